//! Values worked out before anything runs (C# specification, constant expressions).

use super::Binder;
use crate::bound::{Const, Expr, Kind, Op};
use crate::decimal::{self, Answer, DOUBLE_DIGITS, FLOAT_DIGITS};
use crate::sema::Prim;
use crate::source::Pos;

/// A whole number wrapped into the range of a type.
pub(crate) fn wrap(n: i128, prim: Prim) -> i128 {
    match prim {
        Prim::I8 => i128::from(n as i8),
        Prim::U8 => i128::from(n as u8),
        Prim::I16 => i128::from(n as i16),
        Prim::U16 | Prim::Char => i128::from(n as u16),
        Prim::I32 => i128::from(n as i32),
        Prim::U32 => i128::from(n as u32),
        Prim::I64 => i128::from(n as i64),
        Prim::U64 => i128::from(n as u64),
        _ => n,
    }
}

impl Binder<'_> {
    /// A constant number as one of another type; none when it has to be done when it runs.
    pub(super) fn fold_number(&mut self, value: &Expr, to: Prim, _checked: bool) -> Option<Const> {
        let Kind::Const(constant) = &value.kind else { return None };
        let real = match constant {
            Const::Int(n) => {
                return match to {
                    Prim::F64 => Some(Const::Double(*n as f64)),
                    Prim::F32 => Some(Const::Float(*n as f32)),
                    Prim::Decimal => Some(Const::Decimal(decimal::of_whole(*n))),
                    Prim::Bool => None,
                    _ => Some(Const::Int(wrap(*n, to))),
                };
            }
            Const::Double(x) => *x,
            Const::Float(x) => f64::from(*x),
            Const::Decimal(x) => {
                return match to {
                    Prim::F64 => Some(Const::Double(decimal::to_real(*x))),
                    Prim::F32 => Some(Const::Float(decimal::to_real(*x) as f32)),
                    Prim::Decimal => Some(Const::Decimal(*x)),
                    Prim::Bool => None,
                    _ => decimal::to_whole(*x, to).map(Const::Int),
                };
            }
            _ => return None,
        };
        match to {
            Prim::F64 => Some(Const::Double(real)),
            Prim::F32 => Some(Const::Float(real as f32)),
            Prim::Decimal => {
                let digits = if matches!(constant, Const::Float(_)) { FLOAT_DIGITS } else { DOUBLE_DIGITS };
                decimal::of_real(real, digits).ok().map(Const::Decimal)
            }
            Prim::Bool => None,
            _ => {
                let (least, most) = to.range();
                let whole = real.trunc();
                (whole >= least as f64 && whole <= most as f64).then_some(Const::Int(whole as i128))
            }
        }
    }

    /// An operation on two constants.
    pub(super) fn fold(&mut self, pos: Pos, op: Op, prim: Prim, a: &Expr, b: &Expr) -> Option<Const> {
        let (Kind::Const(x), Kind::Const(y)) = (&a.kind, &b.kind) else { return None };
        match (x, y) {
            (Const::Int(x), Const::Int(y)) => self.fold_whole(pos, op, prim, *x, *y),
            (Const::Double(x), Const::Double(y)) => fold_real(op, *x, *y),
            (Const::Float(x), Const::Float(y)) => match op {
                Op::Add => Some(Const::Float(x + y)),
                Op::Sub => Some(Const::Float(x - y)),
                Op::Mul => Some(Const::Float(x * y)),
                Op::Div => Some(Const::Float(x / y)),
                _ => fold_real(op, f64::from(*x), f64::from(*y)).filter(|c| matches!(c, Const::Bool(_))),
            },
            (Const::Decimal(x), Const::Decimal(y)) => match decimal::binary(op, *x, *y) {
                Ok(Answer::Number(x)) => Some(Const::Decimal(x)),
                Ok(Answer::Truth(is)) => Some(Const::Bool(is)),
                Err(decimal::Fault::ByZero) => {
                    self.fault(pos, 20, "Division by constant zero");
                    None
                }
                Err(decimal::Fault::Overflow) => {
                    self.fault(pos, 220, "The operation overflows at compile time in checked mode");
                    None
                }
            },
            (Const::Bool(x), Const::Bool(y)) => Some(Const::Bool(match op {
                Op::And => x & y,
                Op::Or => x | y,
                Op::Xor | Op::Ne => x ^ y,
                Op::Eq => x == y,
                _ => return None,
            })),
            _ => None,
        }
    }

    fn fold_whole(&mut self, pos: Pos, op: Op, prim: Prim, x: i128, y: i128) -> Option<Const> {
        let bits = if matches!(prim, Prim::I64 | Prim::U64) { 63 } else { 31 };
        let n = match op {
            Op::Add => x + y,
            Op::Sub => x - y,
            Op::Mul => x.checked_mul(y)?,
            Op::Div | Op::Rem if y == 0 => {
                self.fault(pos, 20, "Division by constant zero");
                return None;
            }
            Op::Div => x / y,
            Op::Rem => x % y,
            Op::Shl => return Some(Const::Int(wrap(x << (y & bits), prim))),
            Op::Shr => return Some(Const::Int(x >> (y & bits))),
            Op::And => x & y,
            Op::Or => x | y,
            Op::Xor => x ^ y,
            Op::Eq => return Some(Const::Bool(x == y)),
            Op::Ne => return Some(Const::Bool(x != y)),
            Op::Lt => return Some(Const::Bool(x < y)),
            Op::Le => return Some(Const::Bool(x <= y)),
            Op::Gt => return Some(Const::Bool(x > y)),
            Op::Ge => return Some(Const::Bool(x >= y)),
        };
        if wrap(n, prim) != n && !self.unchecked {
            self.fault(pos, 220, "The operation overflows at compile time in checked mode");
            return None;
        }
        Some(Const::Int(wrap(n, prim)))
    }
}

fn fold_real(op: Op, x: f64, y: f64) -> Option<Const> {
    Some(match op {
        Op::Add => Const::Double(x + y),
        Op::Sub => Const::Double(x - y),
        Op::Mul => Const::Double(x * y),
        Op::Div => Const::Double(x / y),
        Op::Rem => Const::Double(x % y),
        Op::Eq => Const::Bool(x == y),
        Op::Ne => Const::Bool(x != y),
        Op::Lt => Const::Bool(x < y),
        Op::Le => Const::Bool(x <= y),
        Op::Gt => Const::Bool(x > y),
        Op::Ge => Const::Bool(x >= y),
        _ => return None,
    })
}
