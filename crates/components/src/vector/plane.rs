//! Vector / Plane.

use katydid_component::{List, Message, component};
use katydid_geometry::{Line, Plane, Point3, Vector3, Xform};

/// The world's xy plane moved to a point.
#[component("17b7152b-d30d-4d50-b9ef-c9fe25576fc2", name = "XY Plane", nick = "XY", at = "Vector/Plane")]
#[output("Plane", "P", "The plane: x axis along the world's x, y axis along its y.")]
fn xy_plane(
    /// The plane's origin.
    #[port("Origin", "O", default = Point3::ORIGIN)]
    origin: Point3,
) -> Plane {
    Plane::XY.with_origin(origin)
}

/// The world's xz plane moved to a point; its normal is the world's -y.
#[component("8cc3a196-f6a0-49ea-9ed9-0cb343a3ae64", name = "XZ Plane", nick = "XZ", at = "Vector/Plane")]
#[output("Plane", "P", "The plane: x axis along the world's x, y axis along its z.")]
fn xz_plane(
    /// The plane's origin.
    #[port("Origin", "O", default = Point3::ORIGIN)]
    origin: Point3,
) -> Plane {
    Plane::XZ.with_origin(origin)
}

/// The world's yz plane moved to a point.
#[component("fad344bc-09b1-4855-a2e6-437ef5715fe3", name = "YZ Plane", nick = "YZ", at = "Vector/Plane")]
#[output("Plane", "P", "The plane: x axis along the world's y, y axis along its z.")]
fn yz_plane(
    /// The plane's origin.
    #[port("Origin", "O", default = Point3::ORIGIN)]
    origin: Point3,
) -> Plane {
    Plane::YZ.with_origin(origin)
}

/// A plane from its origin and two axes. X keeps its direction; Y is turned in their plane to stand at right angles.
///
/// Parallel axes, or one of length 0, are an error.
#[component(
    "bc3e379e-7206-4e7b-b63a-ff61f4b38a3e",
    name = "Construct Plane",
    nick = "Pl",
    at = "Vector/Plane"
)]
#[output("Plane", "Pl", "The plane.")]
fn construct_plane(
    /// The plane's origin.
    #[port("Origin", "O", default = Point3::ORIGIN)]
    origin: Point3,
    /// The direction of the x axis.
    #[port("X-Axis", "X", default = Vector3::new(1.0, 0.0, 0.0))]
    x_axis: Vector3,
    /// On which side the y axis lies.
    #[port("Y-Axis", "Y", default = Vector3::new(0.0, 1.0, 0.0))]
    y_axis: Vector3,
) -> Result<Plane, Message> {
    Ok(Plane::from_axes(origin, x_axis, y_axis)?)
}

/// The origin and the three unit axes of a plane.
#[component(
    "3cd2949b-4ea8-4ffb-a70c-5c380f9f46ea",
    name = "Deconstruct Plane",
    nick = "DePlane",
    at = "Vector/Plane"
)]
#[output("Origin", "O", "Its origin.")]
#[output("X-Axis", "X", "Its x axis.")]
#[output("Y-Axis", "Y", "Its y axis.")]
#[output("Z-Axis", "Z", "Its normal.")]
fn deconstruct_plane(
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> (Point3, Vector3, Vector3, Vector3) {
    (plane.origin, plane.x_axis, plane.y_axis, plane.z_axis)
}

/// The plane through a point at right angles to a direction. Where its x axis points follows from the direction.
#[component("cfb6b17f-ca82-4f5d-b604-d4f69f569de3", name = "Plane Normal", nick = "Pl", at = "Vector/Plane")]
#[output("Plane", "P", "The plane.")]
fn plane_normal(
    /// The plane's origin.
    #[port("Origin", "O", default = Point3::ORIGIN)]
    origin: Point3,
    /// The direction of the normal; not zero.
    #[port("Z-Axis", "Z", default = Vector3::new(0.0, 0.0, 1.0))]
    z_axis: Vector3,
) -> Result<Plane, Message> {
    Ok(Plane::from_normal(origin, z_axis)?)
}

/// A plane moved along its normal.
#[component(
    "3a0c7bda-3d22-4588-8bab-03f57a52a6ea",
    name = "Plane Offset",
    nick = "Pl Offset",
    at = "Vector/Plane"
)]
#[output("Plane", "Pl", "The moved plane.")]
fn plane_offset(
    /// The plane to move.
    #[port("Base Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// How far; negative against the normal.
    #[port("Offset", "O", default = 20.0)]
    offset: f64,
) -> Plane {
    plane.offset(offset)
}

