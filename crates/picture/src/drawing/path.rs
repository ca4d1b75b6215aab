//! Outlines.

/// One step of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Segment {
    /// Begins a new part.
    Move([f64; 2]),
    /// A straight line to a point.
    Line([f64; 2]),
    /// A cubic Bézier curve: two handles and its end.
    Cubic([f64; 2], [f64; 2], [f64; 2]),
    /// Back to where the part began.
    Close,
}

/// An outline of one part or more.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Path {
    /// The steps.
    pub segments: Vec<Segment>,
}

/// The handle length of a quarter circle of radius 1 (the cubic that meets the circle in the middle: 4/3·(√2 − 1)).
const QUARTER: f64 = 0.552_284_749_830_793_4;

impl Path {
    /// A line through points.
    pub fn polyline(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let mut path = Self::default();
        path.add_polyline(points);
        path
    }

    /// A closed outline through points.
    pub fn polygon(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let mut path = Self::polyline(points);
        path.segments.push(Segment::Close);
        path
    }

    /// Adds a part: a line through points.
    pub fn add_polyline(&mut self, points: impl IntoIterator<Item = [f64; 2]>) {
        for (k, p) in points.into_iter().enumerate() {
            self.segments.push(if k == 0 { Segment::Move(p) } else { Segment::Line(p) });
        }
    }

    /// A cubic Bézier curve.
    pub fn cubic([a, b, c, d]: [[f64; 2]; 4]) -> Self {
        Self { segments: vec![Segment::Move(a), Segment::Cubic(b, c, d)] }
    }

    /// A rectangle from its corner with the least coordinates, its width and height.
    pub fn rectangle([x, y, w, h]: [f64; 4]) -> Self {
        Self::polygon([[x, y], [x + w, y], [x + w, y + h], [x, y + h]])
    }

    /// A rectangle with round corners.
    pub fn rounded([x, y, w, h]: [f64; 4], radius: f64) -> Self {
        let r = radius.min(w / 2.0).min(h / 2.0).max(0.0);
        if r == 0.0 {
            return Self::rectangle([x, y, w, h]);
        }
        let k = r * (1.0 - QUARTER);
        let (right, bottom) = (x + w, y + h);
        use Segment::{Close, Cubic, Line, Move};
        Self {
            segments: vec![
                Move([x + r, y]),
                Line([right - r, y]),
                Cubic([right - k, y], [right, y + k], [right, y + r]),
                Line([right, bottom - r]),
                Cubic([right, bottom - k], [right - k, bottom], [right - r, bottom]),
                Line([x + r, bottom]),
                Cubic([x + k, bottom], [x, bottom - k], [x, bottom - r]),
                Line([x, y + r]),
                Cubic([x, y + k], [x + k, y], [x + r, y]),
                Close,
            ],
        }
    }

    /// A circle.
    pub fn circle([x, y]: [f64; 2], radius: f64) -> Self {
        Self::rounded([x - radius, y - radius, 2.0 * radius, 2.0 * radius], radius)
    }

    /// Adds the parts of another outline.
    pub fn extend(&mut self, other: Self) {
        self.segments.extend(other.segments);
    }

    /// Changes every point.
    pub fn for_each_point(&mut self, mut change: impl FnMut(&mut [f64; 2])) {
        for segment in &mut self.segments {
            match segment {
                Segment::Move(p) | Segment::Line(p) => change(p),
                Segment::Cubic(a, b, c) => [a, b, c].into_iter().for_each(&mut change),
                Segment::Close => {}
            }
        }
    }
}
