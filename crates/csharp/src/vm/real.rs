//! Functions of one number that are operations of their own.

use katydid_elementary::Elementary;

/// A function of `System.Math`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Real {
    Sin,
    Cos,
    Tan,
    Sqrt,
    Exp,
    Log,
    Abs,
    Floor,
    Ceiling,
    Truncate,
}

impl Real {
    /// By its name.
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "Sin" => Self::Sin,
            "Cos" => Self::Cos,
            "Tan" => Self::Tan,
            "Sqrt" => Self::Sqrt,
            "Exp" => Self::Exp,
            "Log" => Self::Log,
            "Abs" => Self::Abs,
            "Floor" => Self::Floor,
            "Ceiling" => Self::Ceiling,
            "Truncate" => Self::Truncate,
            _ => return None,
        })
    }

    /// Its value.
    #[inline]
    pub fn of(self, x: f64) -> f64 {
        match self {
            Self::Sin => x.sine(),
            Self::Cos => x.cosine(),
            Self::Tan => x.tangent(),
            Self::Sqrt => x.sqrt(),
            Self::Exp => x.exponential(),
            Self::Log => x.logarithm(),
            Self::Abs => x.abs(),
            Self::Floor => x.floor(),
            Self::Ceiling => x.ceil(),
            Self::Truncate => x.trunc(),
        }
    }
}
