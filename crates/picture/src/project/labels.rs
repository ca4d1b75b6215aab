//! Texts beside points: each where it covers no other, as far as there is room.

use katydid_data::Colour;

use crate::drawing::{Anchor, Item, Label};
use crate::font;

/// Texts to be placed.
#[derive(Debug, Default)]
pub(crate) struct Labels {
    texts: Vec<(Label, bool)>,
}

/// A rectangle: its least and its greatest coordinates.
type Extent = [f64; 4];

/// With more texts than this they are not kept apart: nobody could read them all the same.
const MOST_APART: usize = 3000;

impl Labels {
    /// A text for a point of the picture; `on` puts its middle there.
    pub(crate) fn add(&mut self, at: [f64; 2], text: &str, size: f64, colour: Colour, on: bool) {
        if size.is_finite() && size > 0.0 {
            self.texts.push((Label::new(at, text, size.min(500.0), colour), on));
        }
    }

    /// The texts with their places: right above their points, or to another side where that is taken.
    pub(crate) fn placed(self, [width, height]: [f64; 2], ground: Colour) -> Vec<Item> {
        let mut taken: Vec<Extent> = Vec::new();
        let mut out = Vec::new();
        let apart = self.texts.len() <= MOST_APART;
        for (label, on) in self.texts {
            let (p, size) = (label.at, label.size);
            let block = Block::of(&label);
            let free = |e: &Extent| {
                let inside = e[0] >= 1.0 && e[1] >= 1.0 && e[2] <= width - 1.0 && e[3] <= height - 1.0;
                inside && !(apart && taken.iter().any(|t| meet(t, e)))
            };
            let sides = sides(size, on);
            let chosen = sides.iter().find(|side| free(&block.extent(p, side)));
            let Some(side) = chosen.or(sides.first()) else { continue };
            let extent = block.extent(p, side);
            // With no room on any side it is moved onto the picture, if its point is there.
            let seen = (0.0..=width).contains(&p[0]) && (0.0..=height).contains(&p[1]);
            let by = if seen { inwards(extent, [width, height]) } else { [0.0; 2] };
            taken.push([extent[0] + by[0], extent[1] + by[1], extent[2] + by[0], extent[3] + by[1]]);
            for (k, text) in label.text.lines().enumerate() {
                let mut line = Label { text: text.to_owned(), ..label.clone() };
                line = line.with_halo(Colour { a: 210, ..ground });
                line.at = [p[0] + side.by[0] + by[0], p[1] + side.by[1] + by[1] + block.step * k as f64];
                line.anchor = side.anchor;
                out.push(Item::Label(line));
            }
        }
        out
    }
}

/// A place of a text beside its point: where its first line stands, and which end of it.
#[derive(Debug, Clone, Copy)]
struct Side {
    by: [f64; 2],
    anchor: Anchor,
}

/// The places of a text of this size in the order in which they are tried.
fn sides(size: f64, on: bool) -> Vec<Side> {
    let side = |by: [f64; 2], anchor: Anchor| Side { by, anchor };
    if on {
        return vec![side([0.0, 0.35 * size], Anchor::Middle)];
    }
    vec![
        side([5.0, -4.0], Anchor::Start),
        side([-5.0, -4.0], Anchor::End),
        side([5.0, 3.0 + 0.75 * size], Anchor::Start),
        side([-5.0, 3.0 + 0.75 * size], Anchor::End),
        side([0.0, -8.0], Anchor::Middle),
        side([0.0, 7.0 + 0.75 * size], Anchor::Middle),
        side([9.0, 0.35 * size], Anchor::Start),
        side([-9.0, 0.35 * size], Anchor::End),
    ]
}

/// The lines of a text, which stay together.
struct Block {
    wide: f64,
    /// From the first line to the last.
    deep: f64,
    /// From a line to the next.
    step: f64,
    size: f64,
}

impl Block {
    fn of(label: &Label) -> Self {
        let wide = label.text.lines().map(|line| font::width(line, label.size)).fold(0.0, f64::max);
        let step = 1.2 * label.size;
        let deep = step * label.text.lines().count().saturating_sub(1) as f64;
        Self { wide, deep, step, size: label.size }
    }

    /// What the text covers beside a point.
    fn extent(&self, p: [f64; 2], side: &Side) -> Extent {
        let before = match side.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * self.wide,
            Anchor::End => self.wide,
        };
        let (x, y) = (p[0] + side.by[0] - before, p[1] + side.by[1]);
        [x, y - 0.75 * self.size, x + self.wide, y + self.deep + 0.2 * self.size]
    }
}

/// How far a rectangle must be moved to lie on the picture; one that is too large keeps its left upper corner on it.
fn inwards(e: Extent, [width, height]: [f64; 2]) -> [f64; 2] {
    let by = |low: f64, high: f64, most: f64| {
        let back = (most - 1.0 - high).min(0.0);
        if low + back < 1.0 { 1.0 - low } else { back }
    };
    [by(e[0], e[2], width), by(e[1], e[3], height)]
}

fn meet(a: &Extent, b: &Extent) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_one_point_go_to_its_sides() {
        let mut labels = Labels::default();
        for text in ["first", "second", "third", "fourth"] {
            labels.add([50.0, 50.0], text, 10.0, Colour::default(), false);
        }
        let placed = labels.placed([100.0, 100.0], Colour::rgb(255, 255, 255));
        let mut places: Vec<[i64; 2]> = placed
            .iter()
            .map(|item| match item {
                Item::Label(label) => label.at.map(|x| x.round() as i64),
                _ => [0, 0],
            })
            .collect();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), 4);
    }

    #[test]
    fn texts_stay_on_the_picture() {
        let mut labels = Labels::default();
        labels.add([98.0, 2.0], "at the corner", 10.0, Colour::default(), false);
        let placed = labels.placed([100.0, 100.0], Colour::rgb(255, 255, 255));
        let Some(Item::Label(label)) = placed.first() else { panic!("a label") };
        assert_eq!(label.anchor, Anchor::End);
        assert!(label.at[1] > 8.0);
    }

    /// Every line finds its own place no more: where one would fit and the next not, both move.
    #[test]
    fn lines_of_a_text_stay_together() {
        for at in [[95.0, 50.0], [50.0, 97.0], [99.0, 99.0], [2.0, 2.0], [60.0, 3.0]] {
            let mut labels = Labels::default();
            labels.add(at, "short\na much longer line\nend", 8.0, Colour::default(), false);
            let placed = labels.placed([100.0, 100.0], Colour::rgb(255, 255, 255));
            let lines: Vec<&Label> = placed
                .iter()
                .filter_map(|item| if let Item::Label(label) = item { Some(label) } else { None })
                .collect();
            let [first, second, third] = lines.as_slice() else { panic!("three lines") };
            for (upper, lower) in [(first, second), (second, third)] {
                assert_eq!((upper.at[0], upper.anchor), (lower.at[0], lower.anchor), "{at:?}");
                assert!((lower.at[1] - upper.at[1] - 9.6).abs() < 1e-9, "{at:?}");
            }
            assert!(first.at[1] > 6.0 && third.at[1] < 99.0, "{at:?}");
        }
    }
}
