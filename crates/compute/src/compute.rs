use std::sync::Arc;

use katydid_component::Files;

use crate::{Answer, Bounds, Definition, Description, Fault, RequestLimits, Solution, SolveRequest};

/// What a [`Compute`] may use, for all requests.
#[derive(Debug, Clone)]
pub struct Settings {
    /// The most bytes that kept definitions with their default results may take, by estimate.
    pub cache_bytes: usize,
    /// The most bytes of replies that are kept for requests that ask for it.
    pub reply_bytes: usize,
    /// How much a request may bring.
    pub request: RequestLimits,
    /// Which files definitions may read: none unless said so.
    pub files: Files,
    /// Whether replies tell what components warned of. Rhino.Compute does so in its debug mode only.
    pub warnings: bool,
}

impl Default for Settings {
    /// 256 MiB of definitions, 64 MiB of replies, no files, with warnings.
    fn default() -> Self {
        Self {
            cache_bytes: 256 << 20,
            reply_bytes: 64 << 20,
            request: RequestLimits::default(),
            files: Files::None,
            warnings: true,
        }
    }
}

/// Where the definition of a request is.
#[derive(Debug, Clone)]
pub enum Located {
    /// Here.
    Here(Arc<Definition>),
    /// At this URL: whoever may fetch it does, and hands it to [`Compute::load_bytes`] with the URL as key. A
    /// definition that was fetched before and is kept still is [`Here`](Self::Here).
    Url(String),
}

/// Solves definitions for requests. Shared by all of them.
#[derive(Debug)]
pub struct Compute {
    settings: Settings,
}

impl Compute {
    /// One that keeps nothing yet.
    pub fn new(settings: Settings) -> Self {
        Self { settings }
    }

    /// What it may use.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The definition that a request speaks of: by its pointer first, then by what it brings.
    ///
    /// # Errors
    /// `BadRequest` when it names none; `NotFound` when the pointer leads nowhere and nothing is brought; `Refused`
    /// for a path of a file; as for [`load`](Self::load).
    pub fn locate(&self, request: &SolveRequest) -> Result<Located, Fault> {
        let _ = request;
        Err(Fault::not_supported("locate"))
    }

    /// The definition in a text: base64 of a .gh file, or of a .ghx file. It is read once for the same text, and
    /// kept under the key `md5_…` of the text.
    ///
    /// # Errors
    /// `BadRequest` when the text is no base64 of a definition.
    pub fn load(&self, algo: &str) -> Result<Arc<Definition>, Fault> {
        let _ = algo;
        Err(Fault::not_supported("load"))
    }

    /// The definition with that key, when it is kept still.
    pub fn cached(&self, key: &str) -> Option<Arc<Definition>> {
        let _ = key;
        None
    }

    /// The definition in the bytes of a .gh or .ghx file, kept under a key of the caller's: a URL.
    ///
    /// # Errors
    /// `BadRequest` when the bytes are no definition.
    pub fn load_bytes(&self, key: String, bytes: &[u8]) -> Result<Arc<Definition>, Fault> {
        let _ = (key, bytes);
        Err(Fault::not_supported("load_bytes"))
    }

    /// What the definition asks for and gives: the reply of `/io`.
    pub fn describe(&self, definition: &Definition) -> Description {
        Description { description: String::new(), cache_key: definition.key().to_owned() }
    }

    /// Solves a request. It may be called from many threads at a time, for the same definition too.
    ///
    /// # Errors
    /// `BadRequest` when the definition gives nothing or a value cannot be read; `TimedOut` and `Cancelled`;
    /// `TooLarge`. An error of a component is none: see [`Solution::has_errors`].
    pub fn solve(
        &self,
        definition: &Arc<Definition>,
        request: &SolveRequest,
        bounds: &Bounds,
    ) -> Result<Solution, Fault> {
        let _ = (definition, request, bounds);
        Err(Fault::not_supported("solve"))
    }

    /// Solves a request and writes its reply; a request that lets its reply be kept gets the one from last time.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn answer(
        &self,
        definition: &Arc<Definition>,
        request: &SolveRequest,
        bounds: &Bounds,
    ) -> Result<Answer, Fault> {
        let _ = self.solve(definition, request, bounds)?;
        Err(Fault::not_supported("answer"))
    }
}
