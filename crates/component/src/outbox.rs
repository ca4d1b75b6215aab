//! Files that a definition writes, kept until whoever runs it puts them where they may go.
//!
//! A definition may name any path of any machine (`C:\\Users\\…`), and whoever made it is not who runs it. So components open no
//! file: they put bytes here, and of a path only the name of the file counts.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use crate::Message;

/// The most bytes that systems take for the name of a file.
const LONGEST_NAME: usize = 255;
/// The most files of a run.
const MOST_FILES: usize = 10_000;

/// The files that components have written in a run.
#[derive(Debug, Default)]
pub struct Outbox(Mutex<BTreeMap<String, OutFile>>);

/// A file that is to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutFile {
    /// Its name, without folders.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

impl Outbox {
    /// Puts a file in; gives its name. A later file takes the place of an earlier one of the same name, whatever the case of
    /// letters, as on a disk.
    ///
    /// # Errors
    /// The message to show when the path has no name of a file, or there are more than 10,000 files.
    pub fn put(&self, path: &str, bytes: Vec<u8>) -> Result<String, Message> {
        let Some(name) = file_name(path) else {
            return Err(Message::error(format!("{path} cannot be written: it has no name of a file")));
        };
        let mut files = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // Some systems do not tell large letters from small ones.
        let key = name.to_lowercase();
        if files.len() >= MOST_FILES && !files.contains_key(&key) {
            return Err(Message::error(format!("More than {MOST_FILES} files are written")));
        }
        files.insert(key, OutFile { name: name.to_owned(), bytes });
        Ok(name.to_owned())
    }

    /// Takes all files out, by name.
    pub fn take(&self) -> Vec<OutFile> {
        let mut files = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut *files).into_values().collect()
    }
}

/// The name of the file of a path of Windows or Unix; none where it has no name that is safe to write to.
///
/// ```
/// use katydid_component::file_name;
///
/// assert_eq!(file_name("C:\\Users\\anna\\points.txt"), Some("points.txt"));
/// assert_eq!(file_name("a/.."), None);
/// ```
pub fn file_name(path: &str) -> Option<&str> {
    let name = path.rsplit(['/', '\\', ':']).next()?.trim();
    let is_safe = !name.is_empty()
        && name.len() <= LONGEST_NAME
        && !name.chars().all(|letter| letter == '.')
        && !name.chars().any(char::is_control);
    is_safe.then_some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_name_of_a_path_counts() {
        for (path, name) in [
            ("C:\\Users\\anna\\Desktop\\points.txt", Some("points.txt")),
            ("/tmp/points.csv", Some("points.csv")),
            ("points.txt", Some("points.txt")),
            ("../../etc/cron.d/evil", Some("evil")),
            ("C:points.txt", Some("points.txt")),
            ("..", None),
            ("a/..", None),
            ("a/", None),
            ("", None),
            ("a\n", Some("a")),
            ("a\nb", None),
            ("a\0b", None),
        ] {
            assert_eq!(file_name(path), name, "{path:?}");
        }
        assert_eq!(file_name(&"a".repeat(256)), None);
    }

    #[test]
    fn a_later_file_takes_the_place_of_an_earlier_one() {
        let outbox = Outbox::default();
        assert_eq!(outbox.put("C:\\b.csv", vec![1]).unwrap(), "b.csv");
        outbox.put("a.csv", vec![2]).unwrap();
        outbox.put("/elsewhere/B.csv", vec![3]).unwrap();
        assert!(outbox.put("..", vec![]).unwrap_err().text.contains("no name of a file"));
        let files = outbox.take();
        let told: Vec<(&str, &[u8])> =
            files.iter().map(|file| (file.name.as_str(), file.bytes.as_slice())).collect();
        assert_eq!(told, [("a.csv", &[2_u8][..]), ("B.csv", &[3])]);
        assert!(outbox.take().is_empty());
    }

    #[test]
    fn files_have_a_limit() {
        let outbox = Outbox::default();
        for number in 0..MOST_FILES {
            outbox.put(&number.to_string(), Vec::new()).unwrap();
        }
        assert!(outbox.put("one more", Vec::new()).unwrap_err().text.contains("More than"));
        assert!(outbox.put("7", vec![7]).is_ok());
    }
}
