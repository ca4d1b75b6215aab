//! Objects that their users set, and those that show data: sliders, toggles, lists, colours, graphs, matrices.

use katydid_data::{Colour, Value, text};
use katydid_definition::document::Special;
use katydid_definition::document::special::{
    Gradient, Graph, GraphMapper, Knob, ListMode, MdSlider, Rounding, Slider, ValueList,
};
use katydid_elementary::Elementary;
use uuid::{Uuid, uuid};

use super::capsule::{body, grips, middle, titled, window};
use super::{Placed, charts, moments, theme};
use crate::drawing::{Anchor, Item, Label, Path, Shape, blend};
use crate::font;
use crate::project::gradient;
use katydid_scene::colour::of_archive as colour;

const DISPLAY_MATRIX: Uuid = uuid!("b6d27aa4-a61f-4d08-b76e-1105fef0e9e4");

/// An object with settings of its own; `None` for one that looks like any other.
pub(super) fn draw(one: &Placed<'_>, special: &Special) -> Option<Vec<Item>> {
    let mut items = match special {
        Special::Slider(slider) => self::slider(one, slider),
        Special::Toggle(on) => pill(one, if *on { "True" } else { "False" }, *on),
        Special::Button(_) => pill(one, "Button", false),
        Special::Colour(c) => swatch(one, colour(*c)),
        Special::ValueList(list) => value_list(one, list),
        Special::Gradient(g) => strip(one, g),
        Special::MdSlider(slider) => md_slider(one, slider),
        Special::Knob(knob) => self::knob(one, knob),
        Special::DigitScroller(scroller) => pill(
            one,
            &format!("{}{}{}", scroller.prefix, text::number(scroller.value), scroller.suffix),
            false,
        ),
        Special::Calendar(calendar) => moments::calendar(one, calendar),
        Special::Clock(clock) => moments::clock(one, clock),
        Special::GenePool(pool) => bars(one, &pool.values, [pool.min, pool.max]),
        Special::GraphMapper(mapper) => graph(one, mapper),
        _ => return None,
    };
    items.extend(grips(one));
    Some(items)
}

/// An object that shows its data.
pub(super) fn shown(one: &Placed<'_>) -> Option<Vec<Item>> {
    let mut items = match one.object.component {
        DISPLAY_MATRIX => matrix(one)?,
        _ => return charts::draw(one),
    };
    items.extend(grips(one));
    Some(items)
}

/// A number with a slider's digits.
fn slider_text(slider: &Slider, x: f64) -> String {
    let digits = if slider.rounding == Rounding::Real { slider.digits as usize } else { 0 };
    format!("{x:.digits$}")
}

fn slider(one: &Placed<'_>, slider: &Slider) -> Vec<Item> {
    let (mut items, [x, y, w, h]) = titled(one, 0.45 * one.frame.rect[2]);
    let range = slider.max - slider.min;
    let t = if range.abs() > 0.0 { ((slider.value - slider.min) / range).clamp(0.0, 1.0) } else { 0.5 };
    let t = if t.is_finite() { t } else { 0.5 };
    items.push(Shape::filled(Path::rounded([x, y + 1.0, w - 1.0, h - 2.0], 3.0), theme::PAPER).into());
    // The number stands behind the track, with room for the longest there can be.
    let text = slider_text(slider, slider.value);
    let ends = [slider.min, slider.max].map(|x| font::width(&slider_text(slider, x), theme::NAME));
    let wide = ends[0].max(ends[1]).max(font::width(&text, theme::NAME));
    let room = (wide + 8.0).min(0.6 * w);
    let (from, to, cy) = (x + 8.0, x + w - 8.0 - room, y + 0.5 * h);
    let at = from + (to - from) * t;
    items
        .push(Shape::stroked(Path::polyline([[from, cy], [to, cy]]), Colour::rgb(190, 192, 198), 1.2).into());
    items.push(Shape::stroked(Path::polyline([[from, cy], [at, cy]]), theme::EDGE, 2.0).into());
    let r = 0.28 * h.min(24.0);
    let knob = Path::polygon([[at, cy - r], [at + r, cy], [at, cy + r], [at - r, cy]]);
    items.push(Shape::filled(knob, theme::BAND).into());
    let text = font::fitted(&text, theme::NAME, room);
    let label = Label::new([x + w - 6.0, cy + 3.5], text, theme::NAME, theme::INK);
    items.push(label.anchored(Anchor::End).into());
    items
}

fn pill(one: &Placed<'_>, value: &str, on: bool) -> Vec<Item> {
    let (mut items, [x, y, w, h]) = titled(one, font::width(value, theme::NAME) + 16.0);
    let fill = if on { theme::BAND } else { theme::PAPER };
    let ink = if on { theme::WHITE } else { theme::INK };
    let rect = [x + 2.0, y + 3.0, (w - 6.0).max(4.0), (h - 6.0).max(4.0)];
    items.push(Shape::filled(Path::rounded(rect, 6.0), fill).outlined(theme::EDGE, 0.8).into());
    let text = font::fitted(value, theme::NAME, rect[2] - 6.0);
    items.push(middle([rect[0] + 0.5 * rect[2], y + 0.5 * h], text, theme::NAME, ink));
    items
}

