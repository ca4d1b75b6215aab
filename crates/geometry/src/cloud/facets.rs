use super::check_points3;
use super::convex_polygon::{nearer_part, outline};
use super::neighbours::PointTree;
use crate::cloud::thresholds::AT_BORDER;
use crate::{BoundingBox, Curve, Plane, Point2, Point3, Result, Sphere, Vector2, Vector3};

/// Half the side of the square that a facet without neighbours is, in radii; the corners of a regular tetrahedron about
/// the sphere lie 2√2 radii from the middles of its faces.
const HALF_SQUARE: f64 = 4.0;
/// So many neighbours settle most facets.
const USUAL: usize = 24;
/// Directions nearer to each other count as one.
const SAME: f64 = 1e-12;
/// The sides of a polygon that stands for a circle.
const ROUND: u32 = 64;

/// A facet of a dome: a convex polygon in a plane that touches the sphere.
#[derive(Debug, Clone, PartialEq)]
pub struct Facet {
    /// The plane, with its origin where it touches the sphere and its normal outwards.
    pub plane: Plane,
    ring: Vec<Point2>,
}

impl Facet {
    /// The corners, counter-clockwise seen from outside; none where nothing is left of the facet.
    pub fn corners(&self) -> Vec<Point3> {
        self.ring.iter().map(|p| self.plane.at(p.x, p.y, 0.0)).collect()
    }

    /// The outline as a closed curve; with a radius only what lies within that distance of the touching point, with
    /// arcs of the circle. `None` where nothing is left.
    ///
    /// # Errors
    /// The radius is not greater than 0 and finite.
    pub fn outline(&self, radius: Option<f64>) -> Result<Option<Curve>> {
        outline(&self.ring, &self.plane, radius.map(|r| (Point2::ORIGIN, r)))
    }

    /// The facet without what lies farther than a radius from its touching point, with a polygon of 64 sides for the
    /// circle.
    #[must_use]
    pub fn within(mut self, radius: f64) -> Self {
        let mut room = Vec::new();
        for k in 0..ROUND {
            let n = Vector2::X.rotated(std::f64::consts::TAU * f64::from(k) / f64::from(ROUND));
            self.keep(n, radius, &mut room);
        }
        self
    }

    /// Keeps the points u with n·u ≤ b, n of length 1.
    fn keep(&mut self, n: Vector2, b: f64, room: &mut Vec<Point2>) {
        // The same half-plane as the places nearer to one point than to another.
        let site = (n * (b - 0.5)).to_point();
        self.nearer(site, site + n, room);
    }

    fn nearer(&mut self, site: Point2, other: Point2, room: &mut Vec<Point2>) {
        if nearer_part(&self.ring, site, other, room) {
            std::mem::swap(&mut self.ring, room);
        }
    }

    fn cut_by_box(&mut self, b: &BoundingBox, room: &mut Vec<Point2>) {
        for (axis, low, high) in
            [(Vector3::X, b.min.x, b.max.x), (Vector3::Y, b.min.y, b.max.y), (Vector3::Z, b.min.z, b.max.z)]
        {
            let slope = Vector2::new(axis.dot(self.plane.x_axis), axis.dot(self.plane.y_axis));
            let here = axis.dot(self.plane.origin.to_vector());
            let steep = slope.length();
            match slope.unitized().filter(|_| steep > SAME) {
                Some(n) => {
                    self.keep(n, (high - here) / steep, room);
                    self.keep(-n, (here - low) / steep, room);
                }
                None if here < low || here > high => self.ring.clear(),
                None => {}
            }
        }
    }

    fn scaled(mut self, center: Point3, radius: f64) -> Self {
        self.plane.origin = center + self.plane.origin.to_vector() * radius;
        for p in &mut self.ring {
            *p = (p.to_vector() * radius).to_point();
        }
        self
    }

    /// The facet of direction `i` on the unit sphere, uncut at open sides.
    fn on_unit_sphere(i: usize, n: Vector3, directions: &[Point3], tree: &PointTree) -> Result<Self> {
        let plane = Plane::from_normal(Point3::ORIGIN + n, n)?;
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let ring = square.map(|(x, y)| Point2::new(HALF_SQUARE * x, HALF_SQUARE * y)).to_vec();
        let (mut facet, mut room, mut found) = (Self { plane, ring }, Vec::new(), Vec::new());
        let place = Point3::ORIGIN + n;
        let mut count = USUAL;
        loop {
            tree.nearest_into(place.into(), count, [0.0, f64::INFINITY], Some(i), &mut found);
            // Those of the round before come again; they cut nothing more.
            for &(d, j) in &found {
                let Some(&other) = directions.get(j as usize) else { continue };
                let m = other.to_vector();
                if !(m.length_squared() > 0.5) {
                    continue;
                }
                if d <= SAME * SAME {
                    if (j as usize) < i {
                        facet.ring.clear();
                        return Ok(facet);
                    }
                    continue;
                }
                // The planes meet at tan(θ/2) from the touching point, where sin²(θ/2) = d/4.
                let farthest = facet.ring.iter().map(|p| p.to_vector().length_squared()).fold(0.0, f64::max);
                let rest = 1.0 - 0.25 * d;
                if 0.25 * d >= farthest * rest {
                    return Ok(facet);
                }
                let flat = Vector2::new(m.dot(plane.x_axis), m.dot(plane.y_axis));
                facet.nearer(Point2::ORIGIN, (flat / rest).to_point(), &mut room);
            }
            if count >= directions.len() {
                return Ok(facet);
            }
            count = count.saturating_mul(8);
        }
    }

