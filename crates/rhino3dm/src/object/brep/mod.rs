//! Class Brep (section 8): major version 3, and the trimmed surfaces of version 2 archives.

mod bare;
mod items;
mod legacy;
mod lists;
mod regions;
mod summary;

pub use bare::BareSurface;
pub(crate) use items::read_trim;
pub use summary::{BrepEdge, BrepSummary};

use std::collections::BTreeMap;

use katydid_geometry::brep::{Parts, Solidity};
use katydid_geometry::{BoundingBox, Brep};

use super::curve::{FLAT, SPACE};
use super::{CachedMesh, CurveForm, SurfaceForm, cached_mesh};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::version::Version;
use crate::{Error, Result, class_ids, typecode};

const WHAT: &str = "brep";
/// Programs before this openNURBS version store a box around the whole surfaces of faces.
const TRIMMED_BOX_FROM: u32 = 2_382_395_020;

/// A brep with all that archives say of it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BrepObject {
    /// The brep.
    pub brep: Brep,
    /// Parameter curves that archives have otherwise than the brep does, or that the kernel refused (their place in
    /// the brep is empty then), by place. These are written; take them out when curves change.
    pub odd_curves_2d: BTreeMap<usize, CurveForm>,
    /// The same of curves in space.
    pub odd_curves_3d: BTreeMap<usize, CurveForm>,
    /// The same of surfaces.
    pub odd_surfaces: BTreeMap<usize, SurfaceForm>,
    /// Meshes for display, one a face; a list may be shorter.
    pub render_meshes: Vec<Option<CachedMesh>>,
    /// Meshes for analysis, one a face; a list may be shorter.
    pub analysis_meshes: Vec<Option<CachedMesh>>,
    /// A box around the faces, if one was stored.
    pub bounds: Option<BoundingBox>,
    /// Whether that box may hold parts of surfaces outside their faces, as programs before version 7 made it.
    pub bounds_are_wide: bool,
}

impl From<Brep> for BrepObject {
    fn from(brep: Brep) -> Self {
        Self { brep, ..Self::default() }
    }
}

/// What is read before the brep can be put together.
#[derive(Default)]
pub(crate) struct Reading {
    pub(crate) parts: Parts,
    odd_curves_2d: BTreeMap<usize, CurveForm>,
    odd_curves_3d: BTreeMap<usize, CurveForm>,
    odd_surfaces: BTreeMap<usize, SurfaceForm>,
}

impl Reading {
    pub(crate) fn add_curve_2d(&mut self, form: Option<CurveForm>) {
        let place = self.parts.curves_2d.len();
        let (curve, odd) = form.map_or((None, None), |form| form.split(FLAT));
        self.parts.curves_2d.push(curve);
        self.odd_curves_2d.extend(odd.map(|odd| (place, odd)));
    }

    pub(crate) fn add_curve_3d(&mut self, form: Option<CurveForm>) {
        let place = self.parts.curves_3d.len();
        let (curve, odd) = form.map_or((None, None), |form| form.split(SPACE));
        self.parts.curves_3d.push(curve);
        self.odd_curves_3d.extend(odd.map(|odd| (place, odd)));
    }

    pub(crate) fn add_surface(&mut self, form: Option<SurfaceForm>) {
        let place = self.parts.surfaces.len();
        let (surface, odd) = form.map_or((None, None), SurfaceForm::split);
        self.parts.surfaces.push(surface);
        self.odd_surfaces.extend(odd.map(|odd| (place, odd)));
    }

    pub(crate) fn finish(self, offset: usize) -> Result<BrepObject> {
        let brep = Brep::from_parts(self.parts).map_err(|e| Error::geometry(offset, WHAT, e))?;
        Ok(BrepObject {
            brep,
            odd_curves_2d: self.odd_curves_2d,
            odd_curves_3d: self.odd_curves_3d,
            odd_surfaces: self.odd_surfaces,
            ..BrepObject::default()
        })
    }
}

/// Reads the body; version 5 archives have the regions in user data.
pub(super) fn read(body: &mut Reader<'_>, user_data: &[UserData]) -> Result<BrepObject> {
    let offset = body.offset();
    match body.packed_version(WHAT)? {
        (2, minor) => legacy::read(body, minor),
        (3, minor) => read_3(body, minor, user_data),
        (major, _) => Err(Error::malformed(offset, WHAT, format!("major version {major} is not known"))),
    }
}

