//! Goals-Lin: lengths and directions of segments.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Line, Mesh, Point3, Vector3};

use super::goal::{Place, finite};
use super::thresholds::{GIVES_WAY, SHORTEST};
use super::{Goal, Pull, Rule};

/// The ends of a curve, which stands for a segment.
pub(super) fn ends(curve: &Curve) -> [Point3; 2] {
    [curve.start(), curve.end()]
}

/// The segment between the first two points, as an item.
pub(super) fn segment(points: &[Point3]) -> Option<Value> {
    match points {
        [a, b, ..] => Some(Value::from(Line::new(*a, *b))),
        _ => None,
    }
}

/// A spring after Hooke: the force is its strength times what its length lacks.
#[derive(Debug)]
pub(super) struct Spring {
    pub(super) rest: f64,
    pub(super) strength: f64,
}

/// Both ends half of the way to the length `rest`, so that twice the strength times the move is the force.
pub(super) fn stretch(points: &[Point3], rest: f64, strength: f64, pulls: &mut [Pull]) {
    let ([a, b, ..], [p, q, ..]) = (points, pulls) else { return };
    let way = *b - *a;
    let length = way.length();
    if length > SHORTEST {
        let half = way * (0.5 * (1.0 - rest / length));
        *p = Pull::new(half, 2.0 * strength);
        *q = Pull::new(-half, 2.0 * strength);
    }
}

impl Rule for Spring {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        stretch(points, self.rest, self.strength, pulls);
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        segment(points)
    }
}

/// Pulls a segment to a length, as a spring whose force is the strength times what is lacking. Stands for Kangaroo 2's
/// Length(Line).
#[component(
    "091bae84-8fa9-4b35-8aad-b25b859055f6",
    name = "Length(Line)",
    nick = "Length(Line)",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("S", "S", "The goal, for a solver.")]
fn length_of_line(
    /// The segment: a curve counts by its ends.
    #[port("Line", "Line")]
    line: &Curve,
    /// The length to reach, in units; the length that it has when nothing is given.
    #[port("Length", "Length", optional)]
    length: Option<f64>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let [a, b] = ends(line);
    let rest = finite(length.unwrap_or_else(|| a.distance_to(b)), "The length")?;
    let rule = Spring { rest, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: Length", vec![a, b], rule)
}

/// A point, or the number of a particle.
pub(super) fn place(value: &Value) -> Result<Place, Message> {
    match value {
        Value::Point(p) if p.is_finite() => Ok(Place::At(*p)),
        Value::Integer(n) => usize::try_from(*n)
            .map(Place::Number)
            .map_err(|_| Message::error("A particle's number is negative")),
        Value::Number(x) if *x >= 0.0 && *x < 1e9 && x.fract() == 0.0 => Ok(Place::Number(*x as usize)),
        other => {
            let point = katydid_data::cast::value(other, katydid_data::Kind::Point, &Default::default());
            match point {
                Some(Value::Point(p)) if p.is_finite() => Ok(Place::At(p)),
                _ => Err(Message::error("Neither a point nor the number of a particle")),
            }
        }
    }
}

/// Pulls two points to a distance from each other. Stands for Kangaroo 2's Length(Pts).
#[component(
    "c681ef8e-fbf7-4277-a6a8-8a00d94cc953",
    name = "Length(Pts)",
    nick = "Length(Pts)",
    at = "Kangaroo2/Goals"
)]
#[output("S", "S", "The goal, for a solver.")]
fn length_of_points(
    /// One point, or the number of its particle.
    #[port("Start", "Start")]
    start: Value,
    /// The other point, or the number of its particle.
    #[port("End", "End")]
    end: Value,
    /// The distance to reach, in units; the one that they have when nothing is given.
    #[port("Length", "Length", optional)]
    length: Option<f64>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let places = vec![place(&start)?, place(&end)?];
    let rest = match (length, places.as_slice()) {
        (Some(length), _) => length,
        (None, [Place::At(a), Place::At(b)]) => a.distance_to(*b),
        _ => return Err(Message::error("A length is needed where particles are given by number")),
    };
    let rule = Spring { rest: finite(rest, "The length")?, strength: finite(strength, "The strength")? };
    Goal::of_places("Kangaroo goal: Length", places, rule)
}

/// A spring to the nearest length of a range or of a grid.
#[derive(Debug)]
enum Choice {
    Between(f64, f64),
    Multiple(f64),
}

#[derive(Debug)]
struct Chosen {
    choice: Choice,
    strength: f64,
}

impl Rule for Chosen {
    /// Which bound was exceeded in the step before: −1 the lower, 1 the upper, 0 none.
    fn memory(&self) -> Vec<f64> {
        vec![0.0]
    }

