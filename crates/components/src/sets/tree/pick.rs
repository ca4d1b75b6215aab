//! Taking branches and items out of a tree.

use katydid_component::{Context, Each, Message, component};
use katydid_data::{Path, Tree, Value};

use crate::sets::{integer, place, room};

/// The number of the branch at a path.
fn find(tree: &Tree, path: &Path) -> Option<usize> {
    tree.paths().binary_search(path).ok()
}

/// One branch as a tree, at a path.
fn branch(context: &Context<'_>, tree: &Tree, b: usize, path: Path) -> Result<Tree, Message> {
    let range = tree.range(b);
    room(context, range.len().saturating_add(1))?;
    let column = if range.len() == tree.item_count() {
        tree.column().clone()
    } else {
        tree.column().gather(&range.collect::<Vec<_>>())
    };
    Ok(Tree::branch_at(path, column))
}

/// Takes the branches at given paths out of a tree.
///
/// A path without a branch is a warning. A setting puts the branches at `{0}` instead of their paths.
#[component("3a710c1e-1809-4e19-8c15-82adce31cd62", name = "Tree Branch", nick = "Branch", at = "Sets/Tree")]
#[output("Branch", "B", "The branch.")]
fn tree_branch(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// The path of the branch.
    #[port("Path", "P")]
    path: Path,
) -> Result<Tree, Message> {
    let Some(b) = find(tree, &path) else {
        context.warn(format!("There is no branch {path}"));
        return Ok(Tree::empty());
    };
    let keep = context.settings().bool("MaintainPaths").unwrap_or(false);
    branch(context, tree, b, if keep { path } else { Path::zero() })
}

/// Takes one item out of a tree, by path and index.
///
/// With Wrap the branch is counted round and round. A path without a branch, and an index outside, give a null
/// and a warning.
#[component("c1ec65a3-bda4-4fad-87d0-edf86ed9d81c", name = "Tree Item", nick = "Item", at = "Sets/Tree")]
#[output("Element", "E", "The item.")]
fn tree_item(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// The path of the branch.
    #[port("Path", "P")]
    path: Path,
    /// Which item of it; the first is 0.
    #[port("Index", "i", default = 0)]
    index: i32,
    /// Count round and round.
    #[port("Wrap", "W", default = true)]
    wrap: bool,
) -> Option<Value> {
    let Some(branch) = find(tree, &path).and_then(|b| tree.branch(b)) else {
        context.warn(format!("There is no branch {path}"));
        return None;
    };
    let Some(at) = place(index.into(), branch.len(), wrap) else {
        context.warn("The index lies outside the branch");
        return None;
    };
    branch.get(at)
}

/// Gives each branch of a tree to an output of its own, in order.
///
/// Branches beyond the last output are left out with a warning; outputs beyond the last branch get nothing.
#[component(
    "74cad441-2264-45fe-a57d-85034751208a",
    name = "Explode Tree",
    nick = "BANG!",
    at = "Sets/Tree",
    also("8a470a35-d673-4779-a65e-ba95765e59e4")
)]
#[output("Branch 0", "-", "One branch, at its path.")]
fn explode_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D", optional)]
    data: &Tree,
) -> Result<Each<Tree>, Message> {
    let outputs = context.output_count();
    if data.branch_count() > outputs {
        let n = data.branch_count();
        context.warn(format!("The tree has {n} branches, but there are {outputs} outputs"));
    }
    let one = |b: usize| match data.paths().get(b) {
        Some(path) => branch(context, data, b, path.clone()),
        None => Ok(Tree::empty()),
    };
    Ok(Each((0..outputs).map(one).collect::<Result<_, _>>()?))
}

/// Tells which branches a tree has and how long they are.
#[component(
    "99bee19d-588c-41a0-b9b9-1d00fb03ea1a",
    name = "Tree Statistics",
    nick = "TStat",
    at = "Sets/Tree"
)]
#[output("Paths", "P", "The paths of all branches.")]
#[output("Length", "L", "The number of items in each, nulls included.")]
#[output("Count", "C", "The number of branches.")]
fn tree_statistics(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
) -> Result<(Vec<Path>, Vec<i32>, i32), Message> {
    let n = tree.branch_count();
    context.items(n.saturating_mul(2))?;
    Ok((tree.paths().to_vec(), tree.branches().map(|branch| integer(branch.len())).collect(), integer(n)))
}

