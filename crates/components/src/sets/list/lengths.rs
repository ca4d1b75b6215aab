//! Making lists equally long, and pairing every item with every other.

use katydid_component::{Context, Each, ManyLists, Message, component};
use katydid_data::{Column, Value};

/// How often the budget is asked in a loop that makes items.
const ASK_EVERY: usize = 4096;

/// The length of each list; `None` for an input without data, which does not count.
fn lengths(context: &Context<'_>, lists: &ManyLists<'_, Value>) -> Vec<Option<usize>> {
    lists.iter().enumerate().map(|(k, list)| context.has_data(k).then(|| list.len())).collect()
}

/// `target` places of a list of `n` items, spread evenly from the first to the last.
fn spread(n: usize, target: usize) -> Vec<usize> {
    if target <= 1 {
        return vec![0; target];
    }
    let step = n.saturating_sub(1) as f64 / (target - 1) as f64;
    (0..target).map(|k| (k as f64 * step).round_ties_even() as usize).collect()
}

/// The lists at the places that `choose` gives for their lengths.
fn resized(
    context: &Context<'_>,
    lists: &ManyLists<'_, Value>,
    target: usize,
    choose: impl Fn(usize) -> Vec<usize>,
) -> Result<Each<Column>, Message> {
    context.items(target.saturating_mul(lists.len()))?;
    let lists = lists.iter().enumerate().map(|(k, list)| match list.len() {
        _ if !context.has_data(k) => Column::nulls(0),
        0 => Column::nulls(target),
        n => list.gather(&choose(n)),
    });
    Ok(Each(lists.collect()))
}

/// Makes all lists as long as the shortest.
///
/// A setting says what is left out: items at the end, items at the start, or items in between. Inputs without
/// data do not count.
#[component("5a13ec19-e4e9-43da-bf65-f93025fa87ca", name = "Shortest List", nick = "Short", at = "Sets/List")]
#[output("List (A)", "A", "The shortened list.")]
fn shortest_list(
    context: &Context<'_>,
    /// A list.
    #[port("List (A)", "A", optional)]
    lists: ManyLists<Value>,
) -> Result<Each<Column>, Message> {
    let target = lengths(context, &lists).into_iter().flatten().min().unwrap_or(0);
    let mode = context.settings().i32("TrimMode").unwrap_or(2);
    resized(context, &lists, target, |n| match mode {
        1 => (n - target..n).collect(),
        3 => spread(n, target),
        _ => (0..target).collect(),
    })
}

/// Makes all lists as long as the longest.
///
/// A setting says what fills the shorter ones: the first item again, the last item again, every item about
/// equally often, the list over and over, or the list forwards and backwards. An empty list is filled with
/// nulls. Inputs without data do not count.
#[component("8440fd1b-b6e0-4bdb-aa93-4ec295c213e9", name = "Longest List", nick = "Long", at = "Sets/List")]
#[output("List (A)", "A", "The lengthened list.")]
fn longest_list(
    context: &Context<'_>,
    /// A list.
    #[port("List (A)", "A", optional)]
    lists: ManyLists<Value>,
) -> Result<Each<Column>, Message> {
    let target = lengths(context, &lists).into_iter().flatten().max().unwrap_or(0);
    let mode = context.settings().i32("PaddingMode").unwrap_or(2);
    resized(context, &lists, target, |n| match mode {
        1 => (0..target).map(|i| i.saturating_sub(target - n)).collect(),
        3 => spread(n, target),
        4 => (0..target).map(|i| i % n).collect(),
        5 => (0..target)
            .map(|i| match i % (2 * n) {
                i if i < n => i,
                i => 2 * n - 1 - i,
            })
            .collect(),
        _ => (0..target).map(|i| i.min(n - 1)).collect(),
    })
}

/// Which combinations of places are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cross {
    /// All.
    Holistic,
    /// All but those where all places are equal.
    Diagonal,
    /// All but those where two places are equal.
    Coincident,
    /// Each place is at least the next list's.
    Lower,
    /// Each place is larger than the next list's.
    LowerStrict,
    /// Each place is at most the next list's.
    Upper,
    /// Each place is smaller than the next list's.
    UpperStrict,
}

