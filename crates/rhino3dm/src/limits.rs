/// How much a reader may spend on an archive that nobody vouches for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// How deep chunks may nest. Real files stay below 30.
    pub depth: usize,
    /// Bytes that all compressed buffers together may inflate to.
    pub inflated: u64,
    /// How many times the size of an archive they may inflate to. 128 MiB are free.
    pub inflation: u64,
    /// Warnings kept; later ones are counted but not stored.
    pub warnings: usize,
}

impl Default for Limits {
    /// 64 levels, 4 GiB inflated and no more than 32 times the archive, 1000 warnings.
    fn default() -> Self {
        Self { depth: 64, inflated: 4 << 30, inflation: 32, warnings: 1000 }
    }
}
