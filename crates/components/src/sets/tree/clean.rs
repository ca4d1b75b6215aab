//! Nulls, invalid items and empty branches of trees.

use katydid_component::{Context, Each, ManyTrees, Message, component};
use katydid_data::{Tree, Value};

use super::whole;
use crate::sets::is_invalid;

/// Which items of a tree stay.
fn kept(tree: &Tree, nulls: bool, invalid: bool) -> Vec<bool> {
    let stays = |item: Option<Value>| match item {
        None => !nulls,
        Some(item) => !(invalid && is_invalid(&item)),
    };
    tree.column().iter().map(stays).collect()
}

/// The tree with the items that stay, and perhaps without its empty branches.
fn cleaned(tree: &Tree, kept: &[bool], empty: bool) -> Tree {
    let mut paths = Vec::with_capacity(tree.branch_count());
    let mut ends = Vec::with_capacity(tree.branch_count());
    let mut indices = Vec::with_capacity(tree.item_count());
    for branch in tree.branches() {
        let before = indices.len();
        indices.extend(branch.range().filter(|&i| kept.get(i) == Some(&true)));
        if !empty || indices.len() > before {
            paths.push(branch.path().clone());
            ends.push(indices.len());
        }
    }
    Tree::from_parts(paths, ends, tree.column().gather(&indices))
}

fn same_shape(a: &Tree, b: &Tree) -> bool {
    a.paths() == b.paths() && (0..a.branch_count()).all(|k| a.range(k) == b.range(k))
}

/// Leaves out nulls, items that are not valid, and empty branches.
///
/// Trees of the same shape are cleaned in step: a place that goes in one of them goes in all, so that items that
/// belong together stay together. Branches are looked at when their items are gone.
#[component("071c3940-a12d-4b77-bb23-42b5d3314a0d", name = "Clean Tree", nick = "Clean", at = "Sets/Tree")]
#[output("Tree", "T", "The cleaned tree.")]
fn clean_tree(
    context: &Context<'_>,
    /// Leave out nulls.
    #[port("Remove Nulls", "N", default = true)]
    nulls: bool,
    /// Leave out items with infinite parts or parts that are not a number.
    #[port("Remove Invalid", "X", default = true)]
    invalid: bool,
    /// Leave out empty branches.
    #[port("Remove Empty", "E", default = false)]
    empty: bool,
    /// The tree.
    #[port("Tree", "T")]
    trees: ManyTrees,
) -> Result<Each<Tree>, Message> {
    for tree in &trees {
        whole(context, tree)?;
    }
    let mut kept: Vec<Vec<bool>> = trees.iter().map(|tree| kept(tree, nulls, invalid)).collect();
    let mut filled = trees.iter().filter(|tree| !tree.is_empty());
    let in_step = match filled.next() {
        Some(first) => filled.all(|tree| same_shape(first, tree)),
        None => false,
    };
    if in_step {
        let mut common = vec![true; trees.iter().map(|tree| tree.item_count()).max().unwrap_or(0)];
        for kept in &kept {
            common.iter_mut().zip(kept).for_each(|(all, &one)| *all &= one);
        }
        kept.fill(common);
    }
    Ok(Each(trees.iter().zip(&kept).map(|(tree, kept)| cleaned(tree, kept, empty)).collect()))
}

/// Leaves out nulls, items that are not valid, and empty branches.
#[component(
    "7991bc5f-8a01-4768-bfb0-a39357ac6b84",
    name = "Clean Tree",
    nick = "Clean",
    at = "Sets/Tree",
    also("70ce4230-da08-4fce-b29d-63dc42a88585"),
    old
)]
#[output("Tree", "T", "The cleaned tree.")]
fn clean_one_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// Leave out items with infinite parts or parts that are not a number.
    #[port("Clean Invalid", "X", default = true)]
    invalid: bool,
    /// Leave out empty branches.
    #[port("Clean Empty", "E", default = false)]
    empty: bool,
) -> Result<Tree, Message> {
    whole(context, tree)?;
    Ok(cleaned(tree, &kept(tree, true, invalid), empty))
}

/// Tells for each item of a tree whether it is null.
#[component("e6859d1e-2b3d-4704-93ea-32714acae176", name = "Null Check", nick = "Null", at = "Sets/Tree")]
#[output("Null", "N", "True where there is no item.")]
fn null_check(
    /// The tree.
    #[port("Data", "D")]
    data: &Tree,
) -> Tree {
    let flags = (0..data.item_count()).map(|i| data.column().is_null(i)).collect();
    data.with_column(<bool as katydid_data::Item>::column(flags, None))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};

    #[test]
    fn cleaning_takes_items_then_branches() {
        let tree = |nulls: bool, empty: bool| {
            let trial = Trial::of("Clean Tree").item(nulls).default().item(empty);
            trial.gaps([Some(1.0), None, Some(f64::INFINITY), Some(4.0)])
        };
        assert_eq!(tree(true, false).texts(0), ["{0}: 1, 4"]);
        assert_eq!(tree(false, false).texts(0), ["{0}: 1, null, 4"]);
        let hollow =
            |empty: bool| Trial::of("Clean Tree").default().default().item(empty).gaps::<f64>([None, None]);
        assert_eq!(hollow(false).texts(0), ["{0}:"]);
        assert!(hollow(true).texts(0).is_empty());
    }

    #[test]
    fn trees_of_one_shape_are_cleaned_in_step() {
        let trial = Trial::of("Clean Tree").default().default().default();
        let outcome =
            trial.gaps([Some(1), None, Some(3)]).gaps([None, Some("b"), Some("c")]).outputs(2).run();
        assert_eq!(texts(&outcome.outputs[0]), ["{0}: 3"]);
        assert_eq!(texts(&outcome.outputs[1]), ["{0}: c"]);
        let trial = Trial::of("Clean Tree").default().default().default();
        let outcome = trial.gaps([Some(1), None]).list(["a", "b", "c"]).outputs(2).run();
        assert_eq!(texts(&outcome.outputs[1]), ["{0}: a, b, c"]);
    }

    #[test]
    fn the_old_ones() {
        let old = Trial::of_guid("7991bc5f-8a01-4768-bfb0-a39357ac6b84").gaps([Some(1.0), None]);
        assert_eq!(old.texts(0), ["{0}: 1"]);
        assert_eq!(Trial::of("Null Check").gaps([Some(1.0), None]).texts(0), ["{0}: False, True"]);
    }
}
