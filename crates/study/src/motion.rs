//! How what is shown moves when an input moves.

use katydid_component::Cancel;
use katydid_data::{Kind, Tree, Value, cast};
use katydid_definition::document::{Document, ids};
use katydid_geometry::{Direction, Point3, Vector3};
use katydid_solver::Engine;

use crate::probe::Probe;
use crate::thresholds::{MOST_ARROWS, MOTION_PARTS, NUDGE};
use crate::{Prepared, StudyError};

/// A place that moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrow {
    /// Where it is.
    pub at: Point3,
    /// How far it moves when the input grows by 1, as the derivative says.
    pub by: Vector3,
}

/// How places of the shown geometry move.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The places, those that stand still among them.
    pub arrows: Vec<Arrow>,
    /// Objects whose geometry has another count of places beside where the input stands: what moves there is not told.
    pub left_out: Vec<usize>,
}

/// How places of the geometry of some objects move with the only variable of a prepared definition: points, places at even parameters
/// of curves and surfaces, corners and middles of edges, vertices of meshes. Differences to both sides of where the input stands, to
/// one at the end of its range.
///
/// # Errors
/// The variable has no range or takes whole numbers only, nothing can be solved beside where it stands, or somebody asked to stop.
pub fn motion(prepared: &Prepared, objects: &[usize], cancel: &Cancel) -> Result<Motion, StudyError> {
    let unfit = |why: String| StudyError::Unfit(why);
    let [variable] = prepared.variables() else {
        return Err(unfit("motion is that of one input".to_owned()));
    };
    if variable.step().is_some() {
        return Err(unfit(format!("'{}' takes whole numbers: it cannot be moved evenly", variable.name)));
    }
    let limits = variable.limits().filter(|[min, max]| max > min);
    let ([min, max], Some(at)) = (
        limits.ok_or_else(|| unfit(format!("'{}' has no range of numbers", variable.name)))?,
        variable.stands_at(),
    ) else {
        return Err(unfit(format!("'{}' is no number", variable.name)));
    };
    let mut probe = Probe::new(prepared);
    let nudge = NUDGE * (max - min);
    let sides = [(at - nudge).max(min), (at + nudge).min(max)];
    let mut seen = Vec::with_capacity(3);
    for x in [at, sides[0], sides[1]] {
        probe.set(0, x);
        probe.solve();
        if cancel.is_cancelled() {
            return Err(StudyError::Stopped);
        }
        seen.push(objects.iter().map(|object| places(probe.engine(), *object)).collect::<Vec<_>>());
    }
    let [here, below, above] = seen.as_slice() else { return Err(StudyError::Stopped) };
    let over = sides[1] - sides[0];
    let mut found = Motion { arrows: Vec::new(), left_out: Vec::new() };
    for (object, ((here, below), above)) in objects.iter().zip(here.iter().zip(below).zip(above)) {
        if here.len() != below.len() || here.len() != above.len() {
            found.left_out.push(*object);
            continue;
        }
        let arrows = here
            .iter()
            .zip(below.iter().zip(above))
            .map(|(at, (a, b))| Arrow { at: *at, by: (*b - *a) / over });
        found.arrows.extend(arrows.filter(|arrow| arrow.by.length().is_finite()));
    }
    let step = found.arrows.len().div_ceil(MOST_ARROWS).max(1);
    found.arrows = found.arrows.into_iter().step_by(step).collect();
    Ok(found)
}

/// The objects of a document whose geometry is shown.
pub fn shown_objects(document: &Document) -> Vec<usize> {
    let objects = document.objects.iter().enumerate();
    // A panel hands geometry on, but shows it as text.
    objects
        .filter(|(_, o)| katydid_scene::is_shown(o) && o.component != ids::PANEL)
        .map(|(at, _)| at)
        .collect()
}

fn places(engine: &Engine, object: usize) -> Vec<Point3> {
    let mut found = Vec::new();
    let outputs = engine.report(object).map_or(&[][..], |report| &report.outputs);
    for tree in outputs {
        places_of(tree, &mut found);
        if found.len() > MOST_ARROWS {
            break;
        }
    }
    found
}

fn places_of(tree: &Tree, found: &mut Vec<Point3>) {
    for item in tree.branches().flat_map(|branch| branch.iter().collect::<Vec<_>>()).flatten() {
        of_value(&item, found);
        if found.len() > MOST_ARROWS {
            return;
        }
    }
}

/// Parts of 1, ends among them.
fn parts() -> impl Iterator<Item = f64> + Clone {
    (0..=MOTION_PARTS).map(|k| f64::from(k) / f64::from(MOTION_PARTS))
}

fn of_value(value: &Value, found: &mut Vec<Point3>) {
    match value {
        Value::Point(p) => found.push(*p),
        Value::Curve(curve) => {
            let domain = curve.domain();
            found.extend(parts().map(|part| curve.point_at(domain.at(part))));
        }
        Value::Surface(surface) => {
            let [u, v] = [Direction::U, Direction::V].map(|direction| surface.domain(direction));
            found.extend(
                parts()
                    .flat_map(|a| parts().map(move |b| (a, b)))
                    .map(|(a, b)| surface.point_at(u.at(a), v.at(b))),
            );
        }
        Value::Brep(brep) => {
            found.extend(brep.vertices().iter().map(|vertex| vertex.point));
            let edges = (0..brep.edges().len()).filter_map(|edge| brep.edge_as_curve(edge).ok().flatten());
            found.extend(edges.map(|curve| curve.point_at(curve.domain().middle())));
        }
        Value::Mesh(mesh) => {
            let vertices = mesh.vertices();
            found.extend(vertices.iter().step_by(vertices.len().div_ceil(MOST_ARROWS).max(1)));
        }
        // Numbers and words that read as points are not shown.
        Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) => {
            if let Some(curve @ Value::Curve(_)) = cast::value(value, Kind::Curve, &cast::Rules::default()) {
                of_value(&curve, found);
            }
        }
        Value::Box(_) | Value::TwistedBox(_) => {
            if let Some(brep @ Value::Brep(_)) = cast::value(value, Kind::Brep, &cast::Rules::default()) {
                of_value(&brep, found);
            }
        }
        _ => {}
    }
}
