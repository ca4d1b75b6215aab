//! BitmapPlus: pictures made of noises, read from files, taken apart and put together.
//!
//! Ports and the numbers of modes are facts from files; the noises are our own, so that pictures look alike but are not the
//! plug-in's. Pixels go row by row from the top.

mod create;
mod edit;
#[cfg(test)]
mod tests;

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Value};
use katydid_geometry::{Interval, Plane, Rectangle};

use crate::kept::{keep, kept};

/// The most pixels along a side.
const LONGEST: i32 = 1 << 14;
/// Pixels on an inch where a picture does not tell.
const RESOLUTION: f64 = 96.0;

/// A picture.
#[derive(Debug, Clone, PartialEq)]
struct Bitmap {
    width: usize,
    height: usize,
    pixels: Vec<Colour>,
}

impl Bitmap {
    /// # Errors
    /// A side has no pixels or too many.
    fn sides(context: &Context<'_>, width: i32, height: i32) -> Result<[usize; 2], Message> {
        let side = |n: i32, name: &str| match usize::try_from(n) {
            Ok(count) if (1..=LONGEST).contains(&n) => Ok(count),
            _ => Err(Message::error(format!("The {name} is {n} pixels: it must be from 1 to {LONGEST}"))),
        };
        let sides = [side(width, "width")?, side(height, "height")?];
        context.bytes(sides[0].saturating_mul(sides[1]).saturating_mul(4))?;
        Ok(sides)
    }

    fn made(
        context: &Context<'_>,
        [width, height]: [usize; 2],
        mut colour: impl FnMut(usize, usize) -> Colour,
    ) -> Result<Self, Message> {
        let mut pixels = Vec::with_capacity(width.saturating_mul(height));
        for y in 0..height {
            context.check()?;
            pixels.extend((0..width).map(|x| colour(x, y)));
        }
        Ok(Self { width, height, pixels })
    }

    fn item(self) -> Value {
        keep(format!("Bitmap ({} x {})", self.width, self.height), self)
    }

    fn of(value: &Value) -> Result<&Self, Message> {
        kept::<Self>(value).ok_or_else(|| Message::error("This is no picture"))
    }

    /// The pixel nearest to a place inside.
    fn at(&self, x: i64, y: i64) -> Colour {
        let inside = |x: i64, count: usize| {
            let last = i64::try_from(count).unwrap_or(i64::MAX).saturating_sub(1);
            usize::try_from(x.clamp(0, last.max(0))).unwrap_or(0)
        };
        let place = inside(y, self.height) * self.width + inside(x, self.width);
        self.pixels.get(place).copied().unwrap_or_default()
    }
}

/// The colours of a picture, row by row from the top. Stands for BitmapPlus's Deconstruct Bitmap; the order is our reading.
#[component(
    "80c86564-eb50-4dfd-876a-139f5fc24246",
    name = "Deconstruct Bitmap",
    nick = "DeBmp",
    at = "BitmapPlus/Analysis"
)]
#[output("Colors", "C", "The colour of each pixel.")]
fn deconstruct(
    context: &Context<'_>,
    /// The picture.
    #[port("Image", "I")]
    image: Value,
) -> Result<Vec<Colour>, Message> {
    let bitmap = Bitmap::of(&image)?;
    context.items(bitmap.pixels.len())?;
    Ok(bitmap.pixels.clone())
}

