//! Operations in their fast form, where there is one.

use super::op::{Cmp, Low, Op, Reg};
use crate::bound::Op as BinOp;
use crate::sema::Prim;

fn low(reg: Reg) -> Option<Low> {
    Low::try_from(reg).ok()
}

impl Op {
    /// The same operation for low registers and the types that it is for; itself where there is no such form.
    pub fn narrow(self) -> Self {
        self.narrowed().unwrap_or(self)
    }

    fn narrowed(self) -> Option<Self> {
        Some(match self {
            Self::Move { d, a } => Self::MoveLow { d: low(d)?, a: low(a)? },
            Self::Arith { op, prim, checked, d, a, b } => {
                let (d, a, b) = (low(d)?, low(a)?, low(b)?);
                match (op, prim, checked) {
                    (BinOp::Add, Prim::I32, false) => Self::AddI { d, a, b },
                    (BinOp::Sub, Prim::I32, false) => Self::SubI { d, a, b },
                    (BinOp::Mul, Prim::I32, false) => Self::MulI { d, a, b },
                    (BinOp::Add, Prim::I64, false) => Self::AddL { d, a, b },
                    (BinOp::Sub, Prim::I64, false) => Self::SubL { d, a, b },
                    (BinOp::Mul, Prim::I64, false) => Self::MulL { d, a, b },
                    (BinOp::Add, Prim::F64, _) => Self::AddF { d, a, b },
                    (BinOp::Sub, Prim::F64, _) => Self::SubF { d, a, b },
                    (BinOp::Mul, Prim::F64, _) => Self::MulF { d, a, b },
                    (BinOp::Div, Prim::F64, _) => Self::DivF { d, a, b },
                    (op, Prim::I32, false) => Self::ArithI { op, d, a, b },
                    _ => return None,
                }
            }
            Self::Convert { from, to, checked, d, a } => {
                let (d, a) = (low(d)?, low(a)?);
                match (from, to, checked) {
                    (Prim::I32, Prim::F64, _) => Self::IntToReal { d, a },
                    (Prim::I32, Prim::I64, _) => Self::IntToLong { d, a },
                    (Prim::I64, Prim::I32, false) => Self::LongToInt { d, a },
                    _ => return None,
                }
            }
            Self::JumpCmp { cmp, prim, a, b, to } => {
                let (a, b) = (low(a)?, low(b)?);
                match prim {
                    Prim::I32 if cmp == Cmp::LT => Self::JumpLtI { a, b, to },
                    Prim::I32 => Self::JumpI { cmp, a, b, to },
                    Prim::I64 => Self::JumpL { cmp, a, b, to },
                    Prim::F64 => Self::JumpF { cmp, a, b, to },
                    _ => return None,
                }
            }
            Self::LoadField { d, o, i } => Self::LoadFieldLow { d: low(d)?, o: low(o)?, i: low(i)? },
            Self::StoreField { o, i, v } => Self::StoreFieldLow { o: low(o)?, i: low(i)?, v: low(v)? },
            Self::LoadElem { d, a, i } => Self::LoadElemLow { d: low(d)?, a: low(a)?, i: low(i)? },
            Self::StoreElem { a, i, v } => Self::StoreElemLow { a: low(a)?, i: low(i)?, v: low(v)? },
            _ => return None,
        })
    }

    /// The two in one, where there is such an operation.
    pub fn fused(self, next: Self) -> Option<Self> {
        match (self, next) {
            (Self::AddIK { d, a, k }, Self::JumpLtI { a: tested, b, to })
                if d == a && a == tested && b != a =>
            {
                Some(Self::StepLtI { a, k: i8::try_from(k).ok()?, b, to })
            }
            _ => None,
        }
    }

    /// Where it jumps to.
    pub fn target_mut(&mut self) -> Option<&mut u32> {
        match self {
            Self::Jump { to }
            | Self::JumpIf { to, .. }
            | Self::JumpNot { to, .. }
            | Self::JumpNull { to, .. }
            | Self::JumpCmp { to, .. }
            | Self::JumpI { to, .. }
            | Self::JumpLtI { to, .. }
            | Self::JumpIK { to, .. }
            | Self::JumpL { to, .. }
            | Self::JumpF { to, .. }
            | Self::StepLtI { to, .. } => Some(to),
            _ => None,
        }
    }
}
