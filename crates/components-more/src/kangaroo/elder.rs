//! The elder Kangaroo (0.099): its forces and solvers, brought to rest by the solver of Kangaroo 2.
//!
//! Names and ports are facts from a public list of its components. Kangaroo moves bodies with mass and drag; here they come to
//! the rest that the same forces have. Its tools for meshes are those of Kangaroo 2 of the same names.

use std::collections::HashMap;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder, Value};
use katydid_geometry::{Curve, Line, Mesh, MeshSettings, MeshTree, Plane, Point3, PolylineCurve, Vector3};

use super::angles::turn;
use super::folds::hinge;
use super::goal::finite;
use super::lines::{ends, segment, stretch, yielded};
use super::loads::{Force, Pressure};
use super::on::{Floor, OnCurve, OnMesh};
use super::solve::{Motion, System};
use super::thresholds::{HOLD, REST, SHORTEST, SMALLEST_CELL, TOLERANCE};
use super::{Goal, Pull, Rule};
use crate::kept::{keep, kept};

/// A spring that works between two lengths, and gives way for good beyond a share of its rest length.
#[derive(Debug)]
struct Spring {
    rest: f64,
    stiffness: f64,
    /// The lengths between which it works; 0 above for no limit.
    lower: f64,
    upper: f64,
    plasticity: f64,
}

impl Spring {
    fn works_at(&self, length: f64) -> bool {
        !(self.upper > 0.0 && length > self.upper) && length >= self.lower
    }
}

impl Rule for Spring {
    fn memory(&self) -> Vec<f64> {
        vec![self.rest]
    }

    fn pull(&self, points: &[Point3], memory: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let ([a, b], [rest, ..]) = (points, memory) else { return };
        let length = a.distance_to(*b);
        if !self.works_at(length) {
            return;
        }
        stretch(points, *rest, self.stiffness, pulls);
    }

    fn give_way(&self, points: &[Point3], memory: &mut [f64]) -> bool {
        let ([a, b], [rest, ..]) = (points, memory) else { return false };
        let (length, give) = (a.distance_to(*b), self.plasticity * self.rest);
        give > 0.0 && self.works_at(length) && yielded(rest, length, give)
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        segment(points)
    }
}

/// A spring on a segment. Stands for the elder Kangaroo's SpringsFromLine; damping does not change where it rests.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4001",
    name = "SpringsFromLine",
    nick = "Springs",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Springs", "S", "The spring, for a solver.")]
fn springs_from_line(
    /// The segment: a curve counts by its ends.
    #[port("Connection", "Connection")]
    line: &Curve,
    /// The force by the length that the spring is too long.
    #[port("Stiffness", "Stiffness", default = 100.0)]
    stiffness: f64,
    /// Not needed: the rest is the same.
    #[port("Damping", "Damping", optional)]
    _damping: Option<f64>,
    /// The length at rest, in units; that of the segment when nothing is given.
    #[port("Rest Length", "Rest length", optional)]
    rest: Option<f64>,
    /// The spring works below this length; 0 for no limit.
    #[port("UpperCutoff", "UpperCutoff", default = 0.0)]
    upper: f64,
    /// The spring works above this length.
    #[port("LowerCutoff", "LowerCutoff", default = 0.0)]
    lower: f64,
    /// The part of its length at rest beyond which it gives way; 0 for never.
    #[port("Plasticity", "Plasticity", default = 0.0)]
    plasticity: f64,
) -> Result<Value, Message> {
    let [a, b] = ends(line);
    let rule = Spring {
        rest: finite(rest.unwrap_or(a.distance_to(b)), "The rest length")?,
        stiffness: finite(stiffness, "The stiffness")?,
        lower: finite(lower, "The lower cutoff")?,
        upper: finite(upper, "The upper cutoff")?,
        plasticity: finite(plasticity, "The plasticity")?,
    };
    Goal::item("Kangaroo force: Spring", vec![a, b], rule)
}

/// Springs on the edges of a mesh: one for each edge. Stands for the elder Kangaroo's SpringsFromMesh; the ports beyond the mesh are
/// our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4002",
    name = "SpringsFromMesh",
    nick = "MeshSprings",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Springs", "S", "The springs, in order of the edges.")]
