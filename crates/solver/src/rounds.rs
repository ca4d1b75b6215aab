//! Solves a loop: what lies between its start and its end, again and again, with the state that the end takes in given out by
//! the start in the next round.
//!
//! A definition is run once, so that a loop that a user would watch is run to its end, and all its objects show the last round.

use std::collections::HashMap;
use std::sync::Mutex;

use katydid_component::{Budget, Message};
use katydid_data::{Kind, Tree, Value, cast};
use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::{Object, Port};

use crate::engine::solve_object;
use crate::graph::{Graph, Source};
use crate::object::{Turn, output};
use crate::region::{Region, Step};
use crate::report::{ObjectReport, Status};
use crate::{collect, outside};

/// A loop makes no more rounds than this, whatever its count says: days of work are a mistake.
const MOST_ROUNDS: u32 = 10_000_000;

/// A loop without a count makes no more rounds than this: its exit condition would have come.
const MOST_ROUNDS_WITHOUT_COUNT: u32 = 100_000;

/// What the objects of a region gave in the last round.
type LastRound = HashMap<usize, ObjectReport>;

/// Runs the rounds of an outermost loop. Gives the report of its end, and puts those of its other objects into `last_round`.
pub(crate) fn solve<'a>(
    turn: &Turn<'_>,
    graph: &Graph,
    region: &Region,
    tree: &dyn Fn(&Source) -> Option<&'a Tree>,
    last_round: &Mutex<LastRound>,
) -> ObjectReport {
    let mut made = LastRound::new();
    let rounds = Rounds { turn, graph, outside: tree };
    let report = rounds.run(region, &mut made);
    made.remove(&region.end);
    if let Ok(mut all) = last_round.lock() {
        all.extend(made);
    }
    report
}

/// The report of an end without rounds, which says why.
pub(crate) fn refused(mut report: ObjectReport) -> ObjectReport {
    report.messages.push(Message::error(
        "This loop was not run: it crosses another one, shares its start with one, lies in too many, or its objects read each \
         other in a circle",
    ));
    report.status = Status::Error;
    report
}

/// What the rounds of a loop and of those in it have in common.
struct Rounds<'r, 'a> {
    turn: &'r Turn<'r>,
    graph: &'r Graph,
    /// What objects outside of the loop gave.
    outside: &'r dyn Fn(&Source) -> Option<&'a Tree>,
}

/// Which ports of a loop's two objects do what.
#[derive(Debug, Default)]
struct Ports {
    /// Of the start: the input with the number of rounds, and those that the state begins with.
    count: Option<usize>,
    first: Vec<usize>,
    /// Of the start: for each output what it gives.
    gives: Vec<Gives>,
    /// Of the end: the inputs that the state comes in by, and the one that stops the loop.
    next: Vec<usize>,
    exit: Option<usize>,
    /// What the exit condition has to be for the loop to stop.
    stops_at: bool,
    /// Of the end: for each output, what it gives.
    results: Vec<Gives>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Gives {
    Link,
    Counter,
    State(usize),
    /// All states of the first part, round by round.
    History,
}

impl Ports {
    /// The ports of a start and an end, told by their names: files of several versions differ in how many there are.
    fn of(start: &Object, end: &Object) -> Self {
        let mut ports = Self { stops_at: true, ..Self::default() };
        for (k, port) in start.inputs.iter().enumerate() {
            let name = port.name.to_lowercase();
            match k {
                0 => ports.count = Some(k),
                _ if name.contains("trigger") || name.contains("reset") => {}
                _ => ports.first.push(k),
            }
        }
        let mut state = 0..;
        let mut give = |k: usize, port: &Port| match k {
            0 => Gives::Link,
            1 if port.name.to_lowercase().contains("count")
                || ["C", "i", "I"].contains(&port.nickname.as_str()) =>
            {
                Gives::Counter
            }
            _ => Gives::State(state.next().unwrap_or_default()),
        };
        ports.gives = start.outputs.iter().enumerate().map(|(k, port)| give(k, port)).collect();
        for (k, port) in end.inputs.iter().enumerate().skip(1) {
            let name = port.name.to_lowercase();
            let is_exit =
                name.contains("exit") || name.contains("stop") || outside::kind(port) == Kind::Boolean;
            if is_exit && ports.exit.is_none() {
                ports.exit = Some(k);
            } else {
                ports.next.push(k);
            }
        }
        ports.results = (0..end.outputs.len()).map(Gives::State).collect();
        ports
    }

