//! Joining trees, and choosing between them.

use katydid_component::{Context, Each, ManyTrees, Message, component};
use katydid_data::{Path, Tree};

use super::whole;

/// Asks for room for the items and the paths of trees once more, and again with their places where branches have to be
/// sorted. What items share is not copied.
fn copies(context: &Context<'_>, trees: &[&Tree]) -> Result<(), Message> {
    let items = trees.iter().map(|tree| tree.item_count()).sum();
    context.items(items)?;
    let weight = trees.iter().map(|tree| tree.copied_weight()).fold(0, usize::saturating_add);
    let filled: Vec<&&Tree> = trees.iter().filter(|tree| !tree.is_empty()).collect();
    let in_order = filled.windows(2).all(|pair| pair[0].paths().last() <= pair[1].paths().first());
    let sorting = if in_order { 0 } else { weight.saturating_add(items.saturating_mul(size_of::<usize>())) };
    context.bytes(weight.saturating_add(sorting))
}

/// Joins trees: branches of the same path become one list, in the order of the inputs.
#[component(
    "3cadddef-1e2b-4c09-9390-0e8f78f7609f",
    name = "Merge",
    nick = "Merge",
    at = "Sets/Tree",
    also(
        "86866576-6cc0-485a-9cd2-6f7d493f57f7",
        "481f0339-1299-43ba-b15c-c07891a8f822",
        "b5be5d1f-717f-493c-b958-816957f271fd",
        "f4b0f7b4-5a10-46c4-8191-58d7d66ffdff",
        "ac9b4faf-c9d5-4f6a-a5e9-58c0c2cac116",
        "a70aa477-0109-4e75-ba73-78725dca0274",
        "22f66ff6-d281-453c-bd8c-36ed24026783",
        "0b6c5dac-6c93-4158-b8d1-ca3187d45f25"
    )
)]
#[output("Result", "R", "All branches.")]
fn merge(
    context: &Context<'_>,
    /// A tree; inputs without data are left out.
    #[port("Data 1", "D1", optional)]
    trees: ManyTrees,
) -> Result<Tree, Message> {
    copies(context, &trees)?;
    Ok(Tree::merge(trees.iter().copied()))
}

/// Puts each input in a branch of its own.
///
/// With flattened inputs, which is the usual setting, all items of input k become the list `{0;k}`; else the
/// number of the input is put in front of every path. Inputs without data have no branch.
#[component("c9785b8e-2f30-4f90-8ee3-cca710f82402", name = "Entwine", nick = "Entwine", at = "Sets/Tree")]
#[output("Result", "R", "The tree of all inputs.")]
fn entwine(
    context: &Context<'_>,
    /// What becomes one branch.
    #[port("Branch {0;0}", "{0;0}", optional)]
    trees: ManyTrees,
) -> Result<Tree, Message> {
    copies(context, &trees)?;
    let flatten = context.settings().bool("FlattenInputs").unwrap_or(true);
    let branches: Vec<Tree> = (0..)
        .zip(&trees)
        .map(|(k, tree)| match flatten {
            true => tree.flatten_to(Path::from([0, k])),
            false => {
                let prefixed =
                    |path: &Path| std::iter::once(k).chain(path.elements().iter().copied()).collect();
                tree.with_paths(tree.paths().iter().map(prefixed).collect())
            }
        })
        .collect();
    Ok(Tree::merge(&branches))
}

/// The place that a gate opens.
fn opened(gate: i32, n: usize) -> Result<usize, Message> {
    let place = usize::try_from(gate).ok().filter(|&k| k < n);
    place.ok_or_else(|| Message::error(format!("Gate is {gate}, but goes from 0 to {}", n.saturating_sub(1))))
}

