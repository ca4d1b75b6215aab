//! Texts, text dots and hatches of a Rhino model: made, and taken apart.

use katydid_3dm::{
    Annotation, AnnotationKind, CurveForm, Hatch, HatchLoop, Limits, Object, StoredPlane, TextContent,
    TextDot,
};
use katydid_component::Message;
use katydid_component::parts::Uuid;
use katydid_data::{Content, Value};
use katydid_geometry::{Curve, Plane, Point2, Point3, Vector2, Xform};

use crate::model_objects::type_name;

/// The pattern of a hatch that is filled: one that no table has.
const NO_PATTERN: i32 = -1;

/// The object of an archive that an item is, or is the attributes and geometry of.
fn archived(value: &Value) -> Option<Object> {
    match value {
        Value::Kept(raw) => raw.parse(&Limits::default()).ok(),
        Value::Content(content) => match &**content {
            Content::Object(object) => object.geometry.as_ref().and_then(archived),
            _ => None,
        },
        _ => None,
    }
}

/// Where a text stands from its point, counted from the left and from the bottom: 0, 1 or 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Alignment {
    pub(crate) across: i32,
    pub(crate) up: i32,
}

impl Alignment {
    /// The word of Rhino for it: `BottomLeft`, `MiddleCenter`.
    pub(crate) fn word(self) -> String {
        let up = ["Bottom", "Middle", "Top"];
        let across = ["Left", "Center", "Right"];
        let of = |words: [&'static str; 3], place: i32| {
            usize::try_from(place).ok().and_then(|place| words.get(place).copied()).unwrap_or_default()
        };
        format!("{}{}", of(up, self.up), of(across, self.across))
    }
}

/// A text of a model, taken apart.
pub(crate) struct Writing {
    pub(crate) text: String,
    pub(crate) plane: Plane,
    pub(crate) alignment: Alignment,
}

/// A text of a model.
///
/// # Errors
/// The item is none.
pub(crate) fn writing(value: &Value) -> Result<Writing, Message> {
    match archived(value) {
        Some(Object::Annotation(text)) if matches!(text.kind, AnnotationKind::Text) => {
            // Those of archives: 0 top, 1 and 3 and 6 the middle, the others the bottom.
            let up = match text.text.vertical_alignment {
                0 => 2,
                1 | 3 | 6 => 1,
                _ => 0,
            };
            let across = text.text.horizontal_alignment.clamp(0, 2);
            let words = text.plain_text().replace("\r\n", "\n");
            Ok(Writing { text: words, plane: text.plane.frame, alignment: Alignment { across, up } })
        }
        Some(Object::TextDot(dot)) => Ok(Writing {
            text: dot.text,
            plane: Plane::XY.with_origin(dot.point),
            alignment: Alignment { across: 1, up: 1 },
        }),
        _ => Err(Message::error(format!("A {} is no text of a model", type_name(value)))),
    }
}

/// A text as an object of a model, in its style of annotations.
///
/// # Errors
/// It cannot be written.
pub(crate) fn text_object(text: &str, plane: &Plane) -> Result<Value, Message> {
    let annotation = Annotation {
        kind: AnnotationKind::Text,
        text: TextContent { vertical_alignment: 4, ..TextContent::new(text) },
        style: Uuid::nil(),
        overrides: None,
        plane: StoredPlane::from(*plane),
        horizontal: Vector2::X,
        scales_text: true,
    };
    Value::from_object(Object::Annotation(Box::new(annotation)), &[])
        .ok_or_else(|| Message::error("The text cannot be written"))
}

/// A text dot as an object of a model.
///
/// # Errors
/// Its height is not above 0, or it cannot be written.
pub(crate) fn text_dot(text: &str, at: Point3, font: Option<&str>, height: i32) -> Result<Value, Message> {
    if height < 1 {
        return Err(Message::error(format!("The size is {height}: it must be at least 1")));
    }
    let mut dot = TextDot { height, ..TextDot::new(at, text) };
    if let Some(font) = font.filter(|font| !font.trim().is_empty()) {
        font.clone_into(&mut dot.font);
    }
    Value::from_object(Object::TextDot(dot), &[])
        .ok_or_else(|| Message::error("The text dot cannot be written"))
}

/// A solid hatch of a model inside a curve, with what a pattern would be turned, in radians, and multiplied by.
///
/// # Errors
/// The curve is not closed or not planar, a number is not finite or the scale not above 0, or it cannot be written.
pub(crate) fn hatch_object(
    boundary: &Curve,
    rotation: f64,
    scale: f64,
    tolerance: f64,
) -> Result<Value, Message> {
    if !boundary.is_closed() {
        return Err(Message::error("The boundary is not closed"));
    }
    let plane = boundary.plane(tolerance).ok_or_else(|| Message::error("The boundary is not planar"))?;
    if !(rotation.is_finite() && scale.is_finite() && scale > 0.0) {
        return Err(Message::error(format!(
            "A pattern cannot be turned by {rotation} and multiplied by {scale}"
        )));
    }
    let flat = boundary.transformed(&Xform::plane_to_plane(&plane, &Plane::XY))?;
    let hatch = Hatch {
        plane: StoredPlane::from(plane),
        scale,
        rotation,
        pattern: NO_PATTERN,
        loops: vec![HatchLoop { outer: true, curve: CurveForm::of(&flat, 2) }],
        base_point: Point2::ORIGIN,
    };
    Value::from_object(Object::Hatch(Box::new(hatch)), &[])
        .ok_or_else(|| Message::error("The hatch cannot be written"))
}

/// A hatch of a model with its boundary curves where they lie.
///
/// # Errors
/// The item is none, or a curve of it is broken.
pub(crate) fn hatch(value: &Value) -> Result<(Hatch, Vec<Curve>), Message> {
    let Some(Object::Hatch(hatch)) = archived(value) else {
        return Err(Message::error(format!("A {} is no hatch", type_name(value))));
    };
    let placed = Xform::plane_to_plane(&Plane::XY, &hatch.plane.frame);
    let curve = |k: &katydid_3dm::HatchLoop| k.curve.to_curve()?.transformed(&placed);
    let curves = hatch.loops.iter().map(curve).collect::<Result<Vec<Curve>, _>>()?;
    Ok((*hatch, curves))
}
