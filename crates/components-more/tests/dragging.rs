//! A hand drags particles of Kangaroo's solvers, which go on from where they are.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

use std::sync::Arc;

use katydid_component::testing::Trial;
use katydid_component::{Kept, Outcome};
use katydid_data::{Column, Path, Tree, Value};
use katydid_definition::archive::ItemValue;
use katydid_geometry::{Curve, Line, LineCurve, Point3, Vector3};

const SOLVER: &str = "313490f5-8e38-4dde-9e9a-05e4d739b35d";
const BOUNCY_SOLVER: &str = "0febdb68-70bd-4882-b5e4-f68d1cddc4ae";
const GRAB: &str = "ea145d1d-7727-4d52-8db6-c9b7100ab7f9";
/// The links of the rope, from one anchor to the other.
const LINKS: usize = 8;

fn goals(trial: Trial) -> Vec<Value> {
    let outcome = trial.run();
    assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
    outcome.outputs[0].column().iter().flatten().collect()
}

fn place(i: usize) -> Point3 {
    Point3::new(i as f64, 0.0, 0.0)
}

/// A rope of springs of strength 20 and length 1.1 between anchors, each node with a weight of 1.
fn rope() -> Vec<Value> {
    let mut all = Vec::new();
    for i in 0..LINKS {
        let line = Curve::Line(LineCurve::new(Line::new(place(i), place(i + 1))));
        all.extend(goals(Trial::of("Length(Line)").item(line).item(1.1).item(20.0)));
    }
    let load = Trial::of_guid("2019c995-53af-4eb2-976d-95b1fdc823fa");
    let inner: Vec<Point3> = (1..LINKS).map(place).collect();
    all.extend(goals(load.list(inner).item(Vector3::new(0.0, 0.0, -1.0))));
    let anchor = Trial::of_guid("3c30b1a1-4473-4ad4-a700-ea9770726c03");
    all.extend(goals(anchor.list([place(0), place(LINKS)])));
    all
}

fn grab(strength: f64, hold: Option<(Point3, Point3)>) -> Value {
    let mut trial = Trial::of_guid(GRAB).default().item(strength);
    if let Some((from, to)) = hold {
        trial = trial
            .setting("GrabFrom", ItemValue::Point3d([from.x, from.y, from.z]))
            .setting("GrabTo", ItemValue::Point3d([to.x, to.y, to.z]))
            .setting("GrabReach", 0.3);
    }
    goals(trial).pop().unwrap()
}

/// The same goals again and again with another hand each time, as a studio has them solved.
struct Bench {
    goals: Vec<Value>,
    kept: Arc<Kept>,
    solver: &'static str,
}

impl Bench {
    fn new(solver: &'static str) -> Self {
        katydid_components_more::link();
        Self { goals: rope(), kept: Arc::default(), solver }
    }

    fn solve(&self, grab: Value) -> Outcome {
        let all = self.goals.iter().cloned().chain([grab]).collect();
        let tree = Tree::branch_at(Path::zero(), Column::of_values(all, None));
        let outcome = Trial::of_guid(self.solver).tree(tree).kept(&self.kept).run();
        assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
        outcome
    }

    fn points(&self, grab: Value) -> Vec<Point3> {
        points(&self.solve(grab))
    }

    /// Solves until nothing moves any more.
    fn rested(&self, hold: (Point3, Point3), strength: f64) -> Vec<Point3> {
        let mut before = self.points(grab(strength, Some(hold)));
        for _ in 0..5000 {
            let now = self.points(grab(strength, Some(hold)));
            if far(&before, &now) < 1e-12 {
                return now;
            }
            before = now;
        }
        panic!("it does not come to rest");
    }
}

fn points(outcome: &Outcome) -> Vec<Point3> {
    let points = outcome.outputs[1].column().iter();
    points.map(|v| if let Some(Value::Point(p)) = v { p } else { panic!("{v:?}") }).collect()
}

fn far(a: &[Point3], b: &[Point3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance_to(*b)).fold(0.0, f64::max)
}

fn up(by: f64) -> Vector3 {
    Vector3::new(0.0, 0.0, by)
}

#[test]
fn a_goal_without_a_hand_asks_for_nothing() {
    let bench = Bench::new(SOLVER);
    let without = Tree::branch_at(Path::zero(), Column::of_values(bench.goals.clone(), None));
    let plain = points(&Trial::of_guid(SOLVER).tree(without).run());
    assert_eq!(bench.points(grab(1000.0, None)), plain);
    // As often as it is solved.
    assert_eq!(bench.points(grab(1000.0, None)), plain);
}

#[test]
fn the_particle_is_pulled_to_the_hand_with_its_strength() {
    let bench = Bench::new(SOLVER);
    let rest = bench.points(grab(1000.0, None));
    let from = rest[3];
    let to = from + up(2.0);
    // Taken a little beside it, as a pointer does.
    let at = bench.rested((from + up(0.1), to), 1000.0);
    // The forces on it are in balance: two springs, a weight, and the hand.
    let pull = |other: Point3| {
        let way = other - at[3];
        way.unitized().unwrap() * (20.0 * (way.length() - 1.1))
    };
    let force = pull(at[2]) + pull(at[4]) + up(-1.0) + (to - at[3]) * 1000.0;
    assert!(force.length() < 1e-3, "{force:?}");
    // So it is as far from the hand as the rope pulls it back.
    let off = at[3].distance_to(to);
    assert!(off > 0.001 && off < 0.05, "{off}");
    let stronger = bench.rested((from + up(0.1), to), 100_000.0);
    assert!(stronger[3].distance_to(to) < off / 50.0);
}

