//! A definition with what it asks for and what it gives.

mod defaults;
mod describe;
pub(crate) mod files;
mod headless;
mod interface;
mod single;

use std::sync::{Arc, OnceLock};

use katydid_definition::archive::Limits;
use katydid_definition::document::Document;
use katydid_solver::{Refused, ScriptMaker, Scripts};
use uuid::Uuid;

use crate::Fault;
use crate::cache::weigh;
use crate::solve::States;

use describe::describe;
pub use describe::{Description, InputDescription, OutputDescription};
pub(crate) use headless::idle_objects;
pub use interface::{Data, Form, Input, Interface, Output};

/// A definition that requests are solved on. It never changes, but for results that all requests have in common, which
/// it keeps.
#[derive(Debug)]
pub struct Definition {
    key: String,
    document: Document,
    interface: Interface,
    /// What it does, where its file does not say so.
    about: Option<&'static str>,
    weight: usize,
    states: States,
    /// What `/io` replies, once somebody has asked: defaults that are solids take longer to write than to send.
    described: OnceLock<Arc<Description>>,
    /// What runs its scripts, once a request has brought it to one: all requests share the process, which stays warm.
    scripts: OnceLock<Arc<dyn Scripts>>,
}

impl Definition {
    /// Reads the bytes of a .gh or .ghx file.
    ///
    /// # Errors
    /// `BadRequest` when they are no definition.
    pub(crate) fn read(key: String, bytes: &[u8], limits: &Limits) -> Result<Self, Fault> {
        if bytes.is_empty() {
            return Err(Fault::bad_request("Unable to load grasshopper definition: it is empty"));
        }
        let document = Document::read(bytes, limits)
            .map_err(|error| Fault::bad_request(format!("Unable to load grasshopper definition: {error}")))?;
        let interface = Interface::of(&document);
        Ok(Self::new(key, document, interface, None))
    }

    /// A definition of one component: what it takes is asked for, and what it gives is given.
    ///
    /// # Errors
    /// `NotFound` when there is no component of that type, `NotSupported` when it is known and not here.
    pub(crate) fn single(key: String, component: Uuid) -> Result<Self, Fault> {
        let (document, interface, about) = single::of(component)?;
        Ok(Self::new(key, document, interface, Some(about)))
    }

    fn new(key: String, document: Document, interface: Interface, about: Option<&'static str>) -> Self {
        let weight = key.len() + weigh::document(&document);
        let (states, described, scripts) = (States::default(), OnceLock::new(), OnceLock::new());
        Self { key, document, interface, about, weight, states, described, scripts }
    }

    /// The key by which it is known in later requests: `md5_…` for one that came as text, else what the caller gave.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The document as it came.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// What it asks for and gives.
    pub fn interface(&self) -> &Interface {
        &self.interface
    }

    /// About how many bytes of memory it takes, with the results that it keeps.
    pub fn weight(&self) -> usize {
        let described = self.described.get().map_or(0, |described| described.weight());
        self.weight.saturating_add(self.states.weight()).saturating_add(described)
    }

    /// What it asks for and gives, and whether it is heavier for having been asked.
    pub(crate) fn described(&self) -> (Arc<Description>, bool) {
        let heavier = self.described.get().is_none();
        (self.described.get_or_init(|| Arc::new(describe(self))).clone(), heavier)
    }

    /// What runs its scripts, or refuses to: the process that all requests share, or one that is for this request alone.
    pub(crate) fn scripts(&self, maker: Option<&dyn ScriptMaker>, shared: bool) -> Arc<dyn Scripts> {
        let make = || match maker {
            Some(maker) => maker.make(),
            None => Arc::new(Refused::new("this server was started without --allow-scripts")),
        };
        if shared { self.scripts.get_or_init(make).clone() } else { make() }
    }

    pub(crate) fn about(&self) -> Option<&str> {
        self.about
    }

    pub(crate) fn states(&self) -> &States {
        &self.states
    }
}
