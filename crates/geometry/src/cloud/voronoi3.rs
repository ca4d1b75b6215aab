use super::neighbours::PointTree;
use super::polyhedron::{ConvexPolyhedron, Cut, Scratch};
use super::{check_coordinates, check_points3};
use crate::box_tree::{Bounds, squared_distance_to};
use crate::thresholds;
use crate::{BoundingBox, Error, Point3, Result, Vector3};

/// So many neighbours, the nearest first, settle most cells.
const USUAL: usize = 24;

/// The Voronoi cells of sites in space, inside a box: for every site the part of the box that is nearer to it than to
/// any other site. The faces of a cell are tagged with the sites beyond them.
///
/// `None` for a site in the same place as an earlier one, and for one so far outside the box that its cell does not
/// reach it. Each cell is cut from the box by the middle planes to its neighbours, the nearest first, until none can be
/// near enough to matter (C. Rycroft, *Voro++: a three-dimensional Voronoi cell library*, 2009): after the nearest few,
/// boxes of sites in a tree are passed over that are nearer to no corner of the cell than its own site, so that sites
/// on a plane or a surface take not much longer than others. Corners within 1e-12 of the box's size of a plane count as
/// on it. Runs in parallel with the `parallel` feature.
///
/// # Errors
/// A coordinate is not finite or beyond 3.2e60, or the box has no volume.
pub fn voronoi_cells_3d(sites: &[Point3], bounds: &BoundingBox) -> Result<Vec<Option<ConvexPolyhedron>>> {
    let cells = Cells::new(sites, bounds)?;
    let start = |i: usize, scratch: &mut Room| cells.cell(i, scratch);
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        let all = (0..sites.len()).into_par_iter().with_min_len(64);
        Ok(crate::parallel::waiting(|| all.map_init(Room::default, |s, i| start(i, s)).collect()))
    }
    #[cfg(not(feature = "parallel"))]
    {
        let mut scratch = Room::default();
        Ok((0..sites.len()).map(|i| start(i, &mut scratch)).collect())
    }
}

/// The Voronoi cell of one site among others, inside a box, as [`voronoi_cells_3d`] gives it; faces are tagged with the
/// indices of the others. Others in the site's own place are passed over.
///
/// # Errors
/// As [`voronoi_cells_3d`].
pub fn voronoi_cell_3d(
    site: Point3,
    others: &[Point3],
    bounds: &BoundingBox,
) -> Result<Option<ConvexPolyhedron>> {
    check_points3(&[site])?;
    let cells = Cells::new(others, bounds)?;
    Ok(cells.cell_at(site, None, &mut Room::default()))
}

struct Cells {
    tree: PointTree,
    sites: Vec<Point3>,
    whole: ConvexPolyhedron,
    tolerance: f64,
}

#[derive(Default)]
struct Room {
    scratch: Scratch,
    found: Vec<(f64, u32)>,
}

impl Cells {
    fn new(sites: &[Point3], bounds: &BoundingBox) -> Result<Self> {
        let (min, max): ([f64; 3], [f64; 3]) = (bounds.min.into(), bounds.max.into());
        check_coordinates(min.into_iter().chain(max))?;
        let size = bounds.diagonal();
        if !(size.x > 0.0 && size.y > 0.0 && size.z > 0.0) {
            return Err(Error::degenerate("box", "it has no volume"));
        }
        Ok(Self {
            tree: PointTree::new(sites)?,
            sites: sites.to_vec(),
            whole: ConvexPolyhedron::from_box(bounds),
            tolerance: thresholds::ROUNDING * size.length(),
        })
    }

    fn cell(&self, i: usize, room: &mut Room) -> Option<ConvexPolyhedron> {
        self.cell_at(*self.sites.get(i)?, Some(i), room)
    }

    /// The cell of a site that is number `own`, or none of the sites.
    fn cell_at(&self, site: Point3, own: Option<usize>, room: &mut Room) -> Option<ConvexPolyhedron> {
        // Seen from the site, so that rounding does not grow with the distance from the origin.
        let cell = self.whole.clone().mapped(|p| (p - site).to_point());
        Some(self.cut_out(cell, site, own, room)?.mapped(|p| site + p.to_vector()))
    }