fn read_3(body: &mut Reader<'_>, minor: u8, user_data: &[UserData]) -> Result<BrepObject> {
    let offset = body.offset();
    let version = body.version();
    let mut reading = Reading::default();
    lists::read_curves(body, |form| reading.add_curve_2d(form))?;
    lists::read_curves(body, |form| reading.add_curve_3d(form))?;
    lists::read_surfaces(body, |form| reading.add_surface(form))?;
    reading.parts.vertices = items::read_vertices(body)?;
    reading.parts.edges = items::read_edges(body)?;
    reading.parts.trims = items::read_trims(body)?;
    reading.parts.loops = items::read_loops(body)?;
    reading.parts.faces = items::read_faces(body)?;
    let faces = reading.parts.faces.len();
    let bounds = body.bounds("brep box")?;
    let (mut render_meshes, mut analysis_meshes) = (Vec::new(), Vec::new());
    if minor >= 1 {
        render_meshes = read_meshes(body, faces, "brep render meshes")?;
        analysis_meshes = read_meshes(body, faces, "brep analysis meshes")?;
    }
    if minor >= 2 {
        reading.parts.solidity = solidity(body.i32("brep solid flag")?);
    }
    if minor >= 3 {
        let (mut chunk, _) = body.versioned_1("brep regions")?;
        if chunk.bool("brep regions")? {
            reading.parts.regions = Some(regions::read(&mut chunk)?);
        }
        chunk.finish();
    }
    if reading.parts.regions.is_none() {
        let stored = user_data.iter().find(|data| data.class == class_ids::V5_REGIONS);
        reading.parts.regions = stored.map(|data| data.with_body(regions::read)).transpose()?;
    }
    let object = reading.finish(offset)?;
    let bounds_are_wide = bounds.is_some() && (version.archive < 70 || version.opennurbs < TRIMMED_BOX_FROM);
    Ok(BrepObject { render_meshes, analysis_meshes, bounds, bounds_are_wide, ..object })
}

/// 3 means not solid, but openNURBS itself takes 3 and beyond for "not set".
fn solidity(flag: i32) -> Solidity {
    match flag {
        1 => Solidity::Outward,
        2 => Solidity::Inward,
        _ => Solidity::Unknown,
    }
}

/// One mesh a face, in a chunk of its own. No meshes at all are no list.
fn read_meshes(body: &mut Reader<'_>, faces: usize, what: &'static str) -> Result<Vec<Option<CachedMesh>>> {
    let mut chunk = body.expect(typecode::ANONYMOUS, what)?;
    if body.context().is_of_shape() {
        return Ok(Vec::new());
    }
    let meshes = cached_mesh::read_flagged(&mut chunk, faces, what)?;
    chunk.finish();
    Ok(if meshes.iter().all(Option::is_none) { Vec::new() } else { meshes })
}

/// The user data that carries the regions to version 5 archives.
pub(super) fn own_user_data(object: &BrepObject, version: Version) -> Result<Option<UserData>> {
    match regions::to_write(object.brep.parts()) {
        Some(regions) if version.archive == 50 => {
            let write = |w: &mut Writer| regions::write(regions, w);
            UserData::core(class_ids::V5_REGIONS, 1, version, write).map(Some)
        }
        _ => Ok(None),
    }
}

pub(super) fn write(object: &BrepObject, w: &mut Writer) -> Result<()> {
    let parts = object.brep.parts();
    let version = w.version().archive;
    let has_regions = version > 50;
    w.packed_version(3, if has_regions { 3 } else { 2 });
    lists::write_curves(&parts.curves_2d, &object.odd_curves_2d, FLAT, w)?;
    lists::write_curves(&parts.curves_3d, &object.odd_curves_3d, SPACE, w)?;
    lists::write_surfaces(&parts.surfaces, &object.odd_surfaces, w)?;
    items::write_vertices(&parts.vertices, w)?;
    items::write_edges(&parts.edges, w)?;
    items::write_trims(&parts.trims, w)?;
    items::write_loops(&parts.loops, w)?;
    items::write_faces(&parts.faces, w)?;
    w.bounds(bounds_to_write(object, version));
    for meshes in [&object.render_meshes, &object.analysis_meshes] {
        w.chunk(typecode::ANONYMOUS, |w| cached_mesh::write_flagged(meshes, parts.faces.len(), w))?;
    }
    w.i32(match parts.solidity {
        Solidity::Unknown => 0,
        Solidity::Outward => 1,
        Solidity::Inward => 2,
    });
    if has_regions {
        w.versioned(1, 1, |w| {
            let regions = regions::to_write(parts);
            w.bool(regions.is_some());
            regions.map_or(Ok(()), |regions| regions::write(regions, w))
        })?;
    }
    Ok(())
}

/// From version 70 on readers take the box for one of the faces, not of their surfaces.
fn bounds_to_write(object: &BrepObject, version: i32) -> Option<BoundingBox> {
    let stored = object.bounds?;
    if version < 70 || !object.bounds_are_wide {
        return Some(stored);
    }
    let [a, b] = [stored, object.brep.bounds_of_faces()?];
    let min = |x: f64, y: f64| x.min(y);
    let max = |x: f64, y: f64| x.max(y);
    let corner = |p: katydid_geometry::Point3, q: katydid_geometry::Point3, f: fn(f64, f64) -> f64| {
        katydid_geometry::Point3::new(f(p.x, q.x), f(p.y, q.y), f(p.z, q.z))
    };
    let both = BoundingBox { min: corner(a.min, b.min, max), max: corner(a.max, b.max, min) };
    (both.min.x <= both.max.x && both.min.y <= both.max.y && both.min.z <= both.max.z).then_some(both)
}
