//! A program made of source and a host, checked, and run as often as wanted.

use std::sync::LazyLock;

use crate::diagnostic::Diagnostic;
use crate::host::Host;
use crate::library;
use crate::program::{Key, Program};
use crate::sema::{MethodId, Sema, Ty};
use crate::source::{Location, SourceMap};
use crate::syntax::{self, ast::Namespace};
use crate::vb;
use crate::vm::heap::Obj;
use crate::vm::value::Value;
use crate::vm::{Limits, Raise, State, Stop};

/// The source of a program.
#[derive(Debug, Clone, Copy)]
pub enum Source<'a> {
    /// A whole file of C#.
    File(&'a str),
    /// A script component of Grasshopper 1 in C#.
    Parts(Parts<'a>),
    /// One in VB.
    Basic(Parts<'a>),
}

/// The three parts of a script component of Grasshopper 1, in its own language, and what it is put into.
#[derive(Debug, Clone, Copy)]
pub struct Parts<'a> {
    /// `using` or `Imports` lines beyond those that every component has.
    pub using: &'a str,
    /// The body of `RunScript`.
    pub body: &'a str,
    /// Further members of the class.
    pub additional: &'a str,
    /// The parameters of `RunScript`, as C# writes them.
    pub parameters: &'a str,
    /// What every component uses, as `using` lines of C#.
    pub usual: &'a str,
    /// The base class, empty for none.
    pub base: &'a str,
}

/// How a run ended that did not end well.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// The class of the exception, or empty when the run was stopped.
    pub exception: String,
    /// What it says.
    pub message: String,
    /// Where.
    pub at: Option<Location>,
    /// Why it was stopped.
    pub stop: Option<Stop>,
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let Some(at) = &self.at {
            write!(f, "{at}: ")?;
        }
        if !self.exception.is_empty() {
            write!(f, "{}: ", self.exception)?;
        }
        f.write_str(&self.message)
    }
}

/// A program that can be run.
pub struct Engine {
    program: Program,
    state: State,
    map: SourceMap,
}

/// The library, declared, and where its texts stand.
type Declared = (Sema, SourceMap);

/// The library as it is declared: the same for all programs, so it is read once in a process.
static LIBRARY: LazyLock<Result<Declared, Vec<Diagnostic>>> = LazyLock::new(|| {
    let (mut sema, mut map) = (Sema::default(), SourceMap::default());
    let mut files = Vec::new();
    for (name, text) in library::SOURCES {
        files.push(read(&mut map, name, text).map_err(|f| located(&map, vec![f]))?);
    }
    sema.declare(&files, true);
    Ok((sema, map))
});

/// Reads and declares; gives all faults in the order of their places.
fn declared(source: &Source<'_>, host: &dyn Host) -> Result<Declared, Vec<Diagnostic>> {
    let (mut sema, mut map) = LIBRARY.clone()?;
    if !host.declarations().is_empty() {
        let own = read(&mut map, "host", host.declarations()).map_err(|f| located(&map, vec![f]))?;
        sema.declare(&[own], true);
    }
    let user = match source {
        Source::File(text) => read(&mut map, "script", text),
        Source::Parts(own) => parts(&mut map, own),
        Source::Basic(own) => {
            sema.vb = true;
            let (body, additional) = basic(own)?;
            let using = vb::imports(own.using);
            parts(&mut map, &Parts { using: &using, body: &body, additional: &additional, ..*own })
        }
    };
    let user = user.map_err(|f| located(&map, vec![f]))?;
    sema.declare(&[user], false);
    Ok((sema, map))
}

/// The body and the members of a component in VB as C#.
fn basic(component: &Parts<'_>) -> Result<(String, String), Vec<Diagnostic>> {
    let Parts { body, additional, parameters, .. } = *component;
    let wrong = |part: &str, (line, message): (usize, String)| {
        let at = Location { part: part.into(), line: u32::try_from(line).unwrap_or(u32::MAX), column: 1 };
        vec![Diagnostic { at, code: 0, message }]
    };
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let name = |text: &str| text.split(|c: char| !is_part(c)).next().unwrap_or_default().to_owned();
    let mut known: Vec<String> = parameters.split('@').skip(1).map(name).collect();
    known.extend(vb::declared(additional).map_err(|w| wrong("additional", w))?);
    let additional = vb::members(additional, &known).map_err(|w| wrong("additional", w))?;
    let body = vb::body(body, &known).map_err(|w| wrong("script", w))?;
    Ok((body, additional))
}

