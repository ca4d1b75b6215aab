//! The formats, and writing and reading in any of them.

use std::io::Write;

use crate::{Error, LeftOut, Result, Scene, View, gltf, obj, ply, step, stl, svg};

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// Wavefront OBJ: points, polylines, meshes; objects and groups.
    #[default]
    Obj,
    /// STL: triangles.
    Stl,
    /// Stanford PLY: vertices with normals and colours, faces, edges.
    Ply,
    /// glTF 2.0 as one binary file.
    Glb,
    /// glTF 2.0 as text, its data inside as base 64.
    Gltf,
    /// STEP: points, curves, surfaces and solids exactly.
    Step,
    /// SVG 1.1: a drawing of the scene as seen from one side. It is written, not read.
    Svg,
}

/// What is known of a format. A format is added by a variant of [`Format`] and its row here.
struct Row {
    format: Format,
    /// The ending of its files, without the dot and in lower case.
    extension: &'static str,
    /// Other endings by which its files are read.
    also: &'static [&'static str],
    /// Its media type, as registered with IANA where it is.
    media_type: &'static str,
    is_exact: bool,
    write: fn(&Scene, &Options, &mut dyn Write) -> Result<Vec<LeftOut>>,
    /// `None` if it is only written.
    read: Option<Reader>,
}

/// Reads a file whose other files a function fetches.
type Reader = fn(&[u8], &mut dyn FnMut(&str) -> Result<Vec<u8>>) -> Result<Scene>;

/// The table of formats, in the order of [`Format::ALL`].
const ROWS: [Row; 7] = [
    Row {
        format: Format::Obj,
        extension: "obj",
        also: &[],
        media_type: "model/obj",
        is_exact: false,
        write: |scene, options, out| obj::write(scene, options, out),
        read: Some(|bytes, fetch| obj::read(bytes, fetch)),
    },
    Row {
        format: Format::Stl,
        extension: "stl",
        also: &[],
        media_type: "model/stl",
        is_exact: false,
        write: |scene, options, out| stl::write(scene, options, out),
        read: Some(|bytes, _| stl::read(bytes)),
    },
    Row {
        format: Format::Ply,
        extension: "ply",
        also: &[],
        media_type: "application/octet-stream",
        is_exact: false,
        write: |scene, options, out| ply::write(scene, options, out),
        read: Some(|bytes, _| ply::read(bytes)),
    },
    Row {
        format: Format::Glb,
        extension: "glb",
        also: &[],
        media_type: "model/gltf-binary",
        is_exact: false,
        write: |scene, options, out| gltf::write_glb(scene, options, out),
        read: Some(|bytes, fetch| gltf::read(bytes, fetch)),
    },
    Row {
        format: Format::Gltf,
        extension: "gltf",
        also: &[],
        media_type: "model/gltf+json",
        is_exact: false,
        write: |scene, options, out| gltf::write_gltf(scene, options, out),
        read: Some(|bytes, fetch| gltf::read(bytes, fetch)),
    },
    Row {
        format: Format::Step,
        extension: "step",
        also: &["stp", "p21"],
        media_type: "model/step",
        is_exact: true,
        write: |scene, _, out| step::write(scene, out),
        read: Some(|bytes, _| step::read(bytes)),
    },
    Row {
        format: Format::Svg,
        extension: "svg",
        also: &[],
        media_type: "image/svg+xml",
        is_exact: false,
        write: |scene, options, out| svg::write(scene, options, out),
        read: None,
    },
];

impl Format {
    /// All formats.
    pub const ALL: [Self; ROWS.len()] = {
        let mut all = [Self::Obj; ROWS.len()];
        let mut i = 0;
        while i < ROWS.len() {
            // A row that stood in another place would be another format's.
            assert!(ROWS[i].format as usize == i);
            all[i] = ROWS[i].format;
            i += 1;
        }
        all
    };

    const fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// The extension of its files, without the dot and in lower case.
    pub const fn extension(self) -> &'static str {
        self.row().extension
    }

    /// The format of files with that extension, without the dot and in lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        let has = |row: &&Row| row.extension == extension || row.also.contains(&extension);
        ROWS.iter().find(has).map(|row| row.format)
    }

    /// The media type of its files.
    pub const fn media_type(self) -> &'static str {
        self.row().media_type
    }

    /// Whether its files can be read; all can be written.
    pub const fn is_read(self) -> bool {
        self.row().read.is_some()
    }

    /// Whether the format holds surfaces and solids exactly: then [`Conversion::exact`](crate::Conversion::exact)
    /// should be set.
    pub const fn is_exact(self) -> bool {
        self.row().is_exact
    }
}

/// How a file is written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options {
    /// How far polylines may be from the curves they stand for, and Bézier curves from curves that are none, in the
    /// scene's units. When not given: the scene's tolerance, or a ten-thousandth of the curve's size if that is more.
    pub tolerance: Option<f64>,
    /// STL and PLY as text instead of binary.
    pub ascii: bool,
    /// Where a drawing is seen from.
    pub view: View,
    /// The name of the file of materials that an OBJ points to, as [`write_materials`] writes it. Without it an OBJ has no
    /// colours but those of vertices.
    pub materials: Option<String>,
}

/// Writes a scene; gives what the format could not hold, with what the scene itself had to leave out.
///
/// The destination gets many writes of some kilobytes, so a file needs no buffer around it.
///
/// # Errors
/// A coordinate that is not finite or beyond the format's numbers, more vertices than the format can count, or a
/// destination that fails. What was written until then is no whole file.
pub fn write(scene: &Scene, format: Format, options: &Options, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    scene.check_finite(format)?;
    let faceted = if format.is_exact() { None } else { scene.faceted(options.tolerance) };
    let scene = faceted.as_ref().unwrap_or(scene);
    let mut left_out = scene.left_out.clone();
    let more = (format.row().write)(scene, options, out)?;
    more.into_iter().for_each(|one| LeftOut::add(&mut left_out, one));
    out.flush()?;
    Ok(left_out)
}

/// Whether a scene has colours that an OBJ needs a file of materials for.
pub fn needs_materials(scene: &Scene) -> bool {
    scene.things.iter().any(|thing| thing.colour.is_some())
}

/// Writes the file of materials (MTL) that an OBJ of the scene points to by [`Options::materials`].
///
/// # Errors
/// The destination fails.
pub fn write_materials(scene: &Scene, out: &mut dyn Write) -> Result<()> {
    obj::write_materials(scene, out)
}

/// Reads a file: its points, curves, meshes and breps.
///
/// # Errors
/// The bytes do not keep to the format, or it is SVG. A .gltf file whose data lies in other files needs
/// [`read_with`].
pub fn read(bytes: &[u8], format: Format) -> Result<Scene> {
    read_with(bytes, format, &mut |name| {
        Err(Error::Unsupported(format!("it lies in another file, {name}, which may not be opened here")))
    })
}

/// Reads a file that may name others: `fetch` gives their bytes, by the name that stands in the file. Whether that name
/// may be opened at all is for `fetch` to decide.
///
/// # Errors
/// As [`read`], and those of `fetch`.
pub fn read_with(
    bytes: &[u8],
    format: Format,
    fetch: &mut dyn FnMut(&str) -> Result<Vec<u8>>,
) -> Result<Scene> {
    match format.row().read {
        Some(read) => read(bytes, fetch),
        None => {
            let name = format.extension().to_uppercase();
            Err(Error::Unsupported(format!("{name} can be written, but not read")))
        }
    }
}
