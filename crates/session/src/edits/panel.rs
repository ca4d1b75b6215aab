//! How panels look.

use katydid_definition::archive::ItemValue;
use katydid_definition::document::special::Panel;
use katydid_definition::document::{Object, Special, ids};
use uuid::Uuid;

use crate::Refusal;
use crate::controls::{argb, part, unfit};
use crate::editor::Draft;
use crate::protocol::PanelChange;

/// The most bytes of the path of a file.
const LONGEST_PATH: usize = 4096;

/// Changes how a panel looks.
pub(super) fn change(draft: &mut Draft<'_>, id: Uuid, change: &PanelChange) -> Result<(), Refusal> {
    let object = draft.object(id)?;
    if object.component != ids::PANEL {
        return Err(unfit(object, "it is not a Panel"));
    }
    property(object, change)?;
    object.refresh();
    Ok(())
}

pub(crate) fn property(object: &mut Object, change: &PanelChange) -> Result<(), Refusal> {
    let Some(Special::Panel(panel)) = object.special() else {
        return Err(unfit(object, "it is not a Panel"));
    };
    let (name, value, same) = match change {
        PanelChange::Multiline { on } => ("Multiline", ItemValue::Bool(*on), panel.multiline == *on),
        PanelChange::Paths { on } => ("DrawPaths", ItemValue::Bool(*on), panel.draw_paths == *on),
        PanelChange::Indices { on } => ("DrawIndices", ItemValue::Bool(*on), panel.draw_indices == *on),
        PanelChange::Wrap { on } => ("Wrap", ItemValue::Bool(*on), panel.wrap == *on),
        PanelChange::SpecialCodes { on } => {
            ("SpecialCodes", ItemValue::Bool(*on), panel.special_codes == *on)
        }
        PanelChange::Alignment { alignment } if !(0..=2).contains(alignment) => {
            return Err(unfit(object, "text stands left, in the middle or right"));
        }
        PanelChange::Alignment { alignment } => {
            ("Alignment", ItemValue::Int32(*alignment), panel.alignment == *alignment)
        }
        PanelChange::Colour { colour } => {
            ("Colour", ItemValue::Colour(argb(*colour)), panel.colour == Some(argb(*colour)))
        }
        PanelChange::Stream { file } => return stream(object, &panel, file.as_deref()),
    };
    if !same {
        part(object, "PanelProperties")?.set(name, value);
    }
    Ok(())
}

/// Has a panel written to a file, or not any more. The path stays where it is only switched off, as in Grasshopper.
fn stream(object: &mut Object, panel: &Panel, file: Option<&str>) -> Result<(), Refusal> {
    let file = file.map(str::trim).filter(|file| !file.is_empty());
    if panel.stream_path.as_deref() == file {
        return Ok(());
    }
    if let Some(file) = file
        && (file.len() > LONGEST_PATH || file.contains('\0'))
    {
        return Err(unfit(object, "the name of its file is too long or holds a zero"));
    }
    let properties = part(object, "PanelProperties")?;
    properties.set("Stream", file.is_some());
    if let Some(file) = file {
        properties.set("StreamPath", file);
    }
    Ok(())
}
