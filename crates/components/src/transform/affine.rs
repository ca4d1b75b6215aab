//! Transform / Affine: maps that keep lines straight.

use katydid_component::{Context, Message, component};
use katydid_data::{Geometry, Value};
use katydid_elementary::Elementary;
use katydid_geometry::{Box3, Curve, Interval, Plane, Point3, Rectangle, Vector3, Xform};

use super::transformed;

/// Makes geometry larger or smaller about a point.
#[component(
    "4d2a06bd-4b0f-4c65-9ee0-4220e4c01703",
    name = "Scale",
    nick = "Scale",
    at = "Transform/Affine",
    also("4f0dfac8-6c61-40ef-ad41-aad84533f382")
)]
#[output("Geometry", "G", "The scaled geometry.")]
#[output("Transform", "X", "The scaling as a transform.", kind = Transform)]
fn scale(
    context: &Context<'_>,
    /// What to scale.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The point that stays.
    #[port("Center", "C", default = Point3::ORIGIN)]
    center: Point3,
    /// 1 changes nothing, a negative factor mirrors through the point; not zero.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    if factor == 0.0 {
        return Err(Message::error("A factor of 0 leaves nothing"));
    }
    transformed(context, geometry, Xform::scale(center, factor))
}

/// Stretches geometry by three factors along the axes of a plane.
#[component(
    "290f418a-65ee-406a-a9d0-35699815b512",
    name = "Scale NU",
    nick = "Scale NU",
    at = "Transform/Affine",
    also("7753fb03-c1f1-4dbe-8557-f01e23aa3b20")
)]
#[output("Geometry", "G", "The stretched geometry.")]
#[output("Transform", "X", "The stretching as a transform.", kind = Transform)]
fn scale_nu(
    context: &Context<'_>,
    /// What to scale.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// Its origin stays; the factors act along its axes.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The factor along the plane's x axis; not zero.
    #[port("Scale X", "X", default = 1.0)]
    x: f64,
    /// The factor along its y axis; not zero.
    #[port("Scale Y", "Y", default = 1.0)]
    y: f64,
    /// The factor along its normal; not zero.
    #[port("Scale Z", "Z", default = 1.0)]
    z: f64,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    if x == 0.0 || y == 0.0 || z == 0.0 {
        return Err(Message::error("A factor of 0 flattens the geometry: use Project for that"));
    }
    transformed(context, geometry, Xform::scale_non_uniform(&plane, x, y, z))
}

/// Shears geometry so that a grip point moves to a target. The base plane stays; what lies higher moves farther.
///
/// A grip in the base plane is an error.
#[component(
    "5a27203a-e05f-4eea-b80f-a5f29a00fdf2",
    name = "Shear",
    nick = "Shear",
    at = "Transform/Affine",
    also("3ae3a462-38fb-4d49-9f86-7558dfed7c3e")
)]
#[output("Geometry", "G", "The sheared geometry.")]
#[output("Transform", "X", "The shear as a transform.", kind = Transform)]
fn shear(
    context: &Context<'_>,
    /// What to shear.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The plane that stays.
    #[port("Base", "P", default = Plane::XY)]
    base: Plane,
    /// The point to take hold of.
    #[port("Grip", "G")]
    grip: Point3,
    /// Where it goes; only the movement along the plane counts.
    #[port("Target", "T")]
    target: Point3,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    let height = base.signed_distance(grip);
    if height == 0.0 {
        return Err(Message::error("The grip lies in the base plane, which does not move"));
    }
    let motion = target - grip;
    let along = (motion - base.z_axis * motion.dot(base.z_axis)) / height;
    transformed(context, geometry, Xform::in_frame(&base, base.x_axis, base.y_axis, base.z_axis + along))
}