fn located(map: &SourceMap, mut faults: Vec<crate::diagnostic::Fault>) -> Vec<Diagnostic> {
    faults.sort_by_key(|f| f.pos);
    faults.dedup();
    faults
        .into_iter()
        .map(|f| Diagnostic { at: map.locate(f.pos), code: f.code, message: f.message })
        .collect()
}

fn read(map: &mut SourceMap, name: &str, text: &str) -> crate::diagnostic::Checked<Namespace> {
    let base = map.add(name, text);
    let tokens = syntax::tokens(text, base)?;
    syntax::parse(tokens, base + text.len() as u32)
}

/// The parts of a component put together as one class; each keeps its own places.
fn parts(map: &mut SourceMap, component: &Parts<'_>) -> crate::diagnostic::Checked<Namespace> {
    let Parts { using, body, additional, parameters, usual, base } = *component;
    let before = if base.is_empty() { String::new() } else { format!(" : {base}") };
    let head = format!("public class Script_Instance{before} {{ private void RunScript({parameters}) {{");
    let mut tokens = Vec::new();
    let mut end = 0;
    for (name, text) in [
        ("using", usual),
        ("using", using),
        ("component", &head),
        ("script", body),
        ("component", "}"),
        ("additional", additional),
        ("component", "}"),
    ] {
        let base = map.add(name, text);
        tokens.extend(syntax::tokens(text, base)?);
        if name != "component" || end == 0 {
            end = base + text.len() as u32;
        }
    }
    syntax::parse(tokens, end)
}

