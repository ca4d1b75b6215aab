//! Surface / Freeform: surfaces inside a frame of curves.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Point3, construct};

use super::warning;

/// A surface whose sides are two, three or four curves.
///
/// The curves may come in any order and direction; between three and four the surface is the Coons patch, between two
/// it is ruled.
#[component(
    "36132830-e2ef-4476-8ea1-6a43922344f0",
    name = "Edge Surface",
    nick = "EdgeSrf",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface.", kind = Brep)]
fn edge_surface(
    context: &Context<'_>,
    /// The first side.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The second side.
    #[port("Curve B", "B")]
    b: &Curve,
    /// The third side; without it and the fourth the surface is ruled.
    #[port("Curve C", "C")]
    c: Option<Shared<Curve>>,
    /// The fourth side; without it the surface has three.
    #[port("Curve D", "D")]
    d: Option<Shared<Curve>>,
) -> Result<Value, Message> {
    let mut sides = vec![a.clone(), b.clone()];
    sides.extend([c, d].into_iter().flatten().map(|side| (*side).clone()));
    Ok(Value::from(construct::edge_surface(&sides, &context.tolerance()).map_err(warning)?))
}

fn curves(list: &List<'_, Shared<Curve>>) -> Vec<Curve> {
    list.present().map(|curve| (*curve).clone()).collect()
}

/// A surface through a net of curves.
///
/// Every curve of one set crosses every curve of the other; within a set they may come in any order and direction. What
/// sticks out beyond the outermost curves is cut off.
#[component(
    "71506fa8-9bf0-432d-b897-b2e0c5ac316c",
    name = "Network Surface",
    nick = "NetSurf",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface: u runs along the first set of curves.", kind = Surface)]
fn network_surface(
    context: &Context<'_>,
    /// Curves in one direction, at least two.
    #[port("Curves U", "U")]
    first: List<Shared<Curve>>,
    /// Curves in the other direction, at least two.
    #[port("Curves V", "V")]
    second: List<Shared<Curve>>,
    /// How the surface meets others: 0 loosely, 1 in place, 2 in tangents, 3 in curvature. Curves say nothing about
    /// other surfaces, so that it makes no difference here.
    #[port("Continuity", "C", default = 2)]
    continuity: i32,
) -> Result<Value, Message> {
    if !(0..=3).contains(&continuity) {
        return Err(Message::error(format!(
            "There is no continuity of type {continuity}: it is from 0 to 3"
        )));
    }
    let (first, second) = (curves(&first), curves(&second));
    if first.len() < 2 || second.len() < 2 {
        return Err(Message::warning("A network needs at least two curves in either direction"));
    }
    context.check()?;
    Ok(Value::from(construct::network_surface(&first, &second, &context.tolerance()).map_err(warning)?))
}

/// A surface near curves and points.
///
/// It is fitted over the plane that lies nearest to all of them, so that it does not follow what folds back over
/// itself, and it does not go through them exactly.
#[component("57b2184c-8931-4e70-9220-612ec5b3809a", name = "Patch", nick = "Patch", at = "Surface/Freeform")]
#[output("Patch", "P", "The surface.", kind = Surface)]
fn patch(
    context: &Context<'_>,
    /// The curves.
    #[port("Curves", "C", optional)]
    lines: List<Shared<Curve>>,
    /// The points.
    #[port("Points", "P", optional)]
    points: List<Point3>,
    /// How many spans the surface has in either direction, from 1 to 100.
    #[port("Spans", "S", default = 20)]
    spans: i32,
    /// How willingly it bends: 0.1 a tenth as willingly as 1.
    #[port("Flexibility", "F", default = 1.0)]
    flexibility: f64,
    /// Whether it ends where the outermost closed curve is.
    #[port("Trim", "T", default = true)]
    trim: bool,
) -> Result<Value, Message> {
    let (lines, points): (Vec<Curve>, Vec<Point3>) = (curves(&lines), points.present().collect());
    let spans = usize::try_from(spans).ok().filter(|n| (1..=100).contains(n));
    let spans = spans.ok_or_else(|| Message::error("The number of spans is from 1 to 100"))?;
    let control_points = (spans + 3).saturating_mul(spans + 3);
    context.bytes(control_points.saturating_mul(9 * 8 * (spans + 4)))?;
    let options = construct::PatchOptions { spans: [spans; 2], flexibility, trimmed: trim };
    Ok(Value::from(construct::patch(&lines, &points, &options, &context.tolerance()).map_err(warning)?))
}

