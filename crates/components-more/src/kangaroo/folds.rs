//! Goals-Mesh: angles between triangles that share an edge.

use katydid_component::{Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary as _;
use katydid_geometry::{Point3, Vector3};

use super::goal::finite;
use super::lines::yielded;
use super::thresholds::SHORTEST;
use super::{Goal, Pull, Rule};

/// The moves that take a measure of some points by `-amount`, as short as they can be: along its slopes (M. Müller and
/// others, *Position based dynamics*, 2007).
pub(super) fn project(slopes: &[Vector3], amount: f64, strength: f64, pulls: &mut [Pull]) {
    let sum: f64 = slopes.iter().map(|s| s.length_squared()).sum();
    if sum > SHORTEST * SHORTEST {
        for (slope, pull) in slopes.iter().zip(pulls) {
            *pull = Pull::new(*slope * (-amount / sum), strength);
        }
    }
}

/// The angle by which two triangles on an edge are folded, 0 where they are flat, from −π to π; positive where the tips stand
/// up on the side to which the first triangle looks when its corners are start, end, tip.
pub(super) fn fold_angle([start, end, first, second]: [Point3; 4]) -> Option<f64> {
    let edge = (end - start).unitized()?;
    let (n, m) = (edge.cross(first - start).unitized()?, (second - start).cross(edge).unitized()?);
    // Seen along the edge, the second normal leans away from the first tip where the fold is a valley.
    // Adding zero leaves no negative one.
    Some((m.cross(n).dot(edge) + 0.0).arctangent_of(n.dot(m)))
}

/// How the angle changes as each of the four points moves (R. Bridson and others, *Simulation of clothing with folds and
/// wrinkles*, 2003).
fn slopes([start, end, first, second]: [Point3; 4]) -> Option<[Vector3; 4]> {
    let way = end - start;
    let length = way.length();
    if !(length > SHORTEST) {
        return None;
    }
    let (n, m) = (way.cross(first - start), (second - start).cross(way));
    let (n, m) = (over_square(n)?, over_square(m)?);
    let along = |p: Point3| (p - start).dot(way) / (length * length);
    let (a, b) = (n * length, m * length);
    let (s, t) = (along(first), along(second));
    Some([-(a * (1.0 - s) + b * (1.0 - t)), -(a * s + b * t), a, b])
}

fn over_square(v: Vector3) -> Option<Vector3> {
    let squared = v.length_squared();
    (squared > SHORTEST * SHORTEST).then(|| v / squared)
}

fn four(points: &[Point3]) -> Option<[Point3; 4]> {
    points.try_into().ok()
}

/// The difference of two angles by the shorter way round.
fn difference(a: f64, b: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    let turn = (a - b) % TAU;
    if turn > PI {
        turn - TAU
    } else if turn < -PI {
        turn + TAU
    } else {
        turn
    }
}

#[derive(Debug)]
struct Hinge {
    rest: f64,
    /// The change of the angle beyond which the rest angle gives way.
    limit: Option<f64>,
    strength: f64,
}

impl Rule for Hinge {
    fn memory(&self) -> Vec<f64> {
        vec![self.rest]
    }

    fn pull(&self, points: &[Point3], memory: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let (Some(four), [rest, ..]) = (four(points), memory) else { return };
        let (Some(angle), Some(slopes)) = (fold_angle(four), slopes(four)) else { return };
        project(&slopes, difference(angle, *rest), self.strength, pulls);
    }

    fn give_way(&self, points: &[Point3], memory: &mut [f64]) -> bool {
        let (Some(limit), Some(four), [rest, ..]) = (self.limit, four(points), memory) else { return false };
        let Some(angle) = fold_angle(four) else { return false };
        yielded(rest, *rest + difference(angle, *rest), limit)
    }
}

pub(super) fn hinge(
    points: [Point3; 4],
    rest: Option<f64>,
    limit: Option<f64>,
    strength: f64,
) -> Result<Value, Message> {
    let rest = rest.or_else(|| fold_angle(points)).unwrap_or(0.0);
    let rule = Hinge {
        rest: finite(rest, "The rest angle")?,
        limit: limit.map(|limit| finite(limit, "The limit")).transpose()?.map(|limit| limit.max(0.0)),
        strength: finite(strength, "The strength")?,
    };
    Goal::item("Kangaroo goal: Hinge", points.to_vec(), rule)
}

/// Folds two triangles on an edge to an angle, 0 where they are flat. Stands for Kangaroo 2's Hinge; which way is positive is
/// our reading.
#[component(
    "b6b6632e-a164-491a-8874-9a214dcc79bc",
    name = "Hinge",
    nick = "Hinge",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("H", "H", "The goal, for a solver.")]