/// Leaves out branches that have too few or too many items.
#[component("fe769f85-8900-45dd-ba11-ec9cd6c778c6", name = "Prune Tree", nick = "Prune", at = "Sets/Tree")]
#[output("Tree", "T", "The other branches.")]
fn prune_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// The fewest items that a branch may have.
    #[port("Minimum", "N0", default = 1)]
    minimum: i32,
    /// The most items that a branch may have; 0 for any number.
    #[port("Maximum", "N1", default = 0)]
    maximum: i32,
) -> Result<Tree, Message> {
    super::whole(context, tree)?;
    let minimum = usize::try_from(minimum).unwrap_or(0);
    let maximum = usize::try_from(maximum).ok().filter(|&n| n > 0).unwrap_or(usize::MAX);
    Ok(tree.filter_branches(|b| (minimum..=maximum).contains(&tree.range(b).len())))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    use super::*;

    fn two(name: &str) -> Trial {
        Trial::of(name).branches([("{0;0}", [1, 2]), ("{0;1}", [3, 4])])
    }

    #[test]
    fn branches_by_path() {
        let branch = |path: &str| two("Tree Branch").item(path);
        assert_eq!(branch("{0;1}").setting("MaintainPaths", true).texts(0), ["{0;1}: 3, 4"]);
        assert_eq!(branch("{0;1}").texts(0), ["{0}: 3, 4"]);
        assert_eq!(branch("{5}").message(), "There is no branch {5}");
        let both = two("Tree Branch").list(["{0;1}", "{0;0}"]).setting("MaintainPaths", true);
        assert_eq!(both.texts(0), ["{0;0}: 1, 2", "{0;1}: 3, 4"]);
    }

    #[test]
    fn items_by_path_and_index() {
        let item = |path: &str, i: i32, wrap: bool| two("Tree Item").item(path).item(i).item(wrap);
        assert_eq!(item("{0;1}", -1, true).texts(0), ["{0}: 4"]);
        assert_eq!(item("{0;1}", 2, false).texts(0), ["{0}: null"]);
        assert_eq!(item("{0;1}", 2, false).message(), "The index lies outside the branch");
        assert_eq!(item("{1}", 0, true).message(), "There is no branch {1}");
    }

    #[test]
    fn exploding_by_order() {
        let bang = |n: usize| two("Explode Tree").outputs(n);
        assert_eq!(bang(2).texts(1), ["{0;1}: 3, 4"]);
        assert!(bang(3).texts(2).is_empty());
        assert_eq!(bang(1).message(), "The tree has 2 branches, but there are 1 outputs");
    }

    #[test]
    fn statistics_at_zero() {
        assert_eq!(two("Tree Statistics").texts(0), ["{0}: {0;0}, {0;1}"]);
        assert_eq!(two("Tree Statistics").texts(1), ["{0}: 2, 2"]);
        assert_eq!(two("Tree Statistics").texts(2), ["{0}: 2"]);
        assert_eq!(Trial::of("Tree Statistics").tree(Tree::empty()).texts(2), ["{0}: 0"]);
    }

    #[test]
    fn pruning_by_length() {
        let tree = || {
            let trial = Trial::of("Partition List").list([1, 2, 3, 4, 5, 6]).list([1, 2, 3]).run();
            Trial::of("Prune Tree").tree(trial.outputs[0].clone())
        };
        assert_eq!(tree().item(2).texts(0), ["{0;1}: 2, 3", "{0;2}: 4, 5, 6"]);
        assert_eq!(tree().item(0).item(1).texts(0), ["{0;0}: 1"]);
        assert_eq!(tree().item(4).texts(0).len(), 0);
        assert_eq!(Trial::of("Prune Tree").list::<f64>([]).texts(0).len(), 0);
    }

    #[test]
    fn the_same_branch_a_thousand_times_is_counted() {
        let long = Tree::list((0..1_000_000).map(f64::from).collect());
        let trial = Trial::of("Tree Branch").tree(long).list(vec!["{0}"; 1000]);
        assert!(trial.message().contains("bytes"));
    }
}
