//! C# and VB components: each is compiled once and run in this process. A script can only compute, so it needs no permission.

mod breps;
mod convert;
mod declare;
mod enums;
mod foreign;
mod host;
mod member;
mod program;
mod structs;

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use katydid_definition::document::{Object, Script, ScriptLanguage};
use katydid_solver::{Refused, ScriptDone, ScriptMaker, ScriptTask, Scripts, Unrun};
use uuid::Uuid;
use web_time::Instant;

use crate::from_script::Outward;
use crate::keeper::Keepers;
use crate::outputs;
use crate::reply::Reply;
use crate::task::Prepared;
use crate::to_script::Inward;
use program::Program;

/// Runs the C# and VB components of one document, and hands all others on.
#[derive(Default)]
pub struct CSharp {
    /// The compiled scripts by component.
    programs: Mutex<HashMap<Uuid, Program>>,
    /// What runs scripts of other languages.
    others: Option<Arc<dyn Scripts>>,
}

impl std::fmt::Debug for CSharp {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CSharp").field("others", &self.others).finish_non_exhaustive()
    }
}

impl CSharp {
    /// With what runs scripts of other languages.
    pub fn beside(others: Arc<dyn Scripts>) -> Self {
        Self { others: Some(others), ..Self::default() }
    }

    /// The program of a component. It is taken out while it runs, so that nothing is locked meanwhile.
    fn program(&self, task: &ScriptTask<'_>) -> Result<Program, Vec<katydid_component::Message>> {
        let inputs: Vec<_> = task.inputs.iter().map(|(port, _)| *port).collect();
        let parameters = program::parameters(task.object, &inputs, task.script);
        let kept = self.programs.lock().unwrap_or_else(PoisonError::into_inner).remove(&task.object.id);
        match kept {
            Some(kept) if kept.source.0 == *task.script && kept.source.1 == parameters => Ok(kept),
            _ => Program::new(task.script, &parameters),
        }
    }

    fn perform(&self, task: &ScriptTask<'_>) -> Result<ScriptDone, Unrun> {
        let prepared = Prepared::new(task);
        task.budget.fits(prepared.iterations()).map_err(Unrun::Failed)?;
        let mut program = match self.program(task) {
            Ok(program) => program,
            Err(messages) => return Ok(ScriptDone { outputs: Vec::new(), messages }),
        };
        program.limit(task.limits.bytes.min(task.limits.solve_bytes));
        {
            let mut turn = program.turn.lock().unwrap_or_else(PoisonError::into_inner);
            turn.limits = task.limits;
            turn.rules = task.rules;
            turn.cancel = task.cancel.clone();
            turn.end = task.limits.time.and_then(|time| Instant::now().checked_add(time));
        }
        let mut inward = Inward { rules: &prepared.rules, process: 0, lost: Vec::new() };
        let rows = prepared.rows(&mut inward);
        let mut lost = inward.lost;
        let (mut reply, mut ended) = (Reply::default(), false);
        let mut said = program.around(false);
        for row in &rows {
            let called = task.budget.token().during(|| program.call(&row.items().unwrap_or_default()));
            reply.iterations.push(called.row);
            reply.prints.push(called.printed);
            for message in called.messages {
                if !reply.messages.contains(&message) {
                    reply.messages.push(message);
                }
            }
            ended = called.ended;
            if ended {
                break;
            }
        }
        if !ended {
            said.extend(program.around(true));
        }
        reply.messages.extend(said);
        // What the caller's limits stopped is told in their words.
        task.budget.check().map_err(Unrun::Failed)?;
        if !ended {
            self.programs.lock().unwrap_or_else(PoisonError::into_inner).insert(task.object.id, program);
        }
        let keepers = Keepers::new(0);
        let mut outward = Outward { keepers: &keepers, texts: &reply.texts, lost: Vec::new() };
        let outputs = outputs::trees(&prepared, &reply, &mut outward);
        lost.extend(outward.lost);
        let warnings = lost.into_iter().map(katydid_component::Message::warning);
        Ok(ScriptDone { outputs, messages: warnings.chain(reply.messages).collect() })
    }
}

/// Makes what runs the scripts of one document: C# here, scripts of other languages as it is told.
#[derive(Debug, Clone)]
pub struct CSharpMaker {
    /// Makes what runs scripts of other languages; none where they may not run.
    pub others: Option<Arc<dyn ScriptMaker>>,
    /// What is said of scripts of other languages that may not run.
    pub refused: Refused,
}

impl ScriptMaker for CSharpMaker {
    fn make(&self) -> Arc<dyn Scripts> {
        let refused = || Arc::new(self.refused.clone()) as Arc<dyn Scripts>;
        Arc::new(CSharp::beside(self.others.as_ref().map_or_else(refused, |maker| maker.make())))
    }
}

/// What is wrong with a C# script before it runs, each with its place; what it needs that is not here is told by name.
pub fn faults(object: &Object, script: &Script) -> Vec<String> {
    let inputs: Vec<_> = object.inputs.iter().collect();
    let parameters = program::parameters(object, &inputs, script);
    program::faults(script, &parameters).iter().map(ToString::to_string).collect()
}

/// Whether scripts of a language run here: VB is rewritten as C#.
fn is_ours(language: &ScriptLanguage) -> bool {
    matches!(language, ScriptLanguage::CSharp | ScriptLanguage::VisualBasic)
}

impl Scripts for CSharp {
    fn runs(&self, language: &ScriptLanguage) -> bool {
        is_ours(language) || self.others.as_ref().is_some_and(|others| others.runs(language))
    }

    fn losses(&self) -> u64 {
        self.others.as_ref().map_or(0, |others| others.losses())
    }

    /// Programs keep what their fields hold from one run to the next: each copy of a document has its own.
    fn another(&self) -> Option<Arc<dyn Scripts>> {
        let others = self.others.as_ref().map(|others| others.another().unwrap_or_else(|| others.clone()));
        Some(Arc::new(Self { others, ..Self::default() }))
    }

    fn run(&self, task: &ScriptTask<'_>) -> Result<ScriptDone, Unrun> {
        match &self.others {
            Some(others) if !is_ours(&task.script.language) => others.run(task),
            _ => self.perform(task),
        }
    }
}
