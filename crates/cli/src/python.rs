//! `katydid python`.

use std::path::{Path, PathBuf};

use katydid_script::environment::{Environment, LOCK, Locked, Requirement};
use katydid_script::{Examiner, Interpreter, find};
use katydid_session::check as examine;

use crate::args::{PythonAddArgs, PythonArgs, PythonCommand, PythonSyncArgs};
use crate::output::say;
use crate::source;

pub(crate) fn python(args: &PythonArgs) -> Result<u8, String> {
    match &args.command {
        PythonCommand::Add(args) => add(args),
        PythonCommand::Sync(args) => sync(args),
    }
}

fn add(args: &PythonAddArgs) -> Result<u8, String> {
    let base = base(&args.place)?;
    let mut texts = args.packages.clone();
    if let (true, Some(file)) = (texts.is_empty(), &args.place.file) {
        texts = asked_by(file, &base)?;
        if texts.is_empty() {
            say("Its scripts ask for no package that is not installed");
            return Ok(0);
        }
    }
    let packages = texts.iter().map(|text| Requirement::new(text)).collect::<Result<Vec<_>, _>>()?;
    let environment = Environment::of_folder(&folder(&args.place));
    let locked = environment.add(&base, &packages)?;
    tell(&environment, &locked);
    Ok(0)
}

fn sync(args: &PythonSyncArgs) -> Result<u8, String> {
    let environment = Environment::of_folder(&folder(args));
    let locked = environment.sync(&base(args)?)?;
    tell(&environment, &locked);
    Ok(0)
}

/// The Python that an environment is made from: never another environment beside the definition.
fn base(args: &PythonSyncArgs) -> Result<Interpreter, String> {
    find(args.python.as_deref(), None)
}

fn folder(args: &PythonSyncArgs) -> PathBuf {
    let beside = args.file.as_deref().and_then(Path::parent);
    beside.filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned()
}

/// The packages that the scripts of a definition ask for in their `# r:` lines and that are not there.
fn asked_by(file: &Path, base: &Interpreter) -> Result<Vec<String>, String> {
    let check = examine(&source::document(file)?);
    let python = find(None, Some(file)).unwrap_or_else(|_| base.clone());
    let mut examiner = Examiner::new(&python)?;
    let mut packages = Vec::new();
    for object in &check.scripts {
        packages.extend(examiner.needs(&object.script)?.packages);
    }
    packages.sort();
    packages.dedup();
    Ok(packages)
}

fn tell(environment: &Environment, locked: &Locked) {
    say(&format!("{} has {}", environment.place().display(), locked.packages().join(", ")));
    say(&format!("{LOCK} has their versions and hashes"));
}
