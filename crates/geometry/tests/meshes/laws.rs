//! Meshes: counts that Grasshopper shows, measures with known answers, topology.

use crate::common::{close, close_points, close_vectors};
use katydid_geometry::{
    BoundingBox, Box3, Interval, Mesh, MeshFace, Plane, Point3, Rectangle, Vector3, Xform,
};
use std::f64::consts::{FRAC_PI_2, PI};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn cube(n: usize) -> Mesh {
    let frame = Plane::from_normal(p(1.0, 2.0, 3.0), Vector3::new(1.0, 1.0, 2.0)).unwrap();
    let side = Interval::new(-0.3, 1.7);
    Mesh::cuboid(&Box3 { plane: frame, x: side, y: side, z: side }, n, n, n).unwrap()
}

#[test]
fn box_counts_are_grasshoppers() {
    let m = cube(10);
    assert_eq!((m.vertices().len(), m.faces().len()), (726, 600));
    assert_eq!(m.welded(91.0 * PI / 180.0).vertices().len(), 602);
    assert_eq!(m.welded(80.0 * PI / 180.0).vertices().len(), 726);
    assert_eq!(m.welded(PI).vertices().len(), 602);
    assert_eq!(m.welded(PI).unwelded(FRAC_PI_2).vertices().len(), 726);
    assert!(m.check().is_ok());
}

#[test]
fn box_measures() {
    for n in [1, 3] {
        let m = cube(n);
        close(m.area(), 24.0, 1e-13, "area");
        close(m.volume(), 8.0, 1e-13, "volume, outwards");
        close(m.flipped().volume(), -8.0, 1e-13, "volume, inwards");
        let center = m.volume_and_centroid().1.unwrap();
        close_points(m.area_and_centroid().1.unwrap(), center, 1e-13, "centroids");
        assert!(m.is_closed() && m.is_manifold() && m.is_oriented());
        let edges = m.edges();
        // Euler: V − E + F = 2 on the welded cube.
        let welded = m.welded(PI);
        assert_eq!(welded.vertices().len() + welded.faces().len(), edges.len() + 2);
        assert!(edges.iter().all(|e| e.faces == 2));
    }
}

#[test]
fn sphere_approaches_its_volume() {
    let m = Mesh::sphere(&Plane::XZ, 2.0, 10, 20).unwrap();
    assert_eq!(m.vertices().len(), 10 * 19 + 2);
    assert!(m.is_closed() && m.is_oriented() && m.check().is_ok());
    let fine = Mesh::sphere(&Plane::XZ, 2.0, 200, 100).unwrap();
    close(fine.volume(), 4.0 / 3.0 * PI * 8.0, 1e-3, "volume");
    close(fine.area(), 16.0 * PI, 1e-3, "area");
    for (n, want) in fine.vertex_normals().iter().zip(fine.normals()) {
        assert!(n.angle_to(*want).unwrap() < 0.02);
    }
    assert!(Mesh::sphere(&Plane::XY, 0.0, 8, 8).is_err());
    assert!(Mesh::sphere(&Plane::XY, 1.0, 2, 8).is_err());
    assert!(Mesh::sphere(&Plane::XY, 1.0, usize::MAX, 8).is_err());
}

#[test]
fn open_mesh_and_its_edges() {
    let r = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(0.0, 2.0) };
    let m = Mesh::plane(&r, 3, 2).unwrap();
    assert_eq!((m.vertices().len(), m.faces().len()), (12, 6));
    close(m.area(), 6.0, 1e-15, "area");
    assert!(!m.is_closed());
    let count = |n: usize| m.edges().iter().filter(|e| e.faces == n).count();
    assert_eq!((count(1), count(2), count(3)), (10, 7, 0));
    assert_eq!(m.vertices()[1], p(1.0, 0.0, 0.0));
    assert!(m.normals().iter().all(|n| (*n - Vector3::Z).length() < 1e-15));
    close_points(m.face_centers()[0], p(0.5, 0.5, 0.0), 1e-15, "first face");
    let three = Mesh::new(
        vec![p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, 1.0, 0.0), p(0.0, -1.0, 0.0), p(0.0, 0.0, 1.0)],
        vec![MeshFace::Triangle([0, 1, 2]), MeshFace::Triangle([1, 0, 3]), MeshFace::Triangle([0, 1, 4])],
    )
    .unwrap();
    assert!(!three.is_manifold());
}

