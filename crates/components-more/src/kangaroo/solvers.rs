//! Main: the solvers, and goals that only show.

use katydid_component::{Context, Message, component};
use katydid_data::{Column, Path, Tree, TreeBuilder, Value};
use katydid_geometry::{Curve, Line, Mesh, Point3};

use super::held::{Hand, begin_anew};
use super::solve::{Motion, System};
use super::thresholds::{REST, TOLERANCE, ZOMBIE_REST};
use super::utility::polyline;
use super::{Goal, Pull, Rule};

/// All items of a tree in order.
fn items(tree: &Tree) -> Vec<Option<Value>> {
    tree.column().iter().collect()
}

/// What the goals of these items show, in the branches of `goals`; `from` is the number of the first item.
fn shown(system: &System, goals: &Tree, from: usize) -> Tree {
    let mut builder = TreeBuilder::<Value>::new();
    let mut k = from;
    for branch in goals.branches() {
        builder.branch(branch.path().clone());
        for _ in branch.iter() {
            builder.push(system.shown(k));
            k += 1;
        }
    }
    builder.finish()
}

/// The same as one list.
fn shown_list(system: &System, count: usize) -> Tree {
    let values: Vec<Option<Value>> = (0..count).map(|k| system.shown(k)).collect();
    if values.is_empty() { Tree::empty() } else { Tree::branch_at(Path::zero(), Column::of_options(values)) }
}

fn steps(system: &System) -> i32 {
    i32::try_from(system.steps).unwrap_or(i32::MAX)
}

fn threshold(value: f64) -> Result<f64, Message> {
    if value.is_finite() { Ok(value.max(0.0)) } else { Err(Message::error("The threshold is not finite")) }
}

/// Says that a solver has not come to rest.
fn unrested(context: &Context<'_>, system: &System) {
    let text = format!("Not at rest after {} steps: the goals may contradict each other", system.steps);
    context.tell(Message::remark(text));
}

/// Brings the system of a solver to rest, unless it shall stay as it is at first; while a hand drags, nearer to rest.
fn settle(
    context: &Context<'_>,
    name: &'static str,
    system: &mut System,
    motion: Motion,
    rest: f64,
    [reset, on]: [bool; 2],
) -> Result<(), Message> {
    if reset || !on {
        begin_anew(context, name, system);
        return Ok(());
    }
    let rest = threshold(rest)?;
    let hand = Hand::take(context, name, system);
    let (is_held, most) = (hand.is_held(), hand.most_steps(system, 1));
    let ran = system.run(context, motion, rest, most);
    hand.keep(context, system);
    if !ran? && !is_held {
        unrested(context, system);
    }
    Ok(())
}

/// Brings points to where their goals are in balance. Kangaroo goes on step by step while one looks; here all steps are taken
/// in one solve, until the points rest or 20,000 steps are done. Stands for Kangaroo 2's Solver.
#[component("313490f5-8e38-4dde-9e9a-05e4d739b35d", name = "Solver", nick = "Solver", at = "Kangaroo2/Main")]
#[output("Iterations", "I", "The number of steps.", kind = Integer)]
#[output("Vertices", "V", "The points where they come to rest.", kind = Point)]
#[output(
    "Output",
    "O",
    "What each goal shows, in the branches of the goals; null for those that show nothing."
)]
fn solver(
    context: &Context<'_>,
    /// The goals.
    #[port("GoalObjects", "GoalObjects")]
    goals: &Tree,
    /// Whether the points stay where they are at first.
    #[port("Reset", "Reset", default = false)]
    reset: bool,
    /// The mean square of a step at which points are at rest, in square units.
    #[port("Threshold", "Threshold", default = REST)]
    rest: f64,
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = TOLERANCE)]
    tolerance: f64,
    /// Whether it runs; else the points stay where they are at first.
    #[port("On", "On", default = true)]
    on: bool,
) -> Result<(i32, Vec<Point3>, Tree), Message> {
    let mut system = System::new(context, &items(goals), &[], tolerance)?;
    settle(context, "Solver", &mut system, Motion::ToRest, rest, [reset, on])?;
    Ok((steps(&system), system.points.clone(), shown(&system, goals, 0)))
}

