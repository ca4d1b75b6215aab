//! The file in which a studio tells its address to the programs of assistants.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::PathBuf;

use super::private_folder;

/// A file with an address and its token, which only its owner can read. It goes with this value, unless another studio has
/// written its own there since.
#[derive(Debug)]
pub(crate) struct AddressFile {
    path: PathBuf,
    text: String,
}

impl AddressFile {
    /// Writes an address, in place of that of another studio.
    pub(crate) fn write(path: PathBuf, url: &str) -> io::Result<Self> {
        if let Some(folder) = path.parent() {
            private_folder(folder)?;
        }
        // A new file, so that nobody has the old one open, and a link that stands there is not followed.
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        let mut options = File::options();
        options.write(true).create_new(true);
        #[cfg(unix)]
        {
            use std::os::unix::fs::OpenOptionsExt;
            options.mode(0o600);
        }
        let text = format!("{url}\n");
        options.open(&path)?.write_all(text.as_bytes())?;
        Ok(Self { path, text })
    }
}

impl Drop for AddressFile {
    fn drop(&mut self) {
        if fs::read_to_string(&self.path).is_ok_and(|text| text == self.text) {
            // A file that cannot be removed names a server that does not answer.
            let _ = fs::remove_file(&self.path);
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use std::os::unix::fs::PermissionsExt;

    use super::*;

    #[test]
    fn only_its_owner_reads_it_and_the_last_one_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state").join("studio-address");
        let first = AddressFile::write(path.clone(), "http://127.0.0.1:1/?token=a").unwrap();
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o600);
        let second = AddressFile::write(path.clone(), "http://127.0.0.1:2/?token=b").unwrap();
        drop(first);
        assert_eq!(fs::read_to_string(&path).unwrap(), "http://127.0.0.1:2/?token=b\n");
        drop(second);
        assert!(!path.exists());
    }
}