    fn pull(&self, points: &[Point3], memory: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let ([a, b, ..], [before, ..]) = (points, memory) else { return };
        let length = a.distance_to(*b);
        let rest = match self.choice {
            Choice::Between(low, high) => length.clamp(low, high),
            Choice::Multiple(factor) => (length / factor).round() * factor,
        };
        if matches!(self.choice, Choice::Between(..)) {
            let exceeded = if length == rest { 0.0 } else { (length - rest).signum() };
            let leapt = exceeded * *before < 0.0;
            *before = if leapt { 0.0 } else { exceeded };
            // From beyond one bound to beyond the other there are lengths at which it lets go.
            if leapt || exceeded == 0.0 {
                return;
            }
        }
        stretch(points, rest, self.strength, pulls);
    }

    fn is_mutual(&self) -> bool {
        true
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        segment(points)
    }
}

/// Keeps the length of a segment between two bounds. Stands for Kangaroo 2's ClampLength.
#[component(
    "0822cf4a-be2e-4352-aed2-dad197f0611e",
    name = "ClampLength",
    nick = "ClampLength",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("C", "C", "The goal, for a solver.")]
fn clamp_length(
    /// The segment: a curve counts by its ends.
    #[port("Line", "Line")]
    line: &Curve,
    /// The least length, in units.
    #[port("LowerLimit", "LowerLimit", default = 0.0)]
    lower: f64,
    /// The greatest length, in units.
    #[port("UpperLimit", "UpperLimit", default = 1.0)]
    upper: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let (lower, upper) = (finite(lower, "The lower limit")?, finite(upper, "The upper limit")?);
    let choice = Choice::Between(lower.min(upper), upper.max(lower));
    let rule = Chosen { choice, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: ClampLength", ends(line).to_vec(), rule)
}

/// Pulls the length of a segment to the nearest whole multiple of a number. Stands for Kangaroo 2's LengthSnap.
#[component(
    "5fa0d301-9b28-47ce-a281-5292c1b1364b",
    name = "LengthSnap",
    nick = "LengthSnap",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("S", "S", "The goal, for a solver.")]
fn length_snap(
    /// The segment: a curve counts by its ends.
    #[port("Line", "Line")]
    line: &Curve,
    /// What the length becomes a multiple of, in units.
    #[port("Factor", "Factor", default = 1.0)]
    factor: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    if !(factor > 0.0 && factor.is_finite()) {
        return Err(Message::error(format!("The factor is {factor}: it must be greater than 0")));
    }
    let rule = Chosen { choice: Choice::Multiple(factor), strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: LengthSnap", ends(line).to_vec(), rule)
}

/// Moves what is kept at rest after a state that is farther off than a limit, by what exceeds the limit; whether it did.
pub(super) fn yielded(rest: &mut f64, state: f64, limit: f64) -> bool {
    let off = state - *rest;
    let beyond = off.abs() - limit;
    if !(beyond > GIVES_WAY * (off.abs() + rest.abs())) {
        return false;
    }
    *rest += beyond.copysign(off);
    true
}

/// A spring whose rest length gives way.
#[derive(Debug)]
struct Plastic {
    rest: f64,
    limit: f64,
    strength: f64,
}

impl Rule for Plastic {
    fn memory(&self) -> Vec<f64> {
        vec![self.rest]
    }

    fn pull(&self, points: &[Point3], memory: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let [rest, ..] = memory else { return };
        stretch(points, *rest, self.strength, pulls);
    }

    fn give_way(&self, points: &[Point3], memory: &mut [f64]) -> bool {
        let ([a, b, ..], [rest, ..]) = (points, memory) else { return false };
        yielded(rest, a.distance_to(*b), self.limit)
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        segment(points)
    }
}

/// Keeps the length of a segment as a spring does, until it is changed by more than a limit: then its rest length gives
/// way. Stands for Kangaroo 2's PlasticLength.
#[component(
    "030749a0-2773-45d3-9647-d37662d2ad4c",
    name = "PlasticLength",
    nick = "PL",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("S", "S", "The goal, for a solver.")]
fn plastic_length(
    /// The segment: a curve counts by its ends.
    #[port("Line", "Line")]
    line: &Curve,
    /// The greatest change of length that is taken back, in units.
    #[port("Limit", "L", default = 0.1)]
    limit: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let [a, b] = ends(line);
    let rule = Plastic {
        rest: finite(a.distance_to(b), "The length")?,
        limit: finite(limit, "The limit")?.max(0.0),
        strength: finite(strength, "The strength")?,
    };
    Goal::item("Kangaroo goal: PlasticLength", vec![a, b], rule)
}

/// Segments of the mean of their lengths.
#[derive(Debug)]
struct Equal {
    strength: f64,
}

impl Rule for Equal {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let lengths = points.chunks_exact(2).map(|pair| match pair {
            [a, b] => a.distance_to(*b),
            _ => 0.0,
        });
        let mean = lengths.sum::<f64>() / (points.len() / 2).max(1) as f64;
        for (pair, pulls) in points.chunks_exact(2).zip(pulls.chunks_exact_mut(2)) {
            stretch(pair, mean, self.strength, pulls);
        }
    }
}

