//! Volumes: signed distances at the points of a grid.

use katydid_component::{Context, Message};
use katydid_data::Value;
use katydid_geometry::isosurface::{Isosurfacing, ScalarGrid};
use katydid_geometry::{BoundingBox, Mesh, Point3, Vector3};

use crate::kept::{keep, kept};

/// The most points of a grid: each takes eight bytes, and is looked at by every step.
const MOST_POINTS: usize = 1 << 25;
/// The most faces of a mesh.
const MOST_FACES: usize = 20_000_000;
/// How far points of a grid may lie beside multiples of the voxel for the next one to be taken, in voxels: rounding.
const ROUNDING: f64 = 1e-9;

/// Signed distances at points that stand at multiples of the voxel, so that two volumes of one voxel share their points.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Volume {
    pub(super) voxel: f64,
    /// The first point, in voxels.
    pub(super) first: [i64; 3],
    pub(super) counts: [usize; 3],
    /// Along x first, then y, then z; negative inside, and no farther from 0 than the band.
    pub(super) distances: Vec<f64>,
    /// The distance from which on nothing is known.
    pub(super) band: f64,
}

impl Volume {
    /// A volume over a box, far outside everywhere.
    ///
    /// # Errors
    /// The box is not finite, or has too many points.
    pub(super) fn outside(
        context: &Context<'_>,
        bounds: &BoundingBox,
        voxel: f64,
        band: f64,
    ) -> Result<Self, Message> {
        /// Multiples beyond are not told apart by numbers of 64 bits.
        const FARTHEST: f64 = 1e15;
        let (mut first, mut counts) = ([0_i64; 3], [0_usize; 3]);
        let low = [bounds.min.x, bounds.min.y, bounds.min.z];
        let high = [bounds.max.x, bounds.max.y, bounds.max.z];
        for axis in 0..3 {
            let (from, to) = ((low[axis] / voxel + ROUNDING).floor(), (high[axis] / voxel - ROUNDING).ceil());
            if !(from.abs() < FARTHEST && to.abs() < FARTHEST) {
                return Err(Message::error("The geometry lies too far away for voxels of this size"));
            }
            let count = to - from + 1.0;
            if count > MOST_POINTS as f64 {
                return Err(too_many());
            }
            first[axis] = from as i64;
            counts[axis] = count.max(2.0) as usize;
        }
        Self::filled(context, voxel, first, counts, band)
    }

    /// A volume of so many points, far outside everywhere.
    ///
    /// # Errors
    /// There are too many.
    pub(super) fn filled(
        context: &Context<'_>,
        voxel: f64,
        first: [i64; 3],
        counts: [usize; 3],
        band: f64,
    ) -> Result<Self, Message> {
        let total = counts.iter().fold(1_usize, |product, n| product.saturating_mul(*n));
        if total > MOST_POINTS {
            return Err(too_many());
        }
        context.bytes(total.saturating_mul(8))?;
        Ok(Self { voxel, first, counts, distances: vec![band; total], band })
    }

    pub(super) fn of(value: &Value) -> Result<&Self, Message> {
        kept::<Self>(value).ok_or_else(|| Message::error("This is no volume"))
    }

    pub(super) fn item(self) -> Value {
        let [x, y, z] = self.counts;
        keep(format!("Volume ({x} x {y} x {z} points, voxel {})", self.voxel), self)
    }

    pub(super) fn point(&self, [i, j, k]: [usize; 3]) -> Point3 {
        let along = |axis: usize, n: usize| (self.first[axis] as f64 + n as f64) * self.voxel;
        Point3::new(along(0, i), along(1, j), along(2, k))
    }

    pub(super) fn number(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.counts[0] * (j + self.counts[1] * k)
    }

    /// Gives every point its distance, row by row.
    ///
    /// # Errors
    /// That of `row`, and when the work shall stop.
    pub(super) fn fill(
        &mut self,
        context: &Context<'_>,
        mut row: impl FnMut(&Self, [usize; 2], &mut [f64]) -> Result<(), Message>,
    ) -> Result<(), Message> {
        let [width, rows, layers] = self.counts;
        let mut line = vec![self.band; width];
        for k in 0..layers {
            for j in 0..rows {
                context.check()?;
                let start = self.number([0, j, k]);
                let Some(old) = self.distances.get(start..start + width) else { continue };
                line.copy_from_slice(old);
                row(self, [j, k], &mut line)?;
                for distance in &mut line {
                    *distance =
                        if distance.is_nan() { self.band } else { distance.clamp(-self.band, self.band) };
                }
                if let Some(old) = self.distances.get_mut(start..start + width) {
                    old.copy_from_slice(&line);
                }
            }
        }
        Ok(())
    }

    /// The distance at a point of the common grid, far outside where this has none.
    pub(super) fn at(&self, place: [i64; 3]) -> f64 {
        let mut inside = [0_usize; 3];
        for axis in 0..3 {
            match usize::try_from(place[axis] - self.first[axis]) {
                Ok(n) if n < self.counts[axis] => inside[axis] = n,
                _ => return self.band,
            }
        }
        self.distances.get(self.number(inside)).copied().unwrap_or(self.band)
    }

    /// The surface at a distance, outwards positive.
    ///
    /// # Errors
    /// The distance is not inside the band, or there are too many faces.
    pub(super) fn mesh(&self, level: f64) -> Result<Mesh, Message> {
        if level.abs() >= self.band {
            return Err(Message::error(format!(
                "The isovalue {level} is not within the band of {}: make the bandwidth larger",
                self.band
            )));
        }
        let step = Vector3::new(self.voxel, self.voxel, self.voxel);
        let grid = ScalarGrid::new(self.point([0, 0, 0]), step, self.counts)?;
        let heights: Vec<f64> = self.distances.iter().map(|d| -d).collect();
        let how = Isosurfacing { level: -level, closed: true, most_faces: MOST_FACES };
        Ok(grid.isosurface(&heights, &how)?)
    }
}

fn too_many() -> Message {
    Message::error(format!("More than {MOST_POINTS} voxels are needed: make the voxel size larger"))
}