/// A plane with its origin moved to a point; its axes stay.
#[component(
    "75eec078-a905-47a1-b0d2-0934182b1e3d",
    name = "Plane Origin",
    nick = "Pl Origin",
    at = "Vector/Plane"
)]
#[output("Plane", "Pl", "The plane.")]
fn plane_origin(
    /// The plane that gives the axes.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// The new origin.
    #[port("Origin", "O")]
    origin: Point3,
) -> Plane {
    base.with_origin(origin)
}

/// The plane through three points.
///
/// Points on one line are an error.
#[component("c98a6015-7a2f-423c-bc66-bdc505249b45", name = "Plane 3Pt", nick = "Pl 3Pt", at = "Vector/Plane")]
#[output("Plane", "Pl", "The plane.")]
fn plane_3pt(
    /// The origin.
    #[port("Point A", "A")]
    a: Point3,
    /// Where the x axis points.
    #[port("Point B", "B")]
    b: Point3,
    /// On which side the y axis lies.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<Plane, Message> {
    Ok(Plane::from_points(a, b, c)?)
}

/// The plane of two lines: its origin at the start of the first, its x axis along it.
///
/// The lines must cross or lie in one plane; parallel lines do too. Lines that are one line are an error.
#[component("d788ad7f-6d68-4106-8b2f-9e55e6e107c0", name = "Line + Line", nick = "LnLn", at = "Vector/Plane")]
#[output("Plane", "Pl", "The plane.")]
fn line_line(
    /// The first line.
    #[port("Line A", "A")]
    a: Line,
    /// The second line.
    #[port("Line B", "B")]
    b: Line,
) -> Result<Plane, Message> {
    match Plane::from_axes(a.from, a.direction(), b.direction()) {
        Ok(plane) => Ok(plane),
        Err(_) => Ok(Plane::from_line_and_point(&a, b.midpoint())?),
    }
}

/// The plane of a line and a point beside it: its origin at the line's start, its x axis along the line.
///
/// A point on the line is an error.
#[component("ccc3f2ff-c9f6-45f8-aa30-8a924a9bda36", name = "Line + Pt", nick = "LnPt", at = "Vector/Plane")]
#[output("Plane", "Pl", "The plane.")]
fn line_pt(
    /// The line.
    #[port("Line", "L")]
    line: Line,
    /// The point; on the side of the y axis.
    #[port("Point", "P")]
    point: Point3,
) -> Result<Plane, Message> {
    Ok(Plane::from_line_and_point(&line, point)?)
}

/// The plane that fits points best: the squares of their distances from it add up to the least.
///
/// At least three points that are not on one line. Nulls are skipped.
#[component("33bfc73c-19b2-480b-81e6-f3523a012ea6", name = "Plane Fit", nick = "PlFit", at = "Vector/Plane")]
#[output("Plane", "Pl", "The plane; its origin is the mean of the points.")]
#[output("Deviation", "dx", "The largest distance of a point from it.")]
fn plane_fit(
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<(Plane, f64), Message> {
    let points: Vec<Point3> = points.present().collect();
    Ok(Plane::fit(&points)?)
}

/// The point of a plane nearest to a point.
#[component(
    "b075c065-efda-4c9f-9cc9-288362b1b4b9",
    name = "Plane Closest Point",
    nick = "CP",
    at = "Vector/Plane"
)]
#[output("Point", "P", "The nearest point.")]
#[output("UV Point", "uv", "Its coordinates in the plane.")]
#[output("Distance", "D", "The distance; negative below the plane.")]
fn plane_closest_point(
    /// The point to project.
    #[port("Point", "S")]
    point: Point3,
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> (Point3, Point3, f64) {
    let [u, v, _] = plane.coordinates(point);
    (plane.closest_point(point), Point3::new(u, v, 0.0), plane.signed_distance(point))
}

/// The coordinates of a point in a plane.
#[component(
    "5f127fa4-ca61-418e-bb2d-e3739d900f1f",
    name = "Plane Coordinates",
    nick = "PlCoord",
    at = "Vector/Plane"
)]
#[output("X coordinate", "X", "Along the plane's x axis.")]
#[output("Y coordinate", "Y", "Along its y axis.")]
#[output("Z coordinate", "Z", "Along its normal.")]
fn plane_coordinates(
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

/// Reverses or swaps the axes of a plane. The normal follows by the right-hand rule.
#[component("c73e1ed0-82a2-40b0-b4df-8f10e445d60b", name = "Flip Plane", nick = "PFlip", at = "Vector/Plane")]
#[output("Plane", "P", "The changed plane.")]
fn flip_plane(
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Whether to reverse the x axis.
    #[port("Reverse X", "X", default = false)]
    reverse_x: bool,
    /// Whether to reverse the y axis.
    #[port("Reverse Y", "Y", default = false)]
    reverse_y: bool,
    /// Whether to swap the two, after reversing.
    #[port("Swap axes", "S", default = true)]
    swap_axes: bool,
) -> Plane {
    let mut x = if reverse_x { -plane.x_axis } else { plane.x_axis };
    let mut y = if reverse_y { -plane.y_axis } else { plane.y_axis };
    if swap_axes {
        std::mem::swap(&mut x, &mut y);
    }
    Plane { origin: plane.origin, x_axis: x, y_axis: y, z_axis: x.cross(y) }
}

/// Turns a plane about its own normal, counter-clockwise.
#[component(
    "f6f14b09-6497-4564-8403-09e4eb5a6b82",
    name = "Rotate Plane",
    nick = "PRot",
    at = "Vector/Plane"
)]
#[output("Plane", "P", "The turned plane.")]
fn rotate_plane(
    /// The plane.
    #[port("Plane", "P")]
    plane: Plane,
    /// In radians.
    #[port("Angle", "A")]
    angle: f64,
) -> Plane {
    plane.rotated(angle)
}

