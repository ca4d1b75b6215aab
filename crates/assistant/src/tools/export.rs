//! What a definition makes, as files for other programs.

use std::collections::HashSet;
use std::path::Path;

use katydid_exchange::{Conversion, Format, Scene};
use katydid_session::{BakeOptions, bake};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::json;

use super::{Answer, Does, Entry, Reply, entry};
use crate::document::cut;
use crate::fault::Fault;
use crate::folders::Folders;
use crate::reference::Names;
use crate::store::Store;
use crate::thresholds::{ARCHIVE_VERSION, MOST_INLINE};
use crate::work;

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "export_geometry",
        "Export geometry",
        "Writes the geometry of the last solve to a file: .3dm (Rhino), .step, .obj, .stl, .ply, .glb, .gltf or .svg. What is \
         marked as output (Context Bake, RH_OUT), else all that is previewed, or that of the objects that are named. Without \
         a path, but with a format, the file comes in the answer, up to 4 MB. Tells how many objects it holds and what the \
         format leaves out.",
        Does::Writes,
        export,
    )]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Export {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The file: absolute, or from the first folder that is open; its extension is the format.
    path: Option<String>,
    /// The format, as `glb`, when the file shall come in the answer.
    format: Option<String>,
    /// Only what these objects give, by names or ids, previewed or not.
    objects: Option<Vec<String>>,
    /// Whether a file that is there is written over.
    #[serde(default)]
    overwrite: bool,
}

const WHAT: &str = "nothing was exported";
const KNOWN: &str = "3dm, step, obj, stl, ply, glb, gltf, svg";

fn export(store: &Store, given: Export) -> Result<Reply, Fault> {
    let opened = store.find(WHAT, given.document.as_deref())?;
    let extension = match (&given.path, &given.format) {
        (Some(_), Some(_)) => {
            return Err(Fault::new(WHAT, "path, format", "only one of the two can be given"));
        }
        (None, None) => return Err(Fault::new(WHAT, "path, format", "one of the two must be given")),
        (Some(path), None) => {
            Path::new(path).extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
        }
        (None, Some(format)) => format.trim_start_matches('.').to_lowercase(),
    };
    let format = Format::from_extension(&extension);
    if extension != "3dm" && format.is_none() {
        let place = given.path.or(given.format).unwrap_or_default();
        return Err(Fault::new(WHAT, cut(&place), format!("it is no format that can be written: {KNOWN}")));
    }
    let place = given.path.as_deref().map(|path| store.folders.place(path, given.overwrite)).transpose()?;
    let solved = opened.current(WHAT)?;
    let names = Names::new(solved.engine.document());
    let objects = given.objects.as_ref().map(|wanted| {
        let id = |name: &String| {
            let at = names.object(WHAT, name)?;
            let object = solved.engine.document().objects.get(at);
            object.map(|object| object.id).ok_or_else(|| Fault::new(WHAT, name, "it is gone"))
        };
        wanted.iter().map(id).collect::<Result<HashSet<_>, Fault>>()
    });
    let options = BakeOptions { objects: objects.transpose()?, ..BakeOptions::default() };
    let baked = work::within(WHAT, || bake(&solved.engine, options))?;
    let mut left_out = baked.left_out;
    let count = baked.model.objects.len();
    if count == 0 {
        let why = match left_out.first() {
            Some(first) => format!("no geometry could be put in a file: {}", cut(first)),
            None => "no object gives geometry that is previewed or marked as output; `objects` names others"
                .to_owned(),
        };
        return Err(Fault::new(WHAT, &opened.id, why));
    }
    let failed =
        |why: String| Fault::new(WHAT, given.path.clone().unwrap_or_else(|| extension.clone()), cut(&why));
    let (bytes, kind) = work::within(WHAT, || match format.filter(|_| extension != "3dm") {
        None => {
            let written =
                baked.model.write_what_fits(ARCHIVE_VERSION).map_err(|error| failed(error.to_string()))?;
            left_out.extend(written.1.iter().map(ToString::to_string));
            Ok((written.0, "model/vnd.3dm"))
        }
        Some(format) => {
            let conversion = Conversion { exact: format.is_exact(), ..Default::default() };
            let scene = Scene::from_model_with(&baked.model, &conversion);
            let mut bytes = Vec::new();
            let lost = katydid_exchange::write(&scene, format, &Default::default(), &mut bytes)
                .map_err(|error| failed(error.to_string()))?;
            left_out.extend(lost.iter().map(ToString::to_string));
            Ok((bytes, format.media_type()))
        }
    })??;
    let mut told = json!({
        "document": opened.id,
        "format": extension,
        "objects": count,
        "bytes": bytes.len(),
        "units": solved.engine.options().rules.units.name(),
        "left_out": left_out.iter().take(50).map(|what| cut(what)).collect::<Vec<_>>(),
        "remarks": baked.remarks.iter().take(50).map(|what| cut(what)).collect::<Vec<_>>(),
    });
    let Some(place) = place else {
        if bytes.len() > MOST_INLINE {
            let why = format!(
                "the file has {} bytes, {MOST_INLINE} come in an answer at most: give a path",
                bytes.len()
            );
            return Err(Fault::new(WHAT, extension, why));
        }
        let name = format!("{}.{extension}", opened.id);
        return Ok(Reply::Done(Answer { value: told, file: Some((name, kind, bytes)), ..Answer::default() }));
    };
    Folders::write(&place, &bytes)?;
    told["path"] = json!(place);
    Ok(told.into())
}
