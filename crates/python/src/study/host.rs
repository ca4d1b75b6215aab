use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use katydid_cli::SweepCall;
use katydid_component::Cancel;
use katydid_study::{Cell, Dispatcher, Plan, Prepared, Progress, StudyError, Summary, Thing, sweep};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyList};

use super::cells::{cell_in, column_out, list_out, points_in, points_out};
use super::{Files, failed, opened};
use crate::errors::{InputError, KatydidError};
use crate::work::listening;

/// What Python's `progress` is called with: points of the plan, those that were known, those that were solved, those of them
/// without a result, and the seconds since the beginning.
type Counts = (u64, u64, u64, u64, f64);
/// An input: its name, its limits, the distance of its numbers where they are whole, and what it can be chosen from.
type Input<'py> = (String, Option<[f64; 2]>, Option<f64>, Option<Bound<'py, PyAny>>);
/// The columns of rows: inputs, outputs, the words of how they came out, and why.
type Columns<'py> = (Vec<Bound<'py, PyAny>>, Vec<Bound<'py, PyAny>>, Vec<&'static str>, Vec<String>);

/// A definition, a plan and a folder: the part of a study that is not Python's. Use it through `katydid.study`.
#[pyclass(frozen, module = "katydid")]
pub(crate) struct StudyCore {
    call: SweepCall,
    /// The inputs and outputs, and, where it has some, the points.
    plan: Plan,
    prepared: Mutex<Option<Prepared>>,
    dispatcher: Arc<Mutex<Option<Dispatcher>>>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn counts(progress: &Progress) -> Counts {
    (progress.points, progress.had, progress.solved, progress.failed, progress.elapsed.as_secs_f64())
}

fn summed(summary: Summary) -> (Counts, u64, Vec<PathBuf>) {
    (counts(&summary.progress), summary.failed_rows, summary.files)
}

impl StudyCore {
    /// Does something with the open dispatcher, without the interpreter's lock.
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut Dispatcher) -> Result<T, StudyError> + Send,
    ) -> PyResult<T> {
        py.detach(|| match &mut *locked(&self.dispatcher) {
            Some(dispatcher) => work(dispatcher).map_err(failed),
            None => Err(KatydidError::new_err("the study is closed")),
        })
    }

    fn prepared(&self) -> Prepared {
        let mut prepared = locked(&self.prepared);
        let made = prepared.get_or_insert_with(|| {
            let skip_unread = !self.plan.pictures && self.plan.geometry.is_none();
            let options = katydid_solver::Options { skip_unread, ..self.call.options.clone() };
            let (variables, outputs) = (self.plan.variables().to_vec(), self.plan.outputs().to_vec());
            Prepared::new(self.call.document.clone(), options, variables, outputs)
        });
        made.clone()
    }
}

#[pymethods]
impl StudyCore {
    /// Opens what the words of `katydid sweep` name. Without `points` the plan only names inputs and outputs.
    #[new]
    #[pyo3(signature = (words, *, points=true))]
    fn new(py: Python<'_>, words: Vec<OsString>, points: bool) -> PyResult<Self> {
        py.detach(|| {
            let call = opened(words, None)?;
            let plan = if points {
                Plan::bind(&call.plan, &call.document)
            } else {
                Plan::space(&call.plan, &call.document, &[])
            };
            let plan = plan.map_err(failed)?;
            Ok(Self { call, plan, prepared: Mutex::default(), dispatcher: Arc::default() })
        })
    }

    /// How many points the plan has.
    #[getter]
    fn points(&self) -> u64 {
        self.plan.count()
    }

