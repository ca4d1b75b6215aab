//! Maps onto surfaces.

use katydid_elementary::Elementary;

use super::{Morph, finite};
use crate::thresholds;
use crate::{ClosestOnSurface, Direction, Error, Interval, Plane, Point3, Result, Surface, Vector3};

/// A surface that goes on beyond its edges: along the tangents at an open edge, round a closed one.
#[derive(Debug, Clone)]
pub(super) struct Sheet {
    surface: Surface,
    domains: [Interval; 2],
    closed: [bool; 2],
}

impl Sheet {
    pub(super) fn new(surface: &Surface) -> Self {
        Self {
            domains: Direction::BOTH.map(|d| surface.domain(d)),
            closed: Direction::BOTH.map(|d| surface.is_closed(d)),
            surface: surface.clone(),
        }
    }

    /// The point at a height along the normal over (u, v).
    pub(super) fn at(&self, u: f64, v: f64, height: f64) -> Result<Point3> {
        let wanted = [u, v];
        let [iu, iv]: [f64; 2] = std::array::from_fn(|i| {
            let domain = self.domains[i];
            match self.closed[i] {
                true if !domain.contains(wanted[i]) => domain.wrapped(wanted[i]),
                true => wanted[i],
                false => domain.clamp(wanted[i]),
            }
        });
        let mut point = self.surface.point_at(iu, iv);
        let beyond = [(u - iu, self.closed[0]), (v - iv, self.closed[1])];
        if beyond.iter().any(|(by, closed)| *by != 0.0 && !closed) {
            let d = self.surface.derivatives(iu, iv, 1, self.surface.inner_quadrant(iu, iv));
            for ((by, closed), along) in beyond.into_iter().zip([d.get(1, 0), d.get(0, 1)]) {
                if !closed {
                    point += along * by;
                }
            }
        }
        if height == 0.0 {
            return finite(point);
        }
        let none = Error::degenerate("surface", "it has no normal where something is to stand on it");
        finite(point + self.surface.normal_at(iu, iv).ok_or(none)? * height)
    }

    /// How far (u, v) is from an anchor, the shorter way round where the surface is closed.
    fn off_anchor(&self, place: [f64; 2], anchor: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|i| {
            let (by, period) = (place[i] - anchor[i], self.domains[i].length());
            if self.closed[i] && by.abs() > 0.5 * period { by - period * by.signum() } else { by }
        })
    }
}

/// A place on a surface, with the linear map between steps of its parameters and of its tangent plane.
#[derive(Debug, Clone)]
struct Anchor {
    sheet: Sheet,
    place: [f64; 2],
    /// The columns are ∂S/∂u and ∂S/∂v in the frame's x and y.
    matrix: [[f64; 2]; 2],
    determinant: f64,
}

impl Anchor {
    fn new(surface: &Surface, u: f64, v: f64) -> Result<Self> {
        if !(u.is_finite() && v.is_finite()) {
            return Err(Error::NotFinite("parameter"));
        }
        let sheet = Sheet::new(surface);
        let [u, v] = [sheet.domains[0].clamp(u), sheet.domains[1].clamp(v)];
        let none = Error::degenerate("anchor on a surface", "it has no tangent plane there");
        let frame = surface.frame_at(u, v).ok_or(none.clone())?;
        let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
        let (du, dv) = (d.get(1, 0), d.get(0, 1));
        let matrix =
            [[du.dot(frame.x_axis), dv.dot(frame.x_axis)], [du.dot(frame.y_axis), dv.dot(frame.y_axis)]];
        let determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
        if !(determinant.abs() > thresholds::ROUNDING * du.length() * dv.length()) {
            return Err(none);
        }
        Ok(Self { sheet, place: [u, v], matrix, determinant })
    }

    /// The step in the tangent plane that a step of the parameters comes to.
    fn step(&self, [du, dv]: [f64; 2]) -> [f64; 2] {
        self.matrix.map(|row| row[0] * du + row[1] * dv)
    }

    /// The point that lies over the parameters which a step in the tangent plane leads to.
    fn over(&self, [x, y]: [f64; 2], height: f64) -> Result<Point3> {
        let [[a, b], [c, d]] = self.matrix;
        let (du, dv) = ((d * x - b * y) / self.determinant, (a * y - c * x) / self.determinant);
        self.sheet.at(self.place[0] + du, self.place[1] + dv, height)
    }
}

/// From one surface to another: the nearest point's parameters as fractions of the domains, and the height along the
/// normal, are the same on both.
#[derive(Debug, Clone)]
pub struct MapToSurface {
    nearest: ClosestOnSurface,
    source: Sheet,
    target: Sheet,
}

impl MapToSurface {
    /// The map from `source` to `target`.
    ///
    /// # Errors
    /// The source has no NURBS form.
    pub fn new(source: &Surface, target: &Surface) -> Result<Self> {
        let nearest = ClosestOnSurface::new(source)?;
        Ok(Self { nearest, source: Sheet::new(source), target: Sheet::new(target) })
    }
}

