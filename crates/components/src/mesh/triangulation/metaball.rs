//! Outlines of metaballs.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::isoline::Metaballs;
use katydid_geometry::{Curve, Plane, Point2, Point3, PolylineCurve};

/// How often a ball is looked at for a cell before the outline counts as too fine.
const MOST_LOOKS: usize = 1_000_000_000;

/// The closed lines of a field at a threshold, in space.
fn outlines(
    context: &Context<'_>,
    field: &Metaballs,
    plane: &Plane,
    threshold: f64,
    accuracy: Option<f64>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let accuracy = accuracy.unwrap_or_else(|| field.usual_accuracy(threshold));
    let lines = field.isolines(threshold, accuracy, MOST_LOOKS)?;
    context.items(lines.iter().map(|l| l.points.len()).sum())?;
    let curve = |points: &[Point2]| -> Result<Shared<Curve>, Message> {
        let ring = points.iter().chain(points.first());
        let points: Vec<Point3> = ring.map(|p| plane.at(p.x, p.y, 0.0)).collect();
        Ok(Shared::new(PolylineCurve::new(points)?.into()))
    };
    lines.iter().filter(|l| l.closed).map(|l| curve(&l.points)).collect()
}

/// The outline of balls that melt together where they come near, at the strength that their field has at a point.
///
/// The field is the sum of 1/d², d the distance from a ball's middle in space; the outline is where it is as strong as
/// at the point.
#[component(
    "dc934310-67eb-4d1d-8607-7cc62a501dd9",
    name = "MetaBall",
    nick = "MetaBall",
    at = "Mesh/Triangulation"
)]
#[output("Isocurve", "I", "The outlines: closed polylines in the plane.")]
fn metaball(
    context: &Context<'_>,
    /// The middles of the balls; nulls are left out.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane of the outline.
    #[port("Plane", "Pl")]
    plane: Plane,
    /// A point on the outline; off the plane the nearest point of the plane counts. Not the middle of a ball.
    #[port("Point", "X")]
    point: Point3,
    /// How long the pieces of the outline are, about; greater than 0.
    #[port("Accuracy", "A")]
    accuracy: f64,
) -> Result<Vec<Shared<Curve>>, Message> {
    let points: Vec<Point3> = points.present().collect();
    let field = Metaballs::new(&points, &[1.0], &plane)?;
    if points.is_empty() {
        return Ok(Vec::new());
    }
    let [x, y, _] = plane.coordinates(point);
    let threshold = field.at(Point2::new(x, y));
    if !threshold.is_finite() {
        return Err(Message::error("The point is the middle of a ball, or not finite"));
    }
    outlines(context, &field, &plane, threshold, Some(accuracy))
}

/// The outline of balls that melt together where they come near, at a strength of their field.
///
/// The field is the sum of 1/d², d the distance from a ball's middle in space: a ball by itself, cut through its middle,
/// is a circle of radius √(1/threshold).
#[component(
    "c48cf4d4-432c-41b6-b77a-77650479a31f",
    name = "MetaBall(t)",
    nick = "MetaBall(t)",
    at = "Mesh/Triangulation"
)]
#[output("Isocurve", "I", "The outlines: closed polylines in the plane.")]
fn metaball_t(
    context: &Context<'_>,
    /// The middles of the balls; nulls are left out.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane of the outline.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
    /// The strength of the field along the outline: a larger one gives smaller balls. Not 0.
    #[port("Threshold", "T", default = 0.5)]
    threshold: f64,
    /// How long the pieces of the outline are, about; greater than 0. Without one an eighth of the smallest ball.
    #[port("Accuracy", "A", optional)]
    accuracy: Option<f64>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let points: Vec<Point3> = points.present().collect();
    let field = Metaballs::new(&points, &[1.0], &plane)?;
    outlines(context, &field, &plane, threshold, accuracy)
}