/// Brings points to where their goals are in balance. Stands for an earlier Solver of Kangaroo 2, whose output is a list.
#[component(
    "8f9f19c0-207a-419d-90f6-2fcadaa845f9",
    name = "Solver",
    nick = "Solver",
    at = "Kangaroo2/Main",
    old
)]
#[output("Iterations", "I", "The number of steps.", kind = Integer)]
#[output("Vertices", "V", "The points where they come to rest.", kind = Point)]
#[output("Output", "O", "What each goal shows; null for those that show nothing.")]
fn solver_of_lists(
    context: &Context<'_>,
    /// The goals.
    #[port("GoalObjects", "GoalObjects")]
    goals: &Tree,
    /// Whether the points stay where they are at first.
    #[port("Reset", "Reset", default = false)]
    reset: bool,
    /// The mean square of a step at which points are at rest, in square units.
    #[port("Threshold", "Threshold", default = REST)]
    rest: f64,
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = TOLERANCE)]
    tolerance: f64,
    /// Whether it runs; else the points stay where they are at first.
    #[port("On", "On", default = true)]
    on: bool,
) -> Result<(i32, Vec<Point3>, Tree), Message> {
    let items = items(goals);
    let mut system = System::new(context, &items, &[], tolerance)?;
    settle(context, "Solver", &mut system, Motion::ToRest, rest, [reset, on])?;
    Ok((steps(&system), system.points.clone(), shown_list(&system, items.len())))
}

/// Brings points to where their goals are in balance. Stands for the first Solver of Kangaroo 2, which takes points to begin
/// with.
#[component(
    "a54d250e-e285-4f38-9fb3-8dd9c886c659",
    name = "Solver",
    nick = "Solver",
    at = "Kangaroo2/Main",
    old
)]
#[output("Vertices", "V", "The points where they come to rest.", kind = Point)]
#[output("Output", "O", "What each goal shows; null for those that show nothing.")]
fn solver_with_points(
    context: &Context<'_>,
    /// The goals.
    #[port("GoalObjects", "GoalObjects")]
    goals: &Tree,
    /// The first particles, which goals may ask for by number.
    #[port("Points", "Points", optional, kind = Point)]
    points: &Tree,
    /// Whether the points stay where they are at first.
    #[port("Reset", "Reset", default = false)]
    reset: bool,
    /// Not needed: each solve begins anew.
    #[port("Restart", "Restart", optional)]
    _restart: Option<bool>,
    /// Not needed: the results are the same on any number of threads.
    #[port("Parallel", "Parallel", optional)]
    _parallel: Option<bool>,
    /// The mean square of a step at which points are at rest, in square units.
    #[port("Threshold", "Threshold", default = REST)]
    rest: f64,
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = TOLERANCE)]
    tolerance: f64,
    /// Not needed: each solve begins anew.
    #[port("AddCurrent", "AddCurrent", optional)]
    _add_current: Option<bool>,
    /// Whether it runs; else the points stay where they are at first.
    #[port("On", "On", default = true)]
    on: bool,
) -> Result<(Vec<Point3>, Tree), Message> {
    let first: Vec<Point3> = points
        .column()
        .iter()
        .filter_map(|value| match value {
            Some(Value::Point(p)) => Some(p),
            _ => None,
        })
        .collect();
    let items = items(goals);
    let mut system = System::new(context, &items, &first, tolerance)?;
    settle(context, "Solver", &mut system, Motion::ToRest, rest, [reset, on])?;
    Ok((system.points.clone(), shown_list(&system, items.len())))
}

