//! `katydid book`.

use std::path::Path;

use katydid_book::{Book, Fault, Files};

use crate::args::BookArgs;
use crate::output::{GREEN, RED, YELLOW, note, write_file};

pub(crate) fn book(args: &BookArgs) -> Result<u8, String> {
    let files = Files::folder(&args.folder)?;
    let built = Book::read(files).and_then(|book| book.build());
    let site = match built {
        Ok(site) => site,
        Err(faults) => return Ok(tell(&args.folder, &faults)),
    };
    let (pages, figures) = (site.pages, site.figures);
    if !site.has_script {
        note(&format!("{YELLOW}note{YELLOW:#}: the script of the pages is not built: figures stand still"));
    }
    let Some(output) = &args.output else {
        note(&format!("{GREEN}{pages}{GREEN:#} pages with {figures} figures, nothing wrong"));
        return Ok(0);
    };
    for (name, bytes) in &site.files {
        let path = output.join(name);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        }
        write_file(&path, bytes)?;
    }
    note(&format!("{GREEN}{pages}{GREEN:#} pages with {figures} figures written to {}", output.display()));
    Ok(0)
}

/// All that is wrong, a line each, as editors and terminals find it.
fn tell(folder: &Path, faults: &[Fault]) -> u8 {
    for fault in faults {
        note(&format!("{RED}error{RED:#}: {}/{fault}", folder.display()));
    }
    1
}
