//! Vector / Point: points from numbers and back.

use katydid_component::{Call, List, Message, Outcome, component, whole};
use katydid_data::Value;
use katydid_elementary::Elementary;
use katydid_geometry::{Plane, Point3};

/// A point from its three coordinates.
#[component(
    "3581f42a-9592-4549-bd6b-1c0fc39d067b",
    name = "Construct Point",
    nick = "Pt",
    at = "Vector/Point",
    columns = construct_points
)]
#[output("Point", "Pt", "The point.")]
fn construct_point(
    /// Along the world's x axis.
    #[port("X coordinate", "X", default = 0.0)]
    x: f64,
    /// Along the world's y axis.
    #[port("Y coordinate", "Y", default = 0.0)]
    y: f64,
    /// Along the world's z axis.
    #[port("Z coordinate", "Z", default = 0.0)]
    z: f64,
) -> Point3 {
    Point3::new(x, y, z)
}

/// Points of whole columns of coordinates.
fn construct_points(call: &Call<'_>) -> Option<Outcome> {
    whole::three(call, Point3::new)
}

/// A point from its coordinates in a plane.
#[component(
    "8a5aae11-8775-4ee5-b4fc-db3a1bd89c2f",
    name = "Construct Point",
    nick = "Pt",
    at = "Vector/Point",
    old
)]
#[output("Point", "Pt", "The point.")]
fn construct_point_in_system(
    /// Along the plane's x axis.
    #[port("X coordinate", "X", default = 0.0)]
    x: f64,
    /// Along the plane's y axis.
    #[port("Y coordinate", "Y", default = 0.0)]
    y: f64,
    /// Along the plane's normal.
    #[port("Z coordinate", "Z", default = 0.0)]
    z: f64,
    /// The plane the coordinates are measured in.
    #[port("System", "S", default = Plane::XY)]
    system: Plane,
) -> Point3 {
    system.at(x, y, z)
}

/// The three coordinates of a point.
#[component(
    "9abae6b7-fa1d-448c-9209-4a8155345841",
    name = "Deconstruct",
    nick = "pDecon",
    at = "Vector/Point"
)]
#[output("X component", "X", "Along the world's x axis.")]
#[output("Y component", "Y", "Along the world's y axis.")]
#[output("Z component", "Z", "Along the world's z axis.")]
fn deconstruct(
    /// The point.
    #[port("Point", "P")]
    point: Point3,
) -> (f64, f64, f64) {
    (point.x, point.y, point.z)
}

/// The coordinates of a point in a plane.
#[component(
    "670fcdba-da07-4eb4-b1c1-bfa0729d767d",
    name = "Deconstruct Point",
    nick = "DePoint",
    at = "Vector/Point"
)]
#[output("X coordinate", "X", "Along the plane's x axis.")]
#[output("Y coordinate", "Y", "Along the plane's y axis.")]
#[output("Z coordinate", "Z", "Along the plane's normal.")]
fn deconstruct_point(
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// The plane to measure in.
    #[port("System", "S", default = Plane::XY)]
    system: Plane,
) -> (f64, f64, f64) {
    let [x, y, z] = system.coordinates(point);
    (x, y, z)
}

/// The straight distance between two points.
#[component(
    "93b8e93d-f932-402c-b435-84be04d87666",
    name = "Distance",
    nick = "Dist",
    at = "Vector/Point",
    columns = distances
)]
#[output("Distance", "D", "The distance, in the units of the points.")]
fn distance(
    /// The first point.
    #[port("Point A", "A")]
    a: Point3,
    /// The second point.
    #[port("Point B", "B")]
    b: Point3,
) -> f64 {
    a.distance_to(b)
}

/// Distances of whole columns of points.
fn distances(call: &Call<'_>) -> Option<Outcome> {
    whole::two(call, Point3::distance_to)
}

