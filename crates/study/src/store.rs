//! Outcomes on the disk, by the content of their points: what is there is not solved again.
//!
//! A file of records that only grows. Each record has its length and a checksum before it, so that what a crash or a full disk
//! cut off is told from what is whole, and is cut away when the file is opened again.

use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::thresholds::{MOST_RECORD_BYTES, SYNC_EVERY};
use crate::{Cell, Outcome, Status, StudyError};

/// What a store's file begins with; the last byte is the version of the form.
const MAGIC: [u8; 8] = *b"KDSTUDY\x01";
/// The magic and the name of the study.
const HEADER: u64 = 24;

/// The name of a point or a study: what it is made of, hashed.
pub(crate) type Name = [u8; 16];

/// The first bytes of a BLAKE3 hash.
pub(crate) fn name_of(hasher: &blake3::Hasher) -> Name {
    hasher.finalize().as_bytes().first_chunk().copied().unwrap_or_default()
}

/// What is kept of a point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Kept {
    pub(crate) name: Name,
    pub(crate) outcome: Outcome,
    /// The names of its picture and its geometry; empty where there is none.
    pub(crate) files: [String; 2],
}

/// The file, and where in it each point is.
#[derive(Debug)]
pub(crate) struct Store {
    path: PathBuf,
    file: File,
    /// From the first half of a name to the place of its record, or 0 while it is being solved.
    places: HashMap<u64, u64>,
    /// Where whole records end.
    end: u64,
    synced: Instant,
}

