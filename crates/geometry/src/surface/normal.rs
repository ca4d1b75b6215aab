//! Normals, also where derivatives vanish, and frames.

use super::Surface;
use crate::surface::thresholds::{ANISOTROPY, NORMAL_LENGTH, NORMAL_SERIES};
use crate::{Direction, Interval, NurbsSurface, Plane, Point3, Quadrant, SurfaceDerivatives, Vector3};

/// The highest order of derivatives that the search for a limit normal looks at.
const LIMIT_ORDER: usize = 6;

/// What normals and curvature are made from.
pub(super) trait Evaluate {
    /// The domain in one direction.
    fn range(&self, direction: Direction) -> Interval;

    /// Point and derivatives up to an order.
    fn jet(&self, u: f64, v: f64, order: usize, side: Quadrant) -> SurfaceDerivatives;

    /// The lengths of both domains: what makes derivatives by u and v comparable.
    fn lengths(&self) -> [f64; 2] {
        Direction::BOTH.map(|d| self.range(d).length())
    }

    /// From below at the largest parameters.
    fn inner(&self, u: f64, v: f64) -> Quadrant {
        Quadrant::new(u >= self.range(Direction::U).end, v >= self.range(Direction::V).end)
    }

    /// The normal of the piece on a side, the limit where it is singular taken from the middle of the domain.
    fn normal(&self, u: f64, v: f64) -> Option<Vector3> {
        let [x, y] = Direction::BOTH.map(|d| self.range(d).middle());
        self.normal_from(u, v, self.inner(u, v), Quadrant::new(u > x, v > y))
    }

    /// The normal of the piece on a side, the limit where it is singular taken from another.
    fn normal_from(&self, u: f64, v: f64, side: Quadrant, inwards: Quadrant) -> Option<Vector3> {
        regular_normal(&self.jet(u, v, 1, side), self.lengths())
            .or_else(|| limit_normal(&self.jet(u, v, LIMIT_ORDER, side), inwards, self.lengths()))
    }

    /// The tangent plane: x along Su, z the normal.
    fn frame(&self, u: f64, v: f64) -> Option<Plane> {
        let z_axis = self.normal(u, v)?;
        let d = self.jet(u, v, 1, self.inner(u, v));
        let [lu, lv] = self.lengths();
        let (du, dv) = (d.get(1, 0) * lu, d.get(0, 1) * lv);
        let x_axis = if du.length() > ANISOTROPY * dv.length() {
            du.rejected_from(z_axis).and_then(Vector3::unitized)?
        } else {
            dv.cross(z_axis).unitized()?
        };
        Some(Plane { origin: d.point(), x_axis, y_axis: z_axis.cross(x_axis), z_axis })
    }
}

impl Evaluate for Surface {
    fn range(&self, direction: Direction) -> Interval {
        self.domain(direction)
    }

    fn jet(&self, u: f64, v: f64, order: usize, side: Quadrant) -> SurfaceDerivatives {
        self.derivatives(u, v, order, side)
    }
}

impl Evaluate for NurbsSurface {
    fn range(&self, direction: Direction) -> Interval {
        self.domain(direction)
    }

    fn jet(&self, u: f64, v: f64, order: usize, side: Quadrant) -> SurfaceDerivatives {
        self.derivatives(u, v, order, side)
    }
}

impl Surface {
    /// The quadrant from which (u, v) is approached inside the domain: from below at the largest parameters.
    pub fn inner_quadrant(&self, u: f64, v: f64) -> Quadrant {
        self.inner(u, v)
    }

    /// The unit normal at (u, v): the direction of ∂S/∂u × ∂S/∂v. Where that vanishes, as at a pole or an apex, it is
    /// the limit along the diagonal towards the middle of the domain, by higher derivatives; `None` when there is
    /// none either, as on a surface that is a curve.
    pub fn normal_at(&self, u: f64, v: f64) -> Option<Vector3> {
        self.normal(u, v)
    }

    /// The unit normal at (u, v) of the piece on a side, at a singular point the limit from it.
    pub fn normal_on_side(&self, u: f64, v: f64, side: Quadrant) -> Option<Vector3> {
        self.normal_from(u, v, side, side)
    }

