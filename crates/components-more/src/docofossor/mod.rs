//! Docofossor: terrains as grids of heights, cut and filled by points, paths, areas and surfaces.
//!
//! A grid travels as one list of numbers, as the plug-in's documentation tells: the numbers of columns and rows, the origin,
//! the sides of a cell, two places that are free, the origin in the world, then the heights, column by column from the
//! lower left corner. That a column's heights follow each other, and the exact shapes of cuts, are our reading.

mod absolute;
mod analysis;
mod grid;
mod io;
mod path;
mod relative;
#[cfg(test)]
mod tests;

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message};
use katydid_geometry::{Mesh, MeshFace, Point3};

/// How many numbers stand before the heights.
const HEAD: usize = 10;
/// The most heights of a grid.
const MOST_HEIGHTS: usize = 50_000_000;
/// The slope of cuts and fills where nothing is given, in degrees: what the plug-in's documentation says.
const SLOPE: f64 = 33.0;

/// Heights over a grid of columns and rows.
#[derive(Debug, Clone, PartialEq)]
struct Terrain {
    columns: usize,
    rows: usize,
    /// The lower left corner, in the model.
    origin: [f64; 2],
    /// The sides of a cell.
    cell: [f64; 2],
    /// The lower left corner in the world.
    world: [f64; 2],
    heights: Vec<f64>,
}

impl Terrain {
    /// A grid at one height.
    ///
    /// # Errors
    /// There are no columns or rows or too many, or a cell has no size.
    fn flat(
        context: &Context<'_>,
        columns: usize,
        rows: usize,
        origin: [f64; 2],
        cell: [f64; 2],
    ) -> Result<Self, Message> {
        let count = columns.saturating_mul(rows);
        if count == 0 || count > MOST_HEIGHTS {
            return Err(Message::error(format!("{columns} columns of {rows} heights are not possible")));
        }
        if !cell.iter().all(|c| *c > 0.0 && c.is_finite()) || !origin.iter().all(|x| x.is_finite()) {
            return Err(Message::error("The sides of a cell must be greater than 0"));
        }
        context.items(count)?;
        Ok(Self { columns, rows, origin, cell, world: origin, heights: vec![0.0; count] })
    }

    /// The grid in a list of numbers.
    ///
    /// # Errors
    /// The list is none.
    fn of(context: &Context<'_>, list: &List<'_, f64>) -> Result<Self, Message> {
        let number = |i: usize| list.get(i).filter(|x| x.is_finite());
        let head = |i: usize| number(i).ok_or_else(|| Message::error("This list is no terrain grid"));
        let count = |i: usize| -> Result<usize, Message> {
            let x = head(i)?;
            if x >= 1.0 && x <= MOST_HEIGHTS as f64 {
                Ok(x as usize)
            } else {
                Err(Message::error("This list is no terrain grid: it has no columns or no rows"))
            }
        };
        let mut terrain =
            Self::flat(context, count(0)?, count(1)?, [head(2)?, head(3)?], [head(4)?, head(5)?])?;
        if let (Some(x), Some(y)) = (number(8), number(9)) {
            terrain.world = [x, y];
        }
        let needed = terrain.heights.len();
        if list.len() != HEAD + needed {
            let found = list.len().saturating_sub(HEAD);
            let text =
                format!("The grid has {needed} places and {found} heights: this list is no terrain grid");
            return Err(Message::error(text));
        }
        for (i, height) in terrain.heights.iter_mut().enumerate() {
            *height = number(HEAD + i)
                .ok_or_else(|| Message::error(format!("Height {i} of the grid is missing or not finite")))?;
        }
        Ok(terrain)
    }

    fn list(&self) -> Vec<f64> {
        let [ox, oy] = self.origin;
        let [cx, cy] = self.cell;
        let [gx, gy] = self.world;
        let mut list = vec![self.columns as f64, self.rows as f64, ox, oy, cx, cy, 0.0, 0.0, gx, gy];
        list.extend_from_slice(&self.heights);
        list
    }

    /// Where height `i` stands.
    fn place(&self, i: usize) -> [f64; 2] {
        let (column, row) = (i / self.rows.max(1), i % self.rows.max(1));
        self.at(column, row)
    }

    fn at(&self, column: usize, row: usize) -> [f64; 2] {
        let ([ox, oy], [cx, cy]) = (self.origin, self.cell);
        [ox + column as f64 * cx, oy + row as f64 * cy]
    }

    fn height(&self, column: usize, row: usize) -> f64 {
        let inside = column < self.columns && row < self.rows;
        if inside { self.heights.get(column * self.rows + row).copied().unwrap_or(0.0) } else { 0.0 }
    }

    fn point(&self, i: usize) -> Point3 {
        let [x, y] = self.place(i);
        Point3::new(x, y, self.heights.get(i).copied().unwrap_or(0.0))
    }

    fn cell_area(&self) -> f64 {
        self.cell[0] * self.cell[1]
    }

    /// Gives each height another one, and the volume that this adds; what is cut counts as negative.
    fn change(
        &mut self,
        context: &Context<'_>,
        height: impl Fn([f64; 2], f64) -> f64,
    ) -> Result<f64, Message> {
        let mut added = 0.0;
        let mut heights = std::mem::take(&mut self.heights);
        for (i, z) in heights.iter_mut().enumerate() {
            if i % 1024 == 0 {
                context.check()?;
            }
            let new = height(self.place(i), *z);
            if new.is_finite() {
                added += new - *z;
                *z = new;
            }
        }
        self.heights = heights;
        Ok(added * self.cell_area())
    }

    fn mesh(&self, context: &Context<'_>) -> Result<Shared<Mesh>, Message> {
        if self.columns < 2 || self.rows < 2 {
            return Err(Message::error("A mesh needs at least two columns and two rows"));
        }
        context.bytes(self.heights.len().saturating_mul(100))?;
        let points = (0..self.heights.len()).map(|i| self.point(i)).collect();
        let number = |column: usize, row: usize| u32::try_from(column * self.rows + row).unwrap_or(u32::MAX);
        let faces = (1..self.columns).flat_map(|c| {
            (1..self.rows).map(move |r| {
                MeshFace::Quad([number(c - 1, r - 1), number(c, r - 1), number(c, r), number(c - 1, r)])
            })
        });
        Ok(Shared::new(Mesh::new(points, faces.collect())?))
    }
}

/// The rise of a slope by its run, from an angle in degrees.
///
/// # Errors
/// The angle is not between 0 and 90.
fn rise(degrees: f64) -> Result<f64, Message> {
    if degrees > 0.0 && degrees < 90.0 {
        Ok(degrees.to_radians().tan())
    } else {
        Err(Message::error("A slope angle is between 0 and 90 degrees"))
    }
}

/// A length that must not be negative.
fn length(value: f64, what: &str) -> Result<f64, Message> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Message::error(format!("{what} must be a number of at least 0")))
    }
}
