use crate::{Error, Place, Result};

/// A place in a run of little-endian bytes; every read checks first whether the bytes are there.
pub(crate) struct Cursor<'a> {
    bytes: &'a [u8],
    offset: usize,
    place: Place,
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(bytes: &'a [u8], place: Place) -> Self {
        Self { bytes, offset: 0, place }
    }

    pub(crate) fn offset(&self) -> usize {
        self.offset
    }

    pub(crate) fn remaining(&self) -> usize {
        self.bytes.len().saturating_sub(self.offset)
    }

    pub(crate) fn error(&self, reason: impl Into<String>) -> Error {
        Error::at(self.place, self.offset, reason)
    }

    /// The next `n` bytes.
    pub(crate) fn take(&mut self, n: usize, what: &str) -> Result<&'a [u8]> {
        let end = self.offset.checked_add(n);
        let Some(slice) = end.and_then(|end| self.bytes.get(self.offset..end)) else {
            let rest = self.remaining();
            return Err(self.error(format!("{what} needs {n} bytes, but only {rest} remain")));
        };
        self.offset += n;
        Ok(slice)
    }

    pub(crate) fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N, what)?);
        Ok(array)
    }

    pub(crate) fn u8(&mut self, what: &str) -> Result<u8> {
        Ok(u8::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn i32(&mut self, what: &str) -> Result<i32> {
        Ok(i32::from_le_bytes(self.array(what)?))
    }

    /// A count that may not be negative.
    pub(crate) fn count(&mut self, what: &str) -> Result<usize> {
        let at = self.offset;
        let n = self.i32(what)?;
        usize::try_from(n).map_err(|_| Error::at(self.place, at, format!("{what} is negative ({n})")))
    }

    /// A length as .NET writes it: seven bits a byte, lowest first, at most 31 bits. Says also whether the
    /// length was written with more bytes than it needs.
    fn length(&mut self, what: &str) -> Result<(usize, bool)> {
        let start = self.offset;
        let mut n: u64 = 0;
        for shift in [0, 7, 14, 21, 28] {
            let byte = self.u8(what)?;
            n |= u64::from(byte & 0x7f) << shift;
            if byte & 0x80 == 0 {
                if n > i32::MAX as u64 {
                    break;
                }
                return Ok((usize::try_from(n).unwrap_or(usize::MAX), shift > 0 && byte == 0));
            }
        }
        Err(Error::at(self.place, start, format!("the length of {what} is more than 31 bits long")))
    }

    /// A text with its length before it, and whether the length was written with needless bytes.
    pub(crate) fn text(&mut self, what: &str) -> Result<(&'a str, bool)> {
        let (n, padded) = self.length(what)?;
        let start = self.offset;
        let bytes = self.take(n, what)?;
        std::str::from_utf8(bytes).map(|text| (text, padded)).map_err(|error| {
            Error::at(self.place, start + error.valid_up_to(), format!("{what} is not valid UTF-8"))
        })
    }
}
