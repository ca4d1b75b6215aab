//! Bound trees to operations on registers, for concrete types.

mod branch;
mod call;
mod effect;
mod expression;
mod hoist;
mod inline;
mod intrinsic;
mod lambda;
mod place;
mod quiet;
mod split;
mod statement;
mod steps;
mod uses;

use std::collections::HashMap;
use std::sync::Arc;

pub(crate) use expression::number;
pub(crate) use quiet::Quiet;

use crate::bound::{Body, Label, LocalId, Stmt, StmtKind};
use crate::program::{Key, Program, Start};
use crate::sema::{DefId, Substitution, Ty};
use crate::source::Pos;
use crate::syntax::ast::Passing;
use crate::vm::op::{Function, Handler, Op, Reg};
use crate::vm::value::Value;

/// Why a function cannot be compiled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Refused(pub(crate) Pos, pub(crate) String);

type Emitted<T> = Result<T, Refused>;

/// A function, and the places of texts among its constants.
type Compiled = (Function, HashMap<Arc<[u16]>, u32>);

/// The variables of a block that lambdas share with it.
#[derive(Debug, Clone)]
struct Env {
    locals: Vec<LocalId>,
    has_this: bool,
    /// Where it is in the function that is being compiled.
    reg: Option<Reg>,
}

/// A place in the code that is not known yet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Mark(u32);

/// A `try` around what is being compiled.
#[derive(Debug, Clone)]
struct Guard {
    finally: Option<Arc<Stmt>>,
    /// Ranges of code inside it that it does not guard.
    gaps: Vec<(u32, u32)>,
}

struct Emitter<'p> {
    program: &'p mut Program,
    /// The class that the function stands in.
    def: Option<DefId>,
    body: Arc<Body>,
    by: Substitution,
    f: Function,
    regs: HashMap<LocalId, Reg>,
    /// Parameters, which come in registers.
    fixed: Vec<LocalId>,
    held: HashMap<u32, Reg>,
    next: u32,
    envs: Vec<Env>,
    marks: Vec<Option<u32>>,
    /// The last place that is jumped to.
    last_mark: u32,
    labels: HashMap<Label, (Mark, usize)>,
    guards: Vec<Guard>,
    /// Exceptions of the `catch` that is being compiled.
    caught: Vec<Reg>,
    this: Option<Reg>,
    /// Variables that are structs in their parts, and the object of a method in place where it is one.
    parts: HashMap<LocalId, inline::Parts>,
    held_parts: HashMap<u32, inline::Parts>,
    this_parts: Option<inline::Parts>,
    /// Where a method in place of its call puts its result, and where what follows it is.
    goes_on: Option<(Reg, Mark)>,
    in_lambda: bool,
    texts: HashMap<Arc<[u16]>, u32>,
    /// The constants of the outermost loop.
    hoisted: Option<hoist::Hoisted>,
    /// How many methods stand in one another without a call.
    inlined: u32,
    /// Whether all variables have registers before anything runs.
    reserved: bool,
    pos: Pos,
}

/// The most registers of a function.
const MAX_REGS: u32 = 20_000;

/// Compiles a function.
pub(crate) fn compile(
    program: &mut Program,
    number: u32,
    add_text: &mut dyn FnMut(&[u16]) -> Value,
) -> Result<(), Refused> {
    let Some(Some(key)) = program.sources.get(number as usize).cloned() else { return Ok(()) };
    let (body, by, name, has_this) = match &key {
        Key::Method(id, owner, args) => {
            if program.too_many_types(*owner) || args.iter().any(|a| program.too_many_types(*a)) {
                return Err(Refused(
                    program.sema.method(*id).pos,
                    "Types stand too deeply in one another".to_owned(),
                ));
            }
            let info = program.sema.method(*id).clone();
            let mut by = program.sema.substitution(*owner);
            by.0.extend(Substitution::of(&info.type_params, args).0);
            if let crate::sema::Body::Auto(field, set) = info.body {
                compile_auto(program, number, *owner, field, set, info.is_static);
                return Ok(());
            }
            let body = program.body(*id);
            (body, by, program.sema.show_method(*id), !info.is_static)
        }
        Key::Dynamic(..) => {
            let body = program.dynamic_bodies.get(&number).cloned();
            (body, Substitution::default(), "dynamic".to_owned(), false)
        }
        Key::Statics(ty) => {
            let def = program.sema.def_of(*ty);
            let body = def.and_then(|d| program.static_body(d));
            (body, program.sema.substitution(*ty), format!("{}..cctor", program.sema.show(*ty)), false)
        }
    };
    let Some(body) = body else {
        return Err(Refused(0, format!("{name} has no body")));
    };
    if let Some(fault) = program.sema.faults.first() {
        return Err(Refused(fault.pos, fault.message.clone()));
    }
    let def = match &key {
        Key::Method(id, ..) => Some(program.sema.method(*id).owner),
        Key::Statics(ty) => program.sema.def_of(*ty),
        Key::Dynamic(site, _) => program.dynamics.get(*site as usize).map(|site| site.def),
    };
    let mut emitter = Emitter::new(program, body, by);
    emitter.def = def;
    emitter.f.name = name;
    let function = emitter.method(has_this)?;
    program.finish(number, function, add_text);
    Ok(())
}

