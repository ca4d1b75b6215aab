//! Edges of breps rounded or cut off.
//!
//! A ball rolls along each edge and touches both faces: at a place of the edge the offsets of both surfaces meet in its
//! centre, in the plane square to the edge (`wedge`). The arc between its contacts, carried along, is the new face
//! (`strip`): exact where the ball only moves along a line or turns about an axis, elsewhere within the tolerance. The
//! contacts are the rails to which both faces are cut back (`rebuild`). What happens where an edge ends is told by the
//! trims round the vertex (`joint`): the strip is cut along its section with a third face (`cut`), goes on in the next
//! strip, is mitred with it, or meets others on the ball that touches all of their faces (`meeting`, `corner`).
//!
//! Not all edges can be rounded at once. Which go first is told by their convexities and radii (`order`); each step
//! leaves a whole and valid brep, in which the edges that wait are found again, with the arcs in which the roundings
//! before them ended.
//!
//! Sources: the rolling ball and its contact curves after B. K. Choi and S. Y. Ju, "Constant-radius blending in surface
//! modelling", *Computer-Aided Design* 21 (1989); names of the parts after J. Vida, R. R. Martin and T. Várady, "A survey
//! of blending methods that use parametric surfaces", *Computer-Aided Design* 26 (1994).

mod cap;
mod corner;
mod cut;
mod fan;
mod joint;
mod level;
mod meeting;
mod names;
mod newton;
mod order;
mod rebuild;
mod section;
mod strip;
mod thresholds;
mod weave;
mod wedge;
mod widen;

use crate::brep::fillet::thresholds::LEAST_SLANT;
use std::collections::{BTreeMap, BTreeSet};

use joint::{Fans, Joint, Link, Outlet, Stub};
use names::Names;
use strip::Strip;
use weave::{Piece, Weave};
use wedge::{Radius, Wedge};

use super::{Along, Brep, Builder};
use crate::{Error, Result, Tolerance, Vector3};

/// What takes the place of an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum FilletBlend {
    /// Straight across: the edge is cut off.
    Chamfer,
    /// An arc that touches both faces.
    #[default]
    Arc,
    /// A curve of degree 5 that meets both faces with their tangents and curvatures.
    Smooth,
}

/// What the radius of a rounded edge measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum FilletRail {
    /// The distance of the rails from the edge: the mean of both, where the faces bend differently.
    DistanceFromEdge,
    /// The radius of the ball that rolls along the edge.
    #[default]
    RollingBall,
    /// The distance of the rails from each other.
    DistanceBetweenRails,
}

impl Brep {
    /// The brep with edges rounded or cut off: for each the place among [`Brep::edges`] and its radius in model units,
    /// which measures what `rail` says. An edge that runs on without a kink into others is rounded together with them,
    /// with its radius unless they have their own. Convex edges lose material, concave ones gain it.
    ///
    /// Where three edges meet that are not all convex or all concave, the odd one out is rounded first, and the others run
    /// on round the arc in which it ends; they are so too where their radii differ, the largest first, and their own radius
    /// changes round the arc if they differ from each other. Two of one radius beside a smaller third are mitred, and the
    /// small ball runs on along the mitre to its end. An edge that runs on round such an arc into a third one takes
    /// that with it.
    ///
    /// Faces between planes and along circles are exact cylinders, tori, planes and cones, the corners of edges of one
    /// radius parts of spheres (of chamfers: flat facets); elsewhere the new faces are within the tolerance.
    ///
    /// # Errors
    /// An edge that does not exist, is given twice, is naked, a seam, smooth, or has more than two faces; a radius
    /// that is not above 0 or for which there is no room; edges that meet in a way that is not supported yet: four or
    /// more at a vertex whose faces no one ball touches, or two that neither mirror each other nor end on each other. The
    /// message names the edge or vertex. Or the tolerance is not above 0, the brep has faults, or nobody waits any more.
    ///
    /// ```
    /// use katydid_geometry::brep::{FilletBlend, FilletRail};
    /// use katydid_geometry::{Box3, Interval, Plane, Tolerance, construct::box_brep};
    /// # fn main() -> katydid_geometry::Result<()> {
    /// let side = Interval::new(0.0, 4.0);
    /// let cube = box_brep(&Box3 { plane: Plane::XY, x: side, y: side, z: side })?;
    /// let every: Vec<(usize, f64)> = (0..cube.edges().len()).map(|edge| (edge, 1.0)).collect();
    /// let rounded = cube.filleted(&every, FilletBlend::Arc, FilletRail::RollingBall, &Tolerance::default())?;
    /// assert!(rounded.is_solid() && rounded.faces().len() == 6 + 12 + 8);
    /// # Ok(())
    /// # }
    /// ```
    pub fn filleted(
        &self,
        edges: &[(usize, f64)],
        blend: FilletBlend,
        rail: FilletRail,
        tolerance: &Tolerance,
    ) -> Result<Self> {
        tolerance.positive_distance()?;
        if edges.is_empty() {
            return Ok(self.clone());
        }
        let names = Names::default();
        let given = Fans { brep: self, names: &names };
        let mut wanted: Vec<(usize, Radius)> = Vec::with_capacity(edges.len());
        let mut known = BTreeSet::new();
        for &(edge, radius) in edges {
            if !known.insert(edge) {
                return Err(names.refused(edge, "it is given twice"));
            }
            // What can be said of the edge alone comes first.
            let radius = Radius([radius; 2]);
            Wedge::new(&given, edge, radius, rail, tolerance)?;
            wanted.push((edge, radius));
        }
        let brep = level::levelled(self.clone().checked()?, tolerance.absolute)?;
        let fans = Fans { brep: &brep, names: &names };
        // Whether an edge is convex; none if there is nothing to round.
        let sharp = |edge: usize| {
            let wedge = Wedge::new(&fans, edge, Radius([1.0; 2]), rail, tolerance).ok()?;
            Some(wedge.is_convex(&brep))
        };
        fans.prolonged(&mut wanted, tolerance, sharp, blend != FilletBlend::Chamfer)?;
        let style = Style { blend, tolerance: *tolerance };
        let wanted = wanted.into_iter().map(|(edge, radius)| Wanted { edge, radius, rail }).collect();
        let made = in_steps(brep.clone(), wanted, &style)?;
        if brep.is_solid() && !made.is_solid() {
            return Err(Error::Invalid { what: "fillet", why: "the result would not be closed".into() });
        }
        Ok(made)
    }
}