impl Engine {
    /// Reads, declares and checks a program.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn new(source: &Source<'_>, host: Box<dyn Host>, limits: Limits) -> Result<Self, Vec<Diagnostic>> {
        let (mut sema, map) = declared(source, host.as_ref())?;
        if !sema.faults.is_empty() {
            return Err(located(&map, std::mem::take(&mut sema.faults)));
        }
        let state = State::new(host, limits, &mut sema);
        let mut program = Program::new(sema);
        program.check();
        if !program.sema.faults.is_empty() {
            return Err(located(&map, std::mem::take(&mut program.sema.faults)));
        }
        program.find_host_members(state.host.as_ref());
        Ok(Self { program, state, map })
    }

    /// Runs the program's `static void Main()`.
    ///
    /// # Errors
    /// An exception that nobody caught, or a stop.
    pub fn run_main(&mut self) -> Result<Value, Failure> {
        let found = self.program.main();
        let Some((id, ty, takes)) = found else {
            return Err(Failure {
                exception: String::new(),
                message: "Program does not contain a static 'Main' method suitable for an entry point"
                    .to_owned(),
                at: None,
                stop: None,
            });
        };
        let mut args = Vec::new();
        if takes {
            let string = self.program.sema.known.string;
            let ty = self.program.sema.array(string, 1);
            args.push(Value::Ref(self.state.heap.add(Obj::Array(ty, Vec::new().into(), None))));
        }
        self.call(id, ty, &args)
    }

    /// A new object of a class of the program, by its constructor without parameters. It is kept for the engine's life.
    ///
    /// # Errors
    /// An exception of the constructor, or a stop; a failure where there is no such class.
    pub fn create(&mut self, class: &str) -> Result<Value, Failure> {
        let missing = || Failure {
            exception: String::new(),
            message: format!("There is no class '{class}' that can be made"),
            at: None,
            stop: None,
        };
        let def = self.program.sema.library("", class, 0).ok_or_else(missing)?;
        let ty = self.program.sema.named(def, &[]);
        let ctor = self.method(class, ".ctor").ok_or_else(missing)?;
        let object = self.state.instance(&mut self.program, ty);
        if let Value::Ref(handle) = object {
            self.state.heap.pins.push(handle);
        }
        self.call(ctor, ty, &[object])?;
        Ok(object)
    }

    /// A method of a class by its name, the first where there are several.
    pub fn method(&self, class: &str, name: &str) -> Option<MethodId> {
        let def = self.program.sema.library("", class, 0)?;
        self.program.sema.def(def).members.get(name)?.iter().find_map(|m| match m {
            crate::sema::Member::Method(id) => Some(*id),
            _ => None,
        })
    }

    /// Calls a method; of instance methods the first argument is the object.
    ///
    /// # Errors
    /// An exception that nobody caught, or a stop.
    pub fn call(&mut self, method: MethodId, owner: Ty, args: &[Value]) -> Result<Value, Failure> {
        // What comes in is reachable from nowhere else until the call has begun.
        let pinned = self.state.heap.pins.len();
        self.state
            .heap
            .pins
            .extend(args.iter().filter_map(|a| if let Value::Ref(h) = a { Some(*h) } else { None }));
        let count = self.state.heap.pins.len() - pinned;
        let result = self.call_pinned(method, owner, args);
        // Texts of functions compiled meanwhile stay behind them.
        self.state.heap.pins.drain(pinned..pinned + count);
        result
    }

    fn call_pinned(&mut self, method: MethodId, owner: Ty, args: &[Value]) -> Result<Value, Failure> {
        self.state.renew();
        if let Some(init) = self.program.static_init(owner) {
            let (func, done) = self.program.static_inits[init as usize];
            if !done {
                self.program.static_inits[init as usize].1 = true;
                crate::vm::run(&mut self.program, &mut self.state, func, &[])
                    .map_err(|e| self.failure(&e.raise, e.at))?;
            }
        }
        let func = self.program.function(Key::Method(method, owner, Vec::new()));
        crate::vm::run(&mut self.program, &mut self.state, func, args)
            .map_err(|e| self.failure(&e.raise, e.at))
    }

    /// Calls a method whose last arguments are references to variables that begin with `refs`. Gives its result and
    /// what the variables hold in the end.
    ///
    /// # Errors
    /// An exception that nobody caught, or a stop.
    pub fn call_with_refs(
        &mut self,
        method: MethodId,
        owner: Ty,
        args: &[Value],
        refs: &[Value],
    ) -> Result<(Value, Vec<Value>), Failure> {
        let object = self.program.sema.known.object;
        let ty = self.program.sema.array(object, 1);
        let handle = self.state.heap.add(Obj::Array(ty, refs.to_vec().into(), None));
        self.state.heap.pins.push(handle);
        let mut all = args.to_vec();
        all.extend((0..refs.len()).map(|i| Value::PartRef(handle, i as u32)));
        let result = self.call(method, owner, &all);
        self.state.heap.pins.retain(|pin| *pin != handle);
        let outs = match self.state.heap.get(handle) {
            Obj::Array(_, data, _) => data.to_values(),
            _ => Vec::new(),
        };
        Ok((result?, outs))
    }

    /// A declared type without type parameters.
    pub fn type_named(&mut self, namespace: &str, name: &str) -> Option<Ty> {
        let def = self.program.sema.library(namespace, name, 0)?;
        Some(self.program.sema.named(def, &[]))
    }

    /// A new object with these fields, for use as an argument.
    pub fn instance(&mut self, ty: Ty, fields: &[Value]) -> Value {
        self.program.layout(ty);
        Value::Ref(self.state.heap.add(Obj::Inst(ty, fields.into())))
    }

    /// A struct whose fields are all zero; null for any other type.
    pub fn default_of(&mut self, ty: Ty) -> Value {
        self.state.default_of(&mut self.program, ty)
    }

    /// What runs may use from now on.
    pub fn limit(&mut self, limits: Limits) {
        self.state.heap.limit = limits.bytes;
        self.state.limits = limits;
    }

    /// A new `List<T>`, for use as an argument.
    pub fn list(&mut self, element: Ty, items: Vec<Value>) -> Value {
        let def = self.program.sema.library("System.Collections.Generic", "List", 1);
        let ty = def.map_or(Ty::ERROR, |def| self.program.sema.named(def, &[element]));
        Value::Ref(self.state.heap.add(Obj::List(ty, items.into(), 0)))
    }

    /// The machine, to make and look at values.
    pub fn state(&mut self) -> &mut State {
        &mut self.state
    }

    /// What is declared.
    pub fn sema(&mut self) -> &mut Sema {
        &mut self.program.sema
    }

    /// The text of a value.
    pub fn text_of(&mut self, value: Value) -> String {
        library::text_of(value, &self.state, &mut self.program.sema)
    }

    fn failure(&self, raise: &Raise, at: u32) -> Failure {
        let place = if at > 0 { Some(self.map.locate(at)) } else { None };
        match raise {
            Raise::Stop(stop) => Failure {
                exception: String::new(),
                message: stop.to_string(),
                at: place,
                stop: Some(stop.clone()),
            },
            Raise::Exception(name, message) => Failure {
                exception: format!("System.{name}"),
                message: message.clone(),
                at: place,
                stop: None,
            },
            Raise::Object(value) => {
                let ty = self.state.type_of(*value, &self.program.sema);
                let exception = self.program.sema.full_name(ty);
                let message = match value {
                    Value::Ref(handle) => match self.state.heap.get(*handle) {
                        Obj::Inst(_, fields) => fields.first().and_then(|m| self.state.string(*m)),
                        _ => None,
                    },
                    _ => None,
                };
                let message =
                    message.unwrap_or_else(|| format!("Exception of type '{exception}' was thrown."));
                Failure { exception, message, at: place, stop: None }
            }
        }
    }
}

