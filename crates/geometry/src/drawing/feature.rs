//! Curves in space with their pictures.

use katydid_elementary::Elementary;

use super::{DrawingOptions, View};
use crate::drawing::thresholds::STEP_DONE;
use crate::silhouette::SilhouetteKind;
use crate::thresholds;
use crate::{Curve, Interval, Line, NurbsCurve, Plane, Point3, PolylineCurve, Result, Vector3};

/// A curve to be drawn.
#[derive(Debug, Clone)]
pub(super) struct Feature {
    pub(super) object: usize,
    pub(super) kind: SilhouetteKind,
    /// The faces of its object that it lies on.
    pub(super) faces: Vec<usize>,
    /// In space.
    space: NurbsCurve,
    /// In the picture, with the same parameters.
    picture: NurbsCurve,
    view: View,
    /// Places along it, so close that the chords between their pictures are within the tolerance.
    pub(super) samples: Vec<Sample>,
}

/// A place on a curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) t: f64,
    pub(super) at: [f64; 2],
}

/// Halvings of a span at most.
const DEEPEST: u32 = 12;
/// The most samples of one curve.
const MOST: usize = 40_000;
/// Places in a span between which a curve is taken to pass a clipping plane at most once.
const PLACES: usize = 16;
/// Halvings for the place where it passes.
const HALVINGS: usize = 60;

impl Feature {
    /// The parts of a curve that no plane cuts away and that have a picture.
    pub(super) fn new(
        object: usize,
        kind: SilhouetteKind,
        curve: &Curve,
        faces: Vec<usize>,
        view: &View,
        options: &DrawingOptions,
    ) -> Result<Vec<Self>> {
        curve.check_finite()?;
        let mut parts = vec![curve.to_nurbs()?];
        // A section lies in its own plane.
        let lies = |p: &Plane, c: &NurbsCurve| {
            c.control_points().iter().all(|q| p.signed_distance(*q).abs() <= options.tolerance.absolute)
        };
        for plane in options.clipping.iter().copied().chain(view.clipping()) {
            let mut kept = Vec::new();
            for part in parts {
                if kind == SilhouetteKind::SectionCut && lies(&plane, &part) {
                    kept.push(part);
                } else {
                    kept.extend(above(&part, &plane)?);
                }
            }
            parts = kept;
        }
        let tolerance = options.tolerance.absolute;
        let mut out = Vec::with_capacity(parts.len());
        for space in parts {
            let picture = view.picture_of(&space)?;
            let samples = samples(&picture, 0.5 * tolerance);
            let reach = samples
                .first()
                .map_or(0.0, |a| samples.iter().map(|s| distance(a.at, s.at)).fold(0.0, f64::max));
            if reach > tolerance {
                out.push(Self { object, kind, faces: faces.clone(), space, picture, view: *view, samples });
            }
        }
        Ok(out)
    }

    pub(super) fn domain(&self) -> Interval {
        self.picture.domain()
    }

    pub(super) fn space(&self) -> &NurbsCurve {
        &self.space
    }

