//! A definition solved at numbers to all digits, also such as its sliders would round away.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Instant;

use katydid_component::Level;
use katydid_data::{Tree, Value};
use katydid_solver::{Engine, Status};

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
    /// How many solves there were.
    pub(crate) solves: u64,
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
        Self { engine: start.clone(), start, variables, outputs, watched, at, solves: 0 }
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
        let Some(slot) = self.at.get_mut(variable) else { return };
        if *slot == Some(x) {
            return;
        }
        *slot = Some(x);
        let Self { engine, variables, at, .. } = self;
        if let Some(found) = variables.get(variable) {
            found.place(engine, x, &genes(variables, at, found));
        }
    }

    /// Solves as the variables stand.
    pub(crate) fn solve(&mut self) -> Reading {
        self.solves += 1;
        let start = Instant::now();
        self.engine.solve();
        let limit = self.engine.options().limits.time;
        if limit.is_some_and(|limit| start.elapsed() >= limit) {
            // What was stopped half-way is not kept for the next solve.
            self.engine = self.start.clone();
            for (variable, x) in self.variables.iter().zip(&self.at) {
                if let Some(x) = x {
                    variable.place(&mut self.engine, *x, &genes(&self.variables, &self.at, variable));
                }
            }
            return Reading { numbers: None, shape: 0 };
        }
        Reading { numbers: self.numbers(), shape: self.shape() }
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
        self.read(variable, a);
        let before: Vec<u64> = self.watched.iter().map(|one| self.shape_of(one)).collect();
        self.read(variable, b);
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
