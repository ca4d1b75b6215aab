//! Reading and writing values with `serde`, behind the feature of that name.
//!
//! Points and vectors are lists of numbers, everything else is a structure with the names of its parts. What is read
//! goes through the same checks as the constructors, so that no value can come out of a file that the kernel would not
//! make itself; numbers survive to the last bit.

mod conics;
mod curves;
mod meshes;
mod plain;
mod surfaces;
mod thresholds;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

use crate::Result;

/// How a type looks in a file.
trait Form: Sized {
    /// What is written and read.
    type Written: Serialize + for<'de> Deserialize<'de>;

    /// The parts of a value.
    fn written(&self) -> Self::Written;

    /// The value of parts, when it is one.
    fn read(written: Self::Written) -> Result<Self>;
}

fn serialize<T: Form, S: Serializer>(value: &T, serializer: S) -> std::result::Result<S::Ok, S::Error> {
    value.written().serialize(serializer)
}

fn deserialize<'de, T: Form, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<T, D::Error> {
    T::read(T::Written::deserialize(deserializer)?).map_err(D::Error::custom)
}

/// Both traits of serde for types that have a [`Form`].
macro_rules! through_forms {
    ($($type:ty),* $(,)?) => { $(
        impl serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, s: S) -> std::result::Result<S::Ok, S::Error> {
                crate::serde_forms::serialize(self, s)
            }
        }
        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(d: D) -> std::result::Result<Self, D::Error> {
                crate::serde_forms::deserialize(d)
            }
        }
    )* };
}
use through_forms;

/// A structure whose fields are public and whose rule is a function.
macro_rules! structure {
    ($type:ident { $($field:ident: $kind:ty),* } $check:expr) => {
        const _: () = {
            #[derive(serde::Serialize, serde::Deserialize)]
            #[serde(deny_unknown_fields)]
            #[allow(unreachable_pub, reason = "an associated type needs it")]
            pub struct Written { $($field: $kind),* }

            impl crate::serde_forms::Form for $type {
                type Written = Written;
                fn written(&self) -> Written {
                    Written { $($field: self.$field.clone()),* }
                }
                fn read(w: Written) -> crate::Result<Self> {
                    let value = Self { $($field: w.$field),* };
                    let check: fn(&Self) -> crate::Result<()> = $check;
                    check(&value).map(|()| value)
                }
            }
            crate::serde_forms::through_forms!($type);
        };
    };
}
use structure;
