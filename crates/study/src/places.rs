//! Where in the store each point is: a hash table in a file of its own, so that memory does not grow with the points.
//!
//! The file has no name and goes with the process: the store's records say everything, and the table is made anew when a store is
//! opened. Open addressing with linear probing (Knuth, The Art of Computer Programming 3, 6.4, algorithm L). A name is a hash
//! already: its first bits are its slot, so that a larger table is filled in the order of the smaller one.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crate::record::Name;

/// The bytes of a slot: a name and the place of its record; all 0 where the slot is free.
const SLOT: usize = 24;
/// How many slots are read at a time: with two of three slots in use, a search for what is not there looks at five of them.
const RUN: u64 = 16;
/// The slots of a new table, as a power of 2.
const FIRST_BITS: u32 = 10;
/// The most slots, as a power of 2: more than any disk holds.
const MOST_BITS: u32 = 48;

/// In a slot, for a point that was solved and is to be solved again. Records begin behind the header of a store.
const FORGOTTEN: u64 = 1;

/// A slot: the one that has a name, or the free one where it would be.
#[derive(Debug, Clone, Copy)]
struct Found {
    slot: u64,
    /// 0 where the slot is free.
    byte: u64,
}

/// The table of places.
#[derive(Debug)]
pub(crate) struct Places {
    folder: PathBuf,
    table: Table,
    /// How many slots are not free.
    used: u64,
}

impl Places {
    /// An empty table, whose file lies in a folder.
    ///
    /// # Errors
    /// The file cannot be made.
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        Ok(Self { folder: folder.to_path_buf(), table: Table::new(folder, FIRST_BITS)?, used: 0 })
    }

    /// At which byte of the store the record of a point begins; `None` where there is none.
    ///
    /// # Errors
    /// The file cannot be read.
    pub(crate) fn get(&mut self, name: &Name) -> io::Result<Option<u64>> {
        let byte = self.table.find(name)?.byte;
        Ok(Some(byte).filter(|byte| *byte > FORGOTTEN))
    }

    /// Says where the record of a point begins.
    ///
    /// # Errors
    /// The file cannot be read or written: the disk is full, say. Then the table is as it was.
    pub(crate) fn set(&mut self, name: &Name, byte: u64) -> io::Result<()> {
        // A third of the slots stays free.
        if (self.used + 1) * 3 > self.table.slots() * 2 {
            self.grow()?;
        }
        let found = self.table.find(name)?;
        self.table.write(found.slot, name, byte)?;
        self.used += u64::from(found.byte == 0);
        Ok(())
    }

    /// Takes the record of a point away.
    ///
    /// # Errors
    /// As [`set`](Self::set).
    pub(crate) fn forget(&mut self, name: &Name) -> io::Result<()> {
        self.set(name, FORGOTTEN)
    }

    /// Moves everything into a table of twice the slots.
    fn grow(&mut self) -> io::Result<()> {
        let mut larger = Table::new(&self.folder, self.table.bits + 1)?;
        let mut used = 0;
        self.table.file.seek(SeekFrom::Start(0))?;
        let mut reader = BufReader::with_capacity(1 << 16, &self.table.file);
        for _ in 0..self.table.slots() {
            let mut bytes = [0; SLOT];
            reader.read_exact(&mut bytes)?;
            let (name, byte) = slot(&bytes);
            // What is forgotten is as good as unknown.
            if byte > FORGOTTEN {
                let found = larger.find(&name)?;
                larger.write(found.slot, &name, byte)?;
                used += 1;
            }
        }
        (self.table, self.used) = (larger, used);
        Ok(())
    }
}

/// The file of so many slots.
#[derive(Debug)]
struct Table {
    file: File,
    bits: u32,
}

impl Table {
    fn new(folder: &Path, bits: u32) -> io::Result<Self> {
        if bits > MOST_BITS {
            return Err(io::Error::other("there are more points than a study can have"));
        }
        let file = tempfile::tempfile_in(folder)?;
        let mut table = Self { file, bits };
        // Written from end to end: a file with holes that are filled here and there makes file systems slow.
        let length = table.slots() * SLOT as u64;
        io::copy(&mut io::repeat(0).take(length), &mut table.file)?;
        Ok(table)
    }

