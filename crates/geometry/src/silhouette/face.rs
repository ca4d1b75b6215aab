//! Silhouettes across faces.

use super::form::Form;
use super::{Silhouette, SilhouetteKind, SilhouettePart, Silhouettes, Viewpoint};
use crate::brep::ClosestOnBrep;
use crate::curve::traced::{Sample, joined, sampled};
use crate::intersect::zeros;
use crate::silhouette::thresholds::{NO_WAY, SAME_END, STRETCH};
use crate::surface::Round;
use crate::thresholds;
use crate::{
    Curve, Direction, Interval, NurbsSurface, Point3, Quadrant, Result, Surface, Tolerance, Vector3,
};

/// The silhouettes across one face, within its trims. Those along its edges are left to them.
pub(super) fn silhouettes(
    search: &ClosestOnBrep,
    face: usize,
    viewpoint: Viewpoint,
    tolerance: &Tolerance,
) -> Result<Silhouettes> {
    let mut out = Silhouettes { curves: Vec::new(), complete: true };
    let brep = search.brep();
    let deleted = brep.faces().get(face).is_none_or(|f| f.deleted);
    let Some(surface) = brep.face_surface(face).filter(|s| !deleted && !matches!(s, Surface::Plane(_)))
    else {
        return Ok(out);
    };
    let edges: Vec<Curve> = brep
        .trims_of(face)
        .into_iter()
        .filter_map(|t| brep.trims().get(t)?.edge)
        .filter_map(|e| brep.edge_as_curve(e).ok().flatten())
        .collect();
    let closed = Round::of(surface)
        .and_then(|round| super::round::silhouettes(&round, viewpoint, tolerance.absolute))
        .map(|curves| curves.into_iter().map(|c| (SilhouetteKind::Tangent, c)).collect());
    let whole = closed.is_some() && brep.faces().get(face).is_some_and(|own| brep.is_whole(own));
    let found = match closed {
        Some(curves) => OnSurface { curves, complete: true },
        None => on_surface(surface, viewpoint, tolerance)?,
    };
    out.complete = found.complete;
    for (kind, curve) in found.curves {
        let pieces = if whole { vec![curve] } else { search.curve_on_face(face, &curve)? };
        for piece in pieces {
            if piece.length() > tolerance.absolute && !runs_along(&piece, &edges, tolerance.absolute)? {
                out.curves.push(Silhouette { curve: piece, kind, part: SilhouettePart::Face(face) });
            }
        }
    }
    Ok(out)
}

/// Whether a curve is one of the edges or a part of it.
fn runs_along(curve: &Curve, edges: &[Curve], tolerance: f64) -> Result<bool> {
    let domain = curve.domain();
    for edge in edges {
        let mut all = true;
        for x in [0.5, 0.13, 0.87, 0.31, 0.69] {
            all = all && edge.closest_point_within(curve.point_at(domain.at(x)), 2.0 * tolerance)?.is_some();
        }
        if all {
            return Ok(true);
        }
    }
    Ok(false)
}

struct OnSurface {
    curves: Vec<(SilhouetteKind, Curve)>,
    complete: bool,
}

/// The silhouettes of a whole surface, without its sides.
fn on_surface(surface: &Surface, viewpoint: Viewpoint, tolerance: &Tolerance) -> Result<OnSurface> {
    let limit = tolerance.absolute;
    let nurbs = surface.to_nurbs()?;
    let size = crate::BoundingBox::from_points(nurbs.control_points()).map_or(0.0, |b| b.diagonal().length());
    let patches = nurbs.bezier_patches()?;
    let forms: Vec<Form> = patches.iter().map(|p| Form::new(p, viewpoint)).collect();
    let cells = forms.iter().enumerate().filter_map(|(i, form)| form.cell(i));
    let (stretches, complete) = zeros::stretches(cells, STRETCH);
    let mut rows: Vec<Vec<Sample>> = Vec::with_capacity(stretches.len());
    for stretch in &stretches {
        let Some(patch) = patches.get(stretch.patch()) else { continue };
        rows.extend(sampled(0.0, 1.0, 2, 0.25 * limit, |x| {
            Ok(Some(sample(patch, stretch.place(x), viewpoint)))
        })?);
    }
    let gap = (SAME_END * size).min(0.25 * limit).max(thresholds::ROUNDING * size);
    let curves = joined(&rows, gap, tolerance.angle)?;
    let mut curves: Vec<_> = curves.into_iter().map(|c| (SilhouetteKind::Tangent, c)).collect();
    curves.extend(knot_lines(&nurbs, &forms, thresholds::SAME_POINT * size)?);
    Ok(OnSurface { curves, complete })
}

