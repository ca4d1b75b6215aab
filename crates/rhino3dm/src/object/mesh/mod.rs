//! Class Mesh (section 8): faces as indices of 1, 2 or 4 bytes, vertex data plain (major version 1) or in
//! compressed buffers (3), and double-precision vertices beside the single-precision ones.

mod double_vertices;
mod ngons;
mod parameters;
mod read;
mod statistics;
mod write;

pub use ngons::Ngon;
pub use parameters::{MeshParameters, SubDMeshing};
pub use statistics::CurvatureStatistics;

pub(super) use read::read;
pub(super) use write::write;

use katydid_geometry::{Interval, Mesh, MeshFace, Point3, Vector3};

use super::MappingTag;
use crate::class_object::UserData;
use crate::version::Version;
use crate::{Result, class_ids};

const WHAT: &str = "mesh";
/// What openNURBS writes for a number that is not set.
pub(super) const UNSET: f64 = -1.234_321_012_343_21e308;
/// A box that is not computed: turned inside out.
const NO_BOX: [f32; 2] = [1.0, -1.0];

/// A mesh as archives have it: everything that openNURBS keeps of one, odd things included. [`MeshObject::to_mesh`]
/// gives the kernel's mesh, `From<Mesh>` takes one.
///
/// Nothing is promised about the numbers: faces may refer to vertices that are not there, coordinates may be
/// infinite, and each list that has an entry a vertex may be of another length, in which case openNURBS pays it no
/// heed. Such lists are empty where the mesh has none of the kind.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshObject {
    /// The vertices in single precision.
    pub vertices: Vec<[f32; 3]>,
    /// The vertices in double precision, where single precision would lose something.
    pub double_vertices: Vec<[f64; 3]>,
    /// Four indices of vertices a face, counter-clockwise; a triangle repeats its third.
    pub faces: Vec<[u32; 4]>,
    /// Unit normals at the vertices.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates u, v at the vertices.
    pub texture_coordinates: Vec<[f32; 2]>,
    /// The two principal curvatures at the vertices.
    pub curvatures: Vec<[f64; 2]>,
    /// Red, green, blue, alpha at the vertices.
    pub colours: Vec<[u8; 4]>,
    /// Parameters u, v at the vertices of the surface that was meshed.
    pub surface_parameters: Vec<[f64; 2]>,
    /// Groups of faces that are seen as one polygon.
    pub ngons: Vec<Ngon>,
    /// The part u, v of the texture that this mesh was given, when the meshes of several faces share one.
    pub packed_texture_domain: [Interval; 2],
    /// Whether the mesh lies turned by a quarter in that part.
    pub packed_texture_rotated: bool,
    /// The domains u, v of the surface that was meshed.
    pub surface_domain: [Interval; 2],
    /// About the length and width of that surface.
    pub surface_scale: [f64; 2],
    /// Least and greatest corner of the box of the vertices; not set until somebody computed it.
    pub vertex_box: [[f64; 3]; 2],
    /// The same of the normals.
    pub normal_box: [[f32; 3]; 2],
    /// The same of the texture coordinates.
    pub texture_box: [[f32; 2]; 2],
    /// Whether it is closed, when somebody found out.
    pub closed: Option<bool>,
    /// What is known of its being manifold, as archives number it: 0 for nothing.
    pub manifold: u8,
    /// What is known of its being oriented, as archives number it: 0 for nothing.
    pub oriented: u8,
    /// What is known of its being solid, as archives number it: 0 for nothing, 1 outward, 2 inward, 3 not.
    pub solid: u8,
    /// How it was made from a surface.
    pub parameters: Option<Box<MeshParameters>>,
    /// Statistics of its Gaussian and mean curvatures and of its least and greatest radii.
    pub curvature_statistics: [Option<Box<CurvatureStatistics>>; 4],
    /// Which mapping made the texture coordinates.
    pub mapping: MappingTag,
}

