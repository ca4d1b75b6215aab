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
            for_each_line(&label, |line, down| {
                let mut line = line.with_halo(Colour { a: 210, ..ground });
                let (p, size) = (line.at, line.size);
                let sides: &[([f64; 2], Anchor)] = &[
                    ([5.0, -4.0], Anchor::Start),
                    ([-5.0, -4.0], Anchor::End),
                    ([5.0, 3.0 + 0.75 * size], Anchor::Start),
                    ([-5.0, 3.0 + 0.75 * size], Anchor::End),
                    ([0.0, -8.0], Anchor::Middle),
                    ([0.0, 7.0 + 0.75 * size], Anchor::Middle),
                    ([9.0, 0.35 * size], Anchor::Start),
                    ([-9.0, 0.35 * size], Anchor::End),
                ];
                let on_it: &[([f64; 2], Anchor)] = &[([0.0, 0.35 * size], Anchor::Middle)];
                let sides = if on { on_it } else { sides };
                let wide = font::width(&line.text, size);
                let extent = |(by, anchor): &([f64; 2], Anchor)| {
                    let x = p[0] + by[0]
                        - match anchor {
                            Anchor::Start => 0.0,
                            Anchor::Middle => 0.5 * wide,
                            Anchor::End => wide,
                        };
                    let y = p[1] + by[1] + down;
                    [x, y - 0.75 * size, x + wide, y + 0.2 * size]
                };
                let free = |e: &Extent| {
                    let inside = e[0] >= 1.0 && e[1] >= 1.0 && e[2] <= width - 1.0 && e[3] <= height - 1.0;
                    inside && !(apart && taken.iter().any(|t| meet(t, e)))
                };
                let chosen = sides.iter().find(|side| free(&extent(side))).or_else(|| sides.first());
                if let Some(side) = chosen {
                    let extent = extent(side);
                    // With no room on any side it is moved onto the picture, if its point is there.
                    let seen = (0.0..=width).contains(&p[0]) && (0.0..=height).contains(&p[1]);
                    let by = if seen { inwards(extent, [width, height]) } else { [0.0; 2] };
                    taken.push([extent[0] + by[0], extent[1] + by[1], extent[2] + by[0], extent[3] + by[1]]);
                    line.at = [p[0] + side.0[0] + by[0], p[1] + side.0[1] + down + by[1]];
                    line.anchor = side.1;
                }
                out.push(Item::Label(line));
            });
        }
        out
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

/// The lines of a text with how far each stands below the first.
fn for_each_line(label: &Label, mut each: impl FnMut(Label, f64)) {
    for (k, line) in label.text.lines().enumerate() {
        each(Label { text: line.to_owned(), ..label.clone() }, 1.2 * label.size * k as f64);
    }
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
}
