//! Texts, text dots and hatches of a Rhino model.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Plane, Point3};

use crate::annotations::{hatch, hatch_object, text_dot, text_object, writing};
use crate::human::regions;

/// The height of a text dot where none is given, in points of the screen: that of new ones in Rhino.
const DOT: i32 = 14;

/// A text on a plane as an object that can be baked. Stands for EleFront's Define Text Object. Styles of annotations are not
/// supported: it has the model's own.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd231",
    name = "Define Text Object",
    nick = "Text",
    at = "EleFront/04 Annotations"
)]
#[output("Text", "T", "The text.", kind = Generic)]
fn define_text(
    context: &Context<'_>,
    /// The words.
    #[port("Text", "T")]
    text: Arc<str>,
    /// The plane: along its x axis, letters upright along y.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Not supported.
    #[port("Dimension Style", "[]DS", optional)]
    style: Option<Arc<str>>,
) -> Result<Value, Message> {
    if style.is_some() {
        context
            .tell(Message::remark("Styles of annotations are not supported: the text has the model's own"));
    }
    context.bytes(text.len())?;
    text_object(&text, &plane)
}

/// A text dot as an object that can be baked: a text that faces the viewer. Stands for EleFront's Define Text Dot.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd232",
    name = "Define Text Dot",
    nick = "TextDot",
    at = "EleFront/04 Annotations"
)]
#[output("TextDot", "T", "The dot.", kind = Generic)]
fn define_dot(
    context: &Context<'_>,
    /// The words.
    #[port("Text", "T")]
    text: Arc<str>,
    /// Where it is.
    #[port("Location", "P")]
    at: Point3,
    /// The name of the font.
    #[port("Font", "F", optional)]
    font: Option<Arc<str>>,
    /// The height in points of the screen, at least 1.
    #[port("Size", "S", default = DOT)]
    size: i32,
) -> Result<Value, Message> {
    context.bytes(text.len())?;
    text_dot(&text, at, font.as_deref(), size)
}

/// A text dot as an object that can be baked. Stands for EleFront's Create Text Dot, an earlier name of Define Text Dot.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd233",
    name = "Create Text Dot",
    nick = "Create Text Dot",
    at = "EleFront/04 Annotations"
)]
#[output("G", "G", "The dot.", kind = Generic)]
fn create_dot(
    context: &Context<'_>,
    /// The words.
    #[port("T", "T")]
    text: Arc<str>,
    /// Where it is.
    #[port("P", "P")]
    at: Point3,
    /// The name of the font.
    #[port("F", "F", optional)]
    font: Option<Arc<str>>,
    /// The height in points of the screen, at least 1.
    #[port("S", "S", default = DOT)]
    size: i32,
) -> Result<Value, Message> {
    context.bytes(text.len())?;
    text_dot(&text, at, font.as_deref(), size)
}

/// The words, the plane and the alignment of a text of the model. Stands for EleFront's Deconstruct Text. The height is one of its
/// style, which is not read: it is null.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd234",
    name = "Deconstruct Text",
    nick = "DeText",
    at = "EleFront/04 Annotations"
)]
#[output("Text", "T", "The words, without formatting.")]
#[output("Plane", "P", "The plane it lies in.")]
#[output("Height", "H", "Null; not supported.")]
#[output("Justification", "J", "Which part of it is at the plane's origin, as Rhino has it: BottomLeft.", kind = Text)]
fn deconstruct_text(
    /// The text.
    #[port("Text Object", "T")]
    object: Value,
) -> Result<(Arc<str>, Plane, Option<f64>, Arc<str>), Message> {
    let found = writing(&object)?;
    Ok((found.text.into(), found.plane, None, found.alignment.word().into()))
}

