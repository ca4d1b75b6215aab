//! Definite assignment (C# specification, 9.4): which variables have a value for certain where they are read.
//!
//! The bound tree is gone through once, forwards. What is assigned where a loop begins is what is assigned before it: a
//! jump back can only come from below and brings no less.

use std::collections::HashMap;

use super::assigned_set::Assigned;
use crate::bound::{Arg, Body, Expr, FieldRef, Kind, Label, LocalId, Stmt, StmtKind};
use crate::diagnostic::Fault;
use crate::sema::{FieldId, Sema};
use crate::source::Pos;
use crate::syntax::ast::Passing;

/// Faults of a body: variables that are read, and `out` parameters that are left, without a value.
pub(super) fn unassigned(sema: &Sema, body: &Body) -> Vec<Fault> {
    let mut flow = Flow {
        sema,
        body,
        places: HashMap::new(),
        count: 0,
        now: Assigned::default(),
        labels: HashMap::new(),
        faults: Vec::new(),
        in_lambda: false,
        around: Around::default(),
        placed: HashMap::new(),
        jumps: Vec::new(),
        blocks: vec![0],
        made: 0,
    };
    for param in &body.params {
        if flow.passing(*param) == Passing::Out {
            flow.declare(*param);
        }
    }
    flow.stmt(&body.stmt);
    if !flow.now.is_dead() {
        flow.leave(body.stmt.pos);
    }
    // A label is seen in its own block and in those within it.
    let unseen = |(_, label, around): &&(Pos, Label, Vec<u32>)| {
        flow.placed.get(label).is_none_or(|block| !around.contains(block))
    };
    if let Some((pos, ..)) = flow.jumps.iter().find(unseen) {
        let message = "No such label within the scope of the goto statement";
        flow.faults.push(Fault::new(*pos, 159, message));
    }
    flow.faults
}

/// Where a variable, and each of its fields if it is a struct, stands among what can be assigned.
struct Place {
    whole: usize,
    fields: Vec<(FieldId, usize)>,
}

/// What stands around a statement inside its function.
#[derive(Debug, Clone, Copy, Default)]
struct Around {
    /// A `try` with a `catch`.
    tried: bool,
    catch: bool,
    finally: bool,
}

struct Flow<'a> {
    sema: &'a Sema,
    body: &'a Body,
    places: HashMap<LocalId, Place>,
    count: usize,
    now: Assigned,
    /// What is assigned at the jumps to a label so far.
    labels: HashMap<Label, Assigned>,
    faults: Vec<Fault>,
    in_lambda: bool,
    around: Around,
    /// The blocks that labels stand in, and the jumps with the blocks around them.
    placed: HashMap<Label, u32>,
    jumps: Vec<(Pos, Label, Vec<u32>)>,
    /// The blocks around what is looked at, the innermost last, and how many there were so far.
    blocks: Vec<u32>,
    made: u32,
}

