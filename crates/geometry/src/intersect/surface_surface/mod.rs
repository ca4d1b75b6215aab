//! Surface with surface.

mod contacts;
mod cover;
mod equal;
mod rows;
mod search;
mod tangent_curve;
mod touch;

use cover::Curves;
use search::Search;
use tangent_curve::tangent_curve;

use crate::chart::{Chart, smooth_pieces};
use crate::trace::thresholds::{
    ABOVE_NOISE, AT_CONTACT, AT_POLE, COARSEST, LONGEST, ON_CURVE, SAME_PLACE, SHORTEST, SMALLEST,
};
use crate::trace::{Limits, Pair, fitted, fitted_within};
use crate::{Curve, Error, NurbsCurve, NurbsSurface, Point3, Result, Tolerance, Vector3, Xform};

/// A curve along which two surfaces pass through each other, or touch.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceBranch {
    /// The curve: a line, an arc or a circle where it is one to rounding, else cubics. It runs along the product of the
    /// normals of the surfaces where they pass through each other.
    pub curve: Curve,
    /// Its images in the domain of the first and of the second surface (z is 0). At equal shares of the domains they and
    /// the curve are at the same point. Across a seam they go on beyond the domain.
    pub parameters: [NurbsCurve; 2],
    /// The largest distance between the curve and its images on both surfaces, by measurement between all its places.
    pub deviation: f64,
    /// Whether it ends where it begins.
    pub closed: bool,
}

/// How two surfaces touch where they do not pass through each other at an angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SurfaceContactKind {
    /// They touch in one point.
    Point,
    /// They are tangent in a point where two curves cross each other.
    Crossing,
    /// They touch along a curve.
    Curve,
    /// They have an area in common.
    Overlap,
    /// What they do here was not decided.
    Undecided,
}

/// A place where two surfaces have the same tangent plane, or one of them has none.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceContact {
    /// How they touch.
    pub kind: SurfaceContactKind,
    /// The point where they are nearest, halfway between both.
    pub point: Point3,
    /// The parameters of the point on both surfaces.
    pub at: [[f64; 2]; 2],
    /// The distance between the surfaces there.
    pub gap: f64,
    /// The ranges of u and v of the first, then of the second surface within which the contact lies.
    pub ranges: [[f64; 2]; 4],
    /// The curve along which they touch, when they do so from side to side or around.
    pub curve: Option<SurfaceBranch>,
}

/// All that two surfaces have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceMeeting {
    /// The curves in which they pass through each other.
    pub branches: Vec<SurfaceBranch>,
    /// Where they touch.
    pub contacts: Vec<SurfaceContact>,
    /// Whether every pair of parts of the surfaces was proved to hold nothing, or lies on a branch, or belongs to a
    /// contact whose kind is known.
    pub complete: bool,
}

/// The curves in which two NURBS surfaces meet, and the places in which they touch.
///
/// # Method
/// Both surfaces are cut at their kinks. Pairs of Bézier patches are divided until their hulls are proved apart, or
/// bounds on their derivatives prove that their common curve is a graph over a direction. Curves begin at the common
/// points of the sides with the other surface ([`curve_surface`](super::curve_surface())) and, for loops, in pairs of parts
/// that no curve runs through yet; each is followed by steps within boxes that are proved to hold that curve alone. In the
/// end every pair that was not excluded has a curve in it, or belongs to a contact. Nothing is sampled to find a curve.
/// (After T. Sederberg and R. Meyers, *Loop detection in surface patch intersections*, 1988, with interval bounds instead of
/// cones; marching as in N. Patrikalakis and T. Maekawa, *Shape Interrogation*, 5.8.)
///
/// Where the surfaces touch, Newton's method on their tangent planes finds the place, and the difference of their second
/// fundamental forms its kind; along a curve the way goes on where the difference is 0. Surfaces of equal control points and
/// knots overlap as a whole.
///
/// The result does not depend on the order of the surfaces but for the direction of branches, nor on the number of threads.
///
/// # Errors
/// A surface has weights that are not above 0; the tolerance is not above 0; the surfaces run next to each other over too
/// many patches ([`Error::Unsupported`]); or the work was stopped.
pub fn surface_surface(a: &NurbsSurface, b: &NurbsSurface, tolerance: &Tolerance) -> Result<SurfaceMeeting> {
    let limit = tolerance.positive_distance()?;
    if comes_first(b, a) {
        let mut out = ordered(b, a, limit)?;
        for branch in &mut out.branches {
            branch.parameters.reverse();
            branch.curve = branch.curve.reversed();
            branch.parameters = [branch.parameters[0].reversed(), branch.parameters[1].reversed()];
        }
        for contact in &mut out.contacts {
            contact.at.reverse();
            contact.ranges.rotate_left(2);
            if let Some(curve) = &mut contact.curve {
                curve.parameters.reverse();
            }
        }
        return Ok(out);
    }
    ordered(a, b, limit)
}

/// Whether a surface comes before another by its control points: so that their order in a call does not matter.
fn comes_first(a: &NurbsSurface, b: &NurbsSurface) -> bool {
    let numbers = |s: &NurbsSurface| s.homogeneous_points().concat();
    let order = numbers(a).iter().zip(&numbers(b)).map(|(x, y)| x.total_cmp(y)).find(|o| o.is_ne());
    order.unwrap_or_else(|| a.point_count().cmp(&b.point_count())).is_lt()
}

