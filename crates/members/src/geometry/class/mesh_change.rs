//! Members that change one vertex or face of a mesh, done in the mesh itself where its holder says that it may be.

use std::sync::Arc;

use katydid_geometry::Point3;

use super::mesh::{Corners, kernel_faces};
use crate::{Shape, Value};

fn index(value: &Value) -> Option<usize> {
    match value {
        Value::Int(i) => usize::try_from(*i).ok(),
        _ => None,
    }
}

fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        #[expect(clippy::cast_precision_loss, reason = "coordinates are numbers, whole or not")]
        Value::Int(i) => Some(*i as f64),
        _ => None,
    }
}

fn point(values: &[Value]) -> Option<Point3> {
    match values {
        [Value::Point(p)] => Some(*p),
        [x, y, z] => Some(Point3::new(number(x)?, number(y)?, number(z)?)),
        _ => None,
    }
}

fn corners(values: &[Value]) -> Option<Corners> {
    let corner = |value: &Value| i32::try_from(index(value)?).ok();
    match values {
        [Value::Face(all)] => Some(Corners(*all)),
        [a, b, c] => Some(Corners([corner(a)?, corner(b)?, corner(c)?, corner(c)?])),
        [a, b, c, d] => Some(Corners([corner(a)?, corner(b)?, corner(c)?, corner(d)?])),
        _ => None,
    }
}

/// Whether [`change_in_place`] knows a member.
pub fn changes_in_place(name: &str) -> bool {
    matches!(
        name,
        "MeshVertexList.SetVertex"
            | "MeshVertexList.set_Item"
            | "MeshVertexList.Add"
            | "MeshFaceList.AddFace"
    )
}

/// Calls a member, `Class.Member`, with its arguments behind the object, and changes the object itself. A mesh that others
/// hold too is copied first: they keep it as it is. None where the member must be called as any other, also to say what is
/// wrong: the object is then as it was.
pub fn change_in_place(name: &str, object: &mut Shape, arguments: &[Value]) -> Option<Value> {
    let Shape::Mesh(mesh) = object else { return None };
    if !changes_in_place(name) {
        return None;
    }
    let mesh = Arc::make_mut(mesh);
    let given = |place: usize| i64::try_from(place).ok().map(Value::Int);
    match (name, arguments) {
        ("MeshVertexList.SetVertex", [place, to @ ..]) => {
            mesh.set_vertex(index(place)?, point(to)?).ok()?.then_some(Value::Bool(true))
        }
        ("MeshVertexList.set_Item", [place, to]) => {
            let to = point(std::slice::from_ref(to))?;
            mesh.set_vertex(index(place)?, to).ok()?.then_some(Value::Null)
        }
        ("MeshVertexList.Add", vertex) => given(mesh.add_vertex(point(vertex)?).ok()?),
        ("MeshFaceList.AddFace", face) => {
            let face = *kernel_faces(&[corners(face)?]).ok()?.first()?;
            given(mesh.add_face(face).ok()?)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use katydid_geometry::Mesh;

    use super::*;

    fn held(shape: &Shape) -> *const Mesh {
        match shape {
            Shape::Mesh(mesh) => Arc::as_ptr(mesh),
            _ => std::ptr::null(),
        }
    }

    fn row(count: i32) -> Result<Arc<Mesh>, String> {
        let points = (0..count).map(|i| Point3::new(i.into(), 0.0, 0.0)).collect();
        Mesh::new(points, Vec::new()).map(Arc::new).map_err(|e| e.to_string())
    }

    /// How often the mesh is copied while all its vertices are set one by one.
    fn copies(object: &mut Shape, count: i64) -> usize {
        let mut copies = 0;
        for i in 0..count {
            let before = held(object);
            let to = [Value::Int(i), Value::Number(0.5), Value::Int(i), Value::Number(2.0)];
            assert_eq!(change_in_place("MeshVertexList.SetVertex", object, &to), Some(Value::Bool(true)));
            copies += usize::from(held(object) != before);
        }
        copies
    }

    #[test]
    fn a_mesh_is_copied_at_most_once_however_many_vertices_are_set() -> Result<(), String> {
        let mut own = Shape::Mesh(row(1000)?);
        assert_eq!(copies(&mut own, 1000), 0);
        let shared = row(1000)?;
        let mut object = Shape::Mesh(shared.clone());
        assert_eq!(copies(&mut object, 1000), 1);
        assert_eq!(shared.vertices()[999], Point3::new(999.0, 0.0, 0.0));
        let Shape::Mesh(mesh) = object else { return Err("a mesh stays one".into()) };
        assert_eq!(mesh.vertices()[999], Point3::new(0.5, 999.0, 2.0));
        Ok(())
    }

    #[test]
    fn what_is_wrong_is_left_to_the_usual_call() -> Result<(), String> {
        let mut object = Shape::Mesh(row(3)?);
        let before = object.clone();
        let at = Value::Point(Point3::ORIGIN);
        let nowhere = Value::Point(Point3::new(f64::NAN, 0.0, 0.0));
        let wrong: [(&str, Vec<Value>); 6] = [
            ("MeshVertexList.SetVertex", vec![Value::Int(3), at.clone()]),
            ("MeshVertexList.set_Item", vec![Value::Int(-1), at]),
            ("MeshVertexList.set_Item", vec![Value::Int(0), nowhere]),
            ("MeshVertexList.Add", vec![Value::Text("x".into())]),
            ("MeshFaceList.AddFace", vec![Value::Int(0), Value::Int(1), Value::Int(7)]),
            ("Mesh.get_IsClosed", vec![]),
        ];
        for (name, arguments) in wrong {
            assert_eq!(change_in_place(name, &mut object, &arguments), None, "{name}");
        }
        let (Shape::Mesh(now), Shape::Mesh(then)) = (&object, &before) else { return Err("meshes".into()) };
        assert_eq!(now, then);
        let face = [Value::Int(0), Value::Int(1), Value::Int(2)];
        assert_eq!(change_in_place("MeshFaceList.AddFace", &mut object, &face), Some(Value::Int(0)));
        let vertex = [Value::Point(Point3::new(0.0, 1.0, 0.0))];
        assert_eq!(change_in_place("MeshVertexList.Add", &mut object, &vertex), Some(Value::Int(3)));
        Ok(())
    }
}
