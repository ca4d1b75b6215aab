//! A document that is open: who owns it, who solves it, and who is told.
//!
//! [`actor`] is the thread that owns the editor; all that happens to a document passes it in turn. [`worker`] is the
//! thread that owns the engine: it hears of changes and solves when it is told to. [`outbox`] is what one client has yet
//! to hear.

mod actor;
mod asked;
pub(crate) mod assistant;
mod clients;
mod drawn;
mod journal;
mod model;
mod outbox;
mod scripts;
mod solving;
mod source;
mod studies;
mod worker;

use std::sync::Arc;
use std::sync::mpsc::Sender;
use std::time::Duration;

use katydid_component::{RhinoModel, Trust};
use katydid_solver::Engine;
use tokio::sync::oneshot;

use crate::files::Form;
use crate::geometry::Geometries;
use katydid_session::protocol::Request;

pub(crate) use clients::Standing;
pub(crate) use journal::left_behind;
pub(crate) use katydid_studio::ClientId;
pub(crate) use outbox::{Message, Outbox};
pub(crate) use source::{Source, id_of};

/// What a document is asked or told.
pub(crate) enum Command {
    /// A client wants to see it.
    Join(ClientId, Arc<Outbox>, Standing),
    /// A client is gone.
    Leave(ClientId),
    /// A client was too slow: it wants everything anew.
    Refresh(ClientId),
    /// A client asks.
    Ask(ClientId, Box<Request>),
    /// Its bytes in a form, and a name for the file.
    Bytes(Form, oneshot::Sender<Result<Download, String>>),
    /// A Rhino model that its parameters refer to.
    Model(Attached, oneshot::Sender<()>),
    /// Something to be done with the results when no solve is running.
    With(Inquiry),
    /// A picture that it holds, by its name, with its media type.
    Picture(String, oneshot::Sender<Option<(Vec<u8>, &'static str)>>),
    /// How it stands.
    About(oneshot::Sender<About>),
    /// What the worker tells.
    Work(worker::News),
    /// Inputs that were found for a wanted result.
    Found(studies::Found),
    /// What the program of an assistant asks.
    Assistant(assistant::Asked),
    /// The end.
    Close(oneshot::Sender<()>),
}

/// A Rhino model beside a document.
#[derive(Debug, Clone)]
pub(crate) struct Attached {
    /// The name of its file.
    pub(crate) name: String,
    pub(crate) model: Arc<RhinoModel>,
}

/// Something to be done with an engine between two solves.
pub(crate) type Inquiry = Box<dyn FnOnce(&Engine) + Send>;

/// A file to be kept by a browser.
pub(crate) struct Download {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
}

/// How a document stands.
#[derive(Debug, Clone)]
pub(crate) struct About {
    pub(crate) name: String,
    pub(crate) changed: bool,
    /// Whether it is only shown for a while.
    pub(crate) is_passing: bool,
    /// How many clients show it.
    pub(crate) clients: usize,
}

/// A document that is open.
#[derive(Debug, Clone)]
pub(crate) struct Handle {
    commands: Sender<Command>,
}

/// An inquiry waits so long for a solve to end.
const WAIT: Duration = Duration::from_secs(120);

impl Handle {
    /// Opens a document: its threads live until it is closed.
    pub(crate) fn open(source: Source, shared: Arc<Shared>) -> std::io::Result<Self> {
        let (commands, inbox) = std::sync::mpsc::channel();
        let own = commands.clone();
        std::thread::Builder::new()
            .name("document".to_owned())
            .spawn(move || actor::Actor::new(source, shared, own).run(&inbox))?;
        Ok(Self { commands })
    }

    /// Tells it something; `false` when it is closed.
    pub(crate) fn tell(&self, command: Command) -> bool {
        self.commands.send(command).is_ok()
    }

    /// Asks it something that it answers by itself.
    pub(crate) async fn ask<T>(&self, question: impl FnOnce(oneshot::Sender<T>) -> Command) -> Option<T> {
        let (answer, waiting) = oneshot::channel();
        self.tell(question(answer)).then_some(())?;
        waiting.await.ok()
    }

    /// Does something with the results, once no solve is running.
    pub(crate) async fn with<T: Send + 'static>(
        &self,
        work: impl FnOnce(&Engine) -> T + Send + 'static,
    ) -> Result<T, String> {
        let (answer, waiting) = oneshot::channel();
        let inquiry = Box::new(move |engine: &Engine| {
            let _ = answer.send(work(engine));
        });
        if !self.tell(Command::With(inquiry)) {
            return Err("the document is closed".to_owned());
        }
        match tokio::time::timeout(WAIT, waiting).await {
            Ok(Ok(done)) => Ok(done),
            Ok(Err(_)) => {
                Err("it could not be made: this is a fault of Katydid, please report it".to_owned())
            }
            Err(_) => Err("the definition is still being solved: wait for it or cancel it".to_owned()),
        }
    }
}

/// What all documents share.
#[derive(Debug, Default)]
pub(crate) struct Shared {
    pub(crate) geometries: Geometries,
    pub(crate) recent: Option<crate::files::Recent>,
    /// Pictures of definitions that are not open.
    pub(crate) portraits: crate::files::Portraits,
    /// The folder of journals.
    pub(crate) journals: Option<std::path::PathBuf>,
    /// Who works on the documents, and what they may therefore read of this machine.
    pub(crate) trust: Trust,
    /// What runs their scripts once somebody lets them.
    pub(crate) scripts: Option<crate::ScriptConfig>,
}
