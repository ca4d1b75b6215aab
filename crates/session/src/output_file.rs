//! Files that are there whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use uuid::Uuid;

/// A file that is being written. It has a random name beside the place where it shall be, until
/// [`finish`](Self::finish) puts it there: whatever happens in between, the old file or the new one is there, whole.
/// Dropped before, it leaves nothing behind.
///
/// The file under the random name is created exclusively: two programs that write the same output do not share one, and
/// a symbolic link that somebody placed there is not followed. A link at the place itself is followed, and who may read
/// the old file may read the new one. What is no plain file (a device, a pipe) is written to as it stands, since it
/// cannot be replaced.
#[derive(Debug)]
pub struct OutputFile {
    file: File,
    /// Where it shall be.
    target: PathBuf,
    /// Where it is now; nothing for what is written to directly.
    beside: Option<PathBuf>,
}

impl OutputFile {
    /// Begins a file that shall be at a path.
    ///
    /// # Errors
    /// When the path is a folder, or no file can be created beside it.
    pub fn create(path: &Path) -> io::Result<Self> {
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
        let old = fs::metadata(&target).ok();
        if let Some(old) = old.as_ref().filter(|old| !old.is_file()) {
            if old.is_dir() {
                return Err(io::ErrorKind::IsADirectory.into());
            }
            let file = File::options().write(true).open(&target)?;
            return Ok(Self { file, target, beside: None });
        }
        let beside = beside(&target);
        let file = File::options().write(true).create_new(true).open(&beside)?;
        // From here on the file is taken away when something fails.
        let made = Self { file, target, beside: Some(beside) };
        if let Some(old) = old {
            made.file.set_permissions(old.permissions())?;
        }
        Ok(made)
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// When its last bytes cannot be written, or it cannot be renamed; the old file is there as it was.
    pub fn finish(mut self) -> io::Result<()> {
        let Some(beside) = &self.beside else { return self.file.flush() };
        self.file.sync_all()?;
        fs::rename(beside, &self.target)?;
        self.beside = None;
        Ok(())
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for OutputFile {
    fn drop(&mut self) {
        if let Some(beside) = &self.beside {
            let _ = fs::remove_file(beside);
        }
    }
}

/// Writes a file whole or not at all, as [`OutputFile`] does.
///
/// # Errors
/// When it cannot be written; the old file is there as it was.
pub fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OutputFile::create(path)?;
    file.write_all(bytes)?;
    file.finish()
}

/// A name that nobody guesses, in the same folder. Long names are cut, so that it is not longer than systems allow.
fn beside(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let start: String = name.chars().take(40).collect();
    path.with_file_name(format!(".{start}.{}.part", Uuid::new_v4().simple()))
}

/// Removes what programs that were ended in the middle of writing this file have left beside it. Only for whoever alone
/// writes there: another program's unfinished file would go too.
///
/// # Errors
/// When the folder cannot be read, or one of them cannot be removed.
pub fn remove_unfinished(path: &Path) -> io::Result<()> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let start: String = name.chars().take(40).collect();
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let found = entry.file_name().to_string_lossy().into_owned();
        let random = found
            .strip_prefix(&format!(".{start}."))
            .and_then(|rest| rest.strip_suffix(".part"))
            .is_some_and(|random| Uuid::try_parse(random).is_ok());
        if random && entry.file_type()?.is_file() {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn unfinished_files_of_one_place_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        // As a program leaves it that is ended before it can remove it.
        std::mem::forget(OutputFile::create(&path).unwrap());
        for other in [".b.csv.0f8fad5bd9cb469fa16570867728950e.part", ".a.csv.mine.part", "a.csv"] {
            fs::write(folder.path().join(other), "").unwrap();
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 4);
        remove_unfinished(&path).unwrap();
        let mut left: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
        left.sort();
        assert_eq!(left, [".a.csv.mine.part", ".b.csv.0f8fad5bd9cb469fa16570867728950e.part", "a.csv"]);
    }

    #[test]
    fn a_file_is_replaced_whole_and_nothing_stays_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.kd");
        write_file(&path, b"one").unwrap();
        write_file(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert!(write_file(&folder.path().join("none").join("a.kd"), b"x").is_err());
        assert!(write_file(folder.path(), b"x").is_err());
        // Half a file is none.
        let mut half = OutputFile::create(&path).unwrap();
        half.write_all(b"thr").unwrap();
        drop(half);
        assert_eq!(
            (fs::read(&path).unwrap(), names(folder.path())),
            (b"two".to_vec(), vec!["a.kd".to_owned()])
        );
        let long = folder.path().join(format!("{}.kd", "é".repeat(120)));
        write_file(&long, b"x").unwrap();
        assert_eq!(fs::read(&long).unwrap(), b"x");
    }

    #[test]
    fn who_writes_the_same_file_does_not_share_a_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.bin");
        std::thread::scope(|scope| {
            for k in 0..8_u8 {
                let path = &path;
                scope.spawn(move || {
                    for _ in 0..20 {
                        let mut file = OutputFile::create(path).unwrap();
                        for _ in 0..16 {
                            file.write_all(&[k; 1024]).unwrap();
                        }
                        file.finish().unwrap();
                        let found = fs::read(path).unwrap();
                        let first = found.first().copied();
                        assert!(found.len() == 16 << 10 && found.iter().all(|byte| Some(*byte) == first));
                    }
                });
            }
        });
        assert_eq!(names(folder.path()), ["a.bin"]);
    }

    #[cfg(unix)]
    #[test]
    fn links_beside_are_not_followed_and_a_link_in_its_place_is() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (path, victim) = (folder.path().join("a.kd"), folder.path().join("victim"));
        fs::write(&victim, "mine").unwrap();
        symlink(&victim, folder.path().join("a.kd.part")).unwrap();
        symlink(&victim, folder.path().join("a.new")).unwrap();
        write_file(&path, b"x").unwrap();
        assert_eq!(fs::read(&victim).unwrap(), b"mine");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        let link = folder.path().join("link.kd");
        symlink(&path, &link).unwrap();
        write_file(&link, b"y").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&path).unwrap(), b"y");
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
        // A device stays one.
        write_file(Path::new("/dev/null"), b"x").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }
}
