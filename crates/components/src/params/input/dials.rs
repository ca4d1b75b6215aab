//! Sliders, knobs and scrollers.

use katydid_component::{Context, Message, component};
use katydid_data::{Tree, Value, formula as values};
use katydid_definition::archive::Chunk;
use katydid_expression::Variant;
use katydid_geometry::{Interval, Point3};

use crate::maths::formula::Formula;

fn missing() -> Message {
    Message::error("No value is stored in this object")
}

/// `x` between the slider's ends, and on its grid: decimals, whole, even or odd numbers.
fn fitted(slider: &Chunk, x: f64) -> f64 {
    let end = |name, default| slider.f64(name).unwrap_or(default);
    let (a, b) = (end("Min", f64::NEG_INFINITY), end("Max", f64::INFINITY));
    let (min, max) = (a.min(b), a.max(b));
    let x = x.min(max).max(min);
    let (first, step) = match slider.i32("Interval") {
        Some(1) => (0.0, 1.0),
        Some(2) => (0.0, 2.0),
        Some(3) => (1.0, 2.0),
        _ => {
            let places = usize::try_from(slider.i32("Digits").unwrap_or(3).clamp(0, 12)).unwrap_or(3);
            let rounded: f64 = format!("{x:.places$}").parse().unwrap_or(x);
            return rounded.min(max).max(min);
        }
    };
    let on_grid = ((x - first) / step).round_ties_even() * step + first;
    // Rounding may step over an end; between ends closer than a step there may be no number of the grid.
    let candidates = [on_grid, on_grid - step, on_grid + step];
    candidates.into_iter().find(|v| (min..=max).contains(v)).unwrap_or(x)
}

/// A number, set by hand between two ends: with decimals, or whole, even or odd.
///
/// An expression stored in the slider changes what it gives; it goes by `x`.
#[component(
    "57da07bd-ecab-415d-9d86-af36d7073abc",
    name = "Number Slider",
    nick = "",
    at = "Params/Input",
    floating
)]
#[output("Number", "N", "The number.", kind = Number)]
fn number_slider(
    context: &Context<'_>,
    /// Not used: the number is stored in the slider.
    #[port("Number", "N", optional, kind = Number)]
    _data: &Tree,
) -> Result<Option<Value>, Message> {
    let slider = context.settings().child("Slider").ok_or_else(missing)?;
    let x = fitted(slider, slider.f64("Value").ok_or_else(missing)?);
    match slider.str("Expression").filter(|text| !text.trim().is_empty()) {
        None => Ok(Some(Value::Number(x))),
        Some(text) => {
            let x = values::variant(&Value::Number(x)).unwrap_or(Variant::Null);
            Formula::new(text, &["x"])?.evaluate(&[x])
        }
    }
}

/// A point, set by hand on a square: its place there stands for a place in two ranges of numbers.
#[component(
    "318dacd7-9073-4ede-b043-a0c132eb77e0",
    name = "MD Slider",
    nick = "MD Slider",
    at = "Params/Input",
    floating
)]
#[output("Point", "P", "The point; its z is 0 when the slider is flat.")]
fn md_slider(
    context: &Context<'_>,
    /// Not used: the point is stored in the slider.
    #[port("Point", "P", optional, kind = Point)]
    _data: &Tree,
) -> Result<Point3, Message> {
    let settings = context.settings();
    let [x, y, z] = settings.point3d("slider_value").ok_or_else(missing)?;
    let at = |name, t: f64| {
        let [start, end] = settings.interval(name).unwrap_or([0.0, 1.0]);
        Interval::new(start, end).at(t)
    };
    // A flat slider stores a z as well, which it does not give.
    let flat = settings.i32("SliderMode").unwrap_or(0) == 0;
    let z = if flat { 0.0 } else { at("z_domain", z) };
    Ok(Point3::new(at("x_domain", x), at("y_domain", y), z))
}

