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

impl Format {
    /// All formats.
    pub const ALL: [Self; 7] =
        [Self::Obj, Self::Stl, Self::Ply, Self::Glb, Self::Gltf, Self::Step, Self::Svg];

    /// The extension of its files, without the dot and in lower case.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Ply => "ply",
            Self::Glb => "glb",
            Self::Gltf => "gltf",
            Self::Step => "step",
            Self::Svg => "svg",
        }
    }

    /// The format of files with that extension, without the dot and in lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        match extension {
            "stp" | "p21" => Some(Self::Step),
            _ => Self::ALL.into_iter().find(|format| format.extension() == extension),
        }
    }

    /// Whether the format holds surfaces and solids exactly: then [`Conversion::exact`](crate::Conversion::exact)
    /// should be set.
    pub const fn is_exact(self) -> bool {
        matches!(self, Self::Step)
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
    let more = match format {
        Format::Obj => obj::write(scene, options, out)?,
        Format::Stl => stl::write(scene, options, out)?,
        Format::Ply => ply::write(scene, options, out)?,
        Format::Glb => gltf::write_glb(scene, options, out)?,
        Format::Gltf => gltf::write_gltf(scene, options, out)?,
        Format::Step => step::write(scene, out)?,
        Format::Svg => svg::write(scene, options, out)?,
    };
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
    match format {
        Format::Obj => obj::read(bytes, fetch),
        Format::Stl => stl::read(bytes),
        Format::Ply => ply::read(bytes),
        Format::Glb | Format::Gltf => gltf::read(bytes, fetch),
        Format::Step => step::read(bytes),
        Format::Svg => Err(Error::Unsupported("SVG can be written, but not read".into())),
    }
}
