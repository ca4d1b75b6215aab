//! Faces and lines with a depth: what lies nearer hides what lies behind.

use katydid_data::Colour;

/// Faces and lines in the space of the picture: x and y in pixels, depth growing towards the viewer. The projection
/// keeps planes plane and lines straight, so that depth can be interpolated on the picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Solids {
    /// The faces.
    pub faces: Vec<Face>,
    /// The lines.
    pub lines: Vec<SpaceLine>,
}

/// A corner of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// x, y, depth.
    pub at: [f64; 3],
    /// The colour there, light included.
    pub colour: Colour,
}

/// A convex, flat face.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// Its corners in order.
    pub corners: Vec<Corner>,
    /// Whether it is a sign rather than a part of the model, such as the head of an arrow: it faces the viewer.
    pub sign: bool,
}

/// A line through space.
#[derive(Debug, Clone, PartialEq)]
pub struct SpaceLine {
    /// The points: x, y, depth.
    pub points: Vec<[f64; 3]>,
    /// The colour; lines let nothing through.
    pub colour: Colour,
    /// The width in pixels.
    pub width: f64,
}

impl Face {
    /// The colour in the middle.
    pub fn colour(&self) -> Colour {
        let n = self.corners.len().max(1) as f64;
        let mean = |channel: fn(&Colour) -> u8| {
            let sum: f64 = self.corners.iter().map(|corner| f64::from(channel(&corner.colour))).sum();
            super::channel(sum / n)
        };
        Colour { a: mean(|c| c.a), r: mean(|c| c.r), g: mean(|c| c.g), b: mean(|c| c.b) }
    }

    /// The depth in the middle.
    pub fn depth(&self) -> f64 {
        self.corners.iter().map(|corner| corner.at[2]).sum::<f64>() / self.corners.len().max(1) as f64
    }

    /// Whether nothing shines through it.
    pub fn is_opaque(&self) -> bool {
        self.corners.iter().all(|corner| corner.colour.a == 255)
    }
}

impl Solids {
    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty() && self.lines.is_empty()
    }

    pub(super) fn transform(&mut self, factor: f64, by: [f64; 2]) {
        let place = |p: &mut [f64; 3]| {
            *p = [p[0] * factor + by[0], p[1] * factor + by[1], p[2] * factor];
        };
        for corner in self.faces.iter_mut().flat_map(|face| &mut face.corners) {
            place(&mut corner.at);
        }
        for line in &mut self.lines {
            line.width *= factor;
            line.points.iter_mut().for_each(place);
        }
    }
}
