//! Messages between a script's process and this one: values as bytes.
//!
//! A message is a `u32` length of what follows and one value. All numbers are little-endian; a text's length is in bytes of
//! UTF-8. A value is a tag and its body:
//!
//! | tag | value | body |
//! | --- | --- | --- |
//! | `N` `T` `F` | null, true, false | |
//! | `i` `d` | whole number, number | i64, f64 |
//! | `s` `b` | text, bytes | u32 length, bytes |
//! | `l` `m` | list, map | u32 count, values; for a map a key and a value each |
//! | `D` `J` `P` `W` `O` | numbers, whole numbers, points, vectors, polyline | u32 count, then f64, i64 or 3 f64 each |
//! | `p` `v` `2` | point, vector, point in a plane | 3, 3, 2 f64 |
//! | `q` `n` `I` `X` | plane, line, interval, transform | 12, 6, 2, 16 f64 |
//! | `c` `e` `a` | circle, ellipse, arc | plane, then radius; two radii; radius and angle interval |
//! | `R` `B` `x` `S` | rectangle, bounding box, box, sphere | plane and 2 intervals; 6 f64; plane and 3 intervals; plane and radius |
//! | `C` `g` `z` `t` | colour, Guid, complex, time | 4 bytes A R G B; 16 bytes in the order of the text; 2 f64; i64 ticks |
//! | `f` `u` | mesh face, path | 4 i32; u32 count, i32 each |
//! | `U` | tree | u32 branches, each a path, a u32 count and values |
//! | `G` | geometry | u64 number, then the body of a text: the class |
//! | `y` | object of the script's language | u64 |
//! | `k` | member of an enumeration | body of a text, i64 |
//! | `E` | error | bodies of two texts: kind and message |
//!
//! The script's process sends `["call", member, arguments...]`, answered by `["ok", value]` or an error; `["release",
//! numbers]`, not answered; `["members"]`, answered by a list of texts; `["components"]` and `["component", name, inputs]`.
//! A member is `Class.Member`, a constructor `Class.new`, a property `Class.get_Name` and `Class.set_Name`; instance members
//! take the object first. A member of a base class is found under a derived class: `LineCurve.GetLength`. Results with
//! several properties and no tag of their own (`AreaMassProperties`, `IntersectionEvent`) are geometry too: `G` with their
//! class, whose properties are read by `Class.get_Name`. Parameters that RhinoCommon calls `out` are left out of the
//! arguments and come behind the result, in a list.
//!
//! A handle may stand for a list that belongs to an object, such as `MeshVertexList` for `mesh.Vertices`: its class has
//! `get_Count`, `get_Item`, where it is written in `set_Item`, and `ToArray` for all items at once. Handed over it is its
//! object: `MeshVertexList.Add` changes the mesh. Other lists (`brep.Faces`) are lists of values.
//!
//! Lengths are checked against the bytes that are there before anything is allocated, and values nest at most 64 deep.

mod read;
mod write;

use std::io::{self, Read, Write};

pub use read::decode;
pub use write::encode;

/// How deep values may nest.
pub const DEEPEST: usize = 64;

/// The most bytes of a message.
pub const LARGEST: usize = 1 << 30;

/// What is wrong with a message.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The pipe.
    #[error("the pipe: {0}")]
    Pipe(#[from] io::Error),
    /// More bytes than a message may have.
    #[error("a message of {0} bytes; {LARGEST} are allowed")]
    TooLarge(u64),
    /// A value that cannot be read, at a byte of the message.
    #[error("byte {at} of the message: {what}")]
    Broken {
        /// Where.
        at: usize,
        /// What is wrong there.
        what: String,
    },
}

/// Reads the bytes of the next message; `None` at the end of the pipe.
///
/// # Errors
/// The pipe breaks, also within a message, or the message is too large.
pub fn receive(pipe: &mut impl Read) -> Result<Option<Vec<u8>>, Error> {
    let mut length = [0; 4];
    let mut got = 0;
    while got < length.len() {
        let rest = length.get_mut(got..).unwrap_or_default();
        match pipe.read(rest) {
            Ok(0) if got == 0 => return Ok(None),
            Ok(0) => return Err(io::Error::from(io::ErrorKind::UnexpectedEof).into()),
            Ok(count) => got += count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error.into()),
        }
    }
    let length = u32::from_le_bytes(length);
    if length as usize > LARGEST {
        return Err(Error::TooLarge(length.into()));
    }
    // The bytes are allocated as they come: a length alone costs nothing.
    let mut bytes = Vec::new();
    pipe.take(length.into()).read_to_end(&mut bytes)?;
    if bytes.len() < length as usize {
        return Err(io::Error::from(io::ErrorKind::UnexpectedEof).into());
    }
    Ok(Some(bytes))
}

/// Sends a message.
///
/// # Errors
/// The pipe breaks, or the message is too large.
pub fn send(pipe: &mut impl Write, bytes: &[u8]) -> Result<(), Error> {
    let length = u32::try_from(bytes.len()).ok().filter(|length| *length as usize <= LARGEST);
    let length = length.ok_or(Error::TooLarge(bytes.len() as u64))?;
    pipe.write_all(&length.to_le_bytes())?;
    pipe.write_all(bytes)?;
    pipe.flush()?;
    Ok(())
}

#[cfg(test)]
mod tests;
