//! LunchBox: panels and structures on surfaces, surfaces by formulas, tools for lists, curves and meshes, and spreadsheets.

mod attract;
mod classify;
mod convert;
mod curves;
mod forms;
mod frame;
mod grids;
mod learn;
mod lists;
mod meshes;
mod panels;
mod parts;
mod sheets;
mod solids;
mod space;
mod structures;
mod subdivide;
mod surfaces;
#[cfg(test)]
mod tests;
mod truss;

pub(crate) use solids::Solid;

use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_data::Value;
use katydid_geometry::{Direction, Line, NurbsSurface, Point3, Surface};

/// The most cells along one direction.
const MOST: i32 = 4000;

/// Points of a surface at whole and half divisions: place (i, j) counts in halves.
struct Lattice<'a> {
    surface: &'a Surface,
    cells: [usize; 2],
}

impl<'a> Lattice<'a> {
    /// # Errors
    /// A number of divisions is not positive or too large; there is no room for so many panels.
    fn new(context: &Context<'_>, surface: &'a Surface, u: i32, v: i32) -> Result<Self, Message> {
        let cells = [(u, "U"), (v, "V")].map(|(n, name)| match usize::try_from(n) {
            Ok(count) if (1..=MOST).contains(&n) => Ok(count),
            _ => Err(Message::error(format!("{name} is {n}: it must be from 1 to {MOST}"))),
        });
        let [u, v] = cells;
        let cells = [u?, v?];
        context.items(cells[0].saturating_mul(cells[1]).saturating_mul(2))?;
        // A panel is a surface of four control points.
        context.bytes(cells[0].saturating_mul(cells[1]).saturating_mul(1000))?;
        Ok(Self { surface, cells })
    }

    /// The point at i halves of a division along u and j along v.
    fn at(&self, i: usize, j: usize) -> Point3 {
        let [u, v] = [Direction::U, Direction::V].map(|d| self.surface.domain(d));
        let [m, n] = self.cells;
        let part = |k: usize, of: usize| k as f64 / (2 * of) as f64;
        self.surface.point_at(u.at(part(i, m)), v.at(part(j, n)))
    }

    /// The point at parts of the whole.
    fn at_parts(&self, s: f64, t: f64) -> Point3 {
        let [u, v] = [Direction::U, Direction::V].map(|d| self.surface.domain(d));
        self.surface.point_at(u.at(s.clamp(0.0, 1.0)), v.at(t.clamp(0.0, 1.0)))
    }

    /// The panel between corners at places in halves: a surface of four corners, or of three with one side of no length.
    fn panel(&self, corners: &[(usize, usize)]) -> Result<Value, Message> {
        let points: Vec<Point3> = corners.iter().map(|(i, j)| self.at(*i, *j)).collect();
        panel(&points)
    }

    fn line(&self, a: (usize, usize), b: (usize, usize)) -> Line {
        Line::new(self.at(a.0, a.1), self.at(b.0, b.1))
    }
}

/// The surface between four corners, or three.
fn panel(points: &[Point3]) -> Result<Value, Message> {
    let surface = match *points {
        [a, b, c, d] => NurbsSurface::from_corners(a, b, c, d),
        [a, b, c] => NurbsSurface::from_triangle(a, b, c),
        _ => return Err(Message::error("Internal error: a panel has three or four corners")),
    };
    Ok(Value::from(Shared::new(Surface::from(surface?))))
}
