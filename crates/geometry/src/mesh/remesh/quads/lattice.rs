//! Crosses and lattices of neighbouring places, turned and moved to fit each other (Jakob and others 2015, section 3,
//! the measures in space).

use crate::{Point3, Vector3};

/// A unit direction in the tangent plane of a unit normal; it stands for all four quarter turns of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cross {
    pub(super) direction: Vector3,
    pub(super) normal: Vector3,
}

impl Cross {
    /// The direction a quarter turn on.
    pub(super) fn across(&self) -> Vector3 {
        self.normal.cross(self.direction)
    }

    /// Of two crosses the directions that are nearest to each other.
    pub(super) fn fitted(&self, other: &Self) -> (Vector3, Vector3) {
        let own = [self.direction, self.across()];
        let mut best = (f64::NEG_INFINITY, self.direction, other.direction);
        for a in own {
            for b in [other.direction, other.across()] {
                let dot = a.dot(b);
                if dot.abs() > best.0 {
                    best = (dot.abs(), a, if dot < 0.0 { -b } else { b });
                }
            }
        }
        (best.1, best.2)
    }
}

/// A lattice of squares in a tangent plane: one of its points, and its cross.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lattice {
    pub(super) place: Point3,
    pub(super) cross: Cross,
}

impl Lattice {
    /// The lattice point at or before a point in both directions.
    fn floor(&self, p: Point3, side: f64) -> Point3 {
        self.stepped(p, side, f64::floor)
    }

    /// The lattice point nearest to a point.
    pub(super) fn nearest(&self, p: Point3, side: f64) -> Point3 {
        self.stepped(p, side, f64::round)
    }

    fn stepped(&self, p: Point3, side: f64, whole: impl Fn(f64) -> f64) -> Point3 {
        let (q, t, d) = (self.cross.direction, self.cross.across(), p - self.place);
        self.place + q * (whole(q.dot(d) / side) * side) + t * (whole(t.dot(d) / side) * side)
    }

    /// The points of two lattices at places `at` nearest to each other, of those about the place between.
    pub(super) fn fitted(&self, other: &Self, at: [Point3; 2], side: f64) -> (Point3, Point3) {
        let middle = between(at, [self.cross.normal, other.cross.normal]);
        let corners = |lattice: &Self| {
            let (p, q, t) =
                (lattice.floor(middle, side), lattice.cross.direction * side, lattice.cross.across() * side);
            [p, p + q, p + t, p + q + t]
        };
        let mut best = (f64::INFINITY, self.place, other.place);
        for a in corners(self) {
            for b in corners(other) {
                let d = (a - b).length_squared();
                if d < best.0 {
                    best = (d, a, b);
                }
            }
        }
        (best.1, best.2)
    }
}

/// The point in both tangent planes nearest to two points: that which minimises the sum of the squared distances.
fn between([p, q]: [Point3; 2], [n, m]: [Vector3; 2]) -> Point3 {
    /// Keeps apart what is parallel.
    const APART: f64 = 1e-4;
    let (d, c) = (q - p, n.dot(m));
    let (along_n, along_m) = (n.dot(d), -m.dot(d));
    let scale = 1.0 / (1.0 - c * c + APART);
    let first = 2.0 * (along_n - c * along_m) * scale;
    let second = 2.0 * (along_m - c * along_n) * scale;
    p.lerp(q, 0.5) - (n * first + m * second) * 0.25
}
