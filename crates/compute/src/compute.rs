use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_component::{Cancel, Files};
use katydid_definition::archive::Limits;
use katydid_geometry::CancellationToken;
use katydid_solver::ScriptMaker;
use uuid::Uuid;

use crate::cache::{self, Definitions, Replies};
use crate::definition::files::DefinitionFiles;
use crate::reply::to_json;
use crate::request::{CacheControl, unpacked};
use crate::web::{Asked, Web};
use crate::{
    Answer, Bounds, Cause, Definition, Description, Fault, HopsSettings, RequestLimits, Solution,
    SolveRequest, WebSettings, solve,
};

/// What a [`Compute`] may use, for all requests.
#[derive(Debug, Clone)]
pub struct Settings {
    /// The most bytes that kept definitions with their default results may take, by estimate.
    pub cache_bytes: usize,
    /// The most bytes of replies that are kept for requests that ask for it.
    pub reply_bytes: usize,
    /// How much a request may bring.
    pub request: RequestLimits,
    /// How much a definition may ask for before it is refused.
    pub archive: Limits,
    /// Which files definitions may read: none unless said so.
    pub files: Files,
    /// The folders below which a pointer may name the file of a definition: none unless said so.
    pub definitions: Vec<PathBuf>,
    /// Which other hosts may be asked, for definitions and by Hops components: none unless said so.
    pub web: WebSettings,
    /// How Hops components ask them.
    pub hops: HopsSettings,
    /// What runs the scripts of definitions, each in a process of its own; none run unless it is there.
    pub scripts: Option<Arc<dyn ScriptMaker>>,
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
            archive: Limits { max_inflated: 128 << 20, ..Limits::default() },
            files: Files::None,
            definitions: Vec::new(),
            web: WebSettings::default(),
            hops: HopsSettings::default(),
            scripts: None,
            warnings: true,
        }
    }
}

/// Where the definition of a request is.
#[derive(Debug, Clone)]
pub enum Located {
    /// Here.
    Here(Arc<Definition>),
    /// At this URL, for [`Compute::fetch`]. A definition that was fetched before and is kept still is
    /// [`Here`](Self::Here).
    Url(String),
}

/// Solves definitions for requests. Shared by all of them.
#[derive(Debug)]
pub struct Compute {
    settings: Settings,
    definitions: Definitions,
    replies: Replies,
    files: DefinitionFiles,
    web: Arc<Web>,
}

/// No definition takes longer to fetch.
const FETCH: Duration = Duration::from_secs(20);

impl Compute {
    /// One that keeps nothing yet.
    pub fn new(settings: Settings) -> Self {
        katydid_components::link();
        Self {
            definitions: Definitions::new(settings.cache_bytes),
            replies: Replies::new(settings.reply_bytes),
            files: DefinitionFiles::below(&settings.definitions),
            web: Arc::new(Web::new(&settings.web)),
            settings,
        }
    }

    /// What it may use.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// How many definitions are kept, and how many bytes they take with their results, by estimate.
    pub fn kept(&self) -> (usize, usize) {
        self.definitions.size()
    }

