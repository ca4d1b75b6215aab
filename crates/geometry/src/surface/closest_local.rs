//! All the points of a surface that are nearer to a given one than their neighbours.

use super::Surface;
use super::closest::{ClosestOnSurface, SurfacePoint};
use super::closest_cells::{Cell, Degrees, Verdict};
use super::closest_patch::{Patches, Search};
use super::closest_places::{Domain, Place};
use crate::bernstein::BUDGET;
use crate::curve::along_span;
use crate::polynomial::Polynomial;
use crate::surface::thresholds::{AT_POLE, FIRST_FALL, SAME_MINIMUM, SHORTEST_SIDE};
use crate::thresholds;
use crate::{NurbsSurface, Point3, Result};

/// The places of a surface that are nearer to a point than all around them.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SurfaceMinima {
    /// The places, the nearest first.
    pub points: Vec<SurfacePoint>,
    /// Whether the search came to its end. `false` says that the distance stays nearly the same along some line that
    /// is no line of constant u or v, or a hair beside a pole, so that the budget of work ran out: the nearest point is
    /// among those listed, but another minimum may be missing.
    pub complete: bool,
}

/// The work that a search may do, in steps of halving; about half a second.
const WORK: u64 = 200_000_000;

/// The most undecided ranges of one patch, and the most places, that are kept.
const MOST_CELLS: usize = 1024;
const MOST_PLACES: usize = 4096;

/// A step in a patch's own parameters that separates no places.
const EPSILON: f64 = 1e-7;

/// In which directions the distance surely falls from a patch's border into it.
struct Border {
    /// All along the side where parameter d starts or ends.
    sides: [[bool; 2]; 2],
    /// At the corner where u and v start or end.
    corners: [[bool; 2]; 2],
}

impl Border {
    fn of(cell: &Cell, degrees: &Degrees, noise: f64) -> Self {
        let noise = cell.noise(degrees, noise);
        let rows = [0, 1].map(|d| [false, true].map(|end| cell.inward(degrees, d, end)));
        let falls = |x: Option<&f64>| x.is_some_and(|x| *x < -noise);
        let sides = [0, 1].map(|d: usize| [0, 1].map(|e: usize| rows[d][e].iter().all(|x| *x < -noise)));
        let at = |row: &[f64], end: usize| falls(if end == 0 { row.first() } else { row.last() });
        let corners = [0, 1].map(|u: usize| [0, 1].map(|v: usize| at(&rows[0][u], v) || at(&rows[1][v], u)));
        Self { sides, corners }
    }
}

/// A search of all patches.
struct Survey<'s> {
    patches: &'s Patches,
    /// The patches in each direction.
    counts: [usize; 2],
    domain: Domain,
    q: [f64; 3],
    work: u64,
    complete: bool,
    places: Vec<Place>,
}

