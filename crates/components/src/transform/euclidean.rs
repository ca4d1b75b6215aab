//! Transform / Euclidean: maps that keep distances.

use std::f64::consts::FRAC_PI_2;

use katydid_component::{Call, Context, Message, Outcome, component, whole};
use katydid_data::{Geometry, Value};
use katydid_geometry::{Line, Plane, Point3, Vector3, Xform};

use super::{around, transformed};
use crate::vector::hit;

/// Moves geometry along a vector.
#[component(
    "e9eb1dcf-92f6-4d4d-84ae-96222d60f56b",
    name = "Move",
    nick = "Move",
    at = "Transform/Euclidean",
    also("b40f28a2-ba30-4ac2-afe5-a6ece7f985fc"),
    columns = move_points
)]
#[output("Geometry", "G", "The moved geometry.")]
#[output("Transform", "X", "The movement as a transform.", kind = Transform)]
fn move_geometry(
    context: &Context<'_>,
    /// What to move.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// How far and where to.
    #[port("Motion", "T", default = Vector3::new(0.0, 0.0, 10.0))]
    motion: Vector3,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, Xform::translation(motion))
}

/// Points by one motion, when nobody reads the transforms.
fn move_points(call: &Call<'_>) -> Option<Outcome> {
    let motion = whole::constant::<Vector3>(call, 1).filter(|v| v.is_finite())?;
    if call.wanted.get(1).copied().unwrap_or(true) {
        return None;
    }
    whole::map(call, |&point: &Point3| Some(point + motion))
}

/// Turns geometry in a plane, counter-clockwise about its origin.
#[component(
    "b7798b74-037e-4f0c-8ac7-dc1043d093e0",
    name = "Rotate",
    nick = "Rotate",
    at = "Transform/Euclidean",
    also("b661519d-43fd-4e5a-b244-d54d9fae2bde")
)]
#[output("Geometry", "G", "The turned geometry.")]
#[output("Transform", "X", "The rotation as a transform.", kind = Transform)]
fn rotate(
    context: &Context<'_>,
    /// What to turn.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// In radians.
    #[port("Angle", "A", default = FRAC_PI_2)]
    angle: f64,
    /// The plane to turn in.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, Xform::rotation(angle, plane.z_axis, plane.origin)?)
}

/// Turns geometry about an axis through a point, by the right-hand rule.
#[component(
    "3dfb9a77-6e05-4016-9f20-94f78607d672",
    name = "Rotate 3D",
    nick = "Rot3D",
    at = "Transform/Euclidean",
    also("955d887b-c83b-4c61-bf35-df5d4c4abd9b")
)]
#[output("Geometry", "G", "The turned geometry.")]
#[output("Transform", "X", "The rotation as a transform.", kind = Transform)]
fn rotate_3d(
    context: &Context<'_>,
    /// What to turn.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// In radians.
    #[port("Angle", "A", default = FRAC_PI_2)]
    angle: f64,
    /// A point of the axis.
    #[port("Center", "C", default = Point3::ORIGIN)]
    center: Point3,
    /// The direction of the axis; not zero.
    #[port("Axis", "X", default = Vector3::new(0.0, 0.0, 1.0))]
    axis: Vector3,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, Xform::rotation(angle, axis, center)?)
}

/// Turns geometry about a line, by the right-hand rule from its start to its end.
#[component(
    "3ac8e589-37f5-477d-aa61-6699702c5728",
    name = "Rotate Axis",
    nick = "RotAx",
    at = "Transform/Euclidean",
    also("55959599-0b44-4333-8427-a73564ea7ffb")
)]
#[output("Geometry", "G", "The turned geometry.")]
#[output("Transform", "X", "The rotation as a transform.", kind = Transform)]
fn rotate_axis(
    context: &Context<'_>,
    /// What to turn.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// In radians.
    #[port("Angle", "A", default = FRAC_PI_2)]
    angle: f64,
    /// The line; not of length 0.
    #[port("Axis", "X", default = Line::new(Point3::ORIGIN, Point3::new(10.0, 0.0, 0.0)))]
    axis: Line,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, Xform::rotation(angle, axis.direction(), axis.from)?)
}

