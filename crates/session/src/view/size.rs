//! How large things are on the canvas, and where the grips of their ports are. What a file says counts; this is for
//! objects that are new, and for what files leave out. The measures are those of objects in real files.

use katydid_definition::document::{Object, Port, Side, Special, ids};
use uuid::Uuid;

use crate::controls;

/// The room between the edge of a capsule and its ports.
const EDGE: f32 = 2.0;
/// The band in the middle of a capsule, with the room beside it.
const BAND: f32 = 30.0;
/// The height of a row of ports.
const ROW: f32 = 20.0;
/// The least height of a capsule without its edges.
const LEAST: f32 = 24.0;
/// The room that an input's name takes besides its letters.
const BESIDE_INPUT: f32 = 8.0;
/// The room that an output's name takes besides its letters.
const BESIDE_OUTPUT: f32 = 11.0;
/// The size of the letters, in pixels: 8 points.
const LETTERS: f32 = 8.0 * 96.0 / 72.0;
/// Coordinates beyond this are taken for broken.
const FARTHEST: f32 = 1e7;

/// x, y, width and height of an object, in canvas units.
pub(crate) fn bounds(object: &Object) -> [f32; 4] {
    if let Some(Special::Scribble(scribble)) = object.special() {
        return around(scribble.corners.iter().copied());
    }
    if let Some(Special::Sketch(sketch)) = object.special() {
        return around(sketch.marks.iter().flat_map(|mark| &mark.points).map(|p| p.map(|x| x as f32)));
    }
    let sound = |numbers: &[f32]| numbers.iter().all(|x| x.abs() <= FARTHEST);
    match (object.bounds.filter(|b| sound(b)), object.pivot.filter(|p| sound(p))) {
        (Some([x, y, w, h]), _) if w > 0.0 && h > 0.0 => [x, y, w, h],
        (Some([x, y, ..]), _) => {
            let [w, h] = natural(object);
            [x, y, w, h]
        }
        (None, Some(pivot)) => hung(object, pivot),
        (None, None) => {
            let [w, h] = natural(object);
            [0.0, 0.0, w, h]
        }
    }
}

/// The smallest rectangle around points; nothing around none.
pub(crate) fn around(points: impl IntoIterator<Item = [f32; 2]>) -> [f32; 4] {
    let mut points = points.into_iter().filter(|p| p.iter().all(|x| x.abs() <= FARTHEST));
    let Some([x, y]) = points.next() else { return [0.0; 4] };
    let [left, top, right, bottom] =
        points.fold([x, y, x, y], |[l, t, r, b], [x, y]| [l.min(x), t.min(y), r.max(x), b.max(y)]);
    [left, top, right - left, bottom - top]
}

/// The rectangle of an object that hangs from a point.
fn hung(object: &Object, [x, y]: [f32; 2]) -> [f32; 4] {
    let [w, h] = natural(object);
    let [dx, dy] = hang(object, [w, h]);
    [x - dx, y - dy, w, h]
}

/// Where in its rectangle the point is that an object hangs from: the middle of the band, the middle of a parameter, the
/// corner of a control.
pub(crate) fn hang(object: &Object, [w, h]: [f32; 2]) -> [f32; 2] {
    if controls::settings(object).is_some_and(|(row, _)| row.hangs_from_corner) {
        [0.0, 0.0]
    } else if object.is_floating() {
        [0.5 * w, 0.5 * h]
    } else {
        [EDGE + column(&object.inputs, BESIDE_INPUT) + 0.5 * BAND, 0.5 * h]
    }
}

/// The width and height that a new object gets.
pub(crate) fn natural(object: &Object) -> [f32; 2] {
    let name = text(object.title());
    if let Some(size) = controls::size(object, name) {
        return size;
    }
    match object.component {
        ids::RELAY => [40.0, 16.0],
        component if draws(component) => [150.0, 100.0],
        _ if object.is_floating() => [(name + 18.0).max(50.0), ROW],
        _ => {
            let [left, right] =
                [column(&object.inputs, BESIDE_INPUT), column(&object.outputs, BESIDE_OUTPUT)];
            let rows = object.inputs.len().max(object.outputs.len()).max(1);
            let rows = u16::try_from(rows).map_or(1e5, f32::from);
            [2.0 * EDGE + left + BAND + right, 2.0 * EDGE + (ROW * rows).max(LEAST)]
        }
    }
}

