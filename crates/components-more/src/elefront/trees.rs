//! Trees that go along with another one. Public lists tell little of what each does: the rest is our reading, and its help says so.

use katydid_component::{Context, Each, ManyTrees, Message, component};
use katydid_data::{Branch, Path, Tree, TreeBuilder, Value};

use crate::branches::{Branches, items};

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

/// Gives each item of a tree a branch of its own, and each of these branches all that other trees have beside it. What is beside it is
/// the branch of the same path, else the one at the same place, the last again and again. Stands for EleFront's Graft Parallel; what
/// the other trees give is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd251",
    name = "Graft Parallel",
    nick = "GraftP",
    at = "EleFront/07 Trees"
)]
#[output("Primary Data", "P", "The tree, an item a branch.", kind = Generic)]
#[output("Secondary Data", "1", "For each item of the tree the branch beside it.", kind = Generic)]
fn graft_parallel(
    context: &Context<'_>,
    /// The tree.
    #[port("Primary Data", "P", kind = Generic)]
    primary: &Tree,
    /// A tree that goes along.
    #[port("Secondary Data", "1", kind = Generic, optional)]
    others: ManyTrees<'_>,
) -> Result<(Tree, Each<Tree>), Message> {
    room(context, primary, &others)?;
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
    let others = others.iter().map(along).collect::<Result<Vec<Tree>, Message>>()?;
    Ok((grafted.finish(), Each(others)))
}

/// Leaves out the nulls of a tree, and of other trees what stands at the same places. A tree that goes along has the branches at the
/// same places; what it has beyond them stays. Stands for EleFront's Clean Parallel.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd252",
    name = "Clean Parallel",
    nick = "CleanP",
    at = "EleFront/07 Trees"
)]
#[output("Primary Data", "P", "The tree without nulls.", kind = Generic)]
#[output("Secondary Data", "1", "What goes along.", kind = Generic)]
fn clean_parallel(
    context: &Context<'_>,
    /// The tree.
    #[port("Primary Data", "P", kind = Generic)]
    primary: &Tree,
    /// A tree that goes along.
    #[port("Secondary Data", "1", kind = Generic, optional)]
    others: ManyTrees<'_>,
) -> Result<(Tree, Each<Tree>), Message> {
    room(context, primary, &others)?;
    let cleaned = |tree: &Tree| {
        let mut made = TreeBuilder::<Value>::new();
        for (at, branch) in tree.branches().enumerate() {
            made.branch(branch.path().clone());
            let guide = primary.branch(at);
            let is_left_out = |place: usize| {
                guide.as_ref().is_some_and(|guide| place < guide.len() && guide.get(place).is_none())
            };
            let kept = branch.iter().enumerate().filter(|(place, _)| !is_left_out(*place));
            kept.for_each(|(_, item)| made.push(item));
        }
        made.finish()
    };
    Ok((cleaned(primary), Each(others.iter().map(|tree| cleaned(tree)).collect())))
}

/// A tree as it is, and of other trees the branches with the same paths, empty ones where they have none. Stands for EleFront's Get
/// Matching Branches; the choice of its menu to leave out empty branches is not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd253",
    name = "Get Matching Branches",
    nick = "GetBrn",
    at = "EleFront/07 Trees"
)]
#[output("Primary Data", "P", "The tree.", kind = Generic)]
#[output("Secondary Data", "1", "The branches with its paths.", kind = Generic)]
fn matching_branches(
    context: &Context<'_>,
    /// The tree.
    #[port("Primary Data", "P", kind = Generic)]
    primary: &Tree,
    /// A tree with other branches too.
    #[port("Secondary Data", "1", kind = Generic, optional)]
    others: ManyTrees<'_>,
) -> Result<(Tree, Each<Tree>), Message> {
    room(context, primary, &others)?;
    let of = |tree: &&Tree| {
        let known: std::collections::HashMap<&Path, usize> =
            tree.paths().iter().enumerate().map(|(place, path)| (path, place)).collect();
        let mut made = TreeBuilder::<Value>::new();
        for path in primary.paths() {
            made.branch(path.clone());
            let found = known.get(path).and_then(|place| tree.branch(*place));
            found.into_iter().for_each(|branch| branch.iter().for_each(|item| made.push(item)));
        }
        made.finish()
    };
    Ok((primary.clone(), Each(others.iter().map(of).collect())))
}

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

