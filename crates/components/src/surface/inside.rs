//! Surface / Analysis: what lies in Breps and near them.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::{Brep, Containment, Point3, PolylineLimits, Vector3};

use super::warning;
use crate::prepared;

/// The point of a Brep that is nearest to a point, on a face or an edge.
#[component(
    "4beead95-8aa2-4613-8bb9-24758a0f5c4c",
    name = "Brep Closest Point",
    nick = "Brep CP",
    at = "Surface/Analysis"
)]
#[output("Point", "P", "The nearest point of the Brep.")]
#[output("Normal", "N", "The normal there; on an edge that of one of its faces.")]
#[output("Distance", "D", "How far away it is.")]
fn brep_closest_point(
    context: &Context<'_>,
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Point3, Option<Vector3>, f64), Message> {
    let near = prepared::brep(context, &brep)?.nearest(point).map_err(warning)?;
    Ok((near.point, near.normal, near.distance))
}

/// The point of a Brep that is nearest to a point.
#[component(
    "cdd5d441-3bad-4f19-a370-6cf180b6f0fa",
    name = "Brep Closest Point",
    nick = "Brep CP",
    at = "Surface/Analysis",
    old
)]
#[output("Point", "P", "The nearest point of the Brep.")]
#[output("Distance", "D", "How far away it is.")]
fn brep_closest_point_only(
    context: &Context<'_>,
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Point3, f64), Message> {
    let near = prepared::brep(context, &brep)?.nearest(point).map_err(warning)?;
    Ok((near.point, near.distance))
}

/// Where a point lies in a Brep; an open one has no inside.
fn place(context: &Context<'_>, brep: &Shared<Brep>, point: Point3) -> Result<Containment, Message> {
    prepared::brep(context, brep)?.contains(point, context.tolerance().absolute).map_err(warning)
}

fn counts(found: Containment, strict: bool) -> bool {
    match found {
        Containment::Inside => true,
        Containment::On => !strict,
        Containment::Outside => false,
    }
}

/// Whether a point lies in a closed Brep. An open one has no inside: a warning.
#[component(
    "e03561f8-0e66-41d3-afde-62049f152443",
    name = "Point In Brep",
    nick = "BrepInc",
    at = "Surface/Analysis"
)]
#[output("Inside", "I", "Whether it does.")]
fn point_in_brep(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// Whether points within the tolerance of a face are out.
    #[port("Strict", "S", default = false)]
    strict: bool,
) -> Result<bool, Message> {
    Ok(counts(place(context, &brep, point)?, strict))
}

/// Whether a point lies in one of several closed Breps, and in which. Open ones have no inside: a warning.
#[component(
    "859daa86-3ab7-49cb-9eda-f2811c984070",
    name = "Point In Breps",
    nick = "BrepsInc",
    at = "Surface/Analysis"
)]
#[output("Inside", "I", "Whether it does.")]
#[output("Index", "i", "The place of the first Brep that it lies in; −1 for none.")]
fn point_in_breps(
    context: &Context<'_>,
    /// The Breps.
    #[port("Brep", "B")]
    breps: List<Shared<Brep>>,
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// Whether points within the tolerance of a face are out.
    #[port("Strict", "S", default = false)]
    strict: bool,
) -> Result<(bool, i32), Message> {
    for (k, brep) in breps.iter().enumerate() {
        context.check()?;
        let Some(brep) = brep else { continue };
        if !brep.is_solid() {
            context.warn("A Brep is not closed, and has no inside");
            continue;
        }
        if counts(place(context, &brep, point)?, strict) {
            return Ok((true, i32::try_from(k).unwrap_or(i32::MAX)));
        }
    }
    Ok((false, -1))
}

/// Points that tell where a shape lies; for curves, meshes and Breps those of their polylines, corners and edges.
fn samples(context: &Context<'_>, shape: &Value, depth: usize) -> Result<Vec<Point3>, Message> {
    const DEEPEST: usize = 100;
    let along = |curve: &katydid_geometry::Curve| -> Result<Vec<Point3>, Message> {
        let limits = PolylineLimits::within(10.0 * context.tolerance().absolute);
        let line = curve.to_polyline(&limits).map_err(warning)?;
        let points = line.points();
        let middles = points.windows(2).map(|w| w[0].lerp(w[1], 0.5));
        Ok(points.iter().copied().chain(middles).collect())
    };
    match shape {
        Value::Point(p) => Ok(vec![*p]),
        Value::Mesh(mesh) => Ok(mesh.vertices().iter().copied().chain(mesh.face_centers()).collect()),
        Value::Brep(_) | Value::Surface(_) | Value::Box(_) | Value::Kept(_) => {
            let brep =
                shape.brep().ok_or_else(|| Message::warning("It has no faces"))?.map_err(Message::warning)?;
            let size = brep.bounds_of_faces().map_or(1.0, |b| b.diagonal().length());
            let settings = katydid_geometry::MeshSettings::within(1e-2 * size);
            let mesh = brep.mesh_unless(&settings, &context.stop()).and_then(|m| m.to_mesh());
            samples(context, &Value::from(mesh.map_err(warning)?), depth + 1)
        }
        Value::Group(group) if depth < DEEPEST => {
            let mut all = Vec::new();
            for member in group.members.iter().flatten() {
                all.extend(samples(context, member, depth + 1)?);
            }
            Ok(all)
        }
        other => match cast::value(other, Kind::Curve, context.rules()) {
            Some(Value::Curve(curve)) => along(&curve),
            _ => Err(Message::warning(format!("Whether a {} lies in a Brep is not known", other.kind()))),
        },
    }
}

