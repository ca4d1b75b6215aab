//! Paths and matching: the rules R1–R7 and M1–M5 that pictures of Grasshopper prove.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use katydid_component::{
    Account, Budget, Call, Context, Each, Limits, List, ManyItems, ManyLists, Message, Outcome, component,
    registry, whole,
};
use katydid_data::{Path, Tree, TreeBuilder, Value};
use katydid_definition::archive::Chunk;

/// Joins two numbers into one.
#[component("00000000-0000-0000-0000-000000000001", name = "Test Item", nick = "I", at = "Test/Test")]
#[output("Both", "R", "A hundred times the first, and the second.")]
fn item_to_item(
    /// First.
    #[port("A", "A")]
    a: f64,
    /// Second.
    #[port("B", "B")]
    b: f64,
) -> f64 {
    a * 100.0 + b
}

/// Counts up.
#[component("00000000-0000-0000-0000-000000000002", name = "Test Series", nick = "I", at = "Test/Test")]
#[output("List", "L", "0 to n.")]
fn item_to_list(
    context: &Context<'_>,
    /// How many.
    #[port("Count", "N")]
    n: i32,
) -> Result<Vec<f64>, Message> {
    let n = usize::try_from(n).map_err(|_| Message::error("The count is negative"))?;
    context.items(n)?;
    Ok((0..n).map(|i| i as f64).collect())
}

/// Counts a list.
#[component("00000000-0000-0000-0000-000000000003", name = "Test Length", nick = "I", at = "Test/Test")]
#[output("Length", "L", "How many.")]
fn list_to_item(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
) -> i32 {
    list.len() as i32
}

/// Turns a list round.
#[component("00000000-0000-0000-0000-000000000004", name = "Test Reverse", nick = "I", at = "Test/Test")]
#[output("List", "L", "Back to front.")]
fn list_to_list(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
) -> Vec<Option<Value>> {
    list.iter().rev().collect()
}

/// Moves a list round.
#[component("00000000-0000-0000-0000-000000000005", name = "Test Shift", nick = "I", at = "Test/Test")]
#[output("List", "L", "Moved.")]
fn list_and_item_to_list(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// By how much.
    #[port("Shift", "S")]
    shift: i32,
) -> Vec<Option<Value>> {
    list.iter().skip(shift.max(0) as usize).collect()
}

/// Takes from a list.
#[component("00000000-0000-0000-0000-000000000006", name = "Test Take", nick = "I", at = "Test/Test")]
#[output("Item", "i", "The item.")]
fn list_and_item_to_item(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// Which.
    #[port("Index", "i")]
    i: i32,
) -> Option<Value> {
    list.get(usize::try_from(i).ok()?)
}

/// Adds up any number of inputs.
#[component("00000000-0000-0000-0000-000000000007", name = "Test Many", nick = "I", at = "Test/Test")]
#[output("Sum", "S", "The sum.")]
#[output("Same", "s", "The inputs.")]
fn many_to_each(
    /// A term.
    #[port("A", "A", optional)]
    terms: ManyItems<f64>,
) -> (f64, Each<Option<f64>>) {
    (terms.iter().flatten().sum(), Each(terms.to_vec()))
}

/// Hands lists through.
#[component("00000000-0000-0000-0000-000000000008", name = "Test Lists", nick = "I", at = "Test/Test")]
#[output("Same", "s", "The inputs.")]
fn lists_to_each(
    /// A list.
    #[port("A", "A", optional)]
    lists: ManyLists<'_, f64>,
) -> Each<Vec<Option<f64>>> {
    Each(lists.iter().map(List::to_vec).collect())
}

/// A tree for each number.
#[component("00000000-0000-0000-0000-000000000010", name = "Test Trees", nick = "I", at = "Test/Test")]
#[output("Tree", "T", "Trees.")]
fn item_to_tree(
    /// The number.
    #[port("Number", "x")]
    x: f64,
) -> Tree {
    tree_of(x as i32)
}

