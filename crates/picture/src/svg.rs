//! Writing SVG 1.1: vectors as vectors, text as text, with a title and a description for who cannot see it.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use katydid_data::Colour;

use crate::drawing::{Anchor, Drawing, Item, Label, Path, Segment, Shape, Solids, opaque};
use crate::order::{self, Drawn};
use crate::{font, raster};

/// With more faces and pieces of lines than this, what hides one another is put in as pixels: a vector file would take
/// tens of megabytes and open slowly.
const MOST_VECTORS: usize = 12_000;
/// How many pixels a pixel of such an inner picture has, each way.
const FINENESS: f64 = 2.0;

pub(crate) fn write(drawing: &Drawing) -> String {
    let [width, height] = drawing.size.map(number);
    let mut out = String::with_capacity(4096);
    // Writing to a string never fails.
    let _ = write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\" \
         aria-labelledby=\"title desc\" font-family=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
         <title id=\"title\">{}</title>\n<desc id=\"desc\">{}</desc>\n",
        font::FAMILY,
        escaped(&drawing.title),
        escaped(&drawing.description),
    );
    if let Some(colour) = drawing.background {
        let _ = writeln!(out, "<rect width=\"{width}\" height=\"{height}\"{}/>", paint("fill", colour));
    }
    drawing.items.iter().for_each(|item| write_item(&mut out, item, drawing.size));
    out.push_str("</svg>\n");
    out
}

fn write_item(out: &mut String, item: &Item, size: [f64; 2]) {
    match item {
        Item::Shape(shape) => write_shape(out, shape),
        Item::Label(label) => write_label(out, label),
        Item::Solids(solids) => write_solids(out, solids, size),
        Item::Group(title, items) => {
            let _ = writeln!(out, "<g><title>{}</title>", escaped(title));
            items.iter().for_each(|item| write_item(out, item, size));
            out.push_str("</g>\n");
        }
    }
}

fn write_shape(out: &mut String, shape: &Shape) {
    if shape.path.segments.is_empty() {
        return;
    }
    let _ = write!(out, "<path d=\"{}\"", data(&shape.path));
    match shape.fill {
        Some(colour) => out.push_str(&paint("fill", colour)),
        None => out.push_str(" fill=\"none\""),
    }
    if let Some(stroke) = &shape.stroke {
        let _ = write!(out, "{} stroke-width=\"{}\"", paint("stroke", stroke.colour), number(stroke.width));
        if !stroke.dashes.is_empty() {
            let dashes: Vec<String> = stroke.dashes.iter().map(|x| number(*x)).collect();
            let _ = write!(out, " stroke-dasharray=\"{}\" stroke-linecap=\"butt\"", dashes.join(" "));
        }
    }
    out.push_str("/>\n");
}

fn write_label(out: &mut String, label: &Label) {
    if label.text.trim().is_empty() {
        return;
    }
    let [x, y] = label.at.map(number);
    let _ = write!(out, "<text");
    if label.turn == [1.0, 0.0, 0.0, 1.0] {
        let _ = write!(out, " x=\"{x}\" y=\"{y}\"");
    } else {
        let [a, b, c, d] = label.turn.map(|k| format!("{:.5}", k + 0.0));
        let _ = write!(out, " transform=\"matrix({a} {b} {c} {d} {x} {y})\"");
    }
    let _ = write!(out, " font-size=\"{}\"{}", number(label.size), paint("fill", label.colour));
    match label.anchor {
        Anchor::Start => {}
        Anchor::Middle => out.push_str(" text-anchor=\"middle\""),
        Anchor::End => out.push_str(" text-anchor=\"end\""),
    }
    if label.bold {
        out.push_str(" font-weight=\"bold\"");
    }
    if let Some(halo) = label.halo {
        let width = number(0.25 * label.size);
        let _ = write!(out, "{} stroke-width=\"{width}\" paint-order=\"stroke\"", paint("stroke", halo));
    }
    let _ = writeln!(out, " xml:space=\"preserve\">{}</text>", escaped(&label.text));
}

fn write_solids(out: &mut String, solids: &Solids, size: [f64; 2]) {
    let pieces = solids.faces.len() + solids.lines.iter().map(|line| line.points.len()).sum::<usize>();
    if pieces > MOST_VECTORS && !solids.faces.is_empty() && write_pixels(out, solids, size).is_some() {
        return;
    }
    let mut run = Run { solids, line: None, alpha: None };
    for drawn in order::back_to_front(solids) {
        match drawn {
            Drawn::Face { corners, colour } => run.face(out, &corners, colour),
            Drawn::Line { from, to, of } => run.line(out, [from[0], from[1]], [to[0], to[1]], of),
        }
    }
    run.finish_line(out);
    run.finish_faces(out);
}

/// What is being written: neighbours in the painter's order share what they have in common.
struct Run<'a> {
    solids: &'a Solids,
    /// A line of one style, and the index of one that has it.
    line: Option<(usize, Path)>,
    /// The alpha of the group of faces that is open.
    alpha: Option<u8>,
}

