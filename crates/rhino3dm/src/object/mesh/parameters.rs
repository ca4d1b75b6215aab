//! How a mesh was made from a surface or a SubD: its meshing parameters.

use crate::chunk::{Reader, Writer};
use crate::{Error, Result, typecode};

const WHAT: &str = "mesh parameters";

/// The meshing parameters that a render or analysis mesh was made with. Lengths are in units of the model, angles
/// in radians, and 0 means "no limit" where openNURBS has it mean that.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshParameters {
    /// Whether curvatures are computed.
    pub compute_curvature: bool,
    /// Whether planar faces get as few polygons as they can.
    pub simple_planes: bool,
    /// Whether the first grid is refined.
    pub refine: bool,
    /// Whether faces are meshed each on its own, so that seams do not match.
    pub jagged_seams: bool,
    /// The fifth flag of the body, which writers leave 0.
    pub reserved: i32,
    /// Most distance between the mesh and the surface.
    pub tolerance: f64,
    /// Least length of an edge.
    pub minimum_edge_length: f64,
    /// Most length of an edge.
    pub maximum_edge_length: f64,
    /// Most ratio of the sides of a quad of the first grid.
    pub grid_aspect_ratio: f64,
    /// Least and most number of quads of the first grid.
    pub grid_counts: [i32; 2],
    /// Most angle between normals at neighbours of the first grid.
    pub grid_angle: f64,
    /// By how much the number of quads of the first grid is raised.
    pub grid_amplification: f64,
    /// Most angle between neighbours after refinement.
    pub refine_angle: f64,
    /// The angle below which faces are meshed together.
    pub combine_angle: f64,
    /// 0 for triangles and quads, 1 for triangles, 2 for quads.
    pub face_type: i32,
    /// 1 where each face fills the texture, 2 where faces are packed into it.
    pub texture_range: i32,
    /// Whether the settings are the user's own.
    pub custom: bool,
    /// How fine the mesh is between 0 and 1, relative to the size of the object.
    pub relative_tolerance: f64,
    /// Which mesher: 0 the slow one, 1 the fast one.
    pub mesher: u8,
    /// Whether the user's own settings are used.
    pub custom_enabled: bool,
    /// How SubDs are meshed.
    pub subd: SubDMeshing,
}

/// How finely a SubD is meshed.
#[derive(Debug, Clone, PartialEq)]
pub struct SubDMeshing {
    /// Subdivisions of a face: 0 for the control net, each further step halves the quads.
    pub density: u32,
    /// 1 to mesh the control net, 2 the limit surface.
    pub location: u32,
    /// Whether the density holds for every SubD, or less for one of many faces.
    pub absolute: bool,
    /// Whether curvatures are computed.
    pub compute_curvature: bool,
}

impl Default for SubDMeshing {
    fn default() -> Self {
        Self { density: 4, location: 2, absolute: false, compute_curvature: false }
    }
}

/// Reads the anonymous chunk that holds the body.
pub(super) fn read(body: &mut Reader<'_>) -> Result<MeshParameters> {
    let mut body = body.expect(typecode::ANONYMOUS, WHAT)?;
    let offset = body.offset();
    let (major, minor) = body.packed_version(WHAT)?;
    if major != 1 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let mut flag = || body.i32(WHAT);
    let mut parameters = MeshParameters {
        compute_curvature: flag()? != 0,
        simple_planes: flag()? != 0,
        refine: flag()? != 0,
        jagged_seams: flag()? != 0,
        reserved: flag()?,
        tolerance: body.f64(WHAT)?,
        minimum_edge_length: body.f64(WHAT)?,
        maximum_edge_length: body.f64(WHAT)?,
        grid_aspect_ratio: body.f64(WHAT)?,
        grid_counts: [body.i32(WHAT)?, body.i32(WHAT)?],
        grid_angle: body.f64(WHAT)?,
        grid_amplification: body.f64(WHAT)?,
        refine_angle: body.f64(WHAT)?,
        combine_angle: body.f64(WHAT)?,
        face_type: body.i32(WHAT)?,
        ..MeshParameters::default()
    };
    if minor >= 1 {
        parameters.texture_range = body.i32(WHAT)?;
    }
    if minor >= 2 {
        parameters.custom = body.bool(WHAT)?;
        parameters.relative_tolerance = body.f64(WHAT)?;
    }
    if minor >= 3 {
        parameters.mesher = body.u8(WHAT)?;
    }
    if minor >= 4 {
        parameters.custom_enabled = body.bool(WHAT)?;
    }
    if minor >= 5 {
        parameters.subd = read_subd(&mut body)?;
    }
    body.finish();
    Ok(parameters)
}

fn read_subd(body: &mut Reader<'_>) -> Result<SubDMeshing> {
    let (mut chunk, minor) = body.versioned_1(WHAT)?;
    let mut subd =
        SubDMeshing { density: chunk.u32(WHAT)?, location: chunk.u32(WHAT)?, ..SubDMeshing::default() };
    if minor >= 2 {
        subd.absolute = chunk.bool(WHAT)?;
    }
    if minor >= 3 {
        subd.compute_curvature = chunk.bool(WHAT)?;
    }
    chunk.finish();
    Ok(subd)
}

/// Writes the anonymous chunk.
pub(super) fn write(parameters: &MeshParameters, w: &mut Writer) -> Result<()> {
    w.chunk(typecode::ANONYMOUS, |w| {
        w.packed_version(1, 5);
        let p = parameters;
        for flag in [p.compute_curvature, p.simple_planes, p.refine, p.jagged_seams] {
            w.i32(i32::from(flag));
        }
        w.i32(p.reserved);
        for x in [p.tolerance, p.minimum_edge_length, p.maximum_edge_length, p.grid_aspect_ratio] {
            w.f64(x);
        }
        p.grid_counts.iter().for_each(|n| w.i32(*n));
        for x in [p.grid_angle, p.grid_amplification, p.refine_angle, p.combine_angle] {
            w.f64(x);
        }
        w.i32(p.face_type);
        w.i32(p.texture_range);
        w.bool(p.custom);
        w.f64(p.relative_tolerance);
        w.u8(p.mesher);
        w.bool(p.custom_enabled);
        let subd = &p.subd;
        w.versioned(1, 3, |w| {
            w.u32(subd.density);
            w.u32(subd.location);
            w.bool(subd.absolute);
            w.bool(subd.compute_curvature);
            Ok(())
        })
    })
}

impl Default for MeshParameters {
    /// What openNURBS takes where nothing else is said.
    fn default() -> Self {
        Self {
            compute_curvature: false,
            simple_planes: false,
            refine: true,
            jagged_seams: false,
            reserved: 0,
            tolerance: 0.0,
            minimum_edge_length: 1e-4,
            maximum_edge_length: 0.0,
            grid_aspect_ratio: 6.0,
            grid_counts: [0, 0],
            grid_angle: 20.0_f64.to_radians(),
            grid_amplification: 1.0,
            refine_angle: 20.0_f64.to_radians(),
            combine_angle: 5.0_f64.to_radians(),
            face_type: 0,
            texture_range: 2,
            custom: false,
            relative_tolerance: 0.0,
            mesher: 0,
            custom_enabled: true,
            subd: SubDMeshing::default(),
        }
    }
}
