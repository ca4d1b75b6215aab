//! Fast text: numbers as their shortest decimal form that reads back as the same number.

use std::io::Write;

use crate::Result;

/// Text on its way to a destination.
pub(crate) struct Text<'a> {
    out: &'a mut dyn Write,
    buffer: Vec<u8>,
}

/// The buffer is sent on when it has grown to this.
const FULL: usize = 1 << 16;

impl<'a> Text<'a> {
    pub(crate) fn new(out: &'a mut dyn Write) -> Self {
        Self { out, buffer: Vec::with_capacity(FULL + 4096) }
    }

    pub(crate) fn push(&mut self, text: &str) {
        self.buffer.extend_from_slice(text.as_bytes());
    }

    /// A finite number: 1 for 1.0, 1e-7, 0.1.
    pub(crate) fn real(&mut self, x: f64) {
        push_real(&mut self.buffer, x);
    }

    /// A finite number of single precision.
    pub(crate) fn short_real(&mut self, x: f32) {
        let mut digits = zmij::Buffer::new();
        self.push(without_zero(digits.format_finite(x)));
    }

    /// Three numbers, each with a blank before it.
    pub(crate) fn reals(&mut self, numbers: [f64; 3]) {
        for x in numbers {
            self.buffer.push(b' ');
            self.real(x);
        }
    }

    pub(crate) fn whole(&mut self, n: usize) {
        let mut digits = itoa::Buffer::new();
        self.buffer.extend_from_slice(digits.format(n).as_bytes());
    }

    /// The end of a line; the place where the buffer is sent on.
    pub(crate) fn end_line(&mut self) -> Result<()> {
        self.buffer.push(b'\n');
        if self.buffer.len() >= FULL { self.flush() } else { Ok(()) }
    }

    /// Raw bytes, sent on when there are enough of them.
    pub(crate) fn bytes(&mut self, bytes: &[u8]) -> Result<()> {
        self.buffer.extend_from_slice(bytes);
        if self.buffer.len() >= FULL { self.flush() } else { Ok(()) }
    }

    /// Sends everything on.
    pub(crate) fn flush(&mut self) -> Result<()> {
        self.out.write_all(&self.buffer)?;
        self.buffer.clear();
        Ok(())
    }
}

/// A finite number at the end of a text in bytes.
pub(crate) fn push_real(buffer: &mut Vec<u8>, x: f64) {
    // Coordinates are whole numbers more often than chance would have it.
    if x.abs() < 1e9 && x == x.trunc() {
        let mut digits = itoa::Buffer::new();
        buffer.extend_from_slice(digits.format(x as i64).as_bytes());
        return;
    }
    let mut digits = zmij::Buffer::new();
    buffer.extend_from_slice(without_zero(digits.format_finite(x)).as_bytes());
}

fn without_zero(digits: &str) -> &str {
    digits.strip_suffix(".0").unwrap_or(digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_as_themselves() {
        for x in [0.0, -0.0, 1.0, -2.5, 0.1, 1e-7, 1e300, 5e-324, 1.0 / 3.0, 123_456_789_012.0] {
            let mut buffer = Vec::new();
            push_real(&mut buffer, x);
            let text = String::from_utf8(buffer).unwrap();
            assert_eq!(text.parse::<f64>().unwrap(), x, "{text}");
            assert!(!text.ends_with(".0"), "{text}");
        }
    }
}