/// The point of a silhouette at a place, and its direction either way: along it the derivative of N·(towards the viewer)
/// is zero.
fn sample(patch: &NurbsSurface, [u, v]: [f64; 2], viewpoint: Viewpoint) -> Sample {
    let jet = patch.derivatives(u, v, 2, Quadrant::NorthEast);
    let (su, sv) = (jet.get(1, 0), jet.get(0, 1));
    let point: Point3 = jet.point();
    let view = viewpoint.towards(point);
    let slope = |a: Vector3, b: Vector3| view.dot(a.cross(sv) + su.cross(b));
    let (fu, fv) = (slope(jet.get(2, 0), jet.get(1, 1)), slope(jet.get(1, 1), jet.get(0, 2)));
    let direction = su * fv - sv * fu;
    let scale = su.length() * fv.abs() + sv.length() * fu.abs();
    let told = scale > 0.0 && direction.length() > NO_WAY * scale;
    Sample { point, direction: if told { direction.unitized() } else { None } }
}

/// The silhouettes along inner knot lines. `forms` belong to the Bézier patches, v running fastest.
fn knot_lines(nurbs: &NurbsSurface, forms: &[Form], least: f64) -> Result<Vec<(SilhouetteKind, Curve)>> {
    let spans = Direction::BOTH.map(|d| nurbs.span_parameters(d));
    let counts = [0, 1].map(|d| spans[d].len().saturating_sub(1));
    let mut out = Vec::new();
    for across in Direction::BOTH {
        let along = across.other();
        let (d, n, m) = (across.index(), counts[across.index()], counts[along.index()]);
        for line in 1..n {
            let mut runs: Vec<(SilhouetteKind, [usize; 2])> = Vec::new();
            for k in 0..m {
                let form = |i: usize| forms.get(if d == 0 { i * m + k } else { k * n + i });
                let (Some(before), Some(after)) = (form(line - 1), form(line)) else { continue };
                let Some(kind) = beside(before, after, d) else { continue };
                match runs.last_mut() {
                    Some((last, run)) if *last == kind && run[1] == k => run[1] = k + 1,
                    _ => runs.push((kind, [k, k + 1])),
                }
            }
            for (kind, [from, to]) in runs {
                let at = |i: usize| spans[along.index()].get(i).copied().unwrap_or(0.0);
                let Ok(iso) = nurbs.isocurve(along, spans[d].get(line).copied().unwrap_or(0.0)) else {
                    continue;
                };
                let iso: Curve = iso.into();
                let curve =
                    if from == 0 && to == m { iso } else { iso.trimmed(Interval::new(at(from), at(to)))? };
                if curve.bounding_box().diagonal().length() > least {
                    out.push((kind, curve));
                }
            }
        }
    }
    Ok(out)
}

/// What the common side of two patches is, one after the other along u (0) or v (1), if it is a silhouette.
fn beside(before: &Form, after: &Form, d: usize) -> Option<SilhouetteKind> {
    let [last, first] = [2 * d + 1, 2 * d];
    let signs = [before.sign_beside(last), after.sign_beside(first)];
    match signs {
        [0, 0] => None,
        [0, _] | [_, 0] if before.level != after.level => Some(SilhouetteKind::Projecting),
        [a, b] if a * b < 0 && before.zero[last] && after.zero[first] => Some(SilhouetteKind::Tangent),
        _ => None,
    }
}
