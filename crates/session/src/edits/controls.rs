//! Sliders, panels, lists and all else that has a face of its own.

use katydid_data::DateTime;
use katydid_definition::archive::{Chunk, Colour as Argb, ItemValue};
use katydid_definition::document::{Object, Special, ids, parse_path};

use super::{bounded, finite, graphs, lists, make, objects, panel, scripts};
use crate::Refusal;
use crate::editor::Draft;
use crate::protocol::{BorderView, Colour, Control, PanelChange, RoundingView, Setting};
use crate::view::size;

/// The most letters of a text that a control holds.
const MOST_LETTERS: usize = 10_000_000;

/// The archive's order of a colour's parts.
pub(super) fn argb([r, g, b, a]: Colour) -> Argb {
    Argb::new(a, r, g, b)
}

pub(super) fn unfit(object: &Object, reason: &str) -> Refusal {
    Refusal::Unfit { object: object.title().to_owned(), reason: reason.to_owned() }
}

pub(super) fn short(text: &str) -> Result<&str, Refusal> {
    if text.len() <= MOST_LETTERS {
        Ok(text)
    } else {
        Err(Refusal::Senseless(format!("a text has at most {MOST_LETTERS} bytes")))
    }
}

/// Gives a control a new value.
pub(super) fn set(draft: &mut Draft<'_>, id: uuid::Uuid, to: &Setting) -> Result<(), Refusal> {
    let object = draft.object(id)?;
    let before = object.clone();
    match to {
        Setting::Number { value } => {
            finite(&[*value])?;
            match object.component {
                ids::NUMBER_SLIDER => object.set_slider(*value).map(drop)?,
                _ => turn(object, *value)?,
            }
        }
        Setting::Text { text } => object.set_panel_text(short(text)?)?,
        Setting::Switch { on } => object.set_toggle(*on)?,
        // The session keeps this for as long as the button is held: nothing of the document changes.
        Setting::Press { .. } if object.component == ids::BUTTON => {}
        Setting::Press { .. } => return Err(unfit(object, "it is not a Button")),
        Setting::Choose { chosen } => {
            bounded(chosen)?;
            let mut chosen: Vec<usize> = chosen.iter().filter_map(|k| usize::try_from(*k).ok()).collect();
            chosen.sort_unstable();
            chosen.dedup();
            object.select(&chosen)?;
        }
        Setting::Colour { colour } => object.set_colour(argb(*colour))?,
        Setting::Place { value } => object.set_md_slider(*value)?,
        Setting::Gene { index, value } => {
            finite(&[*value])?;
            object.set_gene(usize::try_from(*index).unwrap_or(usize::MAX), *value)?;
        }
        Setting::Date { date } => object.set_calendar(*date)?,
        Setting::Time { seconds } => set_clock(object, *seconds)?,
    }
    if *object == before {
        *object = before;
    } else {
        object.refresh();
    }
    Ok(())
}

/// Gives a control another form.
pub(super) fn reshape(draft: &mut Draft<'_>, id: uuid::Uuid, control: &Control) -> Result<(), Refusal> {
    let object = draft.object(id)?;
    let natural = size::natural(object);
    let before = object.clone();
    shape(object, control)?;
    if *object == before {
        *object = before;
        return Ok(());
    }
    // A list becomes as wide as its items; a pool as high.
    let (now, bounds) = (size::natural(object), object.bounds);
    if let (true, Some([x, y, w, h])) = (matches!(object.component, ids::VALUE_LIST | ids::GENE_POOL), bounds)
    {
        let pivot = object.pivot.unwrap_or([x, y]);
        let grown = [(w + now[0] - natural[0]).max(40.0), (h + now[1] - natural[1]).max(16.0)];
        object.set_place([x, y, grown[0], grown[1]], pivot);
    }
    if object.component == ids::SCRIBBLE
        && matches!(control, Control::Scribble { corners, .. } if flat(corners))
    {
        let corner = object.container().canvas_point("Ca").unwrap_or_default();
        objects::shape_scribble(object, corner);
    }
    Ok(())
}

/// Whether corners enclose nothing: a face that does not know how large letters are sends them so.
fn flat(corners: &[[f32; 2]; 4]) -> bool {
    corners.iter().all(|corner| corner == &corners[0])
}