/// Flat faces that fill a closed polyline, which need not be flat itself.
///
/// They are the triangles between its corners whose areas together are least; those in one plane are one face.
#[component(
    "cb56b26c-2595-4d03-bdb2-eb2e6aeba82d",
    name = "Fragment Patch",
    nick = "FPatch",
    at = "Surface/Freeform"
)]
#[output("Patch", "P", "The faces, joined.", kind = Brep)]
fn fragment_patch(
    context: &Context<'_>,
    /// The polyline.
    #[port("Boundary", "B")]
    boundary: &Curve,
) -> Result<Value, Message> {
    let corners = boundary.as_polyline().ok_or_else(|| Message::warning("The boundary is not a polyline"))?;
    if !boundary.is_closed() {
        return Err(Message::warning("The boundary is open"));
    }
    Ok(Value::from(construct::fragment_patch(&corners, &context.tolerance()).map_err(warning)?))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    use crate::surface::trial::{breps, mesh_area};

    #[test]
    fn frames_of_lines() {
        let p = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let sides = [
            Line::new(p(0.0, 0.0), p(4.0, 0.0)),
            Line::new(p(0.0, 3.0), p(4.0, 3.0)),
            Line::new(p(4.0, 3.0), p(4.0, 0.0)),
            Line::new(p(0.0, 0.0), p(0.0, 3.0)),
        ];
        let quad = Trial::of("Edge Surface").item(sides[0]).item(sides[1]).item(sides[2]).item(sides[3]);
        assert!((mesh_area(&breps(quad)[0]) - 12.0).abs() < 1e-9);
        let ruled = Trial::of("Edge Surface").item(sides[0]).item(sides[1]);
        assert!((mesh_area(&breps(ruled)[0]) - 12.0).abs() < 1e-9);
        let third = Line::new(p(4.0, 0.0), p(0.0, 3.0));
        let triangle = Trial::of("Edge Surface").item(sides[0]).item(third).item(sides[3]);
        assert!((mesh_area(&breps(triangle)[0]) - 6.0).abs() < 1e-9);
        let apart = Trial::of("Edge Surface").item(sides[0]).item(sides[1]).item(sides[2]);
        assert!(apart.message().contains("end to end"));
    }

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    #[test]
    fn nets_of_lines() {
        let along = [0.0, 1.0, 2.0].map(|y| Line::new(p(-1.0, y, 0.0), p(5.0, y, 0.0)));
        let across = [0.0, 4.0].map(|x| Line::new(p(x, 0.0, 0.0), p(x, 2.0, 0.0)));
        let net = breps(Trial::of("Network Surface").list(along).list(across));
        assert!((mesh_area(&net[0]) - 8.0).abs() < 1e-6);
        assert!(Trial::of("Network Surface").list(along).list([across[0]]).message().contains("two curves"));
        assert!(Trial::of("Network Surface").list(along).list(across).item(4).message().contains("type 4"));
        let apart = [0.0, 4.0].map(|x| Line::new(p(x, 0.0, 9.0), p(x, 2.0, 9.0)));
        assert!(Trial::of("Network Surface").list(along).list(apart).message().contains("cross"));
    }

    #[test]
    fn patches() {
        let ring = Circle { plane: Plane::XY, radius: 1.0 };
        let disc = breps(Trial::of("Patch").list([ring]).default());
        assert!((mesh_area(&disc[0]) - std::f64::consts::PI).abs() < 1e-2);
        let whole = Trial::of("Patch").list([ring]).default().item(5).item(1.0).item(false);
        assert_eq!(whole.texts(0), ["{0}: Untrimmed Surface"]);
        assert!(Trial::of("Patch").list([ring]).default().item(0).message().contains("1 to 100"));
        assert!(!Trial::of("Patch").default().list([p(0.0, 0.0, 0.0)]).message().is_empty());
    }

    #[test]
    fn fragments() {
        let corners =
            [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 1.0), p(0.0, 1.0, 0.0), p(0.0, 0.0, 0.0)];
        let frame: Curve = PolylineCurve::new(corners.to_vec()).unwrap().into();
        assert_eq!(breps(Trial::of("Fragment Patch").item(frame))[0].faces().len(), 2);
        let ring = Circle { plane: Plane::XY, radius: 1.0 };
        assert!(Trial::of("Fragment Patch").item(ring).message().contains("not a polyline"));
    }
}
