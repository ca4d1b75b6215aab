//! Fields of force, and the lines along them.

use katydid_elementary::Elementary;

use crate::thresholds;
use crate::{Box3, Error, Line, Plane, Point3, Result, Vector3};

/// A place this near to the box of a field, in model units, is in it.
const BOX_SLACK: f64 = 1e-9;
/// Lines of a field are not followed more exactly than this, in model units.
const LEAST_TOLERANCE: f64 = 1e-12;

/// One source of force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// Pushes away from a point with charge / distanceᵈᵉᶜᵃʸ; a negative charge pulls.
    Point {
        /// Where the charge sits.
        location: Point3,
        /// The force at distance 1.
        charge: f64,
        /// The power of the distance it falls with; 2 in nature.
        decay: f64,
    },
    /// Pushes away from a charge spread evenly over a segment, each part as a point charge of decay 2.
    Segment {
        /// Where the charge is spread.
        line: Line,
        /// The charge of the whole segment.
        charge: f64,
    },
    /// Turns round the axis of a plane, counter-clockwise seen against its normal, by
    /// strength / (1 + distance / radius)ᵈᵉᶜᵃʸ, the distance being that from the plane's origin.
    Spin {
        /// The plane whose normal through its origin is the axis.
        plane: Plane,
        /// The force near the origin.
        strength: f64,
        /// The unit of distance that the force fades in; of 0 it has faded everywhere.
        radius: f64,
        /// The power it fades with.
        decay: f64,
    },
    /// The same vector everywhere.
    Uniform(
        /// The force.
        Vector3,
    ),
}

/// A source of force that may be kept inside a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// What it does.
    pub source: Source,
    /// Where it does it; everywhere when absent.
    pub bounds: Option<Box3>,
}

impl Force {
    /// The force at a point: zero outside the bounds and where the source itself sits.
    pub fn at(&self, p: Point3) -> Vector3 {
        if self.bounds.as_ref().is_some_and(|b| !b.contains(p, BOX_SLACK)) {
            return Vector3::ZERO;
        }
        let force = match self.source {
            Source::Point { location, charge, decay } => {
                let v = p - location;
                v.unitized().map_or(Vector3::ZERO, |u| u * (charge / v.length().raised_to(decay)))
            }
            Source::Segment { line, charge } => segment(&line, p) * charge,
            Source::Spin { plane, strength, radius, decay } => {
                let [x, y, _] = plane.coordinates(p);
                let fade = (1.0 + plane.origin.distance_to(p) / radius).raised_to(-decay);
                (plane.y_axis * x - plane.x_axis * y)
                    .unitized()
                    .map_or(Vector3::ZERO, |u| u * (strength * fade))
            }
            Source::Uniform(v) => v,
        };
        if force.is_finite() { force } else { Vector3::ZERO }
    }

    /// The distance from a point to the charge; `None` for a source that sits nowhere.
    fn distance(&self, p: Point3) -> Option<f64> {
        match self.source {
            Source::Point { location, .. } => Some(location.distance_to(p)),
            Source::Segment { line, .. } => {
                Some(line.at(line.closest_parameter(p).clamp(0.0, 1.0)).distance_to(p))
            }
            Source::Spin { .. } | Source::Uniform(_) => None,
        }
    }
}

/// The field of a unit charge spread over a segment: the integral of (p − q)/|p − q|³ over its points q in closed form.
fn segment(line: &Line, p: Point3) -> Vector3 {
    let Some(u) = line.unit_direction() else {
        let v = p - line.from;
        return v.unitized().map_or(Vector3::ZERO, |u| u / v.length_squared());
    };
    // Along the line from the foot of p: the ends at a and b, p itself off it by n.
    let (a, b) = ((line.from - p).dot(u), (line.to - p).dot(u));
    let n = (p - line.from) + u * a;
    let r = n.length();
    let (ra, rb) = (a.hypotenuse(r), b.hypotenuse(r));
    if ra == 0.0 || rb == 0.0 {
        return Vector3::ZERO;
    }
    let along = u * (1.0 / rb - 1.0 / ra);
    let across = if a * b > 0.0 {
        // Beside the segment the two parts nearly cancel: written so that they do not.
        n * (a.signum() * (1.0 / (ra * (ra + a.abs())) - 1.0 / (rb * (rb + b.abs()))))
    } else if r > 0.0 {
        n * ((b / rb - a / ra) / (r * r))
    } else {
        return Vector3::ZERO;
    };
    (along + across) / line.length()
}

