//! The point of any geometry nearest to a point, and where a line meets geometry.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_data::{Kind, Value, cast};
use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::{Box3, Brep, Curve, Line, Mesh, Point3, Vector3};

use crate::prepared;

/// The point of `geometry` nearest to `p`. A box counts as its skin, a rectangle as its outline.
///
/// # Errors
/// Geometry of a type that nothing can be pulled to yet; `p` is not finite.
pub(crate) fn closest(context: &Context<'_>, geometry: &Value, p: Point3) -> Result<Option<Point3>, Message> {
    Ok(match geometry {
        Value::Point(q) => Some(*q),
        Value::Plane(plane) => Some(plane.closest_point(p)),
        Value::Line(line) => Some(line.closest_point(p)),
        Value::Curve(curve) => Some(curve.closest_point(p)?.point),
        Value::Surface(surface) => Some(prepared::surface(context, surface)?.nearest(p)?.point),
        Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) => {
            match cast::value(geometry, Kind::Curve, &cast::Rules::default()) {
                Some(Value::Curve(curve)) => Some(curve.closest_point(p)?.point),
                _ => None,
            }
        }
        Value::Brep(_) | Value::Kept(_) if geometry.brep().is_some() => match geometry.brep() {
            Some(brep) => {
                let brep = brep.map_err(Message::warning)?;
                Some(prepared::brep(context, &brep)?.nearest(p)?.point)
            }
            None => None,
        },
        Value::Box(b) => Some(nearest(skin(b).iter().map(|&t| on_triangle(t, p)), p).unwrap_or(p)),
        Value::Mesh(mesh) if mesh.faces().is_empty() => None,
        Value::Mesh(mesh) => Some(prepared::mesh(context, mesh)?.tree.nearest(p)?),
        Value::Group(group) => {
            let mut found = Vec::new();
            for member in group.members.iter().flatten() {
                found.extend(closest(context, member, p)?);
            }
            nearest(found.into_iter(), p)
        }
        other => {
            return Err(Message::error(format!("Nothing can be pulled to a {} yet", other.kind().name())));
        }
    })
}

fn nearest(points: impl Iterator<Item = Point3>, p: Point3) -> Option<Point3> {
    points.min_by(|a, b| a.distance_to(p).total_cmp(&b.distance_to(p)))
}

/// The parameters t at which the line `p` + t `direction` meets `geometry`.
///
/// # Errors
/// Geometry of a type that a line cannot be cut with yet.
pub(crate) fn along(geometry: &Value, p: Point3, direction: Vector3) -> Result<Vec<f64>, Message> {
    Ok(match geometry {
        Value::Mesh(mesh) => triangles(mesh).filter_map(|t| through_triangle(t, p, direction)).collect(),
        Value::Box(b) => skin(b).into_iter().filter_map(|t| through_triangle(t, p, direction)).collect(),
        Value::Surface(_) | Value::Brep(_) | Value::Kept(_) if geometry.brep().is_some() => {
            match geometry.brep() {
                Some(brep) => through_brep(&*brep.map_err(Message::warning)?, p, direction)?,
                None => Vec::new(),
            }
        }
        Value::Plane(plane) => {
            let speed = direction.dot(plane.z_axis);
            if speed == 0.0 { Vec::new() } else { vec![-plane.signed_distance(p) / speed] }
        }
        other => {
            return Err(Message::error(format!(
                "Points cannot be projected to a {} yet",
                other.kind().name()
            )));
        }
    })
}

/// The parameters t at which the line `p` + t `direction` meets a Brep. Of a stretch in a face its ends count.
fn through_brep(brep: &Brep, p: Point3, direction: Vector3) -> Result<Vec<f64>, Message> {
    let (Some(bounds), speed) = (brep.bounds_of_faces(), direction.length()) else { return Ok(Vec::new()) };
    let reach = bounds.max_distance_to(p).max(1e-9) * 1.01;
    let unit = direction / speed;
    let line: Curve = Line::new(p - unit * reach, p + unit * reach).into();
    let found = ClosestOnBrep::new(Shared::new(brep.clone()))?.curve_crossings(&line, 1e-9 * reach)?;
    let domain = line.domain();
    let ends = found.overlaps.iter().flat_map(|o| [o.start, o.end]);
    let places = found.crossings.iter().map(|c| c.t).chain(ends);
    Ok(places.map(|t| (2.0 * domain.normalized(t) - 1.0) * reach / speed).collect())
}

type Triangle = [Point3; 3];

/// The twelve triangles around a box.
fn skin(b: &Box3) -> Vec<Triangle> {
    let c = b.corners();
    let quads = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    quads.iter().flat_map(|&[i, j, k, l]| [[c[i], c[j], c[k]], [c[i], c[k], c[l]]]).collect()
}

/// All faces of a mesh as triangles.
pub(crate) fn triangles(mesh: &Mesh) -> impl Iterator<Item = Triangle> + '_ {
    let at = |i: u32| mesh.vertices().get(i as usize).copied();
    mesh.faces()
        .iter()
        .flat_map(|face| face.triangles())
        .filter_map(move |[a, b, c]| Some([at(a)?, at(b)?, at(c)?]))
}

/// The point of a triangle nearest to `p` (C. Ericson, *Real-Time Collision Detection*, 2005, 5.1.5).
fn on_triangle([a, b, c]: Triangle, p: Point3) -> Point3 {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (ab.dot(p - a), ac.dot(p - a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let (d3, d4) = (ab.dot(p - b), ac.dot(p - b));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let (d5, d6) = (ab.dot(p - c), ac.dot(p - c));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let total = va + vb + vc;
    a + ab * (vb / total) + ac * (vc / total)
}

/// Where a line passes through a triangle, edges included (T. Möller, B. Trumbore, *Fast, minimum storage ray/triangle
/// intersection*, 1997).
pub(crate) fn through_triangle([a, b, c]: Triangle, p: Point3, direction: Vector3) -> Option<f64> {
    let (ab, ac) = (b - a, c - a);
    let h = direction.cross(ac);
    let det = ab.dot(h);
    if det == 0.0 {
        return None;
    }
    let s = p - a;
    let u = s.dot(h) / det;
    let q = s.cross(ab);
    let v = direction.dot(q) / det;
    const EDGE: f64 = -1e-12;
    (u >= EDGE && v >= EDGE && u + v <= 1.0 - EDGE).then(|| ac.dot(q) / det)
}
