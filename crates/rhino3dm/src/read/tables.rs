//! Reading the tables of entries: each record typed, or kept where that fails.

use super::Reading;
use crate::chunk::Chunk;
use crate::places::Numbers;
use crate::tables::{Entry, KeptRecord, Table, read_entry};
use crate::{Result, typecode};

/// Reads an entry into its list and notes it.
fn push<T: Entry>(record: &Chunk<'_>, list: &mut Vec<T>, numbers: &mut Numbers) -> Result<()> {
    match read_entry(&mut record.body.clone()) {
        Ok(entry) => {
            list.push(entry);
            numbers.push();
            Ok(())
        }
        Err(error) => {
            numbers.skip();
            Err(error)
        }
    }
}

impl Reading {
    /// Takes a record of any table but those of objects and lights.
    pub(super) fn read_entry_record(&mut self, table: u32, record: &Chunk<'_>) -> Result<()> {
        // Blocks are referred to by their identifiers.
        let mut unused = Numbers::default();
        let (model, places) = (&mut self.model, &mut self.places);
        let read = match (table, record.typecode) {
            (typecode::LAYER_TABLE, typecode::LAYER_RECORD) => {
                push(record, &mut model.layers, &mut places.layers)
            }
            (typecode::MATERIAL_TABLE, typecode::MATERIAL_RECORD) => {
                push(record, &mut model.materials, &mut places.materials)
            }
            (typecode::LINETYPE_TABLE, typecode::LINETYPE_RECORD) => {
                push(record, &mut model.linetypes, &mut places.linetypes)
            }
            (typecode::GROUP_TABLE, typecode::GROUP_RECORD) => {
                push(record, &mut model.groups, &mut places.groups)
            }
            (typecode::HATCH_PATTERN_TABLE, typecode::HATCH_PATTERN_RECORD) => {
                push(record, &mut model.hatch_patterns, &mut places.hatch_patterns)
            }
            (typecode::INSTANCE_DEFINITION_TABLE, typecode::INSTANCE_DEFINITION_RECORD) => {
                push(record, &mut model.blocks, &mut unused)
            }
            _ => {
                self.keep(table, record);
                return Ok(());
            }
        };
        // A layer that cannot be read leaves its objects without; others are carried along unread.
        if let Err(error) = read {
            if table == typecode::LAYER_TABLE {
                return Err(error);
            }
            let context = record.body.context();
            context.kept(record.offset, "a record", error);
            self.keep(table, record);
        }
        Ok(())
    }

    /// Keeps a record byte for byte.
    pub(super) fn keep(&mut self, table: u32, record: &Chunk<'_>) {
        let Some(table) = Table::from_typecode(table) else { return };
        self.model.kept.push(KeptRecord::of(table, record));
    }

    /// Turns the numbers by which layers, objects and lights refer to entries of tables into places.
    pub(super) fn place(&mut self) {
        let (model, places) = (&mut self.model, &self.places);
        model.layers.iter_mut().for_each(|layer| layer.place(places));
        for object in model.objects.iter_mut().chain(&mut model.lights) {
            object.attributes.place(places);
            object.geometry.place(places);
        }
        model.settings.place(places);
    }
}
