//! Pictures as grids of colours, and where a place falls in one.

use katydid_component::Message;

/// The longest side a picture may have.
#[cfg(feature = "pictures")]
const LONGEST: u32 = 1 << 15;

/// The most bytes a picture may take: 64 million pixels of four channels.
#[cfg(feature = "pictures")]
const MOST: u64 = 1 << 28;

/// A picture: pixels row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Picture {
    width: usize,
    height: usize,
    /// Four bytes a pixel: red, green, blue and alpha.
    pixels: Vec<u8>,
}

/// Where a place outside a picture is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Outside {
    /// On its edge.
    Clamp,
    /// In copies side by side.
    Tile,
    /// In copies that are each other's mirror images.
    Flip,
}

impl Outside {
    /// The place between 0 and 1 that `x` stands for.
    fn inside(self, x: f64) -> f64 {
        match self {
            Self::Clamp => x.clamp(0.0, 1.0),
            // The far edge belongs to the picture too.
            Self::Tile if (0.0..=1.0).contains(&x) => x,
            Self::Tile => x.rem_euclid(1.0),
            Self::Flip => 1.0 - (x.rem_euclid(2.0) - 1.0).abs(),
        }
    }
}

impl Picture {
    /// Reads a PNG, JPEG, BMP or GIF file.
    ///
    /// # Errors
    /// The message to show for another kind of file, a broken one and one that is too large.
    #[cfg(feature = "pictures")]
    pub(super) fn read(bytes: &[u8]) -> Result<Self, Message> {
        let problem = |why: String| Message::error(format!("The picture cannot be read: {why}"));
        let reader = image::ImageReader::new(std::io::Cursor::new(bytes)).with_guessed_format();
        let mut reader = reader.map_err(|error| problem(error.to_string()))?;
        let mut limits = image::Limits::default();
        limits.max_image_width = Some(LONGEST);
        limits.max_image_height = Some(LONGEST);
        limits.max_alloc = Some(MOST);
        reader.limits(limits);
        let picture = reader.decode().map_err(|error| problem(error.to_string()))?.into_rgba8();
        let size = |n: u32| usize::try_from(n).unwrap_or(0);
        let (width, height) = (size(picture.width()), size(picture.height()));
        Self::new(width, height, picture.into_raw())
    }

    /// Pictures are not read without the feature `pictures`.
    #[cfg(not(feature = "pictures"))]
    pub(super) fn read(_: &[u8]) -> Result<Self, Message> {
        Err(Message::error("This program reads no pictures"))
    }

    /// A picture of these pixels, four bytes each.
    #[cfg(any(test, feature = "pictures"))]
    fn new(width: usize, height: usize, pixels: Vec<u8>) -> Result<Self, Message> {
        let size = width.checked_mul(height).and_then(|n| n.checked_mul(4));
        if pixels.is_empty() || size != Some(pixels.len()) {
            return Err(Message::error("The picture is empty"));
        }
        Ok(Self { width, height, pixels })
    }

    /// The channels a, r, g, b of the pixel in a column and row; the nearest one for those outside.
    fn pixel(&self, column: f64, row: f64) -> [f64; 4] {
        let index = |x: f64, n: usize| (x.max(0.0) as usize).min(n - 1);
        let at = 4 * (index(row, self.height) * self.width + index(column, self.width));
        match self.pixels.get(at..).and_then(<[u8]>::first_chunk) {
            Some(&[r, g, b, a]) => [a, r, g, b].map(f64::from),
            None => [0.0; 4],
        }
    }

    /// The channels a, r, g, b, each 0 to 1, at a place: x from 0 on the left to 1 on the right, y from 0 at the bottom to
    /// 1 at the top. `blend` mixes the four pixels whose centres are nearest, else it is the pixel at that place.
    pub(super) fn at(&self, x: f64, y: f64, outside: Outside, blend: bool) -> [f64; 4] {
        let (x, y) = (outside.inside(x), 1.0 - outside.inside(y));
        let (column, row) = (x * self.width as f64, y * self.height as f64);
        if !blend {
            return self.pixel(column, row).map(|c| c / 255.0);
        }
        let (column, row) = (column - 0.5, row - 0.5);
        let (left, top) = (column.floor(), row.floor());
        let (s, t) = (column - left, row - top);
        let corners = [
            (self.pixel(left, top), (1.0 - s) * (1.0 - t)),
            (self.pixel(left + 1.0, top), s * (1.0 - t)),
            (self.pixel(left, top + 1.0), (1.0 - s) * t),
            (self.pixel(left + 1.0, top + 1.0), s * t),
        ];
        let mut sum = [0.0; 4];
        for (pixel, weight) in corners {
            for (sum, channel) in sum.iter_mut().zip(pixel) {
                *sum += channel * weight / 255.0;
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_by_two() -> Picture {
        let grey = |x: u8| [x, x, x, 255];
        Picture::new(2, 2, [0, 51, 102, 255].map(grey).concat()).unwrap()
    }

    #[test]
    fn places_are_counted_from_the_lower_left() {
        let picture = two_by_two();
        let red = |x, y, blend| picture.at(x, y, Outside::Clamp, blend)[1];
        assert_eq!([red(0.0, 1.0, false), red(0.9, 0.9, false)], [0.0, 0.2]);
        assert_eq!([red(0.1, 0.1, false), red(1.0, 0.0, false)], [0.4, 1.0]);
        // The middle is the mean, the centre of a pixel is itself.
        assert!((red(0.5, 0.5, true) - 0.4).abs() < 1e-12);
        assert!((red(0.75, 0.25, true) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn outside_there_are_edges_tiles_or_mirrors() {
        let inside = |x: f64| [Outside::Clamp, Outside::Tile, Outside::Flip].map(|o| o.inside(x));
        assert_eq!(inside(1.25), [1.0, 0.25, 0.75]);
        assert_eq!(inside(-0.25), [0.0, 0.75, 0.25]);
        assert_eq!(inside(1.0), [1.0, 1.0, 1.0]);
        assert_eq!(inside(0.0), [0.0, 0.0, 0.0]);
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        assert!(Picture::read(b"not a picture").is_err());
        assert!(Picture::read(&[]).is_err());
        assert!(Picture::new(0, 0, Vec::new()).is_err());
        assert!(Picture::new(2, 2, vec![0; 15]).is_err());
    }
}
