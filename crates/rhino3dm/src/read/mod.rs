//! Reading an archive: header, tables, records (sections 1, 5 and 7).

mod header;
mod records;
mod tables;
mod top;

use crate::chunk::{Chunk, Context, Reader};
use crate::model::Model;
use crate::places::Places;
use crate::unit_scale::read_units;
use crate::user_table::UserTable;
use crate::version::Version;
use crate::{Error, Limits, Result, properties, typecode, v1};

pub(crate) use header::{SIGNATURE, find as find_header};
pub(crate) use records::RecordCodes;
use records::read_record;
use top::TopChunks;

impl Model {
    /// Reads an archive of version 1, 2, 3, 4, 5, 50, 60, 70 or 80, and of later versions as far as they keep to the
    /// same layout.
    ///
    /// What is broken is left out: [`Model::warnings`] says what and where, [`Model::skipped`] how much of it. An
    /// object that the kernel refuses is kept as bytes with a warning, and so is everything whose checksum does not
    /// fit. [`Model::read_strict`] ends at the first of these instead.
    ///
    /// # Errors
    /// No header, or a version that is not known.
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
        read_whole(bytes, Context::of_archive(limits, bytes.len(), false))
    }

    /// Reads an archive of which nothing is broken. Objects that the kernel refuses although their bytes are whole
    /// are kept as bytes with a warning here, too.
    ///
    /// # Errors
    /// The first broken thing, with its offset, the chunks around it and the reason: no header, an unknown version,
    /// chunks that pass the end of the bytes or a limit, a checksum that does not fit, a record that does not make
    /// sense, no end mark.
    pub fn read_strict(bytes: &[u8], limits: &Limits) -> Result<Self> {
        read_whole(bytes, Context::of_archive(limits, bytes.len(), true))
    }
}

fn read_whole(bytes: &[u8], context: Context) -> Result<Model> {
    let read = read_archive(bytes, &context).and_then(|model| context.check().map(|()| model));
    let mut model = read.map_err(|error| context.with_path(0, error))?;
    model.warnings = context.into_warnings();
    Ok(model)
}

fn read_archive(bytes: &[u8], context: &Context) -> Result<Model> {
    let (start, archive) = header::find(bytes, context)?;
    context.forget(0);
    let version = Version::unstated(archive);
    let file = Reader::new_at(bytes.get(start..).unwrap_or_default(), start, version, context);
    if archive == 1 {
        return v1::read_archive(file, context);
    }
    let mut reading =
        Reading { model: Model { archive_version: archive, ..Model::default() }, ..Reading::default() };
    let mut ended = false;
    let mut chunks = TopChunks::new(file);
    while let Some(chunk) = chunks.next()? {
        match chunk.typecode {
            typecode::END_OF_FILE => {
                ended = true;
                break;
            }
            typecode::COMMENT => {}
            typecode::PROPERTIES_TABLE => {
                let version = reading.read_properties(chunk)?;
                chunks.set_version(version);
            }
            _ => reading.read_table(chunk)?,
        }
    }
    if !ended {
        let why = "the archive ends without an end mark";
        context.left_out(bytes.len(), "what stood behind is", Error::malformed(bytes.len(), "archive", why));
    }
    reading.place();
    Ok(reading.model)
}

/// How many records a table has, by their headers alone, so that a list of them need not grow while it is read. Records
/// too small for any object do not count: nobody shall pay for what they will not become.
fn records(table: &Reader<'_>) -> usize {
    const SMALLEST: usize = 128;
    let most = table.left() / SMALLEST;
    let mut ahead = table.clone();
    let hops = std::iter::from_fn(|| ahead.hop()).take_while(|typecode| *typecode != typecode::END_OF_TABLE);
    hops.take(most).count()
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
            let record = match body.chunk() {
                Ok(record) => record,
                Err(error) => {
                    context.left_out(body.offset(), "the rest of the properties table is", error);
                    break;
                }
            };
            let read = match record.typecode {
                typecode::OPENNURBS_VERSION => {
                    // The low 32 bits, whether the value was stored in 4 bytes or 8.
                    version.opennurbs = u32::try_from(record.value & 0xFFFF_FFFF).unwrap_or_default();
                    self.model.opennurbs_version = version.opennurbs;
                    Ok(())
                }
                typecode::END_OF_TABLE => break,
                _ => properties::read(
                    &record,
                    &mut self.model.properties,
                    &mut self.model.notes,
                    &mut self.model.application,
                )
                .map(|known| {
                    if !known {
                        self.keep(typecode::PROPERTIES_TABLE, &record);
                    }
                }),
            };
            if let Err(error) = read {
                context.left_out(record.offset, "a property", error);
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
                    context.left_out(table.offset, "a user table is", error);
                }
            }
            return Ok(());
        }
        let mut body = table.body;
        if table.typecode == typecode::OBJECT_TABLE {
            self.model.objects.reserve_exact(records(&body));
        }
        while !body.is_at_end() {
            let context = body.context();
            let opened = context.opened();
            // Each table's extent is known, so a broken record costs the rest of its table and no more.
            let record = match body.chunk() {
                Ok(record) => record,
                Err(error) => {
                    self.skip(name);
                    context.left_out(body.offset(), &format!("the rest of the {name} table is"), error);
                    break;
                }
            };
            if record.typecode == typecode::END_OF_TABLE {
                break;
            }
            let offset = record.offset;
            if let Err(error) = self.read_record(table.typecode, &record) {
                self.skip(name);
                context.left_out(offset, &format!("a record of the {name} table is"), error);
            }
            context.check()?;
            context.forget(opened);
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
        let stored = read_units(record.body.clone())?;
        let settings = &mut self.model.settings;
        [settings.length_display, settings.length_digits] = stored.display;
        settings.impossible_tolerances = stored.impossible;
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
