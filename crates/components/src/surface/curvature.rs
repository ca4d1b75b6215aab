//! Surface / Analysis: how surfaces bend.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Circle, Curve, Plane, Point3, Surface, SurfaceCurvature, Vector3};

use super::{uv, warning};

fn bending(surface: &Surface, at: Point3) -> Result<(SurfaceCurvature, Option<Plane>), Message> {
    let (u, v) = uv(at)?;
    let found = surface.curvature_at(u, v).map_err(warning)?;
    Ok((found, surface.frame_at(u, v)))
}

/// The largest and the smallest curvature of the sections of a surface by planes through its normal.
///
/// They are reciprocals of radii, positive where the surface bends towards its normal. Where all sections bend alike,
/// as on a sphere, the first direction is that of u. A pole or an apex has none: a warning.
#[component(
    "404f75ac-5594-4c48-ad8a-7d0f472bbf8a",
    name = "Principal Curvature",
    nick = "Curvature",
    at = "Surface/Analysis"
)]
#[output("Frame", "F", "The tangent plane.")]
#[output("Maximum", "C¹", "The larger curvature.")]
#[output("Minimum", "C²", "The smaller curvature.")]
#[output("Max direction", "K¹", "The unit direction of the section that bends most.")]
#[output("Min direction", "K²", "The unit direction of the section that bends least, square to the other.")]
fn principal_curvature(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The parameters, u as x and v as y.
    #[port("Point", "uv")]
    at: Point3,
) -> Result<(Option<Plane>, f64, f64, Vector3, Vector3), Message> {
    let (found, frame) = bending(surface, at)?;
    let ([most, least], [first, second]) = (found.principal, found.directions);
    Ok((frame, most, least, first, second))
}

/// The Gaussian and the mean curvature of a surface: the product of its principal curvatures, and half their sum.
///
/// A pole or an apex has none: a warning.
#[component(
    "4139f3a3-cf93-4fc0-b5e0-18a3acd0b003",
    name = "Surface Curvature",
    nick = "Curvature",
    at = "Surface/Analysis"
)]
#[output("Frame", "F", "The tangent plane.")]
#[output("Gaussian", "G", "The product: positive on a dome, negative on a saddle, 0 where it unrolls flat.")]
#[output("Mean", "M", "The mean of the two.")]
fn surface_curvature(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The parameters, u as x and v as y.
    #[port("Point", "uv")]
    at: Point3,
) -> Result<(Option<Plane>, f64, f64), Message> {
    let (found, frame) = bending(surface, at)?;
    Ok((frame, found.gaussian, found.mean))
}

/// The circles that follow a surface best in its two principal directions.
///
/// They lie in the planes of the normal and those directions. Where the surface is straight there is none: null.
#[component(
    "b799b7c0-76df-4bdb-b3cc-401b1d021aa5",
    name = "Osculating Circles",
    nick = "Osc",
    at = "Surface/Analysis"
)]
#[output("Point", "P", "The point of the surface.")]
#[output("First circle", "C1", "The circle in the direction of the larger curvature.", kind = Curve)]
#[output("Second circle", "C2", "The circle in the direction of the smaller curvature.", kind = Curve)]
fn osculating_circles(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The parameters, u as x and v as y.
    #[port("Point", "uv")]
    at: Point3,
) -> Result<(Point3, Option<Circle>, Option<Circle>), Message> {
    let (u, v) = uv(at)?;
    let (found, _) = bending(surface, at)?;
    let [first, second] = found.directions;
    let circle = |k: f64, direction: Vector3| -> Result<Option<Circle>, Message> {
        // Rounding makes a straight section bend a little.
        if !(k.abs() > 1e-14 * (found.principal[0].abs() + found.principal[1].abs())) || k.abs() < 1e-16 {
            return Ok(None);
        }
        Ok(surface.normal_section(u, v, direction).map_err(warning)?.osculating_circle())
    };
    let [most, least] = found.principal;
    Ok((found.point, circle(most, first)?, circle(least, second)?))
}

