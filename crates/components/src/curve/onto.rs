//! Curve / Util and Spline: curves on surfaces and meshes.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Kind, Value, cast};
use katydid_geometry::{Brep, Curve, Mesh, Point3, Surface, Vector3};

use super::{shared, warning};
use crate::prepared;

/// What a curve can be brought onto.
enum Carrier {
    Surface(Shared<Surface>),
    Mesh(Shared<Mesh>),
    Brep(Shared<Brep>),
}

impl Carrier {
    fn of(context: &Context<'_>, value: &Value) -> Result<Self, Message> {
        if let Value::Mesh(mesh) = value {
            return Ok(Self::Mesh(mesh.clone()));
        }
        if let (Value::Brep(_) | Value::Kept(_), Some(brep)) = (value, value.brep()) {
            return Ok(Self::Brep(brep.map_err(Message::warning)?));
        }
        // One after the other: what has a surface is not meshed for nothing.
        let to = |kind| cast::value(value, kind, context.rules());
        if let Some(Value::Surface(surface)) = to(Kind::Surface) {
            return Ok(Self::Surface(surface));
        }
        match to(Kind::Mesh) {
            Some(Value::Mesh(mesh)) => Ok(Self::Mesh(mesh)),
            _ => Err(Message::error(format!(
                "Curves cannot be brought onto a {} yet: only onto Breps, boxes and meshes",
                value.kind().name()
            ))),
        }
    }
}

/// Projects a curve onto a surface or mesh along a direction, forwards and backwards.
///
/// Every part of the Brep that the curve meets on its way gives a curve, within the trims. Where it meets nothing there
/// is none.
#[component("d7ee52ff-89b8-4d1a-8662-3e0dd391d0af", name = "Project", nick = "Project", at = "Curve/Util")]
#[output("Curve", "C", "The projected curves.")]
fn project(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The Brep, box or mesh.
    #[port("Brep", "B", kind = Geometry)]
    brep: Value,
    /// The direction; its length and sense do not matter.
    #[port("Direction", "D", default = Vector3::new(0.0, 0.0, 1.0))]
    direction: Vector3,
) -> Result<Vec<Shared<Curve>>, Message> {
    let tolerance = context.tolerance();
    let curves = match Carrier::of(context, &brep)? {
        Carrier::Surface(surface) => {
            prepared::projection_onto(context, &surface, direction)?.project(curve, &tolerance)
        }
        Carrier::Mesh(mesh) => mesh.project_curve(curve, direction, tolerance.absolute),
        Carrier::Brep(brep) => prepared::projection(context, &brep, direction)?.project(curve, &tolerance),
    };
    Ok(curves.map_err(warning)?.into_iter().map(Shared::new).collect())
}

/// Pulls a curve to a surface or mesh: each point goes to the nearest point there.
///
/// Beside the surface the result runs along its sides. Where it would come apart, the longest part is given, with a
/// warning.
#[component("6b5812f5-bb36-4d74-97fc-5a1f2f77452d", name = "Pull Curve", nick = "Pull", at = "Curve/Util")]
#[output("Curve", "C", "The pulled curve.")]
fn pull_curve(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The surface, box or mesh.
    #[port("Surface", "S", kind = Geometry)]
    surface: Value,
) -> Result<Shared<Curve>, Message> {
    let tolerance = context.tolerance();
    let curves = match Carrier::of(context, &surface)? {
        Carrier::Surface(surface) => surface.pull_curve(curve, &tolerance).map_err(warning)?,
        Carrier::Brep(brep) => match (brep.faces(), brep.face_surface(0)) {
            ([_], Some(surface)) => surface.pull_curve(curve, &tolerance).map_err(warning)?,
            _ => return Err(Message::error("A curve can be pulled to one face only: take the Brep apart")),
        },
        Carrier::Mesh(mesh) => vec![mesh.pull_curve(curve, tolerance.absolute).map_err(warning)?.into()],
    };
    if curves.len() > 1 {
        context.warn("The nearest points leap: only the longest part of the curve is given");
    }
    let longest = curves.into_iter().max_by(|a, b| a.length().total_cmp(&b.length()));
    longest.map(Shared::new).ok_or_else(|| Message::warning("The curve is pulled to a single point"))
}

/// The curves on a surface at a distance from a curve on it, measured along the surface.
///
/// A positive distance lies to the left of the curve, seen against the normal of the surface. The outer sides of corners
/// are rounded. Where the offset leaves the surface it has gaps; loops where the curve bends tightly are not removed.
#[component(
    "b6f5cb51-f260-4c74-bf73-deb47de1bf91",
    name = "Offset on Srf",
    nick = "OffsetS",
    at = "Curve/Util"
)]
#[output("Curve", "C", "The offset curves.")]
fn offset_on_surface(
    context: &Context<'_>,
    /// The curve; it is pulled to the surface.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far; negative to the right of the curve.
    #[port("Distance", "D")]
    distance: f64,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
) -> Result<Vec<Shared<Curve>>, Message> {
    let curves = surface.offset_curve(curve, distance, &context.tolerance()).map_err(warning)?;
    Ok(curves.into_iter().map(Shared::new).collect())
}

