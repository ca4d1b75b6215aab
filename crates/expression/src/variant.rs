use std::fmt;
use std::sync::Arc;

use katydid_geometry::{Plane, Point3};

use crate::format::{Dialect, number_text};

/// A value of the expression language.
///
/// Points and vectors are one type here, as in the original: the language does not tell them apart.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Variant {
    /// No value. It passes through every operator.
    #[default]
    Null,
    /// True or false.
    Boolean(bool),
    /// A whole number of 32 bits; results that do not fit become [`Variant::Number`].
    Integer(i32),
    /// A real number.
    Number(f64),
    /// A text.
    Text(Arc<str>),
    /// A point or a vector.
    Point(Point3),
    /// A plane.
    Plane(Plane),
    /// A complex number.
    Complex {
        /// Real part.
        re: f64,
        /// Imaginary part.
        im: f64,
    },
}

impl Variant {
    /// A text value.
    pub fn text(text: impl AsRef<str>) -> Self {
        Self::Text(Arc::from(text.as_ref()))
    }

    /// A point value.
    pub fn point(x: f64, y: f64, z: f64) -> Self {
        Self::Point(Point3::new(x, y, z))
    }

    /// The type's name as a user knows it.
    pub fn type_name(&self) -> &'static str {
        match self {
            Self::Null => "Null",
            Self::Boolean(_) => "Boolean",
            Self::Integer(_) => "Integer",
            Self::Number(_) => "Number",
            Self::Text(_) => "Text",
            Self::Point(_) => "Point",
            Self::Plane(_) => "Plane",
            Self::Complex { .. } => "Complex",
        }
    }

    /// Whether there is no value.
    pub fn is_null(&self) -> bool {
        matches!(self, Self::Null)
    }

    /// The value as text with numbers in full precision, as `&`, `CStr` and `{0}` write it.
    ///
    /// Points read `{1, 2, 3}`, planes `O(0, 0, 0) Z(0, 0, 1)`, complex numbers `1+2i`; null is an empty text.
    pub fn to_text(&self, dialect: Dialect) -> String {
        let n = |x: f64| number_text(x, dialect);
        match self {
            Self::Null => String::new(),
            Self::Boolean(true) => "True".into(),
            Self::Boolean(false) => "False".into(),
            Self::Integer(i) => i.to_string(),
            Self::Number(x) => n(*x),
            Self::Text(t) => t.to_string(),
            Self::Point(p) => format!("{{{}, {}, {}}}", n(p.x), n(p.y), n(p.z)),
            Self::Plane(p) => format!(
                "O({}, {}, {}) Z({}, {}, {})",
                n(p.origin.x),
                n(p.origin.y),
                n(p.origin.z),
                n(p.z_axis.x),
                n(p.z_axis.y),
                n(p.z_axis.z)
            ),
            Self::Complex { re, im } => {
                let sign = if im.is_sign_negative() { "" } else { "+" };
                format!("{}{sign}{}i", n(*re), n(*im))
            }
        }
    }

    /// Whether no coordinate or number in the value is NaN or infinite.
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Number(x) => x.is_finite(),
            Self::Point(p) => p.is_finite(),
            Self::Complex { re, im } => re.is_finite() && im.is_finite(),
            Self::Plane(p) => {
                p.origin.is_finite() && p.x_axis.is_finite() && p.y_axis.is_finite() && p.z_axis.is_finite()
            }
            Self::Null | Self::Boolean(_) | Self::Integer(_) | Self::Text(_) => true,
        }
    }
}

impl fmt::Display for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.to_text(Dialect::Modern))
    }
}

impl From<bool> for Variant {
    fn from(v: bool) -> Self {
        Self::Boolean(v)
    }
}

impl From<i32> for Variant {
    fn from(v: i32) -> Self {
        Self::Integer(v)
    }
}

impl From<f64> for Variant {
    fn from(v: f64) -> Self {
        Self::Number(v)
    }
}

impl From<&str> for Variant {
    fn from(v: &str) -> Self {
        Self::text(v)
    }
}

impl From<Point3> for Variant {
    fn from(v: Point3) -> Self {
        Self::Point(v)
    }
}

impl From<Plane> for Variant {
    fn from(v: Plane) -> Self {
        Self::Plane(v)
    }
}
