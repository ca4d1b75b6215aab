//! The outlines of a mesh's shadow.

use crate::mesh::thresholds::{LIGHT_ALONG, SHADOW_STRAIGHT};
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use katydid_elementary::Elementary;
use manifold_rust::cross_section::CrossSection;
use manifold_rust::linalg::Vec2;

use super::Mesh;
use crate::{Error, Plane, Point2, Point3, Result, Vector3};

/// The union is made on a grid of 10⁻⁸ units; the shadow is brought to this size first, so that the grid is 10⁻¹² of it.
const SIZE: f64 = 1e4;
/// Outlines that enclose less than this part of the shadow's square are seams between triangles, not holes.
const LEAST: f64 = 1e-14;

impl Mesh {
    /// The outlines of the shadow that light along a vector throws on a plane: closed polylines in the plane, the first
    /// point not repeated, outer ones counter-clockwise about the plane's normal, holes clockwise. The whole mesh throws
    /// a shadow, also what lies behind the plane. Corners are exact to about 10⁻¹² of the shadow's size.
    ///
    /// # Errors
    /// The light runs along the plane, or something is not finite.
    pub fn shadow(&self, light: Vector3, plane: &Plane) -> Result<Vec<Vec<Point3>>> {
        if !light.is_finite() || !plane.is_finite() {
            return Err(Error::NotFinite("light or plane of a shadow"));
        }
        let light = light.unitized().ok_or(Error::degenerate("light", "it has no direction"))?;
        let normal = plane.z_axis;
        let down = normal.dot(light);
        if down.abs() <= LIGHT_ALONG {
            return Err(Error::degenerate("light", "it runs along the plane and throws no shadow on it"));
        }
        let fall = |p: Point3| {
            let foot = p - light * (plane.signed_distance(p) / down);
            let [x, y, _] = plane.coordinates(foot);
            Point2::new(x, y)
        };
        let flat: Vec<Point2> = self.vertices.iter().map(|&p| fall(p)).collect();
        let rim = self.rim_of(&flat);
        let all = || rim.iter().flatten();
        let bound = |pick: fn(f64, f64) -> f64, start: f64| {
            all().fold([start; 2], |m, p| [pick(m[0], p.x), pick(m[1], p.y)])
        };
        let (low, high) = (bound(f64::min, f64::INFINITY), bound(f64::max, f64::NEG_INFINITY));
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        if rim.is_empty() || extent == 0.0 {
            return Ok(Vec::new());
        }
        if !(extent.is_finite() && extent > f64::MIN_POSITIVE * SIZE) {
            return Err(Error::NotFinite("shadow"));
        }
        let scale = SIZE / extent;
        let middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        let place = |p: Point2| Vec2 { x: (p.x - middle[0]) * scale, y: (p.y - middle[1]) * scale };
        let rim = rim.into_iter().map(|l| l.into_iter().map(place).collect()).collect();
        let Ok(loops) = catch_unwind(AssertUnwindSafe(|| CrossSection::new(rim).to_polygons())) else {
            return Err(Error::Invalid {
                what: "mesh for a shadow",
                why: "its outlines could not be found".into(),
            });
        };
        let back = |v: &Vec2| plane.at(v.x / scale + middle[0], v.y / scale + middle[1], 0.0);
        let outlines = loops.iter().map(|l| cleaned(l)).filter(|l| area(l).abs() > LEAST * SIZE * SIZE);
        Ok(outlines.map(|l| l.iter().map(back).collect()).collect())
    }

    /// Closed loops that go round each point of the shadow as often as triangles lie over it, all counter-clockwise:
    /// the sides that are left when those that neighbours walk in opposite directions are taken out. So the union has
    /// to deal with the silhouette only, not with every triangle.
    fn rim_of(&self, flat: &[Point2]) -> Vec<Vec<Point2>> {
        let merged = self.merged_indices();
        let at = |i: u32| flat.get(i as usize).copied().unwrap_or(Point2::new(0.0, 0.0));
        // The faces of a closed mesh that look one way have the whole shadow.
        let closed = self.is_closed() && self.is_oriented();
        let mut sides: HashMap<[u32; 2], i64> = HashMap::new();
        for t in self.faces.iter().flat_map(|f| f.triangles()) {
            let [a, mut b, mut c] = t.map(|i| merged.get(i as usize).copied().unwrap_or(i));
            let area = (at(b) - at(a)).cross(at(c) - at(a));
            if area == 0.0 || (area < 0.0 && closed) {
                continue;
            }
            if area < 0.0 {
                std::mem::swap(&mut b, &mut c);
            }
            for (i, j) in [(a, b), (b, c), (c, a)] {
                *sides.entry([i.min(j), i.max(j)]).or_default() += if i < j { 1 } else { -1 };
            }
        }
        let mut walks: Vec<[u32; 2]> = Vec::new();
        for ([i, j], times) in sides {
            let walk = if times > 0 { [i, j] } else { [j, i] };
            walks.extend((0..times.unsigned_abs()).map(|_| walk));
        }
        walks.sort_unstable();
        // The next side that leaves a place, as places are in order.
        let mut next: HashMap<u32, usize> = HashMap::new();
        for (k, walk) in walks.iter().enumerate() {
            next.entry(walk[0]).or_insert(k);
        }
        let mut loops = Vec::new();
        for start in walks.iter().map(|w| w[0]) {
            let (mut here, mut corners) = (start, Vec::new());
            // As many sides leave a place as come to it, so every walk comes back to its start.
            while let Some(k) = next.get_mut(&here)
                && let Some([_, to]) = walks.get(*k).filter(|w| w[0] == here)
            {
                *k += 1;
                corners.push(at(here));
                here = *to;
                if here == start {
                    break;
                }
            }
            if corners.len() > 2 {
                loops.push(corners);
            }
        }
        loops
    }
}

