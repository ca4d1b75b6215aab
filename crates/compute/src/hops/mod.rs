//! Hops components: definitions and components that another server solves.
//!
//! A server of components (ghhops-server, say) describes each of them at its own URL and solves at `/solve`. Any other
//! URL is that of a definition: its bytes go to the server of definitions that the settings name.

mod client;
mod protocol;

use std::collections::HashMap;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use katydid_component::{Access, Matching, Message};
use katydid_data::{Column, Path, Tree, TreeBuilder, Value};
use katydid_solver::{Question, Remote, Solved};

use crate::cache::lock;
use crate::solve::MOST_RECURSION;
use client::Client;
use protocol::{Described, Results};

/// Which servers the Hops components of definitions may ask, and for how much.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HopsSettings {
    /// The servers, as `host` or `host:port`. None at all unless said so.
    pub hosts: Vec<String>,
    /// The server that solves definitions which lie at a URL, as `http://host:port`; it may be asked too.
    pub compute: Option<String>,
    /// How long one answer may take.
    pub time: Duration,
    /// The most bytes of one answer.
    pub bytes: u64,
    /// The most calls that one component makes in a solve: one for each item of an input that takes items.
    pub calls: usize,
}

impl Default for HopsSettings {
    /// No server; 100 seconds, 50 MiB and 1000 calls.
    fn default() -> Self {
        Self {
            hosts: Vec::new(),
            compute: None,
            time: Duration::from_secs(100),
            bytes: 52_428_800,
            calls: 1000,
        }
    }
}

impl HopsSettings {
    /// Whether any server may be asked.
    pub(crate) fn is_on(&self) -> bool {
        !self.hosts.is_empty() || self.compute.is_some()
    }
}

/// Asks servers for the components of one request.
#[derive(Debug)]
pub(crate) struct Hops {
    settings: HopsSettings,
    client: Client,
    /// How many definitions called one another to come here.
    recursion: u32,
    /// What the locations that were asked so far describe.
    known: Mutex<HashMap<String, Arc<Described>>>,
}

impl Hops {
    pub(crate) fn new(settings: &HopsSettings, recursion: u32) -> Self {
        Self { client: Client::new(settings), settings: settings.clone(), recursion, known: Mutex::default() }
    }

    /// What is at a location.
    fn described(&self, question: &Question<'_>) -> Result<Arc<Described>, Message> {
        let location = question.location.trim();
        if let Some(known) = lock(&self.known).get(location) {
            return Ok(known.clone());
        }
        let described = Arc::new(protocol::describe(&self.client, &self.settings, question)?);
        lock(&self.known).insert(location.to_owned(), described.clone());
        Ok(described)
    }
}

impl Remote for Hops {
    fn solve(&self, question: &Question<'_>) -> Result<Solved, Message> {
        let recursion = self.recursion.saturating_add(1);
        if recursion > MOST_RECURSION {
            let text = format!("Definitions call one another more than {MOST_RECURSION} times");
            return Err(Message::error(text));
        }
        let described = self.described(question)?;
        let ports = described.inputs_for(question)?;
        let mut trees = Vec::with_capacity(ports.len());
        for (port, (_, tree)) in ports.iter().zip(&question.inputs) {
            let tree = if tree.is_empty() { port.default.clone() } else { tree.clone() };
            if tree.is_empty() && !port.optional {
                return Err(Message::warning(format!(
                    "Input parameter {} failed to collect data",
                    port.name
                )));
            }
            trees.push(tree);
        }
        let access: Vec<Access> = ports.iter().map(|port| port.access).collect();
        let matching = Matching::new(&trees, &access, None);
        if matching.iterations() > self.settings.calls {
            return Err(Message::error(format!(
                "{} calls are more than the {} that a component may make",
                matching.iterations(),
                self.settings.calls
            )));
        }
        let mut gathered = Gathered::new(question.outputs.len());
        for (set, path) in matching.paths().iter().enumerate() {
            for index in 0..matching.set_range(set).len() {
                question.budget.check()?;
                let ranges = matching.ranges(set);
                let values = ports.iter().zip(&trees).zip(ranges).map(|((port, tree), range)| {
                    (port.name.as_str(), part(tree, port.access, range.clone(), index))
                });
                let results = protocol::solve(&self.client, &described, values, recursion, question)?;
                gathered.add(path, results, &described, question);
            }
        }
        Ok(gathered.finish())
    }
}

/// What of a tree one call takes.
fn part(tree: &Tree, access: Access, range: std::ops::Range<usize>, index: usize) -> Tree {
    let (start, length) = match access {
        Access::Tree => return tree.clone(),
        Access::List => (range.start, range.len()),
        Access::Item => (range.start + index.min(range.len().saturating_sub(1)), range.len().min(1)),
    };
    let places: Vec<usize> = (start..start + length).collect();
    // Servers expect items and lists at this path, whatever theirs is.
    Tree::branch_at(Path::zero(), tree.column().gather(&places))
}

/// The results of all calls.
struct Gathered {
    outputs: Vec<TreeBuilder<Value>>,
    messages: Vec<Message>,
}

impl Gathered {
    fn new(outputs: usize) -> Self {
        Self { outputs: (0..outputs).map(|_| TreeBuilder::new()).collect(), messages: Vec::new() }
    }

    /// Adds the results of a call: single items go where the items of the inputs came from, trees keep their paths.
    fn add(&mut self, path: &Path, results: Results, described: &Described, question: &Question<'_>) {
        for message in results.messages {
            if !self.messages.contains(&message) {
                self.messages.push(message);
            }
        }
        for (k, builder) in self.outputs.iter_mut().enumerate() {
            let name = question.outputs.get(k).copied().unwrap_or_default();
            let Some(tree) = described.output_named(k, name, &results.values) else { continue };
            let single = tree.item_count() == 1;
            for branch in tree.branches() {
                builder.branch(if single { path.clone() } else { branch.path().clone() });
                branch.iter().for_each(|item| builder.push(item));
            }
        }
    }

    fn finish(self) -> Solved {
        let outputs = self.outputs.into_iter().map(TreeBuilder::finish).collect();
        Solved { outputs, messages: self.messages }
    }
}

/// A tree of one value; nothing for none.
fn single(value: Option<Value>) -> Tree {
    value
        .map_or_else(Tree::empty, |value| Tree::branch_at(Path::zero(), Column::of_values(vec![value], None)))
}
