//! One table of vertices for all operands: points within the tolerance of each other are one.

use std::collections::HashMap;

use crate::{Point3, Vector3};

/// How wide a cell is, in tolerances: what is within the tolerance of a point lies mostly in the point's own cell.
const CELL: f64 = 8.0;

/// Points by the cells of a grid some tolerances wide.
#[derive(Debug)]
pub(super) struct Vertices {
    points: Vec<Point3>,
    /// The largest distance of a point that became the vertex.
    moved: Vec<f64>,
    cells: HashMap<[i64; 3], Vec<usize>>,
    near: f64,
}

impl Vertices {
    /// An empty table; points nearer than `near` are one.
    pub(super) fn new(near: f64) -> Self {
        Self { points: Vec::new(), moved: Vec::new(), cells: HashMap::new(), near }
    }

    /// The vertex at a point: the nearest known one within the tolerance, else a new one.
    pub(super) fn at(&mut self, p: Point3) -> usize {
        if let Some(known) = self.known(p) {
            let distance = self.point(known).distance_to(p);
            self.moved.get_mut(known).into_iter().for_each(|m| *m = m.max(distance));
            return known;
        }
        let place = self.points.len();
        self.points.push(p);
        self.moved.push(0.0);
        self.cells.entry(self.cell(p)).or_default().push(place);
        place
    }

    /// The known vertex nearest to a point, within the tolerance.
    pub(super) fn known(&self, p: Point3) -> Option<usize> {
        let reach = Vector3::new(self.near, self.near, self.near);
        let [low, high] = [self.cell(p - reach), self.cell(p + reach)];
        let mut best: Option<(f64, usize)> = None;
        // Mostly one cell, eight at a corner.
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    for &place in self.cells.get(&[x, y, z]).map_or(&[] as &[usize], Vec::as_slice) {
                        let distance = self.point(place).distance_to(p);
                        if distance <= self.near && best.is_none_or(|b| (distance, place) < b) {
                            best = Some((distance, place));
                        }
                    }
                }
            }
        }
        best.map(|b| b.1)
    }

    /// Where a vertex is.
    pub(super) fn point(&self, place: usize) -> Point3 {
        self.points.get(place).copied().unwrap_or(Point3::ORIGIN)
    }

    /// The vertices with the largest distance of a point that became each.
    pub(super) fn moved(&self) -> impl Iterator<Item = (Point3, f64)> + '_ {
        self.points.iter().copied().zip(self.moved.iter().copied())
    }

    /// All points, by the places of their vertices.
    pub(super) fn points(&self) -> &[Point3] {
        &self.points
    }

    #[allow(clippy::cast_possible_truncation, reason = "far away points share the last cell")]
    fn cell(&self, p: Point3) -> [i64; 3] {
        // Coordinates are finite; saturation far away only makes searches slower.
        let width = CELL * self.near;
        [p.x, p.y, p.z].map(|x| ((x / width).floor() as i64).clamp(-(1 << 60), 1 << 60))
    }
}
