use std::fs::DirBuilder;
use std::io;
use std::path::Path;

/// Makes a folder that only its owner may look into, with those above it that are missing. One that is there stays as it
/// is. What is kept between runs holds documents, whoever may read their files.
pub(crate) fn private_folder(path: &Path) -> io::Result<()> {
    let mut builder = DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::DirBuilderExt;
        builder.mode(0o700);
    }
    builder.create(path)
}

#[cfg(all(test, unix))]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use std::os::unix::fs::PermissionsExt;

    use super::*;

    #[test]
    fn nobody_else_looks_into_it() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("state").join("journals");
        private_folder(&inner).unwrap();
        private_folder(&inner).unwrap();
        for made in [&inner, &folder.path().join("state")] {
            assert_eq!(std::fs::metadata(made).unwrap().permissions().mode() & 0o777, 0o700);
        }
    }
}
