//! The Path Mapper, the Cherry Picker and the Data Recorder.

use katydid_definition::archive::Chunk;
use katydid_definition::document::{Object, Special, format_path, ids, parse_path};

use super::list::MOST_ITEMS;
use super::{PLAIN, Row, part, short, unfit};
use crate::Refusal;
use crate::protocol::Control;

pub(super) const PATH_MAPPER: Row = Row {
    components: &[ids::PATH_MAPPER],
    begin: |container| {
        let mut rules = Chunk::new("lexers");
        rules.set("lexer_count", 0);
        container.set_child(rules);
    },
    view: |_, special| {
        let Special::PathMapper(mapper) = special else { return None };
        Some(Control::Paths { rules: mapper.rules.into_iter().map(|(from, to)| [from, to]).collect() })
    },
    shape: |object, control| {
        let Control::Paths { rules } = control else { return Ok(false) };
        paths(object, rules)
    },
    ..PLAIN
};

pub(super) const CHERRY_PICKER: Row = Row {
    components: &[ids::CHERRY_PICKER],
    begin: |container| {
        let mut path = Chunk::new("TreePath");
        path.set("path", "{0}");
        container.set_child(path);
        container.set("ListIndex", 0);
    },
    view: |_, special| {
        let Special::CherryPicker(picker) = special else { return None };
        Some(Control::Cherry { path: format_path(&picker.path), index: picker.index })
    },
    shape: |object, control| {
        let Control::Cherry { path, index } = control else { return Ok(false) };
        let path = parse_path(path).ok_or_else(|| unfit(object, "a path looks like {0;1}"))?;
        part(object, "TreePath")?.set("path", format_path(&path));
        object.container_mut().set("ListIndex", *index);
        Ok(true)
    },
    ..PLAIN
};

pub(super) const RECORDER: Row = Row {
    components: &[ids::DATA_RECORDER],
    begin: |container| {
        container.set("RecordData", true);
        container.set("DataLimit", -1);
    },
    view: |_, special| {
        let Special::DataRecorder(recorder) = special else { return None };
        Some(Control::Recorder { recording: recorder.recording, limit: recorder.limit })
    },
    shape: |object, control| {
        let Control::Recorder { recording, limit } = control else { return Ok(false) };
        let container = object.container_mut();
        container.set("RecordData", *recording);
        container.set("DataLimit", limit.unwrap_or(-1));
        Ok(true)
    },
    ..PLAIN
};

fn paths(object: &mut Object, rules: &[[String; 2]]) -> Result<bool, Refusal> {
    if rules.len() > MOST_ITEMS {
        return Err(unfit(object, "it has at most ten thousand rules"));
    }
    let lexers = part(object, "lexers")?;
    lexers.remove("source");
    lexers.remove("target");
    for (k, [source, target]) in (0..).zip(rules) {
        lexers.set_at("source", k, short(source)?);
        lexers.set_at("target", k, short(target)?);
    }
    lexers.set("lexer_count", i32::try_from(rules.len()).unwrap_or(i32::MAX));
    Ok(true)
}
