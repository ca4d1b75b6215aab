//! Colours and layers by entity.

use std::collections::HashMap;

use super::entity::File;

/// How many entities are looked at under one style.
const MOST: usize = 200;

/// What entities look like, and their layers.
#[derive(Default)]
pub(super) struct Styles {
    colours: HashMap<u64, [u8; 4]>,
    layers: HashMap<u64, String>,
}

impl Styles {
    pub(super) fn of(file: &File) -> Self {
        let mut styles = Self::default();
        for keyword in ["STYLED_ITEM", "OVER_RIDING_STYLED_ITEM"] {
            for record in file.all(keyword) {
                let (Ok(assigned), Some(item)) = (record.references(1), record.maybe(2)) else { continue };
                let found = [false, true].iter().find_map(|lines| {
                    assigned.iter().find_map(|id| colour(file, *id, *lines, &mut MOST.clone()))
                });
                if let Some([r, g, b]) = found {
                    let through = assigned
                        .iter()
                        .find_map(|id| transparency(file, *id, &mut MOST.clone()))
                        .unwrap_or(0.0);
                    styles.colours.insert(item, [r, g, b, byte(1.0 - through)]);
                }
            }
        }
        for record in file.all("PRESENTATION_LAYER_ASSIGNMENT") {
            for item in record.references(2).unwrap_or_default() {
                styles.layers.insert(item, record.text(0).to_owned());
            }
        }
        styles
    }

    /// The colour of the first of some entities that has one.
    pub(super) fn colour(&self, ids: &[u64]) -> Option<[u8; 4]> {
        ids.iter().find_map(|id| self.colours.get(id)).copied()
    }

    /// The layer of the first of some entities that has one.
    pub(super) fn layer(&self, ids: &[u64]) -> Option<String> {
        ids.iter().find_map(|id| self.layers.get(id)).cloned()
    }
}

fn byte(share: f64) -> u8 {
    (255.0 * share.clamp(0.0, 1.0)).round() as u8
}

/// The first colour under a style; those of lines only when wanted.
fn colour(file: &File, id: u64, lines: bool, left: &mut usize) -> Option<[u8; 3]> {
    *left = left.checked_sub(1)?;
    let record = file.record(id).ok()?;
    match record.keyword {
        "COLOUR_RGB" => {
            let parts = [1, 2, 3].map(|place| record.real(place).ok().map(byte));
            let [Some(r), Some(g), Some(b)] = parts else { return None };
            Some([r, g, b])
        }
        "DRAUGHTING_PRE_DEFINED_COLOUR" | "PRE_DEFINED_COLOUR" => named(record.text(0)),
        "CURVE_STYLE" | "POINT_STYLE" if !lines => None,
        _ => file.references(id).into_iter().find_map(|next| colour(file, next, lines, left)),
    }
}

fn named(name: &str) -> Option<[u8; 3]> {
    Some(match name.to_ascii_lowercase().as_str() {
        "red" => [255, 0, 0],
        "green" => [0, 255, 0],
        "blue" => [0, 0, 255],
        "yellow" => [255, 255, 0],
        "magenta" => [255, 0, 255],
        "cyan" => [0, 255, 255],
        "black" => [0, 0, 0],
        "white" => [255, 255, 255],
        _ => return None,
    })
}

fn transparency(file: &File, id: u64, left: &mut usize) -> Option<f64> {
    *left = left.checked_sub(1)?;
    let record = file.record(id).ok()?;
    if record.keyword == "SURFACE_STYLE_TRANSPARENT" {
        return record.real(0).ok();
    }
    file.references(id).into_iter().find_map(|next| transparency(file, next, left))
}
