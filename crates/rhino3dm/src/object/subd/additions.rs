//! What versions from 70 on append to vertices, edges and faces: pieces of known size in a fixed order, each with its
//! size before it or 0 where it is left out, then pieces that are not known, then an end mark.

use super::WHAT;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, typecode};

/// What stands for a size before a chunk.
const CHUNK: u8 = 254;
/// What stands for a size at the end.
const END: u8 = 255;

/// The additions of one part, read in order.
#[derive(Debug)]
pub(super) struct Additions {
    ended: bool,
}

impl Additions {
    /// The additions of an archive of this version: none before 70.
    pub(super) fn of(body: &Reader<'_>) -> Self {
        Self { ended: body.version().archive < 70 }
    }

    /// Whether the next piece, of this size, is there.
    pub(super) fn next(&mut self, body: &mut Reader<'_>, size: u8) -> Result<bool> {
        if self.ended {
            return Ok(false);
        }
        let offset = body.offset();
        let found = body.u8(WHAT)?;
        self.ended = found == END;
        if found != size && found != 0 && found != END {
            return Err(Error::malformed(offset, WHAT, format!("an addition of {found} bytes, not {size}")));
        }
        Ok(found == size)
    }

    /// Passes over what is not known, to the end mark.
    pub(super) fn finish(self, body: &mut Reader<'_>) -> Result<()> {
        let mut ended = self.ended;
        while !ended {
            match body.u8(WHAT)? {
                END => ended = true,
                CHUNK => {
                    body.expect(typecode::ANONYMOUS, WHAT)?;
                }
                size => {
                    body.take(usize::from(size), WHAT)?;
                }
            }
        }
        Ok(())
    }
}

impl Writer {
    /// A piece of an addition when there is one, else the mark that it is left out.
    pub(super) fn addition<T>(&mut self, size: u8, piece: Option<T>, write: impl FnOnce(&mut Self, T)) {
        self.u8(if piece.is_some() { size } else { 0 });
        if let Some(piece) = piece {
            write(self, piece);
        }
    }

    /// The mark behind all additions.
    pub(super) fn end_of_additions(&mut self) {
        self.u8(END);
    }
}