    /// Its spans in space as Bézier curves, each with its range.
    pub(super) fn beziers(&self) -> impl Iterator<Item = (Vec<[f64; 4]>, Interval)> + '_ {
        let (knots, degree) = (self.space.knots(), self.space.degree());
        self.space.spans().map(move |j| {
            let range = Interval::new(knots[j + degree - 1], knots[j + degree]);
            (self.space.bezier_points(j), range)
        })
    }

    pub(super) fn point(&self, t: f64) -> Point3 {
        self.space.point_at(t)
    }

    /// How near to the viewer a place is: it grows towards the viewer.
    pub(super) fn depth(&self, t: f64) -> f64 {
        self.view.picture(self.space.point_at(t)).1
    }

    /// The parameter of the place in the picture nearest to a point, found from a guess.
    pub(super) fn nearest(&self, q: [f64; 2], guess: f64) -> f64 {
        let domain = self.domain();
        let mut t = guess;
        for _ in 0..8 {
            let (at, d) = self.jet(t);
            let square = d[0] * d[0] + d[1] * d[1];
            if !(square > 0.0) {
                break;
            }
            let step = ((q[0] - at[0]) * d[0] + (q[1] - at[1]) * d[1]) / square;
            t = (t + step).clamp(domain.start, domain.end);
            if step.abs() <= STEP_DONE * domain.length() {
                break;
            }
        }
        t
    }

    /// The parameters of the samples within a range, `most` of them at most.
    pub(super) fn sampled(&self, range: Interval, most: usize) -> impl Iterator<Item = f64> + '_ {
        let from = self.samples.partition_point(|s| s.t <= range.start);
        let to = self.samples.partition_point(|s| s.t < range.end).max(from);
        let step = (to - from).div_ceil(most.max(1)).max(1);
        self.samples.get(from..to).unwrap_or(&[]).iter().step_by(step).map(|s| s.t)
    }

    /// Where the picture turns back on itself: there the curve runs along the line of sight.
    pub(super) fn folds(&self) -> Vec<f64> {
        let speed = |t: f64| {
            let (_, d) = self.jet(t);
            d[0].hypotenuse(d[1])
        };
        let mut out = Vec::new();
        for w in self.samples.windows(3) {
            let [a, b, c] = [w[0], w[1], w[2]];
            let (r, s) = ([b.at[0] - a.at[0], b.at[1] - a.at[1]], [c.at[0] - b.at[0], c.at[1] - b.at[1]]);
            if r[0] * s[0] + r[1] * s[1] >= 0.0 {
                continue;
            }
            // The slowest place, by thirds.
            let (mut low, mut high) = (a.t, c.t);
            for _ in 0..HALVINGS {
                let third = (high - low) / 3.0;
                if speed(low + third) < speed(high - third) { high -= third } else { low += third }
            }
            let slowest = 0.5 * (low + high);
            // At a corner of the curve the speed leaps.
            out.push(if speed(slowest) < 0.1 * speed(a.t).min(speed(c.t)) { slowest } else { b.t });
        }
        out
    }

    pub(super) fn is_closed(&self) -> bool {
        let domain = self.domain();
        let [a, b] = [domain.start, domain.end].map(|t| self.space.point_at(t));
        a.distance_to(b) <= thresholds::SAME_POINT * (1.0 + a.to_vector().length())
    }

    /// The place in the picture and the velocity there.
    pub(super) fn jet(&self, t: f64) -> ([f64; 2], [f64; 2]) {
        let (p, d) = self.picture.derivatives(t, 1, false);
        let d = d.first().copied().unwrap_or(Vector3::ZERO);
        ([p.x, p.y], [d.x, d.y])
    }

    /// How far apart the ends of a piece are in the picture, by way of its middle.
    pub(super) fn picture_chord(&self, range: Interval) -> f64 {
        let [a, b, c] = [range.start, range.middle(), range.end].map(|t| self.picture.point_at(t));
        a.distance_to(b) + b.distance_to(c)
    }

    /// A piece of the picture as a curve: a line, arc or circle where it is one.
    pub(super) fn drawn(&self, range: Interval, tolerance: f64) -> Option<Curve> {
        let domain = self.domain();
        let whole = range.start <= domain.start && domain.end <= range.end;
        let piece = if whole { self.picture.clone() } else { self.picture.trimmed(range).ok()? };
        let points = piece.control_points();
        let size = points.iter().map(|p| p.distance_to(points[0])).fold(0.0, f64::max);
        if size <= tolerance {
            return None;
        }
        if piece.degree() == 1 && points.len() == 2 {
            return Some(Line::new(points[0], points[1]).into());
        }
        if piece.degree() == 1 && !piece.is_rational() {
            return PolylineCurve::new(points).ok().map(Curve::from);
        }
        let piece: Curve = piece.into();
        let exact = thresholds::SAME_POINT * size;
        if let Some(line) = piece.as_line(exact) {
            return Some(line.into());
        }
        if piece.is_closed() {
            if let Some(circle) = piece.as_circle(exact) {
                return Some(circle.into());
            }
        } else if let Some(arc) = piece.as_arc(exact) {
            return Some(arc.into());
        }
        Some(piece)
    }
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypotenuse(a[1] - b[1])
}

/// The parts of a curve on the positive side of a plane.
fn above(curve: &NurbsCurve, plane: &Plane) -> Result<Vec<NurbsCurve>> {
    let heights: Vec<f64> = curve.control_points().iter().map(|p| plane.signed_distance(*p)).collect();
    if heights.iter().all(|h| *h >= 0.0) {
        return Ok(vec![curve.clone()]);
    }
    if heights.iter().all(|h| *h <= 0.0) {
        return Ok(Vec::new());
    }
    let height = |t: f64| plane.signed_distance(curve.point_at(t));
    let spans = curve.span_parameters();
    let mut stops = vec![curve.domain().start];
    let places: Vec<f64> = spans
        .windows(2)
        .flat_map(|w| (0..PLACES).map(|k| w[0] + (w[1] - w[0]) * k as f64 / PLACES as f64))
        .chain([curve.domain().end])
        .collect();
    for w in places.windows(2) {
        let (mut low, mut high) = (w[0], w[1]);
        let was = height(low) > 0.0;
        if (height(high) > 0.0) == was {
            continue;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if (height(middle) > 0.0) == was { low = middle } else { high = middle }
        }
        stops.push(0.5 * (low + high));
    }
    stops.push(curve.domain().end);
    let mut out = Vec::new();
    let least = thresholds::EXACT_PARAMETER * curve.domain().length();
    for w in stops.windows(2) {
        if w[1] - w[0] > least && height(0.5 * (w[0] + w[1])) > 0.0 {
            out.push(curve.trimmed(Interval::new(w[0], w[1]))?);
        }
    }
    Ok(out)
}

fn samples(picture: &NurbsCurve, limit: f64) -> Vec<Sample> {
    let sample = |t: f64| {
        let p = picture.point_at(t);
        Sample { t, at: [p.x, p.y] }
    };
    let straight = picture.degree() == 1;
    let spans = picture.span_parameters();
    let mut out: Vec<Sample> = spans.first().map(|t| sample(*t)).into_iter().collect();
    for w in spans.windows(2) {
        if straight {
            out.push(sample(w[1]));
            continue;
        }
        let parts = 4;
        for k in 0..parts {
            let at = |k: usize| w[0] + (w[1] - w[0]) * k as f64 / parts as f64;
            let mut stack = vec![(sample(at(k)), sample(at(k + 1)), 0)];
            while let Some((a, b, depth)) = stack.pop() {
                let m = sample(0.5 * (a.t + b.t));
                let middle = [0.5 * (a.at[0] + b.at[0]), 0.5 * (a.at[1] + b.at[1])];
                if depth >= DEEPEST || out.len() >= MOST || distance(middle, m.at) <= limit {
                    out.push(b);
                } else {
                    stack.push((m, b, depth + 1));
                    stack.push((a, m, depth + 1));
                }
            }
        }
    }
    out
}
