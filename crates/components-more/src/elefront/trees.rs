//! Trees that go along with another one. Public lists tell little of what each does: the rest is our reading, and its help says so.

use std::collections::HashMap;

use katydid_component::{Context, Each, ManyTrees, Message, component};
use katydid_data::{Branch, Path, Tree, TreeBuilder, Value};

use crate::branches::{Branches, items, refilled};

/// Room for the items of all trees.
fn room(context: &Context<'_>, first: &Tree, others: &ManyTrees<'_>) -> Result<(), Message> {
    let counts = others.iter().map(|tree| tree.item_count());
    context.items(counts.fold(first.item_count(), usize::saturating_add))
}

/// The branch of a path, else the one at a place, the last again and again.
fn beside<'a>(tree: &'a Tree, path: &Path, place: usize) -> Option<Branch<'a>> {
    let same = tree.paths().iter().position(|known| known == path);
    tree.branch(same.unwrap_or_else(|| place.min(tree.branch_count().saturating_sub(1))))
}

/// A component that takes a tree and others that go along with it, and gives as many.
macro_rules! parallel {
    (
        $(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal,
        $(#[$told:meta])* $first:literal, $(#[$others_told:meta])*
        [$out:literal, $short:literal, $first_help:literal], $others_help:literal,
        $made:expr
    ) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "EleFront/07 Trees")]
        #[output($out, $short, $first_help, kind = Generic)]
        #[output("Secondary Data", "1", $others_help, kind = Generic)]
        fn $function(
            context: &Context<'_>,
            $(#[$told])*
            #[port($first, $short, kind = Generic)]
            primary: &Tree,
            $(#[$others_told])*
            #[port("Secondary Data", "1", kind = Generic, optional)]
            others: ManyTrees<'_>,
        ) -> Result<(Tree, Each<Tree>), Message> {
            room(context, primary, &others)?;
            let made: fn(&Context<'_>, &Tree, &[&Tree]) -> Result<(Tree, Vec<Tree>), Message> = $made;
            let (primary, others) = made(context, primary, &others)?;
            Ok((primary, Each(others)))
        }
    };
}

parallel!(
    /// Gives each item of a tree a branch of its own, and each of these branches all that other trees have beside it. What is beside it is
    /// the branch of the same path, else the one at the same place, the last again and again. Stands for EleFront's Graft Parallel; what
    /// the other trees give is our reading.
    graft_parallel, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd251", "Graft Parallel", "GraftP",
    /// The tree.
    "Primary Data",
    /// A tree that goes along.
    ["Primary Data", "P", "The tree, an item a branch."], "For each item of the tree the branch beside it.",
    |context, primary, others| {
        let mut grafted = TreeBuilder::<Value>::new();
        for branch in primary.branches() {
            for (place, item) in branch.iter().enumerate() {
                grafted.branch(branch.path().child(place));
                grafted.push(item);
            }
        }
        let along = |tree: &&Tree| -> Result<Tree, Message> {
            let mut made = TreeBuilder::<Value>::new();
            for (at, branch) in primary.branches().enumerate() {
                let Some(other) = beside(tree, branch.path(), at) else { continue };
                context.items(other.len().saturating_mul(branch.len()))?;
                for place in 0..branch.len() {
                    context.check()?;
                    made.branch(branch.path().child(place));
                    other.iter().for_each(|item| made.push(item));
                }
            }
            Ok(made.finish())
        };
        Ok((grafted.finish(), others.iter().map(along).collect::<Result<_, Message>>()?))
    }
);

parallel!(
    /// Leaves out the nulls of a tree, and of other trees what stands at the same places. A tree that goes along has the branches at the
    /// same places; what it has beyond them stays. Stands for EleFront's Clean Parallel.
    clean_parallel, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd252", "Clean Parallel", "CleanP",
    /// The tree.
    "Primary Data",
    /// A tree that goes along.
    ["Primary Data", "P", "The tree without nulls."], "What goes along.",
    |_, primary, others| {
        let cleaned = |tree: &Tree| {
            refilled(tree, |at, branch| {
                let guide = primary.branch(at);
                let is_left_out = move |place: usize| {
                    guide.as_ref().is_some_and(|guide| place < guide.len() && guide.get(place).is_none())
                };
                let kept = branch.iter().enumerate().filter(move |(place, _)| !is_left_out(*place));
                kept.map(|(_, item)| item)
            })
        };
        Ok((cleaned(primary), others.iter().map(|tree| cleaned(tree)).collect()))
    }
);

parallel!(
    /// A tree as it is, and of other trees the branches with the same paths, empty ones where they have none. Stands for EleFront's Get
    /// Matching Branches; the choice of its menu to leave out empty branches is not supported.
    matching_branches, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd253", "Get Matching Branches", "GetBrn",
    /// The tree.
    "Primary Data",
    /// A tree with other branches too.
    ["Primary Data", "P", "The tree."], "The branches with its paths.",
    |_, primary, others| {
        let of = |tree: &&Tree| {
            let known: HashMap<&Path, usize> =
                tree.paths().iter().enumerate().map(|(place, path)| (path, place)).collect();
            refilled(primary, |_, branch| {
                let found = known.get(branch.path()).and_then(|place| tree.branch(*place));
                found.into_iter().flat_map(|branch| branch.iter())
            })
        };
        Ok((primary.clone(), others.iter().map(of).collect()))
    }
);

/// Puts each item of a tree at a path of its own, in the order in which they come; paths that are asked for are there even without
/// items. Stands for EleFront's Create Tree.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd254",
    name = "Create Tree",
    nick = "Tree",
    at = "EleFront/07 Trees"
)]
#[output("Data", "D", "The items at their paths.", kind = Generic)]
fn create_tree(
    context: &Context<'_>,
    /// The items.
    #[port("Data", "D", kind = Generic)]
    data: &Tree,
    /// A path for each; the last is for all that follow.
    #[port("Path", "P", kind = Path)]
    paths: &Tree,
    /// Paths that are there in any case.
    #[port("Ensure", "E", kind = Path, optional)]
    ensured: &Tree,
) -> Result<Tree, Message> {
    context.items(data.item_count())?;
    let given: Vec<Path> = paths_in(paths);
    let last = given.last().ok_or_else(|| Message::error("There are no paths"))?;
    let mut branches = Branches::default();
    paths_in(ensured).into_iter().for_each(|path| branches.extend(path, []));
    for (place, item) in items(data).enumerate() {
        branches.push(given.get(place).unwrap_or(last).clone(), item);
    }
    Ok(branches.tree())
}