/// Pulls segments to one length: the mean of those that they have. Stands for Kangaroo 2's EqualLength.
#[component(
    "537e7b52-4f3e-4bb6-b5f5-98233a66b79d",
    name = "EqualLength",
    nick = "EqualLength",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("E", "E", "The goal, for a solver.")]
fn equal_length(
    /// The segments: curves count by their ends.
    #[port("Line", "Line")]
    lines: List<std::sync::Arc<Curve>>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let points = lines.present().flat_map(|line| ends(&line)).collect();
    Goal::item("Kangaroo goal: EqualLength", points, Equal { strength: finite(strength, "The strength")? })
}

/// Two segments whose lengths have a ratio.
#[derive(Debug)]
struct Ratio {
    ratio: f64,
    strength: f64,
}

impl Rule for Ratio {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let [a, b, c, d] = points else { return };
        let (first, second) = (a.distance_to(*b), c.distance_to(*d));
        // The least change of both: (x, ratio · x) nearest to (first, second).
        let x = (first + self.ratio * second) / (1.0 + self.ratio * self.ratio);
        let Some((one, other)) = pulls.split_at_mut_checked(2) else { return };
        stretch(&[*a, *b], x, self.strength, one);
        stretch(&[*c, *d], x * self.ratio, self.strength, other);
    }
}

/// Keeps the length of one segment a multiple of that of another. Stands for Kangaroo 2's LengthRatio.
#[component(
    "09fef083-0d7b-4e3d-a24c-928a19a71aed",
    name = "LengthRatio",
    nick = "LengthRatio",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("A", "A", "The goal, for a solver.")]
fn length_ratio(
    /// The first segment.
    #[port("LineA", "LineA")]
    first: Line,
    /// The second segment.
    #[port("LineB", "LineB")]
    second: Line,
    /// The length of the second by that of the first.
    #[port("Ratio", "Ratio", default = 1.0)]
    ratio: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let rule = Ratio { ratio: finite(ratio, "The ratio")?, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: LengthRatio", vec![first.from, first.to, second.from, second.to], rule)
}

/// A segment turned to a direction, or to the nearest axis of the world.
#[derive(Debug)]
struct Direction {
    direction: Option<Vector3>,
    strength: f64,
}

impl Rule for Direction {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let ([a, b], [p, q]) = (points, pulls) else { return };
        let way = *b - *a;
        let axis = self.direction.unwrap_or_else(|| {
            let [x, y, z] = [way.x.abs(), way.y.abs(), way.z.abs()];
            if x >= y && x >= z {
                Vector3::X
            } else if y >= z {
                Vector3::Y
            } else {
                Vector3::Z
            }
        });
        let off = (way - axis * way.dot(axis)) * 0.5;
        *p = Pull::new(off, self.strength);
        *q = Pull::new(-off, self.strength);
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        segment(points)
    }
}

/// Turns a segment to a direction. Stands for Kangaroo 2's Direction.
#[component(
    "6d36a97d-811f-423a-a4a1-35a7a7637697",
    name = "Direction",
    nick = "Direction",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("D", "D", "The goal, for a solver.")]
fn direction(
    /// The segment.
    #[port("Line", "Line")]
    line: Line,
    /// The direction; the nearest axis of the world when nothing is given.
    #[port("Direction", "Direction", optional)]
    direction: Option<Vector3>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let unit = |v: Vector3| v.unitized().ok_or_else(|| Message::error("The direction has no length"));
    let rule = Direction {
        direction: direction.map(unit).transpose()?,
        strength: finite(strength, "The strength")?,
    };
    Goal::item("Kangaroo goal: Direction", vec![line.from, line.to], rule)
}

/// Pulls the edges of a mesh to a multiple of the lengths that they have: a goal for each edge. Stands for Kangaroo 2's
/// EdgeLengths.
#[component(
    "24e2b0d2-d7b8-4478-8a83-1f04cba701a1",
    name = "EdgeLengths",
    nick = "EdgeLengths",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("EL", "EL", "The goals, for a solver, in order of the edges.")]
fn edge_lengths(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The length of an edge by the one that it has.
    #[port("LengthFactor", "LengthFactor", default = 1.0)]
    factor: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    let (factor, strength) = (finite(factor, "The factor")?, finite(strength, "The strength")?);
    let edges = mesh.edges();
    context.items(edges.len())?;
    let lines = edges.iter().filter_map(|edge| mesh.edge_line(edge));
    lines
        .map(|line| {
            let rule = Spring { rest: line.length() * factor, strength };
            Goal::item("Kangaroo goal: Length", vec![line.from, line.to], rule)
        })
        .collect()
}
