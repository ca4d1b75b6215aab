//! The Image Sampler.

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Column, Gather, Item, Tree, Value};
use katydid_definition::archive::{Chunk, ItemValue};
use katydid_geometry::Point3;

use super::picture::{Outside, Picture};

/// What is read off a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Channel {
    Colour,
    Alpha,
    Red,
    Green,
    Blue,
    Hue,
    Saturation,
    Value,
}

impl Channel {
    fn read(name: &str) -> Result<Self, Message> {
        Ok(match name.to_ascii_lowercase().as_str() {
            "" | "colour" | "color" => Self::Colour,
            "alpha" => Self::Alpha,
            "red" => Self::Red,
            "green" => Self::Green,
            "blue" => Self::Blue,
            "hue" => Self::Hue,
            "saturation" => Self::Saturation,
            "value" | "brightness" => Self::Value,
            _ => return Err(Message::error(format!("The channel {name} is not known"))),
        })
    }

    fn of(self, [a, r, g, b]: [f64; 4]) -> Value {
        let (max, min) = (r.max(g).max(b), r.min(g).min(b));
        Value::Number(match self {
            Self::Colour => {
                let byte = |x: f64| (x * 255.0).round().clamp(0.0, 255.0) as u8;
                return Value::Colour(Colour { a: byte(a), r: byte(r), g: byte(g), b: byte(b) });
            }
            Self::Alpha => a,
            Self::Red => r,
            Self::Green => g,
            Self::Blue => b,
            Self::Hue => crate::display::hue_of([r, g, b]),
            Self::Saturation if max == 0.0 => 0.0,
            Self::Saturation => (max - min) / max,
            Self::Value => max,
        })
    }
}

/// The picture that the sampler holds, or the one it names.
fn picture(context: &Context<'_>, settings: &Chunk) -> Result<Picture, Message> {
    let embedded = match settings.item("LocalImage") {
        Some(ItemValue::Bitmap(bytes) | ItemValue::ByteArray(bytes)) if !bytes.is_empty() => Some(bytes),
        _ => None,
    };
    // The file is the fresher one, unless the picture is meant to travel with the definition.
    let path = settings.str("FilePath").filter(|path| !path.trim().is_empty());
    match (embedded, path) {
        (Some(bytes), _) => Picture::read(bytes),
        (None, Some(path)) => Picture::read(&context.read_file(path)?),
        (None, None) => Err(Message::error("No picture is set")),
    }
}

/// Reads colours or other values off a picture at points: x to the right and y upwards over the ranges set in the
/// sampler.
///
/// It gives colours, or one channel as numbers from 0 to 1. Outside the ranges the picture ends, repeats or is mirrored,
/// as is set.
#[component(
    "d69a3494-785b-4beb-969b-d2373f65abfd",
    name = "Image Sampler",
    nick = "Image",
    at = "Params/Input",
    floating
)]
#[output("Image", "Image", "Colours or numbers, one a point.")]
fn image_sampler(
    context: &Context<'_>,
    /// The points; z does not matter. A number is a place along x.
    #[port("Image", "Image", optional, kind = Point)]
    points: &Tree,
) -> Result<Tree, Message> {
    if points.is_empty() {
        return Ok(Tree::empty());
    }
    let settings = context.settings();
    let channel = Channel::read(settings.str("Filter").unwrap_or_default())?;
    let blend = settings.bool("Interpolate").unwrap_or(false);
    let outside = match settings.i32("Wrap") {
        Some(0) => Outside::Clamp,
        Some(2) => Outside::Flip,
        _ => Outside::Tile,
    };
    let end = |name, default| settings.f64(name).filter(|x| x.is_finite()).unwrap_or(default);
    let (u0, u1) = (end("Umin", 0.0), end("Umax", 1.0));
    let (v0, v1) = (end("Vmin", 0.0), end("Vmax", 1.0));
    if u0 == u1 || v0 == v1 {
        return Err(Message::error("The picture covers no area: its range in x or y has no length"));
    }
    let picture = picture(context, settings)?;
    let column: &Column = points.column();
    let mut values = Gather::<Value>::with_capacity(column.len());
    for i in 0..column.len() {
        if i % 1024 == 1023 {
            context.check()?;
        }
        let place = Point3::get(column, i).filter(|p| p.is_finite());
        values.push(
            place.map(|p| {
                channel.of(picture.at((p.x - u0) / (u1 - u0), (p.y - v0) / (v1 - v0), outside, blend))
            }),
        );
    }
    Ok(points.with_column(values.finish()))
}

#[cfg(test)]
#[cfg(feature = "pictures")]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::ItemValue;
    use katydid_geometry::Point3;

    /// A PNG of 2 × 1 pixels: orange on the left, half clear blue on the right.
    fn png() -> Vec<u8> {
        let mut bytes = std::io::Cursor::new(Vec::new());
        let pixels = vec![255, 128, 0, 255, 0, 0, 255, 128];
        let picture = image::RgbaImage::from_raw(2, 1, pixels).unwrap();
        picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        bytes.into_inner()
    }

    fn sampler(filter: &str) -> Trial {
        Trial::of("Image Sampler")
            .setting("LocalImage", ItemValue::Bitmap(png()))
            .setting("Filter", filter)
            .setting("Umax", 10.0)
            .setting("Wrap", 1)
    }

    #[test]
    fn channels() {
        let points = || [Point3::new(2.0, 0.5, 7.0), Point3::new(8.0, 0.5, 0.0), Point3::new(12.0, 0.5, 0.0)];
        for (filter, wanted) in [
            ("Colour", "{0}: 255,128,0, 0,0,255 (128), 255,128,0"),
            ("Red", "{0}: 1, 0, 1"),
            ("Green", "{0}: 0.501961, 0, 0.501961"),
            ("Blue", "{0}: 0, 1, 0"),
            ("Alpha", "{0}: 1, 0.501961, 1"),
            ("Hue", "{0}: 0.083660, 0.666667, 0.083660"),
            ("Saturation", "{0}: 1, 1, 1"),
            ("Value", "{0}: 1, 1, 1"),
        ] {
            let wanted = wanted.replace("0.083660", "0.08366");
            assert_eq!(sampler(filter).list(points()).texts(0), [wanted], "{filter}");
        }
        let clamped = sampler("Red").setting("Wrap", 0).gaps([Some(Point3::new(12.0, 0.0, 0.0)), None]);
        assert_eq!(clamped.texts(0), ["{0}: 0, null"]);
        let between = sampler("Red").setting("Interpolate", true).item(Point3::new(5.0, 0.5, 0.0));
        assert_eq!(between.texts(0), ["{0}: 0.5"]);
    }

    #[test]
    fn what_is_missing_is_said() {
        let bare = || Trial::of("Image Sampler").item(Point3::ORIGIN);
        assert_eq!(bare().message(), "No picture is set");
        assert!(bare().setting("FilePath", "a.png").message().contains("may not be read here"));
        assert!(sampler("Smell").item(Point3::ORIGIN).message().contains("Smell"));
        assert!(sampler("Red").setting("Umax", 0.0).item(Point3::ORIGIN).message().contains("no area"));
        assert!(sampler("Red").texts(0).is_empty());
    }
}