fn paths_in(tree: &Tree) -> Vec<Path> {
    let path = |item| match item {
        Some(Value::Path(path)) => Some(path),
        _ => None,
    };
    items(tree).filter_map(path).collect()
}

/// A tree whose paths keep their first numbers only; branches whose paths become the same are joined.
fn shifted(tree: &Tree, depth: usize) -> Tree {
    let mut branches = Branches::default();
    for branch in tree.branches() {
        let numbers = branch.path().elements();
        branches.extend(Path::from(numbers.get(..depth).unwrap_or(numbers)), branch.iter());
    }
    branches.tree()
}

/// Cuts the paths of a tree to so many numbers; branches that come to one path are joined, and paths that are shorter stay, which is
/// our reading. Stands for EleFront's Shift To Depth.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd255",
    name = "Shift To Depth",
    nick = "ShfDep",
    at = "EleFront/07 Trees"
)]
#[output("Shifted Tree", "S", "The tree with shorter paths.", kind = Generic)]
fn shift_to_depth(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T", kind = Generic)]
    tree: &Tree,
    /// How many numbers paths have, at least 1.
    #[port("Depth", "D", kind = Integer)]
    depth: &Tree,
) -> Result<Tree, Message> {
    context.items(tree.item_count())?;
    let depth = match crate::model_objects::first(depth) {
        Some(Value::Integer(depth)) => depth,
        _ => return Err(Message::error("There is no depth")),
    };
    match usize::try_from(depth) {
        Ok(depth) if depth > 0 => Ok(shifted(tree, depth)),
        _ => Err(Message::error(format!("The depth is {depth}: it must be at least 1"))),
    }
}

