//! Goals-Pt: points that hold to places and to each other.

use katydid_component::{List, Message, component};
use katydid_data::Value;
use katydid_geometry::{CancellationToken, Point3, Vector3, Xform};

use super::goal::{Place, finite};
use super::lines::yielded;
use super::thresholds::{HOLD, MOST_PAIRS};
use super::{Goal, Pull, Rule};

/// A point pulled to a place, along the axes that count.
#[derive(Debug)]
struct Anchor {
    target: Point3,
    axes: [bool; 3],
    strength: f64,
}

impl Rule for Anchor {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let (Some(p), Some(pull)) = (points.first(), pulls.first_mut()) else { return };
        let way = self.target - *p;
        let along = |axis: usize, x: f64| if self.axes[axis] { x } else { 0.0 };
        *pull = Pull::new(Vector3::new(along(0, way.x), along(1, way.y), along(2, way.z)), self.strength);
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        points.first().map(|p| Value::Point(*p))
    }
}

/// Holds a point at a place, with a spring of this strength. Stands for Kangaroo 2's Anchor.
#[component(
    "3c30b1a1-4473-4ad4-a700-ea9770726c03",
    name = "Anchor",
    nick = "Anchor",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("A", "A", "The goal, for a solver.")]
fn anchor(
    /// The point to hold.
    #[port("P", "P")]
    point: Point3,
    /// Where to hold it; where it is when nothing is given.
    #[port("T", "T", optional)]
    target: Option<Point3>,
    /// The strength of the spring.
    #[port("Strength", "Strength", default = HOLD)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    let rule = Anchor { target: target.unwrap_or(point), axes: [true; 3], strength };
    Goal::item("Kangaroo goal: Anchor", vec![point], rule)
}

/// Holds a point where it is, with a spring of this strength. Stands for an earlier Anchor of Kangaroo 2.
#[component(
    "b476d3d0-4daf-489c-b91a-49f5dd72a256",
    name = "Anchor",
    nick = "Anchor",
    at = "Kangaroo2/Goals-Pt",
    old
)]
#[output("A", "A", "The goal, for a solver.")]
fn anchor_by_number(
    /// The point to hold.
    #[port("P", "P")]
    point: Point3,
    /// The number of the particle to hold there; the one at the point when nothing, or a negative number, is given.
    #[port("I", "I", optional)]
    index: Option<i32>,
    /// The strength of the spring.
    #[port("Strength", "Strength", default = HOLD)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    let place = index.and_then(|i| usize::try_from(i).ok()).map_or(Place::At(point), Place::Number);
    if !point.is_finite() {
        return Err(Message::error("A point is not finite"));
    }
    let rule = Anchor { target: point, axes: [true; 3], strength };
    Goal::of_places("Kangaroo goal: Anchor", vec![place], rule)
}

/// Holds a point along chosen axes of the world. Stands for Kangaroo 2's AnchorXYZ.
#[component(
    "2128cde3-9694-40b0-874c-670c89341acd",
    name = "AnchorXYZ",
    nick = "AnchorXYZ",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("A", "A", "The goal, for a solver.")]
fn anchor_xyz(
    /// The point to hold.
    #[port("Point", "P")]
    point: Point3,
    /// Whether it may not move along x.
    #[port("X", "X", default = true)]
    x: bool,
    /// Whether it may not move along y.
    #[port("Y", "Y", default = true)]
    y: bool,
    /// Whether it may not move along z.
    #[port("Z", "Z", default = true)]
    z: bool,
    /// The strength of the spring.
    #[port("Strength", "Strength", default = HOLD)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    Goal::item("Kangaroo goal: AnchorXYZ", vec![point], Anchor { target: point, axes: [x, y, z], strength })
}

/// A spring to a place that slides after the point beyond a distance.
#[derive(Debug)]
struct Sliding {
    start: Point3,
    limit: f64,
    strength: f64,
}

impl Rule for Sliding {
    fn memory(&self) -> Vec<f64> {
        vec![self.start.x, self.start.y, self.start.z]
    }

    fn pull(&self, points: &[Point3], memory: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let (Some(p), Some(pull), [x, y, z]) = (points.first(), pulls.first_mut(), memory) else { return };
        *pull = Pull::new(Point3::new(*x, *y, *z) - *p, self.strength);
    }

    fn give_way(&self, points: &[Point3], memory: &mut [f64]) -> bool {
        let (Some(p), [x, y, z]) = (points.first(), memory) else { return false };
        let way = *p - Point3::new(*x, *y, *z);
        let (mut slid, length) = (0.0, way.length());
        let slides = yielded(&mut slid, length, self.limit);
        if slides {
            let by = way * (slid / length);
            (*x, *y, *z) = (*x + by.x, *y + by.y, *z + by.z);
        }
        slides
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        points.first().map(|p| Value::Point(*p))
    }
}

fn sliding(point: Point3, limit: f64, strength: f64) -> Result<Value, Message> {
    let (limit, strength) = (finite(limit, "The limit")?, finite(strength, "The strength")?);
    let rule = Sliding { start: point, limit: limit.max(0.0), strength };
    Goal::item("Kangaroo goal: PlasticAnchor", vec![point], rule)
}

