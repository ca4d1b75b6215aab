//! Documents as files: reading, writing, the recent ones, the gallery.

mod export;
mod form;
mod gallery;
mod plain;
mod portraits;
mod private;
mod recent;

pub(crate) use export::{Wishes, export};
pub(crate) use form::{Form, read, write};
pub(crate) use gallery::Gallery;
pub(crate) use plain::plain;
pub(crate) use portraits::Portraits;
pub(crate) use private::private_folder;
pub(crate) use recent::Recent;
