//! Curves through the places that were followed: in space and in both domains, of one parameter.

use super::{Four, Pair, Place};
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
    place.tangent.cross(direction).length() <= 1e-7 * direction.length()
}

/// The curve through places in order. It runs by its length: lines and arcs as such, else cubics.
///
/// # Errors
/// A number is not finite.
pub(crate) fn fitted(pair: &Pair<'_>, places: &[Place], shift: Vector3) -> Result<Fitted> {
    let places = &apart(places, 1e-7 * pair.size());
    let mut lengths = vec![0.0];
    for w in places.windows(2) {
        // The length of an arc with these tangents.
        let half = 0.5 * w[0].tangent.angle_to(w[1].tangent).unwrap_or(0.0);
        let stretch = if half > 1e-6 { half / half.sin() } else { 1.0 };
        lengths.push(lengths.last().copied().unwrap_or(0.0) + stretch * (w[1].point - w[0].point).length());
    }
    let samples: Vec<Sample> = places
        .iter()
        .map(|p| Sample { point: (p.point + shift).to_point(), direction: Some(p.tangent) })
        .collect();
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
    let mut deviation: f64 = 0.0;
    for i in 1..lengths.len() {
        for j in 0..TESTED {
            let share = (j as f64 + 0.5) / TESTED as f64;
            let t = lengths[i - 1] + share * (lengths[i] - lengths[i - 1]);
            let whole = lengths.last().copied().unwrap_or(1.0);
            let p = curve.point_at(curve.domain().at(t / whole)).to_vector() - shift;
            for (s, image) in parameters.iter().enumerate() {
                let uv = image.point_at(t);
                let on = pair.charts[s].jet([uv.x, uv.y])[0];
                deviation = deviation.max((on - p).length());
            }
        }
    }
    Ok(Fitted { curve, parameters, deviation })
}
