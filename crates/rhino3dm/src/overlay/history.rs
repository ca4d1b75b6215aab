//! History records: how an object came about (section 5).

use katydid_geometry::{Point3, Vector3, Xform};
use uuid::{Uuid, uuid};

use crate::chunk::Reader;
use crate::class_object::ClassObject;
use crate::object::RawObject;
use crate::values::{read_colour, read_ids};
use crate::{Error, Result, typecode};

/// How objects came about: a command, what it took, and what it made.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryRecord {
    /// The identifier of the record.
    pub id: Uuid,
    /// The version of the command's own data.
    pub version: i32,
    /// The command.
    pub command: Uuid,
    /// The objects it made.
    pub descendants: Vec<Uuid>,
    /// The objects it took.
    pub antecedents: Vec<Uuid>,
    /// What the command keeps of its input.
    pub values: Vec<HistoryValue>,
    /// Whether the values are those of a feature of the object, not those of a command.
    pub is_feature: bool,
    /// Whether the record goes with an object that takes the place of the one it made.
    pub copy_on_replace: bool,
}

/// Something that a command keeps of its input, under a number of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryValue {
    /// By which the command knows it.
    pub id: i32,
    /// What it is.
    pub values: HistoryValues,
}

/// Values of one kind.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the names say it")]
pub enum HistoryValues {
    Booleans(Vec<bool>),
    Integers(Vec<i32>),
    Numbers(Vec<f64>),
    /// Red, green, blue, alpha.
    Colours(Vec<[u8; 4]>),
    Points(Vec<Point3>),
    Vectors(Vec<Vector3>),
    Transforms(Vec<Xform>),
    Texts(Vec<String>),
    Objects(Vec<ObjectReference>),
    Geometry(Vec<RawObject>),
    Ids(Vec<Uuid>),
    /// A kind that is not taken apart, by its number in archives: chains of edges, mostly.
    Other(i32),
}

/// An object of the model or a part of one, and where on it somebody picked.
#[derive(Debug, Clone, PartialEq)]
pub struct ObjectReference {
    /// The object.
    pub object: Uuid,
    /// The part: its kind and its place among the parts of that kind, by their numbers in archives.
    pub component: [i32; 2],
    /// What the part is, as Rhino's filters number it.
    pub geometry_type: i32,
    /// Where it was picked.
    pub point: Point3,
}

const WHAT: &str = "history record";
const CLASS: Uuid = uuid!("ECD0FD2F-2088-49DC-9641-9CF7A28FFA6B");
const FEATURE: i32 = 1;

impl HistoryRecord {
    pub(crate) fn read(object: &ClassObject<'_>) -> Result<Option<Self>> {
        let Some(mut body) = object.data.clone().filter(|_| object.class == CLASS) else { return Ok(None) };
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let mut record = Self {
            id: chunk.uuid(WHAT)?,
            version: chunk.i32(WHAT)?,
            command: chunk.uuid(WHAT)?,
            descendants: chunk.id_list(WHAT)?,
            antecedents: chunk.id_list(WHAT)?,
            values: Vec::new(),
            is_feature: false,
            copy_on_replace: false,
        };
        let (mut values, _) = chunk.versioned_1(WHAT)?;
        let count = values.count(20, WHAT)?;
        record.values = (0..count).map(|_| HistoryValue::read(&mut values)).collect::<Result<_>>()?;
        if minor >= 1 {
            record.is_feature = chunk.i32(WHAT)? == FEATURE;
        }
        if minor >= 2 {
            record.copy_on_replace = chunk.bool(WHAT)?;
        }
        Ok(Some(record))
    }
}

impl HistoryValue {
    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, _) = body.versioned_1(WHAT)?;
        let kind = chunk.i32(WHAT)?;
        Ok(Self { id: chunk.i32(WHAT)?, values: HistoryValues::read(kind, &mut chunk)? })
    }
}