impl Cross {
    fn of(code: i32) -> Self {
        match code {
            2 => Self::Diagonal,
            3 => Self::Coincident,
            4 => Self::Lower,
            5 => Self::LowerStrict,
            6 => Self::Upper,
            7 => Self::UpperStrict,
            _ => Self::Holistic,
        }
    }

    /// The places a list of `n` items may take beside the place of the next list.
    fn range(self, n: usize, next: Option<usize>) -> std::ops::Range<usize> {
        let Some(next) = next else { return 0..n };
        match self {
            Self::Lower => next..n,
            Self::LowerStrict => next + 1..n,
            Self::Upper => 0..n.min(next + 1),
            Self::UpperStrict => 0..n.min(next),
            Self::Holistic | Self::Diagonal | Self::Coincident => 0..n,
        }
    }

    /// Whether places that follow the ranges are wanted; `rest` are those of all lists behind this one.
    fn accepts(self, place: usize, rest: &[usize], first: bool) -> bool {
        match self {
            Self::Coincident => !rest.contains(&place),
            Self::Diagonal => !first || rest.is_empty() || rest.iter().any(|&other| other != place),
            _ => true,
        }
    }
}

/// Calls `give` for each combination of places, those of the first list running fastest.
fn combinations(
    context: &Context<'_>,
    mode: Cross,
    lengths: &[usize],
    mut give: impl FnMut(&[usize]) -> Result<(), Message>,
) -> Result<(), Message> {
    let Some(last) = lengths.len().checked_sub(1) else { return Ok(()) };
    let mut places = vec![0; lengths.len()];
    let mut ends = vec![0; lengths.len()];
    let enter = |k: usize, places: &mut [usize], ends: &mut [usize]| {
        let next = places.get(k + 1).copied().filter(|_| k < last);
        let range = mode.range(lengths.get(k).copied().unwrap_or(0), next);
        places[k] = range.start;
        ends[k] = range.end;
    };
    let mut k = last;
    enter(k, &mut places, &mut ends);
    for step in 1_usize.. {
        if step % (1 << 16) == 0 {
            context.check()?;
        }
        if places[k] >= ends[k] {
            if k == last {
                break;
            }
            k += 1;
            places[k] += 1;
        } else if !mode.accepts(places[k], &places[k + 1..], k == 0) {
            places[k] += 1;
        } else if k == 0 {
            give(&places)?;
            places[0] += 1;
        } else {
            k -= 1;
            enter(k, &mut places, &mut ends);
        }
    }
    Ok(())
}

/// Pairs every item of a list with every item of the others; the first list runs fastest.
///
/// A setting leaves combinations out: those where all places are equal, where any two are equal, or those below
/// or above the diagonal. Inputs without data do not count.
#[component(
    "36947590-f0cb-4807-a8f9-9c90c9b20621",
    name = "Cross Reference",
    nick = "CrossRef",
    at = "Sets/List"
)]
#[output("List (A)", "A", "This list's item of each combination.")]
fn cross_reference(
    context: &Context<'_>,
    /// A list.
    #[port("List (A)", "A", optional)]
    lists: ManyLists<Value>,
) -> Result<Each<Column>, Message> {
    let mode = Cross::of(context.settings().i32("CrossMode").unwrap_or(1));
    let all = lengths(context, &lists);
    let wired: Vec<usize> = (0..all.len()).filter(|&k| all.get(k).is_some_and(Option::is_some)).collect();
    let lengths: Vec<usize> = all.into_iter().flatten().collect();
    let mut places: Vec<Vec<usize>> = vec![Vec::new(); lengths.len()];
    let mut count = 0_usize;
    combinations(context, mode, &lengths, |combination| {
        if count.is_multiple_of(ASK_EVERY) {
            context.items((count + ASK_EVERY).saturating_mul(lengths.len()))?;
        }
        count += 1;
        for (list, &place) in places.iter_mut().zip(combination) {
            list.push(place);
        }
        Ok(())
    })?;
    let mut result = vec![Column::nulls(0); lists.len()];
    for (k, places) in wired.into_iter().zip(places) {
        if let (Some(target), Some(list)) = (result.get_mut(k), lists.get(k)) {
            *target = list.gather(&places);
        }
    }
    Ok(Each(result))
}

