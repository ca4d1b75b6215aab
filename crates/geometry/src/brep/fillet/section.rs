//! What a rounded edge looks like across: a segment, an arc, or a curve that meets the curvature of both faces.

use super::FilletBlend;
use super::wedge::{Station, Wedge};
use crate::brep::fillet::thresholds::SECTION_STEP;
use crate::{Arc, ArcCurve, Curve, Interval, Line, LineCurve, NurbsCurve, Point3, Result, Vector3};

/// The homogeneous control points (x·w, y·w, z·w, w) of the Bézier curve from the first contact to the second.
pub(super) fn columns(wedge: &Wedge<'_>, station: &Station, blend: FilletBlend) -> Vec<[f64; 4]> {
    let [a, b] = station.contacts;
    let plain = |p: Point3| [p.x, p.y, p.z, 1.0];
    if blend == FilletBlend::Chamfer {
        return vec![plain(a), plain(b)];
    }
    let [from, to] = station.arms();
    // Where the tangents of the arc meet; its weight is the cosine of half the arc.
    let cosine = (0.5 * (1.0 + from.dot(to))).max(0.0).sqrt();
    let scaled = station.centre.to_vector() * cosine + (from + to) * (0.5 * station.radius / cosine);
    if blend == FilletBlend::Arc {
        return vec![plain(a), [scaled.x, scaled.y, scaled.z, cosine], plain(b)];
    }
    let apex = (scaled / cosine).to_point();
    // A Bézier curve of degree 5 has at its start the derivatives 5 (P1 − P0) and 20 (P2 − 2 P1 + P0). With a speed of
    // twice the way to the apex, P1 and P2 lie at 0.4 and 0.8 of it, P2 raised by what the face's curvature asks for.
    let side = |p: Point3, k: usize| {
        let way = apex - p;
        let bend = wedge.bend(station, k, way);
        [p + way * 0.4, p + way * 0.8 + bend * 0.2]
    };
    let ([a1, a2], [b1, b2]) = (side(a, 0), side(b, 1));
    [a, a1, a2, b2, b1, b].map(plain).to_vec()
}

/// The derivatives of the columns along the edge, from that of the unknowns: by differences of fourth order.
pub(super) fn slopes(
    wedge: &Wedge<'_>,
    x: &[f64; 5],
    slope: &[f64; 5],
    blend: FilletBlend,
) -> Option<Vec<[f64; 4]>> {
    let step = SECTION_STEP * wedge.curve.domain().length();
    let at = |h: f64| -> Option<Vec<[f64; 4]>> {
        let moved: [f64; 5] = std::array::from_fn(|k| x[k] + h * slope[k]);
        Some(columns(wedge, &wedge.of(&moved)?, blend))
    };
    let (p, q) = (at(step)?, at(-step)?);
    let (pp, qq) = (at(2.0 * step)?, at(-2.0 * step)?);
    let out = (0..p.len()).map(|n| {
        std::array::from_fn(|c| (8.0 * (p[n][c] - q[n][c]) - (pp[n][c] - qq[n][c])) / (12.0 * step))
    });
    Some(out.collect())
}

/// The section as a Bézier curve over 0…1.
pub(super) fn bezier(columns: &[[f64; 4]]) -> Result<NurbsCurve> {
    let degree = columns.len() - 1;
    let knots = [vec![0.0; degree], vec![1.0; degree]].concat();
    if columns.iter().all(|c| c[3] == 1.0) {
        let points = columns.iter().map(|c| Point3::new(c[0], c[1], c[2])).collect();
        return NurbsCurve::new(degree, points, knots);
    }
    NurbsCurve::rational(degree, columns.to_vec(), knots)
}

/// The section as the simplest curve that it is, over 0…1.
pub(super) fn simplest(wedge: &Wedge<'_>, station: &Station, blend: FilletBlend) -> Result<Curve> {
    let unit = Interval::new(0.0, 1.0);
    let [a, b] = station.contacts;
    match blend {
        FilletBlend::Chamfer => Ok(LineCurve { line: Line::new(a, b), domain: unit }.into()),
        FilletBlend::Arc => {
            let [from, to] = station.arms();
            let middle: Vector3 = (from + to).unitized().unwrap_or(from);
            let arc = Arc::through(a, station.centre + middle * station.radius, b)?;
            Ok(ArcCurve { arc, domain: unit }.into())
        }
        FilletBlend::Smooth => Ok(bezier(&columns(wedge, station, blend))?.into()),
    }
}
