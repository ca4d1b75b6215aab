//! `katydid convert`.

use katydid_definition::archive::{self, Limits};

use crate::args::ConvertArgs;
use crate::output::{YELLOW, extension, note, write_file};
use crate::source;

pub(crate) fn convert(args: &ConvertArgs) -> Result<u8, String> {
    let failed =
        |path: &std::path::Path, error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let archive = archive::read(&source::bytes(&args.from)?, &Limits::default())
        .map_err(|error| failed(&args.from, &error))?;
    for text in &archive.notes {
        note(&format!("{YELLOW}note{YELLOW:#}: {}: {text}", args.from.display()));
    }
    let bytes = match extension(&args.to).as_str() {
        "gh" | "ghuser" => archive::write_gh(&archive.root),
        "ghx" => archive::write_ghx(&archive.root).map(String::into_bytes),
        "kd" => return Err("the .kd form is not supported yet".to_owned()),
        other => return Err(format!(".{other} is not a form of a definition: use .gh or .ghx")),
    };
    write_file(&args.to, &bytes.map_err(|error| failed(&args.to, &error))?)?;
    Ok(0)
}
