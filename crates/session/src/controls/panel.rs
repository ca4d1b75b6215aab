//! The Panel.

use katydid_definition::archive::{Chunk, Colour};
use katydid_definition::document::{Special, ids};

use super::{FACE, Row, colour, short};
use crate::edits::panel_property;
use crate::protocol::{Control, PanelChange};
use crate::view::size::text as width;

/// A new panel's paper.
const PAPER: Colour = Colour::new(255, 255, 250, 90);

pub(super) const PANEL: Row = Row {
    components: &[ids::PANEL],
    begin: |container| {
        container.set("ScrollRatio", 0.0);
        container.set("UserText", "Double click to edit panel content…");
        let mut panel = Chunk::new("PanelProperties");
        panel.set("Colour", PAPER);
        for (name, on) in [
            ("DrawIndices", true),
            ("DrawPaths", true),
            ("Multiline", true),
            ("SpecialCodes", false),
            ("Stream", false),
            ("Wrap", true),
        ] {
            panel.set(name, on);
        }
        container.set_child(panel);
    },
    view: |_, special| {
        let Special::Panel(panel) = special else { return None };
        Some(Control::Panel {
            text: panel.text,
            multiline: panel.multiline,
            paths: panel.draw_paths,
            indices: panel.draw_indices,
            wrap: panel.wrap,
            special_codes: panel.special_codes,
            alignment: panel.alignment,
            colour: colour(panel.colour.unwrap_or(PAPER)),
            stream: panel.stream_path,
        })
    },
    shape: |object, control| {
        let Control::Panel {
            text,
            multiline,
            paths,
            indices,
            wrap,
            special_codes,
            alignment,
            colour,
            stream,
        } = control
        else {
            return Ok(false);
        };
        if !matches!(object.special(), Some(Special::Panel(panel)) if panel.text == *text) {
            object.set_panel_text(short(text)?)?;
        }
        for change in [
            PanelChange::Multiline { on: *multiline },
            PanelChange::Paths { on: *paths },
            PanelChange::Indices { on: *indices },
            PanelChange::Wrap { on: *wrap },
            PanelChange::SpecialCodes { on: *special_codes },
            PanelChange::Alignment { alignment: *alignment },
            PanelChange::Colour { colour: *colour },
            PanelChange::Stream { file: stream.clone() },
        ] {
            panel_property(object, &change)?;
        }
        Ok(true)
    },
    size: |special, _| {
        let Special::Panel(panel) = special else { return None };
        Some(size(&panel.text))
    },
    ..FACE
};

/// As large as a text wants to be read, within what is usual.
fn size(content: &str) -> [f32; 2] {
    let longest = content.lines().take(200).map(width).fold(0.0, f32::max);
    let lines = u16::try_from(content.lines().count()).map_or(1e5, f32::from);
    [(longest + 30.0).clamp(160.0, 400.0), (lines * 14.0 + 30.0).clamp(100.0, 400.0)]
}