/// How a line along a field is stepped; the number of an order is the power of the step that its error falls with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stepper {
    /// Euler's method, order 1.
    Euler,
    /// The midpoint method, order 2.
    Midpoint,
    /// Kutta's third-order method.
    Kutta3,
    /// The classic Runge–Kutta method, order 4.
    RungeKutta4,
    /// The Dormand–Prince pair of orders 5 and 4: steps are cut as short as an error below this length needs.
    DormandPrince(
        /// The largest error of one step.
        f64,
    ),
}

/// Several forces that act together.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Field {
    forces: Vec<Force>,
}

impl Field {
    /// The field of all these forces.
    ///
    /// # Errors
    /// A charge, strength, decay or place that is not finite, and a spin without a positive radius.
    pub fn new(forces: Vec<Force>) -> Result<Self> {
        for force in &forces {
            let finite = match force.source {
                Source::Point { location, charge, decay } => {
                    location.is_finite() && charge.is_finite() && decay.is_finite()
                }
                Source::Segment { line, charge } => line.is_finite() && charge.is_finite(),
                Source::Spin { plane, strength, radius, decay } => {
                    if !(radius >= 0.0) {
                        let must = "not negative";
                        return Err(Error::OutOfRange {
                            what: "radius of a spin force",
                            value: radius,
                            must,
                        });
                    }
                    plane.is_finite() && strength.is_finite() && radius.is_finite() && decay.is_finite()
                }
                Source::Uniform(v) => v.is_finite(),
            };
            if !finite {
                return Err(Error::NotFinite("force"));
            }
        }
        Ok(Self { forces })
    }

    /// The forces it is made of.
    #[inline]
    pub fn forces(&self) -> &[Force] {
        &self.forces
    }

    /// The sum of all forces at a point.
    pub fn at(&self, p: Point3) -> Vector3 {
        self.forces.iter().map(|force| force.at(p)).sum()
    }

    /// The direction of the field; `None` where there is no force.
    fn direction(&self, p: Point3) -> Option<Vector3> {
        self.at(p).unitized()
    }

    /// Points along the line of the field from `start` on, `step` apart along it: at most `steps` of them behind the
    /// first. It ends where there is no force, and at a charge that it runs into.
    ///
    /// The field's direction is followed and not its strength, so the points are evenly spaced. Runge–Kutta methods
    /// and the Dormand–Prince pair: Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, II.1 and
    /// II.5. `go_on` is asked before each step; when it says no, the line ends.
    ///
    /// # Errors
    /// A step that is not positive, or a start that is not finite.
    pub fn line(
        &self,
        start: Point3,
        steps: usize,
        step: f64,
        stepper: Stepper,
        mut go_on: impl FnMut() -> bool,
    ) -> Result<Vec<Point3>> {
        if !start.is_finite() {
            return Err(Error::NotFinite("start of a field line"));
        }
        if !(step > 0.0 && step.is_finite()) {
            return Err(Error::OutOfRange { what: "step", value: step, must: "greater than 0" });
        }
        let mut points = vec![start];
        let mut p = start;
        for _ in 0..steps {
            if !go_on() {
                break;
            }
            let Some(next) = self.step(p, step, stepper).filter(|q| q.is_finite()) else { break };
            // A line that comes nearer to a charge than half a step has arrived: past it, it would only swing.
            let near =
                |q: Point3| self.forces.iter().filter_map(|f| f.distance(q)).fold(f64::INFINITY, f64::min);
            let (before, after) = (near(p), near(next));
            points.push(next);
            if after < 0.5 * step && after < before {
                break;
            }
            p = next;
        }
        Ok(points)
    }

