//! The definitions that are open, and what all calls share.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

use katydid_component::{Origin, RhinoModel, Trust};
use katydid_data::DateTime;
use katydid_data::cast::Rules;
use katydid_definition::document::Document;
use katydid_geometry::Units;
use katydid_solver::{Options, Scripts};

use crate::attached::Original;
use crate::document::{Opened, limits};
use crate::fault::Fault;
use crate::folders::Folders;
use crate::studio::Studio;
use crate::thresholds::MOST_DOCUMENTS;

/// Gives what runs the scripts of a definition, by the file that it came from.
pub type ScriptsOf = dyn Fn(Option<&Path>) -> Arc<dyn Scripts> + Send + Sync;

/// What an assistant may do.
#[derive(Clone)]
pub struct Config {
    /// The folders whose files may be read and written; none for no files at all.
    pub folders: Vec<PathBuf>,
    /// The folder of a book whose pages are given as resources, besides the definitions that the program has.
    pub book: Option<PathBuf>,
    /// What runs scripts; none run without it.
    pub scripts: Option<Arc<ScriptsOf>>,
    /// The studio whose documents are worked on, in place of definitions of one's own.
    pub studio: Option<StudioAddress>,
    /// The most seconds of one solve.
    pub seconds: f64,
    /// The most bytes of one solve.
    pub bytes: u64,
}

/// Where a studio is.
#[derive(Clone)]
pub enum StudioAddress {
    /// Its address with the token, as it is printed.
    Url(String),
    /// The file in which the studio that was started last tells its address.
    File(PathBuf),
}

impl std::fmt::Debug for Config {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Config")
            .field("folders", &self.folders)
            .field("book", &self.book)
            .finish_non_exhaustive()
    }
}

impl Default for Config {
    /// No files, no scripts, two minutes and 2 GiB a solve.
    fn default() -> Self {
        Self { folders: Vec::new(), book: None, scripts: None, studio: None, seconds: 120.0, bytes: 2 << 30 }
    }
}

/// The definitions that are open.
pub(crate) struct Store {
    pub(crate) config: Config,
    pub(crate) folders: Folders,
    open: Mutex<Vec<Arc<Opened>>>,
    /// The studio that was asked last, with the text of its address.
    studio: Mutex<Option<(String, Studio)>>,
    documents: AtomicU64,
    jobs: AtomicU64,
}

impl Store {
    pub(crate) fn new(config: Config) -> Result<Self, String> {
        if let Some(StudioAddress::Url(url)) = &config.studio {
            Studio::new(url)?;
        }
        Ok(Self {
            folders: Folders::new(&config.folders)?,
            config,
            open: Mutex::default(),
            studio: Mutex::default(),
            documents: AtomicU64::new(0),
            jobs: AtomicU64::new(0),
        })
    }

    /// The definitions that are open, in the order in which they were opened.
    pub(crate) fn all(&self) -> Vec<Arc<Opened>> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The definition of that id; without one, the only one that is open.
    pub(crate) fn find(&self, what: &str, id: Option<&str>) -> Result<Arc<Opened>, Fault> {
        self.follow(what)?;
        let found = self.named(what, id)?;
        found.follow(what)?;
        Ok(found)
    }

    fn named(&self, what: &str, id: Option<&str>) -> Result<Arc<Opened>, Fault> {
        let all = self.all();
        let names = || match all.len() {
            0 if self.config.studio.is_some() => "none is open in the studio".to_owned(),
            0 => "none is open: call new_definition or open_definition".to_owned(),
            _ => format!("open are {}", all.iter().map(|one| one.id.as_str()).collect::<Vec<_>>().join(", ")),
        };
        match (id, all.as_slice()) {
            (Some(id), _) => all.iter().find(|one| one.id == id).cloned().ok_or_else(|| {
                Fault::new(
                    what,
                    format!("document \"{id}\""),
                    format!("there is no such definition: {}", names()),
                )
            }),
            (None, [one]) => Ok(Arc::clone(one)),
            (None, _) => Err(Fault::new(what, "document", format!("which definition is meant? {}", names()))),
        }
    }

    /// Opens a definition, which came from a file or was made here.
    pub(crate) fn open(
        &self,
        document: Document,
        units: Option<Units>,
        path: Option<PathBuf>,
        model: Option<RhinoModel>,
    ) -> Result<Arc<Opened>, Fault> {
        let mut rules = usual_rules();
        if let Some(model) = &model {
            (rules.units, rules.tolerance) = (model.units, model.tolerance);
        }
        rules.units = units.unwrap_or(rules.units);
        self.open_with(document, rules, path, model, None)
    }

    /// Opens a definition with its units and tolerances; one of a studio with where it is there.
    pub(crate) fn open_with(
        &self,
        document: Document,
        rules: Rules,
        path: Option<PathBuf>,
        model: Option<RhinoModel>,
        there: Option<Original>,
    ) -> Result<Arc<Opened>, Fault> {
        // Whoever asks is not the user: nothing but what is in the folders is read, wherever a definition comes from.
        let origin = path.as_deref().map_or(Origin::Sent, Origin::File);
        let files = Trust::shared(self.folders.all().to_vec()).files(origin);
        let options = Options {
            rules,
            limits: limits(self.config.seconds, self.config.bytes),
            files,
            model: model.map(Arc::new),
            scripts: self.config.scripts.as_ref().map(|of| of(path.as_deref())),
            ..Options::default()
        };
        let mut open = self.open.lock().unwrap_or_else(PoisonError::into_inner);
        if open.len() >= MOST_DOCUMENTS {
            let why = format!("{MOST_DOCUMENTS} are open already: close one");
            return Err(Fault::new("the definition was not opened", "", why));
        }
        let id = format!("d{}", self.documents.fetch_add(1, Ordering::Relaxed) + 1);
        let opened = Arc::new(Opened::new(id, document, options, path, there));
        open.push(Arc::clone(&opened));
        Ok(opened)
    }

    /// Closes a definition; its solve is given up.
    pub(crate) fn close(&self, id: &str) {
        self.keep_open(|one| one.id != id);
    }

    /// Closes all other definitions; their solves are given up.
    pub(crate) fn keep_open(&self, stays: impl Fn(&Opened) -> bool) {
        let mut open = self.open.lock().unwrap_or_else(PoisonError::into_inner);
        open.retain(|one| {
            let stays = stays(one);
            if !stays {
                one.give_up();
            }
            stays
        });
    }

    /// The studio that was asked last, with the text of its address; whoever holds it asks alone.
    pub(crate) fn studio(&self) -> MutexGuard<'_, Option<(String, Studio)>> {
        self.studio.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A number for a job.
    pub(crate) fn next_job(&self) -> u64 {
        self.jobs.fetch_add(1, Ordering::Relaxed) + 1
    }
}

/// Units and tolerances of a definition of which nobody says any.
pub(crate) fn usual_rules() -> Rules {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).ok().and_then(DateTime::since_1970);
    Rules { now, ..Rules::default() }
}

impl Drop for Store {
    fn drop(&mut self) {
        self.all().iter().for_each(|one| one.give_up());
    }
}