/// Whether a parameter draws its data.
fn draws(component: Uuid) -> bool {
    [ids::QUICK_GRAPH, ids::BAR_GRAPH, ids::PIE_CHART, ids::IMAGE_GALLERY, ids::VALUE_TRACKER]
        .contains(&component)
}

/// The width of a column of ports.
fn column(ports: &[Port], beside: f32) -> f32 {
    let wide =
        |port: &Port| text(if port.nickname.is_empty() { &port.name } else { &port.nickname }) + beside;
    ports.iter().map(wide).fold(0.0, f32::max).ceil()
}

/// The width of a text in the letters of the canvas.
pub(crate) fn text(text: &str) -> f32 {
    text.chars().take(1000).map(letter).sum::<f32>() * LETTERS / 2048.0
}

/// How far a letter goes on, in 2048ths of its size, in the face that Grasshopper writes with.
fn letter(letter: char) -> f32 {
    const SMALL: [f32; 26] = [
        1042., 1204., 946., 1206., 1071., 641., 1206., 1158., 496., 496., 1018., 496., 1765., 1158., 1200.,
        1204., 1206., 712., 869., 694., 1158., 981., 1481., 940., 992., 927.,
    ];
    const LARGE: [f32; 26] = [
        1321., 1174., 1268., 1436., 1036., 999., 1406., 1454., 545., 731., 1188., 963., 1839., 1532., 1544.,
        1147., 1544., 1225., 1087., 1073., 1407., 1272., 1913., 1208., 1133., 1168.,
    ];
    let of = |table: &[f32; 26], first: u8| {
        u8::try_from(letter)
            .ok()
            .and_then(|byte| table.get(usize::from(byte - first)).copied())
            .unwrap_or(1100.0)
    };
    match letter {
        'a'..='z' => of(&SMALL, b'a'),
        'A'..='Z' => of(&LARGE, b'A'),
        '0'..='9' => 1104.0,
        ' ' => 561.0,
        '.' | ',' | ':' | ';' | '\'' | '|' => 444.0,
        '(' | ')' | '[' | ']' | '{' | '}' | '-' => 620.0,
        '\u{2e80}'..='\u{ffff}' => 2048.0,
        _ => 1100.0,
    }
}

/// Whether an object shows the grips of a side: nothing can be wired into what its user sets, or out of what only shows.
pub(crate) fn shows(object: &Object, side: Side) -> bool {
    let set_by_hand = object.component == ids::CLUSTER_INPUT
        || controls::of(object.component).is_some_and(|row| row.is_set_by_hand);
    match side {
        Side::Input => !set_by_hand || object.inputs.iter().any(|port| !port.sources.is_empty()),
        Side::Output => object.component != ids::CLUSTER_OUTPUT,
    }
}

/// How far below the top of its object the grip of each port of a side is.
pub(crate) fn grips(object: &Object, side: Side) -> Vec<f32> {
    let [_, top, _, height] = bounds(object);
    let ports = object.ports(side);
    let share = |k: usize| {
        let [k, n] = [k, ports.len()].map(|n| u16::try_from(n).map_or(1e5, f32::from));
        EDGE + (height - 2.0 * EDGE) * (k + 0.5) / n.max(1.0)
    };
    let at = |(k, port): (usize, &Port)| {
        if object.is_floating() {
            return 0.5 * height;
        }
        let attributes = port.chunk(object.container()).and_then(|chunk| chunk.child("Attributes"));
        let own = attributes.and_then(|attributes| attributes.canvas_rectangle("Bounds"));
        let middle = own.map(|[_, y, _, h]| y + 0.5 * h - top);
        middle.filter(|y| (0.0..=height).contains(y)).unwrap_or_else(|| share(k))
    };
    ports.iter().enumerate().map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::text;

    /// The widths of single names in real files are these, less what stands beside them.
    #[test]
    fn letters_are_as_wide_as_in_real_files() {
        for (name, measured) in [("Point", 24.0), ("Mesh", 26.0), ("Curve", 27.0), ("Brep", 21.0), ("A", 6.5)]
        {
            assert!((text(name) - measured).abs() < 1.5, "{name}: {}", text(name));
        }
    }
}
