//! Paths, and places by keys and values.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Path, Tree, Value};
use katydid_geometry::Interval;

use crate::branches::{Branches, items};

/// A path with one number more behind its others. Stands for Heteroptera's Extend Path; the choice of its menu to put the number first
/// is not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd411",
    name = "Extend Path",
    nick = "ExtendPath",
    at = "Heteroptera/Utilities"
)]
#[output("Path", "P", "The longer path.")]
fn extend_path(
    /// The path.
    #[port("Path", "P")]
    path: Path,
    /// The number.
    #[port("Element", "E", default = 0)]
    element: i32,
) -> Path {
    let mut numbers = path.elements().to_vec();
    numbers.push(element);
    Path::from(numbers.as_slice())
}

/// A tree of empty branches. Stands for Heteroptera's Empty Structure.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd412",
    name = "Empty Structure",
    nick = "O-Tree",
    at = "Heteroptera/Utilities"
)]
#[output("Tree", "T", "A branch without items for each path.", kind = Generic)]
fn empty_structure(
    context: &Context<'_>,
    /// The paths.
    #[port("Paths", "P", kind = Path)]
    paths: &Tree,
) -> Result<Tree, Message> {
    context.items(paths.item_count())?;
    let mut branches = Branches::default();
    for path in items(paths) {
        if let Some(Value::Path(path)) = path {
            branches.extend(path, []);
        }
    }
    Ok(branches.tree())
}

/// The parts of a domain, and for each part the places of the values in it.
fn allocated(
    context: &Context<'_>,
    number: i32,
    domain: Option<Interval>,
    values: &Tree,
) -> Result<(Vec<Interval>, Tree), Message> {
    let parts = usize::try_from(number).ok().filter(|parts| *parts > 0);
    let Some(parts) = parts else {
        return Err(Message::error(format!("The number of branches is {number}: it must be at least 1")));
    };
    context.items(parts.saturating_add(values.item_count()))?;
    let number = |item| match item {
        Some(Value::Number(number)) if f64::is_finite(number) => Some(number),
        _ => None,
    };
    let values: Vec<Option<f64>> = items(values).map(number).collect();
    let given = values.iter().flatten().map(|value| Interval::new(*value, *value));
    let range = domain.map(Interval::ordered).or_else(|| given.reduce(Interval::union));
    let Some(range) = range else { return Ok((Vec::new(), Tree::empty())) };
    let at = |place: usize| range.at(place as f64 / parts as f64);
    let intervals = (0..parts).map(|place| Interval::new(at(place), at(place + 1))).collect();
    let mut branches = Branches::default();
    let mut outside = 0_usize;
    for place in 0..parts {
        branches.extend(path(place), []);
    }
    for (place, value) in values.into_iter().enumerate() {
        let Some(value) = value.filter(|value| range.contains(*value)) else {
            outside += 1;
            continue;
        };
        // The end of the range belongs to the last part; a range without length is one part.
        let part = if range.is_singleton() { 0.0 } else { range.normalized(value) * parts as f64 };
        let part = (part as usize).min(parts - 1);
        branches.push(path(part), Some(Value::Integer(i32::try_from(place).unwrap_or(i32::MAX))));
    }
    if outside > 0 {
        context.warn(format!("Values outside the domain are left out: {outside}"));
    }
    Ok((intervals, branches.tree()))
}

fn path(place: usize) -> Path {
    Path::from([i32::try_from(place).unwrap_or(i32::MAX)])
}

/// The two components are one, under two names.
macro_rules! allocate {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "Heteroptera/Utilities")]
        #[output("Intervals", "I", "The parts.")]
        #[output("Index Tree", "i", "A branch for each part: the places of the values in it.", kind = Integer)]
        fn $function(
            context: &Context<'_>,
            /// The number of parts, at least 1.
            #[port("Number", "N", default = 10)]
            number: i32,
            /// The domain; without one that of the values.
            #[port("Domain", "D", optional)]
            domain: Option<Interval>,
            /// The values, one branch after the other.
            #[port("Value", "V", kind = Number)]
            values: &Tree,
        ) -> Result<(Vec<Interval>, Tree), Message> {
            allocated(context, number, domain, values)
        }
    };
}

allocate!(
    /// Divides a domain into parts, and puts the place of each value into the branch of the part that it lies in. Stands for Heteroptera's
    /// Allocate By Value; data that it moves along, and "Preserve structure" of its menu, are not supported: List Item with the places
    /// gives the data.
    allocate_by_value, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd413", "Allocate By Value", "Value-Allocator"
);

allocate!(
    /// Divides a domain into parts, and puts the place of each value into the branch of the part that it lies in. Stands for Heteroptera's
    /// Allocate By Domain; data that it moves along, and "Preserve structure" of its menu, are not supported: List Item with the places
    /// gives the data.
    allocate_by_domain, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd414", "Allocate By Domain", "Domain-Allocator"
);

/// The different keys of a list, in the order in which they are met. Stands for Heteroptera's Allocate By Keys, whose branches have them
/// as names; data that it moves along, and "Preserve structure" of its menu, are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd415",
    name = "Allocate By Keys",
    nick = "Key-Allocator",
    at = "Heteroptera/Utilities"
)]
#[output("Branch Name", "S", "The keys, each once.")]
fn allocate_by_keys(
    context: &Context<'_>,
    /// The keys.
    #[port("Key Tag", "K")]
    keys: List<Shared<str>>,
) -> Result<Vec<Shared<str>>, Message> {
    context.items(keys.len())?;
    let mut known = std::collections::HashSet::new();
    Ok(keys.present().filter(|key| known.insert(key.clone())).collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Path;
    use katydid_geometry::Interval;

    fn path(text: &str) -> Path {
        text.parse().unwrap()
    }

    #[test]
    fn paths_and_empty_branches() {
        assert_eq!(Trial::of("Extend Path").item(path("{0;2}")).item(7).texts(0), ["{0}: {0;2;7}"]);
        let empty = Trial::of("Empty Structure").list([path("{3}"), path("{0;1}"), path("{3}")]);
        assert_eq!(empty.texts(0), ["{0;1}:", "{3}:"]);
    }

    #[test]
    fn values_go_to_the_parts_of_a_domain() {
        for name in ["Allocate By Value", "Allocate By Domain"] {
            let trial = |parts: i32| Trial::of(name).item(parts);
            let values = [0.0, 10.0, 4.9, 5.0];
            assert_eq!(trial(2).default().list(values).texts(1), ["{0}: 0, 2", "{1}: 1, 3"]);
            assert_eq!(trial(2).default().list(values).texts(0), ["{0;0}: 0 To 5, 5 To 10"]);
            let within = || trial(2).item(Interval::new(4.0, 0.0)).list(values);
            assert_eq!(within().texts(1), ["{0}: 0", "{1}:"]);
            assert_eq!(within().message(), "Values outside the domain are left out: 3");
            assert_eq!(trial(3).default().list([2.0, 2.0]).texts(1), ["{0}: 0, 1", "{1}:", "{2}:"]);
            let none = trial(0).default().list(values).message();
            assert_eq!(none, "The number of branches is 0: it must be at least 1");
        }
    }

    #[test]
    fn keys_each_once() {
        let keys = Trial::of("Allocate By Keys").list(["b", "a", "b", "c", "a"]);
        assert_eq!(keys.texts(0), ["{0}: b, a, c"]);
    }
}
