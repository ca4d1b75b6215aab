//! Objects with settings of their own: how these stand among the arguments.

use katydid_data::DateTime;
use katydid_data::cast::parse_time;
use uuid::Uuid;

use super::ast::{Argument, Lit, LitKind, Target, Values};
use super::problem::Fault;
use super::raw_value::{colour_form, string_form};
use super::value::{colour, plain};
use super::{pipeline, text, timing};
use crate::archive::{Chunk, Colour, ItemValue};
use crate::document::{Object, ids};

/// What a new panel says.
const PANEL_TEXT: &str = "Double click to edit panel content…";
const PANEL_COLOUR: Colour = Colour::new(255, 255, 250, 90);

/// Takes those arguments that are settings, and gives the rest: what the object's ports are given. The settings go
/// into the container.
pub(super) fn take<'a>(
    component: Uuid,
    arguments: &'a [Argument],
    container: &mut Chunk,
    faults: &mut Vec<Fault>,
) -> Vec<&'a Argument> {
    let mut own = Own { rest: arguments.iter().collect(), faults };
    match component {
        ids::NUMBER_SLIDER => slider(&mut own, container),
        ids::PANEL => panel(&mut own, container),
        ids::BOOLEAN_TOGGLE | ids::BOOLEAN_TOGGLE_2 => {
            let on = own.take(|lit| if let LitKind::Boolean(on) = lit.kind { Some(on) } else { None });
            let name = if component == ids::BOOLEAN_TOGGLE { "ToggleValue" } else { "SwitchValue" };
            container.set(name, on.unwrap_or(false));
        }
        ids::COLOUR_SWATCH => {
            let swatch = own.take(|lit| colour(lit).ok());
            container.set("SwatchColor", swatch.unwrap_or(Colour::new(255, 255, 255, 255)));
        }
        ids::VALUE_LIST => value_list(&mut own, container),
        ids::CALENDAR => {
            let day = own.take(|lit| parse_time(&text_of(lit)?)).unwrap_or_else(first_day);
            // Grasshopper's own calendars hold a tick after midnight.
            let midnight = day.ticks - day.time_of_day();
            container.set("LocalDate", ItemValue::Date(midnight + 1));
        }
        ids::CLOCK => {
            let time =
                own.take(|lit| parse_time(&text_of(lit)?)).map_or(DateTime::DAY / 2, DateTime::time_of_day);
            container.set("LocalTime", ItemValue::Date(time));
        }
        ids::EXPRESSION => {
            if let Some(text) = own.take(text_of) {
                container.set("Expression", text);
            }
        }
        ids::SCRIBBLE => scribble(&mut own, container),
        ids::GEOMETRY_PIPELINE => pipeline::take(&mut own, container),
        ids::TRIGGER => timing::trigger(&mut own, container),
        ids::DATA_RECORDER => timing::recorder(&mut own, container),
        ids::DATA_DAM => timing::dam(&mut own, container),
        _ => {}
    }
    own.rest
}

/// The day of a calendar whose author gives none.
fn first_day() -> DateTime {
    DateTime::on([2000, 1, 1]).unwrap_or_default()
}

/// The arguments of an object that are not taken yet.
pub(super) struct Own<'a, 'f> {
    pub(super) rest: Vec<&'a Argument>,
    faults: &'f mut Vec<Fault>,
}

/// The value of an argument that is nothing but one.
fn literal(argument: &Argument) -> Option<&Lit> {
    let given = &argument.given;
    match &given.values {
        Values::One(lit) if given.wires.is_empty() && given.modifiers.is_empty() => Some(lit),
        _ => None,
    }
}

fn text_of(lit: &Lit) -> Option<String> {
    if let LitKind::Text(text) = &lit.kind { Some(text.clone()) } else { None }
}

impl Own<'_, '_> {
    /// The first argument without a name that reads as this.
    fn take<T>(&mut self, read: impl Fn(&Lit) -> Option<T>) -> Option<T> {
        let value = |argument: &Argument| {
            if argument.name.is_none() { literal(argument).and_then(&read) } else { None }
        };
        let k = self.rest.iter().position(|argument| value(argument).is_some())?;
        let argument = self.rest.remove(k);
        value(argument)
    }

