//! VoxelTools: grids of voxels filled by geometry, put together as sets, and made meshes of.
//!
//! Names, ports and ids are those of the plug-in's own published list. A cell is filled by a solid where its centre is
//! inside: that is our reading.

mod analysis;
mod boolean;
mod create;
mod fill;
#[cfg(test)]
mod tests;

use katydid_component::{Context, Message};
use katydid_data::Value;
use katydid_geometry::{Box3, Point3, Vector3};

use crate::kept::{keep, kept};

/// The most cells of a grid: one takes a byte, and each is looked at.
const MOST_CELLS: usize = 1 << 27;

/// Cells along the axes of a box; each is full or empty.
#[derive(Debug, Clone, PartialEq)]
struct Voxels {
    frame: Box3,
    /// The sides of a cell.
    size: Vector3,
    counts: [usize; 3],
    /// Along x first, then y, then z.
    cells: Vec<bool>,
}

impl Voxels {
    /// The empty grid of cells that fit whole into a box.
    ///
    /// # Errors
    /// A side of a cell is not greater than 0, no cell fits, or there are too many.
    fn new(context: &Context<'_>, frame: Box3, size: Vector3) -> Result<Self, Message> {
        /// A box that is a whole number of cells long but for rounding holds them all.
        const ROUNDING: f64 = 1e-9;
        let mut counts = [0_usize; 3];
        let sides = [(frame.x, size.x, "x"), (frame.y, size.y, "y"), (frame.z, size.z, "z")];
        for (slot, (side, step, name)) in counts.iter_mut().zip(sides) {
            if !(step > 0.0 && step.is_finite() && side.is_finite()) {
                return Err(Message::error(format!("The size of a voxel in {name} must be greater than 0")));
            }
            let count = (side.length().abs() / step + ROUNDING).floor();
            if !(count >= 1.0) {
                return Err(Message::error(format!("No voxel fits into the box in {name}")));
            }
            if count > MOST_CELLS as f64 {
                return Err(Message::error(format!("There are more than {MOST_CELLS} voxels in {name}")));
            }
            *slot = count as usize;
        }
        let total = counts.iter().fold(1_usize, |product, n| product.saturating_mul(*n));
        if total > MOST_CELLS {
            return Err(Message::error(format!("{total} voxels are more than the {MOST_CELLS} possible")));
        }
        context.bytes(total)?;
        Ok(Self { frame, size, counts, cells: vec![false; total] })
    }

    fn item(self) -> Value {
        let [x, y, z] = self.counts;
        keep(format!("VoxelGrid [{x},{y},{z}={}]", self.cells.len()), self)
    }

    /// The grid in an item.
    ///
    /// # Errors
    /// It is none.
    fn of(value: &Value) -> Result<&Self, Message> {
        kept::<Self>(value).ok_or_else(|| Message::error("This is no grid of voxels"))
    }

    fn number(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.counts[0] * (j + self.counts[1] * k)
    }

    fn place(&self, number: usize) -> [usize; 3] {
        let [x, y, _] = self.counts.map(|n| n.max(1));
        [number % x, number / x % y, number / x / y]
    }

    /// The place of coordinates counted in cells from the corner of the grid: cell (0, 0, 0) goes from 0 to 1.
    fn at(&self, [x, y, z]: [f64; 3]) -> Point3 {
        let Box3 { plane, x: a, y: b, z: c } = &self.frame;
        plane.at(a.min() + x * self.size.x, b.min() + y * self.size.y, c.min() + z * self.size.z)
    }

    fn centre(&self, place: [usize; 3]) -> Point3 {
        self.at(place.map(|i| i as f64 + 0.5))
    }

    /// Coordinates of a point, counted in cells.
    fn coordinates(&self, p: Point3) -> [f64; 3] {
        let [x, y, z] = self.frame.plane.coordinates(p);
        let Box3 { x: a, y: b, z: c, .. } = &self.frame;
        [(x - a.min()) / self.size.x, (y - b.min()) / self.size.y, (z - c.min()) / self.size.z]
    }

    /// The cell that a point is in.
    fn cell_of(&self, p: Point3) -> Option<usize> {
        let mut place = [0; 3];
        for ((slot, x), count) in place.iter_mut().zip(self.coordinates(p)).zip(self.counts) {
            if !(x >= 0.0 && x < count as f64) {
                return None;
            }
            *slot = x as usize;
        }
        Some(self.number(place))
    }

    /// Whether the cell one step away is full; `None` where the grid ends.
    fn beside(&self, place: [usize; 3], axis: usize, up: bool) -> Option<bool> {
        let mut other = place;
        let i = other.get_mut(axis)?;
        *i = if up { i.checked_add(1)? } else { i.checked_sub(1)? };
        let inside = other.iter().zip(self.counts).all(|(i, n)| *i < n);
        if inside { self.cells.get(self.number(other)).copied() } else { None }
    }

    fn full(&self) -> usize {
        self.cells.iter().filter(|full| **full).count()
    }
}
