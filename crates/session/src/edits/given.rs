//! Geometry that is picked or drawn in a viewport and kept in an input: Grasshopper's *Set one* and *Set multiple*.

use katydid_data::cast::{self, Rules};
use katydid_data::{Kind, Path, Value};
use katydid_definition::document::{Branch, Persistent, Stored, parse_path};
use katydid_geometry::{
    Circle, Curve, Interval, KnotSpacing, Line, NurbsCurve, Plane, Point3, PolylineCurve, Rectangle, Vector3,
};
use uuid::Uuid;

use super::{finite, geometry, keep};
use crate::Refusal;
use crate::editor::Draft;
use crate::protocol::{Drawing, GeometrySource, PlaneView};

/// A hand draws no more points than this.
const MOST_POINTS: usize = 10_000;

/// Keeps geometry in an input, one item each in one branch, in place of what it kept.
pub(super) fn set(draft: &mut Draft<'_>, port: Uuid, items: &[GeometrySource]) -> Result<(), Refusal> {
    let at = draft.input(port)?;
    let object = draft.at(at.object)?.clone();
    let kind = keep::kind_of(&object, at.port);
    let unfit = |reason: String| keep::unfit(&object, reason);
    if items.is_empty() || items.len() > keep::MOST_VALUES {
        return Err(unfit(format!("an input is given 1 to {} items", keep::MOST_VALUES)));
    }
    let items = items.iter().map(|item| one(draft, item, kind, &unfit)).collect::<Result<Vec<_>, _>>()?;
    let values = Persistent { branches: vec![Branch { path: vec![0], items }] };
    let object = draft.at(at.object)?;
    if object.inputs.get(at.port).and_then(|port| object.persistent(port)).as_ref() != Some(&values) {
        object.set_persistent(at.port, Some(&values))?;
    }
    Ok(())
}

/// An item as an input of a type keeps it.
fn one(
    draft: &Draft<'_>,
    item: &GeometrySource,
    kind: Kind,
    unfit: &impl Fn(String) -> Refusal,
) -> Result<Stored, Refusal> {
    let value = match item {
        GeometrySource::Model { object } => return referenced(draft, *object, kind).map_err(unfit),
        GeometrySource::Item { port, path, index } => item_of(draft, *port, path, *index).map_err(unfit)?,
        GeometrySource::Drawn { drawing } => drawn(drawing)?,
    };
    let fitting = fit(&value, kind, &draft.rules);
    let fitting = fitting.ok_or_else(|| unfit(format!("a {} is no {kind}", value.kind())))?;
    geometry::stored(&fitting).map_err(unfit)
}

/// A reference to an object of the model, which must be there and fit the input.
fn referenced(draft: &Draft<'_>, id: Uuid, kind: Kind) -> Result<Stored, String> {
    let model = draft.results.model().ok_or("no Rhino model is attached")?;
    let found = model.object(id).ok_or_else(|| format!("the model has no object {id}"))?;
    let geometry = found.geometry.as_ref().ok_or_else(|| format!("a {} cannot be used yet", found.class))?;
    if fit(geometry, kind, &draft.rules).is_none() {
        return Err(format!("a {} of the model is no {kind}", found.class));
    }
    Ok(geometry::reference(id, geometry, kind))
}

fn item_of(draft: &Draft<'_>, port: Uuid, path: &str, index: u32) -> Result<Value, String> {
    let tree = draft.results.output(port, draft.within);
    let tree = tree.ok_or_else(|| "there is no data to keep until it is solved".to_owned())?;
    let path = parse_path(path).map(|elements| Path::from(elements.as_slice()));
    let found = tree
        .branches()
        .find(|branch| Some(branch.path()) == path.as_ref())
        .and_then(|branch| branch.get(index as usize));
    found.ok_or_else(|| "the item that was picked is not there any more".to_owned())
}

/// A value as an input of a type takes it.
pub(super) fn fit(value: &Value, kind: Kind, rules: &Rules) -> Option<Value> {
    match kind {
        Kind::Generic | Kind::Geometry => Some(value.clone()),
        kind => cast::value(value, kind, rules),
    }
}

/// What was drawn, as a value.
fn drawn(drawing: &Drawing) -> Result<Value, Refusal> {
    let senseless = |error: katydid_geometry::Error| Refusal::Senseless(error.to_string());
    Ok(match drawing {
        Drawing::Point { at } => Value::Point(point(at)?),
        Drawing::Vector { along: [x, y, z] } => {
            finite(&[*x, *y, *z])?;
            Value::Vector(Vector3::new(*x, *y, *z))
        }
        Drawing::Plane { plane } => Value::from(plane_of(plane)?),
        Drawing::Line { ends: [from, to] } => {
            let line = Line { from: point(from)?, to: point(to)? };
            if line.from == line.to {
                return Err(Refusal::Senseless("a line without length".to_owned()));
            }
            Value::from(line)
        }
        Drawing::Polyline { points } => {
            Value::from(Curve::from(PolylineCurve::new(several(points)?).map_err(senseless)?))
        }
        Drawing::Interpolated { points, closed } => {
            let points = several(points)?;
            let curve = if *closed && points.len() > 2 {
                NurbsCurve::interpolate_periodic(3, &points, KnotSpacing::Chord)
            } else {
                NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None)
            };
            Value::from(Curve::from(curve.map_err(senseless)?))
        }
        Drawing::Circle { plane, radius } => {
            finite(&[*radius])?;
            Value::from(Circle::new(plane_of(plane)?, *radius).map_err(senseless)?)
        }
        Drawing::Rectangle { plane, size: [width, height] } => {
            finite(&[*width, *height])?;
            if *width == 0.0 || *height == 0.0 {
                return Err(Refusal::Senseless("a rectangle without area".to_owned()));
            }
            let side = |length: f64| Interval::new(length.min(0.0), length.max(0.0));
            Value::from(Rectangle { plane: plane_of(plane)?, x: side(*width), y: side(*height) })
        }
    })
}

fn point(&[x, y, z]: &[f64; 3]) -> Result<Point3, Refusal> {
    finite(&[x, y, z])?;
    Ok(Point3::new(x, y, z))
}

/// Points of a curve, each other than the one before.
fn several(points: &[[f64; 3]]) -> Result<Vec<Point3>, Refusal> {
    if points.len() > MOST_POINTS {
        return Err(Refusal::Senseless(format!("no more than {MOST_POINTS} points are drawn")));
    }
    let mut points = points.iter().map(point).collect::<Result<Vec<_>, _>>()?;
    points.dedup();
    if points.len() < 2 {
        return Err(Refusal::Senseless("a curve has two points at least".to_owned()));
    }
    Ok(points)
}

fn plane_of(view: &PlaneView) -> Result<Plane, Refusal> {
    let [x, y] = [view.x, view.y].map(|[x, y, z]| Vector3::new(x, y, z));
    finite(&[view.x, view.y].concat())?;
    Plane::from_axes(point(&view.origin)?, x, y).map_err(|error| Refusal::Senseless(error.to_string()))
}
