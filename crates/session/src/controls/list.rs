//! The Value List.

use katydid_definition::archive::Chunk;
use katydid_definition::document::special::ListMode;
use katydid_definition::document::{Object, Special, ids};

use super::{FACE, Row, short, unfit};
use crate::Refusal;
use crate::protocol::{Control, ListItemView, ListModeView};
use crate::view::size::text as width;

/// The most items of a list.
pub(super) const MOST_ITEMS: usize = 10_000;

pub(super) const VALUE_LIST: Row = Row {
    components: &[ids::VALUE_LIST],
    is_set_by_hand: true,
    grows: true,
    begin: |container| {
        let items = ["One", "Two", "Three", "Four"];
        for (k, name) in (0..).zip(items) {
            let mut item = Chunk::indexed("ListItem", k);
            item.set("Expression", (k + 1).to_string());
            item.set("Name", name);
            item.set("Selected", k == 0);
            container.set_child(item);
        }
        container.set("ListCount", 4);
        container.set("ListMode", 1);
    },
    view: |_, special| {
        let Special::ValueList(list) = special else { return None };
        Some(Control::ValueList {
            mode: match list.mode {
                ListMode::CheckList => ListModeView::Check,
                ListMode::DropDown => ListModeView::DropDown,
                ListMode::Sequence => ListModeView::Sequence,
                ListMode::Cycle => ListModeView::Cycle,
            },
            items: list
                .items
                .into_iter()
                .map(|item| ListItemView {
                    name: item.name,
                    expression: item.expression,
                    selected: item.selected,
                })
                .collect(),
        })
    },
    shape: |object, control| {
        let Control::ValueList { mode, items } = control else { return Ok(false) };
        shape(object, *mode, items)
    },
    size: |special, title| {
        let Special::ValueList(list) = special else { return None };
        let longest = list.items.iter().map(|item| width(&item.name)).fold(0.0, f32::max);
        Some([(title + longest + 50.0).clamp(80.0, 400.0), 22.0])
    },
    ..FACE
};

fn shape(object: &mut Object, mode: ListModeView, items: &[ListItemView]) -> Result<bool, Refusal> {
    if items.len() > MOST_ITEMS {
        return Err(unfit(object, &format!("a list has at most {MOST_ITEMS} items")));
    }
    let mut one = items.iter().position(|item| item.selected);
    if mode != ListModeView::Check && one.is_none() && !items.is_empty() {
        one = Some(0);
    }
    let container = object.container_mut();
    container.remove_children("ListItem");
    for (k, item) in items.iter().enumerate() {
        let mut chunk = Chunk::indexed("ListItem", i32::try_from(k).unwrap_or(i32::MAX));
        chunk.set("Expression", short(&item.expression)?);
        chunk.set("Name", short(&item.name)?);
        chunk.set("Selected", if mode == ListModeView::Check { item.selected } else { one == Some(k) });
        container.chunks.push(chunk);
    }
    container.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    container.set("ListCount", i32::try_from(items.len()).unwrap_or(i32::MAX));
    container.set(
        "ListMode",
        match mode {
            ListModeView::Check => 0,
            ListModeView::DropDown => 1,
            ListModeView::Sequence => 2,
            ListModeView::Cycle => 3,
        },
    );
    Ok(true)
}