/// Turns geometry about the line through two points, by the right-hand rule.
#[component(
    "bef50d22-e6b3-45fd-b7be-1c501502186b",
    name = "Rotate Axis [OBSOLETE]",
    nick = "RotAx",
    at = "Transform/Euclidean"
)]
#[output("Geometry", "G", "The turned geometry.")]
fn rotate_axis_by_points(
    /// What to turn.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// In radians.
    #[port("Angle", "A", default = FRAC_PI_2)]
    angle: f64,
    /// A point of the axis.
    #[port("Start", "S")]
    start: Point3,
    /// Another point of the axis.
    #[port("End", "E")]
    end: Point3,
) -> Result<Option<Geometry>, Message> {
    let turn = Xform::rotation(angle, end - start, start)?;
    Ok(geometry.map(|g| g.0.transformed(&turn).map(Geometry)).transpose()?)
}

/// Turns geometry about a point by the smallest rotation that takes one direction to another.
#[component(
    "5edaea74-32cb-4586-bd72-66694eb73160",
    name = "Rotate Direction",
    nick = "Rotate",
    at = "Transform/Euclidean"
)]
#[output("Geometry", "G", "The turned geometry.")]
#[output("Transform", "X", "The rotation as a transform.", kind = Transform)]
fn rotate_direction(
    context: &Context<'_>,
    /// What to turn.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The point that stays.
    #[port("Center", "C", default = Point3::ORIGIN)]
    center: Point3,
    /// The direction to turn; not zero.
    #[port("From", "F")]
    from: Vector3,
    /// Where it shall point; not zero.
    #[port("To", "T")]
    to: Vector3,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, Xform::rotation_between(from, to, center)?)
}

/// Reflects geometry in a plane.
#[component(
    "f12daa2f-4fd5-48c1-8ac3-5dea476912ca",
    name = "Mirror",
    nick = "Mirror",
    at = "Transform/Euclidean",
    also("a70bdac1-1ed2-40d3-b687-3437bc150af0")
)]
#[output("Geometry", "G", "The mirror image.")]
#[output("Transform", "X", "The reflection as a transform.", kind = Transform)]
fn mirror(
    context: &Context<'_>,
    /// What to reflect.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The mirror.
    #[port("Plane", "P", default = Plane::YZ)]
    plane: Plane,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, Xform::mirror(&plane))
}

/// Carries geometry from one plane to another: what it was to the first plane it becomes to the second.
#[component(
    "378d0690-9da0-4dd1-ab16-1d15246e7c22",
    name = "Orient",
    nick = "Orient",
    at = "Transform/Euclidean",
    also("a35811bc-1034-4491-acb8-608a8cfa27b1")
)]
#[output("Geometry", "G", "The carried geometry.")]
#[output("Transform", "X", "The movement as a transform.", kind = Transform)]
fn orient(
    context: &Context<'_>,
    /// What to carry.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The plane it is seen from.
    #[port("Source", "A", default = Plane::XY)]
    source: Plane,
    /// The plane it goes to.
    #[port("Target", "B", default = Plane::XY)]
    target: Plane,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    transformed(context, geometry, Xform::plane_to_plane(&source, &target))
}

/// Moves geometry straight away from other geometry: from the emitter's point nearest to its middle.
///
/// Geometry whose middle lies on the emitter has no way to go: it stays where it is, with a warning.
#[component(
    "dd9f597a-4db0-42b1-9cb2-5607ec97db09",
    name = "Move Away From",
    nick = "MoveAway",
    at = "Transform/Euclidean"
)]
#[output("Geometry", "G", "The moved geometry.")]
#[output("Transform", "X", "The movement as a transform.", kind = Transform)]
fn move_away_from(
    context: &Context<'_>,
    /// What to move.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// What to move away from.
    #[port("Emitter", "E")]
    emitter: Geometry,
    /// How far; negative towards the emitter.
    #[port("Distance", "D", default = 10.0)]
    distance: f64,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    let nothing = || Message::error("There is nothing to measure the direction from");
    let middle = around(&geometry.0, &Plane::XY).ok_or_else(nothing)?.center();
    let from = hit::closest(context, &emitter.0, middle)?.ok_or_else(nothing)?;
    let motion = (middle - from).with_length(distance).unwrap_or_else(|| {
        context.warn("The geometry lies on the emitter: no way leads away");
        Vector3::ZERO
    });
    transformed(context, Some(geometry), Xform::translation(motion))
}

