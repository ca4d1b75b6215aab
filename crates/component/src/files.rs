use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::Message;

/// Which files of the machine a definition may read. A definition names files by itself, so whoever solves one that
/// came from elsewhere decides.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Files {
    /// None.
    #[default]
    None,
    /// Any; a path that is not absolute starts at this folder, the definition's own as a rule.
    Any(PathBuf),
    /// Those in this folder and the folders inside it.
    Inside(PathBuf),
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
            Self::Any(folder) | Self::Inside(folder) => folder,
        };
        let named = PathBuf::from(path.trim());
        let first = folder.join(&named);
        let beside =
            path.rsplit(['/', '\\']).next().filter(|name| !name.is_empty()).map(|name| folder.join(name));
        let found = std::iter::once(first).chain(beside).find(|file| self.allows(file) && file.exists());
        let Some(found) = found else {
            return Err(problem(match self {
                Self::Inside(_) => "there is no such file in the folder that may be read",
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

    /// Whether a file may be read, links followed.
    fn allows(&self, file: &Path) -> bool {
        match self {
            Self::None => false,
            Self::Any(_) => true,
            Self::Inside(folder) => match (folder.canonicalize(), file.canonicalize()) {
                (Ok(folder), Ok(file)) => file.starts_with(folder),
                _ => false,
            },
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
        assert!(any.read("a.txt", 4).unwrap_err().text.contains("more than 4 bytes"));
        assert!(any.read(".", 4).unwrap_err().text.contains("not a file"));
        assert!(any.read("", 4).is_err());
        assert!(Files::None.read("a.txt", 100).unwrap_err().text.contains("may not be read here"));
        fs::remove_dir_all(&folder).unwrap();
    }
}
