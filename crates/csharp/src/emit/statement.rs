//! Statements.

use std::sync::Arc;

use super::{Emitted, Emitter, Env, Guard};
use crate::bound::{Catch, Expr, Kind, Label, LocalId, Stmt, StmtKind};
use crate::vm::op::{Op, Reg};

impl Emitter<'_> {
    /// How many `try` stand around each label.
    pub(super) fn labels_of(&mut self, stmt: &Stmt, depth: usize) {
        match &stmt.kind {
            StmtKind::Block(_, list) | StmtKind::Several(list) => {
                list.iter().for_each(|s| self.labels_of(s, depth))
            }
            StmtKind::If(_, a, b) => {
                self.labels_of(a, depth);
                if let Some(b) = b {
                    self.labels_of(b, depth);
                }
            }
            StmtKind::Loop(_, body, _, brk, cont) | StmtKind::DoLoop(body, _, brk, cont) => {
                self.label_at(*brk, depth);
                self.label_at(*cont, depth);
                self.labels_of(body, depth);
            }
            StmtKind::Label(label) => self.label_at(*label, depth),
            StmtKind::Try(body, catches, finally) => {
                let inner = depth + 1 + usize::from(finally.is_some() && !catches.is_empty());
                self.labels_of(body, inner);
                let around = depth + usize::from(finally.is_some());
                for catch in catches {
                    self.labels_of(&catch.body, around);
                }
                if let Some(finally) = finally {
                    self.labels_of(finally, depth);
                }
            }
            _ => {}
        }
    }

    fn label_at(&mut self, label: Label, depth: usize) {
        let mark = self.mark();
        self.labels.insert(label, (mark, depth));
    }

    pub(super) fn stmt(&mut self, stmt: &Stmt) -> Emitted<()> {
        let kept = self.next;
        if stmt.pos > 0 {
            self.pos = stmt.pos;
        }
        match &stmt.kind {
            StmtKind::Block(locals, list) => {
                let envs = self.envs.len();
                self.enter(locals)?;
                for inner in list {
                    self.stmt(inner)?;
                }
                self.envs.truncate(envs);
            }
            StmtKind::Several(list) => {
                for inner in list {
                    self.stmt(inner)?;
                }
            }
            StmtKind::Expr(e) => self.effect(e)?,
            StmtKind::If(c, yes, no) => {
                let (other, end) = (self.mark(), self.mark());
                self.branch(c, other, false)?;
                self.stmt(yes)?;
                if let Some(no) = no {
                    self.jump(end);
                    self.set(other);
                    self.stmt(no)?;
                } else {
                    self.set(other);
                }
                self.set(end);
            }
            StmtKind::Loop(c, body, step, brk, cont) => {
                self.with_hoisted(|emitter| emitter.turns(c.as_ref(), body, step, (*brk, *cont)))?;
                self.place_label(*brk);
            }
            StmtKind::DoLoop(body, c, brk, cont) => {
                let top = self.mark();
                self.set(top);
                self.stmt(body)?;
                self.place_label(*cont);
                self.branch(c, top, true)?;
                self.place_label(*brk);
            }
            StmtKind::Label(label) => self.place_label(*label),
            StmtKind::Goto(label) => {
                if let Some((mark, depth)) = self.labels.get(label).copied() {
                    self.leave(depth)?;
                    self.jump(mark);
                } else {
                    return Err(super::Refused(
                        stmt.pos,
                        "No such label within the scope of the goto statement".to_owned(),
                    ));
                }
            }
            StmtKind::Return(value) => self.return_(value.as_ref())?,
            StmtKind::Throw(Some(e)) => {
                let a = self.expr(e, None)?;
                self.pos = stmt.pos;
                self.op(Op::Throw { a });
            }
            StmtKind::Throw(None) => match self.caught.last().copied() {
                Some(a) => self.op(Op::Rethrow { a }),
                None => {
                    return Err(super::Refused(
                        stmt.pos,
                        "A throw statement with no arguments is not allowed outside of a catch clause"
                            .to_owned(),
                    ));
                }
            },
            StmtKind::Try(body, catches, finally) => self.try_(body, catches, finally.as_deref())?,
            StmtKind::Yield(Some(e)) => {
                let a = self.copied(e, None)?;
                self.op(Op::Yield { a });
            }
            StmtKind::Yield(None) => {
                self.leave(0)?;
                self.op(Op::ReturnVoid);
            }
        }
        // Variables stay until their block ends; what is between statements is free again.
        if !matches!(stmt.kind, StmtKind::Several(_)) {
            self.next = kept;
        }
        Ok(())
    }

    /// The condition stands at the end, so that each turn has one jump.
    fn turns(
        &mut self,
        c: Option<&Expr>,
        body: &Stmt,
        step: &[Expr],
        (brk, cont): (Label, Label),
    ) -> Emitted<()> {
        let (top, test) = (self.mark(), self.mark());
        // A short one stands before the first turn too, so that it follows the step with no jump in between.
        let guard = self.labels.get(&brk).map(|(mark, _)| *mark).zip(c.filter(|c| is_short(c)));
        match guard {
            Some((end, c)) => {
                self.pos = c.pos;
                self.branch(c, end, false)?;
            }
            None => self.jump(test),
        }
        self.set(top);
        self.stmt(body)?;
        self.place_label(cont);
        for e in step {
            self.effect(e)?;
        }
        if guard.is_none() {
            self.set(test);
        }
        match c {
            Some(c) => {
                self.pos = c.pos;
                self.branch(c, top, true)
            }
            None => {
                self.jump(top);
                Ok(())
            }
        }
    }

    /// Registers for the variables of a block, and the object that it shares with lambdas.
    fn enter(&mut self, locals: &[LocalId]) -> Emitted<()> {
        let body = self.body.clone();
        let shared: Vec<_> = locals
            .iter()
            .copied()
            .filter(|l| body.locals.get(l.0 as usize).is_some_and(|l| l.captured))
            .collect();
        for local in locals {
            let has_one = self.reserved && self.regs.contains_key(local);
            if !self.fixed.contains(local) && !shared.contains(local) && !has_one && !self.split(*local)? {
                let reg = self.alloc()?;
                self.regs.insert(*local, reg);
                if self.stays(*local) {
                    let ty = body.locals.get(local.0 as usize).map_or(crate::sema::Ty::ERROR, |l| l.ty);
                    let ty = self.ty(ty);
                    self.default_into(reg, ty);
                }
            }
        }
        if shared.is_empty() {
            return Ok(());
        }
        let parent = self.innermost_env()?;
        let d = self.alloc()?;
        self.op(Op::NewEnv { d, n: shared.len() as u16, parent });
        for (i, local) in shared.iter().enumerate() {
            // Parameters come in registers.
            if self.fixed.contains(local)
                && let Some(reg) = self.regs.get(local).copied()
            {
                self.op(Op::StoreField { o: d, i: i as Reg + 1, v: reg });
            }
        }
        self.envs.push(Env { locals: shared, has_this: false, reg: Some(d) });
        Ok(())
    }

    fn place_label(&mut self, label: Label) {
        if let Some((mark, _)) = self.labels.get(&label).copied() {
            self.set(mark);
        }
    }

    fn return_(&mut self, value: Option<&crate::bound::Expr>) -> Emitted<()> {
        if let Some((d, end)) = self.goes_on {
            // The method stands in place of its call.
            if let Some(e) = value {
                self.copied(e, Some(d))?;
            }
            self.jump(end);
            return Ok(());
        }
        let Some(e) = value else {
            self.leave(0)?;
            self.op(Op::ReturnVoid);
            return Ok(());
        };
        let pos = self.pos;
        if self.guards.is_empty() {
            let a = self.copied(e, None)?;
            self.op(Op::Return { a });
            return Ok(());
        }
        let a = self.alloc()?;
        self.copied(e, Some(a))?;
        self.leave(0)?;
        self.pos = pos;
        self.op(Op::Return { a });
        Ok(())
    }

    /// Runs the `finally` of every `try` that is left, down to a depth.
    fn leave(&mut self, depth: usize) -> Emitted<()> {
        let all = self.guards.clone();
        let from = self.here();
        let mut level = all.len();
        while level > depth {
            level -= 1;
            if let Some(finally) = all[level].finally.clone() {
                let start = self.here();
                let outer = self.guards.split_off(level);
                self.labels_of(&finally, level);
                self.stmt(&finally)?;
                self.guards.extend(outer);
                let end = self.here();
                for guard in self.guards.iter_mut().skip(level) {
                    guard.gaps.push((start, end));
                }
            }
        }
        let _ = from;
        Ok(())
    }

    fn try_(&mut self, body: &Stmt, catches: &[Catch], finally: Option<&Stmt>) -> Emitted<()> {
        let Some(finally) = finally else { return self.try_catch(body, catches) };
        let shared = Arc::new(finally.clone());
        self.guards.push(Guard { finally: Some(shared), gaps: Vec::new() });
        let from = self.here();
        if catches.is_empty() {
            self.stmt(body)?
        } else {
            self.try_catch(body, catches)?
        }
        let to = self.here();
        let guard = self.guards.pop();
        let gaps = guard.map(|g| g.gaps).unwrap_or_default();
        let (failed, end) = (self.mark(), self.mark());
        let depth = self.guards.len();
        self.labels_of(finally, depth);
        self.stmt(finally)?;
        self.jump(end);
        let reg = self.alloc()?;
        self.handler(from, to, &gaps, failed, reg, true);
        self.set(failed);
        self.labels_of(finally, depth);
        self.stmt(finally)?;
        self.op(Op::Rethrow { a: reg });
        self.set(end);
        Ok(())
    }

    fn try_catch(&mut self, body: &Stmt, catches: &[Catch]) -> Emitted<()> {
        self.guards.push(Guard { finally: None, gaps: Vec::new() });
        let from = self.here();
        self.stmt(body)?;
        let to = self.here();
        let gaps = self.guards.pop().map(|g| g.gaps).unwrap_or_default();
        let (caught, end) = (self.mark(), self.mark());
        self.jump(end);
        let reg = self.alloc()?;
        self.handler(from, to, &gaps, caught, reg, false);
        self.set(caught);
        for catch in catches {
            let next = self.mark();
            let ty = self.ty(catch.ty);
            let d = self.alloc()?;
            self.pos = catch.body.pos;
            self.op(Op::Is { d, a: reg, ty });
            self.op(Op::JumpNot { a: d, to: next.0 });
            self.catch(catch, reg, next)?;
            self.jump(end);
            self.set(next);
        }
        self.op(Op::Rethrow { a: reg });
        self.set(end);
        Ok(())
    }

    fn catch(&mut self, catch: &Catch, reg: Reg, next: super::Mark) -> Emitted<()> {
        let StmtKind::Block(locals, list) = &catch.body.kind else { return Ok(()) };
        let envs = self.envs.len();
        self.enter(locals)?;
        if let Some(local) = catch.local {
            if let Some((env, index)) = self.captured(local)? {
                self.op(Op::StoreField { o: env, i: index, v: reg });
            } else if let Some(d) = self.regs.get(&local).copied() {
                self.op(Op::Move { d, a: reg });
            }
        }
        if let Some(filter) = &catch.filter {
            self.branch(filter, next, false)?;
        }
        self.caught.push(reg);
        for stmt in list {
            self.stmt(stmt)?;
        }
        self.caught.pop();
        self.envs.truncate(envs);
        Ok(())
    }
}

/// Whether a condition is worth standing twice: a comparison of variables, constants and lengths.
fn is_short(c: &Expr) -> bool {
    fn is_leaf(e: &Expr) -> bool {
        match &e.kind {
            Kind::Local(_) | Kind::Const(_) | Kind::This => true,
            Kind::Length(a) | Kind::Convert(_, a) | Kind::Field(Some(a), _) => is_leaf(a),
            _ => false,
        }
    }
    matches!(&c.kind, Kind::Binary(_, _, _, a, b) if is_leaf(a) && is_leaf(b))
}
