//! Items by name with the type that is wanted. Numbers of another width are widened; anything else of the wrong
//! type reads as absent, as in Grasshopper.

use uuid::Uuid;

use super::{Chunk, Colour, Decimal, ItemValue, Version};

impl ItemValue {
    /// The text of a string.
    pub fn as_str(&self) -> Option<&str> {
        if let Self::String(text) = self { Some(text) } else { None }
    }

    /// A boolean.
    pub fn as_bool(&self) -> Option<bool> {
        if let Self::Bool(value) = self { Some(*value) } else { None }
    }

    /// A whole number that fits 32 bits.
    pub fn as_i32(&self) -> Option<i32> {
        match self {
            Self::Int32(value) => Some(*value),
            Self::Byte(value) => Some(i32::from(*value)),
            Self::Int64(value) => i32::try_from(*value).ok(),
            _ => None,
        }
    }

    /// A whole number.
    pub fn as_i64(&self) -> Option<i64> {
        match self {
            Self::Int64(value) => Some(*value),
            other => other.as_i32().map(i64::from),
        }
    }

    /// A number of any kind.
    pub fn as_f64(&self) -> Option<f64> {
        match self {
            Self::Double(value) => Some(*value),
            Self::Single(value) => Some(f64::from(*value)),
            Self::Decimal(value) => Some(value.to_f64()),
            other => other.as_i32().map(f64::from),
        }
    }

    /// A GUID.
    pub fn as_guid(&self) -> Option<Uuid> {
        if let Self::Guid(value) = self { Some(*value) } else { None }
    }

    /// The bytes of a byte array or a bitmap.
    pub fn as_bytes(&self) -> Option<&[u8]> {
        match self {
            Self::ByteArray(bytes) | Self::Bitmap(bytes) => Some(bytes),
            _ => None,
        }
    }
}

macro_rules! getters {
    ($($(#[$doc:meta])* $name:ident, $at:ident -> $type:ty = $by:expr;)*) => {
        impl Chunk {
            $(
                $(#[$doc])*
                pub fn $name(&self, name: &str) -> Option<$type> {
                    self.item(name).and_then($by)
                }

                /// The same for the item of this name and index.
                pub fn $at(&self, name: &str, index: i32) -> Option<$type> {
                    self.item_at(name, index).and_then($by)
                }
            )*
        }
    };
}

getters! {
    /// The text of a string item without index.
    str, str_at -> &str = ItemValue::as_str;
    /// A boolean item without index.
    bool, bool_at -> bool = ItemValue::as_bool;
    /// A whole number without index.
    i32, i32_at -> i32 = ItemValue::as_i32;
    /// A whole number of 64 bits without index.
    i64, i64_at -> i64 = ItemValue::as_i64;
    /// A number of any kind without index.
    f64, f64_at -> f64 = ItemValue::as_f64;
    /// A GUID without index.
    guid, guid_at -> Uuid = ItemValue::as_guid;
    /// The bytes of a byte array or bitmap without index.
    bytes, bytes_at -> &[u8] = ItemValue::as_bytes;
    /// A colour without index.
    colour, colour_at -> Colour = |v| if let ItemValue::Colour(c) = v { Some(*c) } else { None };
    /// A decimal number without index.
    decimal, decimal_at -> Decimal = |v| if let ItemValue::Decimal(d) = v { Some(*d) } else { None };
    /// A version without index.
    version, version_at -> Version = |v| if let ItemValue::Version(x) = v { Some(*x) } else { None };
    /// A moment without index, in steps of 100 ns since the start of year 1.
    date, date_at -> i64 = |v| if let ItemValue::Date(ticks) = v { Some(*ticks) } else { None };
    /// A point of the canvas without index, of whole or broken pixels.
    canvas_point, canvas_point_at -> [f32; 2] = |v| match v {
        ItemValue::PointF(p) => Some(*p),
        ItemValue::Point(p) => Some(p.map(|c| c as f32)),
        _ => None,
    };
    /// A rectangle of the canvas without index: x, y, width, height.
    canvas_rectangle, canvas_rectangle_at -> [f32; 4] = |v| match v {
        ItemValue::RectangleF(r) => Some(*r),
        ItemValue::Rectangle(r) => Some(r.map(|c| c as f32)),
        _ => None,
    };
    /// A point in the plane without index.
    point2d, point2d_at -> [f64; 2] = |v| if let ItemValue::Point2d(p) = v { Some(*p) } else { None };
    /// A point in space without index.
    point3d, point3d_at -> [f64; 3] = |v| if let ItemValue::Point3d(p) = v { Some(*p) } else { None };
    /// A range without index: start, end.
    interval, interval_at -> [f64; 2] = |v| if let ItemValue::Interval1d(i) = v { Some(*i) } else { None };
    /// A range in u and v without index: start and end in u, start and end in v.
    interval2d, interval2d_at -> [f64; 4] = |v| if let ItemValue::Interval2d(i) = v { Some(*i) } else { None };
    /// A plane without index: origin, x axis, y axis.
    plane, plane_at -> [f64; 9] = |v| if let ItemValue::Plane(p) = v { Some(**p) } else { None };
    /// A line without index: start, end.
    line, line_at -> [f64; 6] = |v| if let ItemValue::Line(l) = v { Some(**l) } else { None };
}
