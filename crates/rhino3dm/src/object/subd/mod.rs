//! Class SubD (section 8): control nets whose parts name each other by numbers of the archive. Archives have the class
//! from version 60 on; before, a mesh stands for it.

mod additions;
mod kernel;
mod proxy;
mod read;
mod write;

pub(super) use proxy::{check_writable, mesh_of, stood_for};
pub(super) use read::read;
pub(super) use write::write;

use katydid_geometry::subd::{SubDEdgeTag, SubDVertexTag};
use uuid::Uuid;

use super::MappingTag;

const WHAT: &str = "SubD";

/// A subdivision surface as archives have it, its nets not checked. [`SubDObject::to_subd`] gives the kernel's,
/// `From<&SubD>` takes one.
///
/// Version 60 keeps the nets alone. Points of the limit surface that some archives keep beside vertices are not taken
/// over: they follow from the net, and openNURBS drops them too.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SubDObject {
    /// Its nets, the coarsest first; none at all in an empty object.
    pub levels: Vec<SubDLevel>,
    /// Where texture coordinates come from, as archives number it: 0 for unset.
    pub texture_coordinates: u8,
    /// Which mapping made the texture coordinates.
    pub mapping: MappingTag,
    /// Its symmetry as its chunk holds it, with the checksum; none where it has none.
    pub symmetry: Option<Vec<u8>>,
    /// A number that changes with the geometry.
    pub serial_number: u64,
    /// How its faces are packed into a texture.
    pub packing: SubDPacking,
}

/// How faces were packed into a texture, and what of.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SubDPacking {
    /// The first flag, which says that the surface is symmetric.
    pub symmetric: bool,
    /// The identifier of the packing; nil when there is none.
    pub id: Uuid,
    /// Whether the hash below is that of the net that was packed.
    pub hashed: bool,
    /// The hash of that net as its chunk holds it, with the checksum; none where it is empty.
    pub hash: Option<Vec<u8>>,
}

/// One control net.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SubDLevel {
    /// How often the net was subdivided.
    pub index: u16,
    /// Its vertices, in the order of their identifiers.
    pub vertices: Vec<StoredVertex>,
    /// Its edges, in the order of their identifiers.
    pub edges: Vec<StoredEdge>,
    /// Its faces, in the order of their identifiers.
    pub faces: Vec<StoredFace>,
}

/// What vertices, edges and faces have in common.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StoredPart {
    /// Its identifier.
    pub id: u32,
    /// The level it is on.
    pub level: u16,
    /// Where its subdivision point lies, if somebody kept it. Version 60 only.
    pub saved_point: Option<[f64; 3]>,
    /// By how much the subdivision point is moved.
    pub displacement: Option<[f64; 3]>,
    /// The group it belongs to; 0 for none. From version 70 on.
    pub group: u32,
    /// What it becomes under the symmetry. From version 70 on.
    pub symmetry_next: Option<Reference>,
}

/// Names a part of a net: the vertices, then the edges, then the faces are counted from 1. 0 names nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Reference {
    /// The number.
    pub number: u32,
    /// Flags; the lowest says that an edge is seen against its direction.
    pub flags: u8,
}

/// A vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StoredVertex {
    /// What all parts have.
    pub part: StoredPart,
    /// Its tag as archives number it: 0 unset, 1 smooth, 2 crease, 3 corner, 4 dart.
    pub tag: u8,
    /// Its control point.
    pub point: [f64; 3],
    /// The edges that end there.
    pub edges: Vec<Reference>,
    /// The faces that meet there.
    pub faces: Vec<Reference>,
}

/// An edge.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StoredEdge {
    /// What all parts have.
    pub part: StoredPart,
    /// Its tag as archives number it: 0 unset, 1 smooth, 2 crease, 4 smooth between creases.
    pub tag: u8,
    /// The sector coefficients at both ends.
    pub sector_coefficients: [f64; 2],
    /// The sharpness at both ends. Before version 80 archives keep the first only.
    pub sharpness: [f64; 2],
    /// The vertices at both ends.
    pub vertices: [Reference; 2],
    /// The faces it bounds.
    pub faces: Vec<Reference>,
}

/// A face. All but the common things and the edges from version 70 on only.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StoredFace {
    /// What all parts have.
    pub part: StoredPart,
    /// The identifier of the face of the coarsest net that it came from.
    pub level_zero_face: u32,
    /// Its edges in order.
    pub edges: Vec<Reference>,
    /// The part of the texture it was given.
    pub pack_rectangle: Option<PackRectangle>,
    /// The channel of materials it shows; 0 for that of the object.
    pub material_channel: i32,
    /// Its colour as red, green, blue, alpha.
    pub colour: Option<[u8; 4]>,
    /// Which faces are packed together; 0 for none.
    pub pack: u32,
    /// Texture coordinates at its corners, none or one an edge.
    pub texture_points: Vec<[f64; 3]>,
}

/// A rectangle of a texture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PackRectangle {
    /// The number of the kind of texture coordinates, which is no longer used.
    pub kind: u8,
    /// How many quarters the face is turned by.
    pub quarter_turns: u8,
    /// The corner u, v with the least values.
    pub origin: [f64; 2],
    /// Its size along u and v.
    pub size: [f64; 2],
}

/// The tags of vertices as archives number them, from 0.
const VERTEX_TAGS: [SubDVertexTag; 5] = [
    SubDVertexTag::Unset,
    SubDVertexTag::Smooth,
    SubDVertexTag::Crease,
    SubDVertexTag::Corner,
    SubDVertexTag::Dart,
];
/// The tags of edges with the numbers that archives give them.
const EDGE_TAGS: [(SubDEdgeTag, u8); 4] =
    [(SubDEdgeTag::Unset, 0), (SubDEdgeTag::Smooth, 1), (SubDEdgeTag::Crease, 2), (SubDEdgeTag::SmoothX, 4)];
