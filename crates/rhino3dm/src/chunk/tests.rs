use super::*;
use crate::version::Version;
use crate::{Error, Limits, StoredBuffer, typecode};

const WIDE: Version = Version { archive: 70, opennurbs: 0x9000_0000 };
const NARROW: Version = Version { archive: 4, opennurbs: 200_712_190 };

fn nested(version: Version) -> Vec<u8> {
    let mut w = Writer::new(version);
    w.chunk(typecode::ANONYMOUS, |w| {
        w.i32(1);
        w.chunk(typecode::ANONYMOUS, |w| w.string("inner"))?;
        w.short(typecode::END_OF_TABLE, -2);
        w.i32(2);
        Ok(())
    })
    .unwrap();
    w.into_bytes()
}

fn read_nested(bytes: &[u8], version: Version) -> Vec<crate::Warning> {
    let context = Context::new(&Limits::default());
    let mut reader = Reader::new(bytes, version, &context);
    let mut outer = reader.expect(typecode::ANONYMOUS, "outer").unwrap();
    assert_eq!(outer.i32("one").unwrap(), 1);
    let mut inner = outer.expect(typecode::ANONYMOUS, "inner").unwrap();
    assert_eq!(inner.string("text").unwrap(), "inner");
    inner.finish();
    let short = outer.chunk().unwrap();
    assert_eq!((short.typecode, short.value), (typecode::END_OF_TABLE, -2));
    assert_eq!(outer.i32("two").unwrap(), 2);
    outer.finish();
    assert!(reader.is_at_end());
    context.into_warnings()
}

#[test]
fn crc_covers_own_bytes_only() {
    for version in [WIDE, NARROW] {
        let bytes = nested(version);
        assert_eq!(read_nested(&bytes, version), []);
        let mut own = vec![1, 0, 0, 0, 2, 0, 0, 0];
        let crc = crc32fast::hash(&own);
        own.extend(crc.to_le_bytes());
        assert_eq!(bytes[bytes.len() - 8..], own[4..]);
    }
}

#[test]
fn a_changed_byte_is_a_warning() {
    let mut bytes = nested(WIDE);
    let last = bytes.len() - 1;
    bytes[last] ^= 1;
    let warnings = read_nested(&bytes, WIDE);
    assert_eq!(warnings.len(), 1);
    assert!(warnings[0].message.contains("CRC mismatch"));
}

#[test]
fn lengths_beyond_the_end_are_refused_before_anything_is_read() {
    let context = Context::new(&Limits::default());
    let mut bytes = typecode::ANONYMOUS.to_le_bytes().to_vec();
    bytes.extend(i64::MAX.to_le_bytes());
    let error = Reader::new(&bytes, WIDE, &context).chunk().unwrap_err();
    assert!(matches!(error, Error::Truncated { offset: 12, .. }), "{error}");
    bytes.truncate(4);
    bytes.extend((-1_i64).to_le_bytes());
    assert!(matches!(Reader::new(&bytes, WIDE, &context).chunk(), Err(Error::Malformed { .. })));
    let counts = i32::MAX.to_le_bytes();
    assert!(matches!(Reader::new(&counts, WIDE, &context).points("points"), Err(Error::Truncated { .. })));
}

#[test]
fn nesting_is_bounded() {
    fn nest(w: &mut Writer, depth: usize) -> crate::Result<()> {
        w.chunk(typecode::ANONYMOUS, |w| if depth == 0 { Ok(()) } else { nest(w, depth - 1) })
    }
    fn descend(mut reader: Reader<'_>) -> crate::Result<usize> {
        if reader.is_at_end() { Ok(0) } else { Ok(1 + descend(reader.chunk()?.body)?) }
    }
    let mut w = Writer::new(WIDE);
    nest(&mut w, 200).unwrap();
    let context = Context::new(&Limits::default());
    let bytes = w.into_bytes();
    let error = descend(Reader::new(&bytes, WIDE, &context)).unwrap_err();
    assert!(matches!(error, Error::TooDeep { limit: 64, .. }));
}

#[test]
fn compressed_buffers_come_back() {
    for size in [0, 1, 128, 129, 100_000] {
        let plain: Vec<u8> = (0..size).map(|i: u32| (i % 7) as u8).collect();
        let mut w = Writer::new(WIDE);
        w.stored_buffer(&StoredBuffer::new(plain.clone())).unwrap();
        let bytes = w.into_bytes();
        assert!(bytes.len() <= plain.len().max(128) + 16);
        let context = Context::new(&Limits::default());
        let mut reader = Reader::new(&bytes, WIDE, &context);
        let stored = reader.stored_buffer("buffer").unwrap();
        assert_eq!((stored.size(), stored.to_bytes().unwrap()), (plain.len(), plain));
        assert!(reader.is_at_end());
        assert_eq!(context.into_warnings(), []);
        // As it is stored it is written again.
        let mut w = Writer::new(WIDE);
        w.stored_buffer(&stored).unwrap();
        assert_eq!(w.into_bytes(), bytes);
    }
}

#[test]
fn a_stored_buffer_holds_what_it_promises() {
    let mut w = Writer::new(WIDE);
    w.stored_buffer(&StoredBuffer::new((0..70_000_u32).map(|i| (i % 251) as u8).collect())).unwrap();
    let bytes = w.into_bytes();
    let read = |bytes: &[u8]| {
        let context = Context::new(&Limits::default());
        let read = Reader::new(bytes, WIDE, &context).stored_buffer("buffer");
        (read, context.into_warnings().len())
    };
    for size in [69_999_u32, 70_001] {
        let mut lie = bytes.clone();
        lie[..4].copy_from_slice(&size.to_le_bytes());
        assert!(matches!(read(&lie), (Err(Error::Malformed { .. }), 0)), "{size}");
    }
    let mut wrong = bytes;
    wrong[4] ^= 1;
    assert!(matches!(read(&wrong), (Ok(_), 1)), "a checksum that does not fit is a warning");
}

#[test]
fn inflation_is_bounded() {
    let mut w = Writer::new(WIDE);
    w.stored_buffer(&StoredBuffer::new(vec![0; 1 << 20])).unwrap();
    let bytes = w.into_bytes();
    let context = Context::new(&Limits { inflated: 1000, ..Limits::default() });
    let error = Reader::new(&bytes, WIDE, &context).stored_buffer("buffer").unwrap_err();
    assert!(matches!(error, Error::TooLarge { limit: 1000, .. }));
    // A size that the stream cannot hold is refused whatever the limit.
    let mut lie = bytes;
    lie[..4].copy_from_slice(&u32::MAX.to_le_bytes());
    let context = Context::new(&Limits::default());
    assert!(matches!(
        Reader::new(&lie, WIDE, &context).stored_buffer("buffer"),
        Err(Error::Malformed { .. })
    ));
}

#[test]
fn text_is_utf16_with_a_closing_zero() {
    let mut w = Writer::new(WIDE);
    w.string("Ä𝄞").unwrap();
    w.string("").unwrap();
    let bytes = w.into_bytes();
    assert_eq!(bytes[..4], 4_u32.to_le_bytes());
    let context = Context::new(&Limits::default());
    let mut reader = Reader::new(&bytes, WIDE, &context);
    assert_eq!(reader.string("text").unwrap(), "Ä𝄞");
    assert_eq!(reader.string("text").unwrap(), "");
}