/// Lets one of several trees pass: the one whose number the gate says.
#[component(
    "eeafc956-268e-461d-8e73-ee05c6f72c01",
    name = "Stream Filter",
    nick = "Filter",
    at = "Sets/Tree",
    also("3e5582a1-901a-4f7c-b58d-f5d7e3166124")
)]
#[output("Stream", "S", "The tree that passes.")]
fn stream_filter(
    context: &Context<'_>,
    /// The number of a stream; the first is 0.
    #[port("Gate", "G", default = 0)]
    gate: i32,
    /// A tree that may pass.
    #[port("Stream 0", "0", optional)]
    streams: ManyTrees,
) -> Result<Tree, Message> {
    let open = opened(gate, streams.len())?;
    let Some(stream) = streams.get(open) else { return Ok(Tree::empty()) };
    whole(context, stream)?;
    Ok((*stream).clone())
}

/// Sends a tree to one of several outputs: the one whose number the gate says. The others get nothing.
#[component(
    "71fcc052-6add-4d70-8d97-cfb37ea9d169",
    name = "Stream Gate",
    nick = "Gate",
    at = "Sets/Tree",
    also("d6313940-216b-487f-b511-6c8a5b87eae7")
)]
#[output("Target 0", "0", "The tree, when the gate says so.")]
fn stream_gate(
    context: &Context<'_>,
    /// The tree.
    #[port("Stream", "S")]
    stream: &Tree,
    /// The number of an output; the first is 0.
    #[port("Gate", "G", default = 0)]
    gate: i32,
) -> Result<Each<Tree>, Message> {
    let open = opened(gate, context.output_count())?;
    whole(context, stream)?;
    let target = |k: usize| if k == open { stream.clone() } else { Tree::empty() };
    Ok(Each((0..context.output_count()).map(target).collect()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    use super::*;

    #[test]
    fn merging_joins_equal_paths() {
        let trial = || Trial::of("Merge").branches([("{0}", [1, 2]), ("{2}", [3, 4])]).tree(Tree::empty());
        let trial = || trial().branches([("{0}", ["a"]), ("{1}", ["b"])]);
        assert_eq!(trial().texts(0), ["{0}: 1, 2, a", "{1}: b", "{2}: 3, 4"]);
        let old =
            Trial::of_guid("481f0339-1299-43ba-b15c-c07891a8f822").item(1).item(2).gaps([None, Some(3)]);
        assert_eq!(old.texts(0), ["{0}: 1, 2, null, 3"]);
    }

    #[test]
    fn entwining_makes_a_branch_an_input() {
        let trial = || {
            let trial = Trial::of("Entwine").branches([("{0}", [1]), ("{1}", [2])]);
            trial.tree(Tree::empty()).list([3, 4])
        };
        assert_eq!(trial().texts(0), ["{0;0}: 1, 2", "{0;2}: 3, 4"]);
        let nested = trial().setting("FlattenInputs", false);
        assert_eq!(nested.texts(0), ["{0;0}: 1", "{0;1}: 2", "{2;0}: 3, 4"]);
    }

    #[test]
    fn one_stream_passes() {
        let filter = |gate: i32| Trial::of("Stream Filter").item(gate).item("a").branches([("{4}", ["b"])]);
        assert_eq!(filter(1).texts(0), ["{4}: b"]);
        assert_eq!(Trial::of("Stream Filter").item(false).item("a").item("b").texts(0), ["{0}: a"]);
        assert_eq!(filter(2).message(), "Gate is 2, but goes from 0 to 1");
        assert!(filter(-1).texts(0).is_empty());
        let nothing = Trial::of("Stream Filter").item(false).tree(Tree::empty()).item("b");
        assert!(nothing.texts(0).is_empty());
    }

    #[test]
    fn one_output_gets_the_stream() {
        let gate = |k: i32| Trial::of("Stream Gate").branches([("{4}", [1, 2])]).item(k).outputs(3);
        assert_eq!(gate(2).texts(2), ["{4}: 1, 2"]);
        assert!(gate(2).texts(0).is_empty());
        assert_eq!(gate(3).message(), "Gate is 3, but goes from 0 to 2");
    }
}
