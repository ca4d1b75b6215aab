//! Heteroptera: small tools for numbers and lists. Names, ports and ids are those of public lists, which also tell what each does;
//! only a few of its components are here.

mod numbers;
mod trees;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Path, Tree, Value};
use katydid_geometry::{Interval, Vector3};

use crate::branches::{Branches, items};

/// The part that is common to all of some domains; null where there is none. Stands for Heteroptera's Intersect Domains.
#[component(
    "6dc51bda-1c9e-490f-8179-fcb0f9706a87",
    name = "Intersect Domains",
    nick = "Domain^",
    at = "Heteroptera/Maths"
)]
#[output("Domain", "D", "The common part.")]
fn intersect_domains(
    context: &Context<'_>,
    /// The domains.
    #[port("Domain", "D")]
    domains: List<Interval>,
) -> Option<Interval> {
    let sorted = |domain: Interval| (domain.start.min(domain.end), domain.start.max(domain.end));
    let common = domains.present().map(sorted).reduce(|a, b| (a.0.max(b.0), a.1.min(b.1)))?;
    if common.0 > common.1 {
        context.warn("The domains have no common part");
        return None;
    }
    Some(Interval::new(common.0, common.1))
}

/// The numbers of a set that are closest to a number, the closest first; of two as close the one that stands first. Stands for
/// Heteroptera's Closest Numbers.
#[component(
    "745ee08a-a3f9-4bbe-b604-7b765ddb7af1",
    name = "Closest Numbers",
    nick = "CN",
    at = "Heteroptera/Maths"
)]
#[output("Closest Numbers", "R", "The numbers.")]
fn closest_numbers(
    /// The set.
    #[port("Number Set", "D")]
    numbers: List<f64>,
    /// The number that they are close to.
    #[port("Search", "S")]
    to: f64,
    /// How many.
    #[port("Count", "N", default = 1)]
    count: i32,
) -> Vec<f64> {
    let mut numbers: Vec<f64> = numbers.present().filter(|number| !number.is_nan()).collect();
    numbers.sort_by(|a, b| (a - to).abs().total_cmp(&(b - to).abs()));
    numbers.truncate(usize::try_from(count).unwrap_or(0));
    numbers
}

/// The column and the row of a number, where numbers from 0 on fill rows of a size. Stands for Heteroptera's Numbers On Grid; that X
/// and Y are the steps of the vectors is our reading.
#[component(
    "68201ce2-db0e-472e-ad5c-ac232d382c85",
    name = "Numbers On Grid",
    nick = "GridNums",
    at = "Heteroptera/Maths"
)]
#[output("Column", "C", "The column, from 0.")]
#[output("Row", "R", "The row, from 0.")]
#[output("Vectors", "V", "X for each column, and Y for each row.")]
fn numbers_on_grid(
    /// The number.
    #[port("Number", "N")]
    number: i32,
    /// The numbers in a row, at least 1.
    #[port("Row Size", "S")]
    size: i32,
    /// The step from column to column.
    #[port("X", "X", default = 1.0)]
    x: f64,
    /// The step from row to row.
    #[port("Y", "Y", default = 1.0)]
    y: f64,
) -> Result<(i32, i32, Vector3), Message> {
    if size < 1 {
        return Err(Message::error(format!("Row Size is {size}: it must be at least 1")));
    }
    let (column, row) = (number.rem_euclid(size), number.div_euclid(size));
    Ok((column, row, Vector3::new(f64::from(column) * x, f64::from(row) * y, 0.0)))
}

/// Puts each item into the branch of a number. Stands for Heteroptera's Allocate By Index; "Preserve structure" of its menu is not
/// supported.
#[component(
    "6e93c41d-c3fd-405f-b072-3f0b3134321f",
    name = "Allocate By Index",
    nick = "i-Allocator",
    at = "Heteroptera/Utilities"
)]
#[output("Data", "A", "A branch for each number.", kind = Generic)]
fn allocate(
    context: &Context<'_>,
    /// The number of the branch of each item.
    #[port("Index", "i", kind = Integer)]
    numbers: &Tree,
    /// The items.
    #[port("Data", "A", kind = Generic)]
    data: &Tree,
) -> Result<Tree, Message> {
    if numbers.item_count() != data.item_count() {
        let (numbers, items) = (numbers.item_count(), data.item_count());
        return Err(Message::error(format!(
            "There are {numbers} numbers for {items} items: there must be as many"
        )));
    }
    context.items(data.item_count())?;
    let mut branches = Branches::default();
    for (number, item) in items(numbers).zip(items(data)) {
        if let Some(Value::Integer(number)) = number {
            branches.push(Path::from([number]), item);
        }
    }
    Ok(branches.tree())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::Interval;

    #[test]
    fn what_domains_have_in_common() {
        let of = |domains: &[(f64, f64)]| {
            let domains: Vec<Interval> = domains.iter().map(|(a, b)| Interval::new(*a, *b)).collect();
            Trial::of("Intersect Domains").list(domains).texts(0)
        };
        assert_eq!(of(&[(0.0, 5.0), (7.0, 3.0), (-1.0, 4.5)]), ["{0}: 3 To 4.5"]);
        assert_eq!(of(&[(0.0, 1.0), (2.0, 3.0)]), ["{0}: null"]);
        assert_eq!(of(&[(0.0, 1.0), (1.0, 3.0)]), ["{0}: 1 To 1"]);
    }

    #[test]
    fn numbers_by_closeness() {
        let closest =
            |count: i32| Trial::of("Closest Numbers").list([5.0, 1.0, 3.5, 2.5]).item(3.0).item(count);
        assert_eq!(closest(3).texts(0), ["{0;0}: 3.5, 2.5, 5"]);
        assert_eq!(closest(9).texts(0), ["{0;0}: 3.5, 2.5, 5, 1"]);
        assert_eq!(closest(-1).run().outputs[0].item_count(), 0);
    }

    #[test]
    fn rows_of_numbers() {
        let at = |number: i32, k: usize| {
            Trial::of("Numbers On Grid").item(number).item(4).item(2.0).item(10.0).texts(k)
        };
        assert_eq!((at(6, 0), at(6, 1)), (vec!["{0}: 2".to_owned()], vec!["{0}: 1".to_owned()]));
        assert_eq!(at(6, 2), ["{0}: {4, 10, 0}"]);
        assert_eq!((at(-1, 0), at(-1, 1)), (vec!["{0}: 3".to_owned()], vec!["{0}: -1".to_owned()]));
        assert!(
            Trial::of("Numbers On Grid").item(1).item(0).default().default().message().contains("at least 1")
        );
    }

    #[test]
    fn items_go_into_branches() {
        let trial = Trial::of("Allocate By Index").list([2, 0, 2]).list(["a", "b", "c"]);
        assert_eq!(trial.texts(0), ["{0}: b", "{2}: a, c"]);
        assert!(
            Trial::of("Allocate By Index")
                .list([2])
                .list(["a", "b"])
                .message()
                .contains("1 numbers for 2 items")
        );
    }
}