impl Run<'_> {
    fn face(&mut self, out: &mut String, corners: &[[f64; 3]], colour: Colour) {
        self.finish_line(out);
        if self.alpha != Some(colour.a) {
            self.finish_faces(out);
            self.alpha = Some(colour.a);
            // Neighbours would let the ground shine through between them: an opaque face gets a rim of its own
            // colour, and a clear one, whose rim would show, is drawn without smoothing.
            if colour.a == 255 {
                out.push_str("<g stroke-width=\"0.6\">\n");
            } else {
                let opacity = number(f64::from(colour.a) / 255.0);
                let _ = writeln!(out, "<g fill-opacity=\"{opacity}\" shape-rendering=\"crispEdges\">");
            }
        }
        let path = data(&Path::polygon(corners.iter().map(|p| [p[0], p[1]])));
        let rim = if colour.a == 255 { paint("stroke", colour) } else { String::new() };
        let _ = writeln!(out, "<path d=\"{path}\"{}{rim}/>", paint("fill", opaque(colour)));
    }

    fn line(&mut self, out: &mut String, from: [f64; 2], to: [f64; 2], of: usize) {
        self.finish_faces(out);
        if !self.line.as_ref().is_some_and(|(last, _)| same_style(self.solids, *last, of)) {
            self.finish_line(out);
        }
        let (_, path) = self.line.get_or_insert_with(|| (of, Path::default()));
        if !matches!(path.segments.last(), Some(Segment::Line(p)) if *p == from) {
            path.segments.push(Segment::Move(from));
        }
        path.segments.push(Segment::Line(to));
    }

    fn finish_line(&mut self, out: &mut String) {
        if let Some((of, path)) = self.line.take()
            && let Some(style) = self.solids.lines.get(of)
        {
            write_shape(out, &Shape::stroked(path, opaque(style.colour), style.width));
        }
    }

    fn finish_faces(&mut self, out: &mut String) {
        if self.alpha.take().is_some() {
            out.push_str("</g>\n");
        }
    }
}

fn same_style(solids: &Solids, a: usize, b: usize) -> bool {
    let style = |k: usize| solids.lines.get(k).map(|line| (line.colour, line.width));
    style(a) == style(b)
}

/// The solids as an inner picture.
fn write_pixels(out: &mut String, solids: &Solids, size: [f64; 2]) -> Option<()> {
    let mut inner = Drawing { size, ..Drawing::default() };
    inner.items.push(Item::Solids(solids.clone()));
    let bytes = raster::png(&inner.scaled(FINENESS)).ok()?;
    let [w, h] = size.map(number);
    let image = STANDARD.encode(bytes);
    let _ =
        writeln!(out, "<image width=\"{w}\" height=\"{h}\" xlink:href=\"data:image/png;base64,{image}\"/>");
    Some(())
}

/// The `d` attribute of a path.
fn data(path: &Path) -> String {
    let mut out = String::with_capacity(12 * path.segments.len());
    let mut letter = ' ';
    let mut begin = |out: &mut String, next: char| {
        if letter == next && next != 'M' {
            out.push(' ');
        } else {
            out.push(next);
        }
        letter = next;
    };
    let pair = |out: &mut String, p: &[f64; 2]| {
        let _ = write!(out, "{} {}", number(p[0]), number(p[1]));
    };
    for segment in &path.segments {
        match segment {
            Segment::Move(p) => {
                begin(&mut out, 'M');
                pair(&mut out, p);
            }
            Segment::Line(p) => {
                begin(&mut out, 'L');
                pair(&mut out, p);
            }
            Segment::Cubic(a, b, c) => {
                begin(&mut out, 'C');
                pair(&mut out, a);
                out.push(' ');
                pair(&mut out, b);
                out.push(' ');
                pair(&mut out, c);
            }
            Segment::Close => begin(&mut out, 'Z'),
        }
    }
    out
}

/// A paint attribute and, where it is needed, its opacity.
fn paint(what: &str, c: Colour) -> String {
    let mut text = format!(" {what}=\"#{:02x}{:02x}{:02x}\"", c.r, c.g, c.b);
    if c.a < 255 {
        let _ = write!(text, " {what}-opacity=\"{}\"", number(f64::from(c.a) / 255.0));
    }
    text
}

/// A number to a hundredth of a pixel, as short as can be. What is no number is 0: it must not spoil the file.
fn number(x: f64) -> String {
    if !x.is_finite() {
        return "0".to_owned();
    }
    let mut text = format!("{x:.2}");
    text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    if text == "-0" { "0".to_owned() } else { text }
}

/// Text as XML takes it; control characters, which XML refuses, become blanks.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [1.0, -0.001, 2.5, 1e9, f64::NAN, 0.126].map(number);
        assert_eq!(texts, ["1", "0", "2.5", "1000000000", "0", "0.13"]);
    }

    #[test]
    fn texts_stay_texts() {
        let mut drawing =
            Drawing { size: [10.0, 10.0], title: "a < b & \"c\"\u{7}".into(), ..Drawing::default() };
        drawing.push(Label::new([1.0, 2.0], "x < y", 4.0, Colour::rgb(1, 2, 3)));
        let svg = write(&drawing);
        assert!(svg.contains("<title id=\"title\">a &lt; b &amp; &quot;c&quot; </title>"), "{svg}");
        assert!(svg.contains("fill=\"#010203\" xml:space=\"preserve\">x &lt; y</text>"), "{svg}");
        assert!(svg.contains("role=\"img\""));
    }
}
