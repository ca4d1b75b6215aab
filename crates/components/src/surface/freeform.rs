//! Surface / Freeform: surfaces through points and between curves.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{
    Curve, Interval, KnotSpacing, Line, NurbsSurface, Point3, RevolutionSurface, SumSurface, Surface,
};

use super::{shared, warning};

/// A surface with a grid of points as its control points, or through them, of degree 3 where there are enough.
///
/// The grid is given row by row: with V points to a row, point i·V + j lies i steps along u and j along v.
#[component(
    "4b04a1e1-cddf-405d-a7db-335aaa940541",
    name = "Surface From Points",
    nick = "SrfGrid",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface.")]
fn surface_from_points(
    context: &Context<'_>,
    /// The points of the grid.
    #[port("Points", "P")]
    points: List<Point3>,
    /// How many points lie along u: a divisor of the number of points, at least 2.
    #[port("U Count", "U")]
    u_count: i32,
    /// Whether the surface goes through the points.
    #[port("Interpolate", "I", default = false)]
    interpolate: bool,
) -> Result<Shared<Surface>, Message> {
    let points: Vec<Point3> = points.present().collect();
    let rows = usize::try_from(u_count).ok().filter(|&u| u >= 2);
    let rows = rows.ok_or_else(|| Message::error("The U count must be at least 2"))?;
    let columns = points.len() / rows;
    if columns < 2 || columns * rows != points.len() {
        return Err(Message::error(format!(
            "{} points are no grid with {rows} along u and at least 2 along v",
            points.len()
        )));
    }
    context.bytes(points.len().saturating_mul(64))?;
    let (counts, degrees) = ([rows, columns], [rows, columns].map(|n| (n - 1).min(3)));
    let made = if interpolate {
        NurbsSurface::interpolate(degrees, counts, &points, KnotSpacing::Chord, [false, false])
    } else {
        NurbsSurface::clamped_uniform(degrees, counts, &points)
    };
    Ok(shared(made.map_err(warning)?))
}

/// A flat or saddle-shaped surface between four corners, or three.
///
/// u runs from A to B and v from A to D; each domain is as long as the longer of its two sides.
#[component(
    "c77a8b3b-c569-4d81-9b59-1c27299a1c45",
    name = "4Point Surface",
    nick = "Srf4Pt",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface.")]
fn four_point_surface(
    /// The first corner.
    #[port("Corner A", "A")]
    a: Point3,
    /// The second corner, counter-clockwise.
    #[port("Corner B", "B")]
    b: Point3,
    /// The third corner.
    #[port("Corner C", "C")]
    c: Point3,
    /// The fourth corner; without it the surface is a triangle, whose side opposite A and B is the point C.
    #[port("Corner D", "D")]
    d: Option<Point3>,
) -> Result<Shared<Surface>, Message> {
    let made = match d {
        Some(d) => NurbsSurface::from_corners(a, b, c, d),
        None => NurbsSurface::from_triangle(a, b, c),
    };
    Ok(shared(made.map_err(warning)?))
}

/// Straight lines between the points of two curves with the same parameter.
///
/// The curves are used in their own directions: when they run against each other, the surface is twisted.
#[component(
    "6e5de495-ba76-42d0-9985-a5c265e9aeca",
    name = "Ruled Surface",
    nick = "RuleSrf",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface: u runs along the curves, v from A, at 0, to B, at 1.")]
fn ruled_surface(
    /// The first curve.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The second curve.
    #[port("Curve B", "B")]
    b: &Curve,
) -> Result<Shared<Surface>, Message> {
    let (a, b) = (a.to_nurbs().map_err(warning)?, b.to_nurbs().map_err(warning)?);
    Ok(shared(NurbsSurface::ruled(&a, &b).map_err(warning)?))
}

/// The surface that a curve sweeps when it is moved along another without turning: a point A(u) + B(v) − B(start).
#[component(
    "5e33c760-adcd-4235-b1dd-05cf72eb7a38",
    name = "Sum Surface",
    nick = "SumSrf",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface: u runs along A, v along B.", kind = Brep)]
fn sum_surface(
    /// The curve that is moved.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The curve along which it is moved.
    #[port("Curve B", "B")]
    b: &Curve,
) -> Result<Shared<Surface>, Message> {
    let back = -b.start().to_vector();
    Ok(shared(SumSurface::new(a.clone(), b.clone(), back).map_err(warning)?))
}

/// The surface that a curve sweeps when it turns about an axis.
///
/// The angles are radians, counted from where the curve lies; at most a full turn is made.
#[component(
    "cdee962f-4202-456b-a1b4-f3ed9aa0dc29",
    name = "Revolution",
    nick = "RevSrf",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface: u is the angle, v runs along the curve.", kind = Brep)]
