//! Plain functions as entries of the table.

use serde_json::Value as Json;

use super::answer::{Answer, Outcome};
use super::argument::Argument;
use super::call::Call;
use crate::Fault;

/// A function as the table keeps it.
pub(super) type Entry = Box<dyn Fn(&mut Call<'_>) -> Result<Json, Fault> + Send + Sync>;

/// A function of arguments that can be read, with a result that can be written.
pub(super) trait Function<Arguments>: Send + Sync + Sized + 'static {
    /// The name of what it gives.
    fn gives(&self) -> String;

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

            #[expect(non_snake_case, reason = "variables are named after their types")]
            fn entry(self) -> Entry {
                Box::new(move |call| {
                    $(let $argument = $argument::take(call)?;)*
                    call.ready = true;
                    self($($argument),*)?.json()
                })
            }
        }
    };
}

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
