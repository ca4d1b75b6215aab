//! Curves changed through places on them: edit points and ends.

use super::Curve;
use crate::thresholds;
use crate::{Error, LeastSquares, NurbsCurve, Point3, Result, Vector3};

impl NurbsCurve {
    /// The parameters of the edit points: the Greville abscissae that name different points. A curve that closes has
    /// one less than control points, a periodic one as many as different control points.
    pub fn edit_parameters(&self) -> Vec<f64> {
        let all = self.greville_abscissae();
        if self.is_periodic() {
            // The abscissae of the different control points within one period.
            let domain = self.domain();
            let near = thresholds::SAME_PARAMETER * domain.length();
            let inside = |t: &f64| *t >= domain.start - near && *t < domain.end - near;
            return all.into_iter().filter(inside).map(|t| domain.clamp(t)).collect();
        }
        let closing = usize::from(Curve::from(self.clone()).is_closed());
        let count = all.len().saturating_sub(closing);
        all.into_iter().take(count).collect()
    }

    /// The curve of the same degree, knots and weights that goes through other points at its
    /// [edit parameters](Self::edit_parameters).
    ///
    /// # Errors
    /// Another number of points than of edit parameters, a point that is not finite, a periodic curve whose knots are
    /// not even or that has weights, or a system without a unique solution.
    pub fn through_edit_points(&self, points: &[Point3]) -> Result<Self> {
        let parameters = self.edit_parameters();
        if points.len() != parameters.len() {
            let why = format!("the curve has {} of them, got {}", parameters.len(), points.len());
            return Err(Error::Invalid { what: "edit points", why });
        }
        let (degree, domain) = (self.degree(), self.domain());
        if self.is_periodic() {
            let steps: Vec<f64> = self.knots().windows(2).map(|pair| pair[1] - pair[0]).collect();
            let is_even = steps
                .iter()
                .all(|step| (step - steps[0]).abs() <= thresholds::SAME_PARAMETER * domain.length());
            if !is_even || self.is_rational() {
                return Err(Error::Unsupported(
                    "edit points of periodic curves with uneven knots or weights",
                ));
            }
            return Self::least_squares_periodic(degree, points.len(), domain, points, &parameters);
        }
        // Of a curve with weights: its control points times their weights make a plain curve through the points times
        // the value of the denominator.
        let parameters = self.greville_abscissae();
        let weights = self.is_rational().then(|| self.weights());
        let denominator = weights.as_ref().map(|weights| {
            let heights = weights.iter().map(|w| Point3::new(*w, 0.0, 0.0)).collect();
            Self::new(degree, heights, self.knots().to_vec())
        });
        let denominator = denominator.transpose()?;
        let scale = |t: f64| denominator.as_ref().map_or(1.0, |curve| curve.point_at(t).x);
        let closing = points.first().copied();
        let wanted: Vec<Point3> = points.iter().copied().chain(closing).take(parameters.len()).collect();
        let scaled: Vec<Point3> =
            wanted.iter().zip(&parameters).map(|(p, t)| (p.to_vector() * scale(*t)).to_point()).collect();
        let options = LeastSquares { free_ends: !self.is_clamped(), ..LeastSquares::default() };
        let plain = Self::least_squares(degree, self.knots(), &scaled, &parameters, &options)?;
        match weights {
            None => Ok(plain),
            Some(weights) => {
                let places = plain.control_points().into_iter().zip(&weights);
                let places: Vec<Point3> = places.map(|(p, w)| (p.to_vector() / *w).to_point()).collect();
                Self::with_weights(degree, &places, &weights, self.knots().to_vec())
            }
        }
    }

    /// The curve, clamped, with its end (or start) in another place, and if they are given with another direction and
    /// with another curvature there. The direction is that in which the curve runs, at either end; of the curvature the
    /// part at right angles to it counts. As many control points move as are needed, as
    /// [`matched_to`](Self::matched_to) moves them.
    ///
    /// # Errors
    /// A direction without length, or as [`matched_to`](Self::matched_to).
    pub fn with_end(
        &self,
        at_end: bool,
        place: Point3,
        direction: Option<Vector3>,
        curvature: Option<Vector3>,
    ) -> Result<Self> {
        let Some(direction) = direction else {
            let clamped = self.clamped()?;
            let last = clamped.point_count().saturating_sub(1);
            return clamped.with_control_point(if at_end { last } else { 0 }, place);
        };
        let none = Error::degenerate("direction of an end", "it has no length");
        // What the curve goes on into: away from it.
        let along = direction.unitized().ok_or(none)? * if at_end { 1.0 } else { -1.0 };
        let bend = curvature.unwrap_or(Vector3::ZERO);
        let bend = bend - along * bend.dot(along);
        // A parabola with a speed of 2 at its start has the acceleration 4·κ there.
        let target = Self::bezier(&[place, place + along, place + along * 2.0 + bend * 2.0])?;
        self.matched_to(at_end, &target.into(), if curvature.is_some() { 2 } else { 1 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Plane};

    fn wave() -> NurbsCurve {
        let points: Vec<Point3> =
            (0..6).map(|k| Point3::new(f64::from(k), f64::from(k % 2), f64::from(k * k) * 0.1)).collect();
        NurbsCurve::clamped_uniform(3, &points).unwrap()
    }

    #[test]
    fn goes_through_edit_points() {
        let circle = Curve::from(Circle::new(Plane::XY, 2.0).unwrap()).to_nurbs().unwrap();
        let ring: Vec<Point3> = (0..6).map(|k| Point3::from_polar(f64::from(k))).collect();
        let ring = NurbsCurve::periodic_uniform(3, &ring).unwrap();
        assert_eq!(ring.edit_parameters().len(), 6);
        for curve in [wave(), circle, ring] {
            let parameters = curve.edit_parameters();
            let moved: Vec<Point3> =
                parameters.iter().map(|t| curve.point_at(*t) + Vector3::new(t.sin(), 0.3, t.cos())).collect();
            let made = curve.through_edit_points(&moved).unwrap();
            assert_eq!(made.weights(), curve.weights());
            for (t, p) in parameters.iter().zip(&moved) {
                assert!(made.point_at(*t).distance_to(*p) < 1e-9, "{t}");
            }
            assert!(curve.through_edit_points(&moved[1..]).is_err());
        }
    }

    #[test]
    fn ends_are_set() {
        let place = Point3::new(1.0, -2.0, 0.5);
        let (way, bend) = (Vector3::new(0.0, 3.0, 4.0), Vector3::new(2.0, 0.0, 0.0));
        for at_end in [false, true] {
            let set = Curve::from(wave().with_end(at_end, place, Some(way), Some(bend)).unwrap());
            let t = if at_end { set.domain().end } else { set.domain().start };
            assert!(set.point_at(t).distance_to(place) < 1e-12);
            assert!((set.tangent_at(t).unwrap() - way / 5.0).length() < 1e-9);
            assert!((set.curvature_at(t) - bend).length() < 1e-9);
            let moved = wave().with_end(at_end, place, None, None).unwrap();
            assert!(
                moved.point_at(moved.domain().at(f64::from(u8::from(at_end)))).distance_to(place) < 1e-12
            );
            assert!(wave().with_end(at_end, place, Some(Vector3::ZERO), None).is_err());
        }
    }

    impl Point3 {
        fn from_polar(angle: f64) -> Self {
            Self::new(3.0 * angle.cos(), 2.0 * angle.sin(), 0.2 * angle)
        }
    }
}
