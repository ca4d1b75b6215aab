//! Spheres, cylinders and cones among surfaces, told by how they are made: what lines and curves meet in closed form.

use crate::surface::thresholds::{CONE_SLOPE, SAME_HEIGHT};
use std::f64::consts::{FRAC_PI_2, TAU};

use katydid_elementary::Elementary;

use super::{RevolutionSurface, SumSurface, Surface};
use crate::polynomial::Polynomial;
use crate::{Curve, Interval, Plane, Point3, Vector3};

/// What is turned about the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RoundForm {
    /// A sphere about the frame's origin, with its radius.
    Sphere(f64),
    /// A cylinder about the frame's z axis, with its radius.
    Cylinder(f64),
    /// A cone with its apex in the frame's origin, with its radius at the height 1.
    Cone(f64),
}

/// A part of a sphere, cylinder or cone between two angles and two heights.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Round {
    /// The axis is its z axis; angles are counted from its x axis.
    pub(crate) frame: Plane,
    pub(crate) form: RoundForm,
    /// Its angles, increasing.
    pub(crate) angle: Interval,
    angle_domain: Interval,
    /// Which of the two parameters runs through the angle.
    angle_index: usize,
    /// Its heights above the frame, on spheres latitudes, where the other parameter starts and ends.
    pub(crate) along: Interval,
    along_domain: Interval,
}

/// What counts as parallel, upright or on the axis, in parts of the size.
const EXACT: f64 = 1e-10;
/// How far beyond its ends a part still goes, in parts of its range: what rounding may take away.
const BEYOND: f64 = 1e-12;

impl Round {
    /// Of a revolution of a line or an arc about its axis, or an extrusion of an arc, where it is such a part.
    pub(crate) fn of(surface: &Surface) -> Option<Self> {
        match surface {
            Surface::Revolution(s) => Self::of_revolution(s),
            Surface::Sum(s) => Self::of_sum(s),
            Surface::Plane(_) | Surface::Nurbs(_) => None,
        }
    }

    fn of_revolution(s: &RevolutionSurface) -> Option<Self> {
        let unit = s.axis().unit_direction()?;
        let angle_index = s.angle_direction().index();
        let angle_domain = s.domain(s.angle_direction());
        let made = |frame, form, along, along_domain| Self {
            frame,
            form,
            angle: s.angle(),
            angle_domain,
            angle_index,
            along,
            along_domain,
        };
        match s.profile() {
            Curve::Line(c) => {
                let axis = s.axis();
                let [a, b] = [c.line.from, c.line.to].map(|p| {
                    let height = (p - axis.from).dot(unit);
                    let foot = axis.from + unit * height;
                    (height, p - foot)
                });
                let size = c.line.length();
                let (ra, rb) = (a.1.length(), b.1.length());
                let x_axis = if ra > rb { a.1 } else { b.1 }.unitized()?;
                // Both ends on one side of the axis, in one plane with it.
                let skew = |arm: Vector3| (arm - x_axis * arm.length()).length();
                if skew(a.1).max(skew(b.1)) > EXACT * size || (b.0 - a.0).abs() <= SAME_HEIGHT * size {
                    return None;
                }
                let frame_at = |height: f64| frame(axis.from + unit * height, x_axis, unit);
                if (ra - rb).abs() <= EXACT * size {
                    let along = Interval::new(0.0, b.0 - a.0);
                    return Some(made(frame_at(a.0), RoundForm::Cylinder(0.5 * (ra + rb)), along, c.domain));
                }
                let slope = (rb - ra) / (b.0 - a.0);
                let apex = a.0 - ra / slope;
                // A cone that is nearly a cylinder has its apex too far away.
                if !(slope.abs() > CONE_SLOPE) {
                    return None;
                }
                let along = Interval::new(a.0 - apex, b.0 - apex);
                Some(made(frame_at(apex), RoundForm::Cone(slope.abs()), along, c.domain))
            }
            Curve::Arc(c) => {
                let circle = &c.arc.circle;
                let center = circle.center();
                let off = center - s.axis().from;
                let size = circle.radius;
                let aside = off - unit * off.dot(unit);
                if aside.length() > EXACT * size || circle.plane.z_axis.dot(unit).abs() > EXACT {
                    return None;
                }
                let middle = circle.at(c.arc.angle.middle()) - center;
                let x_axis = (middle - unit * middle.dot(unit)).unitized()?;
                let latitude = |angle: f64| {
                    let p = circle.at(angle) - center;
                    p.dot(unit).arctangent_of(p.dot(x_axis))
                };
                let ends = Interval::new(latitude(c.arc.angle.start), latitude(c.arc.angle.end));
                let within = |x: f64| x.abs() <= FRAC_PI_2 + EXACT;
                let whole = (ends.length().abs() - c.arc.angle.length()).abs() <= EXACT;
                if !(within(ends.start) && within(ends.end) && whole) {
                    return None;
                }
                Some(made(frame(center, x_axis, unit), RoundForm::Sphere(size), ends, c.domain))
            }
            _ => None,
        }
    }

