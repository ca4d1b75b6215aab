//! What an archive holds besides objects: tables of named things that objects refer to (sections 5 and 8).
//!
//! Every entry is plain data with its user data beside it. Entries of a class or layout that is not taken apart
//! are kept byte for byte as a [`KeptRecord`].

mod block;
mod component;
mod file_reference;
mod group;
mod hatch_pattern;
mod kept;
mod layer;
mod linetype;
mod material;
mod rendering;
mod section_style;
mod texture;

pub use block::{Block, BlockSource, Checksum, LinkedBlock};
pub use file_reference::{ContentHash, FileReference};
pub use group::Group;
pub use hatch_pattern::{HatchFill, HatchLine, HatchPattern};
pub use kept::{KeptRecord, Table};
pub use layer::Layer;
pub use linetype::{LineCap, LineJoin, Linetype, LinetypeSegment};
pub use material::Material;
pub use rendering::{MappingReference, MaterialReference, Rendering};
pub use section_style::SectionStyle;
pub use texture::{Texture, TextureKind};

pub(crate) use component::Component;
pub(crate) use material::single;

use std::borrow::Cow;

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData, write_class};
use crate::version::Version;
use crate::{Error, Result};

/// What every entry of a table has: an identifier, a name and user data.
pub(crate) trait Named {
    /// The identifier; nil when there is none.
    fn id(&self) -> Uuid;

    /// The name.
    fn name(&self) -> &str;

    /// The user data.
    fn user_data(&self) -> &[UserData];

    /// Takes the user data that stands behind the body.
    fn set_user_data(&mut self, data: Vec<UserData>);
}

macro_rules! named {
    ($($entry:ty),*) => {
        $(impl Named for $entry {
            fn id(&self) -> Uuid {
                self.id
            }

            fn name(&self) -> &str {
                &self.name
            }

            fn user_data(&self) -> &[UserData] {
                &self.user_data
            }

            fn set_user_data(&mut self, data: Vec<UserData>) {
                self.user_data = data;
            }
        })*
    };
}

named!(Block, Group, HatchPattern, Layer, Linetype, Material);

/// An entry of a table: one class object.
pub(crate) trait Entry: Named + Sized {
    /// The class.
    const CLASS: Uuid;
    /// The class in words.
    const WHAT: &'static str;

    /// Reads the body. The number that it states says nothing: entries are referred to by their places.
    fn read(body: &mut Reader<'_>) -> Result<Self>;

    /// Writes the body under a number and an identifier that no other entry of the table has.
    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()>;

    /// Takes out of the user data what is the entry's own, put there by versions that had no other place for it.
    fn take_own_data(&mut self) {}

    /// The user data in which a version has to put what is the entry's own.
    fn own_data(&self, _version: Version) -> Result<Option<UserData>> {
        Ok(None)
    }
}

/// Reads a record that holds one entry.
pub(crate) fn read_entry<T: Entry>(record: &mut Reader<'_>) -> Result<T> {
    let offset = record.offset();
    // Betas of version 4 wrote some bodies without their wrapping.
    if record.peek_typecode() != Some(crate::typecode::CLASS) {
        return T::read(record);
    }
    let object = ClassObject::read(record)?;
    let Some(mut data) = object.data.filter(|_| object.class == T::CLASS) else {
        return Err(Error::malformed(offset, T::WHAT, "the record holds another class"));
    };
    let mut entry = T::read(&mut data)?;
    data.finish();
    entry.set_user_data(object.user_data);
    entry.take_own_data();
    Ok(entry)
}

/// Writes an entry as a class object.
pub(crate) fn write_entry<T: Entry>(entry: &T, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
    let data: Cow<'_, [UserData]> = match entry.own_data(w.version())? {
        Some(own) => std::iter::once(own).chain(entry.user_data().iter().cloned()).collect(),
        None => Cow::Borrowed(entry.user_data()),
    };
    write_class(w, T::CLASS, &data, |w| entry.write(number, id, w))
}