fn area(outline: &[Vec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
}

/// The outline without corners that lie on a straight line, where triangles meet at its edge.
fn cleaned(outline: &[Vec2]) -> Vec<Vec2> {
    let n = outline.len();
    let turns = |k: usize| {
        let [a, b, c] = [(k + n - 1) % n, k, (k + 1) % n].map(|k| outline[k]);
        let (u, v) = ([b.x - a.x, b.y - a.y], [c.x - b.x, c.y - b.y]);
        let longest = u[0].hypotenuse(u[1]).max(v[0].hypotenuse(v[1]));
        let cross = u[0] * v[1] - u[1] * v[0];
        let ahead = u[0] * v[0] + u[1] * v[1];
        // Off the line by more than a few cells of the grid.
        !(cross.abs() <= SHADOW_STRAIGHT * longest && ahead > 0.0)
    };
    (0..n).filter(|&k| turns(k)).map(|k| outline[k]).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::{Box3, Interval, Mesh, Plane, Point3, Vector3};

    fn area(outline: &[Point3]) -> f64 {
        let next = outline.iter().cycle().skip(1);
        0.5 * outline.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
    }

    #[test]
    fn boxes_and_rings() {
        let side = Interval::new(1.0, 3.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 3, 3, 3).unwrap();
        let down = cube.shadow(Vector3::new(0.0, 0.0, -1.0), &Plane::XY).unwrap();
        assert_eq!(down.len(), 1);
        assert_eq!(down[0].len(), 4);
        assert!((area(&down[0]) - 4.0).abs() < 1e-9);
        assert!(down[0].iter().all(|p| p.z == 0.0));
        // Along the diagonal of a face the shadow is a hexagon or a rectangle of known area.
        let slanted = cube.shadow(Vector3::new(1.0, 0.0, -1.0), &Plane::XY).unwrap();
        assert!((area(&slanted[0]) - 8.0).abs() < 1e-9);
        assert!((slanted[0].iter().map(|p| p.x).fold(f64::INFINITY, f64::min) - 2.0).abs() < 1e-9);
        let skew = cube.shadow(Vector3::new(1.0, 1.0, -1.0), &Plane::XY).unwrap();
        assert_eq!(skew[0].len(), 6);
        // |n·l| summed over the three visible faces.
        assert!((area(&skew[0]) - 12.0).abs() < 1e-9);
        assert!(cube.shadow(Vector3::new(1.0, 0.0, 0.0), &Plane::XY).is_err());
        assert!(cube.shadow(Vector3::ZERO, &Plane::XY).is_err());
        assert!(Mesh::default().shadow(Vector3::Z, &Plane::XY).unwrap().is_empty());

        let torus = crate::Torus::new(Plane::XY, 3.0, 1.0).unwrap().into();
        let ring =
            Mesh::from_surface(&torus, &crate::SurfaceMeshing { max_distance: 0.001, ..Default::default() });
        let ring = ring.unwrap().shadow(Vector3::new(0.0, 0.0, -2.0), &Plane::XY).unwrap();
        assert_eq!(ring.len(), 2);
        let areas: Vec<f64> = ring.iter().map(|l| area(l)).collect();
        assert!(areas.iter().any(|a| (a - 16.0 * PI).abs() < 0.1), "{areas:?}");
        assert!(areas.iter().any(|a| (a + 4.0 * PI).abs() < 0.1), "{areas:?}");
    }

    #[test]
    fn an_open_sheet() {
        let side = Interval::new(0.0, 1.0);
        let plane = Plane { origin: Point3::new(0.0, 0.0, 5.0), ..Plane::XY };
        let sheet = Mesh::plane(&crate::Rectangle { plane, x: side, y: side }, 4, 4).unwrap();
        for sheet in [sheet.flipped(), sheet] {
            let outline = sheet.shadow(Vector3::new(0.0, 0.0, -1.0), &Plane::XY).unwrap();
            assert_eq!(outline.len(), 1);
            assert!((area(&outline[0]) - 1.0).abs() < 1e-9);
        }
    }
}