    fn step(&self, p: Point3, h: f64, stepper: Stepper) -> Option<Point3> {
        let d = |p: Point3| self.direction(p);
        let k1 = d(p)?;
        Some(match stepper {
            Stepper::Euler => p + k1 * h,
            Stepper::Midpoint => p + d(p + k1 * (0.5 * h))? * h,
            Stepper::Kutta3 => {
                let k2 = d(p + k1 * (0.5 * h))?;
                let k3 = d(p + (k2 * 2.0 - k1) * h)?;
                p + (k1 + k2 * 4.0 + k3) * (h / 6.0)
            }
            Stepper::RungeKutta4 => {
                let k2 = d(p + k1 * (0.5 * h))?;
                let k3 = d(p + k2 * (0.5 * h))?;
                let k4 = d(p + k3 * h)?;
                p + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (h / 6.0)
            }
            Stepper::DormandPrince(tolerance) => self.adaptive(p, h, tolerance.max(LEAST_TOLERANCE))?,
        })
    }

    /// One step of length `h` in as many shorter ones as the tolerance asks for; `None` when 10 000 are too few.
    fn adaptive(&self, mut p: Point3, h: f64, tolerance: f64) -> Option<Point3> {
        let (mut done, mut size) = (0.0, h);
        for _ in 0..10_000 {
            let left = h - done;
            if left <= thresholds::EXACT_PARAMETER * h {
                return Some(p);
            }
            size = f64::min(size, left);
            let (next, error) = self.dormand_prince(p, size)?;
            if error <= tolerance {
                p = next;
                done += size;
            }
            let grown = 0.9 * (tolerance / error.max(thresholds::LEAST_DIVISOR)).raised_to(0.2);
            size *= grown.clamp(0.2, 5.0);
        }
        None
    }

