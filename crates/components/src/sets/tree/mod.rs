//! Sets / Tree.

mod clean;
mod join;
mod mask;
mod offset;
mod path;
mod path_mapper;
mod pick;
mod relative;
mod shape;

use katydid_component::{Context, Message};
use katydid_data::Tree;

use crate::sets::room;

/// Asks for the room of a tree that is given out as it is or in another shape.
fn whole(context: &Context<'_>, tree: &Tree) -> Result<(), Message> {
    room(context, tree.item_count().saturating_add(tree.branch_count()))
}