/// What all edges have in common.
struct Style {
    blend: FilletBlend,
    tolerance: Tolerance,
}

/// An edge to be rounded.
#[derive(Clone, Copy)]
struct Wanted {
    edge: usize,
    radius: Radius,
    rail: FilletRail,
}

/// A shape with some edges rounded.
struct Made {
    brep: Brep,
    /// The places of the edges that are left, by what they were.
    kept: BTreeMap<usize, usize>,
    /// The new edges in which roundings end on a third face, from the first rail to the second.
    ends: BTreeMap<Stub, usize>,
    /// The new edges round each rounding, with the edge that it is of.
    borders: Vec<(usize, usize)>,
}

/// The shape with edges rounded, those first that have to be, and the others on the valid shape that this leaves.
fn in_steps(mut brep: Brep, mut wanted: Vec<Wanted>, style: &Style) -> Result<Brep> {
    let mut names = Names::default();
    // Arcs on which the ball of their own radius stands still.
    let mut still: BTreeSet<usize> = BTreeSet::new();
    // Where mitres end between roundings that run into one face.
    let mut points: BTreeSet<Stub> = BTreeSet::new();
    // A step rounds one edge at least, and an edge leaves an arc at each end at most.
    let most = 3 * wanted.len();
    for _ in 0..most {
        if wanted.is_empty() {
            break;
        }
        wanted.sort_by_key(|own| own.edge);
        let fans = Fans { brep: &brep, names: &names };
        let mut wedges = BTreeMap::new();
        for own in &wanted {
            crate::cancellation::check()?;
            let mut wedge = Wedge::new(&fans, own.edge, own.radius, own.rail, &style.tolerance)?;
            wedge.by_contacts = points.iter().any(|(edge, _)| *edge == own.edge);
            wedges.insert(own.edge, wedge);
        }
        let first = order::first(&fans, &wedges, style.blend, &style.tolerance)?;
        let joints = fans.joints(&first.iter().copied().collect::<Vec<_>>(), &style.tolerance)?;
        let joints = fans.capped(joints, &still, &points)?;
        let later: BTreeMap<usize, Wanted> =
            wanted.iter().filter(|own| !first.contains(&own.edge)).map(|own| (own.edge, *own)).collect();
        let mut arcs = Vec::new();
        let mut mitres = Vec::new();
        for joint in &joints {
            if let Joint::Mitre { stubs, links } = joint {
                let found = links.iter().enumerate().find_map(|(side, link)| match link {
                    Link::Over(over, _) => Some((*later.get(&over.0)?, side)),
                    Link::Face(_) => None,
                });
                mitres.extend(found.map(|(own, side)| (stubs[0], own, side)));
            }
            let Joint::Third { stub, beside, .. } = joint else { continue };
            if let [Some(a), Some(b)] = beside.map(|(edge, _)| later.get(&edge)) {
                let all = [stub.0, a.edge, b.edge].map(|edge| wedges.get(&edge));
                arcs.push((*stub, between(&wedges, [*a, *b], *beside, style.blend)?, is_still(&brep, all)?));
            }
        }
        wedges.retain(|edge, _| first.contains(edge) && !still.contains(edge));
        let made = step(&fans, wedges, &joints, style)?;
        wanted.clear();
        let (old, ended) = (std::mem::take(&mut still), std::mem::take(&mut points));
        for (edge, own) in &later {
            let place = made.kept.get(edge).ok_or_else(|| names.refused(*edge, "nothing of it is left"))?;
            wanted.push(Wanted { edge: *place, ..*own });
            still.extend(old.contains(edge).then_some(*place));
            points.extend(
                [false, true].iter().filter(|end| ended.contains(&(*edge, **end))).map(|end| (*place, *end)),
            );
        }
        for (stub, (radius, rail), stands) in arcs {
            if let Some(&edge) = made.ends.get(&stub) {
                wanted.push(Wanted { edge, radius, rail });
                still.extend(stands.then_some(edge));
            }
        }
        for (stub, own, over) in mitres {
            if let Some(&edge) = made.ends.get(&stub) {
                // The mitre runs from the first rail to the second, and starts at the edge that goes on in it.
                wanted.push(Wanted { edge, ..own });
                points.insert((edge, over == 0));
            }
        }
        names = names.after(&made.kept, &made.borders);
        brep = made.brep;
    }
    match wanted.first() {
        None => Ok(brep),
        Some(own) => Err(names.refused(own.edge, "the edges that wait for it come to no end")),
    }
}

