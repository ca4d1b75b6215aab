//! Maps along a finite axis: stretch, taper, twist.

use super::{Morph, finite};
use crate::{Error, Line, Plane, Point3, Result, Vector3};

/// A line from which places along it are measured.
#[derive(Debug, Clone, Copy)]
struct Axis {
    line: Line,
    direction: Vector3,
    length: f64,
}

impl Axis {
    fn new(line: Line) -> Result<Self> {
        if !line.is_finite() {
            return Err(Error::NotFinite("axis"));
        }
        let none = Error::degenerate("axis", "it has no length");
        let direction = line.unit_direction().ok_or(none.clone())?;
        let length = line.length();
        if length > 0.0 && length.is_finite() { Ok(Self { line, direction, length }) } else { Err(none) }
    }

    /// How far along the axis a point lies, 0 at the start.
    fn along(&self, p: Point3) -> f64 {
        (p - self.line.from).dot(self.direction)
    }

    /// The planes across both ends.
    fn ends(&self) -> Vec<Plane> {
        [self.line.from, self.line.to]
            .iter()
            .filter_map(|&p| Plane::from_normal(p, self.direction).ok())
            .collect()
    }

    /// The place along the axis as a fraction of its length; kept in 0…1 unless the map is infinite.
    fn fraction(&self, p: Point3, infinite: bool) -> f64 {
        let s = self.along(p) / self.length;
        if infinite { s } else { s.clamp(0.0, 1.0) }
    }
}

fn number(x: f64, what: &'static str) -> Result<f64> {
    if x.is_finite() { Ok(x) } else { Err(Error::NotFinite(what)) }
}

/// Lengthens or shortens space along an axis: behind its start nothing moves, between its ends all is scaled so that
/// the axis gets the new length, beyond its end all is shifted with the end.
#[derive(Debug, Clone, Copy)]
pub struct Stretch {
    axis: Axis,
    length: f64,
}

impl Stretch {
    /// The stretch that gives the axis a length.
    ///
    /// # Errors
    /// An axis without length, or a length that is not finite.
    pub fn new(axis: Line, length: f64) -> Result<Self> {
        Ok(Self { axis: Axis::new(axis)?, length: number(length, "length")? })
    }
}

impl Morph for Stretch {
    fn image(&self, p: Point3) -> Result<Point3> {
        let s = self.axis.along(p).clamp(0.0, self.axis.length);
        finite(p + self.axis.direction * (s * (self.length / self.axis.length - 1.0)))
    }

    fn seams(&self) -> Vec<Plane> {
        self.axis.ends()
    }
}

/// Widens or narrows space about an axis: the distance from it is scaled by 1 at its start and by `end`/`start` at its
/// end, linearly between. What is at the distance `start` from the axis at its start is at the distance `end` at its end.
#[derive(Debug, Clone, Copy)]
pub struct Taper {
    axis: Axis,
    ratio: f64,
    /// The one direction that is scaled, in a flat taper.
    flat: Option<Vector3>,
    infinite: bool,
}

impl Taper {
    /// The taper between two distances. A flat one acts only in the horizontal direction across the axis (along world
    /// x for a vertical axis). An infinite one goes on beyond the ends, where the factor else stays.
    ///
    /// # Errors
    /// An axis without length, a start distance of 0, or a number that is not finite.
    pub fn new(axis: Line, start: f64, end: f64, flat: bool, infinite: bool) -> Result<Self> {
        let axis = Axis::new(axis)?;
        if start == 0.0 {
            return Err(Error::degenerate("taper", "the distance at the start is 0"));
        }
        let ratio = number(number(end, "end distance")? / number(start, "start distance")?, "taper")?;
        let across = || Vector3::Z.cross(axis.direction).unitized().unwrap_or(Vector3::X);
        Ok(Self { axis, ratio, flat: flat.then(across), infinite })
    }
}

impl Morph for Taper {
    fn image(&self, p: Point3) -> Result<Point3> {
        let factor = self.axis.fraction(p, self.infinite) * (self.ratio - 1.0);
        let off = p - self.axis.line.from;
        let off = match self.flat {
            Some(across) => across * off.dot(across),
            None => off - self.axis.direction * off.dot(self.axis.direction),
        };
        finite(p + off * factor)
    }

    fn seams(&self) -> Vec<Plane> {
        if self.infinite { Vec::new() } else { self.axis.ends() }
    }
}

/// Turns space about an axis, by the right-hand rule, the more the farther along it: by 0 at its start and by the whole
/// angle at its end.
#[derive(Debug, Clone, Copy)]
pub struct Twist {
    axis: Axis,
    angle: f64,
    infinite: bool,
}

impl Twist {
    /// The twist by an angle in radians. An infinite one goes on beyond the ends, where the turn else stays as it is.
    ///
    /// # Errors
    /// An axis without length, or an angle that is not finite.
    pub fn new(axis: Line, angle: f64, infinite: bool) -> Result<Self> {
        Ok(Self { axis: Axis::new(axis)?, angle: number(angle, "angle")?, infinite })
    }
}

