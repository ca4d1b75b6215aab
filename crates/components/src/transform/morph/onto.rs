//! Deformations from surface to surface.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Geometry;
use katydid_geometry::morph::{MapToSurface, Splop, Sporph};
use katydid_geometry::{Curve, Plane, Point3, Surface};

use super::{Manner, morphed};

/// Carries a curve from one surface to another by its control points.
///
/// Each control point goes to the same fractions of the domains as its nearest point on the source has, and keeps its
/// height along the normal. Lines and polylines stay such.
#[component(
    "fc5b7d12-7247-4de0-81bc-9b2c2f8f72f6",
    name = "Map to Surface",
    nick = "Map Srf",
    at = "Transform/Morph"
)]
#[output("Curve", "C", "The curve on the target.")]
fn map_to_surface(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The surface the curve lies on or near to.
    #[port("Source", "S")]
    source: &Surface,
    /// The surface it is carried to.
    #[port("Target", "T")]
    target: &Surface,
) -> Result<Shared<Curve>, Message> {
    Ok(Shared::new(curve.with_morphed_controls(&MapToSurface::new(source, target)?)?))
}

/// Wraps geometry onto a surface.
///
/// The plane's origin comes to the place on the surface, its x axis along growing u. Steps along the plane follow the
/// surface's parameter lines, true in length and angle at that place; heights are kept along the normal.
#[component("ff4e6ccd-47ba-4c8c-8287-2a1f2cb1fa5e", name = "Splop", nick = "Splop", at = "Transform/Morph")]
#[output("Geometry", "G", "The wrapped geometry.")]
fn splop(
    context: &Context<'_>,
    /// What to wrap.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The plane on which the geometry stands.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The place on the surface: its parameters u and v as x and y.
    #[port("Parameter", "uv")]
    parameter: Point3,
    /// A turn about the normal there, in radians.
    #[port("Angle", "A", default = 0.0)]
    angle: f64,
    /// Whether geometry keeps its shape and is moved as its middle is.
    #[port("Rigid", "R", default = false)]
    rigid: bool,
) -> Result<Geometry, Message> {
    let morph = Splop::new(plane, surface, [parameter.x, parameter.y], angle)?;
    morphed(context, &geometry, &morph, Manner::of(rigid))
}

/// Carries geometry from one surface to another.
///
/// A place of the base comes to a place of the target. Steps along the base's parameter lines become steps along the
/// target's, with the same lengths and angles at these places; heights are kept along the normals.
#[component("9cacad37-b09f-4b54-b2b1-1ccdc2e3ffea", name = "Sporph", nick = "Sporph", at = "Transform/Morph")]
#[output("Geometry", "G", "The geometry on the target.")]
fn sporph(
    context: &Context<'_>,
    /// What to carry.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The surface on which the geometry stands.
    #[port("Base", "S0")]
    base: &Surface,
    /// A place on it: its parameters u and v as x and y.
    #[port("Parameter", "P0")]
    from: Point3,
    /// The surface on which it shall stand.
    #[port("Target", "S1")]
    target: &Surface,
    /// The place of it where the other comes to.
    #[port("Parameter", "P1")]
    to: Point3,
    /// Whether geometry keeps its shape and is moved as its middle is.
    #[port("Rigid", "R", default = false)]
    rigid: bool,
) -> Result<Geometry, Message> {
    let morph = Sporph::new(base, [from.x, from.y], target, [to.x, to.y])?;
    morphed(context, &geometry, &morph, Manner::of(rigid))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Interval, Line, PlaneSurface};

    use super::*;

    fn sheet(plane: Plane, x: f64) -> Surface {
        PlaneSurface::new(plane, Interval::new(0.0, x), Interval::new(0.0, 2.0)).unwrap().into()
    }

    #[test]
    fn from_plane_to_plane() {
        let line = Line::new(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 2.0, 0.0));
        let map =
            Trial::of("Map to Surface").item(line).item(sheet(Plane::XY, 2.0)).item(sheet(Plane::YZ, 4.0));
        let Some(Value::Curve(image)) = map.run().outputs.first().unwrap().column().get(0) else {
            panic!("a curve")
        };
        assert!(image.start().distance_to(Point3::new(1.0, 0.0, 0.0)) < 1e-12);
        assert!(image.end().distance_to(Point3::new(0.0, 4.0, 2.0)) < 1e-12);
    }

    #[test]
    fn splop_and_sporph_keep_lengths_at_their_places() {
        let p = Point3::new(0.5, 0.25, 1.0);
        let uv = Point3::new(1.0, 1.0, 0.0);
        let splop = Trial::of("Splop").item(p).default().item(sheet(Plane::YZ, 4.0)).item(uv);
        assert_eq!(splop.default().default().texts(0), ["{0}: {1, 1.5, 1.25}"]);
        let zero = Point3::ORIGIN;
        let sporph = |rigid: bool| {
            let trial = Trial::of("Sporph").item(p).item(sheet(Plane::XY, 2.0)).item(zero);
            trial.item(sheet(Plane::YZ, 4.0)).item(uv).item(rigid)
        };
        assert_eq!(sporph(false).texts(0), ["{0}: {1, 1.5, 1.25}"]);
        assert_eq!(sporph(true).texts(0), ["{0}: {1, 1.5, 1.25}"]);
    }
}
