//! Breps cut, parted along edges and joined along them.

use katydid_geometry::brep::Fuse;
use katydid_geometry::construct::baseball_sphere;
use katydid_geometry::{Brep, Curve, Plane, Point3, Sphere};

use super::answer::{Outcome, or_null};
use super::argument::{Count, Positive, Some1, Waiting, Within};
use super::brep_face::Face;
use super::choice::Along;
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("brep/trim-brep_plane_double", |b: Brep, plane: Plane, t: Within, w: Waiting| {
        let cut = b.split_by_plane(&plane, &t.tolerance(), || w.go_on());
        w.check()?;
        let [kept, _] = cut?;
        Ok(kept)
    });
    table.add("brep/split-brep_curvearray_double", |b: Brep, c: Some1<Curve>, t: Within, w: Waiting| {
        let cut = b.split_along(&c.0, &t.tolerance(), || w.go_on());
        w.check()?;
        let parts = cut?;
        // Nothing was split: there are no parts.
        Ok(if parts.len() > 1 { parts } else { Vec::new() })
    });
    table.add("brep/split-brep_brep_double", |b: Brep, cutter: Brep, t: Within, w: Waiting| {
        split_by(&b, &[cutter], t, &w)
    });
    table.add("brep/split-brep_breparray_double", |b: Brep, cutters: Some1<Brep>, t: Within, w: Waiting| {
        split_by(&b, &cutters.0, t, &w)
    });
    table.add("brep/unjoinedges-brep_intarray", |b: Brep, edges: Some1<Index>| {
        let edges: Vec<usize> = edges.0.iter().map(|at| at.0).collect();
        Ok(b.unjoined(&edges)?)
    });
    table.add(
        "brep/joinedges-brep_int_int_double_bool",
        |b: Brep, e0: Index, e1: Index, t: Within, _: bool| {
            let joined = b.with_edges_joined(e0.0, e1.0, &t.tolerance())?;
            Ok(joined.map_or((false, b), |joined| (true, joined)))
        },
    );
    table.add(
        "brep/createfromjoinededges-brep_int_brep_int_double",
        |a: Brep, e0: Index, b: Brep, e1: Index, t: Within| {
            if e0.0 >= a.edges().len() || e1.0 >= b.edges().len() {
                return Err(Fault::bad_request(format!("edges {} and {} are not both there", e0.0, e1.0)));
            }
            let second = a.edges().len() + e1.0;
            Ok(Brep::merged(&[a, b]).with_edges_joined(e0.0, second, &t.tolerance())?)
        },
    );
    table.add("brep/createsolid-breparray_double", |b: Some1<Brep>, t: Within| solids(&b.0, t));
    table.add("brep/removefins-brep", |b: Brep| {
        let left = b.without_fins()?;
        Ok(left.map_or((false, b), |left| (left.is_manifold(), left)))
    });
    table.add("brep/changeseam-brepface_int_double_double", |f: Face, along: Along, at: f64, t: Within| {
        or_null(other_seam(&f, along, at, t))
    });
    table.add("brep/createbaseballsphere-point3d_double_double", |p: Point3, radius: Positive, _: f64| {
        Ok(baseball_sphere(&Sphere::around(p, radius.0)?)?)
    });
}

type Index = Count<0, { i32::MAX as usize }>;

/// The parts into which other Breps cut one; none where nothing was split.
fn split_by(brep: &Brep, cutters: &[Brep], within: Within, waiting: &Waiting) -> Result<Vec<Brep>, Fault> {
    let tolerance = within.tolerance();
    let mut curves = Vec::new();
    for cutter in cutters {
        let met = brep.meeting(cutter, &tolerance)?;
        if !met.complete {
            return Err(Fault::bad_request(
                "faces are tangent to each other or lie upon each other: not supported",
            ));
        }
        curves.extend(met.curves);
    }
    let cut = brep.split_along(&curves, &tolerance, || waiting.go_on());
    waiting.check()?;
    let parts = cut?;
    Ok(if parts.len() > 1 { parts } else { Vec::new() })
}

/// The solids that Breps close to as they are, else those that they enclose when they are cut by one another.
fn solids(breps: &[Brep], tolerance: Within) -> Outcome<Vec<Brep>> {
    let joined = Brep::join(breps, &tolerance.tolerance())?.breps;
    if joined.iter().all(Brep::is_solid) {
        Ok(joined)
    } else {
        let cells = Fuse::new(breps, &tolerance.tolerance())?.volumes()?;
        let cells: Vec<Brep> = cells.into_iter().map(|(_, made)| made.brep).collect();
        if cells.is_empty() {
            return Err(Fault::failed("the Breps enclose no volume"));
        }
        Ok(Brep::union(&cells, &tolerance.tolerance())?.into_iter().map(|made| made.brep).collect())
    }
}

/// The face on its surface with the seam elsewhere.
fn other_seam(face: &Face, Along(along): Along, at: f64, tolerance: Within) -> Outcome<Brep> {
    let surface = face.surface()?;
    if !surface.is_closed(along) || !surface.domain(along).contains(at) {
        return Err(Fault::bad_request("the surface does not close, or has no such parameter"));
    }
    let (moved, own) = (surface.with_seam(along, at)?, face.brep());
    let reversed = own.faces().first().is_some_and(|face| face.reversed);
    let whole = own.as_surface().is_some();
    let made = if whole {
        Brep::from_surface(moved)?
    } else {
        let mut parts = own.retrimmed(0, &moved, &tolerance.tolerance())?;
        match (parts.len(), parts.pop()) {
            (1, Some(only)) => only,
            _ => return Err(Fault::failed("the face comes apart at its new seam")),
        }
    };
    Ok(if reversed { made.flipped() } else { made })
}
