//! Curve with surface.

mod places;

use super::ContactKind;
use super::curve_curve::check;
use super::judge::separated;
use super::patch_tree::{PatchNode, PatchTree};
use super::search::NOISE;
use super::thresholds::{IN_RANGE, KEEPS, NO_BETTER, NO_FRAME, ROUNDED, SHORT_PART};
use super::tree::{Node, Tree};
use crate::curve::Piece;
use crate::nurbs::project;
use crate::{Curve, Direction, Interval, NurbsSurface, Point3, Result, Vector3, cancellation};

/// A point that a curve and a surface have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceCrossing {
    /// The parameter on the curve.
    pub t: f64,
    /// The parameters on the surface.
    pub u: f64,
    /// See `u`.
    pub v: f64,
    /// The point halfway between curve and surface there.
    pub point: Point3,
    /// The distance between them there, at most the tolerance.
    pub gap: f64,
    /// Whether the curve pierces the surface or touches it.
    pub kind: ContactKind,
}

/// A stretch of a curve that lies in a surface, within the tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceOverlap {
    /// The range on the curve, increasing.
    pub t: Interval,
    /// The surface's u and v where the stretch begins.
    pub from: [f64; 2],
    /// The surface's u and v where the stretch ends.
    pub to: [f64; 2],
}

/// All that a curve and a surface have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceIntersections {
    /// The points, sorted by the parameter on the curve.
    pub crossings: Vec<SurfaceCrossing>,
    /// The stretches, sorted likewise.
    pub overlaps: Vec<SurfaceOverlap>,
    /// Whether the search came to its end; see [`super::CurveIntersections::complete`].
    pub complete: bool,
    /// The pairs of parts that were looked at.
    pub visits: u64,
}

/// All points and stretches that a curve and a NURBS surface have in common within `tolerance`.
///
/// **Complete** in the sense of [`super::curve_curve`]: spans of the curve and Bézier patches are discarded when hulls
/// of control points prove them further apart than the tolerance; settled when all differences of their control
/// points, along the curve, along u and along v, prove that they share at most one point and Newton's method in three
/// unknowns finds it; all else is halved. Crossings are polished to rounding. A touch is listed once; a stretch of the
/// curve in the surface is an overlap, also where it is only as long as a part of a span.
///
/// The tolerance and the bound on the work are those of [`super::curve_curve`]. On closed surfaces a point of the
/// seam counts once, with the smaller parameter.
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn curve_surface(curve: &Curve, surface: &NurbsSurface, tolerance: f64) -> Result<SurfaceIntersections> {
    curve_surface_within(curve, surface, tolerance, MOST_VISITS)
}

/// The most pairs of parts that a search looks at.
pub(super) const MOST_VISITS: u64 = 300_000;

/// As [`curve_surface`], looking at no more than so many pairs of parts.
pub(crate) fn curve_surface_within(
    curve: &Curve,
    surface: &NurbsSurface,
    tolerance: f64,
    most_visits: u64,
) -> Result<SurfaceIntersections> {
    check(tolerance)?;
    cancellation::check()?;
    let patches = PatchTree::new(surface)?;
    Ok(curve_parts(curve, surface, patches, tolerance, most_visits).0)
}

/// As [`curve_surface`] with the parts of the surface, which are given back for the next curve.
pub(super) fn curve_parts<'a>(
    curve: &Curve,
    surface: &NurbsSurface,
    patches: PatchTree<'a>,
    tolerance: f64,
    most_visits: u64,
) -> (SurfaceIntersections, PatchTree<'a>) {
    let tree = Tree::new(curve.pieces());
    let scale = tree.scale.max(patches.scale);
    let tolerance = tolerance.max(NOISE * scale).max(f64::MIN_POSITIVE);
    let mut search = Search {
        tree,
        patches,
        tolerance,
        limit: most_visits,
        visits: 0,
        complete: true,
        contacts: Vec::new(),
        stack: Vec::new(),
        domain: Direction::BOTH.map(|d| surface.domain(d)),
    };
    search.run();
    let found = search.read(curve.domain());
    (found, search.patches)
}

