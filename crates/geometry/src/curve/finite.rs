//! Whether curves hold only numbers.

use super::Curve;
use crate::{Error, Result};

impl Curve {
    /// Whether all that it holds is finite: points, weights, knots, radii and angles, and the length of its domain.
    pub fn is_finite(&self) -> bool {
        self.non_finite_part().is_none()
    }

    /// Refuses a curve that holds a number that is not finite.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the name of what is not.
    pub fn check_finite(&self) -> Result<()> {
        self.non_finite_part().map_or(Ok(()), |what| Err(Error::NotFinite(what)))
    }

    /// The name of what is not finite.
    fn non_finite_part(&self) -> Option<&'static str> {
        let domain = self.domain();
        if !(domain.is_finite() && domain.length().is_finite()) {
            return Some("domain of a curve");
        }
        let (what, finite) = match self {
            Self::Line(c) => ("end of a line", c.line.is_finite()),
            Self::Arc(c) => {
                let circle = &c.arc.circle;
                let finite = circle.plane.is_finite() && circle.radius.is_finite() && c.arc.angle.is_finite();
                ("plane, radius or angle of an arc", finite)
            }
            Self::Polyline(c) => {
                let finite = c.points().iter().all(|p| p.is_finite());
                ("point or parameter of a polyline", finite && c.parameters().iter().all(|t| t.is_finite()))
            }
            Self::Nurbs(c) => {
                let finite = c.homogeneous_points().iter().flatten().all(|x| x.is_finite());
                (
                    "control point, weight or knot of a curve",
                    finite && c.knots().iter().all(|t| t.is_finite()),
                )
            }
            // How deep they nest is limited where they are made.
            Self::Poly(c) => {
                let inside = c.segments().iter().find_map(Self::non_finite_part);
                let finite = inside.is_none() && c.parameters().iter().all(|t| t.is_finite());
                (inside.unwrap_or("parameter of a poly-curve"), finite)
            }
        };
        (!finite).then_some(what)
    }
}

#[cfg(test)]
mod tests {
    use crate::{
        Arc, ArcCurve, Circle, Curve, Interval, Line, LineCurve, NurbsCurve, Plane, Point3, PolyCurve,
    };

    const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

    #[test]
    fn numbers_that_are_none_are_found() {
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 2.0, 3.0));
        let sound = LineCurve { line, domain: Interval::UNIT };
        assert!(Curve::from(sound).is_finite());
        let circle = Circle::new(Plane::XY, 2.0).unwrap();
        let arc = ArcCurve { arc: Arc { circle, angle: Interval::UNIT }, domain: Interval::UNIT };
        assert!(Curve::from(arc).is_finite());
        for bad in BAD {
            let mut point = sound;
            point.line.to.y = bad;
            let mut domain = sound;
            domain.domain.end = bad;
            let mut radius = arc;
            radius.arc.circle.radius = bad;
            let mut angle = arc;
            angle.arc.angle.end = bad;
            let mut centre = arc;
            centre.arc.circle.plane.origin.z = bad;
            let wrong: [Curve; 5] = [point.into(), domain.into(), radius.into(), angle.into(), centre.into()];
            for curve in wrong {
                assert!(!curve.is_finite(), "{curve:?}");
                if let Ok(chain) = PolyCurve::with_parameters(vec![curve], vec![0.0, 1.0]) {
                    assert!(!Curve::from(chain).is_finite());
                }
            }
        }
    }

    #[test]
    fn a_domain_without_a_finite_length() {
        let points = vec![Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)];
        if let Ok(curve) = NurbsCurve::new(1, points, vec![-1.5e308, 1.5e308]) {
            assert!(!Curve::from(curve).is_finite());
        }
    }
}
