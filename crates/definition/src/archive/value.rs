use uuid::Uuid;

use super::Decimal;

/// A colour with opacity, each part 0 to 255.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Colour {
    /// Opacity: 0 is clear, 255 solid.
    pub a: u8,
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
}

impl Colour {
    /// The colour with the given opacity, red, green and blue.
    pub const fn new(a: u8, r: u8, g: u8, b: u8) -> Self {
        Self { a, r, g, b }
    }
}

/// A version of three numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Version {
    /// The first number.
    pub major: i32,
    /// The second.
    pub minor: i32,
    /// The third.
    pub revision: i32,
}

impl std::fmt::Display for Version {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}.{}.{}", self.major, self.minor, self.revision)
    }
}

/// What an item holds: one variant a type code of the format.
///
/// Equality is that of the stored bits: a NaN equals the same NaN, and 0 does not equal −0.
/// [`DoubleArray`](Self::DoubleArray), [`SizeF`](Self::SizeF), [`Point4d`](Self::Point4d) and
/// [`BoundingBox`](Self::BoundingBox) occur in no known file: their layout is inferred from their kin.
#[derive(Debug, Clone)]
pub enum ItemValue {
    /// Type 1.
    Bool(bool),
    /// Type 2.
    Byte(u8),
    /// Type 3.
    Int32(i32),
    /// Type 4.
    Int64(i64),
    /// Type 5.
    Single(f32),
    /// Type 6.
    Double(f64),
    /// Type 7: a .NET decimal number.
    Decimal(Decimal),
    /// Type 8: a moment, in steps of 100 ns since the start of year 1.
    Date(i64),
    /// Type 9.
    Guid(Uuid),
    /// Type 10.
    String(String),
    /// Type 20.
    ByteArray(Vec<u8>),
    /// Type 21.
    DoubleArray(Vec<f64>),
    /// Type 30: x, y in pixels.
    Point([i32; 2]),
    /// Type 31: x, y.
    PointF([f32; 2]),
    /// Type 32: width, height.
    Size([i32; 2]),
    /// Type 33: width, height.
    SizeF([f32; 2]),
    /// Type 34: x, y, width, height.
    Rectangle([i32; 4]),
    /// Type 35: x, y, width, height.
    RectangleF([f32; 4]),
    /// Type 36.
    Colour(Colour),
    /// Type 37: a picture file, PNG as a rule.
    Bitmap(Vec<u8>),
    /// Type 50: x, y.
    Point2d([f64; 2]),
    /// Type 51: x, y, z.
    Point3d([f64; 3]),
    /// Type 52: x, y, z, w.
    Point4d([f64; 4]),
    /// Type 60: start, end.
    Interval1d([f64; 2]),
    /// Type 61: start and end in u, start and end in v.
    Interval2d([f64; 4]),
    /// Type 70: start x, y, z and end x, y, z.
    Line(Box<[f64; 6]>),
    /// Type 71: smallest x, y, z and largest x, y, z.
    BoundingBox(Box<[f64; 6]>),
    /// Type 72: origin, x axis, y axis, three numbers each.
    Plane(Box<[f64; 9]>),
    /// Type 80.
    Version(Version),
}

/// The type codes with their names in XML.
pub(super) const TYPES: [(i32, &str); 29] = [
    (1, "gh_bool"),
    (2, "gh_byte"),
    (3, "gh_int32"),
    (4, "gh_int64"),
    (5, "gh_single"),
    (6, "gh_double"),
    (7, "gh_decimal"),
    (8, "gh_date"),
    (9, "gh_guid"),
    (10, "gh_string"),
    (20, "gh_bytearray"),
    (21, "gh_doublearray"),
    (30, "gh_drawing_point"),
    (31, "gh_drawing_pointf"),
    (32, "gh_drawing_size"),
    (33, "gh_drawing_sizef"),
    (34, "gh_drawing_rectangle"),
    (35, "gh_drawing_rectanglef"),
    (36, "gh_drawing_color"),
    (37, "gh_drawing_bitmap"),
    (50, "gh_point2d"),
    (51, "gh_point3d"),
    (52, "gh_point4d"),
    (60, "gh_interval1d"),
    (61, "gh_interval2d"),
    (70, "gh_line"),
    (71, "gh_boundingbox"),
    (72, "gh_plane"),
    (80, "gh_version"),
];