fn revolution(
    context: &Context<'_>,
    /// The profile.
    #[port("Curve", "P")]
    profile: &Curve,
    /// The axis; seen against its direction the curve turns counter-clockwise.
    #[port("Axis", "A")]
    axis: Line,
    /// From which angle to which, in radians.
    #[port("Domain", "D", default = Interval::new(0.0, std::f64::consts::TAU))]
    domain: Interval,
) -> Result<Shared<Surface>, Message> {
    let mut angle = domain.ordered();
    if angle.length() > std::f64::consts::TAU {
        if angle.length() > std::f64::consts::TAU + 1e-9 {
            context.warn("The domain is longer than a full turn: a full turn is made");
        }
        angle = Interval::new(angle.start, angle.start + std::f64::consts::TAU);
    }
    Ok(shared(RevolutionSurface::new(profile.clone(), axis, angle).map_err(warning)?))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Circle, Direction, Interval, Line, Plane, Point3, Surface};

    fn surface(trial: Trial) -> Surface {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Surface(surface)) => (*surface).clone(),
            other => panic!("{other:?}"),
        }
    }

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    #[test]
    fn grids_of_points() {
        let grid: Vec<Point3> =
            (0..20).map(|i| p(f64::from(i / 4), f64::from(i % 4), f64::from(i % 3))).collect();
        let made = |through: bool| Trial::of("Surface From Points").list(grid.clone()).item(5).item(through);
        let loose = surface(made(false));
        assert_eq!(loose.domain(Direction::U), Interval::new(0.0, 2.0));
        assert_eq!(loose.domain(Direction::V), Interval::new(0.0, 1.0));
        assert_eq!(loose.point_at(2.0, 0.0), p(4.0, 0.0, 1.0));
        let through = surface(made(true));
        for q in &grid {
            assert!(through.closest_point(*q).unwrap().distance < 1e-9);
        }
        assert!(Trial::of("Surface From Points").list(grid.clone()).item(3).message().contains("20 points"));
        assert!(Trial::of("Surface From Points").list(grid).item(-3).message().contains("at least 2"));
    }

    #[test]
    fn corners_and_rulings() {
        let quad = || {
            Trial::of("4Point Surface").item(p(0.0, 0.0, 0.0)).item(p(4.0, 0.0, 0.0)).item(p(4.0, 3.0, 0.0))
        };
        let flat = surface(quad().item(p(0.0, 3.0, 0.0)));
        assert!((flat.area().unwrap().area - 12.0).abs() < 1e-9);
        assert_eq!(flat.point_at(4.0, 0.0), p(4.0, 0.0, 0.0));
        assert!((surface(quad()).area().unwrap().area - 6.0).abs() < 1e-9);

        let (a, b) =
            (Line::new(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)), Line::new(p(0.0, 1.0, 0.0), p(0.0, 1.0, 1.0)));
        let saddle = surface(Trial::of("Ruled Surface").item(a).item(b));
        assert!(saddle.point_at(0.5, 0.5).distance_to(p(0.25, 0.5, 0.25)) < 1e-15);
        let sum = surface(Trial::of("Sum Surface").item(a).item(b));
        assert_eq!(sum.point_at(1.0, 1.0), p(1.0, 0.0, 1.0));
        assert_eq!(Trial::of("Sum Surface").item(a).item(b).texts(0), ["{0}: Untrimmed Surface"]);
    }

    #[test]
    fn revolutions() {
        let profile = Line::new(p(1.0, 0.0, 0.0), p(1.0, 0.0, 2.0));
        let axis = Line::new(p(0.0, 0.0, 0.0), p(0.0, 0.0, 1.0));
        let made = || Trial::of("Revolution").item(profile).item(axis);
        assert!((surface(made()).area().unwrap().area - 4.0 * PI).abs() < 1e-9);
        let half = surface(made().item(Interval::new(0.0, PI)));
        assert!(half.point_at(PI, 1.0).distance_to(p(-1.0, 0.0, 2.0)) < 1e-15);
        assert!(made().item(Interval::new(0.0, 2.0 * TAU)).message().contains("full turn"));
        assert!(!made().item(Interval::new(1.0, 1.0)).message().is_empty());
        let tube = Circle { plane: Plane { origin: p(3.0, 0.0, 0.0), ..Plane::XZ }, radius: 1.0 };
        let torus = surface(Trial::of("Revolution").item(tube).item(axis));
        assert!((torus.area().unwrap().area - 4.0 * PI * PI * 3.0).abs() < 1e-7);
    }
}
