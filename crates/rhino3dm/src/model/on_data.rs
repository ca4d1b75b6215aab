//! Objects of models in the form that travels outside archives (section 9).

use super::ModelObject;
use crate::chunk::{Context, Reader};
use crate::class_object::ClassObject;
use crate::object::object_version;
use crate::{Limits, Object, OnData, Result};

impl ModelObject {
    /// Reads the object of a JSON or .NET form as [`Object::from_on_data`] does, its user data with it. Such forms
    /// have no attributes.
    ///
    /// # Errors
    /// As [`Object::from_on_data`].
    pub fn from_on_data(archive3dm: i32, opennurbs: i32, data: &[u8]) -> Result<Self> {
        let context = Context::new(&Limits::default());
        let version = object_version(archive3dm, opennurbs.cast_unsigned())?;
        let class = ClassObject::read(&mut Reader::new(data, version, &context))?;
        let geometry = Object::from_class(&class)?;
        let beside = !matches!(geometry, Object::Kept(_));
        let user_data = class.user_data.into_iter().filter(|data| beside && !geometry.holds(data)).collect();
        Ok(Self { user_data, ..geometry.into() })
    }

    /// The object with its user data, without its attributes, in the form that travels outside archives.
    ///
    /// # Errors
    /// As [`Object::to_on_data`].
    pub fn to_on_data(&self, archive3dm: i32) -> Result<OnData> {
        self.geometry.on_data_with(archive3dm, &self.user_data)
    }
}
