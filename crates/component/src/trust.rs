//! Who may have files of this machine read. This is the one place that decides it: for components that read text, points,
//! pictures, models and stored data, for Hops, and for whatever reads files later. All of them read through [`Files`],
//! which is made here and nowhere else when a definition is opened.

use std::path::{Path, PathBuf};

use crate::Files;

/// Where a definition comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin<'a> {
    /// A file of this machine, which whoever runs Katydid named by its path.
    File(&'a Path),
    /// It was sent, or is new: nobody of this machine vouches for the paths in it.
    Sent,
}

/// Who asks: only whoever runs Katydid on this machine, or others too. Everybody who works on a document can write any
/// path into it, so what a document may read follows from who can reach it, and not from who made it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trust {
    is_shared: bool,
    folders: Vec<PathBuf>,
}

impl Default for Trust {
    /// Nothing is trusted: others may ask, and no folder is open to them.
    fn default() -> Self {
        Self::shared(Vec::new())
    }
}

impl Trust {
    /// Nobody but the user who runs Katydid: the command line, and a studio that only that user can reach. A definition
    /// that they open by its path reads what they may read; one that was sent reads what is in `folders`.
    pub fn own(folders: Vec<PathBuf>) -> Self {
        Self { is_shared: false, folders }
    }

    /// Others ask too: a compute server, and a studio that others can join. Nothing is read but what is in `folders`,
    /// wherever the definition comes from.
    pub fn shared(folders: Vec<PathBuf>) -> Self {
        Self { is_shared: true, folders }
    }

    /// Whether those who ask may name paths of this machine, to open and to save, and are told them.
    pub fn names_paths(&self) -> bool {
        !self.is_shared
    }

    /// The files that a definition may read.
    pub fn files(&self, origin: Origin<'_>) -> Files {
        let beside = match origin {
            Origin::File(path) => Some(path.parent().unwrap_or(Path::new(""))),
            Origin::Sent => None,
        };
        match (beside, self.folders.first()) {
            (Some(beside), _) if !self.is_shared => Files::Any(beside.to_path_buf()),
            (_, None) => Files::None,
            (Some(beside), _) if self.holds(beside) => {
                Files::Folders { start: beside.to_path_buf(), folders: self.folders.clone() }
            }
            (_, Some(first)) => Files::Folders { start: first.clone(), folders: self.folders.clone() },
        }
    }

    /// How a path of this machine is told to those who ask: whole, or only the name of the file.
    pub fn told(&self, path: &Path) -> String {
        if self.names_paths() {
            return path.display().to_string();
        }
        path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    }

    fn holds(&self, folder: &Path) -> bool {
        let real = folder.canonicalize().ok();
        real.is_some_and(|real| {
            self.folders.iter().any(|open| open.canonicalize().is_ok_and(|open| real.starts_with(open)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_definition_may_read_follows_from_who_can_reach_it() {
        let folder = std::env::temp_dir().join(format!("katydid-trust-{}", std::process::id()));
        let (open, other) = (folder.join("open"), folder.join("other"));
        for place in [&open, &other] {
            std::fs::create_dir_all(place).unwrap();
        }
        let (inside, outside) = (open.join("a.gh"), other.join("a.gh"));
        let folders = || vec![open.clone()];
        let beside = Files::Folders { start: open.clone(), folders: folders() };
        for (trust, origin, wanted) in [
            (Trust::own(vec![]), Origin::File(&outside), Files::Any(other.clone())),
            (Trust::own(vec![]), Origin::Sent, Files::None),
            (Trust::own(folders()), Origin::File(&outside), Files::Any(other.clone())),
            (Trust::own(folders()), Origin::Sent, beside.clone()),
            (Trust::shared(vec![]), Origin::File(&inside), Files::None),
            (Trust::shared(vec![]), Origin::Sent, Files::None),
            (Trust::shared(folders()), Origin::File(&inside), beside.clone()),
            (Trust::shared(folders()), Origin::File(&outside), beside.clone()),
            (Trust::shared(folders()), Origin::Sent, beside.clone()),
            (Trust::default(), Origin::File(&inside), Files::None),
        ] {
            assert_eq!(trust.files(origin), wanted, "{trust:?} {origin:?}");
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn paths_stay_at_home() {
        let path = Path::new("/home/anna/a.gh");
        assert_eq!(Trust::own(vec![]).told(path), path.display().to_string());
        assert_eq!(Trust::shared(vec![]).told(path), "a.gh");
        assert!(Trust::own(vec![]).names_paths() && !Trust::default().names_paths());
    }
}