/// What an arc is rounded with between two edges that run on into it: with the ball that arrives there.
fn between(
    wedges: &BTreeMap<usize, Wedge<'_>>,
    beside: [Wanted; 2],
    stubs: [Stub; 2],
    blend: FilletBlend,
) -> Result<(Radius, FilletRail)> {
    let mut radii = [0.0; 2];
    for ((own, stub), radius) in beside.iter().zip(stubs).zip(&mut radii) {
        *radius = own.radius.at_end(stub.1);
        if let Some(wedge) = wedges.get(&own.edge).filter(|_| blend != FilletBlend::Chamfer) {
            *radius = strip::at_end(wedge, stub.1).ok_or_else(|| wedge.too_large())?.radius;
        }
    }
    let even = (radii[0] - radii[1]).abs() <= order::EQUAL * radii[0];
    let rail = if blend == FilletBlend::Chamfer { beside[0].rail } else { FilletRail::RollingBall };
    Ok((Radius(if even { [radii[0]; 2] } else { radii }), rail))
}

/// Whether three edges that meet turn the same way with one radius: the ball that rolls round the arc in which the first
/// one's rounding ends stands still then.
fn is_still(brep: &Brep, wedges: [Option<&Wedge<'_>>; 3]) -> Result<bool> {
    let [Some(a), Some(b), Some(c)] = wedges else { return Ok(false) };
    let like = a.is_convex(brep) == b.is_convex(brep) && a.is_convex(brep) == c.is_convex(brep);
    let radii = [a.first()?.radius, b.first()?.radius, c.first()?.radius];
    Ok(like && radii.iter().all(|r| (r - radii[0]).abs() <= order::EQUAL * radii[0]))
}

/// The shape with edges rounded that can be rounded at once.
fn step<'a>(
    fans: &Fans<'a>,
    wedges: BTreeMap<usize, Wedge<'a>>,
    joints: &[Joint],
    style: &Style,
) -> Result<Made> {
    let (brep, tolerance) = (fans.brep, &style.tolerance);
    let mut strips = BTreeMap::new();
    for (edge, wedge) in wedges {
        crate::cancellation::check()?;
        let reach = [false, true].map(|end| reach(fans, &wedge, style.blend, (edge, end), joints));
        let closed = joints
            .iter()
            .any(|joint| matches!(joint, Joint::Through { stubs: [a, b], .. } if a.0 == edge && b.0 == edge));
        let points = [false, true]
            .map(|end| joints.iter().any(|j| matches!(j, Joint::Point { stub } if *stub == (edge, end))));
        strips.insert(edge, Strip::new(wedge, style.blend, reach, closed, points, tolerance)?);
    }
    let ends = strips.keys().flat_map(|edge| [(*edge, false), (*edge, true)]);
    let gone = ends.filter_map(|stub| fans.vertex(stub)).collect();
    let worst = brep.edges().iter().map(|edge| edge.tolerance).fold(0.0, f64::max);
    let mut weave = Weave {
        brep,
        names: fans.names,
        strips,
        builder: Builder::new(),
        tolerance: *tolerance,
        limit: tolerance.absolute,
        blend: style.blend,
        ends: BTreeMap::new(),
        shortened: BTreeMap::new(),
        inserts: BTreeMap::new(),
        widened: BTreeMap::new(),
        caps: BTreeMap::new(),
        kept: BTreeMap::new(),
        gone,
    };
    for joint in joints {
        weave.add(joint)?;
    }
    let rails = weave.add_strips()?;
    let kept = weave.add_faces(&rails)?;
    let ends = joints.iter().filter_map(|joint| match joint {
        Joint::Third { stub, outlets, .. } => match outlets.as_slice() {
            [outlet] => Some((*stub, weave.inserts.get(&outlet.after)?.edge.0)),
            _ => None,
        },
        Joint::Mitre { stubs, .. } => match weave.ends.get(&stubs[0])?.pieces.as_slice() {
            [Piece { along: Along::Edge(edge, _), .. }] => Some((stubs[0], edge.0)),
            _ => None,
        },
        _ => None,
    });
    let ends: BTreeMap<Stub, usize> = ends.collect();
    let mut borders: Vec<(usize, usize)> = ends.iter().map(|(stub, now)| (stub.0, *now)).collect();
    borders
        .extend(rails.iter().flat_map(|(edge, sides)| sides.iter().flatten().map(|side| (*edge, side.0.0))));
    let brep = weave.builder.finish(2.0 * tolerance.absolute + worst)?;
    Ok(Made { brep, kept, ends, borders })
}