impl ItemValue {
    /// The type code in files.
    pub fn code(&self) -> i32 {
        match self {
            Self::Bool(_) => 1,
            Self::Byte(_) => 2,
            Self::Int32(_) => 3,
            Self::Int64(_) => 4,
            Self::Single(_) => 5,
            Self::Double(_) => 6,
            Self::Decimal(_) => 7,
            Self::Date(_) => 8,
            Self::Guid(_) => 9,
            Self::String(_) => 10,
            Self::ByteArray(_) => 20,
            Self::DoubleArray(_) => 21,
            Self::Point(_) => 30,
            Self::PointF(_) => 31,
            Self::Size(_) => 32,
            Self::SizeF(_) => 33,
            Self::Rectangle(_) => 34,
            Self::RectangleF(_) => 35,
            Self::Colour(_) => 36,
            Self::Bitmap(_) => 37,
            Self::Point2d(_) => 50,
            Self::Point3d(_) => 51,
            Self::Point4d(_) => 52,
            Self::Interval1d(_) => 60,
            Self::Interval2d(_) => 61,
            Self::Line(_) => 70,
            Self::BoundingBox(_) => 71,
            Self::Plane(_) => 72,
            Self::Version(_) => 80,
        }
    }

    /// The type's name in XML files, `gh_int32` say.
    pub fn type_name(&self) -> &'static str {
        let code = self.code();
        TYPES.iter().find(|(c, _)| *c == code).map_or("", |(_, name)| name)
    }
}

fn same32(a: &[f32], b: &[f32]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

fn same64(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

impl PartialEq for ItemValue {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Bool(a), Self::Bool(b)) => a == b,
            (Self::Byte(a), Self::Byte(b)) => a == b,
            (Self::Int32(a), Self::Int32(b)) => a == b,
            (Self::Int64(a), Self::Int64(b)) | (Self::Date(a), Self::Date(b)) => a == b,
            (Self::Single(a), Self::Single(b)) => same32(&[*a], &[*b]),
            (Self::Double(a), Self::Double(b)) => same64(&[*a], &[*b]),
            (Self::Decimal(a), Self::Decimal(b)) => a == b,
            (Self::Guid(a), Self::Guid(b)) => a == b,
            (Self::String(a), Self::String(b)) => a == b,
            (Self::ByteArray(a), Self::ByteArray(b)) | (Self::Bitmap(a), Self::Bitmap(b)) => a == b,
            (Self::DoubleArray(a), Self::DoubleArray(b)) => same64(a, b),
            (Self::Point(a), Self::Point(b)) | (Self::Size(a), Self::Size(b)) => a == b,
            (Self::PointF(a), Self::PointF(b)) | (Self::SizeF(a), Self::SizeF(b)) => same32(a, b),
            (Self::Rectangle(a), Self::Rectangle(b)) => a == b,
            (Self::RectangleF(a), Self::RectangleF(b)) => same32(a, b),
            (Self::Colour(a), Self::Colour(b)) => a == b,
            (Self::Point2d(a), Self::Point2d(b)) | (Self::Interval1d(a), Self::Interval1d(b)) => same64(a, b),
            (Self::Point3d(a), Self::Point3d(b)) => same64(a, b),
            (Self::Point4d(a), Self::Point4d(b)) | (Self::Interval2d(a), Self::Interval2d(b)) => same64(a, b),
            (Self::Line(a), Self::Line(b)) | (Self::BoundingBox(a), Self::BoundingBox(b)) => {
                same64(a.as_slice(), b.as_slice())
            }
            (Self::Plane(a), Self::Plane(b)) => same64(a.as_slice(), b.as_slice()),
            (Self::Version(a), Self::Version(b)) => a == b,
            _ => false,
        }
    }
}

macro_rules! from {
    ($($from:ty => $variant:ident),* $(,)?) => {
        $(impl From<$from> for ItemValue {
            fn from(value: $from) -> Self {
                Self::$variant(value.into())
            }
        })*
    };
}

from! {
    bool => Bool,
    i32 => Int32,
    i64 => Int64,
    f32 => Single,
    f64 => Double,
    Decimal => Decimal,
    Uuid => Guid,
    &str => String,
    String => String,
    Colour => Colour,
    Version => Version,
}
