//! A conversion: from which types, to which, what it gives, and how sure we are that Grasshopper does the same.

use crate::{Kind, Value};

use super::Rules;

/// How sure we are that Grasshopper converts in this way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sure {
    /// A picture of Grasshopper or its documentation shows it.
    Shown,
    /// Files could not have worked otherwise.
    Used,
    /// Known to its users; nothing at hand shows it.
    Likely,
    /// Our own reading: nothing at hand tells. Where it is used, a remark says so.
    Ours,
}

impl Sure {
    /// A word for lists: `shown`, `used`, `likely`, `ours`.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Shown => "shown",
            Self::Used => "used",
            Self::Likely => "likely",
            Self::Ours => "ours",
        }
    }
}

/// What a conversion computes; `None` where this value has none.
pub(super) type Convert = fn(&Value, &Rules) -> Option<Value>;

/// A row of the table of conversions.
///
/// [`Kind::Geometry`] among the types it converts from stands for every type of geometry that has no row of its own,
/// [`Kind::Generic`] for every type at all.
#[derive(Debug, Clone, Copy)]
pub struct Way {
    /// The type that it gives.
    pub to: Kind,
    /// The types that it takes.
    pub from: &'static [Kind],
    /// What comes of them.
    pub gives: &'static str,
    /// How sure we are of it.
    pub sure: Sure,
    pub(super) convert: Convert,
}

impl Way {
    /// The names of the types that it takes, for lists.
    pub fn sources(&self) -> String {
        let name = |kind: &Kind| match kind {
            Kind::Generic => "anything",
            Kind::Geometry => "any geometry",
            other => other.name(),
        };
        self.from.iter().map(name).collect::<Vec<_>>().join(", ")
    }
}

/// A row, written short.
pub(super) const fn way(
    to: Kind,
    from: &'static [Kind],
    gives: &'static str,
    sure: Sure,
    convert: Convert,
) -> Way {
    Way { to, from, gives, sure, convert }
}
