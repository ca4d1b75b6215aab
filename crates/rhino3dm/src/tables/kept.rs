//! Records that are carried along byte for byte.

use crate::chunk::Writer;
use crate::{Result, typecode};

/// The tables of an archive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Table {
    Properties,
    Settings,
    Bitmaps,
    TextureMappings,
    Materials,
    Linetypes,
    Layers,
    Groups,
    TextStyles,
    DimensionStyles,
    Lights,
    HatchPatterns,
    Blocks,
    Objects,
    History,
}

/// Every table that holds records, in the order of archives.
const TABLES: [(Table, u32); 15] = [
    (Table::Properties, typecode::PROPERTIES_TABLE),
    (Table::Settings, typecode::SETTINGS_TABLE),
    (Table::Bitmaps, typecode::BITMAP_TABLE),
    (Table::TextureMappings, typecode::TEXTURE_MAPPING_TABLE),
    (Table::Materials, typecode::MATERIAL_TABLE),
    (Table::Linetypes, typecode::LINETYPE_TABLE),
    (Table::Layers, typecode::LAYER_TABLE),
    (Table::Groups, typecode::GROUP_TABLE),
    (Table::TextStyles, typecode::FONT_TABLE),
    (Table::DimensionStyles, typecode::DIMENSION_STYLE_TABLE),
    (Table::Lights, typecode::LIGHT_TABLE),
    (Table::HatchPatterns, typecode::HATCH_PATTERN_TABLE),
    (Table::Blocks, typecode::INSTANCE_DEFINITION_TABLE),
    (Table::Objects, typecode::OBJECT_TABLE),
    (Table::History, typecode::HISTORY_TABLE),
];

impl Table {
    pub(crate) fn from_typecode(typecode: u32) -> Option<Self> {
        TABLES.iter().find(|(_, known)| *known == typecode).map(|(table, _)| *table)
    }

    pub(crate) fn typecode(self) -> u32 {
        TABLES.iter().find(|(table, _)| *table == self).map(|(_, code)| *code).unwrap_or_default()
    }

    /// The table in words.
    pub fn name(self) -> &'static str {
        TABLES
            .iter()
            .find(|(table, _)| *table == self)
            .and_then(|(_, code)| typecode::table_name(*code))
            .unwrap_or_default()
    }
}

/// A record of a table as it was, for what is not taken apart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeptRecord {
    /// The table it stands in.
    pub table: Table,
    /// Its typecode.
    pub typecode: u32,
    /// The value of a short record; a long one has bytes.
    pub value: i64,
    /// The body with its closing CRC, verbatim.
    pub body: Vec<u8>,
    /// The archive version whose rules the body follows.
    pub archive_version: i32,
    /// The openNURBS version that wrote it.
    pub opennurbs_version: u32,
}

impl KeptRecord {
    /// What the record is, in words.
    pub fn name(&self) -> String {
        typecode::record_name(self.typecode).map_or_else(
            || format!("record {:08X} of the {} table", self.typecode, self.table.name()),
            str::to_owned,
        )
    }

    /// Whether the record may stand in an archive of the given version as it is, and if not why.
    pub(crate) fn fits(&self, archive: i32) -> std::result::Result<(), &'static str> {
        let own = self.archive_version;
        if self.typecode & typecode::SHORT != 0 {
            return Ok(());
        }
        let wide = |version: i32| version >= 50;
        if wide(own) != wide(archive) {
            return Err("its chunk lengths are of another width");
        }
        // Layouts changed with version 60, and before version 50 with each.
        let generation = |version: i32| if version >= 60 { 60 } else { version };
        if self.table != Table::Settings && generation(own) != generation(archive) {
            return Err("its layout belongs to another version");
        }
        Ok(())
    }

    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        if self.typecode & typecode::SHORT != 0 {
            w.short(self.typecode, self.value);
            return Ok(());
        }
        w.foreign_chunk(self.typecode, &self.body)
    }
}