impl Flow<'_> {
    fn passing(&self, local: LocalId) -> Passing {
        self.body.locals.get(local.0 as usize).map_or(Passing::Value, |l| l.passing)
    }

    /// A variable begins without a value.
    fn declare(&mut self, local: LocalId) {
        if !self.places.contains_key(&local) {
            let ty = self.body.locals.get(local.0 as usize).map(|l| l.ty);
            let def = ty.filter(|ty| self.sema.is_struct(*ty)).and_then(|ty| self.sema.def_of(ty));
            let own = def.map(|def| self.sema.def(def)).filter(|def| !def.library);
            let whole = self.count;
            let fields: Vec<_> = own
                .iter()
                .flat_map(|def| &def.fields)
                .enumerate()
                .map(|(i, field)| (*field, whole + 1 + i))
                .collect();
            self.count += 1 + fields.len();
            self.places.insert(local, Place { whole, fields });
        }
        if let Some(place) = self.places.get(&local) {
            self.now.clear(place.whole);
            place.fields.iter().for_each(|(_, at)| self.now.clear(*at));
        }
    }

    fn set(&mut self, local: LocalId) {
        if let Some(place) = self.places.get(&local) {
            self.now.set(place.whole);
        }
    }

    fn set_field(&mut self, local: LocalId, field: FieldRef) {
        let Some(place) = self.places.get(&local) else { return };
        if let Some((_, at)) = place.fields.iter().find(|(id, _)| *id == field.id) {
            self.now.set(*at);
        }
        if place.fields.iter().all(|(_, at)| self.now.has(*at)) {
            self.now.set(place.whole);
        }
    }

    /// A variable is read. It is told once.
    fn read(&mut self, local: LocalId, pos: Pos) {
        let Some(place) = self.places.get(&local) else { return };
        if self.now.has(place.whole) {
            return;
        }
        self.now.set(place.whole);
        let Some(info) = self.body.locals.get(local.0 as usize) else { return };
        let (code, what) =
            if info.passing == Passing::Out { (269, "out parameter") } else { (165, "local variable") };
        self.faults.push(Fault::new(pos, code, format!("Use of unassigned {what} '{}'", info.name)));
    }

    fn read_field(&mut self, local: LocalId, field: FieldRef, pos: Pos) {
        let Some(place) = self.places.get(&local) else { return };
        let own = place.fields.iter().find(|(id, _)| *id == field.id).map(|(_, at)| *at);
        let Some(at) = own else { return self.read(local, pos) };
        if !self.now.has(place.whole) && !self.now.has(at) {
            self.now.set(at);
            let name = self.sema.field(field.id).name.clone();
            let message = format!("Use of possibly unassigned field '{name}'");
            self.faults.push(Fault::new(pos, 170, message));
        }
    }

    /// The function is left: its `out` parameters must have values.
    fn leave(&mut self, pos: Pos) {
        if self.in_lambda {
            return;
        }
        for param in &self.body.params {
            let Some(place) = self.places.get(param) else { continue };
            if self.now.has(place.whole) {
                continue;
            }
            self.now.set(place.whole);
            let name = self.body.locals.get(param.0 as usize).map(|l| l.name.clone()).unwrap_or_default();
            let message = format!(
                "The out parameter '{name}' must be assigned to before control leaves the current method"
            );
            self.faults.push(Fault::new(pos, 177, message));
        }
    }

    fn goto(&mut self, pos: Pos, label: Label) {
        self.jumps.push((pos, label, self.blocks.clone()));
        let now = self.now.clone();
        self.labels.entry(label).and_modify(|before| before.meet(&now)).or_insert(now);
        self.now.die();
    }

    fn arrive(&mut self, label: Label) {
        self.placed.insert(label, self.blocks.last().copied().unwrap_or(0));
        if let Some(from) = self.labels.get(&label) {
            self.now.meet(from);
        }
    }

    fn fault(&mut self, pos: Pos, code: u16, message: &str) {
        self.faults.push(Fault::new(pos, code, message));
    }

    /// Something is done on one of two ways.
    fn either(
        &mut self,
        one: Assigned,
        run: impl FnOnce(&mut Self),
        other: Assigned,
        run_other: impl FnOnce(&mut Self),
    ) {
        self.now = one;
        run(self);
        let end = std::mem::replace(&mut self.now, other);
        run_other(self);
        self.now.meet(&end);
    }

    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Block(_, list) => {
                self.made += 1;
                self.blocks.push(self.made);
                list.iter().for_each(|s| self.stmt(s));
                self.blocks.pop();
            }
            StmtKind::Several(list) => list.iter().for_each(|s| self.stmt(s)),
            StmtKind::Expr(e) => match declared(stmt, e) {
                Some(local) => self.declare(local),
                None => self.expr(e),
            },
            StmtKind::If(c, yes, no) => {
                let (t, f) = self.condition(c);
                self.either(t, |s| s.stmt(yes), f, |s| no.iter().for_each(|no| s.stmt(no)));
            }
            StmtKind::Loop(c, body, step, brk, cont) => {
                let (t, f) = match c {
                    Some(c) => self.condition(c),
                    None => (self.now.clone(), Assigned::dead()),
                };
                self.now = t;
                self.stmt(body);
                self.arrive(*cont);
                step.iter().for_each(|e| self.expr(e));
                self.now = f;
                self.arrive(*brk);
            }
            StmtKind::DoLoop(body, c, brk, cont) => {
                self.stmt(body);
                self.arrive(*cont);
                self.now = self.condition(c).1;
                self.arrive(*brk);
            }
            StmtKind::Label(label) => self.arrive(*label),
            StmtKind::Goto(label) => self.goto(stmt.pos, *label),
            StmtKind::Return(value) => {
                if self.around.finally {
                    self.fault(stmt.pos, 157, "Control cannot leave the body of a finally clause");
                }
                value.iter().for_each(|e| self.expr(e));
                if !self.now.is_dead() {
                    self.leave(stmt.pos);
                }
                self.now.die();
            }
            StmtKind::Throw(value) => {
                if value.is_none() && !self.around.catch {
                    let message =
                        "A throw statement with no arguments is not allowed outside of a catch clause";
                    self.fault(stmt.pos, 156, message);
                }
                value.iter().for_each(|e| self.expr(e));
                self.now.die();
            }
            StmtKind::Yield(Some(e)) => {
                if self.around.tried {
                    let message = "Cannot yield a value in the body of a try block with a catch clause";
                    self.fault(stmt.pos, 1626, message);
                } else if self.around.catch {
                    self.fault(stmt.pos, 1631, "Cannot yield a value in the body of a catch clause");
                } else if self.around.finally {
                    self.fault(stmt.pos, 1625, "Cannot yield in the body of a finally clause");
                }
                self.expr(e);
            }
            StmtKind::Yield(None) => self.now.die(),
            StmtKind::Try(body, catches, finally) => {
                let before = self.now.clone();
                let around = self.around;
                self.around.tried |= !catches.is_empty();
                self.stmt(body);
                let mut end = self.now.clone();
                self.around = Around { catch: true, ..around };
                for catch in catches {
                    self.now = before.clone();
                    if let Some(filter) = &catch.filter {
                        self.now = self.condition(filter).0;
                    }
                    self.stmt(&catch.body);
                    end.meet(&self.now);
                }
                self.around = Around { finally: true, ..around };
                if let Some(finally) = finally {
                    self.now = before;
                    self.stmt(finally);
                    end.join(&self.now);
                }
                self.around = around;
                self.now = end;
            }
        }
    }

    /// What is assigned when a condition holds and when it does not.
    fn condition(&mut self, e: &Expr) -> (Assigned, Assigned) {
        match &e.kind {
            Kind::Const(crate::bound::Const::Bool(true)) => (self.now.clone(), Assigned::dead()),
            Kind::Const(crate::bound::Const::Bool(false)) => (Assigned::dead(), self.now.clone()),
            Kind::Not(inner) => {
                let (t, f) = self.condition(inner);
                (f, t)
            }
            Kind::And(a, b) => {
                let (t, f) = self.condition(a);
                self.now = t;
                let (t, mut other) = self.condition(b);
                other.meet(&f);
                (t, other)
            }
            Kind::Or(a, b) => {
                let (t, f) = self.condition(a);
                self.now = f;
                let (mut other, f) = self.condition(b);
                other.meet(&t);
                (other, f)
            }
            Kind::Choice(c, a, b) => {
                let (t, f) = self.condition(c);
                self.now = t;
                let (mut yes, mut no) = self.condition(a);
                self.now = f;
                let (other_yes, other_no) = self.condition(b);
                yes.meet(&other_yes);
                no.meet(&other_no);
                (yes, no)
            }
            _ => {
                self.expr(e);
                (self.now.clone(), self.now.clone())
            }
        }
    }

    fn arguments(&mut self, args: &[Arg]) {
        for (passing, arg) in args {
            if *passing == Passing::Out {
                self.target(arg);
            } else {
                self.expr(arg);
            }
        }
        for (_, arg) in args.iter().filter(|(passing, _)| *passing == Passing::Out) {
            self.assigned_to(arg);
        }
    }

    /// What is read to find the place that is assigned to.
    fn target(&mut self, place: &Expr) {
        match &place.kind {
            Kind::Local(_) => {}
            Kind::Field(Some(of), _) if matches!(of.kind, Kind::Local(_)) && self.sema.is_struct(of.ty) => {}
            Kind::Field(Some(of), _) if self.sema.is_struct(of.ty) => self.target(of),
            Kind::Prop(of, args, ..) => {
                of.iter().for_each(|of| self.expr(of));
                self.arguments(args);
            }
            _ => self.expr(place),
        }
    }

    fn assigned_to(&mut self, place: &Expr) {
        match &place.kind {
            Kind::Local(id) => self.set(*id),
            Kind::Field(Some(of), field) => {
                if let Kind::Local(id) = of.kind {
                    self.set_field(id, *field);
                }
            }
            _ => {}
        }
    }

    /// A function in here: it may run at any later time, so what it assigns is not assigned here.
    fn lambda(&mut self, body: &Stmt, is_local_function: bool) {
        let before = self.now.clone();
        if is_local_function {
            // It stands before everything else of its block; where it is called is not followed.
            self.now = Assigned::all(self.count);
        }
        let outer = std::mem::replace(&mut self.in_lambda, true);
        let around = std::mem::take(&mut self.around);
        self.stmt(body);
        self.in_lambda = outer;
        self.around = around;
        self.now = before;
    }

    fn expr(&mut self, e: &Expr) {
        match &e.kind {
            Kind::Local(id) => self.read(*id, e.pos),
            Kind::Field(Some(of), field) => match &of.kind {
                Kind::Local(id) if self.sema.is_struct(of.ty) => self.read_field(*id, *field, e.pos),
                _ => self.expr(of),
            },
            Kind::Assign(place, value) => {
                self.target(place);
                self.expr(value);
                self.assigned_to(place);
            }
            Kind::And(..) | Kind::Or(..) | Kind::Not(_) => {
                let (t, f) = self.condition(e);
                self.now = t;
                self.now.meet(&f);
            }
            Kind::Choice(c, a, b) => {
                let (t, f) = self.condition(c);
                self.either(t, |s| s.expr(a), f, |s| s.expr(b));
            }
            Kind::Coalesce(a, b) | Kind::Conditional(a, _, b) => {
                self.expr(a);
                let before = self.now.clone();
                self.expr(b);
                self.now = before;
            }
            Kind::Bind(_, place) | Kind::Ref(place) | Kind::Deref(place) => self.expr(place),
            Kind::Throw(value) => {
                self.expr(value);
                self.now.die();
            }
            Kind::Lambda(lambda) => self.lambda(&lambda.body, e.ty == self.sema.known.object),
            Kind::Block(stmts, value) => {
                stmts.iter().for_each(|s| self.stmt(s));
                self.expr(value);
            }
            Kind::Prop(_, _, None, Some(setter), _) => {
                let info = self.sema.method(setter.id);
                let name = info.name.trim_start_matches("set_");
                let owner = &self.sema.def(info.owner).name;
                let message = format!(
                    "The property or indexer '{owner}.{name}' cannot be used in this context because it lacks the get accessor"
                );
                self.fault(e.pos, 154, &message);
            }
            Kind::Call(of, _, args, _) | Kind::Prop(of, args, ..) => {
                of.iter().for_each(|of| self.expr(of));
                self.arguments(args);
            }
            Kind::Invoke(of, args) => {
                self.expr(of);
                self.arguments(args);
            }
            Kind::New(_, args) => self.arguments(args),
            Kind::Lifted(a, b, _, inner, _) => [a, b, inner].into_iter().for_each(|e| self.expr(e)),
            Kind::Binary(_, _, _, a, b) | Kind::SameObject(_, a, b) | Kind::Update(a, _, b, _) => {
                self.expr(a);
                self.expr(b);
            }
            Kind::Element(of, list) | Kind::Initialise(of, _, list) | Kind::Deconstruct(of, _, list) => {
                self.expr(of);
                list.iter().for_each(|e| self.expr(e));
            }
            Kind::NewArray(_, list)
            | Kind::ArrayOf(_, list, _)
            | Kind::Concat(list)
            | Kind::Tuple(list)
            | Kind::Dynamic(_, list) => list.iter().for_each(|e| self.expr(e)),
            Kind::Length(of)
            | Kind::IsNull(_, of)
            | Kind::Negate(_, _, of)
            | Kind::Complement(_, of)
            | Kind::Convert(_, of)
            | Kind::Text(of)
            | Kind::Is(of, _)
            | Kind::As(of, _) => self.expr(of),
            Kind::Const(_)
            | Kind::Default(_)
            | Kind::This
            | Kind::Held(_)
            | Kind::Field(None, _)
            | Kind::TypeOf(_)
            | Kind::Error => {}
        }
    }
}

/// The variable that a statement declares without a value: its first value has no place in the source.
fn declared(stmt: &Stmt, e: &Expr) -> Option<LocalId> {
    match &e.kind {
        Kind::Assign(place, value) if stmt.pos == 0 && matches!(value.kind, Kind::Default(_)) => {
            if let Kind::Local(id) = place.kind {
                Some(id)
            } else {
                None
            }
        }
        _ => None,
    }
}
