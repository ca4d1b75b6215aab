//! How surfaces bend: fundamental forms, principal, Gaussian and mean curvature, and normal sections.

use katydid_elementary::Elementary;

use super::Surface;
use super::normal::{Evaluate, regular_normal};
use crate::surface::thresholds::SAME_CURVATURE;
use crate::thresholds;
use crate::{Circle, Error, NurbsSurface, Plane, Point3, Quadrant, Result, SurfaceDerivatives, Vector3};

/// How a surface bends at a regular point. Curvatures are positive where the surface bends towards its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SurfaceCurvature {
    /// The point.
    pub point: Point3,
    /// The unit normal, the direction of Su × Sv.
    pub normal: Vector3,
    /// The first fundamental form E, F, G: Su·Su, Su·Sv, Sv·Sv.
    pub first_form: [f64; 3],
    /// The second fundamental form L, M, N: Suu·n, Suv·n, Svv·n.
    pub second_form: [f64; 3],
    /// The principal curvatures, the larger first, in 1/units.
    pub principal: [f64; 2],
    /// The unit tangents along which the principal curvatures occur, at right angles; with the normal
    /// right-handed (first × second = normal). At an umbilic, where all directions are equal, the first is along Su.
    pub directions: [Vector3; 2],
    /// The Gaussian curvature: the product of the principal ones.
    pub gaussian: f64,
    /// The mean curvature: half their sum.
    pub mean: f64,
}

/// The curve in which a surface is cut by the plane through its normal and a tangent direction, close to the point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NormalSection {
    /// The plane of the cut: x along the tangent direction, y along the surface normal.
    pub plane: Plane,
    /// The curvature by Euler's formula, k₁ cos² φ + k₂ sin² φ with φ the angle to the first principal direction.
    pub by_euler: f64,
    /// The curvature of the curve of intersection itself, from its own first two derivatives in the plane of the cut.
    pub by_cutting: f64,
}

impl NormalSection {
    /// The circle that touches the section best; `None` where it is straight.
    pub fn osculating_circle(&self) -> Option<Circle> {
        let radius = 1.0 / self.by_cutting;
        let center = self.plane.at(0.0, radius, 0.0);
        Circle::new(self.plane.with_origin(center), radius.abs()).ok().filter(|_| center.is_finite())
    }
}

impl SurfaceCurvature {
    /// From the point and the derivatives up to the second order; `None` where Su and Sv are parallel or vanish.
    ///
    /// The shape operator is set up in an orthonormal frame of the tangent plane, where it is a symmetric matrix:
    /// its eigenvalues are the principal curvatures and its eigenvectors are at right angles even next to an umbilic
    /// (M. do Carmo, *Differential Geometry of Curves and Surfaces*, §3-2; the frame is Gram–Schmidt's).
    pub fn from_derivatives(d: &SurfaceDerivatives) -> Option<Self> {
        let [su, sv, suu, suv, svv] = [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2)].map(|(i, j)| d.get(i, j));
        let e1 = su.unitized()?;
        let normal = e1.cross(sv.unitized()?).unitized()?;
        let e2 = normal.cross(e1);
        // su = a e1, sv = b e1 + c e2.
        let (a, b, c) = (su.length(), sv.dot(e1), sv.dot(e2));
        let [l, m, n] = [suu, suv, svv].map(|s| s.dot(normal));
        // The second form on e1 = su/a and e2 = (sv − b e1)/c.
        let w11 = l / a / a;
        let w12 = (m / a - b * w11) / c;
        let w22 = (n / c - b * (2.0 * w12 + b * w11 / c)) / c;
        let half = 0.5 * (w11 - w22);
        let spread = half.hypotenuse(w12);
        let mean = 0.5 * (w11 + w22);
        if !(mean.is_finite() && spread.is_finite()) {
            return None;
        }
        // Half the angle of (half, w12); of an umbilic's rounding noise that is 0.
        let angle = if spread <= SAME_CURVATURE * mean.abs() { 0.0 } else { 0.5 * w12.arctangent_of(half) };
        let (sin, cos) = angle.sine_cosine();
        let first = e1 * cos + e2 * sin;
        Some(Self {
            point: d.point(),
            normal,
            first_form: [su.dot(su), su.dot(sv), sv.dot(sv)],
            second_form: [l, m, n],
            principal: [mean + spread, mean - spread],
            directions: [first, normal.cross(first)],
            gaussian: w11 * w22 - w12 * w12,
            mean,
        })
    }

    /// The curvature of the normal section in a tangent direction, by Euler's formula; only the direction's part in
    /// the tangent plane counts. `None` for a direction without such a part.
    pub fn normal_curvature(&self, direction: Vector3) -> Option<f64> {
        let [first, second] = self.directions;
        let (x, y) = (direction.dot(first), direction.dot(second));
        let squared = x * x + y * y;
        let [k1, k2] = self.principal;
        (squared > thresholds::NO_LENGTH_SQUARED * direction.length_squared() && squared.is_finite())
            .then(|| (k1 * x * x + k2 * y * y) / squared)
    }

    /// Whether the surface bends equally in all directions, within `tolerance` in 1/units.
    pub fn is_umbilic(&self, tolerance: f64) -> bool {
        self.principal[0] - self.principal[1] <= tolerance
    }
}

