//! Reading an archive: header, tables, records (sections 1, 5 and 7).

mod header;
mod places;
mod records;
mod tables;

use crate::chunk::{Chunk, Context, Reader};
use crate::model::Model;
use crate::user_table::UserTable;
use crate::version::Version;
use crate::{Error, Limits, Result, properties, settings, typecode};

pub(crate) use header::SIGNATURE;
pub(crate) use places::{Numbers, Places};
pub(crate) use records::RecordCodes;
use records::read_record;

impl Model {
    /// Reads an archive of version 2, 3, 4, 5, 50, 60, 70 or 80, and of later versions as far as they keep to the
    /// same layout.
    ///
    /// A record that is broken is left out with a warning, an object that the kernel refuses is kept as bytes with
    /// a warning, and so is everything whose checksum does not fit. Only an archive whose tables cannot be told
    /// apart is an error.
    ///
    /// # Errors
    /// No header, a version that is not read (1 among them), or chunks that pass the end of the bytes or a limit.
    ///
    /// ```
    /// use katydid_3dm::{Layer, Limits, Model, Object};
    /// use katydid_geometry::Point3;
    ///
    /// let mut model = Model::default();
    /// model.layers.push(Layer::new("anchors"));
    /// model.objects.push(Object::Point(Point3::new(1.0, 2.0, 3.0)).into());
    /// let bytes = model.write(70)?;
    /// let back = Model::read(&bytes, &Limits::default())?;
    /// assert_eq!(back.objects[0].geometry, model.objects[0].geometry);
    /// # Ok::<(), katydid_3dm::Error>(())
    /// ```
    pub fn read(bytes: &[u8], limits: &Limits) -> Result<Self> {
        let context = Context::new(limits);
        let mut model = read_archive(bytes, &context)?;
        model.warnings = context.into_warnings();
        Ok(model)
    }
}

fn read_archive(bytes: &[u8], context: &Context) -> Result<Model> {
    let (start, archive) = header::find(bytes, context)?;
    let version = Version { archive, opennurbs: 0 };
    let mut file = Reader::new_at(bytes.get(start..).unwrap_or_default(), start, version, context);
    let mut reading =
        Reading { model: Model { archive_version: archive, ..Model::default() }, ..Reading::default() };
    let mut ended = false;
    while !file.is_at_end() {
        let chunk = file.chunk()?;
        match chunk.typecode {
            typecode::END_OF_FILE => {
                ended = true;
                break;
            }
            typecode::COMMENT => {}
            typecode::PROPERTIES_TABLE => {
                let version = reading.read_properties(chunk)?;
                file.set_version(version);
            }
            _ => reading.read_table(chunk)?,
        }
    }
    if !ended {
        context.warn(file.offset(), "the archive has no end mark");
    }
    reading.place();
    Ok(reading.model)
}

/// A model being read.
#[derive(Default)]
struct Reading {
    model: Model,
    /// The numbers by which entries of tables are referred to.
    places: Places,
}

impl Reading {
    /// The properties table; gives the version under which all that follows was written.
    fn read_properties(&mut self, table: Chunk<'_>) -> Result<Version> {
        let mut body = table.body;
        let mut version = body.version();
        while !body.is_at_end() {
            let context = body.context();
            let record = body.chunk()?;
            let read = match record.typecode {
                typecode::OPENNURBS_VERSION => {
                    // The low 32 bits, whether the value was stored in 4 bytes or 8.
                    version.opennurbs = u32::try_from(record.value & 0xFFFF_FFFF).unwrap_or_default();
                    self.model.opennurbs_version = version.opennurbs;
                    Ok(())
                }
                typecode::END_OF_TABLE => break,
                _ => properties::read(&record, &mut self.model).map(|known| {
                    if !known {
                        self.keep(typecode::PROPERTIES_TABLE, &record);
                    }
                }),
            };
            if let Err(error) = read {
                context.warn(record.offset, format!("a property left out: {error}"));
            }
        }
        Ok(version)
    }

    /// Any other table, record after record.
    fn read_table(&mut self, table: Chunk<'_>) -> Result<()> {
        let Some(name) = typecode::table_name(table.typecode) else {
            self.skip("unknown");
            return Ok(());
        };
        if table.typecode == typecode::USER_TABLE {
            let context = table.body.context();
            match UserTable::read(table.body) {
                Ok(read) => self.model.user_tables.push(read),
                Err(error) => {
                    self.skip(name);
                    context.warn(table.offset, format!("a user table is left out: {error}"));
                }
            }
            return Ok(());
        }
        let mut body = table.body;
        while !body.is_at_end() {
            let context = body.context();
            // Each table's extent is known, so a broken record costs the rest of its table and no more.
            let record = match body.chunk() {
                Ok(record) => record,
                Err(error @ Error::TooDeep { .. }) => return Err(error),
                Err(error) => {
                    context.warn(body.offset(), format!("the rest of the {name} table is left out: {error}"));
                    break;
                }
            };
            if record.typecode == typecode::END_OF_TABLE {
                break;
            }
            let offset = record.offset;
            if let Err(error) = self.read_record(table.typecode, &record) {
                self.skip(name);
                context.warn(offset, format!("a record of the {name} table is left out: {error}"));
            }
        }
        Ok(())
    }

    fn read_record(&mut self, table: u32, record: &Chunk<'_>) -> Result<()> {
        match (table, record.typecode) {
            (typecode::SETTINGS_TABLE, typecode::UNITS) => self.read_units(record),
            (typecode::SETTINGS_TABLE, _) => {
                if !self.model.settings.read(record)? {
                    self.keep(table, record);
                }
                Ok(())
            }
            (typecode::OBJECT_TABLE, typecode::OBJECT_RECORD) => {
                self.model.objects.push(read_record(record.body.clone(), RecordCodes::OBJECT)?);
                Ok(())
            }
            (typecode::LIGHT_TABLE, typecode::LIGHT_RECORD) => {
                self.model.lights.push(read_record(record.body.clone(), RecordCodes::LIGHT)?);
                Ok(())
            }
            _ => self.read_entry_record(table, record),
        }
    }

    fn read_units(&mut self, record: &Chunk<'_>) -> Result<()> {
        let context = record.body.context();
        let stored = settings::read_units(record.body.clone())?;
        let settings = &mut self.model.settings;
        [settings.length_display, settings.length_digits] = stored.display;
        self.model.units = stored.units;
        self.model.tolerance = stored.tolerance;
        self.model.relative_tolerance = stored.relative_tolerance;
        if let Some(scale) = &stored.scale {
            context.warn(
                record.offset,
                format!("the unit is {} ({} m), which is treated as no unit", scale.name, scale.metres),
            );
        }
        self.model.unit_scale = stored.scale;
        Ok(())
    }

    fn skip(&mut self, name: &str) {
        *self.model.skipped.entry(name.to_owned()).or_default() += 1;
    }
}
