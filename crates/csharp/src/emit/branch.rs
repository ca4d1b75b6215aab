//! Conditions as jumps.

use super::{Emitted, Emitter, Mark};
use crate::bound::{Const, Expr, Kind, Op as BinOp};
use crate::sema::Prim;
use crate::vm::op::{Cmp, Op};

pub(super) fn comparison(op: BinOp) -> Option<Cmp> {
    Some(match op {
        BinOp::Eq => Cmp::Eq,
        BinOp::Ne => Cmp::Ne,
        BinOp::Lt => Cmp::Lt,
        BinOp::Le => Cmp::Le,
        BinOp::Gt => Cmp::Gt,
        BinOp::Ge => Cmp::Ge,
        _ => return None,
    })
}

fn opposite(cmp: Cmp) -> Cmp {
    match cmp {
        Cmp::Eq => Cmp::Ne,
        Cmp::Ne => Cmp::Eq,
        Cmp::Lt => Cmp::Ge,
        Cmp::Le => Cmp::Gt,
        Cmp::Gt => Cmp::Le,
        Cmp::Ge => Cmp::Lt,
    }
}

impl Emitter<'_> {
    /// Jumps when a condition is what is said.
    pub(super) fn branch(&mut self, e: &Expr, to: Mark, when: bool) -> Emitted<()> {
        let kept = self.next;
        self.branch_on(e, to, when)?;
        self.next = kept;
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
            Kind::Binary(op, prim @ (Prim::I32 | Prim::F64), _, a, b) => {
                // `!(a < b)` is not `a >= b` where one is not a number.
                if let Some(cmp) = comparison(*op).filter(|_| when || *prim == Prim::I32) {
                    let (a, b) = self.operands(a, b)?;
                    let cmp = if when { cmp } else { opposite(cmp) };
                    self.pos = e.pos;
                    self.op(if *prim == Prim::I32 {
                        Op::JumpI { cmp, a, b, to: to.0 }
                    } else {
                        Op::JumpF { cmp, a, b, to: to.0 }
                    });
                    return Ok(());
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
