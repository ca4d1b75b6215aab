//! Vector / Vector: where the sun stands.

use katydid_component::component;
use katydid_data::{Colour, DateTime, Location};
use katydid_elementary::Elementary;
use katydid_geometry::{Plane, Vector3};

/// The sun's direction at a place, as the parts of a unit vector to the east, to the north and up.
///
/// The low-precision formulas of the *Astronomical Almanac* (page C5), good to a hundredth of a degree between 1950 and
/// 2050; no refraction. The time is universal time.
fn sun(place: Location, time: DateTime) -> [f64; 3] {
    // Days since noon of 1 January 2000; year 1 of the calendar begins at Julian date 1 721 425.5.
    let n = time.ticks as f64 / 864e9 + 1_721_425.5 - 2_451_545.0;
    let anomaly = (357.528 + 0.985_600_3 * n).to_radians();
    let longitude = 280.460 + 0.985_647_4 * n + 1.915 * anomaly.sine() + 0.020 * (2.0 * anomaly).sine();
    let longitude = longitude.to_radians();
    let obliquity = (23.439 - 4e-7 * n).to_radians();
    let ascension = (obliquity.cosine() * longitude.sine()).arctangent_of(longitude.cosine());
    let declination = (obliquity.sine() * longitude.sine()).arcsine();
    let sidereal_hours = 18.697_374_558 + 24.065_709_824_419_08 * n;
    let hour_angle = (sidereal_hours.rem_euclid(24.0) * 15.0 + place.longitude).to_radians() - ascension;
    let latitude = place.latitude.to_radians();
    [
        -declination.cosine() * hour_angle.sine(),
        latitude.cosine() * declination.sine() - latitude.sine() * declination.cosine() * hour_angle.cosine(),
        latitude.sine() * declination.sine() + latitude.cosine() * declination.cosine() * hour_angle.cosine(),
    ]
}

/// The colour of sunlight at a height: dark blue at night, orange at the horizon, white from 30° on.
fn colour(elevation: f64) -> Colour {
    let height = (elevation.to_degrees() / 30.0).clamp(0.0, 1.0);
    if elevation < 0.0 {
        return Colour::rgb(15, 15, 60);
    }
    let channel = |low: f64| (low + (255.0 - low) * height).round() as u8;
    Colour::rgb(255, channel(120.0), channel(30.0))
}

/// The direction in which sunlight falls at a time and place.
///
/// The time is universal time (UTC), the place's longitude counts east of Greenwich. Refraction is left out: the sun is up
/// to half a degree higher at the horizon.
#[component(
    "59e1f848-38d4-4cbf-ad7f-40ffc52acdf5",
    name = "Solar Incidence",
    nick = "Solar",
    at = "Vector/Vector"
)]
#[output("Direction", "D", "The direction of the light, from the sun to the ground, of length 1.")]
#[output("Elevation", "E", "The angle of the sun above the horizon in radians, negative below it.")]
#[output("Horizon", "H", "Whether the sun is above the horizon.")]
#[output("Colour", "C", "A colour for the light.")]
fn solar_incidence(
    /// The place on the globe.
    #[port("Location", "L")]
    location: Location,
    /// The moment, in universal time.
    #[port("Time", "T")]
    time: DateTime,
    /// The ground: x to the east, y to the north.
    #[port("Orientation", "P", default = Plane::XY)]
    plane: Plane,
) -> (Vector3, f64, bool, Colour) {
    let [east, north, up] = sun(location, time);
    let towards = plane.x_axis * east + plane.y_axis * north + plane.z_axis * up;
    let elevation = up.clamp(-1.0, 1.0).arcsine();
    (-towards, elevation, elevation > 0.0, colour(elevation))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Location, Tree, Value};
    use katydid_geometry::Vector3;

    fn date(parts: [i32; 5]) -> Tree {
        let trial = parts.iter().fold(Trial::of("Construct Date"), |trial, part| trial.item(*part));
        trial.run().outputs[0].clone()
    }

    fn solar(longitude: f64, latitude: f64, parts: [i32; 5]) -> (Vector3, f64, String) {
        let trial = Trial::of("Solar Incidence").item(Location { longitude, latitude }).tree(date(parts));
        let out = trial.run().outputs;
        match (out[0].column().get(0), out[1].column().get(0)) {
            (Some(Value::Vector(d)), Some(Value::Number(e))) => {
                (d, e.to_degrees(), texts(&out[2])[0].clone())
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn equinoxes_and_solstices() {
        // Equinox of 2024-03-20, 03:06 UTC: the sun is on the equator. It crosses Greenwich 7.4 minutes after noon.
        let (light, height, up) = solar(0.0, 0.0, [2024, 3, 20, 12, 7]);
        assert!(height > 89.7 && up.ends_with("True"), "{height}");
        assert!((light + Vector3::Z).length() < 0.01);
        // Greenwich at noon of the June solstice: 90 - 51.48 + 23.44.
        let (light, height, _) = solar(0.0, 51.48, [2024, 6, 20, 12, 2]);
        assert!((height - 61.96).abs() < 0.02, "{height}");
        assert!(light.y > 0.0, "the light falls northwards");
        // Sydney at that moment is in the night; its own noon is ten hours earlier, and low.
        assert!(solar(151.21, -33.87, [2024, 6, 20, 12, 2]).2.ends_with("False"));
        let (light, height, _) = solar(151.21, -33.87, [2024, 6, 21, 1, 57]);
        assert!((height - (90.0 - 33.87 - 23.44)).abs() < 0.05, "{height}");
        assert!(light.y < 0.0);
        // In the morning the sun stands in the east: its light falls westwards.
        assert!(solar(0.0, 51.48, [2024, 6, 20, 6, 0]).0.x < 0.0);
    }
}