    fn of_sum(s: &SumSurface) -> Option<Self> {
        let [first, second] = s.curves();
        let (angle_index, arc, line) = match (first, second) {
            (Curve::Arc(a), Curve::Line(l)) => (0, a, l),
            (Curve::Line(l), Curve::Arc(a)) => (1, a, l),
            _ => return None,
        };
        let plane = arc.arc.circle.plane;
        let way = line.line.to - line.line.from;
        let height = way.dot(plane.z_axis);
        if (way - plane.z_axis * height).length() > EXACT * way.length() || height == 0.0 {
            return None;
        }
        let origin = plane.origin + (line.line.from.to_vector() + s.shift());
        Some(Self {
            frame: plane.with_origin(origin),
            form: RoundForm::Cylinder(arc.arc.circle.radius),
            angle: arc.arc.angle,
            angle_domain: arc.domain,
            angle_index,
            along: Interval::new(0.0, height),
            along_domain: line.domain,
        })
    }

    /// x² + y² + a·z² − c is zero on it, in the frame's coordinates.
    fn coefficients(&self) -> (f64, f64) {
        match self.form {
            RoundForm::Sphere(r) => (1.0, r * r),
            RoundForm::Cylinder(r) => (0.0, r * r),
            RoundForm::Cone(k) => (-k * k, 0.0),
        }
    }

    /// Whether it goes all round.
    pub(crate) fn is_full_turn(&self) -> bool {
        (self.angle.length() - TAU).abs() <= EXACT
    }

    /// A vector in the frame's axes.
    pub(crate) fn components(&self, v: Vector3) -> [f64; 3] {
        [v.dot(self.frame.x_axis), v.dot(self.frame.y_axis), v.dot(self.frame.z_axis)]
    }

    /// The surface's parameters at a point on it; `None` beyond its ends. A cone is met on one side of its apex only.
    pub(crate) fn parameters(&self, p: Point3) -> Option<[f64; 2]> {
        let [x, y, z] = self.frame.coordinates(p);
        let height = match self.form {
            RoundForm::Sphere(_) => z.arctangent_of(x.hypotenuse(y)),
            _ => z,
        };
        let share = self.along.normalized(height);
        if !(-BEYOND..=1.0 + BEYOND).contains(&share) {
            return None;
        }
        let turns = (y.arctangent_of(x) - self.angle.start).rem_euclid(TAU) / self.angle.length();
        let turns = if turns * self.angle.length() > TAU * (1.0 - BEYOND) { 0.0 } else { turns };
        if turns > 1.0 + BEYOND {
            return None;
        }
        let mut out = [self.along_domain.at(share.clamp(0.0, 1.0)); 2];
        out[self.angle_index] = self.angle_domain.at(turns.min(1.0));
        Some(out)
    }

    /// The distance of a point from the whole sphere, cylinder or cone: of a cone from both of its halves.
    pub(crate) fn distance_to_whole(&self, p: Point3) -> f64 {
        let [x, y, z] = self.frame.coordinates(p);
        let from_axis = x.hypotenuse(y);
        match self.form {
            RoundForm::Sphere(r) => (from_axis.hypotenuse(z) - r).abs(),
            RoundForm::Cylinder(r) => (from_axis - r).abs(),
            RoundForm::Cone(k) => (from_axis - k * z.abs()).abs() / 1.0_f64.hypotenuse(k),
        }
    }

    /// Where a line meets the whole sphere, cylinder or cone: none or two distances along a unit direction. A line that
    /// lies in it meets it nowhere.
    pub(crate) fn line(&self, from: Point3, direction: Vector3) -> Option<[f64; 2]> {
        let (a, c) = self.coefficients();
        // About the place nearest to the origin: far away digits are lost.
        let shift = (self.frame.origin - from).dot(direction);
        let p = self.frame.coordinates(from + direction * shift);
        let d = self.components(direction);
        let form = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + a * u[2] * v[2];
        let (aa, bb, cc) = (form(d, d), form(p, d), form(p, p) - c);
        if aa.abs() <= EXACT * EXACT {
            // Along a cylinder, or along a ruling of the cone: once at most.
            if !(bb.abs() > EXACT * (c.sqrt() + p[2].abs())) {
                return None;
            }
            let s = -0.5 * cc / bb + shift;
            return Some([s, s]);
        }
        let square = bb * bb - aa * cc;
        if !(square >= 0.0) {
            return None;
        }
        let q = -(bb + bb.signum() * square.sqrt());
        let (s, t) = (q / aa, if q == 0.0 { 0.0 } else { cc / q });
        Some([s.min(t) + shift, s.max(t) + shift])
    }