/// A component that makes a hatch.
macro_rules! hatches {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $pattern:literal, $out:literal) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "EleFront/04 Annotations")]
        #[output("Hatch", $out, "The hatch.", kind = Generic)]
        fn $function(
            context: &Context<'_>,
            /// The curve around it, closed and planar.
            #[port("Curve", "C")]
            boundary: Arc<Curve>,
            /// The pattern; only `Solid` is supported.
            #[port("Pattern", $pattern, default = "Solid")]
            pattern: Arc<str>,
            /// How far the pattern is turned, in degrees.
            #[port("Rotation", "R", default = 0.0)]
            rotation: f64,
            /// What the lengths of the pattern are multiplied by, above 0.
            #[port("Scale", "S", default = 1.0)]
            scale: f64,
        ) -> Result<Value, Message> {
            if !pattern.trim().eq_ignore_ascii_case("solid") {
                context.warn("There is no table of patterns: the hatch is solid");
            }
            hatch_object(&boundary, rotation.to_radians(), scale, context.tolerance().absolute)
        }
    };
}

hatches!(
    /// A hatch inside a curve as an object that can be baked. There is no table of patterns: the hatch is solid, and keeps the turn and
    /// the scale for a pattern that it is given later. Stands for EleFront's Define Hatch.
    define_hatch, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd235", "Define Hatch", "Hatch", "[]P", "H"
);

hatches!(
    /// A hatch inside a curve as an object that can be baked. There is no table of patterns: the hatch is solid, and keeps the turn and
    /// the scale for a pattern that it is given later. Stands for EleFront's Create Hatch, an earlier name of Define Hatch.
    create_hatch, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd236", "Create Hatch", "Create Hatch", "P", "G"
);

/// The inside of a hatch of the model as surfaces, the curves around it, and its pattern's scale and turn. Stands for EleFront's
/// Deconstruct Hatch. The name of the pattern is not supported: it is null, and the inside is that of a solid hatch.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd237",
    name = "Deconstruct Hatch",
    nick = "DeHatch",
    at = "EleFront/04 Annotations"
)]
#[output("Hatch Geometry", "C", "Its inside as surfaces.", kind = Geometry)]
#[output("Boundary", "B", "The curves around it.")]
#[output("Name", "N", "Null; not supported.")]
#[output("Scale", "S", "What the lengths of the pattern are multiplied by.")]
#[output("Rotation", "R", "The turn of the pattern in degrees.")]
fn deconstruct_hatch(
    context: &Context<'_>,
    /// The hatch.
    #[port("Hatch", "H")]
    object: Value,
) -> Result<(Vec<Value>, Vec<Arc<Curve>>, Option<Arc<str>>, f64, f64), Message> {
    let (hatch, curves) = hatch(&object)?;
    let inside = regions(context, &curves)?;
    let curves = curves.into_iter().map(Arc::new).collect();
    Ok((inside, curves, None, hatch.scale, hatch.rotation.to_degrees()))
}

