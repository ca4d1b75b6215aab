//! What a definition makes, as files of other programs.

use katydid_definition::document::ids;
use katydid_exchange::Format;
use katydid_picture::{HiddenLines, Options, View};
use katydid_session::{BakeOptions, bake, write_panel};
use katydid_solver::Engine;
use uuid::Uuid;

/// How a file is made.
#[derive(Debug, Clone, Default, serde::Deserialize)]
pub struct Wishes {
    /// The extension of the format.
    pub format: String,
    /// Of pictures, in pixels.
    width: Option<u32>,
    height: Option<u32>,
    /// `perspective`, `top`, `front`, `right`, `iso`.
    view: Option<String>,
    /// Whether the definition itself is drawn.
    #[serde(default)]
    canvas: bool,
    /// The ids of objects, with commas between: only what they have.
    objects: Option<String>,
}

impl Wishes {
    fn baking(&self) -> Result<BakeOptions, String> {
        let read = |id: &str| Uuid::try_parse(id).map_err(|_| format!("'{id}' is no id of an object"));
        let objects = self.objects.as_deref().filter(|ids| !ids.is_empty());
        let objects = objects.map(|ids| ids.split(',').map(read).collect()).transpose()?;
        Ok(BakeOptions { objects, ..BakeOptions::default() })
    }
}

/// The longer side of a picture of pixels.
const LONGEST: f64 = 8192.0;

/// The bytes of a file in that format, and their type.
///
/// # Errors
/// What is wrong with the wishes, or why the file cannot be written.
pub fn export(engine: &Engine, wishes: &Wishes) -> Result<(Vec<u8>, &'static str), String> {
    match wishes.format.as_str() {
        "3dm" => {
            let baked = bake(engine, wishes.baking()?);
            let (bytes, _) = baked.model.write_what_fits(70).map_err(|error| error.to_string())?;
            Ok((bytes, "model/vnd.3dm"))
        }
        "txt" => Ok((panel(engine, wishes)?, "text/plain; charset=utf-8")),
        "png" => Ok((drawing(engine, wishes)?.to_png().map_err(|error| error.to_string())?, "image/png")),
        "svg" => Ok((drawing(engine, wishes)?.to_svg().into_bytes(), "image/svg+xml")),
        other => {
            let format = Format::from_extension(other)
                .ok_or_else(|| format!("'{other}' is no format that can be written"))?;
            let baked = bake(engine, wishes.baking()?);
            let conversion = katydid_exchange::Conversion { exact: format.is_exact(), ..Default::default() };
            let scene = katydid_exchange::Scene::from_model_with(&baked.model, &conversion);
            let mut bytes = Vec::new();
            katydid_exchange::write(&scene, format, &Default::default(), &mut bytes)
                .map_err(|error| error.to_string())?;
            Ok((bytes, format.media_type()))
        }
    }
}

/// What one panel shows, as it is streamed to a file.
fn panel(engine: &Engine, wishes: &Wishes) -> Result<Vec<u8>, String> {
    let chosen = wishes.baking()?.objects.unwrap_or_default();
    if chosen.len() != 1 {
        return Err("one panel is written at a time".to_owned());
    }
    let mut objects = engine.document().objects.iter();
    let index = objects.position(|object| chosen.contains(&object.id) && object.component == ids::PANEL);
    let mut bytes = Vec::new();
    write_panel(engine, index.ok_or("it is no panel of this document")?, &mut bytes)
        .map_err(|error| error.to_string())?;
    Ok(bytes)
}

fn drawing(engine: &Engine, wishes: &Wishes) -> Result<katydid_picture::Drawing, String> {
    let side = |wish: Option<u32>, usual: u32| wish.unwrap_or(usual).clamp(16, LONGEST as u32);
    let view = match wishes.view.as_deref() {
        None | Some("") => None,
        Some("perspective") => Some(View::Perspective),
        Some("top") => Some(View::Top),
        Some("front") => Some(View::Front),
        Some("right") => Some(View::Right),
        Some("iso") => Some(View::Isometric),
        Some(other) => return Err(format!("'{other}' is no view: perspective, top, front, right or iso")),
    };
    let options = Options {
        size: [side(wishes.width, 1600), side(wishes.height, 1000)],
        view,
        hidden_lines: HiddenLines::Natural,
        ..Options::default()
    };
    if !wishes.canvas {
        return Ok(katydid_picture::result(engine, &options).drawing);
    }
    let drawing = katydid_picture::canvas(engine, &options);
    let factor = f64::min(LONGEST / drawing.size[0].max(drawing.size[1]).max(1.0), 1.0);
    Ok(drawing.scaled(factor))
}