/// The outline of balls of different charges that melt together where they come near, at a strength of their field.
///
/// The field is the sum of charge/d², d the distance from a ball's middle in space. Negative charges eat away.
#[component(
    "c4373505-a4cf-4992-8db1-fd6e6bb5850d",
    name = "MetaBall(t) Custom",
    nick = "MetaBall(t)",
    at = "Mesh/Triangulation"
)]
#[output("Isocurve", "I", "The outlines: closed polylines in the plane.")]
fn metaball_t_custom(
    context: &Context<'_>,
    /// The middles of the balls; nulls are left out with their charges.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The charge of each ball; the last one holds for all balls after it.
    #[port("Charge", "C")]
    charge: List<f64>,
    /// The plane of the outline.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
    /// The strength of the field along the outline: a larger one gives smaller balls. Not 0.
    #[port("Threshold", "T", default = 0.5)]
    threshold: f64,
    /// How long the pieces of the outline are, about; greater than 0. Without one an eighth of the smallest ball.
    #[port("Accuracy", "A", optional)]
    accuracy: Option<f64>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let last = charge.len().checked_sub(1).ok_or_else(|| Message::error("There are no charges"))?;
    let balls = points.iter().enumerate().filter_map(|(i, p)| Some((p?, charge.get(i.min(last))?)));
    let (points, mut charges): (Vec<Point3>, Vec<f64>) = balls.unzip();
    if charges.is_empty() {
        charges.push(0.0);
    }
    let field = Metaballs::new(&points, &charges, &plane)?;
    outlines(context, &field, &plane, threshold, accuracy)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Plane, Point3};

    fn row() -> [Point3; 2] {
        [Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0)]
    }

    /// The number of outlines, and the area of the first.
    fn seen(trial: Trial) -> (usize, f64) {
        let out = trial.run().outputs[0].clone();
        let areas = Trial::of("Area").tree(out.clone()).texts(0).join("");
        let first = areas.split([':', ',']).nth(1).and_then(|a| a.trim().parse().ok());
        (out.item_count(), first.unwrap_or(0.0))
    }

    #[test]
    fn balls_alone_and_together() {
        let one = Trial::of("MetaBall(t)").list([Point3::ORIGIN]).item(Plane::XY).item(0.25).item(0.01);
        let (n, area) = seen(one);
        assert!(n == 1 && (area - 4.0 * std::f64::consts::PI).abs() < 1e-3, "{n} {area}");
        assert_eq!(seen(Trial::of("MetaBall(t)").list(row()).default().item(1.0)).0, 2);
        assert_eq!(seen(Trial::of("MetaBall(t)").list(row())).0, 1);
        assert!(Trial::of("MetaBall(t)").list(row()).default().item(0.0).message().contains("threshold"));
        let fine = Trial::of("MetaBall(t)").list(row()).default().default().item(1e-9);
        assert!(fine.message().contains("accuracy"));
    }

    #[test]
    fn charges() {
        let trial = |charges: &[f64]| {
            Trial::of("MetaBall(t) Custom").list(row()).list(charges.to_vec()).default().item(1.0)
        };
        assert_eq!(seen(trial(&[1.0])).0, 2);
        assert_eq!(seen(trial(&[1.0, -1.0])).0, 1);
        assert_eq!(seen(trial(&[1.0, 9.0])).0, 1);
        let alone = Trial::of("MetaBall(t) Custom")
            .gaps([Some(Point3::ORIGIN), None])
            .list([4.0, -9.0])
            .default()
            .item(1.0);
        assert!((seen(alone).1 - 4.0 * std::f64::consts::PI).abs() < 0.1);
    }

    #[test]
    fn through_a_point() {
        let x = Point3::new(0.0, 2.0, 7.0);
        let trial = |points: &[Point3]| {
            Trial::of("MetaBall").list(points.to_vec()).item(Plane::XY).item(x).item(0.02)
        };
        assert!((seen(trial(&row()[..1])).1 - 4.0 * std::f64::consts::PI).abs() < 1e-2);
        let middle = Trial::of("MetaBall").list(row()).item(Plane::XY).item(Point3::ORIGIN).item(0.1);
        assert!(middle.message().contains("middle of a ball"));
    }
}
