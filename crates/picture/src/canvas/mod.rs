//! The definition itself as it stands on the canvas: capsules and their ports, wires by the structure of their data,
//! groups, panels with what they show, sliders where they stand.

mod capsule;
mod charts;
mod controls;
mod frame;
mod moments;
mod notes;
mod panel;
mod sign;
mod theme;
mod viewport;
mod wires;

use katydid_data::Tree;
use katydid_data::text::Style;
use katydid_definition::document::{Document, Object, Special, ids};
use katydid_definition::kd;
use katydid_solver::{Engine, ObjectReport, Status};

use crate::drawing::{Drawing, Item};
use crate::{Options, result};
use frame::Frame;

/// Free pixels around everything.
const MARGIN: f64 = 24.0;

/// An object with its place and what it gave.
pub(crate) struct Placed<'a> {
    pub(crate) object: &'a Object,
    pub(crate) frame: Frame,
    pub(crate) report: Option<&'a ObjectReport>,
    pub(crate) style: Style,
}

impl Placed<'_> {
    pub(crate) fn status(&self) -> Status {
        self.report.map_or(Status::Ok, |report| report.status)
    }

    /// The data of an output.
    pub(crate) fn output(&self, k: usize) -> Option<&Tree> {
        self.report?.outputs.get(k)
    }
}

/// The picture of the canvas, a pixel a unit of it. Objects that have no place in the file are given one.
pub fn canvas(engine: &Engine, options: &Options) -> Drawing {
    let document = arranged(engine.document());
    let rules = &engine.options().rules;
    let style = Style { units: rules.units, tolerance: rules.tolerance };
    let place = |(index, object)| {
        let frame = Frame::new(object)?;
        Some(Placed { object, frame, report: engine.report(index), style })
    };
    // By the index of the object: wires name theirs.
    let placed: Vec<Option<Placed<'_>>> = document.objects.iter().enumerate().map(place).collect();

    let mut drawing = Drawing { background: options.background, ..Drawing::default() };
    drawing.items.extend(notes::groups(&document, &placed));
    let ground = options.background.unwrap_or(theme::PAPER);
    drawing.items.extend(wires::all(&document, &placed, ground));
    for one in placed.iter().flatten() {
        let items = object(one);
        if !items.is_empty() {
            drawing.items.push(Item::Group(told(one), items));
        }
    }
    let windows = viewport::windows(engine, &placed);
    for (_, window) in &windows {
        drawing.items.push(Item::Group("The model".to_owned(), viewport::draw(engine, *window)));
    }
    crop(&mut drawing, &placed, &document, &windows);
    drawing.title = format!("Canvas: {}", result::title(&document, options));
    drawing.description = description(&document, &placed);
    drawing
}

fn arranged(document: &Document) -> Document {
    let mut document = document.clone();
    kd::arrange(&mut document);
    document
}

fn object(one: &Placed<'_>) -> Vec<Item> {
    let mut items = match one.object.special() {
        Some(Special::Group(_)) => return Vec::new(),
        Some(Special::Scribble(scribble)) => return notes::scribble(one, &scribble),
        Some(Special::Sketch(sketch)) => return notes::sketch(&sketch),
        Some(Special::Panel(panel)) => panel::draw(one, &panel),
        Some(special) => controls::draw(one, &special),
        None => controls::shown(one),
    }
    .unwrap_or_else(|| capsule::draw(one));
    items.extend(sign::of(one));
    items
}

/// What an object is and how it came out, for who asks.
fn told(one: &Placed<'_>) -> String {
    let object = one.object;
    let mut text = object.title().replace('\n', " ");
    if object.title() != object.name {
        text = format!("{text} ({})", object.name);
    }
    if let Some(report) = one.report.filter(|report| report.status != Status::Ok) {
        text = format!("{text}: {}", report.status.word());
        for message in report.messages.iter().take(3) {
            text = format!("{text}; {}", message.text);
        }
    }
    text
}

/// The name of an object's type where neither its nickname nor its look tells it.
pub(crate) fn type_name(object: &Object) -> Option<&str> {
    let telling = object.title().eq_ignore_ascii_case(&object.name)
        || [ids::RELAY, ids::NUMBER_SLIDER, ids::BOOLEAN_TOGGLE, ids::BOOLEAN_TOGGLE_2, ids::COLOUR_SWATCH]
            .contains(&object.component);
    (!telling).then_some(object.name.as_str())
}

/// Moves everything to the corner and gives the picture its size.
fn crop(
    drawing: &mut Drawing,
    placed: &[Option<Placed<'_>>],
    document: &Document,
    windows: &[(usize, [f64; 4])],
) {
    let frames = placed.iter().flatten().map(|one| one.frame.outer());
    let groups = notes::group_frames(document, placed);
    let all = frames.chain(groups).chain(windows.iter().map(|(_, window)| *window)).reduce(frame::union);
    let [x, y, w, h] = all.unwrap_or([0.0, 0.0, 200.0, 100.0]);
    let by = [MARGIN - x, MARGIN - y];
    drawing.items.iter_mut().for_each(|item| item.transform(1.0, by));
    drawing.size = [w + 2.0 * MARGIN, h + 2.0 * MARGIN].map(f64::ceil);
}

/// What is on the canvas, counted, and what is wrong with it.
fn description(document: &Document, placed: &[Option<Placed<'_>>]) -> String {
    let working = document.objects.iter().filter(|object| !object.is_annotation()).count();
    let wires = document.wires().count();
    let groups = document.objects.iter().filter(|object| object.component == ids::GROUP).count();
    let mut text =
        format!("A Grasshopper definition of {working} objects, {wires} wires and {groups} groups.");
    for (status, words) in [
        (Status::Error, "With errors"),
        (Status::Warning, "With warnings"),
        (Status::Unsupported, "Not supported"),
        (Status::NoData, "Without data"),
    ] {
        let names: Vec<&str> = placed
            .iter()
            .flatten()
            .filter(|one| one.status() == status)
            .map(|one| one.object.title())
            .take(12)
            .collect();
        if !names.is_empty() {
            text = format!("{text} {words}: {}.", names.join(", "));
        }
    }
    text
}
