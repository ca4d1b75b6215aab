//! Pictures of what a definition makes, and of the definition itself.

use katydid_picture::{HiddenLines, Options, View, canvas, result};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::json;

use super::{Answer, Does, Entry, Reply, entry};
use crate::fault::Fault;
use crate::store::Store;
use crate::thresholds::{PICTURE_SIDES, USUAL_PICTURE};
use crate::work;

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "picture",
        "Picture",
        "A picture (PNG) of what the definition makes, or of the definition itself on its canvas with wires, panels and \
         groups. Shows the results of the last solve; objects with their preview off are not shown.",
        Does::Reads,
        picture,
    )]
}

/// What is drawn.
#[derive(Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Of {
    /// What the definition makes.
    #[default]
    Result,
    /// The definition itself.
    Canvas,
}

/// Where to look from.
#[derive(Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum From {
    Perspective,
    Top,
    Front,
    Right,
    Iso,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Picture {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// What is drawn: `result` or `canvas`.
    #[serde(default)]
    of: Of,
    /// Where to look from; from above where everything is flat, else in perspective, when not given.
    view: Option<From>,
    /// Pixels, 64 to 2048; 1024 when not given.
    width: Option<u32>,
    /// Pixels, 64 to 2048; 768 when not given.
    height: Option<u32>,
    /// Whether the axes are drawn.
    #[serde(default)]
    axes: bool,
    /// Whether a grid is drawn.
    #[serde(default)]
    grid: bool,
}

fn picture(store: &Store, given: Picture) -> Result<Reply, Fault> {
    const WHAT: &str = "no picture was made";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let size = [given.width.unwrap_or(USUAL_PICTURE[0]), given.height.unwrap_or(USUAL_PICTURE[1])];
    for (side, name) in size.iter().zip(["width", "height"]) {
        if !PICTURE_SIDES.contains(side) {
            let why = format!("it goes from {} to {} pixels", PICTURE_SIDES.start(), PICTURE_SIDES.end());
            return Err(Fault::new(WHAT, name, why));
        }
    }
    let options = Options {
        size,
        view: given.view.map(|from| match from {
            From::Perspective => View::Perspective,
            From::Top => View::Top,
            From::Front => View::Front,
            From::Right => View::Right,
            From::Iso => View::Isometric,
        }),
        axes: given.axes,
        grid: given.grid,
        hidden_lines: HiddenLines::Natural,
        ..Options::default()
    };
    let mut told = json!({ "document": opened.id });
    let drawing = if given.of == Of::Canvas {
        // The definition as it stands, with the results of what stands in it still.
        let mut engine = katydid_solver::Engine::clone(&opened.solved().engine);
        let document = opened.document();
        let difference = katydid_definition::document::Difference::between(engine.document(), &document);
        if engine.apply(&difference).is_err() {
            engine = katydid_solver::Engine::new(
                katydid_definition::document::Document::clone(&document),
                engine.options().clone(),
            );
        }
        if document.objects.is_empty() {
            told["note"] = json!("the definition is empty");
        }
        work::within(WHAT, || canvas(&engine, &options).fitted(size.map(f64::from)))?
    } else {
        let solved = opened.results(WHAT)?;
        let picture = work::within(WHAT, || result(&solved.engine, &options))?;
        if picture.is_empty {
            told["note"] = json!("nothing to show: no object with its preview on gives geometry");
        }
        if !picture.left_out.is_empty() {
            told["left_out"] = json!(picture.left_out);
        }
        picture.drawing
    };
    let png = work::within(WHAT, || drawing.to_png())?;
    let png = png.map_err(|error| Fault::new(WHAT, "", error.to_string()))?;
    told["results"] = opened.standing();
    told["size"] = json!(size);
    Ok(Reply::Done(Answer { value: told, pictures: vec![png], file: None }))
}
