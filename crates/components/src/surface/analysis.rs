//! Surface / Analysis: places on surfaces, their sizes and control points. Trims count where that is said.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Face;
use katydid_geometry::{Brep, Containment, Direction, Plane, Point3, Surface, Vector3};

use super::{uv, warning};
use crate::prepared;

/// The point, the unit normal and the tangent plane at a pair of parameters.
type Place = (Point3, Option<Vector3>, Option<Plane>);

fn place(context: &Context<'_>, face: &Face, at: Point3) -> Result<Place, Message> {
    let (u, v) = uv(at)?;
    let outside = Direction::BOTH.iter().zip([u, v]).any(|(d, t)| {
        let domain = face.surface.domain(*d);
        let slack = 1e-9 * domain.length();
        !(domain.start - slack <= t && t <= domain.end + slack)
    });
    if outside {
        context.warn("The parameters lie outside the surface's domain: it is continued there");
    }
    Ok((face.point_at(u, v), face.normal_at(u, v), face.frame_at(u, v)))
}

/// The point, normal, directions and tangent plane of a surface at a pair of parameters in its own domains.
///
/// Reparameterize the surface to give them from 0 to 1. A surface that is only a line there has no normal: nulls. The
/// normal of a face of a solid looks outward: where that is against the surface's own, the frame is turned over, with x
/// along v and y along u.
#[component(
    "353b206e-bde5-4f02-a913-b3b8a977d4b9",
    name = "Evaluate Surface",
    nick = "EvalSrf",
    at = "Surface/Analysis"
)]
#[output("Point", "P", "The point.")]
#[output("Normal", "N", "The unit normal.")]
#[output("U direction", "U", "The unit vector along which u grows.")]
#[output("V direction", "V", "The unit vector along which v grows.")]
#[output("Frame", "F", "The tangent plane, its z axis along the normal.")]
fn evaluate_surface(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    face: Face,
    /// The parameters, u as x and v as y.
    #[port("Point", "uv")]
    at: Point3,
) -> Result<(Point3, Option<Vector3>, Option<Vector3>, Option<Vector3>, Option<Plane>), Message> {
    let (point, normal, frame) = place(context, &face, at)?;
    let (u, v) = (at.x, at.y);
    let d = face.surface.derivatives(u, v, 1, face.surface.inner_quadrant(u, v));
    // At a pole one of the derivatives vanishes; the frame says how it comes in.
    let at_pole = face.surface.frame_at(u, v);
    let along_u = d.get(1, 0).unitized().or(at_pole.map(|f| f.x_axis));
    let along_v = d.get(0, 1).unitized().or(at_pole.map(|f| f.y_axis));
    Ok((point, normal, along_u, along_v, frame))
}

/// The point, normal and tangent plane of a surface at a pair of parameters in its own domains.
#[component(
    "aa1dc107-70de-473e-9636-836030160fc3",
    name = "Evaluate Surface",
    nick = "EvalSrf",
    at = "Surface/Analysis",
    old
)]
#[output("Point", "P", "The point.")]
#[output("Normal", "N", "The unit normal.")]
#[output("Frame", "F", "The tangent plane, its z axis along the normal.")]
fn evaluate_surface_without_directions(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    face: Face,
    /// The parameters, u as x and v as y.
    #[port("Point", "uv")]
    at: Point3,
) -> Result<(Point3, Option<Vector3>, Option<Plane>), Message> {
    place(context, &face, at)
}

/// The point of a surface that is nearest to a point.
#[component(
    "4a9e9a8e-0943-4438-b360-129c30f2bb0f",
    name = "Surface Closest Point",
    nick = "Srf CP",
    at = "Surface/Analysis"
)]
#[output("Point", "P", "The nearest point of the surface.")]
#[output("UV Point", "uvP", "Its parameters, u as x and v as y.")]
#[output("Distance", "D", "How far away it is.")]
fn surface_closest_point(
    context: &Context<'_>,
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Surface>,
) -> Result<(Point3, Point3, f64), Message> {
    let near = prepared::surface(context, &surface)?.nearest(point)?;
    Ok((near.point, Point3::new(near.u, near.v, 0.0), near.distance))
}

/// The control points of a surface, of its exact NURBS form where it has none of its own.
///
/// They are listed row by row: with V points to a row, point i·V + j is the i-th along u and the j-th along v.
#[component(
    "15128198-399d-4d6c-9586-1f65db3ce7bf",
    name = "Surface Points",
    nick = "SrfPt",
    at = "Surface/Analysis"
)]
#[output("Points", "P", "The control points.")]
#[output("Weights", "W", "Their weights.")]
#[output("Greville", "G", "For each the parameters where it acts most, u as x and v as y.")]
#[output("U Count", "U", "How many there are along u.")]
#[output("V Count", "V", "How many there are along v.")]
fn surface_points(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
) -> Result<(Vec<Point3>, Vec<f64>, Vec<Point3>, i32, i32), Message> {
    let nurbs = surface.to_nurbs().map_err(warning)?;
    context.items(nurbs.point_count().saturating_mul(3))?;
    let [us, vs] = Direction::BOTH.map(|d| nurbs.greville_abscissae(d));
    let greville = us.iter().flat_map(|&u| vs.iter().map(move |&v| Point3::new(u, v, 0.0))).collect();
    let [m, n] = nurbs.counts().map(|n| i32::try_from(n).unwrap_or(i32::MAX));
    Ok((nurbs.control_points(), nurbs.weights(), greville, m, n))
}

