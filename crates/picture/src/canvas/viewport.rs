//! A view of the model on the canvas.

use katydid_data::{Tree, Value};
use katydid_solver::{Engine, Inputs};
use uuid::{Uuid, uuid};

use super::{Placed, theme};
use crate::drawing::{Item, Path, Shape};
use crate::{Options, result};

const VIEWPORT_DISPLAY: Uuid = uuid!("b78d95bc-dffb-414c-b177-c611c92580b9");
/// The least and the greatest side of a view, in pixels.
const SIDES: [f64; 2] = [40.0, 1200.0];
/// Between an object and its view.
const GAP: f64 = 8.0;

/// The rectangles of the views that objects show, each with the number of its object.
pub(super) fn windows(engine: &Engine, placed: &[Option<Placed<'_>>]) -> Vec<(usize, [f64; 4])> {
    let wanted = placed.iter().enumerate();
    let wanted = wanted.filter_map(|(k, one)| Some((k, one.as_ref()?)));
    let wanted: Vec<_> = wanted.filter(|(_, one)| one.object.component == VIEWPORT_DISPLAY).collect();
    if wanted.is_empty() {
        return Vec::new();
    }
    let inputs = Inputs::new(engine);
    let window = |(k, one): (usize, &Placed<'_>)| {
        let trees = inputs.of(k);
        let first = |i: usize| trees.get(i).and_then(|tree: &Tree| tree.column().get(0));
        if matches!(first(0), Some(Value::Boolean(false))) {
            return None;
        }
        let side = |i: usize, usual: f64| match first(i) {
            Some(Value::Integer(n)) => f64::from(n).clamp(SIDES[0], SIDES[1]),
            Some(Value::Number(x)) if x.is_finite() => x.clamp(SIDES[0], SIDES[1]),
            _ => usual,
        };
        let [x, y, _, h] = one.frame.rect;
        Some((k, [x, y + h + GAP, side(3, 300.0), side(4, 200.0)]))
    };
    wanted.into_iter().filter_map(window).collect()
}

/// What the definition makes, in a rectangle.
pub(super) fn draw(engine: &Engine, [x, y, w, h]: [f64; 4]) -> Vec<Item> {
    let size = [w, h].map(|side| side.round().max(1.0) as u32);
    let mut drawing = result(engine, &Options { size, ..Options::default() }).drawing;
    let frame = Path::rectangle([x, y, w, h]);
    drawing.items.iter_mut().for_each(|item| item.transform(1.0, [x, y]));
    let mut items = vec![Shape::filled(frame.clone(), theme::PAPER).into()];
    items.append(&mut drawing.items);
    items.push(Shape::stroked(frame, theme::EDGE, 1.0).into());
    items
}
