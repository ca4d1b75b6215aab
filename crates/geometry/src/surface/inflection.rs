//! Where a surface changes from a dome to a saddle.

use katydid_elementary::Elementary;

use super::Surface;
use crate::isoline::{Isoline, isolines};
use crate::thresholds;
use crate::{Direction, Error, Point2, Point3, PolylineCurve, Result, Vector3};

/// Cells of the grid on which the lines are looked for, along each direction.
const CELLS: usize = 96;
/// Curvature below this fraction of what a sphere of the surface's size has is none: noise of a surface that unrolls.
const FLAT: f64 = 1e-9;
/// Between two places of the grid a line is halved so often at most.
const HALVINGS: usize = 8;

impl Surface {
    /// The lines along which the Gaussian curvature is 0 and has different signs on both sides, as polylines within
    /// `tolerance` of the surface's own line. Surfaces without any curvature of that kind, planes and developable ones
    /// among them, have none; so do spheres. Trims are not heeded.
    ///
    /// The sign of the Gaussian curvature is that of LN − M², the determinant of the second fundamental form. Lines are
    /// found on a grid of 97 by 97 places, refined along its gradient; what is smaller than a cell is missed.
    ///
    /// # Errors
    /// A tolerance that is not above 0, or numbers that are not finite.
    pub fn inflection_lines(&self, tolerance: f64) -> Result<Vec<PolylineCurve>> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance,
                must: "finite and greater than 0",
            });
        }
        let bend = Bend::of(self)?;
        // Places off the middle of spans, where symmetric surfaces have their lines, keep these out of the corners.
        let grid: Vec<f64> = (0..=CELLS)
            .flat_map(|j| (0..=CELLS).map(move |i| (i, j)))
            .map(|(i, j)| bend.at(share(i), share(j)))
            .collect();
        if !grid.iter().all(|k| k.is_finite()) {
            return Err(Error::NotFinite("curvature of the surface"));
        }
        if grid.iter().all(|k| k.abs() <= FLAT) {
            return Ok(Vec::new());
        }
        let quiet: Vec<f64> = grid.into_iter().map(|k| if k.abs() <= FLAT { FLAT } else { k }).collect();
        let lines = isolines(&quiet, CELLS + 1, 0.0)?;
        lines.iter().filter_map(|line| bend.refined(line, tolerance)).collect()
    }
}

/// The parameter of a place of the grid, as a share of the domain: the inner ones a little off even.
fn share(i: usize) -> f64 {
    const OFF: f64 = 0.0137;
    let x = i as f64 / CELLS as f64;
    x + OFF / CELLS as f64 * (std::f64::consts::PI * x).sine()
}

/// The share at a place between places of the grid.
fn share_between(x: f64) -> f64 {
    let i = (x.floor().max(0.0) as usize).min(CELLS - 1);
    let (a, b) = (share(i), share(i + 1));
    a + (x - i as f64) * (b - a)
}

/// The determinant of the second fundamental form, over shares of the domain and in the size of the surface.
struct Bend<'a> {
    surface: &'a Surface,
    domains: [crate::Interval; 2],
    size: f64,
}

impl<'a> Bend<'a> {
    fn of(surface: &'a Surface) -> Result<Self> {
        let domains = Direction::BOTH.map(|d| surface.domain(d));
        let size = surface.bounding_box()?.diagonal().length().max(f64::MIN_POSITIVE);
        Ok(Self { surface, domains, size })
    }

    fn uv(&self, x: f64, y: f64) -> (f64, f64) {
        (self.domains[0].at(x.clamp(0.0, 1.0)), self.domains[1].at(y.clamp(0.0, 1.0)))
    }

    fn point(&self, x: f64, y: f64) -> Point3 {
        let (u, v) = self.uv(x, y);
        self.surface.point_at(u, v)
    }

    fn at(&self, x: f64, y: f64) -> f64 {
        let (u, v) = self.uv(x, y);
        let d = self.surface.derivatives(u, v, 2, self.surface.inner_quadrant(u, v));
        let [a, b] = self.domains.map(crate::Interval::length);
        let Some(normal) = d.get(1, 0).cross(d.get(0, 1)).unitized() else { return 0.0 };
        let along = |vector: Vector3| vector.dot(normal) / self.size;
        along(d.get(2, 0)) * a * a * along(d.get(0, 2)) * b * b - (along(d.get(1, 1)) * a * b).powi(2)
    }

    /// The place of no curvature nearest to one, by Newton's steps along the gradient.
    fn root(&self, mut x: f64, mut y: f64) -> (f64, f64) {
        const STEP: f64 = 1e-5;
        for _ in 0..12 {
            let here = self.at(x, y);
            let slope = |dx: f64, dy: f64| (self.at(x + dx, y + dy) - self.at(x - dx, y - dy)) / (2.0 * STEP);
            let (gx, gy) = (slope(STEP, 0.0), slope(0.0, STEP));
            let square = gx * gx + gy * gy;
            let far = here.abs() / square.sqrt();
            // Farther than a cell away it would be another line.
            if !(square > 0.0) || !(far < 1.0 / CELLS as f64) {
                break;
            }
            x = (x - here * gx / square).clamp(0.0, 1.0);
            y = (y - here * gy / square).clamp(0.0, 1.0);
            if far < thresholds::EXACT_PARAMETER {
                break;
            }
        }
        (x, y)
    }

    /// A line of the grid on the surface; nothing where it is shorter than the tolerance.
    fn refined(&self, line: &Isoline, tolerance: f64) -> Option<Result<PolylineCurve>> {
        let place = |p: &Point2| self.root(share_between(p.x), share_between(p.y));
        let mut places: Vec<(f64, f64)> = line.points.iter().map(place).collect();
        if line.closed {
            places.extend(places.first().copied());
        }
        let mut points = Vec::with_capacity(places.len());
        points.extend(places.first().map(|p| self.point(p.0, p.1)));
        for pair in places.windows(2) {
            self.between(pair[0], pair[1], tolerance, HALVINGS, &mut points);
        }
        points.dedup_by(|b, a| a.distance_to(*b) <= thresholds::SAME_POINT * self.size);
        let length: f64 = points.windows(2).map(|p| p[0].distance_to(p[1])).sum();
        (points.len() > 1 && length > tolerance).then(|| PolylineCurve::new(points))
    }

    /// Adds the points after the first up to the second.
    fn between(&self, a: (f64, f64), b: (f64, f64), tolerance: f64, left: usize, out: &mut Vec<Point3>) {
        let (from, to) = (self.point(a.0, a.1), self.point(b.0, b.1));
        let middle = self.root(0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1));
        let on = self.point(middle.0, middle.1);
        let off = crate::Line::new(from, to).distance_to(on);
        if left > 0 && off > 0.5 * tolerance && off.is_finite() {
            self.between(a, middle, tolerance, left - 1, out);
            self.between(middle, b, tolerance, left - 1, out);
        } else {
            out.push(to);
        }
    }
}
