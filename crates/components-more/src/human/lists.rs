//! Lists that are filtered together, and objects told apart by their types.

use std::collections::HashSet;
use std::sync::Arc as Shared;

use katydid_component::{Context, Each, List, ManyLists, Message, component};
use katydid_data::{Path, Tree, Value};

use crate::branches::{Branches, of};
use crate::model_objects::{object_of, type_name};

/// The items of some lists whose places pass. A list that is shorter ends earlier.
fn passed(lists: &ManyLists<'_, Value>, passes: &[bool]) -> Vec<Vec<Option<Value>>> {
    let kept = |list: &List<'_, Value>| {
        let items = list.iter().zip(passes);
        items.filter(|(_, passes)| **passes).map(|(item, _)| item).collect()
    };
    lists.iter().map(kept).collect()
}

fn room(context: &Context<'_>, lists: &ManyLists<'_, Value>) -> Result<(), Message> {
    context.items(lists.iter().map(List::len).fold(0, usize::saturating_add))
}

/// The items of several lists at whose place a pattern is true, which starts again where it ends.
///
/// # Errors
/// The pattern is empty.
pub(crate) fn by_pattern(
    context: &Context<'_>,
    pattern: &List<'_, bool>,
    lists: &ManyLists<'_, Value>,
) -> Result<Each<Vec<Option<Value>>>, Message> {
    room(context, lists)?;
    if pattern.is_empty() {
        return Err(Message::error("The pattern is empty"));
    }
    let longest = lists.iter().map(List::len).max().unwrap_or(0);
    let pattern: Vec<bool> = pattern.iter().map(|passes| passes.unwrap_or(false)).collect();
    let passes: Vec<bool> = pattern.iter().copied().cycle().take(longest).collect();
    Ok(Each(passed(lists, &passes)))
}

/// The items of several lists at whose place a pattern is true. A pattern that is shorter than the longest list starts again, which
/// is our reading; null counts as false. Stands for Human's Dispatch Multiple.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd311",
    name = "Dispatch Multiple",
    nick = "MDispatch",
    at = "Human/Misc"
)]
#[output("List 0", "0", "The items of a list that pass.", kind = Generic)]
fn dispatch_multiple(
    context: &Context<'_>,
    /// Which places pass.
    #[port("Dispatch Pattern", "DP")]
    pattern: List<bool>,
    /// A list.
    #[port("List 0", "0", optional)]
    lists: ManyLists<'_, Value>,
) -> Result<Each<Vec<Option<Value>>>, Message> {
    by_pattern(context, &pattern, &lists)
}

/// The items of several lists at whose place a guide list has one of some texts. Capitals matter, which is our reading. Stands for
/// Human's Filter By Item.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd312",
    name = "Filter By Item",
    nick = "IFilter",
    at = "Human/Misc"
)]
#[output("List 0", "0", "The items of a list that pass.", kind = Generic)]
fn filter_by_item(
    context: &Context<'_>,
    /// The texts that decide, one for each place.
    #[port("Guide List", "G")]
    guide: List<Shared<str>>,
    /// The texts that pass.
    #[port("Selected Items", "S")]
    selected: List<Shared<str>>,
    /// A list.
    #[port("List 0", "0", optional)]
    lists: ManyLists<'_, Value>,
) -> Result<Each<Vec<Option<Value>>>, Message> {
    room(context, &lists)?;
    if let Some(list) = lists.iter().find(|list| list.len() > guide.len()) {
        let (items, guides) = (list.len(), guide.len());
        return Err(Message::error(format!("The guide list has {guides} texts for a list of {items} items")));
    }
    let selected: HashSet<Shared<str>> = selected.present().collect();
    let passes: Vec<bool> =
        guide.iter().map(|text| text.is_some_and(|text| selected.contains(&text))).collect();
    Ok(Each(passed(&lists, &passes)))
}

/// Hands the items of a list on one after the other. A single solution comes after all of them: the last item is what stays, which is
/// our reading. Stands for Human's PassSequentially.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd313",
    name = "PassSequentially",
    nick = "PassSeq",
    at = "Human/Misc"
)]
#[output("Data out", "d", "The last item.", kind = Generic)]
fn pass_sequentially(
    /// The items.
    #[port("Data to Pass", "d")]
    items: List<Value>,
) -> Option<Value> {
    items.len().checked_sub(1).and_then(|last| items.get(last))
}

/// Which output of Sort Objects By Type an object goes to.
fn place_of(value: &Value) -> usize {
    match type_name(value) {
        "Text" | "TextDot" | "Leader" | "Dimension" => 0,
        "Hatch" => 1,
        "Light" => 2,
        "Block" => 3,
        _ => 4,
    }
}

