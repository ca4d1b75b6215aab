//! `katydid check`.

use std::fs;
use std::path::{Path, PathBuf};

use katydid_script::{Examiner, Interpreter, find};
use katydid_session::{Check, KnownOfPlugin, check as examine};
use serde_json::json;

use crate::args::CheckArgs;
use crate::output::{BOLD, DIM, GREEN, RED, YELLOW, extension, say};
use crate::source;

/// Folders deeper than this are not searched: a link may lead in circles.
const DEEPEST: usize = 64;

pub(crate) fn check(args: &CheckArgs) -> Result<u8, String> {
    let mut files = Vec::new();
    for path in &args.paths {
        if path.is_dir() {
            search(path, 0, &mut files);
        } else {
            files.push(path.clone());
        }
    }
    let mut scripts = Scripts::new(args);
    let results: Vec<(PathBuf, Result<Check, String>)> = files
        .into_iter()
        .map(|file| {
            let checked = source::document(&file).map(|document| {
                let mut check = scripts.examined(&file, examine(&document));
                check.look_at_outputs(&document);
                check
            });
            (file, checked)
        })
        .collect();
    if args.json {
        let entries: Vec<serde_json::Value> =
            results.iter().map(|(file, result)| entry(file, result)).collect();
        say(&serde_json::to_string(&entries).map_err(|error| error.to_string())?);
    } else {
        print(&results);
    }
    let code = |result: &Result<Check, String>| match result {
        Ok(check) => u8::from(!check.runnable),
        Err(_) => 2,
    };
    Ok(results.iter().map(|(_, result)| code(result)).max().unwrap_or(0))
}

/// Looks at the scripts of all files; at those in Python with the Python that would run them, one for all files that have
/// the same.
struct Scripts<'a> {
    args: &'a CheckArgs,
    python: Option<Result<Interpreter, String>>,
    examiner: Option<Result<Examiner, String>>,
}

impl<'a> Scripts<'a> {
    fn new(args: &'a CheckArgs) -> Self {
        Self { args, python: None, examiner: None }
    }

    /// The check with what its scripts need and have not.
    fn examined(&mut self, file: &Path, mut check: Check) -> Check {
        if check.scripts.iter().any(|object| object.script.is_python()) {
            let found = find(self.args.python.as_deref(), Some(file));
            if self.python.as_ref() != Some(&found) {
                // Another file may have another environment beside it.
                self.examiner = None;
                self.python = Some(found);
            }
        }
        for object in std::mem::take(&mut check.scripts) {
            if !object.script.is_python() {
                for fault in katydid_script::csharp_faults(&object.object, &object.script) {
                    check.lacks(&object, &fault);
                }
                continue;
            }
            let Some(python) = &self.python else { continue };
            let start = || python.clone().and_then(|python| Examiner::new(&python));
            let examiner = self.examiner.get_or_insert_with(start);
            let needs = match examiner {
                Ok(examiner) => examiner.needs(&object.script),
                Err(why) => Err(why.clone()),
            };
            match needs {
                Ok(needs) => {
                    needs.modules.iter().for_each(|name| check.lacks(&object, &module(name)));
                    needs.packages.iter().for_each(|name| check.lacks(&object, &package(name)));
                    needs.members.iter().for_each(|name| check.lacks(&object, name));
                    needs
                        .error
                        .iter()
                        .for_each(|why| check.lacks(&object, &format!("Python without errors ({why})")));
                }
                Err(why) => {
                    check.lacks(&object, &format!("Python ({why})"));
                    // Another script may be looked at by another process.
                    if examiner.is_ok() {
                        self.examiner = None;
                    }
                }
            }
        }
        check
    }
}

/// A module that cannot be imported. Its package may have another name; the script's own message knows some of them.
fn module(name: &str) -> String {
    format!("{name}, a module of Python (see `katydid python add`)")
}

fn package(name: &str) -> String {
    format!("{name}, a package of Python (`katydid python add {name}`)")
}

/// All definitions in a folder and those inside it, in order of their names.
fn search(folder: &Path, depth: usize, files: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() && depth < DEEPEST {
            search(&path, depth + 1, files);
        } else if ["gh", "ghx", "kd"].contains(&extension(&path).as_str()) {
            files.push(path);
        }
    }
}

