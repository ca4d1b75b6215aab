//! Cracks that grow until they meet another: J. Tarbell's *Substrate*, 2003.

use crate::thresholds;
use crate::{Error, Interval, Point2, Result, Vector2, cancellation};

/// Looks for a free place this often before it gives up.
const ATTEMPTS: usize = 64;
/// Squares of the grid that finds what lies ahead, along each side.
const MOST_SQUARES: usize = 256;

/// A crack, from where it starts to where it meets another or the border.
pub type Crack = [Point2; 2];

/// Grows straight cracks in a rectangle, one after the other. The first ones start at random places and run both ways
/// in the given directions (angles in radians, taken in turn); every later one starts on a crack drawn at random and
/// runs to one side of it, at a right angle give or take `deviation` radians. A crack ends where it meets another or
/// the border. `random` gives numbers from 0 to below 1.
///
/// There are fewer than `count` where no room is left to start.
///
/// # Errors
/// A number is not finite, or the rectangle has no area; or nobody waits any more.
pub fn substrate(
    [x, y]: [Interval; 2],
    count: usize,
    angles: &[f64],
    deviation: f64,
    mut random: impl FnMut() -> f64,
) -> Result<Vec<Crack>> {
    let (x, y) = (x.ordered(), y.ordered());
    if !(x.is_finite() && y.is_finite() && deviation.is_finite() && angles.iter().all(|a| a.is_finite())) {
        return Err(Error::NotFinite("border, angle or deviation of cracks"));
    }
    if !(x.length() > 0.0 && y.length() > 0.0 && (x.length() * y.length()).is_finite()) {
        return Err(Error::degenerate("border of cracks", "it has no area"));
    }
    let mut field = Field::new([x, y], count);
    let mut out: Vec<Crack> = Vec::new();
    let first = angles.len().clamp(1, count.max(1));
    for k in 0..first.min(count) {
        cancellation::check()?;
        let start = Point2::new(x.at(random()), y.at(random()));
        let direction = Vector2::X.rotated(angles.get(k).copied().unwrap_or(0.0));
        let ends = [-direction, direction].map(|d| field.end_of(start, d, None));
        let crack = ends.map(|t| t.unwrap_or(start));
        field.add(crack, &mut out);
    }
    while out.len() < count {
        let mut grown = None;
        for _ in 0..ATTEMPTS {
            cancellation::check()?;
            let parent = ((random() * out.len() as f64) as usize).min(out.len().saturating_sub(1));
            let (t, side, turn) = (random(), random() < 0.5, random());
            let Some(&[a, b]) = out.get(parent) else { break };
            let Some(along) = (b - a).unitized() else { continue };
            let angle = std::f64::consts::FRAC_PI_2 + (2.0 * turn - 1.0) * deviation;
            let direction = along.rotated(if side { angle } else { -angle });
            let start = a.lerp(b, t);
            // Where it would start along its parent, it has no length.
            if direction.cross(along).abs() < thresholds::PARALLEL {
                continue;
            }
            grown = field.end_of(start, direction, Some(parent)).map(|end| [start, end]);
            if grown.is_some() {
                break;
            }
        }
        let Some(crack) = grown else { break };
        field.add(crack, &mut out);
    }
    Ok(out)
}

/// The cracks so far, found by the squares that they run through.
struct Field {
    border: [Interval; 2],
    squares: usize,
    inside: Vec<Vec<u32>>,
    cracks: Vec<Crack>,
    shortest: f64,
}

impl Field {
    fn new(border: [Interval; 2], count: usize) -> Self {
        let squares = ((count as f64).sqrt() as usize).clamp(1, MOST_SQUARES);
        let [x, y] = border;
        let shortest = thresholds::SAME_POINT * (x.length() + y.length());
        Self { border, squares, inside: vec![Vec::new(); squares * squares], cracks: Vec::new(), shortest }
    }

    fn square(&self, k: usize, value: f64) -> usize {
        let range = self.border[k];
        (((value - range.start) / range.length() * self.squares as f64).max(0.0) as usize)
            .min(self.squares - 1)
    }

    fn add(&mut self, crack: Crack, out: &mut Vec<Crack>) {
        let number = self.cracks.len() as u32;
        self.walk(crack, |field, at| {
            if let Some(list) = field.inside.get_mut(at) {
                list.push(number);
            }
            true
        });
        self.cracks.push(crack);
        out.push(crack);
    }

