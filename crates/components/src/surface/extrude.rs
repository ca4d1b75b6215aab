//! Surface / Freeform: extrusions. A closed profile gives an open surface, as it does in Grasshopper: its ends are
//! not capped.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::{Curve, Line, NurbsSurface, Plane, Point3, SumSurface, Surface, Vector3, Xform};

use super::{shared, warning};

/// The curve that is extruded.
fn profile(context: &Context<'_>, geometry: &Geometry) -> Result<Curve, Message> {
    match cast::value(&geometry.0, Kind::Curve, context.rules()) {
        Some(Value::Curve(curve)) => Ok((*curve).clone()),
        _ => Err(Message::error(format!("A {} cannot be extruded yet, only curves", geometry.0.kind()))),
    }
}

fn extruded(curve: Curve, direction: Vector3) -> Result<Shared<Surface>, Message> {
    Ok(shared(SumSurface::extrusion(curve, direction).map_err(warning)?))
}

/// Moves a curve along a vector and gives the surface that it sweeps.
///
/// Closed curves are not capped. Surfaces, whose extrusion is a solid, cannot be extruded yet.
#[component("962034e9-cc27-4394-afc4-5c16e3447cf9", name = "Extrude", nick = "Extr", at = "Surface/Freeform")]
#[output("Extrusion", "E", "The surface: u runs along the curve, v along the vector by length.", kind = Brep)]
fn extrude(
    context: &Context<'_>,
    /// The curve.
    #[port("Base", "B")]
    base: Geometry,
    /// In which direction and how far; not 0.
    #[port("Direction", "D")]
    direction: Vector3,
) -> Result<Shared<Surface>, Message> {
    extruded(profile(context, &base)?, direction)
}

/// Brings a curve from one plane to another, moves it along a line from there, and gives the surface that it sweeps.
///
/// Closed curves are not capped. Surfaces cannot be extruded yet.
#[component(
    "8efd5eb9-a896-486e-9f98-d8d1a07a49f3",
    name = "Extrude Linear",
    nick = "Extrude",
    at = "Surface/Freeform"
)]
#[output("Extrusion", "E", "The surface: u runs along the curve, v along the line by length.", kind = Brep)]
fn extrude_linear(
    context: &Context<'_>,
    /// The curve.
    #[port("Profile", "P")]
    base: Geometry,
    /// The plane that the curve is seen in.
    #[port("Orientation (P)", "Po", default = Plane::XY)]
    from: Plane,
    /// The line along which the curve is moved.
    #[port("Axis", "A", default = Line::new(Point3::new(10.0, 0.0, 0.0), Point3::new(10.0, 0.0, 1.0)))]
    axis: Line,
    /// The plane to which the curve is brought; without it the one square to the line at its start.
    #[port("Orientation (A)", "Ao")]
    to: Option<Plane>,
) -> Result<Shared<Surface>, Message> {
    let to = match to {
        Some(plane) => plane,
        None => Plane::from_normal(axis.from, axis.direction()).map_err(warning)?,
    };
    let curve = profile(context, &base)?.transformed(&Xform::plane_to_plane(&from, &to)).map_err(warning)?;
    extruded(curve, axis.direction())
}

/// Straight lines from all points of a curve to a tip.
///
/// Closed curves are not capped. Surfaces cannot be extruded yet.
#[component(
    "be6636b2-2f1a-4d42-897b-fdef429b6f17",
    name = "Extrude Point",
    nick = "Extr",
    at = "Surface/Freeform"
)]
#[output("Extrusion", "E", "The surface: u runs along the curve, v from it, at 0, to the tip, at 1.", kind = Brep)]
fn extrude_point(
    context: &Context<'_>,
    /// The curve.
    #[port("Base", "B")]
    base: Geometry,
    /// The tip.
    #[port("Point", "P")]
    tip: Point3,
) -> Result<Shared<Surface>, Message> {
    let curve = profile(context, &base)?.to_nurbs().map_err(warning)?;
    Ok(shared(NurbsSurface::to_apex(&curve, tip).map_err(warning)?))
}

/// Moves a curve along another one without turning it, and gives the surface that it sweeps.
///
/// The curve stays where it is at the start of the other. Closed curves are not capped. Surfaces cannot be extruded
/// yet.
#[component(
    "38a5638b-6d01-4417-bf11-976d925f8a71",
    name = "Extrude Along",
    nick = "ExtrCrv",
    at = "Surface/Freeform"
)]
#[output("Extrusion", "E", "The surface: u runs along the base, v along the curve.", kind = Brep)]
fn extrude_along(
    context: &Context<'_>,
    /// The curve that is moved.
    #[port("Base", "B")]
    base: Geometry,
    /// The curve along which it is moved.
    #[port("Curve", "C")]
    along: &Curve,
) -> Result<Shared<Surface>, Message> {
    let back = -along.start().to_vector();
    let sum = SumSurface::new(profile(context, &base)?, along.clone(), back);
    Ok(shared(sum.map_err(warning)?))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Circle, Direction, Interval, Line, Plane, Point3, Surface, Vector3};

    fn surface(trial: Trial) -> Surface {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Surface(surface)) => (*surface).clone(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn extrusions() {
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let tube = surface(Trial::of("Extrude").item(circle).item(Vector3::new(0.0, 0.0, 3.0)));
        assert_eq!(tube.domain(Direction::U), Interval::new(0.0, TAU));
        assert_eq!(tube.domain(Direction::V), Interval::new(0.0, 3.0));
        assert!((tube.area().unwrap().area - 6.0 * PI).abs() < 1e-9);
        assert!(!tube.is_solid());
        assert!(!Trial::of("Extrude").item(circle).item(Vector3::ZERO).message().is_empty());
        let b = Box3 { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT, z: Interval::UNIT };
        assert!(Trial::of("Extrude").item(b).item(Vector3::Z).message().contains("Box"));

        let linear = surface(Trial::of("Extrude Linear").item(circle));
        assert!(linear.point_at(0.0, 1.0).distance_to(Point3::new(11.0, 0.0, 1.0)) < 1e-15);
        let cone = surface(Trial::of("Extrude Point").item(circle).item(Point3::new(0.0, 0.0, 1.0)));
        assert!((cone.area().unwrap().area - PI * 2f64.sqrt()).abs() < 1e-8);
        let rail = Line::new(Point3::new(5.0, 5.0, 5.0), Point3::new(5.0, 5.0, 7.0));
        let along = surface(Trial::of("Extrude Along").item(circle).item(rail));
        assert!(along.point_at(0.0, 2.0).distance_to(Point3::new(1.0, 0.0, 2.0)) < 1e-15);
    }
}