fn springs_from_mesh(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The force by the length that a spring is too long.
    #[port("Stiffness", "Stiffness", default = 100.0)]
    stiffness: f64,
    /// The length at rest by the length of the edge.
    #[port("LengthFactor", "LengthFactor", default = 1.0)]
    factor: f64,
) -> Result<Vec<Value>, Message> {
    let (stiffness, factor) = (finite(stiffness, "The stiffness")?, finite(factor, "The factor")?);
    let edges = mesh.edges();
    context.items(edges.len())?;
    let lines = edges.iter().filter_map(|edge| mesh.edge_line(edge));
    lines
        .map(|line| {
            let rest = line.length() * factor;
            let rule = Spring { rest, stiffness, lower: 0.0, upper: 0.0, plasticity: 0.0 };
            Goal::item("Kangaroo force: Spring", vec![line.from, line.to], rule)
        })
        .collect()
}

/// A force on a point. Stands for the elder Kangaroo's UnaryForce.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4003",
    name = "UnaryForce",
    nick = "UForce",
    at = "Kangaroo2/Elder",
    old
)]
#[output("UnaryForce", "U", "The force, for a solver.")]
fn unary_force(
    /// The point.
    #[port("Point", "Point")]
    point: Point3,
    /// The force.
    #[port("Force", "Force", default = Vector3::new(0.0, 0.0, -1.0))]
    force: Vector3,
) -> Result<Value, Message> {
    if !force.is_finite() {
        return Err(Message::error("The force is not finite"));
    }
    Goal::item("Kangaroo force: UnaryForce", vec![point], Force { force, weight: 1.0 })
}

/// A point pulled back to where it was.
#[derive(Debug)]
struct Back {
    place: Point3,
    strength: f64,
}

impl Rule for Back {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        if let (Some(p), Some(pull)) = (points.first(), pulls.first_mut()) {
            *pull = Pull::new(self.place - *p, self.strength);
        }
    }
}

/// A spring of no length from a point to where it is at first. Stands for the elder Kangaroo's AnchorSpring; that the place slips is
/// not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4004",
    name = "AnchorSpring",
    nick = "ASpring",
    at = "Kangaroo2/Elder",
    old
)]
#[output("ASpring", "A", "The spring, for a solver.")]
fn anchor_spring(
    context: &Context<'_>,
    /// The point.
    #[port("Point", "Point")]
    point: Point3,
    /// The force by the distance.
    #[port("Strength", "Strength", default = 100.0)]
    strength: f64,
    /// The force at which the place slips; only 0, never, is supported.
    #[port("Sticky", "Sticky", default = 0.0)]
    sticky: f64,
) -> Result<Value, Message> {
    if sticky != 0.0 {
        context.tell(Message::remark("Anchors that slip are not supported: the place stays"));
    }
    let rule = Back { place: point, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo force: AnchorSpring", vec![point], rule)
}

/// Keeps the angle between two triangles. Stands for the elder Kangaroo's Hinge; which way is positive is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4005",
    name = "Hinge",
    nick = "Hinge",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Hinges", "H", "The force, for a solver.")]
fn elder_hinge(
    /// The start of the edge that both share.
    #[port("Point1", "Point1")]
    start: Point3,
    /// The end of the edge.
    #[port("Point2", "Point2")]
    end: Point3,
    /// The tip of the first triangle.
    #[port("Point3", "Point3")]
    first: Point3,
    /// The tip of the second triangle.
    #[port("Point4", "Point4")]
    second: Point3,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
    /// The angle at rest, 0 where both are flat, in radians.
    #[port("RestAngle", "RestAngle", default = 0.0)]
    rest: f64,
) -> Result<Value, Message> {
    hinge([start, end, first, second], Some(rest), None, strength)
}

/// Two segments that keep the angle between them.
#[derive(Debug)]
struct Bend {
    /// The angle that the second turns from the first: 0 is straight.
    rest: f64,
    strength: f64,
}

impl Rule for Bend {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        turn(points, self.rest, self.strength, pulls);
    }
}

/// Keeps the angle at the middle of three points. Stands for the elder Kangaroo's Bend; that a straight angle is π is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4006",
    name = "Bend",
    nick = "Bend",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Bending", "B", "The force, for a solver.")]
