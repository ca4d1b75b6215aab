//! Definitions from bytes, and what they are solved with in a page.

use std::sync::Arc;

use katydid_data::DateTime;
use katydid_data::cast::Rules;
use katydid_definition::document::Document;
use katydid_script::CSharp;
use katydid_solver::{Options, Refused};
use katydid_studio::{Form, read};
use web_time::SystemTime;

/// The most bytes that one object, and a whole solve, may take: a module has 4 GB at most, and what it cannot have ends it.
const MOST_BYTES: u64 = 2 << 30;
/// Katydid's text begins with this word.
const KD: &[u8] = b"katydid";

/// A definition that was read.
#[derive(Debug)]
pub struct Opened {
    /// The document.
    pub document: Document,
    /// Its units and tolerances, and the moment.
    pub rules: Rules,
}

/// The form of a definition by its first bytes: Katydid's text, XML, or else Grasshopper's archive.
pub fn form_of(bytes: &[u8]) -> Form {
    let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = start.trim_ascii_start();
    let is_comment = text.starts_with(b"#") || text.starts_with(b"//");
    if text.starts_with(KD) || is_comment {
        Form::Kd
    } else if text.starts_with(b"<") {
        Form::Ghx
    } else {
        Form::Gh
    }
}

/// Reads a definition.
///
/// # Errors
/// What is wrong with the bytes, and where.
pub fn open(form: Form, bytes: &[u8]) -> Result<Opened, String> {
    katydid_components::link();
    let (document, units) = read(form, bytes)?;
    let mut rules = rules();
    rules.units = units.unwrap_or(rules.units);
    Ok(Opened { document, rules })
}

/// Units and tolerances of a definition that names none, at this moment in UTC.
pub(crate) fn rules() -> Rules {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).ok();
    Rules { now: now.and_then(DateTime::since_1970), ..Rules::default() }
}

/// What a solve may use here: no files, no other servers, no processes. C# and VB can only compute: they run.
pub fn options(rules: Rules) -> Options {
    let refused =
        Arc::new(Refused::new("scripts in Python are not supported in a page; `katydid run` runs them"));
    let mut options =
        Options { rules, scripts: Some(Arc::new(CSharp::beside(refused))), ..Options::default() };
    options.limits = options.limits.with_bytes(MOST_BYTES);
    options
}