#[cfg(test)]
mod tests {
    use katydid_component::{Limits, testing::Trial};
    use katydid_data::Tree;

    fn two(name: &str, setting: &str, mode: i32) -> (String, String) {
        let trial = || {
            let lists = Trial::of(name).list(["A", "B", "C", "D", "E"]).list(["X", "Y", "Z"]);
            lists.outputs(2).setting(setting, mode)
        };
        (trial().texts(0).concat(), trial().texts(1).concat())
    }

    #[test]
    fn shortest_leaves_out_by_mode() {
        assert_eq!(two("Shortest List", "TrimMode", 1), ("{0}: C, D, E".into(), "{0}: X, Y, Z".into()));
        assert_eq!(two("Shortest List", "TrimMode", 2), ("{0}: A, B, C".into(), "{0}: X, Y, Z".into()));
        assert_eq!(two("Shortest List", "TrimMode", 3), ("{0}: A, C, E".into(), "{0}: X, Y, Z".into()));
        let unwired = Trial::of("Shortest List").list(["A", "B"]).tree(Tree::empty()).outputs(2).run();
        assert_eq!(unwired.outputs[0].item_count(), 2);
        assert_eq!(unwired.outputs[1].item_count(), 0);
    }

    #[test]
    fn longest_fills_by_mode() {
        let b = |mode: i32| two("Longest List", "PaddingMode", mode).1;
        assert_eq!(b(1), "{0}: X, X, X, Y, Z");
        assert_eq!(b(2), "{0}: X, Y, Z, Z, Z");
        assert_eq!(b(3), "{0}: X, X, Y, Z, Z");
        assert_eq!(b(4), "{0}: X, Y, Z, X, Y");
        assert_eq!(b(5), "{0}: X, Y, Z, Z, Y");
        let empty = Trial::of("Longest List").list(["A", "B"]).list::<f64>([]).outputs(2);
        assert_eq!(empty.texts(1), ["{0}: null, null"]);
    }

    fn crossed(mode: i32) -> [String; 2] {
        [0, 1].map(|k| {
            let lists = Trial::of("Cross Reference").list(["A", "B", "C"]).list(["X", "Y", "Z"]);
            lists.outputs(2).setting("CrossMode", mode).texts(k).concat()
        })
    }

    #[test]
    fn crossing_by_mode() {
        assert_eq!(crossed(1)[0], "{0}: A, B, C, A, B, C, A, B, C");
        assert_eq!(crossed(1)[1], "{0}: X, X, X, Y, Y, Y, Z, Z, Z");
        for mode in [2, 3] {
            assert_eq!(crossed(mode), ["{0}: B, C, A, C, A, B", "{0}: X, X, Y, Y, Z, Z"]);
        }
        assert_eq!(crossed(4), ["{0}: A, B, C, B, C, C", "{0}: X, X, X, Y, Y, Z"]);
        assert_eq!(crossed(5), ["{0}: B, C, C", "{0}: X, X, Y"]);
        assert_eq!(crossed(6), ["{0}: A, A, B, A, B, C", "{0}: X, Y, Y, Z, Z, Z"]);
        assert_eq!(crossed(7), ["{0}: A, A, B", "{0}: Y, Z, Z"]);
    }

    #[test]
    fn crossing_three_lists() {
        let count = |mode: i32| {
            let lists = Trial::of("Cross Reference").list([0, 1, 2]).list([0, 1, 2]).list([0, 1, 2]);
            lists.outputs(3).setting("CrossMode", mode).run().outputs[2].item_count()
        };
        assert_eq!([1, 2, 3, 4, 5, 6, 7].map(count), [27, 24, 6, 10, 1, 10, 1]);
        let one =
            Trial::of("Cross Reference").list([1, 2]).tree(Tree::empty()).outputs(2).setting("CrossMode", 2);
        assert_eq!(one.texts(0), ["{0}: 1, 2"]);
    }

    #[test]
    fn too_many_combinations_are_a_message() {
        let long = || (0..100_000).map(f64::from);
        let trial = Trial::of("Cross Reference").list(long()).list(long()).outputs(2);
        assert!(
            trial.limits(Limits { items: 100_000, ..Limits::default() }).message().contains("100000 items")
        );
    }
}
