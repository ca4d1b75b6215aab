//! TreeSloth: lists, and the paths of trees.
//!
//! Names and ports are those of public lists, ids as far as files show them. The lists say in a line what each does; the rest is our
//! reading, and its help says so.

mod along;
mod lists;
mod paths;

use katydid_component::{Context, Message};
use katydid_data::{Path, Tree, Value};

use crate::branches::{Branches, items, of};

/// A tree whose branches stand at other paths. Branches that come to the same one are joined.
fn moved(
    context: &Context<'_>,
    tree: &Tree,
    to: impl Fn(usize, &Path) -> Result<Path, Message>,
) -> Result<Tree, Message> {
    context.items(tree.item_count())?;
    let mut branches = Branches::default();
    for (place, branch) in tree.branches().enumerate() {
        branches.extend(to(place, branch.path())?, of(&branch));
    }
    Ok(branches.tree())
}

/// The whole numbers of a tree.
fn numbers(tree: &Tree) -> Vec<i32> {
    let number = |item| match item {
        Some(Value::Integer(number)) => Some(number),
        _ => None,
    };
    items(tree).filter_map(number).collect()
}

/// The path of a place in a row.
fn numbered(place: usize) -> Path {
    Path::from([i32::try_from(place).unwrap_or(i32::MAX)])
}

/// The output for each place of a row, as a pattern of their numbers says that starts again and again; none where there is no such
/// output, with a warning.
///
/// # Errors
/// The pattern is empty.
fn dealt(context: &Context<'_>, pattern: &[i32], count: usize) -> Result<Vec<Option<usize>>, Message> {
    if pattern.is_empty() {
        return Err(Message::error("The pattern is empty"));
    }
    let outputs = context.output_count();
    let output = |number: &i32| usize::try_from(*number).ok().filter(|output| *output < outputs);
    let dealt: Vec<Option<usize>> = pattern.iter().cycle().take(count).map(output).collect();
    if dealt.iter().any(Option::is_none) {
        context.warn("What the pattern gives to outputs that are not there is left out");
    }
    Ok(dealt)
}
