//! Isocurves beyond those at the knots.

use katydid_data::Colour;
use katydid_geometry::{Curve, Direction, NurbsCurve, NurbsSurface};

use super::{Measure, Sheet, Subjects};
use crate::display::curves::Smoothness;
use crate::display::parts::{DOCUMENT, Paint};
use crate::protocol::{AnalysisView, PartKind};

/// The colours of isocurves along u and along v, which are those of the axes of a plane.
const COLOURS: [Colour; 2] = [Colour::rgb(190, 50, 50), Colour::rgb(40, 140, 50)];
/// Of more spans in a direction some are left out evenly.
const MOST_SPANS: usize = 24;
/// With so many isocurves each is drawn with fewer segments.
const MANY: usize = 500;

/// A line of one constant parameter.
pub(super) struct Isocurve {
    pub(super) curve: NurbsCurve,
    /// Along which direction it runs: 0 for u, 1 for v.
    along: usize,
    /// Whether it is at a knot or a side, where a preview has one already.
    is_knot: bool,
}

fn spans(surface: &NurbsSurface, direction: Direction) -> Vec<f64> {
    let all = surface.span_parameters(direction);
    let step = all.len().saturating_sub(1).div_ceil(MOST_SPANS).max(1);
    let mut kept: Vec<f64> = all.iter().copied().step_by(step).collect();
    if kept.last() != all.last() {
        kept.extend(all.last());
    }
    kept
}

/// The isocurves at sides and knots, and so many between two of them, in both directions.
pub(super) fn isocurves(surface: &NurbsSurface, between: usize) -> impl Iterator<Item = Isocurve> + '_ {
    Direction::BOTH.into_iter().enumerate().flat_map(move |(along, direction)| {
        let knots = spans(surface, direction.other());
        let mut places: Vec<(f64, bool)> = Vec::new();
        for pair in knots.windows(2) {
            let [a, b] = *pair else { continue };
            places.push((a, true));
            let steps = between + 1;
            places.extend((1..steps).map(|k| (a + (b - a) * (k as f64 / steps as f64), false)));
        }
        places.extend(knots.last().map(|last| (*last, true)));
        places.into_iter().filter_map(move |(at, is_knot)| {
            let curve = surface.isocurve(direction, at).ok()?;
            Some(Isocurve { curve, along, is_knot })
        })
    })
}

/// So many isocurves a span, or as many fewer as all surfaces together may have.
pub(super) fn fitting(all: &[&Subjects], between: usize, most: usize) -> usize {
    let count = |surface: &NurbsSurface| -> usize {
        Direction::BOTH.iter().map(|d| spans(surface, *d).len().saturating_sub(1)).sum()
    };
    let spans: usize = all.iter().flat_map(|subjects| subjects.surfaces()).map(|(_, s)| count(s)).sum();
    between.min(most / spans.max(1))
}

/// Draws those between the knots; with a colour for each direction all of them.
pub(super) fn draw(sheet: &mut Sheet, subjects: &Subjects, analysis: &AnalysisView, measure: &Measure) {
    let directions = analysis.isocurves.is_some_and(|lines| lines.directions);
    let smoothness = Smoothness::for_curves(if measure.is_draft { usize::MAX } else { MANY });
    for (origin, surface) in subjects.surfaces() {
        for line in isocurves(surface, measure.between).filter(|line| directions || !line.is_knot) {
            if sheet.is_full() {
                return;
            }
            let points = smoothness.points(&Curve::Nurbs(line.curve));
            let colour = COLOURS.get(line.along).filter(|_| directions).copied().unwrap_or(DOCUMENT);
            let paint = Paint { kind: PartKind::Isocurves, colour, width: 0.0, text_height: 0.0 };
            sheet.parts.line(paint, &points, origin);
        }
    }
}