    /// The polynomial that is zero where a Bézier curve with homogeneous control points meets the whole of it.
    pub(crate) fn along_curve(&self, points: &[[f64; 4]]) -> Polynomial {
        let (a, c) = self.coefficients();
        let origin = self.frame.origin.to_vector();
        let part = |axis: Vector3| {
            let values = points.iter().map(|p| (Vector3::new(p[0], p[1], p[2]) - origin * p[3]).dot(axis));
            Polynomial::new(values.collect())
        };
        let square = |p: Polynomial| p.times(&p);
        let [x, y, z] = [self.frame.x_axis, self.frame.y_axis, self.frame.z_axis].map(|d| square(part(d)));
        let w = square(Polynomial::new(points.iter().map(|p| p[3]).collect()));
        x.plus(&y).plus(&z.scaled(a)).minus(&w.scaled(c))
    }
}

fn frame(origin: Point3, x_axis: Vector3, z_axis: Vector3) -> Plane {
    Plane { origin, x_axis, y_axis: z_axis.cross(x_axis), z_axis }
}

#[cfg(test)]
mod tests {
    use super::{Round, RoundForm};
    use crate::{
        Arc, Circle, Cone, Cylinder, Interval, Line, Plane, Point3, Sphere, SumSurface, Surface, Vector3,
    };

    fn surfaces() -> Vec<Surface> {
        let frame = Plane::from_axes(
            Point3::new(1.0, 2.0, 3.0),
            Vector3::new(1.0, 1.0, 0.0),
            Vector3::new(0.2, 0.3, 1.0),
        )
        .unwrap();
        let cone = Cone::new(frame, -3.0, 2.0).unwrap().to_revolution();
        let arc = Arc { circle: Circle::new(frame, 2.0).unwrap(), angle: Interval::new(0.4, 2.4) };
        vec![
            Sphere::new(frame, 2.0).unwrap().into(),
            Cylinder::new(frame, 2.0, Interval::new(-1.0, 4.0)).unwrap().into(),
            cone.clone().into(),
            cone.transposed().into(),
            SumSurface::extrusion(arc.into(), frame.z_axis * -3.0).unwrap().into(),
        ]
    }

    #[test]
    fn parameters_and_lines_are_those_of_the_surface() {
        for surface in surfaces() {
            let round = Round::of(&surface).unwrap();
            let [du, dv] = crate::Direction::BOTH.map(|d| surface.domain(d));
            for (i, j) in (1..9).flat_map(|i| (1..9).map(move |j| (i, j))) {
                let (u, v) = (du.at(f64::from(i) / 9.0), dv.at(f64::from(j) / 9.0));
                let p = surface.point_at(u, v);
                let [a, b] = round.parameters(p).unwrap();
                assert!((a - u).abs() < 1e-9 && (b - v).abs() < 1e-9, "{surface:?} {u} {v} {a} {b}");
                let normal = surface.normal_at(u, v).unwrap();
                for off in [0.0, 1e-3, -2e-2] {
                    let distance = round.distance_to_whole(p + normal * off);
                    assert!((distance - off.abs()).abs() < 1e-9, "{surface:?} {u} {v} {off} {distance}");
                }
                let direction = Vector3::new(0.3, -0.5, 0.81).unitized().unwrap();
                let hits = round.line(p - direction * 7.0, direction).unwrap();
                assert!(hits.iter().any(|s| (s - 7.0).abs() < 1e-6), "{hits:?}");
                let line = Line::new(p - direction, p + direction * 2.0);
                let [a, b] = [line.from, line.to].map(|p| [p.x, p.y, p.z, 1.0]);
                let roots = round.along_curve(&[a, b]).roots(1e-12);
                assert!(roots.iter().any(|x| (x - 1.0 / 3.0).abs() < 1e-6), "{roots:?}");
            }
        }
    }

    #[test]
    fn others_are_none() {
        let torus: Surface = crate::Torus::new(Plane::XY, 3.0, 1.0).unwrap().into();
        assert!(Round::of(&torus).is_none());
        let skew = Line::new(Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 1.0, 1.0));
        let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
        let turn = Interval::new(0.0, 1.0);
        let hyperboloid = crate::RevolutionSurface::new(skew.into(), axis, turn).unwrap();
        assert!(Round::of(&hyperboloid.into()).is_none());
        let tube = Round::of(&Cylinder::new(Plane::XY, 2.0, turn).unwrap().into()).unwrap();
        assert!(tube.is_full_turn() && tube.form == RoundForm::Cylinder(2.0));
        assert!(tube.parameters(Point3::new(2.0, 0.0, 1.5)).is_none());
    }
}