/// The paths are those of others too, now and then a tree is large, of another type or empty.
fn tree_of(i: i32) -> Tree {
    let path = Path::from([i % 7, i % 3]);
    match i % 1500 {
        0 => Tree::empty(),
        1 => Tree::branch_at(path, Tree::list(vec![f64::from(i); 3000]).column().clone()),
        2 => Tree::branch_at(path, Tree::list(vec![i]).column().clone()),
        _ => Tree::branch_at(path, Tree::list(vec![f64::from(i)]).column().clone()),
    }
}

#[test]
fn trees_of_many_iterations_are_joined_in_order() {
    for n in [1, 2, 1024, 1025, 1026, 5000, 20_000] {
        let items: Vec<f64> = (0..n).map(f64::from).collect();
        let joined = run("Test Trees", &[Tree::list(items)]).remove(0);
        let all: Vec<Tree> = (0..n).map(tree_of).collect();
        assert!(joined == Tree::merge(&all), "{n}");
    }
}

/// Half a number, by the loop or by whole columns.
#[component("00000000-0000-0000-0000-000000000009", name = "Test Half", nick = "I", at = "Test/Test", columns = halves)]
#[output("Half", "H", "The half.")]
fn half(
    /// The number.
    #[port("Number", "x")]
    x: f64,
) -> Result<f64, Message> {
    if x < 0.0 { Err(Message::error("It is negative")) } else { Ok(x / 2.0) }
}

fn halves(call: &Call<'_>) -> Option<Outcome> {
    whole::map(call, |&x: &f64| (x >= 0.0).then_some(x / 2.0))
}

#[test]
fn whole_columns_give_what_the_loop_gives() {
    let items: Vec<f64> = (0..100_000).map(f64::from).collect();
    let plain = Tree::list(items.clone()).graft();
    let outcome = run_limited("Test Half", &[plain], 1, Limits::default());
    assert_eq!(outcome.outputs[0].branch_count(), 100_000);
    assert_eq!(numbers(&outcome.outputs[0]), items.iter().map(|x| x / 2.0).collect::<Vec<_>>());
    // One item that the short way does not take: the loop says why, and the others have their results.
    let mut mixed = items;
    mixed[50_000] = -1.0;
    let outcome = run_limited("Test Half", &[Tree::list(mixed)], 1, Limits::default());
    assert_eq!(outcome.messages.len(), 1);
    assert!(outcome.outputs[0].column().is_null(50_000));
    assert_eq!(numbers(&outcome.outputs[0])[99_999], 49_999.5);
    let small = Limits { items: 10, ..Limits::default() };
    let outcome = run_limited("Test Half", &[Tree::list(vec![1.0; 50_000])], 1, small);
    assert!(outcome.messages[0].text.contains("10 items"));
}

fn run_limited(name: &str, inputs: &[Tree], outputs: usize, limits: Limits) -> Outcome {
    let component = registry::by_name(name).unwrap();
    let solve = std::sync::Arc::new(Account::new(limits.solve_bytes));
    let budget = Budget::new(limits, Default::default(), Default::default(), solve);
    let call = Call {
        inputs,
        input_names: &[],
        output_count: outputs,
        wanted: &[],
        settings: &Chunk::default(),
        rules: Default::default(),
        budget: &budget,
        files: &Default::default(),
        outbox: None,
        kept: None,
        model: None,
    };
    (component.run)(&call)
}

fn run(name: &str, inputs: &[Tree]) -> Vec<Tree> {
    let n = registry::by_name(name).unwrap().outputs.len();
    run_limited(name, inputs, n, Limits::default()).outputs
}

fn tree(branches: &[(&[i32], &[f64])]) -> Tree {
    let mut builder = TreeBuilder::<f64>::new();
    for (path, items) in branches {
        builder.branch(Path::from(*path));
        items.iter().for_each(|&x| builder.push(Some(x)));
    }
    builder.finish()
}

fn integers(branches: &[(&[i32], &[i32])]) -> Tree {
    let mut builder = TreeBuilder::<i32>::new();
    for (path, items) in branches {
        builder.branch(Path::from(*path));
        items.iter().for_each(|&x| builder.push(Some(x)));
    }
    builder.finish()
}

