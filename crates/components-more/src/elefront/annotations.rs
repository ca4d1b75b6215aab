//! Texts and text dots of a Rhino model.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Plane, Point3};

use crate::annotations::{text_dot, text_object, writing};

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

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Plane, Point3};

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
}