    /// The definition that a request speaks of: by its pointer first, then by what it brings.
    ///
    /// # Errors
    /// `BadRequest` when it names none; `NotFound` when the pointer leads nowhere and nothing is brought; `Refused`
    /// for a path of a file that is not below the folders of the settings; as for [`load`](Self::load).
    pub fn locate(&self, request: &SolveRequest) -> Result<Located, Fault> {
        let algo = request.algo.as_deref().filter(|algo| !algo.trim().is_empty());
        let Some(pointer) = request.pointer() else {
            let algo = algo.ok_or_else(|| {
                Fault::bad_request("Unable to load grasshopper definition: neither algo nor pointer is given")
            })?;
            return self.load_with(algo, request.cache).map(Located::Here);
        };
        let scheme = pointer.split_once("://").map(|(scheme, _)| scheme.to_ascii_lowercase());
        let is_url = scheme.as_deref().is_some_and(|scheme| ["http", "https"].contains(&scheme));
        // What lies at a URL may be another definition now; what has a key of its text is always the same.
        if let Some(known) = self.cached(pointer).filter(|_| !is_url || request.cache.reads()) {
            return Ok(Located::Here(known));
        }
        if let Ok(component) = Uuid::parse_str(pointer) {
            let key = component.to_string();
            let make = || Definition::single(key.clone(), component);
            return self.definitions.get_or_make(&key, make).map(Located::Here);
        }
        if is_url {
            return Ok(Located::Url(pointer.to_owned()));
        }
        let is_key = pointer.starts_with("md5_");
        let read = if is_key {
            Err(Fault::not_found(
                "Unable to load grasshopper definition: it is not kept here, send it again as algo",
            ))
        } else {
            self.files.read(pointer, self.settings.request.bytes)
        };
        match (read, algo) {
            // The same key as for who sends the file.
            (Ok(bytes), _) => self.load_with(&STANDARD.encode(bytes), request.cache).map(Located::Here),
            (Err(_), Some(algo)) => self.load_with(algo, request.cache).map(Located::Here),
            (Err(fault), None) => Err(fault),
        }
    }

    /// The definition in a text: base64 of a .gh file, or of a .ghx file. It is read once for the same text, and
    /// kept under the key `md5_…` of the text.
    ///
    /// # Errors
    /// `BadRequest` when the text is no base64 of a definition.
    pub fn load(&self, algo: &str) -> Result<Arc<Definition>, Fault> {
        self.load_with(algo, CacheControl::Allowed)
    }

    /// The same for a request that may say that it is not to be kept.
    ///
    /// # Errors
    /// As for [`load`](Self::load).
    pub fn load_with(&self, algo: &str, cache: CacheControl) -> Result<Arc<Definition>, Fault> {
        let key = cache::key(algo);
        let make = || Definition::read(key.clone(), &decoded(algo)?, &self.settings.archive);
        if !cache.keeps() {
            return self.cached(&key).map_or_else(|| make().map(Arc::new), Ok);
        }
        self.definitions.get_or_make(&key, make)
    }

    /// The definition with that key, when it is kept still.
    pub fn cached(&self, key: &str) -> Option<Arc<Definition>> {
        self.definitions.get(key)
    }

    /// The definition of a request, when it is kept still; nothing is read or fetched.
    pub fn at_hand(&self, request: &SolveRequest) -> Option<Arc<Definition>> {
        let is_key = |pointer: &&str| request.cache.reads() || pointer.starts_with("md5_");
        let by_pointer = request.pointer().filter(is_key).and_then(|pointer| self.cached(pointer));
        by_pointer.or_else(|| self.cached(&cache::key(request.algo.as_deref()?)))
    }

    /// The definition in the bytes of a .gh or .ghx file, kept under a key of the caller's: a URL. It is read again
    /// only when the key is not kept any more.
    ///
    /// # Errors
    /// `BadRequest` when the bytes are no definition.
    pub fn load_bytes(&self, key: String, bytes: &[u8]) -> Result<Arc<Definition>, Fault> {
        let make = || Definition::read(key.clone(), bytes, &self.settings.archive);
        self.definitions.get_or_make(&key, make)
    }

