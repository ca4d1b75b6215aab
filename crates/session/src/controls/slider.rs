//! The Number Slider.

use katydid_definition::archive::Chunk;
use katydid_definition::document::special::Rounding;
use katydid_definition::document::{Object, Special, ids};

use super::parts::number;
use super::{FACE, Row, finite, part, short, unfit};
use crate::Refusal;
use crate::protocol::{Control, RoundingView};

pub(super) const SLIDER: Row = Row {
    components: &[ids::NUMBER_SLIDER],
    is_set_by_hand: true,
    begin: |container| {
        let mut slider = Chunk::new("Slider");
        slider.set("Digits", 3);
        slider.set("GripDisplay", 1);
        slider.set("Interval", 0);
        slider.set("Max", 1.0);
        slider.set("Min", 0.0);
        slider.set("SnapCount", 0);
        slider.set("Value", 0.25);
        container.set_child(slider);
    },
    view: |_, special| {
        let Special::Slider(slider) = special else { return None };
        Some(Control::Slider {
            value: slider.value,
            min: slider.min,
            max: slider.max,
            rounding: match slider.rounding {
                Rounding::Real => RoundingView::Float,
                Rounding::Integer => RoundingView::Integer,
                Rounding::Even => RoundingView::Even,
                Rounding::Odd => RoundingView::Odd,
            },
            digits: slider.digits,
            expression: slider.expression,
        })
    },
    shape: |object, control| {
        let Control::Slider { value, min, max, rounding, digits, expression } = control else {
            return Ok(false);
        };
        shape(object, [*value, *min, *max], *rounding, *digits, expression.as_deref())
    },
    size: |_, title| Some([(title + 160.0).clamp(180.0, 400.0), 20.0]),
    ..FACE
};

fn shape(
    object: &mut Object,
    [value, min, max]: [f64; 3],
    rounding: RoundingView,
    digits: u32,
    expression: Option<&str>,
) -> Result<bool, Refusal> {
    finite(&[value, min, max])?;
    if min > max {
        return Err(unfit(object, "its least value is greater than its greatest"));
    }
    let chunk = part(object, "Slider")?;
    number(chunk, "Min", min);
    number(chunk, "Max", max);
    chunk.set("Digits", i32::try_from(digits.min(12)).unwrap_or(3));
    chunk.set(
        "Interval",
        match rounding {
            RoundingView::Float => 0,
            RoundingView::Integer => 1,
            RoundingView::Even => 2,
            RoundingView::Odd => 3,
        },
    );
    match expression.map(str::trim).filter(|text| !text.is_empty()) {
        Some(text) => chunk.set("Expression", short(text)?),
        None => {
            chunk.remove("Expression");
        }
    }
    object.set_slider(value)?;
    Ok(true)
}
