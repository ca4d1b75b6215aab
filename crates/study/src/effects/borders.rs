//! How far to either side of a number an answer changes without a jump, and without a change of counts.

use crate::thresholds::{BORDER_CELLS, BORDER_OCTAVES, JUMP_LEVELS, JUMP_NOISE, JUMP_STAYS};

/// What is known of an answer at a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// `None` where there is none.
    pub(super) value: Option<f64>,
    /// What counts of items and faces make of the answer: equal where they are.
    pub(super) shape: u64,
}

impl Sample {
    fn is_like(&self, other: &Self) -> bool {
        self.shape == other.shape && self.value.is_some() == other.value.is_some()
    }
}

/// Where an answer stops to change evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Border {
    /// The last number known on the near side.
    pub(super) near: f64,
    /// The first number known on the far side; a rounding step away.
    pub(super) far: f64,
    /// Whether counts change there, or the answer ends; else it jumps.
    pub(super) is_change: bool,
}

/// The first border from `x` on towards `end`. Looks at cells that grow with their distance, so that a border is found by cells a
/// fraction of its distance wide; two jumps in one cell that take each other back are not seen.
pub(super) fn first(f: &mut dyn FnMut(f64) -> Sample, x: f64, end: f64) -> Option<Border> {
    let reach = end - x;
    if reach == 0.0 || !reach.is_finite() {
        return None;
    }
    let cells = BORDER_CELLS * BORDER_OCTAVES;
    let offset = |cell: u32| -> f64 {
        // Within each doubling, cells of equal width.
        let (octave, part) = (cell / BORDER_CELLS, cell % BORDER_CELLS);
        let start = reach / f64::from(1_u32 << (BORDER_OCTAVES - octave).min(31));
        start * (1.0 + f64::from(part) / f64::from(BORDER_CELLS))
    };
    let mut a = x;
    for cell in 0..=cells {
        let b = if cell == cells { end } else { x + offset(cell) };
        let mut found = in_cell(f, a, b);
        // What was found may have another before it.
        for _ in 0..8 {
            let Some(border) = found else { break };
            match in_cell(f, a, border.near) {
                Some(nearer) if nearer.far != border.far => found = Some(nearer),
                _ => break,
            }
        }
        if found.is_some() {
            return found;
        }
        a = b;
    }
    None
}

fn in_cell(f: &mut dyn FnMut(f64) -> Sample, a: f64, b: f64) -> Option<Border> {
    let m = f64::midpoint(a, b);
    let (fa, fm, fb) = (f(a), f(m), f(b));
    if !fa.is_like(&fm) {
        return Some(change(f, a, m));
    }
    if !fa.is_like(&fb) {
        return Some(change(f, m, b));
    }
    jump(f, [a, m, b], [fa, fm, fb])
}

/// Halves an interval at whose ends counts differ, until its ends are neighbours.
fn change(f: &mut dyn FnMut(f64) -> Sample, a: f64, b: f64) -> Border {
    let (mut near, mut far) = (a, b);
    let start = f(a);
    while let Some(m) = between(near, far) {
        if f(m).is_like(&start) { near = m } else { far = m }
    }
    Border { near, far, is_change: true }
}

/// A number between two, unless they are as near as makes no difference.
fn between(a: f64, b: f64) -> Option<f64> {
    let m = f64::midpoint(a, b);
    let least = 4.0 * f64::EPSILON * a.abs().max(b.abs());
    ((b - a).abs() > least && m != a && m != b).then_some(m)
}