#[test]
fn it_goes_on_from_where_it_is_and_comes_back() {
    let bench = Bench::new(SOLVER);
    let steps = |outcome: &Outcome| match outcome.outputs[0].column().get(0) {
        Some(Value::Integer(n)) => n,
        other => panic!("{other:?}"),
    };
    let before = bench.solve(grab(1000.0, None));
    let rest = points(&before);
    let hold = (rest[4], rest[4] + up(3.0));
    let (first, second) = (bench.solve(grab(1000.0, Some(hold))), bench.solve(grab(1000.0, Some(hold))));
    // One sees the form give way: the first solve is on the way, and the next does not begin anew.
    assert_eq!([steps(&first), steps(&second)], [steps(&before) + 30, steps(&before) + 60]);
    let (first, second) = (points(&first), points(&second));
    assert!(first[4].distance_to(rest[4]) > 1.0);
    assert!(far(&first, &second) > 1e-6 && far(&rest, &first) > far(&first, &second));
    // Let go, it is as before; a rope has one place of rest.
    let back = bench.points(grab(1000.0, None));
    assert!(far(&back, &rest) < 1e-4, "{}", far(&back, &rest));
}

#[test]
fn the_same_particle_is_held_wherever_the_hand_goes() {
    let bench = Bench::new(SOLVER);
    let rest = bench.points(grab(1000.0, None));
    // Past its neighbour: that is nearer to the hand then.
    let from = rest[3];
    for share in [0.2, 0.5, 0.8, 1.0] {
        bench.points(grab(1000.0, Some((from, from + (rest[5] - from) * share))));
    }
    let at = bench.rested((from, rest[5] + up(0.5)), 1000.0);
    assert!(at[3].distance_to(rest[5] + up(0.5)) < 0.2, "{:?}", at[3]);
}

#[test]
fn what_is_out_of_reach_stays() {
    let bench = Bench::new(SOLVER);
    let rest = bench.points(grab(1000.0, None));
    let beside = rest[3] + up(0.5);
    assert_eq!(bench.points(grab(1000.0, Some((beside, beside + up(1.0))))), rest);
    // Range goes before the pointer's reach; a hand that is off holds nothing.
    let hand = |range: f64, on: bool| {
        let [from, to] = [beside, beside + up(1.0)].map(|p| ItemValue::Point3d([p.x, p.y, p.z]));
        let trial = Trial::of_guid(GRAB).item(on).item(1000.0).item(range);
        let trial = trial.setting("GrabFrom", from).setting("GrabTo", to).setting("GrabReach", 0.3);
        goals(trial).pop().unwrap()
    };
    assert_eq!(bench.points(hand(1.0, false)), rest);
    assert!(far(&bench.points(hand(1.0, true)), &rest) > 0.5);
}

#[test]
fn other_goals_begin_anew_and_reset_too() {
    let mut bench = Bench::new(SOLVER);
    let rest = bench.points(grab(1000.0, None));
    bench.rested((rest[4], rest[4] + up(3.0)), 1000.0);
    bench.goals = rope();
    assert_eq!(bench.points(grab(1000.0, None)), rest);
    bench.points(grab(1000.0, Some((rest[4], rest[4] + up(3.0)))));
    let all = bench.goals.iter().cloned().chain([grab(1000.0, None)]).collect();
    let tree = Tree::branch_at(Path::zero(), Column::of_values(all, None));
    let reset = points(&Trial::of_guid(SOLVER).tree(tree).item(true).kept(&bench.kept).run());
    assert!(reset.iter().all(|p| p.z == 0.0));
    assert_eq!(bench.points(grab(1000.0, None)), rest);
}

#[test]
fn other_solvers_are_dragged_too() {
    let bench = Bench::new(BOUNCY_SOLVER);
    let rest = bench.points(grab(1000.0, None));
    let to = rest[4] + up(2.0);
    let at = bench.rested((rest[4], to), 1000.0);
    assert!(at[4].distance_to(to) < 0.1, "{:?}", at[4]);
    let back = bench.points(grab(1000.0, None));
    assert!(far(&back, &rest) < 1e-3, "{}", far(&back, &rest));
}

#[test]
fn hard_goals_hold_against_a_hand_among_the_soft_ones() {
    let bench = Bench::new(SOLVER);
    let kept = Arc::new(Kept::default());
    let tree = |values: Vec<Value>| Tree::branch_at(Path::zero(), Column::of_values(values, None));
    let hard = tree(bench.goals.clone());
    let solve = |hold| {
        let trial = Trial::of("Soft & Hard Solver").tree(tree(vec![grab(1.0, hold)])).tree(hard.clone());
        points(&trial.kept(&kept).run())
    };
    let rest = solve(None);
    let mut at = rest.clone();
    for _ in 0..200 {
        at = solve(Some((rest[4], rest[4] + up(4.0))));
    }
    // It gives way, and less far than the hand.
    assert!(at[4].z > rest[4].z + 0.3 && at[4].z < rest[4].z + 3.9, "{:?} {:?}", at[4], rest[4]);
}
