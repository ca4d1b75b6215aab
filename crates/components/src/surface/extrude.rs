//! Surface / Freeform: extrusions. A closed profile gives an open surface, as it does in Grasshopper: its ends are
//! not capped. A surface gives a solid.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::{Brep, Curve, Line, Plane, Point3, Vector3, Xform, construct};

use super::warning;

/// What is extruded.
enum Base {
    /// A curve, which gives a surface.
    Curve(Shared<Curve>),
    /// Faces, which give a solid.
    Faces(Shared<Brep>),
}

impl Base {
    fn of(context: &Context<'_>, geometry: &Geometry) -> Result<Self, Message> {
        // What has faces is drawn out as such, and not its border, which it would be as a curve.
        let shape = cast::value(&geometry.0, Kind::Geometry, context.rules());
        let has_faces = shape.is_some_and(|shape| shape.brep().is_some());
        if !has_faces
            && let Some(Value::Curve(curve)) = cast::value(&geometry.0, Kind::Curve, context.rules())
        {
            return Ok(Self::Curve(curve));
        }
        let faces = cast::value(&geometry.0, Kind::Brep, context.rules()).and_then(|value| value.brep());
        let faces = faces.transpose().map_err(Message::warning)?;
        let faces = faces.ok_or_else(|| {
            Message::error(format!("A {} cannot be extruded, only curves and surfaces", geometry.0.kind()))
        })?;
        if faces.naked_edges().is_empty() {
            return Err(Message::error("A closed Brep cannot be extruded: it has no open edges"));
        }
        Ok(Self::Faces(faces))
    }

    fn transformed(self, xform: &Xform) -> Result<Self, Message> {
        Ok(match self {
            Self::Curve(curve) => Self::Curve(Shared::new(curve.transformed(xform).map_err(warning)?)),
            Self::Faces(brep) => Self::Faces(Shared::new(brep.transformed(xform).map_err(warning)?)),
        })
    }

    fn extruded(&self, context: &Context<'_>, direction: Vector3) -> Result<Value, Message> {
        let tolerance = context.tolerance();
        let made = match self {
            Self::Curve(curve) => construct::extrude(curve, direction, false, &tolerance),
            Self::Faces(brep) => construct::extrude_brep(brep, direction, &tolerance),
        };
        Ok(Value::from(made.map_err(warning)?))
    }
}

/// Moves a curve or a surface along a vector and gives what it sweeps.
///
/// A curve gives a surface, with a face for each stretch without a kink; closed curves are not capped. A surface gives
/// a solid.
#[component("962034e9-cc27-4394-afc4-5c16e3447cf9", name = "Extrude", nick = "Extr", at = "Surface/Freeform")]
#[output("Extrusion", "E", "The surface or solid: u runs along the curve, v along the vector by length.", kind = Brep)]
fn extrude(
    context: &Context<'_>,
    /// The curve or surface.
    #[port("Base", "B")]
    base: Geometry,
    /// In which direction and how far; not 0.
    #[port("Direction", "D")]
    direction: Vector3,
) -> Result<Value, Message> {
    Base::of(context, &base)?.extruded(context, direction)
}

/// Brings a curve or a surface from one plane to another, moves it along a line from there, and gives what it sweeps.
///
/// A curve gives a surface, closed curves are not capped; a surface gives a solid.
#[component(
    "8efd5eb9-a896-486e-9f98-d8d1a07a49f3",
    name = "Extrude Linear",
    nick = "Extrude",
    at = "Surface/Freeform"
)]
#[output("Extrusion", "E", "The surface or solid: u runs along the curve, v along the line by length.", kind = Brep)]
fn extrude_linear(
    context: &Context<'_>,
    /// The curve or surface.
    #[port("Profile", "P")]
    base: Geometry,
    /// The plane that the profile is seen in.
    #[port("Orientation (P)", "Po", default = Plane::XY)]
    from: Plane,
    /// The line along which the profile is moved.
    #[port("Axis", "A", default = Line::new(Point3::new(10.0, 0.0, 0.0), Point3::new(10.0, 0.0, 1.0)))]
    axis: Line,
    /// The plane to which the profile is brought; without it the one square to the line at its start.
    #[port("Orientation (A)", "Ao")]
    to: Option<Plane>,
) -> Result<Value, Message> {
    let to = match to {
        Some(plane) => plane,
        None => Plane::from_normal(axis.from, axis.direction()).map_err(warning)?,
    };
    let base = Base::of(context, &base)?.transformed(&Xform::plane_to_plane(&from, &to))?;
    base.extruded(context, axis.direction())
}

/// Straight lines from all points of a curve, or of the edges of a surface, to a tip.
///
/// A curve gives a surface, closed curves are not capped; a surface gives a solid.
#[component(
    "be6636b2-2f1a-4d42-897b-fdef429b6f17",
    name = "Extrude Point",
    nick = "Extr",
    at = "Surface/Freeform"
)]
#[output("Extrusion", "E", "The surface or solid: u runs along the curve, v from it, at 0, to the tip, at 1.", kind = Brep)]
fn extrude_point(
    context: &Context<'_>,
    /// The curve or surface.
    #[port("Base", "B")]
    base: Geometry,
    /// The tip.
    #[port("Point", "P")]
    tip: Point3,
) -> Result<Value, Message> {
    let tolerance = context.tolerance();
    let made = match Base::of(context, &base)? {
        Base::Curve(curve) => construct::extrude_to_point(&curve, tip, false, &tolerance),
        Base::Faces(brep) => construct::extrude_brep_to_point(&brep, tip, &tolerance),
    };
    Ok(Value::from(made.map_err(warning)?))
}

