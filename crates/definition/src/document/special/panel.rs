use crate::Result;
use crate::archive::{Chunk, Colour};
use crate::document::{Object, ids};

/// A Panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The text its author typed. With a wire into the panel it is a leftover and not what the panel gives.
    pub text: String,
    /// Whether the text is one item with line breaks; else each line is an item.
    pub multiline: bool,
    /// Whether paths are shown.
    pub draw_paths: bool,
    /// Whether indices are shown.
    pub draw_indices: bool,
    /// Whether long lines are wrapped.
    pub wrap: bool,
    /// Whether signs such as `\n` stand for others.
    pub special_codes: bool,
    /// 0 left, 1 centre, 2 right.
    pub alignment: i32,
    /// The colour of the paper.
    pub colour: Option<Colour>,
    /// The file that what it shows is written to, where there is one.
    pub stream_path: Option<String>,
}

impl Panel {
    pub(super) fn read(container: &Chunk) -> Self {
        // Grasshopper 0.6 kept the properties in the container, under other names.
        let chunk = container.child("PanelProperties").unwrap_or(container);
        let flag = |new, old| chunk.bool(new).or_else(|| container.bool(old));
        let streams = flag("Stream", "StreamContents").unwrap_or(false);
        let path = chunk.str("StreamPath").or_else(|| container.str("StreamDestination"));
        Self {
            text: container.str("UserText").unwrap_or_default().to_owned(),
            multiline: flag("Multiline", "MultilineData").unwrap_or(true),
            draw_paths: flag("DrawPaths", "DrawPaths").unwrap_or(true),
            draw_indices: flag("DrawIndices", "EntryNumbers").unwrap_or(true),
            wrap: flag("Wrap", "WrapItems").unwrap_or(true),
            special_codes: chunk.bool("SpecialCodes").unwrap_or(false),
            alignment: chunk.i32("Alignment").unwrap_or(0),
            colour: chunk.colour("Colour"),
            stream_path: path.filter(|path| streams && !path.is_empty()).map(str::to_owned),
        }
    }

    /// The items that the text stands for when nothing is wired in.
    pub fn items(&self) -> Vec<&str> {
        if self.multiline { vec![&self.text] } else { self.text.lines().collect() }
    }
}

impl Object {
    /// Types a text into a Panel.
    ///
    /// # Errors
    /// When the object is no Panel, or shows what comes over a wire.
    pub fn set_panel_text(&mut self, text: &str) -> Result<()> {
        if self.component != ids::PANEL {
            return Err(self.refuse("it is not a Panel"));
        }
        if self.inputs.iter().any(|port| !port.sources.is_empty()) {
            return Err(self.refuse("the panel shows what comes over its wire"));
        }
        self.container_mut().set("UserText", text);
        Ok(())
    }
}
