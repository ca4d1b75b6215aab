use std::sync::Arc as Shared;

use super::Content;
use crate::{Value, cast};

/// Which items pass, by their attributes.
#[derive(Debug, Clone, PartialEq)]
pub enum Filter {
    /// Those whose attribute is this value, or is not.
    Equal {
        /// The key of the attribute.
        key: Shared<str>,
        /// What it is compared with.
        value: Value,
        /// Whether those pass that have another value, or none.
        negated: bool,
    },
    /// Those whose attribute has this text in it.
    Contains {
        /// The key of the attribute.
        key: Shared<str>,
        /// The text that is looked for.
        text: Shared<str>,
        /// Whether small and capital letters are told apart.
        case: bool,
    },
    /// Those that pass all of these. None of these is one of several again.
    All(Vec<Filter>),
}

impl Filter {
    /// Those that pass each of several filters.
    pub fn all(filters: impl IntoIterator<Item = Self>) -> Self {
        let flat = |filter| match filter {
            Self::All(filters) => filters,
            one => vec![one],
        };
        Self::All(filters.into_iter().flat_map(flat).collect())
    }

    /// Whether an item passes. Values of the attribute are cast to the type they are compared with.
    pub fn passes(&self, content: &Content, rules: &cast::Rules) -> bool {
        match self {
            Self::Equal { key, value, negated } => {
                content.attribute(key).is_some_and(|found| same(&found, value, rules)) != *negated
            }
            Self::Contains { key, text, case } => {
                let found = content.attribute(key);
                let found = found.and_then(|found| cast::value(&found, crate::Kind::Text, rules));
                match found {
                    Some(Value::Text(found)) if *case => found.contains(&**text),
                    Some(Value::Text(found)) => found.to_lowercase().contains(&text.to_lowercase()),
                    _ => false,
                }
            }
            Self::All(filters) => filters.iter().all(|filter| filter.passes(content, rules)),
        }
    }

    /// What it asks for, in words.
    pub fn words(&self, style: &crate::text::Style) -> String {
        match self {
            Self::Equal { key, value, negated } => {
                let sign = if *negated { '\u{2260}' } else { '=' };
                format!("{key} {sign} {}", crate::text::value(value, style))
            }
            Self::Contains { key, text, .. } => format!("{key} contains {text}"),
            Self::All(filters) => {
                filters.iter().map(|filter| filter.words(style)).collect::<Vec<_>>().join(" and ")
            }
        }
    }
}

/// Content such as a layer is the same when its path is.
fn same(found: &Value, wanted: &Value, rules: &cast::Rules) -> bool {
    match (found, wanted) {
        (Value::Content(found), Value::Content(wanted)) => found.path() == wanted.path(),
        (Value::Content(found), Value::Text(wanted)) => found.path() == Some(&**wanted),
        _ => cast::value(found, wanted.kind(), rules).is_some_and(|found| found == *wanted),
    }
}