/// A place, or a stretch, where curve and surface were found within the tolerance of each other.
#[derive(Debug, Clone, Copy)]
struct Contact {
    /// The range on the curve, by the whole curve's parameter.
    t: [f64; 2],
    best: f64,
    uv: [f64; 2],
    gap: f64,
    root: bool,
    /// How far beyond its range another contact still belongs to it.
    reach: f64,
}

struct Search<'c, 's> {
    tree: Tree<'c>,
    patches: PatchTree<'s>,
    tolerance: f64,
    limit: u64,
    visits: u64,
    complete: bool,
    contacts: Vec<Contact>,
    stack: Vec<(u32, u32)>,
    domain: [Interval; 2],
}

/// How many times shorter than a patch the parts of a curve are made that begin or end on it.
const SHORTER: f64 = 4.0;

/// How a part of a curve lies to a part of the surface, as far as places on it tell.
enum Lies {
    /// Within the tolerance all along, and recorded.
    Along,
    /// An end lies within the tolerance of the surface.
    Partly,
    /// None of that is known.
    Off,
}

/// What control points prove.
enum Verdict {
    Apart,
    Single,
    Unclear,
}

impl Search<'_, '_> {
    fn run(&mut self) {
        if self.tree.nodes.is_empty() || self.patches.nodes.is_empty() {
            return;
        }
        self.stack.push((self.tree.root, self.patches.root));
        while let Some((ic, ip)) = self.stack.pop() {
            self.visits += 1;
            if self.visits > self.limit || (self.visits.is_multiple_of(256) && cancellation::check().is_err())
            {
                self.complete = false;
                return;
            }
            self.visit(ic, ip);
        }
    }

    fn visit(&mut self, ic: u32, ip: u32) {
        let (c, p) = (self.tree.nodes[ic as usize], self.patches.nodes[ip as usize]);
        let reach = self.tolerance;
        if (0..3).any(|k| c.min[k] - p.max[k] > reach || p.min[k] - c.max[k] > reach) {
            return;
        }
        let (sc, sp) = (c.size_squared(), p.size_squared());
        let (Some(piece), Some(patch)) = (c.piece(), p.patch()) else {
            let open_curve = c.piece().is_none() && (p.patch().is_some() || sc >= sp);
            self.open(ic, ip, open_curve);
            return;
        };
        let verdict = self.judge(&c, &p);
        let piece = self.tree.pieces[piece];
        match verdict {
            Verdict::Apart => return,
            Verdict::Single => {
                if let Some(contact) = self.crossing(&piece, &c, &p, patch) {
                    self.contacts.push(contact);
                    return;
                }
            }
            Verdict::Unclear => {}
        }
        if sc.max(sp) <= self.tolerance * self.tolerance {
            self.add(&piece, [c.from, c.to], &p, patch);
            return;
        }
        let curve_first = match self.lies(&piece, &c, &p, patch) {
            Lies::Along => return,
            Lies::Off => sc >= sp,
            // Parts of one size never lie within each other: the curve's are made shorter than the patch's, so that
            // only those across its border are left.
            Lies::Partly => SHORTER * SHORTER * sc >= sp,
        };
        if !self.open(ic, ip, curve_first) && !self.open(ic, ip, !curve_first) {
            self.add(&piece, [c.from, c.to], &p, patch);
        }
    }

    fn open(&mut self, ic: u32, ip: u32, curve: bool) -> bool {
        if curve {
            let Some((l, r)) = self.tree.children(ic) else { return false };
            self.stack.extend([(r, ip), (l, ip)]);
        } else {
            let Some((l, r)) = self.patches.children(ip) else { return false };
            self.stack.extend([(ic, r), (ic, l)]);
        }
        true
    }