parallel!(
    /// Cuts the paths of trees to as many numbers as the first path of a guide tree has. Stands for EleFront's ShiftMatch; that paths which
    /// are shorter stay is our reading.
    shift_match, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd256", "ShiftMatch", "ShiftM",
    /// The tree that has the depth.
    "Guide Tree",
    /// A tree to shift.
    ["Guide Tree", "G", "The guide tree."], "The tree with paths of its depth.",
    |_, guide, others| {
        let depth = guide.paths().first().map_or(1, |path| path.len().max(1));
        Ok((guide.clone(), others.iter().map(|tree| shifted(tree, depth)).collect()))
    }
);

parallel!(
    /// Cuts the branches of trees to the shortest among them: the first branches together, then the second ones, and so on. Where a tree
    /// has no more branches, it has an empty one. Stands for EleFront's Shortest List Clean.
    shortest_list, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd257", "Shortest List Clean", "Shortest",
    /// The tree.
    "Primary Data",
    /// A tree that goes along.
    ["Primary Data", "P", "The tree, cut."], "Another one, cut.",
    |_, primary, others| {
        let length = |tree: &Tree, place: usize| tree.branch(place).map_or(0, |branch| branch.len());
        let shortest = |place: usize| {
            let others = others.iter().map(|tree| length(tree, place));
            others.fold(length(primary, place), usize::min)
        };
        let cut = |tree: &Tree| refilled(tree, |place, branch| branch.iter().take(shortest(place)));
        Ok((cut(primary), others.iter().map(|tree| cut(tree)).collect()))
    }
);

