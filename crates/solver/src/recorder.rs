//! What a Data Recorder or a Value Tracker has at the end of a solution, when a definition runs in time.

use katydid_component::{Limits, Message};
use katydid_data::Tree;
use katydid_definition::document::{Object, Special, ids};

/// So many of the newest values of a branch does a tracker keep.
const TRACKED: i32 = 10_000;

/// What the recorder `object` holds once `new` came in: the items behind those that it has recorded, branch by branch;
/// of each branch no more than its limit says, the newest. One that is switched off keeps what it has, and one that
/// would hold more than an object may put out takes nothing more and says so.
pub(crate) fn record(
    object: &Object,
    before: Option<&Tree>,
    new: Tree,
    limits: &Limits,
    messages: &mut Vec<Message>,
) -> Tree {
    let (recording, limit) = match object.special() {
        Some(Special::DataRecorder(recorder)) => (recorder.recording, recorder.limit),
        _ if object.component == ids::VALUE_TRACKER => (true, Some(TRACKED)),
        _ => (true, None),
    };
    let Some(before) = before else { return newest(new, limit) };
    if !recording {
        return before.clone();
    }
    let all = newest(Tree::merge([before, &new]), limit);
    let fits = |n: usize, most: u64| u64::try_from(n).is_ok_and(|n| n <= most);
    if fits(all.item_count(), limits.items) && fits(all.weight(), limits.bytes) {
        return all;
    }
    let text = format!("The recorder is full: it holds {} items, and takes no more", before.item_count());
    messages.push(Message::error(text));
    before.clone()
}

/// The last items of each branch, `limit` at most.
fn newest(tree: Tree, limit: Option<i32>) -> Tree {
    let Some(limit) = limit.and_then(|limit| usize::try_from(limit).ok()) else { return tree };
    if tree.branches().all(|branch| branch.len() <= limit) {
        return tree;
    }
    let mut ends = Vec::with_capacity(tree.branch_count());
    let mut indices = Vec::new();
    for branch in tree.branches() {
        let range = branch.range();
        indices.extend(range.end.saturating_sub(limit).max(range.start)..range.end);
        ends.push(indices.len());
    }
    Tree::from_parts(tree.shared_paths().clone(), ends, tree.column().gather(&indices))
}