    /// Those of a HoopSnake: what it begins with, what comes back, and whether to go on; it gives the state and its history.
    fn of_snake(snake: &Object) -> Self {
        let results: Vec<Gives> =
            [Gives::State(0), Gives::History, Gives::Counter].into_iter().take(snake.outputs.len()).collect();
        Self {
            count: None,
            first: vec![0],
            gives: results.clone(),
            next: vec![1],
            exit: (snake.inputs.len() > 2).then_some(2),
            stops_at: false,
            results,
        }
    }
}

impl Rounds<'_, '_> {
    /// Runs all rounds of a region. Its objects' reports are in `made` then, its end's too.
    fn run(&self, region: &Region, made: &mut LastRound) -> ObjectReport {
        let objects = &self.turn.document.objects;
        let (Some(start), Some(end)) = (objects.get(region.start), objects.get(region.end)) else {
            return ObjectReport::idle(Status::Ok, Vec::new(), 0);
        };
        let snake = region.start == region.end;
        let ports = if snake { Ports::of_snake(start) } else { Ports::of(start, end) };
        let result = self.rounds(region, start, end, &ports, made);
        let report = result
            .unwrap_or_else(|message| ObjectReport::idle(Status::Error, vec![message], end.outputs.len()));
        // Objects that were never reached, as the time was over before the first round.
        for at in region.all.iter().filter(|at| **at != region.end) {
            let outputs = objects.get(*at).map_or(0, |object| object.outputs.len());
            made.entry(*at).or_insert_with(|| ObjectReport::idle(Status::NoData, Vec::new(), outputs));
        }
        made.insert(region.end, report.clone());
        report
    }

    fn rounds(
        &self,
        region: &Region,
        start: &Object,
        end: &Object,
        ports: &Ports,
        made: &mut LastRound,
    ) -> Result<ObjectReport, Message> {
        let turn = self.turn;
        let budget = Budget::new(
            turn.options.limits,
            turn.options.cancel.clone(),
            turn.deadline,
            turn.account.clone(),
        );
        let mut messages = Vec::new();
        let mut state: Vec<Tree> =
            ports.first.iter().map(|k| self.input(region.start, start, *k, made, &mut messages)).collect();
        let count = self.count(region, start, ports, made, &mut messages);
        let is_exit_wired =
            ports.exit.and_then(|k| end.inputs.get(k)).is_some_and(|port| !port.sources.is_empty());
        if count.is_none() && !is_exit_wired && region.start != region.end {
            return Err(Message::error(format!(
                "{} has neither a number of rounds nor an exit condition in {}: such a loop has no end",
                start.title(),
                end.title()
            )));
        }
        // A snake whose way on is not said is fed by its user's hand: it shows what it begins with.
        let count = match count {
            None if !is_exit_wired => Some(0),
            count => count,
        };
        let most = count.unwrap_or(MOST_ROUNDS_WITHOUT_COUNT).min(MOST_ROUNDS);
        let keeps = ports.results.contains(&Gives::History) || records(end);
        let mut record = Record::new(if keeps { ports.next.len() } else { 0 });
        let stopped = |round: u32, why: &str| {
            Message::error(format!("The loop of {} was stopped after {round} rounds: {why}", end.title()))
        };
        let mut round = 0;
        loop {
            budget.check().map_err(|message| stopped(round, &message.text))?;
            let mut said = messages.clone();
            let outputs = (0..start.outputs.len())
                .map(|k| output(start, k, give(ports.gives.get(k), round, &state), turn.options, &mut said))
                .collect();
            let status = ObjectReport::status_of(&said);
            made.insert(region.start, ObjectReport { outputs, ..ObjectReport::idle(status, said, 0) });
            for step in &region.steps {
                match step {
                    Step::Object(at) => {
                        let report = {
                            let tree = |source: &Source| self.tree(source, made);
                            solve_object(turn, self.graph, *at, &tree)
                        };
                        made.insert(*at, report);
                    }
                    Step::Rounds(inner) => {
                        self.run(inner, made);
                    }
                }
            }
            // A loop of no rounds hands on what it began with; its objects show what they would do with that.
            if count == Some(0) {
                break;
            }
            let mut said = Vec::new();
            let next: Vec<Tree> =
                ports.next.iter().map(|k| self.input(region.end, end, *k, made, &mut said)).collect();
            let exits = match ports.exit {
                Some(k) => is_any(
                    &self.input(region.end, end, k, made, &mut said),
                    ports.stops_at,
                    &turn.options.rules,
                ),
                None => false,
            };
            round += 1;
            record.add(&next, round - 1, turn).map_err(|why| stopped(round, &why))?;
            for (k, tree) in next.into_iter().enumerate() {
                match state.get_mut(k) {
                    Some(part) => *part = tree,
                    // The end may take in more than the start gives out.
                    None => state.push(tree),
                }
            }
            if exits || count.is_some_and(|count| round >= count) && round <= most {
                messages = said;
                break;
            }
            if round >= most {
                return Err(stopped(round, "no more are made; its exit condition did not come"));
            }
        }
        let results = if records(end) { record.trees() } else { state.clone() };
        let history = record.trees().into_iter().next().unwrap_or_default();
        let outputs = ports
            .results
            .iter()
            .enumerate()
            .map(|(k, gives)| {
                let tree = match gives {
                    Gives::History => history.clone(),
                    gives => give(Some(gives), round, &results),
                };
                output(end, k, tree, turn.options, &mut messages)
            })
            .collect();
        let status = ObjectReport::status_of(&messages);
        Ok(ObjectReport { outputs, ..ObjectReport::idle(status, messages, 0) })
    }

