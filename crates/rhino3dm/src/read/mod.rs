//! Reading an archive: header, tables, records (sections 1, 5 and 7).

mod header;
mod records;
mod top;

use std::collections::HashMap;

use crate::chunk::{Chunk, Context, Reader};
use crate::model::Model;
use crate::object::ClassObject;
use crate::version::Version;
use crate::{Error, Limits, Result, class_ids, layer, settings, typecode, v1};

pub(crate) use header::SIGNATURE;
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
    let version = Version { archive, opennurbs: 0 };
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
    reading.place_on_layers();
    Ok(reading.model)
}

/// A model being read.
#[derive(Default)]
struct Reading {
    model: Model,
    /// The number that each layer gives itself, by which attributes refer to it.
    layer_numbers: Vec<i32>,
    /// The layer number of each object and each light.
    object_layers: Vec<i32>,
    light_layers: Vec<i32>,
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
                typecode::NOTES => read_notes(record.body).map(|notes| self.model.notes = notes),
                typecode::APPLICATION => {
                    read_application(record.body).map(|name| self.model.application = name)
                }
                typecode::END_OF_TABLE => break,
                _ => Ok(()),
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
            self.skip(name);
            return Ok(());
        }
        let mut body = table.body;
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
            if let Err(error) = self.read_record(table.typecode, name, record) {
                self.skip(name);
                context.left_out(offset, &format!("a record of the {name} table is"), error);
            }
            context.check()?;
            context.forget(opened);
        }
        Ok(())
    }

    fn read_record(&mut self, table: u32, name: &str, record: Chunk<'_>) -> Result<()> {
        match (table, record.typecode) {
            (typecode::SETTINGS_TABLE, typecode::UNITS) => self.read_units(record),
            // Other settings are views and options, not parts of the model.
            (typecode::SETTINGS_TABLE, _) => Ok(()),
            (typecode::LAYER_TABLE, typecode::LAYER_RECORD) => self.read_layer(record),
            (typecode::OBJECT_TABLE, typecode::OBJECT_RECORD) => {
                let (object, layer) = read_record(record.body, RecordCodes::OBJECT)?;
                self.model.objects.push(object);
                self.object_layers.push(layer);
                Ok(())
            }
            (typecode::LIGHT_TABLE, typecode::LIGHT_RECORD) => {
                let (light, layer) = read_record(record.body, RecordCodes::LIGHT)?;
                self.model.lights.push(light);
                self.light_layers.push(layer);
                Ok(())
            }
            _ => {
                self.skip(name);
                Ok(())
            }
        }
    }

    fn read_units(&mut self, record: Chunk<'_>) -> Result<()> {
        let context = record.body.context();
        let stored = settings::read_units(record.body)?;
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

    fn read_layer(&mut self, record: Chunk<'_>) -> Result<()> {
        const WHAT: &str = "layer";
        let mut body = record.body;
        let object = ClassObject::read(&mut body)?;
        let Some(mut data) = object.data.filter(|_| object.class == class_ids::LAYER) else {
            return Err(Error::malformed(record.offset, WHAT, "the record holds no layer"));
        };
        let (layer, number) = layer::read(&mut data)?;
        self.model.layers.push(layer);
        self.layer_numbers.push(number);
        Ok(())
    }

    /// Turns the layer numbers of objects into places in the list of layers.
    fn place_on_layers(&mut self) {
        let places: HashMap<i32, usize> =
            self.layer_numbers.iter().enumerate().rev().map(|(place, number)| (*number, place)).collect();
        let place = |number: &i32| places.get(number).copied().unwrap_or(0);
        for (object, number) in self.model.objects.iter_mut().zip(&self.object_layers) {
            object.attributes.layer = place(number);
        }
        for (light, number) in self.model.lights.iter_mut().zip(&self.light_layers) {
            light.attributes.layer = place(number);
        }
    }

    fn skip(&mut self, name: &str) {
        *self.model.skipped.entry(name.to_owned()).or_default() += 1;
    }
}

/// Notes: whether HTML, then the text; the window behind it is passed over.
fn read_notes(mut body: Reader<'_>) -> Result<String> {
    const WHAT: &str = "notes";
    body.packed_version(WHAT)?;
    body.i32(WHAT)?;
    body.string(WHAT)
}

fn read_application(mut body: Reader<'_>) -> Result<String> {
    const WHAT: &str = "application";
    body.packed_version(WHAT)?;
    body.string(WHAT)
}
