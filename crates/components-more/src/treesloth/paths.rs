//! The paths of one tree: numbered anew, made longer or shorter, turned, sorted, and dealt out.

use std::collections::BTreeMap;

use katydid_component::{Context, Each, Message, component};
use katydid_data::{Branch, Path, Tree, Value};

use super::{dealt, moved, numbered, numbers};
use crate::branches::{Branches, items, of};
use crate::treefrog::uneven;

/// A component that puts a number at one end of each path.
macro_rules! lengthen {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $joined:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $name, at = "TreeSloth/Tree")]
        #[output("Data", "D", "The tree with longer paths.", kind = Generic)]
        fn $function(
            context: &Context<'_>,
            /// The tree.
            #[port("Data", "D", kind = Generic)]
            data: &Tree,
            /// The number; with several one for each branch, the last for all that follow.
            #[port("Index", "I", kind = Integer, default = 0)]
            index: &Tree,
        ) -> Result<Tree, Message> {
            let numbers = numbers(index);
            let last = numbers.last().copied().ok_or_else(|| Message::error("There is no index"))?;
            let joined: fn(i32, &[i32]) -> Vec<i32> = $joined;
            moved(context, data, |place, path| {
                let number = numbers.get(place).copied().unwrap_or(last);
                Ok(Path::from(joined(number, path.elements()).as_slice()))
            })
        }
    };
}

lengthen!(
    /// Puts a number behind the others of each path. Stands for TreeSloth's Append Element.
    append_element, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f11", "Append Element",
    |number, path| [path, &[number]].concat()
);

lengthen!(
    /// Puts a number before the others of each path. Stands for TreeSloth's Prepend Element.
    prepend_element, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f12", "Prepend Element",
    |number, path| [&[number], path].concat()
);

/// Gives items the structure of a tree with as many; or puts each at a path, or in the branch of a number. Stands for TreeSloth's Clone
/// Structure; that whole numbers in one branch are such numbers is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f13",
    name = "Clone Structure",
    nick = "Clone",
    at = "TreeSloth/Tree"
)]
#[output("Tree", "T", "The items in the structure.", kind = Generic)]
fn clone_structure(
    context: &Context<'_>,
    /// The items.
    #[port("List", "L", kind = Generic)]
    list: &Tree,
    /// A tree with as many items, or a path or a number for each item.
    #[port("Structure", "S", kind = Generic)]
    structure: &Tree,
) -> Result<Tree, Message> {
    let count = list.item_count();
    if structure.item_count() != count {
        return Err(uneven("places in the structure", structure.item_count(), count));
    }
    context.items(count)?;
    let path = |item| match item {
        Some(Value::Path(path)) => Some(path),
        Some(Value::Integer(number)) if structure.branch_count() == 1 => Some(Path::from([number])),
        _ => None,
    };
    let paths: Option<Vec<Path>> = items(structure).map(path).collect();
    let Some(paths) = paths else { return Ok(structure.with_column(list.column().clone())) };
    let mut branches = Branches::default();
    paths.into_iter().zip(items(list)).for_each(|(path, item)| branches.push(path, item));
    Ok(branches.tree())
}

/// Deals the branches of a tree out to the outputs, as a pattern of the outputs' numbers says that starts again and again. Stands for
/// TreeSloth's Divide Branches; that paths numbered anew are {0}, {1} and so on in each output is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f14",
    name = "Divide Branches",
    nick = "Divide Branches",
    at = "TreeSloth/Tree"
)]
#[output("Data {0}", "0", "The branches for an output.", kind = Generic)]
fn divide_branches(
    context: &Context<'_>,
    /// The tree.
    #[port("Data Tree", "D", kind = Generic)]
    data: &Tree,
    /// The number of the output for each branch, from 0.
    #[port("Division Pattern", "P", kind = Integer)]
    pattern: &Tree,
    /// Whether paths are numbered anew.
    #[port("Renumber Paths", "R", default = false)]
    renumber: bool,
) -> Result<Each<Tree>, Message> {
    context.items(data.item_count())?;
    let outputs = dealt(context, &numbers(pattern), data.branch_count())?;
    let mut parts: Vec<(Branches, usize)> = Vec::new();
    parts.resize_with(context.output_count(), Default::default);
    for (branch, output) in data.branches().zip(outputs) {
        let Some((part, count)) = output.and_then(|output| parts.get_mut(output)) else { continue };
        let path = if renumber { numbered(*count) } else { branch.path().clone() };
        part.extend(path, of(&branch));
        *count += 1;
    }
    Ok(Each(parts.into_iter().map(|(part, _)| part.tree()).collect()))
}

