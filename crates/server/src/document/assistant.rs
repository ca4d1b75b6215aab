//! What the program of an assistant asks of a document: its whole state, and steps that lead to others.
//!
//! The assistant works on a copy; what it makes of that comes as one step a call, made for the state of a revision. Where
//! somebody has changed the document since, the step is refused, and the copy is brought up to date first.

use std::sync::Arc;

use katydid_data::cast::Rules;
use katydid_definition::document::{Difference, Document};
use tokio::sync::oneshot;

use super::actor::Actor;

/// What each step of an assistant is called at first. Undo by an assistant takes back no other steps.
const MARK: &str = "Assistant: ";
/// What a step is called is cut after so many characters.
const LONGEST_NAME: usize = 200;

/// What an assistant asks.
#[derive(Debug)]
pub(crate) enum Question {
    /// The document, unless it is still at the revision that the assistant has.
    State { known: Option<u64> },
    /// A step from the state of a revision, and what it is called.
    Step { revision: u64, name: String, difference: Difference },
    /// The assistant's last step is taken back, or made again with `again`.
    Walk { revision: u64, again: bool },
}

/// How the document stands after that.
#[derive(Debug)]
pub(crate) struct State {
    pub(crate) revision: u64,
    pub(crate) name: String,
    pub(crate) rules: Rules,
    /// The name of the Rhino model beside it.
    pub(crate) model: Option<String>,
    /// Whether edits wait until the person has them solved.
    pub(crate) is_locked: bool,
    /// What was taken back or made again.
    pub(crate) step: Option<String>,
    /// The document, where the assistant does not have it yet.
    pub(crate) document: Option<Arc<Document>>,
}

/// A question, and where its answer goes.
pub(crate) type Asked = (Question, oneshot::Sender<Result<State, String>>);

impl Actor {
    /// Answers an assistant.
    pub(super) fn assistant(&mut self, (question, answer): Asked) {
        let told = self.answer_assistant(question);
        // Who has gone wants no answer.
        let _ = answer.send(told);
    }

    fn answer_assistant(&mut self, question: Question) -> Result<State, String> {
        match question {
            Question::State { known } => {
                if known.is_none() {
                    self.notice("remark", "an assistant has joined: its edits can be taken back".to_owned());
                }
                let document =
                    (known != Some(self.editor.revision())).then(|| Arc::clone(self.editor.document()));
                Ok(State { document, ..self.state(None) })
            }
            Question::Step { revision, name, difference } => {
                self.expect(revision)?;
                let mut after = Document::clone(self.editor.document());
                after.apply(&difference).map_err(|misfit| misfit.to_string())?;
                let name = format!("{MARK}{}", name.chars().take(LONGEST_NAME).collect::<String>());
                let change = self.editor.put_document(after, name, None);
                self.publish(&change);
                Ok(self.state(None))
            }
            Question::Walk { revision, again } => {
                self.expect(revision)?;
                let name = if again { self.editor.redo_name() } else { self.editor.undo_name() };
                let step = name.and_then(|name| name.strip_prefix(MARK)).map(str::to_owned);
                let Some(step) = step else {
                    return Err(match (name, again) {
                        (None, false) => "there is nothing to undo".to_owned(),
                        (None, true) => "there is nothing to do again".to_owned(),
                        (Some(name), _) => {
                            format!("\"{name}\" was done by the person, and is theirs to take back")
                        }
                    });
                };
                let change = if again { self.editor.redo() } else { self.editor.undo() };
                self.publish(&change.ok_or("the step does not fit the document any more")?);
                Ok(self.state(Some(step)))
            }
        }
    }

    /// # Errors
    /// The document has changed since.
    fn expect(&self, revision: u64) -> Result<(), String> {
        if revision == self.editor.revision() {
            return Ok(());
        }
        Err("the definition was changed in the studio meanwhile: read it again".to_owned())
    }

    fn state(&self, step: Option<String>) -> State {
        let about = self.editor.about();
        State {
            revision: self.editor.revision(),
            name: about.name.clone(),
            rules: self.editor.rules(),
            model: self.model.name().map(str::to_owned),
            is_locked: about.locked,
            step,
            document: None,
        }
    }
}