    const fn slots(&self) -> u64 {
        1 << self.bits
    }

    /// The slot of a name; a third of the slots is free, so that there is always one.
    fn find(&mut self, name: &Name) -> io::Result<Found> {
        let first = name.first_chunk().map_or(0, |bytes| u64::from_be_bytes(*bytes)) >> (64 - self.bits);
        let mut run = [0; RUN as usize * SLOT];
        let mut at = first;
        loop {
            let count = RUN.min(self.slots() - at);
            let bytes = run.get_mut(..count as usize * SLOT).unwrap_or_default();
            self.file.seek(SeekFrom::Start(at * SLOT as u64))?;
            self.file.read_exact(bytes)?;
            for (slot_at, bytes) in (at..).zip(bytes.chunks_exact(SLOT)) {
                let (found, byte) = slot(bytes);
                if byte == 0 || found == *name {
                    return Ok(Found { slot: slot_at, byte });
                }
            }
            at = (at + count) % self.slots();
        }
    }

    fn write(&mut self, slot: u64, name: &Name, byte: u64) -> io::Result<()> {
        let mut bytes = [0; SLOT];
        let (head, tail) = bytes.split_at_mut(name.len());
        head.copy_from_slice(name);
        tail.copy_from_slice(&byte.to_le_bytes());
        self.file.seek(SeekFrom::Start(slot * SLOT as u64))?;
        self.file.write_all(&bytes)
    }
}

/// What is in a slot: a name, and the place of its record.
fn slot(bytes: &[u8]) -> (Name, u64) {
    let name = bytes.first_chunk().copied().unwrap_or_default();
    (name, bytes.last_chunk().copied().map_or(0, u64::from_le_bytes))
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use proptest::prelude::*;

    use super::*;

    /// Names whose first bits are the same, or at the end of the table, so that runs of slots are long and go around.
    fn crowded(n: u16) -> Name {
        let mut name = [255; 16];
        name[1] = if n.is_multiple_of(2) { 255 } else { 0 };
        name[8..10].copy_from_slice(&n.to_le_bytes());
        name
    }

    /// Names that are spread, as hashes are.
    fn spread(n: u16) -> Name {
        *blake3::hash(&n.to_le_bytes()).as_bytes().first_chunk().unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn it_says_what_a_map_in_memory_says(
            steps in prop::collection::vec((0_u16..2500, 0_u64..4, any::<bool>()), 0..3000),
        ) {
            let folder = tempfile::tempdir().unwrap();
            let mut places = Places::new(folder.path()).unwrap();
            let mut known = HashMap::new();
            for (n, step, is_crowded) in steps {
                let name = if is_crowded { crowded(n % 300) } else { spread(n) };
                prop_assert_eq!(places.get(&name).unwrap(), known.get(&name).copied());
                match step {
                    0 => {}
                    1 => {
                        places.forget(&name).unwrap();
                        known.remove(&name);
                    }
                    _ => {
                        let byte = 24 + step * u64::from(n);
                        places.set(&name, byte).unwrap();
                        known.insert(name, byte);
                    }
                }
            }
            for (name, byte) in known {
                prop_assert_eq!(places.get(&name).unwrap(), Some(byte));
            }
            prop_assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "its files have no names");
        }
    }

    #[test]
    fn it_grows_and_loses_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut places = Places::new(folder.path()).unwrap();
        for n in 0..20_000 {
            assert_eq!(places.get(&spread(n)).unwrap(), None);
            places.set(&spread(n), u64::from(n) + 24).unwrap();
        }
        assert!(places.table.slots() == 1 << 15 && places.used == 20_000);
        for n in 0..20_000 {
            assert_eq!(places.get(&spread(n)).unwrap(), Some(u64::from(n) + 24));
        }
    }
}