fn bend(
    /// The first point.
    #[port("Point1", "Point1")]
    a: Point3,
    /// The middle point.
    #[port("Point2", "Point2")]
    b: Point3,
    /// The last point.
    #[port("Point3", "Point3")]
    c: Point3,
    /// The strength.
    #[port("BendStrength", "BendStrength", default = 1.0)]
    strength: f64,
    /// The angle at rest, in radians.
    #[port("RestAngle", "RestAngle", default = std::f64::consts::PI)]
    rest: f64,
) -> Result<Value, Message> {
    let rest = std::f64::consts::PI - finite(rest, "The rest angle")?;
    let rule = Bend { rest, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo force: Bend", vec![a, b, b, c], rule)
}

/// A point pulled to the mean of its neighbours.
#[derive(Debug)]
struct Smoothing {
    strength: f64,
}

impl Rule for Smoothing {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let (Some((centre, around)), Some(pull)) = (points.split_first(), pulls.first_mut()) else { return };
        if let Some(mean) = Point3::mean(around) {
            *pull = Pull::new(mean - *centre, self.strength);
        }
    }
}

/// Pulls a point to the mean of its neighbours. Stands for the elder Kangaroo's Laplacian; other weights than equal ones are not
/// supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4007",
    name = "Laplacian",
    nick = "Laplacian",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Laplacian", "L", "The force, for a solver.")]
fn laplacian(
    context: &Context<'_>,
    /// The point.
    #[port("Center", "Center")]
    centre: Point3,
    /// Its neighbours.
    #[port("Neighbours", "Neighbours")]
    around: List<Point3>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
    /// The weights: 0 equal, 1 by cotangents, 2 by lengths; equal ones are taken.
    #[port("Weighting", "Weighting", default = 0)]
    weighting: i32,
) -> Result<Value, Message> {
    if weighting != 0 {
        context.tell(Message::remark("Only equal weights are supported: they are taken"));
    }
    let points = std::iter::once(centre).chain(around.present()).collect();
    Goal::item("Kangaroo force: Laplacian", points, Smoothing { strength: finite(strength, "The strength")? })
}

/// Four points pulled into the plane between them.
#[derive(Debug)]
struct Flat {
    strength: f64,
}

impl Rule for Flat {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        if let Ok((plane, _)) = Plane::fit(points) {
            for (p, pull) in points.iter().zip(pulls) {
                *pull = Pull::new(plane.closest_point(*p) - *p, self.strength);
            }
        }
    }
}

/// Makes a quad flat. Stands for the elder Kangaroo's Planarize.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4008",
    name = "Planarize",
    nick = "Planarize",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Planarize", "P", "The force, for a solver.")]
fn planarize(
    /// A corner.
    #[port("Point1", "Point1")]
    a: Point3,
    /// The second corner.
    #[port("Point2", "Point2")]
    b: Point3,
    /// The third corner.
    #[port("Point3", "Point3")]
    c: Point3,
    /// The fourth corner.
    #[port("Point4", "Point4")]
    d: Point3,
    /// The strength.
    #[port("PlanarizeStrength", "PlanarizeStrength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    Goal::item(
        "Kangaroo force: Planarize",
        vec![a, b, c, d],
        Flat { strength: finite(strength, "The strength")? },
    )
}

/// Pushes a triangle along its normal, in proportion to its area. Stands for the elder Kangaroo's Pressure: seen along the push, the
/// corners go with the clock.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4009",
    name = "Pressure",
    nick = "Pressure",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Pressure", "P", "The force, for a solver.")]
fn pressure(
    /// A corner.
    #[port("Point1", "Point1")]
    a: Point3,
    /// The second corner.
    #[port("Point2", "Point2")]
    b: Point3,
    /// The third corner.
    #[port("Point3", "Point3")]
    c: Point3,
    /// The force on a unit of area.
    #[port("PressureLevel", "PressureLevel", default = 1.0)]
    level: f64,
) -> Result<Value, Message> {
    let rule = Pressure { strength: finite(level, "The pressure")? };
    Goal::item("Kangaroo force: Pressure", vec![a, b, c], rule)
}

/// Segments pulled to the mean of their lengths.
#[derive(Debug)]
struct Equal {
    strength: f64,
}

