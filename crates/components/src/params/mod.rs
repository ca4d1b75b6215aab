//! The Params tab: objects that are their own port.

/// Declares parameters: each hands on what it collected, cast to its type by the solver.
macro_rules! parameters {
    ($($(#[doc = $help:tt])+ $function:ident, $guid:tt, $name:tt, $nick:tt, $at:tt, $kind:ident;)*) => {$(
        $(#[doc = $help])+
        #[component($guid, name = $name, nick = $nick, at = $at, floating)]
        #[output($name, $nick, "The data.", kind = $kind)]
        fn $function(
            #[doc = "The data, from a wire or stored in the parameter."]
            #[port($name, $nick, optional, kind = $kind)]
            data: &Tree,
        ) -> Tree {
            data.clone()
        }
    )*};
}

mod contextual;
mod geometry;
mod input;
mod landscape;
mod passive;
mod primitive;
mod rhino;
mod stored_data;
mod undocumented;
mod util;
pub(crate) mod wildcard;
