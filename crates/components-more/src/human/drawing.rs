//! Hatches, texts of the model, and maps between boxes.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Box3, Brep, Curve, Interval, Plane, Point3, Vector3, Xform};

use crate::annotations::{hatch, writing};

/// The plane regions that closed curves bound, those inside others as holes.
pub(crate) fn regions(context: &Context<'_>, curves: &[Curve]) -> Result<Vec<Value>, Message> {
    let found = Brep::planar_breps(curves, &context.tolerance())?;
    if !found.left.is_empty() {
        let count = found.left.len();
        context.warn(format!(
            "Curves that are not planar, not closed, or enclose nothing are left out: {count}"
        ));
    }
    context.items(found.breps.len())?;
    Ok(found.breps.into_iter().map(Value::from).collect())
}

/// The inside of closed curves as surfaces; curves inside others are holes. Stands for Human's Create Hatch. There is no table of
/// patterns, so each hatch is solid, as Human makes those whose pattern it does not find; it is baked as geometry, with Bake Geometry.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd351",
    name = "CreateHatch",
    nick = "CreateHatch",
    at = "Human/Creation"
)]
#[output("geo", "geo", "The surfaces.", kind = Geometry)]
fn create_hatch(
    context: &Context<'_>,
    /// Whether to bake, which is not supported.
    #[port("Bake?", "bake", default = false)]
    bake: bool,
    /// The curves, all together.
    #[port("Curves", "crv")]
    curves: List<Shared<Curve>>,
    /// The pattern; only `Solid` is supported.
    #[port("Hatch Pattern Name", "name", default = "Solid")]
    names: List<Shared<str>>,
    /// Not used: a solid hatch has no scale.
    #[port("Hatch Scale", "scale", default = 1.0)]
    _scales: List<f64>,
    /// Not used: a solid hatch has no direction.
    #[port("Hatch Rotation", "rot", default = 0.0)]
    _rotations: List<f64>,
    /// Not used: hatches are not baked.
    #[port("Attributes", "att", optional)]
    _attributes: List<Value>,
) -> Result<Vec<Value>, Message> {
    if bake {
        context.tell(Message::remark("The hatch is not baked: bake its surfaces"));
    }
    if names.present().any(|name| !name.trim().eq_ignore_ascii_case("solid")) {
        context.warn("There is no table of patterns: the hatch is solid");
    }
    let curves: Vec<Curve> = curves.present().map(|curve| (*curve).clone()).collect();
    regions(context, &curves)
}

/// The curves around a hatch of the model, its pattern's scale and turn, and its inside as surfaces. Stands for Human's Hatch Explode.
/// The name of the pattern is not supported: it is null, and the inside is that of a solid hatch.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd352",
    name = "Hatch Explode",
    nick = "HatchExp",
    at = "Human/Reference"
)]
#[output("curves", "curves", "The curves around it.")]
#[output("name", "name", "Null; not supported.")]
#[output("scale", "scale", "What the pattern's lengths are multiplied by.")]
#[output("rot", "rot", "The turn of the pattern in radians.")]
#[output("exp", "exp", "Its inside as surfaces.", kind = Geometry)]
fn hatch_explode(
    context: &Context<'_>,
    /// The hatch.
    #[port("Hatch", "hatch")]
    object: Value,
) -> Result<(Vec<Shared<Curve>>, Option<Shared<str>>, f64, f64, Vec<Value>), Message> {
    let (hatch, curves) = hatch(&object)?;
    let inside = regions(context, &curves)?;
    let curves = curves.into_iter().map(Shared::new).collect();
    Ok((curves, None, hatch.scale, hatch.rotation, inside))
}

/// The plane, the words and the alignment of a text of the model. Stands for Human's Text Object Info. The height is one of its style,
/// which is not read: it is null.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd353",
    name = "Text Object Info",
    nick = "TxtObjInfo",
    at = "Human/Reference"
)]
#[output("L", "L", "The plane it lies in.")]
#[output("T", "T", "The text, without formatting.")]
#[output("S", "S", "Null: the height is not supported.")]
#[output("A", "A", "0 left, 1 centre, 2 right.")]
#[output("VA", "VA", "0 bottom, 1 middle, 2 top.")]
fn text_info(
    /// The text.
    #[port("Text Objects", "txtObj")]
    object: Value,
) -> Result<(Plane, Shared<str>, Option<f64>, i32, i32), Message> {
    let found = writing(&object)?;
    Ok((found.plane, found.text.into(), None, found.alignment.across, found.alignment.up))
}

/// The map that carries one box to another, and stretches what it carries as their sides differ. Stands for Human's Box2BoxXform; the
/// names of its ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd354",
    name = "Box2BoxXform",
    nick = "Box2Box",
    at = "Human/Misc"
)]
#[output("Transform", "X", "The map.")]
fn box_to_box(
    /// The box it starts from.
    #[port("Source Box", "S")]
    source: Box3,
    /// The box it leads to.
    #[port("Target Box", "T")]
    target: Box3,
) -> Result<Xform, Message> {
    let back = frame(&source).inverse().ok_or_else(|| Message::error("The source has no extent"))?;
    Ok(frame(&target) * back)
}