/// An automatic property reads or writes its field.
fn compile_auto(
    program: &mut Program,
    number: u32,
    owner: Ty,
    field: crate::sema::FieldId,
    set: bool,
    is_static: bool,
) {
    let mut f = Function {
        name: "property".to_owned(),
        regs: 3,
        params: u32::from(!is_static) + u32::from(set),
        ..Function::default()
    };
    if is_static {
        if let Some(i) = program.static_init(owner) {
            f.code.push(Op::Init { i });
        }
        let s = program.static_base(owner) + program.sema.field(field).index;
        f.code.push(if set { Op::StoreStatic { s, v: 0 } } else { Op::LoadStatic { d: 0, s } });
    } else {
        let i = program.field_index(owner, field);
        f.code.push(if set { Op::StoreField { o: 0, i, v: 1 } } else { Op::LoadField { d: 0, o: 0, i } });
    }
    if !set {
        let ty = program.field_type(owner, field);
        if program.sema.is_struct(ty) {
            f.code.push(Op::Copy { d: 0, a: 0 });
        }
    }
    f.code.push(if set { Op::ReturnVoid } else { Op::Return { a: 0 } });
    program.link(number, f);
}

impl Program {
    /// Puts a compiled function in its place; texts among its constants go into the heap.
    fn finish(&mut self, number: u32, compiled: Compiled, add_text: &mut dyn FnMut(&[u16]) -> Value) {
        let (mut function, texts) = compiled;
        self.funcs[number as usize] = Function::default();
        let mut waiting = std::mem::take(&mut self.pending_texts);
        for (number, list) in waiting.drain(..) {
            for (place, text) in list {
                let value = self.text_value(&text, add_text);
                if let Some(slot) = self.funcs[number as usize].consts.get_mut(place as usize) {
                    *slot = value;
                }
            }
        }
        for (text, place) in texts {
            let value = self.text_value(&text, add_text);
            if let Some(slot) = function.consts.get_mut(place as usize) {
                *slot = value;
            }
        }
        self.link(number, function);
    }

    /// Puts the code of a function behind that of all others; its places are among them from then on.
    fn link(&mut self, number: u32, mut function: Function) {
        let entry = self.code.len() as u32;
        for op in &mut function.code {
            if let Some(to) = op.target_mut() {
                *to += entry;
            }
        }
        for (at, _) in &mut function.places {
            *at += entry;
        }
        for handler in &mut function.handlers {
            handler.from += entry;
            handler.to += entry;
            handler.target += entry;
        }
        self.code.append(&mut function.code);
        function.entry = Some(entry);
        self.funcs[number as usize] = function;
    }

    fn text_value(&mut self, text: &Arc<[u16]>, add_text: &mut dyn FnMut(&[u16]) -> Value) -> Value {
        if let Some(handle) = self.texts.get(text) {
            return Value::Ref(*handle);
        }
        let value = add_text(text);
        if let Value::Ref(handle) = value {
            self.texts.insert(text.clone(), handle);
        }
        value
    }
}

impl<'p> Emitter<'p> {
    fn new(program: &'p mut Program, body: Arc<Body>, by: Substitution) -> Self {
        Self {
            program,
            def: None,
            body,
            by,
            f: Function::default(),
            regs: HashMap::new(),
            fixed: Vec::new(),
            held: HashMap::new(),
            next: 0,
            envs: Vec::new(),
            marks: Vec::new(),
            last_mark: 0,
            labels: HashMap::new(),
            guards: Vec::new(),
            caught: Vec::new(),
            this: None,
            parts: HashMap::new(),
            held_parts: HashMap::new(),
            this_parts: None,
            goes_on: None,
            in_lambda: false,
            texts: HashMap::new(),
            hoisted: None,
            inlined: 0,
            reserved: false,
            pos: 0,
        }
    }