fn hinge_goal(
    /// The start of the edge.
    #[port("FoldStart", "FoldStart")]
    start: Point3,
    /// The end of the edge.
    #[port("FoldEnd", "FoldEnd")]
    end: Point3,
    /// The tip of the first triangle.
    #[port("Tip1", "Tip1")]
    first: Point3,
    /// The tip of the second triangle.
    #[port("Tip2", "Tip2")]
    second: Point3,
    /// The angle at rest, in radians; the one that they have when nothing is given.
    #[port("RestAngle", "RestAngle", optional)]
    rest: Option<f64>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    hinge([start, end, first, second], rest, None, strength)
}

/// Folds two triangles on an edge to an angle that gives way where it is changed by more than a limit. Stands for Kangaroo
/// 2's PlasticHinge.
#[component(
    "69a52798-b567-4a36-b5b4-7614bea071bc",
    name = "PlasticHinge",
    nick = "PH",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("H", "H", "The goal, for a solver.")]
fn plastic_hinge(
    /// The start of the edge.
    #[port("FoldStart", "FoldStart")]
    start: Point3,
    /// The end of the edge.
    #[port("FoldEnd", "FoldEnd")]
    end: Point3,
    /// The tip of the first triangle.
    #[port("Tip1", "Tip1")]
    first: Point3,
    /// The tip of the second triangle.
    #[port("Tip2", "Tip2")]
    second: Point3,
    /// The angle at rest, in radians; the one that they have when nothing is given.
    #[port("RestAngle", "RestAngle", optional)]
    rest: Option<f64>,
    /// The greatest change of the angle that is taken back, in radians.
    #[port("Limit", "Limit", default = 0.5)]
    limit: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    hinge([start, end, first, second], rest, Some(limit), strength)
}

/// Two triangles kept from folding through each other.
#[derive(Debug)]
struct NoFoldThrough {
    strength: f64,
}

impl Rule for NoFoldThrough {
    fn memory(&self) -> Vec<f64> {
        vec![f64::NAN]
    }

    fn pull(&self, points: &[Point3], memory: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let (Some(four), [last, ..]) = (four(points), memory) else { return };
        let (Some(angle), Some(slopes)) = (fold_angle(four), slopes(four)) else { return };
        // A jump from nearly π to nearly −π is a side that went through the other.
        let through = last.is_finite() && (angle - *last).abs() > std::f64::consts::PI;
        if through {
            let over = difference(angle, std::f64::consts::PI.copysign(*last));
            project(&slopes, over, self.strength, pulls);
        } else {
            *last = angle;
        }
    }
}

/// Keeps the sides of a fold from going through each other. Stands for Kangaroo 2's NoFoldThrough.
#[component(
    "8f083dbb-357b-4172-80d0-b584b21b6d75",
    name = "NoFoldThrough",
    nick = "NoFoldThrough",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("H", "H", "The goal, for a solver.")]
fn no_fold_through(
    /// The start of the edge.
    #[port("FoldStart", "FoldStart")]
    start: Point3,
    /// The end of the edge.
    #[port("FoldEnd", "FoldEnd")]
    end: Point3,
    /// The tip of the first triangle.
    #[port("Tip1", "Tip1")]
    first: Point3,
    /// The tip of the second triangle.
    #[port("Tip2", "Tip2")]
    second: Point3,
    /// The strength.
    #[port("Strength", "Strength", default = 100.0)]
    strength: f64,
) -> Result<Value, Message> {
    let rule = NoFoldThrough { strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: NoFoldThrough", vec![start, end, first, second], rule)
}

/// The angle between two triangles that share an edge, in radians: 0 where they are flat. Stands for Kangaroo 2's FoldAngle;
/// which way is positive is our reading.
#[component(
    "b09481df-b73c-4889-b2d7-6ed306beddad",
    name = "FoldAngle",
    nick = "FoldAngle",
    at = "Kangaroo2/Mesh"
)]
#[output("Angle", "A", "The angle, from −π to π.")]
fn fold_angle_of(
    /// The start of the common edge.
    #[port("P1", "P1")]
    start: Point3,
    /// The end of the common edge.
    #[port("P2", "P2")]
    end: Point3,
    /// The tip of the first triangle.
    #[port("P3", "P3")]
    first: Point3,
    /// The tip of the second triangle.
    #[port("P4", "P4")]
    second: Point3,
) -> Result<f64, Message> {
    fold_angle([start, end, first, second]).ok_or_else(|| Message::error("A triangle has no area"))
}
