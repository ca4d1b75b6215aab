use super::ScalarGrid;
use super::pattern::{Patterns, ends, number};
use crate::{Error, Mesh, MeshFace, Point3, Result, Vector3};

/// No corner of the surface lies nearer to a corner of the grid than this part of an edge, so that no face is without
/// area: where the grid itself has the height, the surface is that much off.
pub const NEAREST_TO_CORNER: f64 = 1.0 / 4096.0;

/// Not made yet.
const NONE: u32 = u32::MAX;
/// Beyond a closed border all is as low as can be.
const LOWEST: f64 = -f64::MAX;

/// How a surface of equal height is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Isosurfacing {
    /// The height. What is as high counts as high, and lies behind the faces.
    pub level: f64,
    /// Whether all beyond the grid counts as low, so that the mesh is closed; its caps lie [`NEAREST_TO_CORNER`] of a
    /// cell outside. Otherwise it is open where the grid ends in what is high.
    pub closed: bool,
    /// The most faces it may have.
    pub most_faces: usize,
}

/// The corners of the surface on the edges that start in one layer of the grid.
#[derive(Default)]
struct Crossings {
    x: Vec<u32>,
    y: Vec<u32>,
    z: Vec<u32>,
}

/// One layer of the grid with its border, and what is known of it.
#[derive(Default)]
struct Layer {
    heights: Vec<f64>,
    crossings: Crossings,
}

struct March<'a> {
    grid: &'a ScalarGrid,
    how: Isosurfacing,
    /// How wide the border is: 1 where it is closed.
    border: usize,
    columns: usize,
    rows: usize,
    patterns: Patterns,
    vertices: Vec<Point3>,
    faces: Vec<MeshFace>,
}

impl Isosurfacing {
    /// The surface at a level, closed, with up to 2³⁰ faces.
    pub fn closed_at(level: f64) -> Self {
        Self { level, closed: true, most_faces: 1 << 30 }
    }

    /// The surface at a level, open where the grid ends in what is high, with up to 2³⁰ faces.
    pub fn open_at(level: f64) -> Self {
        Self { closed: false, ..Self::closed_at(level) }
    }

    /// The mesh through the cells of a grid. `fill` writes the numbers of layer k, x fastest, in order of k; no more
    /// than two layers are kept. An error of it ends the work and is handed on, and so it can stop the work.
    ///
    /// The mesh is manifold and oriented with its faces to the low side, and closed if that is asked for. Corners lie
    /// where the height is reached by linear interpolation along edges of the grid, but see [`NEAREST_TO_CORNER`]. It
    /// takes time in proportion to the grid, and memory to two layers and the mesh.
    ///
    /// # Errors
    /// The level or a number is not finite, there are more faces than may be, or `fill` fails.
    pub fn mesh(
        &self,
        grid: &ScalarGrid,
        mut fill: impl FnMut(usize, &mut [f64]) -> Result<()>,
    ) -> Result<Mesh> {
        if !self.level.is_finite() {
            return Err(Error::NotFinite("height of a surface"));
        }
        let [nx, ny, nz] = grid.counts();
        if nx.min(ny).min(nz) == 0 {
            return Ok(Mesh::default());
        }
        let border = usize::from(self.closed);
        let mut march = March {
            grid,
            how: *self,
            border,
            columns: nx + 2 * border,
            rows: ny + 2 * border,
            patterns: Patterns::new(),
            vertices: Vec::new(),
            faces: Vec::new(),
        };
        let mut numbers = vec![0.0; nx * ny];
        let (mut below, mut above) = (march.layer(), march.layer());
        for k in 0..nz + 2 * border {
            std::mem::swap(&mut below, &mut above);
            let own = k.checked_sub(border).filter(|own| *own < nz);
            if let Some(own) = own {
                fill(own, &mut numbers)?;
            }
            march.lay(own.map(|_| numbers.as_slice()), &mut above)?;
            if k > 0 {
                march.slab(k - 1, &mut below, &mut above)?;
            }
        }
        Mesh::new(march.vertices, march.faces)
    }
}