impl Rule for Equal {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let length = |pair: &[Point3]| match pair {
            [a, b] => a.distance_to(*b),
            _ => 0.0,
        };
        let mean = points.chunks_exact(2).map(length).sum::<f64>() / (points.len() / 2).max(1) as f64;
        for (pair, pulls) in points.chunks_exact(2).zip(pulls.chunks_exact_mut(2)) {
            stretch(pair, mean, self.strength, pulls);
        }
    }
}

/// Pulls segments to one length: the mean of those that they have. Stands for the elder Kangaroo's Equalize.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f400a",
    name = "Equalize",
    nick = "Equalize",
    at = "Kangaroo2/Elder",
    old
)]
#[output("EqualizeN", "EqN", "The force, for a solver.")]
fn equalize(
    /// The segments: curves count by their ends.
    #[port("Lines", "L")]
    lines: List<Shared<Curve>>,
    /// The strength.
    #[port("EqNStrength", "EqNStrength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let points = lines.present().flat_map(|line| ends(&line)).collect();
    Goal::item("Kangaroo force: Equalize", points, Equal { strength: finite(strength, "The strength")? })
}

/// The strength of a pull, where 0 stands for one that holds.
fn pull_strength(strength: f64) -> Result<f64, Message> {
    Ok(if finite(strength, "The strength")? == 0.0 { HOLD } else { strength })
}

/// Pulls points to a curve. Stands for the elder Kangaroo's CurvePull.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f400b",
    name = "CurvePull",
    nick = "CurvePull",
    at = "Kangaroo2/Elder",
    old
)]
#[output("PullToCurve", "P", "The force, for a solver.")]
fn curve_pull(
    /// The curve.
    #[port("Curve", "Curve")]
    curve: Shared<Curve>,
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The strength; 0 holds them on the curve.
    #[port("Strength", "Strength", default = 0.0)]
    strength: f64,
) -> Result<Value, Message> {
    let rule = OnCurve { curve, strength: pull_strength(strength)? };
    Goal::item("Kangaroo force: CurvePull", points.present().collect(), rule)
}

/// Pulls points to a mesh. Stands for the elder Kangaroo's PullToMesh.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f400c",
    name = "PullToMesh",
    nick = "Pull",
    at = "Kangaroo2/Elder",
    old
)]
#[output("PullToMesh", "Pull", "The force, for a solver.")]
fn pull_to_mesh(
    /// The mesh.
    #[port("ConstraintMesh", "ConstraintMesh")]
    mesh: &Mesh,
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The strength; 0 holds them on the mesh.
    #[port("PullStrength", "PullStrength", default = 0.0)]
    strength: f64,
) -> Result<Value, Message> {
    let rule = OnMesh { tree: MeshTree::new(mesh), strength: pull_strength(strength)? };
    Goal::item("Kangaroo force: PullToMesh", points.present().collect(), rule)
}

/// Pulls points to a surface, which is taken as a fine mesh. Stands for the elder Kangaroo's PullToSurf; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f400d",
    name = "PullToSurf",
    nick = "PullS",
    at = "Kangaroo2/Elder",
    old
)]
#[output("PullToSurf", "Pull", "The force, for a solver.")]
fn pull_to_surface(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "Surface")]
    surface: Shared<katydid_geometry::Brep>,
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The strength; 0 holds them on the surface.
    #[port("PullStrength", "PullStrength", default = 0.0)]
    strength: f64,
) -> Result<Value, Message> {
    let settings = MeshSettings::within(context.tolerance().absolute);
    let mesh = surface.mesh_unless(&settings, &context.stop())?.welded()?;
    let rule = OnMesh { tree: MeshTree::new(&mesh), strength: pull_strength(strength)? };
    Goal::item("Kangaroo force: PullToSurf", points.present().collect(), rule)
}

/// Two points that push each other away, or pull, by a power of their distance.
#[derive(Debug)]
struct Power {
    exponent: i32,
    strength: f64,
    cutoff: f64,
}

