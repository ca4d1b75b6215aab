//! Surface / Util: edges of a Brep rounded or cut off.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::Brep;
use katydid_geometry::brep::{FilletBlend, FilletRail};

use super::warning;

/// Rounds edges of a Brep, or cuts them off.
///
/// A ball rolls along each edge, inside where the edge is convex and outside where it is concave; the faces are cut back
/// to where it touches them. An edge that runs on smoothly into others is rounded together with them. Where three edges
/// meet that are not all convex or all concave, the odd one out is rounded first and the two others run on round its end;
/// where three have different radii, the largest come first. Without edges or radii the shape stays as it is.
///
/// A warning that names the edge or vertex says what there is no room for and what is not supported yet; there is no
/// result then: seams, four or more edges at a vertex that no one ball touches, different radii along one smooth chain, and
/// corners of three edges blended with their curvature.
#[component(
    "4b87eb13-f87c-4ff1-ae0e-6c9f1f2aecbd",
    name = "Fillet Edge",
    nick = "FilEdge",
    at = "Surface/Util"
)]
#[output("Result", "B", "The shape with its edges rounded.", kind = Brep)]
fn fillet_edge(
    context: &Context<'_>,
    /// The shape.
    #[port("Shape", "S")]
    shape: Shared<Brep>,
    /// What takes the place of an edge: 0 a flat chamfer, 1 an arc, 2 a curve that meets both faces with their curvature.
    #[port("Blend", "B", default = 1)]
    blend: i32,
    /// What a radius measures: 0 how far from the edge the faces are cut, 1 the radius of the ball, 2 the distance
    /// between the two cuts.
    #[port("Metric", "M", default = 0)]
    metric: i32,
    /// The numbers of the edges, as Convex Edges and Edges from Length give them.
    #[port("Edges", "E", optional)]
    edges: List<i32>,
    /// The radius of each edge in units, greater than 0; the last one is repeated.
    #[port("Radii", "R", optional)]
    radii: List<f64>,
) -> Result<Value, Message> {
    let blend = match blend {
        0 => FilletBlend::Chamfer,
        1 => FilletBlend::Arc,
        2 => FilletBlend::Smooth,
        other => {
            return Err(Message::error(format!(
                "There is no blend {other}: 0 is a chamfer, 1 a fillet, 2 a blend"
            )));
        }
    };
    let rail = match metric {
        0 => FilletRail::DistanceFromEdge,
        1 => FilletRail::RollingBall,
        2 => FilletRail::DistanceBetweenRails,
        other => {
            return Err(Message::error(format!(
                "There is no metric {other}: 0 is the distance from the edge, 1 the radius of the ball, 2 the distance \
                 between the rails"
            )));
        }
    };
    let Some(last) = radii.len().checked_sub(1).filter(|_| !edges.is_empty()) else {
        return Ok(Value::from(shape));
    };
    if edges.len() > shape.edges().len() {
        return Err(Message::warning(format!("The shape has no more than {} edges", shape.edges().len())));
    }
    let mut wanted = Vec::with_capacity(edges.len());
    for (n, edge) in edges.iter().enumerate() {
        let (Some(edge), Some(radius)) = (edge, radii.get(n.min(last))) else { continue };
        let place = usize::try_from(edge);
        wanted.push((place.map_err(|_| Message::warning(format!("There is no edge {edge}")))?, radius));
    }
    context.check()?;
    Ok(Value::from(shape.filleted(&wanted, blend, rail, &context.tolerance()).map_err(warning)?))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Interval, Plane};

    use crate::surface::trial::{breps, mesh_volume};

    fn cube() -> Value {
        let side = Interval::new(0.0, 4.0);
        katydid_geometry::construct::box_brep(&Box3 { plane: Plane::XY, x: side, y: side, z: side })
            .unwrap()
            .into()
    }

    fn trial(blend: i32, metric: i32) -> Trial {
        Trial::of("Fillet Edge").item(cube()).item(blend).item(metric)
    }

    #[test]
    fn edges_and_radii() {
        let gap = 1.0 - PI / 4.0;
        let volume = |trial: Trial| mesh_volume(&breps(trial)[0]);
        let one = volume(trial(1, 0).list([3]).list([1.0]));
        assert!((one - (64.0 - 4.0 * gap)).abs() < 2e-2, "{one}");
        let flat = volume(trial(0, 2).list([3]).list([2.0]));
        assert!((flat - (64.0 - 4.0)).abs() < 1e-9, "{flat}");
        let all: Vec<i32> = (0..12).collect();
        let ball = volume(trial(1, 1).list(all).list([1.0]));
        assert!((ball - (8.0 + 24.0 + 6.0 * PI + 4.0 / 3.0 * PI)).abs() < 5e-2, "{ball}");
    }

    #[test]
    fn every_edge_of_a_bracket() {
        use katydid_geometry::{Curve, Point3, PolylineCurve, Tolerance, Vector3, construct};
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0), (0.0, 0.0)];
        let points = corners.iter().map(|(x, y)| Point3::new(*x, *y, 0.0)).collect();
        let outline: Curve = PolylineCurve::new(points).unwrap().into();
        let fine = Tolerance { absolute: 1e-3, angle: 0.01 };
        let bracket = construct::extrude(&outline, Vector3::Z * 3.0, true, &fine).unwrap();
        let all: Vec<i32> = (0..18).collect();
        let trial = Trial::of("Fillet Edge").item(Value::from(bracket)).item(1).item(1);
        let made = breps(trial.list(all).list([0.5]));
        assert!(made[0].is_solid() && made[0].faces().len() == 38);
    }

    #[test]
    fn nothing_to_round_and_what_cannot_be() {
        let same = breps(Trial::of("Fillet Edge").item(cube()));
        assert_eq!(same[0].faces().len(), 6);
        let same = breps(trial(1, 0).list([2]));
        assert_eq!(same[0].faces().len(), 6);
        let says = |trial: Trial, words: &str| assert!(trial.message().contains(words));
        says(trial(1, 0).list([12]).list([1.0]), "edge 12");
        says(trial(1, 0).list([-1]).list([1.0]), "-1");
        says(trial(1, 0).list([0]).list([0.0]), "edge 0");
        says(trial(1, 0).list([0]).list([9.0]), "too large");
        says(trial(3, 0).list([0]).list([1.0]), "blend");
        says(trial(1, 3).list([0]).list([1.0]), "metric");
    }
}