/// The weighted sum of three points. With U + V + W = 1 it lies in their plane, and these are its barycentric coordinates.
#[component(
    "9adffd61-f5d1-4e9e-9572-e8d9145730dc",
    name = "Barycentric",
    nick = "BCentric",
    at = "Vector/Point"
)]
#[output("Point", "P", "The point U A + V B + W C.")]
fn barycentric(
    /// The first corner.
    #[port("Point A", "A")]
    a: Point3,
    /// The second corner.
    #[port("Point B", "B")]
    b: Point3,
    /// The third corner.
    #[port("Point C", "C")]
    c: Point3,
    /// The weight of A.
    #[port("Coordinate U", "U", default = 1.0)]
    u: f64,
    /// The weight of B.
    #[port("Coordinate V", "V", default = 0.0)]
    v: f64,
    /// The weight of C.
    #[port("Coordinate W", "W", default = 0.0)]
    w: f64,
) -> Point3 {
    (a.to_vector() * u + b.to_vector() * v + c.to_vector() * w).to_point()
}

/// A point from its coordinates in a plane.
#[component(
    "aa333235-5922-424c-9002-1e0b866a854b",
    name = "Point Oriented",
    nick = "Pt",
    at = "Vector/Point"
)]
#[output("Point", "Pt", "The point.")]
fn point_oriented(
    /// The plane the coordinates are measured in.
    #[port("Base plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Along the plane's x axis.
    #[port("U component", "U", default = 0.0)]
    u: f64,
    /// Along the plane's y axis.
    #[port("V component", "V", default = 0.0)]
    v: f64,
    /// Along the plane's normal.
    #[port("W component", "W", default = 0.0)]
    w: f64,
) -> Point3 {
    plane.at(u, v, w)
}

/// A point from cylindrical coordinates: an angle in a plane, a distance from its normal axis, and a height.
#[component(
    "23603075-be64-4d86-9294-c3c125a12104",
    name = "Point Cylindrical",
    nick = "Pt",
    at = "Vector/Point"
)]
#[output("Point", "Pt", "The point.")]
fn point_cylindrical(
    /// The plane the coordinates are measured in.
    #[port("Base plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Counter-clockwise from the plane's x axis, in radians.
    #[port("Angle", "A", default = 0.0)]
    angle: f64,
    /// The distance from the axis.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// The height above the plane.
    #[port("Elevation", "E", default = 0.0)]
    elevation: f64,
) -> Point3 {
    let (sin, cos) = angle.sine_cosine();
    plane.at(radius * cos, radius * sin, elevation)
}

/// A point from two angles and a distance: longitude, latitude and radius.
#[component("a435f5c8-28a2-43e8-a52a-0b6e73c2e300", name = "Point Polar", nick = "Pt", at = "Vector/Point")]
#[output("Point", "Pt", "The point.")]
fn point_polar(
    /// The plane the angles are measured from.
    #[port("Base plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Counter-clockwise from the plane's x axis, in radians.
    #[port("XY angle", "xy", default = 0.0)]
    xy: f64,
    /// Up from the plane, in radians.
    #[port("Z angle", "z", default = 0.0)]
    z: f64,
    /// The distance from the plane's origin.
    #[port("Offset", "d", default = 1.0)]
    offset: f64,
) -> Point3 {
    let ((sin, cos), (up, flat)) = (xy.sine_cosine(), z.sine_cosine());
    plane.at(offset * flat * cos, offset * flat * sin, offset * up)
}

/// The two angles and the distance of a point as seen from a plane's origin.
#[component("61647ba2-31eb-4921-9632-df81e3286f7d", name = "To Polar", nick = "Polar", at = "Vector/Point")]
#[output("Phi", "P", "The angle in the plane, counter-clockwise from its x axis, 0 to 2 pi.")]
#[output("Theta", "T", "The angle up from the plane, -pi/2 to pi/2.")]
#[output("Radius", "R", "The distance from the plane's origin.")]
fn to_polar(
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// The plane to measure in.
    #[port("System", "S", default = Plane::XY)]
    system: Plane,
) -> (f64, f64, f64) {
    let [x, y, z] = system.coordinates(point);
    let phi = y.arctangent_of(x);
    let phi = if phi < 0.0 { phi + std::f64::consts::TAU } else { phi };
    (phi, z.arctangent_of(x.hypotenuse(y)), point.distance_to(system.origin))
}