impl<'s> Survey<'s> {
    fn question(&self, [i, j]: [usize; 2]) -> Option<Search<'s>> {
        self.patches.question(i * self.counts[1] + j, self.q)
    }

    /// The patch `step` patches on in direction `d`, over the seam if there is one.
    fn beside(&self, at: usize, d: usize, step: isize) -> Option<usize> {
        let count = self.counts[d];
        match at.checked_add_signed(step) {
            Some(k) if k < count => Some(k),
            _ if !self.closed(d) => None,
            Some(_) => Some(0),
            None => count.checked_sub(1),
        }
    }

    fn closed(&self, d: usize) -> bool {
        self.domain.closed[d]
    }

    /// Whether line `k` of the grid of patches, across direction `d`, is a single point.
    fn is_pole(&self, d: usize, k: usize) -> bool {
        (k == 0 && self.domain.singular[d][0]) || (k == self.counts[d] && self.domain.singular[d][1])
    }

    /// Whether the distance falls nowhere from a point of a patch, neither in it nor in those beside it.
    fn stands(&self, at: [usize; 2], x: [f64; 2]) -> bool {
        let mut around = [[None; 3]; 2];
        for d in 0..2 {
            let start = x[d] <= EPSILON;
            let end = x[d] >= 1.0 - EPSILON;
            // Poles are looked at by themselves.
            if (x[d] <= AT_POLE && self.is_pole(d, at[d]))
                || (x[d] >= 1.0 - AT_POLE && self.is_pole(d, at[d] + 1))
            {
                return false;
            }
            around[d][0] = Some((at[d], x[d]));
            around[d][1] = start.then(|| self.beside(at[d], d, -1)).flatten().map(|k| (k, 1.0));
            around[d][2] = end.then(|| self.beside(at[d], d, 1)).flatten().map(|k| (k, 0.0));
        }
        around[0].iter().flatten().all(|&(i, x)| {
            around[1].iter().flatten().all(|&(j, y)| {
                self.question([i, j])
                    .is_some_and(|search| DIRECTIONS.iter().all(|&d| !falls(&search, [x, y], d)))
            })
        })
    }

    /// Records a range of a patch's parameters, if the distance really does not fall from the point that stands for it.
    fn add(&mut self, at: [usize; 2], search: &Search<'_>, range: [[f64; 2]; 2], x: [f64; 2], sure: bool) {
        let inside = x.iter().all(|x| *x > EPSILON && *x < 1.0 - EPSILON);
        let proved = sure && inside;
        if !proved && !self.stands(at, x) {
            return;
        }
        if self.places.len() >= MOST_PLACES {
            self.complete = false;
            return;
        }
        let low = search.parameters([range[0][0], range[1][0]]);
        let high = search.parameters([range[0][1], range[1][1]]);
        let epsilon = search.patch.range.map(|[a, b]| 10.0 * EPSILON * (b - a));
        let (at, squared, noise) = (search.parameters(x), search.squared(x), search.noise);
        self.places.push(Place { low, high, at, squared, noise, epsilon });
    }

    /// Minima inside a patch, those on its border among them where both slopes vanish.
    ///
    /// Ranges are halved, all of a size together, until the slopes' coefficients decide; see [`Verdict`].
    fn interior(&mut self, at: [usize; 2], search: &Search<'_>, cell: Cell, degrees: &Degrees) {
        let mut level = vec![cell];
        while !level.is_empty() {
            let lost = level.len() > MOST_CELLS || self.work == 0;
            let mut next = Vec::new();
            for cell in level.drain(..) {
                let range = cell.range;
                let middle = range.map(|[a, b]| 0.5 * (a + b));
                let mut d = match cell.verdict(degrees, search.noise) {
                    Verdict::Empty => continue,
                    Verdict::Single => {
                        let found = search.minimum(range, middle);
                        if found.settled {
                            if at_rest(search, found.x, [false; 2]) {
                                self.add(at, search, found.x.map(|x| [x, x]), found.x, true);
                            }
                            continue;
                        }
                        usize::from(range[1][1] - range[1][0] > range[0][1] - range[0][0])
                    }
                    Verdict::Level(level) => {
                        let x = if level == [true; 2] { middle } else { search.minimum(range, middle).x };
                        if at_rest(search, x, level) {
                            let over = [0, 1].map(|d: usize| if level[d] { range[d] } else { [x[d], x[d]] });
                            self.add(at, search, over, x, false);
                        }
                        continue;
                    }
                    Verdict::Open(d) => d,
                };
                let wide = |d: usize| range[d][1] - range[d][0] > SHORTEST_SIDE;
                if !wide(d) {
                    d = 1 - d;
                }
                if lost || !wide(d) {
                    self.complete &= !lost;
                    let x = search.minimum(range, middle).x;
                    self.add(at, search, range, x, false);
                    continue;
                }
                self.work = self.work.saturating_sub(cell.work(degrees));
                next.extend(cell.halves(degrees, d));
            }
            level = next;
        }
    }

    /// Minima along the lines between patches and along the sides of the domain.
    fn edges(&mut self, borders: &[Border]) {
        let mut budget = BUDGET.saturating_mul(10);
        let border = |[i, j]: [usize; 2]| borders.get(i * self.counts[1] + j);
        let mut found = Vec::new();
        for d in 0..2 {
            let along = 1 - d;
            let lines = if self.closed(d) { self.counts[d] } else { self.counts[d] + 1 };
            for k in (0..lines).filter(|&k| !self.is_pole(d, k)) {
                for j in 0..self.counts[along] {
                    let patch = |k: usize| if d == 0 { [k, j] } else { [j, k] };
                    let before = match k.checked_sub(1) {
                        None => self.beside(0, d, -1),
                        some => some,
                    };
                    // Each with the end of the parameter at which it has the line.
                    let sides = [(k < self.counts[d]).then_some((k, 0)), before.map(|k| (k, 1))];
                    let falls = |&(k, end): &(usize, usize)| border(patch(k)).is_none_or(|b| b.sides[d][end]);
                    if sides.iter().flatten().any(falls) {
                        continue;
                    }
                    let Some(&(k, end)) = sides.iter().flatten().next() else { continue };
                    found.push((d, patch(k), end));
                }
            }
        }
        for (d, at, end) in found {
            let Some(search) = self.question(at) else { continue };
            let (n, width, fixed) = (search.n, search.n[1] + 1, end as f64);
            let line: Vec<[f64; 4]> = match d {
                0 => search.points.iter().skip(end * n[0] * width).take(width).copied().collect(),
                _ => search.points.iter().skip(end * n[1]).step_by(width).copied().collect(),
            };
            let [x, y, z] = search.r;
            let course = along_span(&line, Point3::new(x, y, z), &mut budget);
            let place = |t: f64| if d == 0 { [fixed, t] } else { [t, fixed] };
            let range = |low: f64, high: f64| {
                let fixed = [fixed, fixed];
                if d == 0 { [fixed, [low, high]] } else { [[low, high], fixed] }
            };
            for &t in &course.inside {
                let x = search.minimum(range(0.0, 1.0), place(t)).x;
                self.add(at, &search, x.map(|x| [x, x]), x, false);
            }
            let level = course.inside.is_empty() && course.start == 0.0 && course.end == 0.0;
            if level && [0.25, 0.75].into_iter().all(|t| self.stands(at, place(t))) {
                self.add(at, &search, range(0.0, 1.0), place(0.5), false);
            }
        }
        self.complete &= budget > 0;
    }

    /// Minima at corners of patches.
    fn corners(&mut self, borders: &[Border]) {
        let border = |[i, j]: [usize; 2]| borders.get(i * self.counts[1] + j);
        let lines = [0, 1].map(|d| if self.closed(d) { self.counts[d] } else { self.counts[d] + 1 });
        let mut found = Vec::new();
        for i in 0..lines[0] {
            for j in 0..lines[1] {
                if self.is_pole(0, i) || self.is_pole(1, j) {
                    continue;
                }
                let sides = [(0, i), (1, j)].map(|(d, k)| {
                    let before = match k.checked_sub(1) {
                        None => self.beside(0, d, -1),
                        some => some,
                    };
                    [(k < self.counts[d]).then_some((k, 0_usize)), before.map(|k| (k, 1))]
                });
                let mut around = sides[0]
                    .iter()
                    .flatten()
                    .flat_map(|&(i, u)| sides[1].iter().flatten().map(move |&(j, v)| ([i, j], [u, v])));
                let Some(first) = around.clone().next() else { continue };
                if around.all(|(at, [u, v])| border(at).is_some_and(|b| !b.corners[u][v])) {
                    found.push(first);
                }
            }
        }
        for (at, ends) in found {
            let Some(search) = self.question(at) else { continue };
            let x = ends.map(|e| e as f64);
            self.add(at, &search, x.map(|x| [x, x]), x, false);
        }
    }

    /// Minima at poles: sides of the domain that are single points.
    fn poles(&mut self) {
        for d in 0..2 {
            for end in 0..2 {
                if self.domain.singular[d][end] {
                    self.pole(d, end);
                }
            }
        }
    }

    /// A pole is left in all the directions of the lines that run into it: the slope along them is a polynomial.
    fn pole(&mut self, d: usize, end: usize) {
        let along = 1 - d;
        let Some(k) = (if end == 0 { Some(0) } else { self.counts[d].checked_sub(1) }) else { return };
        for j in 0..self.counts[along] {
            let Some(search) = self.question(if d == 0 { [k, j] } else { [j, k] }) else { return };
            let (cell, degrees) = Cell::whole(&search);
            let slope = Polynomial::new(cell.inward(&degrees, d, end == 1));
            let mut steepest = slope.derivative().roots(thresholds::POLYNOMIAL_ZERO * slope.size());
            steepest.extend((0..=8).map(|k| f64::from(k) / 8.0));
            let inward = if end == 0 { 1.0 } else { -1.0 };
            let fall = |t: f64| {
                let pair = |a: f64, b: f64| if d == 0 { [a, b] } else { [b, a] };
                falls(&search, pair(end as f64, t), pair(inward, 0.0))
            };
            if steepest.into_iter().any(fall) {
                return;
            }
        }
        let Some(search) = self.question(if d == 0 { [k, 0] } else { [0, k] }) else { return };
        let mut x = [0.0; 2];
        x[d] = end as f64;
        let at = search.parameters(x);
        let (mut low, mut high) = (at, at);
        (low[along], high[along]) = (self.domain.ranges[along].start, self.domain.ranges[along].end);
        let epsilon = search.patch.range.map(|[a, b]| 10.0 * EPSILON * (b - a));
        let (squared, noise) = (search.squared(x), search.noise);
        self.places.push(Place { low, high, at, squared, noise, epsilon });
    }
}

