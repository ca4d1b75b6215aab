//! One openNURBS class object (sections 6 and 8): read into geometry where this crate knows the class, else kept
//! byte for byte.

mod bare_brep;
mod brep;
mod class_object;
mod curve;
mod mapping_tag;
mod mesh;
mod on_data;
mod point;
mod point_cloud;
mod raw;
mod surface;
mod user_data;

pub use bare_brep::BareSurface;
pub use brep::{BrepEdge, BrepSummary, Solidity};
pub use mapping_tag::MappingTag;
pub use mesh::{CurvatureStatistics, MeshObject, MeshParameters, Ngon, SubDMeshing};
pub use on_data::OnData;
pub use point_cloud::PointCloud;
pub use raw::RawObject;
pub use user_data::UserData;

pub(crate) use class_object::{ClassObject, write_class};

use katydid_geometry::{Curve, Mesh, Plane, Point3, Surface};
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::version::Version;
use crate::{Error, Result, class_ids};

/// A geometric object of an archive.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Object {
    /// A point.
    Point(Point3),
    /// Many points, with normals and colours if they have them.
    PointCloud(PointCloud),
    /// A curve of any kind the kernel has. Curves in a plane (dimension 2) lie at z = 0.
    Curve(Curve),
    /// A surface without trims: of a plane, of revolution, a sum of two curves, or NURBS.
    Surface(Surface),
    /// A mesh with everything that archives keep of one.
    Mesh(Box<MeshObject>),
    /// A class this crate does not take apart, or an object the kernel refused: its bytes as they were.
    Kept(RawObject),
}

impl Object {
    /// The name of the openNURBS class that holds this object, or its identifier when that is not known.
    pub fn class_name(&self) -> String {
        match self {
            Self::Kept(raw) => raw.class_name(),
            other => class_ids::name(other.class()).unwrap_or_default().to_owned(),
        }
    }

    /// Whether an archive of the given version can carry this object.
    ///
    /// # Errors
    /// The version is not written, or the object was kept from an archive whose layout it does not share; the
    /// error says why.
    pub fn check_writable(&self, version: i32) -> Result<()> {
        Version::for_writing(version)?;
        match self {
            Self::Kept(raw) => raw.check_fits(version),
            _ => Ok(()),
        }
    }

    /// The class under which this object is written.
    pub(crate) fn class(&self) -> Uuid {
        match self {
            Self::Point(_) => class_ids::POINT,
            Self::PointCloud(_) => class_ids::POINT_CLOUD,
            Self::Curve(c) => curve::class_of(c),
            Self::Surface(s) => surface::class_of(s),
            Self::Mesh(_) => class_ids::MESH,
            Self::Kept(raw) => raw.class,
        }
    }

    /// Takes a class object apart, or keeps it when its class is none of those above.
    ///
    /// Fails when the class is known but its bytes are broken or hold numbers that the kernel refuses.
    pub(crate) fn from_class(object: &ClassObject<'_>) -> Result<Self> {
        let Some(data) = object.data.clone() else { return Ok(Self::Kept(object.to_raw())) };
        let mut body: Reader<'_> = data;
        let parsed = match class_ids::canonical(object.class) {
            class_ids::POINT => Self::Point(point::read(&mut body)?),
            class_ids::POINT_CLOUD => Self::PointCloud(point_cloud::read(&mut body)?),
            class_ids::MESH => Self::Mesh(Box::new(mesh::read(&mut body, &object.user_data)?)),
            class if curve::is_curve(class) => Self::Curve(curve::read(class, &mut body)?),
            class if surface::is_surface(class) => Self::Surface(surface::read(class, &mut body)?),
            _ => return Ok(Self::Kept(object.to_raw())),
        };
        body.finish();
        Ok(parsed)
    }

    /// The user data that is carried beside this object: none beside a kept one, whose bytes hold it, and beside
    /// others what did not become part of them.
    pub(crate) fn user_data_beside(&self, mut all: Vec<UserData>) -> Vec<UserData> {
        match self {
            Self::Kept(_) => all.clear(),
            Self::Mesh(_) => all.retain(|data| !mesh::owns(data)),
            _ => {}
        }
        all
    }

    /// Writes the class object, with user data behind the body. Kept objects go out as they came, and carry
    /// their own user data already.
    pub(crate) fn write(&self, w: &mut Writer, user_data: &[UserData]) -> Result<()> {
        match self {
            Self::Kept(raw) => raw.write(w),
            Self::Point(p) => write_class(w, self.class(), user_data, |w| point::write(*p, w)),
            Self::PointCloud(c) => write_class(w, self.class(), user_data, |w| point_cloud::write(c, w)),
            Self::Curve(c) => write_class(w, self.class(), user_data, |w| curve::write(c, w)),
            Self::Surface(s) => write_class(w, self.class(), user_data, |w| surface::write(s, w)),
            Self::Mesh(m) => {
                let all = mesh::all_user_data(m, user_data, w.version())?;
                write_class(w, self.class(), &all, |w| mesh::write(m, w))
            }
        }
    }
}

impl From<Mesh> for Object {
    fn from(mesh: Mesh) -> Self {
        Self::Mesh(Box::new(mesh.into()))
    }
}

/// A body that must begin with the version byte 1.x; gives the minor number.
fn major_1(body: &mut Reader<'_>, what: &'static str) -> Result<u8> {
    let offset = body.offset();
    let (major, minor) = body.packed_version(what)?;
    if major != 1 {
        return Err(Error::malformed(offset, what, format!("major version {major} is not known")));
    }
    Ok(minor)
}

/// How far axes may be from unit length and right angles before a plane is refused.
const SQUARENESS: f64 = 1e-6;

/// Whether a plane has finite, right-handed axes of length 1 at right angles.
fn is_frame(plane: &Plane) -> bool {
    let (x, y, z) = (plane.x_axis, plane.y_axis, plane.z_axis);
    plane.origin.is_finite()
        && [x.length() - 1.0, y.length() - 1.0, (x.cross(y) - z).length(), x.dot(y)]
            .iter()
            .all(|error| error.abs() <= SQUARENESS)
}
