//! Points that are handed out and come back in any order give the tables of a sweep, each point once.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fs;
use std::path::Path;
use std::time::Duration;

use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{Cell, Dispatcher, Plan, PlanFile, PointSolver, Prepared, Settings, Status, sweep};

const TEXT: &str = "katydid 1\nx = Number Slider(1, 0.00..2.00)\nn = Number Slider(3, 1..5)\n\
    root = Expression(\"Sqrt(x - 1) * n\", x = x, n = n)\nsum = Addition(x, n)\n";
const PLAN: &str = r#"{"inputs": {"x": {"steps": 21}, "n": {}}, "outputs": ["sum", "root"]}"#;

fn document() -> Document {
    katydid_components::link();
    kd::read(TEXT, &Registry).unwrap().document
}

fn plan() -> Plan {
    Plan::bind(&PlanFile::parse(PLAN).unwrap(), &document()).unwrap()
}

fn settings() -> Settings {
    Settings { workers: 2, ..Settings::default() }
}

fn tables(folder: &Path) -> Vec<Vec<u8>> {
    ["table.parquet", "data.csv", "failed.csv"].map(|name| fs::read(folder.join(name)).unwrap()).into()
}

fn solver() -> PointSolver {
    PointSolver::new(document(), Options::default(), &plan(), Cancel::default()).unwrap()
}

#[test]
fn batches_in_any_order_give_the_tables_of_a_sweep() {
    let [local, elsewhere] = [0, 1].map(|_| tempfile::tempdir().unwrap());
    sweep(document(), Options::default(), &plan(), local.path(), &settings(), |_| {}).unwrap();
    let (first, second) = (solver(), solver());
    let mut dispatcher = Dispatcher::open(plan(), elsewhere.path(), &settings()).unwrap();
    let mut batches = Vec::new();
    loop {
        let points = dispatcher.next_points(7).unwrap();
        if points.is_empty() {
            break;
        }
        batches.push(points);
    }
    assert_eq!(batches.iter().map(Vec::len).sum::<usize>(), 105);
    assert!(dispatcher.finish().is_err(), "points are missing");
    for (k, points) in batches.iter().rev().enumerate() {
        let solver = if k % 2 == 0 { &first } else { &second };
        let batch = solver.solve(points).unwrap();
        // Nothing of a damaged message is believed, and what comes twice counts once.
        let mut damaged = batch.records.clone();
        *damaged.last_mut().unwrap() ^= 1;
        let before = dispatcher.progress().solved;
        if points.len() == 1 {
            assert!(dispatcher.keep(&damaged, &[]).is_err());
            assert_eq!(dispatcher.progress().solved, before);
        }
        assert_eq!(dispatcher.keep(&batch.records, &batch.things).unwrap(), points.len() as u64);
        assert_eq!(dispatcher.keep(&batch.records, &batch.things).unwrap(), 0);
        assert!(dispatcher.keep(&damaged, &[]).is_err());
        assert!(dispatcher.keep(&batch.records[..batch.records.len() - 1], &[]).is_err());
    }
    let summary = dispatcher.finish().unwrap();
    assert_eq!((summary.progress.solved, summary.progress.had, summary.failed_rows), (105, 0, 50));
    assert!(tables(local.path()) == tables(elsewhere.path()));
    // A sweep goes on with what a dispatcher has begun.
    drop(dispatcher);
    let again =
        sweep(document(), Options::default(), &plan(), elsewhere.path(), &settings(), |_| {}).unwrap();
    assert_eq!((again.progress.solved, again.progress.had), (0, 105));
}

#[test]
fn results_of_points_that_nobody_handed_out_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let mut dispatcher = Dispatcher::open(plan(), folder.path(), &settings()).unwrap();
    let stranger = solver().solve(&[vec![Cell::Number(1.23), Cell::Number(2.0)]]).unwrap();
    assert!(dispatcher.keep(&stranger.records, &[]).is_err());
    let points = dispatcher.next_points(2).unwrap();
    dispatcher.give_up(&points[0], "its worker ended 3 times", Duration::ZERO).unwrap();
    assert_eq!(dispatcher.outcome(&points[0]).unwrap().unwrap().status, Status::Lost);
    assert_eq!(dispatcher.outcome(&points[1]).unwrap(), None);
    assert_eq!(dispatcher.progress().failed, 1);
    // What was handed out and did not come back is handed out again by the next one.
    drop(dispatcher);
    let mut next = Dispatcher::open(plan(), folder.path(), &settings()).unwrap();
    assert_eq!(next.next_points(1).unwrap(), points[1..]);
}

#[test]
fn points_that_a_program_asks_for_are_rows_once_in_that_order() {
    let folder = tempfile::tempdir().unwrap();
    let space = Plan::space(&PlanFile::parse(PLAN).unwrap(), &document(), &[]).unwrap();
    let prepared =
        Prepared::new(document(), Options::default(), space.variables().to_vec(), space.outputs().to_vec());
    let point = |x: f64, n: f64| vec![Cell::Number(x), Cell::Number(n)];
    let ask = |dispatcher: &mut Dispatcher, points: Vec<Vec<Cell>>| {
        let points: Vec<_> = points.into_iter().map(|point| dispatcher.fitted(point)).collect();
        let wanted = dispatcher.ask(&points).unwrap();
        let count = wanted.len();
        dispatcher.solve_here(&prepared, wanted, 2, &Cancel::default()).unwrap();
        count
    };
    let mut dispatcher = Dispatcher::open(space.clone(), folder.path(), &settings()).unwrap();
    dispatcher.ask_as_before().unwrap();
    let points = vec![point(1.251, 2.0), point(0.5, 1.0), point(1.25, 2.2), point(1.25, 2.0)];
    assert_eq!(ask(&mut dispatcher, points), 2);
    assert_eq!(ask(&mut dispatcher, vec![point(2.0, 5.0), point(0.5, 1.0)]), 1);
    dispatcher.finish_asked().unwrap();
    let text = fs::read_to_string(folder.path().join("data.csv")).unwrap();
    let starts: Vec<&str> = text.lines().skip(1).map(|line| &line[..line.len().min(9)]).collect();
    assert_eq!(starts, ["1.25,2,3.", "0.5,1,1.5", "2,5,7,5,2"]);
    drop(dispatcher);
    let mut next = Dispatcher::open(space, folder.path(), &settings()).unwrap();
    next.ask_as_before().unwrap();
    assert_eq!(ask(&mut next, vec![point(2.0, 5.0), point(0.0, 3.0)]), 1);
    next.finish_asked().unwrap();
    let longer = fs::read_to_string(folder.path().join("data.csv")).unwrap();
    assert!(longer.starts_with(&text) && longer.lines().count() == 5, "{longer}");
}
