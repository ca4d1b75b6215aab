//! Which scripts may run.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

/// Whether scripts may run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Permission {
    /// They may not.
    #[default]
    Refused,
    /// They may: whoever started the program said so, or trusts the file.
    Given,
}

/// What a definition is known by: the hash of its bytes.
pub fn fingerprint(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

/// The files whose scripts may run, by their hashes: a text file with one a line, and after the hash what the user knows
/// the file by. A file that changes is another one.
#[derive(Debug, Clone)]
pub struct Trusted {
    path: PathBuf,
    hashes: BTreeSet<String>,
}

/// A list longer than this is none of ours.
const LARGEST: u64 = 1 << 24;

impl Trusted {
    /// The list at a path; empty where there is none yet.
    ///
    /// # Errors
    /// It is there and cannot be read.
    pub fn read(path: &Path) -> io::Result<Self> {
        let text = match std::fs::metadata(path) {
            Ok(found) if found.len() > LARGEST => return Err(io::ErrorKind::FileTooLarge.into()),
            Ok(_) => std::fs::read_to_string(path)?,
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(error),
        };
        let hashes = text.lines().filter_map(|line| line.split_ascii_whitespace().next());
        Ok(Self { path: path.to_owned(), hashes: hashes.map(str::to_owned).collect() })
    }

    /// The user's own: in the folder for settings.
    ///
    /// # Errors
    /// It cannot be read, or there is no such folder.
    pub fn of_user() -> io::Result<Self> {
        let place = Self::usual_place();
        Self::read(&place.ok_or_else(|| io::Error::other("there is no folder for settings"))?)
    }

    /// Where the user's own list is.
    pub fn usual_place() -> Option<PathBuf> {
        Some(config_folder()?.join("katydid").join("trusted"))
    }

    /// Whether the scripts of a file with these bytes may run.
    pub fn trusts(&self, bytes: &[u8]) -> bool {
        self.knows(&fingerprint(bytes))
    }

    /// The same of a file with this [`fingerprint`].
    pub fn knows(&self, fingerprint: &str) -> bool {
        self.hashes.contains(fingerprint)
    }

    /// Where the list is kept.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds a file by its bytes, and the name that the user knows it by.
    ///
    /// # Errors
    /// The list cannot be written.
    pub fn add(&mut self, bytes: &[u8], name: &str) -> io::Result<()> {
        self.learn(&fingerprint(bytes), name)
    }

    /// The same of a file with this [`fingerprint`].
    ///
    /// # Errors
    /// The list cannot be written.
    pub fn learn(&mut self, hash: &str, name: &str) -> io::Result<()> {
        use std::io::Write as _;
        if !self.hashes.insert(hash.to_owned()) {
            return Ok(());
        }
        if let Some(folder) = self.path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let mut file = std::fs::OpenOptions::new().create(true).append(true).open(&self.path)?;
        writeln!(file, "{hash} {name}")
    }
}

fn config_folder() -> Option<PathBuf> {
    let folder = |name: &str| std::env::var_os(name).filter(|path| !path.is_empty()).map(PathBuf::from);
    folder("XDG_CONFIG_HOME")
        .or_else(|| folder("APPDATA"))
        .or_else(|| folder("HOME").map(|home| home.join(".config")))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn a_file_is_trusted_until_it_changes() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/trusted");
        let mut trusted = Trusted::read(&path).unwrap();
        assert!(!trusted.trusts(b"one"));
        trusted.add(b"one", "a\nb.gh").unwrap();
        trusted.add(b"one", "again").unwrap();
        let again = Trusted::read(&path).unwrap();
        assert!(again.trusts(b"one") && !again.trusts(b"two"));
        assert_eq!(std::fs::read_to_string(&path).unwrap().lines().count(), 1);
    }
}