fn entry(file: &Path, result: &Result<Check, String>) -> serde_json::Value {
    let file = file.display().to_string();
    match result {
        Ok(check) => json!({
            "file": file,
            "objects": check.objects,
            "unsupported": check.unsupported,
            "runnable": check.runnable,
            "outputs": check.outputs,
        }),
        Err(error) => json!({ "file": file, "error": error, "runnable": false }),
    }
}

/// What a file knows of an object of a plug-in, in a line.
fn told(known: &KnownOfPlugin) -> String {
    let mut parts = Vec::new();
    let by = [&known.version, &known.author];
    let by: Vec<&str> = by.into_iter().map(|part| part.trim()).filter(|part| !part.is_empty()).collect();
    if !by.is_empty() {
        parts.push(by.join(" by "));
    }
    let about = one_line(&known.description);
    if !about.is_empty() {
        parts.push(about);
    }
    parts.push(format!("{} → {}", known.inputs.join(", "), known.outputs.join(", ")));
    if known.others_run {
        parts.push("other components of this plug-in run".to_owned());
    }
    parts.join("; ")
}

/// So many outputs are named; `--json` has all.
const MOST_NAMED: usize = 12;
/// How many objects are named that an output needs; `--json` has all.
const MOST_NEEDS: usize = 4;

/// What runs without what is missing, in lines.
fn without(check: &Check) -> Vec<String> {
    let outputs = &check.outputs;
    let kind = if outputs.marked { "marked outputs" } else { "outputs (what no wire leads on from)" };
    if outputs.count == 0 {
        return vec!["         it has no outputs".to_owned()];
    }
    if outputs.missing.is_empty() {
        return vec![format!(
            "         {GREEN}runs without them{GREEN:#}: all {} {kind} are whole",
            outputs.count
        )];
    }
    let mut lines = vec![format!(
        "         without them {} of {} {kind} are whole; missing:",
        outputs.whole, outputs.count
    )];
    for missing in outputs.missing.iter().take(MOST_NAMED) {
        let component = if missing.name == missing.component {
            String::new()
        } else {
            format!(" ({})", missing.component)
        };
        let needs = named(&missing.needs);
        lines.push(format!("              {}{component} {DIM}needs {needs}{DIM:#}", one_line(&missing.name)));
    }
    let more = outputs.missing.len().saturating_sub(MOST_NAMED);
    if more > 0 {
        lines.push(format!("              and {more} more"));
    }
    lines
}

/// The first names of a list, and how many more there are.
fn named(names: &[String]) -> String {
    let mut shown = names.iter().take(MOST_NEEDS).map(String::as_str).collect::<Vec<_>>().join(", ");
    if let Some(more) = names.len().checked_sub(MOST_NEEDS).filter(|more| *more > 0) {
        shown += &format!(" and {more} more");
    }
    shown
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn print(results: &[(PathBuf, Result<Check, String>)]) {
    let (mut objects, mut missing, mut runnable) = (0, 0, 0);
    for (file, result) in results {
        let file = file.display();
        match result {
            Ok(check) if check.runnable => {
                say(&format!("{GREEN}runs{GREEN:#}     {BOLD}{file}{BOLD:#}: {} objects", check.objects));
                runnable += 1;
            }
            Ok(check) => {
                let count: usize = check.unsupported.iter().map(|u| u.count).sum();
                say(&format!(
                    "{YELLOW}in part{YELLOW:#}  {BOLD}{file}{BOLD:#}: {count} of {} objects are not supported",
                    check.objects
                ));
                for missing in &check.unsupported {
                    let why = missing.plugin.as_deref().or(missing.reason.as_deref());
                    let plugin = why.map(|why| format!(" ({why})")).unwrap_or_default();
                    say(&format!("         {:>4} × {}{DIM}{plugin}{DIM:#}", missing.count, missing.name));
                    if let Some(known) = &missing.known {
                        say(&format!("              {DIM}{}{DIM:#}", told(known)));
                    }
                }
                without(check).iter().for_each(|line| say(line));
                missing += count;
            }
            Err(error) => say(&format!("{RED}fails{RED:#}    {error}")),
        }
        objects += result.as_ref().map_or(0, |check| check.objects);
    }
    if results.len() > 1 {
        let supported = match objects {
            0 => "no objects in them".to_owned(),
            _ => {
                let share = 100.0 * (objects - missing) as f64 / objects as f64;
                format!("{} of {objects} objects are supported ({share:.1} %)", objects - missing)
            }
        };
        say(&format!("{} files, {runnable} run whole; {supported}", results.len()));
    }
}
