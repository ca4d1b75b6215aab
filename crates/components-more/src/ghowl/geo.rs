//! Places on the earth: longitude, latitude and height as the x, y and z of a point.

use katydid_component::{Context, Message, component};
use katydid_elementary::Elementary as _;
use katydid_geometry::{Point3, Units};

/// The radii of the earth at its poles and at the equator that Rhino computes with, in metres.
const POLAR: f64 = 6_356_750.0;
/// See [`POLAR`].
const EQUATORIAL: f64 = 6_378_135.0;

/// Degrees east, degrees north and metres up for a unit of the model at a latitude.
///
/// The radius of the spheroid in the direction of the latitude is that of its ellipse in polar form; a degree of longitude is
/// shorter by the cosine of the latitude.
fn scales(latitude: f64, units: Units) -> Result<[f64; 3], Message> {
    if !(latitude.abs() < 90.0) {
        return Err(Message::error(format!(
            "The latitude is {latitude}: it must lie between the poles, -90 and 90"
        )));
    }
    let radians = latitude.to_radians();
    let (sine, cosine) = radians.sine_cosine();
    let radius = EQUATORIAL / cosine.hypotenuse(sine * (EQUATORIAL / POLAR));
    let metres = katydid_data::units::metres(units);
    let north = metres / radius.to_radians();
    Ok([north / cosine, north, metres])
}

/// The place on the earth of a point of the model, from a point whose place is known: x is the longitude, y the latitude, both in
/// degrees, z the height in metres. The model's x axis runs east and its y axis north. Stands for gHowl's XYZ to Geo. That lengths
/// are in the units of the document is our reading: the plug-in takes any unit for metres.
#[component("7251a345-6b2e-4d21-bdb8-3b26176b21d8", name = "XYZ to Geo", nick = "XYZ->Geo", at = "gHowl/GEO")]
#[output("Geo Points", "P", "Longitude and latitude in degrees, height in metres.")]
fn xyz_to_geo(
    context: &Context<'_>,
    /// The point of the model.
    #[port("XYZ_IN", "P")]
    point: Point3,
    /// The point of the model whose place is known.
    #[port("EAP_XYZ", "XYZ")]
    anchor: Point3,
    /// Its longitude and latitude in degrees, and its height in metres.
    #[port("EAP_Geo", "Geo")]
    place: Point3,
) -> Result<Point3, Message> {
    on_earth(point, anchor, place, context.rules().units)
}

/// The place on the earth of a point of the model, from one whose place is known.
pub(super) fn on_earth(
    point: Point3,
    anchor: Point3,
    place: Point3,
    units: Units,
) -> Result<Point3, Message> {
    let [east, north, up] = scales(place.y, units)?;
    let by = point - anchor;
    Ok(Point3::new(place.x + by.x * east, place.y + by.y * north, place.z + by.z * up))
}

/// The point of the model at a place on the earth, between two points whose places are known: longitude goes to x and latitude to y,
/// each in proportion; the height stays. Stands for gHowl's Geo to XYZ.
#[component("6268ae44-0782-40ca-ac94-21c62ca7943d", name = "Geo to XYZ", nick = "Geo->XYZ", at = "gHowl/GEO")]
#[output("XYZ Points", "P", "The point of the model.")]
fn geo_to_xyz(
    /// Longitude and latitude in degrees, and height.
    #[port("Geo_IN", "P")]
    place: Point3,
    /// The first point of the model, as a rule the lower left corner of a map.
    #[port("Pt 1 Reference XYZ", "P1_XYZ")]
    from: Point3,
    /// The second one, as a rule the upper right corner.
    #[port("Pt 2 Reference XYZ", "P2_XYZ")]
    to: Point3,
    /// The place of the first point.
    #[port("Pt 1 Reference Geo", "P1_Geo")]
    from_place: Point3,
    /// The place of the second one.
    #[port("Pt 2 Reference Geo", "P2_Geo")]
    to_place: Point3,
) -> Result<Point3, Message> {
    let along = |name: &str, at: f64, [a, b]: [f64; 2], [x, y]: [f64; 2]| {
        if a == b {
            return Err(Message::error(format!("The two places have the same {name}")));
        }
        Ok(x + (at - a) / (b - a) * (y - x))
    };
    let x = along("longitude", place.x, [from_place.x, to_place.x], [from.x, to.x])?;
    let y = along("latitude", place.y, [from_place.y, to_place.y], [from.y, to.y])?;
    Ok(Point3::new(x, y, place.z))
}

/// Degrees from degrees and minutes that are written as one number, as receivers of satellite signals do: 4123.5 is 41 degrees and
/// 23.5 minutes. Stands for gHowl's Format Geo. That the sign counts for the whole, and that there may be less than a degree, is our
/// reading.
#[component(
    "6e6fb252-5974-4e39-b0ad-905304b2e7d8",
    name = "Format Geo",
    nick = "DMs -> DD",
    at = "gHowl/GEO"
)]
#[output("Formated Coordinates", "P", "Longitude and latitude in degrees, the height as it came.")]
fn format_geo(
    /// Longitude and latitude in degrees and minutes, and height.
    #[port("GEO", "P")]
    place: Point3,
) -> Point3 {
    let degrees = |x: f64| {
        let whole = (x.abs() / 100.0).floor();
        (whole + (x.abs() - 100.0 * whole) / 60.0).copysign(x)
    };
    Point3::new(degrees(place.x), degrees(place.y), place.z)
}