    fn is_open(&self) -> bool {
        self.ring.iter().any(|p| p.x.abs().max(p.y.abs()) >= HALF_SQUARE * (1.0 - AT_BORDER))
    }
}

/// The facets of a dome over a sphere: for every point the part of the plane that touches the sphere in its direction
/// that no other such plane cuts off. Empty for a point that shares its direction with an earlier one, and for one at
/// the sphere's centre.
///
/// A facet at an open rim has no end of its own. A box cuts all facets; without one, a dome with a rim is cut by the box
/// around its points, grown by the reach of the middling facet. Which planes can
/// matter is settled as for Voronoi cells: the nearest first, until no corner is far enough off.
///
/// # Errors
/// A coordinate is not finite or beyond 3.2e60.
pub fn facets(points: &[Point3], sphere: &Sphere, bounds: Option<&BoundingBox>) -> Result<Vec<Facet>> {
    check_points3(points)?;
    let center = sphere.plane.origin;
    // One without direction goes to the middle.
    let direction = |p: &Point3| (*p - center).unitized().unwrap_or(Vector3::ZERO).to_point();
    let directions: Vec<Point3> = points.iter().map(direction).collect();
    let tree = PointTree::new(&directions)?;
    let mut out: Vec<(Facet, bool)> = Vec::with_capacity(points.len());
    for (i, d) in directions.iter().enumerate() {
        out.push(if d.to_vector().length_squared() > 0.5 {
            let facet = Facet::on_unit_sphere(i, d.to_vector(), &directions, &tree)?;
            let open = facet.is_open();
            (facet.scaled(center, sphere.radius), open)
        } else {
            (Facet { plane: sphere.plane, ring: Vec::new() }, false)
        });
    }
    let rim = out.iter().any(|(_, open)| *open);
    let around = match bounds {
        None if rim => {
            BoundingBox::from_points(points.iter().copied()).map(|b| b.inflated(usual_reach(&out)))
        }
        given => given.copied(),
    };
    let mut room = Vec::new();
    if let Some(b) = &around {
        out.iter_mut().for_each(|(facet, _)| facet.cut_by_box(b, &mut room));
    }
    Ok(out.into_iter().map(|(facet, _)| facet).collect())
}

/// How far the middling closed facet reaches from where it touches; 0 when all are open.
fn usual_reach(facets: &[(Facet, bool)]) -> f64 {
    let reach = |f: &Facet| f.ring.iter().map(|p| p.to_vector().length()).fold(0.0, f64::max);
    let mut all: Vec<f64> = facets.iter().filter(|(_, open)| !open).map(|(f, _)| reach(f)).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn areas(facets: &[Facet]) -> Vec<f64> {
        let area = |ring: &[Point3]| {
            let parts = ring.windows(2).map(|w| (w[0] - ring[0]).cross(w[1] - ring[0]));
            0.5 * parts.sum::<Vector3>().length()
        };
        facets.iter().map(|f| area(&f.corners())).collect()
    }

    #[test]
    fn a_cube_about_its_sphere() {
        let c = Point3::new(5.0, -1.0, 2.0);
        let axes = [Vector3::X, -Vector3::X, Vector3::Y, -Vector3::Y, Vector3::Z, -Vector3::Z];
        let mut points: Vec<Point3> = axes.iter().map(|&d| c + d * 2.0).collect();
        points.push(c + Vector3::X * 7.0);
        points.push(c);
        let sphere = Sphere::around(c, 2.0).unwrap();
        let all = facets(&points, &sphere, None).unwrap();
        let areas = areas(&all);
        assert!(areas[..6].iter().all(|a| (a - 16.0).abs() < 1e-9), "{areas:?}");
        assert_eq!(areas[6..], [0.0, 0.0]);
        assert_eq!(all[0].corners().len(), 4);
        let round = all[0].outline(Some(1.0)).unwrap().unwrap();
        assert!((round.length() - std::f64::consts::TAU).abs() < 1e-9);
        assert!(all[0].clone().within(1.0).corners().len() == 64);
        let low = BoundingBox { min: c - Vector3::new(9.0, 9.0, 9.0), max: c + Vector3::new(9.0, 9.0, 1.0) };
        let cut = facets(&points, &sphere, Some(&low)).unwrap();
        assert!(cut[4].corners().is_empty());
        assert!((cut[0].corners().iter().map(|p| p.z).fold(0.0, f64::max) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn an_open_dome_ends_with_its_points() {
        // Half of many points, spread evenly over the sphere.
        let points: Vec<Point3> = (0..150)
            .map(|i| {
                let z = 1.0 - (f64::from(i) + 0.5) / 150.0;
                let (s, c) = (f64::from(i) * 2.399_963).sin_cos();
                let r = (1.0 - z * z).sqrt();
                Point3::new(r * c, r * s, z)
            })
            .collect();
        let sphere = Sphere::around(Point3::ORIGIN, 1.0).unwrap();
        let all = facets(&points, &sphere, None).unwrap();
        let corners: Vec<Point3> = all.iter().flat_map(Facet::corners).collect();
        assert!(corners.iter().all(|p| p.to_vector().length() >= 1.0 - 1e-9));
        assert!(corners.iter().all(|p| p.to_vector().length() < 1.5 && p.z > -0.5));
        let area: f64 = areas(&all).iter().sum();
        assert!((6.2..7.8).contains(&area), "{area}");
    }
}