/// Shears geometry by two angles. The base plane stays; what lies higher leans farther over.
#[component(
    "f19ee36c-f21f-4e25-be4c-4ca4b30eda0d",
    name = "Shear Angle",
    nick = "Shear",
    at = "Transform/Affine",
    also("77bfb6a1-0305-4645-b309-cd6dbf1205d7")
)]
#[output("Geometry", "G", "The sheared geometry.")]
#[output("Transform", "X", "The shear as a transform.", kind = Transform)]
fn shear_angle(
    context: &Context<'_>,
    /// What to shear.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The plane that stays.
    #[port("Base", "P", default = Plane::XY)]
    base: Plane,
    /// How far uprights lean along the plane's x axis, in radians; less than a right angle.
    #[port("Angle X", "Ax", default = 0.0)]
    ax: f64,
    /// How far they lean along its y axis.
    #[port("Angle Y", "Ay", default = 0.0)]
    ay: f64,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    let lean = base.x_axis * ax.tangent() + base.y_axis * ay.tangent();
    transformed(context, geometry, Xform::in_frame(&base, base.x_axis, base.y_axis, base.z_axis + lean))
}

/// Projects geometry onto a plane, at right angles to it.
#[component(
    "23285717-156c-468f-a691-b242488c06a6",
    name = "Project",
    nick = "Project",
    at = "Transform/Affine",
    also("24e913c9-7530-436d-b81d-bc3aa27296a4", "9025f4ca-159f-4c54-958b-0aad379dae77")
)]
#[output("Geometry", "G", "The image in the plane.")]
#[output("Transform", "X", "The projection as a transform.", kind = Transform)]
fn project(
    context: &Context<'_>,
    /// What to project.
    #[port("Geometry", "G")]
    geometry: Option<Value>,
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<(Option<Value>, Option<Value>), Message> {
    projected(context, geometry, Xform::planar_projection(&plane))
}

/// Projects geometry onto a plane along a direction.
///
/// A direction within the plane is an error.
#[component(
    "06d7bc4a-ba3e-4445-8ab5-079613b52f28",
    name = "Project Along",
    nick = "ProjectA",
    at = "Transform/Affine"
)]
#[output("Geometry", "G", "The image in the plane.")]
#[output("Transform", "X", "The projection as a transform.", kind = Transform)]
fn project_along(
    context: &Context<'_>,
    /// What to project.
    #[port("Geometry", "G")]
    geometry: Option<Value>,
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Where everything moves.
    #[port("Direction", "D", default = Vector3::new(0.0, 0.0, -1.0))]
    direction: Vector3,
) -> Result<(Option<Value>, Option<Value>), Message> {
    projected(context, geometry, Xform::projection_along(&plane, direction)?)
}

fn projected(
    context: &Context<'_>,
    geometry: Option<Value>,
    xform: Xform,
) -> Result<(Option<Value>, Option<Value>), Message> {
    let (image, xform) = transformed(context, geometry.map(Geometry), xform)?;
    Ok((image.map(|g| g.0), xform))
}

/// The picture of geometry behind a pinhole: mirrored through a point and scaled.
#[component(
    "407e35c6-7c40-4652-bd80-fde1eb7ec034",
    name = "Camera Obscura",
    nick = "CO",
    at = "Transform/Affine",
    also("7ee33ede-4ce1-482c-ab1a-eb7f9151fbc5")
)]
#[output("Geometry", "G", "The picture.")]
#[output("Transform", "X", "The map as a transform.", kind = Transform)]
fn camera_obscura(
    context: &Context<'_>,
    /// What to picture.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The pinhole.
    #[port("Point", "P", default = Point3::ORIGIN)]
    point: Point3,
    /// The size of the picture; not zero.
    #[port("Factor", "F", default = 1.0)]
    factor: f64,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    if factor == 0.0 {
        return Err(Message::error("A factor of 0 leaves nothing"));
    }
    transformed(context, geometry, Xform::scale(point, -factor))
}

/// Carries geometry from one point and direction to another, by the smallest rotation, and scales it as the lengths of
/// the directions differ.
#[component(
    "1602b2cc-007c-4b79-8926-0067c6184e44",
    name = "Orient Direction",
    nick = "Orient",
    at = "Transform/Affine",
    also("4041be93-6746-4cdb-aa95-929bff544fb0")
)]
#[output("Geometry", "G", "The carried geometry.")]
#[output("Transform", "X", "The map as a transform.", kind = Transform)]
fn orient_direction(
    context: &Context<'_>,
    /// What to carry.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The point that goes to point B.
    #[port("Point A", "pA", default = Point3::ORIGIN)]
    point_a: Point3,
    /// The direction that turns into direction B; not zero.
    #[port("Direction A", "dA", default = Vector3::new(0.0, 0.0, 1.0))]
    direction_a: Vector3,
    /// Where point A goes.
    #[port("Point B", "pB", default = Point3::ORIGIN)]
    point_b: Point3,
    /// Where direction A goes; not zero.
    #[port("Direction B", "dB", default = Vector3::new(0.0, 0.0, 1.0))]
    direction_b: Vector3,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    let turn = Xform::rotation_between(direction_a, direction_b, point_a)?;
    let grow = Xform::scale(point_a, direction_b.length() / direction_a.length());
    transformed(context, geometry, Xform::translation(point_b - point_a) * grow * turn)
}

