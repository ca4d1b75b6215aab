//! Boxes with eight free corners, and deformations into them and onto surfaces.

use katydid_component::{Context, Message, component};
use katydid_data::{Domain2, Geometry};
use katydid_geometry::morph::{BoxMorph, SurfaceMorph};
use katydid_geometry::{Box3, Interval, Point3, Surface, TwistedBox};

use super::{Manner, morphed};

/// Carries geometry from a box into a twisted box.
///
/// Every point keeps its fractions of the box's sides; what lies outside the box comes to lie outside the other. Corners
/// go to corners, straight sides to straight sides.
#[component(
    "d8940ff0-dd4a-4e74-9361-54df537b50db",
    name = "Box Morph",
    nick = "Morph",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The deformed geometry.")]
fn box_morph(
    context: &Context<'_>,
    /// What to deform.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The box that is carried, in general the one around the geometry.
    #[port("Reference", "R")]
    reference: Box3,
    /// What the box becomes.
    #[port("Target", "T")]
    target: TwistedBox,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &BoxMorph::new(reference, target)?, Manner::Bent)
}

/// Lays geometry from a box over a part of a surface.
///
/// The box's width becomes the range of u, its depth that of v, and its height that of the distance along the surface's
/// normal. Beyond an open edge the surface goes on along its tangents.
#[component(
    "5889b68f-fd88-4032-860f-869fb69654dd",
    name = "Surface Morph",
    nick = "SrfMorph",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The deformed geometry.")]
fn surface_morph(
    context: &Context<'_>,
    /// What to deform.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The box that is carried, in general the one around the geometry.
    #[port("Reference", "R")]
    reference: Box3,
    /// The surface it is laid over.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The range of u, in the surface's own domain.
    #[port("U Domain", "U")]
    u: Interval,
    /// The range of v, in the surface's own domain.
    #[port("V Domain", "V")]
    v: Interval,
    /// The range of the distance from the surface, in units.
    #[port("W Domain", "W")]
    w: Interval,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &SurfaceMorph::new(reference, surface, u, v, w)?, Manner::Bent)
}

/// The corners of a part of a surface, in the order of the bottom of a box, raised by a height along the normals there.
fn patch(surface: &Surface, domain: &Domain2, height: f64) -> Result<[Point3; 4], Message> {
    let (u, v) = (domain.u, domain.v);
    let mut corners = [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end)]
        .map(|(u, v)| (u, v, surface.point_at(u, v)));
    if height != 0.0 {
        for (u, v, point) in &mut corners {
            let none = || Message::error("The surface has no normal at a corner of the domain");
            *point += surface.normal_at(*u, *v).ok_or_else(none)? * height;
        }
    }
    Ok(corners.map(|(_, _, point)| point))
}

fn between(bottom: [Point3; 4], top: [Point3; 4]) -> Result<TwistedBox, Message> {
    let ([a, b, c, d], [e, f, g, h]) = (bottom, top);
    Ok(TwistedBox::new([a, b, c, d, e, f, g, h])?)
}

/// A twisted box on a part of a surface: its bottom are the corners of the part, its top lies above them along the
/// normals.
#[component(
    "4f65c681-9331-4818-9d54-6290cae686c3",
    name = "Surface Box",
    nick = "SBox",
    at = "Transform/Morph"
)]
#[output("Twisted Box", "B", "The box.")]
fn surface_box(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The part, in the surface's own domains.
    #[port("Domain", "D")]
    domain: Domain2,
    /// The height, in units; negative below the surface.
    #[port("Height", "H", default = 1.0)]
    height: f64,
) -> Result<TwistedBox, Message> {
    between(patch(surface, &domain, 0.0)?, patch(surface, &domain, height)?)
}

/// A twisted box between parts of two surfaces: its bottom are the corners of the one, its top those of the other.
#[component(
    "6283fb37-e273-4eb2-8d2a-e347881e3928",
    name = "Blend Box",
    nick = "BlendBox",
    at = "Transform/Morph"
)]
#[output("Twisted Box", "B", "The box.")]
fn blend_box(
    /// The surface of the bottom.
    #[port("Surface A", "Sa")]
    surface_a: &Surface,
    /// Its part, in its own domains.
    #[port("Domain A", "Da")]
    domain_a: Domain2,
    /// The surface of the top.
    #[port("Surface B", "Sb")]
    surface_b: &Surface,
    /// Its part, in its own domains.
    #[port("Domain B", "Db")]
    domain_b: Domain2,
) -> Result<TwistedBox, Message> {
    between(patch(surface_a, &domain_a, 0.0)?, patch(surface_b, &domain_b, 0.0)?)
}

