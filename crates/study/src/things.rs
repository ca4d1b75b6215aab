//! The picture and the geometry of a point, in files named by their content.

use std::path::{Path, PathBuf};

use katydid_exchange::{Conversion, Format, Options as WriteOptions, Scene};
use katydid_picture::Options as Look;
use katydid_session::{BakeOptions, bake, write_file};
use katydid_solver::Engine;

use crate::StudyError;

/// The version of .3dm files: that of Rhino 7.
const VERSION: i32 = 70;
/// Width and height of pictures in pixels.
const PICTURE: [u32; 2] = [640, 480];

/// Which files points get.
#[derive(Debug, Clone, Default)]
pub struct Things {
    folder: PathBuf,
    pictures: bool,
    /// An extension.
    geometry: Option<String>,
}

impl Things {
    /// The folders for pictures and geometry are made where they are needed.
    ///
    /// # Errors
    /// The geometry's format is not known, or a folder cannot be made.
    pub fn new(folder: &Path, pictures: bool, geometry: Option<&str>) -> Result<Self, StudyError> {
        if let Some(extension) = geometry
            && extension != "3dm"
            && Format::from_extension(extension).is_none()
        {
            return Err(StudyError::Plan(format!(
                "geometry '{extension}': glb, 3dm, or another format that is written"
            )));
        }
        let things = Self { folder: folder.to_path_buf(), pictures, geometry: geometry.map(str::to_owned) };
        for (name, wanted) in [("pictures", pictures), ("geometry", geometry.is_some())] {
            if wanted {
                let path = folder.join(name);
                std::fs::create_dir_all(&path).map_err(|error| StudyError::file(&path, error))?;
            }
        }
        Ok(things)
    }

    /// Writes the picture and the geometry of a solved engine; gives their paths in the study's folder, with / between
    /// their parts, empty where none is wanted.
    ///
    /// # Errors
    /// One could not be made or written.
    pub fn write(&self, engine: &Engine) -> Result<[String; 2], StudyError> {
        let mut names = [String::new(), String::new()];
        if self.pictures {
            let look = Look { size: PICTURE, title: " ".to_owned(), ..Look::default() };
            let picture = katydid_picture::result(engine, &look);
            let bytes = picture
                .drawing
                .to_png()
                .map_err(|error| StudyError::Unfit(format!("its picture: {error}")))?;
            names[0] = self.keep("pictures", "png", &bytes)?;
        }
        if let Some(extension) = &self.geometry {
            let bytes = geometry(engine, extension)?;
            names[1] = self.keep("geometry", extension, &bytes)?;
        }
        Ok(names)
    }

    fn keep(&self, folder: &str, extension: &str, bytes: &[u8]) -> Result<String, StudyError> {
        let hash = blake3::hash(bytes).to_hex();
        let name = format!("{folder}/{}.{extension}", hash.get(..32).unwrap_or_default());
        let path = self.folder.join(&name);
        if !path.exists() {
            write_file(&path, bytes).map_err(|error| StudyError::file(&path, error))?;
        }
        Ok(name)
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