/// The lines on which a surface changes from a dome to a saddle: there its Gaussian curvature is 0.
///
/// What unrolls flat and what is a dome everywhere has none. Trims are not heeded.
#[component(
    "0efd7f0c-f63d-446d-970e-9fb0e636ea41",
    name = "Surface Inflection",
    nick = "SInf",
    at = "Surface/Analysis"
)]
#[output("Curves", "C", "The lines, as polylines.")]
fn surface_inflection(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// How far the polylines may be from the lines; the document's tolerance when it is left out.
    #[port("Tolerance", "T", optional)]
    tolerance: Option<f64>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let lines =
        surface.inflection_lines(tolerance.unwrap_or(context.tolerance().absolute)).map_err(warning)?;
    Ok(lines.into_iter().map(|line| Shared::new(line.into())).collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Cylinder, Interval, Plane, PlaneSurface, Point3, Sphere, Surface, Torus};

    fn at(name: &str, surface: impl Into<Surface>, u: f64, v: f64) -> Trial {
        Trial::of(name).item(surface.into()).item(Point3::new(u, v, 0.0))
    }

    fn tube() -> Cylinder {
        Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 3.0)).unwrap()
    }

    #[test]
    fn principal_gaussian_and_mean() {
        // The normal of a cylinder points outwards: it bends away from it round the axis.
        let on_tube = |k: usize| at("Principal Curvature", tube(), 0.0, 1.0).texts(k).join("");
        assert_eq!((on_tube(1), on_tube(2)), ("{0}: 0".into(), "{0}: -0.5".into()));
        assert_eq!(on_tube(0), "{0}: O(2.00,0.00,1.00) Z(1.00,0.00,0.00)");
        let ball = Sphere::around(Point3::ORIGIN, 4.0).unwrap();
        assert_eq!(at("Surface Curvature", ball, 1.0, 0.5).texts(1), ["{0}: 0.0625"]);
        assert_eq!(at("Surface Curvature", ball, 1.0, 0.5).texts(2), ["{0}: -0.25"]);
        // On the inside of a torus: 1/r and −1/(R − r).
        let torus = Torus::new(Plane::XY, 3.0, 1.0).unwrap();
        let inner = at("Surface Curvature", torus, 0.0, std::f64::consts::PI);
        assert_eq!(inner.texts(1), ["{0}: -0.5"]);
        let pole = at("Surface Curvature", ball, 0.0, std::f64::consts::FRAC_PI_2);
        assert!(!pole.message().is_empty());
    }

    #[test]
    fn circles_of_normal_sections() {
        let run = at("Osculating Circles", tube(), 0.0, 1.0).run();
        assert_eq!(run.outputs[1].column().get(0), None);
        let Some(Value::Circle(circle)) = run.outputs[2].column().get(0) else { panic!("a circle") };
        assert!((circle.radius - 2.0).abs() < 1e-12);
        assert!(circle.center().distance_to(Point3::new(0.0, 0.0, 1.0)) < 1e-12);
        let flat = PlaneSurface::new(Plane::XY, Interval::UNIT, Interval::UNIT).unwrap();
        assert_eq!(at("Osculating Circles", flat, 0.5, 0.5).texts(1), ["{0}: null"]);
    }

    #[test]
    fn a_torus_changes_on_its_top_and_bottom() {
        let torus: Surface = Torus::new(Plane::XY, 3.0, 1.0).unwrap().into();
        let lines = Trial::of("Surface Inflection").item(torus).item(1e-4).run();
        let tree = lines.outputs.first().unwrap();
        let curves: Vec<_> = tree.branches().flat_map(|b| b.iter().flatten().collect::<Vec<_>>()).collect();
        assert_eq!(curves.len(), 2);
        for value in curves {
            let Value::Curve(curve) = value else { panic!("no curve") };
            let height = curve.point_at(curve.domain().start).z;
            assert!((height.abs() - 1.0).abs() < 1e-9);
            assert!((curve.length() / (6.0 * std::f64::consts::PI) - 1.0).abs() < 1e-4);
        }
        let ball: Surface = Sphere::around(Point3::ORIGIN, 4.0).unwrap().into();
        for none in [ball, tube().into()] {
            assert_eq!(Trial::of("Surface Inflection").item(none).texts(0), ["{0;0}:"]);
        }
    }
}