/// Puts the settings of a control into an object.
pub(super) fn shape(object: &mut Object, control: &Control) -> Result<(), Refusal> {
    let special = object.special();
    match (control, &special) {
        (Control::Slider { value, min, max, rounding, digits, expression }, Some(Special::Slider(_))) => {
            slider(object, [*value, *min, *max], *rounding, *digits, expression.as_deref())?;
        }
        (
            Control::Panel {
                text,
                multiline,
                paths,
                indices,
                wrap,
                special_codes,
                alignment,
                colour,
                stream,
            },
            Some(Special::Panel(panel)),
        ) => {
            if *text != panel.text {
                object.set_panel_text(short(text)?)?;
            }
            for change in [
                PanelChange::Multiline { on: *multiline },
                PanelChange::Paths { on: *paths },
                PanelChange::Indices { on: *indices },
                PanelChange::Wrap { on: *wrap },
                PanelChange::SpecialCodes { on: *special_codes },
                PanelChange::Alignment { alignment: *alignment },
                PanelChange::Colour { colour: *colour },
                PanelChange::Stream { file: stream.clone() },
            ] {
                panel::property(object, &change)?;
            }
        }
        (Control::Toggle { on }, Some(Special::Toggle(_))) => object.set_toggle(*on)?,
        (Control::Button { normal, pressed }, Some(Special::Button(_))) => {
            let container = object.container_mut();
            container.set("ExpressionNormal", short(normal)?);
            container.set("ExpressionPressed", short(pressed)?);
        }
        (Control::ValueList { mode, items }, Some(Special::ValueList(_))) => {
            lists::value_list(object, *mode, items)?
        }
        (Control::Swatch { colour }, Some(Special::Colour(_))) => object.set_colour(argb(*colour))?,
        (Control::MdSlider { value, domains }, Some(Special::MdSlider(_))) => {
            finite(domains.as_flattened())?;
            object.set_md_slider(*value)?;
            for (name, domain) in ["x_domain", "y_domain", "z_domain"].into_iter().zip(domains) {
                object.container_mut().set(name, ItemValue::Interval1d(*domain));
            }
        }
        (Control::Knob { value, min, max, limited, range, decimals }, Some(Special::Knob(_))) => {
            finite(&[*value, *min, *max, *range])?;
            let dial = part(object, "DialData")?;
            for (name, x) in [("Minimum", min), ("Maximum", max), ("Range", range)] {
                number(dial, name, *x);
            }
            dial.set("Limit", *limited);
            dial.set("Decimals", (*decimals).clamp(0, 12));
            turn(object, *value)?;
        }
        (Control::Digits { value, digits, radix, prefix, suffix }, Some(Special::DigitScroller(_))) => {
            finite(&[*value])?;
            let scroller = part(object, "Scroller")?;
            scroller.set("Digits", (*digits).clamp(1, 28));
            scroller.set("Radix", (*radix).clamp(0, 28));
            scroller.set("Prefix", short(prefix)?);
            scroller.set("Suffix", short(suffix)?);
            turn(object, *value)?;
        }
        (Control::Calendar { date, .. }, Some(Special::Calendar(_))) => object.set_calendar(*date)?,
        (Control::Clock { seconds }, Some(Special::Clock(_))) => set_clock(object, *seconds)?,
        (Control::Genes { values, decimals, min, max }, Some(Special::GenePool(_))) => {
            lists::genes(object, values, *decimals, *min, *max)?;
        }
        (Control::Graph { x, y, graph, .. }, Some(Special::GraphMapper(_))) => {
            graphs::shape(object, *x, *y, graph)?
        }
        (Control::Gradient { grips, linear }, Some(Special::Gradient(_))) => {
            lists::gradient(object, grips, *linear)?
        }
        (Control::Image { file, .. }, Some(Special::ImageSampler(_))) => {
            object.container_mut().set("FilePath", short(file)?);
        }
        (Control::Formula { text }, Some(Special::Expression(_))) => {
            object.container_mut().set("Expression", short(text)?);
        }
        (Control::Paths { rules }, Some(Special::PathMapper(_))) => lists::paths(object, rules)?,
        (Control::Cherry { path, index }, Some(Special::CherryPicker(_))) => {
            let path = parse_path(path).ok_or_else(|| unfit(object, "a path looks like {0;1}"))?;
            part(object, "TreePath")?.set("path", katydid_definition::document::format_path(&path));
            object.container_mut().set("ListIndex", *index);
        }
        (Control::Recorder { recording, limit }, Some(Special::DataRecorder(_))) => {
            let container = object.container_mut();
            container.set("RecordData", *recording);
            container.set("DataLimit", limit.unwrap_or(-1));
        }
        (Control::Contextual { prompt, minimum, maximum }, Some(Special::Contextual(_))) => {
            object.container_mut().set("Prompt", short(prompt)?);
            for (name, x) in [("Minimum", minimum), ("Maximum", maximum)] {
                match x {
                    Some(x) => {
                        finite(&[*x])?;
                        number(object.container_mut(), name, *x);
                    }
                    None => {
                        object.container_mut().remove(name);
                    }
                }
            }
        }
        (Control::Group { label, colour, border, members }, Some(Special::Group(_))) => {
            super::groups::shape(object, label, *colour, *border, members)?;
        }
        (Control::Scribble { text, font, size, bold, italic, corners }, Some(Special::Scribble(_))) => {
            finite(&[*size])?;
            super::sound(corners.as_flattened())?;
            if !(1.0..=1000.0).contains(size) {
                return Err(unfit(object, "letters are between 1 and 1000 points high"));
            }
            let container = object.container_mut();
            container.set("Text", short(text)?);
            container.set("Font", short(font)?);
            container.set("Size", ItemValue::Single(*size as f32));
            container.set("Bold", *bold);
            container.set("Italic", *italic);
            if !flat(corners) {
                for (name, corner) in ["Ca", "Cb", "Cc", "Cd"].into_iter().zip(corners) {
                    container.set(name, ItemValue::PointF(*corner));
                }
            }
        }
        (Control::Sketch { lines, colour, width }, Some(Special::Sketch(_))) => {
            lists::sketch(object, lines, *colour, *width)?
        }
        (Control::Script { text, additional, using, .. }, _) => {
            scripts::write(object, text, [additional.as_deref(), using.as_deref()])?;
        }
        _ => return Err(unfit(object, "it is not a control of that kind")),
    }
    object.refresh();
    Ok(())
}

