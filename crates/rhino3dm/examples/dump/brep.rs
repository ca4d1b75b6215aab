//! Breps.

use katydid_3dm::BrepObject;
use katydid_geometry::brep::{CurvePart, Iso, LoopKind, TrimKind};
use katydid_geometry::{Interval, Side};
use serde_json::{Value, json};

use crate::curve::curve;
use crate::numbers::point;
use crate::surface::surface;

pub(crate) fn brep(object: &BrepObject) -> Value {
    let brep = &object.brep;
    let parts = brep.parts();
    let place = |place: Option<usize>| place.map_or(json!(-1), |place| json!(place));
    let places = |list: [Option<usize>; 2]| json!([place(list[0]), place(list[1])]);
    let vertices = parts.vertices.iter();
    let vertices =
        vertices.map(|v| json!({"at": point(v.point), "edges": v.edges, "tolerance": v.tolerance}));
    let edges = parts.edges.iter().enumerate().map(|(i, e)| {
        let points: Vec<_> =
            [0.0, 0.3, 1.0].map(|x| brep.edge_point(i, e.part.domain.at(x)).map(point)).into();
        json!({"part": part(&e.part), "vertices": places(e.vertices), "trims": e.trims,
            "tolerance": e.tolerance, "points": points})
    });
    let trims = parts.trims.iter().map(|t| {
        json!({"part": part(&t.part), "edge": place(t.edge), "vertices": places(t.vertices),
            "reversed": t.reversed, "kind": kind(t.kind), "iso": iso(t.iso), "loop": place(t.in_loop),
            "tolerance": t.tolerance})
    });
    let loops = parts.loops.iter().map(|l| {
        let kind = match l.kind {
            LoopKind::Unknown => 0,
            LoopKind::Outer => 1,
            LoopKind::Inner => 2,
            LoopKind::Slit => 3,
        };
        json!({"trims": l.trims, "kind": kind, "face": place(l.face)})
    });
    let faces = parts.faces.iter().map(|f| {
        json!({"loops": f.loops, "surface": place(f.surface), "reversed": f.reversed,
            "material": f.material_channel, "colour": f.colour})
    });
    let curves = |list: &[Option<_>]| list.iter().map(|c| c.as_ref().map(curve)).collect::<Vec<_>>();
    let meshes = |list: &[Option<_>]| list.iter().map(Option::is_some).collect::<Vec<_>>();
    json!({"vertices": vertices.collect::<Vec<_>>(), "edges": edges.collect::<Vec<_>>(),
        "trims": trims.collect::<Vec<_>>(), "loops": loops.collect::<Vec<_>>(),
        "faces": faces.collect::<Vec<_>>(), "curves_2d": curves(&parts.curves_2d),
        "curves_3d": curves(&parts.curves_3d),
        "surfaces": parts.surfaces.iter().map(|s| s.as_ref().map(surface)).collect::<Vec<_>>(),
        "render_meshes": meshes(&object.render_meshes), "analysis_meshes": meshes(&object.analysis_meshes),
        "bare": object.bare_surface().map(|b| surface(&b.surface)),
        "solid": object.brep.is_solid(), "solidity": format!("{:?}", parts.solidity),
        "faults": brep.faults().iter().map(ToString::to_string).collect::<Vec<_>>()})
}

fn part(part: &CurvePart) -> Value {
    let ends = |range: Interval| [range.start, range.end];
    json!({"curve": part.curve.map_or(-1, |c| c as i64), "range": ends(part.range),
        "reversed": part.reversed, "domain": ends(part.domain)})
}

fn kind(kind: TrimKind) -> i32 {
    match kind {
        TrimKind::Unknown => 0,
        TrimKind::Boundary => 1,
        TrimKind::Mated => 2,
        TrimKind::Seam => 3,
        TrimKind::Singular => 4,
    }
}

fn iso(iso: Iso) -> i32 {
    match iso {
        Iso::None => 0,
        Iso::InnerU => 1,
        Iso::InnerV => 2,
        Iso::Side(Side::West) => 3,
        Iso::Side(Side::South) => 4,
        Iso::Side(Side::East) => 5,
        Iso::Side(Side::North) => 6,
    }
}
