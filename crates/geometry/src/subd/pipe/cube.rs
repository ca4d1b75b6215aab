//! Nodes that are cubes.

use katydid_elementary::Elementary;

use crate::subd::thresholds::BETTER_COSINE;
use crate::{Point3, Vector3};

/// The angle between the axis of a cube through the middle of a side and that through a corner, in radians.
const CORNER: f64 = 0.955_316_618_124_509_3;

/// A cube about a node. Corner k lies at the upper end of axis i where bit i of k is set.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cube {
    pub(super) corners: [Point3; 8],
    axes: [Vector3; 3],
}

/// The corners of the sides, counter-clockwise seen from outside: lower and upper of x, y and z.
pub(super) const SIDES: [[usize; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

impl Cube {
    pub(super) fn new(middle: Point3, axes: [Vector3; 3], half: f64) -> Self {
        let [x, y, z] = axes.map(|axis| axis * half);
        let corners = std::array::from_fn(|k| {
            let sign = |bit: usize| if k >> bit & 1 == 1 { 1.0 } else { -1.0 };
            middle + x * sign(0) + y * sign(1) + z * sign(2)
        });
        Self { corners, axes }
    }

    /// The side that a direction passes through.
    pub(super) fn side(&self, direction: Vector3) -> usize {
        side_of(&self.axes, direction).0
    }
}

/// The side of a cube with these axes that a direction passes through, and the cosine of the angle to its axis.
fn side_of(axes: &[Vector3; 3], direction: Vector3) -> (usize, f64) {
    let along = axes.map(|axis| axis.dot(direction));
    let mut best = 0;
    for k in 1..3 {
        if along[k].abs() > along[best].abs() {
            best = k;
        }
    }
    (2 * best + usize::from(along[best] > 0.0), along[best].abs())
}

/// The axes of a cube each of whose sides at most one direction passes through, all of them within a part `fit` of the
/// largest angle there is from the axis of the side; of several such cubes the one whose worst angle is least.
pub(super) fn fitted(directions: &[Vector3], fit: f64) -> Option<[Vector3; 3]> {
    if !(2..=6).contains(&directions.len()) {
        return None;
    }
    let least = (fit.min(1.0) * CORNER).cosine() - BETTER_COSINE;
    let mut best: Option<([Vector3; 3], f64)> = None;
    for (i, a) in directions.iter().enumerate() {
        for b in directions.iter().skip(i + 1) {
            let Some(axes) = frame(*a, *b) else { continue };
            let mut taken = [false; 6];
            let mut worst = 1.0_f64;
            for direction in directions {
                let (side, cosine) = side_of(&axes, *direction);
                worst = if std::mem::replace(&mut taken[side], true) { -1.0 } else { worst.min(cosine) };
            }
            if worst >= least && best.is_none_or(|(_, known)| worst > known + BETTER_COSINE) {
                best = Some((axes, worst));
            }
        }
    }
    best.map(|(axes, _)| axes)
}

/// The frame that lies evenly between two directions and the axes they stand for.
fn frame(a: Vector3, b: Vector3) -> Option<[Vector3; 3]> {
    let z = a.cross(b).unitized()?;
    // Turned in their plane so that both are off by as much.
    let middle = (a + b).unitized()?;
    let x = middle.rotated(-std::f64::consts::FRAC_PI_4, z)?;
    Some([x, z.cross(x), z])
}