/// How a shape lies to a closed Brep.
///
/// It is judged by points of the shape: those of curves, and those of meshes of the others. What only the thinnest part
/// of a shape does may be missed.
#[component(
    "2ba64356-be21-4c12-bbd4-ced54f04c8ef",
    name = "Shape In Brep",
    nick = "ShapeIn",
    at = "Surface/Analysis"
)]
#[output("Relation", "R", "0 when it lies inside, 1 when it goes through the skin, 2 when it lies outside.")]
fn shape_in_brep(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The shape.
    #[port("Shape", "S")]
    shape: Geometry,
) -> Result<i32, Message> {
    let (mut inside, mut outside, mut known) = (false, false, false);
    for point in samples(context, &shape.0, 0)? {
        context.check()?;
        known = true;
        match place(context, &brep, point)? {
            Containment::Inside => inside = true,
            Containment::Outside => outside = true,
            Containment::On => {}
        }
        if inside && outside {
            return Ok(1);
        }
    }
    if !known {
        return Err(Message::warning("The shape has no points"));
    }
    if outside {
        return Ok(2);
    }
    Ok(if inside { 0 } else { 1 })
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Cylinder, Interval, Line, Plane, Point3, Sphere, Surface, construct};

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn can() -> Value {
        let shape = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 4.0)).unwrap();
        construct::cylinder(&shape, [true; 2]).unwrap().into()
    }

    #[test]
    fn nearest_points() {
        let near = |q: Point3| Trial::of("Brep Closest Point").item(q).item(can());
        assert_eq!(near(p(0.5, 0.0, 5.0)).texts(0), ["{0}: {0.5, 0, 4}"]);
        assert_eq!(near(p(0.5, 0.0, 5.0)).texts(1), ["{0}: {0, 0, 1}"]);
        assert_eq!(near(p(0.0, 5.0, 1.0)).texts(2), ["{0}: 3"]);
        assert_eq!(near(p(5.0, 0.0, 8.0)).texts(0), ["{0}: {2, 0, 4}"]);
        let old = Trial::of_guid("cdd5d441-3bad-4f19-a370-6cf180b6f0fa").item(p(0.0, 0.0, -3.0)).item(can());
        assert_eq!(old.texts(1), ["{0}: 3"]);
    }

    #[test]
    fn points_inside() {
        let inside = |q: Point3, strict: bool| {
            Trial::of("Point In Brep").item(can()).item(q).item(strict).texts(0).join("")
        };
        assert_eq!(inside(p(1.0, 1.0, 1.0), true), "{0}: True");
        assert_eq!(inside(p(1.9, 1.9, 1.0), false), "{0}: False");
        assert_eq!(inside(p(2.0, 0.0, 1.0), false), "{0}: True");
        assert_eq!(inside(p(0.3, 0.2, 4.0), true), "{0}: False");
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::UNIT).unwrap().into();
        assert!(
            Trial::of("Point In Brep")
                .item(tube)
                .item(Point3::ORIGIN)
                .item(true)
                .message()
                .contains("closed")
        );
        let side = Interval::new(10.0, 12.0);
        let block = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        let which = |q: Point3| {
            Trial::of("Point In Breps")
                .list([can(), Value::from(block)])
                .item(q)
                .item(false)
                .texts(1)
                .join("")
        };
        assert_eq!(which(p(11.0, 11.0, 11.0)), "{0}: 1");
        assert_eq!(which(p(0.0, 0.0, 1.0)), "{0}: 0");
        assert_eq!(which(p(5.0, 5.0, 5.0)), "{0}: -1");
    }

    #[test]
    fn shapes_inside() {
        let lies = |shape: Value| Trial::of("Shape In Brep").item(can()).item(shape).texts(0).join("");
        let ball = |x: f64, r: f64| {
            Value::from(construct::sphere(&Sphere::around(p(x, 0.0, 2.0), r).unwrap()).unwrap())
        };
        assert_eq!(lies(ball(0.0, 0.5)), "{0}: 0");
        assert_eq!(lies(ball(2.0, 0.5)), "{0}: 1");
        assert_eq!(lies(ball(9.0, 0.5)), "{0}: 2");
        assert_eq!(lies(Line::new(p(0.0, 0.0, -1.0), p(0.0, 0.0, 1.0)).into()), "{0}: 1");
        assert_eq!(lies(p(0.0, 0.0, 1.0).into()), "{0}: 0");
    }
}
