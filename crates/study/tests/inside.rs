//! Inputs and outputs inside clusters: named by a path, set, and looked at as those of the definition itself.

#![allow(clippy::panic, clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fs;

use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_elementary::Elementary;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{
    Cell, Here, Output, Plan, PlanFile, Prepared, RangeSettings, Settings, Slope, Variable, effects_here,
    effects_over_range, inputs_of, solve_for, sweep,
};

/// y = a·x² + genes, with a outside, x in the inner of two clusters, the genes in the outer one.
const NESTED: &str = "katydid 1\na = Number Slider(3.0, 0.0..5.0)\n\
    Outer = Cluster(a) -> y inside {\n    \
    k = Cluster Input()\n    \
    Inner = Cluster(k) -> p inside {\n        \
    n = Cluster Input()\n        \
    x = Number Slider(0.7, 0.00..2.00)\n        \
    unused = Number Slider(1.0, 0.0..9.0)\n        \
    idle = Addition(unused, 1)\n        \
    f = Expression(\"n*x^2\", n = n, x = x)\n        \
    p = Cluster Output(f)\n    \
    }\n    \
    count = Number Slider(2, 1..4)\n    \
    ones = Repeat Data([1.0], count)\n    \
    more = Mass Addition(ones)\n    \
    s = Addition(Inner, more)\n    \
    y = Cluster Output(s)\n\
    }\n\
    shown = Panel(Outer)\n";

fn document(text: &str) -> Document {
    katydid_components::link();
    kd::read(text, &Registry).unwrap_or_else(|problems| panic!("{problems}")).document
}

fn names(variables: &[Variable]) -> Vec<&str> {
    variables.iter().map(|variable| variable.name.as_str()).collect()
}

fn prepared(document: Document, output: &str) -> Prepared {
    let output = Output::find(&document, output).unwrap();
    let variables = inputs_of(&document, &output).unwrap();
    Prepared::new(document, Options { skip_unread: true, ..Options::default() }, variables, vec![output])
}

fn derivative(here: &Here) -> (f64, f64) {
    match here.slope {
        Slope::Even(derivative) => (derivative.value, derivative.error),
        other => panic!("{}: {other:?}", here.name),
    }
}

#[test]
fn what_an_output_hangs_on_goes_into_clusters() {
    let document = document(NESTED);
    let of = |name: &str| {
        let output = Output::find(&document, name).unwrap();
        inputs_of(&document, &output).unwrap()
    };
    assert_eq!(names(&of("shown")), ["a", "Outer/Inner/x", "Outer/count"]);
    // Of a result inside a cluster only what leads to it there, and all that is wired to the cluster.
    assert_eq!(names(&of("Outer/Inner/f")), ["a", "Outer/Inner/x"]);
    assert_eq!(names(&of("Outer/more.R")), ["a", "Outer/count"]);
    let error = Variable::find(&document, "Outer/nothing").unwrap_err().to_string();
    assert!(error.contains("nothing"), "{error}");
    let error = Output::find(&document, "Missing/f").unwrap_err().to_string();
    assert!(error.contains("Missing/f"), "{error}");
}

#[test]
fn derivatives_by_inputs_inside_clusters_are_those_worked_by_hand() {
    let prepared = prepared(document(NESTED), "shown");
    let (value, here) = effects_here(&prepared, &Cancel::default()).unwrap();
    assert!((value - (3.0 * 0.49 + 2.0)).abs() < 1e-12, "{value}");
    for (one, exact) in here.iter().zip([0.49, 2.0 * 3.0 * 0.7]) {
        let (value, error) = derivative(one);
        assert!((value - exact).abs() <= 1e-6 * exact, "{}: {value}", one.name);
        assert!((value - exact).abs() <= error.max(1e-9), "{}: {value} and {error}", one.name);
        let [from, to] = one.holds.as_ref().unwrap();
        assert!(from.is_limit && to.is_limit, "{one:?}");
    }
    assert_eq!(here[2].slope, Slope::Steps { step: 1.0, change: [Some(-1.0), Some(1.0)] });
}

#[test]
fn a_change_of_count_inside_a_cluster_is_named_by_its_path() {
    let text = "katydid 1\nBox = Cluster() -> y inside {\n    \
        x = Number Slider(0.7, 0.00..2.00)\n    \
        n = Expression(\"Floor(x) + 2\", x = x)\n    \
        some = Series(0, 0, n)\n    \
        zero = Mass Addition(some)\n    \
        s = Addition(x, zero)\n    \
        y = Cluster Output(s)\n}\nshown = Panel(Box)\n";
    let (_, here) = effects_here(&prepared(document(text), "shown"), &Cancel::default()).unwrap();
    let (value, _) = derivative(&here[0]);
    let [_, to] = here[0].holds.clone().unwrap();
    assert!((value - 1.0).abs() < 1e-6 && (to.at - 1.0).abs() < 1e-9, "{value} {to:?}");
    assert!(to.why.contains("'Box/some' gives another count"), "{}", to.why);
}