/// The shortest way on a surface between two points. Points beside the surface are pulled to it.
///
/// It may cross the seam of a closed surface, and keeps within the sides of others. Where several ways are nearly
/// equally short it is one of them.
#[component(
    "ce5963b4-1cea-4f71-acd2-a3c28ab85662",
    name = "Geodesic",
    nick = "Geodesic",
    at = "Curve/Spline"
)]
#[output("Geodesic", "G", "The way.")]
fn geodesic(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Where it starts.
    #[port("Start", "S")]
    start: Point3,
    /// Where it ends.
    #[port("End", "E")]
    end: Point3,
) -> Result<Shared<Curve>, Message> {
    let places = surface.closest_points(&[start, end])?;
    let &[a, b] = places.as_slice() else { return Err(Message::error("Internal error: two places")) };
    let way = surface.geodesic([a.u, a.v], [b.u, b.v], &context.tolerance()).map_err(warning)?;
    Ok(shared(way.curve))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Tree, Value};
    use katydid_geometry::{
        Box3, Circle, Cylinder, Interval, Line, Mesh, Plane, PlaneSurface, Point3, Sphere, Surface, Vector3,
    };

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn flat() -> Surface {
        let side = Interval::new(0.0, 4.0);
        PlaneSurface::new(Plane::XY, side, side).unwrap().into()
    }

    fn lengths(curves: &Tree) -> String {
        let texts = Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(curves.clone()).run().outputs
            [0]
        .clone();
        let of = |i: usize| match texts.column().get(i) {
            Some(Value::Number(x)) => format!("{x:.3}"),
            other => format!("{other:?}"),
        };
        (0..texts.item_count()).map(of).collect::<Vec<_>>().join(" ")
    }

    fn project() -> Trial {
        Trial::of_guid("d7ee52ff-89b8-4d1a-8662-3e0dd391d0af")
    }

    #[test]
    fn projected_and_pulled() {
        let line = Line::new(p(-1.0, 1.0, 3.0), p(3.0, 1.0, 6.0));
        assert_eq!(lengths(&project().item(line).item(flat()).run().outputs[0]), "3.000");
        let slanted =
            project().item(line).item(flat()).item(Vector3::new(1.0, 0.0, -1.0)).run().outputs[0].clone();
        assert_eq!(lengths(&slanted), "2.000");
        let side = Interval::new(0.0, 2.0);
        let cube = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        assert_eq!(lengths(&project().item(line).item(cube).run().outputs[0]), "2.000 2.000");
        let mesh = Mesh::cuboid(&cube, 2, 2, 2).unwrap();
        assert_eq!(lengths(&project().item(line).item(mesh.clone()).run().outputs[0]), "2.000 2.000");
        assert_eq!(project().item(line).item(mesh.clone()).item(Vector3::Y).run().outputs[0].item_count(), 0);

        let above = Line::new(p(0.5, 0.5, 3.0), p(1.5, 0.5, 2.5));
        assert_eq!(lengths(&Trial::of("Pull Curve").item(above).item(flat()).run().outputs[0]), "1.000");
        assert_eq!(lengths(&Trial::of("Pull Curve").item(above).item(mesh).run().outputs[0]), "1.000");
        assert!(Trial::of("Pull Curve").item(above).item(p(0.0, 0.0, 0.0)).message().contains("yet"));
    }

    #[test]
    fn ways_and_offsets() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
        let way = Trial::of("Geodesic").item(ball.clone()).item(p(9.0, 0.0, 0.0)).item(p(0.0, 9.0, 0.0));
        assert_eq!(lengths(&way.run().outputs[0]), "3.142");
        let same = Trial::of("Geodesic").item(ball.clone()).item(p(9.0, 0.0, 0.0)).item(p(8.0, 0.0, 0.0));
        assert!(same.message().contains("same point"));
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 6.0)).unwrap().into();
        let ring = Circle { plane: Plane::XY.offset(2.0), radius: 2.0 };
        let offset = Trial::of("Offset on Srf").item(ring).item(1.0).item(tube);
        assert_eq!(lengths(&offset.run().outputs[0]), "12.566");
        let line = Line::new(p(1.0, 1.0, 0.0), p(3.0, 1.0, 0.0));
        let left = Trial::of("Offset on Srf").item(line).item(0.5).item(flat()).run().outputs[0].clone();
        assert_eq!(Trial::of("End Points").tree(left).texts(0).join(""), "{0;0}: {1, 1.5, 0}");
    }
}