fn curvature(s: &impl Evaluate, u: f64, v: f64, side: Quadrant) -> Result<SurfaceCurvature> {
    let d = s.jet(u, v, 2, side);
    regular_normal(&d, s.lengths())
        .and_then(|_| SurfaceCurvature::from_derivatives(&d))
        .ok_or(Error::degenerate("surface curvature", "the surface is singular at this point"))
}

fn section(s: &impl Evaluate, u: f64, v: f64, direction: Vector3) -> Result<NormalSection> {
    let side = s.inner(u, v);
    let c = curvature(s, u, v, side)?;
    let no_direction = Error::degenerate("section direction", "it has no part in the tangent plane");
    let by_euler = c.normal_curvature(direction).ok_or(no_direction.clone())?;
    let x_axis = direction.rejected_from(c.normal).and_then(Vector3::unitized).ok_or(no_direction)?;
    let plane = Plane { origin: c.point, x_axis, y_axis: c.normal, z_axis: x_axis.cross(c.normal) };
    let by_cutting = cut_curvature(&s.jet(u, v, 2, side), &plane)
        .ok_or(Error::degenerate("surface curvature", "the surface is singular at this point"))?;
    Ok(NormalSection { plane, by_euler, by_cutting })
}

impl Surface {
    /// How the surface bends at (u, v), on exact derivatives; at a knot those of the piece that goes on.
    ///
    /// # Errors
    /// The point is singular (a pole, an apex, a degenerate side): Su and Sv are parallel or one of them vanishes.
    pub fn curvature_at(&self, u: f64, v: f64) -> Result<SurfaceCurvature> {
        curvature(self, u, v, self.inner(u, v))
    }

    /// How the surface bends at (u, v) in the piece on one side.
    ///
    /// # Errors
    /// As [`Surface::curvature_at`].
    pub fn curvature_on_side(&self, u: f64, v: f64, side: Quadrant) -> Result<SurfaceCurvature> {
        curvature(self, u, v, side)
    }

    /// The section of the surface at (u, v) by the plane of its normal and a tangent direction, with its curvature
    /// both by Euler's formula and from the curve of intersection.
    ///
    /// # Errors
    /// The point is singular, or the direction has no part in the tangent plane.
    pub fn normal_section(&self, u: f64, v: f64, direction: Vector3) -> Result<NormalSection> {
        section(self, u, v, direction)
    }
}

impl NurbsSurface {
    /// How the surface bends at (u, v), as [`Surface::curvature_at`].
    ///
    /// # Errors
    /// The point is singular.
    pub fn curvature_at(&self, u: f64, v: f64) -> Result<SurfaceCurvature> {
        curvature(self, u, v, self.inner(u, v))
    }

    /// How the surface bends at (u, v) in the piece on one side.
    ///
    /// # Errors
    /// The point is singular.
    pub fn curvature_on_side(&self, u: f64, v: f64, side: Quadrant) -> Result<SurfaceCurvature> {
        curvature(self, u, v, side)
    }

    /// A normal section at (u, v), as [`Surface::normal_section`].
    ///
    /// # Errors
    /// The point is singular, or the direction has no part in the tangent plane.
    pub fn normal_section(&self, u: f64, v: f64, direction: Vector3) -> Result<NormalSection> {
        section(self, u, v, direction)
    }
}

/// The curvature of the curve (u(t), v(t)) on which a surface meets a plane through the point: the height over the
/// plane stays 0 along it, which gives its direction and bend in u and v, and the chain rule its derivatives in the
/// plane.
fn cut_curvature(d: &SurfaceDerivatives, plane: &Plane) -> Option<f64> {
    let height = |i: usize, j: usize| d.get(i, j).dot(plane.z_axis);
    let (hu, hv) = (height(1, 0), height(0, 1));
    let squared = hu * hu + hv * hv;
    if !(squared > 0.0 && squared.is_finite()) {
        return None;
    }
    // Along the level curve of the height; its bend is taken across it, which changes nothing along.
    let (u1, v1) = (-hv, hu);
    let bend = height(2, 0) * u1 * u1 + 2.0 * height(1, 1) * u1 * v1 + height(0, 2) * v1 * v1;
    let (u2, v2) = (-hu * bend / squared, -hv * bend / squared);
    let first = d.get(1, 0) * u1 + d.get(0, 1) * v1;
    let second = d.get(2, 0) * (u1 * u1)
        + d.get(1, 1) * (2.0 * u1 * v1)
        + d.get(0, 2) * (v1 * v1)
        + d.get(1, 0) * u2
        + d.get(0, 1) * v2;
    let (x1, y1) = (first.dot(plane.x_axis), first.dot(plane.y_axis));
    let (x2, y2) = (second.dot(plane.x_axis), second.dot(plane.y_axis));
    // Walked along +x, so that bending towards +y is positive.
    let curvature = (x1 * y2 - y1 * x2) / x1.hypotenuse(y1).powi(3) * x1.signum();
    curvature.is_finite().then_some(curvature)
}
