use crate::surface::thresholds::{EXACT_RIGHT_ANGLE, FULL_REVOLUTION};
use crate::thresholds;
use std::f64::consts::TAU;

use katydid_elementary::Elementary;

use super::sum::check_curve;
use crate::nurbs::Controls;
use crate::{
    Arc, Circle, Curve, Direction, Error, Interval, Line, NurbsSurface, Plane, Point3, Result,
    SurfaceDerivatives, Vector3, Xform,
};

/// A curve turned about an axis. The angle runs along u and the profile along v, or the other way round when the
/// surface is transposed.
#[derive(Debug, Clone, PartialEq)]
pub struct RevolutionSurface {
    profile: Curve,
    axis: Line,
    unit: Vector3,
    angle: Interval,
    angle_domain: Interval,
    transposed: bool,
}

/// A profile point's place relative to the axis: its foot on the axis, the arm from there, and the arm turned by a
/// quarter about the axis.
struct Arm {
    foot: Vector3,
    arm: Vector3,
    turned: Vector3,
}

/// Sine and cosine, without the 6e-17 where a 0 belongs.
fn sin_cos(angle: f64) -> (f64, f64) {
    let (sin, cos) = angle.sine_cosine();
    if sin.abs() < EXACT_RIGHT_ANGLE {
        (0.0, cos.signum())
    } else if cos.abs() < EXACT_RIGHT_ANGLE {
        (sin.signum(), 0.0)
    } else {
        (sin, cos)
    }
}

/// The circle that a profile point runs round, and how it changes along the profile.
pub(crate) struct Ring {
    start: Vector3,
    at: Arm,
    rate: Arm,
    speed: f64,
}

impl Ring {
    /// The place, as a vector from the origin, and the derivatives by the angle's parameter and the profile's, at an angle
    /// in radians.
    pub(crate) fn at(&self, angle: f64) -> [Vector3; 3] {
        let (sin, cos) = angle.sine_cosine();
        let Arm { foot, arm, turned } = &self.at;
        let place = self.start + *foot + *arm * cos + *turned * sin;
        let around = (*turned * cos - *arm * sin) * self.speed;
        let Arm { foot, arm, turned } = &self.rate;
        [place, around, *foot + *arm * cos + *turned * sin]
    }
}

impl RevolutionSurface {
    /// The circle of a parameter of the profile; at its joints with the derivative after it.
    pub(crate) fn ring(&self, t: f64) -> Ring {
        let [place, rate] = self.profile.jet_at::<2>(t, false);
        let start = self.axis.from.to_vector();
        let speed = self.angle.length() / self.angle_domain.length();
        Ring { start, at: self.arm(place - start), rate: self.arm(rate), speed }
    }

    /// The profile turned about an axis between two angles in radians, by the right-hand rule from the axis' start
    /// to its end; angle 0 is where the profile lies. The angle is the parameter u.
    ///
    /// # Errors
    /// The axis has no direction, or the angles do not increase or are more than a turn apart.
    pub fn new(profile: Curve, axis: Line, angle: Interval) -> Result<Self> {
        Self::with_domain(profile, axis, angle, angle)
    }

    /// As [`RevolutionSurface::new`] with another domain for the angle.
    ///
    /// # Errors
    /// As [`RevolutionSurface::new`]; also a domain that does not increase.
    pub fn with_domain(profile: Curve, axis: Line, angle: Interval, domain: Interval) -> Result<Self> {
        check_curve("profile", &profile)?;
        if !axis.is_finite() {
            return Err(Error::NotFinite("axis of revolution"));
        }
        let unit =
            axis.unit_direction().ok_or(Error::degenerate("axis of revolution", "it has no direction"))?;
        if !angle.is_increasing() || angle.length() > TAU * (1.0 + thresholds::WHOLE_TURN) {
            return Err(Error::OutOfRange {
                what: "angle of revolution",
                value: angle.length(),
                must: "greater than 0 and at most a turn",
            });
        }
        if !(domain.is_increasing() && domain.length().is_finite()) {
            return Err(Error::Invalid {
                what: "domain of revolution",
                why: format!("{} to {} does not increase", domain.start, domain.end),
            });
        }
        Ok(Self { profile, axis, unit, angle, angle_domain: domain, transposed: false })
    }

    /// A whole turn of a profile about an axis whose unit direction is known.
    pub(super) fn full(profile: Curve, axis: Line, unit: Vector3) -> Self {
        let turn = Interval::new(0.0, TAU);
        Self { profile, axis, unit, angle: turn, angle_domain: turn, transposed: false }
    }

