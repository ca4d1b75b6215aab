//! The place on the Earth, which archives from version 60 on state in another way when it is not set.

use crate::chunk::{Context, Reader};
use crate::version::Version;
use crate::{Limits, Result};

/// The number that stands for none.
const UNSET: f64 = -1.234_321_012_343_21e308;

/// Positions from this minor version on say by their value whether they are set; before, all zeros said it.
pub(crate) const SAYS_UNSET: i32 = 2;

/// Settings records have a place on the Earth from this minor version on.
pub(crate) const EARTH_FROM: u8 = 3;

/// The settings record of an archive before version 60 for one of later: there a place at zero is set, and what is
/// not set is another number. Bytes of a layout that is not known stay as they are.
pub(crate) fn say_unset(body: &mut [u8], version: Version) {
    let _ = try_say_unset(body, version);
}

fn try_say_unset(body: &mut [u8], version: Version) -> Result<()> {
    const WHAT: &str = "earth anchor";
    let context = Context::new(&Limits::default());
    let mut reader = Reader::new(body, version, &context);
    let (_, minor) = reader.packed_version(WHAT)?;
    if minor < EARTH_FROM {
        return Ok(());
    }
    // Linetype scale, colour in print, linetype; page units; active view; base point.
    reader.take(24, WHAT)?;
    reader.chunk()?;
    reader.take(16 + 24, WHAT)?;
    let mut chunk = reader.chunk()?;
    let end = reader.offset();
    chunk.body.i32(WHAT)?;
    let says_itself = chunk.body.i32(WHAT)? >= SAYS_UNSET;
    let start = chunk.body.offset();
    let unset = (0..3).all(|_| chunk.body.f64(WHAT).is_ok_and(|x| x == 0.0));
    let whole = end.saturating_sub(chunk.whole.len())..end;
    if says_itself || !unset {
        return Ok(());
    }
    for at in [start, start.saturating_add(8)] {
        if let Some(number) = body.get_mut(at..at.saturating_add(8)) {
            number.copy_from_slice(&UNSET.to_le_bytes());
        }
    }
    if let Some((bytes, crc)) = body.get_mut(whole).and_then(<[u8]>::split_last_chunk_mut::<4>) {
        *crc = crc32fast::hash(bytes).to_le_bytes();
    }
    Ok(())
}
