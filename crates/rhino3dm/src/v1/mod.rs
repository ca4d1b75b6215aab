//! Archives of version 1 (section 11): chunks in the order of the file, without tables.
//!
//! Chunk lengths take 4 bytes. Chunks of the old modeller's geometry end in a CRC-16. Objects are restated as
//! class objects of a later version, so that what is read of those is read of these.

mod annotation;
mod attributes;
mod brep;
mod curve;
mod light;
mod mesh;
mod restate;
mod settings;
mod spline;
mod text;
mod toolkit;
mod typecode;
mod view;

use katydid_geometry::Point3;

pub(crate) use self::typecode::may_precede_tables;

use self::annotation::{Annotation, is_annotation};
use self::attributes::{Extra, Stated};
use self::light::Spotlight;
use self::mesh::PackedMesh;
use self::typecode as code;
use self::view::Views;
use crate::chunk::{Chunk, Context, Reader, Writer};
use crate::model::{Model, ModelObject};
use crate::object::Object;
use crate::{Attributes, Result, SurfaceForm, class_ids, typecode as common};

/// What openNURBS writes where a number was never set.
const UNSET: f64 = -1.234_321_012_343_21e308;
/// Height and font of the text dots that those of version 1 become.
const DOT_HEIGHT: i32 = 14;
const DOT_FONT: &str = "Arial";

/// Reads the chunks behind the header.
pub(crate) fn read_archive(mut file: Reader<'_>, context: &Context) -> Result<Model> {
    let mut reading =
        Reading { model: Model { archive_version: 1, ..Model::default() }, views: Views::default() };
    while file.left() >= 8 {
        let offset = file.offset();
        let chunk = match file.chunk() {
            Ok(chunk) => chunk,
            Err(error) => {
                context.left_out(offset, "the rest of the archive is", error);
                break;
            }
        };
        // Some marks of the end were written back by programs that did not know them.
        if chunk.typecode == common::END_OF_FILE && file.is_at_end() {
            break;
        }
        let typecode = chunk.typecode;
        if let Err(error) = reading.read_chunk(chunk, &mut file) {
            reading.skip(kind_name(typecode));
            context.left_out(offset, &format!("a {} is", kind_name(typecode)), error);
        }
        context.check()?;
        context.forget(0);
    }
    reading.check_layers();
    reading.model.kept = reading.views.into_records()?;
    Ok(reading.model)
}

/// A model being read.
struct Reading {
    model: Model,
    views: Views,
}

impl Reading {
    fn read_chunk(&mut self, chunk: Chunk<'_>, file: &mut Reader<'_>) -> Result<()> {
        let mut body = chunk.body;
        match chunk.typecode {
            common::COMMENT => settings::read_comment(body.rest(), &mut self.model),
            code::SUMMARY => settings::read_summary(body, &mut self.model)?,
            code::PREVIEW => settings::read_preview(body, &mut self.model)?,
            code::NOTES => settings::read_notes(body, &mut self.model)?,
            code::UNITS => settings::read_units(body, &mut self.model)?,
            code::VIEWPORT | code::NAMED_VIEW | code::NAMED_PLANE => {
                self.views.take(chunk.typecode, &mut body)?
            }
            code::LAYER => self.model.layers.push(settings::read_layer(body)?),
            // Some points with arrows state a length of zero: what belongs to them follows.
            code::POINT if chunk.value == 0 => self.read_point(chunk.offset, file)?,
            code::POINT => self.read_point(chunk.offset, &mut body)?,
            code::SPOTLIGHT => self.read_light(chunk.offset, &mut body)?,
            code::ROGUE_END => {}
            typecode if is_annotation(typecode) => self.read_annotation(typecode, chunk.offset, &mut body)?,
            typecode => self.read_geometry(typecode, chunk.offset, &mut body)?,
        }
        Ok(())
    }

    /// Objects whose attributes stand beside the chunk of their geometry.
    fn read_geometry(&mut self, typecode: u32, offset: usize, body: &mut Reader<'_>) -> Result<()> {
        let context = body.context();
        let (geometry, stated) = match typecode {
            code::CURVE => {
                let (stated, mut body) = with_substance(body, typecode)?;
                let curve = curve::read_substance(&mut body)?;
                body.finish();
                (curve.into(), stated)
            }
            code::FACE | code::SHELL => {
                let (stated, mut body) = with_substance(body, typecode)?;
                let read = if typecode == code::FACE { brep::read_face } else { brep::read_shell };
                let brep = read(&mut body)?;
                body.finish();
                (Object::Brep(Box::new(brep)), stated)
            }
            code::MESH => {
                let mesh = PackedMesh::read(body)?;
                let stated = Stated::read(body, None)?;
                (restate::object(class_ids::MESH, offset, context, |w| mesh.write(w))?, stated)
            }
            code::TOOLKIT_CURVE => {
                (spline::read_toolkit_curve(body)?.into(), Stated::read(body, Some(code::TOOLKIT_END))?)
            }
            code::TOOLKIT_SURFACE => {
                let surface = SurfaceForm::Nurbs(spline::read_toolkit_surface(body)?);
                (surface.into(), Stated::read(body, Some(code::TOOLKIT_END))?)
            }
            code::TOOLKIT_BREP => {
                let brep = Object::Brep(Box::new(toolkit::read_brep(body)?));
                (brep, Stated::read(body, Some(code::TOOLKIT_END))?)
            }
            _ => return Ok(()),
        };
        self.push(geometry, stated);
        Ok(())
    }