#[test]
fn closest_points() {
    let m = cube(2);
    let outside = p(10.0, -4.0, 6.0);
    let found = m.closest_point(outside).unwrap();
    let sum: Vector3 =
        m.face_points(found.face).unwrap().iter().zip(found.weights).map(|(q, w)| q.to_vector() * w).sum();
    close_points(sum.to_point(), found.point, 1e-13, "weights give the point");
    for q in m.vertices() {
        assert!(m.closest_point(*q).unwrap().distance < 1e-13);
        assert!(q.distance_to(outside) >= found.distance - 1e-13);
    }
    assert!(Mesh::default().closest_point(outside).is_err());
    assert!(m.closest_point(p(f64::NAN, 0.0, 0.0)).is_err());
}

#[test]
fn transforms_keep_outside_outside() {
    let m = cube(2);
    let mirrored = m.transformed(&Xform::mirror(&Plane::YZ)).unwrap();
    close(mirrored.volume(), 8.0, 1e-13, "mirrored");
    let squashed = m.transformed(&Xform::scale_non_uniform(&Plane::XY, 2.0, 3.0, 0.5)).unwrap();
    close(squashed.volume(), 24.0, 1e-13, "scaled");
    for (a, b) in squashed.normals().iter().zip(squashed.vertex_normals()) {
        close_vectors(*a, b, 1e-12, "normals go by the inverse transpose");
    }
    let both = Mesh::join(&[m.clone(), mirrored]).unwrap();
    close(both.volume(), 16.0, 1e-13, "joined");
    assert_eq!(both.vertices().len(), 2 * m.vertices().len());
    assert!(m.transformed(&Xform::scale(Point3::ORIGIN, f64::MAX)).is_err());
    assert_eq!(m.with_colours(&[[1, 2, 3, 4], [5, 6, 7, 8]]).colours()[2], [1, 2, 3, 4]);
}

#[test]
fn bad_meshes_are_refused() {
    let points = vec![p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(2.0, 0.0, 0.0)];
    let why = |r: katydid_geometry::Result<Mesh>| r.unwrap_err().to_string();
    assert!(why(Mesh::new(points.clone(), vec![MeshFace::Triangle([0, 1, 3])])).contains("face 0"));
    assert!(why(Mesh::new(vec![p(f64::INFINITY, 0.0, 0.0)], vec![])).contains("vertex 0"));
    assert!(
        why(Mesh::from_parts(points.clone(), vec![], vec![Vector3::Z], vec![])).contains("1 normals for 3")
    );
    let flat = Mesh::new(points.clone(), vec![MeshFace::Triangle([0, 1, 2])]).unwrap();
    assert!(flat.check().unwrap_err().to_string().contains("no area"));
    let twice = Mesh::new(points, vec![MeshFace::Triangle([0, 1, 1])]).unwrap();
    assert!(twice.check().unwrap_err().to_string().contains("twice"));
    assert!(Mesh::default().check().is_err() && !Mesh::default().is_closed());
    assert_eq!(Mesh::default().bounding_box(), None);
    assert!(Mesh::join(&[]).unwrap().faces().is_empty());
}

#[test]
fn boxes() {
    let b = BoundingBox::from_points([p(1.0, 2.0, 3.0), p(-1.0, 5.0, 0.0)]).unwrap();
    assert_eq!((b.min, b.max), (p(-1.0, 2.0, 0.0), p(1.0, 5.0, 3.0)));
    assert_eq!(b.corners()[6], b.max);
    assert_eq!(b.distance_to(p(1.0, 9.0, 6.0)), 5.0);
    assert_eq!(BoundingBox::from_points([]), None);
    assert_eq!(BoundingBox::from_points([p(f64::NAN, 0.0, 0.0)]), None);
    let solid = Box3::from(b);
    assert_eq!((solid.volume(), solid.area()), (18.0, 2.0 * (6.0 + 9.0 + 6.0)));
    assert_eq!(solid.bounding_box(), b);
    assert!(solid.contains(b.center(), 0.0) && !solid.contains(p(9.0, 0.0, 0.0), 1.0));
    let turned = solid.transformed(&Xform::scale(Point3::ORIGIN, -2.0)).unwrap();
    close(turned.volume(), 8.0 * 18.0, 1e-14, "mirrored and scaled");
    let image = b.transformed(&Xform::scale(Point3::ORIGIN, -2.0)).unwrap();
    close_points(turned.bounding_box().min, image.min, 1e-14, "the same place");
    close_points(turned.bounding_box().max, image.max, 1e-14, "the same place");
    assert!(solid.transformed(&Xform::scale_non_uniform(&Plane::XY, 1.0, 2.0, 1.0)).is_err());
}
