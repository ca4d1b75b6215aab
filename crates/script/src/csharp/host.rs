//! What a C# script is run for: the members of the table, and the limits of the solve.

use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::time::Instant;

use katydid_component::{Cancel, Limits};
use katydid_csharp::vm::value::Value as Net;
use katydid_csharp::{Cx, Host, Raise, Stop};
use katydid_members::geometry::{Waiting, endpoints};
use katydid_members::{Cause, Fault, Shape, Value};

use super::convert::{from_csharp, to_csharp};
use super::declare;

/// The declarations, which all scripts share.
static DECLARATIONS: LazyLock<String> = LazyLock::new(|| declare::declarations(&endpoints().members()));

/// What a script's run may use, and what it printed: shared by its host and by whoever runs it.
#[derive(Debug, Default)]
pub(super) struct Turn {
    pub(super) limits: Limits,
    pub(super) cancel: Cancel,
    pub(super) end: Option<Instant>,
    pub(super) printed: String,
}

impl Turn {
    fn is_over(&self) -> bool {
        self.cancel.is_cancelled() || self.end.is_some_and(|end| Instant::now() >= end)
    }
}

/// The host of one script.
pub(super) struct ScriptHost {
    pub(super) turn: Arc<Mutex<Turn>>,
    /// The members that the script's declarations name, as the table calls them.
    pub(super) names: Vec<String>,
}

impl ScriptHost {
    pub(super) fn new(turn: Arc<Mutex<Turn>>) -> Self {
        let signatures = endpoints().members();
        let mut names: Vec<String> =
            signatures.iter().filter_map(|text| Some(text.split_once('(')?.0.to_owned())).collect();
        names.dedup();
        Self { turn, names }
    }

    fn turn(&self) -> std::sync::MutexGuard<'_, Turn> {
        self.turn.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Host for ScriptHost {
    fn declarations(&self) -> &str {
        &DECLARATIONS
    }

    fn member(&self, key: &str) -> Option<u32> {
        let name = key.split_once('(')?.0;
        let place = self.names.binary_search_by(|own| own.as_str().cmp(name)).ok()?;
        u32::try_from(place).ok()
    }

    fn call(&mut self, member: u32, cx: &mut Cx<'_>) -> Result<Net, Raise> {
        let missing = || Raise::Stop(Stop::NotSupported("This member".to_owned()));
        let name = self.names.get(member as usize).ok_or_else(missing)?;
        let waiting = {
            let turn = self.turn();
            let left = turn.end.map(|end| end.saturating_duration_since(Instant::now()));
            Waiting::new(&Limits { time: left, ..turn.limits }, None, &turn.cancel)
        };
        let first = usize::from(name.ends_with(".new"));
        let (mut arguments, mut outs) = (Vec::new(), Vec::new());
        for place in first..cx.len() {
            match cx.arg(place) {
                Net::StackRef(_) | Net::PartRef(..) | Net::StaticRef(_) => outs.push(place),
                value => {
                    let refused =
                        |what| Raise::new("ArgumentException", format!("{name} does not take {what}"));
                    arguments.push(from_csharp(cx, value).map_err(refused)?);
                }
            }
        }
        let reply = endpoints().call_member(name, &arguments, &waiting).map_err(raised)?;
        if let Some(shape) = reply.changed {
            let object = cx.arg(0);
            if let Some(own) = cx.host_data_mut::<Shape>(object) {
                *own = shape;
            }
        }
        give(name, reply.value, &outs, cx)
    }

    fn write(&mut self, text: &str) {
        self.turn().printed.push_str(text);
    }

    fn cancelled(&mut self) -> bool {
        self.turn().is_over()
    }
}

/// The result of a member as the program has it; what stands behind it goes to the `out` parameters.
fn give(name: &str, value: Value, outs: &[usize], cx: &mut Cx<'_>) -> Result<Net, Raise> {
    let (value, rest) = match value {
        Value::List(items) if !outs.is_empty() => {
            let mut items = items.into_iter();
            (items.next().unwrap_or(Value::Null), items.collect())
        }
        value => (value, Vec::new()),
    };
    let refused =
        |value: &Value| Raise::Stop(Stop::NotSupported(format!("{} as the result of {name}", value.noun())));
    for (place, value) in outs.iter().zip(rest) {
        let made = to_csharp(cx, &value).ok_or_else(|| refused(&value))?;
        cx.set(*place, made);
    }
    to_csharp(cx, &value).ok_or_else(|| refused(&value))
}

fn raised(fault: Fault) -> Raise {
    match fault.cause {
        Cause::Cancelled | Cause::TimedOut => Raise::Stop(Stop::Cancelled),
        Cause::NotSupported(name) => Raise::Stop(Stop::NotSupported(name)),
        Cause::BadRequest => Raise::new("ArgumentException", fault.message),
        _ => Raise::new("InvalidOperationException", fault.message),
    }
}
