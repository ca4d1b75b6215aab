//! Pictures cut, sized, mirrored and made grey.

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Value};
use katydid_geometry::Rectangle;

use super::{Bitmap, LONGEST};

/// The part of a picture in a rectangle that is counted in pixels from the upper left corner. Stands for BitmapPlus's Crop Image; the
/// ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c07",
    name = "Crop Image",
    nick = "Crop",
    at = "BitmapPlus/Transform"
)]
#[output("Image", "I", "The picture.")]
fn crop(
    context: &Context<'_>,
    /// The picture.
    #[port("Image", "I")]
    image: Value,
    /// The rectangle, a unit for each pixel.
    #[port("Region", "R")]
    region: Rectangle,
) -> Result<Value, Message> {
    let bitmap = Bitmap::of(&image)?;
    let corners = region.corners();
    let range = |coordinate: fn(&katydid_geometry::Point3) -> f64, count: usize| {
        let low = corners.iter().map(coordinate).fold(f64::INFINITY, f64::min).floor().max(0.0);
        let high = corners.iter().map(coordinate).fold(f64::NEG_INFINITY, f64::max).ceil().min(count as f64);
        (low < high).then_some([low as usize, high as usize])
    };
    let (Some([left, right]), Some([top, bottom])) =
        (range(|p| p.x, bitmap.width), range(|p| p.y, bitmap.height))
    else {
        return Err(Message::error("No pixel lies in the region"));
    };
    let part = Bitmap::made(context, [right - left, bottom - top], |x, y| {
        bitmap.at((left + x) as i64, (top + y) as i64)
    })?;
    Ok(part.item())
}

/// A picture of another size, blended between pixels. Stands for BitmapPlus's Resize Image; modes of the plug-in do not count.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c08",
    name = "Resize Image",
    nick = "Resize",
    at = "BitmapPlus/Transform"
)]
#[output("Image", "I", "The picture.")]
fn resize(
    context: &Context<'_>,
    /// The picture.
    #[port("Image", "I")]
    image: Value,
    /// How it is sized, which does not count here.
    #[port("Mode", "M", optional)]
    _mode: Option<i32>,
    /// The pixels in a row.
    #[port("Width", "W", default = 100)]
    width: i32,
    /// The rows.
    #[port("Height", "H", default = 100)]
    height: i32,
) -> Result<Value, Message> {
    Ok(sized(context, Bitmap::of(&image)?, Bitmap::sides(context, width, height)?)?.item())
}

fn sized(context: &Context<'_>, bitmap: &Bitmap, sides: [usize; 2]) -> Result<Bitmap, Message> {
    let [width, height] = sides.map(|n| n as f64);
    Bitmap::made(context, sides, |x, y| {
        bitmap.between((x as f64 + 0.5) / width, (y as f64 + 0.5) / height).unwrap_or_default()
    })
}

/// A picture that is larger or smaller by a factor. Stands for BitmapPlus's Scale Image; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c09",
    name = "Scale Image",
    nick = "Scale",
    at = "BitmapPlus/Transform"
)]
#[output("Image", "I", "The picture.")]
fn scale(
    context: &Context<'_>,
    /// The picture.
    #[port("Image", "I")]
    image: Value,
    /// The factor, above 0.
    #[port("Factor", "F", default = 1.0)]
    factor: f64,
) -> Result<Value, Message> {
    let bitmap = Bitmap::of(&image)?;
    let side = |n: usize| {
        let pixels = (n as f64 * factor).round();
        if pixels >= 1.0 && pixels <= f64::from(LONGEST) {
            Ok(pixels as i32)
        } else {
            Err(Message::error("The factor is not possible"))
        }
    };
    let sides = Bitmap::sides(context, side(bitmap.width)?, side(bitmap.height)?)?;
    Ok(sized(context, bitmap, sides)?.item())
}

/// A picture mirrored in its middle. Stands for BitmapPlus's Mirror Image; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c0a",
    name = "Mirror Image",
    nick = "Mirror",
    at = "BitmapPlus/Transform"
)]
#[output("Image", "I", "The picture.")]
fn mirror(
    context: &Context<'_>,
    /// The picture.
    #[port("Image", "I")]
    image: Value,
    /// Whether left and right change places.
    #[port("Horizontal", "H", default = true)]
    horizontal: bool,
    /// Whether top and bottom change places.
    #[port("Vertical", "V", default = false)]
    vertical: bool,
) -> Result<Value, Message> {
    let bitmap = Bitmap::of(&image)?;
    let turned = |x: usize, count: usize, turn: bool| (if turn { count - 1 - x } else { x }) as i64;
    let mirrored = Bitmap::made(context, [bitmap.width, bitmap.height], |x, y| {
        bitmap.at(turned(x, bitmap.width, horizontal), turned(y, bitmap.height, vertical))
    })?;
    Ok(mirrored.item())
}

/// A picture in greys, by the weights of ITU-R BT.709. Stands for BitmapPlus's Grayscale Filter; other weights are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2c0b",
    name = "Grayscale Filter",
    nick = "Grayscale",
    at = "BitmapPlus/Filter"
)]
#[output("Image", "I", "The picture.")]
fn greyscale(
    context: &Context<'_>,
    /// The picture.
    #[port("Image", "I")]
    image: Value,
    /// Which weights, which does not count here.
    #[port("Mode", "M", optional)]
    _mode: Option<i32>,
) -> Result<Value, Message> {
    let bitmap = Bitmap::of(&image)?;
    let grey = Bitmap::made(context, [bitmap.width, bitmap.height], |x, y| {
        let c = bitmap.at(x as i64, y as i64);
        let level = 0.2126 * f64::from(c.r) + 0.7152 * f64::from(c.g) + 0.0722 * f64::from(c.b);
        let level = level.round() as u8;
        Colour::argb(c.a, level, level, level)
    })?;
    Ok(grey.item())
}
