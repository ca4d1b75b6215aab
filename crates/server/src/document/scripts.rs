//! Whether a document's scripts run: who was asked, what they said, and what takes their word back.
//!
//! Whoever is at the machine answers, once for a file. What others change afterwards may be a script, or the text that a
//! script reads its code from: unless it can be neither, their edit takes the permission back. So does what is pasted
//! with scripts in it, whoever pastes it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use katydid_definition::document::Document;
use katydid_script::{CSharp, PythonMaker, Trusted, find, fingerprint};
use katydid_session::protocol::{Ask, Edit, ScriptPermission, ScriptsView, Setting};
use katydid_solver::{Refused, ScriptMaker, Scripts};

use super::ClientId;
use super::actor::Actor;
use super::clients::Standing;
use super::solving::Work;
use super::worker::Job;
use crate::ScriptConfig;
use crate::files::plain;

/// What to do about a script that did not run.
const ASKED: &str = "look at it and say whether it may run";
const REFUSED: &str = "it was told not to; Scripts in the File menu lets it";
const NOT_HERE: &str = "`katydid run FILE --allow-scripts` does";

/// Whether the scripts of a document run, and with what.
#[derive(Debug)]
pub(super) struct Scripting {
    config: Option<ScriptConfig>,
    permission: ScriptPermission,
    /// What its file is known by, as long as the document is what was read from it.
    fingerprint: Option<String>,
    path: Option<PathBuf>,
    /// Whether the answer holds for the file from now on, and for what it is saved as.
    is_kept: bool,
}

impl Scripting {
    pub(super) fn new(
        config: Option<ScriptConfig>,
        fingerprint: Option<String>,
        path: Option<PathBuf>,
    ) -> Self {
        let list = config.as_ref().and_then(|config| Trusted::read(config.trusted.as_deref()?).ok());
        let is_known = list.zip(fingerprint.as_ref()).is_some_and(|(list, own)| list.knows(own));
        let permission = if is_known { ScriptPermission::Given } else { ScriptPermission::Asked };
        Self { config, permission, fingerprint, path, is_kept: is_known }
    }

    /// What runs scripts as things stand. Those that can only compute run in any case.
    pub(super) fn scripts(&self) -> Arc<dyn Scripts> {
        Arc::new(CSharp::beside(self.with_permission()))
    }

    /// What runs scripts that need a permission.
    fn with_permission(&self) -> Arc<dyn Scripts> {
        let Some(config) = &self.config else { return Arc::new(Refused::new(NOT_HERE)) };
        match self.permission {
            ScriptPermission::Given => {
                let interpreter = find(config.python.as_deref(), self.path.as_deref());
                let definition = self.path.clone();
                PythonMaker { interpreter, bounds: config.bounds.clone(), definition }.make()
            }
            ScriptPermission::Asked => Arc::new(Refused::new(ASKED)),
            ScriptPermission::Refused => Arc::new(Refused::new(REFUSED)),
        }
    }

    /// What clients are told: nothing where there are no scripts that need a permission, or none
    /// are run here.
    pub(super) fn view(&self, document: &Document) -> Option<ScriptsView> {
        self.config.as_ref()?;
        let count = u32::try_from(katydid_session::scripts(document).len()).unwrap_or(u32::MAX);
        (count > 0).then_some(ScriptsView { count, permission: self.permission })
    }

    /// The file is another one now: what was allowed for good stays so.
    pub(super) fn saved(&mut self, bytes: &[u8], path: &Path) {
        self.fingerprint = Some(fingerprint(bytes));
        self.path = Some(path.to_owned());
        if self.is_kept && self.permission == ScriptPermission::Given {
            // What could not be kept is asked again.
            let _ = self.keep();
        }
    }

