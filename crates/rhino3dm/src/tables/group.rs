//! Class Group (section 8).

use uuid::{Uuid, uuid};

use super::Entry;
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::{Error, Result};

/// A group; the objects name it in their attributes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Group {
    /// The identifier. A nil one gets a value of its own when written.
    pub id: Uuid,
    /// The name; groups need none.
    pub name: String,
    /// User data, carried along as it is.
    pub user_data: Vec<UserData>,
}

impl Group {
    /// A group of a name.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }
}

impl Entry for Group {
    const CLASS: Uuid = uuid!("721D9F97-3645-44C4-8BE6-B2CF697D25CE");
    const WHAT: &'static str = "group";

    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let (major, minor) = body.packed_version(Self::WHAT)?;
        if major != 1 {
            return Err(Error::malformed(offset, Self::WHAT, format!("major version {major} is not known")));
        }
        body.i32("group number")?;
        let name = body.string("group name")?;
        let id = if minor >= 1 { body.uuid(Self::WHAT)? } else { Uuid::nil() };
        Ok(Self { id, name, user_data: Vec::new() })
    }

    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 1);
        w.i32(number);
        w.string(&self.name)?;
        w.uuid(id);
        Ok(())
    }
}