impl Rule for Power {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let ([a, b], [p, q]) = (points, pulls) else { return };
        let way = *b - *a;
        let length = way.length();
        let out = (self.cutoff > 0.0 && length > self.cutoff) || (self.cutoff < 0.0 && length < -self.cutoff);
        if out || !(length > SHORTEST) {
            return;
        }
        let force = way * (self.strength * length.powi(self.exponent) / length);
        (*p, *q) = (Pull::new(-force, 1.0), Pull::new(force, 1.0));
    }
}

/// Pushes two points apart, or pulls them together, by a power of their distance. Stands for the elder Kangaroo's PowerLaw.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f400e",
    name = "PowerLaw",
    nick = "PowerLaw",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Power Law", "P", "The force, for a solver.")]
fn power_law(
    /// The segment between the points.
    #[port("Connection", "Connection")]
    line: Line,
    /// The power.
    #[port("Exponent", "Exponents", default = -2)]
    exponent: i32,
    /// The strength: positive pushes, negative pulls.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
    /// Positive: it works below this distance; negative: above; 0: everywhere.
    #[port("Cutoff", "Cutoff", default = 0.0)]
    cutoff: f64,
) -> Result<Value, Message> {
    let rule = Power {
        exponent,
        strength: finite(strength, "The strength")?,
        cutoff: finite(cutoff, "The cutoff")?,
    };
    Goal::item("Kangaroo force: PowerLaw", vec![line.from, line.to], rule)
}

/// What a solver is told.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Settings {
    tolerance: f64,
    floor: bool,
}

/// Settings of a solver: the tolerance and the floor count; the rest of bodies is the same for all others. Stands for the elder
/// Kangaroo's Kangaroo Settings.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f400f",
    name = "Kangaroo Settings",
    nick = "KSettings",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Settings", "Settings", "The settings.")]
fn settings(
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = 0.01)]
    tolerance: f64,
    /// Not needed: the rest is the same.
    #[port("TimeStep", "TimeStep", optional)]
    _step: Option<f64>,
    /// Not needed: all steps are taken in one solve.
    #[port("SubIterations", "SubIterations", optional)]
    _steps: Option<i32>,
    /// Whether nothing falls below z = 0.
    #[port("Floor", "Floor", default = false)]
    floor: bool,
) -> Value {
    keep("Kangaroo settings".to_owned(), Settings { tolerance, floor })
}

/// Particles' places before and after, found by the place before.
struct Moved<'a> {
    before: &'a [Point3],
    after: &'a [Point3],
    size: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> Moved<'a> {
    fn new(before: &'a [Point3], after: &'a [Point3], tolerance: f64) -> Self {
        let mut moved = Self { before, after, size: tolerance.max(SMALLEST_CELL), cells: HashMap::new() };
        for (i, p) in before.iter().enumerate() {
            let key = moved.cell(*p);
            moved.cells.entry(key).or_default().push(i);
        }
        moved
    }

    fn cell(&self, p: Point3) -> [i64; 3] {
        [p.x, p.y, p.z].map(|x| (x / self.size).floor() as i64)
    }

    /// Where the particle at a place is now; the place itself where there is none.
    fn point(&self, p: Point3) -> Point3 {
        let [x, y, z] = self.cell(p);
        let around = (0..27).map(|k| {
            let step = |n: i64| n - 1;
            [x.saturating_add(step(k % 3)), y.saturating_add(step(k / 3 % 3)), z.saturating_add(step(k / 9))]
        });
        let near = around
            .filter_map(|key| self.cells.get(&key))
            .flatten()
            .filter_map(|i| Some((*i, self.before.get(*i)?.distance_to(p))))
            .filter(|(_, far)| *far <= self.size)
            .min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        near.and_then(|(i, _)| self.after.get(i)).copied().unwrap_or(p)
    }

    /// Geometry whose corners go with the particles.
    fn value(&self, value: &Value) -> Result<Value, Message> {
        Ok(match value {
            Value::Point(p) => Value::Point(self.point(*p)),
            Value::Line(line) => Value::from(Line::new(self.point(line.from), self.point(line.to))),
            Value::Mesh(mesh) => {
                let points = mesh.vertices().iter().map(|p| self.point(*p)).collect();
                let moved =
                    Mesh::from_parts(points, mesh.faces().to_vec(), Vec::new(), mesh.colours().to_vec())?;
                Value::from(Shared::new(moved.with_normals()))
            }
            Value::Curve(curve) => match curve.as_polyline() {
                Some(points) => {
                    let points = points.into_iter().map(|p| self.point(p)).collect();
                    Value::from(Curve::from(PolylineCurve::new(points)?))
                }
                None => {
                    let mut nurbs = curve.to_nurbs()?;
                    for i in 0..nurbs.point_count() {
                        if let Some(p) = nurbs.control_point(i) {
                            nurbs = nurbs.with_control_point(i, self.point(p))?;
                        }
                    }
                    Value::from(Curve::from(nurbs))
                }
            },
            other => other.clone(),
        })
    }
}