    /// The curve that is turned.
    pub fn profile(&self) -> &Curve {
        &self.profile
    }

    /// The axis, from its start to its end.
    pub fn axis(&self) -> Line {
        self.axis
    }

    /// The angles in radians between which the profile is turned.
    pub fn angle(&self) -> Interval {
        self.angle
    }

    /// The direction along which the angle varies: u, unless the surface is transposed.
    pub fn angle_direction(&self) -> Direction {
        if self.transposed { Direction::V } else { Direction::U }
    }

    /// Whether the angle goes all the way round.
    pub fn is_full_turn(&self) -> bool {
        (self.angle.length() - TAU).abs() <= FULL_REVOLUTION
    }

    /// The range of one parameter.
    pub fn domain(&self, direction: Direction) -> Interval {
        if direction == self.angle_direction() { self.angle_domain } else { self.profile.domain() }
    }

    /// The angle in radians at a parameter.
    pub fn angle_at(&self, t: f64) -> f64 {
        if self.angle == self.angle_domain { t } else { self.angle.at(self.angle_domain.normalized(t)) }
    }

    fn arm(&self, w: Vector3) -> Arm {
        let foot = self.unit * w.dot(self.unit);
        let arm = w - foot;
        Arm { foot, arm, turned: self.unit.cross(w) }
    }

    /// The parameters as (angle's, profile's).
    fn ordered(&self, u: f64, v: f64) -> (f64, f64) {
        if self.transposed { (v, u) } else { (u, v) }
    }

    /// The point at (u, v).
    pub fn point_at(&self, u: f64, v: f64) -> Point3 {
        let (a, t) = self.ordered(u, v);
        self.turned(self.profile.point_at(t), self.angle_at(a))
    }

    /// A point turned about the axis.
    fn turned(&self, p: Point3, angle: f64) -> Point3 {
        let (sin, cos) = sin_cos(angle);
        let Arm { foot, arm, turned } = self.arm(p - self.axis.from);
        self.axis.from + foot + arm * cos + turned * sin
    }

    pub(super) fn derivatives(&self, u: f64, v: f64, order: usize, below: [bool; 2]) -> SurfaceDerivatives {
        let (a, t) = self.ordered(u, v);
        let profile_below = below[1 - self.angle_direction().index()];
        let (point, list) = self.profile.derivatives(t, order, profile_below);
        let angle = self.angle_at(a);
        let speed = self.angle.length() / self.angle_domain.length();
        let arms: Vec<Arm> =
            std::iter::once(point - self.axis.from).chain(list).map(|w| self.arm(w)).collect();
        SurfaceDerivatives::from_fn(order, |i, j| {
            let (turns, along) = if self.transposed { (j, i) } else { (i, j) };
            let Some(Arm { foot, arm, turned }) = arms.get(along) else { return Vector3::ZERO };
            let (sin, cos) = sin_cos(angle);
            // Each derivative by the angle turns the arm by a quarter.
            let (sin, cos) = match turns % 4 {
                0 => (sin, cos),
                1 => (cos, -sin),
                2 => (-sin, -cos),
                _ => (-cos, sin),
            };
            let swept = (*arm * cos + *turned * sin) * speed.powi(turns as i32);
            match (turns, along) {
                (0, 0) => self.axis.from.to_vector() + *foot + swept,
                (0, _) => *foot + swept,
                _ => swept,
            }
        })
    }