/// Moves a curve or a surface along a curve without turning it, and gives what it sweeps.
///
/// It stays where it is at the start of the other. A curve gives a surface, closed curves are not capped; a surface
/// gives a solid.
#[component(
    "38a5638b-6d01-4417-bf11-976d925f8a71",
    name = "Extrude Along",
    nick = "ExtrCrv",
    at = "Surface/Freeform"
)]
#[output("Extrusion", "E", "The surface or solid: u runs along the base, v along the curve.", kind = Brep)]
fn extrude_along(
    context: &Context<'_>,
    /// The curve or surface that is moved.
    #[port("Base", "B")]
    base: Geometry,
    /// The curve along which it is moved.
    #[port("Curve", "C")]
    along: &Curve,
) -> Result<Value, Message> {
    let tolerance = context.tolerance();
    let made = match Base::of(context, &base)? {
        Base::Curve(curve) => construct::extrude_along(&curve, along, false, &tolerance),
        Base::Faces(brep) => construct::extrude_brep_along(&brep, along, &tolerance),
    };
    Ok(Value::from(made.map_err(warning)?))
}

/// The solid between two heights over a flat closed polyline, whose sides lean inwards.
///
/// The polyline is its section at height 0; heights count along the normal about which it runs counter-clockwise. Sides
/// may meet at the top, not below it: roofs are not supported.
#[component(
    "ae57e09b-a1e4-4d05-8491-abd232213bc9",
    name = "Extrude Angled",
    nick = "ExtrAng",
    at = "Surface/Freeform"
)]
#[output("Shape", "S", "The solid.", kind = Brep)]
fn extrude_angled(
    context: &Context<'_>,
    /// The polyline.
    #[port("Polyline", "P")]
    polyline: &Curve,
    /// The height of the bottom.
    #[port("Base height", "Hb", default = 0.0)]
    base: f64,
    /// The height of the top.
    #[port("Top height", "Ht", default = 1.0)]
    top: f64,
    /// How far the sides lean inwards, in radians from upright, one for each segment; the last one counts for the
    /// rest.
    #[port("Angles", "A", default = 0.0)]
    angles: List<f64>,
) -> Result<Value, Message> {
    let corners = polyline.as_polyline().ok_or_else(|| Message::warning("The curve is not a polyline"))?;
    if !polyline.is_closed() {
        return Err(Message::warning("The polyline is open"));
    }
    let angles: Vec<f64> = angles.present().collect();
    let made = construct::extrude_angled(&corners, [base, top], &angles, &context.tolerance());
    Ok(Value::from(made.map_err(warning)?))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{
        Box3, Circle, Direction, Interval, Line, Plane, Point3, Rectangle, Surface, Vector3,
    };

    use crate::surface::trial::{breps, mesh_volume};

    #[test]
    fn surfaces_give_solids() {
        let rings = [2.0, 1.0].map(|radius| Circle { plane: Plane::XY, radius });
        let ring = Trial::of("Boundary Surfaces").list(rings).run().outputs[0].column().get(0).unwrap();
        let up = Vector3::new(0.0, 0.0, 3.0);
        let solid = &breps(Trial::of("Extrude").item(ring.clone()).item(up))[0];
        assert!(solid.is_solid());
        assert!((mesh_volume(solid) - 9.0 * PI).abs() < 1e-2);
        let tip = Point3::new(0.0, 0.0, 3.0);
        let solid = &breps(Trial::of("Extrude Point").item(ring.clone()).item(tip))[0];
        assert!((mesh_volume(solid) - 3.0 * PI).abs() < 1e-2);
        let rail = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 2.0));
        let solid = &breps(Trial::of("Extrude Along").item(ring).item(rail))[0];
        assert!((mesh_volume(solid) - 6.0 * PI).abs() < 1e-2);
        let square = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
        let walls = &breps(Trial::of("Extrude").item(square).item(up))[0];
        assert_eq!((walls.faces().len(), walls.is_solid()), (4, false));
    }

    #[test]
    fn sides_that_lean() {
        let square = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 2.0), y: Interval::new(0.0, 2.0) };
        let leaning = |angle: f64| Trial::of("Extrude Angled").item(square).item(0.0).item(1.0).list([angle]);
        assert!((mesh_volume(&breps(leaning(0.0))[0]) - 4.0).abs() < 1e-9);
        assert!((mesh_volume(&breps(leaning(0.5_f64.atan()))[0]) - 7.0 / 3.0).abs() < 1e-9);
        assert!(leaning(1.2).message().contains("meet"));
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        assert!(Trial::of("Extrude Angled").item(circle).message().contains("not a polyline"));
    }

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
        assert!(Trial::of("Extrude").item(b).item(Vector3::Z).message().contains("closed Brep"));
        assert!(Trial::of("Extrude").item(Point3::ORIGIN).item(Vector3::Z).message().contains("Point"));

        let linear = surface(Trial::of("Extrude Linear").item(circle));
        assert!(linear.point_at(0.0, 1.0).distance_to(Point3::new(11.0, 0.0, 1.0)) < 1e-15);
        let cone = surface(Trial::of("Extrude Point").item(circle).item(Point3::new(0.0, 0.0, 1.0)));
        assert!((cone.area().unwrap().area - PI * 2f64.sqrt()).abs() < 1e-8);
        let rail = Line::new(Point3::new(5.0, 5.0, 5.0), Point3::new(5.0, 5.0, 7.0));
        let along = surface(Trial::of("Extrude Along").item(circle).item(rail));
        assert!(along.point_at(0.0, 1.0).distance_to(Point3::new(1.0, 0.0, 2.0)) < 1e-15);
    }
}
