use crate::isoline::thresholds::{LEAST_SQUARE, ON_LEVEL, SHORTEST};
use std::collections::HashMap;

use katydid_elementary::Elementary;

use super::Isoline;
use super::cell::{is_way, ways};
use super::far::Far;
use super::join::Links;
use crate::{Error, Plane, Point2, Point3, Result, cancellation};

/// What a far ball adds to the field may be off by this part of it.
const FAR_ERROR: f64 = 1e-5;
/// A cell of 2³ smallest ones a side is looked through corner by corner if it has no more near balls than this: cheaper
/// than to gather those that are far from each of its parts.
const BLOCK: u32 = 3;
const MOST_IN_BLOCK: usize = 512;
const BLOCK_CORNERS: usize = ((1 << BLOCK) + 1) * ((1 << BLOCK) + 1);
/// No cell is halved more often than this.
const DEEPEST: u32 = 28;

/// A section of the field of metaballs in a plane: the sum of charge / distance² over all balls, distances in space.
///
/// J. F. Blinn, *A generalization of algebraic surface drawing*, 1982, with the potential of a falling square.
#[derive(Debug, Clone)]
pub struct Metaballs {
    balls: Vec<Ball>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Ball {
    pub(super) x: f64,
    pub(super) y: f64,
    /// The squared distance from the plane.
    pub(super) off: f64,
    pub(super) charge: f64,
}

impl Metaballs {
    /// The field of balls at points, with a charge each; the last charge holds for all points after it.
    ///
    /// # Errors
    /// A number is not finite, or there is no charge.
    pub fn new(points: &[Point3], charges: &[f64], plane: &Plane) -> Result<Self> {
        let Some(&last) = charges.last() else {
            return Err(Error::degenerate("charges", "there are none"));
        };
        if !plane.is_finite() || !charges.iter().all(|c| c.is_finite()) {
            return Err(Error::NotFinite("charge or plane of metaballs"));
        }
        let charges = charges.iter().copied().chain(std::iter::repeat(last));
        let balls: Vec<Ball> = points
            .iter()
            .zip(charges)
            .map(|(&p, charge)| {
                let [x, y, z] = plane.coordinates(p);
                Ball { x, y, off: z * z, charge }
            })
            .collect();
        if !balls.iter().all(|b| b.x.is_finite() && b.y.is_finite() && b.off.is_finite()) {
            return Err(Error::NotFinite("center of a metaball"));
        }
        Ok(Self { balls })
    }

    /// The strength of the field at a place in the plane; infinite in the middle of a ball.
    pub fn at(&self, p: Point2) -> f64 {
        self.balls.iter().map(|b| b.charge / b.squared_distance(p)).sum()
    }

    /// A size of cells that shows the smallest ball: an eighth of its radius, but at most a thousand to a side.
    pub fn usual_accuracy(&self, threshold: f64) -> f64 {
        let radius = |b: &Ball| (b.charge / threshold).abs().sqrt();
        let radii: Vec<f64> = self.balls.iter().map(radius).filter(|r| *r > 0.0 && r.is_finite()).collect();
        let (small, large) = radii.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &r| (a.min(r), b.max(r)));
        let Some([min, max]) = self.extent().filter(|_| large > 0.0) else { return 1.0 };
        let side = (max.x - min.x).max(max.y - min.y) + 2.0 * large;
        (small / 8.0).max(side / 1000.0)
    }

    fn extent(&self) -> Option<[Point2; 2]> {
        let first = self.balls.first()?;
        let start = [Point2::new(first.x, first.y); 2];
        Some(self.balls.iter().fold(start, |[a, b], p| {
            [Point2::new(a.x.min(p.x), a.y.min(p.y)), Point2::new(b.x.max(p.x), b.y.max(p.y))]
        }))
    }

