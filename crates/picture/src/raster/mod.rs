//! Writing PNG: outlines and texts by tiny-skia, faces and lines that hide one another by a depth buffer of our own.

mod depth;

use katydid_data::Colour;
use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, PixmapPaint, StrokeDash, Transform,
};

use crate::drawing::{Anchor, Drawing, Item, Label, Path, Segment, Shape, Stroke};
use crate::{Error, font};

/// A picture is at most this wide and high, in pixels.
pub(crate) const LARGEST: f64 = 16_384.0;
/// And has at most so many pixels: four bytes each.
const MOST: f64 = 134_217_728.0;

/// The bytes of a PNG file.
pub(crate) fn png(drawing: &Drawing) -> Result<Vec<u8>, Error> {
    let [width, height] = drawing.size;
    let fits =
        (1.0..=LARGEST).contains(&width) && (1.0..=LARGEST).contains(&height) && width * height <= MOST;
    let mut pixels = if fits { Pixmap::new(width.ceil() as u32, height.ceil() as u32) } else { None }
        .ok_or(Error::Size { width, height })?;
    if let Some(c) = drawing.background {
        pixels.fill(tiny_skia::Color::from_rgba8(c.r, c.g, c.b, c.a));
    }
    drawing.items.iter().for_each(|item| draw(&mut pixels, item));
    encode(&pixels)
}

fn draw(pixels: &mut Pixmap, item: &Item) {
    match item {
        Item::Shape(shape) => draw_shape(pixels, shape),
        Item::Label(label) => draw_label(pixels, label),
        Item::Solids(solids) => {
            if let Some(layer) = depth::render(solids, pixels.width(), pixels.height()) {
                let paint = PixmapPaint::default();
                pixels.draw_pixmap(0, 0, layer.as_ref(), &paint, Transform::identity(), None);
            }
        }
        Item::Group(_, items) => items.iter().for_each(|item| draw(pixels, item)),
    }
}

fn paint(c: Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(c.r, c.g, c.b, c.a);
    paint
}

/// The path as tiny-skia has it; `None` where there is nothing to draw, or a number that is none.
fn skia(path: &Path) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for segment in &path.segments {
        match segment.map_to_f32() {
            Segment32::Move([x, y]) => builder.move_to(x, y),
            Segment32::Line([x, y]) => builder.line_to(x, y),
            Segment32::Cubic([a, b, c, d, x, y]) => builder.cubic_to(a, b, c, d, x, y),
            Segment32::Close => builder.close(),
        }
    }
    builder.finish()
}

enum Segment32 {
    Move([f32; 2]),
    Line([f32; 2]),
    Cubic([f32; 6]),
    Close,
}

impl Segment {
    fn map_to_f32(self) -> Segment32 {
        let p = |[x, y]: [f64; 2]| [x as f32, y as f32];
        match self {
            Self::Move(a) => Segment32::Move(p(a)),
            Self::Line(a) => Segment32::Line(p(a)),
            Self::Cubic(a, b, c) => {
                let [[a0, a1], [b0, b1], [c0, c1]] = [p(a), p(b), p(c)];
                Segment32::Cubic([a0, a1, b0, b1, c0, c1])
            }
            Self::Close => Segment32::Close,
        }
    }
}

fn draw_shape(pixels: &mut Pixmap, shape: &Shape) {
    let Some(path) = skia(&shape.path) else { return };
    if let Some(colour) = shape.fill {
        pixels.fill_path(&path, &paint(colour), FillRule::Winding, Transform::identity(), None);
    }
    if let Some(stroke) = &shape.stroke {
        draw_stroke(pixels, &path, stroke, Transform::identity());
    }
}

fn draw_stroke(pixels: &mut Pixmap, path: &tiny_skia::Path, stroke: &Stroke, transform: Transform) {
    let dashes: Vec<f32> = stroke.dashes.iter().map(|x| *x as f32).collect();
    let skia = tiny_skia::Stroke {
        width: stroke.width as f32,
        line_cap: if dashes.is_empty() { LineCap::Round } else { LineCap::Butt },
        line_join: LineJoin::Round,
        dash: StrokeDash::new(dashes, 0.0),
        ..tiny_skia::Stroke::default()
    };
    pixels.stroke_path(path, &paint(stroke.colour), &skia, transform, None);
}

fn draw_label(pixels: &mut Pixmap, label: &Label) {
    let Some(path) = skia(&font::outlines(&label.text)) else { return };
    let wide = font::width(&label.text, 1.0);
    let start = match label.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * wide,
        Anchor::End => -wide,
    };
    // From the type's own size, its anchor at 0, to its place on the picture.
    let [a, b, c, d] = label.turn.map(|x| x * label.size);
    let [x, y] = [label.at[0] + start * a, label.at[1] + start * b];
    let [a, b, c, d, x, y] = [a, b, c, d, x, y].map(|x| x as f32);
    let transform = Transform::from_row(a, b, c, d, x, y);
    if let Some(halo) = label.halo {
        draw_stroke(pixels, &path, &Stroke::solid(halo, 0.25), transform);
    }
    pixels.fill_path(&path, &paint(label.colour), FillRule::Winding, transform, None);
    if label.bold {
        draw_stroke(pixels, &path, &Stroke::solid(label.colour, 0.05), transform);
    }
}

fn encode(pixels: &Pixmap) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_depth(png::BitDepth::Eight);
    // Without clear places there is no need to store how clear they are.
    let clear = pixels.pixels().iter().any(|pixel| pixel.alpha() < 255);
    encoder.set_color(if clear { png::ColorType::Rgba } else { png::ColorType::Rgb });
    let mut straight: Vec<u8> = Vec::with_capacity(pixels.pixels().len() * if clear { 4 } else { 3 });
    for pixel in pixels.pixels() {
        let c = pixel.demultiply();
        straight.extend([c.red(), c.green(), c.blue()]);
        straight.extend(Some(c.alpha()).filter(|_| clear));
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&straight)?;
    writer.finish()?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_refused_before_memory_is_taken() {
        for size in [[0.0, 5.0], [1e6, 1e6], [f64::NAN, 1.0], [16_000.0, 16_000.0]] {
            assert!(png(&Drawing { size, ..Drawing::default() }).is_err(), "{size:?}");
        }
        assert!(png(&Drawing { size: [3.0, 2.0], ..Drawing::default() }).is_ok());
    }
}
