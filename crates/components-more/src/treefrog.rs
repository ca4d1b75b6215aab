//! TreeFrog: paths given to data. Names and ports are those of public lists, which also tell what each does.

use katydid_component::{Context, Message, component};
use katydid_data::{Path, Tree, Value};

use crate::branches::{Branches, items};

/// Not as many items as there should be.
pub(crate) fn uneven(what: &str, found: usize, wanted: usize) -> Message {
    Message::error(format!("There are {found} {what} for {wanted} items: there must be as many"))
}

/// Puts each item of a list at a path of its own. Stands for TreeFrog's Assign Paths.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2d01",
    name = "Assign Paths",
    nick = "Assign Paths",
    at = "TreeFrog/TreeFrog"
)]
#[output("Restructured Data", "data", "The items at their paths.", kind = Generic)]
fn assign(
    context: &Context<'_>,
    /// The items.
    #[port("Input Data", "data", kind = Generic)]
    data: &Tree,
    /// A path for each.
    #[port("Paths to Assign", "paths", kind = Path)]
    paths: &Tree,
) -> Result<Tree, Message> {
    if paths.item_count() != data.item_count() {
        return Err(uneven("paths", paths.item_count(), data.item_count()));
    }
    context.items(data.item_count())?;
    let mut branches = Branches::default();
    for (item, path) in items(data).zip(items(paths)) {
        let Some(Value::Path(path)) = path else {
            context.warn("Items without a path are left out");
            continue;
        };
        branches.push(path, item);
    }
    Ok(branches.tree())
}

/// Puts a number behind the path of each item. Stands for TreeFrog's Graft By Data.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2d02",
    name = "Graft By Data",
    nick = "GraftByData",
    at = "TreeFrog/TreeFrog"
)]
#[output("Restructured Data", "data", "The items, a number deeper.", kind = Generic)]
fn graft(
    context: &Context<'_>,
    /// The items.
    #[port("Input Data", "data", kind = Generic)]
    data: &Tree,
    /// A number for each, in the same structure.
    #[port("Paths to Assign", "paths", kind = Integer)]
    numbers: &Tree,
) -> Result<Tree, Message> {
    if data.branch_count() != numbers.branch_count() {
        return Err(Message::error("The numbers have not the structure of the data"));
    }
    context.items(data.item_count())?;
    let mut branches = Branches::default();
    for (things, numbers) in data.branches().zip(numbers.branches()) {
        if things.len() != numbers.len() {
            return Err(uneven("numbers", numbers.len(), things.len()));
        }
        for (item, number) in things.iter().zip(numbers.iter()) {
            let Some(Value::Integer(number)) = number else {
                context.warn("Items without a number are left out");
                continue;
            };
            let mut path = things.path().elements().to_vec();
            path.push(number);
            branches.push(Path::from(path.as_slice()), item);
        }
    }
    Ok(branches.tree())
}

/// Gives a list the structure of a tree with as many items. Stands for TreeFrog's Match Paths.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2d03",
    name = "Match Paths",
    nick = "Match Paths",
    at = "TreeFrog/TreeFrog"
)]
#[output("Restructured Data", "data", "The items in the structure of the tree.", kind = Generic)]
#[output("Index Map", "map", "The place of each in the list.", kind = Integer)]
fn match_paths(
    context: &Context<'_>,
    /// The items.
    #[port("Target Data", "T", kind = Generic)]
    data: &Tree,
    /// The tree.
    #[port("Source Data", "S", kind = Generic)]
    source: &Tree,
) -> Result<(Tree, Tree), Message> {
    let count = data.item_count();
    if source.item_count() != count {
        return Err(uneven("items in the tree", source.item_count(), count));
    }
    context.items(count.saturating_mul(2))?;
    let places: Vec<Value> =
        (0..count).map(|at| Value::Integer(i32::try_from(at).unwrap_or(i32::MAX))).collect();
    let places = katydid_data::Column::of_values(places, None);
    Ok((source.with_column(data.column().clone()), source.with_column(places)))
}

/// The path of each item, in its place. Stands for TreeFrog's Path Description.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2d04",
    name = "Path Description",
    nick = "pd",
    at = "TreeFrog/TreeFrog"
)]
#[output("Paths", "p", "The path of each item.", kind = Path)]
fn describe(
    context: &Context<'_>,
    /// The items.
    #[port("Data", "d", kind = Generic)]
    data: &Tree,
) -> Result<Tree, Message> {
    context.items(data.item_count())?;
    let paths = |branch: katydid_data::Branch<'_>| vec![Value::Path(branch.path().clone()); branch.len()];
    let column = katydid_data::Column::of_values(data.branches().flat_map(paths).collect(), None);
    Ok(data.with_column(column))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn items_go_where_their_paths_say() {
        let paths = ["{1;2}", "{0}", "{1;2}"].map(|path| path.parse::<katydid_data::Path>().unwrap());
        let typed = Trial::of("Assign Paths").list(["a", "b", "c"]).list(paths).texts(0);
        assert_eq!(typed, ["{0}: b", "{1;2}: a, c"]);
        let uneven = Trial::of("Assign Paths")
            .list(["a"])
            .list([katydid_data::Path::zero(), katydid_data::Path::zero()]);
        assert!(uneven.message().contains("2 paths for 1 items"));
    }

    #[test]
    fn numbers_stand_behind_paths() {
        let data = [("{0}", ["a", "b"]), ("{3}", ["c", "d"])];
        let grafted = Trial::of("Graft By Data").branches(data).branches([("{0}", [5, 0]), ("{3}", [1, 1])]);
        assert_eq!(grafted.texts(0), ["{0;0}: b", "{0;5}: a", "{3;1}: c, d"]);
        let wrong = Trial::of("Graft By Data").branches(data).list([1]);
        assert!(wrong.message().contains("structure"));
    }

    #[test]
    fn a_list_takes_the_structure_of_a_tree() {
        let tree = [("{0;1}", [1, 2]), ("{4}", [3, 4])];
        let matched = |k: usize| Trial::of("Match Paths").list(["a", "b", "c", "d"]).branches(tree).texts(k);
        assert_eq!(matched(0), ["{0;1}: a, b", "{4}: c, d"]);
        assert_eq!(matched(1), ["{0;1}: 0, 1", "{4}: 2, 3"]);
        let wrong = Trial::of("Match Paths").list(["a"]).branches(tree).message();
        assert!(wrong.contains("4 items in the tree for 1 items"), "{wrong}");
    }

    #[test]
    fn each_item_has_its_path() {
        let paths = Trial::of("Path Description").branches([("{0;1}", [1, 2]), ("{4}", [3, 4])]).texts(0);
        assert_eq!(paths, ["{0;1}: {0;1}, {0;1}", "{4}: {4}, {4}"]);
    }
}