/// Takes a tree apart at a place of its paths: an output for each number that stands there, from the least. Stands for TreeSloth's
/// Explode at Index; that paths stay as they are, and that what is shorter is left out, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f15",
    name = "Explode at Index",
    nick = "Explode",
    at = "TreeSloth/Tree"
)]
#[output("Data", "D", "The branches that have one number there.", kind = Generic)]
fn explode_at_index(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D", kind = Generic)]
    data: &Tree,
    /// The place in the paths, from 0.
    #[port("Index", "I", default = 0)]
    index: i32,
) -> Result<Each<Tree>, Message> {
    context.items(data.item_count())?;
    let place = at_least_none(index, "The index")?;
    let mut parts: BTreeMap<i32, Branches> = BTreeMap::new();
    for branch in data.branches() {
        if let Some(number) = branch.path().elements().get(place) {
            parts.entry(*number).or_default().extend(branch.path().clone(), of(&branch));
        }
    }
    let outputs = context.output_count();
    if parts.len() > outputs {
        context.warn(format!("There are {} parts for {outputs} outputs", parts.len()));
    }
    let mut trees: Vec<Tree> = parts.into_values().map(Branches::tree).collect();
    trees.resize_with(outputs, Tree::empty);
    Ok(Each(trees))
}

/// # Errors
/// A number is negative.
fn at_least_none(number: i32, name: &str) -> Result<usize, Message> {
    usize::try_from(number).map_err(|_| Message::error(format!("{name} is {number}: it must be at least 0")))
}

/// The last place at which the paths of a tree differ; the last of all where they do not.
///
/// # Errors
/// The paths differ in length.
fn varied(tree: &Tree) -> Result<usize, Message> {
    let Some(first) = tree.paths().first() else { return Ok(0) };
    if let Some(other) = tree.paths().iter().find(|path| path.len() != first.len()) {
        return Err(Message::error(format!("The paths {first} and {other} differ in length")));
    }
    let at = |path: &Path, place: usize| path.elements().get(place).copied();
    let differs = |place: &usize| tree.paths().iter().any(|path| at(path, *place) != at(first, *place));
    Ok((0..first.len()).rev().find(differs).unwrap_or(first.len().saturating_sub(1)))
}

/// A path with another number at a place.
fn with(path: &Path, place: usize, number: usize) -> Path {
    let mut numbers = path.elements().to_vec();
    if let Some(slot) = numbers.get_mut(place) {
        *slot = i32::try_from(number).unwrap_or(i32::MAX);
    }
    Path::from(numbers.as_slice())
}

/// Turns rows into columns: each item goes to the branch that has its place in the list where the paths differ last. Stands for
/// TreeSloth's Flip Last. Paths must have the same length; shorter lists leave no gaps, which is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f16",
    name = "Flip Last",
    nick = "Flip Last",
    at = "TreeSloth/Tree"
)]
#[output("Data", "D", "The turned tree.", kind = Generic)]
fn flip_last(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D", kind = Generic)]
    data: &Tree,
) -> Result<Tree, Message> {
    context.items(data.item_count())?;
    let place = varied(data)?;
    let mut branches = Branches::default();
    for branch in data.branches() {
        for (number, item) in branch.iter().enumerate() {
            branches.push(with(branch.path(), place, number), item);
        }
    }
    Ok(branches.tree())
}

