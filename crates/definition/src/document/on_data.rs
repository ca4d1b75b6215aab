use crate::archive::{self, Cursor, Limits};
use crate::{Place, Result};

/// A RhinoCommon object as .NET's BinaryFormatter wrote it: the class, and one openNURBS object.
///
/// The stream is read by the rules of MS-NRBF, as far as one object of plain members needs them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OnData {
    /// The class, `Rhino.Geometry.Brep` say.
    pub class_name: String,
    /// The version of the .3dm archive that `data` is written for: 4, 50, 60, 70, 80.
    pub archive3dm: i32,
    /// The version of openNURBS that wrote it.
    pub opennurbs: i32,
    /// The openNURBS object, beginning with its chunk head.
    pub data: Vec<u8>,
}

/// The most members a class may have; the real ones have four.
const MOST_MEMBERS: usize = 1000;

impl OnData {
    /// Inflates and reads the stream of an `ON_Data` item.
    ///
    /// # Errors
    /// When the stream is damaged, grows past the limits, is no BinaryFormatter stream, or lacks one of the
    /// members `archive3dm`, `opennurbs` and `data`.
    pub fn read(bytes: &[u8], limits: &Limits) -> Result<Self> {
        let inflated = archive::inflate(bytes, limits.max_inflated)?;
        Stream { at: Cursor::new(&inflated.data, Place::OnData) }.object()
    }
}

/// The assembly that the class is of, as Rhino 7 writes it: readers take any version.
const ASSEMBLY: &str =
    "RhinoCommon, Version=7.38.24338.17001, Culture=neutral, PublicKeyToken=552281e97c755530";
/// The first member says what layout the others have.
const LAYOUT: i32 = 10_000;

impl OnData {
    /// The stream of an `ON_Data` item, deflated: the records that Grasshopper writes, in their order.
    ///
    /// # Errors
    /// When the data is too long for the stream.
    pub fn write(&self) -> Result<Vec<u8>> {
        let mut out = Vec::with_capacity(self.data.len() + 400);
        let int = |out: &mut Vec<u8>, n: i32| out.extend_from_slice(&n.to_le_bytes());
        // SerializedStreamHeader.
        out.push(0);
        for n in [1, -1, 1, 0] {
            int(&mut out, n);
        }
        // BinaryLibrary.
        out.push(12);
        int(&mut out, 2);
        text(&mut out, ASSEMBLY);
        // ClassWithMembersAndTypes: three primitive members and an array of primitives.
        out.push(5);
        int(&mut out, 1);
        text(&mut out, &self.class_name);
        int(&mut out, 4);
        for member in ["version", "archive3dm", "opennurbs", "data"] {
            text(&mut out, member);
        }
        // Their kinds; then what the primitives are: three times Int32, and Byte; then the library.
        out.extend_from_slice(&[0, 0, 0, 7, 8, 8, 8, 2]);
        int(&mut out, 2);
        for n in [LAYOUT, self.archive3dm, self.opennurbs] {
            int(&mut out, n);
        }
        // MemberReference, and the ArraySinglePrimitive that it refers to.
        out.push(9);
        int(&mut out, 3);
        out.push(15);
        int(&mut out, 3);
        let length = i32::try_from(self.data.len()).map_err(|_| crate::Error::Document {
            place: self.class_name.clone(),
            reason: "it is too long to be kept".to_owned(),
        })?;
        int(&mut out, length);
        out.push(2);
        out.extend_from_slice(&self.data);
        // MessageEnd.
        out.push(11);
        archive::deflate(&out)
    }
}

/// A text behind its length, seven bits a byte.
fn text(out: &mut Vec<u8>, text: &str) {
    let mut length = text.len();
    while length > 0x7f {
        out.push((length & 0x7f) as u8 | 0x80);
        length >>= 7;
    }
    out.push(length as u8);
    out.extend_from_slice(text.as_bytes());
}

/// What a class record says of a member.
struct Member {
    name: String,
    kind: MemberKind,
}

enum MemberKind {
    /// A value in place, of this primitive type.
    Primitive(u8),
    /// A record: an object, a reference, or null.
    Record,
}

/// A member's value, as far as it matters here.
#[derive(Clone, Copy)]
enum Value<'a> {
    Whole(i32),
    Bytes(&'a [u8]),
    Reference(i32),
    Other,
}

struct Stream<'a> {
    at: Cursor<'a>,
}