/// A box from its eight corners: four of the bottom, going round, and the four above them.
#[component(
    "124de0f5-65f8-4ae0-8f61-8fb066e2ba02",
    name = "Twisted Box",
    nick = "TBox",
    at = "Transform/Morph"
)]
#[output("Twisted Box", "B", "The box.")]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn twisted_box(
    /// The corner at the fractions (0, 0, 0).
    #[port("Corner A", "A")]
    a: Point3,
    /// The corner at (1, 0, 0).
    #[port("Corner B", "B")]
    b: Point3,
    /// The corner at (1, 1, 0).
    #[port("Corner C", "C")]
    c: Point3,
    /// The corner at (0, 1, 0).
    #[port("Corner D", "D")]
    d: Point3,
    /// The corner at (0, 0, 1), above A.
    #[port("Corner E", "E")]
    e: Point3,
    /// The corner at (1, 0, 1), above B.
    #[port("Corner F", "F")]
    f: Point3,
    /// The corner at (1, 1, 1), above C.
    #[port("Corner G", "G")]
    g: Point3,
    /// The corner at (0, 1, 1), above D.
    #[port("Corner H", "H")]
    h: Point3,
) -> Result<TwistedBox, Message> {
    between([a, b, c, d], [e, f, g, h])
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Domain2, Value};
    use katydid_geometry::{Mesh, Plane, PlaneSurface};

    use super::*;

    fn cube(size: f64) -> Box3 {
        let side = Interval::new(0.0, size);
        Box3 { plane: Plane::XY, x: side, y: side, z: side }
    }

    fn sheet(plane: Plane, size: f64) -> Surface {
        let side = Interval::new(0.0, size);
        PlaneSurface::new(plane, side, side).unwrap().into()
    }

    fn first(trial: Trial) -> Value {
        trial.run().outputs.first().unwrap().column().get(0).unwrap()
    }

    #[test]
    fn into_a_box_of_double_size() {
        let p = Point3::new(1.0, 0.5, 0.25);
        let trial = Trial::of("Box Morph").item(p).item(cube(1.0)).item(cube(2.0));
        assert_eq!(trial.texts(0), ["{0}: {2, 1, 0.5}"]);
        let mesh = Mesh::cuboid(&cube(1.0), 1, 1, 1).unwrap();
        let Value::Mesh(image) = first(Trial::of("Box Morph").item(mesh).item(cube(1.0)).item(cube(2.0)))
        else {
            panic!("a mesh")
        };
        assert!((image.volume() - 8.0).abs() < 1e-12);
        let corners = cube(2.0).corners();
        let made = first(
            corners.iter().fold(Trial::of_guid("124de0f5-65f8-4ae0-8f61-8fb066e2ba02"), |t, &p| t.item(p)),
        );
        assert_eq!(made, Value::from(TwistedBox { corners }));
        let kept = Trial::of_guid("6db039c4-cad1-4549-bd45-e31cb0f71692").item(cube(2.0));
        assert_eq!(kept.texts(0), ["{0}: Twisted Box"]);
    }

    #[test]
    fn boxes_on_surfaces() {
        let (surface, side) = (sheet(Plane::XY, 4.0), Interval::new(1.0, 2.0));
        let domain = Domain2 { u: side, v: side };
        let Value::TwistedBox(on) =
            first(Trial::of("Surface Box").item(surface.clone()).item(domain).default())
        else {
            panic!("a box")
        };
        assert_eq!(on.corners[2], Point3::new(2.0, 2.0, 0.0));
        assert_eq!(on.corners[7], Point3::new(1.0, 2.0, 1.0));
        let above = sheet(Plane { origin: Point3::new(0.0, 0.0, 3.0), ..Plane::XY }, 4.0);
        let blend = Trial::of("Blend Box").item(surface).item(domain).item(above).item(domain);
        let Value::TwistedBox(blend) = first(blend) else { panic!("a box") };
        assert_eq!(blend.corners[4], Point3::new(1.0, 1.0, 3.0));
    }

    #[test]
    fn onto_a_plane() {
        let side = Interval::new(0.0, 2.0);
        let p = Point3::new(1.0, 0.5, 1.0);
        let trial = Trial::of("Surface Morph").item(p).item(cube(1.0)).item(sheet(Plane::XY, 2.0));
        assert_eq!(trial.item(side).item(side).item(Interval::new(0.0, 5.0)).texts(0), ["{0}: {2, 1, 5}"]);
    }
}
