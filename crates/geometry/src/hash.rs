//! Tables by hash of numbers: of places, indices and edges.

/// A table whose hash takes a few instructions and starts from another seed in each run, so that no file can be made for
/// it to be slow. It has no order that anybody may rely on.
pub(crate) type Table<K, V> = std::collections::HashMap<K, V, foldhash::fast::RandomState>;

/// An empty table with room for so many entries.
pub(crate) fn table<K, V>(room: usize) -> Table<K, V> {
    Table::with_capacity_and_hasher(room, foldhash::fast::RandomState::default())
}
