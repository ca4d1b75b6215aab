//! Sliders, panels, lists and all else that has a face of its own.

use katydid_definition::archive::{Chunk, Colour as Argb, ItemValue};
use katydid_definition::document::{Object, Special, ids, parse_path};

use super::{bounded, finite, graphs, make, objects};
use crate::Refusal;
use crate::editor::Draft;
use crate::protocol::{
    BorderView, Colour, Control, GripView, ListItemView, ListModeView, PanelChange, RoundingView, Setting,
};
use crate::view::size;

/// The most letters of a text that a control holds.
const MOST_LETTERS: usize = 10_000_000;
/// The most items of a list.
const MOST_ITEMS: usize = 10_000;

/// The archive's order of a colour's parts.
pub(super) fn argb([r, g, b, a]: Colour) -> Argb {
    Argb::new(a, r, g, b)
}

fn unfit(object: &Object, reason: &str) -> Refusal {
    Refusal::Unfit { object: object.title().to_owned(), reason: reason.to_owned() }
}

fn short(text: &str) -> Result<&str, Refusal> {
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
                _ => object.set_dial(*value).map(drop)?,
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
            Control::Panel { text, multiline, paths, indices, wrap, special_codes, alignment, colour },
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
            ] {
                panel_property(object, &change)?;
            }
        }
        (Control::Toggle { on }, Some(Special::Toggle(_))) => object.set_toggle(*on)?,
        (Control::Button { normal, pressed }, Some(Special::Button(_))) => {
            let container = object.container_mut();
            container.set("ExpressionNormal", short(normal)?);
            container.set("ExpressionPressed", short(pressed)?);
        }
        (Control::ValueList { mode, items }, Some(Special::ValueList(_))) => {
            value_list(object, *mode, items)?
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
            object.set_dial(*value)?;
        }
        (Control::Digits { value, digits, radix, prefix, suffix }, Some(Special::DigitScroller(_))) => {
            finite(&[*value])?;
            let scroller = part(object, "Scroller")?;
            scroller.set("Digits", (*digits).clamp(1, 28));
            scroller.set("Radix", (*radix).clamp(0, 28));
            scroller.set("Prefix", short(prefix)?);
            scroller.set("Suffix", short(suffix)?);
            object.set_dial(*value)?;
        }
        (Control::Genes { values, decimals, min, max }, Some(Special::GenePool(_))) => {
            genes(object, values, *decimals, *min, *max)?;
        }
        (Control::Graph { x, y, graph, .. }, Some(Special::GraphMapper(_))) => {
            graphs::shape(object, *x, *y, graph)?
        }
        (Control::Gradient { grips, linear }, Some(Special::Gradient(_))) => {
            gradient(object, grips, *linear)?
        }
        (Control::Image { file, .. }, Some(Special::ImageSampler(_))) => {
            object.container_mut().set("FilePath", short(file)?);
        }
        (Control::Formula { text }, Some(Special::Expression(_))) => {
            object.container_mut().set("Expression", short(text)?);
        }
        (Control::Paths { rules }, Some(Special::PathMapper(_))) => paths(object, rules)?,
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
            sketch(object, lines, *colour, *width)?
        }
        (Control::Script { .. } | Control::Viewer { .. }, _) => {
            return Err(unfit(object, "this cannot be changed here"));
        }
        _ => return Err(unfit(object, "it is not a control of that kind")),
    }
    object.refresh();
    Ok(())
}

/// The chunk of a control's settings, which is made where it is missing.
fn part<'a>(object: &'a mut Object, name: &str) -> Result<&'a mut Chunk, Refusal> {
    let gone = unfit(object, "its settings are missing");
    let container = object.container_mut();
    if container.child(name).is_none() {
        container.set_child(Chunk::new(name));
    }
    container.child_mut(name).ok_or(gone)
}

