//! Texture mappings: how images lie on objects (section 5).

use katydid_geometry::Xform;
use uuid::{Uuid, uuid};

use crate::Result;
use crate::class_object::ClassObject;
use crate::object::Object;

/// How images lie on objects: from a point on the object to a place in the image.
#[derive(Debug, Clone, PartialEq)]
pub struct TextureMapping {
    /// The identifier, by which rendering attributes name it.
    pub id: Uuid,
    /// The name.
    pub name: String,
    /// The form that the image is wrapped round.
    pub kind: MappingKind,
    /// How points come onto the form, by its number in archives: 0 not set, 1 to the closest point, 2 along the
    /// normal.
    pub projection: i32,
    /// From the world to the space in which the form has its standard size.
    pub transform: Xform,
    /// From places on the form to places in the image.
    pub image_transform: Xform,
    /// The mesh, surface or brep that the image is wrapped round, of kinds that have one.
    pub primitive: Option<Box<Object>>,
    /// Whether the sides of a form divide the image between them, by its number in archives: 0 each has the whole,
    /// 1 they divide it.
    pub texture_space: i32,
    /// Whether cylinders and boxes have caps.
    pub capped: bool,
}

/// The form that an image is wrapped round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the names say it")]
pub enum MappingKind {
    None,
    SurfaceParameters,
    Plane,
    Cylinder,
    Sphere,
    Box,
    Mesh,
    Surface,
    Brep,
    /// The frame of the object.
    ObjectFrame,
    /// Another one, by its number in archives.
    Other(i32),
}

const WHAT: &str = "texture mapping";
const CLASS: Uuid = uuid!("32EC997A-C3BF-4AE5-AB19-FD572B8AD554");
/// What programs of old stored for the mapping by surface parameters, which has no identifier now.
const OBSOLETE: Uuid = uuid!("B988A6C2-61A6-45A7-AAEE-9AED7EF4E316");

impl MappingKind {
    fn from_number(number: i32) -> Self {
        match number {
            0 => Self::None,
            1 => Self::SurfaceParameters,
            2 => Self::Plane,
            3 => Self::Cylinder,
            4 => Self::Sphere,
            5 => Self::Box,
            6 => Self::Mesh,
            7 => Self::Surface,
            8 => Self::Brep,
            9 => Self::ObjectFrame,
            other => Self::Other(other),
        }
    }
}

impl TextureMapping {
    pub(crate) fn read(object: &ClassObject<'_>) -> Result<Option<Self>> {
        let Some(mut body) = object.data.clone().filter(|_| object.class == CLASS) else { return Ok(None) };
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let id = chunk.uuid(WHAT)?;
        let mut mapping = Self {
            id: if id == OBSOLETE { Uuid::nil() } else { id },
            kind: MappingKind::from_number(chunk.i32(WHAT)?),
            projection: chunk.i32(WHAT)?,
            transform: chunk.matrix(WHAT)?,
            image_transform: chunk.matrix(WHAT)?,
            name: chunk.string(WHAT)?,
            primitive: None,
            texture_space: 0,
            capped: false,
        };
        let primitive = ClassObject::read(&mut chunk)?;
        if !primitive.class.is_nil() {
            let object = Object::from_class(&primitive).unwrap_or_else(|_| Object::Kept(primitive.to_raw()));
            mapping.primitive = Some(Box::new(object));
        }
        if minor >= 1 {
            mapping.texture_space = chunk.i32(WHAT)?;
            mapping.capped = chunk.bool(WHAT)?;
        }
        Ok(Some(mapping))
    }
}

#[cfg(test)]
mod tests {
    use katydid_geometry::Point3;

    use super::*;
    use crate::chunk::Writer;
    use crate::class_object::{write_class, write_null};
    use crate::tables::{KeptRecord, Table};
    use crate::version::Version;
    use crate::{Limits, Model, typecode};

    fn write_mapping(w: &mut Writer, minor: i32, primitive: Option<Point3>) -> Result<()> {
        w.versioned(1, minor, |w| {
            w.uuid(Uuid::from_u128(1));
            [5, 2].iter().for_each(|number| w.i32(*number));
            let mut scale = Xform::IDENTITY;
            scale.rows[0][0] = 3.0;
            w.matrix(&scale);
            w.matrix(&Xform::IDENTITY);
            w.string("Kiste")?;
            match primitive {
                Some(point) => Object::Point(point).write(w, &[])?,
                None => write_null(w)?,
            }
            if minor >= 1 {
                w.i32(1);
                w.bool(true);
            }
            Ok(())
        })
    }

    #[test]
    fn mappings_are_read_with_and_without_a_primitive() {
        for (minor, primitive) in [(0, None), (1, None), (1, Some(Point3::new(1.0, 2.0, 3.0)))] {
            let mut w = Writer::new(Version::for_writing(50).unwrap());
            let record = |w: &mut Writer| write_class(w, CLASS, &[], |w| write_mapping(w, minor, primitive));
            w.chunk(typecode::TEXTURE_MAPPING_RECORD, record).unwrap();
            let record = KeptRecord::of_chunk(Table::TextureMappings, typecode::TEXTURE_MAPPING_RECORD, w);
            let model = Model { kept: vec![record], ..Model::default() };
            for version in [4, 50, 80] {
                let back = Model::read(&model.write(version).unwrap(), &Limits::default()).unwrap();
                let mappings = back.texture_mappings();
                let mapping = &mappings[0];
                assert_eq!((mapping.id, mapping.name.as_str()), (Uuid::from_u128(1), "Kiste"));
                assert_eq!((mapping.kind, mapping.projection), (MappingKind::Box, 2));
                assert_eq!((mapping.texture_space, mapping.capped), (minor, minor == 1));
                assert!(mapping.transform.rows[0][0] > 2.0);
                let expected = primitive.map(|point| Box::new(Object::Point(point)));
                assert_eq!(mapping.primitive, expected, "{minor} {version}");
            }
        }
    }
}