/// The size of a surface: the lengths of the curves through its middle.
#[component(
    "f241e42e-8983-4ed3-b869-621c07630b00",
    name = "Dimensions",
    nick = "Dim",
    at = "Surface/Analysis"
)]
#[output("U dimension", "U", "The length along u, in the middle of v.")]
#[output("V dimension", "V", "The length along v, in the middle of u.")]
fn dimensions(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
) -> (f64, f64) {
    let length = |along: Direction| {
        let middle = surface.domain(along.other()).middle();
        // A curve that is a single point on the axis is none.
        surface.isocurve(along, middle).map_or(0.0, |curve| curve.length())
    };
    (length(Direction::U), length(Direction::V))
}

/// Whether a surface is flat within the tolerance.
#[component(
    "d4bc9653-c770-4bee-a31d-d120cbb75b39",
    name = "Is Planar",
    nick = "Planar",
    at = "Surface/Analysis"
)]
#[output("Planar", "F", "Whether all of it lies in a plane.")]
#[output("Plane", "P", "The plane; null when it is not flat.")]
fn is_planar(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Whether only what lies inside the trims counts. Surfaces without trims are the same either way.
    #[port("Interior", "I", default = false)]
    interior: bool,
) -> (bool, Option<Plane>) {
    let _ = interior;
    let plane = surface.plane(context.tolerance().absolute);
    (plane.is_some(), plane)
}

