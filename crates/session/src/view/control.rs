//! The faces of controls, as the file has them.

use katydid_data::{DateTime, Value};
use katydid_definition::archive;
use katydid_definition::document::special::{Border, Graph, GraphMapper, ListMode, Rounding, Sketch};
use katydid_definition::document::{
    Document, Object, Persistent, Script, Special, Stored, TypeHint, format_path, ids,
};
use katydid_solver::{Engine, Options};

use crate::protocol::{
    BorderView, Colour, Control, GraphView, GripView, ListItemView, ListModeView, RoundingView,
};

/// How many points a function is drawn with.
const DRAWN: i32 = 64;
/// A new panel's paper.
const PAPER: archive::Colour = archive::Colour::new(255, 255, 250, 90);

/// The red, green, blue and alpha of a colour.
pub(crate) fn colour(c: archive::Colour) -> Colour {
    [c.r, c.g, c.b, c.a]
}

/// What an object has of its own; none for an ordinary component.
pub(crate) fn control(object: &Object) -> Option<Control> {
    if let Some(script) = object.script() {
        return Some(scripted(object, script));
    }
    Some(match object.special()? {
        Special::Slider(slider) => Control::Slider {
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
        },
        Special::Panel(panel) => Control::Panel {
            text: panel.text,
            multiline: panel.multiline,
            paths: panel.draw_paths,
            indices: panel.draw_indices,
            wrap: panel.wrap,
            special_codes: panel.special_codes,
            alignment: panel.alignment,
            colour: colour(panel.colour.unwrap_or(PAPER)),
            stream: panel.stream_path,
        },
        Special::Toggle(on) => Control::Toggle { on },
        Special::Button(button) => Control::Button { normal: button.normal, pressed: button.pressed },
        Special::Colour(c) => Control::Swatch { colour: colour(c) },
        Special::ValueList(list) => Control::ValueList {
            mode: match list.mode {
                ListMode::CheckList => ListModeView::Check,
                ListMode::DropDown => ListModeView::DropDown,
                ListMode::Sequence => ListModeView::Sequence,
                ListMode::Cycle => ListModeView::Cycle,
            },
            items: list
                .items
                .into_iter()
                .map(|item| ListItemView {
                    name: item.name,
                    expression: item.expression,
                    selected: item.selected,
                })
                .collect(),
        },
        Special::MdSlider(slider) => {
            Control::MdSlider { value: slider.value, domains: slider.domains.map(|d| [d.start, d.end]) }
        }
        Special::Knob(knob) => Control::Knob {
            value: knob.value,
            min: knob.min,
            max: knob.max,
            limited: knob.limited,
            range: knob.range,
            decimals: knob.decimals,
        },
        Special::DigitScroller(scroller) => Control::Digits {
            value: scroller.value,
            digits: scroller.digits,
            radix: scroller.radix,
            prefix: scroller.prefix,
            suffix: scroller.suffix,
        },
        Special::Calendar(calendar) => Control::Calendar { date: calendar.day.date(), shown: calendar.shown },
        Special::Clock(clock) => {
            Control::Clock { seconds: clock.time.time_of_day() as f64 / DateTime::SECOND as f64 }
        }
        Special::GenePool(pool) => {
            Control::Genes { values: pool.values, decimals: pool.decimals, min: pool.min, max: pool.max }
        }
        Special::GraphMapper(mapper) => Control::Graph {
            x: [mapper.x.start, mapper.x.end],
            y: [mapper.y.start, mapper.y.end],
            graph: graph(&mapper),
            drawn: drawn(object, &mapper),
        },
        Special::Gradient(gradient) => Control::Gradient {
            grips: gradient
                .grips
                .iter()
                .map(|grip| GripView { at: grip.at, left: colour(grip.left), right: colour(grip.right) })
                .collect(),
            linear: gradient.linear,
        },
        Special::PathMapper(mapper) => {
            Control::Paths { rules: mapper.rules.into_iter().map(|(from, to)| [from, to]).collect() }
        }
        Special::CherryPicker(picker) => {
            Control::Cherry { path: format_path(&picker.path), index: picker.index }
        }
        Special::DataRecorder(recorder) => {
            Control::Recorder { recording: recorder.recording, limit: recorder.limit }
        }
        Special::ImageSampler(sampler) => Control::Image {
            hash: sampler.image.as_deref().and_then(super::picture::hash),
            file: sampler.file,
        },
        Special::Contextual(input) => {
            Control::Contextual { prompt: input.prompt, minimum: input.minimum, maximum: input.maximum }
        }
        Special::Expression(text) => Control::Formula { text },
        Special::Group(group) => Control::Group {
            label: group.label,
            colour: group.colour.map_or([170, 135, 255, 150], colour),
            border: match group.border {
                Border::Blob => BorderView::Blob,
                Border::Rectangle => BorderView::Rectangle,
                Border::Box | Border::Other(_) => BorderView::Box,
            },
            members: group.members,
        },
        Special::Scribble(scribble) => Control::Scribble {
            text: scribble.text,
            font: scribble.font,
            size: scribble.size,
            bold: scribble.bold,
            italic: scribble.italic,
            corners: scribble.corners,
        },
        Special::Sketch(sketch) => sketched(sketch),
        _ => return None,
    })
}

