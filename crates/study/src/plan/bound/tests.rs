use katydid_definition::kd;
use katydid_session::Registry;

use super::*;

fn document() -> Document {
    katydid_components::link();
    let text = "katydid 1\nx = Number Slider(0.5, 0.00..1.00)\nn = Number Slider(4, 2..6)\ne = Number Slider(4, 2..8, rounding = even)\n\
                on = Boolean Toggle(true)\ns = Addition(x, n)\nout = Panel(s)\n";
    kd::read(text, &Registry).unwrap().document
}

fn points(plan: &str) -> Result<Vec<Vec<String>>, String> {
    let file = PlanFile::parse(plan).map_err(|error| error.to_string())?;
    let plan = Plan::bind(&file, &document()).map_err(|error| error.to_string())?;
    let points: Vec<Vec<String>> = plan
        .points()
        .map_err(|error| error.to_string())?
        .map(|point| point.unwrap().iter().map(ToString::to_string).collect())
        .collect();
    assert_eq!(points.len() as u64, plan.count());
    Ok(points)
}

#[test]
fn a_grid_has_all_combinations() {
    let found = points(r#"{"inputs": {"x": {"steps": 3}, "n": {"from": 5}, "on": {}}}"#).unwrap();
    assert_eq!(found.len(), 12);
    assert_eq!(found[0], ["0", "5", "false"]);
    assert_eq!(found[1], ["0", "5", "true"]);
    assert_eq!(found[11], ["1", "6", "true"]);
    let found = points(r#"{"inputs": {"e": {}, "x": [0.25]}}"#).unwrap();
    assert_eq!(found, [["2", "0.25"], ["4", "0.25"], ["6", "0.25"], ["8", "0.25"]]);
}

#[test]
fn samples_are_within_the_ranges_and_reach_every_step() {
    for sample in ["latin hypercube", "sobol"] {
        let plan = format!(
            r#"{{"inputs": {{"x": {{"from": 0.5}}, "n": {{}}}}, "sample": "{sample}", "points": 500, "seed": 3}}"#
        );
        let found = points(&plan).unwrap();
        assert_eq!(found, points(&plan).unwrap());
        let mut counts = [0; 7];
        for point in &found {
            let x: f64 = point[0].parse().unwrap();
            assert!((0.5..=1.0).contains(&x));
            counts[point[1].parse::<usize>().unwrap()] += 1;
        }
        assert!(counts[2..].iter().all(|n| (98..=102).contains(n)), "{sample} {counts:?}");
    }
}

#[test]
fn what_makes_no_sense_is_refused_with_its_reason() {
    let refused = |plan: &str, part: &str| {
        let error = points(plan).unwrap_err();
        assert!(error.contains(part), "{error}");
    };
    refused(r#"{"inputs": {"x": {}}}"#, "steps");
    refused(r#"{"inputs": {"x": {"from": -1, "steps": 2}}}"#, "0 to 1");
    refused(r#"{"inputs": {"y": {}}}"#, "no input is called 'y'");
    refused(r#"{"inputs": {}}"#, "no inputs");
    refused(r#"{"inputs": {"x": {"steps": 2}}, "outputs": ["q"]}"#, "'q'");
    refused(r#"{"inputs": {"x": {"steps": 2}}, "sampel": "grid"}"#, "sampel");
    refused(r#"{"inputs": {"x": {}}, "sample": "sobol"}"#, "points");
    refused(r#"{"inputs": {"x": {"steps": 2}, "x": {"steps": 2}}}"#, "twice");
    refused(r#"{"inputs": {"x": {"steps": 1000000}, "n": {"steps": 1000000}, "on": {}}}"#, "more than");
}

#[test]
fn rows_of_a_file_are_points() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("points.csv"), "Rating,in:n,in:x\ngood,3,0.123\nbad,5,1\n").unwrap();
    let plan = folder.path().join("plan.json");
    std::fs::write(&plan, r#"{"sample": "rows", "rows": "points.csv"}"#).unwrap();
    let plan = Plan::bind(&PlanFile::read(&plan).unwrap(), &document()).unwrap();
    let points: Vec<Vec<Cell>> = plan.points().unwrap().map(Result::unwrap).collect();
    // The slider has two digits.
    assert_eq!(points, [[Cell::Number(3.0), Cell::Number(0.12)], [Cell::Number(5.0), Cell::Number(1.0)]]);
}