/// A number in the form that is there.
fn number(chunk: &mut Chunk, name: &str, x: f64) {
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

fn value_list(object: &mut Object, mode: ListModeView, items: &[ListItemView]) -> Result<(), Refusal> {
    if items.len() > MOST_ITEMS {
        return Err(unfit(object, &format!("a list has at most {MOST_ITEMS} items")));
    }
    let mut one = items.iter().position(|item| item.selected);
    if mode != ListModeView::Check && one.is_none() && !items.is_empty() {
        one = Some(0);
    }
    let container = object.container_mut();
    container.remove_children("ListItem");
    for (k, item) in items.iter().enumerate() {
        let mut chunk = Chunk::indexed("ListItem", i32::try_from(k).unwrap_or(i32::MAX));
        chunk.set("Expression", short(&item.expression)?);
        chunk.set("Name", short(&item.name)?);
        chunk.set("Selected", if mode == ListModeView::Check { item.selected } else { one == Some(k) });
        container.chunks.push(chunk);
    }
    container.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    container.set("ListCount", i32::try_from(items.len()).unwrap_or(i32::MAX));
    container.set(
        "ListMode",
        match mode {
            ListModeView::Check => 0,
            ListModeView::DropDown => 1,
            ListModeView::Sequence => 2,
            ListModeView::Cycle => 3,
        },
    );
    Ok(())
}

fn genes(object: &mut Object, values: &[f64], decimals: i32, min: f64, max: f64) -> Result<(), Refusal> {
    finite(values)?;
    finite(&[min, max])?;
    if values.len() > MOST_ITEMS || min > max {
        return Err(unfit(object, "a pool has at most ten thousand numbers between its limits"));
    }
    let places = u32::try_from(decimals.clamp(0, 12)).unwrap_or(2);
    let pool = part(object, "GeneData")?;
    pool.remove("Value");
    for (k, x) in (0..).zip(values) {
        pool.items.push(katydid_definition::archive::Item::indexed(
            "Value",
            k,
            make::decimal(x.clamp(min, max), places),
        ));
    }
    pool.set("Count", i32::try_from(values.len()).unwrap_or(i32::MAX));
    pool.set("Decimals", decimals.clamp(0, 12));
    number(pool, "Minimum", min);
    number(pool, "Maximum", max);
    Ok(())
}

fn gradient(object: &mut Object, grips: &[GripView], linear: bool) -> Result<(), Refusal> {
    let at: Vec<f64> = grips.iter().map(|grip| grip.at).collect();
    finite(&at)?;
    if grips.len() > MOST_ITEMS {
        return Err(unfit(object, "a gradient has at most ten thousand grips"));
    }
    let gradient = part(object, "Gradient")?;
    let old: Vec<Chunk> = gradient.children("Grip").into_iter().cloned().collect();
    gradient.remove_children("Grip");
    for (k, grip) in grips.iter().enumerate() {
        // Grips have ids of their own, which stay.
        let index = i32::try_from(k).unwrap_or(i32::MAX);
        let mut chunk = old.get(k).cloned().unwrap_or_else(|| Chunk::new("Grip"));
        chunk.index = Some(index);
        if chunk.guid("Id").is_none() {
            chunk.set("Id", katydid_definition::kd::derived_id(uuid::Uuid::nil(), &format!("grip {k}")));
        }
        chunk.set("Factor", grip.at.clamp(0.0, 1.0));
        chunk.set_at("Colour", 0, argb(grip.left));
        chunk.set_at("Colour", 1, argb(grip.right));
        gradient.set_child(chunk);
    }
    gradient.set("GripCount", i32::try_from(grips.len()).unwrap_or(i32::MAX));
    gradient.set("Linear", linear);
    Ok(())
}

/// A new gradient: places and colours.
pub(super) fn put_gradient(container: &mut Chunk, grips: &[(f64, Colour)]) {
    let mut gradient = Chunk::new("Gradient");
    gradient.set("GripCount", i32::try_from(grips.len()).unwrap_or(0));
    gradient.set("Linear", true);
    gradient.set("Locked", false);
    for (k, (at, colour)) in (0..).zip(grips) {
        let mut grip = Chunk::indexed("Grip", k);
        grip.set("Factor", *at);
        grip.set("Id", katydid_definition::kd::derived_id(uuid::Uuid::nil(), &format!("grip {k}")));
        grip.set_at("Colour", 0, argb(*colour));
        grip.set_at("Colour", 1, argb(*colour));
        gradient.set_child(grip);
    }
    container.set_child(gradient);
}

fn paths(object: &mut Object, rules: &[[String; 2]]) -> Result<(), Refusal> {
    if rules.len() > MOST_ITEMS {
        return Err(unfit(object, "it has at most ten thousand rules"));
    }
    let lexers = part(object, "lexers")?;
    lexers.remove("source");
    lexers.remove("target");
    for (k, [source, target]) in (0..).zip(rules) {
        lexers.set_at("source", k, short(source)?);
        lexers.set_at("target", k, short(target)?);
    }
    lexers.set("lexer_count", i32::try_from(rules.len()).unwrap_or(i32::MAX));
    Ok(())
}

fn sketch(object: &mut Object, lines: &[Vec<[f64; 2]>], colour: Colour, width: f64) -> Result<(), Refusal> {
    const MOST_POINTS: usize = 1_000_000;
    finite(&[width])?;
    if lines.iter().map(Vec::len).sum::<usize>() > MOST_POINTS {
        return Err(unfit(object, "a sketch has at most a million points"));
    }
    for line in lines {
        finite(line.as_flattened())?;
    }
    let container = object.container_mut();
    container.remove_children("Mark");
    for (k, line) in (0..).zip(lines) {
        let mut mark = Chunk::indexed("Mark", k);
        for (i, point) in (0..).zip(line) {
            let value = ItemValue::Point2d(*point);
            mark.items.push(katydid_definition::archive::Item::indexed("V", i, value));
        }
        mark.set("VertexCount", i32::try_from(line.len()).unwrap_or(i32::MAX));
        container.chunks.push(mark);
    }
    container.set("MarkCount", i32::try_from(lines.len()).unwrap_or(i32::MAX));
    let attributes = part(object, "Attributes")?;
    if attributes.child("SketchProperties").is_none() {
        attributes.set_child(Chunk::new("SketchProperties"));
    }
    if let Some(properties) = attributes.child_mut("SketchProperties") {
        properties.set("Color", argb(colour));
        number(properties, "Width", width);
    }
    Ok(())
}

/// Changes how a panel looks.
pub(super) fn change_panel(
    draft: &mut Draft<'_>,
    id: uuid::Uuid,
    change: &PanelChange,
) -> Result<(), Refusal> {
    let object = draft.object(id)?;
    if object.component != ids::PANEL {
        return Err(unfit(object, "it is not a Panel"));
    }
    panel_property(object, change)?;
    object.refresh();
    Ok(())
}

fn panel_property(object: &mut Object, change: &PanelChange) -> Result<(), Refusal> {
    let Some(Special::Panel(panel)) = object.special() else {
        return Err(unfit(object, "it is not a Panel"));
    };
    let (name, value, same) = match change {
        PanelChange::Multiline { on } => ("Multiline", ItemValue::Bool(*on), panel.multiline == *on),
        PanelChange::Paths { on } => ("DrawPaths", ItemValue::Bool(*on), panel.draw_paths == *on),
        PanelChange::Indices { on } => ("DrawIndices", ItemValue::Bool(*on), panel.draw_indices == *on),
        PanelChange::Wrap { on } => ("Wrap", ItemValue::Bool(*on), panel.wrap == *on),
        PanelChange::SpecialCodes { on } => {
            ("SpecialCodes", ItemValue::Bool(*on), panel.special_codes == *on)
        }
        PanelChange::Alignment { alignment } if !(0..=2).contains(alignment) => {
            return Err(unfit(object, "text stands left, in the middle or right"));
        }
        PanelChange::Alignment { alignment } => {
            ("Alignment", ItemValue::Int32(*alignment), panel.alignment == *alignment)
        }
        PanelChange::Colour { colour } => {
            ("Colour", ItemValue::Colour(argb(*colour)), panel.colour == Some(argb(*colour)))
        }
    };
    if !same {
        part(object, "PanelProperties")?.set(name, value);
    }
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