fn swatch(one: &Placed<'_>, c: Colour) -> Vec<Item> {
    let (mut items, [x, y, w, h]) = titled(one, 18.0);
    let rect = [x + 2.0, y + 3.0, (w - 6.0).max(4.0), (h - 6.0).max(4.0)];
    items.push(Shape::filled(Path::rounded(rect, 3.0), c).outlined(theme::EDGE, 0.8).into());
    items
}

fn value_list(one: &Placed<'_>, list: &ValueList) -> Vec<Item> {
    let (mut items, [x, y, w, h]) = titled(one, 0.5 * one.frame.rect[2]);
    let rect = [x + 2.0, y + 2.0, (w - 5.0).max(4.0), (h - 4.0).max(4.0)];
    items.push(Shape::filled(Path::rounded(rect, 3.0), theme::PAPER).outlined(theme::EDGE, 0.6).into());
    if list.mode == ListMode::CheckList && !list.items.is_empty() {
        let rows = ((h / 14.0).floor() as usize).clamp(1, list.items.len());
        let step = rect[3] / rows as f64;
        for (k, item) in list.items.iter().take(rows).enumerate() {
            let cy = rect[1] + step * (k as f64 + 0.5);
            let square = Path::rectangle([rect[0] + 4.0, cy - 3.5, 7.0, 7.0]);
            let fill = if item.selected { theme::BAND } else { theme::PAPER };
            items.push(Shape::filled(square, fill).outlined(theme::EDGE, 0.8).into());
            let text = font::fitted(&item.name, theme::PORT, rect[2] - 20.0);
            items.push(Label::new([rect[0] + 15.0, cy + 3.2], text, theme::PORT, theme::INK).into());
        }
        return items;
    }
    let chosen = list.items.iter().find(|item| item.selected).map_or("", |item| item.name.as_str());
    let cy = y + 0.5 * h;
    let text = font::fitted(chosen, theme::NAME, rect[2] - 22.0);
    items.push(Label::new([rect[0] + 6.0, cy + 3.5], text, theme::NAME, theme::INK).into());
    let tip = rect[0] + rect[2] - 9.0;
    let arrow = Path::polygon([[tip - 4.0, cy - 2.0], [tip + 4.0, cy - 2.0], [tip, cy + 3.0]]);
    items.push(Shape::filled(arrow, theme::EDGE).into());
    items
}

fn strip(one: &Placed<'_>, g: &Gradient) -> Vec<Item> {
    const PARTS: u32 = 48;
    let (mut items, [x, y, w, h]) = window(one);
    let grips: Vec<(f64, Colour, Colour)> =
        g.grips.iter().map(|grip| (grip.at, colour(grip.left), colour(grip.right))).collect();
    let step = w / f64::from(PARTS);
    for k in 0..PARTS {
        let at = (f64::from(k) + 0.5) / f64::from(PARTS);
        let part = Path::rectangle([x + step * f64::from(k), y, step + 0.3, h]);
        items.push(Shape::filled(part, gradient(&grips, at)).into());
    }
    items
}

fn md_slider(one: &Placed<'_>, slider: &MdSlider) -> Vec<Item> {
    let (mut items, [x, y, w, h]) = window(one);
    let [u, v, _] = slider.value.map(|t| if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.5 });
    let at = [x + u * w, y + (1.0 - v) * h];
    let faint = blend(theme::PAPER, theme::EDGE, 0.4);
    items.push(Shape::stroked(Path::polyline([[x, at[1]], [x + w, at[1]]]), faint, 0.8).into());
    items.push(Shape::stroked(Path::polyline([[at[0], y], [at[0], y + h]]), faint, 0.8).into());
    items.push(Shape::filled(Path::circle(at, 4.0), theme::BAND).into());
    items
}

fn knob(one: &Placed<'_>, knob: &Knob) -> Vec<Item> {
    let mut items = body(one, theme::capsule(one).0);
    let [x, y, w, h] = one.frame.rect;
    let (cx, cy, r) = (x + 0.5 * w, y + 0.5 * h, 0.38 * w.min(h));
    items.push(Shape::filled(Path::circle([cx, cy], r), theme::PAPER).outlined(theme::EDGE, 1.0).into());
    let range = if knob.range.abs() > 0.0 { knob.range } else { 1.0 };
    let (sin, cos) = (std::f64::consts::TAU * (knob.value / range)).sine_cosine();
    if sin.is_finite() {
        let tip = [cx + 0.9 * r * sin, cy - 0.9 * r * cos];
        items.push(Shape::stroked(Path::polyline([[cx, cy], tip]), theme::EDGE, 1.6).into());
    }
    let label = Label::new([cx, cy + 3.5], text::number(knob.value), theme::NAME, theme::INK);
    items.push(label.with_halo(theme::PAPER).anchored(Anchor::Middle).into());
    items
}