    /// A step of order 5 and the length of its difference from the one of order 4.
    fn dormand_prince(&self, p: Point3, h: f64) -> Option<(Point3, f64)> {
        const A: [&[f64]; 6] = [
            &[1.0 / 5.0],
            &[3.0 / 40.0, 9.0 / 40.0],
            &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
            &[19_372.0 / 6561.0, -25_360.0 / 2187.0, 64_448.0 / 6561.0, -212.0 / 729.0],
            &[9017.0 / 3168.0, -355.0 / 33.0, 46_732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18_656.0],
            &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
        ];
        /// Weights of order 5 minus those of order 4.
        const E: [f64; 7] = [
            71.0 / 57_600.0,
            0.0,
            -71.0 / 16_695.0,
            71.0 / 1920.0,
            -17_253.0 / 339_200.0,
            22.0 / 525.0,
            -1.0 / 40.0,
        ];
        let mut k = vec![self.direction(p)?];
        let mut next = p;
        for row in A {
            let sum: Vector3 = row.iter().zip(&k).map(|(a, k)| *k * *a).sum();
            next = p + sum * h;
            k.push(self.direction(next)?);
        }
        let difference: Vector3 = E.iter().zip(&k).map(|(e, k)| *k * *e).sum();
        Some((next, difference.length() * h))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interval;

    fn field(source: Source) -> Field {
        Field::new(vec![Force { source, bounds: None }]).unwrap()
    }

    #[test]
    fn a_point_charge_falls_with_the_distance() {
        let f = field(Source::Point { location: Point3::ORIGIN, charge: 3.0, decay: 2.0 });
        assert_eq!(f.at(Point3::new(0.0, 2.0, 0.0)), Vector3::new(0.0, 0.75, 0.0));
        assert_eq!(f.at(Point3::ORIGIN), Vector3::ZERO);
    }

    #[test]
    fn a_segment_is_the_sum_of_its_points() {
        let line = Line::new(Point3::new(-1.0, 0.0, 0.0), Point3::new(3.0, 0.0, 0.0));
        let f = field(Source::Segment { line, charge: 2.0 });
        let n = 200_000;
        for p in [Point3::new(0.5, 1.0, 0.0), Point3::new(5.0, 0.3, -0.2), Point3::new(-4.0, 0.0, 0.0)] {
            let mut sum = Vector3::ZERO;
            for i in 0..n {
                let v = p - line.at((f64::from(i) + 0.5) / f64::from(n));
                sum += v * (2.0 / f64::from(n) / v.length().powi(3));
            }
            assert!((f.at(p) - sum).length() < 1e-8, "{:?} {sum:?}", f.at(p));
        }
        // Far away it is a point charge, and on the segment itself nothing.
        let far = f.at(Point3::new(1.0, 1e5, 0.0));
        assert!((far.y - 2e-10).abs() < 1e-18);
        assert_eq!(f.at(Point3::new(1.0, 0.0, 0.0)), Vector3::ZERO);
    }

    #[test]
    fn a_spin_turns_and_bounds_hold() {
        let source = Source::Spin { plane: Plane::XY, strength: 2.0, radius: 5.0, decay: 2.0 };
        let f = field(source);
        assert_eq!(f.at(Point3::new(5.0, 0.0, 0.0)), Vector3::new(0.0, 0.5, 0.0));
        assert!((f.at(Point3::new(0.0, 3.0, 4.0)) - Vector3::new(-0.5, 0.0, 0.0)).length() < 1e-15);
        assert_eq!(f.at(Point3::new(0.0, 0.0, 4.0)), Vector3::ZERO);
        let side = Interval::new(-1.0, 1.0);
        let bounds = Some(Box3 { plane: Plane::XY, x: side, y: side, z: side });
        let bounded = Force { source, bounds };
        assert_eq!(bounded.at(Point3::new(3.0, 0.0, 0.0)), Vector3::ZERO);
        let flat = Source::Spin { plane: Plane::XY, strength: 2.0, radius: 0.0, decay: 2.0 };
        let still = Field::new(vec![Force { source: flat, bounds: None }]).unwrap();
        assert_eq!(
            still.at(Point3::new(3.0, 0.0, 0.0)),
            Vector3::ZERO,
            "it has faded everywhere but on its axis"
        );
        let inside_out = Source::Spin { plane: Plane::XY, strength: 2.0, radius: -1.0, decay: 2.0 };
        assert!(Field::new(vec![Force { source: inside_out, bounds: None }]).is_err());
    }

    #[test]
    fn lines_of_a_spin_are_circles_to_the_order_of_the_method() {
        let f = field(Source::Spin { plane: Plane::XY, strength: 1.0, radius: 5.0, decay: 2.0 });
        let start = Point3::new(2.0, 0.0, 0.0);
        let error = |stepper, step: f64, steps| {
            let points = f.line(start, steps, step, stepper, || true).unwrap();
            assert_eq!(points.len(), steps + 1);
            let angle = step * steps as f64 / 2.0;
            points.last().unwrap().distance_to(Point3::new(2.0 * angle.cos(), 2.0 * angle.sin(), 0.0))
        };
        for (stepper, order) in [
            (Stepper::Euler, 1.0),
            (Stepper::Midpoint, 2.0),
            (Stepper::Kutta3, 3.0),
            (Stepper::RungeKutta4, 4.0),
        ] {
            let ratio = error(stepper, 0.1, 20) / error(stepper, 0.05, 40);
            assert!((ratio.log2() - order).abs() < 0.4, "{stepper:?}: {ratio}");
        }
        assert!(error(Stepper::DormandPrince(1e-10), 1.0, 12) < 1e-8);
    }

    #[test]
    fn lines_end_at_charges_and_where_there_is_no_force() {
        let f = field(Source::Point { location: Point3::ORIGIN, charge: -1.0, decay: 2.0 });
        let points = f.line(Point3::new(1.0, 0.0, 0.0), 1000, 0.1, Stepper::Kutta3, || true).unwrap();
        assert_eq!(points.len(), 11);
        assert!(points[10].distance_to(Point3::ORIGIN) < 0.05 + 1e-9);
        assert_eq!(Field::default().line(Point3::ORIGIN, 9, 1.0, Stepper::Euler, || true).unwrap().len(), 1);
        assert!(f.line(Point3::ORIGIN, 9, 0.0, Stepper::Euler, || true).is_err());
        let stopped =
            field(Source::Uniform(Vector3::X)).line(Point3::ORIGIN, 9, 1.0, Stepper::Euler, || false);
        assert_eq!(stopped.unwrap().len(), 1);
    }
}
