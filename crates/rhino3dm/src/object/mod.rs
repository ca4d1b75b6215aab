//! One openNURBS class object (sections 6 and 8): read into geometry where this crate knows the class, else kept
//! byte for byte.

mod annotation;
mod block_reference;
mod brep;
mod cached_mesh;
mod clipping_plane;
mod curve;
mod detail_view;
mod extrusion;
mod hatch;
mod light;
mod mapping_tag;
mod mesh;
mod morph_control;
mod nurbs_cage;
mod on_data;
mod point;
mod point_cloud;
mod raw;
mod restated;
mod subd;
mod surface;
mod text_dot;

pub use annotation::{
    Annotation, Annotation2, Annotation2Kind, Annotation5, Annotation5Kind, AnnotationKind, Dimension,
    StyleOverrides, TextContent,
};
pub use block_reference::BlockReference;
pub use brep::{BareSurface, BrepEdge, BrepObject, BrepSummary};
pub use cached_mesh::CachedMesh;
pub use clipping_plane::{ClippingPlane, Participants};
pub use curve::{CurveForm, CurveOnSurface, NurbsForm};
pub use detail_view::DetailView;
pub use extrusion::{Extrusion, ExtrusionMesh};
pub use hatch::{Hatch, HatchLoop};
pub use katydid_geometry::brep::Solidity;
pub use light::{Light, LightStyle};
pub use mapping_tag::MappingTag;
pub(crate) use mesh::single;
pub use mesh::{CurvatureStatistics, MeshObject, MeshParameters, Ngon, SubDMeshing};
pub use morph_control::{Localizer, MorphControl, MorphShape};
pub use nurbs_cage::NurbsCage;
pub use on_data::OnData;
pub use point_cloud::PointCloud;
pub use raw::RawObject;
pub(crate) use raw::object_version;
pub(crate) use restated::{Surroundings, restated};
pub use subd::{
    PackRectangle, Reference as SubDReference, StoredEdge, StoredFace, StoredPart, StoredVertex, SubDLevel,
    SubDObject, SubDPacking,
};
pub use surface::{NurbsSurfaceForm, SurfaceForm};
pub use text_dot::TextDot;

/// The dimension of curves in space.
pub(crate) const SPACE_DIMENSION: i32 = curve::SPACE;

pub(crate) use brep::{Reading as BrepReading, read_trim as brep_trim};

use std::borrow::Cow;

