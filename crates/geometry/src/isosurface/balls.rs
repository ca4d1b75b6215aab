use super::{Isosurfacing, ScalarGrid};
use crate::box_tree::{Bounds, BoxTree};
use crate::{Error, Mesh, Point3, Result, Vector3};

/// A ball that melts together with others: its field is strength·(1 − d²/radius²)³ at distance d from its middle, and 0
/// beyond its radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metaball {
    /// The middle.
    pub center: Point3,
    /// How far its field reaches.
    pub radius: f64,
    /// Its field in the middle; a negative one eats away from others.
    pub strength: f64,
}

/// The field of many metaballs: the sum of theirs.
///
/// After G. Wyvill, C. McPheeters and B. Wyvill, *Data structure for soft objects*, 1986, whose field also ends at a
/// radius; the power is that of later work by B. Wyvill. The field is twice differentiable.
#[derive(Debug, Clone)]
pub struct MetaballField {
    /// By the lowest height that they reach.
    balls: Vec<Metaball>,
    tree: BoxTree,
}

impl Metaball {
    #[inline]
    fn bounds(&self) -> Bounds {
        let c = [self.center.x, self.center.y, self.center.z];
        [c.map(|x| x - self.radius), c.map(|x| x + self.radius)]
    }

    #[inline]
    fn bottom(&self) -> f64 {
        self.center.z - self.radius
    }

    /// Its field where the squared distance over the squared radius is `share`.
    #[inline]
    fn at_share(&self, share: f64) -> f64 {
        let rest = (1.0 - share).max(0.0);
        self.strength * rest * rest * rest
    }
}

impl MetaballField {
    /// The field of balls.
    ///
    /// # Errors
    /// A number is not finite, or a radius not greater than 0.
    pub fn new(balls: &[Metaball]) -> Result<Self> {
        for b in balls {
            if !(b.center.is_finite() && b.strength.is_finite()) {
                return Err(Error::NotFinite("metaball"));
            }
            let square = b.radius * b.radius;
            if !(b.radius > 0.0
                && square.is_normal()
                && b.bounds().as_flattened().iter().all(|x| x.is_finite()))
            {
                let must = "finite and greater than 0";
                return Err(Error::OutOfRange { what: "radius of a metaball", value: b.radius, must });
            }
        }
        let mut balls = balls.to_vec();
        balls.sort_by(|a, b| a.bottom().total_cmp(&b.bottom()));
        let boxes: Vec<Bounds> = balls.iter().map(Metaball::bounds).collect();
        Ok(Self { tree: BoxTree::by_place(&boxes), balls })
    }

    /// The strength of the field at a place.
    pub fn at(&self, p: Point3) -> f64 {
        let mut sum = 0.0;
        // Only boxes that hold the place have a distance of 0.
        self.tree.visit_near(&[p.x, p.y, p.z], f64::MIN_POSITIVE, |i| {
            if let Some(b) = self.balls.get(i) {
                sum += b.at_share((p - b.center).length_squared() / (b.radius * b.radius));
            }
            f64::MIN_POSITIVE
        });
        sum
    }

    /// The grid of cubes of a given size that holds all balls; `None` without balls.
    ///
    /// # Errors
    /// As [`ScalarGrid::new`].
    pub fn grid(&self, cell: f64) -> Result<Option<ScalarGrid>> {
        if !(cell > 0.0 && cell.is_finite()) {
            let must = "finite and greater than 0";
            return Err(Error::OutOfRange { what: "size of a cell", value: cell, must });
        }
        let mut all = self.balls.iter().map(Metaball::bounds);
        let Some(first) = all.next() else { return Ok(None) };
        let [low, high] = all.fold(first, |a, b| {
            [std::array::from_fn(|c| a[0][c].min(b[0][c])), std::array::from_fn(|c| a[1][c].max(b[1][c]))]
        });
        // A half cell to spare, so that a ball's border is not on the grid's.
        let count = |c: usize| ((high[c] - low[c]) / cell).ceil().clamp(0.0, 1e18) as usize + 2;
        let origin = Point3::new(low[0] - 0.5 * cell, low[1] - 0.5 * cell, low[2] - 0.5 * cell);
        ScalarGrid::new(origin, Vector3::new(cell, cell, cell), [0, 1, 2].map(count)).map(Some)
    }

    /// The closed surface where the field has a given strength, by cells of a given size; what is smaller than a cell
    /// may be missed. It takes time in proportion to the cells of the box around all balls, and to the places of the
    /// grid within each ball; `most_faces` bounds the mesh. `go_on` is asked at each layer of cells.
    ///
    /// # Errors
    /// The level is not finite and greater than 0, the size is not finite and greater than 0 or too small for the box
    /// around all balls (see [`ScalarGrid::new`]), there are more faces than may be, or `go_on` says no.
    pub fn mesh(
        &self,
        level: f64,
        cell: f64,
        most_faces: usize,
        mut go_on: impl FnMut() -> bool,
    ) -> Result<Mesh> {
        if !(level > 0.0 && level.is_finite()) {
            let must = "finite and greater than 0";
            return Err(Error::OutOfRange { what: "strength along a surface", value: level, must });
        }
        let Some(grid) = self.grid(cell)? else { return Ok(Mesh::default()) };
        let how = Isosurfacing { level, closed: true, most_faces };
        // Balls come in by their lowest points and go out by their highest.
        let (mut active, mut coming): (Vec<Metaball>, usize) = (Vec::new(), 0);
        how.mesh(&grid, |k, layer| {
            if !go_on() {
                return Err(Error::Stopped);
            }
            let z = grid.point([0.0, 0.0, k as f64]).z;
            active.retain(|b| b.center.z + b.radius > z);
            while let Some(b) = self.balls.get(coming).filter(|b| b.bottom() < z) {
                active.push(*b);
                coming += 1;
            }
            layer.fill(0.0);
            active.iter().for_each(|b| splat(b, &grid, z, layer));
            Ok(())
        })
    }
}

/// Adds the field of a ball to a layer.
fn splat(b: &Metaball, grid: &ScalarGrid, z: f64, layer: &mut [f64]) {
    let [nx, ny, _] = grid.counts();
    let (origin, step) = (grid.point([0.0; 3]), grid.step());
    let square = b.radius * b.radius;
    let dz = z - b.center.z;
    let left = square - dz * dz;
    if !(left > 0.0) {
        return;
    }
    // The whole numbers of steps within a half width of a middle.
    let range = |middle: f64, half: f64, start: f64, step: f64, count: usize| {
        let from = ((middle - half - start) / step).ceil().max(0.0) as usize;
        let to = ((middle + half - start) / step).floor() + 1.0;
        from..(to.max(0.0) as usize).min(count)
    };
    for j in range(b.center.y, left.sqrt(), origin.y, step.y, ny) {
        let dy = origin.y + step.y * j as f64 - b.center.y;
        let rest = left - dy * dy;
        let columns = range(b.center.x, rest.max(0.0).sqrt(), origin.x, step.x, nx);
        let start = columns.start;
        let Some(row) = layer.get_mut(j * nx + start..j * nx + columns.end.max(start)) else { continue };
        for (i, value) in row.iter_mut().enumerate() {
            let dx = origin.x + step.x * (start + i) as f64 - b.center.x;
            *value += b.at_share((dx * dx + dy * dy + dz * dz) / square);
        }
    }
}
