//! SVG 1.1, a drawing in true size: one unit of the model is one unit of the drawing.
//!
//! Lines, polylines, arcs, conics and polynomial curves to degree 3 are exact; other curves are cubic Béziers within the
//! tolerance. Meshes are drawn by their borders, creases and outlines. Hatches
//! are filled, those with a pattern by a tint. Nothing is hidden behind anything.

mod cubic;
mod ellipse;
mod label;
mod mesh;
mod path;

use std::io::Write;

use katydid_geometry::{BoundingBox, Curve, Mesh, Point3, Units, Xform};

use crate::text::Text;
use crate::{Fill, LeftOut, Options, Region, Result, Scene, Shape, Thing};
use label::Flat;
use path::Path;

/// White around the drawing, as a share of its larger side.
const MARGIN: f64 = 0.02;
const BLACK: [u8; 4] = [0, 0, 0, 255];
/// How opaque the tint is that stands for a pattern.
const TINT: f64 = 0.25;

pub(crate) fn write(scene: &Scene, options: &Options, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let mut left_out = Vec::new();
    let page = options.view.to_page();
    let mut drawn = Vec::new();
    for (place, thing) in scene.things.iter().enumerate() {
        let lines = Lines::of(&thing.shape, &page);
        if lines.is_empty() {
            let kind = thing.shape.kind();
            LeftOut::add(
                &mut left_out,
                LeftOut::new(kind, 1, "there is nothing of it to draw from this side"),
            );
        }
        if let Shape::Region(Region { fill: Fill::Pattern, .. }) = &thing.shape {
            LeftOut::add(&mut left_out, LeftOut::new("pattern of a hatch", 1, "a tint stands for it"));
        }
        drawn.push(Drawn { thing, place, lines });
    }
    let bounds = bounds(&drawn);
    let size = bounds.diagonal();
    let mut drawing = Drawing { scene, options, side: size.x.max(size.y), text: Text::new(out) };
    drawing.open(&bounds)?;
    let parents = scene.parents();
    drawing.layer(None, &parents, &drawn)?;
    drawing.text.push("</g>\n</svg>\n");
    drawing.text.flush()?;
    Ok(left_out)
}

/// A thing as it lies on the page: x to the right, y up.
struct Drawn<'a> {
    thing: &'a Thing,
    place: usize,
    lines: Lines<'a>,
}

/// What is drawn of a thing.
enum Lines<'a> {
    Points(Vec<Point3>),
    Curves(Vec<Curve>),
    Segments(Vec<[Point3; 2]>),
    Area(Vec<Curve>, Fill),
    Text(Flat<'a>),
}

impl<'a> Lines<'a> {
    fn of(shape: &'a Shape, page: &Xform) -> Self {
        let edges = |mesh: &Mesh| {
            let flat = mesh.transformed(page).map(|mesh| mesh::edges_to_draw(&mesh));
            Self::Segments(flat.unwrap_or_default())
        };
        match shape {
            Shape::Points(set) => Self::Points(set.points.iter().map(|p| page.point(*p)).collect()),
            Shape::Curve(curve) => Self::Curves(curve.transformed(page).into_iter().collect()),
            Shape::Mesh(mesh) => edges(mesh),
            Shape::Region(region) => {
                let flat = region.boundaries.iter().filter_map(|c| c.transformed(page).ok());
                Self::Area(flat.collect(), region.fill)
            }
            Shape::Text(label) => Self::Text(Flat::of(label, page)),
            // Breps became facets and edges before.
            Shape::Brep(_) => Self::Curves(Vec::new()),
            Shape::Faces { facets: Some(mesh), edges: none } if none.is_empty() => edges(mesh),
            Shape::Faces { edges, .. } => {
                Self::Curves(edges.iter().filter_map(|c| c.transformed(page).ok()).collect())
            }
        }
    }

    fn is_empty(&self) -> bool {
        match self {
            Self::Points(points) => points.is_empty(),
            Self::Curves(curves) => curves.is_empty(),
            Self::Segments(segments) => segments.is_empty(),
            Self::Area(curves, _) => curves.is_empty(),
            Self::Text(text) => !text.is_visible(),
        }
    }

    fn bounds(&self) -> Option<BoundingBox> {
        match self {
            Self::Points(points) => BoundingBox::from_points(points.iter().copied()),
            Self::Curves(curves) | Self::Area(curves, _) => {
                curves.iter().map(Curve::bounding_box).reduce(|a, b| a.union(&b))
            }
            Self::Segments(segments) => BoundingBox::from_points(segments.iter().flatten().copied()),
            Self::Text(text) => text.bounds(),
        }
    }
}

fn bounds(drawn: &[Drawn<'_>]) -> BoundingBox {
    let all = drawn.iter().filter_map(|d| d.lines.bounds()).reduce(|a, b| a.union(&b));
    all.unwrap_or(BoundingBox { min: Point3::ORIGIN, max: Point3::ORIGIN })
}

struct Drawing<'a> {
    scene: &'a Scene,
    options: &'a Options,
    /// The larger side of what is drawn.
    side: f64,
    text: Text<'a>,
}

