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
pub(crate) mod values;

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

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::object::{ClassObject, UserData, write_class};
use crate::{Error, Result};

/// An entry of a table: one class object.
pub(crate) trait Entry: Sized {
    /// The class.
    const CLASS: Uuid;
    /// The class in words.
    const WHAT: &'static str;

    /// Reads the body; gives the number by which other parts of the archive refer to the entry, too.
    fn read(body: &mut Reader<'_>) -> Result<(Self, i32)>;

    /// Writes the body under a number and an identifier that no other entry of the table has.
    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()>;

    /// The identifier; nil when there is none.
    fn id(&self) -> Uuid;

    /// The name.
    fn name(&self) -> &str;

    /// The user data.
    fn user_data(&self) -> &[UserData];

    /// Takes the user data that stands behind the body.
    fn set_user_data(&mut self, data: Vec<UserData>);
}

/// Reads a record that holds one entry.
pub(crate) fn read_entry<T: Entry>(record: &mut Reader<'_>) -> Result<(T, i32)> {
    let offset = record.offset();
    // Betas of version 4 wrote some bodies without their wrapping.
    if record.peek_typecode() != Some(crate::typecode::CLASS) {
        return T::read(record);
    }
    let object = ClassObject::read(record)?;
    let Some(mut data) = object.data.filter(|_| object.class == T::CLASS) else {
        return Err(Error::malformed(offset, T::WHAT, "the record holds another class"));
    };
    let (mut entry, number) = T::read(&mut data)?;
    data.finish();
    entry.set_user_data(object.user_data);
    Ok((entry, number))
}

/// Writes an entry as a class object.
pub(crate) fn write_entry<T: Entry>(entry: &T, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
    write_class(w, T::CLASS, entry.user_data(), |w| entry.write(number, id, w))
}
