//! Trees that are compared by their paths, or put one behind the other.

use std::collections::HashMap;

use katydid_component::{Context, Each, ManyTrees, Message, component};
use katydid_data::{Path, Tree};

use super::moved;
use crate::branches::{Branches, of};

/// Room for the items of all trees.
fn room(context: &Context<'_>, trees: &[&Tree]) -> Result<(), Message> {
    context.items(trees.iter().map(|tree| tree.item_count()).fold(0, usize::saturating_add))
}

/// In how many of some trees each path is.
fn counts<'a>(trees: &[&'a Tree]) -> HashMap<&'a Path, usize> {
    let mut counts = HashMap::new();
    for path in trees.iter().flat_map(|tree| tree.paths()) {
        *counts.entry(path).or_insert(0) += 1;
    }
    counts
}

/// A component that gives for each of some trees another one, by the paths that the trees have in common.
macro_rules! along {
    (
        $(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $told:literal,
        $made:expr
    ) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "TreeSloth/Tree")]
        #[output("Data 0", "0", $told, kind = Generic)]
        fn $function(
            context: &Context<'_>,
            /// A tree.
            #[port("Data 0", "0", optional)]
            trees: ManyTrees<'_>,
        ) -> Result<Each<Tree>, Message> {
            room(context, &trees)?;
            let counts = counts(&trees);
            let made: fn(&Tree, &HashMap<&Path, usize>, usize) -> Tree = $made;
            Ok(Each(trees.iter().map(|tree| made(tree, &counts, trees.len())).collect()))
        }
    };
}

/// The branches of a tree whose paths so many trees have.
fn kept(tree: &Tree, counts: &HashMap<&Path, usize>, wanted: usize) -> Tree {
    let mut branches = Branches::default();
    for branch in tree.branches().filter(|branch| counts.get(branch.path()) == Some(&wanted)) {
        branches.extend(branch.path().clone(), of(&branch));
    }
    branches.tree()
}

along!(
    /// Gives trees the same paths: where one has no branch that another one has, it gets an empty one. Stands for TreeSloth's Add
    /// Unmatched.
    add_unmatched, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f01", "Add Unmatched", "Add Unmatched",
    "The tree with the paths of all.",
    |tree, counts, _| {
        let mut branches = Branches::default();
        counts.keys().for_each(|path| branches.extend((*path).clone(), []));
        tree.branches().for_each(|branch| branches.extend(branch.path().clone(), of(&branch)));
        branches.tree()
    }
);

along!(
    /// Leaves out of trees the branches whose paths are not in all of them. Stands for TreeSloth's Filter Unmatched.
    filter_unmatched, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f02", "Filter Unmatched", "Filter Unmatched",
    "The branches whose paths all trees have.",
    kept
);

along!(
    /// Keeps of trees the branches whose paths are in none of the others. Stands for TreeSloth's Isolate Unique Paths.
    isolate_unique_paths, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f03", "Isolate Unique Paths", "Unique Paths",
    "The branches whose paths only this tree has.",
    |tree, counts, _| kept(tree, counts, 1)
);

/// Puts trees one behind the other: the first numbers of their paths go on where the tree before ended. Stands for TreeSloth's Stack
/// Trees; that the numbers begin with 0 and all others of a path stay is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f04",
    name = "Stack Trees",
    nick = "Stack",
    at = "TreeSloth/Tree"
)]
#[output("Tree", "T", "The trees as one.", kind = Generic)]
fn stack_trees(
    context: &Context<'_>,
    /// A tree.
    #[port("Data {0}", "0", optional)]
    trees: ManyTrees<'_>,
) -> Result<Tree, Message> {
    room(context, &trees)?;
    let head = |path: &Path| i64::from(path.elements().first().copied().unwrap_or(0));
    let mut stacked = Branches::default();
    let mut next = 0_i64;
    for tree in &trees {
        let Some(least) = tree.paths().iter().map(head).min() else { continue };
        let shift = next - least;
        let shifted = moved(context, tree, |_, path| {
            let first = i32::try_from(head(path) + shift)
                .map_err(|_| Message::error("The numbers of the paths are too great"))?;
            let rest = path.elements().get(1..).unwrap_or_default();
            Ok(Path::from([&[first], rest].concat().as_slice()))
        })?;
        next = shifted.paths().iter().map(head).max().map_or(next, |last| last + 1);
        shifted.branches().for_each(|branch| stacked.extend(branch.path().clone(), of(&branch)));
    }
    Ok(stacked.tree())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;

    fn two(name: &str) -> [Vec<String>; 2] {
        [0, 1].map(|k| {
            let trial = Trial::of(name).branches([("{0}", ["a"]), ("{2}", ["b"])]).outputs(2);
            trial.branches([("{2}", [1, 2]), ("{0;5}", [3, 4])]).texts(k)
        })
    }

    #[test]
    fn paths_are_made_the_same() {
        let [first, second] = two("Add Unmatched");
        assert_eq!(first, ["{0}: a", "{0;5}:", "{2}: b"]);
        assert_eq!(second, ["{0}:", "{0;5}: 3, 4", "{2}: 1, 2"]);
    }

    #[test]
    fn paths_in_common_and_paths_of_one() {
        assert_eq!(two("Filter Unmatched"), [vec!["{2}: b".to_owned()], vec!["{2}: 1, 2".to_owned()]]);
        let own = [vec!["{0}: a".to_owned()], vec!["{0;5}: 3, 4".to_owned()]];
        assert_eq!(two("Isolate Unique Paths"), own);
        let alone = |name: &str| Trial::of(name).branches([("{3}", [1])]).outputs(1).texts(0);
        assert_eq!(alone("Filter Unmatched"), ["{3}: 1"]);
        assert_eq!(alone("Isolate Unique Paths"), ["{3}: 1"]);
    }

    #[test]
    fn trees_are_stacked() {
        let trial = Trial::of("Stack Trees").branches([("{0;1}", [1]), ("{1;0}", [2])]);
        let trial = trial.tree(Tree::empty()).branches([("{5}", [3]), ("{7}", [4])]);
        assert_eq!(trial.texts(0), ["{0;1}: 1", "{1;0}: 2", "{2}: 3", "{4}: 4"]);
        let far = Trial::of("Stack Trees").branches([("{0}", [1]), ("{2147483647}", [2])]);
        assert_eq!(far.branches([("{0}", [3])]).message(), "The numbers of the paths are too great");
    }
}