/// The map that takes a corner and three edges to others.
fn between((from, a): (Point3, [Vector3; 3]), (to, b): (Point3, [Vector3; 3])) -> Result<Xform, Message> {
    let frame = |origin, [x, y, z]: [Vector3; 3]| Xform::from_columns(x, y, z, origin);
    let back = frame(from, a).inverse().ok_or_else(|| Message::error("The source has no extent"))?;
    Ok(frame(to, b) * back)
}

/// A range's length, and 1 for a range without: what is flat stays flat.
fn side(range: Interval) -> f64 {
    if range.length() == 0.0 { 1.0 } else { range.length() }
}

/// Carries geometry from one rectangle to another, and stretches it as their sides differ. Heights stay.
#[component(
    "17d40004-489e-42d9-ad10-857f7b436801",
    name = "Rectangle Mapping",
    nick = "RecMap",
    at = "Transform/Affine"
)]
#[output("Geometry", "G", "The carried geometry.")]
#[output("Transform", "X", "The map as a transform.", kind = Transform)]
fn rectangle_mapping(
    context: &Context<'_>,
    /// What to carry.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The rectangle it is seen from.
    #[port("Source", "S")]
    source: Rectangle,
    /// The rectangle it goes to.
    #[port("Target", "T")]
    target: Rectangle,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    let frame = |r: &Rectangle| {
        let corner = r.plane.at(r.x.start, r.y.start, 0.0);
        (corner, [r.plane.x_axis * side(r.x), r.plane.y_axis * side(r.y), r.plane.z_axis])
    };
    transformed(context, geometry, between(frame(&source), frame(&target))?)
}

/// Carries geometry from one box to another, and stretches it as their sides differ.
#[component(
    "8465bcce-9e0a-4cf4-bbda-1a7ce5681e10",
    name = "Box Mapping",
    nick = "BoxMap",
    at = "Transform/Affine"
)]
#[output("Geometry", "G", "The carried geometry.")]
#[output("Transform", "X", "The map as a transform.", kind = Transform)]
fn box_mapping(
    context: &Context<'_>,
    /// What to carry.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The box it is seen from.
    #[port("Source", "S")]
    source: Box3,
    /// The box it goes to.
    #[port("Target", "T")]
    target: Box3,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    let frame = |b: &Box3| {
        let corner = b.plane.at(b.x.start, b.y.start, b.z.start);
        let plane = &b.plane;
        (corner, [plane.x_axis * side(b.x), plane.y_axis * side(b.y), plane.z_axis * side(b.z)])
    };
    transformed(context, geometry, between(frame(&source), frame(&target))?)
}

/// Carries geometry from one triangle to another, corner to corner. Heights above the triangle stay.
#[component(
    "61d81100-c4d3-462d-8b51-d951c0ae32db",
    name = "Triangle Mapping",
    nick = "TriMap",
    at = "Transform/Affine"
)]
#[output("Geometry", "G", "The carried geometry.")]
#[output("Transform", "X", "The map as a transform.", kind = Transform)]
fn triangle_mapping(
    context: &Context<'_>,
    /// What to carry.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The triangle it is seen from: a polyline of three corners.
    #[port("Source", "S")]
    source: &Curve,
    /// The triangle it goes to.
    #[port("Target", "T")]
    target: &Curve,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, between(triangle(source)?, triangle(target)?)?)
}

