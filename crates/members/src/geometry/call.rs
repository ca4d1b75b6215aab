//! One call: its arguments, and what it gives.

use serde_json::Value as Json;

use super::answer::Answer;
use super::argument::Waiting;
use crate::wire::Read;
use crate::{Fault, Value};

/// The archive version of objects in replies.
pub(super) const ARCHIVE: i32 = 70;

/// The arguments of a call, as who calls has them. The reply comes in the same form.
#[derive(Clone, Copy)]
pub(super) enum Arguments<'a> {
    /// A server's.
    Json(&'a [Json]),
    /// A script's.
    Values(&'a [Value]),
}

impl Arguments<'_> {
    /// How many there are.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Json(list) => list.len(),
            Self::Values(list) => list.len(),
        }
    }
}

/// A reply, in the form of the arguments.
pub(super) enum Given {
    /// A server's.
    Json(Json),
    /// A script's.
    Value(Value),
}

/// The arguments of a call, taken one after the other.
pub(super) struct Call<'a> {
    arguments: Arguments<'a>,
    /// The parameters' names.
    names: &'a [&'static str],
    waiting: &'a Waiting,
    place: usize,
    /// Whether all arguments have been read: what goes wrong from then on is not theirs.
    pub(super) ready: bool,
}

impl<'a> Call<'a> {
    pub(super) fn new(arguments: Arguments<'a>, names: &'a [&'static str], waiting: &'a Waiting) -> Self {
        Self { arguments, names, waiting, place: 0, ready: false }
    }

    /// A result in the form of the reply.
    pub(super) fn give(&self, result: impl Answer) -> Result<Given, Fault> {
        match self.arguments {
            Arguments::Json(_) => result.json().map(Given::Json),
            Arguments::Values(_) => result.value().map(Given::Value),
        }
    }

    pub(super) fn waiting(&self) -> &'a Waiting {
        self.waiting
    }

    /// Reads the next argument; one that is left out is null.
    pub(super) fn next<T: Read>(&mut self) -> Result<T, Fault> {
        self.waiting.check()?;
        let place = self.place;
        self.place += 1;
        let name = self.names.get(place).copied().unwrap_or("argument");
        let named = |fault: Fault| Fault { message: format!("{name} {}", fault.message), cause: fault.cause };
        let (read, is_missing) = match self.arguments {
            Arguments::Json(list) => {
                let json = list.get(place).unwrap_or(&Json::Null);
                if names_an_address(json) {
                    return Err(named(Fault::refused("names an address; contents are not fetched")));
                }
                (T::read(json), json.is_null())
            }
            Arguments::Values(list) => {
                let value = list.get(place).unwrap_or(&Value::Null);
                (T::of_value(value), *value == Value::Null)
            }
        };
        // What is null is missing, whatever reading it says.
        read.map_err(|fault| if is_missing { named(Fault::bad_request("is missing")) } else { named(fault) })
    }
}

/// Whether an argument asks to be fetched from elsewhere.
fn names_an_address(json: &Json) -> bool {
    json.as_object()
        .is_some_and(|map| map.len() == 1 && map.keys().all(|key| key.eq_ignore_ascii_case("url")))
}

/// What a call gives.
#[derive(Debug, Clone, PartialEq)]
pub struct CallReply {
    /// The JSON of the reply; `None` for an empty body, of a function that gives nothing.
    pub json: Option<Json>,
}

impl CallReply {
    /// The body of the reply.
    pub fn text(&self) -> String {
        self.json.as_ref().map(Json::to_string).unwrap_or_default()
    }
}
