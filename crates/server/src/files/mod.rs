//! Documents as files: reading, writing, the recent ones, the gallery.

mod address;
mod plain;
mod portraits;
mod private;
mod recent;

pub(crate) use address::AddressFile;
pub(crate) use katydid_studio::{Form, Gallery, Wishes, export, read, write};
pub(crate) use plain::plain;
pub(crate) use portraits::Portraits;
pub(crate) use private::private_folder;
pub(crate) use recent::Recent;
