//! Taking lists apart by a pattern, and putting them together.

use katydid_component::{Context, Each, List, ManyLists, Message, component};
use katydid_data::Value;

/// How often the budget is asked in a loop that makes items.
const ASK_EVERY: usize = 4096;

/// Sends the items of a list to two lists: to A where the pattern is true, to B where it is false.
///
/// The pattern is used over and over; a null in it counts as false. An empty pattern is an error.
#[component("d8332545-21b2-4716-96e3-8559a9876e17", name = "Dispatch", nick = "Dispatch", at = "Sets/List")]
#[output("List A", "A", "The items where the pattern is true.")]
#[output("List B", "B", "The items where the pattern is false.")]
fn dispatch(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// True for A, false for B.
    #[port("Dispatch pattern", "P", default = [true, false])]
    pattern: List<bool>,
) -> Result<(Vec<Option<Value>>, Vec<Option<Value>>), Message> {
    context.items(list.len())?;
    if pattern.is_empty() {
        return Err(Message::error("The pattern is empty"));
    }
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for (i, item) in list.iter().enumerate() {
        let side = if pattern.get(i % pattern.len()).unwrap_or(false) { &mut a } else { &mut b };
        side.push(item);
    }
    Ok((a, b))
}

/// Sends each item of a list to the output whose number stands in the pattern.
///
/// Every output keeps the length of the list, with nulls in the places of what went elsewhere. The pattern is
/// used over and over; an item whose number has no output goes nowhere.
#[component("3249222f-f536-467a-89f4-f0353fba455a", name = "Sift Pattern", nick = "Sift", at = "Sets/List")]
#[output("Output 0", "0", "The items of this number.")]
fn sift_pattern(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// The number of an output for each item; the first is 0.
    #[port("Sift Pattern", "P", default = [0, 1, 0, 1])]
    pattern: List<i32>,
) -> Result<Each<Vec<Option<Value>>>, Message> {
    let outputs = context.output_count();
    context.items(list.len().saturating_mul(outputs))?;
    if pattern.is_empty() {
        return Err(Message::error("The pattern is empty"));
    }
    let mut sifted = vec![vec![None; list.len()]; outputs];
    for (i, item) in list.iter().enumerate() {
        let output = pattern.get(i % pattern.len()).and_then(|k| usize::try_from(k).ok());
        let target = output.and_then(|k| sifted.get_mut(k)).and_then(|list| list.get_mut(i));
        if let Some(target) = target {
            *target = item;
        }
    }
    Ok(Each(sifted))
}

/// Picks the items of a list from several streams: at each place the pattern says which stream gives its item
/// of that place.
///
/// The result is as long as the pattern. A stream that is not there or too short gives a null.
#[component(
    "03b801eb-87cd-476a-a591-257fe5d5bf0f",
    name = "Pick'n'Choose",
    nick = "P'n'C",
    at = "Sets/List",
    also("4356ef8f-0ca1-4632-9c39-9e6dcd2b9496")
)]
#[output("Result", "R", "The items picked.")]
fn pick_n_choose(
    context: &Context<'_>,
    /// The number of a stream for each place; the first is 0.
    #[port("Pattern", "P", default = [0, 1])]
    pattern: List<i32>,
    /// A stream to pick from.
    #[port("Stream 0", "0", optional)]
    streams: ManyLists<Value>,
) -> Result<Vec<Option<Value>>, Message> {
    context.items(pattern.len())?;
    let pick = |(i, k): (usize, Option<i32>)| streams.get(usize::try_from(k?).ok()?)?.get(i);
    Ok(pattern.iter().enumerate().map(pick).collect())
}

