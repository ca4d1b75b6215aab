//! LunchBox Generate: values and vectors by the distance from attractors.

use katydid_component::{Context, List, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Interval, Point3, Vector3};

/// Of each target the mean distance from the attractors and the mean of the vectors to them.
struct Pulls {
    distances: Vec<f64>,
    vectors: Vec<Vector3>,
    /// The least and the greatest distance.
    ends: (f64, f64),
}

impl Pulls {
    /// # Errors
    /// There are no attractors, a point is not finite, or the solve is cancelled.
    fn new(
        context: &Context<'_>,
        attractors: &List<'_, Point3>,
        targets: &List<'_, Point3>,
    ) -> Result<Self, Message> {
        let attractors: Vec<Point3> = attractors.present().collect();
        if attractors.is_empty() {
            return Err(Message::error("There is no attractor"));
        }
        context.items(targets.len().saturating_mul(3))?;
        let count = attractors.len() as f64;
        let mut pulls = Self { distances: Vec::new(), vectors: Vec::new(), ends: (f64::INFINITY, 0.0) };
        for target in targets.present() {
            context.check()?;
            let distance = attractors.iter().map(|a| a.distance_to(target)).sum::<f64>() / count;
            let vector = attractors.iter().fold(Vector3::ZERO, |sum, a| sum + (*a - target)) / count;
            if !distance.is_finite() || !vector.is_finite() {
                return Err(Message::error("A point is not finite"));
            }
            pulls.ends = (pulls.ends.0.min(distance), pulls.ends.1.max(distance));
            pulls.distances.push(distance);
            pulls.vectors.push(vector);
        }
        Ok(pulls)
    }

    /// Where a distance lies between the least, 0, and the greatest, 1.
    fn share(&self, distance: f64) -> f64 {
        let (least, most) = self.ends;
        if most > least { (distance - least) / (most - least) } else { 0.0 }
    }

    /// The values with the vectors of that length, and the distances.
    fn results(self, values: Vec<f64>) -> (Vec<f64>, Vec<Vector3>, Vec<f64>) {
        let unit = |v: &Vector3| v.unitized().unwrap_or(Vector3::ZERO);
        let vectors = self.vectors.iter().zip(&values).map(|(v, value)| unit(v) * *value).collect();
        (values, vectors, self.distances)
    }
}

/// # Errors
/// An end is not finite.
fn checked(domain: Interval) -> Result<Interval, Message> {
    if domain.is_finite() { Ok(domain) } else { Err(Message::error("The domain is not finite")) }
}

/// # Errors
/// The frequency is not finite.
fn finite(frequency: f64) -> Result<(), Message> {
    if frequency.is_finite() { Ok(()) } else { Err(Message::error("The frequency is not finite")) }
}

/// A component that gives values by the distances from attractors.
macro_rules! attractor {
    (
        $(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal,
        [$($(#[$($attribute:tt)*])+ $parameter:ident: $kind:ty)?], $parts:expr
    ) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "LunchBox/Generate")]
        #[output("Values", "Values", "The values, in the domain.")]
        #[output(
            "Vectors",
            "Vectors",
            "Vectors towards the attractors as long as the values: the mean of the directions."
        )]
        #[output("Distances", "Distances", "The distances; with several attractors their mean.")]
        fn $function(
            context: &Context<'_>,
            /// The attractors.
            #[port("Attractor Points", "Attractors")]
            attractors: List<Point3>,
            /// The points that values are wanted for.
            #[port("Target Points", "Targets")]
            targets: List<Point3>,
            /// The domain of the values.
            #[port("Attractor Domain", "Domain", default = Interval::UNIT)]
            domain: Interval,
            $($(#[$($attribute)*])+ $parameter: $kind,)?
        ) -> Result<(Vec<f64>, Vec<Vector3>, Vec<f64>), Message> {
            $(finite($parameter)?;)?
            let (domain, pulls) = (checked(domain)?, Pulls::new(context, &attractors, &targets)?);
            let parts = $parts;
            let values = pulls.distances.iter().map(|d| domain.at(parts(&pulls, *d))).collect();
            Ok(pulls.results(values))
        }
    };
}

attractor!(
    /// Values for points by how far they are from attractors: the nearest of all has the start of a domain, the farthest its end.
    /// Stands for LunchBox's Attractor; that the vectors lead to the attractors, with the values for lengths, is our reading.
    attractor, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c51", "Attractor", "Attract",
    [],
    Pulls::share
);

attractor!(
    /// Values for points that go up and down with the distance from attractors, as rings on water do. Stands for LunchBox's
    /// Attractor Wave; that the value is the sine of the frequency times the distance, carried from −1…1 to the domain, is our
    /// reading.
    attractor_wave, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c52", "Attractor Wave", "AttWave",
    [
        /// By how many radians the wave goes on in a unit of length.
        #[port("Frequency", "Freq", default = 1.0)]
        frequency: f64
    ],
    |_: &Pulls, distance: f64| 0.5 + 0.5 * (frequency * distance).sine()
);

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Point3};

    fn row() -> Vec<Point3> {
        [1.0, 2.0, 5.0].map(|x| Point3::new(x, 0.0, 0.0)).to_vec()
    }

    #[test]
    fn near_is_little_and_far_is_much() {
        let of = || Trial::of("Attractor").item(Point3::ORIGIN).list(row()).item(Interval::new(10.0, 30.0));
        assert_eq!(of().texts(0), ["{0;0}: 10, 15, 30"]);
        assert_eq!(of().texts(1), ["{0;0}: {-10, 0, 0}, {-15, 0, 0}, {-30, 0, 0}"]);
        assert_eq!(of().texts(2), ["{0;0}: 1, 2, 5"]);
        let two = [Point3::ORIGIN, Point3::new(6.0, 0.0, 0.0)];
        let both = Trial::of("Attractor").list(two).list(row());
        assert_eq!(both.texts(2), ["{0;0}: 3, 3, 3"]);
        let both = Trial::of("Attractor").list(two).list(row());
        assert_eq!(both.texts(0), ["{0;0}: 0, 0, 0"]);
    }

    #[test]
    fn waves() {
        let turn = std::f64::consts::FRAC_PI_2;
        let of = |domain: Interval| {
            Trial::of("Attractor Wave").item(Point3::ORIGIN).list(row()).item(domain).item(turn)
        };
        // The sines of 90°, 180° and 450°.
        assert_eq!(of(Interval::new(0.0, 4.0)).texts(0), ["{0;0}: 4, 2, 4"]);
        assert!(of(Interval::new(0.0, f64::INFINITY)).message().contains("domain"));
        let endless = Trial::of("Attractor Wave").item(Point3::ORIGIN).list(row()).default().item(f64::NAN);
        assert!(endless.message().contains("frequency"));
        let none: [Option<Point3>; 1] = [None];
        assert!(Trial::of("Attractor").gaps(none).list(row()).message().contains("no attractor"));
    }
}