/// What a solver of the elder Kangaroo gives: words, steps, particles, geometry and the energy of motion.
type Solved = (Shared<str>, i32, Vec<Point3>, Tree, f64);

/// Brings forces to rest, with points that stay where they are.
fn solve(
    context: &Context<'_>,
    forces: &Tree,
    anchors: &Tree,
    settings: &Tree,
    geometry: &Tree,
    run: Option<(f64, Option<usize>)>,
) -> Result<Solved, Message> {
    let told = settings.column().iter().flatten().find_map(|value| kept::<Settings>(&value).copied());
    let told = told.unwrap_or(Settings { tolerance: TOLERANCE, floor: false });
    let mut goals: Vec<Option<Value>> = forces.column().iter().filter(Option::is_some).collect();
    for value in anchors.column().iter().flatten() {
        if let Value::Point(p) = value {
            goals.push(Some(Goal::item("Kangaroo anchor", vec![p], Back { place: p, strength: HOLD })?));
        }
    }
    if told.floor {
        goals.push(Some(Goal::everywhere("Kangaroo floor", Floor { strength: HOLD })));
    }
    let mut system = System::new(context, &goals, &[], told.tolerance)?;
    let before = system.points.clone();
    if let Some((rest, most)) = run {
        let limit = system.most_steps();
        let most = most.unwrap_or(limit).clamp(1, limit);
        if !system.run(context, Motion::ToRest, rest, most)? {
            let text =
                format!("Not at rest after {} steps: the forces may contradict each other", system.steps);
            context.tell(Message::remark(text));
        }
    }
    let moved = Moved::new(&before, &system.points, told.tolerance.max(TOLERANCE));
    let mut builder = TreeBuilder::<Value>::new();
    for branch in geometry.branches() {
        builder.branch(branch.path().clone());
        for value in branch.iter() {
            builder.push(value.map(|value| moved.value(&value)).transpose()?);
        }
    }
    let words = format!("{} particles, {} forces", system.points.len(), goals.len());
    let steps = i32::try_from(system.steps).unwrap_or(i32::MAX);
    Ok((Shared::from(words), steps, system.points.clone(), builder.finish(), 0.0))
}

/// Brings points to where the forces on them are in balance. Stands for the elder Kangaroo's KangarooPhysics.
///
/// Kangaroo shows the motion step by step; here all steps are taken in one solve, until the points rest or 20,000 steps are done.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4010",
    name = "KangarooPhysics",
    nick = "Kangaroo",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Out", "Out", "How many particles and forces there are.", kind = Text)]
#[output("Iterations", "Iterations", "The number of steps.", kind = Integer)]
#[output("ParticlesOut", "ParticlesOut", "The points where they come to rest.", kind = Point)]
#[output("GeometryOut", "GeometryOut", "The geometry, moved with the points.")]
#[output("KE", "KE", "The energy of motion: 0 at rest.", kind = Number)]
fn physics(
    context: &Context<'_>,
    /// The forces.
    #[port("Force objects", "Force objects")]
    forces: &Tree,
    /// Points that stay.
    #[port("AnchorPoints", "AnchorPoints", optional, kind = Point)]
    anchors: &Tree,
    /// The settings.
    #[port("Settings", "Settings", optional)]
    settings: &Tree,
    /// What goes with the points: points, lines, curves and meshes whose corners are among them.
    #[port("Geometry", "Geometry", optional)]
    geometry: &Tree,
    /// Whether the points stay where they are at first.
    #[port("SimulationReset", "SimulationReset", default = false)]
    reset: bool,
) -> Result<(Shared<str>, i32, Vec<Point3>, Tree, f64), Message> {
    solve(context, forces, anchors, settings, geometry, (!reset).then_some((REST, None)))
}

