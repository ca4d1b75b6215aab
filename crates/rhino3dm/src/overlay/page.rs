//! Units of pages, base point and place on the Earth (section 5).

use katydid_geometry::{Point3, Tolerance, Units, Vector3};

use super::earth::SAYS_UNSET;
use crate::Result;
use crate::chunk::Reader;
use crate::model::UnitScale;
use crate::settings::read_stored_units;

/// What an archive says of its pages and of its place in the world.
#[derive(Debug, Clone, PartialEq)]
pub struct PageSettings {
    /// How much longer patterns of linetypes are shown.
    pub linetype_scale: f64,
    /// The unit of pages.
    pub units: Units,
    /// A unit of pages that [`Units`] has no name for.
    pub unit_scale: Option<UnitScale>,
    /// The tolerances on pages.
    pub tolerance: Tolerance,
    /// The base point of the model.
    pub base_point: Point3,
    /// Where on the Earth the model is.
    pub earth: Option<EarthAnchor>,
}

/// Where on the Earth a model is.
#[derive(Debug, Clone, PartialEq)]
pub struct EarthAnchor {
    /// Latitude and longitude in degrees, north and east positive; nothing when they are not set.
    pub position: Option<[f64; 2]>,
    /// The elevation in metres.
    pub elevation: f64,
    /// The point of the model that lies there.
    pub model_point: Point3,
    /// North in the model.
    pub north: Vector3,
    /// East in the model.
    pub east: Vector3,
    /// The name of the place.
    pub name: String,
    /// A description of it.
    pub description: String,
}

const WHAT: &str = "page settings";
/// Numbers beyond this stand for none.
const UNSET: f64 = 1e300;

impl PageSettings {
    pub(super) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let (_, minor) = body.packed_version(WHAT)?;
        let linetype_scale = if minor >= 1 { body.f64(WHAT)? } else { 1.0 };
        if minor >= 2 {
            // The colour in print and the linetype of new objects, and where both come from.
            body.take(16, WHAT)?;
        }
        let (mut units, _) = body.versioned_1(WHAT)?;
        let stored = read_stored_units(&mut units)?;
        let mut page = Self {
            linetype_scale,
            units: stored.units,
            unit_scale: stored.scale,
            tolerance: stored.tolerance,
            base_point: Point3::ORIGIN,
            earth: None,
        };
        if minor >= 4 {
            body.uuid("active view")?;
        }
        if minor >= 5 {
            page.base_point = body.point(WHAT)?;
            page.earth = Some(EarthAnchor::read(body)?);
        }
        Ok(page)
    }
}

impl EarthAnchor {
    fn read(body: &mut Reader<'_>) -> Result<Self> {
        const WHAT: &str = "earth anchor";
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let position = [chunk.f64(WHAT)?, chunk.f64(WHAT)?];
        let elevation = chunk.f64(WHAT)?;
        let set = position.iter().all(|x| x.abs() < UNSET)
            && (minor >= SAYS_UNSET || position != [0.0; 2] || elevation != 0.0);
        let mut anchor = Self {
            position: set.then_some(position),
            elevation,
            model_point: chunk.point(WHAT)?,
            north: chunk.vector(WHAT)?,
            east: chunk.vector(WHAT)?,
            name: String::new(),
            description: String::new(),
        };
        if minor >= 1 {
            // What the elevation counts from, and an identifier.
            chunk.take(20, WHAT)?;
            anchor.name = chunk.string(WHAT)?;
            anchor.description = chunk.string(WHAT)?;
        }
        Ok(anchor)
    }
}