use katydid_geometry::{Curve, Mesh, Plane, Point3, Surface};
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData, write_class};
use crate::places::Places;
use crate::styles::Styles;
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
    /// A curve of any kind the kernel has.
    Curve(Curve),
    /// A surface without trims: of a plane, of revolution, a sum of two curves, or NURBS.
    Surface(Surface),
    /// A curve that the kernel alone would lose something of: one of dimension 2, one that a SubD can be made of,
    /// or numbers that make no curve.
    CurveForm(Box<CurveForm>),
    /// A surface that the kernel alone would lose something of: a stored box, or numbers that make no surface.
    SurfaceForm(Box<SurfaceForm>),
    /// Faces on surfaces, joined along edges.
    Brep(Box<BrepObject>),
    /// Curves in a plane moved along a segment.
    Extrusion(Box<Extrusion>),
    /// A mesh with everything that archives keep of one.
    Mesh(Box<MeshObject>),
    /// A subdivision surface with everything that archives keep of one.
    SubD(Box<SubDObject>),
    /// Text at a point, turned to the viewer.
    TextDot(TextDot),
    /// A block placed in the model.
    BlockReference(Box<BlockReference>),
    /// A light. Archives keep most of them in a table of their own.
    Light(Box<Light>),
    /// A rectangle that cuts the views.
    ClippingPlane(Box<ClippingPlane>),
    /// A region of a plane filled with a pattern.
    Hatch(Box<Hatch>),
    /// A window of a page into the model.
    DetailView(Box<DetailView>),
    /// A NURBS volume.
    NurbsCage(Box<NurbsCage>),
    /// A curve, surface or volume that bends other objects along with it.
    MorphControl(Box<MorphControl>),
    /// Text, a leader or a dimension of version 6 and later.
    Annotation(Box<Annotation>),
    /// Text, a leader or a dimension as versions 4 and 5 have it. The official reader takes it for one of version 6.
    Annotation5(Box<Annotation5>),
    /// Text, a leader or a dimension as version 2 has it. The official reader takes it for one of version 6.
    Annotation2(Box<Annotation2>),
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

    /// What the object is, as Rhino's filters number it: 1 a point, 2 a point cloud, 4 a curve, 8 a surface, 16 a
    /// brep, 32 a mesh and so on; 0 for a class that is not known.
    pub fn object_type(&self) -> u32 {
        class_ids::object_type(self.class())
    }

    /// Whether an archive of the given version can carry this object.
    ///
    /// # Errors
    /// The version is not written, or the object was kept from an archive whose layout it does not share; the
    /// error says why.
    pub fn check_writable(&self, version: i32) -> Result<()> {
        Version::for_writing(version)?;
        match self {
            Self::Kept(raw) => raw.check_writable(version),
            Self::Extrusion(extrusion) => extrusion::check_writable(extrusion, version),
            Self::SubD(subd) => subd::check_writable(subd, version),
            Self::Annotation(annotation) => annotation.check_writable(version),
            Self::DetailView(detail) => detail.check_writable(version),
            _ => Ok(()),
        }
    }

    /// The curve, if the object is one that the kernel takes, whatever else archives say of it.
    pub fn curve(&self) -> Option<Cow<'_, Curve>> {
        match self {
            Self::Curve(curve) => Some(Cow::Borrowed(curve)),
            Self::CurveForm(form) => form.to_curve().ok().map(Cow::Owned),
            _ => None,
        }
    }

    /// The surface without trims, if the object is one that the kernel takes: a surface, or a brep that is nothing
    /// but one, not turned over.
    pub fn surface(&self) -> Option<Cow<'_, Surface>> {
        match self {
            Self::Surface(surface) => Some(Cow::Borrowed(surface)),
            Self::SurfaceForm(form) => form.to_surface().ok().map(Cow::Owned),
            Self::Brep(object) => match object.brep.as_surface() {
                Some((surface, false)) => Some(Cow::Borrowed(surface)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The object as bytes, with user data, for an archive of version 4, 50, 60, 70 or 80. A kept object stays as it
    /// is, with its own user data.
    ///
    /// # Errors
    /// Another version, or an object that it cannot carry.
    pub fn to_raw(&self, version: i32, user_data: &[UserData]) -> Result<RawObject> {
        if let Self::Kept(raw) = self {
            return Ok(raw.clone());
        }
        let version = Version::for_writing(version)?;
        let mut w = Writer::new(version);
        let around = Surroundings { styles: &Styles::default(), in_model: true };
        let (object, user_data) = restated(self, user_data, around, version)?;
        object.write(&mut w, &user_data)?;
        Ok(RawObject {
            class: object.class(),
            archive_version: version.archive,
            opennurbs_version: version.opennurbs,
            bytes: w.into_bytes(),
            user_data: user_data.into_owned(),
        })
    }

    /// Whether what this user data says is part of the object itself, which writes it anew.
    pub(crate) fn holds(&self, data: &UserData) -> bool {
        match self {
            Self::Brep(_) => data.class == class_ids::V5_REGIONS,
            Self::Extrusion(_) => data.class == class_ids::V5_EXTRUSION_MESHES,
            Self::Hatch(_) => data.class == class_ids::V5_HATCH_BASE,
            Self::Mesh(_) => mesh::owns(data),
            // What the mesh that stood for it had is nothing to a SubD.
            Self::SubD(_) => {
                mesh::owns(data) || matches!(data.class, class_ids::SUBD_PROXY | class_ids::MESH_NGONS)
            }
            _ => false,
        }
    }

    /// Turns the numbers of hatch patterns and layers into places in their tables.
    pub(crate) fn place(&mut self, places: &Places) {
        match self {
            Self::Hatch(hatch) => hatch.pattern = places.hatch_patterns.place(hatch.pattern),
            Self::ClippingPlane(clipping) => {
                let layers = &mut clipping.participants.layers;
                layers.iter_mut().for_each(|layer| *layer = places.layers.place(*layer));
                layers.retain(|layer| *layer >= 0);
            }
            _ => {}
        }
    }

    /// The class under which this object is written.
    pub(crate) fn class(&self) -> Uuid {
        match self {
            Self::Point(_) => class_ids::POINT,
            Self::PointCloud(_) => class_ids::POINT_CLOUD,
            Self::Curve(c) => curve::class_of(c),
            Self::Surface(s) => surface::class_of(s),
            Self::CurveForm(form) => curve::class_of_form(form),
            Self::SurfaceForm(form) => surface::class_of_form(form),
            Self::Brep(_) => class_ids::BREP,
            Self::Extrusion(_) => class_ids::EXTRUSION,
            Self::Mesh(_) => class_ids::MESH,
            Self::SubD(_) => class_ids::SUBD,
            Self::TextDot(_) => class_ids::TEXT_DOT,
            Self::BlockReference(_) => class_ids::BLOCK_REFERENCE,
            Self::Light(_) => class_ids::LIGHT,
            Self::ClippingPlane(_) => class_ids::CLIPPING_PLANE,
            Self::Hatch(_) => class_ids::HATCH,
            Self::DetailView(_) => class_ids::DETAIL_VIEW,
            Self::NurbsCage(_) => class_ids::NURBS_CAGE,
            Self::MorphControl(_) => class_ids::MORPH_CONTROL,
            Self::Annotation(a) => annotation::class_of(a),
            Self::Annotation5(a) => annotation::class_of_5(a),
            Self::Annotation2(a) => annotation::class_of_2(a),
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
            class_ids::MESH => {
                let mesh = mesh::read(&mut body, &object.user_data)?;
                let subd = object.user_data.iter().find_map(|data| subd::stood_for(&mesh, data));
                subd.map_or_else(|| Self::Mesh(Box::new(mesh)), |subd| Self::SubD(Box::new(subd)))
            }
            class_ids::SUBD => Self::SubD(Box::new(subd::read(&mut body)?)),
            class_ids::BREP => Self::Brep(Box::new(brep::read(&mut body, &object.user_data)?)),
            class_ids::EXTRUSION => Self::Extrusion(Box::new(extrusion::read(&mut body, &object.user_data)?)),
            class if curve::is_curve(class) => Self::from(curve::read(class, &mut body)?),
            class if surface::is_surface(class) => Self::from(surface::read(class, &mut body)?),
            class_ids::TEXT_DOT => Self::TextDot(text_dot::read(&mut body)?),
            class_ids::TEXT_DOT_2 => Self::TextDot(text_dot::read_version_2(&mut body)?),
            class_ids::ARROW_2 => Self::Curve(curve::read_arrow(&mut body)?),
            class_ids::BLOCK_REFERENCE => Self::BlockReference(block_reference::read(&mut body)?.into()),
            class_ids::LIGHT => Self::Light(light::read(&mut body)?.into()),
            class_ids::CLIPPING_PLANE => Self::ClippingPlane(clipping_plane::read(&mut body)?.into()),
            class_ids::HATCH => Self::Hatch(hatch::read(&mut body, &object.user_data)?.into()),
            class_ids::DETAIL_VIEW => Self::DetailView(detail_view::read(&mut body)?.into()),
            class_ids::MORPH_CONTROL => Self::MorphControl(morph_control::read(&mut body)?.into()),
            class_ids::NURBS_CAGE => Self::NurbsCage(nurbs_cage::read(&mut body)?.into()),
            class if annotation::is_annotation(class) => {
                Self::Annotation(annotation::read(class, &mut body)?.into())
            }
            class if annotation::is_version_5(class) => {
                Self::Annotation5(annotation::read_5(class, &mut body)?.into())
            }
            class if annotation::is_version_2(class) => {
                Self::Annotation2(annotation::read_2(class, &mut body)?.into())
            }
            _ => return Ok(Self::Kept(object.to_raw())),
        };
        body.finish();
        Ok(parsed)
    }

    /// Writes the class object, with user data behind the body. Kept objects go out as they came, and carry
    /// their own user data already.
    pub(crate) fn write(&self, w: &mut Writer, user_data: &[UserData]) -> Result<()> {
        match self {
            Self::Kept(raw) => raw.write(w),
            Self::Point(p) => write_class(w, self.class(), user_data, |w| point::write(*p, w)),
            Self::PointCloud(c) => write_class(w, self.class(), user_data, |w| point_cloud::write(c, w)),
            Self::Curve(c) => {
                let form = CurveForm::of(c, curve::SPACE);
                write_class(w, self.class(), user_data, |w| curve::write(&form, w))
            }
            Self::Surface(s) => {
                let form = SurfaceForm::of(s);
                write_class(w, self.class(), user_data, |w| surface::write(&form, w))
            }
            Self::CurveForm(form) => write_class(w, self.class(), user_data, |w| curve::write(form, w)),
            Self::SurfaceForm(form) => write_class(w, self.class(), user_data, |w| surface::write(form, w)),
            Self::Brep(b) => {
                let own = brep::own_user_data(b, w.version())?;
                let all: Vec<UserData> = own.into_iter().chain(user_data.iter().cloned()).collect();
                write_class(w, self.class(), &all, |w| brep::write(b, w))
            }
            Self::Extrusion(e) => {
                let own = extrusion::own_user_data(e, w.version())?;
                let all: Vec<UserData> = own.into_iter().chain(user_data.iter().cloned()).collect();
                write_class(w, self.class(), &all, |w| extrusion::write(e, w))
            }
            Self::TextDot(d) => write_class(w, self.class(), user_data, |w| text_dot::write(d, w)),
            Self::BlockReference(b) => {
                write_class(w, self.class(), user_data, |w| block_reference::write(b, w))
            }
            Self::Light(l) => write_class(w, self.class(), user_data, |w| light::write(l, w)),
            Self::ClippingPlane(c) => {
                write_class(w, self.class(), user_data, |w| clipping_plane::write(c, w))
            }
            Self::Hatch(h) => {
                let own = hatch::own_user_data(h, w.version())?;
                let all: Vec<UserData> = own.into_iter().chain(user_data.iter().cloned()).collect();
                write_class(w, self.class(), &all, |w| hatch::write(h, w))
            }
            Self::DetailView(d) => write_class(w, self.class(), user_data, |w| detail_view::write(d, w)),
            Self::MorphControl(c) => write_class(w, self.class(), user_data, |w| morph_control::write(c, w)),
            Self::NurbsCage(c) => write_class(w, self.class(), user_data, |w| nurbs_cage::write(c, w)),
            Self::Annotation(a) => write_class(w, self.class(), user_data, |w| annotation::write(a, w)),
            Self::Annotation5(a) => write_class(w, self.class(), user_data, |w| annotation::write_5(a, w)),
            Self::Annotation2(a) => write_class(w, self.class(), user_data, |w| annotation::write_2(a, w)),
            Self::SubD(s) => write_class(w, self.class(), user_data, |w| subd::write(s, w)),
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

impl From<CurveForm> for Object {
    fn from(form: CurveForm) -> Self {
        match form.to_curve() {
            Ok(curve) if CurveForm::of(&curve, curve::SPACE) == form => Self::Curve(curve),
            _ => Self::CurveForm(Box::new(form)),
        }
    }
}

impl From<SurfaceForm> for Object {
    fn from(form: SurfaceForm) -> Self {
        match form.to_surface() {
            Ok(surface) if SurfaceForm::of(&surface) == form => Self::Surface(surface),
            _ => Self::SurfaceForm(Box::new(form)),
        }
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