impl Drawing<'_> {
    fn open(&mut self, bounds: &BoundingBox) -> Result<()> {
        let size = bounds.diagonal();
        let margin = MARGIN * size.x.max(size.y);
        let margin = if margin > 0.0 { margin } else { 0.5 };
        let [width, height] = [size.x, size.y].map(|side| side + 2.0 * margin);
        let (factor, unit) = match self.scene.units {
            Units::None if self.scene.metres == 1.0 => (1.0, ""),
            Units::Inches => (1.0, "in"),
            Units::Centimeters => (1.0, "cm"),
            _ => (self.scene.metres * 1000.0, "mm"),
        };
        self.text.push(concat!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
            "<svg xmlns=\"http://www.w3.org/2000/svg\" ",
            "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\""
        ));
        for (name, side) in [("width", width), ("height", height)] {
            self.text.push(&format!(" {name}=\""));
            self.text.real(side * factor);
            self.text.push(unit);
            self.text.push("\"");
        }
        self.text.push(" viewBox=\"");
        self.text.real(bounds.min.x - margin);
        self.text.reals([-bounds.max.y - margin, width, height]);
        self.text
            .push("\">\n<g fill=\"none\" stroke=\"#000000\" stroke-width=\"1\" stroke-linecap=\"round\" ");
        self.text.push("stroke-linejoin=\"round\">");
        self.text.end_line()
    }

    /// What lies on a layer, then the layers under it.
    fn layer(&mut self, layer: Option<usize>, parents: &[Option<usize>], drawn: &[Drawn<'_>]) -> Result<()> {
        let of = |thing: &Thing| thing.layer.filter(|layer| *layer < parents.len());
        let things = drawn.iter().filter(|d| of(d.thing) == layer && !d.lines.is_empty());
        things.into_iter().try_for_each(|d| self.thing(d))?;
        for (under, _) in parents.iter().enumerate().filter(|(_, parent)| **parent == layer) {
            if !holds(under, parents, drawn) {
                continue;
            }
            let name = escaped(&self.scene.layers[under].name);
            self.text.push(&format!(
                "<g id=\"layer{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{name}\">\n<title>{name}</title>\n",
                under + 1
            ));
            self.layer(Some(under), parents, drawn)?;
            self.text.push("</g>\n");
        }
        Ok(())
    }

    fn thing(&mut self, drawn: &Drawn<'_>) -> Result<()> {
        if let Lines::Text(text) = &drawn.lines {
            let colour = drawn.thing.colour.unwrap_or(BLACK);
            text.write(&mut self.text, &paint("fill", colour, 1.0), self.side)?;
            return self.text.end_line();
        }
        if let Lines::Area(_, fill) = &drawn.lines {
            let share = if *fill == Fill::Solid { 1.0 } else { TINT };
            self.text.push("<path stroke=\"none\" fill-rule=\"evenodd\"");
            self.text.push(&paint("fill", drawn.thing.colour.unwrap_or(BLACK), share));
        } else {
            self.text.push("<path vector-effect=\"non-scaling-stroke\"");
            self.text.push(&drawn.thing.colour.map_or(String::new(), |colour| paint("stroke", colour, 1.0)));
        }
        if matches!(drawn.lines, Lines::Points(_)) {
            self.text.push(" stroke-width=\"4\"");
        }
        self.text.push(" d=\"");
        let mut path = Path::new(&mut self.text);
        match &drawn.lines {
            Lines::Points(points) => points.iter().try_for_each(|p| path.dot(*p))?,
            Lines::Segments(segments) => segments.iter().try_for_each(|[a, b]| path.segment(*a, *b))?,
            Lines::Text(_) => {}
            Lines::Curves(curves) | Lines::Area(curves, _) => {
                for curve in curves {
                    let tolerance = self.scene.tolerance_for(self.options.tolerance, &curve.bounding_box());
                    path.curve(curve, tolerance)?;
                }
            }
        }
        if drawn.thing.name.is_empty() {
            self.text.push("\"/>");
        } else {
            let name = escaped(&drawn.thing.name);
            self.text.push(&format!("\" id=\"thing{}\"><title>{name}</title></path>", drawn.place + 1));
        }
        self.text.end_line()
    }
}

/// The attributes of a colour as that of lines or areas, and of a share of its opacity.
fn paint(of: &str, [r, g, b, a]: [u8; 4], share: f64) -> String {
    let opacity = (f64::from(a) / 255.0 * share * 1e3).round() / 1e3;
    let opacity = if opacity < 1.0 { format!(" {of}-opacity=\"{opacity}\"") } else { String::new() };
    format!(" {of}=\"#{r:02x}{g:02x}{b:02x}\"{opacity}")
}

/// Whether anything is drawn on a layer or under it.
fn holds(layer: usize, parents: &[Option<usize>], drawn: &[Drawn<'_>]) -> bool {
    drawn.iter().filter(|d| !d.lines.is_empty()).any(|d| {
        let mut next = d.thing.layer;
        while let Some(at) = next {
            if at == layer {
                return true;
            }
            next = parents.get(at).copied().flatten();
        }
        false
    })
}

/// A name as the text of an element or attribute. Characters that XML cannot hold become blanks.
fn escaped(name: &str) -> String {
    let mut out = String::with_capacity(name.len());
    for c in name.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
