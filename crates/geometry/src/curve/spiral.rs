//! Spirals about curves.

use crate::thresholds;
use std::f64::consts::TAU;

use katydid_elementary::Elementary;

use super::{ArcLength, Curve};
use crate::{Error, Interval, KnotSpacing, NurbsCurve, Point3, Result};

/// The most turns, and the most points of them all.
const MOST_TURNS: f64 = 10_000.0;
const MOST_POINTS: f64 = 100_000.0;

impl Curve {
    /// The spiral that winds about a range of this curve, as an even cubic through so many points a turn: counter-
    /// clockwise about the direction of the curve for turns above 0, clockwise below. It turns and rises evenly by the
    /// length of the curve, in frames that do not turn about it, and its radius goes evenly from the first to the
    /// second. `toward` gives the side on which it starts; only its direction from the start of the range counts.
    ///
    /// # Errors
    /// No turns, or more than 10,000; fewer than five points a turn, or more than 100,000 in all; radii that are both
    /// 0, a range without length, a place without direction, or a point `toward` which the curve itself runs.
    pub fn spiral_about(
        &self,
        range: Interval,
        toward: Point3,
        turns: f64,
        radii: [f64; 2],
        points_per_turn: usize,
    ) -> Result<NurbsCurve> {
        if !(turns.abs() > 0.0 && turns.abs() <= MOST_TURNS) {
            return Err(Error::OutOfRange { what: "turns", value: turns, must: "up to 10,000, and not 0" });
        }
        let count = (turns.abs() * points_per_turn as f64).ceil().max(4.0);
        if points_per_turn < 5 || count > MOST_POINTS {
            let (what, value) = ("points of a turn", points_per_turn as f64);
            return Err(Error::OutOfRange { what, value, must: "5 and more, and 100,000 in all" });
        }
        if !(radii.iter().all(|r| r.is_finite()) && radii.iter().any(|r| *r != 0.0)) {
            return Err(Error::degenerate("radii of the spiral", "they are both 0"));
        }
        let rail = self.sub_curve(range)?;
        let measure = ArcLength::new(&rail);
        let length = measure.total();
        if !(length > 0.0) {
            return Err(Error::degenerate("curve of the spiral", "it has no length"));
        }
        let shares: Vec<f64> = (0..=count as usize).map(|k| k as f64 / count).collect();
        let places: Vec<f64> = shares.iter().map(|x| measure.parameter_at(x * length)).collect();
        let frames = rail.perpendicular_frames(&places);
        let none = || Error::degenerate("curve of the spiral", "it has no direction somewhere");
        let first = frames.first().copied().flatten().ok_or_else(none)?;
        let [x, y, _] = first.coordinates(toward);
        if !(x.hypotenuse(y) > thresholds::ROUNDING * (toward - first.origin).length()) {
            return Err(Error::degenerate("radius point", "it lies on the axis"));
        }
        let begin = y.arctangent_of(x);
        let at = |(share, frame): (&f64, &Option<crate::Plane>)| {
            let frame = frame.ok_or_else(none)?;
            let (sin, cos) = (begin + TAU * turns * share).sine_cosine();
            let radius = radii[0] + (radii[1] - radii[0]) * share;
            Ok(frame.at(radius * cos, radius * sin, 0.0))
        };
        let points = shares.iter().zip(&frames).map(at).collect::<Result<Vec<Point3>>>()?;
        // How it sets out and arrives: out by the growth, round by the turn, along by the length.
        let way = |share: f64, frame: &Option<crate::Plane>| {
            let frame = frame.ok_or_else(none)?;
            let (sin, cos) = (begin + TAU * turns * share).sine_cosine();
            let (out, round) =
                (frame.x_axis * cos + frame.y_axis * sin, frame.y_axis * cos - frame.x_axis * sin);
            let radius = radii[0] + (radii[1] - radii[0]) * share;
            Ok(out * (radii[1] - radii[0]) + round * (radius * TAU * turns) + frame.z_axis * length)
        };
        let last = frames.last().ok_or_else(none)?;
        let [start, end] = [way(0.0, &frames[0])?, way(1.0, last)?];
        NurbsCurve::interpolate(3, &points, KnotSpacing::Uniform, Some(start), Some(end))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Arc, Circle, Line, Plane};

    #[test]
    fn about_a_line_it_is_a_helix() {
        let axis = Curve::from(Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 12.0)));
        let toward = Point3::new(5.0, 0.0, 7.0);
        for (turns, way) in [(3.0, 1.0), (-3.0, -1.0)] {
            let made = axis.spiral_about(axis.domain(), toward, turns, [2.0, 2.0], 24).unwrap();
            let made = Curve::from(made);
            let domain = made.domain();
            for k in 0..=200 {
                let share = f64::from(k) / 200.0;
                let p = made.point_at(domain.at(share));
                let angle = way * TAU * 3.0 * share;
                let wanted = Point3::new(2.0 * angle.cos(), 2.0 * angle.sin(), 12.0 * share);
                assert!(p.distance_to(wanted) < 2e-3, "{share}: {p:?} {wanted:?}");
            }
            let length = (TAU * 6.0).hypot(12.0);
            assert!((made.length() - length).abs() < 1e-2);
        }
    }

    #[test]
    fn about_an_arc_it_keeps_its_distance() {
        let arc = Arc::new(Circle::new(Plane::XY, 10.0).unwrap(), Interval::new(0.0, 3.0)).unwrap();
        let rail = Curve::from(arc);
        let made =
            rail.spiral_about(rail.domain(), Point3::new(20.0, 0.0, 0.0), 8.0, [1.0, 3.0], 24).unwrap();
        let made = Curve::from(made);
        let domain = made.domain();
        assert!(made.start().distance_to(Point3::new(11.0, 0.0, 0.0)) < 1e-9);
        for k in 0..=100 {
            let share = f64::from(k) / 100.0;
            let p = made.point_at(domain.at(share));
            let radius = rail.closest_point(p).unwrap().distance;
            assert!((radius - 1.0 - 2.0 * share).abs() < 0.02, "{share}: {radius}");
        }
        let refused = |turns: f64, radii: [f64; 2], points: usize, toward: Point3| {
            rail.spiral_about(rail.domain(), toward, turns, radii, points).is_err()
        };
        let toward = Point3::new(20.0, 0.0, 0.0);
        assert!(refused(0.0, [1.0, 1.0], 12, toward) && refused(f64::NAN, [1.0, 1.0], 12, toward));
        assert!(refused(1.0, [0.0, 0.0], 12, toward) && refused(1.0, [1.0, 1.0], 4, toward));
        assert!(refused(1.0, [1.0, 1.0], 12, Point3::new(10.0, 5.0, 0.0)));
    }
}
