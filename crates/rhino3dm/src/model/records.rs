//! What kept records say, read out of them: views, construction planes, page settings, dimension and text styles,
//! texture mappings, history, embedded files. The records stay as they are and are what is written.

use katydid_geometry::Point3;

use super::Model;
use crate::chunk::Reader;
use crate::class_object::ClassObject;
use crate::overlay::{
    DimensionStyle, EmbeddedFile, HistoryRecord, PageSettings, RENDERING, TextStyle, TextureMapping,
};
use crate::tables::Table;
use crate::views::{ConstructionPlane, PLANE, VIEW, View};
use crate::{Result, typecode};

impl Model {
    /// The views that are open, as far as they can be read.
    pub fn views(&self) -> Vec<View> {
        self.list_of(typecode::VIEWS, VIEW, View::read)
    }

    /// The views that have names, as far as they can be read.
    pub fn named_views(&self) -> Vec<View> {
        self.list_of(typecode::NAMED_VIEWS, VIEW, View::read)
    }

    /// The construction planes that have names, as far as they can be read.
    pub fn named_construction_planes(&self) -> Vec<ConstructionPlane> {
        self.list_of(typecode::NAMED_PLANES, PLANE, ConstructionPlane::read)
    }

    /// Units of pages, base point and place on the Earth, when the archive says them.
    pub fn page_settings(&self) -> Option<PageSettings> {
        let record = self.kept.iter().find(|record| record.typecode == typecode::SETTINGS_ATTRIBUTES)?;
        // Pages of an archive that says nothing of them are like the model.
        let of_model = PageSettings {
            linetype_scale: 1.0,
            units: self.units,
            unit_scale: self.unit_scale.clone(),
            tolerance: self.tolerance,
            base_point: Point3::ORIGIN,
            earth: None,
        };
        record.with_body(|body| PageSettings::read(body, of_model)).ok()
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

    /// The files and images inside the archive, as far as they can be read, in its order.
    pub fn embedded_files(&self) -> Vec<EmbeddedFile<'_>> {
        let records = self.kept.iter().filter(|record| record.table == Table::Bitmaps);
        let mut files: Vec<_> =
            records.filter_map(|record| EmbeddedFile::of(record).ok().flatten()).collect();
        for table in self.user_tables.iter().filter(|table| table.plug_in == RENDERING) {
            // What is broken ends the list; what came before it stays.
            let _ = EmbeddedFile::add_of_rendering(table, &mut files);
        }
        files
    }
}
