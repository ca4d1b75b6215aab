//! Things of plug-ins that are no data of Katydid's own, such as grids of voxels and pictures, on their way over wires.

use std::any::Any;
use std::fmt;
use std::sync::Arc;

use katydid_data::{Content, Keeper, Token, Value};

/// A thing with the text that stands for it on panels.
struct Kept<T> {
    text: String,
    thing: T,
}

impl<T> fmt::Debug for Kept<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl<T: Send + Sync + 'static> Keeper for Kept<T> {
    fn number(&self) -> u64 {
        0
    }

    fn is_lost(&self) -> bool {
        false
    }

    fn text(&self) -> Option<&str> {
        Some(&self.text)
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// A thing as an item of data.
pub(crate) fn keep<T: Send + Sync + 'static>(text: String, thing: T) -> Value {
    Value::from(Token(Arc::new(Kept { text, thing })))
}

/// The thing in an item, where it is one of this type.
pub(crate) fn kept<T: 'static>(value: &Value) -> Option<&T> {
    let Value::Content(content) = value else { return None };
    let Content::Token(token) = &**content else { return None };
    token.0.as_any().downcast_ref::<Kept<T>>().map(|kept| &kept.thing)
}