/// A number, set by turning a knob.
#[component(
    "bcac2747-348b-4edd-ae1f-77a782cebbdd",
    name = "Control Knob",
    nick = "Knob",
    at = "Params/Input",
    floating
)]
#[output("Number", "N", "The number.", kind = Number)]
fn control_knob(
    context: &Context<'_>,
    /// Not used: the number is stored in the knob.
    #[port("Number", "N", optional, kind = Number)]
    _data: &Tree,
) -> Result<f64, Message> {
    let dial = context.settings().child("DialData").ok_or_else(missing)?;
    let x = dial.f64("Value").ok_or_else(missing)?;
    let end = |name, default| dial.f64(name).unwrap_or(default);
    Ok(match dial.bool("Limit") {
        Some(true) => x.min(end("Maximum", f64::INFINITY)).max(end("Minimum", f64::NEG_INFINITY)),
        _ => x,
    })
}

/// A number, set digit by digit.
#[component(
    "33bcf975-a0b2-4b54-99fd-585c893b9e88",
    name = "Digit Scroller",
    nick = "offset",
    at = "Params/Input",
    floating
)]
#[output("Number", "N", "The number.", kind = Number)]
fn digit_scroller(
    context: &Context<'_>,
    /// Not used: the number is stored in the scroller.
    #[port("Number", "N", optional, kind = Number)]
    _data: &Tree,
) -> Result<f64, Message> {
    context.settings().child("Scroller").and_then(|chunk| chunk.f64("Value")).ok_or_else(missing)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::{Chunk, ItemValue};

    fn inside(name: &str, chunk: &str, items: &[(&str, ItemValue)]) -> Trial {
        let mut child = Chunk::new(chunk);
        for (name, value) in items {
            child.set(name, value.clone());
        }
        let mut settings = Chunk::default();
        settings.set_child(child);
        Trial::of(name).settings(settings)
    }

    fn slider(interval: i32, value: f64, expression: &str) -> Vec<String> {
        let items = [
            ("Min", (-2.5).into()),
            ("Max", 9.5.into()),
            ("Value", value.into()),
            ("Digits", 2.into()),
            ("Interval", interval.into()),
            ("Expression", expression.into()),
        ];
        inside("Number Slider", "Slider", &items).texts(0)
    }

    #[test]
    fn a_slider_stays_on_its_grid() {
        assert_eq!(slider(0, 1.23456, ""), ["{0}: 1.23"]);
        assert_eq!(slider(0, 100.0, ""), ["{0}: 9.5"]);
        assert_eq!(slider(1, 9.5, ""), ["{0}: 9"]);
        assert_eq!(slider(1, -100.0, ""), ["{0}: -2"]);
        assert_eq!(slider(2, 5.2, ""), ["{0}: 6"]);
        assert_eq!(slider(3, 5.9, ""), ["{0}: 5"]);
        assert_eq!(slider(1, 3.0, "x^2 + 0.5"), ["{0}: 9.5"]);
        assert_eq!(Trial::of("Number Slider").message(), "No value is stored in this object");
    }

    #[test]
    fn a_flat_slider_has_no_z() {
        let trial = Trial::of("MD Slider").setting("slider_value", ItemValue::Point3d([0.25, 0.5, 0.5]));
        let trial = trial.setting("x_domain", ItemValue::Interval1d([0.0, 8.0]));
        assert_eq!(trial.texts(0), ["{0}: {2, 0.5, 0}"]);
    }

    #[test]
    fn knobs_and_scrollers_give_their_number() {
        let items = [("Value", 12.5.into()), ("Maximum", 10.0.into()), ("Limit", true.into())];
        assert_eq!(inside("Control Knob", "DialData", &items).texts(0), ["{0}: 10"]);
        assert_eq!(inside("Digit Scroller", "Scroller", &[("Value", 0.125.into())]).texts(0), ["{0}: 0.125"]);
    }
}
