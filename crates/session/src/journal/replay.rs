//! Reads a journal and does again what it says.

use katydid_data::cast::Rules;
use katydid_definition::archive::{Encoding, Limits};
use katydid_definition::document::Document;

use super::record::{self, Begin, Record};
use super::{Journal, Source, Store};
use crate::Editor;
use crate::protocol::Restored;

/// What was found in a journal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// How much it is, for clients.
    pub restored: Restored,
    /// What the journal belongs to.
    pub source: Source,
    /// Whether the document's file is another than when the journal began: somebody else saved it since.
    pub file_changed: bool,
    /// Whether the end of the journal was cut short.
    pub torn: bool,
}

impl Editor {
    /// An editor of a document as its file has it, with a journal. What a session before this one left there unsaved is
    /// made again; [`settle`](Self::settle) goes back to the file.
    ///
    /// # Errors
    /// When the journal cannot be read.
    pub fn with_journal(
        document: Document,
        rules: Rules,
        source: Source,
        mut store: Box<dyn Store>,
    ) -> std::io::Result<Self> {
        let bytes = store.read()?;
        let (records, length) = record::read(&bytes);
        let mut records = records.into_iter();
        let begin = match records.next() {
            Some(Record::Begin(begin)) => {
                base(&begin).map(|base| (*begin, base)).ok_or("its document is damaged")
            }
            _ if bytes.is_empty() => Err(""),
            _ if bytes.starts_with(record::MAGIC) => Err("its beginning is damaged"),
            _ => Err("it is no journal"),
        };
        let (begin, base) = match begin {
            Ok(found) => found,
            Err(why) => {
                let editor = Self::new(document, rules);
                let editor = if why.is_empty() { editor } else { editor.without_journal(why) };
                return Ok(editor.journalled(Journal::new(store, source, true, 0)));
            }
        };
        let saved = document;
        let mut editor = Self::new(base, rules);
        let (mut steps, mut at) = (0_u32, 0);
        for record in records {
            match record {
                Record::Begin(_) => {}
                Record::Step(step) => {
                    let Some(_) = editor.make_again(step.name, step.gesture, &step.difference) else { break };
                    at = at.max(step.at);
                }
                Record::Undo => drop(editor.undo()),
                Record::Redo => drop(editor.redo()),
                Record::Abandon => editor.abandon_last(),
            }
            steps = steps.saturating_add(1);
        }
        editor.end_gesture();
        let torn = length < bytes.len();
        let done = u32::try_from(editor.steps()).unwrap_or(u32::MAX);
        let found = Found {
            restored: Restored { steps: done, at },
            file_changed: begin.source.hash != source.hash,
            source: begin.source.clone(),
            torn,
        };
        // Without a step there is nothing to restore.
        if steps == 0 {
            let editor = Self::new(saved, rules);
            let editor = if torn { editor.without_journal("its edits are damaged") } else { editor };
            return Ok(editor.journalled(Journal::new(store, source, true, 0)));
        }
        if torn {
            store.replace(bytes.get(..length).unwrap_or_default())?;
        }
        if !begin.saved || found.file_changed {
            editor.note_unsaved();
        }
        let journal = Journal::new(store, begin.source, begin.saved, length);
        Ok(editor.journalled(journal).restored(found, saved))
    }
}

fn base(begin: &Begin) -> Option<Document> {
    let mut document = Document::read(&begin.document, &Limits::default()).ok()?;
    document.encoding = if begin.encoding == Encoding::Xml { Encoding::Xml } else { Encoding::Binary };
    Some(document)
}
