use std::fs;
use std::io::Read;
use std::path::PathBuf;

use crate::Message;

/// Which files of the machine a definition may read. A definition names files by itself, so [`Trust`](crate::Trust)
/// decides when one is opened.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Files {
    /// None.
    #[default]
    None,
    /// Any; a path that is not absolute starts at this folder, the definition's own as a rule.
    Any(PathBuf),
    /// Those in this folder and the folders inside it.
    Inside(PathBuf),
    /// Those in these folders and the folders inside them.
    Folders {
        /// Where a path that is not absolute starts.
        start: PathBuf,
        /// The folders.
        folders: Vec<PathBuf>,
    },
}

impl Files {
    /// The contents of a file. A path that leads nowhere, as on another machine, is tried once more as the file of
    /// that name in the folder.
    ///
    /// # Errors
    /// The message to show when the file may not be read, cannot be, is no file or has more than `most` bytes.
    pub fn read(&self, path: &str, most: u64) -> Result<Vec<u8>, Message> {
        let problem = |why: &str| Message::error(format!("{path} cannot be read: {why}"));
        let folder = match self {
            Self::None => return Err(problem("files may not be read here")),
            Self::Any(folder) | Self::Inside(folder) | Self::Folders { start: folder, .. } => folder,
        };
        let named = PathBuf::from(path.trim());
        let first = folder.join(&named);
        let beside =
            path.rsplit(['/', '\\']).next().filter(|name| !name.is_empty()).map(|name| folder.join(name));
        let found = std::iter::once(first).chain(beside).find_map(|file| self.admitted(file));
        let Some(found) = found else {
            return Err(problem(match self {
                Self::Inside(_) => "there is no such file in the folder that may be read",
                Self::Folders { .. } => "there is no such file in the folders that may be read",
                _ => "there is no such file",
            }));
        };
        // A device or a pipe has no end.
        if !found.is_file() {
            return Err(problem("it is not a file"));
        }
        let file = fs::File::open(&found).map_err(|error| problem(&error.to_string()))?;
        let mut bytes = Vec::new();
        file.take(most.saturating_add(1))
            .read_to_end(&mut bytes)
            .map_err(|error| problem(&error.to_string()))?;
        if bytes.len() as u64 > most {
            return Err(problem(&format!("it has more than {most} bytes")));
        }
        Ok(bytes)
    }

    /// The file itself, links followed, when it is there and may be read.
    fn admitted(&self, file: PathBuf) -> Option<PathBuf> {
        let within = |folders: &[PathBuf]| {
            let real = file.canonicalize().ok()?;
            let is_in = |folder: &PathBuf| folder.canonicalize().is_ok_and(|folder| real.starts_with(folder));
            folders.iter().any(is_in).then_some(real)
        };
        match self {
            Self::None => None,
            Self::Any(_) => file.exists().then_some(file),
            Self::Inside(folder) => within(std::slice::from_ref(folder)),
            Self::Folders { folders, .. } => within(folders),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_allowed_is_read() {
        let folder = std::env::temp_dir().join(format!("katydid-files-{}", std::process::id()));
        let inside = folder.join("inside");
        fs::create_dir_all(&inside).unwrap();
        fs::write(folder.join("secret.txt"), "s").unwrap();
        fs::write(inside.join("a.txt"), "hello").unwrap();
        let any = Files::Any(inside.clone());
        assert_eq!(any.read("a.txt", 100).unwrap(), b"hello");
        assert_eq!(any.read("../secret.txt", 100).unwrap(), b"s");
        // From another machine.
        assert_eq!(any.read("C:\\Users\\me\\a.txt", 100).unwrap(), b"hello");
        let only = Files::Inside(inside.clone());
        assert_eq!(only.read("a.txt", 100).unwrap(), b"hello");
        assert!(only.read("../secret.txt", 100).unwrap_err().text.contains("no such file in the folder"));
        assert!(only.read(&folder.join("secret.txt").display().to_string(), 100).is_err());
        let both = |folders: &[&PathBuf]| Files::Folders {
            start: inside.clone(),
            folders: folders.iter().map(|&folder| folder.clone()).collect(),
        };
        assert_eq!(both(&[&inside]).read("a.txt", 100).unwrap(), b"hello");
        assert!(
            both(&[&inside])
                .read("../secret.txt", 100)
                .unwrap_err()
                .text
                .contains("no such file in the folders")
        );
        assert_eq!(both(&[&inside, &folder]).read("../secret.txt", 100).unwrap(), b"s");
        assert!(both(&[]).read("a.txt", 100).is_err());
        assert!(any.read("a.txt", 4).unwrap_err().text.contains("more than 4 bytes"));
        assert!(any.read(".", 4).unwrap_err().text.contains("not a file"));
        assert!(any.read("", 4).is_err());
        assert!(Files::None.read("a.txt", 100).unwrap_err().text.contains("may not be read here"));
        fs::remove_dir_all(&folder).unwrap();
    }
}
