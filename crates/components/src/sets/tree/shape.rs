//! What rewrites the paths of a tree and keeps its items.

use katydid_component::{Context, Message, component};
use katydid_data::{Path, Tree};

use super::whole;
use crate::sets::{count, room};

/// Gives every item a branch of its own: item i of `{0}` goes to `{0;i}`.
///
/// An empty branch stays as it is, and a null gets its branch too, unless a setting leaves them out.
#[component("87e1d9ef-088b-4d30-9dda-8a7448a17329", name = "Graft Tree", nick = "Graft", at = "Sets/Tree")]
#[output("Tree", "T", "The tree with a branch for each item.")]
fn graft_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
) -> Result<Tree, Message> {
    whole(context, tree)?;
    let with_empty = context.settings().bool("IncludeEmptyLists").unwrap_or(true);
    let with_nulls = context.settings().bool("IncludeNullItems").unwrap_or(true);
    let grafted = tree.graft();
    Ok(grafted.filter_branches(|b| {
        let range = grafted.range(b);
        if range.is_empty() { with_empty } else { with_nulls || !grafted.column().is_null(range.start) }
    }))
}

/// Gives each item of a tree a branch of its own. An early form of the component of the same name.
#[component(
    "10a8674b-f4bb-4fdf-a56e-94dc606ecf33",
    name = "Graft Tree",
    nick = "Graft",
    at = "Sets/Tree",
    old
)]
#[output("Tree", "T", "The tree with a branch for each item.")]
fn early_graft_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D")]
    tree: &Tree,
    /// Whether nulls are left out.
    #[port("Strip", "S", default = false)]
    strip: bool,
) -> Result<Tree, Message> {
    whole(context, tree)?;
    let grafted = tree.graft();
    Ok(grafted.filter_branches(|b| {
        let range = grafted.range(b);
        !(strip && !range.is_empty() && grafted.column().is_null(range.start))
    }))
}

/// Puts all items of a tree into one list, in order.
#[component(
    "f80cfe18-9510-4b89-8301-8e58faf423bb",
    name = "Flatten Tree",
    nick = "Flatten",
    at = "Sets/Tree",
    also("a13fcd5d-81af-4337-a32e-28dd7e23ae4c")
)]
#[output("Tree", "T", "The one list.")]
fn flatten_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// The path of the list.
    #[port("Path", "P", default = Path::zero())]
    path: Path,
) -> Result<Tree, Message> {
    whole(context, tree)?;
    Ok(tree.flatten_to(path))
}

/// Leaves out the path elements that are the same in all branches.
///
/// With Front only those before the first that differs go. A single branch goes to `{0}`.
#[component(
    "1303da7b-e339-4e65-a051-82c4dce8224d",
    name = "Simplify Tree",
    nick = "Simplify",
    at = "Sets/Tree",
    also("06b3086c-1e9d-41c2-bcfc-bb843156196e")
)]
#[output("Tree", "T", "The tree with shorter paths.")]
fn simplify_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// Only at the front of the paths.
    #[port("Front", "F", default = false)]
    front: bool,
) -> Result<Tree, Message> {
    whole(context, tree)?;
    Ok(tree.simplify(front))
}

