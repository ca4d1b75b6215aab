//! Definitions that are copies of documents in a studio: brought up to date before each call, and changed by steps that
//! the studio takes first.

use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use katydid_definition::document::{Difference, Document};
use katydid_session::{Change, Editor};
use serde_json::{Value, json};

use crate::document::Opened;
use crate::fault::Fault;
use crate::store::{Store, StudioAddress, usual_rules};
use crate::studio::{Standing, Studio, There};
use crate::thresholds::{LONGEST_ADDRESS, MOST_DOCUMENTS};

/// The document of a studio that a definition is a copy of.
pub(crate) struct Original {
    studio: Studio,
    id: String,
    /// What it is called there.
    pub(crate) name: String,
    last: Mutex<Last>,
}

/// How the document stood there when it was asked last.
#[derive(Debug, Clone, Default)]
struct Last {
    revision: u64,
    model: Option<String>,
    is_locked: bool,
}

impl Last {
    fn of(standing: &Standing) -> Self {
        Self { revision: standing.revision, model: standing.model.clone(), is_locked: standing.locked }
    }
}

impl Original {
    fn last(&self) -> Last {
        self.last.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn note(&self, standing: &Standing) {
        *self.last.lock().unwrap_or_else(PoisonError::into_inner) = Last::of(standing);
    }

    /// Brings the copy up to date.
    fn follow(&self, what: &str, editor: &mut Editor) -> Result<(), Fault> {
        let refused = |why: String| Fault::new(what, &self.name, why);
        let standing = self.studio.state(&self.id, Some(self.last().revision)).map_err(refused)?;
        if let Some(document) = standing.document().map_err(refused)? {
            editor.put_document(document, "Changed in the studio".to_owned(), None);
        }
        self.note(&standing);
        Ok(())
    }

    /// Takes the assistant's last steps back, or makes them again, at most so many; what they are called.
    ///
    /// # Errors
    /// There is none, or the person has done something since: nothing has changed then.
    pub(crate) fn walk(
        &self,
        what: &str,
        editor: &mut Editor,
        again: bool,
        most: usize,
    ) -> Result<Vec<String>, Fault> {
        let mut steps = Vec::new();
        let mut revision = self.last().revision;
        while steps.len() < most {
            match self.studio.walk(&self.id, revision, again) {
                Ok(standing) => {
                    revision = standing.revision;
                    steps.extend(standing.step);
                }
                Err(why) if steps.is_empty() => return Err(Fault::new(what, &self.name, why)),
                Err(_) => break,
            }
        }
        self.follow(what, editor)?;
        Ok(steps)
    }

    /// What an assistant should know of the studio.
    pub(crate) fn told(&self) -> Value {
        let Last { model, is_locked, .. } = self.last();
        let mut told = json!({ "name": self.name });
        let mut notes = vec!["the person sees each edit at once, and can take it back".to_owned()];
        if is_locked {
            notes.push("there edits are not solved until the person says so".to_owned());
        }
        if let Some(model) = model {
            notes.push(format!(
                "the Rhino model {model} beside it is not reached from here: what refers to it has no results"
            ));
        }
        told["notes"] = json!(notes);
        told
    }
}

impl Opened {
    /// Brings a copy of a studio's document up to date; definitions of one's own are as they are.
    pub(crate) fn follow(&self, what: &str) -> Result<(), Fault> {
        let Some(original) = &self.original else { return Ok(()) };
        original.follow(what, &mut self.editor())
    }

    /// Makes a state of the document the one that counts, as one step; that of a studio first there.
    ///
    /// # Errors
    /// The studio does not take it: nothing has changed then.
    pub(crate) fn put(
        &self,
        what: &str,
        editor: &mut Editor,
        after: Document,
        name: String,
    ) -> Result<Change, Fault> {
        if let Some(original) = &self.original {
            let difference = Difference::between(editor.document(), &after);
            if !difference.is_empty() {
                let step = original.studio.step(&original.id, original.last().revision, &name, &difference);
                original.note(&step.map_err(|why| Fault::new(what, &original.name, why))?);
            }
        }
        Ok(editor.put_document(after, name, None))
    }
}

impl Store {
    /// # Errors
    /// The definitions are those of a studio.
    pub(crate) fn must_be_own(&self, what: &str) -> Result<(), Fault> {
        if self.config.studio.is_none() {
            return Ok(());
        }
        let why = "this program works on what is open in a studio: there the person makes, opens and closes definitions; edit_text \
                   can put a whole text in the place of one";
        Err(Fault::new(what, "", why))
    }

    /// Opens what was opened in the studio since the last call, and closes what was closed there.
    pub(crate) fn follow(&self, what: &str) -> Result<(), Fault> {
        let Some(address) = &self.config.studio else { return Ok(()) };
        let refused = |why: String| Fault::new(what, "studio", why);
        // One call at a time, so that no document is opened twice.
        let mut asked = self.studio();
        let text = text(address).map_err(refused)?;
        let studio = match &*asked {
            Some((before, studio)) if *before == text => studio.clone(),
            _ => {
                // The documents of a studio before have revisions of their own.
                self.keep_open(|_| false);
                let studio = Studio::new(&text).map_err(refused)?;
                *asked = Some((text, studio.clone()));
                studio
            }
        };
        let there = studio.documents().map_err(refused)?;
        let is_it = |one: &Opened, there: &There| {
            one.original.as_ref().is_some_and(|original| original.id == there.id)
        };
        self.keep_open(|one| there.iter().any(|there| is_it(one, there)));
        for one in there.into_iter().take(MOST_DOCUMENTS) {
            if !self.all().iter().any(|open| is_it(open, &one)) {
                self.join(what, &studio, one)?;
            }
        }
        Ok(())
    }

    fn join(&self, what: &str, studio: &Studio, there: There) -> Result<Arc<Opened>, Fault> {
        let refused = |why: String| Fault::new(what, &there.name, why);
        let standing = studio.state(&there.id, None).map_err(refused)?;
        let document = standing.document().map_err(refused)?;
        let document = document.ok_or_else(|| refused("the studio sent no document".to_owned()))?;
        let rules = standing.rules(usual_rules());
        let last = Mutex::new(Last::of(&standing));
        let original = Original { studio: studio.clone(), id: there.id, name: there.name, last };
        self.open_with(document, rules, None, None, Some(original))
    }
}

/// The address of a studio.
fn text(address: &StudioAddress) -> Result<String, String> {
    let path: &Path = match address {
        StudioAddress::Url(url) => return Ok(url.clone()),
        StudioAddress::File(path) => path,
    };
    let mut text = String::new();
    let read = File::open(path).and_then(|file| file.take(LONGEST_ADDRESS).read_to_string(&mut text));
    match read {
        Ok(_) => Ok(text.trim().to_owned()),
        Err(_) => Err(
            "no studio that lets assistants in is running: start one with katydid studio --allow-assistant"
                .to_owned(),
        ),
    }
}