fn ordered(a: &NurbsSurface, b: &NurbsSurface, limit: f64) -> Result<SurfaceMeeting> {
    let mut out = SurfaceMeeting { branches: Vec::new(), contacts: Vec::new(), complete: true };
    let boxes = [a.hull_box(), b.hull_box()];
    let sizes = boxes.map(|x| x.diagonal().length());
    // Digits are lost far from the origin: near the smaller surface there are more.
    let center = if sizes[0] < sizes[1] { boxes[0].center() } else { boxes[1].center() };
    if !(sizes[0] > 0.0 && sizes[1] > 0.0) {
        return Err(Error::degenerate("surface", "it is a point"));
    }
    let shift = center.to_vector();
    let home = Xform::translation(-shift);
    let whole = [Chart::new(a.transformed(&home)?)?, Chart::new(b.transformed(&home)?)?];
    let pair = Pair::new(&whole[0], &whole[1]);
    let size = pair.size();
    if let Some(mut all) = equal::equal(&pair) {
        all.point += shift;
        out.contacts.push(all);
        return Ok(out);
    }
    let limits = Limits {
        tolerance: 0.5 * limit.min(COARSEST * size).max(ABOVE_NOISE * pair.noise),
        shortest: (SHORTEST * size).max(ABOVE_NOISE * pair.noise),
        longest: LONGEST * size,
        most: 50_000,
    };
    let pieces = [smooth_pieces(whole[0].nurbs())?, smooth_pieces(whole[1].nurbs())?];
    let mut charts: [Vec<Chart>; 2] = [Vec::new(), Vec::new()];
    for (own, pieces) in charts.iter_mut().zip(pieces) {
        for piece in pieces {
            own.push(Chart::new(piece)?);
        }
    }
    let mut followed = Vec::new();
    for first in &charts[0] {
        for second in &charts[1] {
            let part = Pair { charts: [first, second], noise: pair.noise };
            let mut search = Search::new(part, SMALLEST * size)?;
            let places = search.places()?;
            if places.leaves.is_empty() && places.undecided.is_empty() {
                continue;
            }
            let mut curves = Curves { found: Vec::new(), limits, complete: true };
            curves.add_from_sides(&search)?;
            curves.add_from_leaves(&mut search, places.leaves)?;
            out.complete &= curves.complete;
            let mut contacts = contacts::contacts(&part, &places.undecided, limit);
            follow_tangents(&part, &mut contacts, &out.contacts, &limits, shift)?;
            for stuck in curves.stuck() {
                let known = contacts.iter().any(|c| {
                    c.kind != SurfaceContactKind::Undecided
                        && (c.point.to_vector() - stuck.point).length() <= AT_CONTACT * size
                });
                let pole = [first, second].iter().any(|c| {
                    c.poles().iter().any(|p| (p.to_vector() - stuck.point).length() <= AT_POLE * size)
                });
                out.complete &= known || pole;
            }
            out.contacts.extend(contacts);
            followed.append(&mut curves.found);
        }
    }
    for row in rows::joined(&pair, followed) {
        let fit = fitted_within(&pair, &row.places, shift, limit)?;
        out.branches.push(SurfaceBranch {
            curve: fit.curve,
            parameters: fit.parameters,
            deviation: fit.deviation,
            closed: row.closed,
        });
    }
    let poles: Vec<Point3> = whole.iter().flat_map(Chart::poles).collect();
    contacts::drop_poles(&mut out.contacts, &poles, AT_POLE * size);
    contacts::drop_doubles(&mut out.contacts, SAME_PLACE * size);
    for contact in &mut out.contacts {
        out.complete &= contact.kind != SurfaceContactKind::Undecided;
        contact.point += shift;
    }
    Ok(out)
}

/// Gives contacts along curves their curves, and drops what lies on the curve of another one.
fn follow_tangents(
    pair: &Pair<'_>,
    contacts: &mut Vec<SurfaceContact>,
    before: &[SurfaceContact],
    limits: &Limits,
    shift: Vector3,
) -> Result<()> {
    let (mut along, rest): (Vec<_>, Vec<_>) =
        contacts.drain(..).partition(|c| c.kind == SurfaceContactKind::Curve);
    let mut kept: Vec<SurfaceContact> = Vec::new();
    for mut contact in along.drain(..) {
        if is_known(&kept, &contact, pair.size(), shift)? || is_known(before, &contact, pair.size(), shift)? {
            continue;
        }
        let [[a, b], [c, d]] = contact.at;
        if let Some(found) = tangent_curve(pair, [a, b, c, d], limits)? {
            let fit = fitted(pair, &found.places, shift)?;
            contact.curve = Some(SurfaceBranch {
                curve: fit.curve,
                parameters: fit.parameters,
                deviation: fit.deviation,
                closed: found.closed,
            });
        }
        kept.push(contact);
    }
    for contact in rest {
        if contact.kind != SurfaceContactKind::Undecided || !is_known(&kept, &contact, pair.size(), shift)? {
            kept.push(contact);
        }
    }
    *contacts = kept;
    Ok(())
}

/// Whether the place of a contact lies on a curve that was followed.
fn is_known(kept: &[SurfaceContact], contact: &SurfaceContact, size: f64, shift: Vector3) -> Result<bool> {
    for branch in kept.iter().filter_map(|k| k.curve.as_ref()) {
        if branch.curve.closest_point_within(contact.point + shift, ON_CURVE * size)?.is_some() {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod families;
#[cfg(test)]
mod tests;