/// Brings points to where their goals are in balance, in one go. Stands for Kangaroo 2's ZombieSolver; how many steps it takes
/// is our own.
#[component(
    "4408343b-577e-4fd8-96ff-df7549189186",
    name = "ZombieSolver",
    nick = "ZombieSolver",
    at = "Kangaroo2/Main"
)]
#[output("I", "I", "The number of steps.")]
#[output("V", "V", "The points where they come to rest.")]
#[output("O", "O", "What each goal shows; null for those that show nothing.", kind = Generic)]
fn zombie_solver(
    context: &Context<'_>,
    /// The goals.
    #[port("GoalObjects", "GoalObjects")]
    goals: &Tree,
    /// The mean square of a step at which points are at rest, in square units.
    #[port("Threshold", "Threshold", default = ZOMBIE_REST)]
    rest: f64,
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = TOLERANCE)]
    tolerance: f64,
    /// The most steps; 1 when fewer are asked for.
    #[port("MaxIterations", "MaxIterations", default = 100)]
    most: i32,
) -> Result<(i32, Vec<Point3>, Vec<Option<Value>>), Message> {
    let items = items(goals);
    let mut system = System::new(context, &items, &[], tolerance)?;
    let most = usize::try_from(most).unwrap_or(1).clamp(1, system.most_steps());
    system.run(context, Motion::ToRest, threshold(rest)?, most)?;
    let shown = (0..items.len()).map(|k| system.shown(k)).collect();
    Ok((steps(&system), system.points.clone(), shown))
}

/// The share of speed that is left after a step.
fn damping(value: f64) -> f64 {
    if value.is_finite() { value.clamp(0.0, 1.0) } else { 1.0 }
}

/// Moves points as bodies with inertia until they rest. Kangaroo shows the motion step by step; here all steps are taken in
/// one solve. Stands for Kangaroo 2's BouncySolver.
#[component(
    "0febdb68-70bd-4882-b5e4-f68d1cddc4ae",
    name = "BouncySolver",
    nick = "BouncySolver",
    at = "Kangaroo2/Main"
)]
#[output("Iterations", "I", "The number of steps.", kind = Integer)]
#[output("Vertices", "V", "The points where they come to rest.", kind = Point)]
#[output(
    "Output",
    "O",
    "What each goal shows, in the branches of the goals; null for those that show nothing."
)]
fn bouncy_solver(
    context: &Context<'_>,
    /// The goals.
    #[port("GoalObjects", "GoalObjects")]
    goals: &Tree,
    /// Whether the points stay where they are at first.
    #[port("Reset", "Reset", default = false)]
    reset: bool,
    /// The mean square of a step at which points are at rest, in square units.
    #[port("Threshold", "Threshold", default = REST)]
    rest: f64,
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = TOLERANCE)]
    tolerance: f64,
    /// How much of its speed a point keeps from step to step, from 0 to 1.
    #[port("Damping", "Damping", default = 0.99)]
    kept: f64,
    /// Not needed: all steps are taken in one solve.
    #[port("Iterations", "Iterations", optional)]
    _each: Option<i32>,
    /// Whether it runs; else the points stay where they are at first.
    #[port("On", "On", default = true)]
    on: bool,
) -> Result<(i32, Vec<Point3>, Tree), Message> {
    let mut system = System::new(context, &items(goals), &[], tolerance)?;
    settle(context, "BouncySolver", &mut system, Motion::Inertia(damping(kept)), rest, [reset, on])?;
    Ok((steps(&system), system.points.clone(), shown(&system, goals, 0)))
}