impl Default for MeshObject {
    /// No vertices, no faces, nothing known.
    fn default() -> Self {
        let unset = Interval::new(UNSET, UNSET);
        Self {
            vertices: Vec::new(),
            double_vertices: Vec::new(),
            faces: Vec::new(),
            normals: Vec::new(),
            texture_coordinates: Vec::new(),
            curvatures: Vec::new(),
            colours: Vec::new(),
            surface_parameters: Vec::new(),
            ngons: Vec::new(),
            packed_texture_domain: [unset; 2],
            packed_texture_rotated: false,
            surface_domain: [unset; 2],
            surface_scale: [0.0; 2],
            vertex_box: [[UNSET; 3]; 2],
            normal_box: NO_BOX.map(|x| [x; 3]),
            texture_box: NO_BOX.map(|x| [x; 2]),
            closed: None,
            manifold: 0,
            oriented: 0,
            solid: 0,
            parameters: None,
            curvature_statistics: [const { None }; 4],
            mapping: MappingTag::default(),
        }
    }
}

impl MeshObject {
    /// The vertices in the best precision there is.
    fn points(&self) -> Vec<Point3> {
        if self.has_double_vertices() {
            return self.double_vertices.iter().copied().map(Point3::from).collect();
        }
        self.vertices.iter().map(|v| Point3::from(v.map(f64::from))).collect()
    }

    /// Whether there is a double-precision vertex for each single-precision one.
    fn has_double_vertices(&self) -> bool {
        !self.double_vertices.is_empty() && self.double_vertices.len() == self.vertices.len()
    }

    /// The kernel's mesh: vertices in double precision where there are such, faces, normals and colours. Normals and
    /// colours that are not one a vertex, or not finite, are left out.
    ///
    /// # Errors
    /// A vertex is not finite, or a face refers to one that is not there.
    pub fn to_mesh(&self) -> katydid_geometry::Result<Mesh> {
        let faces = self.faces.iter().map(|&[a, b, c, d]| {
            if c == d { MeshFace::Triangle([a, b, c]) } else { MeshFace::Quad([a, b, c, d]) }
        });
        let count = self.vertices.len();
        let finite = |n: &[f32; 3]| n.iter().all(|x| x.is_finite());
        let normals: Vec<Vector3> = if self.normals.len() == count && self.normals.iter().all(finite) {
            self.normals.iter().map(|n| Vector3::from(n.map(f64::from))).collect()
        } else {
            Vec::new()
        };
        let colours = if self.colours.len() == count { self.colours.clone() } else { Vec::new() };
        Mesh::from_parts(self.points(), faces.collect(), normals, colours)
    }
}

impl From<&Mesh> for MeshObject {
    fn from(mesh: &Mesh) -> Self {
        let doubles: Vec<[f64; 3]> = mesh.vertices().iter().map(|p| [p.x, p.y, p.z]).collect();
        let vertices: Vec<[f32; 3]> = doubles.iter().map(|p| p.map(single)).collect();
        let lost = doubles.iter().zip(&vertices).any(|(d, s)| s.map(f64::from) != *d);
        let faces = mesh.faces().iter().map(|face| match *face {
            MeshFace::Triangle([a, b, c]) => [a, b, c, c],
            MeshFace::Quad(corners) => corners,
        });
        Self {
            vertices,
            double_vertices: if lost { doubles } else { Vec::new() },
            faces: faces.collect(),
            normals: mesh.normals().iter().map(|n| [n.x, n.y, n.z].map(single)).collect(),
            colours: mesh.colours().to_vec(),
            ..Self::default()
        }
    }
}

impl From<Mesh> for MeshObject {
    fn from(mesh: Mesh) -> Self {
        Self::from(&mesh)
    }
}

/// A number in single precision.
#[allow(clippy::cast_possible_truncation, reason = "rounding to single precision is the point")]
pub(crate) fn single(x: f64) -> f32 {
    x as f32
}

/// Whether user data becomes part of a mesh when it is read, and so is not carried beside it.
pub(super) fn owns(data: &UserData) -> bool {
    data.class == class_ids::DOUBLE_VERTICES
}

/// The user data of a mesh for an archive: what is beside it, and what archives before version 60 have there.
pub(super) fn all_user_data(
    mesh: &MeshObject,
    beside: &[UserData],
    version: Version,
) -> Result<Vec<UserData>> {
    let mut all = Vec::new();
    if version.archive < 60 {
        all.extend(double_vertices::to_user_data(mesh, version)?);
        let has_old_ngons = beside.iter().any(|data| data.class == class_ids::MESH_NGONS);
        if !mesh.ngons.is_empty() && !has_old_ngons {
            all.push(ngons::to_user_data(&mesh.ngons, mesh.vertices.len(), mesh.faces.len(), version)?);
        }
    }
    all.extend(beside.iter().filter(|data| !owns(data)).cloned());
    Ok(all)
}