/// Turns rows into columns: every branch is a row, and the items number i of all branches go to branch i.
///
/// The new paths are the first path with the number of the column as its last element. Where a branch is too short
/// there is a null. Paths of different lengths are an error.
#[component("41aa4112-9c9b-42f4-847e-503b9d90e4c7", name = "Flip Matrix", nick = "Flip", at = "Sets/Tree")]
#[output("Data", "D", "The turned tree; the last path element is the number of the column.")]
fn flip_matrix(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D")]
    data: &Tree,
) -> Result<Tree, Message> {
    let Some(first) = data.paths().first() else { return Ok(Tree::empty()) };
    if let Some(other) = data.paths().iter().find(|p| p.len() != first.len()) {
        return Err(Message::error(format!("The paths {first} and {other} differ in length")));
    }
    let rows: Vec<_> = (0..data.branch_count()).map(|b| data.range(b)).collect();
    let columns = rows.iter().map(ExactSizeIterator::len).max().unwrap_or(0);
    room(context, columns.saturating_mul(rows.len()))?;
    let parent = first.parent();
    let mut indices: Vec<usize> = Vec::with_capacity(columns * rows.len());
    for column in 0..columns {
        // An index outside all items gathers a null.
        indices
            .extend(rows.iter().map(|row| if column < row.len() { row.start + column } else { usize::MAX }));
    }
    let paths: Vec<Path> = (0..columns).map(|column| parent.child(column)).collect();
    let ends: Vec<usize> = (1..=columns).map(|column| column * rows.len()).collect();
    Ok(Tree::from_parts(paths, ends, data.column().gather(&indices)))
}

/// Every path without some of its elements: the first `n`, or with `last` the last. A path of which nothing is left is
/// that of the first branch, {0}, so that no data is lost.
fn shortened(context: &Context<'_>, tree: &Tree, n: usize, last: bool) -> Result<Tree, Message> {
    whole(context, tree)?;
    if n == 0 {
        return Ok(tree.clone());
    }
    let shorten = |path: &Path| {
        let kept = path.len().checked_sub(n).filter(|&kept| kept > 0)?;
        let range = if last { 0..kept } else { n..path.len() };
        path.elements().get(range).map(Path::from)
    };
    let mut emptied = None;
    let paths = tree.paths().iter().map(|path| {
        shorten(path).unwrap_or_else(|| {
            emptied.get_or_insert(path);
            Path::zero()
        })
    });
    let paths = paths.collect();
    if let Some(path) = emptied {
        let text = format!("The path {path} has no element left without {n} of them: its data goes to {{0}}");
        context.tell(Message::remark(text));
    }
    Ok(tree.with_paths(paths))
}

/// Makes paths shorter: a negative offset takes elements off their end, a positive one off their front.
///
/// Branches whose paths become the same are joined in order. What has a path that would lose all its elements goes to
/// {0}, and a remark says so.
#[component("2d61f4e0-47c5-41d6-a41d-6afa96ee63af", name = "Shift Paths", nick = "PShift", at = "Sets/Tree")]
#[output("Data", "D", "The tree with shorter paths.")]
fn shift_paths(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D")]
    data: &Tree,
    /// How many elements: -1 for the last one.
    #[port("Offset", "O", default = -1)]
    offset: i32,
) -> Result<Tree, Message> {
    let n = usize::try_from(offset.unsigned_abs()).unwrap_or(usize::MAX);
    shortened(context, data, n, offset < 0)
}

/// Merges the outermost branches of a tree: takes elements off the end of every path.
///
/// Branches whose paths become the same are joined in order. What has a path that would lose all its elements goes to
/// {0}, and a remark says so.
#[component("1177d6ee-3993-4226-9558-52b7fd63e1e3", name = "Trim Tree", nick = "Trim", at = "Sets/Tree")]
#[output("Tree", "T", "The tree with shorter paths.")]
fn trim_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// How many elements, 0 or more.
    #[port("Depth", "D", default = 1)]
    depth: i32,
) -> Result<Tree, Message> {
    shortened(context, tree, count(depth, "Depth")?, true)
}

