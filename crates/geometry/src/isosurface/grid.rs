use super::march::Isosurfacing;
use crate::{Error, Mesh, Point3, Result, Vector3};

/// The most numbers in one layer of a grid.
const MOST_IN_LAYER: usize = 1 << 26;
/// The most layers of a grid.
const MOST_LAYERS: usize = 1 << 30;
/// Cells are at least this part of the largest coordinate, so that crossings of their edges can be told apart.
const LEAST_CELL: f64 = 1e-11;

/// Where the numbers of a grid in space stand: along the axes, at equal distances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScalarGrid {
    origin: Point3,
    step: Vector3,
    counts: [usize; 3],
}

impl ScalarGrid {
    /// The grid from an origin with a distance along each axis, and how many numbers stand along each.
    ///
    /// # Errors
    /// The origin is not finite, a distance is not greater than 0 or too small beside the coordinates (1e-11 of the
    /// largest), a layer has more than 2²⁶ numbers, or there are more than 2³⁰ layers.
    pub fn new(origin: Point3, step: Vector3, counts: [usize; 3]) -> Result<Self> {
        let [nx, ny, nz] = counts;
        if nx.saturating_mul(ny) > MOST_IN_LAYER || nx.max(ny) > MOST_IN_LAYER || nz > MOST_LAYERS {
            let why = format!("{nx} × {ny} × {nz} numbers are too many");
            return Err(Error::Invalid { what: "grid in space", why });
        }
        let grid = Self { origin, step, counts };
        let far = grid.point([nx, ny, nz].map(|n| n as f64));
        if !origin.is_finite() || !far.is_finite() {
            return Err(Error::NotFinite("grid in space"));
        }
        let size = [origin, far].iter().flat_map(|p| [p.x, p.y, p.z]).fold(0.0_f64, |a, b| a.max(b.abs()));
        for value in [step.x, step.y, step.z] {
            if !(value > 0.0 && value >= LEAST_CELL * size) {
                let must = "greater than 0, and not too small beside the coordinates";
                return Err(Error::OutOfRange { what: "distance of a grid", value, must });
            }
        }
        Ok(grid)
    }

    /// How many numbers stand along x, y and z.
    pub fn counts(&self) -> [usize; 3] {
        self.counts
    }

    /// The distances between numbers along x, y and z.
    pub fn step(&self) -> Vector3 {
        self.step
    }

    /// The place at a number of steps along each axis.
    #[inline]
    pub fn point(&self, [i, j, k]: [f64; 3]) -> Point3 {
        let Self { origin, step, .. } = self;
        Point3::new(origin.x + step.x * i, origin.y + step.y * j, origin.z + step.z * k)
    }

    /// The surface of numbers, x fastest, then y, then z.
    ///
    /// # Errors
    /// As [`Isosurfacing::mesh`], and when there is another count of numbers than the grid has.
    pub fn isosurface(&self, values: &[f64], how: &Isosurfacing) -> Result<Mesh> {
        let [nx, ny, nz] = self.counts;
        if (nx * ny).checked_mul(nz) != Some(values.len()) {
            let why = format!("{} numbers for {nx} × {ny} × {nz}", values.len());
            return Err(Error::Invalid { what: "grid in space", why });
        }
        how.mesh(self, |k, layer| {
            if let Some(own) = values.get(k * nx * ny..(k + 1) * nx * ny) {
                layer.copy_from_slice(own);
            }
            Ok(())
        })
    }

    /// The surface of a function of the place.
    ///
    /// # Errors
    /// As [`Isosurfacing::mesh`].
    pub fn isosurface_of(&self, height: impl Fn(Point3) -> f64, how: &Isosurfacing) -> Result<Mesh> {
        let nx = self.counts[0].max(1);
        how.mesh(self, |k, layer| {
            for (j, row) in layer.chunks_mut(nx).enumerate() {
                for (i, value) in row.iter_mut().enumerate() {
                    *value = height(self.point([i as f64, j as f64, k as f64]));
                }
            }
            Ok(())
        })
    }
}
