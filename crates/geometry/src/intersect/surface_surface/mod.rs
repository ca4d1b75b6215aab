//! Surface with surface.

mod area;
mod contacts;
mod cover;
mod ends;
mod equal;
mod exact;
mod images;
mod itself;
mod kinds;
mod overlap;
mod rows;
mod search;
mod sheet;
mod tangent_curve;
mod touch;

pub use itself::surface_self;
pub(crate) use kinds::common;
pub use kinds::surface_with_surface;

use cover::Curves;
use search::Search;
use tangent_curve::tangent_curve;

use crate::chart::thresholds::{AT_CONTACT, AT_POLE, MET, ON_CURVE, SAME_PLACE, SMALLEST};
use crate::chart::{Breaks, Chart, changes_speed, smooth_pieces};
use crate::trace::{Limits, Pair, fitted, fitted_within};
use crate::{
    Curve, Error, NurbsCurve, NurbsSurface, Point3, Result, Surface, Tolerance, Vector3, Xform, cancellation,
};

/// What is known of a branch's curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BranchKind {
    /// A straight line, by the closed form of both surfaces, as the kinds that follow.
    Line,
    /// A circle or an arc of one.
    Circle,
    /// An ellipse or a part of one, as a rational quadratic.
    Ellipse,
    /// A part of a parabola, as a quadratic.
    Parabola,
    /// A part of a branch of a hyperbola, as a rational quadratic.
    Hyperbola,
    /// A part of a side of one of the surfaces.
    Side,
    /// Followed: within the tolerance. Lines, arcs and circles to rounding come as such.
    Followed,
}

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
    /// What is known of the curve.
    pub kind: BranchKind,
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
    /// The loops that bound a common area, each of curves that go on where the one before ends, with the area on their left
    /// seen against the normal of the first surface. Sides at seams do not bound; none where both surfaces are closed.
    pub border: Vec<Vec<SurfaceBranch>>,
}

impl SurfaceContact {
    fn branches_mut(&mut self) -> impl Iterator<Item = &mut SurfaceBranch> {
        self.curve.iter_mut().chain(self.border.iter_mut().flatten())
    }
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
/// Both surfaces are cut at their kinks, where a branch that turns ends and another begins; where that leaves something
/// undecided also where their speeds leap, and branches end there. Pairs of Bézier patches are divided until their hulls are proved apart, or
/// bounds on their derivatives prove that their common curve is a graph over a direction. Curves begin at the common
/// points of the sides with the other surface ([`curve_surface`](super::curve_surface())) and, for loops, in pairs of parts
/// that no curve runs through yet; each is followed by steps within boxes that are proved to hold that curve alone. In the
/// end every pair that was not excluded has a curve in it, or belongs to a contact. Nothing is sampled to find a curve.
/// (After T. Sederberg and R. Meyers, *Loop detection in surface patch intersections*, 1988, with interval bounds instead of
/// cones; marching as in N. Patrikalakis and T. Maekawa, *Shape Interrogation*, 5.8.)
///
/// Where one of the surfaces is a part of a plane, sphere, cylinder, cone or torus, parts of the other one alone are proved to
/// hold a graph, each once, and so are the steps: the curve is where a function of two parameters is zero.
///
/// Where the surfaces touch, Newton's method on their tangent planes finds the place, and the difference of their second
/// fundamental forms its kind; along a curve the way goes on where the difference is 0. Common areas are bounded by the parts of
/// the sides of each surface that lie on the other one.
///
/// Planes, spheres, cylinders, cones and tori are told first, also inside NURBS surfaces: what has a closed form
/// ([`carrier_carrier`](super::carrier_carrier())) is that, to rounding, as far as both surfaces reach. Closed conics are whole where
/// both surfaces hold them, also through places where two of them cross, which are contacts; they end at poles.
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
            turn(std::slice::from_mut(branch));
        }
        for contact in &mut out.contacts {
            contact.at.reverse();
            contact.ranges.rotate_left(2);
            for branch in contact.branches_mut() {
                branch.parameters.reverse();
            }
            if face_each_other([a, b], contact.at) {
                contact.border.iter_mut().for_each(|border| turn(border));
            }
        }
        return Ok(out);
    }
    ordered(a, b, limit)
}