impl<'a> Stream<'a> {
    fn object(&mut self) -> Result<OnData> {
        // SerializedStreamHeader: record 0, root and header ids, version 1.0.
        if self.at.u8("the stream's head")? != 0 {
            return Err(self.at.error("it does not begin as a .NET object stream"));
        }
        let root = self.at.i32("the root's id")?;
        self.at.i32("the head's id")?;
        if (self.at.i32("the version")?, self.at.i32("the version")?) != (1, 0) {
            return Err(self.at.error("it is not version 1.0 of the .NET object stream"));
        }
        let mut class = None;
        let mut arrays = Vec::new();
        loop {
            match self.at.u8("a record")? {
                // ClassWithMembersAndTypes, and the same for classes of the system library.
                record @ (5 | 4) => {
                    let id = self.at.i32("an object id")?;
                    let (name, members) = self.class(record == 5)?;
                    let values =
                        members.iter().map(|member| self.member(&member.kind)).collect::<Result<Vec<_>>>()?;
                    if class.is_none() || id == root {
                        class = Some((name, members, values));
                    }
                }
                // BinaryLibrary.
                12 => {
                    self.at.i32("a library id")?;
                    self.at.text("a library's name")?;
                }
                // ArraySinglePrimitive.
                15 => {
                    let (id, bytes) = self.array()?;
                    arrays.push((id, bytes));
                }
                // BinaryObjectString.
                6 => {
                    self.at.i32("an object id")?;
                    self.at.text("a text")?;
                }
                // ObjectNull.
                10 => {}
                // MessageEnd.
                11 => break,
                record => return Err(self.at.error(format!("record type {record} is not handled"))),
            }
        }
        let (class_name, members, values) =
            class.ok_or_else(|| self.at.error("there is no object in the stream"))?;
        let find = |name: &str| {
            let found = members.iter().zip(&values).find(|(member, _)| member.name == name);
            found
                .map(|(_, value)| *value)
                .ok_or_else(|| self.at.error(format!("there is no member \"{name}\"")))
        };
        let whole = |name: &str| match find(name)? {
            Value::Whole(n) => Ok(n),
            _ => Err(self.at.error(format!("the member \"{name}\" is not a whole number"))),
        };
        let data = match find("data")? {
            Value::Bytes(bytes) => Some(bytes),
            Value::Reference(id) => {
                arrays.iter().find(|(other, _)| *other == id).and_then(|(_, bytes)| *bytes)
            }
            _ => None,
        };
        let data =
            data.ok_or_else(|| self.at.error("the member \"data\" is not an array of bytes"))?.to_vec();
        Ok(OnData { class_name, archive3dm: whole("archive3dm")?, opennurbs: whole("opennurbs")?, data })
    }

    /// A class's name and members; the library id follows where it is not of the system.
    fn class(&mut self, with_library: bool) -> Result<(String, Vec<Member>)> {
        let name = self.text("a class name")?;
        let count = self.at.count("a count of members")?;
        if count > MOST_MEMBERS {
            return Err(self.at.error(format!("a class of {count} members")));
        }
        let names = (0..count).map(|_| self.text("a member's name")).collect::<Result<Vec<_>>>()?;
        let kinds = (0..count).map(|_| self.at.u8("a member's kind")).collect::<Result<Vec<_>>>()?;
        let mut members = Vec::with_capacity(count);
        for (name, kind) in names.into_iter().zip(kinds) {
            let kind = match kind {
                0 => MemberKind::Primitive(self.at.u8("a primitive type")?),
                // Text, object, array of objects, array of texts.
                1 | 2 | 5 | 6 => MemberKind::Record,
                // A class of the system library.
                3 => {
                    self.at.text("a class name")?;
                    MemberKind::Record
                }
                4 => {
                    self.at.text("a class name")?;
                    self.at.i32("a library id")?;
                    MemberKind::Record
                }
                // An array of primitives.
                7 => {
                    self.at.u8("a primitive type")?;
                    MemberKind::Record
                }
                _ => return Err(self.at.error(format!("{kind} is not a kind of member"))),
            };
            members.push(Member { name, kind });
        }
        if with_library {
            self.at.i32("a library id")?;
        }
        Ok((name, members))
    }

    fn member(&mut self, kind: &MemberKind) -> Result<Value<'a>> {
        match kind {
            MemberKind::Primitive(8) => Ok(Value::Whole(self.at.i32("a whole number")?)),
            MemberKind::Primitive(kind) => {
                let size = match kind {
                    // Boolean, byte, signed byte.
                    1 | 2 | 10 => 1,
                    // 16 bits.
                    7 | 14 => 2,
                    // Single, unsigned 32 bits.
                    11 | 15 => 4,
                    // Double, 64 bits, time span, date, unsigned 64 bits.
                    6 | 9 | 12 | 13 | 16 => 8,
                    _ => return Err(self.at.error(format!("primitive type {kind} is not handled"))),
                };
                self.at.take(size, "a member")?;
                Ok(Value::Other)
            }
            MemberKind::Record => match self.at.u8("a record")? {
                9 => Ok(Value::Reference(self.at.i32("an object id")?)),
                10 => Ok(Value::Other),
                6 => {
                    self.at.i32("an object id")?;
                    self.at.text("a text")?;
                    Ok(Value::Other)
                }
                15 => Ok(self.array()?.1.map_or(Value::Other, Value::Bytes)),
                record => Err(self.at.error(format!("record type {record} is not handled"))),
            },
        }
    }

    /// An array's id and, of bytes, the contents; arrays of anything else are refused.
    fn array(&mut self) -> Result<(i32, Option<&'a [u8]>)> {
        let id = self.at.i32("an object id")?;
        let n = self.at.count("an array's length")?;
        match self.at.u8("a primitive type")? {
            2 => Ok((id, Some(self.at.take(n, "an array of bytes")?))),
            kind => Err(self.at.error(format!("an array of primitive type {kind} is not handled"))),
        }
    }

    fn text(&mut self, what: &str) -> Result<String> {
        Ok(self.at.text(what)?.0.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        for length in [0, 1, 70_000] {
            let data = (0..length).map(|k| (k % 251) as u8).collect();
            let class_name = "Rhino.Geometry.NurbsCurve".to_owned();
            let before = OnData { class_name, archive3dm: 50, opennurbs: 7, data };
            let bytes = before.write().unwrap_or_default();
            assert_eq!(OnData::read(&bytes, &Limits::default()).ok(), Some(before));
        }
    }
}