    fn method(mut self, has_this: bool) -> Emitted<Compiled> {
        let body = self.body.clone();
        if has_this {
            self.this = Some(self.alloc()?);
        }
        for param in &body.params {
            let reg = self.alloc()?;
            self.regs.insert(*param, reg);
            self.fixed.push(*param);
        }
        self.f.params = self.next;
        if let Some(element) = body.iterator {
            self.f.generator = Some(self.iterator_of(element));
        }
        if body.captures_this && has_this {
            // A block of its own around all others holds the object itself.
            let d = self.alloc()?;
            let parent = self.null()?;
            self.op(Op::NewEnv { d, n: 1, parent });
            if let Some(this) = self.this {
                self.op(Op::StoreField { o: d, i: 1, v: this });
            }
            self.envs.push(Env { locals: Vec::new(), has_this: true, reg: Some(d) });
        }
        self.labels_of(&body.stmt, 0);
        if self.program.sema.vb && has_jumps(&body.stmt) {
            self.reserve(&body.stmt)?;
        }
        self.stmt(&body.stmt)?;
        self.op(Op::ReturnVoid);
        self.close()
    }

    /// In VB a jump may enter a block: all variables have registers of their own and begin with their default values.
    fn reserve(&mut self, stmt: &Stmt) -> Emitted<()> {
        self.reserved = true;
        if let StmtKind::Block(locals, _) = &stmt.kind {
            let body = self.body.clone();
            for local in locals {
                let Some(info) = body.locals.get(local.0 as usize).filter(|l| !l.captured) else { continue };
                if self.fixed.contains(local) {
                    continue;
                }
                let d = self.alloc()?;
                self.regs.insert(*local, d);
                let ty = self.ty(info.ty);
                self.default_into(d, ty);
            }
        }
        let mut inner = Vec::new();
        each_inner(stmt, &mut |s| inner.push(s));
        inner.into_iter().try_for_each(|s| self.reserve(s))
    }

    /// The type of iterators over elements of a type.
    fn iterator_of(&mut self, element: Ty) -> Ty {
        let element = self.ty(element);
        let def = self.program.sema.known.iterator;
        self.program.sema.named(def, &[element])
    }

    /// Resolves jumps.
    fn close(mut self) -> Emitted<Compiled> {
        let marks = self.marks;
        let at = |to: u32| marks.get(to as usize).copied().flatten().unwrap_or(0);
        for op in &mut self.f.code {
            if let Some(to) = op.target_mut() {
                *to = at(*to);
            }
        }
        for handler in &mut self.f.handlers {
            handler.target = at(handler.target);
        }
        Ok((self.f, self.texts))
    }

    /// A type with its parameters replaced, as it is at run time.
    fn ty(&mut self, ty: Ty) -> Ty {
        let ty = self.program.sema.types.substitute(ty, &self.by);
        self.program.sema.types.erase(ty)
    }

    fn alloc(&mut self) -> Emitted<Reg> {
        self.allocs(1)
    }

    /// Registers in a row.
    fn allocs(&mut self, n: u32) -> Emitted<Reg> {
        let first = self.next;
        self.next += n;
        if self.next > MAX_REGS {
            return Err(Refused(self.pos, "The function is too long".to_owned()));
        }
        self.f.regs = self.f.regs.max(self.next);
        Ok(first as Reg)
    }

    fn op(&mut self, op: Op) {
        let op = op.narrow();
        let pc = self.f.code.len() as u32;
        if self.last_mark < pc
            && let Some(last) = self.f.code.last_mut()
            && let Some(both) = last.fused(op)
        {
            *last = both;
            return;
        }
        if self.f.places.last().is_none_or(|(_, pos)| *pos != self.pos) {
            self.f.places.push((pc, self.pos));
        }
        self.f.code.push(op);
    }

    fn here(&self) -> u32 {
        self.f.code.len() as u32
    }

    fn mark(&mut self) -> Mark {
        self.marks.push(None);
        Mark(self.marks.len() as u32 - 1)
    }

    fn set(&mut self, mark: Mark) {
        let here = self.here();
        self.last_mark = here;
        if let Some(place) = self.marks.get_mut(mark.0 as usize) {
            *place = Some(here);
        }
    }

    /// The first is where the second is.
    fn same_place(&mut self, mark: Mark, other: Mark) {
        let at = self.marks.get(other.0 as usize).copied().flatten();
        if let Some(place) = self.marks.get_mut(mark.0 as usize) {
            *place = at;
        }
    }

    fn jump(&mut self, to: Mark) {
        self.op(Op::Jump { to: to.0 });
    }

    fn constant(&mut self, value: Value) -> u32 {
        if let Some(at) =
            self.f.consts.iter().position(|v| *v == value && !matches!(v, Value::F64(_) | Value::F32(_)))
        {
            return at as u32;
        }
        self.f.consts.push(value);
        self.f.consts.len() as u32 - 1
    }

