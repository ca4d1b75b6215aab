//! Lights of version 1: spotlights, as a cone from its base.

use katydid_elementary::Elementary;
use katydid_geometry::{Point3, Vector3};
use uuid::Uuid;

use super::UNSET;
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "spotlight";
/// The style of a spotlight that stands in the world.
const WORLD_SPOT: i32 = 9;

/// A spotlight.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spotlight {
    location: Point3,
    direction: Vector3,
    /// Degrees between the axis and the side; the default is 180.
    angle: f64,
}

impl Spotlight {
    pub(super) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let origin = body.point(WHAT)?;
        let axis = body.vector(WHAT)?.cross(body.vector(WHAT)?);
        let (radius, height) = (body.f64(WHAT)?, body.f64(WHAT)?);
        // The hot spot.
        body.f64(WHAT)?;
        let direction = axis * -1.0;
        Ok(Self {
            location: origin + axis * height,
            direction: if height > 0.0 { direction * height } else { direction },
            angle: if radius > 0.0 && height > 0.0 {
                (radius / height).arctangent().to_degrees()
            } else {
                180.0
            },
        })
    }

    /// Writes the body of the class.
    pub(super) fn write(
        &self,
        diffuse: Option<[u8; 4]>,
        id: Uuid,
        index: usize,
        w: &mut Writer,
    ) -> Result<()> {
        w.packed_version(1, 2);
        w.i32(1);
        w.i32(WORLD_SPOT);
        // Intensity and watts.
        w.f64(1.0);
        w.f64(0.0);
        w.colour([0; 4]);
        let [red, green, blue, _] = diffuse.unwrap_or([255; 4]);
        w.colour([red, green, blue, 0]);
        w.colour([255, 255, 255, 0]);
        w.vector(self.direction);
        w.point(self.location);
        w.f64(self.angle);
        // Exponent, attenuation, strength of shadows.
        w.f64(64.0);
        w.vector(Vector3::new(1.0, 0.0, 0.0));
        w.f64(1.0);
        w.count(index, "lights")?;
        w.uuid(id);
        w.string("")?;
        w.vector(Vector3::new(0.0, 0.0, 0.0));
        w.vector(Vector3::new(0.0, 0.0, 0.0));
        w.f64(UNSET);
        Ok(())
    }
}
