//! Results of a definition that all requests have in common: of the objects that no input leads to.

use std::collections::HashSet;
use std::sync::{Arc, Mutex, OnceLock};

use katydid_component::Limits;
use katydid_data::cast::Rules;
use katydid_definition::archive;
use katydid_definition::document::{ClusterContent, Document, Object};
use katydid_solver::{Engine, HOPS, Options};

use crate::cache::lock;

/// How many combinations of units, tolerances and limits results are kept for.
const MOST_STATES: usize = 4;
/// How many sets of inputs are remembered as giving nothing new.
const MOST_SETS: usize = 64;

/// What a definition has solved so far, for each combination of units, tolerances and limits that was asked for.
#[derive(Debug, Default)]
pub(crate) struct States {
    /// The engine with nothing solved: what reads what is found out once.
    blank: OnceLock<Engine>,
    kept: Mutex<Vec<State>>,
}

/// The inputs of a request, by object and input.
type Set = Vec<(usize, usize)>;

#[derive(Debug)]
struct State {
    rules: Rules,
    limits: Limits,
    engine: Arc<Engine>,
    weight: usize,
    /// The sets of inputs that results were taken over from.
    learnt: HashSet<Set>,
}

impl State {
    fn is_for(&self, rules: &Rules, limits: &Limits) -> bool {
        // Each request has its own time, which what is kept does not hang on.
        self.rules == *rules && Limits { time: None, ..self.limits } == Limits { time: None, ..*limits }
    }
}

impl States {
    /// An engine for a request: with the results that there are, and all else still to be solved.
    pub(crate) fn engine(&self, document: &Document, options: Options) -> Engine {
        let known = lock(&self.kept);
        let known = known.iter().find(|state| state.is_for(&options.rules, &options.limits));
        let known = known.map(|state| state.engine.clone());
        let mut engine = match known {
            Some(engine) => Engine::clone(&engine),
            None => self.blank(document).clone(),
        };
        *engine.options_mut() = options;
        engine
    }

    /// An engine for a request that takes nothing from others.
    pub(crate) fn unsolved(&self, document: &Document, options: Options) -> Engine {
        let mut engine = self.blank(document).clone();
        *engine.options_mut() = options;
        engine
    }

    fn blank(&self, document: &Document) -> &Engine {
        self.blank.get_or_init(|| Engine::new(document.clone(), Options::default()))
    }

    /// Keeps what a solved request has in common with others; says whether there was anything.
    pub(crate) fn learn(&self, document: &Document, solved: &Engine, set: Set) -> bool {
        let options = solved.options();
        let mut kept = lock(&self.kept);
        let at = match kept.iter().position(|state| state.is_for(&options.rules, &options.limits)) {
            Some(at) => at,
            None => {
                if kept.len() == MOST_STATES {
                    kept.remove(0);
                }
                kept.push(State {
                    rules: options.rules,
                    limits: options.limits,
                    engine: Arc::new(self.blank(document).clone()),
                    weight: 0,
                    learnt: HashSet::new(),
                });
                kept.len() - 1
            }
        };
        let Some(state) = kept.get_mut(at) else { return false };
        if state.learnt.contains(&set) || state.learnt.len() == MOST_SETS {
            return false;
        }
        state.learnt.insert(set);
        let engine = Arc::make_mut(&mut state.engine);
        if engine.learn(solved, |object| !asks(object)) == 0 {
            return false;
        }
        state.weight = engine.weight();
        true
    }

    /// About how many bytes the results take.
    pub(crate) fn weight(&self) -> usize {
        lock(&self.kept).iter().map(|state| state.weight).sum()
    }

    /// Drops all results; gives the bytes that they took.
    pub(crate) fn forget(&self) -> usize {
        lock(&self.kept).drain(..).map(|state| state.weight).sum()
    }
}

/// Whether an object asks another server, or holds one that does: what it gives may be another tomorrow.
fn asks(object: &Object) -> bool {
    if object.component == HOPS {
        return true;
    }
    match object.cluster(&archive::Limits::default()) {
        // Clusters nest to a depth that the reader bounds.
        Some(Ok(ClusterContent::Open { document, .. })) => document.objects.iter().any(asks),
        _ => false,
    }
}