impl HistoryValues {
    fn read(kind: i32, body: &mut Reader<'_>) -> Result<Self> {
        Ok(match kind {
            1 => Self::Booleans(list(body, 1, |body| body.bool(WHAT))?),
            2 => Self::Integers(body.ints(WHAT)?),
            3 => Self::Numbers(body.doubles(WHAT)?),
            4 => Self::Colours(list(body, 4, |body| read_colour(body, WHAT))?),
            5 => Self::Points(body.points(WHAT)?),
            6 => Self::Vectors(list(body, 24, |body| body.vector(WHAT))?),
            7 => Self::Transforms(list(body, 128, |body| body.matrix(WHAT))?),
            8 => Self::Texts(list(body, 4, |body| body.string(WHAT))?),
            9 => Self::Objects(list(body, 20, ObjectReference::read)?),
            10 => {
                let (mut objects, _) = body.versioned_1(WHAT)?;
                Self::Geometry(list(&mut objects, 16, |body| Ok(ClassObject::read(body)?.to_raw()))?)
            }
            11 => Self::Ids(read_ids(body, WHAT)?),
            other => Self::Other(other),
        })
    }
}

/// Items of at least `least` bytes each behind their count.
fn list<T>(
    body: &mut Reader<'_>,
    least: usize,
    read: impl Fn(&mut Reader<'_>) -> Result<T>,
) -> Result<Vec<T>> {
    let count = body.count(least, WHAT)?;
    (0..count).map(|_| read(body)).collect()
}

impl ObjectReference {
    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let chunk = body.chunk()?;
        if chunk.typecode != typecode::ANONYMOUS {
            return Err(Error::malformed(offset, WHAT, "an object reference should stand here"));
        }
        let mut chunk = chunk.body;
        // Its version; where and how it was picked follows.
        chunk.take(8, WHAT)?;
        Ok(Self {
            object: chunk.uuid(WHAT)?,
            component: [chunk.i32(WHAT)?, chunk.i32(WHAT)?],
            geometry_type: chunk.i32(WHAT)?,
            point: chunk.point(WHAT)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chunk::Writer;
    use crate::class_object::write_class;
    use crate::tables::{KeptRecord, Table};
    use crate::version::Version;
    use crate::{Limits, Model};

    fn value(kind: i32, w: &mut Writer, body: impl FnOnce(&mut Writer) -> Result<()>) -> Result<()> {
        w.versioned(1, 0, |w| {
            w.i32(kind);
            w.i32(kind + 100);
            body(w)
        })
    }

    /// A record with a value of every kind, laid out as openNURBS writes it.
    fn write_record(w: &mut Writer) -> Result<()> {
        w.versioned(1, 2, |w| {
            w.uuid(Uuid::from_u128(1));
            w.i32(201);
            w.uuid(Uuid::from_u128(2));
            w.id_list(&[Uuid::from_u128(3)])?;
            w.id_list(&[Uuid::from_u128(4), Uuid::from_u128(5)])?;
            w.versioned(1, 0, |w| {
                w.i32(12);
                value(1, w, |w| {
                    w.i32(2);
                    w.bytes(&[1, 0]);
                    Ok(())
                })?;
                value(2, w, |w| {
                    [1, -7].iter().for_each(|x| w.i32(*x));
                    Ok(())
                })?;
                value(3, w, |w| w.doubles(&[0.5, -2.0]))?;
                value(4, w, |w| {
                    w.i32(1);
                    w.bytes(&[10, 20, 30, 0]);
                    Ok(())
                })?;
                value(5, w, |w| w.points(&[Point3::new(1.0, 2.0, 3.0)]))?;
                value(6, w, |w| w.points(&[Point3::new(4.0, 5.0, 6.0)]))?;
                value(7, w, |w| {
                    w.i32(1);
                    w.matrix(&Xform::IDENTITY);
                    Ok(())
                })?;
                value(8, w, |w| {
                    w.i32(2);
                    w.string("größe")?;
                    w.string("")
                })?;
                value(9, w, |w| {
                    w.i32(1);
                    w.versioned(1, 3, |w| {
                        w.uuid(Uuid::from_u128(9));
                        [2, 5, 4].iter().for_each(|x| w.i32(*x));
                        w.point(Point3::new(7.0, 8.0, 9.0));
                        w.bytes(&[0; 120]);
                        Ok(())
                    })
                })?;
                value(10, w, |w| {
                    w.versioned(1, 0, |w| {
                        w.i32(1);
                        write_class(w, crate::class_ids::POINT, &[], |w| {
                            w.packed_version(1, 0);
                            w.point(Point3::ORIGIN);
                            Ok(())
                        })
                    })
                })?;
                value(11, w, |w| {
                    w.i32(1);
                    w.uuid(Uuid::from_u128(11));
                    Ok(())
                })?;
                value(14, w, |w| w.versioned(1, 1, |_| Ok(())))
            })?;
            w.i32(1);
            w.bool(true);
            Ok(())
        })
    }

    fn model(version: i32) -> Model {
        let mut w = Writer::new(Version::for_writing(version).unwrap());
        let record = |w: &mut Writer| write_class(w, CLASS, &[], write_record);
        w.chunk(typecode::HISTORY_RECORD, record).unwrap();
        let kept = vec![KeptRecord::of_chunk(Table::History, typecode::HISTORY_RECORD, w)];
        Model { kept, ..Model::default() }
    }

    #[test]
    fn every_kind_of_value_is_read() {
        let history = model(70).history();
        let record = &history[0];
        assert_eq!(
            (record.id, record.version, record.command),
            (Uuid::from_u128(1), 201, Uuid::from_u128(2))
        );
        assert_eq!(record.descendants, [Uuid::from_u128(3)]);
        assert_eq!(record.antecedents, [Uuid::from_u128(4), Uuid::from_u128(5)]);
        assert!(record.is_feature && record.copy_on_replace);
        let ids: Vec<i32> = record.values.iter().map(|value| value.id - 100).collect();
        assert_eq!(ids, [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 14]);
        let mut values = record.values.iter().map(|value| &value.values);
        let mut next = || values.next().unwrap();
        assert_eq!(*next(), HistoryValues::Booleans(vec![true, false]));
        assert_eq!(*next(), HistoryValues::Integers(vec![-7]));
        assert_eq!(*next(), HistoryValues::Numbers(vec![0.5, -2.0]));
        assert_eq!(*next(), HistoryValues::Colours(vec![[10, 20, 30, 255]]));
        assert_eq!(*next(), HistoryValues::Points(vec![Point3::new(1.0, 2.0, 3.0)]));
        assert_eq!(*next(), HistoryValues::Vectors(vec![Vector3::new(4.0, 5.0, 6.0)]));
        assert_eq!(*next(), HistoryValues::Transforms(vec![Xform::IDENTITY]));
        assert_eq!(*next(), HistoryValues::Texts(vec!["größe".into(), String::new()]));
        let reference = ObjectReference {
            object: Uuid::from_u128(9),
            component: [2, 5],
            geometry_type: 4,
            point: Point3::new(7.0, 8.0, 9.0),
        };
        assert_eq!(*next(), HistoryValues::Objects(vec![reference]));
        let HistoryValues::Geometry(objects) = next() else { panic!("no geometry") };
        assert_eq!(objects[0].class_name(), "Point");
        assert_eq!(*next(), HistoryValues::Ids(vec![Uuid::from_u128(11)]));
        assert_eq!(*next(), HistoryValues::Other(14));
    }

    #[test]
    fn records_are_carried_byte_for_byte_and_into_other_widths() {
        for (from, to) in [(70, 80), (50, 80), (4, 50), (50, 4), (4, 70)] {
            let model = model(from);
            let bytes = model.write(to).unwrap();
            let back = Model::read(&bytes, &Limits::default()).unwrap();
            assert_eq!(back.warnings, [], "{from} to {to}");
            let same_width = (from >= 50) == (to >= 50);
            assert!(!same_width || back.kept[0].body == model.kept[0].body, "{from} to {to}");
            let read = |model: &Model| {
                let mut records = model.history();
                // The geometry says under which rules its bytes stand.
                records.iter_mut().for_each(|record| {
                    record.values.retain(|value| !matches!(value.values, HistoryValues::Geometry(_)));
                });
                records
            };
            assert_eq!(read(&back), read(&model), "{from} to {to}");
        }
    }
}
