//! Laws of triangulations, cells, hulls and neighbours, on points at random, on grids, and far from the origin.

use katydid_geometry::cloud::{
    ConvexPolygon, Delaunay, PointTree, Voronoi, convex_hull, convex_hull_3d, proximity, voronoi_cells_3d,
};
use katydid_geometry::{BoundingBox, Interval, Point2, Point3, Vector3};
use proptest::prelude::*;

/// Points on a coarse grid, so that many share a place, a line or a circle, or anywhere; shifted and scaled.
fn clouds(most: usize) -> impl Strategy<Value = Vec<[f64; 3]>> {
    let coarse = prop::collection::vec([0..6, 0..6, 0..6].prop_map(|p: [i32; 3]| p.map(f64::from)), 0..most);
    let fine = prop::collection::vec([0.0..6.0, 0.0..6.0, 0.0..6.0], 0..most);
    let shift = prop_oneof![Just(0.0), Just(1e6), -1e3..1e3];
    (prop_oneof![coarse, fine], shift)
        .prop_map(|(points, shift)| points.into_iter().map(|p| p.map(|x| x + shift)).collect())
}

fn flat(points: &[[f64; 3]]) -> Vec<Point2> {
    points.iter().map(|p| Point2::new(p[0], p[1])).collect()
}

fn places(points: &[Point2]) -> Vec<[u64; 2]> {
    let mut places: Vec<[u64; 2]> = points.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect();
    places.sort_unstable();
    places.dedup();
    places
}