parallel!(
    /// Repeats items so that they have the structure of a tree: the first item fills the first branch, the second one the second branch,
    /// and so on, the last again and again. Stands for EleFront's Duplicate Data Match; that an item is for a branch is our reading.
    duplicate_data, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd258", "Duplicate Data Match", "Dup",
    /// The tree.
    "Source Data Tree",
    /// Items, one for each branch of the tree.
    ["Source Data", "S", "The tree."], "The items in its structure.",
    |context, source, others| {
        context.items(source.item_count().saturating_mul(others.len().saturating_add(1)))?;
        let filled = |tree: &&Tree| {
            let Some(last) = tree.item_count().checked_sub(1) else { return Tree::empty() };
            refilled(source, |place, branch| {
                let item = tree.column().get(place.min(last));
                std::iter::repeat_n(item, branch.len())
            })
        };
        Ok((source.clone(), others.iter().map(filled).collect()))
    }
);

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Path, Tree, TreeBuilder, Value};

    fn tree(branches: &[(&str, &[&str])]) -> Tree {
        let mut builder = TreeBuilder::<Value>::new();
        for (path, items) in branches {
            builder.branch(path.parse().unwrap());
            items.iter().for_each(|item| builder.push((*item != "-").then(|| Value::text(*item))));
        }
        builder.finish()
    }

    fn pair(name: &str, first: &Tree, second: &Tree) -> [Vec<String>; 2] {
        [0, 1].map(|k| Trial::of(name).tree(first.clone()).tree(second.clone()).texts(k))
    }

    #[test]
    fn each_item_has_what_is_beside_its_branch() {
        let first = tree(&[("{0}", &["a", "b"]), ("{1}", &["c"])]);
        let second = tree(&[("{1}", &["x"]), ("{2}", &["y", "z"])]);
        let [primary, secondary] = pair("Graft Parallel", &first, &second);
        assert_eq!(primary, ["{0;0}: a", "{0;1}: b", "{1;0}: c"]);
        // {1} is there by its path; for {0} stands the first branch.
        assert_eq!(secondary, ["{0;0}: x", "{0;1}: x", "{1;0}: x"]);
        assert_eq!(
            Trial::of("Graft Parallel").tree(Tree::empty()).tree(first).run().outputs[0],
            Tree::empty()
        );
    }

    #[test]
    fn nulls_are_left_out_together() {
        let first = tree(&[("{0}", &["a", "-", "c"]), ("{1}", &["-"])]);
        let second = tree(&[("{0}", &["1", "2", "3", "4"]), ("{5}", &["5"])]);
        let [primary, secondary] = pair("Clean Parallel", &first, &second);
        assert_eq!(primary, ["{0}: a, c", "{1}:"]);
        assert_eq!(secondary, ["{0}: 1, 3, 4", "{5}:"]);
    }

    #[test]
    fn branches_of_the_same_paths() {
        let first = tree(&[("{1}", &["a"]), ("{3}", &["b"])]);
        let second = tree(&[("{0}", &["x"]), ("{1}", &["y", "z"])]);
        let [primary, secondary] = pair("Get Matching Branches", &first, &second);
        assert_eq!(primary, ["{1}: a", "{3}: b"]);
        assert_eq!(secondary, ["{1}: y, z", "{3}:"]);
    }

    #[test]
    fn items_go_where_their_paths_say() {
        let path = |text: &str| text.parse::<Path>().unwrap();
        let trial = || {
            let trial = Trial::of("Create Tree").list(["a", "b", "c"]);
            trial.list([path("{1}"), path("{0;2}")])
        };
        assert_eq!(trial().texts(0), ["{0;2}: b, c", "{1}: a"]);
        assert_eq!(trial().list([path("{0}")]).texts(0), ["{0}:", "{0;2}: b, c", "{1}: a"]);
        assert_eq!(Trial::of("Create Tree").list(["a"]).message(), "There are no paths");
    }

    #[test]
    fn paths_are_cut() {
        let deep = tree(&[("{0;0;1}", &["a"]), ("{0;0;2}", &["b"]), ("{1}", &["c"])]);
        let to = |depth: i32| Trial::of("Shift To Depth").tree(deep.clone()).item(depth);
        assert_eq!(to(2).texts(0), ["{0;0}: a, b", "{1}: c"]);
        assert_eq!(to(9).texts(0), ["{0;0;1}: a", "{0;0;2}: b", "{1}: c"]);
        assert_eq!(to(0).message(), "The depth is 0: it must be at least 1");
        let [guide, cut] = pair("ShiftMatch", &tree(&[("{4;4}", &["g"])]), &deep);
        assert_eq!(guide, ["{4;4}: g"]);
        assert_eq!(cut, ["{0;0}: a, b", "{1}: c"]);
    }

    #[test]
    fn branches_are_cut_to_the_shortest() {
        let first = tree(&[("{0}", &["a", "b", "c"]), ("{1}", &["d"])]);
        let second = tree(&[("{7}", &["1", "2"])]);
        let [primary, secondary] = pair("Shortest List Clean", &first, &second);
        assert_eq!(primary, ["{0}: a, b", "{1}:"]);
        assert_eq!(secondary, ["{7}: 1, 2"]);
    }

    #[test]
    fn items_fill_branches() {
        let first = tree(&[("{0}", &["a", "b"]), ("{1}", &["c"]), ("{2}", &["d", "e"])]);
        let [source, filled] = pair("Duplicate Data Match", &first, &tree(&[("{0}", &["x", "y"])]));
        assert_eq!(source, ["{0}: a, b", "{1}: c", "{2}: d, e"]);
        assert_eq!(filled, ["{0}: x, x", "{1}: y", "{2}: y, y"]);
        let [_, none] = pair("Duplicate Data Match", &first, &Tree::empty());
        assert!(none.is_empty());
    }
}