/// `{0;1}=2` for a branch of two items.
fn shape(tree: &Tree) -> String {
    tree.branches().map(|b| format!("{}={}", b.path(), b.len())).collect::<Vec<_>>().join(" ")
}

fn numbers(tree: &Tree) -> Vec<f64> {
    tree.column()
        .iter()
        .map(|v| match v {
            Some(Value::Number(x)) => x,
            Some(Value::Integer(i)) => f64::from(i),
            _ => f64::NAN,
        })
        .collect()
}

#[test]
fn r1_items_to_an_item_keep_the_path() {
    let out = run("Test Item", &[tree(&[(&[0, 0], &[1.0, 2.0])]), tree(&[(&[0], &[3.0])])]);
    assert_eq!(shape(&out[0]), "{0;0}=2");
    assert_eq!(numbers(&out[0]), [103.0, 203.0]);
}

#[test]
fn r1_a_list_to_an_item_keeps_the_path() {
    assert_eq!(shape(&run("Test Length", &[tree(&[(&[0], &[1.0, 2.0]), (&[3], &[])])])[0]), "{0}=1 {3}=1");
}

#[test]
fn r1_a_list_to_a_list_keeps_the_path() {
    assert_eq!(shape(&run("Test Reverse", &[tree(&[(&[0, 0], &[1.0, 2.0])])])[0]), "{0;0}=2");
}

#[test]
fn r1_r3_r7_an_item_to_a_list_grows_the_path_always() {
    assert_eq!(shape(&run("Test Series", &[integers(&[(&[0], &[3])])])[0]), "{0;0}=3");
    let many = run("Test Series", &[integers(&[(&[0, 0], &[1, 2]), (&[0, 1], &[3])])]);
    assert_eq!(shape(&many[0]), "{0;0;0}=1 {0;0;1}=2 {0;1;0}=3");
}

#[test]
fn r1_a_list_with_an_item_to_a_list_grows_the_path_too() {
    let l = tree(&[(&[0], &[1.0, 2.0, 3.0])]);
    assert_eq!(shape(&run("Test Shift", &[l.clone(), integers(&[(&[0], &[1])])])[0]), "{0;0}=2");
    assert_eq!(shape(&run("Test Shift", &[l, integers(&[(&[0], &[0, 2])])])[0]), "{0;0}=3 {0;1}=1");
}

#[test]
fn r1_a_list_with_items_to_an_item_keeps_the_path() {
    let out = run("Test Take", &[tree(&[(&[0], &[5.0, 6.0, 7.0])]), integers(&[(&[0], &[2, 0, 9])])]);
    assert_eq!(shape(&out[0]), "{0}=3");
    assert_eq!(numbers(&out[0])[..2], [7.0, 5.0]);
    assert!(out[0].column().is_null(2));
}

#[test]
fn r5_an_empty_list_still_makes_its_branch() {
    assert_eq!(shape(&run("Test Series", &[integers(&[(&[0], &[0])])])[0]), "{0;0}=0");
}

#[test]
fn m1_the_last_item_and_the_last_branch_are_used_again() {
    let a = tree(&[(&[0], &[1.0, 2.0, 3.0]), (&[1], &[4.0]), (&[2], &[5.0, 6.0])]);
    let b = tree(&[(&[7], &[1.0, 2.0]), (&[8], &[3.0])]);
    let out = run("Test Item", &[a, b]);
    assert_eq!(shape(&out[0]), "{0}=3 {1}=1 {2}=2");
    assert_eq!(numbers(&out[0]), [101.0, 202.0, 302.0, 403.0, 503.0, 603.0]);
}

#[test]
fn m2_more_branches_give_the_paths() {
    let a = tree(&[(&[0], &[1.0])]);
    let b = tree(&[(&[0, 0], &[1.0]), (&[0, 1], &[2.0])]);
    assert_eq!(shape(&run("Test Item", &[a, b])[0]), "{0;0}=1 {0;1}=1");
}