    /// The lines along which the field has a given strength, in the plane's coordinates: closed, with what is stronger
    /// on the left (for a negative threshold what is weaker). Their points lie where the field is within 1e-5 of the
    /// threshold (of the sum of all balls' strengths without their signs), from side to side of cells of a given size; what is smaller than a cell may be missed.
    ///
    /// Cells are found by halving: one is left when bounds of the field in it do not hold the threshold, with near
    /// balls by their least and largest distance, and far ones gathered in a Taylor polynomial about the cell's
    /// middle, as in the fast multipole method (L. Greengard, V. Rokhlin, 1987). The time grows like balls × log
    /// (side / accuracy). `limit` bounds how many balls are looked at in all cells together.
    ///
    /// # Errors
    /// The threshold is 0 or not finite, the accuracy is not finite and greater than 0, or the work is more than
    /// `limit`.
    pub fn isolines(&self, threshold: f64, accuracy: f64, limit: usize) -> Result<Vec<Isoline>> {
        if !(threshold.is_finite() && threshold != 0.0) {
            let must = "finite and not 0";
            return Err(Error::OutOfRange { what: "threshold of metaballs", value: threshold, must });
        }
        if !(accuracy > 0.0 && accuracy.is_finite()) {
            let must = "finite and greater than 0";
            return Err(Error::OutOfRange { what: "accuracy of metaballs", value: accuracy, must });
        }
        let sign = threshold.signum();
        let balls: Vec<Ball> = self.balls.iter().map(|b| Ball { charge: b.charge * sign, ..*b }).collect();
        let level = threshold.abs();
        let total: f64 = balls.iter().map(|b| b.charge.max(0.0)).sum();
        let Some([min, max]) = self.extent().filter(|_| total > 0.0) else { return Ok(Vec::new()) };
        // Beyond this distance from all balls the field is too weak.
        let reach = (total / level).sqrt();
        let side = (max.x - min.x).max(max.y - min.y) + 2.0 * reach + 2.0 * accuracy;
        let depth = (side / accuracy).logarithm_2().ceil().max(0.0);
        if !(depth <= f64::from(DEEPEST)) {
            return Err(too_many());
        }
        let depth = depth as u32;
        let origin = Point2::new(min.x - reach - accuracy, min.y - reach - accuracy);
        let mut search = Search {
            balls: &balls,
            level,
            origin,
            size: accuracy,
            left: limit,
            heights: HashMap::new(),
            crossings: HashMap::new(),
            places: Vec::new(),
            ways: Vec::new(),
        };
        let all: Vec<u32> = (0..balls.len() as u32).collect();
        let middle = 0.5 * accuracy * f64::from(1_u32 << depth);
        search.visit([0, 0], depth, &all, Far::about(Point2::new(origin.x + middle, origin.y + middle)))?;
        Ok(search.lines())
    }
}

fn too_many() -> Error {
    let why = "the lines take more cells than there may be: a larger accuracy takes fewer".into();
    Error::Invalid { what: "accuracy of metaballs", why }
}

impl Ball {
    #[inline]
    pub(super) fn squared_distance(&self, p: Point2) -> f64 {
        let (dx, dy) = (p.x - self.x, p.y - self.y);
        dx * dx + dy * dy + self.off
    }
}

/// A corner of a cell, or a side (from the corner to the right, or up).
type Key = (u32, u32, bool);

struct Search<'a> {
    balls: &'a [Ball],
    level: f64,
    origin: Point2,
    size: f64,
    left: usize,
    heights: HashMap<(u32, u32), f64>,
    crossings: HashMap<Key, u32>,
    places: Vec<Point2>,
    ways: Vec<[u32; 2]>,
}

