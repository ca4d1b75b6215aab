//! The form of an object: what formats take of it.

use katydid_3dm::{BrepObject, CachedMesh, Extrusion, Object, PointCloud};
use katydid_geometry::{Brep, Curve, Interval, Mesh, MeshSettings, Plane, Surface, Vector3, Xform};

use super::drawn::{self, Styles};
use super::facets::{borders, facets};
use super::{Conversion, LeftOut, PointSet, Region, Scene, Shape};

type Told<T> = std::result::Result<T, String>;

const UNKNOWN: &str = "not supported";
/// Subdivisions of a SubD's net on its way to a mesh: each face of four sides becomes 64.
const SUBDIVISIONS: u32 = 3;
const NOT_FINITE: &str = "a coordinate is not a finite number";

/// Makes shapes of objects.
pub(super) struct Shapes<'a> {
    pub(super) scene: &'a Scene,
    pub(super) styles: &'a Styles,
    pub(super) conversion: &'a Conversion,
}

impl Shapes<'_> {
    pub(super) fn of(&self, geometry: &Object, left_out: &mut Vec<LeftOut>) -> Told<Shape> {
        match geometry {
            Object::Point(p) if !p.is_finite() => Err(NOT_FINITE.into()),
            Object::Point(p) => Ok(Shape::Points(vec![*p].into())),
            Object::PointCloud(cloud) => points(cloud),
            Object::Curve(curve) => Ok(Shape::Curve(curve.clone())),
            Object::CurveForm(form) => form.to_curve().map(Shape::Curve).map_err(|error| error.to_string()),
            Object::Surface(surface) if self.conversion.exact => whole(surface),
            Object::Surface(surface) => Ok(self.faces(surface, false)),
            Object::SurfaceForm(form) if self.conversion.exact => {
                form.to_surface().map_err(|error| error.to_string()).and_then(|surface| whole(&surface))
            }
            Object::SurfaceForm(form) => form
                .to_surface()
                .map(|surface| self.faces(&surface, false))
                .map_err(|error| error.to_string()),
            Object::Brep(brep) if self.conversion.exact => exact(brep),
            Object::Extrusion(extrusion) if self.conversion.exact => extrusion
                .to_brep()
                .map(|object| exact(&object))
                .unwrap_or_else(|| Err("its form as a brep cannot be made".into())),
            Object::Brep(brep) => self.brep(brep, left_out),
            Object::Extrusion(extrusion) => swept(extrusion),
            Object::Mesh(_) => mesh(geometry).map(Shape::Mesh),
            Object::SubD(subd) => subd
                .to_subd()
                .and_then(|subd| subd.limit_mesh(SUBDIVISIONS))
                .map(Shape::Mesh)
                .map_err(|error| error.to_string()),
            Object::Hatch(hatch) => self.styles.hatch(hatch),
            Object::Annotation(annotation) => self.styles.text(annotation),
            Object::Annotation5(annotation) => drawn::text_5(annotation),
            Object::Annotation2(annotation) => drawn::text_2(annotation),
            Object::TextDot(dot) => drawn::dot(dot),
            _ => Err(UNKNOWN.into()),
        }
    }

    fn faces(&self, surface: &Surface, is_reversed: bool) -> Shape {
        let tolerance = match surface.bounding_box() {
            Ok(bounds) => self.scene.tolerance_for(self.conversion.tolerance, &bounds),
            Err(_) => self.scene.tolerance,
        };
        let facets = facets(surface, tolerance).map(|mesh| if is_reversed { mesh.flipped() } else { mesh });
        Shape::Faces { facets, edges: borders(surface) }
    }

    /// A brep by the meshes that its program kept beside it. One that brought none, or is nothing but a surface, is
    /// meshed here.
    fn brep(&self, object: &BrepObject, left_out: &mut Vec<LeftOut>) -> Told<Shape> {
        if let Some(bare) = object.bare_surface() {
            return Ok(self.faces(&bare.surface, bare.is_reversed));
        }
        let edges = edges(object);
        let count = object.brep.faces().len();
        let kept: Vec<Mesh> = (0..count).filter_map(|face| face_mesh(object, face)).collect();
        if kept.is_empty() && edges.is_empty() {
            return Err("it has neither meshes nor edges".into());
        }
        if !kept.is_empty() && kept.len() < count {
            LeftOut::add(
                left_out,
                LeftOut::new("face of a Brep", count - kept.len(), "no mesh of it is kept in the model"),
            );
        }
        let facets = if kept.is_empty() {
            self.meshed(&object.brep)
        } else {
            Some(Mesh::join(&kept).map_err(|error| error.to_string())?)
        };
        Ok(Shape::Faces { facets, edges })
    }

    /// The mesh of a brep within the tolerance; none for one that cannot be meshed.
    fn meshed(&self, brep: &Brep) -> Option<Mesh> {
        let bounds = brep.bounds_of_faces()?;
        let distance = self.scene.tolerance_for(self.conversion.tolerance, &bounds);
        let settings = MeshSettings { min_count: 4, ..MeshSettings::within(distance) };
        brep.mesh(&settings).and_then(|mesh| mesh.welded()).ok().filter(|mesh| !mesh.faces().is_empty())
    }
}

/// A surface as a brep of one face.
fn whole(surface: &Surface) -> Told<Shape> {
    Brep::from_surface(surface.clone())
        .map(|brep| Shape::Brep(brep.into()))
        .map_err(|error| error.to_string())
}

/// A brep of which every face, edge and trim is what the kernel has.
fn exact(object: &BrepObject) -> Told<Shape> {
    if object.brep.faces().is_empty() {
        return Err("it has no faces".into());
    }
    Ok(Shape::Brep(object.brep.clone().into()))
}

