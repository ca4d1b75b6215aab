//! The records of the object and light tables: a class object, its attributes, their user data.

use crate::chunk::Writer;
use crate::ids::Ids;
use crate::model::ModelObject;
use crate::object::{Surroundings, restated};
use crate::read::RecordCodes;
use crate::styles::Styles;
use crate::{ActiveSpace, Error, Result, class_ids, typecode};

/// Fewer records are not worth the start of other threads.
#[cfg(feature = "parallel")]
const PARALLEL: usize = 32;

/// How the records of a table are written.
pub(super) struct Records<'a> {
    /// The typecode of a record.
    pub(super) typecode: u32,
    /// The styles of annotations.
    pub(super) styles: &'a Styles,
    /// How many layers there are.
    pub(super) layers: usize,
    /// The identifiers of lights and objects together.
    pub(super) ids: &'a Ids,
    /// The place of the first of them among those identifiers.
    pub(super) first: usize,
}

impl Records<'_> {
    /// Writes the records in order. Stretches of them are written side by side and put together: the bytes, or the
    /// error, do not depend on the threads.
    pub(super) fn write(&self, objects: &[ModelObject], w: &mut Writer) -> Result<()> {
        #[cfg(feature = "parallel")]
        if objects.len() >= PARALLEL {
            use rayon::prelude::*;
            let version = w.version();
            let stretches = objects.par_iter().enumerate().try_fold(
                || Writer::new(version),
                |mut w, (place, object)| self.record(object, place, &mut w).map(|()| w),
            );
            // A thread that waits may be given others' work, which has a token of its own.
            let stretches: Vec<Result<Writer>> =
                katydid_geometry::CancellationToken::waiting(|| stretches.collect());
            return stretches.into_iter().try_for_each(|stretch| {
                w.chunks(&stretch?.into_bytes());
                Ok(())
            });
        }
        objects.iter().enumerate().try_for_each(|(place, object)| self.record(object, place, w))
    }

    fn record(&self, object: &ModelObject, place: usize, w: &mut Writer) -> Result<()> {
        let attributes = &object.attributes;
        if let Some(layer) = attributes.layer.filter(|layer| *layer >= self.layers) {
            return Err(Error::CannotWrite {
                what: format!("object {place}"),
                version: w.version().archive,
                why: format!("it lies on layer {layer}, but there are {} layers", self.layers),
            });
        }
        let is_object = self.typecode == typecode::OBJECT_RECORD;
        let codes = if is_object { RecordCodes::OBJECT } else { RecordCodes::LIGHT };
        let around = Surroundings { styles: self.styles, in_model: attributes.space == ActiveSpace::Model };
        let (geometry, user_data) = restated(&object.geometry, &object.user_data, around, w.version())?;
        w.chunk(self.typecode, |w| {
            if is_object {
                let kind = class_ids::object_type(geometry.class());
                w.short(typecode::OBJECT_RECORD_TYPE, i64::from(kind));
            }
            let start = w.len();
            geometry.write(w, &user_data)?;
            let id = self.ids.get(self.first + place, w.since(start));
            attributes.write(w, id, codes.attributes, codes.user_data)?;
            object.history.iter().try_for_each(|history| history.write(w))?;
            w.short(codes.end, 0);
            Ok(())
        })
    }
}
