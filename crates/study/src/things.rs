//! The picture and the geometry of a point, in files named by their content.

use std::path::Path;

use katydid_exchange::{Conversion, Format, Options as WriteOptions, Scene};
use katydid_picture::Options as Look;
use katydid_session::{BakeOptions, bake, write_file};
use katydid_solver::Engine;

use crate::StudyError;

/// The version of .3dm files: that of Rhino 7.
const VERSION: i32 = 70;
/// Width and height of pictures in pixels.
const PICTURE: [u32; 2] = [640, 480];
/// The folders of a study with files of points.
const PICTURES: &str = "pictures";
const GEOMETRY: &str = "geometry";

/// Which files points get.
#[derive(Debug, Clone, Default)]
pub struct Things {
    pictures: bool,
    /// An extension.
    geometry: Option<String>,
}

/// A file of a point that is not written yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Thing {
    /// Its path in the study's folder, with / between its parts.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

impl Things {
    /// Whether points get a picture, and geometry of which extension.
    ///
    /// # Errors
    /// The geometry's format is not known.
    pub fn new(pictures: bool, geometry: Option<&str>) -> Result<Self, StudyError> {
        if let Some(extension) = geometry
            && extension != "3dm"
            && Format::from_extension(extension).is_none()
        {
            return Err(StudyError::Plan(format!(
                "geometry '{extension}': glb, 3dm, or another format that is written"
            )));
        }
        Ok(Self { pictures, geometry: geometry.map(str::to_owned) })
    }

    /// Makes the folders in which the files of a study are.
    ///
    /// # Errors
    /// One cannot be made.
    pub fn make_folders(&self, folder: &Path) -> Result<(), StudyError> {
        for (name, wanted) in [(PICTURES, self.pictures), (GEOMETRY, self.geometry.is_some())] {
            if wanted {
                let path = folder.join(name);
                std::fs::create_dir_all(&path).map_err(|error| StudyError::file(&path, error))?;
            }
        }
        Ok(())
    }

    /// Makes the picture and the geometry of a solved engine, where they are wanted.
    ///
    /// # Errors
    /// One could not be made.
    pub fn make(&self, engine: &Engine) -> Result<[Option<Thing>; 2], StudyError> {
        let mut made = [None, None];
        if self.pictures {
            let look = Look { size: PICTURE, title: " ".to_owned(), ..Look::default() };
            let picture = katydid_picture::result(engine, &look);
            let bytes = picture
                .drawing
                .to_png()
                .map_err(|error| StudyError::Unfit(format!("its picture: {error}")))?;
            made[0] = Some(Thing::new(PICTURES, "png", bytes));
        }
        if let Some(extension) = &self.geometry {
            made[1] = Some(Thing::new(GEOMETRY, extension, geometry(engine, extension)?));
        }
        Ok(made)
    }
}

impl Thing {
    fn new(folder: &str, extension: &str, bytes: Vec<u8>) -> Self {
        let hash = blake3::hash(&bytes).to_hex();
        let name = format!("{folder}/{}.{extension}", hash.get(..32).unwrap_or_default());
        Self { name, bytes }
    }

    /// A file that another process made: its name must be what its content says.
    ///
    /// # Errors
    /// It is not.
    pub fn checked(name: &str, bytes: Vec<u8>) -> Result<Self, StudyError> {
        let (folder, extension) =
            name.split_once('/').zip(name.rsplit_once('.')).map_or(("", ""), |(a, b)| (a.0, b.1));
        let thing = Self::new(folder, extension, bytes);
        let is_plain = extension.bytes().all(|byte| byte.is_ascii_alphanumeric());
        if ![PICTURES, GEOMETRY].contains(&folder) || !is_plain || thing.name != name {
            return Err(StudyError::Unfit(format!("'{name}' is no file of a point")));
        }
        Ok(thing)
    }

    /// Writes it, where it is not there yet.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), StudyError> {
        let path = folder.join(&self.name);
        if path.exists() {
            return Ok(());
        }
        write_file(&path, &self.bytes).map_err(|error| StudyError::file(&path, error))
    }
}

fn geometry(engine: &Engine, extension: &str) -> Result<Vec<u8>, StudyError> {
    let failed = |error: &dyn std::fmt::Display| StudyError::Unfit(format!("its geometry: {error}"));
    let baked = bake(engine, BakeOptions::default());
    if extension == "3dm" {
        return baked.model.write_what_fits(VERSION).map(|(bytes, _)| bytes).map_err(|error| failed(&error));
    }
    let format = Format::from_extension(extension).unwrap_or_default();
    let scene = Scene::from_model_with(
        &baked.model,
        &Conversion { exact: format.is_exact(), ..Conversion::default() },
    );
    let mut bytes = Vec::new();
    katydid_exchange::write(&scene, format, &WriteOptions::default(), &mut bytes)
        .map_err(|error| failed(&error))?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_from_elsewhere_must_have_the_name_of_its_content() {
        let made = Thing::new(GEOMETRY, "glb", vec![1, 2, 3]);
        assert_eq!(Thing::checked(&made.name, made.bytes.clone()).unwrap(), made);
        assert!(Thing::checked(&made.name, vec![1, 2]).is_err());
        for name in ["", "geometry/x.glb", "../a/b.glb", "cache/a.kdstudy", "/etc/passwd"] {
            assert!(Thing::checked(name, vec![1, 2, 3]).is_err(), "{name}");
        }
        let outside = Thing::new("..", "glb", vec![1]);
        assert!(Thing::checked(&outside.name, vec![1]).is_err());
        let above = Thing::new(GEOMETRY, "x/../../up", vec![1]);
        assert!(Thing::checked(&above.name, vec![1]).is_err());
    }
}