impl Store {
    /// Opens a study's file, or begins one. Outcomes that `forget` names are left out: they are solved again.
    ///
    /// # Errors
    /// It cannot be read or written, is another program's, or somebody else works on it.
    pub(crate) fn open(
        path: &Path,
        study: &Name,
        forget: impl Fn(Status) -> bool,
    ) -> Result<Self, StudyError> {
        let failed = |error: io::Error| StudyError::file(path, error);
        let mut file =
            File::options().read(true).write(true).create(true).truncate(false).open(path).map_err(failed)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(std::fs::TryLockError::WouldBlock) => {
                return Err(StudyError::file(path, "another sweep works on this study"));
            }
            // Some file systems have no locks; then it is on the user.
            Err(std::fs::TryLockError::Error(_)) => {}
        }
        let length = file.metadata().map_err(failed)?.len();
        let mut header = Vec::with_capacity(24);
        header.extend(MAGIC);
        header.extend(study);
        if length < HEADER {
            file.set_len(0).map_err(failed)?;
            file.write_all(&header).map_err(failed)?;
        } else {
            let mut found = [0; 24];
            file.seek(SeekFrom::Start(0)).map_err(failed)?;
            file.read_exact(&mut found).map_err(failed)?;
            if found.as_slice() != header {
                return Err(StudyError::file(path, "it is no store of this study"));
            }
        }
        let mut store = Self {
            path: path.to_path_buf(),
            file,
            places: HashMap::new(),
            end: HEADER,
            synced: Instant::now(),
        };
        store.index(length, forget).map_err(failed)?;
        Ok(store)
    }

    /// Finds the places of all records; what comes behind the last whole one is cut away.
    fn index(&mut self, length: u64, forget: impl Fn(Status) -> bool) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(HEADER))?;
        let mut reader = BufReader::with_capacity(1 << 16, &self.file);
        let mut bytes = Vec::new();
        while record(&mut reader, length.saturating_sub(self.end), &mut bytes)? {
            if let Some(kept) = decode(&bytes) {
                if forget(kept.outcome.status) {
                    self.places.remove(&half(&kept.name));
                } else {
                    self.places.insert(half(&kept.name), self.end);
                }
            }
            self.end += 8 + bytes.len() as u64;
        }
        self.file.set_len(self.end)?;
        self.file.seek(SeekFrom::Start(self.end))?;
        Ok(())
    }

    /// Takes a point to be solved; `false` when it was solved or is being solved.
    pub(crate) fn take(&mut self, name: &Name) -> bool {
        let place = self.places.entry(half(name));
        let is_new = matches!(place, std::collections::hash_map::Entry::Vacant(_));
        place.or_insert(0);
        is_new
    }

    /// Keeps an outcome. After an error nothing of it is in the file.
    ///
    /// # Errors
    /// It cannot be written.
    pub(crate) fn keep(&mut self, kept: &Kept) -> Result<(), StudyError> {
        let payload = encode(kept);
        let mut bytes = Vec::with_capacity(payload.len() + 8);
        bytes.extend(u32::try_from(payload.len()).unwrap_or(u32::MAX).to_le_bytes());
        bytes.extend(crc32fast::hash(&payload).to_le_bytes());
        bytes.extend(payload);
        if let Err(error) = self.append(&bytes) {
            // Half a record is cut away now where that can be done, else when the file is opened again.
            let _ = self
                .file
                .set_len(self.end)
                .and_then(|()| self.file.seek(SeekFrom::Start(self.end)).map(drop));
            return Err(StudyError::file(
                &self.path,
                format!("{error}: what is solved is kept, and the same command goes on"),
            ));
        }
        self.places.insert(half(&kept.name), self.end);
        self.end += bytes.len() as u64;
        Ok(())
    }

    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        // What was read in between left the file elsewhere.
        self.file.seek(SeekFrom::Start(self.end))?;
        self.file.write_all(bytes)?;
        if self.synced.elapsed() >= SYNC_EVERY {
            self.file.sync_data()?;
            self.synced = Instant::now();
        }
        Ok(())
    }

    /// Has the system write everything to the disk.
    ///
    /// # Errors
    /// It cannot be written.
    pub(crate) fn sync(&self) -> Result<(), StudyError> {
        self.file.sync_data().map_err(|error| StudyError::file(&self.path, error))
    }

    /// What is kept of a point; `None` where it was not solved.
    ///
    /// # Errors
    /// It cannot be read.
    pub(crate) fn get(&mut self, name: &Name) -> Result<Option<Kept>, StudyError> {
        let Some(place) = self.places.get(&half(name)).copied().filter(|place| *place > 0) else {
            return Ok(None);
        };
        let mut bytes = Vec::new();
        let left = self.end.saturating_sub(place);
        let file = &mut self.file;
        let whole = file
            .seek(SeekFrom::Start(place))
            .and_then(|_| record(&mut BufReader::with_capacity(512, file), left, &mut bytes));
        let whole = whole.map_err(|error| StudyError::file(&self.path, error))?;
        let kept = if whole { decode(&bytes) } else { None };
        match kept {
            Some(kept) if kept.name == *name => Ok(Some(kept)),
            _ => Err(StudyError::file(&self.path, format!("the record at byte {place} is damaged"))),
        }
    }
}

/// The key of the table of places: with a million points, two have the same with a chance of 3 in 100 million, which
/// [`Store::get`] notices.
fn half(name: &Name) -> u64 {
    name.first_chunk().map_or(0, |bytes| u64::from_le_bytes(*bytes))
}

/// Reads the payload of the next record; `false` where there is no whole one.
fn record(reader: &mut impl Read, left: u64, bytes: &mut Vec<u8>) -> io::Result<bool> {
    if left < 8 {
        return Ok(false);
    }
    let mut head = [0; 8];
    reader.read_exact(&mut head)?;
    let [length, sum] =
        [0, 4].map(|at| head.get(at..at + 4).and_then(|b| b.try_into().ok()).map_or(0, u32::from_le_bytes));
    if length > MOST_RECORD_BYTES || u64::from(length) > left - 8 {
        return Ok(false);
    }
    bytes.resize(length as usize, 0);
    reader.read_exact(bytes)?;
    Ok(crc32fast::hash(bytes) == sum)
}

