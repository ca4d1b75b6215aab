use serde::{Deserialize, Serialize};
use uuid::Uuid;

/// The first four bytes of a preview: `KTPV`, read as a little-endian number.
pub const PREVIEW_MAGIC: u32 = u32::from_le_bytes(*b"KTPV");
/// The version of the layout.
pub const PREVIEW_VERSION: u16 = 2;

/// The head of the geometry of one object, for a viewport.
///
/// A preview is: the magic number (`u32`), the version (`u16`), flags (`u16`, 0), the length of the head (`u32`), the
/// head in JSON, blanks up to a multiple of 8, and the arrays that the head names, each at a multiple of 8 from the
/// start of the first; all little-endian. Positions are single-precision offsets from `origin`, which is in double
/// precision: what lies far from the model's origin keeps its shape. What a part has nothing of is left out of the head:
/// of hundreds of small objects heads are the larger part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct PreviewHeader {
    /// The object.
    pub object: Uuid,
    /// What positions are measured from, in model units.
    pub origin: [f64; 3],
    /// The least and the greatest coordinates, in model units.
    pub bounds: Option<[[f64; 3]; 2]>,
    /// Whether a finer preview of the same can be had.
    pub draft: bool,
    /// What there is to draw.
    pub parts: Vec<Part>,
}

/// Things of one kind and one look, drawn in one go.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Part {
    /// What they are.
    pub kind: PartKind,
    /// Their own colour (red, green, blue, alpha), where they have one; else that of the document.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub colour: Option<[u8; 4]>,
    /// The width of lines, or the size of points, in pixels; 0 for the usual.
    pub width: f32,
    /// The array of positions: three numbers each.
    pub positions: Slice,
    /// The array of unit normals: three numbers each, of meshes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub normals: Option<Slice>,
    /// The array of colours: red, green, blue, alpha of each position.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub colours: Option<Slice>,
    /// The array of the Gaussian curvature at each position, of surfaces, in 1/units². Its least and greatest values
    /// are in `range`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub values: Option<Slice>,
    /// The least and the greatest of `values`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub range: Option<[f64; 2]>,
    /// The array of the mean curvature at each position, of surfaces, in 1/units. Its least and greatest values are in
    /// `mean_range`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub mean: Option<Slice>,
    /// The least and the greatest of `mean`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub mean_range: Option<[f64; 2]>,
    /// The array of indices: three a triangle, two a line segment; none when positions follow each other.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub indices: Option<Slice>,
    /// The texts, one a position.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "typescript", ts(optional, as = "Option<Vec<String>>"))]
    pub texts: Vec<String>,
    /// The height of texts in model units; 0 for the usual in pixels.
    pub text_height: f64,
    /// Which item of the data each stretch of the drawing is.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "typescript", ts(optional, as = "Option<Vec<Piece>>"))]
    pub pieces: Vec<Piece>,
}

/// What a part draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum PartKind {
    /// Triangles, shaded.
    Mesh,
    /// Edges of surfaces and meshes: segments, two positions or indices each.
    Edges,
    /// Isocurves of surfaces: segments.
    Isocurves,
    /// Curves: segments.
    Curves,
    /// Vectors with a head at their second end: segments.
    Arrows,
    /// Points, each a cross.
    Points,
    /// Control points, each a square.
    ControlPoints,
    /// The polygons and nets between control points: segments.
    Hull,
    /// Curvature combs, teeth and the line over their tips: segments.
    Comb,
    /// Osculating circles: segments.
    Circles,
    /// Squares of planes: segments.
    Planes,
    /// Texts.
    Texts,
}

/// A stretch of a part that is one item, or several in a row that take as much each.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Piece {
    /// The index of the object's output.
    pub output: u32,
    /// The path of the item's branch.
    pub path: String,
    /// The index of the (first) item in it.
    pub index: u32,
    /// The first index (or position, where there are no indices) that belongs to it.
    pub start: u32,
    /// How many do, of each item.
    pub count: u32,
    /// How many items; 1 where nothing is said.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    #[cfg_attr(feature = "typescript", ts(optional, as = "Option<u32>"))]
    pub items: u32,
}

fn one() -> u32 {
    1
}

fn is_one(items: &u32) -> bool {
    *items == 1
}

/// Where an array lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Slice {
    /// What it holds.
    #[serde(rename = "type")]
    pub kind: SliceType,
    /// Bytes from the start of the first array.
    pub offset: u32,
    /// How many numbers it has.
    pub count: u32,
}

/// What an array holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum SliceType {
    /// Single-precision numbers.
    F32,
    /// Whole numbers of 8 bits, −127 to 127 for −1 to 1.
    I8,
    /// Whole numbers of 8 bits, 0 to 255.
    U8,
    /// Whole numbers of 16 bits.
    U16,
    /// Whole numbers of 32 bits.
    U32,
}
