//! Members that only scripts call: constructors, properties, and methods that change their object.

mod brep;
mod brep_parts;
mod brep_trims;
mod cloud_items;
mod curve;
mod curve_kinds;
mod curve_recognised;
mod hatch;
mod marks;
mod mesh;
mod mesh_change;
mod mesh_lists;
mod nurbs_lists;
mod object;
mod subd_parts;
mod surface;
mod surface_lists;
mod user_strings;

use serde_json::Value as Json;

use super::answer::Answer;
use super::table::Endpoints;
use crate::shape::Shape;
use crate::wire::Read;
use crate::{Fault, Value};

pub use mesh_change::{change_in_place, changes_in_place};

pub(super) fn enter(table: &mut Endpoints) {
    for (signature, class) in LISTS {
        table.member(signature, move |own: Held| Ok(Shape::List(class, own.0)));
    }
    object::enter(table);
    curve::enter(table);
    curve_kinds::enter(table);
    curve_recognised::enter(table);
    surface::enter(table);
    brep::enter(table);
    brep_parts::enter(table);
    brep_trims::enter(table);
    marks::enter(table);
    nurbs_lists::enter(table);
    mesh::enter(table);
    mesh_lists::enter(table);
    cloud_items::enter(table);
    hatch::enter(table);
    subd_parts::enter(table);
    surface_lists::enter(table);
    user_strings::enter(table);
}

/// An index that a list has not.
fn beyond(index: usize, count: usize) -> Fault {
    Fault::bad_request(format!("index is {index}, of {count}"))
}

/// Declares results that are geometry of one class: signatures name it.
macro_rules! of_class {
    ($($(#[$doc:meta])* $name:ident, $class:literal;)*) => {
        $($(#[$doc])*
        pub(super) struct $name(pub(super) $crate::Shape);

        impl $crate::geometry::answer::Answer for $name {
            fn name() -> String {
                concat!("Rhino.Geometry.", $class).into()
            }

            fn json(self) -> Result<serde_json::Value, $crate::Fault> {
                self.0.json()
            }

            fn value(self) -> Result<$crate::Value, $crate::Fault> {
                self.0.value()
            }
        })*
    };
}
use of_class;

/// A member of an enumeration of RhinoCommon.
struct Named(&'static str, i64);

impl Answer for Named {
    fn name() -> String {
        "Enum".into()
    }

    fn json(self) -> Result<Json, Fault> {
        Ok(Json::from(self.1))
    }

    fn value(self) -> Result<Value, Fault> {
        Ok(Value::Enum(self.0.into(), self.1))
    }
}

/// An object as a script holds it, by its number: what a list of it refers to.
struct Held(u64);

impl Read for Held {
    fn read(_: &Json) -> Result<Self, Fault> {
        Err(Fault::bad_request("is not held by a script"))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(geometry) if geometry.id > 0 => Ok(Self(geometry.id)),
            other => {
                Err(Fault::bad_request(format!("is {}, not an object that a script holds", other.noun())))
            }
        }
    }

    fn type_name() -> String {
        "GeometryBase".into()
    }
}

/// The lists of objects that scripts write in too: by the property, the class of the list.
const LISTS: [(&str, &str); 8] = [
    ("Mesh.get_Vertices this", "MeshVertexList"),
    ("Mesh.get_Faces this", "MeshFaceList"),
    ("Mesh.get_Normals this", "MeshVertexNormalList"),
    ("Mesh.get_FaceNormals this", "MeshFaceNormalList"),
    ("Mesh.get_VertexColors this", "MeshVertexColorList"),
    ("Mesh.get_TopologyEdges this", "MeshTopologyEdgeList"),
    ("NurbsCurve.get_Points this", "NurbsCurvePointList"),
    ("NurbsSurface.get_Points this", "NurbsSurfacePointList"),
];

/// The distance within which shapes are recognised where RhinoCommon asks for none: its `ZeroTolerance`.
const ZERO: f64 = 2.328_306_436_538_696e-10;