/// Whether the normals of two surfaces at a common place are opposite.
fn face_each_other(surfaces: [&NurbsSurface; 2], at: [[f64; 2]; 2]) -> bool {
    let normal = |s: usize| {
        let [_, u, v] = surfaces[s].partials_at(at[s][0], at[s][1], crate::Quadrant::NorthEast);
        u.cross(v)
    };
    normal(0).dot(normal(1)) < 0.0
}

/// Walks a loop the other way.
fn turn(border: &mut [SurfaceBranch]) {
    border.reverse();
    for branch in border {
        branch.curve = branch.curve.reversed();
        branch.parameters = [branch.parameters[0].reversed(), branch.parameters[1].reversed()];
    }
}

/// Whether a surface comes before another by its control points: so that their order in a call does not matter.
fn comes_first(a: &NurbsSurface, b: &NurbsSurface) -> bool {
    let numbers = |s: &NurbsSurface| s.homogeneous_points().concat();
    let order = numbers(a).iter().zip(&numbers(b)).map(|(x, y)| x.total_cmp(y)).find(|o| o.is_ne());
    order.unwrap_or_else(|| a.point_count().cmp(&b.point_count())).is_lt()
}

/// More pairs of pieces between kinks than this are not looked at.
const MOST_PIECES: usize = 4_000_000;

fn ordered(a: &NurbsSurface, b: &NurbsSurface, limit: f64) -> Result<SurfaceMeeting> {
    let kinds = [Surface::from(a.clone()), Surface::from(b.clone())];
    if let Some(met) = exact::meeting([&kinds[0], &kinds[1]], limit)? {
        return Ok(met);
    }
    let met = met_in_pieces(a, b, limit, Breaks::Turns)?;
    if met.complete || !(changes_speed(a) || changes_speed(b)) {
        return Ok(met);
    }
    // What is not decided where speeds leap is between pieces that are smooth in them.
    let finer = met_in_pieces(a, b, limit, Breaks::Speeds)?;
    Ok(if finer.complete { finer } else { met })
}

