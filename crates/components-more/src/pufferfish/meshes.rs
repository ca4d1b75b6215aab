//! Meshes: lofts, pipes and extrusions by parameters, offsets, voxels and what meshes are made of.

use std::collections::HashMap;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary as _;
use katydid_geometry::{Curve, Decimation, Mesh, Plane, Point3, PolylineCurve, Vector3};

use super::MOST_PARTS;
use super::grids::mesh_of_rows;
use super::mix::Mix;
use crate::polygons::Polygons;

/// Places that differ by less than this part of a section's size, or than this many units, differ by rounding.
const ROUNDING: f64 = 1e-6;

/// The places of a curve at parameters from 0 to 1: shares of its length, or of its domain.
fn places(curve: &Curve, shares: &[f64], by_domain: bool) -> Vec<Point3> {
    let at = |share: f64| {
        let share = share.clamp(0.0, 1.0);
        let by_length = || curve.parameter_at_normalized_length(share);
        let t = if by_domain { None } else { by_length() };
        curve.point_at(t.unwrap_or_else(|| curve.domain().at(share)))
    };
    shares.iter().map(|share| at(*share)).collect()
}

/// The corners of a curve: those of a polyline, or the ends of spans.
fn corners(curve: &Curve) -> Result<Vec<Point3>, Message> {
    if let Some(points) = curve.as_polyline() {
        return Ok(points);
    }
    let nurbs = curve.to_nurbs()?;
    Ok(nurbs.span_parameters().into_iter().map(|t| nurbs.point_at(t)).collect())
}

/// Parameters of a list, from 0 to 1 in ten parts where there are none.
fn shares(list: &List<'_, f64>) -> Result<Vec<f64>, Message> {
    let all: Vec<f64> = list.present().filter(|t| t.is_finite()).collect();
    match all.len() {
        0 => Ok((0..=10).map(|i| f64::from(i) / 10.0).collect()),
        n if n <= MOST_PARTS => Ok(all),
        n => Err(Message::error(format!("{n} parameters are too many"))),
    }
}

/// A mesh between section curves. Stands for Pufferfish's Parameter Loft Mesh; parameters along sections are shares of their lengths,
/// and divisions by angle are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f305d",
    name = "Parameter Loft Mesh",
    nick = "ParamLoftMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Lofted", "L", "The mesh.")]
fn loft(
    context: &Context<'_>,
    /// The sections.
    #[port("Sections", "S")]
    sections: List<Shared<Curve>>,
    /// Where sections are divided, from 0 to 1.
    #[port("Parameters U", "u", optional)]
    us: List<f64>,
    /// Where the way from one section to the next is divided, from 0 to 1.
    #[port("Parameters V", "v", optional)]
    vs: List<f64>,
    /// Whether parameters are shares of the sections' domains, so that they follow what bends.
    #[port("Weighted", "W", default = false)]
    weighted: bool,
    /// Whether sections are divided at their corners instead.
    #[port("Lengths", "L", default = false)]
    lengths: bool,
    /// Divisions by angle, which are not supported: 0.
    #[port("Angle", "A", default = 0.0)]
    angle: f64,
    /// Whether the last section goes on to the first.
    #[port("Closed", "C", default = false)]
    closed: bool,
    /// Whether faces are triangles.
    #[port("Triangulate", "T", default = false)]
    triangulate: bool,
    /// A point before the first section.
    #[port("Point Start", "sP", optional)]
    start: Option<Point3>,
    /// A point behind the last section.
    #[port("Point End", "eP", optional)]
    end: Option<Point3>,
) -> Result<Shared<Mesh>, Message> {
    if angle != 0.0 {
        context.tell(Message::remark("Divisions by angle are not supported: the parameters count"));
    }
    let sections: Vec<Shared<Curve>> = sections.present().collect();
    let (us, mut vs) = (shares(&us)?, if vs.is_empty() { vec![0.0, 1.0] } else { shares(&vs)? });
    vs.sort_by(f64::total_cmp);
    vs.dedup();
    let mut rows: Vec<Vec<Point3>> = Vec::new();
    for section in &sections {
        context.check()?;
        rows.push(if lengths { corners(section)? } else { places(section, &us, weighted) });
    }
    let across = rows.first().map_or(0, Vec::len);
    if rows.iter().any(|row| row.len() != across) {
        return Err(Message::error("The sections have different numbers of corners"));
    }
    if let Some(p) = start {
        rows.insert(0, vec![p; across]);
    }
    if let Some(p) = end {
        rows.push(vec![p; across]);
    }
    if closed && let Some(first) = rows.first().cloned() {
        rows.push(first);
    }
    context.bytes(rows.len().saturating_mul(vs.len()).saturating_mul(across).saturating_mul(100))?;
    let mut points: Vec<Vec<Point3>> = Vec::new();
    for (k, pair) in rows.windows(2).enumerate() {
        let [a, b] = pair else { continue };
        for v in vs.iter().filter(|v| k == 0 || **v > 0.0) {
            points.push(a.iter().zip(b).map(|(p, q)| p.lerp(*q, *v)).collect());
        }
    }
    wall(context, points, triangulate)
}

