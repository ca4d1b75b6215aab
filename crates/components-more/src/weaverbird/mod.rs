//! Weaverbird: subdivision and other operators on meshes and groups of closed polylines.
//!
//! Public pages list names and ports; no file at hand shows the ids that Weaverbird gave its components, so those here have ids
//! of our own, and files find them by name.

mod define;
mod extract;
mod inset;
mod smooth;
mod subdivide;
mod subdivision;
mod tessellation;
#[cfg(test)]
mod tests;
mod weave_back;

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message};
use katydid_data::{Kind, Value, cast};
use katydid_geometry::{Curve, Mesh, Point3, PolylineCurve};

use crate::polygons::Polygons;

/// What a component of Weaverbird takes: meshes one by one, or closed polylines that are the faces of one body.
struct Body {
    polygons: Polygons,
    curves: bool,
}

/// The bodies in a list: each mesh is one, all closed polylines together are one.
///
/// # Errors
/// An item is neither a mesh nor a closed polyline.
fn bodies(items: &List<'_, Value>) -> Result<Vec<Body>, Message> {
    let (mut found, mut loops) = (Vec::new(), Vec::new());
    let rules = Default::default();
    for (k, item) in items.present().enumerate() {
        let curve = match &item {
            Value::Mesh(mesh) => {
                found.push(Body { polygons: Polygons::of_mesh(mesh), curves: false });
                continue;
            }
            Value::Curve(curve) => Some(curve.clone()),
            other => match cast::value(other, Kind::Curve, &rules) {
                Some(Value::Curve(curve)) => Some(curve),
                _ => match cast::value(other, Kind::Mesh, &rules) {
                    Some(Value::Mesh(mesh)) => {
                        found.push(Body { polygons: Polygons::of_mesh(&mesh), curves: false });
                        continue;
                    }
                    _ => None,
                },
            },
        };
        let points = curve.as_ref().and_then(|curve| curve.as_polyline());
        let closed = points.filter(|points| points.len() > 3 && points.first() == points.last());
        let Some(mut points) = closed else {
            return Err(Message::error(format!("Item {k} is neither a mesh nor a closed polyline")));
        };
        points.pop();
        loops.push(points);
    }
    if !loops.is_empty() {
        found.push(Body { polygons: Polygons::of_loops(&loops), curves: true });
    }
    Ok(found)
}

/// The faces as closed polylines.
fn outlines(polygons: &Polygons) -> Vec<Value> {
    let outline = |face: &Vec<usize>| {
        let mut points: Vec<Point3> = face.iter().map(|&i| polygons.at(i)).collect();
        points.extend(points.first().copied());
        PolylineCurve::new(points).ok().map(|curve| Value::from(Curve::Polyline(curve)))
    };
    polygons.faces.iter().filter_map(outline).collect()
}

/// A body as it came: a mesh from a mesh, closed polylines from closed polylines.
fn given(context: &Context<'_>, polygons: &Polygons, curves: bool) -> Result<Vec<Value>, Message> {
    if curves {
        context.items(polygons.faces.len())?;
        return Ok(outlines(polygons));
    }
    Ok(vec![Value::from(Shared::<Mesh>::new(polygons.to_mesh(context)?))])
}

/// Each body changed, and given as it came.
fn each(
    context: &Context<'_>,
    items: &List<'_, Value>,
    change: impl Fn(Polygons) -> Result<Polygons, Message>,
) -> Result<Vec<Value>, Message> {
    let mut results = Vec::new();
    for body in bodies(items)? {
        results.extend(given(context, &change(body.polygons)?, body.curves)?);
    }
    Ok(results)
}
