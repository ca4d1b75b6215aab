use std::collections::HashMap;
use std::sync::Arc;
use std::time::Instant;

use katydid_solver::{Engine, Options, Status};

use super::{Bounds, Solution, Timings};
use crate::definition::Input;
use crate::hops::Hops;
use crate::request::{self, SolveRequest};
use crate::web::Web;
use crate::{Cause, Definition, Fault, Settings};

/// How many definitions may call one another.
pub(crate) const MOST_RECURSION: u32 = 10;

/// Solves a request on its own copy of the definition; says too whether results were kept for others.
///
/// # Errors
/// As for [`crate::Compute::solve`].
pub(crate) fn run(
    settings: &Settings,
    web: &Arc<Web>,
    definition: &Arc<Definition>,
    request: &SolveRequest,
    bounds: &Bounds,
) -> Result<(Solution, bool), Fault> {
    let begin = Instant::now();
    let recursion = bounds.recursion.max(request.recursion_level);
    if recursion > MOST_RECURSION {
        let message = format!("Definitions call one another more than {MOST_RECURSION} times");
        return Err(Fault::bad_request(message));
    }
    let model = request.read_model(settings.archive.max_inflated as u64)?.map(Arc::new);
    // What hangs on a model that only this request has is nothing for others.
    let is_alone = model.is_some() || !request.cache.reads();
    let options = Options {
        rules: request.rules(model.as_deref()),
        limits: bounds.limits,
        memory: bounds.memory.clone(),
        cancel: bounds.cancel.clone(),
        files: settings.files.clone(),
        model,
        progress: bounds.progress.clone(),
        scripts: Some(definition.scripts(settings.scripts.as_deref(), request.cache.reads())),
        remote: Some(Arc::new(Hops::new(settings, web.clone(), recursion))),
        ..Options::default()
    };
    let (states, document) = (definition.states(), definition.document());
    let mut engine =
        if is_alone { states.unsolved(document, options) } else { states.engine(document, options) };
    let set = give(definition, request, &mut engine)?;
    let decoded = Instant::now();
    engine.solve();
    let solved = Instant::now();
    let took = solved - decoded;
    if bounds.cancel.is_cancelled() {
        return Err(Fault::new(Cause::Cancelled, "The request was cancelled"));
    }
    if bounds.memory.as_ref().is_some_and(|memory| memory.was_refused()) {
        return Err(Fault::busy());
    }
    let mut reports = (0..document.objects.len()).filter_map(|at| engine.report(at));
    if let Some(time) = bounds.limits.time.filter(|time| took >= *time)
        && reports.any(|report| report.status == Status::Error)
    {
        let message = format!("The time limit of {} seconds is over", time.as_secs_f64());
        return Err(Fault::new(Cause::TimedOut, message));
    }
    let learnt = !is_alone && states.learn(document, &engine, set);
    let timings = Timings { decode: decoded - begin, solve: took, encode: Default::default() };
    Ok((Solution::new(definition.clone(), engine, request, settings, timings), learnt))
}

/// Sets the inputs that the request names; what it does not name keeps what it has. Names that nobody has are ignored,
/// as clients expect. Of two values for one input the last counts, but those by its own name come after all others.
fn give(
    definition: &Definition,
    request: &SolveRequest,
    engine: &mut Engine,
) -> Result<Vec<(usize, usize)>, Fault> {
    let mut set = Vec::with_capacity(request.values.len());
    let interface = definition.interface();
    let own: HashMap<&str, &Input> =
        interface.inputs.iter().map(|input| (input.name.as_str(), input)).collect();
    let meant = request.values.iter().filter(|value| !own.contains_key(value.name.as_str()));
    let meant =
        meant.filter_map(|value| interface.input_but_for_the_mark(&value.name).map(|input| (input, value)));
    let named =
        request.values.iter().filter_map(|value| own.get(value.name.as_str()).map(|input| (*input, value)));
    for (input, value) in meant.chain(named) {
        engine.give(input.object, input.port, Some(request::tree(input, value)?));
        set.push((input.object, input.port));
    }
    set.sort_unstable();
    set.dedup();
    Ok(set)
}
