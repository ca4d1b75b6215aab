//! What functions give, as replies have it.

use std::sync::Arc;

use serde_json::Value as Json;

use super::call::ARCHIVE;
use crate::wire::{Wire, number};
use crate::{Cause, Fault, Record, Shape, Value};

/// A value of a reply.
pub(super) trait Answer {
    /// The name of its type, for help pages and for `?return.`.
    fn name() -> String;

    /// As the reply has it.
    fn json(self) -> Result<Json, Fault>;

    /// As a script gets it.
    fn value(self) -> Result<Value, Fault>;
}

impl<T: Wire> Answer for T {
    fn name() -> String {
        T::TYPE.into()
    }

    fn json(self) -> Result<Json, Fault> {
        self.to_json(ARCHIVE)
    }

    fn value(self) -> Result<Value, Fault> {
        self.into_script()
    }
}

macro_rules! plain {
    ($($type:ty, $name:literal, $json:expr, $value:expr;)*) => {
        $(impl Answer for $type {
            fn name() -> String {
                $name.into()
            }

            fn json(self) -> Result<Json, Fault> {
                let json: fn($type) -> Json = $json;
                Ok(json(self))
            }

            fn value(self) -> Result<Value, Fault> {
                let value: fn($type) -> Value = $value;
                Ok(value(self))
            }
        })*
    };
}

plain! {
    f64, "System.Double", number, Value::Number;
    bool, "System.Boolean", Json::from, Value::Bool;
    i32, "System.Int32", Json::from, |whole| Value::Int(whole.into());
    usize, "System.Int32", Json::from, |count| i64::try_from(count).map_or(Value::Null, Value::Int);
    String, "System.String", Json::from, Value::Text;
    (), "System.Void", |()| Json::Null, |()| Value::Null;
    Json, "System.Object", |json| json, Value::from;
}

impl Answer for Value {
    fn name() -> String {
        "System.Object".into()
    }

    fn json(self) -> Result<Json, Fault> {
        self.to_json(ARCHIVE)
    }

    fn value(self) -> Result<Value, Fault> {
        Ok(self)
    }
}

impl Answer for Record {
    fn name() -> String {
        "System.Object".into()
    }

    fn json(self) -> Result<Json, Fault> {
        Shape::Record(Arc::new(self)).to_json(ARCHIVE)
    }

    fn value(self) -> Result<Value, Fault> {
        Ok(Shape::Record(Arc::new(self)).into())
    }
}

impl<T: Answer> Answer for Vec<T> {
    fn name() -> String {
        format!("{}[]", T::name())
    }

    fn json(self) -> Result<Json, Fault> {
        self.into_iter().map(T::json).collect::<Result<_, _>>().map(Json::Array)
    }

    fn value(self) -> Result<Value, Fault> {
        self.into_iter().map(T::value).collect::<Result<_, _>>().map(Value::list)
    }
}

impl<T: Answer> Answer for Option<T> {
    fn name() -> String {
        T::name()
    }

    fn json(self) -> Result<Json, Fault> {
        self.map_or(Ok(Json::Null), T::json)
    }

    fn value(self) -> Result<Value, Fault> {
        self.map_or(Ok(Value::Null), T::value)
    }
}

macro_rules! several {
    ($($type:ident),*) => {
        impl<$($type: Answer),*> Answer for ($($type,)*) {
            fn name() -> String {
                [$($type::name()),*].join(", ")
            }

            #[expect(non_snake_case, reason = "variables are named after their types")]
            fn json(self) -> Result<Json, Fault> {
                let ($($type,)*) = self;
                Ok(Json::Array(vec![$($type.json()?),*]))
            }

            #[expect(non_snake_case, reason = "variables are named after their types")]
            fn value(self) -> Result<Value, Fault> {
                let ($($type,)*) = self;
                Ok(Value::List(vec![$($type.value()?),*]))
            }
        }
    };
}

several!(A, B);
several!(A, B, C);
several!(A, B, C, D);

/// What a function may come to: a value, or a fault of ours or of the kernel's.
pub(super) type Outcome<T> = Result<T, Fault>;

/// Null where an operation has no result, as RhinoCommon says it: solids that are open, curves that are not planar.
pub(super) fn or_null<T>(outcome: Outcome<T>) -> Outcome<Option<T>> {
    match outcome {
        Err(fault) if matches!(fault.cause, Cause::BadRequest | Cause::Failed) => Ok(None),
        outcome => outcome.map(Some),
    }
}

impl From<katydid_geometry::Error> for Fault {
    fn from(error: katydid_geometry::Error) -> Self {
        match error {
            katydid_geometry::Error::Unsupported(what) => Self::not_supported(what),
            other => Self::bad_request(other.to_string()),
        }
    }
}
