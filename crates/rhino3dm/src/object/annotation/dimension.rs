//! What all dimensions have beyond what annotations have.

use katydid_geometry::Point2;
use uuid::Uuid;

use crate::Result;
use crate::chunk::{Reader, Writer};

/// What all dimensions have.
#[derive(Debug, Clone, PartialEq)]
pub struct Dimension {
    /// The text as the user wrote it; `<>` in it stands for the measure.
    pub user_text: String,
    /// Whether the user moved the text.
    pub text_moved: bool,
    /// Where the text stands when it was moved, in coordinates of the annotation's plane.
    pub text_point: Option<Point2>,
    /// Whether each arrow points inwards.
    pub flipped_arrows: [bool; 2],
    /// How arrows are fitted in between, in archives of before 2019; styles have it since.
    pub arrow_fit: i32,
    /// How the text is fitted in between, in archives of before 2019.
    pub text_fit: i32,
    /// The detail view through which it measures; nil for none.
    pub detail: Uuid,
    /// What measures are multiplied by.
    pub distance_scale: f64,
}

/// What openNURBS stores for a coordinate that is not set.
const UNSET: Point2 = Point2::new(-1.234_321_012_343_21e308, -1.234_321_012_343_21e308);

impl Default for Dimension {
    fn default() -> Self {
        Self {
            user_text: "<>".into(),
            text_moved: false,
            text_point: None,
            flipped_arrows: [false; 2],
            arrow_fit: 0,
            text_fit: 0,
            detail: Uuid::nil(),
            distance_scale: 1.0,
        }
    }
}

const WHAT: &str = "dimension";

pub(super) fn read(body: &mut Reader<'_>, content: i32) -> Result<Dimension> {
    let user_text = body.string(WHAT)?;
    // A rotation of no use.
    body.f64(WHAT)?;
    let default_place = body.bool(WHAT)?;
    let point = body.point2(WHAT)?;
    Ok(Dimension {
        user_text,
        text_moved: !default_place,
        text_point: (point != UNSET).then_some(point),
        flipped_arrows: [body.bool(WHAT)?, body.bool(WHAT)?],
        arrow_fit: body.i32(WHAT)?,
        detail: body.uuid(WHAT)?,
        distance_scale: body.f64(WHAT)?,
        text_fit: if content >= 1 { body.i32(WHAT)? } else { 0 },
    })
}

pub(super) fn write(dimension: &Dimension, w: &mut Writer) -> Result<()> {
    w.string(&dimension.user_text)?;
    w.f64(0.0);
    w.bool(!dimension.text_moved);
    w.point2(dimension.text_point.unwrap_or(UNSET));
    dimension.flipped_arrows.iter().for_each(|flipped| w.bool(*flipped));
    w.i32(dimension.arrow_fit);
    w.uuid(dimension.detail);
    w.f64(dimension.distance_scale);
    w.i32(dimension.text_fit);
    Ok(())
}