/// Brings points to where the forces on them are in balance, in one go. Stands for the elder Kangaroo's ZombieKangaroo; how many steps
/// it takes is our own.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f4011",
    name = "ZombieKangaroo",
    nick = "Zombie",
    at = "Kangaroo2/Elder",
    old
)]
#[output("Out", "Out", "How many particles and forces there are.", kind = Text)]
#[output("Iterations", "Iterations", "The number of steps.", kind = Integer)]
#[output("ParticlesOut", "ParticlesOut", "The points where they come to rest.", kind = Point)]
#[output("GeometryOut", "GeometryOut", "The geometry, moved with the points.")]
#[output("KE", "KE", "The energy of motion: 0 at rest.", kind = Number)]
fn zombie(
    context: &Context<'_>,
    /// The forces.
    #[port("Force objects", "Force objects")]
    forces: &Tree,
    /// Points that stay.
    #[port("AnchorPoints", "AnchorPoints", optional, kind = Point)]
    anchors: &Tree,
    /// The settings.
    #[port("Settings", "Settings", optional)]
    settings: &Tree,
    /// What goes with the points: points, lines, curves and meshes whose corners are among them.
    #[port("Geometry", "Geometry", optional)]
    geometry: &Tree,
    /// The mean square of a step at which points are at rest, in square units.
    #[port("Threshold", "Threshold", default = REST)]
    rest: f64,
    /// The most steps.
    #[port("Max Iters", "Max Iters", default = 1000)]
    most: i32,
) -> Result<(Shared<str>, i32, Vec<Point3>, Tree, f64), Message> {
    let rest = finite(rest, "The threshold")?.max(0.0);
    solve(context, forces, anchors, settings, geometry, Some((rest, usize::try_from(most).ok())))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Tree, Value};
    use katydid_geometry::{Curve, Line, Point3, Vector3};

    /// A component of the elder Kangaroo by the end of its id.
    fn of(end: &str) -> Trial {
        Trial::of_guid(&format!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f40{end}"))
    }

    fn made(trial: Trial) -> Value {
        trial.run().outputs[0].column().get(0).unwrap()
    }

    #[test]
    fn a_weight_hangs_on_a_spring() {
        let (top, low) = (Point3::new(0.0, 0.0, 5.0), Point3::new(0.0, 0.0, 4.0));
        let line = Line::new(top, low);
        // 10 of force on a stiffness of 100 make the spring a tenth longer.
        let spring = made(
            of("01").item(Curve::from(line)).item(100.0).default().item(1.0).item(0.0).item(0.0).item(0.0),
        );
        let weight = made(of("03").item(low).item(Vector3::new(0.0, 0.0, -10.0)));
        let solver = of("10").list([spring, weight]).list([top]).tree(Tree::empty()).list([line]).item(false);
        let run = solver.run();
        let found = run.outputs[2].column().iter().flatten().collect::<Vec<_>>();
        let Value::Point(p) = &found[1] else { panic!("{found:?}") };
        assert!((p.z - 3.9).abs() < 2e-3, "{p:?}");
        let Some(Value::Line(moved)) = run.outputs[3].column().get(0) else { panic!() };
        assert!(moved.to.distance_to(*p) < 1e-12);
    }

    #[test]
    fn a_quad_becomes_flat() {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.4], [0.0, 1.0, 0.0]].map(Point3::from);
        let [a, b, c, d] = corners;
        let flat = made(of("08").item(a).item(b).item(c).item(d).item(1.0));
        let none: Vec<Point3> = Vec::new();
        let run = of("11")
            .list([flat])
            .list(none)
            .tree(Tree::empty())
            .tree(Tree::empty())
            .item(1e-20)
            .item(1000)
            .run();
        let points: Vec<Point3> = run.outputs[2]
            .column()
            .iter()
            .filter_map(|value| match value {
                Some(Value::Point(p)) => Some(p),
                _ => None,
            })
            .collect();
        let volume = (points[1] - points[0]).triple_product(points[2] - points[0], points[3] - points[0]);
        assert!(volume.abs() < 1e-6, "{volume}");
    }
}
