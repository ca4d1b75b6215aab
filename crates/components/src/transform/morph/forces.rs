//! Deformations by pushes at points.

use std::cell::RefCell;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Value};
use katydid_expression::Variant;
use katydid_geometry::morph::{Forces, Morph};
use katydid_geometry::{CancellationToken, Error, Point3, Vector3};

use super::{Manner, morphed, paired};
use crate::maths::formula::Formula;

/// Pushes geometry by forces at points.
///
/// Every point moves by the sum of the forces, each divided by 1 + d², d being its distance from the force's point: the
/// whole force at that point, half of it at a distance of 1. Where there are fewer forces than points the last one
/// serves for the rest.
#[component(
    "66e6596f-6c8f-4ac3-99e0-0c4b7a59a7f7",
    name = "Spatial Deform",
    nick = "Deform",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The pushed geometry.")]
fn spatial_deform(
    context: &Context<'_>,
    /// What to push.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// Where the forces act.
    #[port("Syntax", "S")]
    syntax: List<Point3>,
    /// The forces: how far and where to the points are pushed.
    #[port("Forces", "F")]
    forces: List<Vector3>,
) -> Result<Geometry, Message> {
    let forces = paired(syntax.iter(), forces.iter());
    morphed(context, &geometry, &Forces::new(&forces, |d| 1.0 / (1.0 + d * d)), Manner::Bent)
}

/// Pushes geometry by forces at points, with a falloff of one's own.
///
/// Every point moves by the sum of the forces, each times the value of the formula at x, its distance from the force's
/// point. A formula that gives no number somewhere is an error.
#[component(
    "331b74f1-1f1f-4f37-b253-24fcdada29e3",
    name = "Spatial Deform (custom)",
    nick = "Deform",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The pushed geometry.")]
fn spatial_deform_custom(
    context: &Context<'_>,
    /// What to push.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// Where the forces act.
    #[port("Syntax", "S")]
    syntax: List<Point3>,
    /// The forces: how far and where to the points are pushed.
    #[port("Forces", "F")]
    forces: List<Vector3>,
    /// The falloff as a formula of the distance x, for example `1/(1+x)`.
    #[port("Falloff", "f")]
    falloff: Shared<str>,
) -> Result<Geometry, Message> {
    let formula = Formula::new(&falloff, &["x"])?;
    // The kernel only knows that there was no number; what the formula said of it is told here.
    let said = RefCell::new(None);
    let value = |d: f64| match formula.evaluate(&[Variant::Number(d)]) {
        Ok(Some(Value::Number(x))) => x,
        Ok(Some(Value::Integer(i))) => f64::from(i),
        Ok(_) => f64::NAN,
        Err(message) => {
            said.borrow_mut().get_or_insert(message);
            f64::NAN
        }
    };
    let forces = paired(syntax.iter(), forces.iter());
    let image = morphed(context, &geometry, &Forces::new(&forces, value), Manner::Bent);
    match said.take() {
        Some(message) => Err(message),
        None => image,
    }
}

/// Moves those points that are in given places, and nothing else.
struct Grips<'a> {
    moves: &'a [(Point3, Vector3)],
    reach: f64,
}

impl Morph for Grips<'_> {
    fn image(&self, p: Point3) -> Result<Point3, Error> {
        if CancellationToken::is_over() {
            return Err(Error::Stopped);
        }
        let grip = self.moves.iter().find(|(q, _)| q.distance_to(p) <= self.reach);
        let image = grip.map_or(p, |(_, by)| p + *by);
        if image.is_finite() { Ok(image) } else { Err(Error::NotFinite("moved point")) }
    }
}

/// Moves single control points of curves and surfaces, and vertices of meshes.
///
/// Those within the tolerance of a given point are moved; all others stay. Where there are fewer motions than points the
/// last one serves for the rest.
#[component(
    "4dbd15c7-ebcb-4af6-b3bd-32e80502520c",
    name = "Point Deform",
    nick = "PDeform",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The geometry with its points moved.")]
fn point_deform(
    context: &Context<'_>,
    /// What to change.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The places of the points to move.
    #[port("Points", "P")]
    points: List<Point3>,
    /// How far and where to each is moved.
    #[port("Motion", "M")]
    motion: List<Vector3>,
) -> Result<Geometry, Message> {
    let moves = paired(points.iter(), motion.iter());
    let grips = Grips { moves: &moves, reach: context.tolerance().absolute };
    morphed(context, &geometry, &grips, Manner::Controls)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Curve, PolylineCurve};

    use super::*;

    #[test]
    fn forces_fall_off() {
        let up = Vector3::new(0.0, 0.0, 4.0);
        let at = |x: f64| Trial::of("Spatial Deform").item(Point3::new(x, 0.0, 0.0));
        assert_eq!(at(0.0).list([Point3::ORIGIN]).list([up]).texts(0), ["{0}: {0, 0, 4}"]);
        assert_eq!(at(1.0).list([Point3::ORIGIN]).list([up]).texts(0), ["{0}: {1, 0, 2}"]);
        let custom = |f: &str| {
            let trial = Trial::of("Spatial Deform (custom)").item(Point3::new(1.0, 0.0, 0.0));
            trial.list([Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)]).list([up]).item(f)
        };
        assert_eq!(custom("1-x").texts(0), ["{0}: {1, 0, 4}"]);
        assert!(!custom("1-").message().is_empty());
        assert!(!custom("1/x").message().is_empty());
    }

    #[test]
    fn only_named_points_move() {
        let corner = Point3::new(1.0, 0.0, 0.0);
        let points = vec![Point3::ORIGIN, corner, Point3::new(1.0, 1.0, 0.0)];
        let polyline: Curve = PolylineCurve::new(points).unwrap().into();
        let trial =
            Trial::of("Point Deform").item(polyline).list([corner]).list([Vector3::new(0.0, 0.0, 2.0)]);
        let Some(Value::Curve(image)) = trial.run().outputs.first().unwrap().column().get(0) else {
            panic!("a curve")
        };
        let Curve::Polyline(image) = &*image else { panic!("a polyline") };
        assert_eq!(image.points()[1], Point3::new(1.0, 0.0, 2.0));
        assert_eq!(image.points()[2], Point3::new(1.0, 1.0, 0.0));
    }
}
