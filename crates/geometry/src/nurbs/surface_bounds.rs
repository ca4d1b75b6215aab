//! Boxes around surfaces.

use crate::nurbs::thresholds::BOUND_SLACK;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::NurbsSurface;
use crate::bernstein::BUDGET;
use crate::{BoundingBox, Box3, Interval, Plane, Point3, Vector3};

/// A patch that is looked at before those with a lower bound.
struct Candidate {
    bound: f64,
    patch: Patch,
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

/// A rational function's Bernstein coefficients on a patch: numerators and weights, v running fastest.
struct Patch {
    counts: [usize; 2],
    values: Vec<[f64; 2]>,
}

impl Patch {
    fn at(&self, i: usize, j: usize) -> f64 {
        self.values.get(i * self.counts[1] + j).map_or(f64::NEG_INFINITY, |[n, w]| n / w)
    }

    /// The largest coefficient, which no value exceeds.
    fn bound(&self) -> f64 {
        self.values.iter().map(|[n, w]| n / w).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest of the values at the four corners.
    fn reached(&self) -> f64 {
        let [i, j] = self.counts.map(|n| n - 1);
        self.at(0, 0).max(self.at(i, 0)).max(self.at(0, j)).max(self.at(i, j))
    }

    /// How far the coefficients are from linear along u and along v.
    fn bends(&self) -> [f64; 2] {
        let [n, m] = self.counts;
        let mut bends = [0.0_f64; 2];
        for i in 0..n {
            for j in 0..m {
                let middle = 2.0 * self.at(i, j);
                if i > 0 && i + 1 < n {
                    bends[0] = bends[0].max((self.at(i - 1, j) + self.at(i + 1, j) - middle).abs());
                }
                if j > 0 && j + 1 < m {
                    bends[1] = bends[1].max((self.at(i, j - 1) + self.at(i, j + 1) - middle).abs());
                }
            }
        }
        bends
    }

    /// The halves along the more bent direction, by de Casteljau's algorithm at 1/2 in each of its lines.
    fn halves(&self) -> [Self; 2] {
        let bends = self.bends();
        let [n, m] = self.counts;
        // Coefficient k of a line is at `start + k * step`.
        let (length, step, starts): (usize, usize, Vec<usize>) = if bends[0] >= bends[1] {
            (n, m, (0..m).collect())
        } else {
            (m, 1, (0..n).map(|i| i * m).collect())
        };
        let (mut low, mut high) = (self.values.clone(), self.values.clone());
        for start in starts {
            for level in 1..length {
                for k in 0..length - level {
                    let (a, b) = (start + k * step, start + (k + 1) * step);
                    let mixed = [0, 1].map(|c| 0.5 * (high[a][c] + high[b][c]));
                    high[a] = mixed;
                    if k == 0 {
                        low[start + level * step] = mixed;
                    }
                }
            }
        }
        [Self { counts: self.counts, values: low }, Self { counts: self.counts, values: high }]
    }
}

impl NurbsSurface {
    /// The box around the control points in space: it holds the surface, but may be larger. This is what openNURBS
    /// calls a surface's bounding box.
    pub fn hull_box(&self) -> BoundingBox {
        crate::cancellation::worked(self.point_count() / 16);
        BoundingBox::from_points(self.control_points())
            .unwrap_or(BoundingBox { min: Point3::ORIGIN, max: Point3::ORIGIN })
    }

    /// The range that the surface reaches along `direction`, measured from the origin in lengths of it.
    ///
    /// By halving Bézier patches, the most promising first, until their control points bound the surface to 1e-12 of
    /// its size. When that takes more than some 20,000 halvings (a curved ridge of equal height), the bound reached
    /// is given, which holds the surface and is larger than it by some 1e-8 of its size.
    pub fn extent_along(&self, direction: Vector3) -> Interval {
        let patches = self.bezier_patches().unwrap_or_default();
        let extreme = |sign: f64| {
            let start: Vec<Patch> = patches
                .iter()
                .map(|patch| {
                    let values = patch.homogeneous_points();
                    let values = values.iter().map(|p| {
                        [sign * (p[0] * direction.x + p[1] * direction.y + p[2] * direction.z), p[3]]
                    });
                    Patch { counts: patch.counts(), values: values.collect() }
                })
                .collect();
            let size = start.iter().flat_map(|p| &p.values).fold(0.0_f64, |m, [n, w]| m.max((n / w).abs()));
            let mut best = start.iter().map(Patch::reached).fold(f64::NEG_INFINITY, f64::max);
            // Large patches are halved fewer times: all of them together stay within some 60 MB.
            let length = start.first().map_or(1, |p| p.values.len());
            let mut budget = (BUDGET as usize).min(4_000_000 / length.max(1));
            let candidate = |patch: Patch| Candidate { bound: patch.bound(), patch };
            let mut queue: BinaryHeap<Candidate> = start.into_iter().map(candidate).collect();
            while let Some(Candidate { bound, patch }) = queue.pop() {
                if !(bound > best + BOUND_SLACK * size) {
                    break;
                }
                if budget == 0 {
                    return bound;
                }
                budget -= 1;
                let halves = patch.halves();
                best = halves.iter().map(Patch::reached).fold(best, f64::max);
                queue.extend(halves.map(candidate));
            }
            best
        };
        Interval::new(-extreme(-1.0), extreme(1.0))
    }

    /// The smallest box along the world axes that holds the surface, see [`NurbsSurface::extent_along`].
    pub fn bounding_box(&self) -> BoundingBox {
        let [x, y, z] = [Vector3::X, Vector3::Y, Vector3::Z].map(|axis| self.extent_along(axis));
        BoundingBox { min: Point3::new(x.start, y.start, z.start), max: Point3::new(x.end, y.end, z.end) }
    }

    /// The smallest box along a plane's axes that holds the surface, see [`NurbsSurface::extent_along`].
    pub fn bounding_box_in(&self, plane: &Plane) -> Box3 {
        let along = |axis: Vector3| {
            let range = self.extent_along(axis);
            let origin = plane.origin.to_vector().dot(axis);
            Interval::new(range.start - origin, range.end - origin)
        };
        Box3 { plane: *plane, x: along(plane.x_axis), y: along(plane.y_axis), z: along(plane.z_axis) }
    }
}
