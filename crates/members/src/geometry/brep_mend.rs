//! Breps mended: naked edges joined, holes closed, edges rounded; points inside them; thick pipes.

use katydid_geometry::brep::{ClosestOnBrep, LoopKind};
use katydid_geometry::construct::{PipeCap, pipe, pipe_variable};
use katydid_geometry::{Brep, Containment, Curve, Direction, Line, Point3, Tolerance, join_curves};

use serde_json::Value as Json;

use super::answer::Outcome;
use super::argument::{Positive, Some1, Turn, Within};
use super::brep_face::{Face, edge_curves};
use super::choice::{Cap, Rail, Rounding};
use super::table::Endpoints;
use crate::Fault;
use crate::wire::{Members, Read};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("brep/joinnakededges-brep_double", |b: Brep, t: Within| {
        let joined = Brep::join(&b.connected_components()?, &t.tolerance())?.breps;
        let whole = if joined.len() == 1 { joined } else { vec![Brep::merged(&joined)] };
        let whole = whole.into_iter().next().unwrap_or_else(|| b.clone());
        // A joint makes one edge of two.
        let joints = b.naked_edges().len().saturating_sub(whole.naked_edges().len()) / 2;
        Ok((joints, whole))
    });
    table.add(
        "brep/createfilletedges-brep_intarray_doublearray_doublearray_blendtype_railtype_double",
        |b: Brep,
         edges: Some1<i32>,
         start: Some1<Positive>,
         end: Some1<Positive>,
         blend: Rounding,
         rail: Rail,
         t: Within| {
            let index = |edge: &i32| {
                usize::try_from(*edge).map_err(|_| Fault::bad_request(format!("there is no edge {edge}")))
            };
            let edges: Vec<usize> = edges.0.iter().map(index).collect::<Outcome<_>>()?;
            filleted(&b, &edges, [&start.0, &end.0], (blend, rail), t).map(|brep| vec![brep])
        },
    );
    table.add("brep/getpointinside-brep_double_point3d", inside);
    table.add("brepface/removeholes-brepface_double", |f: Face, t: Within| without_holes(&f.brep(), None, t));
    table.add("brep/removeholes-brep_double", |b: Brep, t: Within| without_holes(&b, None, t));
    table.add(
        "brep/removeholes-brep_componentindexarray_double",
        |b: Brep, loops: Some1<LoopIndex>, t: Within| {
            let listed: Vec<usize> = loops.0.into_iter().map(|own| own.0).collect();
            without_holes(&b, Some(&listed), t)
        },
    );
    table.add(
        "brep/createthickpipe-curve_double_double_bool_pipecapmode_bool_double_double",
        |rail: Curve, inner: Positive, outer: Positive, _: bool, cap: Cap, _: bool, t: Within, a: Turn| {
            let (tolerance, [a, b]) = (a.and(t), [inner.0.min(outer.0), inner.0.max(outer.0)]);
            if b - a <= tolerance.absolute {
                return Err(no_wall());
            }
            let shells = [a, b].map(|radius| pipe(&rail, radius, PipeCap::None, &tolerance));
            thick_pipe(&rail, shells, cap, &tolerance).map(|brep| vec![brep])
        },
    );
    table.add(
        "brep/createthickpipe-curve_doublearray_doublearray_doublearray_bool_pipecapmode_bool_double_double",
        |rail: Curve,
         at: Some1<f64>,
         first: Some1<Positive>,
         second: Some1<Positive>,
         _: bool,
         cap: Cap,
         _: bool,
         t: Within,
         a: Turn| {
            let (tolerance, count) = (a.and(t), at.0.len());
            if first.0.len() != count || second.0.len() != count {
                return Err(Fault::bad_request("radii are not as many as railRadiiParameters"));
            }
            // Parameters of radii are shares of the rail's domain.
            let given = |pick: fn(f64, f64) -> f64| -> Vec<(f64, f64)> {
                let radii = first.0.iter().zip(&second.0).map(|(a, b)| pick(a.0, b.0));
                at.0.iter().map(|x| rail.domain().at(*x)).zip(radii).collect()
            };
            let radii = [given(f64::min), given(f64::max)];
            if radii[0].iter().zip(&radii[1]).any(|(a, b)| b.1 - a.1 <= tolerance.absolute) {
                return Err(no_wall());
            }
            let shells = radii.each_ref().map(|r| pipe_variable(&rail, r, PipeCap::None, &tolerance));
            thick_pipe(&rail, shells, cap, &tolerance).map(|brep| vec![brep])
        },
    );
    table.add("brep/repair-brep_double", |b: Brep, t: Within| {
        if b.is_valid() {
            return Ok((true, b));
        }
        let mut parts = b.into_parts();
        parts.set_kinds();
        parts.set_vertices();
        parts.set_iso();
        parts.measure_tolerances();
        let repaired = Brep::from_parts(parts)?;
        let within = (0..repaired.edges().len())
            .all(|edge| repaired.edge_deviation(edge).is_none_or(|off| off <= 10.0 * t.0));
        Ok((within && repaired.is_valid(), repaired))
    });
}

