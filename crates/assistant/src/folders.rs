//! The folders whose files an assistant may read and write.
//!
//! A path is looked at as it is written, then as the system has it: neither may lead out.

use std::fs;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

use katydid_session::write_file;

use crate::fault::Fault;
use crate::thresholds::{DEEPEST_FOLDER, MOST_FILE, MOST_FILES};

/// The folders that were named, by their real paths. Without any no file is read or written.
#[derive(Debug, Clone, Default)]
pub(crate) struct Folders(Vec<PathBuf>);

impl Folders {
    /// The folders of a list.
    ///
    /// # Errors
    /// One is not there, or is no folder.
    pub(crate) fn new(folders: &[PathBuf]) -> Result<Self, String> {
        let real = |folder: &PathBuf| {
            let told = |why: &str| format!("{}: {why}", folder.display());
            let real = folder.canonicalize().map_err(|_| told("there is no such folder"))?;
            if real.is_dir() { Ok(real) } else { Err(told("it is no folder")) }
        };
        Ok(Self(folders.iter().map(real).collect::<Result<_, _>>()?))
    }

    /// The folders.
    pub(crate) fn all(&self) -> &[PathBuf] {
        &self.0
    }

    /// The path of a file to be read, with what it holds.
    pub(crate) fn read(&self, path: &str) -> Result<(PathBuf, Vec<u8>), Fault> {
        let what = "the file was not read";
        let refused = |why: &str| Fault::new(what, path, why);
        let candidates = self.candidates(what, path)?;
        let found = candidates.iter().find_map(|file| file.canonicalize().ok());
        let real = found.ok_or_else(|| refused("there is no such file"))?;
        self.admit(&real).map_err(|why| refused(&why))?;
        if !real.is_file() {
            return Err(refused("it is not a file"));
        }
        let mut bytes = Vec::new();
        let file = fs::File::open(&real).map_err(|error| refused(&plain(&error)))?;
        file.take(MOST_FILE + 1).read_to_end(&mut bytes).map_err(|error| refused(&plain(&error)))?;
        if bytes.len() as u64 > MOST_FILE {
            return Err(refused(&format!("it has more than {MOST_FILE} bytes")));
        }
        Ok((real, bytes))
    }

    /// Where a file of that path would be written. One that is there is written over only where that was asked for.
    pub(crate) fn place(&self, path: &str, overwrite: bool) -> Result<PathBuf, Fault> {
        let what = "the file was not written";
        let refused = |why: &str| Fault::new(what, path, why);
        let candidates = self.candidates(what, path)?;
        // What is there already is meant before what would be new.
        let chosen = candidates.iter().find(|file| file.symlink_metadata().is_ok()).or(candidates.first());
        let file = chosen.ok_or_else(|| refused("it has no place"))?;
        let (Some(folder), Some(name)) = (file.parent(), file.file_name()) else {
            return Err(refused("it has no name of a file"));
        };
        let folder = folder.canonicalize().map_err(|_| refused("there is no such folder"))?;
        self.admit(&folder).map_err(|why| refused(&why))?;
        let file = folder.join(name);
        if file.symlink_metadata().is_ok() {
            let real = file.canonicalize().map_err(|_| refused("it is a link that leads nowhere"))?;
            self.admit(&real).map_err(|why| refused(&why))?;
            if !real.is_file() {
                return Err(refused("there is something of that name that is not a file"));
            }
            if !overwrite {
                return Err(refused(
                    "there is such a file: name another, or call again with \"overwrite\": true",
                ));
            }
            return Ok(real);
        }
        Ok(file)
    }

    /// Writes a file whole or not at all, at a path that [`place`](Self::place) gave.
    pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Fault> {
        write_file(path, bytes).map_err(|error| {
            Fault::new("the file was not written", path.display().to_string(), plain(&error))
        })
    }

    /// The definitions and models in the folders, with their sizes: paths as they can be opened by. `true` when there are
    /// more.
    pub(crate) fn list(&self, is_wanted: impl Fn(&Path) -> bool) -> (Vec<(PathBuf, u64)>, bool) {
        let mut found = Vec::new();
        let mut waiting: Vec<(PathBuf, usize)> =
            self.0.iter().rev().map(|folder| (folder.clone(), 0)).collect();
        while let Some((folder, depth)) = waiting.pop() {
            let Ok(entries) = fs::read_dir(&folder) else { continue };
            let mut entries: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
            entries.sort();
            let mut inner = Vec::new();
            for path in entries {
                // Links are not followed: they may lead out, or round in a ring.
                let Ok(about) = path.symlink_metadata() else { continue };
                let is_plain = path.file_name().is_some_and(|name| !name.to_string_lossy().starts_with('.'));
                if about.is_dir() && is_plain && depth < DEEPEST_FOLDER {
                    inner.push((path, depth + 1));
                } else if about.is_file() && is_wanted(&path) {
                    if found.len() == MOST_FILES {
                        return (found, true);
                    }
                    found.push((path, about.len()));
                }
            }
            waiting.extend(inner.into_iter().rev());
        }
        (found, false)
    }

