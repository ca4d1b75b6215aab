//! Conditions as jumps.

use super::{Emitted, Emitter, Mark};
use crate::bound::{Const, Expr, Kind, Op as BinOp};
use crate::sema::Prim;
use crate::source::Pos;
use crate::vm::op::{Cmp, Low, Op};
use crate::vm::value::Value;

pub(super) fn comparison(op: BinOp) -> Option<Cmp> {
    Some(match op {
        BinOp::Eq => Cmp::EQ,
        BinOp::Ne => Cmp::NE,
        BinOp::Lt => Cmp::LT,
        BinOp::Le => Cmp::LE,
        BinOp::Gt => Cmp::GT,
        BinOp::Ge => Cmp::GE,
        _ => return None,
    })
}

impl Emitter<'_> {
    /// Jumps when a condition is what is said.
    pub(super) fn branch(&mut self, e: &Expr, to: Mark, when: bool) -> Emitted<()> {
        let kept = self.next;
        self.branch_on(e, to, when)?;
        self.next = kept;
        Ok(())
    }

    /// Jumps when two numbers stand in a relation.
    fn compare(&mut self, cmp: Cmp, prim: Prim, (a, b): (&Expr, &Expr), pos: Pos, to: Mark) -> Emitted<()> {
        if prim == Prim::I32
            && let Kind::Const(Const::Int(n)) = b.kind
        {
            let a = self.expr(a, None)?;
            if cmp == Cmp::LT
                && let Some(b) = self.hoisted(Value::I32(n as i32))
            {
                // The step of the loop and this are one operation.
                self.pos = pos;
                self.op(Op::JumpCmp { cmp, prim, a, b, to: to.0 });
                return Ok(());
            }
            if let (Ok(k), Ok(a)) = (i32::try_from(n), Low::try_from(a)) {
                self.pos = pos;
                self.op(Op::JumpIK { cmp, a, k, to: to.0 });
                return Ok(());
            }
            let b = self.expr(b, None)?;
            self.pos = pos;
            self.op(Op::JumpCmp { cmp, prim, a, b, to: to.0 });
            return Ok(());
        }
        let (a, b) = self.operands(a, b)?;
        self.pos = pos;
        self.op(Op::JumpCmp { cmp, prim, a, b, to: to.0 });
        Ok(())
    }

    fn branch_on(&mut self, e: &Expr, to: Mark, when: bool) -> Emitted<()> {
        match &e.kind {
            Kind::Const(Const::Bool(b)) => {
                if *b == when {
                    self.jump(to);
                }
                return Ok(());
            }
            Kind::Not(inner) => return self.branch(inner, to, !when),
            Kind::And(a, b) | Kind::Or(a, b) => {
                let is_and = matches!(e.kind, Kind::And(..));
                if is_and == when {
                    // Both, or neither: the first may already decide against it.
                    let past = self.mark();
                    self.branch(a, past, !when)?;
                    self.branch(b, to, when)?;
                    self.set(past);
                } else {
                    self.branch(a, to, when)?;
                    self.branch(b, to, when)?;
                }
                return Ok(());
            }
            Kind::Binary(op, prim @ (Prim::I32 | Prim::I64 | Prim::F64), _, a, b) => {
                if let Some(cmp) = comparison(*op) {
                    let cmp = if when { cmp } else { cmp.opposite() };
                    return self.compare(cmp, *prim, (a, b), e.pos, to);
                }
            }
            Kind::IsNull(is, inner) if *is == when => {
                let a = self.expr(inner, None)?;
                self.op(Op::JumpNull { a, to: to.0 });
                return Ok(());
            }
            _ => {}
        }
        let a = self.expr(e, None)?;
        self.op(if when { Op::JumpIf { a, to: to.0 } } else { Op::JumpNot { a, to: to.0 } });
        Ok(())
    }
}