/// A point inside a solid: halfway from a face to what lies opposite. None for what is no solid.
fn inside(brep: Brep, tolerance: Within) -> Outcome<(bool, Option<Point3>)> {
    /// Shares of a face's domain at which it is tried.
    const TRIED: [f64; 7] = [0.5, 0.31, 0.69, 0.13, 0.87, 0.04, 0.96];
    let faces = brep.faces().len();
    let search = ClosestOnBrep::new(brep.into())?;
    if !search.is_solid() {
        return Ok((false, None));
    }
    let Some(bounds) = search.brep().bounds_of_faces() else { return Ok((false, None)) };
    let reach = 2.0 * bounds.diagonal().length();
    for face in 0..faces {
        let Some(surface) = search.brep().face_surface(face) else { continue };
        let [us, vs] = Direction::BOTH.map(|direction| surface.domain(direction));
        for (u, v) in TRIED.iter().flat_map(|x| TRIED.iter().map(|y| (us.at(*x), vs.at(*y)))) {
            if search.covers(face, u, v, 0.0)? != Containment::Inside {
                continue;
            }
            let Some(normal) = surface.normal_at(u, v) else { continue };
            let from = surface.point_at(u, v);
            for way in [normal * -reach, normal * reach] {
                let line = Curve::from(Line::new(from, from + way));
                let found = search.curve_crossings(&line, tolerance.0)?;
                let opposite = found.crossings.iter().find(|c| c.point.distance_to(from) > 2.0 * tolerance.0);
                let Some(opposite) = opposite else { continue };
                let middle = from.lerp(opposite.point, 0.5);
                if search.contains(middle, tolerance.0)? == Containment::Inside {
                    return Ok((true, Some(middle)));
                }
            }
        }
    }
    Ok((false, None))
}

/// A `ComponentIndex` that is of a loop.
struct LoopIndex(usize);

/// `ComponentIndexType.BrepLoop`.
const BREP_LOOP: i32 = 5;

impl Read for LoopIndex {
    fn read(json: &Json) -> Result<Self, Fault> {
        let members = Members::of(json)?;
        let (kind, index): (i32, i32) = (members.read("ComponentIndexType")?, members.read("Index")?);
        match usize::try_from(index) {
            Ok(index) if kind == BREP_LOOP => Ok(Self(index)),
            _ => {
                Err(Fault::bad_request(format!("is no loop: type {kind}, not {BREP_LOOP}, or index {index}")))
            }
        }
    }

    fn type_name() -> String {
        "ComponentIndex".into()
    }
}

