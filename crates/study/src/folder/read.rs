//! The folder of a study, read again and again while it is made.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use katydid_definition::document::Document;

use super::about::About;
use super::live::{Tail, is_running};
use super::rows::{Column, Kind, Row, Thinned};
use super::{file, table};
use crate::{Cell, StudyError, Variable};

/// How a study stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum State {
    /// There is nothing to read yet.
    #[default]
    Empty,
    /// It is being made.
    Running,
    /// It was ended before all points were solved.
    Stopped,
    /// The tables are written.
    Done,
}

impl State {
    /// The word for it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::Running => "running",
            Self::Stopped => "stopped",
            Self::Done => "done",
        }
    }
}

/// What a folder's rows come from, as it was when they were read.
#[derive(Debug, Default)]
enum Source {
    #[default]
    None,
    Live(Tail),
    Table {
        path: PathBuf,
        stamp: Stamp,
    },
}

/// Tells a file from the one that was there before.
type Stamp = (u64, Option<SystemTime>);

/// The folder of a study: `katydid sweep` or `katydid optimise` made it or is making it, or another program that writes
/// `data.csv` for Design Explorer.
#[derive(Debug)]
pub struct StudyFolder {
    path: PathBuf,
    most: usize,
    about: Option<About>,
    state: State,
    source: Source,
    found: Thinned,
}

impl StudyFolder {
    /// Opens a folder; `most` rows of it are kept at a time, evenly chosen. Nothing is read before [`refresh`](Self::refresh).
    ///
    /// # Errors
    /// There is no such folder.
    pub fn open(folder: &Path, most: usize) -> Result<Self, StudyError> {
        let path = folder.canonicalize().map_err(|error| StudyError::file(folder, error))?;
        if !path.is_dir() {
            return Err(StudyError::file(folder, "it is no folder"));
        }
        Ok(Self {
            path,
            most,
            about: None,
            state: State::Empty,
            source: Source::None,
            found: Thinned::new(most),
        })
    }

    /// Reads what is new. After an error everything is as it was before.
    ///
    /// # Errors
    /// A file cannot be read or is damaged.
    pub fn refresh(&mut self) -> Result<(), StudyError> {
        let is_running = is_running(&self.path);
        if let Some(path) = Tail::path(&self.path) {
            self.state = if is_running { State::Running } else { State::Stopped };
            return self.follow(&path);
        }
        let tables = ["table.parquet", "data.csv"].map(|name| self.path.join(name));
        let Some((path, stamp)) = tables.into_iter().find_map(|path| stamp(&path).map(|stamp| (path, stamp)))
        else {
            self.state = if is_running { State::Running } else { State::Empty };
            return Ok(());
        };
        let is_same = matches!(&self.source, Source::Table { path: known, stamp: at } if *known == path && *at == stamp);
        if !is_same {
            table::read(&path, &mut self.found, self.most)?;
            self.about = About::read(&self.path)?;
            self.source = Source::Table { path, stamp };
        }
        self.state = State::Done;
        Ok(())
    }

    fn follow(&mut self, path: &Path) -> Result<(), StudyError> {
        // What the rows are of was written before them; a file that is shorter than it was is another study's.
        for _ in 0..2 {
            if !matches!(self.source, Source::Live(_)) {
                let about = About::read(&self.path)?;
                let about =
                    about.ok_or_else(|| StudyError::file(path, "there is no study.json beside it"))?;
                self.found.clear(Tail::columns(&about));
                self.about = Some(about);
                self.source = Source::Live(Tail::default());
            }
            let Source::Live(tail) = &mut self.source else { break };
            if tail.read(path, |row| self.found.push(row))? {
                break;
            }
            self.source = Source::None;
        }
        Ok(())
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How it stands.
    pub fn state(&self) -> State {
        self.state
    }

    /// What it is of, where the folder says so.
    pub fn about(&self) -> Option<&About> {
        self.about.as_ref()
    }

    /// The columns of the rows.
    pub fn columns(&self) -> &[Column] {
        &self.found.columns
    }

    /// The rows that are kept, in the order in which they came or stand in the table.
    pub fn rows(&self) -> &[Row] {
        &self.found.rows
    }

    /// How many rows there are, with those that are not kept.
    pub fn row_count(&self) -> u64 {
        self.found.seen
    }

    /// Goes up when rows that were here are gone; otherwise rows only come to the end.
    pub fn generation(&self) -> u64 {
        self.found.generation
    }

    /// The row of a point.
    pub fn row(&self, point: u64) -> Option<&Row> {
        self.found.rows.iter().find(|row| row.point == point)
    }

    /// A picture or geometry of that name in the folder; `None` for everything else, and for what a link leads out to.
    pub fn file(&self, name: &str) -> Option<PathBuf> {
        file::find(&self.path, name)
    }

    /// Sets the inputs of a document to those of a row.
    ///
    /// # Errors
    /// The document has no such input, or the input does not take the value.
    pub fn place(&self, row: &Row, document: &mut Document) -> Result<(), StudyError> {
        let inputs = self.found.columns.iter().zip(&row.cells);
        for (column, cell) in inputs.filter(|(column, _)| column.kind == Kind::Input) {
            let variable = Variable::find(document, &column.name)?;
            if *cell != Cell::Null {
                variable.write(document, cell)?;
            }
        }
        Ok(())
    }
}

fn stamp(path: &Path) -> Option<Stamp> {
    let about = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    Some((about.len(), about.modified().ok()))
}