/// Takes some steps towards balance: one frame of a film. Each solve begins anew, so it shows the first frame; more steps show
/// a later one. Stands for Kangaroo 2's StepSolver.
#[component(
    "fa27771b-cf25-4a21-bf31-8bb20a7822b3",
    name = "StepSolver",
    nick = "StepSolver",
    at = "Kangaroo2/Main"
)]
#[output("Iterations", "I", "The number of steps.", kind = Integer)]
#[output("Vertices", "V", "The points.", kind = Point)]
#[output(
    "Output",
    "O",
    "What each goal shows, in the branches of the goals; null for those that show nothing."
)]
fn step_solver(
    context: &Context<'_>,
    /// The goals.
    #[port("GoalObjects", "GoalObjects")]
    goals: &Tree,
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = TOLERANCE)]
    tolerance: f64,
    /// Whether the points move as bodies with inertia; else as quickly to rest as can be.
    #[port("Momentum", "Momentum", default = false)]
    momentum: bool,
    /// How much of its speed a point keeps from step to step, from 0 to 1; counts with momentum only.
    #[port("Damping", "Damping", default = 0.99)]
    kept: f64,
    /// The number of steps.
    #[port("SubIterations", "SubIterations", default = 10)]
    count: i32,
    /// Whether it moves; else the points stay where they are at first.
    #[port("Animate", "Animate", default = false)]
    animate: bool,
) -> Result<(i32, Vec<Point3>, Tree), Message> {
    let mut system = System::new(context, &items(goals), &[], tolerance)?;
    if animate {
        let motion = if momentum { Motion::Inertia(damping(kept)) } else { Motion::ToRest };
        let count = usize::try_from(count).unwrap_or(0).min(system.most_steps());
        let hand = Hand::take(context, "StepSolver", &mut system);
        let ran = system.run(context, motion, 0.0, count);
        hand.keep(context, &system);
        ran?;
    } else {
        begin_anew(context, "StepSolver", &system);
    }
    Ok((steps(&system), system.points.clone(), shown(&system, goals, 0)))
}

const SOFT_AND_HARD: &str = "Soft & Hard Solver";

/// Steps of soft goals, each followed by several of the hard ones.
struct Turns {
    /// What part of a step the soft goals take.
    share: f64,
    hard_steps: usize,
    rest: f64,
}

impl Turns {
    /// Goes on until the mean square of a step is below `rest` and no goal gives way, at most `most` times. Gives whether it came
    /// to rest.
    fn take(
        &self,
        context: &Context<'_>,
        gentle: &mut System,
        strict: &mut System,
        most: usize,
    ) -> Result<bool, Message> {
        for _ in 0..most {
            context.check()?;
            let before = strict.points.clone();
            gentle.points.clone_from(&strict.points);
            gentle.relax(self.share);
            strict.points.clone_from(&gentle.points);
            for _ in 0..self.hard_steps {
                strict.relax(1.0);
            }
            let moved =
                before.iter().zip(&strict.points).map(|(a, b)| (*a - *b).length_squared()).sum::<f64>();
            if moved / before.len().max(1) as f64 <= self.rest {
                gentle.points.clone_from(&strict.points);
                let gives_way = [gentle.give_way(), strict.give_way()];
                if gives_way == [false; 2] {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }
}

/// Brings points to where hard goals are met, and soft ones as far as the hard ones let them: after each step of the soft goals
/// the hard ones take several. Stands for Kangaroo 2's Soft & Hard Solver.
#[component(
    "35c49588-244d-43a4-81b2-fd3ef59c1b1d",
    name = "Soft & Hard Solver",
    nick = "Soft&HardSolver",
    at = "Kangaroo2/Main"
)]
#[output("Iterations", "I", "The number of steps of the soft goals.", kind = Integer)]
#[output("Vertices", "V", "The points where they come to rest.", kind = Point)]
#[output("Output", "O", "What each soft goal shows, in their branches, then each hard goal in theirs.")]
fn soft_and_hard_solver(
    context: &Context<'_>,
    /// Goals that are met as far as the hard ones let them.
    #[port("SoftGoals", "SoftGoals")]
    soft: &Tree,
    /// Goals that go before.
    #[port("HardGoals", "HardGoals", optional)]
    hard: &Tree,
    /// How many steps the hard goals take after each step of the soft ones.
    #[port("HardIterations", "HardIterations", default = 10)]
    hard_steps: i32,
    /// What part of a step the soft goals take, from 0 to 1.
    #[port("SoftMultiplier", "SoftMultiplier", default = 1.0)]
    share: f64,
    /// Whether the points stay where they are at first.
    #[port("Reset", "Reset", default = false)]
    reset: bool,
    /// The mean square of a step at which points are at rest, in square units.
    #[port("Threshold", "Threshold", default = REST)]
    rest: f64,
    /// Points nearer than this are one, in units.
    #[port("Tolerance", "Tolerance", default = TOLERANCE)]
    tolerance: f64,
    /// Whether it runs; else the points stay where they are at first.
    #[port("On", "On", default = true)]
    on: bool,
) -> Result<(i32, Vec<Point3>, Tree), Message> {
    let (first, second) = (items(soft), items(hard));
    let all: Vec<Option<Value>> = first.iter().chain(&second).cloned().collect();
    // One list of particles for both: the points of the whole are those that each part begins with.
    let mut whole = System::new(context, &all, &[], tolerance)?;
    let (mut gentle, mut strict) = (
        System::new(context, &first, &whole.points, tolerance)?,
        System::new(context, &second, &whole.points, tolerance)?,
    );
    let rest = threshold(rest)?;
    if on && !reset {
        let hand = Hand::take(context, SOFT_AND_HARD, &mut whole);
        gentle.hold_as(&whole, 0);
        strict.hold_as(&whole, gentle.goals.len());
        let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 1.0 };
        let turns = Turns { share, hard_steps: usize::try_from(hard_steps).unwrap_or(0).min(1000), rest };
        let (is_held, most) = (hand.is_held(), hand.most_steps(&whole, turns.hard_steps + 1));
        let rested = turns.take(context, &mut gentle, &mut strict, most);
        whole.points.clone_from(&strict.points);
        whole.steps += gentle.steps;
        hand.keep(context, &whole);
        if !rested? && !all.is_empty() && !is_held {
            unrested(context, &gentle);
        }
    } else {
        begin_anew(context, SOFT_AND_HARD, &whole);
    }
    let trees = [shown(&whole, soft, 0), shown(&whole, hard, first.len())];
    Ok((steps(&whole), whole.points.clone(), Tree::merge(trees.iter())))
}

