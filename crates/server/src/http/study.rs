//! The page on the folder of a study: its rows, its pictures, and its points opened in the studio.

use std::path::Path;
use std::sync::{Arc, Mutex};

use axum::Json;
use axum::body::Body;
use axum::extract::rejection::JsonRejection;
use axum::extract::{Path as Named, Query, State as Extract};
use axum::http::header::{CACHE_CONTROL, CONTENT_DISPOSITION, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use katydid_geometry::Units;
use katydid_session::{assign_input, find_input};
use katydid_study::{About, DefinitionFile, Kind, Row, StudyFolder};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::State;
use super::answer::Refused;
use super::api::{Answer, Question, asked, blocking, opened};
use crate::config::StudyConfig;
use crate::document::Source;
use crate::lock::held;

/// So many rows are kept and shown; of more, evenly chosen ones.
const MOST_ROWS: usize = 20_000;
/// Pictures and geometry that are larger are not handed out.
const MOST_FILE: u64 = 256 << 20;

/// A study that is looked at.
#[derive(Debug)]
pub(crate) struct Study {
    folder: Mutex<StudyFolder>,
    /// The definition, where the folder does not say which it is or it lies elsewhere now.
    definition: Option<DefinitionFile>,
}

/// What the page is told: the rows from a place on, or all where it has others than there are now.
#[derive(Debug, Serialize)]
struct Told<'a> {
    generation: u64,
    from: usize,
    /// Rows of the study, with those that are not told.
    total: u64,
    /// How many there will be, where that is known.
    planned: Option<u64>,
    state: &'static str,
    name: String,
    /// The name of the definition, where points can be opened.
    definition: Option<String>,
    goals: Value,
    bounds: Value,
    columns: Vec<ColumnTold<'a>>,
    rows: Vec<RowTold<'a>>,
    /// Why what is told may be old.
    problem: Option<String>,
}

#[derive(Debug, Serialize)]
struct ColumnTold<'a> {
    name: &'a str,
    kind: &'static str,
    number: bool,
}

/// A row as a list: point, status, reason, picture, geometry, cells.
type RowTold<'a> = (u64, &'a str, &'a str, &'a str, &'a str, Vec<Value>);

impl Study {
    /// A study in a folder.
    ///
    /// # Errors
    /// There is no such folder.
    pub(crate) fn open(config: &StudyConfig) -> Result<Self, String> {
        let folder = StudyFolder::open(&config.folder, MOST_ROWS).map_err(|error| error.to_string())?;
        let definition =
            config.definition.clone().map(|file| DefinitionFile { file, ..DefinitionFile::default() });
        Ok(Self { folder: Mutex::new(folder), definition })
    }

    fn definition(&self, about: Option<&About>) -> Option<DefinitionFile> {
        self.definition.clone().or_else(|| about?.definition.clone())
    }

    fn tell(&self, has: &Having) -> Result<Vec<u8>, String> {
        let mut folder = held(&self.folder);
        let problem = folder.refresh().err().map(|error| error.to_string());
        let is_known = folder.generation() == has.generation && has.from <= folder.rows().len();
        let from = if is_known { has.from } else { 0 };
        let about = folder.about();
        let named = |list: Result<Value, serde_json::Error>| list.unwrap_or_default();
        let name = folder.path().file_name().map(|name| name.to_string_lossy().into_owned());
        let column = |column: &'_ katydid_study::Column| match column.kind {
            Kind::Input => "in",
            Kind::Output => "out",
        };
        let told = Told {
            generation: folder.generation(),
            from,
            total: folder.row_count(),
            planned: about.map(|about| about.points),
            state: folder.state().word(),
            name: name.unwrap_or_default(),
            definition: self
                .definition(about)
                .and_then(|definition| Some(definition.file.file_name()?.to_string_lossy().into_owned())),
            goals: named(serde_json::to_value(about.map(|about| &about.goals))),
            bounds: named(serde_json::to_value(about.map(|about| &about.bounds))),
            columns: folder
                .columns()
                .iter()
                .map(|one| ColumnTold { name: &one.name, kind: column(one), number: one.is_number })
                .collect(),
            rows: folder.rows().iter().skip(from).map(row_told).collect(),
            problem,
        };
        serde_json::to_vec(&told).map_err(|error| error.to_string())
    }

    /// The definition with its inputs at a point: a document of its own, which is kept nowhere until somebody saves it.
    fn point(&self, point: u64) -> Result<Source, String> {
        let folder = held(&self.folder);
        let row = folder.row(point).ok_or_else(|| format!("there is no point {point}"))?;
        let definition = self.definition(folder.about()).ok_or(
            "the folder does not say which definition the study is of: start with --definition FILE",
        )?;
        let DefinitionFile { file, model, units, set } = &definition;
        let mut source = Source::file(file)
            .map_err(|error| format!("{error}; start with --definition FILE where it lies elsewhere now"))?;
        if let Some(model) = model {
            source = source.with_model(model)?;
        }
        source.rules.units = units.as_deref().and_then(units_of).unwrap_or(source.rules.units);
        for (name, value) in set {
            let input = find_input(&source.document, name).map_err(|error| error.to_string())?;
            if let Some(object) = source.document.objects.get_mut(input) {
                assign_input(object, value).map_err(|error| error.to_string())?;
            }
        }
        folder.place(row, &mut source.document).map_err(|error| error.to_string())?;
        let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        Ok(source.copied(format!("{} point {point}", stem.unwrap_or_default())))
    }
}