/// How far a strip has to go on beyond an end of its edge, by the tangent plane of what ends it there.
fn reach(fans: &Fans<'_>, wedge: &Wedge<'_>, blend: FilletBlend, stub: Stub, joints: &[Joint]) -> f64 {
    let slanted = joints.iter().find_map(|joint| match joint {
        Joint::Through { stubs, links } if stubs.contains(&stub) && stubs[0].0 != stubs[1].0 => {
            links.iter().find_map(|link| match link {
                Link::Over(over, _) => Some(fans.way(stub)?.dot(fans.way(*over)?).abs()),
                Link::Face(_) => None,
            })
        }
        _ => None,
    });
    if let Some(slant) = slanted.filter(|slant| *slant > LEAST_SLANT && *slant < 0.95) {
        // The ball leaves the face beside before the vertex, or beyond it.
        let Some((points, _, corner)) = Strip::hull_at(wedge, blend, stub.1) else { return 0.0 };
        let across = points.iter().map(|p| p.distance_to(corner)).fold(0.0, f64::max);
        return 1.2 * across * slant / (1.0 - slant * slant).sqrt();
    }
    let normal = joints.iter().find_map(|joint| -> Option<Vector3> {
        match joint {
            Joint::Third { stub: own, outlets, .. } if *own == stub => {
                let &[Outlet { face, after, .. }] = outlets.as_slice() else { return None };
                let surface = fans.brep.face_surface(face)?;
                let trim = fans.brep.trims().get(after)?;
                let uv = fans.brep.trim_point(after, trim.part.domain.end)?;
                let d = surface.derivatives(uv.x, uv.y, 1, surface.inner_quadrant(uv.x, uv.y));
                d.get(1, 0).cross(d.get(0, 1)).unitized()
            }
            Joint::Mitre { stubs, .. } if stubs.contains(&stub) => {
                (fans.way(stubs[0])? - fans.way(stubs[1])?).unitized()
            }
            _ => None,
        }
    });
    let Some(normal) = normal else { return 0.0 };
    let Some((points, outward, corner)) = Strip::hull_at(wedge, blend, stub.1) else { return 0.0 };
    let rate = outward.dot(normal);
    if rate.abs() < 0.05 {
        return 0.0;
    }
    let beyond = points.iter().map(|p| (corner - *p).dot(normal) / rate).fold(0.0, f64::max);
    if beyond <= crate::thresholds::SAME_POINT * wedge.size
        && beyond >= 0.0
        && is_flat_square(fans, stub, joints, rate)
    {
        return 0.0;
    }
    let across = points.first().zip(points.last()).map_or(0.0, |(a, b)| a.distance_to(*b));
    1.5 * beyond + 0.1 * across
}

/// Whether the end is square to the edge and flat, so that nothing goes beyond it.
fn is_flat_square(fans: &Fans<'_>, stub: Stub, joints: &[Joint], rate: f64) -> bool {
    let flat = joints.iter().any(|joint| match joint {
        Joint::Third { stub: own, outlets, .. } => {
            let flat = |o: &Outlet| {
                fans.brep.face_surface(o.face).is_some_and(|s| s.plane(crate::thresholds::ROUNDING).is_some())
            };
            *own == stub && outlets.len() == 1 && outlets.iter().all(flat)
        }
        _ => false,
    });
    flat && (rate.abs() - 1.0).abs() < crate::thresholds::ROUNDING
}
