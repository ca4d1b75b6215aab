//! Goals-Angle: angles between segments, and rods.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary as _;
use katydid_geometry::{Curve, Line, Point3, Vector3};

use super::goal::finite;
use super::lines::stretch;
use super::thresholds::{FOLDED, SHORTEST, STRAIGHT};
use super::{Goal, Pull, Rule};

/// Turns two segments in their plane so that the angle between them comes nearer to `rest`.
///
/// The shear force on a segment of length L is 2 EI sin(α − rest) / (L C), where C is the length of both together: S.
/// Adriaenssens and M. Barnes, *Tensegrity spline beam and grid shell structures* (2001). The move is the one that turns the
/// segment by about half of what the angle lacks, so that a step does not go too far.
pub(super) fn turn(points: &[Point3], rest: f64, strength: f64, pulls: &mut [Pull]) {
    let ([a, b, c, d], [p, q, r, s]) = (points, pulls) else { return };
    let (u, v) = (*b - *a, *d - *c);
    let (first, second, both) = (u.length(), v.length(), (u + v).length());
    let Some(angle) = u.angle_to(v) else { return };
    // Segments that turn back on each other have no length together: the sum of theirs is as good.
    let both = both.max(FOLDED * (first + second));
    if !(first > SHORTEST && second > SHORTEST) {
        return;
    }
    let lack = (angle - rest).sine();
    // Straight segments lie in no plane: any plane through them does.
    let across = |u: Vector3, v: Vector3| {
        let off = v - u * (v.dot(u) / u.length_squared());
        let whole = off.length() > STRAIGHT * v.length();
        if whole { off.unitized() } else { u.perpendicular() }
    };
    let (Some(x), Some(mut y)) = (across(u, v), across(v, u)) else { return };
    if x.dot(y) > 0.0 && u.dot(v) > 0.0 {
        y = -y;
    }
    let (move_first, move_second) = (x * (first * lack / 4.0), y * (second * lack / 4.0));
    let weight = |length: f64| 8.0 * strength / (length * length * both);
    *p = Pull::new(-move_first, weight(first));
    *q = Pull::new(move_first, weight(first));
    *r = Pull::new(-move_second, weight(second));
    *s = Pull::new(move_second, weight(second));
}

/// The angle between two segments.
fn angle_of(points: &[Point3]) -> Option<f64> {
    match points {
        [a, b, c, d] => (*b - *a).angle_to(*d - *c),
        _ => None,
    }
}

/// Which angle is wanted.
#[derive(Debug)]
enum Wanted {
    Is(f64),
    Multiple(f64),
    Between(f64, f64),
}

#[derive(Debug)]
struct Bend {
    wanted: Wanted,
    strength: f64,
}

impl Rule for Bend {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let Some(now) = angle_of(points) else { return };
        let rest = match self.wanted {
            Wanted::Is(angle) => angle,
            Wanted::Multiple(factor) => (now / factor).round() * factor,
            Wanted::Between(low, high) if (low..=high).contains(&now) => return,
            Wanted::Between(low, high) => now.clamp(low, high),
        };
        turn(points, rest, self.strength, pulls);
    }
}

fn corners(a: &Line, b: &Line) -> Vec<Point3> {
    vec![a.from, a.to, b.from, b.to]
}

/// Bends two segments to an angle between their directions, as an elastic rod does: the moment is the strength times the
/// curvature, and 0 is straight. Stands for Kangaroo 2's Angle.
#[component(
    "f5f95b51-7431-4e80-a32f-d33e5dee53a5",
    name = "Angle",
    nick = "Angle",
    at = "Kangaroo2/Goals-Angle"
)]
#[output("A", "A", "The goal, for a solver.")]
fn angle(
    /// The first segment.
    #[port("LineA", "LineA")]
    first: Line,
    /// The second segment; it goes on where the first ends.
    #[port("LineB", "LineB")]
    second: Line,
    /// The angle at rest, in radians; the one that they have when nothing is given.
    #[port("RestAngle", "RestAngle", optional)]
    rest: Option<f64>,
    /// The strength: the stiffness EI of a rod.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let points = corners(&first, &second);
    let rest = rest.or_else(|| angle_of(&points)).unwrap_or(0.0);
    let rule = Bend {
        wanted: Wanted::Is(finite(rest, "The rest angle")?),
        strength: finite(strength, "The strength")?,
    };
    Goal::item("Kangaroo goal: Angle", points, rule)
}

