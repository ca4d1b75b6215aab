//! Identifier, number and name of an entry, in the two encodings archives have for them (section 8).

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::values::NO_NUMBER;
use crate::{Error, Result};

/// What an entry of a table says of itself.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Component {
    pub(crate) id: Uuid,
    pub(crate) number: i32,
    pub(crate) name: String,
    /// Whether the name is stated though it is empty, in the encoding by bits.
    pub(crate) states_empty_name: bool,
}

impl Default for Component {
    fn default() -> Self {
        Self { id: Uuid::nil(), number: NO_NUMBER, name: String::new(), states_empty_name: false }
    }
}

const WHAT: &str = "component attributes";
const ATTRIBUTES: u32 = 0x4000_8002;

/// States of a field: not asked for, present, asked for but not there.
const NOT_ASKED: u8 = 0;
const PRESENT: u8 = 1;
const UNSET: u8 = 2;

/// Bits of the fields in the second encoding.
const ID: u32 = 1;
const PARENT: u32 = 2;
const NUMBER: u32 = 4;
const NAME: u32 = 8;
const STATUS: u32 = 16;

impl Component {
    /// A component with these values.
    pub(crate) fn new(id: Uuid, number: i32, name: &str) -> Self {
        Self { id, number, name: name.to_owned(), states_empty_name: false }
    }

    /// The chunk of five fields, each behind a byte that says whether it is there.
    pub(crate) fn read_fields(body: &mut Reader<'_>) -> Result<Self> {
        let mut fields = body.expect(ATTRIBUTES, WHAT)?;
        let offset = fields.offset();
        let major = fields.i32(WHAT)?;
        fields.i32(WHAT)?;
        if major != 1 {
            return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
        }
        let mut component = Self::default();
        if fields.u8(WHAT)? == PRESENT {
            fields.take(12, "serial numbers")?;
        }
        if fields.u8(WHAT)? == PRESENT {
            component.id = fields.uuid(WHAT)?;
        }
        if fields.u8(WHAT)? == PRESENT {
            fields.u32("component type")?;
        }
        if fields.u8(WHAT)? == PRESENT {
            component.number = fields.i32(WHAT)?;
        }
        if fields.u8(WHAT)? == PRESENT {
            component.name = fields.string("name")?;
        }
        fields.finish();
        Ok(component)
    }

    /// The chunk of five fields.
    pub(crate) fn write_fields(&self, w: &mut Writer) -> Result<()> {
        w.chunk(ATTRIBUTES, |w| {
            w.i32(1);
            w.i32(0);
            w.u8(NOT_ASKED);
            if self.id.is_nil() {
                w.u8(UNSET);
            } else {
                w.u8(PRESENT);
                w.uuid(self.id);
            }
            w.u8(NOT_ASKED);
            w.u8(PRESENT);
            w.i32(self.number);
            if self.name.is_empty() {
                w.u8(UNSET);
                return Ok(());
            }
            w.u8(PRESENT);
            w.string(&self.name)
        })
    }

    /// The chunk whose bits say which fields follow.
    pub(crate) fn read_bits(body: &mut Reader<'_>) -> Result<Self> {
        let (mut fields, _) = body.versioned_1(WHAT)?;
        let bits = fields.u32(WHAT)?;
        let mut component = Self::default();
        if bits & ID != 0 {
            component.id = fields.uuid(WHAT)?;
        }
        if bits & PARENT != 0 {
            fields.uuid("parent")?;
        }
        if bits & NUMBER != 0 {
            component.number = fields.i32(WHAT)?;
        }
        if bits & NAME != 0 {
            component.name = fields.string("name")?;
            component.states_empty_name = component.name.is_empty();
        }
        if bits & STATUS != 0 {
            fields.take(8, "component status")?;
        }
        fields.finish();
        Ok(component)
    }

    /// The chunk whose bits say which fields follow: those that are set.
    pub(crate) fn write_bits(&self, w: &mut Writer) -> Result<()> {
        let bit = |set: bool, bit: u32| if set { bit } else { 0 };
        let bits = bit(!self.id.is_nil(), ID)
            | bit(self.number != NO_NUMBER, NUMBER)
            | bit(self.states_empty_name || !self.name.is_empty(), NAME);
        w.versioned(1, 0, |w| {
            w.u32(bits);
            if bits & ID != 0 {
                w.uuid(self.id);
            }
            if bits & NUMBER != 0 {
                w.i32(self.number);
            }
            if bits & NAME != 0 {
                w.string(&self.name)?;
            }
            Ok(())
        })
    }
}