/// Turns a plane by the smallest rotation that gives it another normal. The origin stays.
///
/// A normal of length 0 is an error.
#[component(
    "9ce34996-d8c6-40d3-b442-1a7c8c093614",
    name = "Adjust Plane",
    nick = "PAdjust",
    at = "Vector/Plane"
)]
#[output("Plane", "P", "The turned plane.")]
fn adjust_plane(
    /// The plane.
    #[port("Plane", "P")]
    plane: Plane,
    /// The direction of the new normal.
    #[port("Normal", "N", default = Vector3::new(0.0, 0.0, 1.0))]
    normal: Vector3,
) -> Result<Plane, Message> {
    let turn = Xform::rotation_between(plane.z_axis, normal, plane.origin)?;
    Ok(plane.transformed(&turn)?)
}

/// Turns a plane about its own normal so that its x axis points as far as it can along a direction.
///
/// A direction along the normal changes nothing.
#[component(
    "e76040ec-3b91-41e1-8e00-c74c23b89391",
    name = "Align Plane",
    nick = "Align",
    at = "Vector/Plane"
)]
#[output("Plane", "P", "The turned plane.")]
#[output("Angle", "A", "By how much it was turned, counter-clockwise, in radians.")]
fn align_plane(
    /// The plane.
    #[port("Plane", "P")]
    plane: Plane,
    /// Where the x axis shall point.
    #[port("Direction", "D")]
    direction: Vector3,
) -> (Plane, f64) {
    let angle = plane.x_axis.angle_in_plane(direction, &plane).unwrap_or(0.0);
    (plane.rotated(angle), angle)
}

