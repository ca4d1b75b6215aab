//! Units of pages, base point and place on the Earth (section 5).

use katydid_geometry::{Point3, Tolerance, Units, Vector3};

use crate::Result;
use crate::chunk::Reader;
use crate::earth::{EARTH_FROM, SAYS_UNSET};
use crate::unit_scale::UnitScale;
use crate::unit_scale::read_stored_units;

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
    /// Reads a record; what it does not say is as in `of_model`.
    pub(crate) fn read(body: &mut Reader<'_>, of_model: Self) -> Result<Self> {
        let (_, minor) = body.packed_version(WHAT)?;
        let linetype_scale = body.f64(WHAT)?;
        // The colour in print and the linetype of new objects, and where both come from.
        body.take(16, WHAT)?;
        let mut page = Self { linetype_scale, ..of_model };
        if minor >= 1 {
            let (mut units, _) = body.versioned_1(WHAT)?;
            let stored = read_stored_units(&mut units)?;
            page.units = stored.units;
            page.unit_scale = stored.scale;
            page.tolerance = stored.tolerance;
        }
        if minor >= 2 {
            body.uuid("active view")?;
        }
        if minor >= EARTH_FROM {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Model;
    use crate::chunk::Writer;
    use crate::tables::{KeptRecord, Table};
    use crate::typecode;
    use crate::version::Version;

    /// Page settings as openNURBS has written them since 2005, each minor version with more fields.
    fn record(minor: u8) -> KeptRecord {
        let mut w = Writer::new(Version::for_writing(50).unwrap());
        w.chunk(typecode::SETTINGS_ATTRIBUTES, |w| {
            w.packed_version(1, minor);
            w.f64(2.5);
            w.bytes(&[0; 16]);
            if minor >= 1 {
                w.versioned(1, 0, |w| {
                    [102, 8].iter().for_each(|number| w.i32(*number));
                    [0.25, 0.5, 0.01].iter().for_each(|tolerance| w.f64(*tolerance));
                    [0, 3].iter().for_each(|number| w.i32(*number));
                    w.f64(0.0254);
                    w.string("")
                })?;
            }
            if minor >= 2 {
                w.bytes(&[0; 16]);
            }
            if minor >= 3 {
                w.point(Point3::new(1.0, 2.0, 3.0));
                w.versioned(1, 0, |w| {
                    [47.5, 8.5, 400.0].iter().for_each(|number| w.f64(*number));
                    w.bytes(&[0; 72]);
                    Ok(())
                })?;
            }
            Ok(())
        })
        .unwrap();
        KeptRecord::of_chunk(Table::Settings, typecode::SETTINGS_ATTRIBUTES, w)
    }

    #[test]
    fn every_minor_version_is_read_as_far_as_it_goes() {
        for minor in 0..=7 {
            let model = Model { units: Units::Meters, kept: vec![record(minor)], ..Model::default() };
            let page = model.page_settings().unwrap();
            assert!((page.linetype_scale - 2.5).abs() < 1e-15);
            assert_eq!(page.units, if minor >= 1 { Units::Inches } else { Units::Meters }, "1.{minor}");
            assert_eq!(page.base_point == Point3::new(1.0, 2.0, 3.0), minor >= 3, "1.{minor}");
            let position = page.earth.and_then(|earth| earth.position);
            assert_eq!(position, (minor >= 3).then_some([47.5, 8.5]), "1.{minor}");
        }
    }
}
