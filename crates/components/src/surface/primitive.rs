//! Surface / Primitive: round and flat surfaces. Their domains are those that Rhino gives them: angles are scaled to
//! lengths at the radius.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc as Shared;

use katydid_component::{Message, component};
use katydid_data::{Geometry, Value};
use katydid_geometry::{
    Box3, Cone, Cylinder, Interval, Plane, PlaneSurface, Point3, Sphere, Surface, construct,
};

use super::{named, over, shared, warning};
use crate::transform::around;

/// The surface of a sphere, u along the equator and v from pole to pole by length.
pub(super) fn sphere_surface(sphere: Sphere) -> Result<Shared<Surface>, Message> {
    let r = sphere.radius;
    let (u, v) = (Interval::new(0.0, TAU * r), Interval::new(-FRAC_PI_2 * r, FRAC_PI_2 * r));
    Ok(Shared::new(over(sphere, u, v).map_err(warning)?))
}

/// A sphere. Its seam leaves the plane's origin along the x axis, its poles lie on the normal.
#[component("dabc854d-f50e-408a-b001-d043c7de151d", name = "Sphere", nick = "Sph", at = "Surface/Primitive")]
#[output("Sphere", "S", "The sphere; u runs round the equator and v from pole to pole, both by length.")]
fn sphere(
    /// Its origin is the centre.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// The radius, greater than 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
) -> Result<Shared<Surface>, Message> {
    sphere_surface(Sphere::new(base, radius)?)
}

/// A sphere of six four-sided surfaces, without poles.
#[component(
    "361790d6-9d66-4808-8c5a-8de9c218c227",
    name = "Quad Sphere",
    nick = "QSph",
    at = "Surface/Primitive"
)]
#[output("Sphere", "S", "The sphere, a closed Brep of six faces.", kind = Brep)]
fn quad_sphere(
    /// Its origin is the centre.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// The radius, greater than 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
) -> Result<Value, Message> {
    Ok(Value::from(construct::quad_sphere(&Sphere::new(base, radius)?).map_err(warning)?))
}

/// A cylinder without caps.
#[component(
    "0373008a-80ee-45be-887d-ab5a244afc29",
    name = "Cylinder",
    nick = "Cyl",
    at = "Surface/Primitive"
)]
#[output("Cylinder", "C", "The cylinder; u runs round it by length, v along it.")]
fn cylinder(
    /// The plane of the base circle, whose centre is the origin.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// The radius, greater than 0.
    #[port("Radius", "R", default = 0.5)]
    radius: f64,
    /// The length along the normal, not 0; negative goes behind the plane.
    #[port("Length", "L", default = 1.0)]
    length: f64,
) -> Result<Shared<Surface>, Message> {
    let height = Interval::new(0.0, length).ordered();
    let made = Cylinder::new(base, radius, height)?;
    Ok(Shared::new(over(made, Interval::new(0.0, TAU * radius), height).map_err(warning)?))
}

/// A cone on a circle, without its base.
#[component(
    "03e331ed-c4d1-4a23-afa2-f57b87d2043c",
    name = "Cone",
    nick = "Cone",
    at = "Surface/Primitive",
    also("22e61c07-c02f-4c53-b567-c821a164fd92")
)]
#[output("Cone", "C", "The cone; u runs round its base by length.")]
#[output("Tip", "T", "Its tip.")]
fn cone(
    /// The plane of the base circle, whose centre is the origin.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// The radius of the base, greater than 0.
    #[port("Radius", "R", default = 0.5)]
    radius: f64,
    /// The height of the tip over the base, not 0; negative lies behind the plane.
    #[port("Length", "L", default = 1.0)]
    length: f64,
) -> Result<(Shared<Surface>, Point3), Message> {
    let made = Cone::new(base.offset(length), -length, radius)?;
    let apex = made.apex();
    let surface = Surface::from(made);
    let around = surface.with_domain(katydid_geometry::Direction::U, Interval::new(0.0, TAU * radius));
    Ok((Shared::new(around.map_err(warning)?), apex))
}

/// A rectangle of a plane, as a surface.
#[component(
    "439a55a5-2f9e-4f66-9de2-32f24fec2ef5",
    name = "Plane Surface",
    nick = "PlaneSrf",
    at = "Surface/Primitive"
)]
#[output("Plane", "P", "The surface; its parameters are the plane's coordinates.")]
fn plane_surface(
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// From where to where along its x axis.
    #[port("X Size", "X", default = Interval::new(-10.0, 10.0))]
    x: Interval,
    /// From where to where along its y axis.
    #[port("Y Size", "Y", default = Interval::new(-10.0, 10.0))]
    y: Interval,
) -> Result<Shared<Surface>, Message> {
    Ok(shared(PlaneSurface::new(plane, x.ordered(), y.ordered())?))
}