/// Geometry that goes along with the particles at its corners.
#[derive(Debug)]
enum Show {
    Points,
    Line,
    Polyline,
    Mesh(Mesh),
}

impl Rule for Show {
    fn pull(&self, _: &[Point3], _: &mut [f64], _: usize, _: &mut [Pull]) {}

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        match self {
            Self::Points => points.first().map(|p| Value::Point(*p)),
            Self::Line => match points {
                [a, b] => Some(Value::from(Line::new(*a, *b))),
                _ => None,
            },
            Self::Polyline => polyline(points.to_vec()),
            Self::Mesh(mesh) => {
                let moved = Mesh::from_parts(
                    points.to_vec(),
                    mesh.faces().to_vec(),
                    Vec::new(),
                    mesh.colours().to_vec(),
                );
                moved.ok().map(|mesh| Value::from(mesh.with_normals()))
            }
        }
    }
}

/// Shows geometry where its corners come to rest: a point, a line, a polyline or a mesh. Stands for Kangaroo 2's Show.
#[component("0ed5e67d-539d-480e-88cb-d81fa795d66c", name = "Show", nick = "Show", at = "Kangaroo2/Main")]
#[output("G", "G", "The goal, for a solver, which gives the geometry.")]
fn show(
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: Value,
) -> Result<Value, Message> {
    let curve = |curve: &Curve| match curve.as_polyline() {
        Some(points) if points.len() == 2 => Ok((points, Show::Line)),
        Some(points) => Ok((points, Show::Polyline)),
        None => Err(Message::error("Only points, lines, polylines and meshes can be shown")),
    };
    let (points, show) = match &geometry {
        Value::Point(p) => (vec![*p], Show::Points),
        Value::Line(line) => (vec![line.from, line.to], Show::Line),
        Value::Curve(own) => curve(own)?,
        Value::Mesh(mesh) => (mesh.vertices().to_vec(), Show::Mesh((**mesh).clone())),
        other => match katydid_data::cast::value(other, katydid_data::Kind::Curve, &Default::default()) {
            Some(Value::Curve(own)) => curve(&own)?,
            _ => return Err(Message::error("Only points, lines, polylines and meshes can be shown")),
        },
    };
    Goal::item("Kangaroo goal: Show", points, show)
}
