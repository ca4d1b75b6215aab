//! The program of one C# component: compiled once, and called for every iteration.

use std::sync::{Arc, Mutex, PoisonError};

use katydid_component::Message;
use katydid_csharp::sema::{MethodId, Ty};
use katydid_csharp::vm::heap::Obj;
use katydid_csharp::vm::value::Value as Net;
use katydid_csharp::{Engine, Failure, Limits, Source};
use katydid_definition::document::{Access, Script};
use katydid_members::Value;
use katydid_solver::ScriptTask;

use super::convert::{fitted, from_csharp, list, to_csharp};
use super::host::{ScriptHost, Turn};
use crate::hint::Hint;
use crate::task::{OUT, variable};

const CLASS: &str = "Script_Instance";
/// What every component of Grasshopper 1 uses.
const USUAL: &str = "using System; using System.Collections; using System.Collections.Generic; using Rhino; \
    using Rhino.Geometry; using Grasshopper; using Grasshopper.Kernel; using Grasshopper.Kernel.Data; \
    using Grasshopper.Kernel.Types;";

/// A compiled script with its object, whose fields stay between runs.
pub(super) struct Program {
    engine: Engine,
    object: Net,
    owner: Ty,
    run: MethodId,
    /// The types of the parameters that take data.
    takes: Vec<Ty>,
    /// How many parameters give data.
    gives: usize,
    pub(super) turn: Arc<Mutex<Turn>>,
    /// What it was made of.
    pub(super) source: (Script, String),
}

/// What one call gave.
#[derive(Debug, Default)]
pub(super) struct Called {
    pub(super) row: Vec<Value>,
    pub(super) printed: String,
    pub(super) messages: Vec<Message>,
    /// Whether the program cannot go on.
    pub(super) ended: bool,
}

/// The parameters of `RunScript` of a component in three parts.
pub(super) fn parameters(task: &ScriptTask<'_>) -> String {
    let inputs = task.inputs.iter().map(|(port, _)| {
        let kind = type_name(Hint::of(port.type_hint).name);
        let kind = match port.access {
            Access::Item => kind.to_owned(),
            Access::List => format!("List<{kind}>"),
            Access::Tree => format!("DataTree<{kind}>"),
        };
        format!("{kind} @{}", variable(port))
    });
    let outputs = task.object.outputs.iter().filter(|port| variable(port) != OUT);
    let outputs = outputs.map(|port| format!("ref object @{}", variable(port)));
    inputs.chain(outputs).collect::<Vec<_>>().join(", ")
}

/// The type that a hint is in C#.
fn type_name(hint: &str) -> &str {
    match hint {
        "str" => "string",
        "float" => "double",
        "int" | "bool" | "Point3d" | "Vector3d" | "Plane" | "Interval" | "Line" | "Circle" | "Polyline"
        | "Curve" | "Surface" | "Brep" | "Mesh" | "GeometryBase" => hint,
        _ => "object",
    }
}

impl Program {
    /// Compiles a script; what is wrong with it otherwise, each with its place.
    pub(super) fn new(script: &Script, parameters: &str) -> Result<Self, Vec<Message>> {
        let is_whole = script.text.contains("RunScript") && script.text.contains(CLASS);
        let source = if is_whole {
            Source::File(&script.text)
        } else {
            Source::Parts {
                using: &script.using,
                body: &script.text,
                additional: &script.additional,
                parameters,
                usual: USUAL,
                base: "GH_ScriptInstance",
            }
        };
        let turn = Arc::new(Mutex::new(Turn::default()));
        let host = Box::new(ScriptHost::new(turn.clone()));
        let mut engine = Engine::new(&source, host, Limits::default()).map_err(|faults| {
            faults.iter().take(20).map(|fault| Message::error(fault.to_string())).collect::<Vec<_>>()
        })?;
        let failed = |failure: &Failure| vec![Message::error(failure.to_string())];
        let object = engine.create(CLASS).map_err(|failure| failed(&failure))?;
        let missing = || vec![Message::error("the script has no RunScript in a class Script_Instance")];
        let run = engine.method(CLASS, "RunScript").ok_or_else(missing)?;
        let owner = engine.type_named("", CLASS).ok_or_else(missing)?;
        let all = engine.sema().method(run).params.clone();
        let is_value = |ty: &katydid_csharp::sema::ParamDef| format!("{:?}", ty.passing) == "Value";
        let takes: Vec<Ty> = all.iter().filter(|own| is_value(own)).map(|own| own.ty).collect();
        let gives = all.len() - takes.len();
        Ok(Self {
            engine,
            object,
            owner,
            run,
            takes,
            gives,
            turn,
            source: (script.clone(), parameters.to_owned()),
        })
    }

