//! Hatches: the inside of closed curves, filled with lines or with a blend of colours.

use std::sync::Arc as Shared;

use katydid_data::Colour;
use katydid_definition::document::Object;
use katydid_elementary::Elementary;
use katydid_geometry::{Curve, Line, Plane, Point3};
use uuid::{Uuid, uuid};

use super::Draw;
use crate::Painter;
use crate::clip;
use crate::colour::blend;
use crate::rows::Row;
use crate::{Form, Look, tessellated};

pub(super) const DRAWN: &[(Uuid, Draw)] = &[
    (uuid!("6ce90407-9eac-4a1a-a81a-949b601f18f3"), gradient),
    (uuid!("5f9e4549-8135-4a90-97c8-8a34bf05e99a"), pattern),
];

/// Strips that a blend is drawn in.
const STRIPS: u32 = 96;
/// The distance of lines of a pattern at scale 1, in units of the model.
const SPACING: f64 = 1.0;
/// No hatch has more lines.
const MOST_LINES: f64 = 2000.0;

/// Closed outlines on their common plane, which is that of the first.
struct Region {
    plane: Plane,
    outlines: Vec<Vec<[f64; 2]>>,
}

impl Region {
    fn new(curves: &[Shared<Curve>]) -> Option<Self> {
        let lines: Vec<Vec<Point3>> = curves
            .iter()
            .map(|curve| tessellated(curve, 1e-3 * curve.bounding_box().diagonal().length()))
            .collect();
        let first = lines.first()?;
        let origin = *first.first()?;
        let x = first.iter().map(|p| *p - origin).max_by(|a, b| a.length().total_cmp(&b.length()))?;
        let off = |p: &&Point3| x.cross(**p - origin).length();
        let far = first.iter().max_by(|a, b| off(a).total_cmp(&off(b)))?;
        let plane = Plane::from_axes(origin, x, *far - origin).ok()?;
        let flat = |p: &Point3| {
            let [u, v, _] = plane.coordinates(*p);
            [u, v]
        };
        let outlines = lines.iter().map(|line| line.iter().map(flat).collect()).collect();
        Some(Self { plane, outlines })
    }

    fn at(&self, [u, v]: [f64; 2]) -> Point3 {
        self.plane.at(u, v, 0.0)
    }

    /// How far the outlines reach in a direction.
    fn reach(&self, direction: [f64; 2]) -> Option<[f64; 2]> {
        let along = self.outlines.iter().flatten().map(|p| p[0] * direction[0] + p[1] * direction[1]);
        along.fold(None, |r: Option<[f64; 2]>, x| Some(r.map_or([x, x], |[a, b]| [a.min(x), b.max(x)])))
    }
}

fn pattern(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let number = row.item::<i32>(1).unwrap_or(0);
    let scale = row.item::<f64>(2).unwrap_or(1.0);
    let angle = row.item::<f64>(3).unwrap_or(0.0);
    for ends in lines(&row.list(0), number, scale, angle) {
        painter.scene.add(Form::Lines(ends.to_vec()), Look { width: 0.7, ..painter.look });
    }
}

/// The lines of a pattern inside closed curves, by the pattern's number, its scale and its turn in radians. Nothing where
/// the curves bound no region, or where there would be more lines than anybody sees.
pub(crate) fn lines(curves: &[Shared<Curve>], number: i32, scale: f64, angle: f64) -> Vec<[Point3; 2]> {
    let mut found = Vec::new();
    let Some(region) = Region::new(curves) else { return found };
    // 0 is a solid fill; the others are lines, every second one crossed.
    let step = if number == 0 { 0.1 } else { SPACING } * scale.abs();
    let turns: &[f64] = if number > 0 && number % 2 == 0 { &[0.25, 0.75] } else { &[0.25] };
    for turn in turns {
        let (sin, cos) = (angle + turn * std::f64::consts::PI).sine_cosine();
        let (along, across) = ([cos, sin], [-sin, cos]);
        let Some([low, high]) = region.reach(across) else { return found };
        if !(step > 0.0 && (high - low) / step <= MOST_LINES) {
            return Vec::new();
        }
        let mut k = (low / step).ceil();
        while k * step <= high {
            let from = across.map(|x| x * k * step);
            for [a, b] in clip::inside(&region.outlines, from, along) {
                let at = |t: f64| region.at([from[0] + along[0] * t, from[1] + along[1] * t]);
                found.push([at(a), at(b)]);
            }
            k += 1.0;
        }
    }
    found
}

fn gradient(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(region), Some(axis)) = (Region::new(&row.list(0)), row.item::<Line>(1)) else { return };
    let first = row.item::<Colour>(2).unwrap_or(Colour::rgb(255, 255, 255));
    let second = row.item::<Colour>(3).unwrap_or_default();
    let flat = |p: Point3| region.plane.coordinates(p);
    let ([a, b, _], [c, d, _]) = (flat(axis.from), flat(axis.to));
    let length = (c - a).hypotenuse(d - b);
    if !(length > 0.0) {
        return;
    }
    let across = [(c - a) / length, (d - b) / length];
    let along = [-across[1], across[0]];
    let start = a * across[0] + b * across[1];
    let Some([low, high]) = region.reach(across) else { return };
    let step = (high - low) / f64::from(STRIPS);
    for k in 0..STRIPS {
        let middle = low + (f64::from(k) + 0.5) * step;
        let colour = |h: f64| blend(first, second, ((h - start) / length).clamp(0.0, 1.0));
        for [t, u] in clip::inside(&region.outlines, across.map(|x| x * middle), along) {
            let at = |h: f64, t: f64| region.at([0, 1].map(|i| across[i] * h + along[i] * t));
            let (h0, h1) = (middle - 0.5 * step, middle + 0.5 * step);
            let corners = [at(h0, t), at(h0, u), at(h1, u), at(h1, t)];
            let colours = [colour(h0), colour(h0), colour(h1), colour(h1)];
            painter.scene.add(Form::Tile(corners, colours), painter.look);
        }
    }
}