/// What two surfaces have in common, each cut along its breaks of a kind.
fn met_in_pieces(a: &NurbsSurface, b: &NurbsSurface, limit: f64, breaks: Breaks) -> Result<SurfaceMeeting> {
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
    let pair = Pair { carrier: exact::carrier(&whole)?, ..Pair::new(&whole[0], &whole[1]) };
    let size = pair.size();
    if whole.iter().any(|c| !c.has_area()) {
        return Err(Error::degenerate("surface", "it has no area"));
    }
    if let Some(mut all) = equal::equal(&pair) {
        if let Some(found) = overlap::of_charts(&pair, limit)?
            && let Some(area) = found.contacts.into_iter().find(|c| c.kind == SurfaceContactKind::Overlap)
        {
            all.border = area.border;
        }
        out.contacts.push(all);
        return shifted(out, shift);
    }
    let limits = Limits::new(limit, size, pair.noise);
    let reach = MET * pair.noise;
    let mut charts: [Vec<Chart>; 2] = [Vec::new(), Vec::new()];
    for (s, own) in charts.iter_mut().enumerate() {
        let other = whole[1 - s].nurbs().hull_box();
        let wanted = |piece: &NurbsSurface| piece.hull_box().distance_to_box(&other) <= reach;
        for piece in smooth_pieces(whole[s].nurbs(), breaks, &wanted)? {
            own.push(Chart::new(piece)?);
        }
    }
    if charts[0].len().saturating_mul(charts[1].len()) > MOST_PIECES {
        return Err(Error::Unsupported("surfaces of very many pieces between kinks"));
    }
    let mut followed = Vec::new();
    let boxes = [0, 1].map(|s| charts[s].iter().map(|c| c.nurbs().hull_box()).collect::<Vec<_>>());
    for (first, around) in charts[0].iter().zip(&boxes[0]) {
        for (second, other) in charts[1].iter().zip(&boxes[1]) {
            cancellation::check()?;
            if around.distance_to_box(other) > reach {
                continue;
            }
            let part = Pair { charts: [first, second], ..pair };
            let mut search = Search::new(part, SMALLEST * size)?;
            let (places, common) = search.places(limit)?;
            if let Some(common) = common {
                out.complete &= common.complete;
                out.contacts.extend(common.contacts);
            }
            if places.leaves.is_empty() && places.undecided.is_empty() {
                continue;
            }
            let mut curves = Curves { found: Vec::new(), limits, complete: true };
            curves.add_from_sides(&mut search)?;
            curves.add_from_leaves(&mut search, places.leaves)?;
            out.complete &= curves.complete;
            let mut contacts = contacts::contacts(&part, &places.undecided, limit);
            follow_tangents(&part, &mut contacts, &out.contacts, &limits)?;
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
    let mut rows = rows::joined(&pair, followed, breaks);
    ends::led_in(&pair, &mut rows, &out.contacts);
    for row in rows {
        let fit = fitted_within(&pair, &row.places, limit)?;
        out.branches.push(SurfaceBranch {
            curve: fit.curve,
            parameters: fit.parameters,
            deviation: fit.deviation,
            closed: row.closed,
            kind: BranchKind::Followed,
        });
    }
    let poles: Vec<Point3> = whole.iter().flat_map(Chart::poles).collect();
    contacts::drop_poles(&mut out.contacts, &poles, AT_POLE * size);
    contacts::drop_doubles(&mut out.contacts, SAME_PLACE * size);
    for contact in &out.contacts {
        out.complete &= contact.kind != SurfaceContactKind::Undecided;
    }
    shifted(out, shift)
}

/// The same in another place.
fn shifted(mut met: SurfaceMeeting, shift: Vector3) -> Result<SurfaceMeeting> {
    let back = Xform::translation(shift);
    for contact in &mut met.contacts {
        contact.point += shift;
    }
    let own = met.contacts.iter_mut().flat_map(SurfaceContact::branches_mut);
    for branch in met.branches.iter_mut().chain(own) {
        branch.curve = branch.curve.transformed(&back)?;
    }
    Ok(met)
}

/// Gives contacts along curves their curves, and drops what lies on the curve of another one.
fn follow_tangents(
    pair: &Pair<'_>,
    contacts: &mut Vec<SurfaceContact>,
    before: &[SurfaceContact],
    limits: &Limits,
) -> Result<()> {
    let (mut along, rest): (Vec<_>, Vec<_>) =
        contacts.drain(..).partition(|c| c.kind == SurfaceContactKind::Curve);
    let mut kept: Vec<SurfaceContact> = Vec::new();
    for mut contact in along.drain(..) {
        if is_known(&kept, &contact, pair.size())? || is_known(before, &contact, pair.size())? {
            continue;
        }
        let [[a, b], [c, d]] = contact.at;
        if let Some(found) = tangent_curve(pair, [a, b, c, d], limits)? {
            let fit = fitted(pair, &found.places)?;
            contact.curve = Some(SurfaceBranch {
                curve: fit.curve,
                parameters: fit.parameters,
                deviation: fit.deviation,
                closed: found.closed,
                kind: BranchKind::Followed,
            });
        }
        kept.push(contact);
    }
    for contact in rest {
        if contact.kind != SurfaceContactKind::Undecided || !is_known(&kept, &contact, pair.size())? {
            kept.push(contact);
        }
    }
    *contacts = kept;
    Ok(())
}

/// Whether the place of a contact lies on a curve that was followed.
fn is_known(kept: &[SurfaceContact], contact: &SurfaceContact, size: f64) -> Result<bool> {
    for branch in kept.iter().filter_map(|k| k.curve.as_ref()) {
        if branch.curve.closest_point_within(contact.point, ON_CURVE * size)?.is_some() {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod exact_tests;
#[cfg(test)]
mod families;
#[cfg(test)]
mod limits_tests;
#[cfg(test)]
mod random_tests;
#[cfg(test)]
mod steady_tests;
#[cfg(test)]
mod tests;
