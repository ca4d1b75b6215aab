//! `katydid run`.

use std::collections::HashSet;
use std::io::BufWriter;
use std::path::Path;
use std::sync::Arc;

use katydid_component::{Level, Outbox};
use katydid_exchange::Format;
use katydid_session::{BakeOptions, Items, OutputFile, Session, bake, panel_streams, write_panel};
use katydid_solver::Status;

use crate::args::{JsonForm, RunArgs};
use crate::convert_model::model_extensions;
use crate::output::{BOLD, DIM, GREEN, RED, YELLOW, extension, note, say, write_file};
use crate::{explain, open, scene_file, ticks};

pub(crate) fn run(args: &RunArgs) -> Result<u8, String> {
    for path in &args.output {
        let known = extension(path) == "3dm" || Format::from_extension(&extension(path)).is_some();
        if !known {
            let known = model_extensions();
            return Err(format!("{}: the geometry can be saved as {known}", path.display()));
        }
    }
    if let Some(threads) = args.threads {
        if threads == 0 {
            return Err("--threads must be at least 1".to_owned());
        }
        // Only fails when a pool stands already, and this is the first use.
        let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
    }
    let mut session = open::session(&args.definition)?;
    let options = session.options_mut();
    options.limits.items = args.limit_items.unwrap_or(options.limits.items);
    if let Some(bytes) = args.limit_bytes {
        options.limits = options.limits.with_bytes(bytes);
    }
    let outbox = args.write.as_ref().map(|_| Arc::new(Outbox::default()));
    options.outbox.clone_from(&outbox);
    // A report shows every output, and what is saved has what is previewed, which no wire need read.
    options.skip_unread = args.json.is_none() && args.output.is_empty() && args.explain.is_none();
    let whole = ticks::solve(&mut session, &args.definition);

    let failed = complain(&session) || !whole;
    for path in &args.output {
        save(&session, args, path)?;
    }
    write_panels(&session, args.panels.as_deref())?;
    if let (Some(folder), Some(outbox)) = (&args.write, &outbox) {
        write_files(outbox, folder)?;
    }
    if let Some(name) = &args.explain {
        explain::explain(&session, name)?;
    }
    match args.json {
        Some(form) => {
            let items = if form == JsonForm::Values { Items::Values } else { Items::Texts };
            let mut report = session.report_with(items);
            report.file = args.definition.file.display().to_string();
            say(&serde_json::to_string(&report).map_err(|error| error.to_string())?);
        }
        None => summarise(&session, args),
    }
    Ok(u8::from(failed))
}

/// Prints the messages of all objects; tells whether any is an error.
pub(crate) fn complain(session: &Session) -> bool {
    let mut failed = false;
    for (index, object) in session.document().objects.iter().enumerate() {
        let Some(report) = session.engine().report(index) else { continue };
        failed |= report.status == Status::Error;
        for message in &report.messages {
            let style = match message.level {
                Level::Error => RED,
                Level::Warning => YELLOW,
                Level::Remark => DIM,
            };
            let title = object.title();
            let id = object.id;
            note(&format!(
                "{style}{}{style:#}: {BOLD}{title}{BOLD:#} ({id}): {}",
                message.level, message.text
            ));
        }
    }
    failed
}

/// One line of what happened, and the slowest objects when wanted.
fn summarise(session: &Session, args: &RunArgs) {
    let engine = session.engine();
    let objects = &session.document().objects;
    let mut counts = [0usize; 6];
    let mut times = Vec::new();
    for (index, object) in objects.iter().enumerate().filter(|(_, o)| !o.is_annotation()) {
        let Some(report) = engine.report(index) else { continue };
        counts[report.status as usize] += 1;
        times.push((report.time, object));
    }
    let total: usize = counts.iter().sum();
    let milliseconds = 1e3 * session.summary().time.as_secs_f64();
    let mut line = format!("{GREEN}{}{GREEN:#} of {total} objects ran", counts[0] + counts[1]);
    let words = ["", " with warnings", " with errors", " disabled", " not supported", " without data"];
    for (count, word) in counts.iter().zip(words).skip(1).filter(|(count, _)| **count > 0) {
        line.push_str(&format!(", {count}{word}"));
    }
    note(&format!("{line} in {milliseconds:.1} ms"));
    if args.timings {
        times.sort_by_key(|(time, _)| std::cmp::Reverse(*time));
        for (time, object) in times.iter().take(30) {
            say(&format!("{:>10.3} ms  {} ({})", time.as_secs_f64() * 1e3, object.title(), object.name));
        }
    }
}

