//! Geometry as a definition keeps it: openNURBS objects, packed as .NET packs them.

use katydid_3dm::{BrepObject, Object as Archived};
use katydid_data::{Kind, Tree, Value};
use katydid_definition::document::{Branch, OnData, Persistent, Stored, StoredGeometry};

use uuid::Uuid;

use crate::catalogue;

/// The archive version that Grasshopper packs objects for.
const VERSION: i32 = 50;

/// Data as a parameter keeps it.
///
/// # Errors
/// With what cannot be kept yet.
pub(super) fn persistent(tree: &Tree) -> Result<Persistent, String> {
    let item = |value: Option<Value>| value.map_or(Ok(Stored::Null), |value| stored(&value));
    let branches = tree.branches().map(|branch| {
        let items = branch.iter().map(item).collect::<Result<_, _>>()?;
        Ok(Branch { path: branch.path().elements().to_vec(), items })
    });
    Ok(Persistent { branches: branches.collect::<Result<_, String>>()? })
}

/// A value as a parameter keeps it.
///
/// # Errors
/// With what cannot be kept yet.
pub(super) fn stored(value: &Value) -> Result<Stored, String> {
    if let Some(plain) = catalogue::stored(value) {
        return Ok(plain);
    }
    let (object, type_name) = match value {
        Value::Curve(curve) => (Archived::Curve((**curve).clone()), "GH_Curve"),
        Value::Surface(_) | Value::Brep(_) => {
            let brep = value.brep().transpose()?.ok_or_else(|| "a surface without faces".to_owned())?;
            let object = BrepObject { bounds: brep.bounds_of_faces(), ..BrepObject::from((*brep).clone()) };
            let name = if brep.faces().len() == 1 { "GH_Surface" } else { "GH_Brep" };
            (Archived::Brep(Box::new(object)), name)
        }
        Value::Mesh(mesh) => (Archived::from((**mesh).clone()), "GH_Mesh"),
        Value::Kept(raw) => (Archived::Kept((**raw).clone()), kept_type(&raw.class_name())),
        other => return Err(format!("a {} cannot be kept in a definition yet", other.kind())),
    };
    let raw = object.to_raw(VERSION, &[]).map_err(|error| error.to_string())?;
    let data = OnData {
        class_name: format!("Rhino.Geometry.{}", raw.class_name()),
        archive3dm: raw.archive_version,
        opennurbs: raw.opennurbs_version.cast_signed(),
        data: raw.bytes,
    };
    Ok(Stored::Geometry(Box::new(StoredGeometry {
        edge: (type_name == "GH_Curve").then_some(-1),
        on_data: Some(data.write().map_err(|error| error.to_string())?),
        type_name: Some(format!("Grasshopper.Kernel.Types.{type_name}")),
        ..StoredGeometry::default()
    })))
}

/// A reference to an object of a Rhino model, as a parameter of a type keeps it. `geometry` is that of the object.
pub(super) fn reference(object: Uuid, geometry: &Value, kind: Kind) -> Stored {
    let type_name = match geometry {
        Value::Point(_) => "GH_Point",
        Value::Surface(_) => "GH_Surface",
        Value::Brep(_) | Value::Box(_) => "GH_Brep",
        Value::Mesh(_) => "GH_Mesh",
        Value::Kept(raw) => kept_type(&raw.class_name()),
        _ => "GH_Curve",
    };
    Stored::Geometry(Box::new(StoredGeometry {
        ref_id: object,
        edge: (type_name == "GH_Curve").then_some(-1),
        // A Point parameter keeps a reference otherwise than its points.
        ref_type: (kind == Kind::Point).then(|| "point_object".to_owned()),
        type_name: Some(format!("Grasshopper.Kernel.Types.{type_name}")),
        ..StoredGeometry::default()
    }))
}

/// Grasshopper's own type for a class.
fn kept_type(class: &str) -> &'static str {
    match class {
        "SubD" => "GH_SubD",
        "Mesh" => "GH_Mesh",
        "PointCloud" => "GH_PointCloud",
        "Extrusion" => "GH_Extrusion",
        "Brep" => "GH_Brep",
        _ => "GH_Curve",
    }
}