    fn read_point(&mut self, offset: usize, body: &mut Reader<'_>) -> Result<()> {
        let context = body.context();
        let point = body.point("point")?;
        let stated = Stated::read(body, None)?;
        let geometry = match &stated.extra {
            Some(Extra::Arrow(vector)) if vector.length() > 1e-12 => {
                let end = point + *vector;
                let write = |w: &mut Writer| write_line(w, point, end);
                restate::object(class_ids::LINE_CURVE, offset, context, write)?
            }
            Some(Extra::Dot(text)) => {
                restate::object(class_ids::TEXT_DOT, offset, context, |w| write_dot(w, point, text))?
            }
            _ => restate::object(class_ids::POINT, offset, context, |w| {
                w.packed_version(1, 0);
                w.point(point);
                Ok(())
            })?,
        };
        self.push(geometry, stated);
        Ok(())
    }

    fn read_light(&mut self, offset: usize, body: &mut Reader<'_>) -> Result<()> {
        let light = Spotlight::read(body)?;
        let stated = Stated::read(body, None)?;
        let diffuse = stated.material.as_ref().map(|material| material.diffuse);
        let index = self.model.lights.len();
        let geometry = restate::object(class_ids::LIGHT, offset, body.context(), |w| {
            light.write(diffuse, stated.attributes.id, index, w)
        })?;
        // A light's material is its colour and no material of the model.
        self.model.lights.push(with_attributes(geometry, stated.attributes));
        Ok(())
    }

    fn read_annotation(&mut self, typecode: u32, offset: usize, body: &mut Reader<'_>) -> Result<()> {
        let Some(annotation) = Annotation::read(typecode, body)? else { return Ok(()) };
        let stated = Stated::read(body, None)?;
        let context = body.context();
        let geometry = restate::object(annotation.class(), offset, context, |w| annotation.write(w))?;
        self.push(geometry, stated);
        Ok(())
    }

    /// Adds an object, and its material to those of the model.
    fn push(&mut self, geometry: Object, mut stated: Stated) {
        if let Some(material) = stated.material {
            stated.attributes.material = Some(self.model.materials.len());
            self.model.materials.push(material);
        }
        self.model.objects.push(with_attributes(geometry, stated.attributes));
    }

    /// Puts objects on layers that are not there on the first.
    fn check_layers(&mut self) {
        let count = self.model.layers.len();
        for object in self.model.objects.iter_mut().chain(&mut self.model.lights) {
            let layer = object.attributes.layer.filter(|layer| *layer < count);
            object.attributes.layer = layer.or((count > 0).then_some(0));
        }
    }

    fn skip(&mut self, name: &str) {
        *self.model.skipped.entry(name.to_owned()).or_default() += 1;
    }
}

/// The attributes before the substance of an object, and the substance.
fn with_substance<'a>(body: &mut Reader<'a>, kind: u32) -> Result<(Stated, Reader<'a>)> {
    let stated = Stated::read(body, Some(kind | code::SUBSTANCE))?;
    Ok((stated, spline::substance(body, kind, kind_name(kind))?))
}

fn with_attributes(geometry: Object, attributes: Attributes) -> ModelObject {
    ModelObject { attributes, ..geometry.into() }
}

/// The body of a line over its length.
fn write_line(w: &mut Writer, start: Point3, end: Point3) -> Result<()> {
    w.packed_version(1, 0);
    w.point(start);
    w.point(end);
    w.f64(0.0);
    w.f64((end - start).length());
    w.i32(3);
    Ok(())
}

/// The body of a text dot. Without text it has a blank.
fn write_dot(w: &mut Writer, point: Point3, text: &str) -> Result<()> {
    w.packed_version(1, 0);
    w.point(point);
    w.i32(DOT_HEIGHT);
    w.string(if text.is_empty() { " " } else { text })?;
    w.string(DOT_FONT)?;
    w.i32(0);
    Ok(())
}

/// A kind of chunk in words, for messages.
fn kind_name(typecode: u32) -> &'static str {
    match typecode {
        code::LAYER => "layer",
        code::NOTES => "note",
        code::SUMMARY => "summary",
        code::PREVIEW => "preview",
        code::UNITS => "unit",
        code::VIEWPORT | code::NAMED_VIEW => "view",
        code::NAMED_PLANE => "construction plane",
        code::POINT => "point",
        code::MESH => "mesh",
        code::SPOTLIGHT => "light",
        code::CURVE | code::TOOLKIT_CURVE => "curve",
        code::FACE | code::SHELL | code::TOOLKIT_BREP => "brep",
        code::TOOLKIT_SURFACE => "surface",
        typecode if is_annotation(typecode) => "annotation",
        _ => "chunk",
    }
}