impl March<'_> {
    fn layer(&self) -> Layer {
        let n = self.columns * self.rows;
        let crossings = Crossings { x: vec![NONE; n], y: vec![NONE; n], z: vec![NONE; n] };
        Layer { heights: vec![LOWEST; n], crossings }
    }

    /// Puts numbers into a layer, as heights over the level; without numbers all is low.
    fn lay(&self, numbers: Option<&[f64]>, layer: &mut Layer) -> Result<()> {
        let Crossings { x, y, z } = &mut layer.crossings;
        [x, y, z].into_iter().for_each(|list| list.fill(NONE));
        let Some(numbers) = numbers else {
            layer.heights.fill(LOWEST);
            return Ok(());
        };
        let (border, width) = (self.border, self.columns - 2 * self.border);
        let rows = layer.heights.chunks_mut(self.columns).skip(border);
        for (row, own) in rows.zip(numbers.chunks(width)) {
            let mut sum = 0.0;
            for (height, value) in row.iter_mut().skip(border).zip(own) {
                *height = (value - self.how.level).clamp(LOWEST, f64::MAX);
                // Stays 0 as long as all are finite.
                sum += value * 0.0;
            }
            if sum != 0.0 {
                return Err(Error::NotFinite("number of a grid in space"));
            }
        }
        Ok(())
    }

    /// The cells between two layers.
    fn slab(&mut self, k: usize, below: &mut Layer, above: &mut Layer) -> Result<()> {
        for j in 0..self.rows - 1 {
            let start = j * self.columns;
            let high = |layer: &Layer, i: usize| layer.heights.get(i).is_some_and(|h| *h >= 0.0);
            // The corners at x = 0 of a cell have even bits.
            let column = |i: usize| {
                usize::from(high(below, start + i))
                    | usize::from(high(below, start + self.columns + i)) << 2
                    | usize::from(high(above, start + i)) << 4
                    | usize::from(high(above, start + self.columns + i)) << 6
            };
            let mut left = column(0);
            let mut crossed: Vec<(usize, usize)> = Vec::new();
            for i in 0..self.columns - 1 {
                let right = column(i + 1);
                let corners = left | right << 1;
                left = right;
                if corners != 0 && corners != 255 {
                    crossed.push((i, corners));
                }
            }
            for (i, corners) in crossed {
                self.cell([i, j, k], corners, below, above)?;
            }
        }
        Ok(())
    }

    fn cell(&mut self, cell: [usize; 3], high: usize, below: &mut Layer, above: &mut Layer) -> Result<()> {
        let place = |corner: usize| (cell[1] + (corner >> 1 & 1)) * self.columns + cell[0] + (corner & 1);
        let heights: [f64; 8] = std::array::from_fn(|c| {
            let layer = if c < 4 { &*below } else { &*above };
            layer.heights.get(place(c)).copied().unwrap_or(LOWEST)
        });
        let Some(pattern) = self.patterns.get(number(high, &heights)) else { return Ok(()) };
        if self.faces.len() + pattern.triangles.len() > self.how.most_faces {
            let why = format!("the surface takes more than {} faces", self.how.most_faces);
            return Err(Error::Invalid { what: "grid in space", why });
        }
        let mut made = [NONE; 16];
        let (vertices, grid, border) = (&mut self.vertices, self.grid, self.border as f64);
        let mut corner_on = |edge: u8| -> u32 {
            let [from, to] = ends(edge);
            let layer = if from < 4 { &mut *below } else { &mut *above };
            let list = match edge / 4 {
                0 => &mut layer.crossings.x,
                1 => &mut layer.crossings.y,
                _ => &mut layer.crossings.z,
            };
            let Some(slot) = list.get_mut(place(from)) else { return NONE };
            if *slot == NONE {
                // Halved, so that the largest numbers have a finite difference.
                let [a, b] = [0.5 * heights[from], 0.5 * heights[to]];
                let t = a / (a - b);
                let t = t.clamp(NEAREST_TO_CORNER, 1.0 - NEAREST_TO_CORNER);
                let mut at: [f64; 3] = std::array::from_fn(|c| (cell[c] + (from >> c & 1)) as f64 - border);
                at[usize::from(edge / 4)] += t;
                *slot = vertices.len() as u32;
                vertices.push(grid.point(at));
            }
            *slot
        };
        for &corner in pattern.triangles.iter().flatten().filter(|c| **c < 12) {
            if made[usize::from(corner)] == NONE {
                made[usize::from(corner)] = corner_on(corner);
            }
        }
        let around = made;
        for (ring, slot) in pattern.middles.iter().zip(made.iter_mut().skip(12)) {
            let place = |v: u32| self.vertices.get(v as usize).map_or(Vector3::ZERO, |p| p.to_vector());
            let sum: Vector3 = ring.iter().map(|&e| place(around[usize::from(e & 15)])).sum();
            *slot = self.vertices.len() as u32;
            self.vertices.push((sum / ring.len() as f64).to_point());
        }
        self.faces.extend(
            pattern.triangles.iter().map(|t| MeshFace::Triangle(t.map(|c| made[usize::from(c & 15)]))),
        );
        Ok(())
    }
}