impl Program {
    /// Binds all of the user's methods, so that every fault is found before anything runs.
    pub(crate) fn check(&mut self) {
        let own: Vec<_> = (0..self.sema.defs.len()).filter(|i| !self.sema.defs[*i].library).collect();
        for i in own {
            let def = crate::sema::DefId(i as u32);
            // Functions with type parameters in functions become methods while others are bound.
            let mut next = 0;
            while let Some(method) = self.sema.def(def).methods.get(next).copied() {
                crate::bind::check_defaults(&mut self.sema, method);
                self.body(method);
                next += 1;
            }
            self.static_body(def);
            for field in 0..self.sema.fields.len() {
                if self.sema.fields[field].owner == def && self.sema.fields[field].constant {
                    crate::bind::constant_of(&mut self.sema, crate::sema::FieldId(field as u32));
                }
            }
        }
        self.sema.check_noted();
    }

    /// Asks the host for its members.
    pub(crate) fn find_host_members(&mut self, host: &dyn Host) {
        for method in &self.sema.methods {
            if let crate::sema::Body::Extern(key) = &method.body
                && let Some(number) = host.member(key)
            {
                self.host_keys.insert(key.clone(), number);
            }
        }
    }

    /// `static Main`, and whether it takes texts.
    fn main(&mut self) -> Option<(MethodId, Ty, bool)> {
        let found = (0..self.sema.methods.len()).find(|i| {
            let m = &self.sema.methods[*i];
            &*m.name == "Main" && m.is_static && !self.sema.def(m.owner).library
        })?;
        let (owner, takes) = (self.sema.methods[found].owner, !self.sema.methods[found].params.is_empty());
        let ty = self.sema.open(owner);
        Some((MethodId(found as u32), ty, takes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bodies of the library are bound when they are first called: here all are, so that none can fail later.
    #[test]
    fn the_library_has_no_faults() {
        let (mut sema, map) = LIBRARY.clone().unwrap_or_default();
        State::new(Box::new(crate::Printing::default()), Limits::default(), &mut sema);
        for def in &mut sema.defs {
            def.library = false;
        }
        let mut program = Program::new(sema);
        program.check();
        let faults = located(&map, std::mem::take(&mut program.sema.faults));
        assert!(program.sema.defs.len() > 100, "the library was read");
        assert_eq!(faults, [], "faults");
    }
}
