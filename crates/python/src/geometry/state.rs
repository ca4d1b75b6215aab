//! Geometry as text: the form `{"version", "archive3dm", "opennurbs", "data"}` that rhino3dm and Rhino.Compute speak.
//! Copies and pickles go by it, and objects of rhino3dm come and go in it.

use std::sync::Arc;

use katydid_3dm::{BrepObject, MeshObject, Object, SubDObject};
use katydid_data::Value;
use katydid_members::wire::{decode_object, encode_object};
use pyo3::prelude::*;

use super::{Brep, SubD};
use crate::errors::GeometryError;

/// The version of archives whose rules the bytes follow: that of Rhino 8.
const ARCHIVE: i32 = 80;

/// The form of an object.
pub(crate) fn form(object: Object) -> PyResult<String> {
    let json =
        encode_object(&object.into(), ARCHIVE).map_err(|fault| GeometryError::new_err(fault.message))?;
    Ok(json.to_string())
}

pub(crate) fn brep(brep: &katydid_geometry::Brep) -> PyResult<String> {
    form(Object::Brep(Box::new(BrepObject::from(brep.clone()))))
}

pub(crate) fn mesh(mesh: &katydid_geometry::Mesh) -> PyResult<String> {
    form(Object::Mesh(Box::new(MeshObject::from(mesh))))
}

pub(crate) fn subd(subd: &katydid_geometry::subd::SubD) -> PyResult<String> {
    form(Object::SubD(Box::new(SubDObject::from(subd))))
}

/// What a class needs to be made again of its form, for `pickle` and `copy`.
pub(crate) type Reduced<'py> = (Bound<'py, PyAny>, (String, &'static str));

/// The function and arguments that make an object again.
pub(crate) fn reduced<'py>(py: Python<'py>, form: String, class: &'static str) -> PyResult<Reduced<'py>> {
    Ok((py.import("katydid._katydid")?.getattr("rebuild")?, (form, class)))
}

/// Geometry of its form, the JSON text that `to_json()` gives and that rhino3dm's `Encode` has: `{"version",
/// "archive3dm", "opennurbs", "data"}`. A class asked for by name is what comes out, where the form holds one.
#[pyfunction]
#[pyo3(signature = (form, class_name=""))]
pub(crate) fn rebuild<'py>(py: Python<'py>, form: &str, class_name: &str) -> PyResult<Bound<'py, PyAny>> {
    let json =
        serde_json::from_str(form).map_err(|error| GeometryError::new_err(format!("no JSON: {error}")))?;
    let value = decode_object(&json).map_err(|fault| GeometryError::new_err(fault.message))?;
    let failed = |error: String| GeometryError::new_err(error);
    match class_name {
        "Brep" => {
            if let Some(brep) = value.brep() {
                return Ok(Bound::new(py, Brep(brep.map_err(failed)?))?.into_any());
            }
        }
        "SubD" => {
            if let Some(subd) = value.subd() {
                return Ok(Bound::new(py, SubD(Arc::new(subd.map_err(failed)?)))?.into_any());
            }
        }
        _ => {}
    }
    crate::values::to_python(py, Some(&value))
}

/// A subdivision surface as a value of a definition.
pub(crate) fn subd_value(subd: &katydid_geometry::subd::SubD) -> PyResult<Value> {
    let object = Object::SubD(Box::new(SubDObject::from(subd)));
    let raw = object.to_raw(ARCHIVE, &[]).map_err(|error| GeometryError::new_err(error.to_string()))?;
    Ok(Value::from(raw))
}
