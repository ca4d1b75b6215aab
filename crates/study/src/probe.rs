//! A definition solved at numbers to all digits, also such as its sliders would round away.

use std::hash::{DefaultHasher, Hash, Hasher};

use katydid_component::Level;
use katydid_data::{Tree, Value};
use katydid_solver::{Engine, Status};
use web_time::Instant;

use crate::inquiry::Known;
use crate::inside::report_at;
use crate::reach::{Reached, reached};
use crate::{Cell, Output, Prepared, StudyError, Variable};

/// What a definition gave at a point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reading {
    /// The numbers of the outputs one after another: of a point, its three coordinates. `None` where one has no usable data.
    pub(crate) numbers: Option<Vec<f64>>,
    /// How many items, branches, faces, edges there are in all that leads to the outputs, as one number.
    pub(crate) shape: u64,
}

/// Solves a definition again and again, each time with other numbers at its sliders.
#[derive(Debug, Clone)]
pub(crate) struct Probe {
    start: Engine,
    engine: Engine,
    variables: Vec<Variable>,
    outputs: Vec<Output>,
    /// The objects that lead to the outputs.
    watched: Vec<Reached>,
    /// What each variable stands at; `None` for what is no number.
    at: Vec<Option<f64>>,
    /// What they stand at in the engine: readings that are known need no edit of it.
    placed: Vec<Option<f64>>,
    /// How many solves were asked for.
    pub(crate) solves: u64,
    /// Where it works in slices, what it has read already.
    known: Option<Known>,
}

impl Probe {
    pub(crate) fn new(prepared: &Prepared) -> Self {
        let mut start = prepared.engine().clone();
        let variables = prepared.variables().to_vec();
        let outputs = prepared.outputs().to_vec();
        let paths: Vec<Vec<usize>> = outputs.iter().map(|output| output.path().collect()).collect();
        let watched = reached(start.document(), &paths);
        let at = variables.iter().map(Variable::stands_at).collect();
        for variable in &variables {
            variable.refine(&mut start);
        }
        start.solve();
        let placed: Vec<Option<f64>> = at;
        let at = placed.clone();
        Self { engine: start.clone(), start, variables, outputs, watched, at, placed, solves: 0, known: None }
    }

    /// Begins a slice: everything stands as at first, readings that were made already are known, and no new one is begun after
    /// `until`, but for one. What a search gives is worth nothing where [`is_over`](Self::is_over) says so at its end.
    pub(crate) fn begin_slice(&mut self, until: Instant) {
        self.at = self.variables.iter().map(Variable::stands_at).collect();
        self.solves = 0;
        self.known.get_or_insert_default().begin(until);
    }

    /// Whether the slice ended before the search did: its last readings are none.
    pub(crate) fn is_over(&self) -> bool {
        self.known.as_ref().is_some_and(Known::is_over)
    }

    /// Whether the time of a search is over, as `is_over` tells. A slice that comes to where it was found to be over stops there, and
    /// what was known before a slice takes no time.
    pub(crate) fn is_time_over(&mut self, is_over: impl FnOnce() -> bool) -> bool {
        match &mut self.known {
            None => is_over(),
            Some(known) => known.is_time_over(self.solves, is_over),
        }
    }

    /// The variables.
    pub(crate) fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// What the variables stand at.
    pub(crate) fn at(&self) -> &[Option<f64>] {
        &self.at
    }

    /// The engine as the last solve left it.
    pub(crate) fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Solves with one variable at another number, which it keeps.
    pub(crate) fn read(&mut self, variable: usize, x: f64) -> Reading {
        self.set(variable, x);
        self.solve()
    }

    /// Sets a variable for the next solve.
    pub(crate) fn set(&mut self, variable: usize, x: f64) {
        if let Some(slot) = self.at.get_mut(variable) {
            *slot = Some(x);
        }
    }

    /// Solves as the variables stand.
    pub(crate) fn solve(&mut self) -> Reading {
        self.solves += 1;
        let Some(known) = &mut self.known else { return self.solve_anew() };
        let key = Known::key(&self.at);
        match known.reading(&key) {
            Some(reading) => reading,
            None if known.ends() => Reading { numbers: None, shape: 0 },
            None => {
                let reading = self.solve_anew();
                if let Some(known) = &mut self.known {
                    known.keep(key, reading.clone());
                }
                reading
            }
        }
    }

    fn solve_anew(&mut self) -> Reading {
        self.place();
        let start = Instant::now();
        self.engine.solve();
        let limit = self.engine.options().limits.time;
        if limit.is_some_and(|limit| start.elapsed() >= limit) {
            // What was stopped half-way is not kept for the next solve.
            self.engine = self.start.clone();
            self.placed = self.variables.iter().map(Variable::stands_at).collect();
            return Reading { numbers: None, shape: 0 };
        }
        Reading { numbers: self.numbers(), shape: self.shape() }
    }

    /// Brings the engine to where the variables stand.
    fn place(&mut self) {
        let Self { engine, variables, at, placed, .. } = self;
        for (index, (variable, to)) in variables.iter().zip(at.iter()).enumerate() {
            let Some(x) = to else { continue };
            if placed.get(index) != Some(to) {
                variable.place(engine, *x, &genes(variables, at, variable));
            }
        }
        placed.clone_from(at);
    }

