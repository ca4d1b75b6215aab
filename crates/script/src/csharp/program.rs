//! The program of one C# component: compiled once, and called for every iteration.

use std::sync::{Arc, Mutex, PoisonError};

use katydid_component::Message;
use katydid_csharp::sema::{MethodId, Ty};
use katydid_csharp::vm::elements::Elements;
use katydid_csharp::vm::heap::Obj;
use katydid_csharp::vm::value::Value as Net;
use katydid_csharp::{Diagnostic, Engine, Failure, Limits, Location, Parts, Source};
use katydid_definition::document::{Access, Object, Port, Script, ScriptLanguage, TypeHint};
use katydid_members::Value;

use super::convert::{fitted, from_csharp, list, to_csharp};
use super::foreign::python_line;
use super::host::{ScriptHost, Turn};
use crate::from_script::SHOWN;
use crate::task::{OUT, variable};

const CLASS: &str = "Script_Instance";
/// The class of our own declarations that calls `ToString`, which a script may have written anew.
const SHOWS: &str = "__Shown";

/// The most characters of an object's text.
const LONGEST_TEXT: usize = 10_000;

/// What every component of Grasshopper 1 uses: scripts that name no more use LINQ and colours too.
const USUAL: &str = "using System; using System.Collections; using System.Collections.Generic; using System.Linq; \
    using System.Drawing; using Rhino; using Rhino.Geometry; using Grasshopper; using Grasshopper.Kernel; using Grasshopper.Kernel.Data; \
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
    /// What runs before the first iteration of a solve, and after the last.
    around: [Option<MethodId>; 2],
    /// Whether the script draws something itself, which is not supported.
    draws: bool,
    pub(super) turn: Arc<Mutex<Turn>>,
    /// What it was made of.
    pub(super) source: (Script, String),
}

/// Reads and checks a script. Where it cannot be read since it is Python, nothing else is said.
fn compiled(script: &Script, parameters: &str, turn: &Arc<Mutex<Turn>>) -> Result<Engine, Vec<Diagnostic>> {
    let script = &Script { text: without_language(&script.text), ..script.clone() };
    let language = if script.language == ScriptLanguage::VisualBasic { "VB" } else { "C#" };
    compiled_as_written(script, parameters, turn).map_err(|faults| match python_line(&script.text) {
        Some(line) => {
            let message = format!(
                "This text looks like Python, and this component runs {language}: give the text to a Python component"
            );
            vec![Diagnostic { at: Location { part: "script".into(), line, column: 1 }, code: 0, message }]
        }
        None => faults,
    })
}

/// A text without the line that names its language (`#! csharp`): a line that is empty stands in its place.
fn without_language(text: &str) -> String {
    let begin = text.len() - text.trim_start_matches('\u{feff}').trim_start().len();
    match text.get(begin..) {
        Some(rest) if rest.starts_with("#!") => {
            let end = rest.find('\n').unwrap_or(rest.len());
            format!("{}{}", text.get(..begin).unwrap_or_default(), rest.get(end..).unwrap_or_default())
        }
        _ => text.to_owned(),
    }
}

fn compiled_as_written(
    script: &Script,
    parameters: &str,
    turn: &Arc<Mutex<Turn>>,
) -> Result<Engine, Vec<Diagnostic>> {
    let host = Box::new(ScriptHost::new(turn.clone()));
    if script.language == ScriptLanguage::VisualBasic {
        let source = Source::Basic(Parts {
            using: &script.using,
            body: &script.text,
            additional: &script.additional,
            parameters,
            usual: USUAL,
            base: "GH_ScriptInstance",
        });
        return Engine::new(&source, host, Limits::default());
    }
    if is_whole(script) {
        return Engine::new(&Source::File(&script.text), host, Limits::default());
    }
    let (using, body) = match is_loose(script) {
        true => parted(&script.text),
        false => (script.using.clone(), script.text.clone()),
    };
    let source = Source::Parts(Parts {
        using: &using,
        body: &body,
        additional: &script.additional,
        parameters,
        usual: USUAL,
        base: "GH_ScriptInstance",
    });
    Engine::new(&source, host, Limits::default())
}

