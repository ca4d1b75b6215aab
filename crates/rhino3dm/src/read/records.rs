//! Records of the object and light tables (section 7): a class object, its attributes, their user data.

use crate::chunk::Reader;
use crate::class_object::ClassObject;
use crate::model::ModelObject;
use crate::object::Object;
use crate::tables::{KeptRecord, Table};
use crate::{Attributes, Error, Result, typecode};

/// The typecodes inside a record; objects and lights differ in them only.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RecordCodes {
    pub(crate) attributes: u32,
    pub(crate) user_data: u32,
    pub(crate) end: u32,
}

impl RecordCodes {
    pub(crate) const OBJECT: Self = Self {
        attributes: typecode::OBJECT_ATTRIBUTES,
        user_data: typecode::OBJECT_USER_DATA,
        end: typecode::OBJECT_RECORD_END,
    };
    pub(crate) const LIGHT: Self = Self {
        attributes: typecode::LIGHT_ATTRIBUTES,
        user_data: typecode::LIGHT_USER_DATA,
        end: typecode::LIGHT_RECORD_END,
    };
}

/// Reads a record.
pub(super) fn read_record(mut record: Reader<'_>, codes: RecordCodes) -> Result<ModelObject> {
    let offset = record.offset();
    let context = record.context();
    let mut found: Option<(Object, Vec<_>)> = None;
    let mut attributes = Attributes::default();
    let mut history = None;
    while !record.is_at_end() {
        if record.peek_typecode() == Some(typecode::CLASS) && found.is_none() {
            let class = ClassObject::read(&mut record)?;
            let geometry = Object::from_class(&class).unwrap_or_else(|error| {
                context.kept(class.offset, "an object", error);
                Object::Kept(class.to_raw())
            });
            let mut user_data =
                if matches!(geometry, Object::Kept(_)) { Vec::new() } else { class.user_data };
            user_data.retain(|data| !geometry.holds(data));
            found = Some((geometry, user_data));
            continue;
        }
        let chunk = record.chunk()?;
        let at = chunk.offset;
        let read = if chunk.typecode == codes.attributes {
            Attributes::read(chunk.body).map(|read| attributes = read)
        } else if chunk.typecode == codes.user_data {
            attributes.read_user_data(chunk.body)
        } else if chunk.typecode == typecode::OBJECT_HISTORY {
            history = Some(Box::new(KeptRecord::of(Table::Objects, &chunk)));
            Ok(())
        } else if chunk.typecode == codes.end {
            break;
        } else {
            Ok(())
        };
        if let Err(error) = read {
            context.left_out(at, "attributes", error);
        }
    }
    let Some((geometry, user_data)) = found else {
        return Err(Error::malformed(offset, "object record", "it holds no object"));
    };
    Ok(ModelObject { geometry, attributes, user_data, history })
}
