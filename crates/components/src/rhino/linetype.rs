//! Rhino / Linetype: patterns that lines are drawn in.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Colour, Kind, ModelLinetype, Tree, Value, cast};
use katydid_geometry::Curve;

use super::linetype_of;

/// Linetypes. A text becomes the linetype of that name.
#[component(
    "c2c85a16-98f4-4f29-b1e4-9ea45744f80e",
    name = "Linetype",
    nick = "Linetype",
    at = "Rhino/Linetype",
    floating
)]
#[output("Linetype", "Linetype", "The data.", kind = Generic)]
fn linetype(
    context: &Context<'_>,
    /// The data, from a wire or stored in the parameter.
    #[port("Linetype", "Linetype", optional, kind = Generic)]
    data: &Tree,
) -> Tree {
    let mut unfit = None;
    let items = data.column().iter().map(|item| match linetype_of(context, &item?) {
        Ok(linetype) => Some(Value::from(linetype)),
        Err(message) => {
            unfit.get_or_insert(message);
            None
        }
    });
    let column = katydid_data::Column::of_options(items.collect());
    if let Some(message) = unfit {
        context.tell(message);
    }
    data.with_column(column)
}

/// Takes a linetype apart, and puts other properties in the place of its own.
///
/// An input without data leaves what the linetype has; without a linetype a continuous one is the start.
#[component(
    "40abbc84-7bc1-4b05-bb32-10976d2e7157",
    name = "Model Linetype",
    nick = "Linetype",
    at = "Rhino/Linetype"
)]
#[output("Model Linetype", "L", "The linetype.", kind = Content)]
#[output("Name", "N", "Its name.")]
#[output(
    "Segments",
    "S",
    "Lengths of dashes, positive, and gaps, negative, in millimetres; none for a line without gaps."
)]
#[output("Cap Style", "Cs", "The ends: 0 round, 1 flat, 2 square.")]
#[output("Join Style", "Js", "The corners: 0 round, 1 mitred, 2 bevelled.")]
#[output("Width", "W", "The width.")]
#[output("Width Units", "Wu", "The unit of the width, as Rhino numbers units; 0 for pixels.")]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn model_linetype(
    context: &Context<'_>,
    /// The linetype, or the name of one.
    #[port("Model Linetype", "L", optional)]
    linetype: Option<Value>,
    /// Its name from now on.
    #[port("Name", "N", optional)]
    name: Option<Arc<str>>,
    /// Its dashes and gaps from now on, positive and negative lengths in millimetres.
    #[port("Segments", "S", optional)]
    segments: List<f64>,
    /// Its ends from now on: 0 round, 1 flat, 2 square.
    #[port("Cap Style", "Cs", optional)]
    cap: Option<i32>,
    /// Its corners from now on: 0 round, 1 mitred, 2 bevelled.
    #[port("Join Style", "Js", optional)]
    join: Option<i32>,
    /// Its width from now on.
    #[port("Width", "W", optional)]
    width: Option<f64>,
    /// The unit of the width from now on, as Rhino numbers units.
    #[port("Width Units", "Wu", optional)]
    units: Option<Value>,
) -> Result<(Value, Arc<str>, Vec<f64>, i32, i32, f64, i32), Message> {
    let mut changed = match linetype {
        Some(value) => ModelLinetype::clone(&*linetype_of(context, &value)?),
        None => ModelLinetype { name: Arc::from(""), ..ModelLinetype::default() },
    };
    if let Some(name) = name {
        changed.name = name;
    }
    if !segments.is_empty() {
        changed.segments = sound_segments(segments.present().collect())?;
    }
    changed.cap = one_of_three("Cap styles", cap.unwrap_or(changed.cap))?;
    changed.join = one_of_three("Join styles", join.unwrap_or(changed.join))?;
    if let Some(width) = width {
        if !(width.is_finite() && width >= 0.0) {
            return Err(Message::error("A width is a number, 0 or more"));
        }
        changed.width = width;
    }
    if let Some(units) = units {
        match cast::value(&units, Kind::Integer, context.rules()) {
            Some(Value::Integer(number)) if (0..=255).contains(&number) => changed.width_units = number,
            _ => return Err(Message::error("The unit of the width is a number from 0 to 255")),
        }
    }
    let parts = (changed.name.clone(), changed.segments.clone());
    let (cap, join, width, units) = (changed.cap, changed.join, changed.width, changed.width_units);
    Ok((Value::from(changed), parts.0, parts.1, cap, join, width, units))
}

fn one_of_three(what: &str, number: i32) -> Result<i32, Message> {
    if (0..=2).contains(&number) {
        Ok(number)
    } else {
        Err(Message::error(format!("{what} are 0, 1 and 2; there is no {number}")))
    }
}

fn sound_segments(segments: Vec<f64>) -> Result<Vec<f64>, Message> {
    if segments.iter().any(|length| !length.is_finite()) {
        return Err(Message::error("The length of a dash or gap is a number"));
    }
    Ok(segments)
}

/// Shows a curve in a linetype and a colour. It gives nothing out.
///
/// Pictures show the colour; gaps are not drawn yet.
#[component(
    "eeb8f5d3-2c5e-46bd-a368-10f0f9576fe9",
    name = "Custom Curve Preview",
    nick = "Curve Preview",
    at = "Display/Preview"
)]
fn custom_curve_preview(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    _curve: &Curve,
    /// The linetype, or the name of one.
    #[port("Linetype", "L", default = "Continuous", optional)]
    linetype: Value,
    /// The colour.
    #[port("Colour", "C", default = Colour::rgb(255, 255, 255))]
    _colour: Colour,
) {
    if let Err(message) = linetype_of(context, &linetype) {
        context.tell(message);
    }
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Linetype, LinetypeSegment, Model};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Line, Point3};

    fn model() -> RhinoModel {
        let segment = |length, is_gap| LinetypeSegment { length, is_gap };
        let segments = vec![segment(6.0, false), segment(3.0, true)];
        let dashed = Linetype { name: "Dashed".to_owned(), segments, ..Linetype::default() };
        RhinoModel::new(Model { linetypes: vec![dashed], ..Model::default() })
    }

    #[test]
    fn a_linetype_is_taken_apart_and_changed() {
        let trial = || Trial::of("Model Linetype").model(model()).item("dashed");
        let all: Vec<String> = trial().run().outputs.iter().flat_map(texts).collect();
        let ends: Vec<&str> = all.iter().map(|text| text.split_once(": ").unwrap().1).collect();
        assert_eq!(ends, ["Dashed", "Dashed", "6, -3", "0", "0", "1", "0"]);
        let changed = trial().item("Long").list([9.0, -1.0]).item(1).item(2).item(0.5).item(2);
        let all: Vec<String> = changed.run().outputs.iter().flat_map(texts).collect();
        let ends: Vec<&str> = all.iter().map(|text| text.split_once(": ").unwrap().1).collect();
        assert_eq!(ends, ["Long", "Long", "9, -1", "1", "2", "0.5", "2"]);
        assert!(trial().default().default().item(7).message().contains("no 7"));
        assert!(Trial::of("Model Linetype").item("Wavy").message().contains("Wavy is not known"));
    }

    #[test]
    fn a_parameter_finds_linetypes_by_name() {
        assert_eq!(Trial::of("Linetype").item("DASHED").model(model()).texts(0), ["{0}: Dashed"]);
        assert_eq!(Trial::of("Linetype").item("Continuous").texts(0), ["{0}: Continuous"]);
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        assert!(Trial::of("Custom Curve Preview").item(line).item("Wavy").message().contains("Wavy"));
    }
}