/// A mesh through rows of places, each along a section. Faces look outwards where sections run counter-clockwise and rows go up; places
/// that differ by rounding are one, so that closed sections have no seam, and faces without area are left out.
fn wall(
    context: &Context<'_>,
    mut rows: Vec<Vec<Point3>>,
    triangulate: bool,
) -> Result<Shared<Mesh>, Message> {
    let near = context.tolerance().absolute.min(narrowest(&rows) * ROUNDING);
    for row in &mut rows {
        row.reverse();
    }
    let (aligned, _) = mesh_of_rows(&rows, triangulate)?.with_aligned_vertices(near)?;
    Ok(Shared::new(Polygons::of_mesh(&aligned).to_mesh(context)?))
}

/// The least size of a row that is no point: the distance of its first place from the farthest.
fn narrowest(rows: &[Vec<Point3>]) -> f64 {
    let size = |row: &Vec<Point3>| {
        let first = row.first().copied().unwrap_or(Point3::ORIGIN);
        row.iter().map(|p| p.distance_to(first)).fold(0.0, f64::max)
    };
    rows.iter().map(size).filter(|size| *size > 0.0).fold(f64::INFINITY, f64::min)
}

/// A pipe round a curve as a mesh. Stands for Pufferfish's Parameter Pipe Mesh; round ends are flat here, and divisions by angle are not
/// supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f305e",
    name = "Parameter Pipe Mesh",
    nick = "ParamPipeMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Piped", "P", "The mesh.")]
fn pipe(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The radius, in units.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// Where the curve is divided, from 0 to 1.
    #[port("Parameters U", "u", optional)]
    us: List<f64>,
    /// Where the way round is divided, from 0 to 1.
    #[port("Parameters V", "v", optional)]
    vs: List<f64>,
    /// Whether parameters are shares of the curve's domain.
    #[port("Weighted", "W", default = false)]
    weighted: bool,
    /// Whether the curve is divided at its corners instead.
    #[port("Lengths", "L", default = false)]
    lengths: bool,
    /// Divisions by angle, which are not supported: 0.
    #[port("Angle", "A", default = 0.0)]
    angle: f64,
    /// What closes the ends: 0 nothing, others flat faces.
    #[port("End Type", "E", default = 0)]
    ends: i32,
    /// Whether faces are triangles.
    #[port("Triangulate", "T", default = false)]
    triangulate: bool,
) -> Result<Shared<Mesh>, Message> {
    if angle != 0.0 {
        context.tell(Message::remark("Divisions by angle are not supported: the parameters count"));
    }
    if ends == 2 {
        context.tell(Message::remark("Round ends are not supported: they are flat"));
    }
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Message::error("The radius must be greater than 0"));
    }
    let (us, vs) = (shares(&us)?, shares(&vs)?);
    let domain = curve.domain();
    let parameter = |share: f64| {
        let by_length = if weighted { None } else { curve.parameter_at_normalized_length(share) };
        by_length.unwrap_or_else(|| domain.at(share))
    };
    let parameters: Vec<f64> = if lengths {
        curve.to_nurbs()?.span_parameters()
    } else {
        us.iter().map(|share| parameter(share.clamp(0.0, 1.0))).collect()
    };
    context.bytes(parameters.len().saturating_mul(vs.len()).saturating_mul(100))?;
    let frames = curve.perpendicular_frames(&parameters);
    let mut rows: Vec<Vec<Point3>> = Vec::new();
    for frame in frames.into_iter().flatten() {
        let at = |v: f64| {
            let (sin, cos) = (v * std::f64::consts::TAU).sine_cosine();
            frame.at(radius * cos, radius * sin, 0.0)
        };
        rows.push(vs.iter().map(|v| at(*v)).collect());
    }
    if ends > 0 && !curve.is_closed() {
        let middle = |row: &Vec<Point3>, p: Point3| vec![p; row.len()];
        if let (Some(first), Some(last)) = (rows.first().cloned(), rows.last().cloned()) {
            rows.insert(0, middle(&first, curve.start()));
            rows.push(middle(&last, curve.end()));
        }
    }
    wall(context, rows, triangulate)
}

