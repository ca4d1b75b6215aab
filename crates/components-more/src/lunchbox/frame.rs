//! LunchBox Generate: frames round panels.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Brep, Mesh, MeshFace, Point3};

use super::subdivide::corners_of;

/// A frame round a panel, with the smaller panel inside it. Stands for LunchBox's Panel Frame; that the panel is made smaller
/// about the mean of its corners is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c56",
    name = "Panel Frame",
    nick = "Frame",
    at = "LunchBox/Generate"
)]
#[output("Panel Frame", "Frame", "The frame: a face along each side of the panel.", kind = Brep)]
#[output("Panel", "Panel", "The panel inside it.", kind = Brep)]
fn panel_frame(
    context: &Context<'_>,
    /// The panel: a surface with straight sides, or a closed polyline.
    #[port("Panel", "Panel")]
    panel: Value,
    /// The size of the inner panel as a part of the outer one, between 0 and 1.
    #[port("Scale Factor", "S", default = 0.8)]
    scale: f64,
) -> Result<(Shared<Brep>, Shared<Brep>), Message> {
    if !(scale > 0.0 && scale < 1.0) {
        return Err(Message::error(format!("The scale factor is {scale}: it must be between 0 and 1")));
    }
    let outer = corners_of(context, &panel)?;
    let middle = Point3::mean(&outer).unwrap_or(Point3::ORIGIN);
    let inner: Vec<Point3> = outer.iter().map(|p| middle.lerp(*p, scale)).collect();
    let count = u32::try_from(outer.len()).map_err(|_| Message::error("The panel has too many corners"))?;
    let quads = (0..count).map(|k| {
        let next = (k + 1) % count;
        MeshFace::Quad([k, next, count + next, count + k])
    });
    let corners = outer.iter().chain(&inner).copied().collect();
    let tolerance = context.tolerance();
    let frame = Brep::from_mesh(&Mesh::new(corners, quads.collect())?, &tolerance)?;
    let face = match count {
        3 => vec![MeshFace::Triangle([0, 1, 2])],
        4 => vec![MeshFace::Quad([0, 1, 2, 3])],
        // Flat panels are one face in the end; others stay a fan.
        _ => (1..count - 1).map(|k| MeshFace::Triangle([0, k, k + 1])).collect(),
    };
    let inside = Brep::from_mesh(&Mesh::new(inner, face)?, &tolerance)?;
    let inside = if count > 4 { inside.with_coplanar_faces_merged(&tolerance)? } else { inside };
    Ok((Shared::new(frame), Shared::new(inside)))
}