impl Search<'_> {
    fn corner(&self, [i, j]: [u32; 2]) -> Point2 {
        Point2::new(self.origin.x + self.size * f64::from(i), self.origin.y + self.size * f64::from(j))
    }

    /// Looks through a cell of 2^`depth` smallest ones a side; the recursion is that deep.
    fn visit(&mut self, cell: [u32; 2], depth: u32, near: &[u32], far: Far) -> Result<()> {
        self.left = self.left.checked_sub(near.len() + 1).ok_or_else(too_many)?;
        cancellation::check_now()?;
        let half = 0.5 * self.size * f64::from(1_u32 << depth);
        let corner = self.corner(cell);
        let middle = Point2::new(corner.x + half, corner.y + half);
        let mut far = far.moved(middle);
        let (mut low, mut high) = (0.0, 0.0);
        let mut still_near = Vec::with_capacity(near.len());
        let far_from = Far::squared_distance(half);
        for &i in near {
            let Some(ball) = self.balls.get(i as usize) else { continue };
            if ball.squared_distance(middle) >= far_from {
                far.add(ball);
                continue;
            }
            let (dx, dy) = ((ball.x - middle.x).abs(), (ball.y - middle.y).abs());
            let (gx, gy) = ((dx - half).max(0.0), (dy - half).max(0.0));
            let least = gx * gx + gy * gy + ball.off;
            let most = (dx + half) * (dx + half) + (dy + half) * (dy + half) + ball.off;
            still_near.push(i);
            let (weak, strong) = (ball.charge / most, ball.charge / least);
            low += weak.min(strong);
            high += weak.max(strong);
        }
        let [value, spread] = far.range(half);
        let slack = spread + 2.0 * FAR_ERROR * self.level;
        if value + low - slack > self.level || value + high + slack < self.level {
            return Ok(());
        }
        if depth == 0 || (depth <= BLOCK && still_near.len() <= MOST_IN_BLOCK) {
            return self.block(cell, depth, &still_near, &far);
        }
        let below = depth - 1;
        let step = 1_u32 << below;
        for (i, j) in [(0, 0), (step, 0), (0, step), (step, step)] {
            self.visit([cell[0] + i, cell[1] + j], below, &still_near, far)?;
        }
        Ok(())
    }

    /// The height over the threshold at a place in or on a smallest cell.
    fn height(&self, p: Point2, near: &[u32], far: &Far) -> f64 {
        let strength = |&i: &u32| {
            // In the middle of a ball very strong, but finite, so that balls of both signs there add up.
            self.balls.get(i as usize).map_or(0.0, |b| b.charge / b.squared_distance(p).max(LEAST_SQUARE))
        };
        far.at(p) + near.iter().map(strength).sum::<f64>() - self.level
    }

    /// Looks through all smallest cells of a block at once.
    fn block(&mut self, start: [u32; 2], depth: u32, near: &[u32], far: &Far) -> Result<()> {
        let side = 1_u32 << depth;
        let corners = (side as usize + 1).pow(2);
        self.left = self.left.checked_sub(corners * near.len()).ok_or_else(too_many)?;
        let mut heights = [0.0; BLOCK_CORNERS];
        let place = |i: u32, j: u32| (j * (side + 1) + i) as usize;
        for j in 0..=side {
            cancellation::check_now()?;
            for i in 0..=side {
                let corner = [start[0] + i, start[1] + j];
                let h = if i % side == 0 || j % side == 0 {
                    // Corners that blocks share have one height, whichever asks first.
                    let key = (corner[0], corner[1]);
                    let known = self.heights.get(&key).copied();
                    let h = known.unwrap_or_else(|| self.height(self.corner(corner), near, far));
                    self.heights.insert(key, h);
                    h
                } else {
                    self.height(self.corner(corner), near, far)
                };
                if let Some(slot) = heights.get_mut(place(i, j)) {
                    *slot = h;
                }
            }
        }
        let height = |i: u32, j: u32| heights.get(place(i, j)).copied().unwrap_or(0.0);
        for j in 0..side {
            for i in 0..side {
                let around = [height(i, j), height(i + 1, j), height(i + 1, j + 1), height(i, j + 1)];
                self.cell([start[0] + i, start[1] + j], around, near, far);
            }
        }
        Ok(())
    }

    fn cell(&mut self, [i, j]: [u32; 2], heights: [f64; 4], near: &[u32], far: &Far) {
        let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
        let (first, second) = ways(heights);
        for way in [Some(first), second].into_iter().flatten().filter(|w| is_way(*w)) {
            let ends = way.map(|side| {
                let k = usize::from(side % 4);
                let other = (k + 1) % 4;
                // Sides are known by the corner at their left or lower end.
                let (key, from, to) = match k {
                    0 => ((i, j, false), k, other),
                    1 => ((i + 1, j, true), k, other),
                    2 => ((i, j + 1, false), other, k),
                    _ => ((i, j, true), other, k),
                };
                if let Some(&crossing) = self.crossings.get(&key) {
                    return crossing;
                }
                let ends = [self.corner(corners[from]), self.corner(corners[to])];
                let place = self.root(ends, [heights[from], heights[to]], near, far);
                let crossing = self.places.len() as u32;
                self.places.push(place);
                self.crossings.insert(key, crossing);
                crossing
            });
            self.ways.push(ends);
        }
    }

    /// The place between two where the height is 0, by the Illinois variant of regula falsi.
    fn root(&self, [a, b]: [Point2; 2], [mut low, mut high]: [f64; 2], near: &[u32], far: &Far) -> Point2 {
        let (mut from, mut to, mut t) = (0.0, 1.0, 0.5);
        if low == 0.0 {
            return a;
        }
        if high == 0.0 {
            return b;
        }
        let mut side = 0;
        for _ in 0..40 {
            t = if low.is_finite() && high.is_finite() && (low - high).is_finite() {
                from + (to - from) * low / (low - high)
            } else {
                0.5 * (from + to)
            };
            let h = self.height(a.lerp(b, t), near, far);
            if h.abs() <= ON_LEVEL * self.level || to - from < SHORTEST {
                break;
            }
            if (h > 0.0) == (low > 0.0) {
                (from, low) = (t, h);
                high *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (to, high) = (t, h);
                low *= if side == 2 { 0.5 } else { 1.0 };
                side = 2;
            }
        }
        a.lerp(b, t)
    }

    fn lines(self) -> Vec<Isoline> {
        let n = self.places.len();
        let mut links = Links { next: vec![u32::MAX; n], starts: Vec::new(), entered: vec![false; n] };
        self.ways.iter().for_each(|&[from, to]| links.add(from, to));
        links.lines(|i| self.places.get(i as usize).copied().unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MANY: usize = 1 << 24;

    fn balls(points: &[[f64; 3]], charges: &[f64]) -> Metaballs {
        let points: Vec<Point3> = points.iter().copied().map(Point3::from).collect();
        Metaballs::new(&points, charges, &Plane::XY).unwrap()
    }

    #[test]
    fn one_ball_is_a_circle() {
        for (charge, threshold, off) in [(1.0, 0.5, 0.0), (3.0, 0.25, 1.0), (-2.0, -0.5, 0.5)] {
            let field = balls(&[[4.0, 5.0, off]], &[charge]);
            let lines = field.isolines(threshold, 0.1, MANY).unwrap();
            assert_eq!(lines.len(), 1);
            assert!(lines[0].closed);
            let radius = (charge / threshold - off * off).sqrt();
            for p in &lines[0].points {
                assert!(((p.x - 4.0).hypot(p.y - 5.0) - radius).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn points_lie_on_the_line() {
        let points: Vec<[f64; 3]> = (0..200)
            .map(f64::from)
            .map(|i| [(i * 1.7).sin() * 30.0, (i * 2.3).cos() * 30.0, (i * 0.3).sin()])
            .collect();
        let field = balls(&points, &[1.0]);
        for threshold in [0.6, 1.0, 4.0] {
            let lines = field.isolines(threshold, 0.2, MANY).unwrap();
            assert!(!lines.is_empty());
            for line in &lines {
                assert!(line.closed);
                for &p in &line.points {
                    assert!((field.at(p) / threshold - 1.0).abs() < 1e-5);
                }
            }
            // All of them: as many as on a full grid.
            let (n, a) = (520, 0.2);
            let start = Point2::new(-52.0, -52.0);
            let values: Vec<f64> = (0..n * n)
                .map(|k| {
                    field.at(Point2::new(start.x + a * (k % n) as f64, start.y + a * (k / n) as f64)).min(1e9)
                })
                .collect();
            let full = super::super::isolines(&values, n, threshold).unwrap();
            let long = |lines: &[Isoline]| lines.iter().filter(|l| l.points.len() > 16).count();
            assert_eq!(long(&lines), long(&full), "threshold {threshold}");
        }
    }

    #[test]
    fn merged_and_apart_and_refused() {
        let pair = balls(&[[0.0, 0.0, 0.0], [3.0, 0.0, 0.0]], &[1.0, 1.0]);
        assert_eq!(pair.isolines(2.0, 0.05, MANY).unwrap().len(), 2);
        assert_eq!(pair.isolines(0.5, 0.05, MANY).unwrap().len(), 1);
        let against = balls(&[[0.0, 0.0, 0.0], [3.0, 0.0, 0.0]], &[1.0, -1.0]);
        assert_eq!(against.isolines(0.5, 0.05, MANY).unwrap().len(), 1);
        assert_eq!(against.isolines(-0.5, 0.05, MANY).unwrap().len(), 1);
        assert!(balls(&[], &[1.0]).isolines(0.5, 0.1, MANY).unwrap().is_empty());
        assert!(balls(&[[0.0; 3]], &[-1.0]).isolines(0.5, 0.1, MANY).unwrap().is_empty());
        assert!(pair.isolines(0.0, 0.1, MANY).is_err());
        assert!(pair.isolines(0.5, 0.0, MANY).is_err());
        assert!(pair.isolines(0.5, 1e-12, MANY).is_err());
        assert!(pair.isolines(0.5, 1e-3, 100).is_err());
        assert!(Metaballs::new(&[Point3::ORIGIN], &[], &Plane::XY).is_err());
        assert!(Metaballs::new(&[Point3::new(f64::NAN, 0.0, 0.0)], &[1.0], &Plane::XY).is_err());
        assert!(pair.usual_accuracy(0.5) > 0.0);
        assert_eq!(balls(&[], &[1.0]).usual_accuracy(0.5), 1.0);
        assert_eq!(balls(&[[0.0; 3]], &[0.0]).usual_accuracy(0.5), 1.0);
        assert_eq!(balls(&[[0.0; 3]], &[-2.0]).usual_accuracy(-0.5), 0.25);
    }
}
