//! Noise4D: noises of places in space and time. The noises themselves stand in [`kinds`]; other plug-ins use them too.
//!
//! No file at hand shows objects of this plug-in: names and ports are our reading.

pub(crate) mod kinds;

use katydid_component::{Message, component};
use katydid_geometry::Point3;

use kinds::{Blend, Fractal, Metric};

/// The coordinates of a place and a time, times a frequency.
///
/// # Errors
/// One is not finite.
fn place(p: Point3, time: f64, frequency: f64) -> Result<[f64; 4], Message> {
    let place = [p.x, p.y, p.z, time].map(|x| x * frequency);
    if place.iter().all(|x| x.is_finite()) {
        Ok(place)
    } else {
        Err(Message::error("The place is not finite"))
    }
}

macro_rules! noises {
    ($($(#[$help:meta])* $function:ident $guid:tt $name:tt $nick:tt |$seed:ident, $p:ident| $noise:expr;)*) => {$(
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "Noise4D/Noise")]
        #[output("Noise", "N", "The value, from -1 to 1.")]
        fn $function(
            /// The place.
            #[port("Point", "P")]
            point: Point3,
            /// The fourth coordinate, such as the time.
            #[port("W", "W", default = 0.0)]
            time: f64,
            /// Another seed gives another noise.
            #[port("Seed", "S", default = 0)]
            $seed: i32,
            /// How many waves there are on a unit of length.
            #[port("Frequency", "F", default = 1.0)]
            frequency: f64,
        ) -> Result<f64, Message> {
            let $p = place(point, time, frequency)?;
            Ok($noise)
        }
    )*};
}

noises! {
    /// Gradient noise: hills and valleys of one size. Stands for Noise4D's Perlin Noise; names and ports are our reading.
    perlin_noise "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2b01" "Perlin Noise" "Perlin" |seed, p| kinds::perlin(seed, p);
    /// Simplex noise: as gradient noise, with fewer directions that stand out. Stands for Noise4D's Simplex Noise; names and ports
    /// are our reading.
    simplex_noise "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2b02" "Simplex Noise" "Simplex" |seed, p| kinds::simplex(seed, p);
    /// Value noise: random values at whole coordinates, blended. Stands for Noise4D's Value Noise; names and ports are our reading.
    value_noise "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2b03" "Value Noise" "Value" |seed, p| kinds::value(seed, p, Blend::Quintic);
    /// Cubic noise: random values at whole coordinates with cubics through them. Stands for Noise4D's Cubic Noise; names and ports
    /// are our reading.
    cubic_noise "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2b04" "Cubic Noise" "Cubic" |seed, p| kinds::cubic(seed, p);
    /// White noise: a random value for each cell of size 1. Stands for Noise4D's White Noise; names and ports are our reading.
    white_noise "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2b05" "White Noise" "White" |seed, p| kinds::white(seed, p);
}

/// Cellular noise: distances to points spread over space, one in each cell of size 1. Stands for Noise4D's Cellular Noise; names and
/// ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2b06",
    name = "Cellular Noise",
    nick = "Cellular",
    at = "Noise4D/Noise"
)]
#[output("Noise", "N", "The distance to the nearest point.")]
#[output("Second", "N2", "The distance to the next one.")]
#[output("Value", "V", "A random number of the nearest point, from -1 to 1.")]
fn cellular_noise(
    /// The place.
    #[port("Point", "P")]
    point: Point3,
    /// The fourth coordinate, such as the time.
    #[port("W", "W", default = 0.0)]
    time: f64,
    /// Another seed gives another noise.
    #[port("Seed", "S", default = 0)]
    seed: i32,
    /// How many cells there are on a unit of length.
    #[port("Frequency", "F", default = 1.0)]
    frequency: f64,
    /// How far points are from the centres of their cells, from 0 to 1.
    #[port("Jitter", "J", default = 1.0)]
    jitter: f64,
    /// How distances are measured: 0 straight, 1 along the axes, 2 both together.
    #[port("Distance", "D", default = 0)]
    metric: i32,
) -> Result<(f64, f64, f64), Message> {
    let p = place(point, time, frequency)?;
    let jitter = if jitter.is_finite() { jitter.clamp(0.0, 1.0) } else { 1.0 };
    let found = kinds::cells(seed, p, jitter, Metric::of(metric));
    Ok((found.first, found.second, found.value))
}

/// A sum of noises, each finer and smaller than the one before. Stands for Noise4D's Fractal Noise; names and ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2b07",
    name = "Fractal Noise",
    nick = "Fractal",
    at = "Noise4D/Noise"
)]
#[output("Noise", "N", "The value, from -1 to 1.")]
fn fractal_noise(
    /// The place.
    #[port("Point", "P")]
    point: Point3,
    /// The fourth coordinate, such as the time.
    #[port("W", "W", default = 0.0)]
    time: f64,
    /// Another seed gives another noise.
    #[port("Seed", "S", default = 0)]
    seed: i32,
    /// How many waves of the coarsest noise there are on a unit of length.
    #[port("Frequency", "F", default = 1.0)]
    frequency: f64,
    /// The noise: 0 value, 1 gradient, 2 cubic, 3 simplex, 4 white.
    #[port("Mode", "M", default = 1)]
    mode: i32,
    /// How many noises are added, from 1 to 32.
    #[port("Octaves", "O", default = 3)]
    octaves: i32,
    /// How much finer each is than the one before.
    #[port("Lacunarity", "L", default = 2.0)]
    lacunarity: f64,
    /// How much smaller each is.
    #[port("Gain", "G", default = 0.5)]
    gain: f64,
    /// How they are added: 0 as they are, 1 with sharp valleys, 2 with sharp ridges.
    #[port("Type", "T", default = 0)]
    kind: i32,
) -> Result<f64, Message> {
    let p = place(point, time, frequency)?;
    let sum = Fractal::of(kind).sum(p, octaves, lacunarity, gain, |octave, p| {
        by_mode(mode, seed.wrapping_add(octave), p, Blend::Quintic)
    });
    if sum.is_finite() { Ok(sum) } else { Err(Message::error("The sum is not finite")) }
}

/// The noise of a number, as files of BitmapPlus count them.
pub(crate) fn by_mode<const N: usize>(mode: i32, seed: i32, p: [f64; N], blend: Blend) -> f64 {
    match mode {
        0 => kinds::value(seed, p, blend),
        2 => kinds::cubic(seed, p),
        3 => kinds::simplex(seed, p),
        4 => kinds::white(seed, p),
        _ => kinds::perlin_blended(seed, p, blend),
    }
}
