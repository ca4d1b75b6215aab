use super::{check_coordinates, check_count};
use crate::{Error, Result};

/// Halving a range of numbers this often leaves nothing to halve.
const DEEPEST: usize = 60;

/// A cell of a [`Partition`]: the smallest and largest coordinates, and the points in it by their indices, in order.
#[derive(Debug, Clone, PartialEq)]
pub struct Leaf<const D: usize> {
    /// The smallest coordinates.
    pub min: [f64; D],
    /// The largest coordinates.
    pub max: [f64; D],
    /// The points inside, by their indices.
    pub points: Vec<u32>,
}

/// Cells that hold few points each: a cell with more is halved in every direction (R. A. Finkel, J. L. Bentley, *Quad
/// trees: a data structure for retrieval on composite keys*, 1974).
#[derive(Debug, Clone, PartialEq)]
pub struct Partition<const D: usize> {
    leaves: Vec<Leaf<D>>,
}

/// A partition of the plane into quarters of quarters.
pub type QuadTree = Partition<2>;
/// A partition of space into eighths of eighths.
pub type OcTree = Partition<3>;

impl<const D: usize> Partition<D> {
    /// Halves the box around points until no cell holds more than `group`, except points in one place. `square` makes
    /// all sides equally long, about the same middle. The cells cover the box; a point between two cells belongs to
    /// the one with the larger coordinates. No points, no cells.
    ///
    /// # Errors
    /// A coordinate is not finite or beyond 3.2e60, `group` is 0, or more than `limit` cells would be needed.
    pub fn new(points: &[[f64; D]], group: usize, square: bool, limit: usize) -> Result<Self> {
        check_count(points.len())?;
        check_coordinates(points.iter().flatten().copied())?;
        if group == 0 {
            return Err(Error::OutOfRange {
                what: "number of points in a cell",
                value: 0.0,
                must: "at least 1",
            });
        }
        let mut out = Self { leaves: Vec::new() };
        if points.is_empty() {
            return Ok(out);
        }
        let (mut min, mut max) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        for p in points {
            for k in 0..D {
                (min[k], max[k]) = (min[k].min(p[k]), max[k].max(p[k]));
            }
        }
        if square {
            let side = (0..D).map(|k| max[k] - min[k]).fold(0.0, f64::max);
            for k in 0..D {
                let middle = 0.5 * (min[k] + max[k]);
                // Not less than there is, whatever rounding does.
                (min[k], max[k]) = (min[k].min(middle - 0.5 * side), max[k].max(middle + 0.5 * side));
            }
        }
        let all = (0..points.len() as u32).collect();
        out.split(points, Leaf { min, max, points: all }, group, DEEPEST, limit)?;
        Ok(out)
    }

    fn split(
        &mut self,
        points: &[[f64; D]],
        cell: Leaf<D>,
        group: usize,
        depth: usize,
        limit: usize,
    ) -> Result<()> {
        crate::cancellation::check()?;
        let at = |i: u32| points.get(i as usize).copied().unwrap_or([0.0; D]);
        let one_place = |cell: &Leaf<D>| {
            let first = cell.points.first().copied().map(at);
            cell.points.iter().all(|&i| Some(at(i)) == first)
        };
        if cell.points.len() <= group || depth == 0 || one_place(&cell) {
            if self.leaves.len() >= limit {
                return Err(Error::OutOfRange {
                    what: "number of cells",
                    value: self.leaves.len() as f64 + 1.0,
                    must: "within the limit",
                });
            }
            self.leaves.push(cell);
            return Ok(());
        }
        let middle: [f64; D] = std::array::from_fn(|k| 0.5 * (cell.min[k] + cell.max[k]));
        let part = |i: u32| {
            let p = at(i);
            (0..D).fold(0_usize, |part, k| part | usize::from(p[k] >= middle[k]) << k)
        };
        let mut parts: Vec<Vec<u32>> = vec![Vec::new(); 1 << D];
        for &i in &cell.points {
            if let Some(list) = parts.get_mut(part(i)) {
                list.push(i);
            }
        }
        for (part, points_inside) in parts.into_iter().enumerate() {
            let upper = |k: usize| part >> k & 1 == 1;
            let child = Leaf {
                min: std::array::from_fn(|k| if upper(k) { middle[k] } else { cell.min[k] }),
                max: std::array::from_fn(|k| if upper(k) { cell.max[k] } else { middle[k] }),
                points: points_inside,
            };
            self.split(points, child, group, depth - 1, limit)?;
        }
        Ok(())
    }

    /// The cells; the parts of a cell follow each other, x changing first.
    pub fn leaves(&self) -> &[Leaf<D>] {
        &self.leaves
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_cover_and_hold_few() {
        let points: Vec<[f64; 2]> =
            (0..300).map(f64::from).map(|t| [(t * 1.3).sin() * 5.0, (t * 0.7).cos() * t]).collect();
        for square in [false, true] {
            let tree = QuadTree::new(&points, 4, square, 10_000).unwrap();
            let mut seen = vec![0; points.len()];
            let (mut area, mut whole) = (0.0, [f64::INFINITY, f64::INFINITY, -f64::INFINITY, -f64::INFINITY]);
            for leaf in tree.leaves() {
                assert!(leaf.points.len() <= 4);
                area += (leaf.max[0] - leaf.min[0]) * (leaf.max[1] - leaf.min[1]);
                for k in 0..2 {
                    whole[k] = whole[k].min(leaf.min[k]);
                    whole[k + 2] = whole[k + 2].max(leaf.max[k]);
                }
                for &i in &leaf.points {
                    seen[i as usize] += 1;
                    let p = points[i as usize];
                    assert!((0..2).all(|k| leaf.min[k] <= p[k] && p[k] <= leaf.max[k]));
                }
            }
            assert!(seen.iter().all(|&n| n == 1));
            let (w, h) = (whole[2] - whole[0], whole[3] - whole[1]);
            assert!((area - w * h).abs() < 1e-9 * area);
            assert!(!square || (w - h).abs() < 1e-9 * w);
        }
    }

    #[test]
    fn odd_clouds() {
        assert!(OcTree::new(&[], 1, true, 10).unwrap().leaves().is_empty());
        assert_eq!(OcTree::new(&[[1.0; 3]; 9], 1, true, 10).unwrap().leaves().len(), 1);
        let near = [[0.0, 0.0, 0.0], [1e-300, 0.0, 0.0], [1.0, 1.0, 1.0]];
        assert!(OcTree::new(&near, 1, false, 10_000).is_ok());
        assert!(OcTree::new(&near, 1, false, 5).is_err());
        assert!(OcTree::new(&near, 0, false, 10).is_err());
        assert!(OcTree::new(&[[f64::NAN; 3]], 1, false, 10).is_err());
    }
}