/// A rectangle of a plane that is large enough to reach all the way under and over a shape, as a surface.
#[component(
    "d8698126-0e91-4ae7-ba05-2490258573ea",
    name = "Plane Through Shape",
    nick = "PxS",
    at = "Surface/Primitive"
)]
#[output("Surface", "S", "The part of the plane.")]
fn plane_through_shape(
    /// The plane.
    #[port("Plane", "P")]
    plane: Plane,
    /// What the surface must be large enough for.
    #[port("Shape", "S")]
    shape: Geometry,
    /// By how much it is larger on every side, in units.
    #[port("Inflate", "I", default = 1.0)]
    inflate: f64,
) -> Result<Shared<Surface>, Message> {
    reaching(&plane, &shape.0, inflate)
}

/// The part of a plane under and over a shape, and a margin around it.
fn reaching(plane: &Plane, shape: &Value, margin: f64) -> Result<Shared<Surface>, Message> {
    let found = around(shape, plane).ok_or_else(|| {
        Message::warning(format!("A {} has no extent that can be measured yet", named(shape)))
    })?;
    let wider = |r: Interval| Interval::new(r.min() - margin, r.max() + margin);
    let surface = PlaneSurface::new(found.plane, wider(found.x), wider(found.y));
    Ok(shared(surface.map_err(warning)?))
}

/// A rectangle of a plane that is large enough to reach all the way under and over a box, as a surface.
#[component(
    "f565fd67-5a98-4b48-9ea9-2e184a9ef0e6",
    name = "Plane Through Box",
    nick = "PxB",
    at = "Surface/Primitive"
)]
#[output("Surfaces", "S", "The part of the plane.")]
fn plane_through_box(
    /// The plane.
    #[port("Plane", "P")]
    plane: Plane,
    /// The box that the surface must be large enough for.
    #[port("Box", "B")]
    shape: Box3,
    /// By how much it is larger on every side, in units.
    #[port("Inflate", "I", default = 1.0)]
    inflate: f64,
) -> Result<Shared<Surface>, Message> {
    reaching(&plane, &Value::Box(Shared::new(shape)), inflate)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Direction, Interval, Plane, Point3, Surface};

    fn surface(trial: Trial) -> Surface {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Surface(surface)) => (*surface).clone(),
            other => panic!("{other:?}"),
        }
    }

    fn domains(s: &Surface) -> [f64; 4] {
        let (u, v) = (s.domain(Direction::U), s.domain(Direction::V));
        [u.start, u.end, v.start, v.end]
    }

    #[test]
    fn round_surfaces() {
        let ball = surface(Trial::of("Sphere").item(Plane::XY).item(2.0));
        assert_eq!(domains(&ball), [0.0, 2.0 * TAU, -PI, PI]);
        assert!(ball.point_at(0.0, 0.0).distance_to(Point3::new(2.0, 0.0, 0.0)) < 1e-14);
        assert!(ball.point_at(PI, 0.0).distance_to(Point3::new(0.0, 2.0, 0.0)) < 1e-14);
        assert!(Trial::of("Sphere").item(Plane::XY).item(0.0).message().contains("radius"));

        let tube = surface(Trial::of("Cylinder").item(Plane::XY).item(0.5).item(-3.0));
        assert_eq!(domains(&tube), [0.0, PI, -3.0, 0.0]);
        assert!((tube.area().unwrap().area - 3.0 * PI).abs() < 1e-9);

        let cone = || Trial::of("Cone").item(Plane::XY).item(3.0).item(4.0);
        assert!((surface(cone()).area().unwrap().area - 15.0 * PI).abs() < 1e-8);
        assert_eq!(cone().texts(1), ["{0}: {0, 0, 4}"]);
        let outwards = surface(cone()).normal_at(0.0, surface(cone()).domain(Direction::V).middle()).unwrap();
        assert!(outwards.x > 0.0 && outwards.z > 0.0);
        assert!(!Trial::of("Cone").item(Plane::XY).item(3.0).item(0.0).message().is_empty());
    }

    #[test]
    fn flat_surfaces() {
        let flat =
            surface(Trial::of("Plane Surface").item(Plane::XZ).item(Interval::new(4.0, 1.0)).item(2.0));
        assert_eq!(domains(&flat), [1.0, 4.0, 0.0, 2.0]);
        assert_eq!(flat.point_at(4.0, 2.0), Point3::new(4.0, 0.0, 2.0));
        assert_eq!(Trial::of("Plane Surface").texts(0), ["{0}: Untrimmed Surface"]);

        let unit = Interval::new(0.0, 2.0);
        let shape = Box3 { plane: Plane::XY, x: unit, y: unit, z: Interval::new(5.0, 6.0) };
        for name in ["Plane Through Shape", "Plane Through Box"] {
            let under = surface(Trial::of(name).item(Plane::XY).item(shape).item(0.5));
            assert_eq!(under.point_at(-0.5, 2.5), Point3::new(-0.5, 2.5, 0.0));
            assert!((under.area().unwrap().area - 9.0).abs() < 1e-9);
        }
    }
}
