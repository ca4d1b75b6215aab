use std::collections::HashMap;

use crate::archive::{Chunk, ItemValue};
use crate::document::parse_path;

/// A Path Mapper: rules that send items to other paths.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PathMapper {
    /// The rules: source mask and target mask, `{A;B}` to `{B}` say.
    pub rules: Vec<(String, String)>,
}

/// A Cherry Picker: one item of a tree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CherryPicker {
    /// The path of the branch.
    pub path: Vec<i32>,
    /// The index of the item in it.
    pub index: i32,
}

/// A Data Recorder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DataRecorder {
    /// Whether it records.
    pub recording: bool,
    /// How many items it keeps; `None` for all.
    pub limit: Option<i32>,
}

impl PathMapper {
    pub(super) fn read(container: &Chunk) -> Self {
        let rules = container.child("lexers").map(|chunk| {
            let targets: HashMap<i32, _> = chunk.list("target").into_iter().collect();
            let rule = |(k, source): (i32, &ItemValue)| {
                Some((source.as_str()?.to_owned(), targets.get(&k)?.as_str()?.to_owned()))
            };
            chunk.list("source").into_iter().filter_map(rule).collect()
        });
        Self { rules: rules.unwrap_or_default() }
    }
}

impl CherryPicker {
    pub(super) fn read(container: &Chunk) -> Option<Self> {
        let path = container.child("TreePath")?.str("path")?;
        Some(Self { path: parse_path(path)?, index: container.i32("ListIndex").unwrap_or(0) })
    }
}

impl DataRecorder {
    pub(super) fn read(container: &Chunk) -> Self {
        Self {
            recording: container.bool("RecordData").unwrap_or(true),
            // A limit that is switched off is kept as its negative.
            limit: container.i32("DataLimit").filter(|limit| *limit > 0),
        }
    }
}
