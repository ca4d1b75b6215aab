//! Hops components: definitions and components that are solved elsewhere, or that lie elsewhere and are solved here.
//!
//! A server of components (ghhops-server, say) describes each of them at its own URL and solves at `/solve`. Any other
//! URL is that of a definition: a server of definitions solves it where the settings name one, and else it is solved
//! here. A definition that the component keeps in itself, or one in a file that may be read, is solved so too.

mod protocol;
mod result;

use std::collections::HashMap;
use std::ops::Range;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use katydid_component::{Access, Matching, Message, Ranges};
use katydid_data::{Path, Tree};
use katydid_solver::{Question, Remote, Solved};

use crate::cache::lock;
use crate::solve::MOST_RECURSION;
use crate::web::{Asked, HostKey, Response, Web};
use crate::{Fault, Settings};
use protocol::Described;
use result::Gathered;

/// How the Hops components of definitions ask the hosts that may be asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HopsSettings {
    /// The server that solves definitions which lie elsewhere, as `http://host:port`; its host is listed too. Without
    /// one they are solved here.
    pub server: Option<String>,
    /// The keys that hosts ask for: of several for one host the first counts.
    pub keys: Vec<HostKey>,
    /// How long one answer may take.
    pub time: Duration,
    /// The most calls that one component makes in a solve: one for each item of an input that takes items.
    pub calls: usize,
}

impl Default for HopsSettings {
    /// No server of definitions and no keys; 100 seconds and 1000 calls.
    fn default() -> Self {
        Self { server: None, keys: Vec::new(), time: Duration::from_secs(100), calls: 1000 }
    }
}

/// What the Hops components of a definition ask through.
pub fn hops(settings: &Settings) -> Arc<dyn Remote> {
    Arc::new(Hops::new(settings, Arc::new(Web::new(&settings.web)), 0))
}

/// Answers the components of one request.
#[derive(Debug)]
pub(crate) struct Hops {
    settings: Settings,
    web: Arc<Web>,
    /// How many definitions called one another to come here.
    recursion: u32,
    /// What lies where, of what was asked for so far; by component where it keeps its own definition.
    known: Mutex<HashMap<String, Arc<Described>>>,
}

impl Hops {
    pub(crate) fn new(settings: &Settings, web: Arc<Web>, recursion: u32) -> Self {
        Self { settings: settings.clone(), web, recursion, known: Mutex::default() }
    }

    /// What is at a location.
    fn described(&self, question: &Question<'_>) -> Result<Arc<Described>, Message> {
        let name = match question.kept {
            Some(_) => question.component.to_string(),
            None => question.location.trim().to_owned(),
        };
        if let Some(known) = lock(&self.known).get(&name) {
            return Ok(known.clone());
        }
        let described = Arc::new(self.describe(question)?);
        lock(&self.known).insert(name, described.clone());
        Ok(described)
    }

    /// Asks a host, as long as the work may go on.
    fn ask(&self, url: &str, body: Option<Vec<u8>>, question: &Question<'_>) -> Result<Response, Message> {
        let time =
            question.limits.time.map_or(self.settings.hops.time, |left| left.min(self.settings.hops.time));
        let go_on = || question.budget.check().map_err(|message| Fault::failed(message.text));
        let key = self.settings.hops.keys.iter().find_map(|key| key.for_address(url)).map(str::to_owned);
        self.web.ask(Asked { url, body, key, time }, go_on).map_err(|fault| {
            // What the solve itself ran out of says so in its own words.
            question.budget.check().err().unwrap_or_else(|| Message::error(fault.message))
        })
    }
}

impl Remote for Hops {
    fn solve(&self, question: &Question<'_>) -> Result<Solved, Message> {
        if self.recursion >= MOST_RECURSION {
            let text = format!("Definitions call one another more than {MOST_RECURSION} times");
            return Err(Message::error(text));
        }
        let described = self.described(question)?;
        let ports = described.inputs_for(question)?;
        let mut trees = Vec::with_capacity(ports.len());
        for (port, (_, tree)) in ports.iter().zip(&question.inputs) {
            let tree = if tree.is_empty() { port.default.clone() } else { tree.clone() };
            if tree.is_empty() && !port.optional {
                let text = format!("Input parameter {} failed to collect data", port.name);
                return Err(Message::warning(text));
            }
            trees.push(tree);
        }
        let access: Vec<Access> = ports.iter().map(|port| port.access).collect();
        let matching = Matching::new(&trees, &access, None);
        let (calls, most) = (matching.iterations(), self.settings.hops.calls);
        if calls > most {
            let text = format!("{calls} calls are more than the {most} that a component may make");
            return Err(Message::error(text));
        }
        let has_branches = trees.iter().any(|tree| tree.branch_count() > 1);
        let mut gathered = Gathered::new(question.outputs.len(), has_branches);
        let mut ranges = Ranges::new();
        for (set, path) in matching.paths().iter().enumerate() {
            matching.ranges(set, &mut ranges);
            for index in 0..matching.set_range(set).len() {
                question.budget.check()?;
                let values = ports.iter().zip(&trees).zip(&ranges).map(|((port, tree), range)| {
                    (port.name.as_str(), part(tree, port.access, range.clone(), index))
                });
                let results = self.call(&described, values, question)?;
                gathered.add(path, results, &described, question);
            }
        }
        Ok(gathered.finish())
    }
}

/// What of a tree one call takes.
fn part(tree: &Tree, access: Access, range: Range<usize>, index: usize) -> Tree {
    let (start, length) = match access {
        Access::Tree => return tree.clone(),
        Access::List => (range.start, range.len()),
        Access::Item => (range.start + index.min(range.len().saturating_sub(1)), range.len().min(1)),
    };
    let places: Vec<usize> = (start..start + length).collect();
    // Servers expect items and lists at this path, whatever theirs is.
    Tree::branch_at(Path::zero(), tree.column().gather(&places))
}
