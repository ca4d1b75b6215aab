use std::time::Duration;

use katydid_component::Limits;
use katydid_data::{Colour, Tree};
use katydid_definition::document::Document;
use katydid_picture::{HiddenLines, canvas, result};
use katydid_solver::{Engine, Options};

/// Width and height in pixels: twice those of a tile, for screens of high density.
const SIZE: [u32; 2] = [640, 400];
/// Solving for a picture takes no longer.
const TIME: Duration = Duration::from_secs(5);
/// It takes no more memory.
const BYTES: u64 = 512 << 20;
/// No component puts out more items for a picture.
const ITEMS: u64 = 1_000_000;
/// Of more items than this no picture is drawn: drawing has no limit of time.
const MOST_DRAWN: usize = 50_000;

/// A small picture of a definition for the start page, as PNG: what it makes, or its canvas where it makes nothing to
/// see. None of one that makes very much.
pub fn portrait(document: Document, options: Options) -> Option<Vec<u8>> {
    let limits = Limits { items: ITEMS, time: Some(TIME), ..Limits::default().with_bytes(BYTES) };
    let mut engine = Engine::new(document, Options { limits, ..options });
    engine.solve();
    let reports = (0..engine.document().objects.len()).filter_map(|at| engine.report(at));
    let items: usize = reports.flat_map(|report| &report.outputs).map(Tree::item_count).sum();
    if items > MOST_DRAWN {
        return None;
    }
    let options = katydid_picture::Options {
        size: SIZE,
        background: Some(Colour::rgb(255, 255, 255)),
        hidden_lines: HiddenLines::Natural,
        ..katydid_picture::Options::default()
    };
    let picture = result(&engine, &options);
    let drawing = if picture.is_empty { canvas(&engine, &options) } else { picture.drawing };
    let [width, height] = drawing.size;
    let factor = f64::min(f64::from(SIZE[0]) / width.max(1.0), f64::from(SIZE[1]) / height.max(1.0));
    drawing.scaled(factor.min(1.0)).to_png().ok()
}