/// The mesh of a face: that for display, else that for analysis.
fn face_mesh(object: &BrepObject, face: usize) -> Option<Mesh> {
    let cached = |list: &[Option<CachedMesh>]| mesh(&list.get(face)?.as_ref()?.mesh).ok();
    cached(&object.render_meshes)
        .or_else(|| cached(&object.analysis_meshes))
        .filter(|mesh| !mesh.faces().is_empty())
}

/// The kernel's mesh of an object that is one.
fn mesh(object: &Object) -> Told<Mesh> {
    match object {
        Object::Mesh(mesh) => mesh.to_mesh().map_err(|error| error.to_string()),
        _ => Err(UNKNOWN.into()),
    }
}

fn edges(object: &BrepObject) -> Vec<Curve> {
    let edges = object.brep.edges().iter().enumerate().filter(|(_, edge)| !edge.deleted);
    let curve = |(place, edge): (usize, &katydid_geometry::brep::Edge)| {
        let curve = object.brep.edge_curve(place)?;
        if edge.part.range == curve.domain() {
            Some(curve.clone())
        } else {
            curve.sub_curve(edge.part.range).ok()
        }
    };
    edges.filter_map(curve).collect()
}

fn points(cloud: &PointCloud) -> Told<Shape> {
    if cloud.points.is_empty() {
        return Err("it has no points".into());
    }
    if !cloud.points.iter().all(|p| p.is_finite()) {
        return Err(NOT_FINITE.into());
    }
    let mut set = PointSet::from(cloud.points.clone());
    // A list of another length says nothing about the points.
    if cloud.normals.len() == set.points.len() && cloud.normals.iter().all(|n| n.is_finite()) {
        set.normals.clone_from(&cloud.normals);
    }
    if cloud.colours.len() == set.points.len() {
        set.colours.clone_from(&cloud.colours);
    }
    Ok(Shape::Points(set))
}

/// An extrusion by the mesh that its program kept beside it, and by its profiles at both ends.
fn swept(extrusion: &Extrusion) -> Told<Shape> {
    let facets =
        extrusion.meshes.iter().filter_map(|kept| mesh(&kept.mesh.mesh).ok()).find(|m| !m.faces().is_empty());
    let edges = profiles(extrusion);
    if facets.is_none() && edges.is_empty() {
        return Err("it has neither a mesh nor a profile".into());
    }
    Ok(Shape::Faces { facets, edges })
}

/// The profile of an extrusion at its start and its end.
fn profiles(extrusion: &Extrusion) -> Vec<Curve> {
    let Some(profile) = extrusion.profile.as_ref().and_then(|form| form.to_curve().ok()) else {
        return Vec::new();
    };
    // Several profiles are the segments of one curve.
    let profiles = match &profile {
        Curve::Poly(poly) if extrusion.profile_count > 1 => poly.segments().to_vec(),
        one => vec![one.clone()],
    };
    let Interval { start, end } = extrusion.part;
    let ends = [(start, 0), (end, 1)].map(|(share, end)| end_motion(extrusion, share, end));
    let placed =
        ends.iter().flatten().flat_map(|motion| profiles.iter().map(|curve| curve.transformed(motion)));
    placed.filter_map(std::result::Result::ok).collect()
}

/// From the plane of the profile to an end of the extrusion. A mitre moves points along the path until they lie in its
/// plane.
fn end_motion(extrusion: &Extrusion, share: f64, end: usize) -> Option<Xform> {
    let (path, up) = (extrusion.path, extrusion.up);
    let normal = path.unit_direction()?;
    let plane = Plane::from_axes(path.at(share), up.cross(normal), up).ok()?;
    let mut motion = Xform::plane_to_world(&plane);
    let cut: Vector3 = *extrusion.mitre_normals.get(end)?;
    if *extrusion.is_mitred.get(end)? && cut.z.abs() > 1e-9 {
        let shear = Xform {
            rows: [
                [1.0, 0.0, 0.0, 0.0],
                [0.0, 1.0, 0.0, 0.0],
                [-cut.x / cut.z, -cut.y / cut.z, 1.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ],
        };
        motion = motion * shear;
    }
    motion.is_finite().then_some(motion)
}

/// A shape of a block where a reference puts it.
pub(super) fn placed(shape: &Shape, motion: &Xform) -> Told<Shape> {
    let told = |error: katydid_geometry::Error| error.to_string();
    Ok(match shape {
        Shape::Points(set) => {
            let mut set = set.clone();
            motion.transform_points(&mut set.points);
            if !set.points.iter().all(|p| p.is_finite()) {
                return Err(NOT_FINITE.into());
            }
            let turn = motion.normal_map();
            for n in &mut set.normals {
                *n = turn.vector(*n).unitized().unwrap_or(*n);
            }
            Shape::Points(set)
        }
        Shape::Curve(curve) => Shape::Curve(curve.transformed(motion).map_err(told)?),
        Shape::Mesh(mesh) => Shape::Mesh(mesh.transformed(motion).map_err(told)?),
        Shape::Region(region) => {
            let moved = region.boundaries.iter().map(|curve| curve.transformed(motion).map_err(told));
            Shape::Region(Region { boundaries: moved.collect::<Told<_>>()?, fill: region.fill })
        }
        Shape::Text(label) => Shape::Text(label.moved(motion).ok_or(NOT_FINITE)?),
        Shape::Brep(brep) => Shape::Brep(brep.transformed(motion).map_err(told)?.into()),
        Shape::Faces { facets, edges } => Shape::Faces {
            facets: facets.as_ref().map(|mesh| mesh.transformed(motion)).transpose().map_err(told)?,
            edges: edges.iter().filter_map(|edge| edge.transformed(motion).ok()).collect(),
        },
    })
}
