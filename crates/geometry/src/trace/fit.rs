//! Curves through the places that were followed: in space and in both domains, of one parameter.

use katydid_elementary::Elementary;

use super::thresholds::{ALONG, FLAT_ARC, SAME_PLACE};
use super::{Condition, Cubic, Four, Pair, Place};
use crate::curve::traced::{Sample, shape};
use crate::{Curve, NurbsCurve, Point3, Result, Vector3};

/// A curve in space with its images in both domains.
#[derive(Debug, Clone)]
pub(crate) struct Fitted {
    pub(crate) curve: Curve,
    pub(crate) parameters: [NurbsCurve; 2],
    /// The largest distance that was measured between the curve, its images, and both surfaces.
    pub(crate) deviation: f64,
}

/// So many places between two of the curve's are measured.
const TESTED: usize = 4;

/// The places without those between that are in the place of one before or of the last.
fn apart(places: &[Place], near: f64) -> Vec<Place> {
    let mut kept: Vec<Place> = Vec::with_capacity(places.len());
    for (i, place) in places.iter().enumerate() {
        let is_last = i + 1 == places.len();
        while is_last
            && kept.len() > 1
            && kept.last().is_some_and(|k| (k.point - place.point).length() <= near)
        {
            kept.pop();
        }
        if is_last || kept.last().is_none_or(|k| (k.point - place.point).length() > near) {
            kept.push(*place);
        }
    }
    kept
}

/// Whether the curve runs along a direction at a place.
fn is_along(place: &Place, direction: Vector3) -> bool {
    place.tangent.cross(direction).length() <= ALONG * direction.length()
}

/// So often are places put between, which makes the cubics 16 times as exact each time where the surfaces are smooth, and twice
/// where the speed of a surface leaps at one end.
const REFINEMENTS: usize = 16;

/// As [`fitted`], with places put between until the deviation is within a limit, if that helps: first where the curve runs over
/// lines between patches, because cubics are exact only where the surfaces have their derivatives.
///
/// # Errors
/// A number is not finite.
pub(crate) fn fitted_within(pair: &Pair<'_>, places: &[Place], limit: f64) -> Result<Fitted> {
    let mut places = apart(places, SAME_PLACE * pair.size());
    let (mut fit, mut misses) = measured(pair, &places)?;
    for round in 0..REFINEMENTS {
        if fit.deviation <= limit {
            break;
        }
        let off = |i: usize| misses.get(i).is_some_and(|miss| *miss > limit);
        let more = if round == 0 { between_patches(pair, &places, &off) } else { Vec::new() };
        let more = if more.is_empty() { halved(pair, &places, &off) } else { more };
        if more.is_empty() {
            break;
        }
        places = apart(&merged(&places, more), SAME_PLACE * pair.size());
        let (finer, next) = measured(pair, &places)?;
        misses = next;
        if finer.deviation < fit.deviation {
            fit = finer;
        }
    }
    Ok(fit)
}

/// The places with others put in, each behind the place of an index.
fn merged(places: &[Place], more: Vec<(usize, Place)>) -> Vec<Place> {
    let mut more = more.into_iter().peekable();
    let mut out = Vec::with_capacity(places.len() + more.len());
    for (i, place) in places.iter().enumerate() {
        out.push(*place);
        while let Some((_, put)) = more.next_if(|(at, _)| *at == i) {
            out.push(put);
        }
    }
    out
}

/// A place of the curve between two others, near parameters.
fn between(pair: &Pair<'_>, from: &Place, to: &Place, near: Four, condition: Condition) -> Option<Place> {
    let chord = to.point - from.point;
    let found = pair.place(pair.polished(near, condition)?)?;
    // Between both, or it is a place of another curve.
    let along = (found.point - from.point).dot(chord);
    let is_between = along > 0.0 && along < chord.length_squared();
    (is_between && found.tangent.dot(from.tangent) > 0.0).then_some(found)
}

/// Places halfway between two, where Newton's method finds one.
fn halved(pair: &Pair<'_>, places: &[Place], wanted: &dyn Fn(usize) -> bool) -> Vec<(usize, Place)> {
    let middle = |(i, w): (usize, &[Place])| {
        let [from, to] = [&w[0], &w[1]];
        let chord = to.point - from.point;
        let cubic = Cubic { from, to, length: chord.length() };
        let slice = Condition::Slice { through: cubic.point(0.5), across: chord.unitized()? };
        Some((i, between(pair, from, to, cubic.parameters(0.5), slice)?))
    };
    places.windows(2).enumerate().filter(|(i, _)| wanted(*i)).filter_map(middle).collect()
}