/// Turns each plane of a list about its own normal so that its x axis points as its predecessor's does.
#[component(
    "2318aee8-01fe-4ea8-9524-6966023fc622",
    name = "Align Planes",
    nick = "Align",
    at = "Vector/Plane"
)]
#[output("Planes", "P", "The turned planes.")]
fn align_planes(
    /// The planes, in order; nulls stay nulls.
    #[port("Planes", "P")]
    planes: List<Plane>,
    /// What the first plane is aligned with; without it the first stays as it is.
    #[port("Master", "M")]
    master: Option<Plane>,
) -> Vec<Option<Plane>> {
    let mut guide = master.map(|m: Plane| m.x_axis);
    planes
        .iter()
        .map(|plane| {
            let plane = plane?;
            let angle = guide.and_then(|g| plane.x_axis.angle_in_plane(g, &plane)).unwrap_or(0.0);
            let turned = plane.rotated(angle);
            guide = Some(turned.x_axis);
            Some(turned)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Line, Plane, Point3, Vector3};

    const P: Point3 = Point3::new(1.0, 2.0, 3.0);

    #[test]
    fn world_planes() {
        assert_eq!(Trial::of("XY Plane").item(P).texts(0), ["{0}: O(1.00,2.00,3.00) Z(0.00,0.00,1.00)"]);
        assert_eq!(Trial::of("XZ Plane").texts(0), ["{0}: O(0.00,0.00,0.00) Z(0.00,-1.00,0.00)"]);
        assert_eq!(Trial::of("YZ Plane").texts(0), ["{0}: O(0.00,0.00,0.00) Z(1.00,0.00,0.00)"]);
    }

    fn axes(trial: Trial, output: usize) -> [String; 4] {
        let tree = trial.run().outputs[output].clone();
        let text = |k| Trial::of("Deconstruct Plane").tree(tree.clone()).texts(k).join(" ");
        [0, 1, 2, 3].map(|k| text(k).replace("-0,", "0,").replace("-0}", "0}"))
    }

    #[test]
    fn from_axes_points_and_lines() {
        let made = Trial::of("Construct Plane").item(P).item(Vector3::Y).item(Vector3::new(-3.0, 1.0, 0.0));
        assert_eq!(axes(made, 0), ["{0}: {1, 2, 3}", "{0}: {0, 1, 0}", "{0}: {-1, 0, 0}", "{0}: {0, 0, 1}"]);
        let flat = Trial::of("Construct Plane").item(P).item(Vector3::Y).item(Vector3::Y);
        assert!(!flat.message().is_empty());
        let normal = Trial::of("Plane Normal").item(P).item(Vector3::Z * 2.0);
        assert_eq!(axes(normal, 0)[1], "{0}: {1, 0, 0}");
        let o = Point3::ORIGIN;
        let (x, y) = (Point3::new(2.0, 0.0, 0.0), Point3::new(1.0, 3.0, 0.0));
        assert_eq!(axes(Trial::of("Plane 3Pt").item(o).item(x).item(y), 0)[2], "{0}: {0, 1, 0}");
        let lines = Trial::of("Line + Line").item(Line::new(o, x)).item(Line::new(o, y));
        assert_eq!(axes(lines, 0)[3], "{0}: {0, 0, 1}");
        let parallel = Trial::of("Line + Line").item(Line::new(o, x)).item(Line::new(y, y + Vector3::X));
        assert_eq!(axes(parallel, 0)[3], "{0}: {0, 0, 1}");
        assert_eq!(axes(Trial::of("Line + Pt").item(Line::new(o, x)).item(y), 0)[3], "{0}: {0, 0, 1}");
    }

    #[test]
    fn moved_and_turned() {
        assert_eq!(axes(Trial::of("Plane Offset").item(Plane::XY).item(5.0), 0)[0], "{0}: {0, 0, 5}");
        assert_eq!(axes(Trial::of("Plane Origin").item(Plane::XZ).item(P), 0)[0], "{0}: {1, 2, 3}");
        assert_eq!(axes(Trial::of("Flip Plane").item(Plane::XY), 0)[3], "{0}: {0, 0, -1}");
        let reversed = Trial::of("Flip Plane").item(Plane::XY).item(true).item(false).item(false);
        assert_eq!(axes(reversed, 0)[1], "{0}: {-1, 0, 0}");
        assert_eq!(axes(Trial::of("Adjust Plane").item(Plane::XY).item(Vector3::X), 0)[3], "{0}: {1, 0, 0}");
        let aligned = || Trial::of("Align Plane").item(Plane::XY).item(Vector3::new(0.0, -2.0, 9.0));
        assert_eq!(axes(aligned(), 0)[1], "{0}: {0, -1, 0}");
        assert_eq!(aligned().texts(1), ["{0}: 4.712389"]);
        let turned = Trial::of("Rotate Plane").item(Plane::XY).item(FRAC_PI_2);
        assert_eq!(axes(turned, 0)[1], "{0}: {0, 1, 0}");
        let row = Trial::of("Align Planes").list([Plane::XY, Plane::XY.rotated(1.0)]);
        assert_eq!(axes(row, 0)[1], "{0;0}: {1, 0, 0}, {1, 0, 0}");
    }

    #[test]
    fn points_and_planes() {
        let corners = [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0], [4.0, 4.0, 1.0]].map(Point3::from);
        let fit = || Trial::of("Plane Fit").list(corners);
        assert_eq!(fit().texts(1), ["{0}: 0"]);
        assert_eq!(axes(fit(), 0)[0], "{0}: {2, 2, 1}");
        let near = || Trial::of("Plane Closest Point").item(P).item(Plane::XZ);
        assert_eq!(near().texts(0), ["{0}: {1, 0, 3}"]);
        assert_eq!(near().texts(1), ["{0}: {1, 3, 0}"]);
        assert_eq!(near().texts(2), ["{0}: -2"]);
        assert_eq!(Trial::of("Plane Coordinates").item(P).item(Plane::XZ).texts(2), ["{0}: -2"]);
    }
}
