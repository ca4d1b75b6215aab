//! `decimal`, and what `Math` has for it.

use super::format::{formatted, plain};
use super::number::number_of;
use super::{Cx, Native};
use crate::decimal::{self, Decimal, Rounding, Unread};
use crate::sema::Prim;
use crate::vm::heap::Obj;
use crate::vm::value::Value;
use crate::vm::{Raise, decimal_overflow};

impl Cx<'_> {
    /// A decimal; zero for anything else.
    fn decimal(&self, i: usize) -> Decimal {
        self.st.heap.decimal(self.arg(i)).unwrap_or_default()
    }

    fn give_decimal(&mut self, x: Decimal) -> Result<Value, Raise> {
        Ok(Value::Ref(self.st.heap.add(Obj::Decimal(x))))
    }
}

pub(super) fn find(key: &str) -> Option<Native> {
    Some(match key {
        "Decimal.new(Int32)"
        | "Decimal.new(UInt32)"
        | "Decimal.new(Int64)"
        | "Decimal.new(UInt64)"
        | "Decimal.new(Single)"
        | "Decimal.new(Double)" => |cx| cx.st.decimal_of(cx.arg(1)),
        "Decimal.new(Int32,Int32,Int32,Boolean,Byte)" => |cx| {
            let scale = u32::try_from(cx.int(5)).unwrap_or(u32::MAX);
            match decimal::of_words(cx.int(1), cx.int(2), cx.int(3), cx.truth(4), scale) {
                Some(x) => cx.give_decimal(x),
                None => Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "Decimal's scale value must be between 0 and 28, inclusive.\nParameter name: scale",
                )),
            }
        },
        "Decimal.ToString()" => |cx| {
            let shown = number_of(cx.arg(0), cx.st).map(plain).unwrap_or_default();
            Ok(cx.text(&shown))
        },
        "Decimal.ToString(String)" => |cx| {
            let Some(number) = number_of(cx.arg(0), cx.st) else { return Ok(Value::Null) };
            let shown = formatted(number, &cx.string(1))?;
            Ok(cx.text(&shown))
        },
        "Decimal.Equals(Object)" => |cx| {
            let other = cx.st.heap.decimal(cx.arg(1));
            Ok(Value::Bool(other == Some(cx.decimal(0))))
        },
        "Decimal.GetHashCode()" => |cx| Ok(Value::I32(decimal::hash(cx.decimal(0)))),
        "Decimal.GetBits(Decimal)" => |cx| {
            let words = decimal::words(cx.decimal(0)).map(Value::I32).to_vec();
            let int = cx.prim(Prim::I32);
            cx.array(int, words)
        },
        "Decimal.Read(String,Boolean)" => |cx| {
            if cx.arg(0) == Value::Null {
                return Err(Raise::new("ArgumentNullException", "Value cannot be null.\nParameter name: s"));
            }
            match decimal::read(&cx.string(0), cx.truth(1)) {
                Ok(x) => cx.give_decimal(x),
                Err(Unread::TooLarge) => Err(decimal_overflow(Prim::Decimal)),
                Err(Unread::Form) => {
                    Err(Raise::new("FormatException", "Input string was not in a correct format."))
                }
            }
        },
        "Decimal.TryRead(String,Boolean,Decimal)" => |cx| {
            let text = (cx.arg(0) != Value::Null).then(|| cx.string(0));
            let found = text.and_then(|text| decimal::read(&text, cx.truth(1)).ok());
            let value = cx.give_decimal(found.unwrap_or_default())?;
            cx.set(2, value);
            Ok(Value::Bool(found.is_some()))
        },
        "Decimal.Round(Decimal,Int32,Boolean)" => |cx| {
            let how = if cx.truth(2) { Rounding::Away } else { Rounding::Even };
            let Some(places) = u32::try_from(cx.int(1)).ok().filter(|p| *p <= 28) else {
                return Err(Raise::new(
                    "ArgumentOutOfRangeException",
                    "Decimal can only round to between 0 and 28 digits of precision.\nParameter name: decimals",
                ));
            };
            cx.give_decimal(decimal::rounded(cx.decimal(0), places, how))
        },
        "Decimal.Truncate(Decimal)" => |cx| whole(cx, Rounding::Truncate),
        "Decimal.Floor(Decimal)" => |cx| whole(cx, Rounding::Floor),
        "Decimal.Ceiling(Decimal)" => |cx| whole(cx, Rounding::Ceiling),
        _ => return None,
    })
}

fn whole(cx: &mut Cx<'_>, how: Rounding) -> Result<Value, Raise> {
    cx.give_decimal(decimal::rounded(cx.decimal(0), 0, how))
}