fn row_told(row: &Row) -> RowTold<'_> {
    let cells = row.cells.iter().map(katydid_study::Cell::json).collect();
    (row.point, &row.status, &row.reason, &row.picture, &row.geometry, cells)
}

fn units_of(name: &str) -> Option<Units> {
    use Units::{Centimeters, Feet, Inches, Kilometers, Meters, Microns, Miles, Millimeters, None, Yards};
    let all = [None, Microns, Millimeters, Centimeters, Meters, Kilometers, Inches, Feet, Yards, Miles];
    all.into_iter().find(|units| units.name() == name)
}

fn study(state: &State) -> Answer<Arc<Study>> {
    state.study.clone().ok_or_else(|| Refused::missing("study: it is opened with katydid study FOLDER"))
}

/// Which rows a page has.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct Having {
    #[serde(default)]
    generation: u64,
    #[serde(default)]
    from: usize,
}

/// The rows that a page does not have.
pub(crate) async fn rows(Extract(state): Extract<Arc<State>>, query: Question<Having>) -> Answer<Response> {
    let has = asked(query)?;
    let study = study(&state)?;
    let bytes = blocking(move || study.tell(&has)).await?;
    Ok(([(CONTENT_TYPE, "application/json"), (CACHE_CONTROL, "no-store")], Body::from(bytes)).into_response())
}

/// Whether a file is to be kept by the browser.
#[derive(Debug, Deserialize)]
pub(crate) struct Keeping {
    #[serde(default)]
    download: bool,
}

/// A picture or geometry of the folder.
pub(crate) async fn file(
    Extract(state): Extract<Arc<State>>,
    Named(name): Named<String>,
    query: Result<Query<Keeping>, axum::extract::rejection::QueryRejection>,
) -> Answer<Response> {
    let download = asked(query)?.download;
    let study = study(&state)?;
    let found = blocking(move || {
        let Some(path) = held(&study.folder).file(&name) else { return Ok(None) };
        let told = |error: std::io::Error| crate::files::plain(&error).to_string();
        if std::fs::metadata(&path).map_err(told)?.len() > MOST_FILE {
            return Err(format!("more than {} MB are not handed out", MOST_FILE >> 20));
        }
        let kind = kind(&path);
        std::fs::read(&path).map_err(told).map(|bytes| Some((bytes, kind)))
    });
    let (bytes, kind) = found.await?.ok_or_else(|| Refused::missing("picture or geometry in the study"))?;
    let way = if download || !kind.starts_with("image/") { "attachment" } else { "inline" };
    let headers = [
        (CONTENT_TYPE, kind),
        (CONTENT_DISPOSITION, way),
        // Files that Katydid writes have a hash of their content for a name; others may change.
        (CACHE_CONTROL, "private, max-age=60"),
    ];
    Ok((headers, Body::from(bytes)).into_response())
}

fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|end| end.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("png") => "image/png",
        Some("jpg" | "jpeg") => "image/jpeg",
        Some("webp") => "image/webp",
        Some("gif") => "image/gif",
        _ => "application/octet-stream",
    }
}

/// Which point is to be opened.
#[derive(Debug, Deserialize)]
pub(crate) struct Opening {
    point: u64,
}

/// Opens a point in the studio.
pub(crate) async fn open(
    Extract(state): Extract<Arc<State>>,
    opening: Result<Json<Opening>, JsonRejection>,
) -> Answer<Json<Value>> {
    let Json(Opening { point }) = opening.map_err(|error| Refused::new(error.status(), error.body_text()))?;
    let study = study(&state)?;
    let source = blocking(move || study.point(point)).await?;
    opened(&state, source).await
}
