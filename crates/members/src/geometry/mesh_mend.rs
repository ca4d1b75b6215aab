//! Meshes mended: holes closed, borders brought together, edges opened.

use katydid_geometry::intersect::mesh_mesh;
use katydid_geometry::{Healing, Line, Mesh, MeshTree, Point3, PolylineCurve};

use super::answer::Outcome;
use super::argument::{Count, Some1, Waiting, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("mesh/fillholes-mesh", |m: Mesh| {
        let holes = m.holes();
        Ok(if holes.is_empty() { (false, m) } else { (true, m.with_holes_closed(&holes)?) })
    });
    // The path is written so.
    table.add("mesh/filehole-mesh_int", fill_hole);
    table.add("mesh/healnakededges-mesh_double", |m: Mesh, distance: Within, w: Waiting| {
        let (healed, _) = cleaned(&m, distance.0, Healing::Borders, &w)?;
        Ok((true, healed))
    });
    table.add("mesh/createfromiterativecleanup-mesharray_double", |m: Some1<Mesh>, t: Within, w: Waiting| {
        let cleaned = m.0.iter().map(|mesh| {
            let (healed, changes) = cleaned(mesh, t.0, Healing::Everything, &w)?;
            Ok((changes > 0).then_some(healed))
        });
        let cleaned = cleaned.collect::<Outcome<Vec<Option<Mesh>>>>()?;
        Ok(cleaned.iter().any(Option::is_some).then_some(cleaned))
    });
    table.add("mesh/requireiterativecleanup-mesharray_double", |m: Some1<Mesh>, t: Within, w: Waiting| {
        for mesh in &m.0 {
            if cleaned(mesh, t.0, Healing::Everything, &w)?.1 > 0 {
                return Ok(true);
            }
        }
        Ok(false)
    });
    table.add("mesh/unweldedge-mesh_intarray_bool", |m: Mesh, edges: Some1<Index>, modify: bool| {
        let all = topology_edges(&m);
        let wanted = edges.0.iter().map(|at| edge(&all, at.0)).collect::<Outcome<Vec<_>>>()?;
        let opened = m.unwelded_along(&wanted)?;
        Ok((true, if modify { opened.with_normals() } else { opened }))
    });
    table.add("mesh/split-mesh_mesh", |m: Mesh, by: Mesh, w: Waiting| split_by(&m, &[by], None, &w));
    table.add("mesh/split-mesh_mesharray", |m: Mesh, by: Some1<Mesh>, w: Waiting| {
        split_by(&m, &by.0, None, &w)
    });
    table.add(
        "mesh/split-mesh_mesharray_double_bool_textlog_cancellationtoken_doublearray",
        |m: Mesh, by: Some1<Mesh>, t: Within, coplanar: bool, w: Waiting| {
            if coplanar {
                return Err(Fault::not_supported("meshes split where they lie in one plane"));
            }
            split_by(&m, &by.0, Some(t.0), &w)
        },
    );
    table.add(
        "mesh/split-mesh_mesharray_double_bool_bool_textlog_cancellationtoken_doublearray",
        |m: Mesh, by: Some1<Mesh>, t: Within, coplanar: bool, ngons: bool, w: Waiting| {
            if coplanar || ngons {
                return Err(Fault::not_supported(
                    "splits where meshes lie in one plane, and splits with n-gons",
                ));
            }
            split_by(&m, &by.0, Some(t.0), &w)
        },
    );
    for path in [
        "mesh/splitwithprojectedpolylines-mesh_polylinecurvearray_double",
        "mesh/splitwithprojectedpolylines-mesh_polylinecurvearray_double_textlog_cancellationtoken_doublearray",
    ] {
        table.add(path, |m: Mesh, by: Some1<PolylineCurve>, t: Within, w: Waiting| {
            let points = by.0.iter().map(PolylineCurve::points);
            split_along(&m, &segments(points), t.0, &w)
        });
    }
}

/// The share of a mesh's size that counts as a tolerance where none is given.
const ROUNDING: f64 = 1e-9;

fn segments<'a>(chains: impl Iterator<Item = &'a [Point3]>) -> Vec<Line> {
    chains.flat_map(|points| points.windows(2).map(|pair| Line::new(pair[0], pair[1]))).collect()
}

/// The parts into which other meshes cut one; `None` when they do not meet it.
fn split_by(
    mesh: &Mesh,
    others: &[Mesh],
    tolerance: Option<f64>,
    waiting: &Waiting,
) -> Outcome<Option<Vec<Mesh>>> {
    let size = mesh.bounding_box().map_or(1.0, |bounds| bounds.diagonal().length());
    let tolerance = tolerance.unwrap_or(0.0).max(ROUNDING * size).max(f64::MIN_POSITIVE);
    let own = MeshTree::new(mesh);
    let mut cuts = Vec::new();
    for other in others {
        waiting.check()?;
        let chains = mesh_mesh(&own, &MeshTree::new(other), tolerance)?;
        cuts.extend(segments(chains.iter().map(Vec::as_slice)));
    }
    split_along(mesh, &cuts, tolerance, waiting)
}

/// The parts into which segments on a mesh cut it; `None` when they change nothing.
fn split_along(mesh: &Mesh, cuts: &[Line], tolerance: f64, waiting: &Waiting) -> Outcome<Option<Vec<Mesh>>> {
    if cuts.is_empty() {
        return Ok(None);
    }
    let parts = mesh.cut_along(cuts, tolerance, || waiting.go_on());
    waiting.check()?;
    let parts = parts?;
    // What hung together by nothing before is no part that a cut made.
    let before = mesh.cut_along(&[], tolerance, || waiting.go_on())?.len();
    Ok((parts.len() > before).then_some(parts))
}

type Index = Count<0, { i32::MAX as usize }>;

/// The edges as `Mesh.TopologyEdges` counts them: by the first of their places and then by the second, places counted in
/// the order in which the vertices name them first.
fn topology_edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let ends = mesh.edges().into_iter().map(|edge| edge.vertices);
    let mut ends: Vec<[u32; 2]> = ends.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    ends.sort_unstable();
    ends
}

fn edge(all: &[[u32; 2]], at: usize) -> Outcome<[u32; 2]> {
    all.get(at).copied().ok_or_else(|| {
        let last = all.len().saturating_sub(1);
        Fault::bad_request(format!("there is no edge {at}: they are 0 to {last}"))
    })
}

/// The mesh with the hole closed that an edge is on the border of.
fn fill_hole(mesh: Mesh, at: Index) -> Outcome<(bool, Mesh)> {
    let [a, b] = edge(&topology_edges(&mesh), at.0)?;
    let merged = mesh.merged_indices();
    let place = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
    let has = |ring: &Vec<u32>| {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).any(|(p, q)| {
            let (p, q) = (place(*p), place(*q));
            (p.min(q), p.max(q)) == (a, b)
        })
    };
    match mesh.holes().into_iter().find(has) {
        Some(ring) => Ok((true, mesh.with_holes_closed(&[ring])?)),
        None => Ok((false, mesh)),
    }
}

fn cleaned(mesh: &Mesh, distance: f64, what: Healing, waiting: &Waiting) -> Outcome<(Mesh, usize)> {
    waiting.check()?;
    let healed = mesh.healed(distance, what, || waiting.go_on());
    waiting.check()?;
    Ok(healed?)
}
