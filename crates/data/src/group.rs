use crate::Value;

/// Several pieces of geometry that travel as one item.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// The members, in order; a member may be a group again.
    pub members: Vec<Option<Value>>,
}
