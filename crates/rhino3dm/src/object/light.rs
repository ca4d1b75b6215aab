//! Class Light (section 8).

use katydid_geometry::{Point3, Vector3};
use uuid::Uuid;

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Result, colour};

/// What a light's rays start from, and whether it moves with the camera.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LightStyle {
    /// Parallel rays along a direction of the camera.
    CameraDirectional,
    /// From a point of the camera's space.
    CameraPoint,
    /// A cone in the camera's space.
    CameraSpot,
    /// Parallel rays along a direction of the model.
    Directional,
    /// From a point.
    Point,
    /// A cone.
    Spot,
    /// From everywhere.
    Ambient,
    /// From a segment.
    Linear,
    /// From a rectangle.
    Rectangular,
    /// A style by a number that has no name.
    Unknown(i32),
}

/// The numbers of the styles.
const STYLES: [(i32, LightStyle); 9] = [
    (4, LightStyle::CameraDirectional),
    (5, LightStyle::CameraPoint),
    (6, LightStyle::CameraSpot),
    (7, LightStyle::Directional),
    (8, LightStyle::Point),
    (9, LightStyle::Spot),
    (10, LightStyle::Ambient),
    (11, LightStyle::Linear),
    (12, LightStyle::Rectangular),
];

impl LightStyle {
    fn from_number(number: i32) -> Self {
        STYLES.iter().find(|(n, _)| *n == number).map_or(Self::Unknown(number), |(_, style)| *style)
    }

    fn number(self) -> i32 {
        match self {
            Self::Unknown(number) => number,
            named => STYLES.iter().find(|(_, style)| *style == named).map_or(0, |(number, _)| *number),
        }
    }
}

/// A light of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct Light {
    /// Whether it is switched on.
    pub on: bool,
    /// What its rays start from.
    pub style: LightStyle,
    /// How bright it is; 1 is full.
    pub intensity: f64,
    /// Its power in watts; 0 when that is not said.
    pub watts: f64,
    /// The colour it gives to what it does not reach, as red, green, blue, alpha.
    pub ambient: [u8; 4],
    /// The colour it gives to what it reaches.
    pub diffuse: [u8; 4],
    /// The colour of its highlights.
    pub specular: [u8; 4],
    /// Where its rays go.
    pub direction: Vector3,
    /// Where it stands.
    pub location: Point3,
    /// Half the angle of a spot light's cone, in degrees.
    pub spot_angle: f64,
    /// How fast a spot light fades off its axis, 0 to 128.
    pub spot_exponent: f64,
    /// How fast it fades with the distance d: 1 / (x + y·d + z·d²).
    pub attenuation: Vector3,
    /// How dark its shadows are, 0 to 1.
    pub shadow_intensity: f64,
    /// The number it gives itself among the lights.
    pub index: i32,
    /// Its identifier.
    pub id: Uuid,
    /// Its name.
    pub name: String,
    /// The segment of a linear light, one side of a rectangular one.
    pub length: Vector3,
    /// The other side of a rectangular light.
    pub width: Vector3,
    /// How much of a spot light's cone is fully lit, 0 to 1; negative when the exponent says it.
    pub hot_spot: f64,
}

impl Default for Light {
    /// A white spot light at the origin that shines down, as a new one in openNURBS.
    fn default() -> Self {
        Self {
            on: true,
            style: LightStyle::CameraDirectional,
            intensity: 1.0,
            watts: 0.0,
            ambient: [0, 0, 0, 255],
            diffuse: [255, 255, 255, 255],
            specular: [255, 255, 255, 255],
            direction: Vector3::new(0.0, 0.0, -1.0),
            location: Point3::ORIGIN,
            spot_angle: 180.0,
            spot_exponent: 0.0,
            attenuation: Vector3::new(1.0, 0.0, 0.0),
            shadow_intensity: 1.0,
            index: 0,
            id: Uuid::nil(),
            name: String::new(),
            length: Vector3::ZERO,
            width: Vector3::ZERO,
            hot_spot: 1.0,
        }
    }
}

const WHAT: &str = "light";

pub(super) fn read(body: &mut Reader<'_>) -> Result<Light> {
    let minor = major_1(body, WHAT)?;
    let mut light = Light {
        on: body.i32(WHAT)? != 0,
        style: LightStyle::from_number(body.i32(WHAT)?),
        intensity: body.f64(WHAT)?,
        watts: body.f64(WHAT)?,
        ambient: colour::from_archive(body.colour(WHAT)?),
        diffuse: colour::from_archive(body.colour(WHAT)?),
        specular: colour::from_archive(body.colour(WHAT)?),
        direction: body.vector(WHAT)?,
        location: body.point(WHAT)?,
        spot_angle: body.f64(WHAT)?,
        spot_exponent: body.f64(WHAT)?,
        attenuation: body.vector(WHAT)?,
        shadow_intensity: body.f64(WHAT)?,
        index: body.i32(WHAT)?,
        id: body.uuid(WHAT)?,
        name: body.string(WHAT)?,
        ..Light::default()
    };
    if minor >= 1 {
        light.length = body.vector(WHAT)?;
        light.width = body.vector(WHAT)?;
    }
    if minor >= 2 {
        light.hot_spot = body.f64(WHAT)?;
    }
    Ok(light)
}

pub(super) fn write(light: &Light, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 2);
    w.i32(i32::from(light.on));
    w.i32(light.style.number());
    w.f64(light.intensity);
    w.f64(light.watts);
    for shade in [light.ambient, light.diffuse, light.specular] {
        w.colour(colour::to_archive(shade));
    }
    w.vector(light.direction);
    w.point(light.location);
    w.f64(light.spot_angle);
    w.f64(light.spot_exponent);
    w.vector(light.attenuation);
    w.f64(light.shadow_intensity);
    w.i32(light.index);
    w.uuid(light.id);
    w.string(&light.name)?;
    w.vector(light.length);
    w.vector(light.width);
    w.f64(light.hot_spot);
    Ok(())
}
