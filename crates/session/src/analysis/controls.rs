//! Control polygons and control nets.

use katydid_geometry::{Curve, Direction, NurbsCurve, NurbsSurface, Point3};
use katydid_scene::Origin;

use super::{Sheet, Subjects};
use crate::protocol::PartKind;

/// A weight that differs from 1 by less is shown as 1.
const ONE: f64 = 1e-9;

/// The NURBS curves that a curve is made of, each with its own degree; points of a polyline are its corners.
fn parts(curve: &Curve, out: &mut Vec<NurbsCurve>) {
    match curve {
        Curve::Poly(poly) => poly.segments().iter().for_each(|segment| parts(segment, out)),
        other => out.extend(other.to_nurbs()),
    }
}

fn curves(subjects: &Subjects) -> impl Iterator<Item = (Origin, NurbsCurve)> + '_ {
    subjects.curves.iter().flat_map(|(origin, curve)| {
        let mut all = Vec::new();
        parts(curve, &mut all);
        all.into_iter().map(|part| (*origin, part))
    })
}

/// How many control points an object has.
pub(super) fn count(subjects: &Subjects) -> usize {
    curves(subjects).map(|(_, curve)| curve.point_count()).sum::<usize>()
        + subjects.surfaces().map(|(_, surface)| surface.point_count()).sum::<usize>()
}

fn is_weighted(weight: &f64) -> bool {
    (weight - 1.0).abs() > ONE
}

/// How many texts its control points have: one for the degree, and one for each weight.
pub(super) fn labels(subjects: &Subjects) -> usize {
    let of = |weights: Vec<f64>| 1 + weights.iter().filter(|weight| is_weighted(weight)).count();
    curves(subjects).map(|(_, curve)| of(curve.weights())).sum::<usize>()
        + subjects.surfaces().map(|(_, surface)| of(surface.weights())).sum::<usize>()
}

/// Draws the polygons of curves and the nets of surfaces, with texts where there is room for them.
pub(super) fn draw(sheet: &mut Sheet, subjects: &Subjects, has_labels: bool) {
    for (origin, curve) in curves(subjects) {
        let points = curve.control_points();
        if curve.degree() > 1 {
            sheet.line(PartKind::Hull, 0.0, &points, origin);
        }
        let degree = format!("p = {}", curve.degree());
        corners(sheet, &points, &curve.weights(), Some(degree).filter(|_| has_labels), origin);
    }
    for (origin, surface) in subjects.surfaces() {
        if sheet.is_full() {
            return;
        }
        net(sheet, surface, origin);
        let [u, v] = surface.degrees();
        let degrees = format!("p = {u} × {v}");
        let points = surface.control_points();
        corners(sheet, &points, &surface.weights(), Some(degrees).filter(|_| has_labels), origin);
    }
}

/// The points, the degree beside the first, and weights beside theirs.
fn corners(sheet: &mut Sheet, points: &[Point3], weights: &[f64], degree: Option<String>, origin: Origin) {
    for point in points {
        sheet.point(*point, origin);
    }
    let Some(mut degree) = degree else { return };
    for (k, (point, weight)) in points.iter().zip(weights).enumerate() {
        let mut text = if k == 0 { std::mem::take(&mut degree) } else { String::new() };
        if is_weighted(weight) {
            let weight = katydid_data::text::number((weight * 1e4).round() / 1e4);
            text = if text.is_empty() { format!("w = {weight}") } else { format!("{text}, w = {weight}") };
        }
        if !text.is_empty() {
            sheet.text(*point, text, origin);
        }
    }
}

fn net(sheet: &mut Sheet, surface: &NurbsSurface, origin: Origin) {
    let [n, m] = Direction::BOTH.map(|d| surface.count(d));
    let rows = (0..n).map(|i| (0..m).filter_map(|j| surface.control_point(i, j)).collect::<Vec<_>>());
    let columns = (0..m).map(|j| (0..n).filter_map(|i| surface.control_point(i, j)).collect::<Vec<_>>());
    rows.chain(columns).for_each(|line| sheet.line(PartKind::Hull, 0.0, &line, origin));
}
