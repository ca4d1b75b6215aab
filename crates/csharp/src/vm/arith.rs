//! Arithmetic on numbers of any predefined type.

use super::state::Raise;
use super::value::Value;
use crate::bind::wrap;
use crate::bound::Op;
use crate::emit::number;
use crate::sema::Prim;

/// An unchecked operation on two `int`; none where it has no result.
#[inline]
pub(super) fn int(op: Op, x: i32, y: i32) -> Option<Value> {
    Some(match op {
        Op::Add => Value::I32(x.wrapping_add(y)),
        Op::Sub => Value::I32(x.wrapping_sub(y)),
        Op::Mul => Value::I32(x.wrapping_mul(y)),
        Op::Div => Value::I32(x.checked_div(y)?),
        Op::Rem => Value::I32(x.checked_rem(y)?),
        Op::Shl => Value::I32(x.wrapping_shl(y as u32)),
        Op::Shr => Value::I32(x.wrapping_shr(y as u32)),
        Op::And => Value::I32(x & y),
        Op::Or => Value::I32(x | y),
        Op::Xor => Value::I32(x ^ y),
        Op::Eq => Value::Bool(x == y),
        Op::Ne => Value::Bool(x != y),
        Op::Lt => Value::Bool(x < y),
        Op::Le => Value::Bool(x <= y),
        Op::Gt => Value::Bool(x > y),
        Op::Ge => Value::Bool(x >= y),
    })
}

/// An unchecked operation on two `long`; none where it has no result, and for shifts, which are by an `int`.
fn long(op: Op, x: i64, y: i64) -> Option<Value> {
    Some(match op {
        Op::Div => Value::I64(x.checked_div(y)?),
        Op::Rem => Value::I64(x.checked_rem(y)?),
        Op::And => Value::I64(x & y),
        Op::Or => Value::I64(x | y),
        Op::Xor => Value::I64(x ^ y),
        Op::Eq => Value::Bool(x == y),
        Op::Ne => Value::Bool(x != y),
        Op::Lt => Value::Bool(x < y),
        Op::Le => Value::Bool(x <= y),
        Op::Gt => Value::Bool(x > y),
        Op::Ge => Value::Bool(x >= y),
        _ => return None,
    })
}

fn divide_by_zero() -> Raise {
    Raise::new("DivideByZeroException", "Attempted to divide by zero.")
}

pub(crate) fn overflow() -> Raise {
    Raise::new("OverflowException", "Arithmetic operation resulted in an overflow.")
}

/// An operation on two values of one type.
pub(super) fn binary(op: Op, prim: Prim, checked: bool, a: Value, b: Value) -> Result<Value, Raise> {
    if let (Prim::I64, false, Value::I64(x), Value::I64(y)) = (prim, checked, a, b)
        && let Some(value) = long(op, x, y)
    {
        return Ok(value);
    }
    match prim {
        Prim::F64 => {
            let (Some(x), Some(y)) = (a.real(), b.real()) else { return Ok(Value::F64(0.0)) };
            Ok(real(op, x, y))
        }
        Prim::F32 => {
            let (Value::F32(x), Value::F32(y)) = (a, b) else { return Ok(Value::F32(0.0)) };
            Ok(match op {
                Op::Add => Value::F32(x + y),
                Op::Sub => Value::F32(x - y),
                Op::Mul => Value::F32(x * y),
                Op::Div => Value::F32(x / y),
                Op::Rem => Value::F32(x % y),
                _ => real(op, x.into(), y.into()),
            })
        }
        Prim::Bool => {
            let (Value::Bool(x), Value::Bool(y)) = (a, b) else { return Ok(Value::Bool(false)) };
            Ok(Value::Bool(match op {
                Op::And => x & y,
                Op::Or => x | y,
                Op::Eq => x == y,
                _ => x ^ y,
            }))
        }
        _ => {
            let (Some(x), Some(y)) = (a.whole(), b.whole()) else { return Ok(Value::Null) };
            // The bits of an enum over ulong are kept in a long.
            let (x, y) = (wrap(x, prim), if matches!(op, Op::Shl | Op::Shr) { y } else { wrap(y, prim) });
            whole(op, prim, checked, x, y)
        }
    }
}