/// Which coordinates a mask picks: a text such as `XYZ` or `xz`. Files store the usual mask as the number 4.
fn mask(mask: Option<Value>) -> Result<Vec<usize>, Message> {
    let wrong = || Message::error("The mask must be a text of the letters X, Y and Z, each at most once");
    let text = match mask {
        None | Some(Value::Integer(4)) => return Ok(vec![0, 1, 2]),
        Some(Value::Text(text)) => text,
        Some(_) => return Err(wrong()),
    };
    let mut picked = Vec::new();
    for letter in text.trim().chars() {
        let axis = "xyz".find(letter.to_ascii_lowercase()).ok_or_else(wrong)?;
        if picked.contains(&axis) {
            return Err(wrong());
        }
        picked.push(axis);
    }
    if picked.is_empty() { Err(wrong()) } else { Ok(picked) }
}

/// Takes numbers from a list two or three at a time, as coordinates of points.
///
/// Numbers left over at the end make no point. Nulls are skipped.
#[component(
    "0ae07da9-951b-4b9b-98ca-d312c252374d",
    name = "Numbers to Points",
    nick = "Num2Pt",
    at = "Vector/Point"
)]
#[output("Points", "P", "The points.")]
fn numbers_to_points(
    /// The coordinates, one point after the other.
    #[port("Numbers", "N")]
    numbers: List<f64>,
    /// Which coordinates come, and in which order: `XYZ`, `XY`, `zx`. Those that do not are 0.
    #[port("Mask", "M")]
    picked: Option<Value>,
) -> Result<Vec<Point3>, Message> {
    let axes = mask(picked)?;
    let numbers: Vec<f64> = numbers.present().collect();
    let point = |numbers: &[f64]| {
        let mut p = [0.0; 3];
        for (&axis, &x) in axes.iter().zip(numbers) {
            if let Some(place) = p.get_mut(axis) {
                *place = x;
            }
        }
        Point3::from(p)
    };
    Ok(numbers.chunks_exact(axes.len()).map(point).collect())
}