    /// Hulls apart, or, in coordinates along the mean directions of curve, u and v, differences of control points
    /// that keep to their axis so strictly that no chord of the curve is one of the patch.
    fn judge(&self, c: &Node, p: &PatchNode) -> Verdict {
        let hull = self.tree.hull(c);
        let grid = self.patches.points(p);
        let [n, m] = self.patches.counts;
        let mut net = [Vector3::ZERO; 64];
        let mut heap = Vec::new();
        let net: &[Vector3] = if grid.len() <= 64 {
            for (to, from) in net.iter_mut().zip(grid) {
                *to = project(*from).to_vector();
            }
            &net[..grid.len()]
        } else {
            heap.extend(grid.iter().map(|&q| project(q).to_vector()));
            &heap
        };
        let (Some(&first), Some(&last)) = (hull.first(), hull.last()) else { return Verdict::Unclear };
        let [q00, q01, q10, q11] = [net[0], net[m - 1], net[(n - 1) * m], net[n * m - 1]];
        let u = (q10 - q00 + q11 - q01) * 0.5;
        let v = (q01 - q00 + q11 - q10) * 0.5;
        let d = last - first;
        let normal = u.cross(v);
        let between = (q00 + q01 + q10 + q11) * 0.25 - (first + last) * 0.5;
        let squared = d.length_squared();
        let side = if squared > 0.0 { between - d * (between.dot(d) / squared) } else { between };
        for axis in [normal, side, d.cross(u), d.cross(v)] {
            if separated(hull, net, axis, self.tolerance) {
                return Verdict::Apart;
            }
        }
        let determinant = normal.dot(d);
        if !(determinant.abs() > NO_FRAME * normal.length() * d.length()) || determinant == 0.0 {
            return Verdict::Unclear;
        }
        // Rows of the inverse of (u v d).
        let rows = [v.cross(d) / determinant, d.cross(u) / determinant, normal / determinant];
        let keeps = |w: Vector3, axis: usize, slack: f64| {
            let x = rows.map(|r| r.dot(w));
            let size: f64 = x.iter().map(|x| x.abs()).sum();
            // x > the others and what the weights can add.
            w == Vector3::ZERO && slack == 0.0
                || x[axis] > KEEPS * (size - x[axis].abs()) + ROUNDED * size + slack
        };
        if !hull.windows(2).all(|w| keeps(w[1] - w[0], 2, 0.0)) {
            return Verdict::Unclear;
        }
        // Along u: ΔA − SΔw for homogeneous points A and any point S of the patch; S is the middle, give or take.
        let middle = (q00 + q01 + q10 + q11) * 0.25;
        let radius = net.iter().map(|q| (*q - middle).length()).fold(0.0, f64::max);
        let factor: f64 = rows.iter().map(|r| r.length()).sum();
        let slope = |a: usize, b: usize| {
            let (wa, wb) = (grid[a][3], grid[b][3]);
            let w = (net[b] - middle) * wb - (net[a] - middle) * wa;
            (w, (wb - wa).abs() * radius * factor * 2.0)
        };
        for i in 0..n {
            for j in 0..m {
                if i + 1 < n {
                    let (w, slack) = slope(i * m + j, (i + 1) * m + j);
                    if !keeps(w, 0, slack) {
                        return Verdict::Unclear;
                    }
                }
                if j + 1 < m {
                    let (w, slack) = slope(i * m + j, i * m + j + 1);
                    if !keeps(w, 1, slack) {
                        return Verdict::Unclear;
                    }
                }
            }
        }
        Verdict::Single
    }