impl Morph for MapToSurface {
    fn image(&self, p: Point3) -> Result<Point3> {
        let near = self.nearest.nearest(p)?;
        let height = self.source.surface.height_over(near.u, near.v, p).unwrap_or(0.0);
        let [u, v] = [(0, near.u), (1, near.v)]
            .map(|(i, t)| self.target.domains[i].at(self.source.domains[i].normalized(t)));
        self.target.at(u, v, height)
    }
}

/// Wraps space onto a surface: the origin of a plane comes to a place on it, steps along the plane are steps along its
/// parameter lines that have the same lengths and angles at that place, and heights are kept along the normal.
#[derive(Debug, Clone)]
pub struct Splop {
    plane: Plane,
    anchor: Anchor,
    angle: f64,
}

impl Splop {
    /// The map of a plane to the place (u, v) of a surface, turned counter-clockwise by an angle in radians; at angle 0
    /// the plane's x axis comes to lie along the direction of growing u.
    ///
    /// # Errors
    /// The surface has no tangent plane there, or a number is not finite.
    pub fn new(plane: Plane, surface: &Surface, [u, v]: [f64; 2], angle: f64) -> Result<Self> {
        if !(plane.is_finite() && angle.is_finite()) {
            return Err(Error::NotFinite("plane or angle"));
        }
        Ok(Self { plane, anchor: Anchor::new(surface, u, v)?, angle })
    }
}

impl Morph for Splop {
    fn image(&self, p: Point3) -> Result<Point3> {
        let [x, y, z] = self.plane.coordinates(p);
        let (sin, cos) = self.angle.sine_cosine();
        self.anchor.over([x * cos - y * sin, x * sin + y * cos], z)
    }
}

/// From one surface to another with one place of each on the other: steps along the parameter lines of the first become
/// steps along those of the second, with the same lengths and angles at these places; heights are kept.
#[derive(Debug, Clone)]
pub struct Sporph {
    nearest: ClosestOnSurface,
    base: Anchor,
    target: Anchor,
}

impl Sporph {
    /// The map of `base` to `target`, and of the place `from` on one to the place `to` on the other.
    ///
    /// # Errors
    /// A surface has no tangent plane at its place, or a number is not finite.
    pub fn new(base: &Surface, from: [f64; 2], target: &Surface, to: [f64; 2]) -> Result<Self> {
        Ok(Self {
            nearest: ClosestOnSurface::new(base)?,
            base: Anchor::new(base, from[0], from[1])?,
            target: Anchor::new(target, to[0], to[1])?,
        })
    }
}

impl Morph for Sporph {
    fn image(&self, p: Point3) -> Result<Point3> {
        let near = self.nearest.nearest(p)?;
        let surface = &self.base.sheet.surface;
        let normal: Option<Vector3> = surface.normal_at(near.u, near.v);
        let height = normal.map_or(0.0, |n| (p - near.point).dot(n));
        let by = self.base.sheet.off_anchor([near.u, near.v], self.base.place);
        self.target.over(self.base.step(by), height)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::{Cylinder, PlaneSurface};

    fn sheet(plane: Plane, x: f64, y: f64) -> Surface {
        PlaneSurface::new(plane, Interval::new(0.0, x), Interval::new(0.0, y)).unwrap().into()
    }

    #[test]
    fn maps_between_planes() {
        let (a, b) = (sheet(Plane::XY, 2.0, 2.0), sheet(Plane::YZ, 4.0, 2.0));
        let map = MapToSurface::new(&a, &b).unwrap();
        let image = map.image(Point3::new(1.0, 0.5, 3.0)).unwrap();
        assert!(image.distance_to(Point3::new(3.0, 2.0, 0.5)) < 1e-12);
        let p = Point3::new(1.0, 0.5, 3.0);
        assert!(MapToSurface::new(&a, &a).unwrap().image(p).unwrap().distance_to(p) < 1e-12);
        let sporph = Sporph::new(&a, [0.0, 0.0], &b, [1.0, 1.0]).unwrap();
        assert!(sporph.image(p).unwrap().distance_to(Point3::new(3.0, 2.0, 1.5)) < 1e-12);
        let splop = Splop::new(Plane::XY, &b, [1.0, 1.0], FRAC_PI_2).unwrap();
        assert!(splop.image(p).unwrap().distance_to(Point3::new(3.0, 0.5, 2.0)) < 1e-12);
        // Beyond the edge it goes on.
        let far = splop.image(Point3::new(9.0, 0.0, 0.0)).unwrap();
        assert!(far.distance_to(Point3::new(0.0, 1.0, 10.0)) < 1e-12);
    }

    #[test]
    fn a_cylinder_is_wrapped_with_true_lengths() {
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 5.0)).unwrap().into();
        let middle = Direction::BOTH.map(|d| tube.domain(d).middle());
        let splop = Splop::new(Plane::XY, &tube, middle, 0.0).unwrap();
        let start = tube.point_at(middle[0], middle[1]);
        assert!(splop.image(Point3::ORIGIN).unwrap().distance_to(start) < 1e-12);
        for x in [0.5, 3.0, 9.0] {
            let p = splop.image(Point3::new(x, 0.0, 1.0)).unwrap();
            assert!((Vector3::new(p.x, p.y, 0.0).length() - 3.0).abs() < 1e-9, "{p:?}");
        }
    }
}