    /// The argument of this name; a fault when it does not read as this.
    pub(super) fn named<T>(
        &mut self,
        name: &str,
        what: &str,
        read: impl Fn(&Argument) -> Option<T>,
    ) -> Option<T> {
        let is = |argument: &&Argument| argument.name.as_ref().is_some_and(|label| label.text == name);
        let k = self.rest.iter().position(is)?;
        let argument = self.rest.remove(k);
        let value = read(argument);
        if value.is_none() {
            let message = format!("{name} should be {what}");
            self.faults.push(Fault::new(argument.span.at, argument.span.len, message));
        }
        value
    }

    pub(super) fn number(&mut self, name: &str) -> Option<f64> {
        self.named(name, "a number", |argument| {
            if let LitKind::Number(x, _) = literal(argument)?.kind { Some(x) } else { None }
        })
    }

    pub(super) fn boolean(&mut self, name: &str) -> Option<bool> {
        self.named(name, "true or false", |argument| {
            if let LitKind::Boolean(b) = literal(argument)?.kind { Some(b) } else { None }
        })
    }

    pub(super) fn text(&mut self, name: &str) -> Option<String> {
        self.named(name, "a text in quotes", |argument| text_of(literal(argument)?))
    }

    fn colour(&mut self, name: &str) -> Option<Colour> {
        self.named(name, "a colour such as rgb(255, 0, 0)", |argument| colour(literal(argument)?).ok())
    }

    /// One of a few words; gives its number.
    pub(super) fn word(&mut self, name: &str, words: &[&str]) -> Option<i32> {
        let what = format!("one of {}", words.join(", "));
        self.named(name, &what, |argument| word_of(argument, words))
    }
}

/// The number of the word that an argument is.
pub(super) fn word_of(argument: &Argument, words: &[&str]) -> Option<i32> {
    let [wire] = argument.given.wires.as_slice() else { return None };
    let Target::Label(label) = &wire.target else { return None };
    words.iter().position(|word| *word == label.text).and_then(|k| i32::try_from(k).ok())
}

const ROUNDING: [&str; 4] = ["real", "integer", "even", "odd"];
const MODES: [&str; 4] = ["check", "menu", "sequence", "cycle"];
/// What a slider of whole numbers has beside them: as many as any new slider.
const DIGITS: i32 = 3;

/// `Number Slider(5.18, 0..10)`: as many digits behind the point as are written; whole numbers when there are none.
fn slider(own: &mut Own<'_, '_>, container: &mut Chunk) {
    let number = own.take(|lit| if let LitKind::Number(x, d) = lit.kind { Some((x, d)) } else { None });
    let range = own.take(|lit| if let LitKind::Range(a, b, d) = lit.kind { Some((a, b, d)) } else { None });
    let (value, digits) =
        number.unwrap_or((range.map_or(0.25, |(a, ..)| a), range.map_or(Some(3), |_| None)));
    let (min, max, more) = range.unwrap_or_else(|| around(value));
    let digits = digits.unwrap_or(0).max(more);
    let rounding = own.word("rounding", &ROUNDING).unwrap_or(i32::from(digits == 0));
    let inferred = if rounding == 0 { i32::try_from(digits).unwrap_or(12).min(12) } else { DIGITS };
    let digits = own.number("digits").map_or(inferred, |x| x as i32);
    let mut chunk = Chunk::new("Slider");
    if let Some(text) = own.text("expression") {
        chunk.set("Expression", text);
    }
    chunk.set("Digits", digits);
    chunk.set("GripDisplay", 1);
    chunk.set("Interval", rounding);
    chunk.set("Max", max);
    chunk.set("Min", min);
    chunk.set("SnapCount", 0);
    chunk.set("Value", value);
    container.set_child(chunk);
}

/// The range of a slider whose author gives none: up to the next power of ten.
fn around(value: f64) -> (f64, f64, u32) {
    let mut power = 1.0;
    while power < value.abs() && power < 1e12 {
        power *= 10.0;
    }
    if value < 0.0 { (-power, 0.0, 0) } else { (0.0, power, 0) }
}