/// Numbers the branches of a tree {0}, {1} and so on. Stands for TreeSloth's Renumber Paths; that paths keep nothing of what they were
/// is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f17",
    name = "Renumber Paths",
    nick = "Renumber",
    at = "TreeSloth/Tree"
)]
#[output("Renumbered Data", "D", "The branches with new paths.", kind = Generic)]
fn renumber_paths(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D", kind = Generic)]
    data: &Tree,
) -> Result<Tree, Message> {
    moved(context, data, |place, _| Ok(numbered(place)))
}

/// Takes numbers off the paths of a tree; branches that come to one path are joined. A path of which nothing is left becomes {0}.
/// Stands for TreeSloth's Shift Paths.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f18",
    name = "Shift Paths",
    nick = "Shift",
    at = "TreeSloth/Tree"
)]
#[output("Data", "D", "The tree with shorter paths.", kind = Generic)]
fn shift_paths(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D", kind = Generic)]
    data: &Tree,
    /// How many numbers: from the end where it is negative, else from the beginning.
    #[port("Offset", "O", default = -1)]
    offset: i32,
) -> Result<Tree, Message> {
    let count = usize::try_from(offset.unsigned_abs()).unwrap_or(usize::MAX);
    moved(context, data, |_, path| {
        let kept = path.len().saturating_sub(count);
        let range = if offset < 0 { 0..kept } else { path.len() - kept..path.len() };
        let left = path.elements().get(range).filter(|left| !left.is_empty());
        Ok(left.map_or_else(Path::zero, Path::from))
    })
}

/// Sorts the branches of a tree by their first numbers, the least first, and numbers them anew. With a depth the first numbers of the
/// paths stay, and branches are sorted among those that have them in common; branches without a number come last. Stands for
/// TreeSloth's Sort Tree; that the first number of a branch counts is our reading.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f19", name = "Sort Tree", nick = "Sort", at = "TreeSloth/List")]
#[output("Paths", "OP", "The paths that the branches had, in their new order.", kind = Path)]
#[output("Keys", "K", "The sorted branches.", kind = Number)]
fn sort_tree(
    context: &Context<'_>,
    /// How many numbers of a path stay: 0 for none.
    #[port("Path Depth", "PD", default = 0)]
    depth: i32,
    /// The branches to sort by their numbers.
    #[port("Sort Keys", "K", kind = Number)]
    keys: &Tree,
) -> Result<(Vec<Path>, Tree), Message> {
    context.items(keys.item_count().saturating_add(keys.branch_count()))?;
    let depth = at_least_none(depth, "The depth")?;
    let mut groups: BTreeMap<Vec<i32>, Vec<Branch<'_>>> = BTreeMap::new();
    for branch in keys.branches() {
        let path = branch.path().elements();
        groups.entry(path.get(..depth).unwrap_or(path).to_vec()).or_default().push(branch);
    }
    let key = |branch: &Branch<'_>| match branch.iter().next().flatten() {
        Some(Value::Number(key)) if !key.is_nan() => key,
        _ => f64::INFINITY,
    };
    let (mut paths, mut sorted) = (Vec::new(), Branches::default());
    for (group, mut branches) in groups {
        branches.sort_by(|a, b| key(a).total_cmp(&key(b)));
        for (place, branch) in branches.iter().enumerate() {
            sorted.extend(Path::from(group.as_slice()).child(place), of(branch));
            paths.push(branch.path().clone());
        }
    }
    Ok((paths, sorted.tree()))
}