    /// What a source gives: an object of the loop in this round, another as it is.
    fn tree<'m>(&'m self, source: &Source, made: &'m LastRound) -> Option<&'m Tree> {
        match made.get(&source.object) {
            Some(report) => report.outputs.get(source.output),
            None => (self.outside)(source),
        }
    }

    /// The data of an input of one of the loop's two objects.
    fn input(
        &self,
        index: usize,
        object: &Object,
        k: usize,
        made: &LastRound,
        messages: &mut Vec<Message>,
    ) -> Tree {
        let Some(port) = object.inputs.get(k) else { return Tree::empty() };
        let options = self.turn.options;
        let collected = match self.turn.brought.get(&(index, k)) {
            Some(tree) => collect::brought(object, port, None, tree, options),
            None => {
                let sources = self.graph.sources.get(index).and_then(|inputs| inputs.get(k));
                let wires: Vec<&Tree> =
                    sources.into_iter().flatten().filter_map(|source| self.tree(source, made)).collect();
                collect::port(object, port, None, &wires, options)
            }
        };
        messages.extend(collected.messages);
        collected.tree
    }

    /// How many rounds are asked for: none where the input has no data, or a number below zero.
    fn count(
        &self,
        region: &Region,
        start: &Object,
        ports: &Ports,
        made: &LastRound,
        messages: &mut Vec<Message>,
    ) -> Option<u32> {
        let tree = self.input(region.start, start, ports.count?, made, messages);
        let numbers = collect::cast_to(tree, Kind::Integer, &self.turn.options.rules, messages);
        let first = numbers.column().iter().flatten().next()?;
        match first {
            Value::Integer(count) => u32::try_from(count).ok(),
            _ => None,
        }
    }
}

/// What an output gives in a round.
fn give(gives: Option<&Gives>, round: u32, state: &[Tree]) -> Tree {
    match gives {
        Some(Gives::State(k)) => state.get(*k).cloned().unwrap_or_default(),
        Some(Gives::Counter | Gives::Link) => {
            Tree::item(Value::Integer(i32::try_from(round).unwrap_or(i32::MAX)))
        }
        Some(Gives::History) => state.first().cloned().unwrap_or_default(),
        None => Tree::empty(),
    }
}

/// Whether any item of a tree is that boolean.
fn is_any(tree: &Tree, wanted: bool, rules: &cast::Rules) -> bool {
    let cast = cast::column(tree.column(), Kind::Boolean, rules);
    cast.column.iter().flatten().any(|value| matches!(value, Value::Boolean(is) if is == wanted))
}

/// Whether an end keeps the states of all rounds: a switch of its menu, which files keep. The name of the item is not known;
/// any that speaks of records counts.
fn records(end: &Object) -> bool {
    fn on(chunk: &Chunk) -> bool {
        chunk.items.iter().any(|item| {
            item.name.to_lowercase().contains("record") && matches!(item.value, ItemValue::Bool(true))
        })
    }
    on(end.container()) || on(end.chunk())
}

/// The states of all rounds.
struct Record {
    /// For each part of the state, its trees with the round's number behind each path.
    parts: Vec<Vec<Tree>>,
    items: u64,
    bytes: u64,
}

impl Record {
    fn new(parts: usize) -> Self {
        Self { parts: vec![Vec::new(); parts], items: 0, bytes: 0 }
    }

    /// Adds a round's state, unless it is more than an object may put out.
    fn add(&mut self, state: &[Tree], round: u32, turn: &Turn<'_>) -> Result<(), String> {
        let round = usize::try_from(round).unwrap_or(usize::MAX);
        for (part, tree) in self.parts.iter_mut().zip(state) {
            self.items += tree.item_count() as u64;
            self.bytes += tree.weight() as u64;
            let limits = &turn.options.limits;
            if self.items > limits.items || self.bytes > limits.bytes {
                return Err(format!(
                    "its record would hold more than an object may put out ({} items)",
                    self.items
                ));
            }
            part.push(tree.with_paths(tree.paths().iter().map(|path| path.child(round)).collect()));
        }
        Ok(())
    }

    fn trees(&self) -> Vec<Tree> {
        self.parts.iter().map(Tree::merge).collect()
    }
}