    fn cut_out(
        &self,
        mut cell: ConvexPolyhedron,
        site: Point3,
        own: Option<usize>,
        room: &mut Room,
    ) -> Option<ConvexPolyhedron> {
        let q: [f64; 3] = site.into();
        let Room { scratch, found } = room;
        self.tree.nearest_into(q, USUAL, [0.0, f64::INFINITY], own, found);
        // What is not nearer than twice the farthest corner cuts nothing: here squared.
        let mut reach = reach_of(&cell);
        for &(d, j) in found.iter() {
            if d > reach {
                return Some(cell);
            }
            if self.cut(&mut cell, site, own, j, scratch)? {
                reach = reach_of(&cell);
            }
        }
        if found.len() < USUAL {
            return Some(cell);
        }
        // A site cuts off a corner that is nearer to it than to its own.
        let cuts = |(cell, reach): &(Option<ConvexPolyhedron>, f64), bounds: &Bounds| {
            squared_distance_to(bounds, &q) < *reach
                && cell.iter().flat_map(ConvexPolyhedron::vertices).any(|&v| {
                    let v = v.to_vector();
                    squared_distance_to(bounds, &(site + v).into()) < v.length_squared()
                })
        };
        let mut state = (Some(cell), reach);
        self.tree.visit_wanted(&mut state, cuts, |(left, reach), j| {
            let Some(cell) = left.as_mut().filter(|_| Some(j) != own) else { return };
            match self.cut(cell, site, own, j as u32, scratch) {
                Some(true) => *reach = reach_of(cell),
                Some(false) => {}
                None => *left = None,
            }
        });
        state.0
    }

    /// Cuts off what is nearer to site `j`, and tells whether that was anything; `None` when nothing is left.
    fn cut(
        &self,
        cell: &mut ConvexPolyhedron,
        site: Point3,
        own: Option<usize>,
        j: u32,
        scratch: &mut Scratch,
    ) -> Option<bool> {
        let d: Vector3 = *self.sites.get(j as usize)? - site;
        let Some(n) = d.unitized() else {
            // In the same place: the cell is the first one's.
            return own.is_none_or(|i| i < j as usize).then_some(false);
        };
        match cell.cut(n, 0.5 * d.length(), self.tolerance, j, scratch) {
            Cut::Nothing => Some(false),
            Cut::Part => Some(true),
            Cut::All => None,
        }
    }
}

/// Four times the squared distance of the farthest corner from the site, which is the origin.
fn reach_of(cell: &ConvexPolyhedron) -> f64 {
    4.0 * cell.vertices().iter().map(|&p| p.to_vector().length_squared()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(size: f64) -> BoundingBox {
        BoundingBox { min: Point3::ORIGIN, max: Point3::new(size, size, size) }
    }

    #[test]
    fn a_lattice_has_cubes() {
        let sites: Vec<Point3> = (0..64)
            .map(|i| Point3::new(f64::from(i % 4), f64::from(i / 4 % 4), f64::from(i / 16)))
            .map(|p| p + Vector3::new(0.5, 0.5, 0.5))
            .collect();
        let cells = voronoi_cells_3d(&sites, &unit(4.0)).unwrap();
        for cell in cells {
            let cell = cell.unwrap();
            assert_eq!((cell.face_count(), cell.vertices().len()), (6, 8));
            assert!((cell.volume() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn few_and_equal_sites() {
        let p = Point3::new(0.25, 0.5, 0.5);
        let q = Point3::new(0.75, 0.5, 0.5);
        let cells = voronoi_cells_3d(&[p, q, p, Point3::new(90.0, 0.0, 0.0)], &unit(1.0)).unwrap();
        assert!((cells[0].as_ref().unwrap().volume() - 0.5).abs() < 1e-12);
        assert!(cells[2].is_none() && cells[3].is_none());
        assert_eq!(cells[1].as_ref().unwrap().face_count(), 6);
        assert!(cells[1].as_ref().unwrap().touches_border());
        assert!(voronoi_cells_3d(&[], &unit(1.0)).unwrap().is_empty());
        assert!(voronoi_cells_3d(&[p], &unit(0.0)).is_err());
        let one = voronoi_cell_3d(p, &[p, q], &unit(1.0)).unwrap().unwrap();
        assert!((one.volume() - 0.5).abs() < 1e-12);
        // Closed in by more than one look round finds.
        let ball: Vec<Point3> = (0..400)
            .map(|i| {
                let z = (f64::from(i) + 0.5) / 200.0 - 1.0;
                let (s, c) = (f64::from(i) * 2.399_963).sin_cos();
                let r = (1.0 - z * z).sqrt();
                Point3::new(0.5 + 0.4 * r * c, 0.5 + 0.4 * r * s, 0.5 + 0.4 * z)
            })
            .collect();
        let inner = voronoi_cell_3d(Point3::new(0.5, 0.5, 0.5), &ball, &unit(1.0)).unwrap().unwrap();
        assert!(!inner.touches_border() && inner.face_count() > 300);
        let sphere = 4.0 / 3.0 * std::f64::consts::PI * 0.008;
        assert!((inner.volume() / sphere - 1.0).abs() < 0.03);
    }
}
