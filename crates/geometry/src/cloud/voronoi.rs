use crate::thresholds;
use std::ops::Range;

use spade::Triangulation;

use super::convex_polygon::{ConvexPolygon, doubled_area, nearer_part, outline};
use super::delaunay::{Links, SiteMesh, beside, circumcenter, linked};
use crate::{Curve, Plane, Point2, Result, cancellation};

/// The Voronoi diagram of sites in a plane, inside a convex boundary: for every site the part of the boundary's inside
/// that is nearer to it than to any other site.
///
/// A site in the same place as an earlier one has an empty cell, and so has one so far outside that no place inside is
/// nearest to it. The cells fill the boundary. Read off the Delaunay triangulation: the corners of an inner cell are
/// the circumcentres of the triangles around its site, in the same numbers for all cells that share them; cells that
/// reach the boundary are cut from it, side by side.
#[derive(Debug, Clone)]
pub struct Voronoi {
    sites: Vec<Point2>,
    corners: Vec<Point2>,
    /// Where each cell's corners lie.
    ranges: Vec<Range<usize>>,
    duplicates: bool,
}

impl Voronoi {
    /// The diagram of sites inside a boundary.
    ///
    /// # Errors
    /// As [`Delaunay::new`](super::Delaunay::new).
    pub fn new(sites: &[Point2], boundary: &ConvexPolygon) -> Result<Self> {
        let (links, shared) = linked(sites)?;
        let size = boundary
            .corners()
            .iter()
            .flat_map(|&p| boundary.corners().iter().map(move |&q| p.distance_to(q)))
            .fold(0.0, f64::max);
        cancellation::room::<[f64; 20]>(sites.len())?;
        let mut out = Self {
            sites: sites.to_vec(),
            corners: Vec::with_capacity(6 * sites.len()),
            ranges: vec![0..0; sites.len()],
            duplicates: shared.is_some(),
        };
        let near = thresholds::ROUNDING * size;
        match &links {
            Links::Mesh(mesh) => out.cells_of(mesh, boundary, near)?,
            Links::Row(row) => {
                let mut scratch = (Vec::new(), Vec::new());
                for (place, &site) in row.iter().enumerate() {
                    let start = out.corners.len();
                    out.cut_out(boundary, site, beside(row, place), &mut scratch);
                    out.keep(start, site, near);
                }
            }
        }
        Ok(out)
    }

    /// The cells of a triangulation.
    fn cells_of(&mut self, mesh: &SiteMesh, boundary: &ConvexPolygon, near: f64) -> Result<()> {
        cancellation::room::<Center>(mesh.num_all_faces())?;
        let centers: Vec<Center> = mesh
            .all_faces()
            .map(|face| match face.as_inner() {
                None => Center::OUTSIDE,
                Some(face) => Center::new(face.positions().map(|p| Point2::new(p.x, p.y)), boundary),
            })
            .collect();
        let mut scratch = (Vec::new(), Vec::new());
        // In the order of the triangulation's vertices, which lie near each other in memory when they do in the plane.
        for corner in mesh.vertices() {
            cancellation::check()?;
            let start = self.corners.len();
            let inner = corner.out_edges().all(|e| {
                let center = centers.get(e.face().index()).filter(|c| c.inside);
                self.corners.extend(center.map(|c| c.place));
                center.is_some()
            });
            let site = corner.data().index;
            if !inner || corner.out_edge().is_none() {
                self.corners.truncate(start);
                let around = corner.out_edges().map(|edge| edge.to().data().index);
                self.cut_out(boundary, site, around, &mut scratch);
            }
            self.keep(start, site, near);
        }
        Ok(())
    }

    /// Adds the part of the boundary nearest to a site: the sites around it cut it out.
    fn cut_out(
        &mut self,
        boundary: &ConvexPolygon,
        site: u32,
        around: impl Iterator<Item = u32>,
        (ring, next): &mut (Vec<Point2>, Vec<Point2>),
    ) {
        let Some(&own) = self.sites.get(site as usize) else { return };
        ring.clear();
        ring.extend_from_slice(boundary.corners());
        for other in around {
            let Some(&other) = self.sites.get(other as usize) else { continue };
            if nearer_part(ring, own, other, next) {
                std::mem::swap(ring, next);
            }
        }
        self.corners.extend_from_slice(ring);
    }

    /// Makes the corners from `start` on the cell of a site.
    fn keep(&mut self, start: usize, site: u32, near: f64) {
        self.tidy(start, near);
        if let Some(range) = self.ranges.get_mut(site as usize) {
            *range = start..self.corners.len();
        }
    }

