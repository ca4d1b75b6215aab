//! Values: numbers as they are, everything else as a reference into the heap.

use crate::sema::Ty;

/// An object of the heap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Handle(pub u32);

/// A value.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Value {
    Null,
    Bool(bool),
    Char(u16),
    I8(i8),
    U8(u8),
    I16(i16),
    U16(u16),
    I32(i32),
    U32(u32),
    I64(i64),
    U64(u64),
    F32(f32),
    F64(f64),
    /// A member of an enum.
    Enum(Ty, i64),
    /// An object.
    Ref(Handle),
    /// A variable on the stack.
    StackRef(u32),
    /// A field of an object, or an element of an array.
    PartRef(Handle, u32),
    /// A static field.
    StaticRef(u32),
}

impl Value {
    /// A whole number of any size.
    pub fn whole(self) -> Option<i128> {
        Some(match self {
            Self::Char(x) | Self::U16(x) => x.into(),
            Self::I8(x) => x.into(),
            Self::U8(x) => x.into(),
            Self::I16(x) => x.into(),
            Self::I32(x) => x.into(),
            Self::U32(x) => x.into(),
            Self::I64(x) => x.into(),
            Self::U64(x) => x.into(),
            Self::Enum(_, x) => x.into(),
            _ => return None,
        })
    }

    /// A number.
    pub fn real(self) -> Option<f64> {
        match self {
            Self::F64(x) => Some(x),
            Self::F32(x) => Some(x.into()),
            other => other.whole().map(|n| n as f64),
        }
    }
}