/// Bends two segments to the nearest whole multiple of an angle. Stands for Kangaroo 2's AngleSnap.
#[component(
    "c5ca5c17-3d7c-4848-b994-a7406dc519ed",
    name = "AngleSnap",
    nick = "AS",
    at = "Kangaroo2/Goals-Angle"
)]
#[output("A", "A", "The goal, for a solver.")]
fn angle_snap(
    /// The first segment.
    #[port("LineA", "LineA")]
    first: Line,
    /// The second segment.
    #[port("LineB", "LineB")]
    second: Line,
    /// What the angle becomes a multiple of, in radians.
    #[port("Factor", "Factor", default = std::f64::consts::FRAC_PI_2)]
    factor: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    if !(factor > 0.0 && factor.is_finite()) {
        return Err(Message::error(format!("The factor is {factor}: it must be greater than 0")));
    }
    let rule = Bend { wanted: Wanted::Multiple(factor), strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: AngleSnap", corners(&first, &second), rule)
}

/// Keeps the angle between two segments within bounds. Stands for Kangaroo 2's ClampAngle.
#[component(
    "d228945d-3133-412f-9283-d2ac418e82a2",
    name = "ClampAngle",
    nick = "ClampAngle",
    at = "Kangaroo2/Goals-Angle"
)]
#[output("C", "C", "The goal, for a solver.")]
fn clamp_angle(
    /// The first segment.
    #[port("LineA", "LineA")]
    first: Line,
    /// The second segment.
    #[port("LineB", "LineB")]
    second: Line,
    /// The greatest angle, in radians.
    #[port("Upper", "Upper", default = std::f64::consts::FRAC_PI_2)]
    upper: f64,
    /// The least angle, in radians.
    #[port("Lower", "Lower", default = 0.0)]
    lower: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let (lower, upper) = (finite(lower, "The lower angle")?, finite(upper, "The upper angle")?);
    let wanted = Wanted::Between(lower.min(upper), upper.max(lower));
    let rule = Bend { wanted, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: ClampAngle", corners(&first, &second), rule)
}

/// Pairs of segments with the mean of their angles.
#[derive(Debug)]
struct EqualAngles {
    strength: f64,
}

impl Rule for EqualAngles {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let angles: Vec<f64> = points.chunks_exact(4).filter_map(angle_of).collect();
        let mean = angles.iter().sum::<f64>() / angles.len().max(1) as f64;
        for (points, pulls) in points.chunks_exact(4).zip(pulls.chunks_exact_mut(4)) {
            turn(points, mean, self.strength, pulls);
        }
    }
}

/// Bends pairs of segments to one angle: the mean of those that they have. Stands for Kangaroo 2's EqualAngle.
#[component(
    "f8e123b6-517c-409a-9a2f-c3acf58617cd",
    name = "EqualAngle",
    nick = "EA",
    at = "Kangaroo2/Goals-Angle"
)]
#[output("EqualAngle", "EA", "The goal, for a solver.")]
fn equal_angle(
    /// The first segment of each pair.
    #[port("LineA", "LineA")]
    first: List<Line>,
    /// The second segment of each pair.
    #[port("LineB", "LineB")]
    second: List<Line>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let pairs = first.present().zip(second.present());
    let points = pairs.flat_map(|(a, b)| corners(&a, &b)).collect();
    Goal::item(
        "Kangaroo goal: EqualAngle",
        points,
        EqualAngles { strength: finite(strength, "The strength")? },
    )
}

