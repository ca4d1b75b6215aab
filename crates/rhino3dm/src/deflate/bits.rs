/// Writes numbers of a few bits, lowest bit first.
#[derive(Debug)]
pub(super) struct BitWriter {
    out: Vec<u8>,
    waiting: u64,
    count: u32,
}

impl BitWriter {
    /// An empty stream with room for so many bytes.
    pub(super) fn new(capacity: usize) -> Self {
        Self { out: Vec::with_capacity(capacity), waiting: 0, count: 0 }
    }

    /// The lowest `count` bits (at most 16) of a value that has no others.
    pub(super) fn bits(&mut self, value: u32, count: u32) {
        self.waiting |= u64::from(value) << self.count;
        self.count += count;
        if self.count >= 32 {
            let [a, b, c, d, ..] = self.waiting.to_le_bytes();
            self.out.extend([a, b, c, d]);
            self.waiting >>= 32;
            self.count -= 32;
        }
    }

    /// Fills up the last byte with zeros.
    pub(super) fn align(&mut self) {
        let whole = self.count.div_ceil(8) as usize;
        self.out.extend(self.waiting.to_le_bytes().into_iter().take(whole));
        self.waiting = 0;
        self.count = 0;
    }

    /// Whole bytes, behind a filled byte.
    pub(super) fn bytes(&mut self, bytes: &[u8]) {
        self.align();
        self.out.extend_from_slice(bytes);
    }

    pub(super) fn into_bytes(mut self) -> Vec<u8> {
        self.align();
        self.out
    }
}
