//! Records that are carried along byte for byte.

use std::borrow::Cow;

use crate::chunk::{Chunk, Context, Reader, Writer};
use crate::class_object::ClassObject;
use crate::earth::say_unset;
use crate::recode::recode;
use crate::version::Version;
use crate::{Limits, Result, typecode};

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

/// Why a record is left out whose chunks could not be told.
const WIDTH: &str = "its chunk lengths are of another width";

impl KeptRecord {
    /// The record as it stands in an archive.
    pub(crate) fn of(table: Table, record: &Chunk<'_>) -> Self {
        let version = record.body.version();
        Self {
            table,
            typecode: record.typecode,
            value: record.value,
            body: record.whole.to_vec(),
            archive_version: version.archive,
            opennurbs_version: version.opennurbs,
        }
    }

    /// The record that was written as the only chunk.
    pub(crate) fn of_chunk(table: Table, typecode: u32, written: Writer) -> Self {
        let version = written.version();
        let body = written.into_bytes().split_off(if version.is_wide() { 12 } else { 8 });
        Self {
            table,
            typecode,
            value: i64::try_from(body.len()).unwrap_or(i64::MAX),
            body,
            archive_version: version.archive,
            opennurbs_version: version.opennurbs,
        }
    }

    /// What the record is, in words.
    pub fn name(&self) -> String {
        typecode::record_name(self.typecode).map_or_else(
            || format!("record {:08X} of the {} table", self.typecode, self.table.name()),
            str::to_owned,
        )
    }

    /// The body for an archive of the given version, or why it cannot stand there.
    pub(crate) fn body_for(&self, version: Version) -> std::result::Result<Cow<'_, [u8]>, &'static str> {
        if self.typecode & typecode::SHORT != 0 {
            return Ok(Cow::Borrowed(&[]));
        }
        // Class objects changed their layouts with version 60. Settings, images and mappings say their versions
        // themselves, styles of before are another class, which readers of today turn into that of today, and the
        // layout of history has only grown.
        let new = |archive: i32| archive >= 60;
        let says_itself = match self.table {
            Table::Settings | Table::Bitmaps | Table::TextureMappings => true,
            Table::TextStyles | Table::DimensionStyles | Table::History => !new(self.archive_version),
            _ => false,
        };
        if !says_itself && new(self.archive_version) != new(version.archive) {
            return Err("its layout belongs to another version");
        }
        let own = Version { archive: self.archive_version, opennurbs: self.opennurbs_version };
        if self.typecode == typecode::SETTINGS_ATTRIBUTES && !new(own.archive) && new(version.archive) {
            let mut body = recode(self.typecode, &self.body, own, version).ok_or(WIDTH)?;
            say_unset(&mut body, version);
            return Ok(Cow::Owned(body));
        }
        if own.is_wide() == version.is_wide() {
            return Ok(Cow::Borrowed(&self.body));
        }
        let recoded = recode(self.typecode, &self.body, own, version);
        recoded.map(Cow::Owned).ok_or(WIDTH)
    }

    /// Writes the record if it can stand in the archive.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        if self.typecode & typecode::SHORT != 0 {
            w.short(self.typecode, self.value);
            return Ok(());
        }
        match self.body_for(w.version()) {
            Ok(body) => w.foreign_chunk(self.typecode, &body),
            Err(_) => Ok(()),
        }
    }
}

impl KeptRecord {
    /// Runs `read` over the class object that the record holds.
    pub(crate) fn with_class<T>(&self, read: impl FnOnce(&ClassObject<'_>) -> Result<T>) -> Result<T> {
        self.with_body(|body| read(&ClassObject::read(body)?))
    }

    /// Runs `read` over the body, its CRC left out.
    pub(crate) fn with_body<T>(&self, read: impl FnOnce(&mut Reader<'_>) -> Result<T>) -> Result<T> {
        self.with_body_in(&Context::new(&Limits::default()), read)
    }

    /// The same with limits and warnings of the caller's.
    pub(crate) fn with_body_in<T>(
        &self,
        context: &Context,
        read: impl FnOnce(&mut Reader<'_>) -> Result<T>,
    ) -> Result<T> {
        let version = Version { archive: self.archive_version, opennurbs: self.opennurbs_version };
        let body = self.body.split_last_chunk::<4>().map_or(&[] as &[u8], |(body, _)| body);
        read(&mut Reader::new(body, version, context))
    }
}