/// A mesh of a profile moved along a vector, or to a point. Stands for Pufferfish's Parameter Extrude Mesh; along curves the profile is moved
/// without turns, and divisions by angle are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f305f",
    name = "Parameter Extrude Mesh",
    nick = "ParamExtrMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Extruded", "E", "The mesh.")]
fn extrude(
    context: &Context<'_>,
    /// The profile.
    #[port("Profile", "P")]
    profile: &Curve,
    /// A vector, a curve or a point.
    #[port("Direction", "D")]
    direction: Value,
    /// Where the profile is divided, from 0 to 1.
    #[port("Parameters U", "u", optional)]
    us: List<f64>,
    /// Where the way is divided, from 0 to 1.
    #[port("Parameters V", "v", optional)]
    vs: List<f64>,
    /// Whether parameters are shares of domains, so that they follow what bends.
    #[port("Weighted", "W", default = false)]
    weighted: bool,
    /// Whether the profile is divided at its corners instead.
    #[port("Lengths", "L", default = false)]
    lengths: bool,
) -> Result<Shared<Mesh>, Message> {
    let (us, vs) = (shares(&us)?, shares(&vs)?);
    let row = if lengths { corners(profile)? } else { places(profile, &us, weighted) };
    context.bytes(row.len().saturating_mul(vs.len()).saturating_mul(100))?;
    let moved = |by: Vector3| row.iter().map(|p| *p + by).collect::<Vec<Point3>>();
    let rows: Vec<Vec<Point3>> = match &direction {
        Value::Vector(v) => vs.iter().map(|share| moved(*v * *share)).collect(),
        Value::Point(tip) => {
            vs.iter().map(|share| row.iter().map(|p| p.lerp(*tip, *share)).collect()).collect()
        }
        other => match katydid_data::cast::value(other, katydid_data::Kind::Curve, context.rules()) {
            Some(Value::Curve(rail)) => {
                let start = rail.start();
                places(&rail, &vs, weighted).into_iter().map(|p| moved(p - start)).collect()
            }
            _ => return Err(Message::error("The direction must be a vector, a curve or a point")),
        },
    };
    wall(context, rows, false)
}

/// Offsets a mesh, to one side or both, open or as a solid. Stands for Pufferfish's Offset Mesh.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3060",
    name = "Offset Mesh",
    nick = "OffMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Offset", "O", "The meshes.")]
fn offset(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The distance, in units.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// A second distance, of the other sign for the other side.
    #[port("Both Sides", "B", optional)]
    other: Option<f64>,
    /// Whether the mesh is given a thickness.
    #[port("Create Solid", "C", default = false)]
    solid: bool,
) -> Result<Vec<Shared<Mesh>>, Message> {
    let other = other.filter(|d| *d != 0.0);
    if solid {
        let base = match other {
            Some(other) => mesh.offset(other)?,
            None => mesh.clone(),
        };
        return Ok(vec![Shared::new(base.thickened(distance - other.unwrap_or(0.0))?)]);
    }
    let mut meshes = vec![Shared::new(mesh.offset(distance)?)];
    if let Some(other) = other {
        meshes.push(Shared::new(mesh.offset(other)?));
    }
    Ok(meshes)
}

/// Moves the vertices of a mesh along their normals, each by its distance. Stands for Pufferfish's Displace Mesh; the last distance goes on.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3061",
    name = "Displace Mesh",
    nick = "DisMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Displaced", "D", "The mesh.")]
fn displace(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The distances, in units.
    #[port("Distances", "D")]
    distances: List<f64>,
) -> Result<Shared<Mesh>, Message> {
    let distances: Vec<f64> = distances.present().collect();
    let distance = |i: usize| distances.get(i).or(distances.last()).copied().unwrap_or(0.0);
    let normals = mesh.vertex_normals();
    let moved = mesh.vertices().iter().zip(&normals).enumerate().map(|(i, (p, n))| *p + *n * distance(i));
    let displaced =
        Mesh::from_parts(moved.collect(), mesh.faces().to_vec(), Vec::new(), mesh.colours().to_vec())?;
    Ok(Shared::new(displaced.with_normals()))
}