fn panel(own: &mut Own<'_, '_>, container: &mut Chunk) {
    let text = own.take(text_of);
    container.set("ScrollRatio", 0.0);
    container.set("UserText", text.as_deref().unwrap_or(PANEL_TEXT));
    let mut chunk = Chunk::new("PanelProperties");
    chunk.set("Colour", own.colour("colour").unwrap_or(PANEL_COLOUR));
    chunk.set("DrawIndices", true);
    chunk.set("DrawPaths", true);
    chunk.set("Multiline", !own.boolean("lines").unwrap_or(false));
    chunk.set("SpecialCodes", false);
    let stream = own.text("stream").filter(|path| !path.trim().is_empty());
    chunk.set("Stream", stream.is_some());
    if let Some(path) = stream {
        chunk.set("StreamPath", path);
    }
    chunk.set("Wrap", true);
    container.set_child(chunk);
}

/// `Value List("One": "1", * "Two": 2, mode = cycle)`.
fn value_list(own: &mut Own<'_, '_>, container: &mut Chunk) {
    let mut n = 0;
    let mut chosen = false;
    let mode = own.word("mode", &MODES).unwrap_or(1);
    let faults = &mut own.faults;
    own.rest.retain(|argument| {
        let Some((name, value, selected)) = &argument.choice else { return true };
        let expression = match &value.kind {
            LitKind::Text(text) => text.clone(),
            LitKind::Number(x, _) => plain(*x),
            LitKind::Boolean(b) => if *b { "True" } else { "False" }.to_owned(),
            _ => {
                let span = value.span;
                faults.push(Fault::new(
                    span.at,
                    span.len,
                    "an expression in quotes or a number should stand here",
                ));
                String::new()
            }
        };
        let mut item = Chunk::indexed("ListItem", n);
        item.set("Expression", expression);
        item.set("Name", name.as_str());
        item.set("Selected", *selected);
        container.set_child(item);
        n += 1;
        chosen |= *selected;
        false
    });
    // A menu always stands at something.
    if !chosen
        && mode != 0
        && let Some(first) = container.child_at_mut("ListItem", 0)
    {
        first.set("Selected", true);
    }
    container.set("ListCount", n);
    container.set("ListMode", mode);
}

const FONT: &str = "Microsoft Sans Serif";

fn scribble(own: &mut Own<'_, '_>, container: &mut Chunk) {
    let text = own.take(text_of).unwrap_or_default();
    container.set("Text", text);
    container.set("Size", ItemValue::Single(own.number("size").unwrap_or(14.0) as f32));
    container.set("Font", own.text("font").unwrap_or_else(|| FONT.to_owned()));
    container.set("Bold", own.boolean("bold").unwrap_or(false));
    container.set("Italic", own.boolean("italic").unwrap_or(false));
}

/// The arguments that say an object's own settings, as far as they go.
pub(super) fn print(object: &Object) -> Vec<String> {
    let c = object.container();
    match object.component {
        ids::NUMBER_SLIDER => print_slider(c),
        ids::PANEL => print_panel(c),
        ids::BOOLEAN_TOGGLE => c.bool("ToggleValue").map(|on| on.to_string()).into_iter().collect(),
        ids::BOOLEAN_TOGGLE_2 => c.bool("SwitchValue").map(|on| on.to_string()).into_iter().collect(),
        ids::COLOUR_SWATCH => c.colour("SwatchColor").map(colour_form).into_iter().collect(),
        ids::VALUE_LIST => print_value_list(c),
        ids::CALENDAR => c.date("LocalDate").map(|ticks| quoted(DateTime { ticks }, 0)).into_iter().collect(),
        ids::CLOCK => c.date("LocalTime").map(|ticks| quoted(DateTime { ticks }, 1)).into_iter().collect(),
        ids::EXPRESSION => c.str("Expression").map(|text| string_form(text, 0)).into_iter().collect(),
        ids::SCRIBBLE => print_scribble(c),
        ids::GEOMETRY_PIPELINE => pipeline::print(c),
        ids::TRIGGER | ids::DATA_RECORDER | ids::DATA_DAM => timing::print(object.component, c),
        _ => Vec::new(),
    }
}

/// A part of a moment in quotes: 0 the day, 1 the time.
fn quoted(moment: DateTime, part: usize) -> String {
    let text = moment.to_string();
    text::quote(text.split(' ').nth(part).unwrap_or_default(), '"')
}

/// Whether plain values among the arguments are settings, so that the port's own must not stand there.
pub(super) fn has_settings(component: Uuid) -> bool {
    [
        ids::NUMBER_SLIDER,
        ids::PANEL,
        ids::BOOLEAN_TOGGLE,
        ids::BOOLEAN_TOGGLE_2,
        ids::COLOUR_SWATCH,
        ids::VALUE_LIST,
        ids::CALENDAR,
        ids::CLOCK,
        ids::SCRIBBLE,
    ]
    .contains(&component)
}

