//! A surface as something to walk on: its domain, where it closes, where it collapses to a point, its derivatives, and
//! bounds on these over any part of the domain.

mod bounds;
mod carrier;
mod kinks;
pub(crate) mod thresholds;

pub use carrier::{Axis, Carrier};
pub(crate) use kinks::{Breaks, changes_speed, smooth_pieces};

use std::sync::Arc;

use crate::nurbs::Nets;
use crate::{Direction, Interval, NurbsSurface, Point3, Quadrant, Result, Side, Vector3, cancellation};

/// A Bézier patch of the surface in homogeneous form, v running fastest.
#[derive(Debug, Clone, Copy)]
struct Patch<'a> {
    ranges: [[f64; 2]; 2],
    points: &'a [[f64; 4]],
}

/// A NURBS surface prepared to be walked on.
#[derive(Debug)]
pub(crate) struct Chart {
    nurbs: NurbsSurface,
    domain: [Interval; 2],
    closed: [bool; 2],
    /// Whether the sides at the start and the end of u, and of v, are single points.
    collapsed: [[bool; 2]; 2],
    nets: Arc<Nets>,
    counts: [usize; 2],
    /// The length of the diagonal of the box of the control points.
    size: f64,
}

impl Chart {
    /// Prepares a surface.
    ///
    /// # Errors
    /// The surface has weights that are not above 0, for which control points bound nothing; or the work was stopped.
    pub(crate) fn new(nurbs: NurbsSurface) -> Result<Self> {
        if nurbs.weights().iter().any(|w| !(*w > 0.0)) {
            return Err(crate::Error::Unsupported(
                "intersections of surfaces with weights that are not above 0",
            ));
        }
        cancellation::check_now()?;
        let size = nurbs.hull_box().diagonal().length();
        Ok(Self {
            domain: Direction::BOTH.map(|d| nurbs.domain(d)),
            closed: Direction::BOTH.map(|d| nurbs.is_closed(d)),
            collapsed: [[Side::West, Side::East], [Side::South, Side::North]]
                .map(|sides| sides.map(|s| nurbs.is_singular(s))),
            counts: nurbs.degrees().map(|d| d + 1),
            nets: Arc::new(Nets::new(&nurbs)),
            size,
            nurbs,
        })
    }

    /// The surface itself.
    pub(crate) fn nurbs(&self) -> &NurbsSurface {
        &self.nurbs
    }

    /// The Bézier nets of the surface.
    pub(crate) fn nets(&self) -> Arc<Nets> {
        Arc::clone(&self.nets)
    }

    fn patch(&self, index: usize) -> Patch<'_> {
        Patch { ranges: self.nets.ranges(index), points: self.nets.net(&self.nurbs, index) }
    }

    /// The range of one parameter, 0 for u.
    pub(crate) fn domain(&self, k: usize) -> Interval {
        self.domain[k]
    }

    /// The period of a direction in which the surface meets itself.
    pub(crate) fn period(&self, k: usize) -> Option<f64> {
        self.closed[k].then(|| self.domain[k].length())
    }

    /// Whether the side where parameter `k` starts or ends is a single point.
    pub(crate) fn is_collapsed(&self, k: usize, at_end: bool) -> bool {
        self.collapsed[k][usize::from(at_end)]
    }

    /// The parameters of lines between patches inside a range of one direction, also beyond seams.
    pub(crate) fn lines_between(&self, k: usize, low: f64, high: f64) -> Vec<f64> {
        let lines = &self.nets.lines[k];
        let inner = lines.get(1..lines.len().saturating_sub(1)).unwrap_or(&[]);
        let turns = self.period(k).map_or(vec![0.0], |p| vec![0.0, p, -p]);
        let moved = turns.into_iter().flat_map(|turn| inner.iter().map(move |t| t + turn));
        moved.filter(|t| low < *t && *t < high).collect()
    }

    /// The points to which sides collapse.
    pub(crate) fn poles(&self) -> Vec<Point3> {
        let mut out = Vec::new();
        for k in 0..2 {
            for at_end in [false, true] {
                if self.is_collapsed(k, at_end) {
                    let mut at = self.domain.map(Interval::middle);
                    at[k] = if at_end { self.domain[k].end } else { self.domain[k].start };
                    out.push(self.nurbs.point_at(at[0], at[1]));
                }
            }
        }
        out
    }

    /// Whether it has a tangent plane anywhere: in each patch it is looked for at more places than the normal, a polynomial
    /// times a factor, can have zeros along a line.
    pub(crate) fn has_area(&self) -> bool {
        (0..self.nets.len()).map(|i| self.nets.ranges(i)).any(|ranges| {
            let [n, m] = self.counts.map(|c| 2 * c);
            let at = |k: usize, i: usize, of: usize| {
                let [a, b] = ranges[k];
                a + (b - a) * (i as f64 + 0.5) / of as f64
            };
            (0..n).any(|i| {
                (0..m).any(|j| {
                    let [_, u, v] = self.jet([at(0, i, n), at(1, j, m)]);
                    let widths = [0, 1].map(|k| ranges[k][1] - ranges[k][0]);
                    let (u, v) = (u * widths[0], v * widths[1]);
                    u.cross(v).length() > thresholds::NO_AREA * u.length().max(v.length()).powi(2)
                })
            })
        })
    }

    /// The length of the diagonal of the surface's box.
    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    /// Parameters beyond the seam of a closed direction, brought back by periods; others as they are.
    fn inside(&self, uv: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|k| {
            let domain = self.domain[k];
            if self.closed[k] && !domain.contains(uv[k]) { domain.wrapped(uv[k]) } else { uv[k] }
        })
    }

    /// From which side derivatives are taken at the ends of the domain: from within.
    fn side(&self, uv: [f64; 2]) -> Quadrant {
        match [uv[0] >= self.domain[0].end, uv[1] >= self.domain[1].end] {
            [false, false] => Quadrant::NorthEast,
            [true, false] => Quadrant::NorthWest,
            [true, true] => Quadrant::SouthWest,
            [false, true] => Quadrant::SouthEast,
        }
    }

    /// The position and the derivatives by u and v.
    pub(crate) fn jet(&self, uv: [f64; 2]) -> [Vector3; 3] {
        cancellation::worked(1);
        let uv = self.inside(uv);
        self.nurbs.partials_at(uv[0], uv[1], self.side(uv))
    }

    /// As [`Self::jet`], then the second derivatives by uu, uv and vv.
    pub(crate) fn second_jet(&self, uv: [f64; 2]) -> [Vector3; 6] {
        cancellation::worked(2);
        let uv = self.inside(uv);
        self.nurbs.second_partials_at(uv[0], uv[1], self.side(uv))
    }

    /// The velocity in parameters of a point that moves on the surface with velocity `w`; `None` where the surface is
    /// singular.
    pub(crate) fn lifted(jet: &[Vector3; 3], w: Vector3) -> Option<[f64; 2]> {
        let (a, b) = (jet[1], jet[2]);
        let (e, f, g) = (a.dot(a), a.dot(b), b.dot(b));
        let determinant = e * g - f * f;
        if !(determinant > thresholds::PARALLEL_SQUARED * e * g) {
            return None;
        }
        let (p, q) = (w.dot(a), w.dot(b));
        Some([(g * p - f * q) / determinant, (e * q - f * p) / determinant])
    }

    /// Parameters moved by whole periods to where they are nearest to `near`.
    pub(crate) fn unwrapped(&self, uv: [f64; 2], near: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|k| match self.period(k) {
            Some(period) => uv[k] + period * ((near[k] - uv[k]) / period).round(),
            None => uv[k],
        })
    }
}