#[test]
fn shares_of_inputs_inside_clusters_are_those_of_the_formula() {
    // y = a + 2·x over unit ranges: a fifth of the variance is that of a.
    let text = "katydid 1\na = Number Slider(0.5, 0.000..1.000)\nC = Cluster(a) -> y inside {\n    \
        k = Cluster Input()\n    x = Number Slider(0.5, 0.000..1.000)\n    \
        f = Expression(\"k + 2*x\", k = k, x = x)\n    y = Cluster Output(f)\n}\nshown = Panel(C)\n";
    let prepared = prepared(document(text), "shown");
    let settings = RangeSettings { pairs: 256, seed: 1, workers: 2, cancel: Cancel::default() };
    let (inputs, _, failed) = effects_over_range(&prepared, &settings).unwrap();
    let shares: Vec<f64> = inputs.iter().map(|input| input.share.unwrap().alone).collect();
    assert!((shares[0] - 0.2).abs() < 0.05 && (shares[1] - 0.8).abs() < 0.1 && failed == 0, "{shares:?}");
}

#[test]
fn a_wanted_result_is_found_by_an_input_inside_a_cluster_and_written() {
    let mut document = document(NESTED);
    let output = Output::find(&document, "shown").unwrap();
    let x = Variable::find(&document, "Outer/Inner/x").unwrap();
    let prepared = Prepared::new(document.clone(), Options::default(), vec![x.clone()], vec![output.clone()]);
    let found = solve_for(&prepared, &[3.0 * 1.44 + 2.0], Default::default(), &Cancel::default()).unwrap();
    assert!((found.inputs[0] - 1.2).abs() < 1e-12 && found.off < 1e-9, "{found:?}");
    x.write(&mut document, &Cell::Number(1.2)).unwrap();
    let solved = Prepared::new(document, Options::default(), Vec::new(), vec![output.clone()]);
    let number = output.cell(solved.engine()).number().unwrap();
    assert!((number - (3.0 * 1.44 + 2.0)).abs() < 1e-12, "{number}");
    assert!(x.write(&mut self::document(NESTED), &Cell::Number(9.0)).is_err());
}

#[test]
fn a_sweep_sets_and_reads_what_is_inside_clusters() {
    let plan = r#"{"inputs": {"a": [1, 2], "Outer/Inner/x": {"steps": 5}, "Outer/count": {}},
        "outputs": ["shown", "Outer/Inner/f", "Outer/more.R"]}"#;
    let document = document(NESTED);
    let plan = Plan::bind(&PlanFile::parse(plan).unwrap(), &document).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let settings = Settings { workers: 2, ..Settings::default() };
    let summary = sweep(document, Options::default(), &plan, folder.path(), &settings, |_| {}).unwrap();
    assert_eq!((summary.progress.solved, summary.failed_rows), (40, 0));
    let text = fs::read_to_string(folder.path().join("data.csv")).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap();
    assert!(
        header.starts_with("in:a,in:Outer/Inner/x,in:Outer/count,out:shown,out:Outer/Inner/f,"),
        "{header}"
    );
    for line in lines {
        let cells: Vec<f64> = line.split(',').take(6).map(|cell| cell.parse().unwrap()).collect();
        let [a, x, count, shown, f, more] = cells[..] else { panic!("{line}") };
        assert!((f - a * x * x).abs() < 1e-12 && more == count && (shown - f - more).abs() < 1e-12, "{line}");
    }
}

#[test]
fn genes_inside_clusters_are_set_and_looked_at() {
    let text = "katydid 1\nC = Cluster() -> y inside {\n    g = Gene Pool() {\n        \
        GeneData/Count = 2\n        GeneData/Value[0] = decimal 0.2500\n        GeneData/Value[1] = decimal 0.5\n        \
        GeneData/Minimum = decimal 0.00\n        GeneData/Maximum = decimal 1.00\n        GeneData/Decimals = 2\n    }\n    \
        first = List Item(g, 0)\n    second = List Item(g, 1)\n    \
        f = Expression(\"Sin(u)*v\", u = first, v = second)\n    y = Cluster Output(f)\n}\nshown = Panel(C)\n";
    let prepared = prepared(document(text), "shown");
    assert_eq!(names(prepared.variables()), ["C/g.0", "C/g.1"]);
    let (_, here) = effects_here(&prepared, &Cancel::default()).unwrap();
    for (one, exact) in here.iter().zip([0.25_f64.cosine() * 0.5, 0.25_f64.sine()]) {
        let (value, _) = derivative(one);
        assert!((value - exact).abs() <= 1e-6 * exact, "{}: {value}", one.name);
    }
}