/// The size of a picture. Stands for BitmapPlus's Bitmap Properties; the resolution is 96 where none is known.
#[component(
    "df8eb4cb-e2e6-43f0-a2fe-d1c2f8042066",
    name = "Bitmap Properties",
    nick = "BmpProp",
    at = "BitmapPlus/Analysis"
)]
#[output("Boundary", "B", "A rectangle of a unit for each pixel, from the origin.")]
#[output("Width", "W", "The pixels in a row.")]
#[output("Height", "H", "The rows.")]
#[output("Horizontal Resolution", "Hr", "Pixels on an inch along a row.")]
#[output("Vertical Resolution", "Vr", "Pixels on an inch across rows.")]
#[output("Format", "F", "How colours are stored: 32 bits with alpha.")]
fn properties(
    /// The picture.
    #[port("Image", "I")]
    image: Value,
) -> Result<(Rectangle, i32, i32, f64, f64, Shared<str>), Message> {
    let bitmap = Bitmap::of(&image)?;
    let side = |n: usize| Interval::new(0.0, n as f64);
    let boundary = Rectangle { plane: Plane::XY, x: side(bitmap.width), y: side(bitmap.height) };
    let count = |n: usize| i32::try_from(n).unwrap_or(i32::MAX);
    let format = Shared::from("Format32bppArgb");
    Ok((boundary, count(bitmap.width), count(bitmap.height), RESOLUTION, RESOLUTION, format))
}

/// Shows a picture on the canvas in Grasshopper; here the object only takes it. Stands for BitmapPlus's Prev Image.
#[component(
    "87be230e-03e8-44b4-9d5c-f77338700b6e",
    name = "Prev Image",
    nick = "PrevImg",
    at = "BitmapPlus/Visualize"
)]
fn preview(
    /// The picture.
    #[port("Smart Bitmap", "B", optional)]
    _image: Option<Value>,
) {
}

/// The colour of one pixel. Stands for BitmapPlus's Get Pixel; places outside give the nearest one, which is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c01",
    name = "Get Pixel",
    nick = "GetPixel",
    at = "BitmapPlus/Analysis"
)]
#[output("Color", "C", "The colour.")]
fn get_pixel(
    /// The picture.
    #[port("Image", "I")]
    image: Value,
    /// The column, from 0.
    #[port("X", "X", default = 0)]
    x: i32,
    /// The row, from 0 at the top.
    #[port("Y", "Y", default = 0)]
    y: i32,
) -> Result<Colour, Message> {
    Ok(Bitmap::of(&image)?.at(i64::from(x), i64::from(y)))
}

/// The colour at a place between 0 and 1, blended from the four pixels around. Stands for BitmapPlus's Evaluate Bitmap; that v goes
/// down from the top is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c02",
    name = "Evaluate Bitmap",
    nick = "EvalBmp",
    at = "BitmapPlus/Analysis"
)]
#[output("Color", "C", "The colour.")]
fn evaluate(
    /// The picture.
    #[port("Image", "I")]
    image: Value,
    /// The place along a row, from 0 to 1.
    #[port("U", "U", default = 0.5)]
    u: f64,
    /// The place across rows, from 0 to 1.
    #[port("V", "V", default = 0.5)]
    v: f64,
) -> Result<Colour, Message> {
    Bitmap::of(&image)?.between(u, v)
}

impl Bitmap {
    /// The colour at parts of the sides, blended between the centres of pixels.
    fn between(&self, u: f64, v: f64) -> Result<Colour, Message> {
        if !(u.is_finite() && v.is_finite()) {
            return Err(Message::error("The place is not finite"));
        }
        let place = |t: f64, count: usize| t.clamp(0.0, 1.0) * count as f64 - 0.5;
        let (x, y) = (place(u, self.width), place(v, self.height));
        let (i, j) = (x.floor(), y.floor());
        let (s, t) = (x - i, y - j);
        let corner = |a: i64, b: i64| self.at(i as i64 + a, j as i64 + b);
        let mix = |channel: fn(&Colour) -> u8| {
            let of = |a, b| f64::from(channel(&corner(a, b)));
            let (top, low) = (of(0, 0) * (1.0 - s) + of(1, 0) * s, of(0, 1) * (1.0 - s) + of(1, 1) * s);
            (top * (1.0 - t) + low * t).round() as u8
        };
        Ok(Colour::argb(mix(|c| c.a), mix(|c| c.r), mix(|c| c.g), mix(|c| c.b)))
    }
}