/// A mesh of boxes round points, without faces between boxes that touch. Stands for Pufferfish's Voxel Mesh; that points are moved to a grid
/// from the plane's origin is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3062",
    name = "Voxel Mesh",
    nick = "VoxMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Voxelized", "V", "The mesh.")]
fn voxel_mesh(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane along which boxes lie.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
    /// The size of boxes along x; a negative one leaves out the faces across x.
    #[port("Size X", "X", default = 1.0)]
    x: f64,
    /// The size of boxes along y.
    #[port("Size Y", "Y", default = 1.0)]
    y: f64,
    /// The size of boxes along z.
    #[port("Size Z", "Z", default = 1.0)]
    z: f64,
    /// Whether faces are triangles.
    #[port("Triangulate", "T", default = false)]
    triangulate: bool,
) -> Result<Shared<Mesh>, Message> {
    let sizes = [x, y, z];
    if !sizes.iter().all(|s| s.is_finite() && *s != 0.0) {
        return Err(Message::error("The sizes of boxes must not be 0"));
    }
    let mut cells: std::collections::BTreeSet<[i64; 3]> = std::collections::BTreeSet::new();
    for p in points.present().filter(|p| p.is_finite()) {
        let at = plane.coordinates(p);
        cells.insert(std::array::from_fn(|k| (at[k] / sizes[k].abs()).round() as i64));
    }
    context.bytes(cells.len().saturating_mul(1200))?;
    let mut numbers: HashMap<[i64; 3], usize> = HashMap::new();
    let mut polygons = Polygons::default();
    for cell in &cells {
        for axis in 0..3 {
            for up in [0_i64, 1] {
                let mut beside = *cell;
                beside[axis] = beside[axis].saturating_add(2 * up - 1);
                if cells.contains(&beside) || sizes[axis] < 0.0 {
                    continue;
                }
                let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut side: Vec<[i64; 3]> = [[0, 0], [1, 0], [1, 1], [0, 1]]
                    .iter()
                    .map(|[s, t]| {
                        let mut corner = *cell;
                        corner[axis] = corner[axis].saturating_add(up);
                        corner[b] = corner[b].saturating_add(*s);
                        corner[c] = corner[c].saturating_add(*t);
                        corner
                    })
                    .collect();
                if up == 0 {
                    side.reverse();
                }
                let face: Vec<usize> = side
                    .iter()
                    .map(|corner| {
                        let next = polygons.points.len();
                        let number = *numbers.entry(*corner).or_insert(next);
                        if number == next {
                            let at = |k: usize| (corner[k] as f64 - 0.5) * sizes[k].abs();
                            polygons.points.push(plane.at(at(0), at(1), at(2)));
                        }
                        number
                    })
                    .collect();
                match (triangulate, face.as_slice()) {
                    (true, &[a, b, c, d]) => polygons.faces.extend([vec![a, b, c], vec![a, c, d]]),
                    _ => polygons.faces.push(face),
                }
            }
        }
    }
    Ok(Shared::new(polygons.to_mesh(context)?))
}

/// Whether a mesh is closed. Stands for Pufferfish's Is Mesh Closed.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3063",
    name = "Is Mesh Closed",
    nick = "MshClsd",
    at = "Pufferfish/Mesh"
)]
#[output("Closed", "C", "Whether it is.")]
fn is_closed(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> bool {
    mesh.is_closed()
}

/// Whether a mesh has pieces that do not touch. Stands for Pufferfish's Is Mesh Disjoint.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3064",
    name = "Is Mesh Disjoint",
    nick = "MshDisjn",
    at = "Pufferfish/Mesh"
)]
#[output("Disjoint", "D", "Whether it has.")]
#[output("Pieces", "P", "The pieces.", kind = Mesh)]
fn is_disjoint(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<(bool, Vec<Shared<Mesh>>), Message> {
    let pieces = mesh.pieces()?;
    Ok((pieces.len() > 1, pieces.into_iter().map(Shared::new).collect()))
}

/// How many vertices and faces a mesh has. Stands for Pufferfish's Mesh Statistics; the order of the outputs is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3065",
    name = "Mesh Statistics",
    nick = "MshStats",
    at = "Pufferfish/Mesh"
)]
#[output("Vertices", "V", "The vertices.")]
#[output("Faces", "F", "The faces.")]
#[output("Quads", "Q", "The faces with four corners.")]
#[output("Triangles", "T", "The faces with three.")]
#[output("Colors", "C", "The colours.")]
#[output("Pieces", "P", "The pieces.")]
fn statistics(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<(i32, i32, i32, i32, i32, i32), Message> {
    let count = |n: usize| i32::try_from(n).unwrap_or(i32::MAX);
    let quads = mesh.faces().iter().filter(|face| face.indices().len() == 4).count();
    let faces = mesh.faces().len();
    Ok((
        count(mesh.vertices().len()),
        count(faces),
        count(quads),
        count(faces - quads),
        count(mesh.colours().len()),
        count(mesh.pieces()?.len()),
    ))
}

/// Fills the holes of a mesh. Stands for Pufferfish's Close Mesh.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3066",
    name = "Close Mesh",
    nick = "ClsMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Closed", "C", "The mesh.")]