    /// The exact NURBS form over the same domains: rational of degree 2 in the angle, with one span up to a quarter
    /// turn, two up to a half and else four, as openNURBS has it. Only the joints and middles of these spans keep
    /// their parameter.
    ///
    /// # Errors
    /// A degenerate profile, or a number overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        let profile = self.profile.to_nurbs()?;
        let unit = Arc { circle: Circle { plane: Plane::XY, radius: 1.0 }, angle: self.angle };
        let arc = unit.to_nurbs(self.angle_domain)?;
        let origin = self.axis.from.to_vector();
        let points = profile.homogeneous_points();
        let mut net = Vec::with_capacity(arc.point_count() * points.len());
        for [c, s, _, w] in arc.homogeneous_points() {
            for p in &points {
                // Everything times the point's weight.
                let Arm { foot, arm, turned } = self.arm(Vector3::new(p[0], p[1], p[2]) - origin * p[3]);
                let q = (origin * p[3] + foot) * w + arm * c + turned * s;
                net.push([q.x, q.y, q.z, w * p[3]]);
            }
        }
        let degrees = [2, profile.degree()];
        let counts = [arc.point_count(), points.len()];
        let knots = [arc.knots().to_vec(), profile.knots().to_vec()];
        let surface = NurbsSurface::from_controls(degrees, counts, Controls::Rational(net), knots)?;
        Ok(if self.transposed { surface.transposed() } else { surface })
    }

    /// The same points with u and v exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        Self { transposed: !self.transposed, ..self.clone() }
    }

    /// The same points with one direction walked backwards; its domain a…b becomes −b…−a.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> Self {
        let negated = |r: Interval| Interval::new(-r.end, -r.start);
        if direction == self.angle_direction() {
            let mut out = self.about_other_end();
            out.angle = negated(self.angle);
            out.angle_domain = negated(self.angle_domain);
            out
        } else {
            Self { profile: self.profile.reversed(), ..self.clone() }
        }
    }

    /// The axis turned end for end.
    fn about_other_end(&self) -> Self {
        Self { axis: self.axis.reversed(), unit: -self.unit, ..self.clone() }
    }

    /// The surface with another profile.
    pub(super) fn with_profile(&self, profile: Curve) -> Self {
        Self { profile, ..self.clone() }
    }

    /// The part over a range of the angle's parameter.
    pub(super) fn between(&self, range: Interval) -> Result<Self> {
        let angle = Interval::new(self.angle_at(range.start), self.angle_at(range.end));
        let part = Self::with_domain(self.profile.clone(), self.axis, angle, range)?;
        Ok(Self { transposed: self.transposed, ..part })
    }

    /// The whole turn that starts at the angle of parameter `t`.
    pub(super) fn started_at(&self, t: f64) -> Result<Self> {
        let start = self.angle_at(t);
        let angle = Interval::new(start, start + self.angle.length());
        let domain = Interval::new(t, t + self.angle_domain.length());
        let turned = Self::with_domain(self.profile.clone(), self.axis, angle, domain)?;
        Ok(Self { transposed: self.transposed, ..turned })
    }

    /// The same angles over another domain.
    pub(super) fn over_angle_domain(&self, domain: Interval) -> Result<Self> {
        let part = Self::with_domain(self.profile.clone(), self.axis, self.angle, domain)?;
        Ok(Self { transposed: self.transposed, ..part })
    }

    /// The image under a similarity, which is a surface of revolution too.
    pub(super) fn similar(&self, xform: &Xform, mirrors: bool) -> Result<Self> {
        let axis = self.axis.transformed(xform);
        // A mirror turns the sense of rotation about the axis.
        let axis = if mirrors { axis.reversed() } else { axis };
        let profile = self.profile.transformed(xform)?;
        let image = Self::with_domain(profile, axis, self.angle, self.angle_domain)?;
        Ok(Self { transposed: self.transposed, ..image })
    }

    /// The profile in the place that belongs to a parameter of the angle.
    pub(super) fn profile_at(&self, t: f64) -> Result<Curve> {
        let angle = self.angle_at(t);
        if angle == 0.0 {
            return Ok(self.profile.clone());
        }
        let (sin, cos) = sin_cos(angle);
        self.profile.transformed(&Xform::rotation_sin_cos(sin, cos, self.unit, self.axis.from)?)
    }

    /// The circle or arc that the profile's point at `t` runs through.
    pub(super) fn parallel(&self, t: f64) -> Result<Curve> {
        let w = self.profile.point_at(t) - self.axis.from;
        let Arm { foot, arm, .. } = self.arm(w);
        let radius = arm.length();
        let on_axis = Error::degenerate("isocurve", "it is a single point on the axis");
        if radius <= thresholds::FEW_ROUNDINGS * (w.length() + thresholds::LEAST_DIVISOR) {
            return Err(on_axis);
        }
        // A short arm is what is left of long vectors, and not quite upright on the axis.
        let across = |v: Vector3| (v - self.unit * v.dot(self.unit)).unitized();
        let x_axis = arm.unitized().and_then(across).ok_or(on_axis)?;
        let plane = Plane {
            origin: self.axis.from + foot,
            x_axis,
            y_axis: self.unit.cross(x_axis),
            z_axis: self.unit,
        };
        let arc = Arc { circle: Circle::new(plane, radius)?, angle: self.angle };
        Ok(crate::ArcCurve { arc, domain: self.angle_domain }.into())
    }

    /// How far a point is from the axis.
    pub(super) fn distance_from_axis(&self, p: Point3) -> f64 {
        self.arm(p - self.axis.from).arm.length()
    }
}