/// Writes what panels stream into the folder that was given; without one says that nothing is written.
fn write_panels(session: &Session, folder: Option<&Path>) -> Result<(), String> {
    let streams = panel_streams(session.document());
    let Some(folder) = folder else {
        if !streams.is_empty() {
            let count = streams.len();
            note(&format!("{count} panels stream to files, which is done with --panels FOLDER"));
        }
        return Ok(());
    };
    let mut written = HashSet::new();
    for stream in streams {
        let title = session.document().objects.get(stream.object).map_or("Panel", |object| object.title());
        let Some(name) = stream.file else {
            return Err(format!("{title}: the path that it streams to has no name of a file"));
        };
        let path = folder.join(&name);
        // Some systems do not tell large letters from small ones.
        if !written.insert(name.to_lowercase()) {
            return Err(format!("{title}: another panel streams to {} too", path.display()));
        }
        let failed = |error: std::io::Error| format!("{}: {error}", path.display());
        let mut file = BufWriter::new(OutputFile::create(&path).map_err(failed)?);
        let lines = write_panel(session.engine(), stream.object, &mut file).map_err(failed)?;
        let file = file.into_inner().map_err(|error| failed(error.into_error()))?;
        file.finish().map_err(failed)?;
        note(&format!("{GREEN}{lines}{GREEN:#} lines of {title} written to {}", path.display()));
    }
    Ok(())
}

/// Writes the files that components have written into the folder that was given.
fn write_files(outbox: &Outbox, folder: &Path) -> Result<(), String> {
    let files = outbox.take();
    if files.is_empty() {
        note("No component writes a file");
        return Ok(());
    }
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for file in files {
        let path = folder.join(&file.name);
        write_file(&path, &file.bytes)?;
        note(&format!("{GREEN}{}{GREEN:#} bytes written to {}", file.bytes.len(), path.display()));
    }
    Ok(())
}

fn save(session: &Session, args: &RunArgs, path: &Path) -> Result<(), String> {
    let is_model = extension(path) == "3dm";
    let baked =
        bake(session.engine(), BakeOptions { blocks: args.blocks && is_model, ..BakeOptions::default() });
    let mut left_out = baked.left_out;
    let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    if is_model {
        let (bytes, losses) = baked.model.write_what_fits(70).map_err(|error| failed(&error))?;
        left_out.extend(losses.iter().map(ToString::to_string));
        write_file(path, &bytes)?;
    } else {
        let format = Format::from_extension(&extension(path)).unwrap_or_default();
        let conversion = katydid_exchange::Conversion { exact: format.is_exact(), ..Default::default() };
        let scene = katydid_exchange::Scene::from_model_with(&baked.model, &conversion);
        let lost = scene_file::write(&scene, format, katydid_exchange::Options::default(), path)?;
        left_out.extend(lost.iter().map(ToString::to_string));
    }
    let n = baked.model.objects.len();
    let objects = if n == 1 { "object" } else { "objects" };
    note(&format!("{GREEN}{n}{GREEN:#} {objects} written to {}", path.display()));
    for reason in left_out {
        note(&format!("{YELLOW}left out{YELLOW:#}: {reason}"));
    }
    for remark in baked.remarks {
        note(&format!("{YELLOW}remark{YELLOW:#}: {remark}"));
    }
    Ok(())
}
