//! Opening a definition to solve it.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, SystemTime};

use katydid_component::{Limits, Origin, RhinoModel, Trust};
use katydid_data::DateTime;
use katydid_data::cast::Rules;
use katydid_geometry::Units;
use katydid_session::Session;
use katydid_solver::Options;

use crate::args::DefinitionArgs;
use crate::{model_file, progress, source};

/// A session on the definition with its inputs set; nothing is solved yet.
pub(crate) fn session(args: &DefinitionArgs) -> Result<Session, String> {
    let source = source::definition(&args.file)?;
    let model = args.model.as_deref().map(|path| model(path, args.lenient)).transpose()?;
    let mut rules = Rules { now: now(), ..Rules::default() };
    if let Some(model) = &model {
        (rules.units, rules.tolerance) = (model.units, model.tolerance);
    }
    if let Some(units) = args.units.map(Units::from).or(source.units) {
        rules.units = units;
    }
    let time = args.limit_seconds.map(Duration::try_from_secs_f64).transpose();
    // Who runs a definition here may read their own files; the paths start where the definition lies.
    let files = Trust::own(Vec::new()).files(Origin::File(&args.file));
    let settings = katydid_compute::Settings {
        files: files.clone(),
        web: args.web.web()?,
        hops: args.web.hops()?,
        ..katydid_compute::Settings::default()
    };
    let options = Options {
        rules,
        limits: Limits {
            time: time.map_err(|_| "--limit-seconds must be a positive number".to_owned())?,
            ..Limits::default()
        },
        files,
        model: model.map(Arc::new),
        remote: Some(katydid_compute::hops(&settings)),
        scripts: Some(args.scripts.scripts(&args.file)),
        progress: progress::listener(),
        ..Options::default()
    };
    let mut session = Session::new(source.document, options);
    for (name, value) in &args.set {
        session.set(name, value).map_err(|error| error.to_string())?;
    }
    Ok(session)
}

/// The moment by the clock of the machine, in UTC.
fn now() -> Option<DateTime> {
    DateTime::since_1970(SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).ok()?)
}

fn model(path: &Path, lenient: bool) -> Result<RhinoModel, String> {
    let model = model_file::read(path, &source::bytes(path)?, lenient)?;
    model_file::tell(path, &model);
    Ok(RhinoModel::new(model))
}