/// Turns a knob or scroller. One that stands there already keeps its number as it is written.
fn turn(object: &mut Object, value: f64) -> Result<(), Refusal> {
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

/// Sets a clock to so many seconds since midnight, to the tick.
fn set_clock(object: &mut Object, seconds: f64) -> Result<(), Refusal> {
    finite(&[seconds])?;
    // Beyond what a day has the conversion saturates, and is refused.
    object.set_clock((seconds * DateTime::SECOND as f64).round() as i64)?;
    Ok(())
}

/// The chunk of a control's settings, which is made where it is missing.
pub(super) fn part<'a>(object: &'a mut Object, name: &str) -> Result<&'a mut Chunk, Refusal> {
    let gone = unfit(object, "its settings are missing");
    let container = object.container_mut();
    if container.child(name).is_none() {
        container.set_child(Chunk::new(name));
    }
    container.child_mut(name).ok_or(gone)
}

/// A number in the form that is there.
pub(super) fn number(chunk: &mut Chunk, name: &str, x: f64) {
    let value = match chunk.item(name) {
        Some(ItemValue::Decimal(old)) => make::decimal(x, old.scale().max(6)),
        Some(ItemValue::Single(_)) => ItemValue::Single(x as f32),
        Some(ItemValue::Int32(_)) if x.fract() == 0.0 && x.abs() < 2e9 => ItemValue::Int32(x as i32),
        _ => ItemValue::Double(x),
    };
    chunk.set(name, value);
}

fn slider(
    object: &mut Object,
    [value, min, max]: [f64; 3],
    rounding: RoundingView,
    digits: u32,
    expression: Option<&str>,
) -> Result<(), Refusal> {
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
    Ok(())
}

/// The shape of a group's frame, by its number in the file.
pub(super) fn border(border: BorderView) -> i32 {
    match border {
        BorderView::Box => 1,
        BorderView::Blob => 2,
        BorderView::Rectangle => 3,
    }
}
