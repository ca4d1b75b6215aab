//! Reflections in curves and surfaces.

use katydid_component::{Context, Message, component};
use katydid_data::Geometry;
use katydid_geometry::morph::{MirrorInCurve, MirrorInSurface, Morph};
use katydid_geometry::{Curve, Point3, Surface};

use super::{Manner, morphed};

/// Mirrors geometry in a freeform curve: every point in the point of the curve that is nearest to it.
///
/// Where the nearest point leaps, as across the middle of a bend, a curve may be torn: an error.
#[component(
    "9c9f8219-ae88-4d29-ba1b-3433ed713639",
    name = "Mirror Curve",
    nick = "Mirror",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The mirror image.")]
fn mirror_curve(
    context: &Context<'_>,
    /// What to mirror.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The mirror.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Whether an open curve goes on straight beyond its ends; else those mirror as points.
    #[port("Tangent", "T", default = true)]
    tangent: bool,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &MirrorInCurve::new(curve, tangent), Manner::Bent)
}

/// Mirrors a point in a freeform curve: in the point of the curve that is nearest to it.
#[component(
    "f8452dc8-aea6-4654-a72f-c0fd62626d36",
    name = "Mirror Curve",
    nick = "Mirror",
    at = "Transform/Morph"
)]
#[output("Point", "P", "The mirror image.")]
#[output("Distance", "D", "The distance of the point from the mirror.")]
fn mirror_point_in_curve(
    /// What to mirror.
    #[port("Point", "P")]
    point: Point3,
    /// The mirror.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Whether an open curve goes on straight beyond its ends; else those mirror as points.
    #[port("Tangent", "T", default = true)]
    tangent: bool,
) -> Result<(Point3, f64), Message> {
    let mirror = MirrorInCurve::new(curve, tangent);
    Ok((mirror.image(point)?, mirror.foot(point)?.distance_to(point)))
}

/// Mirrors geometry in a freeform surface: every point in the point of the surface that is nearest to it.
///
/// Where the nearest point leaps, as across the middle of a bend, a curve may be torn: an error.
#[component(
    "6ce1aa3c-626b-4db7-8b5b-bf74c78f8c5e",
    name = "Mirror Surface",
    nick = "Mirror",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The mirror image.")]
fn mirror_surface(
    context: &Context<'_>,
    /// What to mirror.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The mirror.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Whether the surface goes on beyond its edges by its tangent planes; else the edges mirror as they are.
    #[port("Frame", "F", default = true)]
    frame: bool,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &MirrorInSurface::new(surface, frame)?, Manner::Bent)
}

/// Mirrors a point in a freeform surface: in the point of the surface that is nearest to it.
#[component(
    "3431f5c6-7578-4d26-a2b6-dfc064a9c65e",
    name = "Mirror Surface",
    nick = "Mirror",
    at = "Transform/Morph"
)]
#[output("Point", "P", "The mirror image.")]
#[output("Distance", "D", "The distance of the point from the mirror.")]
fn mirror_point_in_surface(
    /// What to mirror.
    #[port("Point", "P")]
    point: Point3,
    /// The mirror.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Whether the surface goes on beyond its edges by its tangent planes; else the edges mirror as they are.
    #[port("Frame", "F", default = true)]
    frame: bool,
) -> Result<(Point3, f64), Message> {
    let mirror = MirrorInSurface::new(surface, frame)?;
    Ok((mirror.image(point)?, mirror.foot(point)?.distance_to(point)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Line, Plane, PlaneSurface};

    use super::*;

    #[test]
    fn mirrors_of_curves() {
        let line = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0));
        let p = Point3::new(5.0, 1.0, 2.0);
        let of = |guid: &str, tangent: bool| Trial::of_guid(guid).item(p).item(line).item(tangent);
        let (geometry, point) =
            ("9c9f8219-ae88-4d29-ba1b-3433ed713639", "f8452dc8-aea6-4654-a72f-c0fd62626d36");
        assert_eq!(of(geometry, true).texts(0), ["{0}: {5, -1, -2}"]);
        assert_eq!(of(geometry, false).texts(0), ["{0}: {3, -1, -2}"]);
        assert_eq!(of(point, true).texts(0), ["{0}: {5, -1, -2}"]);
        assert_eq!(of(point, false).texts(1), ["{0}: 2.44949"]);
    }

    #[test]
    fn mirrors_of_surfaces() {
        let side = Interval::new(0.0, 4.0);
        let sheet: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let p = Point3::new(5.0, 1.0, 2.0);
        let of = |guid: &str, frame: bool| Trial::of_guid(guid).item(p).item(sheet.clone()).item(frame);
        let (geometry, point) =
            ("6ce1aa3c-626b-4db7-8b5b-bf74c78f8c5e", "3431f5c6-7578-4d26-a2b6-dfc064a9c65e");
        assert_eq!(of(geometry, true).texts(0), ["{0}: {5, 1, -2}"]);
        assert_eq!(of(geometry, false).texts(0), ["{0}: {3, 1, -2}"]);
        assert_eq!(of(point, true).texts(1), ["{0}: 2"]);
    }
}
