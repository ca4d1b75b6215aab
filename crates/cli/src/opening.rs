//! Opening a definition and solving it, for the commands that need its results.

use std::path::Path;
use std::time::Duration;

use katydid_component::{Files, Limits};
use katydid_data::cast::Rules;
use katydid_geometry::Units;
use katydid_session::Session;
use katydid_solver::Options;

use crate::args::UnitName;
use crate::{progress, source};

/// What a command says of the definition that it opens.
pub(crate) struct Opening<'a> {
    pub(crate) file: &'a Path,
    /// Inputs by name and the values they get.
    pub(crate) set: &'a [(String, String)],
    pub(crate) units: Option<UnitName>,
    pub(crate) limits: Limits,
    /// Whether objects that nobody reads are left out.
    pub(crate) skip_unread: bool,
}

impl Opening<'_> {
    /// The session, solved.
    pub(crate) fn solved(self) -> Result<Session, String> {
        let source = source::definition(self.file)?;
        let units = self.units.map(Units::from).or(source.units).unwrap_or_default();
        let options = Options {
            rules: Rules { units, ..Rules::default() },
            limits: self.limits,
            // Who runs a definition here may read their own files; the paths start where the definition lies.
            files: Files::Any(self.file.parent().unwrap_or(Path::new("")).to_path_buf()),
            skip_unread: self.skip_unread,
            progress: progress::listener(),
            ..Options::default()
        };
        let mut session = Session::new(source.document, options);
        for (name, value) in self.set {
            session.set(name, value).map_err(|error| error.to_string())?;
        }
        session.solve();
        progress::clear();
        Ok(session)
    }
}

/// The time that `--limit-seconds` leaves.
pub(crate) fn time_limit(seconds: Option<f64>) -> Result<Option<Duration>, String> {
    let time = seconds.map(Duration::try_from_secs_f64).transpose();
    time.map_err(|_| "--limit-seconds must be a positive number".to_owned())
}
