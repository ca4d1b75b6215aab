//! Breps: joined, capped, cut by planes, and asked where points lie.

use std::sync::Arc;

use katydid_geometry::brep::{BrepSections, ClosestOnBrep};
use katydid_geometry::region::{FillRule, Region};
use katydid_geometry::{Brep, Containment, Curve, Plane, Point3, Tolerance, join_curves};

use super::answer::{Outcome, or_null};
use super::argument::{Positive, Some1, Turn, Waiting, Within};
use super::brep_face::edge_curves;
use super::curve::contour_planes;
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("brep/getwireframe-brep_int", |b: Brep, density: i32| wireframe(&b, density));
    table.add("extrusion/getwireframe-extrusion", |b: Brep| wireframe(&b, -1));
    table.add("brep/closestpoint-brep_point3d", |b: Brep, p: Point3| Ok(b.closest_point(p)?.point));
    table.add(
        "brep/ispointinside-brep_point3d_double_bool",
        |b: Brep, p: Point3, t: Within, strictly: bool| {
            Ok(match ClosestOnBrep::new(Arc::new(b))?.contains(p, t.0)? {
                Containment::Inside => true,
                Containment::On => !strictly,
                Containment::Outside => false,
            })
        },
    );
    table.add("brep/joinbreps-breparray_double", |b: Some1<Brep>, t: Within| {
        Ok(Brep::join(&b.0, &t.tolerance())?.breps)
    });
    table.add("brep/join-brep_brep_double_bool", |a: Brep, b: Brep, t: Within, _: bool| {
        let mut joined = Brep::join(&[a.clone(), b], &t.tolerance())?.breps;
        Ok(match (joined.len(), joined.pop()) {
            (1, Some(one)) => (true, one),
            _ => (false, a),
        })
    });
    table.add("brep/mergebreps-breparray_double", |b: Some1<Brep>, _: Within| Ok(Brep::merged(&b.0)));
    table.add("brep/capplanarholes-brep_double", |b: Brep, t: Within| {
        let (capped, holes) = b.capped(&t.tolerance())?;
        Ok((holes > 0).then_some(capped))
    });
    table.add("brep/mergecoplanarfaces-brep_double", |b: Brep, t: Within| merged_faces(&b, &t.tolerance()));
    table.add("brep/mergecoplanarfaces-brep_double_double", |b: Brep, t: Within, a: Turn| {
        merged_faces(&b, &a.and(t))
    });
    table.add("brep/createcontourcurves-brep_plane", |b: Brep, plane: Plane, w: Waiting| {
        contours(b, &[plane], &w)
    });
    table.add(
        "brep/createcontourcurves-brep_point3d_point3d_double",
        |b: Brep, start: Point3, end: Point3, interval: Positive, w: Waiting| {
            contours(b, &contour_planes(start, end, interval)?, &w)
        },
    );
    table.add("brep/createplanarunion-breparray_plane_double", |b: Some1<Brep>, plane: Plane, t: Within| {
        or_null(planar(&b.0, &plane, t, Region::union)).map(Option::flatten)
    });
    table.add(
        "brep/createplanarunion-brep_brep_plane_double",
        |a: Brep, b: Brep, plane: Plane, t: Within| {
            or_null(planar(&[a, b], &plane, t, Region::union)).map(Option::flatten)
        },
    );
    table.add(
        "brep/createplanardifference-brep_brep_plane_double",
        |a: Brep, b: Brep, plane: Plane, t: Within| {
            or_null(planar(&[a, b], &plane, t, Region::difference)).map(Option::flatten)
        },
    );
    table.add(
        "brep/createplanarintersection-brep_brep_plane_double",
        |a: Brep, b: Brep, plane: Plane, t: Within| {
            or_null(planar(&[a, b], &plane, t, Region::intersection)).map(Option::flatten)
        },
    );
}

/// The most isocurves between two knots.
const DENSEST: i32 = 100;

/// The edges, and so many isocurves between knots of each face; a density of −1 gives edges only.
fn wireframe(brep: &Brep, density: i32) -> Outcome<Vec<Curve>> {
    if !(-1..=DENSEST).contains(&density) {
        return Err(Fault::bad_request(format!("density is {density}, not -1 to {DENSEST}")));
    }
    let mut out = edge_curves(brep, 0..brep.edges().len())?;
    if let Ok(density) = usize::try_from(density) {
        for face in 0..brep.faces().len() {
            out.extend(brep.face_wires(face, density)?);
        }
    }
    Ok(out)
}

fn merged_faces(brep: &Brep, tolerance: &Tolerance) -> Outcome<(bool, Brep)> {
    let merged = brep.with_coplanar_faces_merged(tolerance)?;
    Ok((merged.faces().len() < brep.faces().len(), merged))
}

fn contours(brep: Brep, planes: &[Plane], waiting: &Waiting) -> Outcome<Vec<Curve>> {
    let sections = BrepSections::new(Arc::new(brep), &Tolerance::default())?;
    let mut out = Vec::new();
    for plane in planes {
        waiting.check()?;
        out.extend(sections.cut(plane)?.curves);
    }
    Ok(out)
}

/// What two regions become.
type Combine = fn(&Region, &Region, f64) -> katydid_geometry::Result<Region>;

/// Flat breps combined as regions of a plane, one after the other; `None` when nothing is left.
fn planar(breps: &[Brep], plane: &Plane, tolerance: Within, combine: Combine) -> Outcome<Option<Vec<Brep>>> {
    let mut whole: Option<Region> = None;
    for (i, brep) in breps.iter().enumerate() {
        let rims = join_curves(&edge_curves(brep, brep.naked_edges())?, tolerance.0, false);
        let flat = |c: &Curve| c.hull_points().iter().all(|p| plane.signed_distance(*p).abs() <= tolerance.0);
        if rims.is_empty() || !rims.iter().all(|rim| rim.is_closed() && flat(rim)) {
            return Err(Fault::bad_request(format!("brep {i} is no region of the plane")));
        }
        let region = Region::new(&rims, FillRule::EvenOdd, plane, tolerance.0)?;
        whole = Some(match whole {
            Some(before) => combine(&before, &region, tolerance.0)?,
            None => region,
        });
    }
    let curves = whole.map(|region| region.curves()).unwrap_or_default();
    if curves.is_empty() {
        return Ok(None);
    }
    Ok(Some(Brep::planar_faces(&curves, &tolerance.tolerance())?.breps))
}
