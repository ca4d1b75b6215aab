use super::SubDSide;
use crate::Point3;

/// How the surface behaves at a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum SubDVertexTag {
    /// Not known.
    Unset,
    /// Smooth all round.
    #[default]
    Smooth,
    /// On a crease that goes through.
    Crease,
    /// A corner: the surface passes through it, with a tangent plane for each sector.
    Corner,
    /// The end of a single crease.
    Dart,
}

/// A vertex of a control net.
#[derive(Debug, Clone, PartialEq)]
pub struct SubDVertex {
    /// A number that no other vertex of the net has.
    pub id: u32,
    /// How the surface behaves here.
    pub tag: SubDVertexTag,
    /// The control point.
    pub point: Point3,
    /// The edges that end here, sorted round it where the net is a surface; reversed where their second vertex is
    /// this one.
    pub edges: Vec<SubDSide>,
    /// Indices of the faces that meet here.
    pub faces: Vec<usize>,
}
