//! What an exchange structure holds.

use std::collections::BTreeMap;

/// A value of an attribute.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    Integer(i64),
    Real(f64),
    Text(String),
    /// A word between points: `.T.`, `.MILLI.`.
    Word(String),
    Reference(u64),
    List(Vec<Value>),
    /// A value with its type: `LENGTH_MEASURE(1.)`.
    Typed(String, Box<Value>),
    /// `$`, `*` or a binary, of which nothing here is made.
    Nothing,
}

/// An entity: one record, or several where it is of several types at once.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Instance {
    pub(crate) records: Vec<(String, Vec<Value>)>,
}

/// The entities of a file, by name.
#[derive(Debug, Default)]
pub(crate) struct Structure {
    pub(crate) instances: BTreeMap<u64, Instance>,
}
