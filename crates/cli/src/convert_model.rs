//! `katydid convert` for models: .3dm to .3dm of another version, and to and from other programs' files.

use std::path::Path;

use katydid_3dm::Model;
use katydid_exchange::{Conversion, Format, LeftOut, Options, Scene};

use crate::args::ConvertArgs;
use crate::output::{GREEN, YELLOW, extension, note, write_file};
use crate::{model_file, scene_file, source};

/// The version that a model is written in when nobody says and its own is not written any more.
const USUAL: i32 = 70;

/// Whether files of that extension hold models, not definitions.
pub(crate) fn is_model(extension: &str) -> bool {
    extension == "3dm" || Format::from_extension(extension).is_some()
}

pub(crate) fn convert(args: &ConvertArgs) -> Result<u8, String> {
    let (from, to) = (extension(&args.from), extension(&args.to));
    if !is_model(&from) {
        return Err(format!("{}: {}", args.from.display(), no_model(&from)));
    }
    if !is_model(&to) {
        return Err(format!("{}: a model can be converted to {}", args.to.display(), model_extensions()));
    }
    if args.version.is_some() && to != "3dm" {
        return Err("--version is for .3dm files".to_owned());
    }
    if args.lenient && from != "3dm" {
        return Err("--lenient is for .3dm files that are read".to_owned());
    }
    let bytes = source::bytes(&args.from)?;
    let model = match Format::from_extension(&from) {
        None => model_file::read(&args.from, &bytes, args.lenient)?,
        Some(format) => {
            let scene = read_scene(args, format, &bytes)?;
            if let Some(format) = Format::from_extension(&to) {
                return write_scene(args, &scene, format).map(|()| 0);
            }
            scene.left_out.iter().for_each(left_out);
            scene.to_model()
        }
    };
    drop(bytes);
    let is_partial = model_file::tell(&args.from, &model);
    match Format::from_extension(&to) {
        Some(format) => {
            let conversion =
                Conversion { tolerance: args.tolerance, hidden: args.hidden, exact: format.is_exact() };
            write_scene(args, &Scene::from_model_with(&model, &conversion), format)?;
        }
        None => write_model(args, &model)?,
    }
    Ok(u8::from(is_partial))
}

/// Why files of an extension cannot become a model.
fn no_model(extension: &str) -> String {
    match extension {
        "gh" | "ghx" | "ghuser" | "kd" => {
            "a definition holds no geometry until it runs: use katydid run -o".to_owned()
        }
        "mtl" => "it holds the materials of an .obj file, and no geometry: convert the .obj file".to_owned(),
        "" => format!(
            "its name has no ending that tells what it is; models that are read end with {}",
            readable_extensions()
        ),
        other => format!("models that end with .{other} are not read: only {}", readable_extensions()),
    }
}

/// The endings of models that are written: `.3dm, .obj, … or .svg`.
pub(crate) fn model_extensions() -> String {
    listed(|_| true)
}

/// The endings of models that are read: drawings are only written.
pub(crate) fn readable_extensions() -> String {
    listed(Format::is_read)
}

fn listed(takes: impl Fn(Format) -> bool) -> String {
    let all = Format::ALL.iter().filter(|format| takes(**format));
    let all: Vec<String> = all.map(|format| format!(".{}", format.extension())).collect();
    match all.split_last() {
        Some((last, others)) => format!(".3dm, {} or {last}", others.join(", ")),
        None => ".3dm".to_owned(),
    }
}

fn failed(path: &Path, error: &dyn std::fmt::Display) -> String {
    format!("{}: {error}", path.display())
}

fn left_out(left_out: &LeftOut) {
    note(&format!("{YELLOW}left out{YELLOW:#}: {left_out}"));
}

fn read_scene(args: &ConvertArgs, format: Format, bytes: &[u8]) -> Result<Scene, String> {
    let folder = args.from.parent().unwrap_or(Path::new(""));
    let scene = katydid_exchange::read_with(bytes, format, &mut |name| {
        // The files that a .gltf names lie beside it; who converts it may read them, but nothing elsewhere.
        let path = Path::new(name);
        if path.components().any(|part| !matches!(part, std::path::Component::Normal(_))) {
            return Err(katydid_exchange::Error::Unsupported(format!(
                "data outside the folder of the file: {name}"
            )));
        }
        source::bytes(&folder.join(path)).map_err(katydid_exchange::Error::Unsupported)
    });
    scene.map_err(|error| failed(&args.from, &error))
}

fn write_scene(args: &ConvertArgs, scene: &Scene, format: Format) -> Result<(), String> {
    let options = Options {
        tolerance: args.tolerance,
        ascii: args.ascii,
        view: args.view.map(Into::into).unwrap_or_default(),
        materials: None,
    };
    let lost = scene_file::write(scene, format, options, &args.to)?;
    note(&format!("{GREEN}{}{GREEN:#} things written to {}", scene.things.len(), args.to.display()));
    lost.iter().for_each(left_out);
    Ok(())
}

fn write_model(args: &ConvertArgs, model: &Model) -> Result<(), String> {
    let own = model.archive_version;
    let version = args.version.unwrap_or(if [4, 50, 60, 70, 80].contains(&own) { own } else { USUAL });
    let (bytes, losses) = model.write_what_fits(version).map_err(|error| failed(&args.to, &error))?;
    write_file(&args.to, &bytes)?;
    let n = model.objects.len() + model.lights.len();
    note(&format!(
        "{GREEN}{n}{GREEN:#} objects read, {} bytes of version {version} written to {}",
        bytes.len(),
        args.to.display()
    ));
    let mut counted: Vec<(String, usize)> = Vec::new();
    for loss in losses {
        let text = loss.to_string();
        match counted.iter_mut().find(|(known, _)| *known == text) {
            Some((_, count)) => *count += 1,
            None => counted.push((text, 1)),
        }
    }
    for (text, count) in counted {
        note(&format!("{YELLOW}left out{YELLOW:#}: {count} × {text}"));
    }
    Ok(())
}
