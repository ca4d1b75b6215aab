//! Plain functions as entries of the table.

use super::answer::{Answer, Outcome};
use super::argument::Argument;
use super::call::{Call, Given};
use crate::Fault;

/// A function as the table keeps it.
pub(super) type Entry = Box<dyn Fn(&mut Call<'_>) -> Result<Given, Fault> + Send + Sync>;

/// A function of arguments that can be read, with a result that can be written.
pub(super) trait Function<Arguments>: Send + Sync + Sized + 'static {
    /// The name of what it gives.
    fn gives(&self) -> String;

    /// The names of the types that callers send.
    fn takes(&self) -> Vec<String>;

    /// The function as the table keeps it.
    fn entry(self) -> Entry;
}

macro_rules! function {
    ($($argument:ident),*) => {
        impl<F, R, $($argument),*> Function<(R, $($argument,)*)> for F
        where
            F: Fn($($argument),*) -> Outcome<R> + Send + Sync + 'static,
            R: Answer + 'static,
            $($argument: Argument + 'static,)*
        {
            fn gives(&self) -> String {
                R::name()
            }

            fn takes(&self) -> Vec<String> {
                let types: &[Vec<String>] = &[$($argument::type_names()),*];
                types.concat()
            }

            #[allow(non_snake_case, reason = "variables are named after their types")]
            fn entry(self) -> Entry {
                Box::new(move |call: &mut Call<'_>| {
                    $(let $argument = $argument::take(call)?;)*
                    call.ready = true;
                    call.give(self($($argument),*)?)
                })
            }
        }
    };
}

function!();
function!(A);
function!(A, B);
function!(A, B, C);
function!(A, B, C, D);
function!(A, B, C, D, E);
function!(A, B, C, D, E, G);
function!(A, B, C, D, E, G, H);
function!(A, B, C, D, E, G, H, I);
function!(A, B, C, D, E, G, H, I, J);
function!(A, B, C, D, E, G, H, I, J, K);
function!(A, B, C, D, E, G, H, I, J, K, L);
function!(A, B, C, D, E, G, H, I, J, K, L, M);
function!(A, B, C, D, E, G, H, I, J, K, L, M, N);