/// The directions in which a place is left to see whether the distance falls.
const DIRECTIONS: [[f64; 2]; 16] = [
    [1.0, 0.0],
    [-1.0, 0.0],
    [0.0, 1.0],
    [0.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [1.0, -1.0],
    [-1.0, -1.0],
    [1.0, 0.5],
    [-1.0, 0.5],
    [1.0, -0.5],
    [-1.0, -0.5],
    [0.5, 1.0],
    [-0.5, 1.0],
    [0.5, -1.0],
    [-0.5, -1.0],
];

/// Whether the distance falls from x in a direction that stays in the patch: it is followed until it differs from that at
/// x by more than rounding may.
fn falls(search: &Search<'_>, x: [f64; 2], direction: [f64; 2]) -> bool {
    let start = search.squared(x);
    let mut step = FIRST_FALL;
    while step < 0.3 {
        let y = [x[0] + step * direction[0], x[1] + step * direction[1]];
        if y.iter().any(|y| !(0.0..=1.0).contains(y)) {
            return false;
        }
        let change = search.squared(y) - start;
        if change.abs() > 2.0 * search.noise {
            return change < 0.0;
        }
        step *= 4.0;
    }
    false
}

/// Whether Newton's method does not move from x, in the directions in which the distance changes at all.
fn at_rest(search: &Search<'_>, x: [f64; 2], level: [bool; 2]) -> bool {
    let [r, su, sv, suu, suv, svv] = search.jet(x);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let g = [dot(r, su), dot(r, sv)];
    let h = [dot(su, su) + dot(r, suu), dot(su, sv) + dot(r, suv), dot(sv, sv) + dot(r, svv)];
    let small = |step: f64| step.abs() <= EPSILON;
    match level {
        [true, true] => true,
        [true, false] => h[2] > 0.0 && small(g[1] / h[2]),
        [false, true] => h[0] > 0.0 && small(g[0] / h[0]),
        [false, false] => {
            let det = h[0] * h[2] - h[1] * h[1];
            h[0] > 0.0
                && det > 0.0
                && small((h[2] * g[0] - h[1] * g[1]) / det)
                && small((h[0] * g[1] - h[1] * g[0]) / det)
        }
    }
}

impl ClosestOnSurface {
    /// All places of the surface that are nearer to `q` than the surface around them, the nearest first: feet of
    /// perpendiculars where the distance has a minimum, and creases, sides and corners of the surface from which it
    /// does not fall. A place on a seam or at a pole is one place, with its least parameters. Equally near places all
    /// appear; where the distance stays the same along a line or over a part of the surface (the axis of a cylinder,
    /// the centre of a sphere), one point of it stands for it.
    ///
    /// Finds all of them, unless [`SurfaceMinima::complete`] says otherwise, but for minima shallower than rounding
    /// (10⁻¹⁴ of the squared distance or size) and two that lie within 10⁻⁶ of a span of each other.
    ///
    /// The surface is cut into ranges until the Bernstein coefficients of the squared distance's derivatives prove that
    /// they do not vanish, that they vanish at no minimum, or that they vanish once and where, by Newton's method
    /// (derived; the uniqueness is D. Gale's and H. Nikaido's, Math. Annalen 159, 1965). Lines between patches and
    /// sides are searched for minima along them, from which the distance must not fall on either side.
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn local_closest_points(&self, q: Point3) -> Result<SurfaceMinima> {
        let nearest = self.nearest(q)?;
        let (patches, counts) = Patches::spans_of(self.nurbs());
        let domain = Domain::of(self.nurbs());
        let (work, complete, places) = (WORK, true, Vec::new());
        let mut survey = Survey { patches: &patches, counts, domain, q: q.into(), work, complete, places };
        let mut borders = Vec::with_capacity(patches.list.len());
        for i in 0..counts[0] {
            for j in 0..counts[1] {
                let Some(search) = survey.question([i, j]) else { continue };
                let (cell, degrees) = Cell::whole(&search);
                borders.push(Border::of(&cell, &degrees, search.noise));
                survey.interior([i, j], &search, cell, &degrees);
            }
        }
        survey.edges(&borders);
        survey.corners(&borders);
        survey.poles();
        let found = survey.domain.distinct(&survey.places);
        let mut points: Vec<SurfacePoint> = found.iter().map(|p| self.place(p.at[0], p.at[1], q)).collect();
        points.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        // Where all is lost in rounding, the nearest point is still one.
        let noise = survey.places.iter().fold(0.0_f64, |m, p| m.max(p.noise));
        let known = |p: &SurfacePoint| {
            p.distance * p.distance
                <= nearest.distance * nearest.distance * (1.0 + SAME_MINIMUM) + 4.0 * noise
        };
        if !points.first().is_some_and(known) {
            points.insert(0, nearest);
        }
        Ok(SurfaceMinima { points, complete: survey.complete })
    }
}

impl NurbsSurface {
    /// All places of the surface that are nearer to `q` than the surface around them:
    /// [`ClosestOnSurface::local_closest_points`].
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn local_closest_points(&self, q: Point3) -> Result<SurfaceMinima> {
        ClosestOnSurface::of_nurbs(self).local_closest_points(q)
    }
}

impl Surface {
    /// All places of the surface that are nearer to `q` than the surface around them:
    /// [`ClosestOnSurface::local_closest_points`].
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows; the surface has no NURBS form.
    pub fn local_closest_points(&self, q: Point3) -> Result<SurfaceMinima> {
        ClosestOnSurface::new(self)?.local_closest_points(q)
    }
}
