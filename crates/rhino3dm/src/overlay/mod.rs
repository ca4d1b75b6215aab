//! What kept records say, read out of them: views, construction planes, page settings, dimension and text styles,
//! texture mappings, history, embedded files.
//! The records stay as they are and are what is written.

mod bitmap;
mod dimension_style;
mod earth;
mod history;
mod page;
mod plain;
mod texture_mapping;
mod view;

pub use bitmap::{EmbeddedFile, EmbeddedForm};
pub use dimension_style::{DimensionStyle, TextStyle};
pub(crate) use earth::say_unset;
pub use history::{HistoryRecord, HistoryValue, HistoryValues, ObjectReference};
pub use page::{EarthAnchor, PageSettings};
pub(crate) use plain::{PlainPlane, PlainView, plane_of, write_plain_page};
pub use texture_mapping::{MappingKind, TextureMapping};
pub use view::{ConstructionPlane, View, ViewProjection};
pub(crate) use view::{PLANE, VIEW};

use crate::chunk::{Context, Reader};
use crate::model::Model;
use crate::object::ClassObject;
use crate::tables::{KeptRecord, Table};
use crate::version::Version;
use crate::{Limits, Result, typecode};

impl Model {
    /// The views that are open, as far as they can be read.
    pub fn views(&self) -> Vec<View> {
        self.list_of(typecode::VIEWS, view::VIEW, View::read)
    }

    /// The views that have names, as far as they can be read.
    pub fn named_views(&self) -> Vec<View> {
        self.list_of(typecode::NAMED_VIEWS, view::VIEW, View::read)
    }

    /// The construction planes that have names, as far as they can be read.
    pub fn named_construction_planes(&self) -> Vec<ConstructionPlane> {
        self.list_of(typecode::NAMED_PLANES, view::PLANE, ConstructionPlane::read)
    }

    /// Units of pages, base point and place on the Earth, when the archive says them.
    pub fn page_settings(&self) -> Option<PageSettings> {
        let record = self.kept.iter().find(|record| record.typecode == typecode::SETTINGS_ATTRIBUTES)?;
        record.with_body(|body| PageSettings::read(body, self)).ok()
    }

    /// The dimension styles, as far as they can be read.
    pub fn dimension_styles(&self) -> Vec<DimensionStyle> {
        self.class_objects(Table::DimensionStyles, DimensionStyle::read)
    }

    /// The text styles of archives before version 60, as far as they can be read. Dimension styles hold the fonts
    /// since.
    pub fn text_styles(&self) -> Vec<TextStyle> {
        self.class_objects(Table::TextStyles, TextStyle::read)
    }

    /// How objects came about, as far as it can be read: the records that programs follow when what an object was
    /// made from changes.
    pub fn history(&self) -> Vec<HistoryRecord> {
        self.class_objects(Table::History, HistoryRecord::read)
    }

    /// How images lie on objects, as far as it can be read.
    pub fn texture_mappings(&self) -> Vec<TextureMapping> {
        self.class_objects(Table::TextureMappings, TextureMapping::read)
    }

    fn class_objects<T>(&self, table: Table, read: impl Fn(&ClassObject<'_>) -> Result<Option<T>>) -> Vec<T> {
        let records = self.kept.iter().filter(|record| record.table == table);
        records
            .filter_map(|record| record.with_body(|body| read(&ClassObject::read(body)?)).ok().flatten())
            .collect()
    }

    /// The items of a record that holds a count and a chunk an item.
    fn list_of<T>(&self, record: u32, item: u32, read: impl Fn(&mut Reader<'_>) -> Result<T>) -> Vec<T> {
        let mut list = Vec::new();
        for record in self.kept.iter().filter(|kept| kept.typecode == record) {
            // What is broken ends the list; what came before it stays.
            let _ = record.with_body(|body| {
                body.i32("count")?;
                while !body.is_at_end() {
                    let mut chunk = body.chunk()?;
                    if chunk.typecode == item {
                        list.push(read(&mut chunk.body)?);
                    }
                }
                Ok(())
            });
        }
        list
    }
}

impl KeptRecord {
    /// Runs `read` over the body, its CRC left out.
    pub(crate) fn with_body<T>(&self, read: impl FnOnce(&mut Reader<'_>) -> Result<T>) -> Result<T> {
        self.with_body_in(&Context::new(&Limits::default()), read)
    }

    /// The same with limits and warnings of the caller's.
    fn with_body_in<T>(
        &self,
        context: &Context,
        read: impl FnOnce(&mut Reader<'_>) -> Result<T>,
    ) -> Result<T> {
        let version = Version { archive: self.archive_version, opennurbs: self.opennurbs_version };
        let body = self.body.split_last_chunk::<4>().map_or(&[] as &[u8], |(body, _)| body);
        read(&mut Reader::new(body, version, context))
    }
}