    /// The definition at a URL, kept under it where that is allowed: fetched when it is not kept any more or must not be
    /// taken from there, in 20 seconds at most.
    ///
    /// # Errors
    /// `Refused` when the host may not be asked or sends elsewhere, `NotFound` when it does not answer or has no such
    /// thing, `TimedOut`, `Cancelled`, `TooLarge`, and `BadRequest` when there is no definition.
    pub fn fetch(
        &self,
        url: &str,
        time: Option<Duration>,
        cancel: &Cancel,
        cache: CacheControl,
    ) -> Result<Arc<Definition>, Fault> {
        if let Some(known) = self.cached(url).filter(|_| cache.reads()) {
            return Ok(known);
        }
        let time = time.map_or(FETCH, |time| time.min(FETCH));
        let go_on = || match cancel.is_cancelled() {
            true => Err(Fault::new(Cause::Cancelled, "The request was cancelled")),
            false => Ok(()),
        };
        let found = self.web.ask(Asked { url, body: None, key: None, time }, go_on)?;
        match found.status {
            200 if cache.reads() => self.load_bytes(url.to_owned(), &found.body),
            200 => {
                let read = Definition::read(url.to_owned(), &found.body, &self.settings.archive);
                let definition = Arc::new(read?);
                if cache.keeps() {
                    self.definitions.put(url, definition.clone());
                }
                Ok(definition)
            }
            300..400 => Err(Fault::refused("the definition is elsewhere: redirects are not followed")),
            status => Err(Fault::not_found(format!("the host of the definition answers {status}"))),
        }
    }

    /// What the definition asks for and gives: the reply of `/io`. It is kept with the definition.
    pub fn describe(&self, definition: &Definition) -> Arc<Description> {
        let (described, heavier) = definition.described();
        if heavier {
            self.definitions.trim();
        }
        described
    }

    /// Solves a request. It may be called from many threads at a time, for the same definition too.
    ///
    /// # Errors
    /// `BadRequest` when a value cannot be read or definitions call one another too often; `TimedOut`; `Cancelled`. An
    /// error of a component is none: see [`Solution::has_errors`].
    pub fn solve(
        &self,
        definition: &Arc<Definition>,
        request: &SolveRequest,
        bounds: &Bounds,
    ) -> Result<Solution, Fault> {
        let (solution, heavier) = solve::run(&self.settings, &self.web, definition, request, bounds)?;
        if heavier {
            self.definitions.trim();
        }
        Ok(solution)
    }

    /// Solves a request and writes its reply; a request that lets its reply be kept gets the one from last time.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve), and `BadRequest` when the definition has no outputs.
    pub fn answer(
        &self,
        definition: &Arc<Definition>,
        request: &SolveRequest,
        bounds: &Bounds,
    ) -> Result<Answer, Fault> {
        if definition.interface().outputs.is_empty() {
            return Err(Fault::bad_request(
                "The definition has no outputs: it needs a Context Bake, a Context Print or a group called RH_OUT:name",
            ));
        }
        let begin = Instant::now();
        let digest = (request.cache_solve && request.cache.keeps()).then(|| request.digest());
        let kept = digest.filter(|_| request.cache.reads());
        if let Some(body) = kept.and_then(|digest| self.replies.get(definition.key(), digest)) {
            let timings = crate::Timings { decode: begin.elapsed(), ..Default::default() };
            return Ok(Answer { body, has_errors: false, kept: true, timings });
        }
        let solution = self.solve(definition, request, bounds)?;
        let begin = Instant::now();
        let reply = solution.reply();
        let body = to_json(&reply)?;
        if !CancellationToken::has_room(body.len()) {
            return Err(Fault::failed("it was given up"));
        }
        let body: Arc<[u8]> = body.into();
        let has_errors = solution.has_errors();
        if let Some(digest) = digest.filter(|_| !has_errors && reply.errors.is_empty()) {
            self.replies.put(definition.key(), digest, body.clone());
        }
        let timings = crate::Timings { encode: begin.elapsed(), ..solution.timings() };
        Ok(Answer { body, has_errors, kept: false, timings })
    }
}

/// The bytes of a definition in a text.
fn decoded(algo: &str) -> Result<Vec<u8>, Fault> {
    unpacked(algo).map_err(|error| {
        Fault::bad_request(format!("Unable to load grasshopper definition: algo is no base64: {error}"))
    })
}
