//! Create: pictures of noises, of colours, and from files.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Colour, Value};

use super::Bitmap;
use crate::noise::by_mode;
use crate::noise::kinds::{Blend, Cells, Fractal, Metric, cells};

/// A noise that is handed from one object to another.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Noise {
    seed: i32,
    sides: [usize; 2],
    depth: f64,
    mode: i32,
    interpolation: i32,
    frequency: f64,
}

/// A number from -1 to 1 as a grey.
fn grey(x: f64) -> Colour {
    let level = ((x.clamp(-1.0, 1.0) + 1.0) * 127.5).round() as u8;
    Colour::rgb(level, level, level)
}

fn finite(value: f64, what: &str) -> Result<f64, Message> {
    if value.is_finite() { Ok(value) } else { Err(Message::error(format!("{what} is not finite"))) }
}

/// A grey picture of a noise. Stands for BitmapPlus's Procedural Noise; the noise itself is our own.
#[component(
    "c3640c6e-09dd-48a1-a663-79419e76bd4e",
    name = "Procedural Noise",
    nick = "Noise",
    at = "BitmapPlus/Create"
)]
#[output("Image", "I", "The picture.")]
#[output("Noise", "N", "The noise, for Procedural Fractal Pass.")]
fn procedural_noise(
    context: &Context<'_>,
    /// Another seed gives another noise.
    #[port("Seed", "S", default = 1)]
    seed: i32,
    /// The pixels in a row.
    #[port("Width", "W", default = 100)]
    width: i32,
    /// The rows.
    #[port("Height", "H", default = 100)]
    height: i32,
    /// The third coordinate.
    #[port("Depth", "D", default = 1.0)]
    depth: f64,
    /// The noise: 0 value, 1 gradient, 2 cubic, 3 simplex, 4 white.
    #[port("Mode", "M", default = 0)]
    mode: i32,
    /// How values are blended: 0 straight, 1 Hermite, 2 quintic.
    #[port("Interpolation", "In", default = 0)]
    interpolation: i32,
    /// How many waves there are on a pixel.
    #[port("Frequency", "F", default = 0.25)]
    frequency: f64,
) -> Result<(Value, Value), Message> {
    let sides = Bitmap::sides(context, width, height)?;
    let (depth, frequency) = (finite(depth, "The depth")?, finite(frequency, "The frequency")?);
    let noise = Noise { seed, sides, depth, mode, interpolation, frequency };
    let blend = Blend::of(interpolation);
    let bitmap = Bitmap::made(context, sides, |x, y| {
        grey(by_mode(mode, seed, [x as f64, y as f64, depth].map(|x| x * frequency), blend))
    })?;
    Ok((bitmap.item(), crate::kept::keep("Noise".to_owned(), noise)))
}

/// A grey picture of a sum of noises, each finer and smaller than the one before. Stands for BitmapPlus's Procedural Fractal Pass;
/// its ports beyond the noise are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c03",
    name = "Procedural Fractal Pass",
    nick = "Fractal",
    at = "BitmapPlus/Create"
)]
#[output("Image", "I", "The picture.")]
fn procedural_fractal(
    context: &Context<'_>,
    /// The noise of Procedural Noise.
    #[port("Noise", "N")]
    noise: Value,
    /// How noises are added: 0 as they are, 1 with sharp valleys, 2 with sharp ridges.
    #[port("Mode", "M", default = 0)]
    mode: i32,
    /// How many noises, from 1 to 32.
    #[port("Octaves", "O", default = 5)]
    octaves: i32,
    /// How much finer each is than the one before.
    #[port("Lacunarity", "L", default = 2.0)]
    lacunarity: f64,
    /// How much smaller each is.
    #[port("Gain", "G", default = 0.5)]
    gain: f64,
) -> Result<Value, Message> {
    let noise = crate::kept::kept::<Noise>(&noise).ok_or_else(|| Message::error("This is no noise"))?;
    let (lacunarity, gain) = (finite(lacunarity, "The lacunarity")?, finite(gain, "The gain")?);
    let blend = Blend::of(noise.interpolation);
    let bitmap = Bitmap::made(context, noise.sides, |x, y| {
        let p = [x as f64, y as f64, noise.depth].map(|x| x * noise.frequency);
        grey(Fractal::of(mode).sum(p, octaves, lacunarity, gain, |octave, p| {
            by_mode(noise.mode, noise.seed.wrapping_add(octave), p, blend)
        }))
    })?;
    Ok(bitmap.item())
}

/// What a picture of cells shows, by the numbers that files have.
fn shown(found: Cells, mode: i32) -> f64 {
    let Cells { first, second, value } = found;
    match mode {
        0 => value,
        2 => second - 1.0,
        3 => first + second - 1.0,
        4 => second - first - 1.0,
        5 => first * second - 1.0,
        6 if second > 0.0 => first / second - 1.0,
        _ => first - 1.0,
    }
}