    /// Calls `visit` with the squares that a segment touches, column by column from its start on, until it says no.
    fn walk(&mut self, [a, b]: Crack, mut visit: impl FnMut(&mut Self, usize) -> bool) {
        let (first, last) = (self.square(0, a.x), self.square(0, b.x));
        let width = self.border[0].length() / self.squares as f64;
        let height = |x: f64| {
            let t = (x - a.x) / (b.x - a.x);
            if t.is_finite() { a.y + (b.y - a.y) * t.clamp(0.0, 1.0) } else { a.y }
        };
        let columns: Vec<usize> =
            if first <= last { (first..=last).collect() } else { (last..=first).rev().collect() };
        for column in columns {
            let left = self.border[0].start + width * column as f64;
            let ends = if first == last { [a.y, b.y] } else { [height(left), height(left + width)] };
            // A little more on both sides, for rounding at the squares' borders.
            let slack = thresholds::SAME_POINT * self.border[1].length();
            let (low, high) = (ends[0].min(ends[1]) - slack, ends[0].max(ends[1]) + slack);
            for row in self.square(1, low)..=self.square(1, high) {
                if !visit(self, row * self.squares + column) {
                    return;
                }
            }
        }
    }

    /// Where a crack from `start` on ends; `None` when it would have no length.
    fn end_of(&mut self, start: Point2, direction: Vector2, parent: Option<usize>) -> Option<Point2> {
        let [x, y] = self.border;
        let to = |from: f64, step: f64, range: Interval| {
            if step > 0.0 {
                (range.end - from) / step
            } else if step < 0.0 {
                (range.start - from) / step
            } else {
                f64::INFINITY
            }
        };
        let mut reach = to(start.x, direction.x, x).min(to(start.y, direction.y, y));
        if !(reach > self.shortest) {
            return None;
        }
        let far = start + direction * reach;
        let far = Point2::new(x.clamp(far.x), y.clamp(far.y));
        let mut end = far;
        self.walk([start, far], |field, at| {
            for &i in field.inside.get(at).into_iter().flatten() {
                if Some(i as usize) == parent {
                    continue;
                }
                let Some(&[a, b]) = field.cracks.get(i as usize) else { continue };
                let along = b - a;
                let across = direction.cross(along);
                if across == 0.0 {
                    continue;
                }
                let t = (a - start).cross(along) / across;
                let s = (a - start).cross(direction) / across;
                if (0.0..=1.0).contains(&s) && t >= 0.0 && t < reach {
                    (reach, end) = (t, start + direction * t);
                }
            }
            true
        });
        (reach > self.shortest).then_some(end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers that look random.
    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 12_345_u64;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        }
    }

    #[test]
    fn cracks_end_at_others_and_cross_none() {
        let range = Interval::new(0.0, 10.0);
        let cracks = substrate([range, range], 400, &[0.3, 1.0], 0.2, numbers()).unwrap();
        assert_eq!(cracks.len(), 400);
        for (i, &[a, b]) in cracks.iter().enumerate() {
            let d = b - a;
            assert!([a, b].iter().all(|p| range.contains(p.x) && range.contains(p.y)));
            for &[p, q] in &cracks[..i] {
                let e = q - p;
                let (t, s) = ((p - a).cross(e) / d.cross(e), (p - a).cross(d) / d.cross(e));
                let inside = |t: f64, length: f64| t * length > 1e-6 && (1.0 - t) * length > 1e-6;
                assert!(!(inside(t, d.length()) && inside(s, e.length())), "{i} crosses an earlier one");
            }
            let on = |p: Point2| {
                let border = [p.x, p.y, 10.0 - p.x, 10.0 - p.y].iter().any(|d| d.abs() < 1e-9);
                let touches = |&[c, e]: &Crack| {
                    let along = (e - c).unitized().unwrap();
                    let s = (p - c).dot(along);
                    along.cross(p - c).abs() < 1e-6 && s > -1e-6 && s < (e - c).length() + 1e-6
                };
                border || cracks[..i].iter().any(touches)
            };
            assert!(on(b), "crack {i} ends in the open");
        }
    }

    #[test]
    fn odd_substrates() {
        let range = Interval::new(0.0, 1.0);
        assert!(substrate([range, range], 0, &[], 0.0, numbers()).unwrap().is_empty());
        assert_eq!(substrate([range, range], 1, &[], 0.0, numbers()).unwrap().len(), 1);
        assert_eq!(substrate([range, range], 50, &[], 0.0, numbers()).unwrap().len(), 50);
        assert!(substrate([range, Interval::new(2.0, 2.0)], 5, &[], 0.0, numbers()).is_err());
        assert!(substrate([range, range], 5, &[f64::NAN], 0.0, numbers()).is_err());
        assert!(substrate([range, range], 5, &[], 1.6, numbers()).is_ok());
        assert!(substrate([range, range], 5, &[], 0.0, || 0.0).is_ok());
    }
}