/// What is wrong with a script before it runs, each with its place: what it needs that is not here too.
pub(super) fn faults(script: &Script, parameters: &str) -> Vec<Diagnostic> {
    compiled(script, parameters, &Arc::default()).err().unwrap_or_default()
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
pub(super) fn parameters(object: &Object, inputs: &[&Port], script: &Script) -> String {
    // A script of statements alone has no types for data without a hint, and VB finds members of objects when it runs.
    let is_open = script.language == ScriptLanguage::VisualBasic || is_loose(script);
    let open = if is_open { "dynamic" } else { "object" };
    let inputs = inputs.iter().map(|port| {
        let kind = type_name(TypeHint::of(port.type_hint).name).unwrap_or(open);
        let kind = match port.access {
            Access::Item => kind.to_owned(),
            Access::List => format!("List<{kind}>"),
            Access::Tree => format!("DataTree<{kind}>"),
        };
        format!("{kind} @{}", variable(port))
    });
    let outputs = object.outputs.iter().filter(|port| variable(port) != OUT);
    let outputs = outputs.map(|port| format!("ref object @{}", variable(port)));
    inputs.chain(outputs).collect::<Vec<_>>().join(", ")
}

/// The type that a hint is in C#; none for data as it comes.
fn type_name(hint: &str) -> Option<&str> {
    Some(match hint {
        "str" => "string",
        "float" => "double",
        "Color" => "System.Drawing.Color",
        "Guid" => "System.Guid",
        "DateTime" => "System.DateTime",
        "Box" => "Rhino.Geometry.Box",
        "Complex" => "System.Numerics.Complex",
        "int" | "bool" | "Point3d" | "Vector3d" | "Plane" | "Interval" | "Line" | "Circle" | "Arc"
        | "Polyline" | "Rectangle3d" | "Transform" | "Curve" | "Surface" | "Brep" | "Mesh"
        | "GeometryBase" => hint,
        _ => return None,
    })
}

/// Whether a script is a class of its own.
fn is_whole(script: &Script) -> bool {
    script.text.contains("RunScript") && script.text.contains(CLASS)
}

/// Whether a script is statements alone, as Rhino 8 has them, with its `using` lines among them.
fn is_loose(script: &Script) -> bool {
    script.language == ScriptLanguage::CSharp
        && !is_whole(script)
        && script.using.is_empty()
        && script.additional.is_empty()
}

/// The `using` lines at the beginning of a script, and the rest with empty lines in their place.
fn parted(text: &str) -> (String, String) {
    let (mut using, mut body) = (String::new(), String::new());
    let mut begins = true;
    for line in text.lines() {
        let plain = line.trim();
        let is_using = begins && plain.starts_with("using ") && plain.contains(';') && !plain.contains('(');
        let is_reference = begins && (plain.starts_with("#r ") || plain.starts_with("// "));
        begins &= is_using || is_reference || plain.is_empty();
        if is_using {
            using.push_str(plain);
        } else if !(is_reference && plain.starts_with('#')) {
            body.push_str(line);
        }
        using.push('\n');
        body.push('\n');
    }
    (using, body)
}

impl Program {
    /// Compiles a script; what is wrong with it otherwise, each with its place.
    pub(super) fn new(script: &Script, parameters: &str) -> Result<Self, Vec<Message>> {
        let turn = Arc::new(Mutex::new(Turn::default()));
        let mut engine = compiled(script, parameters, &turn).map_err(|faults| {
            faults.iter().take(20).map(|fault| Message::error(fault.to_string())).collect::<Vec<_>>()
        })?;
        let failed = |failure: &Failure| vec![Message::error(failure.to_string())];
        let object = engine.create(CLASS).map_err(|failure| failed(&failure))?;
        let missing = || vec![Message::error("the script has no RunScript in a class Script_Instance")];
        let run = engine.method(CLASS, "RunScript").ok_or_else(missing)?;
        let owner = engine.type_named("", CLASS).ok_or_else(missing)?;
        let all = engine.sema().method(run).params.clone();
        let takes: Vec<Ty> = all.iter().filter(|own| own.is_value()).map(|own| own.ty).collect();
        let gives = all.len() - takes.len();
        let around = ["BeforeRunScript", "AfterRunScript"].map(|name| engine.method(CLASS, name));
        let draws = ["DrawViewportWires", "DrawViewportMeshes"]
            .iter()
            .any(|name| engine.method(CLASS, name).is_some());
        Ok(Self {
            around,
            draws,
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

    /// What runs may use from now on.
    pub(super) fn limit(&mut self, bytes: u64) {
        let bytes = usize::try_from(bytes).unwrap_or(usize::MAX);
        self.engine.limit(Limits { bytes, ..Limits::default() });
    }

    /// Runs what stands before all iterations, or behind them; what it said.
    pub(super) fn around(&mut self, is_after: bool) -> Vec<Message> {
        let Some(method) = self.around[usize::from(is_after)] else { return Vec::new() };
        let outcome = self.engine.call(method, self.owner, &[self.object]);
        let mut messages = self.said();
        messages.extend(outcome.err().map(|failure| Message::error(failure.to_string())));
        if is_after && self.draws {
            messages.push(Message::remark("what the script draws in the viewport itself is not supported"));
        }
        messages
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
                // Making the text of one may collect the others, which nothing else holds.
                let pinned = self.engine.state().heap.pins.len();
                let held = outs
                    .iter()
                    .filter_map(|out| if let Net::Ref(handle) = out { Some(*handle) } else { None });
                self.engine.state().heap.pins.extend(held);
                for value in outs {
                    called.row.push(self.result(value));
                }
                self.engine.state().heap.pins.truncate(pinned);
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

    /// An output; an object that is none of ours is what its `ToString` gives.
    fn result(&mut self, value: Net) -> Value {
        let references = self.elements(value).map(|items| items.references().to_vec()).unwrap_or_default();
        let holds_lists = references.into_iter().any(|item| self.elements(item).is_some());
        if !holds_lists && let Ok(value) = from_csharp(&mut self.engine, value) {
            return value;
        }
        let Some(items) = self.elements(value).map(Elements::to_values) else { return self.shown(value) };
        // A list in a list is one object.
        let each = items.into_iter().map(|item| match self.elements(item).is_some() {
            true => self.shown(item),
            false => from_csharp(&mut self.engine, item).unwrap_or_else(|_| self.shown(item)),
        });
        Value::List(each.collect())
    }

    /// The elements of a list, or of an array of one dimension.
    fn elements(&mut self, value: Net) -> Option<&Elements> {
        let Net::Ref(handle) = value else { return None };
        match self.engine.state().heap.get(handle) {
            Obj::Array(_, items, None) | Obj::List(_, items, _) => Some(items),
            _ => None,
        }
    }

    /// An object by its text.
    fn shown(&mut self, value: Net) -> Value {
        let method = self.engine.method(SHOWS, "Of").zip(self.engine.type_named("", SHOWS));
        let text = method.and_then(|(method, owner)| self.engine.call(method, owner, &[value]).ok());
        let text = text.and_then(|text| self.engine.state().string(text));
        let text = text.unwrap_or_else(|| self.engine.text_of(value));
        Value::Error(SHOWN.to_owned(), text.chars().take(LONGEST_TEXT).collect())
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
                    paths.push(to_csharp(&mut self.engine, &Value::Path(path.clone()))?);
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
                Some(self.engine.instance(ty, &[paths, lists, Net::Null]))
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
                    Some(Obj::List(_, items, _)) => {
                        let values = items.to_values();
                        items.clear();
                        values
                    }
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
#[cfg(test)]
mod values;