    /// The inputs.
    #[getter]
    fn inputs<'py>(&self, py: Python<'py>) -> PyResult<Vec<Input<'py>>> {
        let of = |variable: &katydid_study::Variable| {
            let choices = variable.choices().map(|cells| list_out(py, &cells)).transpose()?;
            Ok((variable.name.clone(), variable.limits(), variable.step(), choices))
        };
        self.plan.variables().iter().map(of).collect()
    }

    /// The names of the outputs.
    #[getter]
    fn outputs(&self) -> Vec<String> {
        self.plan.outputs().iter().map(|output| output.name.clone()).collect()
    }

    /// The files that the study stands on: the definition, the model or None, the plan.
    #[getter]
    fn files(&self) -> Files {
        let files = self.call.files.clone();
        (files.definition, files.model, files.plan)
    }

    /// How many seconds a point may take.
    #[getter]
    fn seconds(&self) -> Option<f64> {
        self.call.options.limits.time.map(|time| time.as_secs_f64())
    }

    /// Solves the points of the plan on this machine, as `katydid sweep` does; `progress` is called with counts now and then.
    #[pyo3(signature = (workers=None, progress=None))]
    fn sweep(
        &self,
        py: Python<'_>,
        workers: Option<usize>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<(Counts, u64, Vec<PathBuf>)> {
        self.close();
        let mut settings = self.call.settings.clone();
        settings.workers = workers.unwrap_or(settings.workers);
        settings.cancel = Cancel::default();
        let cancel = settings.cancel.clone();
        let (document, options) = (self.call.document.clone(), self.call.options.clone());
        let (plan, folder) = (self.plan.clone(), self.call.folder.clone());
        let work = move |say: &std::sync::mpsc::Sender<_>| {
            let pause = Duration::from_millis(100);
            let mut told = Duration::ZERO;
            sweep(document, options, &plan, &folder, &settings, |now| {
                if now.elapsed >= told + pause {
                    told = now.elapsed;
                    // Only fails when nobody waits any more.
                    let _ = say.send(crate::work::Said::News(counts(now)));
                }
            })
        };
        let tell = |_: Python<'_>, now: Counts| match progress {
            Some(progress) => progress.call1((now,)).map(drop),
            None => Ok(()),
        };
        listening(py, &cancel, work, tell)?.map(summed).map_err(failed)
    }

    /// Begins to hand out points. With `asked` the points of the table count as asked for before, and are held in memory.
    #[pyo3(signature = (asked=true))]
    fn open(&self, py: Python<'_>, asked: bool) -> PyResult<()> {
        py.detach(|| {
            let mut dispatcher = locked(&self.dispatcher);
            if dispatcher.is_none() {
                let (plan, call) = (self.plan.clone(), &self.call);
                let mut new = Dispatcher::open(plan, &call.folder, &call.settings).map_err(failed)?;
                if asked {
                    new.ask_as_before().map_err(failed)?;
                }
                *dispatcher = Some(new);
            }
            Ok(())
        })
    }

    /// Lets others work on the study.
    fn close(&self) {
        locked(&self.dispatcher).take();
    }

    /// The next points of the plan that are to be solved, at most so many.
    fn next_points<'py>(&self, py: Python<'py>, most: usize) -> PyResult<Bound<'py, PyList>> {
        let points = self.with(py, |dispatcher| dispatcher.next_points(most))?;
        points_out(py, &points)
    }

    /// Takes what a `StudySolver` gave; gives how many points were new.
    fn keep(&self, py: Python<'_>, records: &[u8], files: Vec<(String, Vec<u8>)>) -> PyResult<u64> {
        self.with(py, |dispatcher| {
            let things: Result<Vec<Thing>, _> =
                files.into_iter().map(|(name, bytes)| Thing::checked(&name, bytes)).collect();
            dispatcher.keep(records, &things?)
        })
    }

    /// Records that a point cannot be solved, and why.
    fn give_up(&self, py: Python<'_>, point: Bound<'_, PyBytes>, reason: &str, seconds: f64) -> PyResult<()> {
        let points = points_in(vec![point])?;
        let time = Duration::try_from_secs_f64(seconds).unwrap_or_default();
        self.with(py, |dispatcher| {
            points.iter().try_for_each(|point| dispatcher.give_up(point, reason, time))
        })
    }

    /// Counts, as `progress` is called with.
    fn progress(&self, py: Python<'_>) -> PyResult<Counts> {
        self.with(py, |dispatcher| Ok(counts(&dispatcher.progress())))
    }

    /// Writes the tables of the plan.
    fn finish(&self, py: Python<'_>) -> PyResult<(Counts, u64, Vec<PathBuf>)> {
        self.with(py, |dispatcher| dispatcher.finish()).map(summed)
    }

    /// Writes the tables of the points that were asked for.
    fn finish_asked(&self, py: Python<'_>) -> PyResult<(Counts, u64, Vec<PathBuf>)> {
        self.with(py, |dispatcher| dispatcher.finish_asked()).map(summed)
    }

    /// Points that a program asks for, each a sequence of values in the order of the inputs, as the inputs round them.
    fn fitted<'py>(
        &self,
        py: Python<'py>,
        points: Vec<Vec<Bound<'py, PyAny>>>,
    ) -> PyResult<Bound<'py, PyList>> {
        let count = self.plan.variables().len();
        let cells = points.iter().enumerate().map(|(at, point)| -> PyResult<Vec<Cell>> {
            if point.len() != count {
                return Err(InputError::new_err(format!(
                    "point {at} has {} values, and the study has {count} inputs",
                    point.len()
                )));
            }
            let cells = point.iter().zip(self.plan.variables()).map(|(value, variable)| {
                let cell = cell_in(value).map_err(|error| {
                    InputError::new_err(format!("point {at}, '{}': {}", variable.name, error.value(py)))
                });
                cell.map(|cell| variable.fitted(cell))
            });
            cells.collect()
        });
        points_out(py, &cells.collect::<PyResult<Vec<Vec<Cell>>>>()?)
    }

    /// Asks for points, as `fitted` gives them; gives those that are to be solved.
    fn ask<'py>(&self, py: Python<'py>, points: Vec<Bound<'py, PyBytes>>) -> PyResult<Bound<'py, PyList>> {
        let points = points_in(points)?;
        let wanted = self.with(py, |dispatcher| dispatcher.ask(&points))?;
        points_out(py, &wanted)
    }

    /// How many different points were asked for.
    fn asked(&self, py: Python<'_>) -> PyResult<usize> {
        self.with(py, |dispatcher| Ok(dispatcher.asked_points().len()))
    }

    /// Solves points that were asked for on this machine.
    #[pyo3(signature = (points, workers=None))]
    fn solve(&self, py: Python<'_>, points: Vec<Bound<'_, PyBytes>>, workers: Option<usize>) -> PyResult<()> {
        let points = points_in(points)?;
        let workers = workers.unwrap_or(self.call.settings.workers);
        let cancel = Cancel::default();
        let mut prepared = py.detach(|| self.prepared());
        prepared.set_cancel(cancel.clone());
        let (dispatcher, flag) = (Arc::clone(&self.dispatcher), cancel.clone());
        let work = move |_: &std::sync::mpsc::Sender<_>| match &mut *locked(&dispatcher) {
            Some(dispatcher) => dispatcher.solve_here(&prepared, points, workers, &flag),
            None => Err(StudyError::Unfit("the study is closed".to_owned())),
        };
        listening(py, &cancel, work, |_, ()| Ok(()))?.map_err(failed)
    }

    /// The columns of points that are solved.
    fn rows<'py>(&self, py: Python<'py>, points: Vec<Bound<'py, PyBytes>>) -> PyResult<Columns<'py>> {
        let points = points_in(points)?;
        self.columns(py, move |_| Ok(points))
    }

    /// The columns of the plan's points.
    fn plan_rows<'py>(&self, py: Python<'py>) -> PyResult<Columns<'py>> {
        let plan = &self.plan;
        self.columns(py, |_| plan.points()?.collect())
    }

    /// The columns of the points that were asked for.
    fn asked_rows<'py>(&self, py: Python<'py>) -> PyResult<Columns<'py>> {
        self.columns(py, |dispatcher| Ok(dispatcher.asked_points().to_vec()))
    }
}

