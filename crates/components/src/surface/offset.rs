//! Surface / Util: surfaces at a distance from others.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Brep, construct};

use super::warning;

/// Faces that came apart are one value all the same.
fn one(mut made: Vec<Brep>) -> Result<Value, Message> {
    match made.len() {
        0 => Err(Message::warning("Nothing is left of the surface")),
        1 => Ok(Value::from(made.swap_remove(0))),
        _ => Ok(Value::from(Brep::merged(&made))),
    }
}

/// A surface at a distance from another along its normals.
///
/// Planes and round surfaces stay exact, others are within the tolerance. Where the distance is greater than a radius
/// of curvature the result folds over.
#[component(
    "b25c5762-f90e-4839-9fc5-74b74ab42b1e",
    name = "Offset Surface",
    nick = "Offset",
    at = "Surface/Util"
)]
#[output("Surface", "S", "The surface.", kind = Surface)]
fn offset_surface(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S", kind = Brep)]
    surface: Shared<Brep>,
    /// The distance; below 0 to the other side.
    #[port("Distance", "D", default = 0.0)]
    distance: f64,
    /// Whether the result is trimmed as the surface is.
    #[port("Retrim", "T", default = true)]
    retrim: bool,
) -> Result<Value, Message> {
    let made = construct::offset_brep(&surface, distance, retrim, &context.tolerance()).map_err(warning)?;
    one(made)
}

/// A surface whose control points are those of another, moved along its normals.
///
/// It has no more control points than the other, and is only about as far from it as is asked for.
#[component(
    "e7e43403-f913-4d83-8aff-5b1c7a7f9fbc",
    name = "Offset Surface Loose",
    nick = "Offset (L)",
    at = "Surface/Util"
)]
#[output("Surface", "S", "The surface.", kind = Surface)]
fn offset_surface_loose(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S", kind = Brep)]
    surface: Shared<Brep>,
    /// The distance; below 0 to the other side.
    #[port("Distance", "D", default = 0.0)]
    distance: f64,
    /// Whether the result is trimmed as the surface is.
    #[port("Retrim", "T", default = true)]
    retrim: bool,
) -> Result<Value, Message> {
    let mut out = Vec::new();
    for (place, face) in surface.faces().iter().enumerate().filter(|(_, face)| !face.deleted) {
        context.check()?;
        let Some(own) = surface.face_surface(place) else { continue };
        let distance = if face.reversed { -distance } else { distance };
        let moved = construct::offset_surface_loosely(own, distance).map_err(warning)?.into();
        let whole = surface.sub_brep(&[place]).map_err(warning)?.as_surface().is_some();
        let made = if retrim && !whole {
            surface.copied_trims(place, &moved, &context.tolerance()).map_err(warning)?
        } else {
            vec![Brep::from_surface(moved).map_err(warning)?]
        };
        out.extend(made.into_iter().map(|brep| if face.reversed { brep.flipped() } else { brep }));
    }
    one(out)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Plane, Sphere, Surface};

    use crate::surface::trial::{breps, mesh_area};

    #[test]
    fn spheres_and_discs() {
        let ball = Surface::from(Sphere { plane: Plane::XY, radius: 1.0 });
        let larger = breps(Trial::of("Offset Surface").item(ball.clone()).item(1.0));
        assert!((mesh_area(&larger[0]) - 16.0 * PI).abs() < 2e-2);
        assert_eq!(Trial::of("Offset Surface").item(ball.clone()).texts(0), ["{0}: Untrimmed Surface"]);
        assert!(!Trial::of("Offset Surface").item(ball.clone()).item(f64::NAN).message().is_empty());
        assert_eq!(breps(Trial::of("Offset Surface Loose").item(ball).item(0.1)).len(), 1);
        let disc = Trial::of("Boundary Surfaces").list([Circle { plane: Plane::XY, radius: 2.0 }]).run();
        let disc = disc.outputs[0].column().get(0).unwrap();
        let moved = breps(Trial::of("Offset Surface").item(disc.clone()).item(1.0));
        assert!((mesh_area(&moved[0]) - 4.0 * PI).abs() < 1e-2);
        assert!((moved[0].vertices()[0].point.z.abs() - 1.0).abs() < 1e-9);
        let whole = breps(Trial::of("Offset Surface").item(disc).item(1.0).item(false));
        assert!((mesh_area(&whole[0]) - 16.0).abs() < 1e-6);
    }
}