    /// Calls `RunScript` for one iteration.
    pub(super) fn call(&mut self, inputs: &[Value]) -> Called {
        let mut arguments = vec![self.object];
        for (place, ty) in self.takes.clone().into_iter().enumerate() {
            match self.argument(inputs.get(place).unwrap_or(&Value::Null), ty) {
                Some(value) => arguments.push(value),
                None => {
                    let text = format!("the data of input {} is not supported in C#", place + 1);
                    return Called { messages: vec![Message::error(text)], ..Called::default() };
                }
            }
        }
        let refs = vec![Net::Null; self.gives];
        let outcome = self.engine.call_with_refs(self.run, self.owner, &arguments, &refs);
        let mut called = Called { messages: self.said(), ..Called::default() };
        match outcome {
            Ok((_, outs)) => {
                for value in outs {
                    called.row.push(from_csharp(&mut self.engine, value).unwrap_or_else(|what| {
                        let text = format!("{what} is not supported as a script's result");
                        called.messages.push(Message::warning(text));
                        Value::Null
                    }));
                }
            }
            Err(failure) => {
                called.ended = failure.stop.is_some();
                called.messages.push(Message::error(failure.to_string()));
            }
        }
        let mut turn = self.turn.lock().unwrap_or_else(PoisonError::into_inner);
        called.printed = std::mem::take(&mut turn.printed);
        called
    }

    /// A value as a parameter takes it.
    fn argument(&mut self, value: &Value, ty: Ty) -> Option<Net> {
        let name = self.engine.sema().full_name(ty);
        let element = self.engine.sema().args_of(ty).first().copied();
        match (value, element) {
            (Value::Tree(branches), Some(element)) if name.starts_with("Grasshopper.DataTree") => {
                let path_type = self.engine.type_named("Grasshopper.Kernel.Data", "GH_Path")?;
                let (mut paths, mut lists) = (Vec::new(), Vec::new());
                let mut list_type = None;
                for (path, items) in branches {
                    let indices = to_csharp(
                        &mut self.engine,
                        &Value::Ints(path.iter().map(|i| i64::from(*i)).collect()),
                    )?;
                    paths.push(self.engine.instance(path_type, &[indices]));
                    let items = self.items(items, element)?;
                    let own = list(&mut self.engine, element, items)?;
                    if let Net::Ref(handle) = own
                        && let Obj::List(ty, ..) = self.engine.state().heap.get(handle)
                    {
                        list_type = Some(*ty);
                    }
                    lists.push(own);
                }
                let list_type = list_type.unwrap_or(self.engine.sema().known.object);
                let paths = list(&mut self.engine, path_type, paths)?;
                let lists = list(&mut self.engine, list_type, lists)?;
                Some(self.engine.instance(ty, &[paths, lists]))
            }
            (value, Some(element)) if name.starts_with("System.Collections.Generic.List") => {
                let items = value.items().unwrap_or_default();
                let items = self.items(&items, element)?;
                list(&mut self.engine, element, items)
            }
            (value, _) => {
                let made = to_csharp(&mut self.engine, value)?;
                Some(fitted(&mut self.engine, made, ty))
            }
        }
    }

    fn items(&mut self, items: &[Value], element: Ty) -> Option<Vec<Net>> {
        let fit = |item| {
            let made = to_csharp(&mut self.engine, item)?;
            Some(fitted(&mut self.engine, made, element))
        };
        items.iter().map(fit).collect()
    }

    /// What the script said of its component, once.
    fn said(&mut self) -> Vec<Message> {
        let heap = &mut self.engine.state().heap;
        let field = |heap: &katydid_csharp::vm::heap::Heap, of: Net, place: usize| match of {
            Net::Ref(handle) => match heap.get(handle) {
                Obj::Inst(_, fields) => fields.get(place).copied().unwrap_or(Net::Null),
                _ => Net::Null,
            },
            _ => Net::Null,
        };
        let mut take = |place| {
            let component = field(heap, self.object, 0);
            match field(heap, component, place) {
                Net::Ref(handle) => match heap.get_mut(handle) {
                    Some(Obj::List(_, items, _)) => std::mem::take(items),
                    _ => Vec::new(),
                },
                _ => Vec::new(),
            }
        };
        let (texts, levels) = (take(0), take(1));
        let state = self.engine.state();
        let pairs = texts.into_iter().zip(levels);
        pairs
            .map(|(text, level)| {
                let text = state.string(text).unwrap_or_default();
                match level.whole() {
                    Some(20) => Message::error(text),
                    Some(10) => Message::warning(text),
                    _ => Message::remark(text),
                }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests;