    fn keep(&self) -> Result<(), String> {
        let Some(list) = self.config.as_ref().and_then(|config| config.trusted.as_deref()) else {
            return Err(
                "there is no place to keep the answer: it holds while the document is open".to_owned()
            );
        };
        let Some(own) = &self.fingerprint else {
            return Err("what is open is no file: the answer holds while it is open".to_owned());
        };
        let name = self.path.as_ref().map(|path| path.display().to_string()).unwrap_or_default();
        Trusted::read(list)
            .and_then(|mut trusted| trusted.learn(own, &name))
            .map_err(|error| format!("the list of trusted files: {}", plain(&error)))
    }
}

/// Whether an edit may bring in a script, or change the text that one reads its code from.
fn may_bring_code(ask: &Ask) -> bool {
    match ask {
        Ask::Edit { edit, .. } => !matches!(
            edit,
            Edit::Move { .. }
                | Edit::Align { .. }
                | Edit::Resize { .. }
                | Edit::Arrange { .. }
                | Edit::Transform { .. }
                | Edit::Set {
                    to: Setting::Number { .. }
                        | Setting::Switch { .. }
                        | Setting::Press { .. }
                        | Setting::Grab { .. }
                        | Setting::Choose { .. }
                        | Setting::Colour { .. }
                        | Setting::Place { .. }
                        | Setting::Gene { .. },
                    ..
                }
        ),
        Ask::Undo | Ask::Redo | Ask::Settle { .. } => true,
        _ => false,
    }
}

/// Whether an edit of the owner's brings what others may have written.
fn is_paste(ask: &Ask) -> bool {
    matches!(ask, Ask::Edit { edit: Edit::Paste { .. }, .. })
}

impl Actor {
    /// Takes the permission back before what may bring in code is carried out.
    pub(super) fn look_at_scripts(&mut self, client: ClientId, ask: &Ask) {
        if self.scripting.permission != ScriptPermission::Given {
            return;
        }
        let is_owner = self.clients.get(client).is_some_and(|client| client.standing == Standing::Owner);
        let is_doubtful = if is_owner { is_paste(ask) && brings_scripts(ask) } else { may_bring_code(ask) };
        if is_doubtful {
            self.scripting.fingerprint = None;
            self.scripting.is_kept = false;
            self.permit(ScriptPermission::Asked);
        }
    }

    /// Does as the owner says.
    pub(super) fn allow_scripts(&mut self, client: ClientId, run: bool, keep: bool) -> Result<(), String> {
        if self.clients.get(client).is_none_or(|client| client.standing != Standing::Owner) {
            return Err(
                "only whoever is at the machine that runs Katydid can say whether scripts run".to_owned()
            );
        }
        if self.scripting.config.is_none() {
            return Err(format!("scripts are not run here; {NOT_HERE}"));
        }
        self.scripting.is_kept = run && keep;
        self.permit(if run { ScriptPermission::Given } else { ScriptPermission::Refused });
        if run
            && keep
            && let Err(why) = self.scripting.keep()
        {
            self.notice("warning", why);
        }
        Ok(())
    }

    fn permit(&mut self, permission: ScriptPermission) {
        self.scripting.permission = permission;
        let _ = self.jobs.send(Job::Scripts(self.scripting.scripts()));
        self.show_scripts();
        self.want(Work::Solve);
    }

    /// Tells clients of the scripts, when there are others than they know of.
    pub(super) fn show_scripts(&mut self) {
        let view = self.scripting.view(self.editor.document());
        if self.editor.about().scripts != view {
            self.editor.about_mut().scripts = view;
            self.publish_document();
        }
    }
}

/// Whether scripts may stand in what is pasted. It is XML or Katydid's text, where a script's text, its chunk or the id of
/// its component stands in the open; a cluster is taken for one that holds scripts.
fn brings_scripts(ask: &Ask) -> bool {
    let Ask::Edit { edit: Edit::Paste { text, .. }, .. } = ask else { return false };
    ["CodeInput", "Script", "ScriptParam", "ClusterDocument", "410755b1"]
        .iter()
        .any(|word| text.contains(word))
}
