//! Meshes that are seen whole from one point inside: they do not go through themselves.

use manifold_rust::linalg::Vec3;
use manifold_rust::manifold::Manifold;
use robust::Coord3D;

/// What a determinant of differences of coordinates below 10⁶⁰ must pass to be told from what is lost where products of
/// small numbers become zero: a few hundred times 5·10⁻³²⁴, times 10¹²⁰.
const LOST_TO_UNDERFLOW: f64 = 1e-200;

/// Whether some point sees the outside of no triangle and every direction from it meets the boundary once. False where
/// this was not found for the two points that are tried: it says nothing of the mesh.
///
/// # Method
/// From a point that has all triangles facing away from it, the boundary is projected onto a sphere without folds. The
/// boundary is closed, so it covers the sphere as often everywhere as in one direction, and where that is once, the
/// projection has an inverse: the boundary is a graph over the sphere and cannot meet itself. Signs are exact (J. R.
/// Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*, 1997).
pub(super) fn is_star_shaped(body: &Manifold) -> bool {
    let mesh = body.as_impl();
    if mesh.is_soup {
        return false;
    }
    let place = |i: i32| usize::try_from(i).ok().and_then(|i| mesh.vert_pos.get(i)).map(coord);
    let corner = |half: &manifold_rust::types::Halfedge| place(half.start_vert);
    let triangles: Option<Vec<[Coord3D<f64>; 3]>> = mesh
        .halfedge
        .chunks_exact(3)
        .map(|t| match t {
            [a, b, c] => Some([corner(a)?, corner(b)?, corner(c)?]),
            _ => None,
        })
        .collect();
    let Some(triangles) = triangles else { return false };
    let middle = body.bounding_box().center();
    [coord(&middle), mean(&mesh.vert_pos)].into_iter().any(|from| sees_all_once(&triangles, from))
}

fn coord(p: &Vec3) -> Coord3D<f64> {
    Coord3D { x: p.x, y: p.y, z: p.z }
}

fn mean(points: &[Vec3]) -> Coord3D<f64> {
    let share = 1.0 / points.len().max(1) as f64;
    points.iter().fold(Coord3D { x: 0.0, y: 0.0, z: 0.0 }, |sum, p| Coord3D {
        x: sum.x + p.x * share,
        y: sum.y + p.y * share,
        z: sum.z + p.z * share,
    })
}

fn sees_all_once(triangles: &[[Coord3D<f64>; 3]], from: Coord3D<f64>) -> bool {
    let seen = |a, b, c| robust::orient3d(a, b, c, from);
    if !triangles.iter().all(|&[a, b, c]| seen(a, b, c) > LOST_TO_UNDERFLOW) {
        return false;
    }
    let Some(&[a, b, c]) = triangles.first() else { return false };
    let third = |x: f64, y: f64, z: f64| (x + y + z) / 3.0;
    let towards = Coord3D { x: third(a.x, b.x, c.x), y: third(a.y, b.y, c.y), z: third(a.z, b.z, c.z) };
    // A side that the direction goes through counts for both of its triangles: twice is refused, too.
    let meets = |&&[a, b, c]: &&[Coord3D<f64>; 3]| {
        [(a, b), (b, c), (c, a)].into_iter().all(|(p, q)| seen(p, q, towards) >= -LOST_TO_UNDERFLOW)
    };
    triangles.iter().filter(meets).take(2).count() == 1
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::Solid;
    use crate::{Box3, Interval, Mesh, Plane, Point3, Vector3, Xform};

    fn ball(centre: Point3) -> Mesh {
        Mesh::sphere(&Plane::XY.with_origin(centre), 1.0, 12, 8).unwrap()
    }

    fn proven(mesh: &Mesh) -> bool {
        Solid::new(mesh).unwrap().proven
    }

    #[test]
    fn what_is_seen_whole_from_within() {
        assert!(proven(&ball(Point3::new(3.0, -7.0, 100.0))));
        let side = Interval::new(-1.0, 2.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 3, 2, 1).unwrap();
        assert!(proven(&cube));
        assert!(proven(&cube.flipped()));
    }

    #[test]
    fn what_covers_every_direction_twice_is_not() {
        // Two balls about one point face away from it everywhere, though they do not touch.
        let within = ball(Point3::ORIGIN);
        let grown = within.transformed(&Xform::scale(Point3::ORIGIN, 2.0)).unwrap();
        assert!(!proven(&Mesh::join(&[within, grown]).unwrap()));
    }

    #[test]
    fn two_balls_apart_or_through_one_another_are_not() {
        for by in [1.0, 5.0] {
            let other = ball(Point3::ORIGIN + Vector3::X * by);
            assert!(!proven(&Mesh::join(&[ball(Point3::ORIGIN), other]).unwrap()));
        }
    }

    #[test]
    fn what_is_too_small_for_products_is_searched() {
        let tiny = ball(Point3::ORIGIN).transformed(&Xform::scale(Point3::ORIGIN, 1e-90)).unwrap();
        assert!(!proven(&tiny));
    }

    proptest! {
        /// The library's own exact search finds nothing where the proof holds, and radii without folds are proven.
        #[test]
        fn what_is_proven_does_not_go_through_itself(
            radii in prop::collection::vec(-0.3..1.5, 64..90),
            shift in prop::array::uniform3(-0.8..0.8),
        ) {
            let mesh = ball(Point3::ORIGIN);
            let radius = |i: usize| radii.get(i).copied().unwrap_or(1.0);
            let pulled = |(i, p): (usize, &Point3)| Point3::ORIGIN + (*p - Point3::ORIGIN) * radius(i);
            let vertices: Vec<Point3> = mesh.vertices().iter().enumerate().map(pulled).collect();
            let moved = Xform::translation(Vector3::new(shift[0], shift[1], shift[2]));
            let crumpled = Mesh::new(vertices, mesh.faces().to_vec()).unwrap().transformed(&moved).unwrap();
            let Ok(solid) = Solid::new(&crumpled) else { return Ok(()) };
            if solid.proven {
                prop_assert!(!solid.body.has_self_intersections());
            }
        }
    }
}