/// Moves geometry along a plane's normal until it touches the plane.
#[component(
    "4fe87ef8-49e4-4605-9859-87940d62e1de",
    name = "Move To Plane",
    nick = "MoveToPlane",
    at = "Transform/Euclidean"
)]
#[output("Geometry", "G", "The moved geometry.")]
#[output("Transform", "X", "The movement as a transform.", kind = Transform)]
fn move_to_plane(
    context: &Context<'_>,
    /// What to move.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Whether to move what lies above the plane.
    #[port("Above", "A", default = true)]
    above: bool,
    /// Whether to move what lies below it.
    #[port("Below", "B", default = true)]
    below: bool,
) -> Result<(Option<Geometry>, Option<Value>), Message> {
    let extent = around(&geometry.0, &plane).ok_or_else(|| Message::error("This geometry has no extent"))?;
    let rise = match (extent.z.min(), extent.z.max()) {
        (lowest, _) if lowest > 0.0 && above => -lowest,
        (_, highest) if highest < 0.0 && below => -highest,
        _ => 0.0,
    };
    transformed(context, Some(geometry), Xform::translation(plane.z_axis * rise))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Line, Plane, Point3, Vector3};

    const P: Point3 = Point3::new(1.0, 2.0, 3.0);

    #[test]
    fn movements() {
        assert_eq!(Trial::of("Move").item(P).texts(0), ["{0}: {1, 2, 13}"]);
        assert_eq!(Trial::of("Move").item(P).item(Vector3::X).texts(0), ["{0}: {2, 2, 3}"]);
        assert_eq!(
            Trial::of("Move").tree(katydid_data::Tree::empty()).item(Vector3::X).texts(1),
            ["{0}: Transform"]
        );
        let turned = |name| Trial::of(name).item(P).item(PI);
        assert_eq!(turned("Rotate").texts(0), ["{0}: {-1, -2, 3}"]);
        assert_eq!(turned("Rotate 3D").item(Point3::ORIGIN).item(Vector3::X).texts(0), ["{0}: {1, -2, -3}"]);
        assert_eq!(turned("Rotate Axis").texts(0), ["{0}: {1, -2, -3}"]);
        let by_points = Trial::of_guid("bef50d22-e6b3-45fd-b7be-1c501502186b").item(P).item(PI);
        let by_points = by_points.item(Point3::ORIGIN).item(Point3::new(0.0, 0.0, 1.0));
        assert_eq!(by_points.texts(0), ["{0}: {-1, -2, 3}"]);
        let direction = Trial::of("Rotate Direction").item(P).default().item(Vector3::X).item(Vector3::Y);
        assert_eq!(direction.texts(0), ["{0}: {-2, 1, 3}"]);
        assert_eq!(Trial::of("Mirror").item(P).texts(0), ["{0}: {-1, 2, 3}"]);
        let oriented = Trial::of("Orient").item(P).item(Plane::XY).item(Plane::YZ.offset(1.0));
        assert_eq!(oriented.texts(0), ["{0}: {4, 1, 2}"]);
    }

    #[test]
    fn away_and_down() {
        let away = Trial::of("Move Away From").item(P).item(Point3::new(1.0, 2.0, 0.0)).item(4.0);
        assert_eq!(away.texts(0), ["{0}: {1, 2, 7}"]);
        assert!(Trial::of("Move Away From").item(P).item(P).message().contains("no way"));
        let line = Line::new(P, P + Vector3::Z);
        let down = Trial::of("Move To Plane").item(line).item(Plane::XY);
        let end = Trial::of("Distance").item(Point3::new(1.0, 2.0, 1.0));
        let moved = down.run().outputs[0].clone();
        let katydid_data::Value::Line(moved) = moved.column().get(0).unwrap() else { panic!("a line") };
        assert_eq!(end.item(moved.to).texts(0), ["{0}: 0"]);
        let stays = Trial::of("Move To Plane").item(P).item(Plane::XY).item(false);
        assert_eq!(stays.texts(0), ["{0}: {1, 2, 3}"]);
    }

    #[test]
    fn nulls_stay_in_place() {
        assert_eq!(Trial::of("Move").gaps([None, Some(P)]).texts(0), ["{0}: null, {1, 2, 13}"]);
    }
}