    fn numbers(&self) -> Option<Vec<f64>> {
        let mut numbers = Vec::new();
        for output in &self.outputs {
            numbers.extend(numbers_of(&output.tree(&self.engine))?);
        }
        let failed = self.watched.iter().any(|one| {
            // A cluster that is switched off has nothing inside.
            report_at(&self.engine, &one.path)
                .map_or(one.path.len() == 1, |report| matches!(report.status, Status::Error))
        });
        (!failed && numbers.iter().all(|x| x.is_finite())).then_some(numbers)
    }

    fn shape(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.watched.iter().for_each(|one| self.shape_of(one).hash(&mut hasher));
        hasher.finish()
    }

    fn shape_of(&self, one: &Reached) -> u64 {
        let mut hasher = DefaultHasher::new();
        let outputs = report_at(&self.engine, &one.path).map_or(&[][..], |report| &report.outputs);
        outputs.iter().for_each(|tree| count(tree, &mut hasher));
        hasher.finish()
    }

    /// The first object whose results have other counts at `b` than at `a`, or that fails there, in the order of the document.
    pub(crate) fn what_changes(&mut self, variable: usize, a: f64, b: f64) -> Option<String> {
        let Some(known) = &mut self.known else { return self.compare(variable, a, b) };
        let question = (variable, [a.to_bits(), b.to_bits()]);
        match known.change(&question) {
            Some(answer) => answer,
            None if known.ends() => None,
            None => {
                let answer = self.compare(variable, a, b);
                if let Some(known) = &mut self.known {
                    known.keep_change(question, answer.clone());
                }
                answer
            }
        }
    }

    fn compare(&mut self, variable: usize, a: f64, b: f64) -> Option<String> {
        // Not as readings that may be known: the engine itself is looked at.
        self.set(variable, a);
        self.solve_anew();
        let before: Vec<u64> = self.watched.iter().map(|one| self.shape_of(one)).collect();
        self.set(variable, b);
        self.solve_anew();
        // What only hands an error's lack of data on is not its cause.
        let failed = self.watched.iter().find_map(|one| {
            let report =
                report_at(&self.engine, &one.path).filter(|report| report.status == Status::Error)?;
            let message = report.messages.iter().find(|message| message.level == Level::Error)?;
            Some(format!("'{}': {}", one.name, first_line(&message.text)))
        });
        failed.or_else(|| {
            let mut both = self.watched.iter().zip(&before);
            let (changed, _) = both.find(|(one, before)| **before != self.shape_of(one))?;
            Some(format!("'{}' gives another count", changed.name))
        })
    }
}

/// The numbers of all genes of a pool that are variables: a pool is given as a whole.
fn genes(variables: &[Variable], at: &[Option<f64>], one: &Variable) -> Vec<(usize, f64)> {
    let of_pool = variables.iter().zip(at).filter(|(variable, _)| variable.is_beside(one));
    of_pool.filter_map(|(variable, x)| Some((variable.gene()?, (*x)?))).collect()
}

/// The numbers of a tree one after another; `None` where something is no number and no point, or nothing is there.
pub(crate) fn numbers_of(tree: &Tree) -> Option<Vec<f64>> {
    let mut numbers = Vec::with_capacity(tree.item_count());
    for item in tree.branches().flat_map(|branch| branch.iter().collect::<Vec<_>>()) {
        match item? {
            Value::Point(p) => numbers.extend([p.x, p.y, p.z]),
            Value::Vector(v) => numbers.extend([v.x, v.y, v.z]),
            value => numbers.push(Cell::of_tree(&Tree::item(value)).number()?),
        }
    }
    (!numbers.is_empty()).then_some(numbers)
}

/// Adds the counts of a tree, and those of the faces, edges and vertices of what is in it.
fn count(tree: &Tree, hasher: &mut impl Hasher) {
    tree.branch_count().hash(hasher);
    for branch in tree.branches() {
        branch.len().hash(hasher);
        for item in branch.iter() {
            match item {
                None => 0_usize.hash(hasher),
                Some(Value::Brep(brep)) => {
                    [brep.faces().len(), brep.edges().len(), brep.vertices().len()].hash(hasher);
                }
                Some(Value::Mesh(mesh)) => [mesh.faces().len(), mesh.vertices().len()].hash(hasher),
                Some(_) => 1_usize.hash(hasher),
            }
        }
    }
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

/// The one output of a prepared definition as one number, or why it is none.
pub(crate) fn one_number(probe: &mut Probe) -> Result<f64, StudyError> {
    let reading = probe.solve();
    let name = probe.outputs.first().map_or("", |output| &output.name).to_owned();
    match reading.numbers.as_deref() {
        Some([x]) => Ok(*x),
        Some(many) => {
            let n = many.len();
            Err(StudyError::Unfit(format!("'{name}' gives {n} numbers: one is needed, their sum say")))
        }
        None => Err(StudyError::Unfit(format!("'{name}' gives no number as the definition stands"))),
    }
}