/// A script, with line feeds alone between its lines.
fn scripted(object: &Object, script: Script) -> Control {
    let plain = |text: String| text.replace("\r\n", "\n");
    let container = object.container();
    let is_in_parts =
        [ids::C_SHARP, ids::VB].contains(&object.component) && container.child("UserCode").is_none();
    Control::Script {
        language: script.language.to_string(),
        text: plain(script.text),
        additional: is_in_parts.then(|| plain(script.additional)),
        using: is_in_parts.then(|| plain(script.using)),
        from_wire: script.from_wire,
        hints: TypeHint::offered_by(object.component).map(|(hint, _)| hint.name.to_owned()).collect(),
    }
}

fn sketched(sketch: Sketch) -> Control {
    Control::Sketch {
        lines: sketch.marks.into_iter().map(|mark| mark.points).collect(),
        colour: sketch.colour.map_or([0, 0, 0, 255], colour),
        width: sketch.width,
    }
}

/// The function of a Graph Mapper by the places of its handles.
fn graph(mapper: &GraphMapper) -> GraphView {
    let (name, handles) = match &mapper.graph {
        None => ("", Vec::new()),
        Some(Graph::Bezier(points)) => ("Bezier", points.to_vec()),
        Some(Graph::Linear([start, end])) => ("Linear", vec![[0.0, *start], [1.0, *end]]),
        Some(Graph::Parabola { origin, point }) => ("Parabola", vec![*origin, *point]),
        Some(Graph::Sine(extremes)) => ("Sine", extremes.to_vec()),
        Some(Graph::SineSummation(waves)) => ("Sine Summation", waves.iter().flatten().copied().collect()),
        Some(Graph::Gaussian { mean, deviation, factor }) => {
            ("Gaussian", vec![[*mean, *factor], [mean + deviation, 0.5 * factor]])
        }
        Some(Graph::Perlin { amplitude, frequency, decay, offset }) => {
            ("Perlin", vec![[*frequency, *amplitude], [*decay, 0.0], *offset])
        }
        Some(Graph::Power { point, power }) => ("Power", vec![*point, [*power, 0.0]]),
        Some(Graph::Other(name, _)) => (name.as_str(), Vec::new()),
        Some(_) => ("Other", Vec::new()),
    };
    GraphView { name: name.to_owned(), handles }
}

/// The function as points of the unit square: the mapper itself is asked for them.
fn drawn(object: &Object, mapper: &GraphMapper) -> Vec<[f64; 2]> {
    let (x, y) = (mapper.x, mapper.y);
    let height = y.end - y.start;
    if mapper.graph.is_none() || !(x.end - x.start).is_finite() || !height.is_finite() || height == 0.0 {
        return Vec::new();
    }
    let at: Vec<f64> = (0..=DRAWN).map(|k| f64::from(k) / f64::from(DRAWN)).collect();
    let mut alone = object.clone();
    let values = at.iter().map(|t| Stored::Number(x.start + t * (x.end - x.start))).collect();
    let cleared =
        alone.set_sources(0, &[]).and_then(|()| alone.set_persistent(0, Some(&Persistent::list(values))));
    alone.set_locked(false);
    let mut document = Document::new();
    document.objects.push(alone);
    let mut engine = Engine::new(document, Options::default());
    engine.solve();
    let Some(tree) = engine.report(0).filter(|_| cleared.is_ok()).and_then(|report| report.outputs.first())
    else {
        return Vec::new();
    };
    let number = |value: Option<Value>| match value {
        Some(Value::Number(v)) => Some((v - y.start) / height),
        _ => None,
    };
    let points = at.iter().zip(tree.column().iter());
    points.filter_map(|(t, value)| Some([*t, number(value).filter(|v| v.is_finite())?])).collect()
}