/// Texts, hatches, lights, blocks and all other objects, each on an output of its own. Stands for Human's Sort Objects By Type, which
/// may have more outputs: those with a name here are told apart, anything else is among the others.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd314",
    name = "Sort Objects By Type",
    nick = "SortByType",
    at = "Human/Reference"
)]
#[output("Text Objects", "txt", "Texts, text dots, leaders and dimensions.", kind = Generic)]
#[output("Hatch Objects", "hatch", "Hatches.", kind = Generic)]
#[output("Light Objects", "light", "Lights.", kind = Generic)]
#[output("Blocks", "block", "Blocks that are placed.", kind = Generic)]
#[output("Other", "other", "All other objects.", kind = Generic)]
fn sort_objects(
    context: &Context<'_>,
    /// Objects of the model, or geometry.
    #[port("RhinoObjects", "rhObj")]
    objects: List<Value>,
) -> Result<(Vec<Value>, Vec<Value>, Vec<Value>, Vec<Value>, Vec<Value>), Message> {
    context.items(objects.len())?;
    let mut sorted: [Vec<Value>; 5] = Default::default();
    for object in objects.present() {
        if let Some(list) = sorted.get_mut(place_of(&object)) {
            list.push(object);
        }
    }
    let [texts, hatches, lights, blocks, others] = sorted;
    Ok((texts, hatches, lights, blocks, others))
}

/// Puts objects of the model into the branches that they were baked from. Stands for Human's Reinstate Tree. Under which key Human
/// keeps the path is not known: here it is the first user text that is a path such as `{0;1}`; objects without one stay where they
/// are.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd315",
    name = "Reinstate Tree",
    nick = "ReTree",
    at = "Human/Reference"
)]
#[output("Geometry", "G", "The objects in their branches.", kind = Generic)]
fn reinstate_tree(
    context: &Context<'_>,
    /// The objects.
    #[port("Geometry", "G", kind = Generic)]
    objects: &Tree,
) -> Result<Tree, Message> {
    context.items(objects.item_count())?;
    let mut branches = Branches::default();
    for branch in objects.branches() {
        for item in of(&branch) {
            let path = item.as_ref().and_then(|item| kept_path(context, item));
            branches.push(path.unwrap_or_else(|| branch.path().clone()), item);
        }
    }
    Ok(branches.tree())
}

fn kept_path(context: &Context<'_>, item: &Value) -> Option<Path> {
    let object = object_of(context, item)?;
    let mut texts = object.user_text.iter().map(|(_, text)| text.trim());
    texts.find_map(|text| text.starts_with('{').then(|| text.parse().ok()).flatten())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{BlockDefinition, BlockInstance, ModelObject, Value};
    use katydid_geometry::{Point3, Xform};

    #[test]
    fn lists_are_filtered_by_a_pattern() {
        let trial = || {
            let trial = Trial::of("Dispatch Multiple").list([true, false]).outputs(2);
            trial.list(["a", "b", "c"]).list([1, 2])
        };
        assert_eq!(trial().texts(0), ["{0}: a, c"]);
        assert_eq!(trial().texts(1), ["{0}: 1"]);
    }

    #[test]
    fn lists_are_filtered_by_texts() {
        let trial = |guide: Vec<&'static str>| {
            let trial = Trial::of("Filter By Item").list(guide).list(["oak", "elm"]);
            trial.list([1, 2, 3])
        };
        assert_eq!(trial(vec!["oak", "ash", "elm"]).texts(0), ["{0}: 1, 3"]);
        assert_eq!(trial(vec!["Oak", "ash", "elm"]).texts(0), ["{0}: 3"]);
        assert_eq!(trial(vec!["oak"]).message(), "The guide list has 1 texts for a list of 3 items");
    }

    #[test]
    fn the_last_item_stays() {
        assert_eq!(Trial::of("PassSequentially").list([3, 4, 5]).texts(0), ["{0}: 5"]);
    }

    #[test]
    fn objects_by_their_types() {
        let chair = BlockDefinition::new("Chair", vec![]);
        let placed = BlockInstance { definition: chair.into(), transform: Xform::IDENTITY };
        let objects = [Value::from(Point3::ORIGIN), Value::from(placed)];
        let sorted = Trial::of("Sort Objects By Type").list(objects).run().outputs;
        assert_eq!(texts(&sorted[3]), ["{0}: Block Instance (Chair)"]);
        assert_eq!(texts(&sorted[4]), ["{0}: {0, 0, 0}"]);
        assert_eq!(sorted[0].item_count() + sorted[1].item_count() + sorted[2].item_count(), 0);
    }

    #[test]
    fn objects_go_back_to_their_branches() {
        let baked = |x: f64, path: &str| {
            let mut object = ModelObject::new(Value::from(Point3::new(x, 0.0, 0.0)));
            object.set_text("use", "shop");
            object.set_text("path", path);
            Value::from(object)
        };
        let objects = [baked(1.0, "{0;2}"), baked(2.0, "{0;1}"), baked(3.0, "{nowhere}")];
        let found = Trial::of("Reinstate Tree").list(objects).run().outputs[0].clone();
        let paths: Vec<String> = found.paths().iter().map(ToString::to_string).collect();
        assert_eq!(paths, ["{0}", "{0;1}", "{0;2}"]);
        assert_eq!(found.item_count(), 3);
    }
}
