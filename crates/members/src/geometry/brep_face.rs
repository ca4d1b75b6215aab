//! Faces of breps. A face travels as a brep of which it is the first face.

use std::sync::Arc;

use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::{Brep, Containment, Curve, Interval, Point3, Surface};
use serde_json::Value as Json;

use super::answer::Outcome;
use super::argument::{Waiting, Within};
use super::choice::Along;
use super::table::Endpoints;
use crate::wire::Read;
use crate::{Fault, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.add(
        "brepface/pullpointstoface-brepface_point3darray_double",
        |f: Face, points: Vec<Point3>, _: Within, w: Waiting| {
            let search = ClosestOnBrep::new(Arc::new(f.brep()))?;
            points
                .iter()
                .map(|p| w.check().and_then(|()| Ok(search.nearest(*p)?.point)))
                .collect::<Outcome<Vec<Point3>>>()
        },
    );
    table.add("brepface/ispointonface-brepface_double_double", |f: Face, u: f64, v: f64| {
        relation(f, u, v, Within(0.001))
    });
    table.add("brepface/ispointonface-brepface_double_double_double", relation);
    table.add("brepface/trimawareisocurve-brepface_int_double", |f: Face, along: Along, constant: f64| {
        Ok(f.brep().face_isocurves(0, along.0, constant)?)
    });
    table.add(
        "brepface/trimawareisointervals-brepface_int_double",
        |f: Face, along: Along, constant: f64| {
            let curves = f.brep().face_isocurves(0, along.0, constant)?;
            Ok(curves.iter().map(Curve::domain).collect::<Vec<Interval>>())
        },
    );
    table.add("brepface/shrinksurfacetoedge-brepface", |f: Face| {
        Ok((true, f.brep().shrunk_face(0, &Within(0.001).tolerance())?))
    });
    table.add(
        "brepface/split-brepface_curvearray_double",
        |f: Face, curves: Vec<Curve>, tolerance: Within| {
            let tolerance = tolerance.tolerance();
            let pieces = f.brep().face_split(0, &curves, &tolerance)?;
            Ok(Brep::merged(&Brep::join(&pieces, &tolerance)?.breps))
        },
    );
    table
        .add("brep/copytrimcurves-brepface_surface_double", |f: Face, s: Surface, t: Within| copied(f, s, t));
    table.add("brep/createtrimmedsurface-brepface_surface_double", |f: Face, s: Surface, t: Within| {
        copied(f, s, t)
    });
    table
        .add("brep/createtrimmedsurface-brepface_surface", |f: Face, s: Surface| copied(f, s, Within(0.001)));
}

/// A face of a brep.
pub(super) struct Face(Brep);

impl Face {
    /// The brep of this face alone.
    pub(super) fn brep(&self) -> Brep {
        self.0.clone()
    }

    /// The surface that it is a part of.
    pub(super) fn surface(&self) -> Outcome<Surface> {
        self.0.face_surface(0).cloned().ok_or_else(|| Fault::bad_request("face has no surface"))
    }
}

impl Read for Face {
    fn read(json: &Json) -> Result<Self, Fault> {
        Brep::read(json).and_then(Self::of_brep)
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        Brep::of_value(value).and_then(Self::of_brep)
    }

    fn type_name() -> String {
        "BrepFace".into()
    }
}

impl Face {
    /// The first face of a brep.
    fn of_brep(brep: Brep) -> Result<Self, Fault> {
        match brep.faces().len() {
            0 => Err(Fault::bad_request("is a brep without faces")),
            1 => Ok(Self(brep)),
            _ => Ok(Self(brep.sub_brep(&[0])?)),
        }
    }
}

/// `PointFaceRelation`: 0 outside, 1 inside, 2 on the border.
fn relation(face: Face, u: f64, v: f64, tolerance: Within) -> Outcome<i32> {
    let search = ClosestOnBrep::new(Arc::new(face.brep()))?;
    Ok(match search.covers(0, u, v, tolerance.0)? {
        Containment::Outside => 0,
        Containment::Inside => 1,
        Containment::On => 2,
    })
}

/// A surface trimmed as a face is, by its parameters; `None` when nothing of it is left.
fn copied(face: Face, surface: Surface, tolerance: Within) -> Outcome<Option<Brep>> {
    Ok(face.brep().copied_trims(0, &surface, &tolerance.tolerance())?.into_iter().next())
}

/// The edges of a brep, as curves of their own.
pub(super) fn edge_curves(brep: &Brep, edges: impl IntoIterator<Item = usize>) -> Outcome<Vec<Curve>> {
    let mut out = Vec::new();
    for edge in edges {
        out.extend(brep.edge_as_curve(edge)?);
    }
    Ok(out)
}