/// Takes items off the ends of the lists of a tree, and branches off the ends of each row of branches. A row are those whose paths
/// are the same but for the place where the paths of the tree differ last. Stands for TreeSloth's Trim Data Ends.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f1a",
    name = "Trim Data Ends",
    nick = "Trim",
    at = "TreeSloth/List"
)]
#[output("Trimmed Data", "D", "What is left.", kind = Generic)]
fn trim_data_ends(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D", kind = Generic)]
    data: &Tree,
    /// How many items are taken off the beginning of each list.
    #[port("List Start", "Ls", default = 0)]
    list_start: i32,
    /// How many items are taken off the end of each list.
    #[port("List End", "Le", default = 0)]
    list_end: i32,
    /// How many branches are taken off the beginning of each row.
    #[port("Path Start", "Ps", default = 0)]
    path_start: i32,
    /// How many branches are taken off the end of each row.
    #[port("Path End", "Pe", default = 0)]
    path_end: i32,
    /// Whether what is left of each row is numbered from 0.
    #[port("Renumber Paths", "R", default = false)]
    renumber: bool,
) -> Result<Tree, Message> {
    context.items(data.item_count())?;
    let [list_start, list_end, path_start, path_end] = [
        (list_start, "List Start"),
        (list_end, "List End"),
        (path_start, "Path Start"),
        (path_end, "Path End"),
    ]
    .map(|(number, name)| at_least_none(number, name));
    let (list_start, list_end) = (list_start?, list_end?);
    let (path_start, path_end) = (path_start?, path_end?);
    let place = varied(data)?;
    let mut rows: BTreeMap<Path, Vec<Branch<'_>>> = BTreeMap::new();
    for branch in data.branches() {
        rows.entry(with(branch.path(), place, 0)).or_default().push(branch);
    }
    let mut trimmed = Branches::default();
    for row in rows.into_values() {
        let kept = row.len().saturating_sub(path_end);
        for (number, branch) in row.iter().take(kept).skip(path_start).enumerate() {
            let path = if renumber { with(branch.path(), place, number) } else { branch.path().clone() };
            let end = branch.len().saturating_sub(list_end);
            trimmed.extend(path, branch.iter().take(end).skip(list_start));
        }
    }
    Ok(trimmed.tree())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Path, Tree};

    const ROWS: [(&str, [i32; 2]); 4] =
        [("{0;0;7}", [1, 2]), ("{0;1;7}", [3, 4]), ("{0;2;7}", [5, 6]), ("{1;0;7}", [7, 8])];

    fn rows(name: &str) -> Trial {
        Trial::of(name).branches(ROWS)
    }

    #[test]
    fn paths_are_made_longer() {
        let data = |name: &str| Trial::of(name).branches([("{0}", [1]), ("{1}", [2]), ("{2}", [3])]);
        assert_eq!(data("Append Element").list([4, 5]).texts(0), ["{0;4}: 1", "{1;5}: 2", "{2;5}: 3"]);
        assert_eq!(data("Prepend Element").item(9).texts(0), ["{9;0}: 1", "{9;1}: 2", "{9;2}: 3"]);
        assert_eq!(data("Append Element").tree(Tree::empty()).message(), "There is no index");
    }

    #[test]
    fn items_take_a_structure() {
        let list = || Trial::of("Clone Structure").list(["a", "b", "c"]);
        let paths = ["{1}", "{0;2}", "{1}"].map(|path| path.parse::<Path>().unwrap());
        assert_eq!(list().list(paths).texts(0), ["{0;2}: b", "{1}: a, c"]);
        assert_eq!(list().list([5, 0, 5]).texts(0), ["{0}: b", "{5}: a, c"]);
        assert_eq!(list().list(["x", "y", "z"]).texts(0), ["{0}: a, b, c"]);
        let tree = list().branches([("{2}", [7]), ("{4}", [8]), ("{9}", [9])]);
        assert_eq!(tree.texts(0), ["{2}: a", "{4}: b", "{9}: c"]);
        assert!(list().list([1]).message().contains("1 places in the structure for 3 items"));
    }

    #[test]
    fn branches_are_dealt_out() {
        let trial = |k: usize, renumber: bool| {
            rows("Divide Branches").list([0, 1, 1]).item(renumber).outputs(2).texts(k)
        };
        assert_eq!(trial(0, false), ["{0;0;7}: 1, 2", "{1;0;7}: 7, 8"]);
        assert_eq!(trial(1, true), ["{0}: 3, 4", "{1}: 5, 6"]);
        let missing = rows("Divide Branches").list([0, 2]).default().outputs(2).message();
        assert!(missing.contains("not there"), "{missing}");
        let empty = rows("Divide Branches").tree(Tree::empty()).default().outputs(2).message();
        assert_eq!(empty, "The pattern is empty");
    }

    #[test]
    fn trees_are_exploded() {
        let part = |k: usize| rows("Explode at Index").item(0).outputs(3).texts(k);
        assert_eq!(part(0), ["{0;0;7}: 1, 2", "{0;1;7}: 3, 4", "{0;2;7}: 5, 6"]);
        assert_eq!(part(1), ["{1;0;7}: 7, 8"]);
        assert!(part(2).is_empty());
        let few = rows("Explode at Index").item(1).outputs(2).message();
        assert_eq!(few, "There are 3 parts for 2 outputs");
        assert!(rows("Explode at Index").item(-1).outputs(2).message().contains("at least 0"));
    }

    #[test]
    fn rows_become_columns() {
        assert_eq!(
            rows("Flip Last").texts(0),
            ["{0;0;7}: 1, 3, 5", "{0;1;7}: 2, 4, 6", "{1;0;7}: 7", "{1;1;7}: 8"]
        );
        assert_eq!(Trial::of("Flip Last").list(["a", "b"]).texts(0), ["{0}: a", "{1}: b"]);
        let mixed = Trial::of("Flip Last").branches([("{0}", [1]), ("{0;1}", [2])]);
        assert_eq!(mixed.message(), "The paths {0} and {0;1} differ in length");
        assert!(Trial::of("Flip Last").tree(Tree::empty()).texts(0).is_empty());
    }

    #[test]
    fn paths_are_numbered_and_shortened() {
        assert_eq!(rows("Renumber Paths").texts(0), ["{0}: 1, 2", "{1}: 3, 4", "{2}: 5, 6", "{3}: 7, 8"]);
        let shift = |offset: i32| {
            Trial::of_guid("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f18")
                .branches([("{0;3}", [1]), ("{1;3}", [2])])
                .item(offset)
                .texts(0)
        };
        assert_eq!(shift(-1), ["{0}: 1", "{1}: 2"]);
        assert_eq!(shift(1), ["{3}: 1, 2"]);
        assert_eq!(shift(0), ["{0;3}: 1", "{1;3}: 2"]);
        assert_eq!(shift(-5), ["{0}: 1, 2"]);
        assert_eq!(shift(i32::MIN), ["{0}: 1, 2"]);
    }

    #[test]
    fn branches_are_sorted() {
        let keys = || [("{0;0}", [3.0]), ("{0;1}", [f64::NAN]), ("{0;2}", [1.0]), ("{1;0}", [2.0])];
        let sort = |depth: i32, k: usize| Trial::of("Sort Tree").item(depth).branches(keys()).texts(k);
        assert_eq!(sort(0, 0), ["{0;0}: {0;2}, {1;0}, {0;0}, {0;1}"]);
        assert_eq!(sort(0, 1)[..3], ["{0}: 1", "{1}: 2", "{2}: 3"]);
        assert_eq!(sort(1, 0), ["{0;0}: {0;2}, {0;0}, {0;1}, {1;0}"]);
        let nested = sort(1, 1);
        assert_eq!([&nested[0], &nested[1], &nested[3]], ["{0;0}: 1", "{0;1}: 3", "{1;0}: 2"]);
    }

    #[test]
    fn ends_are_taken_off() {
        let trim = |numbers: [i32; 4], renumber: bool| {
            let trial = rows("Trim Data Ends");
            numbers.into_iter().fold(trial, |trial, number| trial.item(number)).item(renumber)
        };
        assert_eq!(trim([1, 0, 1, 0], false).texts(0), ["{0;1;7}: 4", "{0;2;7}: 6"]);
        assert_eq!(trim([0, 0, 1, 1], true).texts(0), ["{0;0;7}: 3, 4"]);
        assert_eq!(trim([0, 5, 2, 0], false).texts(0), ["{0;2;7}:"]);
        assert_eq!(trim([0, -1, 0, 0], false).message(), "List End is -1: it must be at least 0");
    }
}
