//! How curves and surfaces bend, drawn beside the model: combs, osculating circles, control polygons and nets, more
//! isocurves; and in numbers, at single places.
//!
//! All of it is computed from the curves and surfaces themselves, not from what a viewport has of them. [`Subjects`] are
//! those of one object; a [`Measure`] gives the combs of all objects one scale; [`encode`] lays an object's analysis out as
//! a preview is ([`PreviewHeader`](crate::protocol::PreviewHeader)), and [`probe`] answers for a place.

mod circles;
mod comb;
mod controls;
mod isocurves;
mod probe;
mod subjects;

use katydid_geometry::{BoundingBox, Point3};
use katydid_scene::Origin;
use uuid::Uuid;

use crate::display::parts::{DOCUMENT, Paint, Parts};
use crate::display::{self, Geometry, layout};
use crate::protocol::{AnalysisView, CombMeasure, PartKind};

pub use probe::probe;
pub use subjects::Subjects;

/// Teeth and places on the line over them, of all combs together.
const MOST_TEETH: usize = 60_000;
/// The same while something is dragged.
const MOST_DRAFT_TEETH: usize = 12_000;
/// Circles of all curves together.
const MOST_CIRCLES: usize = 2_000;
/// Control points of all curves and surfaces together.
const MOST_CONTROLS: usize = 100_000;
/// Texts beside control points: more cannot be read.
const MOST_LABELS: usize = 300;
/// Isocurves of all surfaces together.
const MOST_ISOCURVES: usize = 4_000;
/// The analysis of an object takes no more bytes.
const MOST_BYTES: usize = 64 << 20;

/// How much of everything there is, so that what is drawn of each object fits into what is drawn of all.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Measure {
    /// Teeth in each span.
    teeth: usize,
    /// The length of a tooth over its curvature; 0 without combs.
    scale: f64,
    /// No tooth is longer: at a cusp the curvature has no bound.
    longest: f64,
    /// Circles along each curve.
    circles: usize,
    /// Whether there is room for control points.
    controls: bool,
    /// Whether there is room for their texts.
    labels: bool,
    /// Isocurves in each span.
    between: usize,
    /// Whether it is only for the moment, as something is dragged.
    is_draft: bool,
}

/// What is looked at, measured.
#[derive(Debug, Clone, Default)]
pub struct Measured {
    /// For [`encode`].
    pub measure: Measure,
    /// What combs show in numbers, where there are any.
    pub comb: Option<CombMeasure>,
    /// What there is too much of, in words.
    pub left_out: Vec<String>,
}

/// Measures all that is looked at. With `scale`, combs keep the one they had: while something is dragged they grow with
/// the curvature and with nothing else.
pub fn measure(all: &[&Subjects], analysis: &AnalysisView, is_draft: bool, scale: Option<f64>) -> Measured {
    let mut left_out = Vec::new();
    let mut measure = Measure { is_draft, ..Measure::default() };
    let curves = all.iter().map(|subjects| subjects.curves.len()).sum::<usize>();
    let between = analysis.isocurves.map_or(0, |lines| lines.between as usize).min(MOST_ISOCURVES);
    measure.between = isocurves::fitting(all, between, MOST_ISOCURVES);
    if measure.between < between {
        left_out.push(format!("no more than {} isocurves in each span: there are many", measure.between));
    }
    measure.circles = (analysis.circles as usize).min(MOST_CIRCLES / curves.max(1));
    if measure.circles < analysis.circles as usize {
        left_out.push(format!("no more than {} circles a curve: there are many curves", measure.circles));
    }
    if analysis.controls {
        let count = all.iter().map(|subjects| controls::count(subjects)).sum::<usize>();
        measure.controls = count <= MOST_CONTROLS;
        if !measure.controls {
            left_out.push(format!("no control points: there are {count}, and {MOST_CONTROLS} can be shown"));
        }
        measure.labels = all.iter().map(|subjects| controls::labels(subjects)).sum::<usize>() <= MOST_LABELS;
    }
    let mut comb = None;
    if let Some(view) = &analysis.comb {
        let found = comb::Survey::of(all, view, measure.between);
        let most = if is_draft { MOST_DRAFT_TEETH } else { MOST_TEETH };
        let places = comb::places(is_draft);
        let wanted = (view.teeth as usize).clamp(1, 1000);
        measure.teeth = wanted.min(most / (found.spans * places).max(1));
        if measure.teeth == 0 {
            left_out.push(format!("no combs: there are {} spans", found.spans));
        } else if measure.teeth < wanted && !is_draft {
            left_out.push(format!(
                "no more than {} teeth a span: there are {} spans",
                measure.teeth, found.spans
            ));
        }
        measure.scale = scale.filter(|scale| *scale > 0.0).unwrap_or_else(|| found.scale(view.length));
        measure.longest = found.size();
        comb = found.sharpest(measure.scale);
    }
    Measured { measure, comb, left_out }
}

/// The analyses of objects, in the layout of previews, side by side on all cores; nothing for one of which there is
/// nothing to show. What `go_on` denies does not come back at all.
pub fn encode(
    all: &[(Uuid, &Subjects)],
    analysis: &AnalysisView,
    measure: &Measure,
    go_on: impl Fn() -> bool + Sync,
) -> Vec<(Uuid, Option<Geometry>)> {
    let one = |(object, subjects): &(Uuid, &Subjects)| {
        go_on().then(|| (*object, drawn(*object, subjects, analysis, measure)))
    };
    display::each(all, one).into_iter().flatten().collect()
}

fn drawn(object: Uuid, subjects: &Subjects, analysis: &AnalysisView, measure: &Measure) -> Option<Geometry> {
    let mut sheet = Sheet { parts: Parts::new(false) };
    if analysis.isocurves.is_some() {
        isocurves::draw(&mut sheet, subjects, analysis, measure);
    }
    if let Some(view) = analysis.comb.filter(|_| measure.teeth > 0 && measure.scale > 0.0) {
        comb::draw(&mut sheet, subjects, &view, measure);
    }
    if measure.circles > 0 {
        circles::draw(&mut sheet, subjects, measure.circles);
    }
    if measure.controls {
        controls::draw(&mut sheet, subjects, measure.labels);
    }
    layout::bytes(object, &subjects.branches, sheet.parts, measure.is_draft)
}

/// What an analysis is drawn on.
struct Sheet {
    parts: Parts,
}

impl Sheet {
    fn is_full(&self) -> bool {
        self.parts.bytes_above(MOST_BYTES)
    }

    fn line(&mut self, kind: PartKind, width: f64, points: &[Point3], origin: Origin) {
        self.parts.line(Paint { kind, colour: DOCUMENT, width, text_height: 0.0 }, points, origin);
    }

    fn point(&mut self, at: Point3, origin: Origin) {
        self.parts.point(paint(PartKind::ControlPoints), at, None, origin);
    }

    fn text(&mut self, at: Point3, text: String, origin: Origin) {
        self.parts.point(paint(PartKind::Texts), at, Some(text), origin);
    }
}

fn paint(kind: PartKind) -> Paint {
    Paint { kind, colour: DOCUMENT, width: 0.0, text_height: 0.0 }
}

/// The diagonal of a box; 0 without one.
fn size(bounds: Option<&BoundingBox>) -> f64 {
    bounds.map_or(0.0, |bounds| bounds.diagonal().length())
}
