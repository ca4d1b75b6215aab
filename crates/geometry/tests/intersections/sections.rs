//! Sections of random surfaces and meshes by random planes: nothing is missed, and nothing ends inside.

use katydid_geometry::intersect::surface_plane;
use katydid_geometry::{
    Direction, NurbsSurface, Plane, Point3, Surface, Tolerance, Vector3, clamped_uniform_knots,
};

/// Numbers in −1…1 that look random.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 / (1_u64 << 52) as f64) - 1.0
    }
}

fn surface(numbers: &mut Numbers, degrees: [usize; 2], counts: [usize; 2], rational: bool) -> Surface {
    let mut points = Vec::new();
    let mut weights = Vec::new();
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            let (x, y) = (i as f64 + 0.3 * numbers.next(), j as f64 + 0.3 * numbers.next());
            points.push(Point3::new(x, y, 2.0 * numbers.next()));
            weights.push(if rational { 1.5 + numbers.next() } else { 1.0 });
        }
    }
    let knots = [0, 1].map(|d| clamped_uniform_knots(degrees[d], counts[d]).unwrap());
    let made = if rational {
        NurbsSurface::with_weights(degrees, counts, &points, &weights, knots)
    } else {
        NurbsSurface::new(degrees, counts, points, knots)
    };
    made.unwrap().into()
}

#[test]
fn nothing_is_missed() {
    let mut numbers = Numbers(7);
    let mut curves_seen = 0;
    for k in 0..24 {
        let degrees = [1 + k % 4, 1 + (k / 4) % 3];
        let made = surface(&mut numbers, degrees, [5, 6], k % 2 == 1);
        let normal = Vector3::new(numbers.next(), numbers.next(), 2.0 * numbers.next());
        let through = Point3::new(2.0 + numbers.next(), 2.5 + numbers.next(), 0.5 * numbers.next());
        let plane = Plane::from_normal(through, normal).unwrap();
        let section = surface_plane(&made, &plane, &Tolerance::default()).unwrap();
        assert!(section.complete, "{k}");
        curves_seen += section.curves.len();
        let domains = Direction::BOTH.map(|d| made.domain(d));
        for curve in &section.curves {
            for i in 0..=40 {
                let q = curve.point_at(curve.domain().at(f64::from(i) / 40.0));
                assert!(plane.signed_distance(q).abs() < 1e-3, "{k}");
                assert!(made.closest_point(q).unwrap().distance < 1e-3, "{k}");
            }
            if !curve.is_closed() {
                for q in [curve.start(), curve.end()] {
                    let near = made.closest_point(q).unwrap();
                    let inside = [near.u, near.v]
                        .iter()
                        .zip(domains)
                        .all(|(x, d)| x - d.start > 1e-3 && d.end - x > 1e-3);
                    assert!(!inside, "{k}: a curve ends inside at {near:?}");
                }
            }
        }
        for along in Direction::BOTH {
            let across = domains[along.other().index()];
            for i in 0..=12 {
                let iso = made.isocurve(along, across.at(f64::from(i) / 12.0)).unwrap();
                for t in iso.intersect_plane(&plane, 0.0).unwrap() {
                    let q = iso.point_at(t);
                    let miss = section
                        .curves
                        .iter()
                        .map(|c| c.closest_point(q).unwrap().distance)
                        .fold(f64::INFINITY, f64::min);
                    assert!(miss < 2e-3, "{k}: {q:?} is missed by {miss}");
                }
            }
        }
    }
    assert!(curves_seen > 24);
}