#[output("Result Boolean", "R", "Whether it was open and is closed now.")]
fn close(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: Shared<Mesh>,
) -> Result<(Shared<Mesh>, bool), Message> {
    if mesh.is_closed() {
        return Ok((mesh, false));
    }
    let filled = mesh.with_holes_closed(&mesh.holes())?;
    let closed = filled.is_closed();
    Ok((Shared::new(filled), closed))
}

/// The boundaries of a mesh as polylines. Stands for Pufferfish's Mesh Naked Edges.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3067",
    name = "Mesh Naked Edges",
    nick = "MshNakedEdgs",
    at = "Pufferfish/Curve"
)]
#[output("Naked Edges", "E", "The boundaries.")]
fn naked_edges(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Vec<Shared<Curve>>, Message> {
    let edges = mesh.edges();
    let lines = edges.iter().filter(|edge| edge.faces == 1).filter_map(|edge| mesh.edge_line(edge));
    let lines: Vec<Curve> =
        lines.filter_map(|line| PolylineCurve::new(vec![line.from, line.to]).ok()).map(Curve::from).collect();
    context.items(lines.len())?;
    let joined = katydid_geometry::join_curves(&lines, context.tolerance().absolute.min(ROUNDING), false);
    Ok(joined.into_iter().map(Shared::new).collect())
}

/// A mesh with fewer faces. Stands for Pufferfish's Reduce Mesh; the other settings of the plug-in do not count.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3068",
    name = "Reduce Mesh",
    nick = "ReduMsh",
    at = "Pufferfish/Mesh"
)]
#[output("Reduced", "R", "The mesh, of triangles.")]
fn reduce(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The number of faces to come down to.
    #[port("Count", "C", default = 1000)]
    count: i32,
) -> Result<Shared<Mesh>, Message> {
    let faces = usize::try_from(count).unwrap_or(0).max(1);
    let options = Decimation { faces, max_error: f64::INFINITY };
    let stop = context.stop();
    Ok(Shared::new(mesh.decimated(&options, || !stop())?))
}

/// A mesh between two whose vertices each have a factor of their own. Stands for Pufferfish's Blend Two Meshes; the last factor goes on.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3069",
    name = "Blend Two Meshes",
    nick = "Blnd2Mshs",
    at = "Pufferfish/Mesh"
)]
#[output("Blend", "B", "The mesh.")]
fn blend_two(
    context: &Context<'_>,
    /// What factor 0 gives.
    #[port("Mesh A", "A")]
    a: Shared<Mesh>,
    /// What factor 1 gives.
    #[port("Mesh B", "B")]
    b: Shared<Mesh>,
    /// A factor for each vertex.
    #[port("Factors", "F")]
    factors: List<f64>,
) -> Result<Shared<Mesh>, Message> {
    // Half of each tells whether they go together.
    let half = Shared::<Mesh>::mix(&[(a.clone(), 0.5), (b.clone(), 0.5)], context.tolerance().absolute)?;
    let factors: Vec<f64> = factors.present().collect();
    let factor = |i: usize| factors.get(i).or(factors.last()).copied().unwrap_or(0.5);
    let pairs = a.vertices().iter().zip(b.vertices()).enumerate();
    let points = pairs.map(|(i, (p, q))| p.lerp(*q, factor(i))).collect();
    Ok(Shared::new(
        Mesh::from_parts(points, half.faces().to_vec(), Vec::new(), half.colours().to_vec())?.with_normals(),
    ))
}