/// A text on a plane as an object that can be baked, in the model's own style of annotations. Stands for EleFront's Create Text, an
/// earlier name of Define Text Object; sizes and fonts are those of the style.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd238",
    name = "Create Text",
    nick = "Create Text",
    at = "EleFront/04 Annotations"
)]
#[output("Text", "G", "The text.", kind = Generic)]
fn create_text(
    context: &Context<'_>,
    /// The words.
    #[port("Text", "T")]
    text: Arc<str>,
    /// The plane: along its x axis, letters upright along y.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Not supported.
    #[port("Size", "S", optional)]
    size: Option<f64>,
    /// Not supported.
    #[port("Font", "F", optional)]
    font: Option<Arc<str>>,
) -> Result<Value, Message> {
    if size.is_some() || font.is_some() {
        context
            .tell(Message::remark("Sizes and fonts are not supported: the text has the model's own style"));
    }
    context.bytes(text.len())?;
    text_object(&text, &plane)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Circle, Curve, Line, MeshSettings, Plane, Point3};

    #[test]
    fn a_text_is_made_and_taken_apart() {
        let at = Plane::XY.with_origin(Point3::new(0.0, 0.0, 4.0));
        let made = Trial::of("Define Text Object").item("two\nlines").item(at).run();
        assert!(made.messages.is_empty(), "{:?}", made.messages);
        let told = |k: usize| Trial::of("Deconstruct Text").tree(made.outputs[0].clone()).texts(k);
        assert_eq!(told(0), ["{0}: two\nlines"]);
        assert_eq!(told(2), ["{0}: null"]);
        assert_eq!(told(3), ["{0}: BottomLeft"]);
        let styled = Trial::of("Define Text Object").item("a").default().item("Large");
        assert!(styled.message().starts_with("Styles of annotations are not supported"));
    }

    #[test]
    fn a_dot_is_made_and_taken_apart() {
        for name in ["Define Text Dot", "Create Text Dot"] {
            let dot = |size: i32| {
                Trial::of(name).item("door").item(Point3::new(1.0, 2.0, 3.0)).item("Arial").item(size)
            };
            let told =
                |k: usize| Trial::of("Deconstruct Text").tree(dot(9).run().outputs[0].clone()).texts(k);
            assert_eq!(
                (told(0), told(3)),
                (vec!["{0}: door".to_owned()], vec!["{0}: MiddleCenter".to_owned()])
            );
            assert_eq!(dot(0).message(), "The size is 0: it must be at least 1");
        }
        let none = Trial::of("Deconstruct Text").item(Point3::ORIGIN).message();
        assert_eq!(none, "A Point is no text of a model");
    }

    #[test]
    fn a_hatch_is_made_and_taken_apart() {
        let at = Plane::XY.with_origin(Point3::new(0.0, 3.0, 5.0));
        let ring = || Curve::from(Circle { plane: at, radius: 2.0 });
        for name in ["Define Hatch", "Create Hatch"] {
            let hatch =
                |pattern: &str, scale: f64| Trial::of(name).item(ring()).item(pattern).item(90.0).item(scale);
            let made = hatch("Solid", 3.0).run();
            assert!(made.messages.is_empty(), "{:?}", made.messages);
            let out = Trial::of("Deconstruct Hatch").tree(made.outputs[0].clone()).run().outputs;
            assert_eq!((texts(&out[2]), texts(&out[3])), (vec!["{0}: null".into()], vec!["{0}: 3".into()]));
            assert_eq!(texts(&out[4]), ["{0}: 90"]);
            let Some(Value::Curve(edge)) = out[1].column().get(0) else { panic!("a curve") };
            assert!((edge.length() - 4.0 * std::f64::consts::PI).abs() < 1e-9);
            assert!((edge.start().z - 5.0).abs() < 1e-12);
            let Some(Value::Brep(inside)) = out[0].column().get(0) else { panic!("a surface") };
            let area = inside.mesh(&MeshSettings::within(1e-4)).unwrap().to_mesh().unwrap().area();
            assert!((area - 4.0 * std::f64::consts::PI).abs() < 1e-3);
            assert!(hatch("Grid", 1.0).message().contains("the hatch is solid"));
            assert!(hatch("Solid", 0.0).message().contains("multiplied by 0"));
            assert!(hatch("Solid", f64::NAN).message().contains("multiplied by NaN"));
            let open = Trial::of(name).item(Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)));
            assert_eq!(open.message(), "The boundary is not closed");
        }
        let none = Trial::of("Deconstruct Hatch").item(Point3::ORIGIN).message();
        assert_eq!(none, "A Point is no hatch");
    }

    #[test]
    fn an_earlier_text() {
        let made = Trial::of("Create Text").item("north").item(Plane::XY).run();
        assert!(made.messages.is_empty(), "{:?}", made.messages);
        assert_eq!(Trial::of("Deconstruct Text").tree(made.outputs[0].clone()).texts(0), ["{0}: north"]);
        let sized = Trial::of("Create Text").item("north").default().item(3.0);
        assert!(sized.message().starts_with("Sizes and fonts are not supported"));
    }
}
