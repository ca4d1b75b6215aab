//! What is solved so far, while a study is made: `points.jsonl`. The tables are written at the end, in the order of the plan.

use std::fs::{self, File, TryLockError};
use std::io::{BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::about::About;
use super::rows::{Column, Kind, Row};
use crate::record::Kept;
use crate::thresholds::{MOST_RECORD_BYTES, TELL_EVERY};
use crate::{Cell, StudyError};

/// The name of the file in the study's folder. A line is a row; the last one may be half written.
const NAME: &str = "points.jsonl";
/// The file that whoever makes the study holds locked.
const LOCK: &str = "cache/running";
/// Who looks whether the file is locked holds it for a moment: so often is it tried again, after so long.
const TRIES: u32 = 20;
const WAIT: Duration = Duration::from_millis(5);

/// A row as a line of JSON.
#[derive(Debug, Serialize, Deserialize)]
struct Line {
    point: u64,
    #[serde(rename = "in")]
    inputs: Vec<Value>,
    out: Vec<Value>,
    status: String,
    #[serde(default)]
    reason: String,
    #[serde(default)]
    img: String,
    #[serde(default)]
    geometry: String,
}

/// The file of rows, being written. It goes away with [`finish`](Self::finish); otherwise it stays for whoever looks.
#[derive(Debug)]
pub(crate) struct Log {
    path: PathBuf,
    writer: BufWriter<File>,
    flushed: Instant,
    /// Locked as long as this is here.
    _running: File,
}

impl Log {
    /// Begins the file, and writes what the study is of beside it.
    ///
    /// # Errors
    /// A file cannot be written, or another study is being made in this folder.
    pub(crate) fn begin(folder: &Path, about: &About) -> Result<Self, StudyError> {
        let running = hold(&folder.join(LOCK))?;
        about.write(folder)?;
        let path = folder.join(NAME);
        let file = File::create(&path).map_err(|error| StudyError::file(&path, error))?;
        Ok(Self { path, writer: BufWriter::new(file), flushed: Instant::now(), _running: running })
    }

    /// Adds a point. It may be in memory only for a moment, so that quick points cost no call of the system each.
    ///
    /// # Errors
    /// It cannot be written.
    pub(crate) fn row(&mut self, point: u64, inputs: &[Cell], kept: &Kept) -> Result<(), StudyError> {
        let line = Line {
            point,
            inputs: inputs.iter().map(Cell::json).collect(),
            out: kept.outcome.cells.iter().map(Cell::json).collect(),
            status: kept.outcome.status.word().to_owned(),
            reason: kept.outcome.reason.clone(),
            img: kept.files[0].clone(),
            geometry: kept.files[1].clone(),
        };
        let text = serde_json::to_string(&line).map_err(|error| StudyError::file(&self.path, error))?;
        let mut written = writeln!(self.writer, "{text}");
        if self.flushed.elapsed() >= TELL_EVERY {
            written = written.and_then(|()| self.writer.flush());
            self.flushed = Instant::now();
        }
        written.map_err(|error| StudyError::file(&self.path, error))
    }

    /// Takes the file away: the tables have everything.
    ///
    /// # Errors
    /// It cannot be removed.
    pub(crate) fn finish(&self) -> Result<(), StudyError> {
        fs::remove_file(&self.path).map_err(|error| StudyError::file(&self.path, error))
    }
}

fn hold(path: &Path) -> Result<File, StudyError> {
    let file = File::options()
        .write(true)
        .create(true)
        .truncate(false)
        .open(path)
        .map_err(|error| StudyError::file(path, error))?;
    for _ in 0..TRIES {
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => std::thread::sleep(WAIT),
            // Some file systems have no locks; then it is on the user.
            Ok(()) | Err(TryLockError::Error(_)) => return Ok(file),
        }
    }
    Err(StudyError::file(path, "another study is being made in this folder"))
}

/// Whether somebody makes the study now.
pub(super) fn is_running(folder: &Path) -> bool {
    let Ok(file) = File::open(folder.join(LOCK)) else { return false };
    matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock))
}

/// The file of rows, being read: each call goes on where the last one ended.
#[derive(Debug, Default)]
pub(super) struct Tail {
    /// Where the lines that were read end.
    end: u64,
}

impl Tail {
    /// The file of a folder, where it is there.
    pub(super) fn path(folder: &Path) -> Option<PathBuf> {
        let path = folder.join(NAME);
        fs::metadata(&path).is_ok_and(|about| about.is_file()).then_some(path)
    }

    /// The columns of its rows.
    pub(super) fn columns(about: &About) -> Vec<Column> {
        let new = |name: &String, kind| Column { name: name.clone(), kind, is_number: true };
        let inputs = about.inputs.iter().map(|name| new(name, Kind::Input));
        inputs.chain(about.outputs.iter().map(|name| new(name, Kind::Output))).collect()
    }

    /// Gives all whole lines that came since; `false` when the file is not the one that it was: it is to be read from the
    /// beginning, into nothing.
    ///
    /// # Errors
    /// The file cannot be read, or a line is none of a study.
    pub(super) fn read(&mut self, path: &Path, mut take: impl FnMut(Row)) -> Result<bool, StudyError> {
        let failed = |error: &dyn std::fmt::Display| StudyError::file(path, error);
        let mut file = File::open(path).map_err(|error| failed(&error))?;
        if file.metadata().map_err(|error| failed(&error))?.len() < self.end {
            self.end = 0;
            return Ok(false);
        }
        file.seek(SeekFrom::Start(self.end)).map_err(|error| failed(&error))?;
        let mut reader = BufReader::new(file);
        let mut bytes = Vec::new();
        loop {
            bytes.clear();
            let most = u64::from(MOST_RECORD_BYTES);
            let read = (&mut reader).take(most).read_until(b'\n', &mut bytes);
            let length = read.map_err(|error| failed(&error))? as u64;
            if bytes.last() != Some(&b'\n') {
                // The line is not written to its end yet.
                let is_too_long = length == most;
                return if is_too_long { Err(failed(&"a line is too long")) } else { Ok(true) };
            }
            let at = self.end;
            self.end += length;
            let line: Line =
                serde_json::from_slice(&bytes).map_err(|error| failed(&format!("at byte {at}: {error}")))?;
            take(row(line));
        }
    }
}

fn row(line: Line) -> Row {
    let cells = line.inputs.iter().chain(&line.out).map(Cell::of_json).collect();
    let Line { point, status, reason, img, geometry, .. } = line;
    Row { point, cells, status, reason, picture: img, geometry }
}