    /// The plane that touches the surface at (u, v): x along ∂S/∂u, z the normal. Where ∂S/∂u vanishes, y is along
    /// ∂S/∂v. `None` where there is no normal.
    pub fn frame_at(&self, u: f64, v: f64) -> Option<Plane> {
        self.frame(u, v)
    }

    /// How far `p` lies in front of the surface, seen from its point at (u, v): the part of the way from there to
    /// `p` along the normal, negative behind. When (u, v) is the nearest point, its sign tells on which side `p` is.
    /// `None` where there is no normal.
    pub fn height_over(&self, u: f64, v: f64, p: Point3) -> Option<f64> {
        Some((p - self.point_at(u, v)).dot(self.normal_at(u, v)?))
    }
}

impl NurbsSurface {
    /// The unit normal at (u, v), as [`Surface::normal_at`].
    pub fn normal_at(&self, u: f64, v: f64) -> Option<Vector3> {
        self.normal(u, v)
    }

    /// The unit normal at (u, v) of the piece on a side, as [`Surface::normal_on_side`].
    pub fn normal_on_side(&self, u: f64, v: f64, side: Quadrant) -> Option<Vector3> {
        self.normal_from(u, v, side, side)
    }

    /// The plane that touches the surface at (u, v), as [`Surface::frame_at`].
    pub fn frame_at(&self, u: f64, v: f64) -> Option<Plane> {
        self.frame(u, v)
    }
}

/// The normal from the first derivatives alone, unless one of them, or the angle between them, is lost in rounding.
pub(super) fn regular_normal(d: &SurfaceDerivatives, [lu, lv]: [f64; 2]) -> Option<Vector3> {
    let (du, dv) = (d.get(1, 0) * lu, d.get(0, 1) * lv);
    let (a, b) = (du.length(), dv.length());
    // A derivative this much smaller than the other is noise of the sum that made it; openNURBS draws the same line
    // at the square root of the machine epsilon.
    if !(a > ANISOTROPY * b && b > ANISOTROPY * a) {
        return None;
    }
    let normal = du.unitized()?.cross(dv.unitized()?);
    if normal.length() <= NORMAL_LENGTH { None } else { normal.unitized() }
}

/// The direction of Su × Sv close to a point where it vanishes: on the diagonal (±t, ±t) into the quadrant both
/// derivatives are power series in t, and the first coefficient of their product's that does not vanish gives the
/// limit (openNURBS goes to the first order; this goes on).
fn limit_normal(d: &SurfaceDerivatives, side: Quadrant, [lu, lv]: [f64; 2]) -> Option<Vector3> {
    let sign = side.from_below().map(|below| if below { -1.0 } else { 1.0 });
    // Term k of the series of the derivative that is (i, j) at t = 0, scaled to the unit square.
    let term = |i: usize, j: usize, k: usize| {
        let (mut sum, mut choose, mut factorial) = (Vector3::ZERO, 1.0, 1.0);
        for n in 1..=k {
            factorial *= n as f64;
        }
        for b in 0..=k {
            let a = k - b;
            let scale = (lu * sign[0]).powi(a as i32) * (lv * sign[1]).powi(b as i32);
            sum += d.get(i + a, j + b) * (choose * scale);
            choose = choose * a as f64 / (b + 1) as f64;
        }
        sum * (lu.powi(i as i32) * lv.powi(j as i32) / factorial)
    };
    let us: Vec<Vector3> = (0..LIMIT_ORDER).map(|k| term(1, 0, k)).collect();
    let vs: Vec<Vector3> = (0..LIMIT_ORDER).map(|k| term(0, 1, k)).collect();
    let size = |list: &[Vector3]| list.iter().map(|v| v.length()).fold(0.0, f64::max);
    let scale = size(&us) * size(&vs);
    if !(scale > 0.0 && scale.is_finite()) {
        return None;
    }
    (1..LIMIT_ORDER)
        .map(|n| {
            us.iter()
                .zip(vs.iter().take(n + 1).rev().collect::<Vec<_>>())
                .take(n + 1)
                .fold(Vector3::ZERO, |sum, (a, b)| sum + a.cross(*b))
        })
        .find(|c| c.length() > NORMAL_SERIES * scale)
        .and_then(Vector3::unitized)
}
