//! Figures, as pages describe them.

use katydid_picture::View;
use serde_json::{Value as Json, json};

use crate::block::Block;
use crate::fault::Fault;
use crate::palette::Hue;

/// The keys of a figure.
pub(crate) const KEYS: [&str; 13] = [
    "id",
    "definition",
    "numbers",
    "view",
    "controls",
    "drag",
    "only",
    "colours",
    "widgets",
    "say",
    "caption",
    "alt",
    "title",
];
/// Those that are words.
pub(crate) const WORDS: [&str; 6] = ["id", "controls", "say", "caption", "alt", "title"];
/// More hide what matters.
const MOST_CONTROLS: usize = 4;
/// The guide's newest edition has so many figures.
pub(crate) const LAST_NUMBER: u32 = 75;
const WIDGETS: [&str; 7] = ["knots", "basis", "comb", "hodograph", "matrix", "uv", "colours"];
const MEASURES: [&str; 4] = ["gaussian", "mean", "minimum", "maximum"];

/// A figure.
#[derive(Debug, Clone)]
pub(crate) struct Figure {
    pub(crate) id: String,
    /// Its definition, from the book's folder.
    pub(crate) definition: String,
    pub(crate) numbers: Vec<u32>,
    pub(crate) view: View,
    /// Names with their labels.
    pub(crate) controls: Vec<(String, String)>,
    pub(crate) drag: Vec<String>,
    pub(crate) only: Vec<String>,
    pub(crate) colours: Vec<(String, Hue)>,
    pub(crate) widgets: Vec<Widget>,
    pub(crate) caption: String,
    pub(crate) alt: String,
    pub(crate) block: Block,
}

/// What stands beside the picture of a figure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Widget {
    pub(crate) kind: String,
    pub(crate) object: String,
    pub(crate) at: Vec<String>,
    pub(crate) measure: Option<String>,
}

impl Figure {
    /// Reads one of a page in `folder`.
    pub(crate) fn read(folder: &str, block: &Block) -> Result<Self, Fault> {
        let id = block.needed("id")?.to_owned();
        if !id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-') {
            return Err(block.fault("id", format!("'{id}': an id has small letters, digits and hyphens")));
        }
        let definition = match block.get("definition").unwrap_or("definition.kd") {
            path if path.starts_with('/') => path.trim_start_matches('/').to_owned(),
            path => format!("{folder}/{path}"),
        };
        if definition.split('/').any(|part| part.is_empty() || part.starts_with('.')) {
            return Err(block.fault("definition", format!("'{definition}' is no path in the book")));
        }
        let view = match block.get("view").unwrap_or("perspective") {
            "perspective" => View::Perspective,
            "top" => View::Top,
            "front" => View::Front,
            "right" => View::Right,
            other => {
                let why = format!("view: '{other}' is none of top, front, right, perspective");
                return Err(block.fault("view", why));
            }
        };
        let numbers = block.list("numbers").into_iter().map(|text| match text.parse() {
            Ok(n) if (1..=LAST_NUMBER).contains(&n) => Ok(n),
            _ => Err(block
                .fault("numbers", format!("'{text}' is no figure of the guide: they go to {LAST_NUMBER}"))),
        });
        let controls: Vec<(String, String)> =
            block.list("controls").iter().map(|text| labelled(text)).collect();
        if controls.len() > MOST_CONTROLS {
            let why = format!("{} controls: a figure has {MOST_CONTROLS} at most", controls.len());
            return Err(block.fault("controls", why));
        }
        let colours = block.list("colours").into_iter().map(|text| {
            let told = |why: String| block.fault("colours", why);
            let (name, hue) =
                text.rsplit_once('=').ok_or_else(|| told(format!("'{text}' is not `object = colour`")))?;
            let known = || Hue::ALL.map(Hue::name).join(", ");
            let hue = Hue::from_name(hue.trim());
            Ok((
                name.trim().to_owned(),
                hue.ok_or_else(|| told(format!("'{text}': colours are {}", known())))?,
            ))
        });
        block.needed("say")?;
        let widgets = block.list("widgets").into_iter();
        Ok(Self {
            id,
            definition,
            numbers: numbers.collect::<Result<_, Fault>>()?,
            view,
            controls,
            drag: block.list("drag"),
            only: block.list("only"),
            colours: colours.collect::<Result<_, Fault>>()?,
            widgets: widgets
                .map(|text| Widget::read(&text).map_err(|why| block.fault("widgets", why)))
                .collect::<Result<_, Fault>>()?,
            caption: block.get("caption").unwrap_or_default().to_owned(),
            alt: block.needed("alt")?.replace('\n', " "),
            block: block.clone(),
        })
    }

    pub(crate) fn hue(&self, object: &str) -> Option<Hue> {
        self.colours.iter().find(|(name, _)| name == object).map(|(_, hue)| *hue)
    }

    /// What the page's script must know.
    pub(crate) fn to_json(&self) -> Json {
        let colours: serde_json::Map<String, Json> =
            self.colours.iter().map(|(name, hue)| (name.clone(), json!(hue.name()))).collect();
        let controls: Vec<Json> =
            self.controls.iter().map(|(name, label)| json!({"name": name, "label": label})).collect();
        let widgets: Vec<Json> = self.widgets.iter().map(Widget::to_json).collect();
        json!({
            "id": self.id,
            "definition": self.definition,
            "view": self.view.word(),
            "controls": controls,
            "drag": self.drag,
            "only": self.only,
            "colours": colours,
            "widgets": widgets,
        })
    }
}

impl Widget {
    fn read(text: &str) -> Result<Self, String> {
        let (kind, rest) = text.split_once(' ').ok_or_else(|| format!("'{text}' names no object"))?;
        if !WIDGETS.contains(&kind) {
            return Err(format!("there is no widget '{kind}': known are {}", WIDGETS.join(", ")));
        }
        let (object, at) = rest.trim().rsplit_once(" at ").unwrap_or((rest, ""));
        let (mut object, mut measure) = (object.trim(), None);
        if kind == "colours" {
            let (name, what) = object.rsplit_once(' ').ok_or_else(|| format!("'{text}' names no measure"))?;
            if !MEASURES.contains(&what) {
                return Err(format!("'{what}' is none of {}", MEASURES.join(", ")));
            }
            (object, measure) = (name, Some(what.to_owned()));
        }
        Ok(Self {
            kind: kind.to_owned(),
            object: object.to_owned(),
            at: at.split_whitespace().map(str::to_owned).collect(),
            measure,
        })
    }

    /// The sliders that it names. Those of cells of a matrix have the row and column behind a colon: `xS:11`.
    pub(crate) fn sliders(&self) -> impl Iterator<Item = &str> {
        let is_matrix = self.kind == "matrix";
        let is_cell = |cell: &str| cell.len() == 2 && cell.bytes().all(|b| b.is_ascii_digit());
        self.at.iter().map(move |text| match text.rsplit_once(':') {
            Some((name, cell)) if is_matrix && is_cell(cell) => name,
            _ => text.as_str(),
        })
    }

    fn to_json(&self) -> Json {
        json!({"kind": self.kind, "object": self.object, "at": self.at, "measure": self.measure})
    }
}

/// `name (label)`; without a label the name.
fn labelled(text: &str) -> (String, String) {
    match text.strip_suffix(')').and_then(|rest| rest.split_once('(')) {
        Some((name, label)) => (name.trim().to_owned(), label.trim().to_owned()),
        None => (text.to_owned(), text.to_owned()),
    }
}