/// Fills the branches of a guide with the items of a tree, in order: as many for each as the guide has there.
///
/// When there are too few items the last branches stay short or empty; what is too much is left out. Either is
/// a warning.
#[component(
    "b8e2aa8f-8830-4ee1-bb59-613ea279c281",
    name = "Unflatten Tree",
    nick = "Unflatten",
    at = "Sets/Tree"
)]
#[output("Tree", "T", "The items in the branches of the guide.")]
fn unflatten_tree(
    context: &Context<'_>,
    /// The items.
    #[port("Tree", "T")]
    tree: &Tree,
    /// The branches to fill.
    #[port("Guide", "G")]
    guide: &Tree,
) -> Result<Tree, Message> {
    whole(context, guide)?;
    let (n, wanted) = (tree.item_count(), guide.item_count());
    if n != wanted {
        context.warn(format!("There are {n} items for the {wanted} places of the guide"));
    }
    let ends: Vec<usize> = (0..guide.branch_count()).map(|b| guide.range(b).end.min(n)).collect();
    let column = if n <= wanted {
        tree.column().clone()
    } else {
        tree.column().gather(&(0..wanted).collect::<Vec<_>>())
    };
    if guide.is_empty() {
        return Ok(Tree::empty());
    }
    Ok(Tree::from_parts(guide.shared_paths().clone(), ends, column))
}