/// Holds a point at a place that slides after it where the point is farther away than a limit. Stands for Kangaroo 2's
/// PlasticAnchor.
#[component(
    "76469b0a-11f0-4b8e-ad65-31a555d4cddd",
    name = "PlasticAnchor",
    nick = "PlasticAnchor",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("A", "A", "The goal, for a solver.")]
fn plastic_anchor(
    /// The point to hold.
    #[port("Point", "P")]
    point: Point3,
    /// The distance at which the place begins to slide, in units.
    #[port("Limit", "L", default = 0.1)]
    limit: f64,
    /// The strength of the spring.
    #[port("Strength", "Strength", default = HOLD)]
    strength: f64,
    /// Not needed: each solve begins where the point is.
    #[port("Reset", "R", optional)]
    _reset: Option<bool>,
) -> Result<Value, Message> {
    sliding(point, limit, strength)
}

/// Holds a point at a place that slides after it where the point is farther away than a limit. Stands for an earlier
/// PlasticAnchor of Kangaroo 2.
#[component(
    "c2d6c6db-37d4-4c95-928f-7afc27842a1e",
    name = "PlasticAnchor",
    nick = "PlasticAnchor",
    at = "Kangaroo2/Goals-Pt",
    old
)]
#[output("A", "A", "The goal, for a solver.")]
fn plastic_anchor_before(
    /// The point to hold.
    #[port("Point", "P")]
    point: Point3,
    /// The distance at which the place begins to slide, in units.
    #[port("Limit", "L", default = 0.1)]
    limit: f64,
    /// The strength of the spring.
    #[port("Strength", "Strength", default = HOLD)]
    strength: f64,
) -> Result<Value, Message> {
    sliding(point, limit, strength)
}

/// A map from one point to another kept: each goes half of the way.
#[derive(Debug)]
struct Mapped {
    map: Xform,
    back: Xform,
    strength: f64,
}

impl Rule for Mapped {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let ([p, q], [a, b]) = (points, pulls) else { return };
        *a = Pull::new((self.back.point(*q) - *p) * 0.5, self.strength);
        *b = Pull::new((self.map.point(*p) - *q) * 0.5, self.strength);
    }
}

/// Pulls two points together, as a spring of no length. Stands for Kangaroo 2's Coincident.
#[component(
    "c955cf0a-2294-423d-bf1a-fc5cba5d2103",
    name = "Coincident",
    nick = "C",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("C", "C", "The goal, for a solver.")]
fn coincident(
    /// One point.
    #[port("Point0", "P0")]
    a: Point3,
    /// The other one.
    #[port("Point1", "P1")]
    b: Point3,
    /// The strength.
    #[port("Strength", "Strength", default = 1000.0)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    let rule = Mapped { map: Xform::IDENTITY, back: Xform::IDENTITY, strength };
    Goal::item("Kangaroo goal: Coincident", vec![a, b], rule)
}

/// Keeps one point where a map takes the other. Stands for Kangaroo 2's Transform.
#[component(
    "5002d2f7-7878-4965-98ab-2403503891ab",
    name = "Transform",
    nick = "Transform",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("T", "T", "The goal, for a solver.")]
fn transform(
    /// The first point.
    #[port("P0", "P0")]
    a: Point3,
    /// The point where the map takes the first.
    #[port("P1", "P1")]
    b: Point3,
    /// The map; it needs an inverse.
    #[port("T", "T")]
    map: Xform,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    let back = map.inverse().ok_or_else(|| Message::error("The transform has no inverse"))?;
    Goal::item("Kangaroo goal: Transform", vec![a, b], Mapped { map, back, strength })
}

/// Points that snap together where they are near.
#[derive(Debug)]
struct Snap {
    range: f64,
    strength: f64,
}

impl Rule for Snap {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        for (i, p) in points.iter().enumerate() {
            if i % 256 == 0 && CancellationToken::is_over() {
                return;
            }
            for (j, q) in points.iter().enumerate().skip(i + 1) {
                let way = *q - *p;
                if way.length_squared() > self.range * self.range {
                    continue;
                }
                for (k, sign) in [(i, 0.5), (j, -0.5)] {
                    if let Some(pull) = pulls.get_mut(k) {
                        // Moves and weights of several neighbours become one: their mean.
                        let weight = pull.weight + self.strength;
                        let sum = pull.by * pull.weight + way * (sign * self.strength);
                        *pull = Pull::new(if weight == 0.0 { Vector3::ZERO } else { sum / weight }, weight);
                    }
                }
            }
        }
    }
}

/// Snaps points together that are near each other. Stands for Kangaroo 2's MagnetSnap.
#[component(
    "28bedc62-006a-4f19-b97d-e12b20aff875",
    name = "MagnetSnap",
    nick = "MS",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("S", "S", "The goal, for a solver.")]
fn magnet_snap(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The distance within which two points snap, in units.
    #[port("Range", "R", default = 1.0)]
    range: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let points: Vec<Point3> = points.present().collect();
    if points.len().saturating_mul(points.len()) / 2 > MOST_PAIRS {
        return Err(Message::error(format!("{} points are too many to snap", points.len())));
    }
    let rule =
        Snap { range: finite(range, "The range")?.max(0.0), strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: MagnetSnap", points, rule)
}