#[test]
fn m2_of_equals_the_longer_paths_win_then_the_first_input() {
    let long = tree(&[(&[0, 0, 0], &[1.0])]);
    let short = tree(&[(&[0, 0], &[1.0])]);
    assert_eq!(shape(&run("Test Item", &[short.clone(), long])[0]), "{0;0;0}=1");
    let other = tree(&[(&[0, 1], &[1.0])]);
    assert_eq!(shape(&run("Test Item", &[short, other])[0]), "{0;0}=1");
}

#[test]
fn m3_equal_trees_go_branch_by_branch() {
    let a = tree(&[(&[0, 0], &[1.0, 2.0, 3.0]), (&[0, 1], &[4.0, 5.0, 6.0])]);
    let b = tree(&[(&[0, 0], &[1.0]), (&[0, 1], &[7.0])]);
    assert_eq!(numbers(&run("Test Item", &[a, b])[0]), [101.0, 201.0, 301.0, 407.0, 507.0, 607.0]);
}

#[test]
fn m5_each_branch_is_a_list_of_its_own() {
    let out = run("Test Reverse", &[tree(&[(&[0], &[1.0, 2.0]), (&[1], &[3.0, 4.0])])]);
    assert_eq!(numbers(&out[0]), [2.0, 1.0, 4.0, 3.0]);
}

#[test]
fn a_null_item_gives_a_null_at_its_place() {
    let mut builder = TreeBuilder::<f64>::new();
    [Some(1.0), None, Some(3.0)].into_iter().for_each(|x| builder.push(x));
    let out = run("Test Item", &[builder.finish(), tree(&[(&[0], &[0.0])])]);
    assert_eq!(out[0].item_count(), 3);
    assert!(out[0].column().is_null(1) && !out[0].column().is_null(2));
}

#[test]
fn one_port_stands_for_many() {
    let t = |x: f64| tree(&[(&[0], &[x])]);
    let outcome = run_limited("Test Many", &[t(1.0), Tree::empty(), t(3.0)], 4, Limits::default());
    assert_eq!(outcome.outputs.len(), 4);
    assert_eq!(numbers(&outcome.outputs[0]), [4.0]);
    assert!(outcome.outputs[2].column().is_null(0));
    assert_eq!(numbers(&outcome.outputs[3]), [3.0]);
    let lists = run_limited(
        "Test Lists",
        &[tree(&[(&[0], &[1.0, 2.0])]), tree(&[(&[5], &[])])],
        2,
        Limits::default(),
    );
    assert_eq!((shape(&lists.outputs[0]), shape(&lists.outputs[1])), ("{0}=2".into(), "{0}=0".into()));
}

#[test]
fn long_runs_are_the_same_on_any_number_of_threads() {
    let a = Tree::list((0..50_000).map(f64::from).collect());
    let b = Tree::list((0..7).map(|i| f64::from(i) * 0.1).collect());
    let parallel = run("Test Item", &[a.clone(), b.clone()]);
    let one = std::thread::spawn(move || {
        // A small run after another is one piece each.
        let mut all = Vec::new();
        for start in (0..50_000).step_by(100) {
            let part: Vec<f64> = (start..start + 100).map(f64::from).collect();
            let bs: Vec<f64> = (start..start + 100).map(|i| f64::from(i.min(6)) * 0.1).collect();
            all.extend(numbers(&run("Test Item", &[Tree::list(part), Tree::list(bs)])[0]));
        }
        all
    });
    assert_eq!(numbers(&parallel[0]), one.join().unwrap());
}

#[test]
fn too_many_items_are_a_message() {
    let outcome = run_limited("Test Series", &[integers(&[(&[0], &[i32::MAX])])], 1, Limits::default());
    assert!(outcome.messages[0].text.contains("20000000 items"), "{:?}", outcome.messages);
    let small = Limits { items: 100, ..Limits::default() };
    let outcome = run_limited("Test Series", &[integers(&[(&[0], &[60, 60])])], 1, small);
    assert!(outcome.messages[0].text.contains("100 items"));
}
