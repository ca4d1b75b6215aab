//! Intersect / Physical: meshes with meshes.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Curve, LineCurve, Mesh, PolylineCurve, intersect};

use crate::prepared;

/// The curves along which two meshes cross.
///
/// Where they only touch along faces, the outline of what touches is found.
#[component(
    "21b6a605-9568-4bf8-acc1-631565d609d7",
    name = "Mesh | Mesh",
    nick = "MMX",
    at = "Intersect/Physical"
)]
#[output("Intersections", "X", "The polylines; when the object is set to the fast way, loose segments.")]
fn mesh_mesh(
    context: &Context<'_>,
    /// A mesh.
    #[port("Mesh A", "A")]
    a: Shared<Mesh>,
    /// Another mesh.
    #[port("Mesh B", "B")]
    b: Shared<Mesh>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let (first, second) = (prepared::mesh(context, &a)?, prepared::mesh(context, &b)?);
    if context.settings().bool("UseMeshMeshFast") == Some(true) {
        let segments = intersect::mesh_mesh_segments(&first.tree, &second.tree);
        context.items(segments.len())?;
        return Ok(segments.into_iter().map(|l| Shared::new(LineCurve::new(l).into())).collect());
    }
    // Small meshes have small parts: what is joined is small beside them too.
    let size = |m: &Mesh| m.bounding_box().map_or(f64::INFINITY, |b| b.diagonal().length());
    let tolerance = context.tolerance().absolute.min(1e-4 * size(&a).min(size(&b)));
    let tolerance = if tolerance.is_finite() { tolerance.max(0.0) } else { 0.0 };
    let lines = intersect::mesh_mesh(&first.tree, &second.tree, tolerance)?;
    context.items(lines.len())?;
    lines.into_iter().map(|points| Ok(Shared::new(PolylineCurve::new(points)?.into()))).collect()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Box3, Interval, Mesh, Plane};

    fn cube(at: f64) -> Mesh {
        let side = Interval::new(at, at + 2.0);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 2, 2, 2).unwrap()
    }

    #[test]
    fn crossing_boxes() {
        let made = Trial::of("Mesh | Mesh").item(cube(0.0)).item(cube(1.0)).run();
        assert_eq!(made.outputs[0].item_count(), 1);
        let length = Trial::of("Length").tree(made.outputs[0].clone()).texts(0);
        assert!(length.iter().any(|t| t.ends_with(": 6")), "{length:?}");
        assert_eq!(Trial::of("Mesh | Mesh").item(cube(0.0)).item(cube(7.0)).run().outputs[0].item_count(), 0);
        let loose = Trial::of("Mesh | Mesh").item(cube(0.0)).item(cube(1.0)).setting("UseMeshMeshFast", true);
        assert!(loose.run().outputs[0].item_count() >= 6);
    }
}