/// Places where the curve runs over lines between patches.
fn between_patches(pair: &Pair<'_>, places: &[Place], wanted: &dyn Fn(usize) -> bool) -> Vec<(usize, Place)> {
    let mut out = Vec::new();
    for (i, w) in places.windows(2).enumerate().filter(|(i, _)| wanted(*i)) {
        let [from, to] = [&w[0], &w[1]];
        let cubic = Cubic { from, to, length: (to.point - from.point).length() };
        let mut own: Vec<(f64, Place)> = Vec::new();
        for parameter in 0..4 {
            let (a, b) = (from.x[parameter], to.x[parameter]);
            for value in pair.charts[parameter / 2].lines_between(parameter % 2, a.min(b), a.max(b)) {
                let near = cubic.parameters((value - a) / (b - a));
                if let Some(place) = between(pair, from, to, near, Condition::Fixed { parameter, value }) {
                    own.push(((place.point - from.point).length(), place));
                }
            }
        }
        own.sort_by(|x, y| x.0.total_cmp(&y.0));
        out.extend(own.into_iter().map(|(_, place)| (i, place)));
    }
    out
}

/// The curve through places in order. It runs by its length: lines and arcs as such, else cubics.
///
/// # Errors
/// A number is not finite.
pub(crate) fn fitted(pair: &Pair<'_>, places: &[Place]) -> Result<Fitted> {
    Ok(measured(pair, &apart(places, SAME_PLACE * pair.size()))?.0)
}

/// As [`fitted`] through places apart from each other, with the deviation from each to the next.
fn measured(pair: &Pair<'_>, places: &[Place]) -> Result<(Fitted, Vec<f64>)> {
    let mut lengths = vec![0.0];
    for w in places.windows(2) {
        // The length of an arc with these tangents.
        let half = 0.5 * w[0].tangent.angle_to(w[1].tangent).unwrap_or(0.0);
        let stretch = if half > FLAT_ARC { half / half.sine() } else { 1.0 };
        lengths.push(lengths.last().copied().unwrap_or(0.0) + stretch * (w[1].point - w[0].point).length());
    }
    let samples: Vec<Sample> =
        places.iter().map(|p| Sample { point: p.point.to_point(), direction: Some(p.tangent) }).collect();
    let curve = match shape(&samples)? {
        // Two places alone lie on a line whatever is between them.
        Curve::Line(line) if places.iter().all(|p| is_along(p, line.line.direction())) => line.into(),
        Curve::Nurbs(_) | Curve::Line(_) => {
            let points: Vec<Point3> = samples.iter().map(|s| s.point).collect();
            let tangents: Vec<Vector3> = places.iter().map(|p| p.tangent).collect();
            NurbsCurve::hermite_through(&points, &tangents, &lengths)?.into()
        }
        plain => plain,
    };
    let parameters = [0, 1].map(|s| {
        let at = |x: &Four| Vector3::new(x[2 * s], x[2 * s + 1], 0.0);
        let points: Vec<Point3> = places.iter().map(|p| at(&p.x).to_point()).collect();
        let slopes: Vec<Vector3> = places.iter().map(|p| at(&p.velocity)).collect();
        NurbsCurve::hermite_through(&points, &slopes, &lengths)
    });
    let [first, second] = parameters;
    let parameters = [first?, second?];
    let mut misses = Vec::with_capacity(lengths.len());
    for i in 1..lengths.len() {
        let mut deviation: f64 = 0.0;
        for j in 0..TESTED {
            let share = (j as f64 + 0.5) / TESTED as f64;
            let t = lengths[i - 1] + share * (lengths[i] - lengths[i - 1]);
            let whole = lengths.last().copied().unwrap_or(1.0);
            let p = curve.point_at(curve.domain().at(t / whole)).to_vector();
            for (s, image) in parameters.iter().enumerate() {
                let uv = image.point_at(t);
                let on = pair.charts[s].jet([uv.x, uv.y])[0];
                deviation = deviation.max((on - p).length());
            }
        }
        misses.push(deviation);
    }
    let deviation = misses.iter().copied().fold(0.0, f64::max);
    Ok((Fitted { curve, parameters, deviation }, misses))
}