/// Cuts the paths of trees to as many numbers as the first path of a guide tree has. Stands for EleFront's ShiftMatch; that paths which
/// are shorter stay is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd256",
    name = "ShiftMatch",
    nick = "ShiftM",
    at = "EleFront/07 Trees"
)]
#[output("Guide Tree", "G", "The guide tree.", kind = Generic)]
#[output("Secondary Data", "1", "The tree with paths of its depth.", kind = Generic)]
fn shift_match(
    context: &Context<'_>,
    /// The tree that has the depth.
    #[port("Guide Tree", "G", kind = Generic)]
    guide: &Tree,
    /// A tree to shift.
    #[port("Secondary Data", "1", kind = Generic, optional)]
    others: ManyTrees<'_>,
) -> Result<(Tree, Each<Tree>), Message> {
    room(context, guide, &others)?;
    let depth = guide.paths().first().map_or(1, |path| path.len().max(1));
    Ok((guide.clone(), Each(others.iter().map(|tree| shifted(tree, depth)).collect())))
}

/// Cuts the branches of trees to the shortest among them: the first branches together, then the second ones, and so on. Where a tree
/// has no more branches, it has an empty one. Stands for EleFront's Shortest List Clean.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd257",
    name = "Shortest List Clean",
    nick = "Shortest",
    at = "EleFront/07 Trees"
)]
#[output("Primary Data", "P", "The tree, cut.", kind = Generic)]
#[output("Secondary Data", "1", "Another one, cut.", kind = Generic)]
fn shortest_list(
    context: &Context<'_>,
    /// The tree.
    #[port("Primary Data", "P", kind = Generic)]
    primary: &Tree,
    /// A tree that goes along.
    #[port("Secondary Data", "1", kind = Generic, optional)]
    others: ManyTrees<'_>,
) -> Result<(Tree, Each<Tree>), Message> {
    room(context, primary, &others)?;
    let length = |tree: &Tree, place: usize| tree.branch(place).map_or(0, |branch| branch.len());
    let shortest = |place: usize| {
        let others = others.iter().map(|tree| length(tree, place));
        others.fold(length(primary, place), usize::min)
    };
    let cut = |tree: &Tree| {
        let mut made = TreeBuilder::<Value>::new();
        for (place, branch) in tree.branches().enumerate() {
            made.branch(branch.path().clone());
            branch.iter().take(shortest(place)).for_each(|item| made.push(item));
        }
        made.finish()
    };
    Ok((cut(primary), Each(others.iter().map(|tree| cut(tree)).collect())))
}

/// Repeats items so that they have the structure of a tree: the first item fills the first branch, the second one the second branch,
/// and so on, the last again and again. Stands for EleFront's Duplicate Data Match; that an item is for a branch is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd258",
    name = "Duplicate Data Match",
    nick = "Dup",
    at = "EleFront/07 Trees"
)]
#[output("Source Data", "S", "The tree.", kind = Generic)]
#[output("Secondary Data", "1", "The items in its structure.", kind = Generic)]
fn duplicate_data(
    context: &Context<'_>,
    /// The tree.
    #[port("Source Data Tree", "S", kind = Generic)]
    source: &Tree,
    /// Items, one for each branch of the tree.
    #[port("Secondary Data", "1", kind = Generic, optional)]
    others: ManyTrees<'_>,
) -> Result<(Tree, Each<Tree>), Message> {
    context.items(source.item_count().saturating_mul(others.len().saturating_add(1)))?;
    let filled = |tree: &&Tree| {
        let Some(last) = tree.item_count().checked_sub(1) else { return Tree::empty() };
        let mut made = TreeBuilder::<Value>::new();
        for (place, branch) in source.branches().enumerate() {
            made.branch(branch.path().clone());
            let item = tree.column().get(place.min(last));
            (0..branch.len()).for_each(|_| made.push(item.clone()));
        }
        made.finish()
    };
    Ok((source.clone(), Each(others.iter().map(filled).collect())))
}

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
