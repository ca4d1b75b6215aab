//! Display / Vector: arrows and the order of points; and the curvature graph of Curve / Analysis.

use std::sync::Arc as Shared;

use katydid_data::Colour;
use katydid_definition::document::Object;
use katydid_geometry::{Curve, Field, Point3, Rectangle, Vector3};
use uuid::{Uuid, uuid};

use super::Draw;
use crate::Painter;
use crate::rows::Row;
use crate::{Form, Look, Place};

pub(super) const DRAWN: &[(Uuid, Draw)] = &[
    (uuid!("2a3f7078-2e25-4dd4-96f7-0efb491bd61c"), vector),
    (uuid!("11e95a7b-1e2c-4b66-bd95-fcad51f8662a"), coloured_vector),
    (uuid!("cc14daa5-911a-4fcc-8b3b-1149bf7f2eeb"), point_list),
    (uuid!("1f18e802-4ab9-444f-bf3c-3e7e421a2acf"), early_point_list),
    (uuid!("0ad9f1ab-2204-45bb-b282-474469e2fa7b"), point_order),
    (uuid!("08619b6d-f9c4-4cb2-adcd-90959f08dc0d"), tensors),
    (uuid!("7376fe41-74ec-497e-b367-1ffe5072608b"), curvature_graph),
    // Kangaroo's DotDisplay.
    (uuid!("d27b55c6-9d5f-4d05-be7b-b91009aad383"), dots),
];

fn dots(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let points: Vec<Point3> = row.list(0);
    for p in points {
        painter.scene.add(Form::Point(p), painter.look);
    }
}

fn vector(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    arrow(painter, row, painter.look);
}

fn coloured_vector(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let line = row.item::<Colour>(2).unwrap_or_default();
    let width = f64::from(row.item::<i32>(3).unwrap_or(2).clamp(1, 100));
    arrow(painter, row, Look { line, width, ..painter.look });
}

fn arrow(painter: &mut Painter<'_>, row: &Row<'_>, look: Look) {
    if let (Some(anchor), Some(vector)) = (row.item::<Point3>(0), row.item::<Vector3>(1)) {
        painter.scene.add(Form::Arrow(anchor, vector), look);
    }
}

fn point_list(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    numbers(painter, &row.list(0));
}

fn early_point_list(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let points: Vec<Point3> = row.list(0);
    if row.item::<bool>(2) == Some(true) {
        painter.scene.add(Form::Lines(points.clone()), Look { width: 1.0, ..painter.look });
    }
    if row.item::<bool>(1) == Some(true) {
        numbers(painter, &points);
    }
}

fn numbers(painter: &mut Painter<'_>, points: &[Point3]) {
    for (k, at) in points.iter().enumerate() {
        let tag = Form::Tag { at: *at, text: k.to_string(), size: 12.0, place: Place::Beside };
        painter.scene.add(tag, painter.look);
    }
}

fn point_order(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    for w in row.list::<Point3>(0).windows(2) {
        let [a, b] = *w else { continue };
        painter.scene.add(Form::Arrow(a, b - a), Look { width: 1.0, ..painter.look });
    }
}

/// Arrows over a section of a field, the longest of them as long as the way to the next.
fn tensors(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(field), Some(section)) = (row.item::<Shared<Field>>(0), row.item::<Rectangle>(1)) else {
        return;
    };
    let samples = f64::from(row.item::<i32>(2).unwrap_or(1000).clamp(1, 20_000));
    let (w, h) = (section.x.length().abs(), section.y.length().abs());
    let step = (w * h / samples).sqrt();
    if !(step > 0.0) {
        return;
    }
    let count = |side: f64| (side / step).round().clamp(1.0, samples) as u32;
    let (columns, rows) = (count(w), count(h));
    let middle = |k: u32, n: u32| (f64::from(k) + 0.5) / f64::from(n);
    let places = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let arrows: Vec<(Point3, Vector3)> = places
        .map(|(i, j)| section.plane.at(section.x.at(middle(i, columns)), section.y.at(middle(j, rows)), 0.0))
        .map(|p| (p, field.at(p)))
        .filter(|(_, v)| v.is_finite() && v.length() > 0.0)
        .collect();
    let longest = arrows.iter().map(|(_, v)| v.length()).fold(0.0, f64::max);
    for (p, v) in arrows {
        painter.scene.add(Form::Arrow(p, v * (0.9 * step / longest)), Look { width: 0.8, ..painter.look });
    }
}

/// Hairs, and the line over their tips in each smooth piece.
fn curvature_graph(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let Some(curve) = row.item::<Shared<Curve>>(0) else { return };
    let samples = usize::try_from(row.item::<i32>(1).unwrap_or(10)).unwrap_or(1).clamp(1, 10_000);
    // As the component says: at 100 a hair is as long as the curvature is large.
    let scale = f64::from(row.item::<i32>(2).unwrap_or(105)) / 100.0;
    let hairs = curve.curvature_graph(samples, scale);
    let look = Look { width: 1.0, ..painter.look };
    for piece in hairs.chunks(samples + 1) {
        for hair in piece {
            painter.scene.add(Form::Lines(vec![hair.from, hair.to]), Look { width: 0.7, ..look });
        }
        painter.scene.add(Form::Lines(piece.iter().map(|hair| hair.to).collect()), look);
    }
}