/// The map of the unit cube onto a box; sides of no length count as 1, so that what is flat stays flat.
fn frame(of: &Box3) -> Xform {
    let side =
        |range: Interval, axis: Vector3| axis * if range.length() == 0.0 { 1.0 } else { range.length() };
    let corner: Point3 = of.plane.at(of.x.start, of.y.start, of.z.start);
    let plane = &of.plane;
    Xform::from_columns(side(of.x, plane.x_axis), side(of.y, plane.y_axis), side(of.z, plane.z_axis), corner)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_3dm::{CurveForm, Hatch, HatchLoop, Object, StoredPlane};
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Box3, Circle, Curve, Interval, Line, MeshSettings, Plane, Point2, Point3};

    fn ring(radius: f64) -> Curve {
        Circle { plane: Plane::XY, radius }.into()
    }

    /// The area of surfaces, from their meshes.
    fn area(surfaces: &katydid_data::Tree) -> f64 {
        let of = |value: Value| match value {
            Value::Brep(brep) => brep.mesh(&MeshSettings::within(1e-4)).unwrap().to_mesh().unwrap().area(),
            other => panic!("{other:?}"),
        };
        (0..surfaces.item_count()).filter_map(|at| surfaces.column().get(at)).map(of).sum()
    }

    #[test]
    fn curves_are_filled() {
        let filled = |name: &str| Trial::of("CreateHatch").default().list([ring(2.0), ring(1.0)]).item(name);
        let solid = filled("Solid").run();
        assert!(solid.messages.is_empty(), "{:?}", solid.messages);
        assert!((area(&solid.outputs[0]) - 3.0 * PI).abs() < 1e-3);
        assert!(filled("Grid").message().contains("the hatch is solid"));
        let open = Trial::of("CreateHatch").default();
        let open = open.item(Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)));
        assert!(open.message().contains("left out: 1"));
    }

    #[test]
    fn a_hatch_is_taken_apart() {
        let outer = HatchLoop { outer: true, curve: CurveForm::of(&ring(2.0), 2) };
        let hatch = Hatch {
            plane: StoredPlane::from(Plane::XY.with_origin(Point3::new(0.0, 0.0, 5.0))),
            scale: 3.0,
            rotation: 0.5,
            pattern: -1,
            loops: vec![outer],
            base_point: Point2::ORIGIN,
        };
        let value = Value::from_object(Object::Hatch(Box::new(hatch)), &[]).unwrap();
        let out = Trial::of("Hatch Explode").item(value).run();
        assert!(out.messages.is_empty(), "{:?}", out.messages);
        assert_eq!(texts(&out.outputs[2]), ["{0}: 3"]);
        assert_eq!(texts(&out.outputs[3]), ["{0}: 0.5"]);
        let Some(Value::Curve(edge)) = out.outputs[0].column().get(0) else { panic!("a curve") };
        assert!((edge.length() - 4.0 * PI).abs() < 1e-9);
        assert_eq!(edge.start().z, 5.0);
        assert!((area(&out.outputs[4]) - 4.0 * PI).abs() < 1e-3);
        assert_eq!(Trial::of("Hatch Explode").item(Point3::ORIGIN).message(), "A Point is no hatch");
    }

    #[test]
    fn a_text_is_taken_apart() {
        let at = Plane::XY.with_origin(Point3::new(1.0, 2.0, 3.0));
        let made = Trial::of("Define Text Object").item("door").item(at).run().outputs[0].clone();
        let told = |k: usize| Trial::of("Text Object Info").tree(made.clone()).texts(k);
        assert_eq!(told(1), ["{0}: door"]);
        assert_eq!((told(3), told(4)), (vec!["{0}: 0".to_owned()], vec!["{0}: 0".to_owned()]));
        let info = Trial::of("Text Object Info").tree(made.clone()).run();
        let Some(Value::Plane(plane)) = info.outputs[0].column().get(0) else { panic!("a plane") };
        assert_eq!(plane.origin, Point3::new(1.0, 2.0, 3.0));
        assert_eq!(
            Trial::of("Text Object Info").item(Point3::ORIGIN).message(),
            "A Point is no text of a model"
        );
    }

    #[test]
    fn a_box_is_carried_to_another() {
        let of = |size: f64| Box3 {
            plane: Plane::XY,
            x: Interval::new(0.0, size),
            y: Interval::new(0.0, 1.0),
            z: Interval::new(0.0, 1.0),
        };
        let map = Trial::of("Box2BoxXform").item(of(2.0)).item(of(6.0)).run().outputs[0].clone();
        let map = map.column().get(0).and_then(|map| map.as_transform()).unwrap();
        assert_eq!(map.point(Point3::new(1.0, 0.5, 0.25)), Point3::new(3.0, 0.5, 0.25));
    }
}
