//! `katydid fmt`.

use std::io::Read;
use std::path::Path;

use katydid_definition::kd;

use crate::args::FmtArgs;
use crate::output::{complain, extension, print, say, write_file};
use crate::source;

/// Standard input longer than this is not read.
const LARGEST: u64 = 1 << 30;

pub(crate) fn fmt(args: &FmtArgs) -> Result<u8, String> {
    let mut code = 0;
    for file in &args.files {
        match one(file, args.check) {
            Ok(as_it_was) => code = code.max(u8::from(args.check && !as_it_was)),
            // The other files are set all the same.
            Err(error) => {
                complain(&error);
                code = 2;
            }
        }
    }
    Ok(code)
}

/// Sets one file; whether it was set the usual way before.
fn one(file: &Path, check: bool) -> Result<bool, String> {
    let piped = file == Path::new("-");
    let bytes = if piped {
        let mut bytes = Vec::new();
        let read = std::io::stdin().lock().take(LARGEST).read_to_end(&mut bytes);
        read.map_err(|error| format!("standard input: {}", source::plain(&error)))?;
        bytes
    } else if extension(file) == "kd" {
        source::bytes(file)?
    } else {
        return Err(format!("{}: only .kd files are text that can be set", file.display()));
    };
    let name = if piped { Path::new("standard input") } else { file };
    let old = source::text(name, bytes)?;
    let new = kd::format(&old).map_err(|problems| source::pointed(name, &problems))?;
    let same = old == new;
    match (check, piped) {
        (true, _) if !same => say(&name.display().to_string()),
        (true, _) => {}
        (false, true) => print(&new),
        (false, false) if !same => write_file(file, new.as_bytes())?,
        (false, false) => {}
    }
    Ok(same)
}