/// The coordinates of points as one list of numbers, one point after the other. Nulls are skipped.
#[component(
    "d24169cc-9922-4923-92bc-b9222efc413f",
    name = "Points to Numbers",
    nick = "Pt2Num",
    at = "Vector/Point"
)]
#[output("Numbers", "N", "The numbers.")]
fn points_to_numbers(
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// Which coordinates to take, and in which order: `XYZ`, `XY`, `zx`.
    #[port("Mask", "M")]
    picked: Option<Value>,
) -> Result<Vec<f64>, Message> {
    let axes = mask(picked)?;
    Ok(points
        .present()
        .flat_map(|p| {
            let p = <[f64; 3]>::from(p);
            axes.iter().filter_map(move |&axis| p.get(axis).copied()).collect::<Vec<f64>>()
        })
        .collect())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use katydid_component::testing::Trial;
    use katydid_geometry::{Plane, Point3};

    const P: Point3 = Point3::new(1.0, 2.0, 3.0);

    #[test]
    fn coordinates() {
        assert_eq!(Trial::of("Construct Point").item(1.0).item(2).item("3").texts(0), ["{0}: {1, 2, 3}"]);
        assert_eq!(Trial::of("Construct Point").texts(0), ["{0}: {0, 0, 0}"]);
        assert_eq!(Trial::of("Deconstruct").item(P).texts(2), ["{0}: 3"]);
        let there = Trial::of_guid("8a5aae11-8775-4ee5-b4fc-db3a1bd89c2f");
        assert_eq!(there.item(1.0).item(2.0).item(0.0).item(Plane::XZ).texts(0), ["{0}: {1, 0, 2}"]);
        assert_eq!(Trial::of("Deconstruct Point").item(P).item(Plane::XZ).texts(1), ["{0}: 3"]);
        assert_eq!(Trial::of("Distance").item(P).item(Point3::new(1.0, 5.0, 7.0)).texts(0), ["{0}: 5"]);
        let middle = Trial::of("Barycentric").item(P).item(P).item(Point3::ORIGIN).item(0.25).item(0.25);
        assert_eq!(middle.item(0.5).texts(0), ["{0}: {0.5, 1, 1.5}"]);
    }

    /// Lists of different lengths, over branches of different counts, so many that several threads take part.
    #[test]
    fn many_coordinates_meet_as_few_do() {
        let mut x = katydid_data::TreeBuilder::<f64>::new();
        for branch in 0..400 {
            x.branch(format!("{{0;{branch}}}").parse().unwrap());
            x.push(Some(f64::from(branch)));
        }
        let trial = Trial::of("Construct Point").tree(x.finish()).list((0..100).map(f64::from));
        let crossed = trial.list([1.0, 2.0, 3.0]).run().outputs.swap_remove(0);
        assert_eq!((crossed.branch_count(), crossed.item_count()), (400, 40_000));
        assert_eq!(crossed.paths()[399].to_string(), "{0;399}");
        assert_eq!(crossed.range(7), 700..800);
        let points: &[Point3] = katydid_data::Item::slice(crossed.column()).unwrap();
        for (at, point) in points.iter().enumerate() {
            let (branch, i) = (at / 100, at % 100);
            assert_eq!(*point, Point3::new(branch as f64, i as f64, 1.0 + i.min(2) as f64));
        }
    }

    /// Columns that are taken as a whole, and those that are too uneven for that.
    #[test]
    fn columns_of_coordinates() {
        let x = [1.0, 2.0, 3.0];
        let points = |y: &[f64]| Trial::of("Construct Point").list(x).list(y.iter().copied()).texts(0);
        assert_eq!(points(&[7.0]), ["{0}: {1, 7, 0}, {2, 7, 0}, {3, 7, 0}"]);
        assert_eq!(points(&[7.0, 8.0, 9.0]), ["{0}: {1, 7, 0}, {2, 8, 0}, {3, 9, 0}"]);
        assert_eq!(points(&[7.0, 8.0]), ["{0}: {1, 7, 0}, {2, 8, 0}, {3, 8, 0}"]);
        assert_eq!(points(&[7.0, 8.0, 9.0, 10.0])[0].matches("{3, ").count(), 2);
        let branches =
            || Trial::of("Construct Point").branches([("{0;1}", [1.0, 2.0]), ("{0;2}", [3.0, 4.0])]);
        assert_eq!(
            branches().item(5.0).texts(0),
            ["{0;1}: {1, 5, 0}, {2, 5, 0}", "{0;2}: {3, 5, 0}, {4, 5, 0}"]
        );
        let other = branches().branches([("{0;1}", [6.0, 7.0]), ("{0;3}", [8.0, 9.0])]);
        assert_eq!(other.texts(0).len(), 2);
        let apart = Trial::of("Distance").list([P, Point3::ORIGIN]).item(Point3::ORIGIN);
        assert_eq!(apart.texts(0), ["{0}: 3.741657, 0"]);
    }

    #[test]
    fn systems() {
        let oriented = Trial::of("Point Oriented").item(Plane::XY.offset(1.0)).item(1.0).item(2.0).item(3.0);
        assert_eq!(oriented.texts(0), ["{0}: {1, 2, 4}"]);
        let round = Trial::of("Point Cylindrical").item(Plane::XY).item(FRAC_PI_2).item(2.0).item(5.0);
        assert_eq!(round.texts(0), ["{0}: {0, 2, 5}"]);
        let up = Trial::of("Point Polar").item(Plane::XY).item(0.0).item(FRAC_PI_2).item(2.0);
        assert_eq!(up.texts(0), ["{0}: {0, 0, 2}"]);
        let polar = || Trial::of("To Polar").item(Point3::new(0.0, -2.0, 0.0)).item(Plane::XY);
        assert_eq!(polar().texts(0), [format!("{{0}}: {:.6}", 1.5 * PI)]);
        assert_eq!(polar().texts(1), ["{0}: 0"]);
        assert_eq!(polar().texts(2), ["{0}: 2"]);
    }

    #[test]
    fn numbers_and_points() {
        let numbers = || Trial::of("Numbers to Points").list([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
        assert_eq!(numbers().texts(0), ["{0;0}: {1, 2, 3}, {4, 5, 6}"]);
        assert_eq!(numbers().item("zx").texts(0), ["{0;0}: {2, 0, 1}, {4, 0, 3}, {6, 0, 5}"]);
        assert!(numbers().item("xx").message().contains("mask"));
        assert_eq!(Trial::of("Points to Numbers").list([P, P]).item("xy").texts(0), ["{0;0}: 1, 2, 1, 2"]);
    }
}
