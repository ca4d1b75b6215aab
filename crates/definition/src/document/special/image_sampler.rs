use katydid_geometry::Interval;

use crate::archive::Chunk;

/// An Image Sampler.
#[derive(Debug, Clone, PartialEq)]
pub struct ImageSampler {
    /// The picture's file.
    pub file: String,
    /// The picture in the document, PNG as a rule.
    pub image: Option<Vec<u8>>,
    /// Whether the picture in the document is the one that counts.
    pub saved_in_file: bool,
    /// The range of x over the picture.
    pub u: Interval,
    /// The range of y over the picture, upwards.
    pub v: Interval,
    /// What is sampled: `Colour`, `Value`, `Red` and so on.
    pub filter: String,
    /// Whether pixels are blended.
    pub interpolate: bool,
    /// What happens outside the picture.
    pub wrap: Wrap,
}

/// What an Image Sampler does outside the picture, by the number in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Wrap(pub i32);

impl ImageSampler {
    pub(super) fn read(c: &Chunk) -> Self {
        let n = |name, default| c.f64(name).unwrap_or(default);
        let path = c.str("FilePath").filter(|path| !path.is_empty()).or_else(|| c.str("ImagePath"));
        Self {
            file: path.unwrap_or_default().to_owned(),
            image: c.bytes("LocalImage").map(<[u8]>::to_vec),
            saved_in_file: c.bool("SaveInFile").unwrap_or(false),
            u: Interval::new(n("Umin", 0.0), n("Umax", 1.0)),
            v: Interval::new(n("Vmin", 0.0), n("Vmax", 1.0)),
            filter: c.str("Filter").unwrap_or("Colour").to_owned(),
            interpolate: c.bool("Interpolate").unwrap_or(false),
            wrap: Wrap(c.i32("Wrap").unwrap_or(0)),
        }
    }
}