fn bars(one: &Placed<'_>, values: &[f64], [min, max]: [f64; 2]) -> Vec<Item> {
    let (mut items, [x, y, w, h]) = window(one);
    let shown = values.len().min(((h / 3.0).floor() as usize).max(1));
    let step = h / shown.max(1) as f64;
    for (k, value) in values.iter().take(shown).enumerate() {
        let t = ((value - min) / (max - min)).clamp(0.0, 1.0);
        if t.is_finite() {
            let bar = Path::rectangle([x, y + step * k as f64 + 0.5, w * t, (step - 1.0).max(0.5)]);
            items.push(Shape::filled(bar, blend(theme::PAPER, theme::EDGE, 0.55)).into());
        }
    }
    items
}

/// The curve of a graph mapper in its square; the name of one whose curve is more than a few numbers.
fn graph(one: &Placed<'_>, mapper: &GraphMapper) -> Vec<Item> {
    let (mut items, rect) = window(one);
    let [x, y, w, h] = rect;
    let at = |[u, v]: [f64; 2]| [x + u.clamp(0.0, 1.0) * w, y + (1.0 - v.clamp(0.0, 1.0)) * h];
    let sampled =
        |f: &dyn Fn(f64) -> f64| Path::polyline((0..=48).map(|k| f64::from(k) / 48.0).map(|u| at([u, f(u)])));
    let wave = |[[x0, y0], [x1, y1]]: [[f64; 2]; 2], u: f64| {
        let middle = 0.5 * (y0 + y1);
        middle + (y0 - middle) * (std::f64::consts::PI * (u - x0) / (x1 - x0)).cosine()
    };
    let path = match &mapper.graph {
        Some(Graph::Bezier(points)) => Path::cubic(points.map(at)),
        Some(Graph::Linear([a, b])) => sampled(&|u| a + (b - a) * u),
        Some(Graph::Sine(ends)) => sampled(&|u| wave(*ends, u)),
        Some(Graph::SineSummation(waves)) => sampled(&|u| waves.iter().map(|ends| wave(*ends, u)).sum()),
        Some(Graph::Parabola { origin, point }) => {
            let a = (point[1] - origin[1]) / (point[0] - origin[0]).powi(2);
            sampled(&|u| origin[1] + a * (u - origin[0]).powi(2))
        }
        Some(Graph::Gaussian { mean, deviation, factor }) => {
            sampled(&|u| factor * (-0.5 * ((u - mean) / deviation).powi(2)).exponential())
        }
        Some(Graph::Other(name, _)) => {
            items.push(middle([x + 0.5 * w, y + 0.5 * h], font::fitted(name, 10.0, w), 10.0, theme::INK));
            return items;
        }
        Some(Graph::Perlin { .. }) => {
            items.push(middle([x + 0.5 * w, y + 0.5 * h], "Perlin".to_owned(), 10.0, theme::INK));
            return items;
        }
        Some(Graph::Power { power, .. }) => sampled(&|u| u.raised_to(*power)),
        _ => return items,
    };
    items.push(Shape::stroked(path, theme::RED, 1.4).into());
    items
}

/// The first matrix that an object holds, its numbers in columns.
fn matrix(one: &Placed<'_>) -> Option<Vec<Item>> {
    let value = one.output(0)?.column().iter().flatten().next()?;
    let (rows, columns, values): (usize, usize, Vec<f64>) = match &value {
        Value::Matrix(m) => (m.rows(), m.columns(), m.values().to_vec()),
        other => (4, 4, other.as_transform()?.rows.into_iter().flatten().collect()),
    };
    let [x, y, w, h] = one.frame.rect;
    let (mut items, [wx, wy, ww, wh]) = window(one);
    let small = h / (rows.max(1) as f64) < 7.0 || w / (columns.max(1) as f64) < 14.0;
    if small {
        // No room for numbers: how large it is.
        let words = format!("{rows} × {columns}");
        items.push(middle([x + 0.5 * w, y + 0.5 * h], words, theme::NAME, theme::INK));
        return Some(items);
    }
    let size = (0.8 * wh / rows as f64).clamp(6.0, 10.0);
    for (k, number) in values.iter().enumerate() {
        let (row, column) = (k / columns.max(1), k % columns.max(1));
        let at = [
            wx + ww * (column as f64 + 1.0) / columns as f64 - 3.0,
            wy + wh * (row as f64 + 0.5) / rows as f64 + 0.35 * size,
        ];
        let text =
            font::fitted(&text::number((number * 100.0).round() / 100.0), size, ww / columns as f64 - 2.0);
        items.push(Label::new(at, text, size, theme::INK).anchored(Anchor::End).into());
    }
    Some(items)
}