impl StudyCore {
    fn columns<'py>(
        &self,
        py: Python<'py>,
        points: impl FnOnce(&mut Dispatcher) -> Result<Vec<Vec<Cell>>, StudyError> + Send,
    ) -> PyResult<Columns<'py>> {
        let (inputs, outputs) = (self.plan.variables().len(), self.plan.outputs().len());
        let (cells, status, reasons) = self.with(py, |dispatcher| {
            let mut cells = vec![Vec::new(); inputs + outputs];
            let (mut status, mut reasons) = (Vec::new(), Vec::new());
            for (at, point) in points(dispatcher)?.into_iter().enumerate() {
                let outcome = dispatcher.outcome(&point)?;
                let outcome =
                    outcome.ok_or_else(|| StudyError::Unfit(format!("point {at} is not solved")))?;
                cells
                    .iter_mut()
                    .zip(point.into_iter().chain(outcome.cells))
                    .for_each(|(c, cell)| c.push(cell));
                status.push(outcome.status.word());
                reasons.push(outcome.reason);
            }
            Ok((cells, status, reasons))
        })?;
        let mut columns: Vec<_> = cells.iter().map(|cells| column_out(py, cells)).collect::<PyResult<_>>()?;
        let outputs = columns.split_off(inputs);
        Ok((columns, outputs, status, reasons))
    }
}
