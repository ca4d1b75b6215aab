//! Wb SubD: subdivision.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;

use super::each;
use super::subdivision::{
    Naked, catmull_clark, corner_triangles, loop_level, mid_edge, split_quads, triangulated,
};
use crate::polygons::Polygons;

/// The most levels: each makes about four times the faces.
const MOST_LEVELS: i32 = 10;

/// A rule repeated, asked for room before each level.
fn levels(
    context: &Context<'_>,
    mut polygons: Polygons,
    level: i32,
    rule: impl Fn(&Polygons) -> Polygons,
) -> Result<Polygons, Message> {
    /// A corner of a face with its share of points and edges.
    const BYTES: usize = 150;
    if !(0..=MOST_LEVELS).contains(&level) {
        return Err(Message::error(format!("The level is {level}: it must be from 0 to {MOST_LEVELS}")));
    }
    for _ in 0..level {
        context.check()?;
        let corners: usize = polygons.faces.iter().map(Vec::len).sum();
        context.bytes(corners.saturating_mul(4 * BYTES))?;
        polygons = rule(&polygons);
    }
    Ok(polygons)
}

macro_rules! subdivision {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $level:literal, $before:expr, $rule:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "Weaverbird/Wb SubD")]
        #[output("Output Mesh/Curves", "O", "The results: meshes from meshes, closed polylines from closed polylines.")]
        fn $function(
            context: &Context<'_>,
            /// Meshes, or closed polylines that are the faces of one body.
            #[port("Mesh/Curves", "M")]
            bodies: List<Value>,
            /// How often the rule is applied.
            #[port("Level", "L", default = $level)]
            level: i32,
            /// What becomes of naked edges: 0 they stay, 1 they tend to a spline, 2 the same but corners stay. That 1 is meant
            /// when nothing is given is our reading.
            #[port("Smooth Naked Edges", "S", default = 1)]
            naked: i32,
        ) -> Result<Vec<Value>, Message> {
            let naked = Naked::of(naked)?;
            let before: fn(Polygons) -> Polygons = $before;
            let rule: fn(&Polygons, Naked) -> Polygons = $rule;
            each(context, &bodies, |body| levels(context, before(body), level, |body| rule(body, naked)))
        }
    };
}

subdivision!(
    /// Smooths a mesh after Catmull and Clark: each face becomes as many quads as it has corners. Stands for Weaverbird's.
    catmull_clark_component, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b01", "Catmull-Clark Subdivision", "wbCatmullClark", 1,
    |body| body, catmull_clark
);
subdivision!(
    /// Smooths a mesh after Loop: each triangle becomes four; quads are cut in two before. Stands for Weaverbird's.
    loop_component, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b02", "Loop Subdivision", "wbLoop", 1,
    |body: Polygons| triangulated(&body), loop_level
);
subdivision!(
    /// Cuts each face into as many quads as it has corners; the shape stays. Stands for Weaverbird's; naked edges do not move,
    /// whatever is asked for.
    split_polygons, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b03", "Split Polygons Subdivision", "wbSplitPolygons", 1,
    |body| body, |body: &Polygons, _| split_quads(body)
);
subdivision!(
    /// Cuts each triangle into four; quads are cut in two before; the shape stays. Stands for Weaverbird's; naked edges do not
    /// move, whatever is asked for.
    split_triangles, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b04", "Split Triangles Subdivision", "wbSplitTriangles", 1,
    |body: Polygons| triangulated(&body), |body: &Polygons, _| corner_triangles(body, true)
);
subdivision!(
    /// Cuts quads into four quads and triangles into four triangles; the shape stays. Stands for Weaverbird's; that triangles
    /// stay triangles is our reading.
    constant_quads, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b05", "Constant Quads Split Subdivision", "wbConstantQuads", 1,
    |body| body, |body: &Polygons, _| crate::kangaroo::refined(body)
);
subdivision!(
    /// Joins the middles of the edges around each face and around each vertex. Stands for Weaverbird's.
    mid_edge_component, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b06", "Midedge Subdivision", "wbMidEdge", 1,
    |body| body, mid_edge
);
subdivision!(
    /// Puts a face between the middles of the edges of each face, and a triangle at each corner. Stands for Weaverbird's.
    inner_polygons, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b07", "Inner Polygons Subdivision", "wbInnerPolygons", 1,
    |body| body, |body: &Polygons, _| corner_triangles(body, true)
);
subdivision!(
    /// Puts a triangle at each corner of each face, and leaves a hole between them. Stands for Weaverbird's.
    sierpinski_triangles, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b08", "Sierpinski Triangles Subdivision", "wbSierpinski", 1,
    |body| body, |body: &Polygons, _| corner_triangles(body, false)
);