fn real(op: Op, x: f64, y: f64) -> Value {
    match op {
        Op::Add => Value::F64(x + y),
        Op::Sub => Value::F64(x - y),
        Op::Mul => Value::F64(x * y),
        Op::Div => Value::F64(x / y),
        Op::Rem => Value::F64(x % y),
        Op::Eq => Value::Bool(x == y),
        Op::Ne => Value::Bool(x != y),
        Op::Lt => Value::Bool(x < y),
        Op::Le => Value::Bool(x <= y),
        Op::Gt => Value::Bool(x > y),
        Op::Ge => Value::Bool(x >= y),
        _ => Value::F64(0.0),
    }
}

fn whole(op: Op, prim: Prim, checked: bool, x: i128, y: i128) -> Result<Value, Raise> {
    let bits = if matches!(prim, Prim::I64 | Prim::U64) { 63 } else { 31 };
    let n = match op {
        Op::Add => x + y,
        Op::Sub => x - y,
        Op::Mul => x.wrapping_mul(y),
        Op::Div | Op::Rem if y == 0 => return Err(divide_by_zero()),
        // The least number by minus one does not fit, whether checked or not.
        Op::Div | Op::Rem if y == -1 && x == prim.range().0 => return Err(overflow()),
        Op::Div => x / y,
        Op::Rem => x % y,
        Op::Shl => return Ok(number(wrap(x << (y & bits), prim), prim)),
        Op::Shr => return Ok(number(x >> (y & bits), prim)),
        Op::And => x & y,
        Op::Or => x | y,
        Op::Xor => x ^ y,
        Op::Eq => return Ok(Value::Bool(x == y)),
        Op::Ne => return Ok(Value::Bool(x != y)),
        Op::Lt => return Ok(Value::Bool(x < y)),
        Op::Le => return Ok(Value::Bool(x <= y)),
        Op::Gt => return Ok(Value::Bool(x > y)),
        Op::Ge => return Ok(Value::Bool(x >= y)),
    };
    let wrapped = wrap(n, prim);
    if checked && wrapped != n {
        return Err(overflow());
    }
    Ok(number(wrapped, prim))
}

pub(super) fn negate(prim: Prim, checked: bool, a: Value) -> Result<Value, Raise> {
    Ok(match a {
        Value::F64(x) => Value::F64(-x),
        Value::F32(x) => Value::F32(-x),
        other => {
            let n = -other.whole().unwrap_or(0);
            if checked && wrap(n, prim) != n {
                return Err(overflow());
            }
            number(wrap(n, prim), prim)
        }
    })
}

/// A number as one of another type. Out of range and unchecked, a real number gives what x86 gives: the least value.
pub(crate) fn convert(from: Prim, to: Prim, checked: bool, a: Value) -> Result<Value, Raise> {
    if let Some(n) = a.whole() {
        return match to {
            Prim::F64 => Ok(Value::F64(n as f64)),
            Prim::F32 => Ok(Value::F32(n as f32)),
            _ => {
                let wrapped = wrap(wrap(n, from), to);
                if checked && wrapped != n {
                    return Err(overflow());
                }
                Ok(number(wrapped, to))
            }
        };
    }
    let Some(x) = a.real() else { return Ok(a) };
    match to {
        Prim::F64 => Ok(Value::F64(x)),
        Prim::F32 => Ok(Value::F32(x as f32)),
        _ => {
            let (least, most) = to.range();
            let whole = x.trunc();
            let fits = whole >= least as f64 && (whole <= most as f64 && whole < (most as f64 + 1.0));
            if fits && whole as i128 <= most {
                return Ok(number(whole as i128, to));
            }
            if checked {
                return Err(overflow());
            }
            // Small types go through a long or an int first.
            let long = if (i64::MIN as f64..i64::MAX as f64).contains(&whole) {
                i128::from(whole as i64)
            } else if to == Prim::U64 && whole > 0.0 && whole < u64::MAX as f64 {
                whole as i128
            } else {
                i128::from(i64::MIN)
            };
            let n = match to {
                Prim::I32 | Prim::I16 | Prim::I8 | Prim::U16 | Prim::U8 | Prim::Char
                    if !(-2_147_483_648.0..=2_147_483_647.0).contains(&whole) =>
                {
                    i128::from(i32::MIN)
                }
                _ => long,
            };
            Ok(number(wrap(n, to), to))
        }
    }
}
