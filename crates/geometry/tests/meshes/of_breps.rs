//! Meshes of faces that are hard to mesh: no edge has more than two triangles, and none of those looks backwards.

use katydid_geometry::brep::Brep;
use katydid_geometry::{
    BrepMesh, Curve, Direction, MeshSettings, NurbsSurface, Point3, PolylineCurve, Sphere, Surface, Tolerance,
};

/// What is wrong with the mesh of a brep: edges with more than two triangles or with two that run the same way, triangles
/// that look backwards, and points that are off the surface.
fn wrong(brep: &Brep, mesh: &BrepMesh, tolerance: f64) -> Vec<String> {
    let mut out = Vec::new();
    let one = mesh.welded().unwrap();
    let crowded = one.edges().iter().filter(|e| e.faces > 2).count();
    if crowded > 0 || !one.is_oriented() {
        out.push(format!("{crowded} edges are crowded, oriented: {}", one.is_oriented()));
    }
    for face in mesh.faces() {
        let surface = brep.face_surface(face.face).unwrap();
        for corners in face.faces.iter().flat_map(|f| f.triangles()) {
            let flat = corners.map(|v| face.parameters[v as usize]);
            let [a, b, c] = corners.map(|v| mesh.points()[face.places[v as usize] as usize]);
            let across = (b - a).cross(c - a);
            let long = (b - a).length().max((c - a).length()).max((c - b).length());
            let mean = |x: [f64; 3]| (x[0] + x[1] + x[2]) / 3.0;
            let normal = surface.normal_at(mean(flat.map(|p| p.x)), mean(flat.map(|p| p.y)));
            if normal.is_some_and(|n| across.dot(n) < 0.0) && across.length() > 1e-9 * long * long {
                out.push(format!("backwards: {flat:?}"));
            }
            let middle = Point3::new(mean([a.x, b.x, c.x]), mean([a.y, b.y, c.y]), mean([a.z, b.z, c.z]));
            let off = surface.closest_point(middle).unwrap().distance;
            if off > 1.001 * tolerance {
                out.push(format!("{} of the tolerance off: {flat:?}", off / tolerance));
            }
        }
    }
    out
}

fn polygon(corners: &[[f64; 2]]) -> Curve {
    let round = corners.iter().chain(corners.first());
    PolylineCurve::new(round.map(|&[u, v]| Point3::new(u, v, 0.0)).collect()).unwrap().into()
}

fn frame(surface: &Surface) -> Curve {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    polygon(&[[u.start, v.start], [u.end, v.start], [u.end, v.end], [u.start, v.end]])
}

fn trimmed(surface: &Surface, loops: &[Curve]) -> Brep {
    let tolerance = Tolerance { absolute: 1e-6, ..Tolerance::default() };
    let mut breps = Brep::from_parameter_loops(surface, loops, &tolerance).unwrap();
    assert_eq!(breps.len(), 1);
    breps.remove(0)
}

/// A hole with a corner just below the pole: from there the pole is seen to both sides of what lies between.
#[test]
fn a_hole_beside_a_pole() {
    let surface: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().to_nurbs().unwrap().into();
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    for gap in [0.01, 0.04] {
        for turn in [0.31, 0.44, 0.5] {
            let hole = polygon(&[
                [u.at(turn), v.at(1.0 - gap)],
                [u.at(turn - 0.05), v.at(0.8)],
                [u.at(turn + 0.04), v.at(0.75)],
            ]);
            let brep = trimmed(&surface, &[frame(&surface), hole]);
            let mesh = brep.mesh(&MeshSettings::within(0.03)).unwrap();
            let found = wrong(&brep, &mesh, 0.03);
            assert!(found.is_empty(), "{gap} {turn}: {found:#?}");
        }
    }
}

/// A parabolic cylinder over lines that are almost one curve: X = v + u/2, Y = X² + u/500, Z = X²/5.
fn sheared() -> Surface {
    let (k, wide) = (0.5, 0.05);
    let (first, square) = ([0.0, 0.5, 1.0], [0.0, 0.0, 1.0]);
    let mut points = Vec::new();
    for i in 0..3 {
        for j in 0..3 {
            let x = first[j] + k * first[i];
            let xx = square[j] + 2.0 * k * first[i] * first[j] + k * k * square[i];
            points.push(Point3::new(x, xx + wide * first[i], 0.2 * xx));
        }
    }
    let knots = vec![0.0, 0.0, 1.0, 1.0];
    NurbsSurface::new([2, 2], [3, 3], points, [knots.clone(), knots]).unwrap().into()
}

/// Where lines of both parameters run almost along each other, chords of one pass over the next.
#[test]
fn parameters_along_each_other() {
    let surface = sheared();
    let brep = Brep::from_surface(surface).unwrap();
    let mesh = brep.mesh(&MeshSettings::within(0.001)).unwrap();
    let found = wrong(&brep, &mesh, 0.001);
    assert!(found.is_empty(), "{found:#?}");
}

/// A wavy strip, degree 3 by 2, with knots at v = 1, 2, ….
fn wavy() -> Surface {
    let [n, m] = [7, 8];
    let mut points = Vec::new();
    for i in 0..n {
        for j in 0..m {
            let (x, y) = (i as f64, j as f64);
            points.push(Point3::new(x, y, (0.9 * x).sin() + 0.3 * (1.1 * y).cos()));
        }
    }
    let knots = |degree: usize, count: usize| -> Vec<f64> {
        let last = count - degree;
        let mut out = vec![0.0; degree];
        out.extend((1..last).map(|k| k as f64));
        out.extend(vec![last as f64; degree]);
        out
    };
    NurbsSurface::new([3, 2], [n, m], points, [knots(3, n), knots(2, m)]).unwrap().into()
}

/// Trims that run along a line where pieces of the surface meet, but for rounding: no strip between, whose triangles
/// would stand on their edges.
#[test]
fn trims_almost_on_lines_of_the_surface() {
    let surface = wavy();
    for by in [0.0, 1e-15, -3e-9, 3e-8, -2e-7, 9e-7] {
        // Both sides waver by as much as they are off.
        let face =
            polygon(&[[0.4, 2.0], [2.1, 2.0 + by], [3.7, 2.0], [3.7, 4.0 + by], [2.0, 4.0], [0.4, 4.0 - by]]);
        let slot = polygon(&[[1.0, 3.0 + by], [3.0, 3.0 + by], [3.0, 3.4], [1.0, 3.4]]);
        let brep = trimmed(&surface, &[face, slot]);
        for tolerance in [0.03, 0.003] {
            let mesh = brep.mesh(&MeshSettings::within(tolerance)).unwrap();
            let found = wrong(&brep, &mesh, tolerance);
            assert!(found.is_empty(), "{by} {tolerance}: {found:#?}");
        }
    }
}
