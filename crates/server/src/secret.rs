/// What only some may know. It is kept as a hash, and hashes are compared in constant time: how long a refusal takes
/// tells nothing of how much was right.
#[derive(Clone)]
pub(crate) struct Secret(blake3::Hash);

impl Secret {
    pub(crate) fn new(text: &str) -> Self {
        Self(blake3::hash(text.as_bytes()))
    }

    /// Whether that is it.
    pub(crate) fn is(&self, given: &[u8]) -> bool {
        self.0 == blake3::hash(given)
    }
}

impl std::fmt::Debug for Secret {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Secret")
    }
}