fn print_slider(c: &Chunk) -> Vec<String> {
    let Some(chunk) = c.child("Slider") else { return Vec::new() };
    let (Some(value), Some(min), Some(max)) = (chunk.f64("Value"), chunk.f64("Min"), chunk.f64("Max")) else {
        return Vec::new();
    };
    let kept = chunk.i32("Digits").unwrap_or(DIGITS);
    let rounding = chunk.i32("Interval").unwrap_or(0);
    let mut number = plain(value);
    if rounding == 0 && value.is_finite() && value.abs() < 1e15 {
        let padded = format!("{value:.*}", usize::try_from(kept.clamp(0, 12)).unwrap_or(0));
        if padded.parse() == Ok(value) {
            number = padded;
        }
    }
    let range = format!("{}..{}", plain(min), plain(max));
    let digits = |text: &str| {
        if text.contains('e') { 0 } else { text.split_once('.').map_or(0, |(_, d)| d.len()) }
    };
    let written = digits(&number).max(digits(&plain(min))).max(digits(&plain(max)));
    let mut arguments = vec![number, range];
    let inferred = i32::from(written == 0);
    if rounding != inferred
        && let Some(word) = usize::try_from(rounding).ok().and_then(|k| ROUNDING.get(k))
    {
        arguments.push(format!("rounding = {word}"));
    }
    if rounding == 0 && i32::try_from(written.min(12)) != Ok(kept) {
        arguments.push(format!("digits = {kept}"));
    }
    if let Some(expression) = chunk.str("Expression") {
        arguments.push(format!("expression = {}", text::quote(expression, '"')));
    }
    arguments
}

fn print_panel(c: &Chunk) -> Vec<String> {
    let mut arguments = Vec::new();
    if let Some(text) = c.str("UserText").filter(|text| *text != PANEL_TEXT) {
        arguments.push(string_form(text, 0));
    }
    let Some(chunk) = c.child("PanelProperties") else { return arguments };
    if chunk.bool("Multiline") == Some(false) {
        arguments.push("lines = true".to_owned());
    }
    if let Some(colour) = chunk.colour("Colour").filter(|colour| *colour != PANEL_COLOUR) {
        arguments.push(format!("colour = {}", colour_form(colour)));
    }
    if chunk.bool("Stream") == Some(true)
        && let Some(path) = chunk.str("StreamPath").filter(|path| !path.trim().is_empty())
    {
        arguments.push(format!("stream = {}", text::quote(path, '"')));
    }
    arguments
}

fn print_value_list(c: &Chunk) -> Vec<String> {
    let mut arguments = Vec::new();
    for item in c.children("ListItem") {
        let text = |name| item.str(name).unwrap_or_default();
        let mark = if item.bool("Selected") == Some(true) { "* " } else { "" };
        let expression = text("Expression");
        // A number that reads back as the same text needs no quotes.
        let bare = expression.parse().is_ok_and(|x: f64| x.is_finite() && plain(x) == expression);
        let value = if bare { expression.to_owned() } else { text::quote(expression, '"') };
        arguments.push(format!("{mark}{}: {value}", text::quote(text("Name"), '"')));
    }
    let mode = c.i32("ListMode").unwrap_or(1);
    if mode != 1
        && let Some(word) = usize::try_from(mode).ok().and_then(|k| MODES.get(k))
    {
        arguments.push(format!("mode = {word}"));
    }
    arguments
}

fn print_scribble(c: &Chunk) -> Vec<String> {
    let mut arguments: Vec<String> = c.str("Text").map(|text| string_form(text, 0)).into_iter().collect();
    if let Some(size) = c.f64("Size").filter(|size| *size != 14.0) {
        arguments.push(format!("size = {}", plain(size)));
    }
    if let Some(font) = c.str("Font").filter(|font| *font != FONT) {
        arguments.push(format!("font = {}", text::quote(font, '"')));
    }
    for (name, item) in [("bold", "Bold"), ("italic", "Italic")] {
        if c.bool(item) == Some(true) {
            arguments.push(format!("{name} = true"));
        }
    }
    arguments
}