/// Whether a pair of parameters lies on a surface and not on a part that was trimmed away.
#[component(
    "f881810b-96de-4668-a95a-f9a6d683e65c",
    name = "Point In Trim",
    nick = "TrimInc",
    at = "Surface/Analysis"
)]
#[output("Inclusion", "I", "Whether it does; the edge counts.")]
fn point_in_trim(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Brep>,
    /// The parameters, u as x and v as y.
    #[port("UV Point", "P")]
    at: Point3,
) -> Result<bool, Message> {
    let ([_], Some(whole)) = (surface.faces(), surface.face_surface(0)) else {
        return Err(Message::error("A Brep of several faces has no parameters: take it apart"));
    };
    let (u, v) = uv(at)?;
    let domains = Direction::BOTH.map(|d| whole.domain(d));
    if !(domains[0].contains(u) && domains[1].contains(v)) {
        return Ok(false);
    }
    let near = 1e-9 * domains[0].length().min(domains[1].length());
    Ok(prepared::brep(context, &surface)?.covers(0, u, v, near).map_err(warning)? != Containment::Outside)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{
        Circle, Cone, Direction, Interval, NurbsSurface, Plane, PlaneSurface, Point3, Sphere, Surface,
        Vector3,
    };

    /// The faces of a solid look outward, also those whose surfaces do not.
    #[test]
    fn normals_of_faces_look_outward() {
        let ring = Circle { plane: Plane::XY, radius: 2.0 };
        for height in [3.0, -3.0] {
            let disc = Trial::of("Boundary Surfaces").list([ring]).run().outputs[0].column().get(0).unwrap();
            let rod = Trial::of("Extrude").item(disc).item(Vector3::new(0.0, 0.0, height)).run();
            let parts = Trial::of("Deconstruct Brep").tree(rod.outputs[0].clone()).run();
            let middle = Point3::new(0.0, 0.0, 0.5 * height);
            let mut turned = 0;
            for face in (0..3).map(|i| parts.outputs[0].column().get(i).unwrap()) {
                let Some(Ok(brep)) = face.brep() else { panic!("a face") };
                turned += usize::from(brep.faces()[0].reversed);
                let [u, v] = Direction::BOTH.map(|d| brep.face_surface(0).unwrap().domain(d).at(0.3));
                let found =
                    Trial::of("Evaluate Surface").item(face.clone()).item(Point3::new(u, v, 0.0)).run();
                let get = |port: usize| found.outputs[port].column().get(0).unwrap();
                let (Value::Point(p), Value::Vector(n), Value::Plane(frame)) = (get(0), get(1), get(4))
                else {
                    panic!("{found:?}")
                };
                assert!(n.dot(p - middle) > 1.0, "{n:?} at {p:?}");
                assert!((frame.z_axis - n).length() < 1e-12);
                assert!((frame.x_axis.cross(frame.y_axis) - n).length() < 1e-12);
                for (name, port) in [("Divide Surface", 1), ("Surface Frames", 0)] {
                    let grid = Trial::of(name).item(face.clone()).item(2).item(2).run();
                    match grid.outputs[port].column().get(4) {
                        Some(Value::Vector(n)) => {
                            assert!(n.dot(p - middle) > 0.0 || n.dot(p - middle) < -1.0)
                        }
                        Some(Value::Plane(f)) => assert!((f.z_axis.length() - 1.0).abs() < 1e-12),
                        other => panic!("{other:?}"),
                    }
                }
            }
            assert!(turned > 0, "a face looks against its surface");
        }
    }

    fn ball() -> Surface {
        Sphere::around(Point3::ORIGIN, 2.0).unwrap().into()
    }

    fn flat() -> Surface {
        PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 3.0)).unwrap().into()
    }

    #[test]
    fn places_on_surfaces() {
        let at = |u: f64, v: f64| Trial::of("Evaluate Surface").item(ball()).item(Point3::new(u, v, 0.0));
        assert_eq!(at(0.0, 0.0).texts(0), ["{0}: {2, 0, 0}"]);
        assert_eq!(at(0.0, 0.0).texts(1).join("").replace("-0", "0"), "{0}: {1, 0, 0}");
        assert_eq!(at(0.0, 0.0).texts(2).join("").replace("-0", "0"), "{0}: {0, 1, 0}");
        assert_eq!(at(0.0, 0.0).texts(3).join("").replace("-0", "0"), "{0}: {0, 0, 1}");
        assert_eq!(
            at(0.0, 0.0).texts(4).join("").replace("-0", "0"),
            "{0}: O(2.00,0.00,0.00) Z(1.00,0.00,0.00)"
        );
        // At the pole ∂S/∂u vanishes, yet there is a normal.
        assert_eq!(at(0.0, FRAC_PI_2).texts(1).join("").replace("-0", "0"), "{0}: {0, 0, 1}");
        assert!(at(9.0, 0.0).message().contains("outside"));
        assert!(at(f64::NAN, 0.0).message().contains("finite"));
        let old = Trial::of_guid("aa1dc107-70de-473e-9636-836030160fc3").item(flat());
        assert_eq!(old.item(Point3::new(1.0, 2.0, 0.0)).texts(0), ["{0}: {1, 2, 0}"]);

        let near = || Trial::of("Surface Closest Point").item(Point3::new(0.0, 5.0, 0.0)).item(ball());
        assert_eq!(near().texts(0), ["{0}: {0, 2, 0}"]);
        assert_eq!(near().texts(1), ["{0}: {1.570796, 0, 0}"]);
        assert_eq!(near().texts(2), ["{0}: 3"]);
        let inside = |u: f64| Trial::of("Point In Trim").item(flat()).item(Point3::new(u, 3.0, 0.0)).texts(0);
        assert_eq!((inside(4.0), inside(4.5)), (vec!["{0}: True".into()], vec!["{0}: False".into()]));
    }

    #[test]
    fn sizes_and_control_points() {
        let points = || Trial::of("Surface Points").item(flat());
        assert_eq!(points().texts(0), ["{0;0}: {0, 0, 0}, {0, 3, 0}, {4, 0, 0}, {4, 3, 0}"]);
        assert_eq!(points().texts(1), ["{0;0}: 1, 1, 1, 1"]);
        assert_eq!(points().texts(2), ["{0;0}: {0, 0, 0}, {0, 3, 0}, {4, 0, 0}, {4, 3, 0}"]);
        assert_eq!(Trial::of("Surface Points").item(ball()).texts(3), ["{0}: 9"]);
        assert_eq!(Trial::of("Surface Points").item(ball()).texts(4), ["{0}: 5"]);

        let lengths = |s: Surface| [0, 1].map(|k| Trial::of("Dimensions").item(s.clone()).texts(k).join(""));
        assert_eq!(lengths(flat()), ["{0}: 4", "{0}: 3"]);
        assert_eq!(lengths(ball()), ["{0}: 12.566371", "{0}: 6.283185"]);
        let cone = Cone::new(Plane::XY, 4.0, 3.0).unwrap();
        assert_eq!(lengths(cone.into()), [format!("{{0}}: {:.6}", 3.0 * PI), "{0}: 5".to_owned()]);

        assert_eq!(Trial::of("Is Planar").item(flat()).texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("Is Planar").item(ball()).texts(0), ["{0}: False"]);
        assert_eq!(Trial::of("Is Planar").item(ball()).texts(1), ["{0}: null"]);
        let corner = |x: f64, y: f64, z: f64| Point3::new(x, y, z);
        let saddle = NurbsSurface::from_corners(
            corner(0.0, 0.0, 0.0),
            corner(1.0, 0.0, 0.0),
            corner(1.0, 1.0, 1.0),
            corner(0.0, 1.0, 0.0),
        );
        assert_eq!(Trial::of("Is Planar").item(Surface::from(saddle.unwrap())).texts(0), ["{0}: False"]);
    }
}