/// Gives the branches of a tree the paths of a guide, one by one in order.
///
/// Both must have the same number of branches.
#[component("46372d0d-82dc-4acb-adc3-25d1fde04c4e", name = "Match Tree", nick = "Match", at = "Sets/Tree")]
#[output("Tree", "T", "The tree with the paths of the guide.")]
fn match_tree(
    /// The tree.
    #[port("Tree", "T")]
    tree: &Tree,
    /// Where the paths come from.
    #[port("Guide", "G")]
    guide: &Tree,
) -> Result<Tree, Message> {
    let (n, m) = (tree.branch_count(), guide.branch_count());
    if n != m {
        return Err(Message::error(format!("The tree has {n} branches and the guide {m}")));
    }
    Ok(tree.with_paths(guide.paths().to_vec()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn grafting_and_flattening() {
        let tree = |name: &str| Trial::of(name).branches([("{0;0}", [1, 2]), ("{0;1}", [3, 4])]);
        assert_eq!(tree("Graft Tree").texts(0), ["{0;0;0}: 1", "{0;0;1}: 2", "{0;1;0}: 3", "{0;1;1}: 4"]);
        assert_eq!(tree("Flatten Tree").texts(0), ["{0}: 1, 2, 3, 4"]);
        assert_eq!(tree("Flatten Tree").item("{3;1}").texts(0), ["{3;1}: 1, 2, 3, 4"]);
        let gaps = || Trial::of("Graft Tree").gaps([Some(1), None]);
        assert_eq!(gaps().texts(0), ["{0;0}: 1", "{0;1}: null"]);
        assert_eq!(gaps().setting("IncludeNullItems", false).texts(0), ["{0;0}: 1"]);
        let early = || Trial::of_guid("10a8674b-f4bb-4fdf-a56e-94dc606ecf33").gaps([Some(1), None]);
        assert_eq!(early().texts(0), ["{0;0}: 1", "{0;1}: null"]);
        assert_eq!(early().item(true).texts(0), ["{0;0}: 1"]);
        let empty = || Trial::of("Graft Tree").list::<f64>([]);
        assert_eq!(empty().texts(0), ["{0}:"]);
        assert!(empty().setting("IncludeEmptyLists", false).texts(0).is_empty());
    }

    #[test]
    fn simplifying() {
        let tree = || Trial::of("Simplify Tree").branches([("{0;0;5}", [1]), ("{0;1;5}", [2])]);
        assert_eq!(tree().texts(0), ["{0}: 1", "{1}: 2"]);
        assert_eq!(tree().item(true).texts(0), ["{0;5}: 1", "{1;5}: 2"]);
    }

    #[test]
    fn flipping_turns_rows_to_columns() {
        let trial = Trial::of("Flip Matrix").branches([
            ("{0;0}", [1, 2, 3]),
            ("{0;4}", [4, 5, 6]),
            ("{1;0}", [7, 8, 9]),
        ]);
        assert_eq!(
            trial.texts(0),
            ["{0;0}: 1, 4, 7", "{0;1}: 2, 5, 8", "{0;2}: 3, 6, 9"],
            "every branch is a row: files turn rows that list components have put a level deeper"
        );
        let ragged = katydid_data::Tree::merge([
            &katydid_data::Tree::list(vec![1, 2]),
            &katydid_data::Tree::list(vec![3]).with_paths(vec![[1].into()]),
        ]);
        assert_eq!(Trial::of("Flip Matrix").tree(ragged).texts(0), ["{0}: 1, 3", "{1}: 2, null"]);
        let mixed = Trial::of("Flip Matrix").branches([("{0}", [1]), ("{0;1}", [2])]);
        assert_eq!(mixed.message(), "The paths {0} and {0;1} differ in length");
    }

    #[test]
    fn a_flipped_comb_is_refused() {
        let mut comb = katydid_data::TreeBuilder::<f64>::new();
        (0..100_000).for_each(|_| comb.push(Some(0.0)));
        for i in 1..100_000 {
            comb.branch([i].into());
            comb.push(Some(1.0));
        }
        assert!(Trial::of("Flip Matrix").tree(comb.finish()).message().contains("items"));
    }

    #[test]
    fn shifting_and_trimming() {
        let tree =
            |name: &str| Trial::of(name).branches([("{0;0;0}", [1]), ("{0;0;1}", [2]), ("{0;1;0}", [3])]);
        assert_eq!(tree("Shift Paths").texts(0), ["{0;0}: 1, 2", "{0;1}: 3"]);
        assert_eq!(tree("Shift Paths").item(1).texts(0), ["{0;0}: 1", "{0;1}: 2", "{1;0}: 3"]);
        assert_eq!(tree("Shift Paths").item(-2).texts(0), ["{0}: 1, 2, 3"]);
        assert_eq!(tree("Shift Paths").item(0).texts(0).len(), 3);
        // Nothing is lost where nothing of a path is left.
        assert_eq!(tree("Shift Paths").item(-3).texts(0), ["{0}: 1, 2, 3"]);
        assert_eq!(tree("Trim Tree").item(7).texts(0), ["{0}: 1, 2, 3"]);
        assert!(tree("Shift Paths").item(i32::MIN).message().starts_with("The path {0;0;0} has no element"));
        assert_eq!(tree("Trim Tree").texts(0), ["{0;0}: 1, 2", "{0;1}: 3"]);
        assert_eq!(tree("Trim Tree").item(0).texts(0).len(), 3);
        assert!(tree("Trim Tree").item(3).message().contains("no element"));
        assert!(tree("Trim Tree").item(-1).message().contains("negative"));
    }

    #[test]
    fn unflattening_and_matching() {
        let fill = |items: &[&str]| {
            let trial = Trial::of("Unflatten Tree").list(items.iter().copied());
            trial.branches([("{0}", [0, 0]), ("{4}", [0, 0])])
        };
        assert_eq!(fill(&["a", "b", "c", "d"]).texts(0), ["{0}: a, b", "{4}: c, d"]);
        assert_eq!(fill(&["a", "b", "c"]).texts(0), ["{0}: a, b", "{4}: c"]);
        assert_eq!(fill(&["a"]).texts(0), ["{0}: a", "{4}:"]);
        assert_eq!(fill(&["a", "b", "c", "d", "e"]).texts(0), ["{0}: a, b", "{4}: c, d"]);
        assert_eq!(fill(&["a"]).message(), "There are 1 items for the 4 places of the guide");
        let matched = Trial::of("Match Tree").branches([("{0}", [1]), ("{1}", [2])]);
        assert_eq!(matched.branches([("{5;0}", [0]), ("{5;7}", [0])]).texts(0), ["{5;0}: 1", "{5;7}: 2"]);
        let odd = Trial::of("Match Tree").item(1).branches([("{0}", [1]), ("{1}", [2])]);
        assert_eq!(odd.message(), "The tree has 1 branches and the guide 2");
    }
}
