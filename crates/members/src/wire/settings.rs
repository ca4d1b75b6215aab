//! `MeshingParameters`: how fine a mesh is asked for.

use katydid_geometry::MeshSettings;
use serde_json::{Value as Json, json};

use super::numbers::number;
use super::read::{Members, Read};
use super::{Wire, no};
use crate::Fault;

/// How fine a mesh is asked for, as RhinoCommon's `MeshingParameters` say it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshingParameters(pub MeshSettings);

/// The most quads that a first grid may be asked to have.
const MOST_QUADS: i32 = 1 << 20;

impl Wire for MeshingParameters {
    const TYPE: &'static str = "Rhino.Geometry.MeshingParameters";
    const NAME: &'static str = "meshing parameters";

    /// A flat object of properties. What is not there is as a new `MeshingParameters` has it; what has no meaning here
    /// (texture ranges, packing, curvature, grid amplification) is ignored. A number is the density of the short form:
    /// 0 coarse to 1 fine.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        if json.is_number() {
            let density = f64::read(json).map_err(no::<Self>)?;
            if !(0.0..=1.0).contains(&density) {
                return Err(no::<Self>(format!("the density {density} is not 0 to 1")));
            }
            let settings = MeshSettings { relative_tolerance: density, ..MeshSettings::default() };
            return Ok(Self(settings));
        }
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let length = |name: &str, default: f64| -> Result<f64, Fault> {
                let value = members.read_or(name, default)?;
                if value < 0.0 {
                    Err(Fault::bad_request(format!("its {name} is {value}, below 0")))
                } else {
                    Ok(value)
                }
            };
            let count = |name: &str| -> Result<usize, Fault> {
                let value: i32 = members.read_or(name, 0)?;
                match usize::try_from(value) {
                    Ok(count) if value <= MOST_QUADS => Ok(count),
                    _ => Err(Fault::bad_request(format!("its {name} is {value}, not 0 to {MOST_QUADS}"))),
                }
            };
            let refine = members.read_or("RefineGrid", true)?;
            let angle = if refine { length("RefineAngle", 20_f64.to_radians())? } else { 0.0 };
            Ok(MeshSettings {
                max_distance: length("Tolerance", 0.0)?,
                relative_tolerance: length("RelativeTolerance", 0.0)?,
                min_distance: length("MinimumTolerance", 0.0)?,
                max_angle: if angle > 0.0 { angle } else { length("GridAngle", 20_f64.to_radians())? },
                max_aspect: length("GridAspectRatio", 6.0)?,
                min_edge: length("MinimumEdgeLength", 0.0001)?,
                max_edge: length("MaximumEdgeLength", 0.0)?,
                min_count: count("GridMinCount")?,
                max_count: count("GridMaxCount")?,
                refine,
                simple_planes: members.read_or("SimplePlanes", false)?,
                jagged_seams: members.read_or("JaggedSeams", false)?,
            })
        };
        read().map(Self).map_err(no::<Self>)
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        let settings = &self.0;
        Ok(json!({
            "Tolerance": number(settings.max_distance),
            "RelativeTolerance": number(settings.relative_tolerance),
            "MinimumTolerance": number(settings.min_distance),
            "RefineAngle": number(settings.max_angle),
            "GridAngle": number(settings.max_angle),
            "GridAspectRatio": number(settings.max_aspect),
            "MinimumEdgeLength": number(settings.min_edge),
            "MaximumEdgeLength": number(settings.max_edge),
            "GridMinCount": settings.min_count,
            "GridMaxCount": settings.max_count,
            "RefineGrid": settings.refine,
            "SimplePlanes": settings.simple_planes,
            "JaggedSeams": settings.jagged_seams,
        }))
    }
}
