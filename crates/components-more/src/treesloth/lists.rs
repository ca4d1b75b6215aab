//! Lists: their ends, their items against each other, and items dealt out.

use katydid_component::{Context, Each, List, ManyLists, Message, component};
use katydid_data::{Tree, Value};

use super::dealt;
use crate::branches::{Branches, of};
use crate::human::by_pattern;

/// The first and the last item of a list; null where it is empty. Stands for TreeSloth's First/Last.
#[component(
    "3e1c809d-a35b-429c-a01f-151471f5240b",
    name = "First/Last",
    nick = "First/Last",
    at = "TreeSloth/List"
)]
#[output("First Value", "F", "The first item.", kind = Generic)]
#[output("Last Value", "L", "The last item.", kind = Generic)]
fn first_last(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
) -> (Option<Value>, Option<Value>) {
    let last = list.len().checked_sub(1);
    (list.get(0), last.and_then(|last| list.get(last)))
}

/// Every item of a list against all others: a branch for each item, with the item in one tree and the others in their order in the
/// other tree. Stands for TreeSloth's List Compare; how the two are arranged is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f21",
    name = "List Compare",
    nick = "Compare",
    at = "TreeSloth/List"
)]
#[output("Base", "B", "A branch for each item.", kind = Generic)]
#[output("Comparison", "C", "For each item the others.", kind = Generic)]
fn list_compare(
    context: &Context<'_>,
    /// The lists.
    #[port("List", "L", kind = Generic)]
    list: &Tree,
) -> Result<(Tree, Tree), Message> {
    let (mut base, mut others) = (Branches::default(), Branches::default());
    for branch in list.branches() {
        let items = of(&branch);
        context.items(items.len().saturating_mul(items.len()))?;
        for (place, item) in items.iter().enumerate() {
            context.check()?;
            let path = branch.path().child(place);
            let rest = items.iter().enumerate().filter(|(other, _)| *other != place);
            others.extend(path.clone(), rest.map(|(_, item)| item.clone()));
            base.push(path, item.clone());
        }
    }
    Ok((base.tree(), others.tree()))
}

/// Deals the items of a list out to the outputs, as a pattern of the outputs' numbers says that starts again and again. Stands for
/// TreeSloth's Unweave.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f22",
    name = "Unweave",
    nick = "Unweave",
    at = "TreeSloth/List"
)]
#[output("Data {0}", "0", "The items for an output.", kind = Generic)]
fn unweave(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// The number of the output for each item, from 0.
    #[port("Unweave Pattern", "P")]
    pattern: List<i32>,
) -> Result<Each<Vec<Option<Value>>>, Message> {
    context.items(list.len())?;
    let pattern: Vec<i32> = pattern.present().collect();
    let mut parts = vec![Vec::new(); context.output_count()];
    for (item, output) in list.iter().zip(dealt(context, &pattern, list.len())?) {
        if let Some(part) = output.and_then(|output| parts.get_mut(output)) {
            part.push(item);
        }
    }
    Ok(Each(parts))
}

/// Leaves out of several lists the items at whose place a pattern is false. The pattern starts again and again; null counts as false.
/// Stands for TreeSloth's Cull Multiple.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2f23",
    name = "Cull Multiple",
    nick = "Cull Multiple",
    at = "TreeSloth/Sequence"
)]
#[output("Data", "L0", "The items of a list that stay.", kind = Generic)]
fn cull_multiple(
    context: &Context<'_>,
    /// Which places stay.
    #[port("Cull Pattern", "P")]
    pattern: List<bool>,
    /// A list.
    #[port("Data", "L0", optional)]
    lists: ManyLists<'_, Value>,
) -> Result<Each<Vec<Option<Value>>>, Message> {
    by_pattern(context, &pattern, &lists)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn ends_of_lists() {
        let trial = || Trial::of("First/Last").list([7, 8, 9]);
        assert_eq!(trial().texts(0), ["{0}: 7"]);
        assert_eq!(trial().texts(1), ["{0}: 9"]);
        assert_eq!(Trial::of("First/Last").list([5]).texts(1), ["{0}: 5"]);
    }

    #[test]
    fn items_against_each_other() {
        let trial =
            || Trial::of("List Compare").branches([("{0}", ["a", "b", "c"]), ("{2}", ["d", "e", "f"])]);
        assert_eq!(trial().texts(0)[..4], ["{0;0}: a", "{0;1}: b", "{0;2}: c", "{2;0}: d"]);
        assert_eq!(trial().texts(1)[..3], ["{0;0}: b, c", "{0;1}: a, c", "{0;2}: a, b"]);
        assert_eq!(Trial::of("List Compare").list([1]).texts(1), ["{0;0}:"]);
    }

    #[test]
    fn items_are_dealt_out() {
        let trial = || Trial::of("Unweave").list([0, 1, 2, 3, 4, 5, 6]).list([0, 0, 1]).outputs(2);
        assert_eq!(trial().texts(0), ["{0}: 0, 1, 3, 4, 6"]);
        assert_eq!(trial().texts(1), ["{0}: 2, 5"]);
        assert_eq!(trial().message(), "");
        let missing = Trial::of("Unweave").list([7, 8]).list([0, -1]).outputs(2);
        assert_eq!(missing.texts(0), ["{0}: 7"]);
    }

    #[test]
    fn lists_are_culled_together() {
        let trial = || {
            Trial::of("Cull Multiple")
                .list([true, false])
                .outputs(2)
                .list(["a", "b", "c"])
                .list([1, 2, 3, 4, 5])
        };
        assert_eq!(trial().texts(0), ["{0}: a, c"]);
        assert_eq!(trial().texts(1), ["{0}: 1, 3, 5"]);
    }
}