    /// The places that a path may mean, each in one of the folders as it is written.
    fn candidates(&self, what: &str, path: &str) -> Result<Vec<PathBuf>, Fault> {
        let refused = |why: String| Fault::new(what, path, why);
        let Some(first) = self.0.first() else {
            return Err(refused("no folder is open: Katydid was started without --folder".to_owned()));
        };
        if path.trim().is_empty() || path.contains('\0') {
            return Err(refused("it is no path of a file".to_owned()));
        }
        let given = Path::new(path);
        if given.components().any(|part| part == Component::ParentDir) {
            return Err(refused("a path with .. is not followed".to_owned()));
        }
        if given.is_absolute() {
            // Folders may have been named by a path with links in it.
            let inside = self.0.iter().any(|folder| given.starts_with(folder));
            let real = || -> Option<PathBuf> {
                let parent = given.parent()?.canonicalize().ok()?;
                self.admit(&parent).ok()?;
                Some(parent.join(given.file_name()?))
            };
            return match inside {
                true => Ok(vec![given.to_owned()]),
                false => real().map(|real| vec![real]).ok_or_else(|| refused(self.outside())),
            };
        }
        if given.components().any(|part| matches!(part, Component::Prefix(_) | Component::RootDir)) {
            return Err(refused(self.outside()));
        }
        let mut all = vec![first.join(given)];
        all.extend(self.0.iter().skip(1).map(|folder| folder.join(given)));
        Ok(all)
    }

    /// Whether a real path is in one of the folders.
    fn admit(&self, real: &Path) -> Result<(), String> {
        if self.0.iter().any(|folder| real.starts_with(folder)) { Ok(()) } else { Err(self.outside()) }
    }

    fn outside(&self) -> String {
        let names: Vec<String> = self.0.iter().map(|folder| folder.display().to_string()).collect();
        format!("it leads outside the folders that are open: {}", names.join(", "))
    }
}

/// What went wrong, without the number of the error.
fn plain(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "the system does not allow it".to_owned(),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    /// An open folder and another beside it, each with a file.
    fn two() -> (tempfile::TempDir, PathBuf, PathBuf, Folders) {
        let all = tempfile::tempdir().unwrap();
        let root = all.path().canonicalize().unwrap();
        let (open, other) = (root.join("open"), root.join("other"));
        for folder in [&open, &other] {
            fs::create_dir_all(folder.join("deep")).unwrap();
            fs::write(folder.join("a.kd"), "a = Panel(\"x\")").unwrap();
        }
        let folders = Folders::new(std::slice::from_ref(&open)).unwrap();
        (all, open, other, folders)
    }

    fn why(result: Result<impl std::fmt::Debug, Fault>) -> String {
        result.unwrap_err().to_string()
    }

    #[test]
    fn only_what_is_in_the_folders_is_read_and_written() {
        let (_all, open, other, folders) = two();
        let text = |path: &Path| path.display().to_string();
        assert_eq!(folders.read("a.kd").unwrap().0, open.join("a.kd"));
        assert_eq!(folders.read(&text(&open.join("a.kd"))).unwrap().0, open.join("a.kd"));
        assert_eq!(folders.place("deep/b.kd", false).unwrap(), open.join("deep/b.kd"));
        for path in ["../other/a.kd", "deep/../a.kd", "deep/../../other/a.kd"] {
            assert!(why(folders.read(path)).contains(".."), "{path}");
            assert!(why(folders.place(path, true)).contains(".."), "{path}");
        }
        for path in [
            text(&other.join("a.kd")),
            "/etc/passwd".to_owned(),
            "/a.kd".to_owned(),
            text(&other.join("new.kd")),
        ] {
            assert!(why(folders.read(&path)).contains("outside"), "{path}");
            assert!(why(folders.place(&path, true)).contains("outside"), "{path}");
        }
        for path in ["", "  ", "a\0b"] {
            assert!(why(folders.read(path)).contains("no path"), "{path:?}");
        }
        assert!(why(folders.read("none.kd")).contains("no such file"));
        assert!(why(folders.read("deep")).contains("not a file"));
        assert!(why(folders.place("a.kd", false)).contains("overwrite"));
        assert!(folders.place("a.kd", true).is_ok());
        assert!(why(folders.place("nowhere/a.kd", false)).contains("no such folder"));
        assert!(why(folders.place("deep", true)).contains("not a file"));
        let none = Folders::default();
        assert!(
            why(none.read("a.kd")).contains("--folder") && why(none.place("a.kd", true)).contains("--folder")
        );
        assert!(Folders::new(&[open.join("a.kd")]).is_err() && Folders::new(&[open.join("no")]).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn links_do_not_lead_out() {
        use std::os::unix::fs::symlink;
        let (_all, open, other, folders) = two();
        symlink(other.join("a.kd"), open.join("link.kd")).unwrap();
        symlink(&other, open.join("folder")).unwrap();
        symlink(other.join("not there"), open.join("dangling.kd")).unwrap();
        symlink(open.join("a.kd"), open.join("fine.kd")).unwrap();
        for path in ["link.kd", "folder/a.kd"] {
            assert!(why(folders.read(path)).contains("outside"), "{path}");
            assert!(why(folders.place(path, true)).contains("outside"), "{path}");
        }
        assert!(why(folders.place("folder/new.kd", false)).contains("outside"));
        assert!(why(folders.place("dangling.kd", true)).contains("nowhere"));
        assert_eq!(folders.read("fine.kd").unwrap().0, open.join("a.kd"));
        let (found, more) = folders.list(|_| true);
        assert!(!more && found.iter().all(|(path, _)| path == &open.join("a.kd")), "{found:?}");
    }
}