/// The brep with holes of its faces closed, all or those listed: the loops inside a face at whose edges nothing else
/// hangs.
fn without_holes(brep: &Brep, listed: Option<&[usize]>, tolerance: Within) -> Outcome<Brep> {
    let count = brep.loops().len();
    if let Some(at) = listed.unwrap_or_default().iter().find(|at| **at >= count) {
        return Err(Fault::bad_request(format!("loops: there is no loop {at}")));
    }
    let tolerance = tolerance.tolerance();
    let naked = brep.naked_edges();
    let is_hole = |at: usize| {
        let wanted = listed.is_none_or(|listed| listed.contains(&at));
        wanted
            && brep.loops().get(at).is_some_and(|own| {
                let free = |trim: &usize| {
                    brep.trims()
                        .get(*trim)
                        .is_some_and(|trim| trim.edge.is_none_or(|edge| naked.contains(&edge)))
                };
                own.kind == LoopKind::Inner && own.trims.iter().all(free)
            })
    };
    let mut parts = Vec::new();
    let mut whole = Vec::new();
    for (place, face) in brep.faces().iter().enumerate() {
        if !face.loops.iter().any(|at| is_hole(*at)) {
            whole.push(place);
            continue;
        }
        let surface = brep.face_surface(place).ok_or_else(|| Fault::bad_request("a face has no surface"))?;
        let loops = brep.face_loops(place)?.into_iter().zip(&face.loops);
        let kept: Vec<Curve> = loops.filter(|(_, at)| !is_hole(**at)).map(|(curve, _)| curve).collect();
        let closed = Brep::from_parameter_loops(surface, &kept, &tolerance)?.into_iter();
        parts.extend(closed.map(|part| if face.reversed { part.flipped() } else { part }));
    }
    if parts.is_empty() {
        return Ok(brep.clone());
    }
    if !whole.is_empty() {
        parts.push(brep.sub_brep(&whole)?);
    }
    let mut joined = Brep::join(&parts, &tolerance)?.breps;
    Ok(match (joined.len(), joined.pop()) {
        (1, Some(one)) => one,
        _ => Brep::merged(&Brep::join(&parts, &tolerance)?.breps),
    })
}

/// A brep with edges rounded, each with a radius of its own that is the same at both ends.
fn filleted(
    brep: &Brep,
    edges: &[usize],
    radii: [&[Positive]; 2],
    (blend, rail): (Rounding, Rail),
    tolerance: Within,
) -> Outcome<Brep> {
    if radii.iter().any(|list| list.len() != edges.len()) {
        return Err(Fault::bad_request(
            "there must be one radius at the start and one at the end for each edge",
        ));
    }
    if radii[0].iter().zip(radii[1]).any(|(a, b)| a.0 != b.0) {
        return Err(Fault::not_supported("radii that change along an edge"));
    }
    let wanted: Vec<(usize, f64)> =
        edges.iter().zip(radii[0]).map(|(edge, radius)| (*edge, radius.0)).collect();
    Ok(brep.filleted(&wanted, blend.0, rail.0, &tolerance.tolerance())?)
}

fn no_wall() -> Fault {
    Fault::bad_request("radius0 and radius1 leave no wall between them")
}

/// The wall between an inner and an outer pipe about a rail, closed by rings where it shall be.
fn thick_pipe(
    rail: &Curve,
    shells: [katydid_geometry::Result<Brep>; 2],
    Cap(cap): Cap,
    tolerance: &Tolerance,
) -> Outcome<Brep> {
    if cap == PipeCap::Round {
        return Err(Fault::not_supported("thick pipes with round caps"));
    }
    let [inner, outer] = shells;
    let (inner, outer) = (inner?.flipped(), outer?);
    if cap == PipeCap::None || rail.is_closed() {
        return Ok(Brep::merged(&[outer, inner]));
    }
    let mut rims = edge_curves(&outer, outer.naked_edges())?;
    rims.extend(edge_curves(&inner, inner.naked_edges())?);
    let mut parts = Brep::planar_faces(&join_curves(&rims, tolerance.absolute, false), tolerance)?.breps;
    parts.extend([outer, inner]);
    let mut joined = Brep::join(&parts, tolerance)?.breps;
    match (joined.len(), joined.pop()) {
        (1, Some(one)) => Ok(one),
        _ => Err(Fault::failed("the pipes and their rings do not join")),
    }
}
