//! Outcomes on the disk, by the content of their points: what is there is not solved again.
//!
//! A file of records that only grows. Each record has its length and a checksum before it, so that what a crash or a full disk
//! cut off is told from what is whole, and is cut away when the file is opened again. Where each record is, [`Places`] know.

use std::collections::HashSet;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::places::Places;
use crate::record::{Kept, Name, decode, framed, record};
use crate::thresholds::SYNC_EVERY;
use crate::{Status, StudyError};

/// What a store's file begins with; the last byte is the version of the form.
const MAGIC: [u8; 8] = *b"KDSTUDY\x01";
/// The magic and the name of the study.
const HEADER: u64 = 24;

/// The file, and where in it each point is.
#[derive(Debug)]
pub(crate) struct Store {
    path: PathBuf,
    file: File,
    places: Places,
    /// The points that are being solved.
    awaited: HashSet<Name>,
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
        let folder = path.parent().unwrap_or(Path::new("."));
        let mut store = Self {
            path: path.to_path_buf(),
            file,
            places: Places::new(folder).map_err(failed)?,
            awaited: HashSet::new(),
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
                    self.places.forget(&kept.name)?;
                } else {
                    self.places.set(&kept.name, self.end)?;
                }
            }
            self.end += 8 + bytes.len() as u64;
        }
        self.file.set_len(self.end)?;
        self.file.seek(SeekFrom::Start(self.end))?;
        Ok(())
    }

    /// Takes a point to be solved; `false` when it was solved or is being solved.
    ///
    /// # Errors
    /// The table of places cannot be read.
    pub(crate) fn take(&mut self, name: &Name) -> Result<bool, StudyError> {
        Ok(!self.has(name)? && self.awaited.insert(*name))
    }

    /// Whether a point was handed out and has no outcome yet.
    pub(crate) fn is_awaited(&self, name: &Name) -> bool {
        self.awaited.contains(name)
    }

    /// Whether there is an outcome of a point.
    ///
    /// # Errors
    /// The table of places cannot be read.
    pub(crate) fn has(&mut self, name: &Name) -> Result<bool, StudyError> {
        self.place(name).map(|place| place.is_some())
    }

    fn place(&mut self, name: &Name) -> Result<Option<u64>, StudyError> {
        self.places.get(name).map_err(|error| StudyError::file(&self.path, error))
    }

    /// A file that could not be written.
    fn goes_on(&self, error: &io::Error) -> StudyError {
        StudyError::file(&self.path, format!("{error}: what is solved is kept, and the same command goes on"))
    }

    /// Keeps an outcome. After an error all of it is in the file or nothing.
    ///
    /// # Errors
    /// It cannot be written.
    pub(crate) fn keep(&mut self, kept: &Kept) -> Result<(), StudyError> {
        let bytes = framed(kept);
        if let Err(error) = self.append(&bytes) {
            // Half a record is cut away now where that can be done, else when the file is opened again.
            let _ = self
                .file
                .set_len(self.end)
                .and_then(|()| self.file.seek(SeekFrom::Start(self.end)).map(drop));
            return Err(self.goes_on(&error));
        }
        let place = self.end;
        self.end += bytes.len() as u64;
        self.places.set(&kept.name, place).map_err(|error| self.goes_on(&error))?;
        self.awaited.remove(&kept.name);
        Ok(())
    }

    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        // Whoever read a record has left the file's position behind it.
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
        let Some(place) = self.place(name)? else { return Ok(None) };
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

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::{Cell, Outcome};

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
        assert!(store.take(&[1; 16]).unwrap() && !store.take(&[1; 16]).unwrap());
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
        assert!(again.take(&[4; 16]).unwrap());
    }

    #[test]
    fn what_is_kept_after_a_record_was_read_lies_behind_all_others() {
        let folder = tempfile::tempdir().unwrap();
        let mut store = Store::open(&folder.path().join("a"), &[9; 16], |_| false).unwrap();
        // More than what a read takes ahead.
        for n in 1..=40 {
            store.keep(&kept(n, f64::from(n))).unwrap();
        }
        assert_eq!(store.get(&[1; 16]).unwrap(), Some(kept(1, 1.0)));
        store.keep(&kept(41, 41.0)).unwrap();
        for n in 1..=41 {
            assert_eq!(store.get(&[n; 16]).unwrap(), Some(kept(n, f64::from(n))));
        }
    }
}
