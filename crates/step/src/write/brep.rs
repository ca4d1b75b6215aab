//! Breps: solids, with the voids inside them, and sheets.

use super::edge::{self, Support};
use super::sheets::{Piece, pieces};
use super::{flag, point, surface};
use crate::Result;
use crate::part21::{Id, Sheet, list, quoted};
use katydid_geometry::Brep;
use katydid_geometry::brep::LoopKind;

/// How far a trim may be from its edge, as a part of the shell's size.
const NEAR: f64 = 5e-8;

/// The entities that a brep became.
pub(super) struct Items {
    pub(super) solids: Vec<Id>,
    pub(super) sheets: Vec<Id>,
}

pub(super) fn put(sheet: &mut Sheet, brep: &Brep, name: &str, tolerance: f64) -> Result<Items> {
    let (solids, open) = pieces(brep);
    let name = quoted(name);
    let mut items = Items { solids: Vec::new(), sheets: Vec::new() };
    for Piece { outer, voids } in solids {
        let shell = shell(sheet, &outer, "CLOSED_SHELL", tolerance)?;
        if voids.is_empty() {
            items.solids.push(sheet.put(format_args!("MANIFOLD_SOLID_BREP({name},{shell})")));
            continue;
        }
        let mut inner = Vec::new();
        for void in &voids {
            // A void's shell is written with its normals outward, and used turned over.
            let id = self::shell(sheet, &void.clone().flipped(), "CLOSED_SHELL", tolerance)?;
            inner.push(sheet.put(format_args!("ORIENTED_CLOSED_SHELL('',*,{id},.F.)")));
        }
        items.solids.push(sheet.put(format_args!("BREP_WITH_VOIDS({name},{shell},{})", list(inner))));
    }
    let mut shells = Vec::new();
    for one in &open {
        shells.push(shell(sheet, one, "OPEN_SHELL", tolerance)?);
    }
    if !shells.is_empty() {
        items.sheets.push(sheet.put(format_args!("SHELL_BASED_SURFACE_MODEL({name},{})", list(shells))));
    }
    Ok(items)
}

fn invalid(why: String) -> crate::Error {
    katydid_geometry::Error::Invalid { what: "brep", why }.into()
}

fn shell(sheet: &mut Sheet, brep: &Brep, keyword: &str, tolerance: f64) -> Result<Id> {
    let mut supports = Vec::with_capacity(brep.faces().len());
    for (place, face) in brep.faces().iter().enumerate() {
        if face.deleted {
            supports.push(None);
            continue;
        }
        let surface =
            brep.face_surface(place).ok_or_else(|| invalid(format!("face {place} has no surface")))?;
        supports.push(Some(Support { surface, put: surface::put(sheet, surface)? }));
    }
    let vertices: Vec<Id> = brep
        .vertices()
        .iter()
        .map(|vertex| {
            let point = point(sheet, vertex.point);
            sheet.put(format_args!("VERTEX_POINT('',{point})"))
        })
        .collect();
    let size = brep.bounds_of_faces().map_or(0.0, |bounds| bounds.diagonal().length());
    let near = (NEAR * size).max(f64::MIN_POSITIVE);
    let mut edges = Vec::with_capacity(brep.edges().len());
    for (place, edge) in brep.edges().iter().enumerate() {
        if edge.deleted || edge.trims.is_empty() {
            edges.push(None);
            continue;
        }
        let ends = edge.vertices.map(|v| vertices.get(v?).copied());
        let [Some(a), Some(b)] = ends else { return Err(invalid(format!("edge {place} has no vertices"))) };
        edges.push(edge::put(sheet, brep, place, [a, b], &supports, near, tolerance)?);
    }
    let mut faces = Vec::new();
    for (place, support) in supports.iter().enumerate() {
        if let Some(support) = support {
            faces.push(face(sheet, brep, place, support, &edges, &vertices)?);
        }
    }
    Ok(sheet.put(format_args!("{keyword}('',{})", list(faces))))
}

fn face(
    sheet: &mut Sheet,
    brep: &Brep,
    place: usize,
    support: &Support<'_>,
    edges: &[Option<Id>],
    vertices: &[Id],
) -> Result<Id> {
    let face = brep.faces().get(place).ok_or_else(|| invalid(format!("there is no face {place}")))?;
    let mut bounds = Vec::new();
    for chain in face.loops.iter().filter_map(|l| brep.loops().get(*l)).filter(|chain| !chain.deleted) {
        let id = bound(sheet, brep, &chain.trims, edges, vertices)?;
        let keyword = if chain.kind == LoopKind::Outer { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
        bounds.push(sheet.put(format_args!("{keyword}('',{id},{})", flag(!face.reversed))));
    }
    if bounds.is_empty() {
        return Err(invalid(format!("face {place} has no loops")));
    }
    let same = face.reversed == support.put.chart.turns();
    Ok(sheet.put(format_args!("ADVANCED_FACE('',{},{},{})", list(bounds), support.put.id, flag(same))))
}

/// The edges of a loop; where its surface is singular there is none.
fn bound(
    sheet: &mut Sheet,
    brep: &Brep,
    trims: &[usize],
    edges: &[Option<Id>],
    vertices: &[Id],
) -> Result<Id> {
    let mut oriented = Vec::new();
    for trim in trims.iter().filter_map(|t| brep.trims().get(*t)).filter(|trim| !trim.deleted) {
        let Some(place) = trim.edge else { continue };
        let Some(edge) = edges.get(place).copied().flatten() else {
            return Err(invalid(format!("edge {place} has no curve")));
        };
        let same = flag(!trim.reversed);
        oriented.push(sheet.put(format_args!("ORIENTED_EDGE('',*,*,{edge},{same})")));
    }
    if !oriented.is_empty() {
        return Ok(sheet.put(format_args!("EDGE_LOOP('',{})", list(oriented))));
    }
    let place = trims.first().and_then(|t| brep.trims().get(*t)?.vertices[0]);
    let vertex = place.and_then(|v| vertices.get(v)).ok_or_else(|| invalid("a loop has no edges".into()))?;
    Ok(sheet.put(format_args!("VERTEX_LOOP('',{vertex})")))
}