/// A grey picture of cells: points spread over the plane, one in each cell, and how far away they are. Stands for BitmapPlus's
/// Procedural Cellular; the noise itself is our own.
#[component(
    "f4bbc26d-73e6-4e2c-bcec-9f0d1f62acef",
    name = "Procedural Cellular",
    nick = "Cellular",
    at = "BitmapPlus/Create"
)]
#[output("Image", "I", "The picture.")]
fn procedural_cellular(
    context: &Context<'_>,
    /// Another seed gives other points.
    #[port("Seed", "S", default = 1)]
    seed: i32,
    /// The pixels in a row.
    #[port("Width", "W", default = 100)]
    width: i32,
    /// The rows.
    #[port("Height", "H", default = 100)]
    height: i32,
    /// The third coordinate.
    #[port("Depth", "D", default = 1.0)]
    depth: f64,
    /// How distances are measured: 0 straight, 1 along the axes, 2 both together.
    #[port("Boundary Mode", "B", default = 0)]
    metric: i32,
    /// What is shown: 0 a number of the nearest point, 1 its distance, 2 that of the next one, 3 to 6 both distances added,
    /// subtracted, multiplied or divided.
    #[port("Interpolation Mode", "In", default = 0)]
    mode: i32,
    /// How far points are from the centres of their cells, from 0 to 1.
    #[port("Jitter", "J", default = 0.5)]
    jitter: f64,
    /// How many cells there are on a pixel.
    #[port("Frequency", "F", default = 0.25)]
    frequency: f64,
) -> Result<Value, Message> {
    let sides = Bitmap::sides(context, width, height)?;
    let (depth, frequency) = (finite(depth, "The depth")?, finite(frequency, "The frequency")?);
    let jitter = finite(jitter, "The jitter")?.clamp(0.0, 1.0);
    let metric = Metric::of(metric);
    let bitmap = Bitmap::made(context, sides, |x, y| {
        grey(shown(cells(seed, [x as f64, y as f64, depth].map(|x| x * frequency), jitter, metric), mode))
    })?;
    Ok(bitmap.item())
}

/// A picture of colours, row by row from the top; the last colour goes on where there are too few. Stands for BitmapPlus's Build
/// Bitmap; the order is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c04",
    name = "Build Bitmap",
    nick = "Bmp",
    at = "BitmapPlus/Create"
)]
#[output("Image", "I", "The picture.")]
fn build(
    context: &Context<'_>,
    /// The colours.
    #[port("Colors", "C")]
    colours: List<Colour>,
    /// The pixels in a row.
    #[port("Width", "W", default = 100)]
    width: i32,
    /// The rows.
    #[port("Height", "H", default = 100)]
    height: i32,
) -> Result<Value, Message> {
    let sides = Bitmap::sides(context, width, height)?;
    let colours: Vec<Colour> = colours.present().collect();
    let last = *colours.last().ok_or_else(|| Message::warning("There are no colours"))?;
    let bitmap = Bitmap::made(context, sides, |x, y| colours.get(y * sides[0] + x).copied().unwrap_or(last))?;
    Ok(bitmap.item())
}

/// Reads a picture from a file: PNG, JPEG, BMP or GIF. Stands for BitmapPlus's Open Bitmap.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c05",
    name = "Open Bitmap",
    nick = "OpenBmp",
    at = "BitmapPlus/File"
)]
#[output("Image", "I", "The picture.")]
fn open(
    context: &Context<'_>,
    /// The path of the file; one that is not absolute starts where the definition lies.
    #[port("File Path", "P")]
    path: Shared<str>,
) -> Result<Value, Message> {
    Ok(read(&context.read_file(&path)?)?.item())
}

/// Reads a picture, within limits.
#[cfg(feature = "pictures")]
fn read(bytes: &[u8]) -> Result<Bitmap, Message> {
    /// 64 million pixels of four channels.
    const MOST: u64 = 1 << 28;
    let problem = |why: String| Message::error(format!("The picture cannot be read: {why}"));
    let reader = image::ImageReader::new(std::io::Cursor::new(bytes)).with_guessed_format();
    let mut reader = reader.map_err(|error| problem(error.to_string()))?;
    let mut limits = image::Limits::default();
    limits.max_image_width = Some(super::LONGEST.cast_unsigned());
    limits.max_image_height = Some(super::LONGEST.cast_unsigned());
    limits.max_alloc = Some(MOST);
    reader.limits(limits);
    let picture = reader.decode().map_err(|error| problem(error.to_string()))?.into_rgba8();
    let size = |n: u32| usize::try_from(n).unwrap_or(0);
    let (width, height) = (size(picture.width()), size(picture.height()));
    let pixels = picture.pixels().map(|p| {
        let [r, g, b, a] = p.0;
        Colour::argb(a, r, g, b)
    });
    Ok(Bitmap { width, height, pixels: pixels.collect() })
}

/// Pictures are not read without the feature `pictures`.
#[cfg(not(feature = "pictures"))]
fn read(_: &[u8]) -> Result<Bitmap, Message> {
    Err(Message::error("This program reads no pictures"))
}

/// Would write a picture to a file, which is not supported: definitions write no files. Stands for BitmapPlus's Save Bitmap.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c06",
    name = "Save Bitmap",
    nick = "SaveBmp",
    at = "BitmapPlus/File"
)]
#[output("File Path", "P", "Nothing: no file is written.")]
fn save(
    context: &Context<'_>,
    /// The picture.
    #[port("Image", "I", optional)]
    _image: Option<Value>,
    /// The folder.
    #[port("Folder Path", "F", optional)]
    _folder: Option<Shared<str>>,
    /// The name of the file.
    #[port("File Name", "N", optional)]
    _name: Option<Shared<str>>,
    /// The kind of file.
    #[port("Extension", "E", optional)]
    _kind: Option<i32>,
    /// Whether to write; nothing is written.
    #[port("Save", "S", optional)]
    write: Option<bool>,
) -> Option<Shared<str>> {
    if write == Some(true) {
        context.warn("Definitions write no files here");
    }
    None
}
