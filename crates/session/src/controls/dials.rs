//! The MD Slider, the Control Knob and the Digit Scroller.

use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::{Object, Special, ids};

use super::parts::number;
use super::{FACE, Row, decimal, finite, part, short};
use crate::Refusal;
use crate::protocol::Control;

/// The names of the ranges of an MD Slider.
const AXES: [&str; 3] = ["x_domain", "y_domain", "z_domain"];

pub(super) const MD_SLIDER: Row = Row {
    components: &[ids::MD_SLIDER],
    is_set_by_hand: true,
    begin: |container| {
        container.set("SliderMode", 2);
        container.set("slider_value", ItemValue::Point3d([0.5, 0.5, 0.5]));
        for axis in AXES {
            container.set(axis, ItemValue::Interval1d([0.0, 1.0]));
        }
    },
    view: |_, special| {
        let Special::MdSlider(slider) = special else { return None };
        let domains = slider.domains.map(|d| [d.start, d.end]);
        Some(Control::MdSlider { value: slider.value, domains })
    },
    shape: |object, control| {
        let Control::MdSlider { value, domains } = control else { return Ok(false) };
        finite(domains.as_flattened())?;
        object.set_md_slider(*value)?;
        for (name, domain) in AXES.into_iter().zip(domains) {
            object.container_mut().set(name, ItemValue::Interval1d(*domain));
        }
        Ok(true)
    },
    size: |_, _| Some([200.0, 200.0]),
    ..FACE
};

pub(super) const KNOB: Row = Row {
    components: &[ids::CONTROL_KNOB],
    is_set_by_hand: true,
    begin: |container| {
        let mut dial = Chunk::new("DialData");
        dial.set("Decimals", 2);
        dial.set("Limit", false);
        dial.set("Maximum", 100.0);
        dial.set("Minimum", 0.0);
        dial.set("Range", 10.0);
        dial.set("Value", 0.0);
        container.set_child(dial);
    },
    view: |_, special| {
        let Special::Knob(knob) = special else { return None };
        Some(Control::Knob {
            value: knob.value,
            min: knob.min,
            max: knob.max,
            limited: knob.limited,
            range: knob.range,
            decimals: knob.decimals,
        })
    },
    shape: |object, control| {
        let Control::Knob { value, min, max, limited, range, decimals } = control else { return Ok(false) };
        finite(&[*value, *min, *max, *range])?;
        let dial = part(object, "DialData")?;
        for (name, x) in [("Minimum", min), ("Maximum", max), ("Range", range)] {
            number(dial, name, *x);
        }
        dial.set("Limit", *limited);
        dial.set("Decimals", (*decimals).clamp(0, 12));
        turn(object, *value)?;
        Ok(true)
    },
    size: |_, _| Some([128.0, 148.0]),
    ..FACE
};

pub(super) const DIGITS: Row = Row {
    components: &[ids::DIGIT_SCROLLER],
    is_set_by_hand: true,
    begin: |container| {
        let mut scroller = Chunk::new("Scroller");
        scroller.set("Digits", 12);
        scroller.set("Prefix", "");
        scroller.set("Radix", 6);
        scroller.set("Suffix", "");
        scroller.set("Value", decimal(0.0, 6));
        container.set_child(scroller);
    },
    view: |_, special| {
        let Special::DigitScroller(scroller) = special else { return None };
        Some(Control::Digits {
            value: scroller.value,
            digits: scroller.digits,
            radix: scroller.radix,
            prefix: scroller.prefix,
            suffix: scroller.suffix,
        })
    },
    shape: |object, control| {
        let Control::Digits { value, digits, radix, prefix, suffix } = control else { return Ok(false) };
        finite(&[*value])?;
        let scroller = part(object, "Scroller")?;
        scroller.set("Digits", (*digits).clamp(1, 28));
        scroller.set("Radix", (*radix).clamp(0, 28));
        scroller.set("Prefix", short(prefix)?);
        scroller.set("Suffix", short(suffix)?);
        turn(object, *value)?;
        Ok(true)
    },
    size: |_, _| Some([250.0, 20.0]),
    ..FACE
};

/// Turns a knob or scroller. One that stands there already keeps its number as it is written.
pub(crate) fn turn(object: &mut Object, value: f64) -> Result<(), Refusal> {
    let stands = match object.special() {
        Some(Special::Knob(knob)) => Some(knob.value),
        Some(Special::DigitScroller(scroller)) => Some(scroller.value),
        _ => None,
    };
    if stands != Some(value) {
        object.set_dial(value)?;
    }
    Ok(())
}