    fn text_constant(&mut self, text: &Arc<[u16]>) -> u32 {
        if let Some(at) = self.texts.get(text) {
            return *at;
        }
        // A mark that is equal to no other constant, until the text is in the heap.
        self.f.consts.push(Value::StaticRef(u32::MAX - 1));
        let at = self.f.consts.len() as u32 - 1;
        self.texts.insert(text.clone(), at);
        at
    }

    fn null(&mut self) -> Emitted<Reg> {
        let d = self.alloc()?;
        let k = self.constant(Value::Null);
        self.op(Op::Const { d, k });
        Ok(d)
    }

    /// The value that a variable of a type begins with.
    fn default_into(&mut self, d: Reg, ty: Ty) {
        match self.program.start(ty) {
            Start::Value(Value::I32(v)) => self.op(Op::Int { d, v }),
            Start::Value(value) => {
                let k = self.constant(value);
                self.op(Op::Const { d, k });
            }
            Start::Struct(ty) => {
                self.program.layout(ty);
                self.op(Op::New { d, ty });
            }
        }
    }

    /// The register of an object that blocks share, and the place of a variable in it.
    fn captured(&mut self, local: LocalId) -> Emitted<Option<(Reg, Reg)>> {
        let Some(at) = self.envs.iter().rposition(|env| env.locals.contains(&local)) else { return Ok(None) };
        let index = self.envs[at].locals.iter().position(|l| *l == local).unwrap_or(0) as Reg + 1;
        let reg = self.env(at)?;
        Ok(Some((reg, index)))
    }

    /// A shared object, by going from the innermost outwards.
    fn env(&mut self, at: usize) -> Emitted<Reg> {
        if let Some(reg) = self.envs[at].reg {
            return Ok(reg);
        }
        // Everything between is outside this lambda; the innermost came in as its first register.
        let innermost = self.envs.iter().rposition(|env| env.reg.is_none()).unwrap_or(at);
        let mut reg: Reg = 0;
        for _ in at..innermost {
            let d = self.alloc()?;
            self.op(Op::LoadField { d, o: reg, i: 0 });
            reg = d;
        }
        Ok(reg)
    }

    fn innermost_env(&mut self) -> Emitted<Reg> {
        match self.envs.len() {
            0 => self.null(),
            n => self.env(n - 1),
        }
    }

    /// The object itself.
    fn this(&mut self) -> Emitted<Reg> {
        if let Some(this) = self.this {
            return Ok(this);
        }
        if let Some(parts) = self.this_parts {
            let d = self.alloc()?;
            self.build(d, parts);
            return Ok(d);
        }
        let Some(at) = self.envs.iter().position(|env| env.has_this) else {
            return self.null();
        };
        let env = self.env(at)?;
        let d = self.alloc()?;
        self.op(Op::LoadField { d, o: env, i: 1 });
        Ok(d)
    }

    fn is_reference_param(&self, local: LocalId) -> bool {
        self.body.locals.get(local.0 as usize).is_some_and(|l| l.passing != Passing::Value)
    }

    fn unsupported(&mut self, d: Reg, what: &str) {
        self.f.messages.push(what.to_owned());
        let k = self.f.messages.len() as u32 - 1;
        self.op(Op::NotSupported { k });
        let k = self.constant(Value::Null);
        self.op(Op::Const { d, k });
    }

    fn handler(&mut self, from: u32, to: u32, gaps: &[(u32, u32)], target: Mark, reg: Reg, finally: bool) {
        let mut start = from;
        let mut ranges = Vec::new();
        for (gap_from, gap_to) in gaps {
            if *gap_from > start {
                ranges.push((start, *gap_from));
            }
            start = start.max(*gap_to);
        }
        if to > start {
            ranges.push((start, to));
        }
        for (from, to) in ranges {
            self.f.handlers.push(Handler { from, to, target: target.0, reg, finally });
        }
    }
}

/// The statements that stand directly in one.
fn each_inner<'s>(stmt: &'s Stmt, take: &mut dyn FnMut(&'s Stmt)) {
    match &stmt.kind {
        StmtKind::Block(_, list) | StmtKind::Several(list) => list.iter().for_each(take),
        StmtKind::If(_, yes, no) => {
            take(yes);
            if let Some(no) = no {
                take(no);
            }
        }
        StmtKind::Loop(_, body, ..) | StmtKind::DoLoop(body, ..) => take(body),
        StmtKind::Try(body, catches, finally) => {
            take(body);
            catches.iter().for_each(|catch| take(&catch.body));
            if let Some(finally) = finally {
                take(finally);
            }
        }
        _ => {}
    }
}

/// Whether a jump to a label stands in a statement.
fn has_jumps(stmt: &Stmt) -> bool {
    let mut found = matches!(stmt.kind, StmtKind::Goto(_));
    each_inner(stmt, &mut |inner| found = found || has_jumps(inner));
    found
}
