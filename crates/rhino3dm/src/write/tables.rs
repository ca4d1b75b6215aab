//! The tables of an archive in their order: typed entries first, then the records that are kept.

use std::borrow::Cow;

use uuid::Uuid;

use super::records::Records;
use crate::chunk::Writer;
use crate::ids::Ids;
use crate::model::Model;
use crate::styles::Styles;
use crate::tables::{Entry, Named, Table, write_entry};
use crate::unit_scale::{StoredUnits, write_units};
use crate::{Error, Layer, Result, properties, typecode};

impl Model {
    pub(super) fn write_tables(&self, w: &mut Writer) -> Result<()> {
        let styles = Styles::of(&self.kept, self.unit(), w.version());
        self.table(w, Table::Properties, |w| {
            w.short(typecode::OPENNURBS_VERSION, i64::from(w.version().opennurbs));
            properties::write(&self.properties, &self.notes, &self.application, self.archive_version == 0, w)
        })?;
        self.table(w, Table::Settings, |w| self.write_settings(w))?;
        self.table(w, Table::Bitmaps, |_| Ok(()))?;
        self.table(w, Table::TextureMappings, |_| Ok(()))?;
        self.table(w, Table::Materials, |w| entries(&self.materials, typecode::MATERIAL_RECORD, w))?;
        self.table(w, Table::Linetypes, |w| entries(&self.linetypes, typecode::LINETYPE_RECORD, w))?;
        let layers = self.layers_to_write();
        self.table(w, Table::Layers, |w| entries(&layers, typecode::LAYER_RECORD, w))?;
        self.table(w, Table::Groups, |w| entries(&self.groups, typecode::GROUP_RECORD, w))?;
        // Without this table, empty as it may be, readers pass over the dimension styles behind it.
        if styles.replaces(Table::DimensionStyles) {
            only(w, Table::TextStyles, |w| styles.write_text_styles(w))?;
            only(w, Table::DimensionStyles, |w| styles.write_dimension_styles(w))?;
        } else {
            self.table(w, Table::TextStyles, |_| Ok(()))?;
            self.table(w, Table::DimensionStyles, |_| Ok(()))?;
        }
        // Identifiers are unique over lights and objects together.
        let all: Vec<Uuid> = self.lights.iter().chain(&self.objects).map(|o| o.attributes.id).collect();
        let ids = Ids::of(all.into_iter());
        let records =
            |typecode, first| Records { typecode, styles: &styles, layers: layers.len(), ids: &ids, first };
        self.table(w, Table::Lights, |w| records(typecode::LIGHT_RECORD, 0).write(&self.lights, w))?;
        self.table(w, Table::HatchPatterns, |w| {
            entries(&self.hatch_patterns, typecode::HATCH_PATTERN_RECORD, w)
        })?;
        self.table(w, Table::Blocks, |w| entries(&self.blocks, typecode::INSTANCE_DEFINITION_RECORD, w))?;
        let objects = records(typecode::OBJECT_RECORD, self.lights.len());
        self.table(w, Table::Objects, |w| objects.write(&self.objects, w))?;
        self.table(w, Table::History, |_| Ok(()))?;
        self.user_tables.iter().try_for_each(|table| table.write(w))
    }

    /// A table: what `records` writes, the records that are kept, and its end mark.
    fn table(
        &self,
        w: &mut Writer,
        table: Table,
        records: impl FnOnce(&mut Writer) -> Result<()>,
    ) -> Result<()> {
        only(w, table, |w| {
            records(w)?;
            let mut kept = self.kept.iter().filter(|record| record.table == table);
            kept.try_for_each(|record| record.write(w))
        })
    }

    fn write_settings(&self, w: &mut Writer) -> Result<()> {
        w.chunk(typecode::UNITS, |w| {
            let stored = StoredUnits {
                units: self.units,
                scale: self.unit_scale.clone(),
                tolerance: self.tolerance,
                relative_tolerance: self.relative_tolerance,
                display: [self.settings.length_display, self.settings.length_digits],
                impossible: self.settings.impossible_tolerances,
            };
            write_units(&stored, w)
        })?;
        self.settings.write(w)
    }

    fn layers_to_write(&self) -> Cow<'_, [Layer]> {
        if self.layers.is_empty() { vec![Layer::new("Default")].into() } else { (&self.layers).into() }
    }
}

/// A table: what `records` writes, and its end mark.
fn only(w: &mut Writer, table: Table, records: impl FnOnce(&mut Writer) -> Result<()>) -> Result<()> {
    w.chunk(table.typecode(), |w| {
        records(w)?;
        w.short(typecode::END_OF_TABLE, 0);
        Ok(())
    })
}

/// The records of entries, each numbered by its place.
fn entries<T: Entry>(entries: &[T], record: u32, w: &mut Writer) -> Result<()> {
    let ids = Ids::of(entries.iter().map(Named::id));
    for (place, entry) in entries.iter().enumerate() {
        let number = i32::try_from(place).map_err(|_| Error::CannotWrite {
            what: format!("a table with {} entries", entries.len()),
            version: w.version().archive,
            why: "counts end at 2147483647".into(),
        })?;
        let id = ids.get(place, entry.name().as_bytes());
        w.chunk(record, |w| write_entry(entry, number, id, w))?;
    }
    Ok(())
}
