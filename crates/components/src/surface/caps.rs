//! Surface / Util: breps closed and joined.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::Brep;

use super::warning;

/// A brep with its planar holes filled, and how many were. Without one that can be filled it comes back as it was.
fn capped(context: &Context<'_>, brep: &Shared<Brep>) -> Result<(Value, usize, bool), Message> {
    if brep.is_solid() {
        return Ok((Value::Brep(brep.clone()), 0, true));
    }
    let (closed, count) = brep.capped(&context.tolerance()).map_err(warning)?;
    if count == 0 {
        context.warn("There are no planar holes to cap");
        return Ok((Value::from((**brep).clone()), 0, false));
    }
    let is_solid = closed.is_solid();
    Ok((Value::from(closed), count, is_solid))
}

/// Fills the planar holes of a Brep.
///
/// Holes that are not planar stay open. When none is left, the result is a solid.
#[component("b648d933-ddea-4e75-834c-8f6f3793e311", name = "Cap Holes", nick = "Cap", at = "Surface/Util")]
#[output("Brep", "B", "The Brep with its caps.", kind = Brep)]
fn cap_holes(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<Value, Message> {
    Ok(capped(context, &brep)?.0)
}

/// Fills the planar holes of a Brep, and says what came of it.
#[component(
    "f6409a9c-3d2a-4b14-9f2c-e3c3f2cb72f8",
    name = "Cap Holes Ex",
    nick = "CapEx",
    at = "Surface/Util"
)]
#[output("Brep", "B", "The Brep with its caps.", kind = Brep)]
#[output("Caps", "C", "How many caps were made.")]
#[output("Solid", "S", "Whether the result encloses a volume.")]
fn cap_holes_ex(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Value, i32, bool), Message> {
    let (made, count, is_solid) = capped(context, &brep)?;
    Ok((made, i32::try_from(count).unwrap_or(i32::MAX), is_solid))
}

/// Joins Breps along edges that run together.
///
/// Faces are turned to agree with each other; what encloses a volume has its normals outward.
#[component("1addcc85-b04e-46e6-bd4a-6f6c93bf7efd", name = "Brep Join", nick = "Join", at = "Surface/Util")]
#[output("Breps", "B", "The joined Breps, and those that nothing could be joined to.", kind = Brep)]
#[output("Closed", "C", "For each whether it encloses a volume.")]
fn brep_join(
    context: &Context<'_>,
    /// The Breps.
    #[port("Breps", "B")]
    breps: List<Shared<Brep>>,
) -> Result<(Vec<Value>, Vec<bool>), Message> {
    let given: Vec<Brep> = breps.present().map(|brep| (*brep).clone()).collect();
    context.check()?;
    let joined = Brep::join(&given, &context.tolerance()).map_err(warning)?;
    context.items(2 * joined.breps.len())?;
    let closed = joined.breps.iter().map(Brep::is_solid).collect();
    Ok((joined.breps.into_iter().map(Value::from).collect(), closed))
}

/// Makes one face of neighbouring faces in one plane, wherever there are some.
#[component(
    "d6b43673-55dd-4e2f-95c4-6c69a14513a6",
    name = "Merge Faces",
    nick = "FMerge",
    at = "Surface/Util"
)]
#[output("Breps", "B", "The Brep with merged faces.", kind = Brep)]
#[output("Before", "N0", "How many faces it had.")]
#[output("After", "N1", "How many faces it has.")]
fn merge_faces(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Value, i32, i32), Message> {
    let count = |brep: &Brep| i32::try_from(brep.faces().len()).unwrap_or(i32::MAX);
    let merged = brep.with_coplanar_faces_merged(&context.tolerance()).map_err(warning)?;
    let numbers = (count(&brep), count(&merged));
    Ok((Value::from(merged), numbers.0, numbers.1))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Circle, Interval, Mesh, Plane, Rectangle, Vector3};

    use crate::surface::trial::{breps, mesh_volume};

    fn tube(height: f64) -> Value {
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let made = Trial::of("Extrude").item(circle).item(Vector3::new(0.0, 0.0, height)).run();
        made.outputs[0].column().get(0).unwrap()
    }

    #[test]
    fn a_tube_becomes_a_solid() {
        let made = breps(Trial::of("Cap Holes").item(tube(3.0)));
        assert!(made[0].is_solid() && made[0].is_valid());
        assert!((mesh_volume(&made[0]) - 3.0 * PI).abs() < 5e-3);
        let all = Trial::of("Cap Holes Ex").item(tube(3.0)).run().outputs;
        assert_eq!(all[1].column().get(0), Some(Value::Integer(2)));
        assert_eq!(all[2].column().get(0), Some(Value::Boolean(true)));
        let side = Interval::new(0.0, 2.0);
        let cube = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        assert_eq!(Trial::of("Cap Holes").item(cube).texts(0), ["{0}: Closed Brep"]);
        let ball =
            katydid_geometry::Surface::from(katydid_geometry::Sphere { plane: Plane::XY, radius: 1.0 });
        assert!(Trial::of("Cap Holes").item(ball).message().is_empty());
        assert_eq!(Trial::of("Cap Holes").item(Mesh::default()).texts(0), ["{0}: null"]);
    }

    #[test]
    fn six_squares_become_a_cube_and_halves_merge() {
        let half = |x: f64, plane: Plane| {
            Value::from(Rectangle { plane, x: Interval::new(x, x + 1.0), y: Interval::new(0.0, 2.0) })
        };
        let both = [0.0, 1.0].map(|x| half(x, Plane::XY));
        let joined = Trial::of("Brep Join").list(both).run().outputs;
        let brep = joined[0].column().get(0).unwrap();
        assert_eq!((joined[0].column().len(), joined[1].column().get(0)), (1, Some(Value::Boolean(false))));
        let merged = Trial::of("Merge Faces").item(brep).run().outputs;
        assert_eq!(merged[1].column().get(0), Some(Value::Integer(2)));
        assert_eq!(merged[2].column().get(0), Some(Value::Integer(1)));
        let apart = Trial::of("Brep Join").list([half(0.0, Plane::XY), half(5.0, Plane::XY)]);
        assert_eq!(apart.texts(1), ["{0}: False, False"]);
    }
}