fn coord(p: Point2) -> robust::Coord<f64> {
    robust::Coord { x: p.x, y: p.y }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn delaunay_circles_are_empty(points in clouds(60)) {
        let points = flat(&points);
        let d = Delaunay::new(&points).unwrap();
        let mut used = vec![false; points.len()];
        for t in d.triangles() {
            let [a, b, c] = t.map(|i| points[i as usize]);
            prop_assert!(robust::orient2d(coord(a), coord(b), coord(c)) > 0.0);
            for &p in &points {
                prop_assert!(robust::incircle(coord(a), coord(b), coord(c), coord(p)) <= 0.0);
            }
            t.iter().for_each(|&i| used[i as usize] = true);
        }
        // Euler: V − E + F = 2, the outer face with them.
        let (v, e, f) = (places(&points).len(), d.edges().len(), d.triangles().len());
        if f > 0 {
            prop_assert_eq!(v + f + 1, e + 2);
            prop_assert_eq!(used.iter().filter(|u| **u).count(), v);
            let hull = convex_hull(&points).unwrap();
            let border = d.border();
            prop_assert!(hull.iter().all(|&i| border.contains(&(i as u32))));
        } else {
            prop_assert_eq!(e, v.saturating_sub(1));
        }
    }

    #[test]
    fn voronoi_cells_fill_the_boundary(points in clouds(60), probes in prop::collection::vec([0.0..1.0, 0.0..1.0], 20)) {
        let sites = flat(&points);
        let origin = sites.first().copied().unwrap_or_default();
        let range = |x: f64| Interval::new(x - 7.0, x + 8.0);
        let border = ConvexPolygon::rectangle(range(origin.x), range(origin.y)).unwrap();
        let v = Voronoi::new(&sites, &border).unwrap();
        if sites.is_empty() {
            return Ok(());
        }
        let scale = 1.0 + origin.x.abs() + origin.y.abs();
        let sum: f64 = (0..v.len()).map(|i| v.area(i)).sum();
        prop_assert!((sum - border.area()).abs() < 1e-12 * scale * border.area(), "{} of {}", sum, border.area());
        for (i, &site) in sites.iter().enumerate() {
            let cell = v.cell(i);
            for (k, &a) in cell.iter().enumerate() {
                let b = cell[(k + 1) % cell.len()];
                if border.contains(site) {
                    prop_assert!((b - a).cross(site - a) >= -1e-12 * scale);
                }
                // No site is nearer to a corner than its own.
                let own = a.distance_to(site);
                prop_assert!(sites.iter().all(|s| s.distance_to(a) >= own - 1e-11 * scale));
            }
        }
        for [u, w] in probes {
            let p = Point2::new(origin.x - 7.0 + 15.0 * u, origin.y - 7.0 + 15.0 * w);
            let nearest = (0..sites.len()).min_by(|&i, &j| {
                sites[i].distance_to(p).total_cmp(&sites[j].distance_to(p)).then(i.cmp(&j))
            }).unwrap();
            let cell = v.cell(nearest);
            for (k, &a) in cell.iter().enumerate() {
                let b = cell[(k + 1) % cell.len()];
                prop_assert!((b - a).cross(p - a) >= -1e-10 * scale);
            }
            prop_assert!(!cell.is_empty());
        }
    }

    #[test]
    fn hulls_hold_all_points(points in clouds(80)) {
        let points = flat(&points);
        let hull: Vec<Point2> = convex_hull(&points).unwrap().into_iter().map(|i| points[i]).collect();
        let n = hull.len();
        if n < 3 {
            prop_assert!(n == places(&points).len().min(2) || n == 2);
            return Ok(());
        }
        for k in 0..n {
            let (a, b, c) = (hull[k], hull[(k + 1) % n], hull[(k + 2) % n]);
            prop_assert!(robust::orient2d(coord(a), coord(b), coord(c)) > 0.0);
            for &p in &points {
                prop_assert!(robust::orient2d(coord(a), coord(b), coord(p)) >= 0.0);
            }
        }
    }

    #[test]
    fn hulls_in_space_hold_all_points(points in clouds(80)) {
        let points: Vec<Point3> = points.into_iter().map(Point3::from).collect();
        let Ok(hull) = convex_hull_3d(&points) else {
            return Ok(());
        };
        let coord = |p: Point3| robust::Coord3D { x: p.x, y: p.y, z: p.z };
        let mut sides: Vec<[u32; 2]> = Vec::new();
        for t in &hull {
            let [a, b, c] = t.map(|i| coord(points[i as usize]));
            for &p in &points {
                prop_assert!(robust::orient3d(a, b, c, coord(p)) >= 0.0);
            }
            sides.extend([[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
        }
        // Closed: every side is walked once each way. Euler: V − E + F = 2.
        let edges = sides.len() / 2;
        sides.sort_unstable();
        prop_assert!(sides.iter().all(|&[a, b]| sides.binary_search(&[b, a]).is_ok()));
        sides.dedup();
        prop_assert_eq!(sides.len(), 2 * edges);
        let mut corners: Vec<u32> = hull.concat();
        corners.sort_unstable();
        corners.dedup();
        prop_assert_eq!(corners.len() + hull.len(), edges + 2);
    }

    #[test]
    fn cells_in_space_fill_the_box(points in clouds(70)) {
        let sites: Vec<Point3> = points.into_iter().map(Point3::from).collect();
        let Some(&o) = sites.first() else { return Ok(()) };
        let scale = 1.0 + o.to_vector().length();
        let size = Vector3::new(7.0, 8.0, 9.0);
        let bounds = BoundingBox { min: o - size, max: o + size };
        let cells = voronoi_cells_3d(&sites, &bounds).unwrap();
        let sum: f64 = cells.iter().flatten().map(|c| c.volume()).sum();
        prop_assert!((sum - bounds.volume()).abs() < 1e-10 * scale * bounds.volume(), "{sum}");
        for (cell, &site) in cells.iter().zip(&sites) {
            let Some(cell) = cell else { continue };
            let mesh = cell.to_mesh().unwrap();
            prop_assert!(mesh.is_closed() && mesh.is_oriented());
            for &v in cell.vertices() {
                let own = v.distance_to(site);
                prop_assert!(sites.iter().all(|s| s.distance_to(v) >= own - 1e-9 * scale));
            }
            for k in 0..cell.face_count() {
                if let Some(j) = cell.beyond(k) {
                    for &i in cell.face(k) {
                        let v = cell.vertices()[i as usize];
                        prop_assert!((v.distance_to(site) - v.distance_to(sites[j])).abs() < 1e-9 * scale);
                    }
                }
            }
        }
    }

    #[test]
    fn neighbours_are_the_nearest(points in clouds(90), count in 0_usize..12, least in 0.0..2.0, span in 0.0..4.0) {
        let points: Vec<Point3> = points.into_iter().map(Point3::from).collect();
        let found = proximity(&points, count, [least, least + span]).unwrap();
        for (i, near) in found.iter().enumerate() {
            let squared = |j: usize| (points[j] - points[i]).length_squared();
            let mut all: Vec<usize> = (0..points.len())
                .filter(|&j| j != i && squared(j) >= least * least && squared(j) <= (least + span) * (least + span))
                .collect();
            all.sort_by(|&a, &b| squared(a).total_cmp(&squared(b)).then(a.cmp(&b)));
            all.truncate(count);
            prop_assert_eq!(near, &all);
        }
        prop_assert_eq!(PointTree::new(&points).unwrap().nearest(Point3::ORIGIN, usize::MAX, [0.0, 1e12], None).len(), points.len());
    }
}