impl Morph for Twist {
    fn image(&self, p: Point3) -> Result<Point3> {
        let angle = self.angle * self.axis.fraction(p, self.infinite);
        let off = p - self.axis.line.from;
        let turned = off.rotated(angle, self.axis.direction).ok_or(Error::NotFinite("image of a point"))?;
        finite(self.axis.line.from + turned)
    }

    fn seams(&self) -> Vec<Plane> {
        if self.infinite { Vec::new() } else { self.axis.ends() }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::{Curve, PolylineCurve, Tolerance};

    fn up(height: f64) -> Line {
        Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, height))
    }

    fn at(morph: &dyn Morph, x: f64, y: f64, z: f64) -> [f64; 3] {
        let p = morph.image(Point3::new(x, y, z)).unwrap();
        [p.x, p.y, p.z].map(|c| (c * 1e12).round() / 1e12 + 0.0)
    }

    #[test]
    fn stretching_scales_between_the_ends_only() {
        let stretch = Stretch::new(up(2.0), 4.0).unwrap();
        assert_eq!(at(&stretch, 1.0, 0.0, -1.0), [1.0, 0.0, -1.0]);
        assert_eq!(at(&stretch, 1.0, 0.0, 1.0), [1.0, 0.0, 2.0]);
        assert_eq!(at(&stretch, 1.0, 0.0, 5.0), [1.0, 0.0, 7.0]);
        let line: Curve = up(2.0).into();
        assert!((line.morphed(&stretch, &Tolerance::default()).unwrap().length() - 4.0).abs() < 1e-12);
        // An oblique line over an end is bent there, and exactly there.
        let slope: Curve = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 4.0)).into();
        let Curve::Polyline(bent) = slope.morphed(&stretch, &Tolerance::default()).unwrap() else {
            panic!("a polyline")
        };
        let wanted = [[0.0, 0.0, 0.0], [2.0, 0.0, 4.0], [4.0, 0.0, 6.0]].map(Point3::from);
        assert!(
            bent.points().iter().zip(wanted).all(|(p, q)| p.distance_to(q) < 1e-9)
                && bent.points().len() == 3
        );
        assert!(Stretch::new(up(0.0), 1.0).is_err() && Stretch::new(up(1.0), f64::NAN).is_err());
        let flat: Curve =
            PolylineCurve::new([[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from).to_vec())
                .unwrap()
                .into();
        let same = flat.morphed(&stretch, &Tolerance::default()).unwrap();
        assert!(matches!(same, Curve::Polyline(p) if p.points().len() == 3));
    }

    #[test]
    fn tapers_have_their_ratio_at_the_end() {
        let taper = Taper::new(up(2.0), 2.0, 1.0, false, false).unwrap();
        assert_eq!(at(&taper, 2.0, 2.0, 0.0), [2.0, 2.0, 0.0]);
        assert_eq!(at(&taper, 2.0, 2.0, 1.0), [1.5, 1.5, 1.0]);
        assert_eq!(at(&taper, 2.0, 2.0, 2.0), [1.0, 1.0, 2.0]);
        assert_eq!(at(&taper, 2.0, 2.0, 3.0), [1.0, 1.0, 3.0]);
        let infinite = Taper::new(up(2.0), 2.0, 1.0, false, true).unwrap();
        assert_eq!(at(&infinite, 2.0, 2.0, 3.0), [0.5, 0.5, 3.0]);
        let flat = Taper::new(up(2.0), 2.0, 1.0, true, false).unwrap();
        assert_eq!(at(&flat, 2.0, 2.0, 2.0), [1.0, 2.0, 2.0]);
        assert!(Taper::new(up(2.0), 0.0, 1.0, false, false).is_err());
    }

    #[test]
    fn a_twist_turns_by_its_angle_over_the_axis() {
        let twist = Twist::new(up(2.0), FRAC_PI_2, false).unwrap();
        assert_eq!(at(&twist, 1.0, 0.0, 0.0), [1.0, 0.0, 0.0]);
        assert_eq!(at(&twist, 1.0, 0.0, 2.0), [0.0, 1.0, 2.0]);
        assert_eq!(at(&twist, 1.0, 0.0, 4.0), [0.0, 1.0, 4.0]);
        assert_eq!(at(&Twist::new(up(2.0), FRAC_PI_2, true).unwrap(), 1.0, 0.0, 4.0), [-1.0, 0.0, 4.0]);
        // A line beside the axis becomes a helix: length √(h² + (r φ)²).
        let line: Curve = Line::new(Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 0.0, 2.0)).into();
        let fine = Tolerance { absolute: 1e-7, ..Tolerance::default() };
        let helix = line.morphed(&twist, &fine).unwrap();
        assert!((helix.length() - 2f64.hypot(FRAC_PI_2)).abs() < 1e-6);
    }
}