/// The first corner of a triangle, two edges and the unit normal.
fn triangle(curve: &Curve) -> Result<(Point3, [Vector3; 3]), Message> {
    let wrong = || Message::error("A triangle is a polyline of three corners that are not on one line");
    let points = curve.as_polyline().ok_or_else(wrong)?;
    let (a, b, c) = match points.as_slice() {
        [a, b, c] => (*a, *b, *c),
        [a, b, c, d] if a.distance_to(*d) <= 1e-9 * (*b - *a).length() => (*a, *b, *c),
        _ => return Err(wrong()),
    };
    let (x, y) = (b - a, c - a);
    Ok((a, [x, y, x.cross(y).unitized().ok_or_else(wrong)?]))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_4;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Box3, Circle, Interval, Plane, Point3, PolylineCurve, Rectangle, Vector3};

    const P: Point3 = Point3::new(1.0, 2.0, 3.0);

    #[test]
    fn scales() {
        assert_eq!(Trial::of("Scale").item(P).texts(0), ["{0}: {0.5, 1, 1.5}"]);
        assert!(Trial::of("Scale").item(P).default().item(0.0).message().contains("nothing"));
        let nu = Trial::of("Scale NU").item(P).default().item(2.0).item(3.0).item(4.0);
        assert_eq!(nu.texts(0), ["{0}: {2, 6, 12}"]);
        let same = Trial::of("Scale NU").item(Circle { plane: Plane::XY, radius: 1.0 }).default();
        assert!(same.item(2.0).item(2.0).item(2.0).texts(0)[0].starts_with("{0}: Circle"));
        assert_eq!(Trial::of("Camera Obscura").item(P).default().item(2.0).texts(0), ["{0}: {-2, -4, -6}"]);
    }

    #[test]
    fn shears() {
        let up = Point3::new(0.0, 0.0, 1.0);
        let shear = Trial::of("Shear").item(P).item(Plane::XY).item(up).item(Point3::new(1.0, 0.0, 7.0));
        assert_eq!(shear.texts(0), ["{0}: {4, 2, 3}"]);
        let flat = Trial::of("Shear").item(P).item(Plane::XY).item(Point3::ORIGIN).item(up);
        assert!(flat.message().contains("base plane"));
        let angle = Trial::of("Shear Angle").item(P).item(Plane::XY).item(0.0).item(FRAC_PI_4);
        assert_eq!(angle.texts(0), ["{0}: {1, 5, 3}"]);
    }

    #[test]
    fn projections() {
        let project = "23285717-156c-468f-a691-b242488c06a6";
        assert_eq!(Trial::of_guid(project).item(P).texts(0), ["{0}: {1, 2, 0}"]);
        let along = Trial::of("Project Along").item(P).default().item(Vector3::new(1.0, 0.0, -1.0));
        assert_eq!(along.texts(0), ["{0}: {4, 2, 0}"]);
        assert!(!Trial::of("Project Along").item(P).default().item(Vector3::X).message().is_empty());
    }

    #[test]
    fn mappings() {
        let range = |n: f64| Interval::new(0.0, n);
        let r = |x, y| Rectangle { plane: Plane::XY, x: range(x), y: range(y) };
        let mapped = Trial::of("Rectangle Mapping").item(P).item(r(1.0, 1.0)).item(r(2.0, 5.0));
        assert_eq!(mapped.texts(0), ["{0}: {2, 10, 3}"]);
        let b = |x, y, z| Box3 { plane: Plane::XY, x: range(x), y: range(y), z: range(z) };
        let mapped = Trial::of("Box Mapping").item(P).item(b(1.0, 1.0, 1.0)).item(b(2.0, 5.0, 3.0));
        assert_eq!(mapped.texts(0), ["{0}: {2, 10, 9}"]);
        let triangle = |s: f64| {
            let corners = [[0.0, 0.0, 0.0], [s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, 0.0]].map(Point3::from);
            katydid_geometry::Curve::from(PolylineCurve::new(corners.to_vec()).unwrap())
        };
        let mapped = Trial::of("Triangle Mapping").item(P).item(triangle(1.0)).item(triangle(2.0));
        assert_eq!(mapped.texts(0), ["{0}: {2, 4, 3}"]);
        let oriented = Trial::of("Orient Direction").item(P).default().item(Vector3::Z);
        let oriented = oriented.item(Point3::ORIGIN).item(Vector3::Z * 2.0);
        assert_eq!(oriented.texts(0), ["{0}: {2, 4, 6}"]);
    }
}