    /// Takes corners out of the last cell that are nearer than `tolerance` to the one before, and the cell when it has
    /// no area.
    fn tidy(&mut self, start: usize, tolerance: f64) {
        let mut kept = start;
        let apart = |a: Point2, b: Point2| (a - b).length_squared() > tolerance * tolerance;
        for k in start..self.corners.len() {
            if kept == start || apart(self.corners[k], self.corners[kept - 1]) {
                self.corners[kept] = self.corners[k];
                kept += 1;
            }
        }
        while kept > start + 1 && !apart(self.corners[kept - 1], self.corners[start]) {
            kept -= 1;
        }
        self.corners.truncate(kept);
        if !(doubled_area(&self.corners[start..]) > 0.0) {
            self.corners.truncate(start);
        }
    }

    /// The number of sites.
    pub fn len(&self) -> usize {
        self.ranges.len()
    }

    /// Whether there is no site.
    pub fn is_empty(&self) -> bool {
        self.ranges.is_empty()
    }

    /// Whether some sites share a place: all but the first of them have empty cells.
    pub fn has_duplicates(&self) -> bool {
        self.duplicates
    }

    /// The corners of the cell of site `i`, counter-clockwise; none when the cell is empty.
    pub fn cell(&self, i: usize) -> &[Point2] {
        self.ranges.get(i).and_then(|range| self.corners.get(range.clone())).unwrap_or(&[])
    }

    /// The area of the cell of site `i`.
    pub fn area(&self, i: usize) -> f64 {
        0.5 * doubled_area(self.cell(i))
    }

    /// The outline of the cell of site `i` as a closed curve in a plane whose coordinates the sites have. With a radius
    /// only what lies within that distance of the site: arcs take the place of what is farther. `None` when the cell is
    /// empty.
    ///
    /// # Errors
    /// The radius is not greater than 0 and finite.
    pub fn outline(&self, i: usize, plane: &Plane, radius: Option<f64>) -> Result<Option<Curve>> {
        let circle = radius.and_then(|r| self.sites.get(i).map(|&site| (site, r)));
        outline(self.cell(i), plane, circle)
    }
}

/// Where three cells meet.
#[derive(Clone, Copy)]
struct Center {
    place: Point2,
    inside: bool,
}

impl Center {
    /// That of the face around all.
    const OUTSIDE: Self = Self { place: Point2::ORIGIN, inside: false };

    fn new(triangle: [Point2; 3], boundary: &ConvexPolygon) -> Self {
        let place = circumcenter(triangle);
        // Rounding does not matter here: what is taken for outside is cut, and nothing is cut off where it is inside.
        let next = boundary.corners().iter().cycle().skip(1);
        let inside = boundary.corners().iter().zip(next).all(|(&a, &b)| (b - a).cross(place - a) >= 0.0);
        Self { place, inside }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interval;

    fn rectangle(w: f64, h: f64) -> ConvexPolygon {
        ConvexPolygon::rectangle(Interval::new(0.0, w), Interval::new(0.0, h)).unwrap()
    }

    #[test]
    fn a_grid_has_square_cells() {
        let sites: Vec<Point2> =
            (0..100).map(|i| Point2::new(f64::from(i % 10) + 0.5, f64::from(i / 10) + 0.5)).collect();
        let v = Voronoi::new(&sites, &rectangle(10.0, 10.0)).unwrap();
        for i in 0..100 {
            assert_eq!(v.cell(i).len(), 4, "cell {i}: {:?}", v.cell(i));
            assert!((v.area(i) - 1.0).abs() < 1e-12);
        }
        assert!(v.cell(100).is_empty());
    }

    #[test]
    fn few_sites() {
        let whole = rectangle(4.0, 2.0);
        let v = Voronoi::new(&[Point2::new(9.0, 9.0)], &whole).unwrap();
        assert_eq!(v.area(0), 8.0);
        let row = [[1.0, 1.0], [3.0, 1.0], [1.0, 1.0]].map(Point2::from);
        let v = Voronoi::new(&row, &whole).unwrap();
        assert_eq!((v.area(0), v.area(1), v.area(2)), (4.0, 4.0, 0.0));
        assert!(v.has_duplicates() && v.outline(2, &Plane::XY, None).unwrap().is_none());
        assert!(Voronoi::new(&[], &whole).unwrap().is_empty());
        // The middle of three on a line, and one so far outside that it has nothing.
        let row = [[1.0, 1.0], [2.0, 1.0], [3.0, 1.0], [20.0, 1.0]].map(Point2::from);
        let v = Voronoi::new(&row, &whole).unwrap();
        assert_eq!((0..4).map(|i| v.area(i)).collect::<Vec<_>>(), [3.0, 2.0, 3.0, 0.0]);
    }
}
