//! Leaving items out of a list.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;

use crate::sets::place;

/// Keeps the items of a list where the pattern is true.
///
/// The pattern is used over and over; a null in it counts as false. An empty pattern is an error.
#[component(
    "008e9a6f-478a-4813-8c8a-546273bc3a6b",
    name = "Cull Pattern",
    nick = "Cull",
    at = "Sets/Sequence"
)]
#[output("List", "L", "The items kept.")]
fn cull_pattern(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// True keeps an item, false leaves it out.
    #[port("Cull Pattern", "P", default = [false, false, true, true])]
    pattern: List<bool>,
) -> Result<Vec<Option<Value>>, Message> {
    context.items(list.len())?;
    if pattern.is_empty() {
        context.warn("The pattern is empty: nothing says which items to keep");
        return Ok(Vec::new());
    }
    let pattern: Vec<bool> = pattern.iter().map(|keep| keep.unwrap_or(false)).collect();
    Ok(list.iter().zip(pattern.iter().cycle()).filter_map(|(item, &keep)| keep.then_some(item)).collect())
}

/// Leaves out the items at given indices.
///
/// The indices count in the list as it comes in, so naming one twice changes nothing. With Wrap they count round
/// and round; without it indices outside do nothing.
#[component(
    "501aecbb-c191-4d13-83d6-7ee32445ac50",
    name = "Cull Index",
    nick = "Cull i",
    at = "Sets/Sequence",
    also("6568e019-f59c-4984-84d6-96bd5bfbe9e7")
)]
#[output("List", "L", "The other items.")]
fn cull_index(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// Which items to leave out; the first is 0.
    #[port("Indices", "I", default = 0)]
    indices: List<i32>,
    /// Count round and round.
    #[port("Wrap", "W", default = true)]
    wrap: bool,
) -> Result<Vec<Option<Value>>, Message> {
    context.items(list.len())?;
    let mut keep = vec![true; list.len()];
    for i in indices.present() {
        if let Some(kept) = place(i.into(), list.len(), wrap).and_then(|at| keep.get_mut(at)) {
            *kept = false;
        }
    }
    Ok(list.iter().zip(keep).filter_map(|(item, keep)| keep.then_some(item)).collect())
}

/// Leaves out every Nth item: with 3 the third, the sixth and so on.
#[component("932b9817-fcc6-4ac3-b5fd-c0e8eeadc53f", name = "Cull Nth", nick = "CullN", at = "Sets/Sequence")]
#[output("List", "L", "The other items.")]
fn cull_nth(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// Every how many items one is left out; 1 leaves none.
    #[port("Cull frequency", "N")]
    frequency: i32,
) -> Result<Vec<Option<Value>>, Message> {
    context.items(list.len())?;
    let n = usize::try_from(frequency).ok().filter(|&n| n > 0);
    let n = n.ok_or_else(|| Message::error(format!("The frequency is not 1 or more: {frequency}")))?;
    Ok(list.iter().enumerate().filter_map(|(i, item)| ((i + 1) % n != 0).then_some(item)).collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn patterns_repeat() {
        let list = || Trial::of("Cull Pattern").list([0, 1, 2, 3, 4, 5]);
        assert_eq!(list().list(["1", "0", "0"]).texts(0), ["{0}: 0, 3"]);
        assert_eq!(list().texts(0), ["{0}: 2, 3"]);
        assert_eq!(list().list([0.0, 2.5]).texts(0), ["{0}: 1, 3, 5"]);
        // A branch without a pattern keeps none; the others are culled as ever.
        assert_eq!(list().list::<bool>([]).texts(0), ["{0}:"]);
        assert_eq!(
            list().list::<bool>([]).message(),
            "The pattern is empty: nothing says which items to keep"
        );
        let data = [("{0}", ["a", "b"]), ("{1}", ["c", "d"])];
        let mut patterns = katydid_data::TreeBuilder::<bool>::new();
        patterns.branch([0].into());
        patterns.branch([1].into());
        [true, false].into_iter().for_each(|keep| patterns.push(Some(keep)));
        let both = Trial::of("Cull Pattern").branches(data).tree(patterns.finish());
        assert_eq!(both.texts(0), ["{0}:", "{1}: c"]);
    }

    #[test]
    fn indices_count_in_the_original() {
        let list = || Trial::of("Cull Index").list([0, 1, 2, 3, 4, 5]);
        assert_eq!(list().list([1, 3, 3, -1]).texts(0), ["{0;0}: 0, 2, 4"]);
        assert_eq!(list().list([1, 6, -1]).item(false).texts(0), ["{0;0}: 0, 2, 3, 4, 5"]);
        assert_eq!(list().texts(0), ["{0;0}: 1, 2, 3, 4, 5"]);
        assert_eq!(Trial::of("Cull Index").list::<f64>([]).item(2).texts(0), ["{0;0}:"]);
    }

    #[test]
    fn every_nth_goes() {
        let nth = |n: i32| Trial::of("Cull Nth").list([0, 1, 2, 3, 4, 5, 6]).item(n);
        assert_eq!(nth(3).texts(0), ["{0;0}: 0, 1, 3, 4, 6"]);
        assert_eq!(nth(1).texts(0), ["{0;0}:"]);
        assert_eq!(nth(0).message(), "The frequency is not 1 or more: 0");
    }
}
