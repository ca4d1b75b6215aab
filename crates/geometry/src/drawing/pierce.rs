//! Where curves go through surfaces.

use crate::thresholds;
use std::collections::BTreeSet;
use std::ops::ControlFlow;

use super::feature::Feature;
use super::occluder::{Occluders, Source};
use super::sheet::{box_of_points, height};
use crate::bernstein::halves;
use crate::box_tree::boxes_meet;
use crate::{Curve, Point3, Result, intersect};

/// Below this part of the size heights above a surface are rounding.
const NOISE: f64 = 1e-12;
/// A part of a curve is halved while more triangles than this are near it.
const MANY: usize = 8;
/// Halvings of a span for the triangles near it.
const DEEPEST: u32 = 10;
/// The most pairs of parts that are looked at for a curve and a surface without a closed form.
const MOST_VISITS: u64 = 20_000;

/// Where a curve goes through surfaces.
#[derive(Debug)]
pub(super) struct Piercings {
    /// The parameters, in no order.
    pub(super) stops: Vec<f64>,
    /// Whether the search came to its end.
    pub(super) complete: bool,
}

impl Occluders {
    /// The parameters at which a curve goes through the faces that it does not lie on, and where it begins and ends to lie
    /// in one. Planes, spheres, cylinders, cones and meshes are met at the roots of polynomials, other surfaces as
    /// [`curve_surface`](intersect::curve_surface()) tells; those of the curve's own object are taken to meet it nowhere.
    pub(super) fn pierced(&self, feature: &Feature) -> Result<Piercings> {
        let mut out = Piercings { stops: Vec::new(), complete: true };
        let mut others: BTreeSet<(usize, usize)> = BTreeSet::new();
        for (points, range) in feature.beziers() {
            let bounds = box_of_points(&points);
            self.sheet_tree.visit_where(
                |b| boxes_meet(b, &bounds, self.tolerance),
                |i| {
                    if let Some(sheet) = self.sheets.get(i).filter(|sheet| !sheet.carries(feature)) {
                        let form = sheet.along_curve(&points);
                        for x in form.roots(NOISE * form.size().max(self.size)) {
                            let t = range.at(x);
                            let p: [f64; 3] = feature.point(t).into();
                            if boxes_meet(&sheet.bounds, &[p, p], self.tolerance) {
                                out.stops.push(t);
                            }
                        }
                    }
                    ControlFlow::Continue(())
                },
            );
            let mut stack = vec![(points, 0.0, 1.0, 0)];
            while let Some((points, a, b, depth)) = stack.pop() {
                let bounds = box_of_points(&points);
                let mut near: Vec<usize> = Vec::new();
                self.tree.boxes().visit_where(
                    |b| boxes_meet(b, &bounds, self.coarse),
                    |i| {
                        near.push(i);
                        if near.len() > MANY && depth < DEEPEST {
                            ControlFlow::Break(())
                        } else {
                            ControlFlow::Continue(())
                        }
                    },
                );
                if near.len() > MANY && depth < DEEPEST {
                    let (left, right) = halves(&points);
                    let middle = 0.5 * (a + b);
                    stack.push((right, middle, b, depth + 1));
                    stack.push((left, a, middle, depth + 1));
                    continue;
                }
                for i in near {
                    let Some((corners, triangle)) = self.tree.triangle(i) else { continue };
                    match self.sources.get(triangle) {
                        Some(Source::Flat { .. }) => {
                            let stops = through(corners, &points, self.size);
                            out.stops.extend(stops.map(|x| range.at(a + (b - a) * x)));
                        }
                        Some(&Source::Face { object, face, .. }) if object != feature.object => {
                            others.insert((object, face));
                        }
                        _ => {}
                    }
                }
            }
        }
        if others.is_empty() {
            return Ok(out);
        }
        let curve: Curve = feature.space().clone().into();
        for (object, face) in others {
            let Some(Some(search)) = self.searches.get(object) else { continue };
            let Some(surface) = search.brep().face_surface(face) else { continue };
            let nurbs = surface.to_nurbs()?;
            let found = intersect::curve_surface_within(&curve, &nurbs, self.tolerance, MOST_VISITS)?;
            out.complete &= found.complete;
            out.stops.extend(found.crossings.iter().map(|c| c.t));
            out.stops.extend(found.overlaps.iter().flat_map(|o| [o.t.start, o.t.end]));
        }
        Ok(out)
    }
}

/// Where a Bézier curve goes through a triangle from one side to the other, over 0…1.
fn through<'a>(
    corners: &'a [Point3; 3],
    points: &'a [[f64; 4]],
    size: f64,
) -> impl Iterator<Item = f64> + use<'a> {
    let [a, b, c] = *corners;
    let normal = (b - a).cross(c - a).unitized();
    let roots = normal.map_or_else(Vec::new, |n| {
        let form = height(points, a, n);
        let noise = NOISE * form.size().max(size);
        let sides = form.coefficients();
        // What only touches the plane does not go through it.
        if sides.iter().all(|h| *h >= -noise) || sides.iter().all(|h| *h <= noise) {
            Vec::new()
        } else {
            form.roots(noise)
        }
    });
    roots.into_iter().filter(move |x| {
        let [px, py, pz, w] = crate::bernstein::value(points, *x);
        let p = Point3::new(px / w, py / w, pz / w);
        normal.is_some_and(|n| {
            [(a, b), (b, c), (c, a)].iter().all(|(from, to)| {
                (*to - *from).cross(p - *from).dot(n)
                    >= -thresholds::SAME_POINT * (*to - *from).length_squared()
            })
        })
    })
}
