use crate::typecode;

/// The chunks around a place in an archive, outermost first, by their typecodes.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ChunkPath(pub Vec<u32>);

impl ChunkPath {
    /// Whether the place is in no chunk.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// The chunks in words where they have a name, as typecodes where not, joined by ` › `.
impl std::fmt::Display for ChunkPath {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (i, code) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str(" › ")?;
            }
            match (typecode::table_name(*code), typecode::name(*code)) {
                (Some(table), _) => write!(f, "{table} table")?,
                (None, Some(name)) => f.write_str(name)?,
                (None, None) => write!(f, "chunk {code:08X}")?,
            }
        }
        Ok(())
    }
}