/// Looks for a jump: the second difference of what is smooth becomes four times smaller when its interval is halved, and that
/// of a corner twice; that of a jump stays.
fn jump(f: &mut dyn FnMut(f64) -> Sample, x: [f64; 3], samples: [Sample; 3]) -> Option<Border> {
    let mut x = x;
    let mut y = samples.map(|sample| sample.value.unwrap_or(0.0));
    let noise = JUMP_NOISE * y.iter().fold(0.0, |most: f64, y| most.max(y.abs()));
    let second = |y: [f64; 3]| (y[0] - 2.0 * y[1] + y[2]).abs();
    let mut sizes = vec![second(y)];
    while sizes.last().is_some_and(|size| *size > noise) {
        let [a, m, b] = x;
        let (Some(left), Some(right)) = (between(a, m), between(m, b)) else {
            break;
        };
        let (fl, fr) = (f(left), f(right));
        let start = f(a);
        for (sample, at, from) in [(fl, left, a), (fr, right, m)] {
            if !sample.is_like(&start) {
                return Some(change(f, from, at));
            }
        }
        let (l, r) = (fl.value.unwrap_or(0.0), fr.value.unwrap_or(0.0));
        let halves = [([a, left, m], [y[0], l, y[1]]), ([m, right, b], [y[1], r, y[2]])];
        let [first, last] = halves;
        (x, y) = if second(first.1) >= second(last.1) { first } else { last };
        sizes.push(second(y));
        let n = sizes.len();
        if n > JUMP_LEVELS {
            let earlier = sizes.get(n - 1 - JUMP_LEVELS).copied().unwrap_or(0.0);
            if sizes.last().is_some_and(|last| *last >= JUMP_STAYS * earlier) {
                return narrowed(f, x, y);
            }
        }
    }
    None
}

/// Halves an interval with a jump, always on the side with the greater difference; `None` where nothing is left of it between
/// neighbours, so that it was only steep.
fn narrowed(f: &mut dyn FnMut(f64) -> Sample, x: [f64; 3], y: [f64; 3]) -> Option<Border> {
    let size = (y[0] - 2.0 * y[1] + y[2]).abs();
    let left = (y[1] - y[0]).abs() >= (y[2] - y[1]).abs();
    let (mut near, mut far) = if left { (x[0], x[1]) } else { (x[1], x[2]) };
    let (mut first, mut last) = if left { (y[0], y[1]) } else { (y[1], y[2]) };
    while let Some(m) = between(near, far) {
        let Some(middle) = f(m).value else { break };
        if (middle - first).abs() < (last - middle).abs() {
            (near, first) = (m, middle);
        } else {
            (far, last) = (m, middle);
        }
    }
    ((last - first).abs() >= 0.5 * JUMP_STAYS * size).then_some(Border { near, far, is_change: false })
}

#[cfg(test)]
mod tests {
    use katydid_elementary::Elementary;

    use super::*;

    fn found(f: impl Fn(f64) -> f64, x: f64, end: f64) -> Option<f64> {
        first(&mut |x| Sample { value: Some(f(x)), shape: 0 }, x, end).map(|border| border.far)
    }

    #[test]
    fn jumps_are_found_where_they_are() {
        let near = |found: Option<f64>, at: f64| {
            assert!(found.is_some_and(|x| (x - at).abs() < 1e-12), "{found:?} {at}")
        };
        near(found(f64::floor, 0.3, 10.0), 1.0);
        near(found(f64::floor, 3.3, 0.0), 3.0);
        near(found(|x| (100.0 * x).floor(), 0.5051, 1.0), 0.51);
        near(found(|x| x + 1e-4 * if x > 0.7 { 1.0 } else { 0.0 }, 0.0, 1.0), 0.7);
        near(found(|x| x.sine() * if x > 2.0 { 1.2 } else { 1.0 }, 0.1, 9.0), 2.0);
    }

    #[test]
    fn what_is_steep_or_has_corners_does_not_jump() {
        let smooth: [fn(f64) -> f64; 6] = [
            |x| (20.0 * x).sine(),
            |x| (x - 0.37).abs(),
            |x| (x - 0.37).abs().sqrt(),
            |x| (1000.0 * (x - 0.5)).hyperbolic_tangent(),
            |x| x.cube_root(),
            |x| 3.0 * x + 1e6,
        ];
        for (case, f) in smooth.into_iter().enumerate() {
            assert_eq!(found(f, 0.21, 1.0), None, "{case}");
            assert_eq!(found(f, 0.21, 0.0), None, "{case}");
        }
    }
}