/// A polyline that resists stretching and bending.
#[derive(Debug)]
struct Rod {
    closed: bool,
    lengths: Vec<f64>,
    angles: Vec<f64>,
    axial: f64,
    bending: f64,
}

impl Rule for Rod {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        // Each point is in several springs and bends: their pulls add up to one.
        let mut sums = vec![(Vector3::ZERO, 0.0); points.len()];
        let n = points.len();
        let mut add = |i: usize, pull: Pull| {
            if let Some(sum) = sums.get_mut(i % n.max(1)) {
                sum.0 += pull.by * pull.weight;
                sum.1 += pull.weight;
            }
        };
        let at = |i: usize| points.get(i % n.max(1)).copied().unwrap_or(Point3::ORIGIN);
        for (i, rest) in self.lengths.iter().enumerate() {
            let mut two = [Pull::NONE; 2];
            stretch(&[at(i), at(i + 1)], *rest, self.axial, &mut two);
            two.into_iter().enumerate().for_each(|(k, pull)| add(i + k, pull));
        }
        for (i, rest) in self.angles.iter().enumerate() {
            let mut four = [Pull::NONE; 4];
            turn(&[at(i), at(i + 1), at(i + 1), at(i + 2)], *rest, self.bending, &mut four);
            for (pull, k) in four.into_iter().zip([0, 1, 1, 2]) {
                add(i + k, pull);
            }
        }
        for (pull, (sum, weight)) in pulls.iter_mut().zip(sums) {
            if weight > 0.0 {
                *pull = Pull::new(sum / weight, weight);
            }
        }
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        let mut points = points.to_vec();
        if self.closed {
            points.extend(points.first().copied());
        }
        super::utility::polyline(points)
    }
}

/// A rod along a polyline that resists stretching and bending. Stands for Kangaroo 2's Rod.
#[component("51cbcf97-8cf9-4f52-9941-a9b484593db2", name = "Rod", nick = "Rod", at = "Kangaroo2/Goals-Angle")]
#[output("R", "R", "The goal, for a solver.")]
fn rod(
    context: &Context<'_>,
    /// The polyline.
    #[port("Polyline", "Polyline")]
    curve: &Curve,
    /// The length of a segment at rest by the one that it has.
    #[port("LengthFactor", "LengthFactor", default = 1.0)]
    length_factor: f64,
    /// The angle between segments at rest by the one that they have: 0 for a straight rod.
    #[port("AngleFactor", "AngleFactor", default = 0.0)]
    angle_factor: f64,
    /// The strength against stretching.
    #[port("AxialStrength", "AxialStrength", default = 10.0)]
    axial: f64,
    /// The strength against bending.
    #[port("BendStrength", "BendStrength", default = 1.0)]
    bending: f64,
) -> Result<Value, Message> {
    let mut points = curve.as_polyline().ok_or_else(|| Message::error("The curve is not a polyline"))?;
    context.bytes(points.len().saturating_mul(120))?;
    let closed = points.len() > 3 && points.first() == points.last();
    if closed {
        points.pop();
    }
    let n = points.len();
    let at = |i: usize| points.get(i % n.max(1)).copied().unwrap_or(Point3::ORIGIN);
    let (spans, bends) = if closed { (n, n) } else { (n.saturating_sub(1), n.saturating_sub(2)) };
    let length_factor = finite(length_factor, "The length factor")?;
    let angle_factor = finite(angle_factor, "The angle factor")?;
    let lengths = (0..spans).map(|i| at(i).distance_to(at(i + 1)) * length_factor).collect();
    let angle = |i: usize| angle_of(&[at(i), at(i + 1), at(i + 1), at(i + 2)]).unwrap_or(0.0) * angle_factor;
    let angles = (0..bends).map(angle).collect();
    let rule = Rod {
        closed,
        lengths,
        angles,
        axial: finite(axial, "The axial strength")?,
        bending: finite(bending, "The bending strength")?,
    };
    Goal::item("Kangaroo goal: Rod", points, rule)
}