    /// Newton's method on C(t) − S(u, v).
    fn crossing(&self, piece: &Piece<'_>, c: &Node, p: &PatchNode, patch: usize) -> Option<Contact> {
        let patch = self.patches.patch(patch);
        let mut x = [
            0.5 * (c.from + c.to),
            0.5 * (p.ranges[0][0] + p.ranges[0][1]),
            0.5 * (p.ranges[1][0] + p.ranges[1][1]),
        ];
        let ranges = [[c.from, c.to], p.ranges[0], p.ranges[1]];
        let mut small = false;
        for _ in 0..24 {
            let [q, d, _] = piece.jet(x[0]);
            let [s, su, sv] = patch.jet([x[1], x[2]]);
            let r = q - s;
            let n = su.cross(sv);
            let determinant = n.dot(d);
            if determinant == 0.0 {
                return None;
            }
            // C + C′ dt = S + Su du + Sv dv.
            let dt = -r.dot(n) / determinant;
            let w = r + d * dt;
            let nn = n.length_squared();
            let du = w.cross(sv).dot(n) / nn;
            let dv = su.cross(w).dot(n) / nn;
            let steps = [dt, du, dv];
            let mut largest = 0.0_f64;
            for k in 0..3 {
                let width = ranges[k][1] - ranges[k][0];
                x[k] += steps[k];
                largest = largest.max((steps[k] / width).abs());
                let off = (x[k] - ranges[k][0]) / width;
                if !(-1.0..=2.0).contains(&off) {
                    return None;
                }
            }
            if small {
                break;
            }
            small = largest < NO_BETTER;
        }
        if !small {
            return None;
        }
        let wholes = [piece.own, patch.domain[0], patch.domain[1]];
        for k in 0..3 {
            let slack = IN_RANGE * wholes[k].length().abs();
            let [a, b] = ranges[k];
            if !(a.min(b) - slack <= x[k] && x[k] <= a.max(b) + slack) {
                return None;
            }
            x[k] = wholes[k].clamp(x[k]);
        }
        let gap = (piece.jet(x[0])[0] - patch.jet([x[1], x[2]])[0]).length();
        if !(gap <= self.tolerance) {
            return None;
        }
        let t = piece.whole_parameter(x[0]);
        Some(Contact {
            t: [t, t],
            best: t,
            uv: [x[1], x[2]],
            gap,
            root: true,
            reach: self.reach(piece, x[0]),
        })
    }

    /// The step of the whole curve's parameter that leads some tolerances along it.
    fn reach(&self, piece: &Piece<'_>, u: f64) -> f64 {
        let own = piece.own.length().abs();
        let step = (4.0 * self.tolerance / piece.jet(u)[1].length()).min(SHORT_PART * own);
        step * piece.whole.length() / own
    }

    /// Records a part as one contact, by its nearest place to the patch.
    fn add(&mut self, piece: &Piece<'_>, t: [f64; 2], p: &PatchNode, patch: usize) {
        let u = 0.5 * (t[0] + t[1]);
        let start = p.ranges.map(|[a, b]| 0.5 * (a + b));
        let (uv, gap) = self.foot(patch, piece.point(u), start);
        let ends = t.map(|t| piece.whole_parameter(t));
        let reach = self.reach(piece, t[0]).max(self.reach(piece, t[1]));
        let t = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        self.contacts.push(Contact { t, best: piece.whole_parameter(u), uv, gap, root: false, reach });
    }

    /// The place of a patch nearest to `q`, as far as Gauss–Newton from `start` shows it, and its distance.
    fn foot(&self, patch: usize, q: Point3, start: [f64; 2]) -> ([f64; 2], f64) {
        let patch = self.patches.patch(patch);
        let q = q.to_vector();
        let mut uv = start;
        let mut best = (start, f64::INFINITY);
        for _ in 0..20 {
            let [s, su, sv] = patch.jet(uv);
            let r = q - s;
            let gap = r.length();
            if !(gap < best.1) {
                break;
            }
            best = (uv, gap);
            let (a, b, d) = (su.dot(su), su.dot(sv), sv.dot(sv));
            let (e, f) = (r.dot(su), r.dot(sv));
            let determinant = a * d - b * b;
            let clamp = |k: usize, x: f64| patch.domain[k].clamp(x);
            let mut next = [
                clamp(0, uv[0] + (e * d - f * b) / determinant),
                clamp(1, uv[1] + (f * a - e * b) / determinant),
            ];
            // At a border the other parameter goes on alone.
            if next[0] == patch.domain[0].start || next[0] == patch.domain[0].end {
                let left = f - b * (next[0] - uv[0]);
                next[1] = clamp(1, uv[1] + left / d);
            } else if next[1] == patch.domain[1].start || next[1] == patch.domain[1].end {
                let left = e - b * (next[1] - uv[1]);
                next[0] = clamp(0, uv[0] + left / a);
            }
            if !next.iter().all(|x| x.is_finite()) || next == uv {
                break;
            }
            uv = next;
        }
        best
    }

