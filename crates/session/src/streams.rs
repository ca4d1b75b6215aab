//! Panels that stream to files: what a run writes, where it was allowed to.
//!
//! A definition may name any path of any machine (`C:\\Users\\…`), and whoever made it is not who runs it. So of a path only
//! the name of the file counts; the folder is the caller's choice.

use std::io::{self, Write};

use katydid_component::file_name;
use katydid_data::text;
use katydid_definition::document::{Document, Special};
use katydid_solver::Engine;

/// A panel whose contents go to a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PanelStream {
    /// The index of the panel among the objects.
    pub object: usize,
    /// The name of the file, without folders; none where the path has no name that is safe.
    pub file: Option<String>,
}

/// The panels of a document that stream to files and are not disabled, in the order of the document.
pub fn panel_streams(document: &Document) -> Vec<PanelStream> {
    let streams = document.objects.iter().enumerate().filter(|(_, object)| !object.locked);
    streams
        .filter_map(|(index, object)| match object.special() {
            Some(Special::Panel(panel)) => {
                let path = panel.stream_path?;
                Some(PanelStream { object: index, file: file_name(&path).map(str::to_owned) })
            }
            _ => None,
        })
        .collect()
}

/// Writes what a panel shows: a line an item, as the panel writes it, without paths and indices. Gives the number of lines.
///
/// # Errors
/// When it cannot be written.
pub fn write_panel(engine: &Engine, object: usize, mut to: impl Write) -> io::Result<usize> {
    let rules = engine.options().rules;
    let style = text::Style { units: rules.units, tolerance: rules.tolerance };
    let Some(tree) = engine.report(object).and_then(|report| report.outputs.first()) else { return Ok(0) };
    let mut lines = 0;
    for branch in tree.branches() {
        for item in branch.iter() {
            writeln!(to, "{}", text::item(item.as_ref(), &style))?;
            lines += 1;
        }
    }
    Ok(lines)
}