fn encode(kept: &Kept) -> Vec<u8> {
    let mut out = Vec::with_capacity(128);
    out.extend(kept.name);
    out.push(kept.outcome.status as u8);
    out.extend(u64::try_from(kept.outcome.time.as_nanos()).unwrap_or(u64::MAX).to_le_bytes());
    let texts = [&kept.outcome.reason, &kept.files[0], &kept.files[1]];
    texts.iter().for_each(|text| Cell::Text((*text).clone()).encode(&mut out));
    kept.outcome.cells.iter().for_each(|cell| cell.encode(&mut out));
    out
}

fn decode(bytes: &[u8]) -> Option<Kept> {
    let mut rest = bytes;
    let name = taken(&mut rest)?;
    let [status] = taken(&mut rest)?;
    let time = Duration::from_nanos(u64::from_le_bytes(taken(&mut rest)?));
    let mut text = || match cell(&mut rest)? {
        Cell::Text(text) => Some(text),
        _ => None,
    };
    let (reason, files) = (text()?, [text()?, text()?]);
    let mut cells = Vec::new();
    while !rest.is_empty() {
        cells.push(cell(&mut rest)?);
    }
    let outcome = Outcome { status: Status::of_byte(status)?, reason, cells, time };
    Some(Kept { name, outcome, files })
}

fn taken<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    let (head, tail) = rest.split_first_chunk()?;
    *rest = tail;
    Some(*head)
}

fn cell(rest: &mut &[u8]) -> Option<Cell> {
    let [kind] = taken(rest)?;
    Some(match kind {
        0 => Cell::Null,
        1 => Cell::Boolean(taken::<1>(rest)? != [0]),
        2 => Cell::Number(f64::from_bits(u64::from_le_bytes(taken(rest)?))),
        3 => {
            let length = u32::from_le_bytes(taken(rest)?);
            let (head, tail) = rest.split_at_checked(length as usize)?;
            *rest = tail;
            Cell::Text(String::from_utf8(head.to_vec()).ok()?)
        }
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn kept(n: u8, x: f64) -> Kept {
        let cells = vec![Cell::Number(x), Cell::Text("a\u{e9}".to_owned()), Cell::Null, Cell::Boolean(true)];
        let outcome = Outcome {
            status: Status::Warning,
            reason: "r".to_owned(),
            cells,
            time: Duration::from_nanos(17),
        };
        Kept { name: [n; 16], outcome, files: [String::new(), "g".to_owned()] }
    }

    #[test]
    fn what_is_cut_off_anywhere_is_cut_away_and_the_rest_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let open = || Store::open(&path, &[9; 16], |_| false);
        let mut store = open().unwrap();
        assert!(store.take(&[1; 16]) && !store.take(&[1; 16]));
        for n in 1..=3 {
            store.keep(&kept(n, f64::from(n))).unwrap();
            assert_eq!(store.get(&[1; 16]).unwrap(), Some(kept(1, 1.0)), "read in between");
        }
        assert!(open().is_err(), "two at a time");
        drop(store);
        let whole = std::fs::read(&path).unwrap();
        let length = (whole.len() - 24) / 3;
        for cut in 24..whole.len() {
            std::fs::write(&path, &whole[..cut]).unwrap();
            let mut store = open().unwrap();
            for n in 1..=3_u8 {
                let there = cut - 24 >= usize::from(n) * length;
                assert_eq!(store.get(&[n; 16]).unwrap(), there.then(|| kept(n, f64::from(n))), "{cut}");
            }
            store.keep(&kept(4, 4.0)).unwrap();
            drop(store);
            assert_eq!(open().unwrap().get(&[4; 16]).unwrap(), Some(kept(4, 4.0)));
        }
        assert!(Store::open(&path, &[8; 16], |_| false).is_err());
        let mut again = Store::open(&path, &[9; 16], |status| status == Status::Warning).unwrap();
        assert!(again.take(&[4; 16]));
    }

    proptest! {
        #[test]
        fn bytes_are_decoded_or_refused(bytes: Vec<u8>) {
            if let Some(kept) = decode(&bytes) {
                prop_assert_eq!(decode(&encode(&kept)).map(|k| encode(&k)), Some(encode(&kept)));
            }
        }
    }
}
