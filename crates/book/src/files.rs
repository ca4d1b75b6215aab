use std::collections::BTreeMap;
use std::path::Path;

/// Larger files are no pages, definitions or values.
const LARGEST: u64 = 4 << 20;
/// A book has no more files.
const MOST_FILES: usize = 20_000;
/// Folders stand in one another so deep at most: `de/more/name`.
const DEEPEST: usize = 6;
/// What a book is made of.
const KINDS: [&str; 4] = ["md", "kd", "json", "txt"];

/// The files of a book, by their paths from its folder with `/` between the parts.
#[derive(Debug, Clone, Default)]
pub struct Files(BTreeMap<String, Vec<u8>>);

impl Files {
    /// Those of a folder and the folders in it: pages, definitions, values, words.
    ///
    /// # Errors
    /// A folder or file cannot be read, or is larger than any book.
    pub fn folder(path: &Path) -> Result<Self, String> {
        let mut files = Self::default();
        files.walk(path, "", 0)?;
        Ok(files)
    }

    fn walk(&mut self, folder: &Path, name: &str, depth: usize) -> Result<(), String> {
        let told = |path: &Path, error: &std::io::Error| format!("{}: {error}", path.display());
        let entries = std::fs::read_dir(folder).map_err(|error| told(folder, &error))?;
        for entry in entries {
            let entry = entry.map_err(|error| told(folder, &error))?;
            let (path, Ok(own)) = (entry.path(), entry.file_name().into_string()) else { continue };
            if own.starts_with('.') {
                continue;
            }
            let inner = if name.is_empty() { own } else { format!("{name}/{own}") };
            let about = entry.metadata().map_err(|error| told(&path, &error))?;
            if about.is_dir() && depth < DEEPEST {
                self.walk(&path, &inner, depth + 1)?;
            } else if about.is_file() && is_known(&inner) {
                if about.len() > LARGEST || self.0.len() >= MOST_FILES {
                    return Err(format!("{}: this is larger than any book", path.display()));
                }
                let bytes = std::fs::read(&path).map_err(|error| told(&path, &error))?;
                self.0.insert(inner, bytes);
            }
        }
        Ok(())
    }

    /// Adds one.
    pub fn put(&mut self, path: impl Into<String>, bytes: Vec<u8>) {
        self.0.insert(path.into(), bytes);
    }

    /// The bytes of one.
    pub fn get(&self, path: &str) -> Option<&[u8]> {
        self.0.get(path).map(Vec::as_slice)
    }

    /// One as text; `None` where it is not there.
    pub(crate) fn text(&self, path: &str) -> Option<Result<&str, String>> {
        let bytes = self.get(path)?;
        Some(std::str::from_utf8(bytes).map_err(|error| format!("byte {} is no UTF-8", error.valid_up_to())))
    }

    /// The paths.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
}

fn is_known(name: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, kind)| KINDS.contains(&kind))
}
