//! Decimals in the heap.

use super::heap::Obj;
use super::state::{Raise, State};
use super::value::Value;
use crate::bound::Op;
use crate::decimal::{self, Answer, DOUBLE_DIGITS, FLOAT_DIGITS, Fault};
use crate::sema::Prim;

/// What .NET says of a number that has no place in a type.
pub(crate) fn overflow(to: Prim) -> Raise {
    let kind = match to {
        Prim::I8 => "a signed byte",
        Prim::U8 => "an unsigned byte",
        Prim::I16 => "an Int16",
        Prim::U16 => "a UInt16",
        Prim::Char => "a character",
        Prim::U32 => "a UInt32",
        Prim::I64 => "an Int64",
        Prim::U64 => "a UInt64",
        Prim::Decimal => "a Decimal",
        _ => "an Int32",
    };
    Raise::new("OverflowException", format!("Value was either too large or too small for {kind}."))
}

fn fault(fault: Fault) -> Raise {
    match fault {
        Fault::Overflow => overflow(Prim::Decimal),
        Fault::ByZero => Raise::new("DivideByZeroException", "Attempted to divide by zero."),
    }
}

impl State {
    /// An operation of two decimals.
    pub(super) fn decimals(&mut self, op: Op, a: Value, b: Value) -> Result<Value, Raise> {
        let (a, b) = (self.heap.decimal(a).unwrap_or_default(), self.heap.decimal(b).unwrap_or_default());
        Ok(match decimal::binary(op, a, b).map_err(fault)? {
            Answer::Truth(is) => Value::Bool(is),
            Answer::Number(x) => Value::Ref(self.heap.add(Obj::Decimal(x))),
        })
    }

    /// The decimal of a number of any other type.
    pub(crate) fn decimal_of(&mut self, value: Value) -> Result<Value, Raise> {
        let made = match value {
            Value::F64(x) => decimal::of_real(x, DOUBLE_DIGITS).map_err(fault)?,
            Value::F32(x) => decimal::of_real(x.into(), FLOAT_DIGITS).map_err(fault)?,
            Value::Ref(_) => return Ok(value),
            other => decimal::of_whole(other.whole().unwrap_or(0)),
        };
        Ok(Value::Ref(self.heap.add(Obj::Decimal(made))))
    }

    /// The number of a decimal in another type; whole numbers lose what is behind the point.
    pub(crate) fn decimal_to(&self, value: Value, to: Prim) -> Result<Value, Raise> {
        let x = self.heap.decimal(value).unwrap_or_default();
        Ok(match to {
            Prim::F64 => Value::F64(decimal::to_real(x)),
            Prim::F32 => Value::F32(decimal::to_real(x) as f32),
            _ => crate::emit::number(decimal::to_whole(x, to).ok_or_else(|| overflow(to))?, to),
        })
    }
}