    /// Whether a part of the surface is so flat that no point has two feet on it: in coordinates along its mean
    /// directions and its normal, all differences of control points keep to their axis.
    fn is_graph(&self, p: &PatchNode) -> bool {
        let grid = self.patches.points(p);
        let [n, m] = self.patches.counts;
        let at = |i: usize, j: usize| grid.get(i * m + j).map_or(Vector3::ZERO, |&q| project(q).to_vector());
        let u = at(n - 1, 0) - at(0, 0) + at(n - 1, m - 1) - at(0, m - 1);
        let v = at(0, m - 1) - at(0, 0) + at(n - 1, m - 1) - at(n - 1, 0);
        let (Some(u), Some(v)) = (u.unitized(), v.unitized()) else { return false };
        let Some(normal) = u.cross(v).unitized() else { return false };
        let determinant = u.cross(v).dot(normal);
        let rows = [v.cross(normal) / determinant, normal.cross(u) / determinant, normal];
        let keeps = |w: Vector3, axis: usize| {
            let x = rows.map(|r| r.dot(w));
            x[axis] >= 1.2 * (x.iter().map(|x| x.abs()).sum::<f64>() - x[axis].abs())
        };
        (0..n).all(|i| {
            (0..m).all(|j| {
                (i + 1 == n || keeps(at(i + 1, j) - at(i, j), 0))
                    && (j + 1 == m || keeps(at(i, j + 1) - at(i, j), 1))
            })
        })
    }

    /// Whether a part of the curve lies within the tolerance of a flat part of the surface all along: at its ends,
    /// and at as many places between as the degrees leave room to wind. Then that is recorded, and because no point
    /// has a second foot there, nothing is left to find.
    fn lies(&mut self, piece: &Piece<'_>, c: &Node, p: &PatchNode, patch: usize) -> Lies {
        let hull = self.tree.hull(c);
        let (Some(&first), Some(&last)) = (hull.first(), hull.last()) else { return Lies::Off };
        if !super::judge::runs_along(hull, last - first, 1.0) {
            return Lies::Off;
        }
        let [n, m] = self.patches.counts;
        let places = (n + m) * hull.len();
        let middle = p.ranges.map(|[a, b]| 0.5 * (a + b));
        let near = |uv: [f64; 2]| {
            (0..2).all(|k| (uv[k] - middle[k]).abs() <= 0.75 * (p.ranges[k][1] - p.ranges[k][0]))
        };
        let mut uv = middle;
        let mut best = (f64::INFINITY, c.from, uv);
        let mut most = 0.0_f64;
        self.visits += 1;
        // The ends first: they decide most cases.
        for k in [0, places].into_iter().chain(1..places) {
            let t = c.from + (c.to - c.from) * k as f64 / places as f64;
            let (at, gap) = self.foot(patch, piece.point(t), if k == places { middle } else { uv });
            if !(gap <= 1.25 * self.tolerance && near(at)) {
                let at_start = k > 0 || gap <= 1.25 * self.tolerance;
                let partly = at_start || self.foot(patch, piece.point(c.to), middle).1 <= self.tolerance;
                return if partly && self.is_graph(p) { Lies::Partly } else { Lies::Off };
            }
            if k == places && !self.is_graph(p) {
                return Lies::Off;
            }
            uv = at;
            most = most.max(gap);
            if gap < best.0 {
                best = (gap, t, at);
            }
        }
        if most > self.tolerance && best.0 < 0.5 * self.tolerance {
            return Lies::Off;
        }
        self.visits += 2;
        let ends = [c.from, c.to].map(|t| piece.whole_parameter(t));
        let reach = self.reach(piece, c.from).max(self.reach(piece, c.to));
        let (gap, t, uv) = best;
        let best = piece.whole_parameter(t);
        let t = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        self.contacts.push(Contact { t, best, uv, gap, root: false, reach });
        Lies::Along
    }
}