/// Weaves several streams into one list: the pattern says, over and over, which stream gives its next item.
///
/// A stream that is used up is passed over until all streams of the pattern are; with the setting for gaps it
/// gives nulls instead.
#[component(
    "50faccbd-9c92-4175-a5fa-d65e36013db6",
    name = "Weave",
    nick = "Weave",
    at = "Sets/List",
    also("160c1df2-e2e8-48e5-b538-f2d6981007e3")
)]
#[output("Weave", "W", "The woven list.")]
fn weave(
    context: &Context<'_>,
    /// The numbers of streams; the first is 0.
    #[port("Pattern", "P", default = [0, 1])]
    pattern: List<i32>,
    /// A stream to weave in.
    #[port("Stream 0", "0")]
    streams: ManyLists<Value>,
) -> Result<Vec<Option<Value>>, Message> {
    let gaps = context.settings().bool("NullGaps").unwrap_or(false);
    let stream = |k: i32| usize::try_from(k).ok().filter(|&k| k < streams.len());
    let mut pattern: Vec<usize> = pattern.present().filter_map(stream).collect();
    let mut left: Vec<usize> = streams.iter().map(List::len).collect();
    // The streams of the pattern that still have items.
    let mut open = (0..streams.len()).filter(|k| left.get(*k) > Some(&0) && pattern.contains(k)).count();
    if !gaps {
        pattern.retain(|k| left.get(*k) > Some(&0));
    }
    let mut woven = Vec::new();
    let mut at = 0;
    while open > 0 {
        if woven.len() % ASK_EVERY == 0 {
            context.items(woven.len() + ASK_EVERY)?;
        }
        let Some((&k, list)) = pattern.get(at).and_then(|k| Some((k, streams.get(*k)?))) else { break };
        at = if at + 1 == pattern.len() { 0 } else { at + 1 };
        let Some(rest) = left.get_mut(k) else { break };
        if *rest == 0 {
            woven.push(None);
            continue;
        }
        woven.push(list.get(list.len() - *rest));
        *rest -= 1;
        if *rest == 0 {
            open -= 1;
            if !gaps {
                // Going on at the same place of the pattern without that stream.
                let before = pattern.iter().take(at).filter(|&&j| j != k).count();
                pattern.retain(|&j| j != k);
                at = if before < pattern.len() { before } else { 0 };
            }
        }
    }
    Ok(woven)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn dispatch_repeats_its_pattern() {
        let list = || Trial::of("Dispatch").list([0, 1, 2, 3, 4]);
        assert_eq!(list().texts(0), ["{0}: 0, 2, 4"]);
        assert_eq!(list().list(["1", "0", "0"]).texts(1), ["{0}: 1, 2, 4"]);
        assert_eq!(list().gaps([Some(true), None]).texts(0), ["{0}: 0, 2, 4"]);
        assert_eq!(list().item(true).texts(1), ["{0}:"]);
        assert_eq!(list().list::<bool>([]).message(), "The pattern is empty");
    }

    #[test]
    fn sifting_and_combining_undo_each_other() {
        let sift = |k: usize| {
            Trial::of("Sift Pattern").list(["a", "b", "c", "d"]).list([0, 1, 5]).outputs(2).texts(k)
        };
        assert_eq!(sift(0), ["{0}: a, null, null, d"]);
        assert_eq!(sift(1), ["{0}: null, b, null, null"]);
        assert_eq!(Trial::of("Sift Pattern").list([1, 2, 3]).outputs(2).texts(1), ["{0}: null, 2, null"]);
    }

    #[test]
    fn pick_n_choose_takes_the_place_of_each_stream() {
        let trial =
            Trial::of("Pick'n'Choose").list([0, 1, 1, 7, 0]).list(["a", "b", "c", "d"]).list(["A", "B", "C"]);
        assert_eq!(trial.texts(0), ["{0}: a, B, C, null, null"]);
    }

    #[test]
    fn weaving_passes_over_what_is_used_up() {
        let weave = |pattern: &[i32], a: &[&str], b: &[&str]| {
            let lists = Trial::of("Weave").list(pattern.iter().copied());
            lists.list(a.iter().copied()).list(b.iter().copied())
        };
        assert_eq!(weave(&[0, 1], &["1", "2"], &["A", "B"]).texts(0), ["{0}: 1, A, 2, B"]);
        let uneven = weave(&[0, 1, 1], &["1", "2", "3", "4"], &["A", "B", "C"]);
        assert_eq!(uneven.texts(0), ["{0}: 1, A, B, 2, C, 3, 4"]);
        let gaps = weave(&[0, 1, 1], &["1", "2", "3"], &["A", "B", "C"]).setting("NullGaps", true);
        assert_eq!(gaps.texts(0), ["{0}: 1, A, B, 2, C, null, 3"]);
        assert_eq!(weave(&[7, -1], &["1"], &["A"]).texts(0), ["{0}:"]);
        assert_eq!(weave(&[1], &["1"], &["A"]).texts(0), ["{0}: A"]);
        assert_eq!(weave(&[], &["1"], &["A"]).texts(0), ["{0}:"]);
    }

    #[test]
    fn long_patterns_of_used_up_streams_cost_nothing() {
        let pattern = (0..200_000).map(|i| i32::from(i == 0));
        let woven = Trial::of("Weave").list(pattern).item("a").list((0..200_000).map(f64::from)).run();
        assert_eq!(woven.outputs[0].item_count(), 200_001);
    }
}
