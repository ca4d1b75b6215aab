//! The lock file: what was asked for, and for each package the archive that is installed, with its hash.
//!
//! It is a requirements file of pip: `pip install --require-hashes -r` reads it without Katydid.

use serde_json::Value as Json;

const HEAD: &str = "# Made by `katydid python add`; `katydid python sync` makes the environment again.\n";
const ASKED: &str = "# asked: ";

/// A package as somebody asks for it: `numpy`, `scipy==1.10`, the path of an archive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Requirement(String);

impl Requirement {
    /// A requirement of a text.
    ///
    /// # Errors
    /// The text is empty, could be an option of pip, or has more than one line.
    pub fn new(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if text.is_empty() || text.starts_with('-') || text.contains(char::is_control) {
            return Err(format!("{text:?} is no package"));
        }
        Ok(Self(text.to_owned()))
    }

    /// As it was written.
    pub fn text(&self) -> &str {
        &self.0
    }

    /// The package's name in the form in which names are compared (PEP 503).
    pub fn name(&self) -> String {
        let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '_');
        // A path has no name of its own before it is read.
        if self.0.contains(['/', '\\']) {
            return self.0.clone();
        }
        let name: String = self.0.chars().take_while(|c| is_part(*c)).collect();
        let parts = name.split(['.', '-', '_']).filter(|part| !part.is_empty());
        parts.collect::<Vec<_>>().join("-").to_ascii_lowercase()
    }
}

/// Those that were asked for, with more: a later one takes the place of an earlier one of its name.
pub(super) fn merged(before: &[Requirement], more: &[Requirement]) -> Vec<Requirement> {
    let is_new = |one: &&Requirement| more.iter().all(|other| other.name() != one.name());
    let mut all: Vec<Requirement> = before.iter().filter(is_new).cloned().collect();
    for one in more {
        all.retain(|other| other.name() != one.name());
        all.push(one.clone());
    }
    all
}

/// What a lock file holds.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Locked {
    /// What was asked for.
    pub asked: Vec<Requirement>,
    /// A line each package, with its version and its hash; sorted.
    pub lines: Vec<String>,
}

impl Locked {
    pub(super) fn read(text: &str) -> Self {
        let asked = text.lines().filter_map(|line| line.strip_prefix(ASKED));
        let asked = asked.filter_map(|text| Requirement::new(text).ok()).collect();
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        Self { asked, lines: lines.map(str::to_owned).collect() }
    }

    pub(super) fn text(&self) -> String {
        let asked = self.asked.iter().map(|one| format!("{ASKED}{}\n", one.text()));
        let lines = self.lines.iter().map(|line| format!("{line}\n"));
        HEAD.to_owned() + &asked.chain(lines).collect::<String>()
    }

    /// The packages with their versions, for people.
    pub fn packages(&self) -> Vec<String> {
        let first = |line: &String| line.split(" --hash").next().unwrap_or_default().trim().to_owned();
        self.lines.iter().map(first).collect()
    }

    /// What pip's report says that it would install.
    pub(super) fn of_report(report: &[u8], asked: Vec<Requirement>) -> Result<Self, String> {
        let report: Json =
            serde_json::from_slice(report).map_err(|error| format!("pip's report is no JSON: {error}"))?;
        let installs = report.get("install").and_then(Json::as_array);
        let installs =
            installs.ok_or_else(|| "pip's report has no packages: pip 22.2 or later is needed".to_owned())?;
        let mut lines = installs.iter().map(line).collect::<Result<Vec<String>, String>>()?;
        lines.sort();
        Ok(Self { asked, lines })
    }
}

/// The line of one package of the report.
fn line(install: &Json) -> Result<String, String> {
    let text = |path: &str| install.pointer(path).and_then(Json::as_str);
    let (name, version) =
        text("/metadata/name").zip(text("/metadata/version")).ok_or("a package has no name")?;
    let hash = text("/download_info/archive_info/hashes/sha256").map(str::to_owned).or_else(|| {
        text("/download_info/archive_info/hash")
            .and_then(|hash| hash.strip_prefix("sha256="))
            .map(str::to_owned)
    });
    let hash = hash.ok_or_else(|| format!("{name} comes without a hash: only archives can be locked"))?;
    let is_direct = install.get("is_direct").and_then(Json::as_bool).unwrap_or(false);
    Ok(match text("/download_info/url").filter(|_| is_direct) {
        Some(url) => format!("{name} @ {url} --hash=sha256:{hash}"),
        None => format!("{name}=={version} --hash=sha256:{hash}"),
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    fn asked(texts: &[&str]) -> Vec<Requirement> {
        texts.iter().map(|text| Requirement::new(text).unwrap()).collect()
    }

    #[test]
    fn names_are_compared_as_pep_503_says() {
        let name = |text: &str| Requirement::new(text).unwrap().name();
        assert_eq!(name("Ladybug_Core >= 0.44"), "ladybug-core");
        assert_eq!(name("zope.interface[test]"), "zope-interface");
        assert!(Requirement::new("--index-url=http://x").is_err());
        assert!(Requirement::new("a\n--index-url=x").is_err());
        assert!(Requirement::new("  ").is_err());
    }

    #[test]
    fn a_later_version_takes_the_place_of_an_earlier_one() {
        let merged = merged(&asked(&["numpy", "scipy==1.10"]), &asked(&["SciPy==1.11", "a", "a==2"]));
        assert_eq!(merged, asked(&["numpy", "SciPy==1.11", "a==2"]));
    }

    #[test]
    fn a_lock_is_what_it_was_after_writing_and_reading() {
        let lines = vec!["numpy==1.26.4 --hash=sha256:ab".to_owned()];
        let locked = Locked { asked: asked(&["numpy"]), lines };
        assert_eq!(Locked::read(&locked.text()), locked);
        assert_eq!(locked.packages(), ["numpy==1.26.4"]);
    }

    #[test]
    fn a_report_gives_versions_and_hashes() {
        let report = br#"{"version": "1", "install": [
            {"is_direct": false, "metadata": {"name": "b", "version": "2.0"},
             "download_info": {"url": "u", "archive_info": {"hashes": {"sha256": "cd"}}}},
            {"is_direct": true, "metadata": {"name": "a", "version": "1.0"},
             "download_info": {"url": "file:///a.whl", "archive_info": {"hash": "sha256=ef"}}}]}"#;
        let locked = Locked::of_report(report, asked(&["b"])).unwrap();
        assert_eq!(locked.lines, ["a @ file:///a.whl --hash=sha256:ef", "b==2.0 --hash=sha256:cd"]);
        let without =
            br#"{"install": [{"metadata": {"name": "b", "version": "2.0"}, "download_info": {"url": "u"}}]}"#;
        assert!(Locked::of_report(without, Vec::new()).unwrap_err().contains("without a hash"));
    }
}
