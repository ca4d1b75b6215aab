//! Mesh / Analysis: how thick a mesh is.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Mesh, MeshFace};

use super::{room, shared};
use crate::display::colour::of_hue;

/// Shows how thick a mesh is from place to place, and tells whether it is thick enough everywhere.
///
/// The depth at a vertex is the way through the mesh along the inner normal, to where it comes out. Its colour goes from
/// red where the mesh is thinnest over green to blue where it is thickest; with limits from red at the least depth
/// and below to blue at the greatest and above. Vertices without a way through, those of an open mesh say, are grey.
/// How Grasshopper measures the depth and colours it is not documented.
#[component(
    "07a3b2a0-c4d0-4638-9044-39ac4681e782",
    name = "Mesh Depth",
    nick = "MDepth",
    at = "Mesh/Analysis"
)]
#[output("Mesh", "M", "The mesh with a colour at each vertex.")]
#[output("Valid", "V", "Whether the depth at every vertex is within the limits.")]
fn mesh_depth(
    context: &Context<'_>,
    /// The mesh, closed and with its normals outwards.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The least depth that is allowed; without it any.
    #[port("Minimum", "Min", optional)]
    minimum: Option<f64>,
    /// The greatest depth that is allowed; without it any.
    #[port("Maximum", "Max", optional)]
    maximum: Option<f64>,
) -> Result<(Shared<Mesh>, bool), Message> {
    if minimum.zip(maximum).is_some_and(|(low, high)| low > high) {
        return Err(Message::error("The least depth is greater than the greatest"));
    }
    room(context, mesh.faces().len())?;
    let depths = mesh.depths()?;
    let mut used = vec![false; depths.len()];
    for &i in mesh.faces().iter().flat_map(MeshFace::indices) {
        if let Some(used) = used.get_mut(i as usize) {
            *used = true;
        }
    }
    let fits = |depth: f64| minimum.is_none_or(|m| depth >= m) && maximum.is_none_or(|m| depth <= m);
    let mut asked = depths.iter().zip(&used).filter(|(_, used)| **used).map(|(depth, _)| *depth);
    let valid = asked.all(|depth| depth.is_some_and(fits));
    if depths.iter().zip(&used).any(|(depth, used)| *used && depth.is_none()) {
        context
            .warn("At some vertices there is no way through: the mesh is open, or its normals point inwards");
    }
    let known = || depths.iter().flatten().copied();
    let low = minimum.unwrap_or_else(|| known().fold(f64::INFINITY, f64::min));
    let high = maximum.unwrap_or_else(|| known().fold(f64::NEG_INFINITY, f64::max));
    let colours: Vec<[u8; 4]> =
        depths.iter().map(|depth| depth.map_or(GREY, |d| hue(d, low, high))).collect();
    context.tell(Message::remark(
        "How depth is measured is not documented: here it is the way through the mesh along the inner normal of \
         each vertex",
    ));
    Ok((shared(mesh.with_colours(&colours)), valid))
}

const GREY: [u8; 4] = [128, 128, 128, 255];

/// From red at one limit to blue, two thirds round the circle, at the other.
fn hue(depth: f64, low: f64, high: f64) -> [u8; 4] {
    let t = if high > low { ((depth - low) / (high - low)).clamp(0.0, 1.0) } else { 1.0 };
    let [r, g, b] = of_hue(t * 2.0 / 3.0).map(|x| (255.0 * x).round() as u8);
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Interval, Mesh, Plane, Rectangle};

    fn sphere() -> Mesh {
        Mesh::sphere(&Plane::XY, 1.0, 24, 12).unwrap()
    }

    #[test]
    fn a_sphere_is_as_deep_as_it_is_wide() {
        let valid =
            |low: f64, high: f64| Trial::of("Mesh Depth").item(sphere()).item(low).item(high).texts(1);
        assert_eq!(valid(1.5, 2.5), ["{0}: True"]);
        assert_eq!(valid(2.5, 3.0), ["{0}: False"]);
        assert_eq!(valid(0.5, 1.5), ["{0}: False"]);
        assert!(Trial::of("Mesh Depth").item(sphere()).item(2.0).item(1.0).message().contains("least"));
        let out = Trial::of("Mesh Depth").item(sphere()).item(2.5).item(3.0).run();
        let Some(Value::Mesh(mesh)) = out.outputs[0].column().get(0) else { panic!("no mesh") };
        assert!(mesh.colours().iter().all(|c| *c == [255, 0, 0, 255]));
    }

    #[test]
    fn a_sheet_is_not_valid() {
        let square = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
        let out = Trial::of("Mesh Depth").item(Mesh::plane(&square, 1, 1).unwrap()).run();
        assert_eq!(texts(&out.outputs[1]), ["{0}: False"]);
        assert!(out.messages.iter().any(|m| m.text.contains("no way through")));
    }
}
