use super::SubDSide;

/// A face of a control net.
#[derive(Debug, Clone, PartialEq)]
pub struct SubDFace {
    /// A number that no other face of the net has.
    pub id: u32,
    /// Its edges in order, each beginning where the one before ends; reversed where it runs through an edge from the
    /// second vertex to the first.
    pub edges: Vec<SubDSide>,
}
