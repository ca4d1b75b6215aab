//! Surfaces of equal height against closed forms, and laws that hold for any field.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use katydid_geometry::isosurface::{Isosurfacing, Metaball, MetaballField, ScalarGrid};
use katydid_geometry::{Error, Mesh, Point3, Vector3};
use proptest::prelude::*;

/// A cube of cells about the origin.
fn cube(half: f64, n: usize) -> ScalarGrid {
    let step = 2.0 * half / (n - 1) as f64;
    ScalarGrid::new(Point3::new(-half, -half, -half), Vector3::new(step, step, step), [n; 3]).unwrap()
}

fn small(counts: [usize; 3]) -> ScalarGrid {
    ScalarGrid::new(Point3::ORIGIN, Vector3::new(1.0, 1.0, 1.0), counts).unwrap()
}

/// Vertices − edges + faces.
fn euler(mesh: &Mesh) -> i64 {
    mesh.vertices().len() as i64 - mesh.edges().len() as i64 + mesh.faces().len() as i64
}

/// Closed, two faces to each edge in opposite directions, and one fan of faces around each vertex.
fn assert_solid(mesh: &Mesh) {
    assert!(mesh.is_closed() && mesh.is_manifold() && mesh.is_oriented());
    mesh.check().unwrap();
    let mut around: Vec<HashMap<u32, u32>> = vec![HashMap::new(); mesh.vertices().len()];
    for face in mesh.faces() {
        let c = face.indices();
        for k in 0..3 {
            let (v, from, to) = (c[k], c[(k + 1) % 3], c[(k + 2) % 3]);
            assert!(around[v as usize].insert(from, to).is_none());
        }
    }
    for fan in &around {
        let Some(&start) = fan.keys().next() else { panic!("a vertex without faces") };
        let (mut at, mut count) = (fan[&start], 1);
        while at != start {
            (at, count) = (fan[&at], count + 1);
        }
        assert_eq!(count, fan.len(), "two fans at a vertex");
    }
}

#[test]
fn spheres_converge_by_the_square_of_the_cell() {
    let error = |n: usize| {
        let ball = |p: Point3| 1.0 - (p - Point3::new(0.03, -0.02, 0.01)).length_squared();
        let mesh = cube(1.3, n).isosurface_of(ball, &Isosurfacing::open_at(0.0)).unwrap();
        assert_solid(&mesh);
        assert_eq!(euler(&mesh), 2);
        assert!(mesh.volume() > 0.0, "faces look to the low side");
        [(mesh.volume() / (4.0 / 3.0 * PI) - 1.0).abs(), (mesh.area() / (4.0 * PI) - 1.0).abs()]
    };
    let [coarse, fine] = [error(25), error(49)];
    for (c, f) in coarse.into_iter().zip(fine) {
        assert!(c < 0.02 && f < 0.3 * c, "{c} {f}");
    }
}

#[test]
fn a_torus_has_one_hole() {
    let torus = |p: Point3| 0.16 - (p.x.hypot(p.y) - 1.0).powi(2) - p.z * p.z;
    let mesh = cube(1.5, 61).isosurface_of(torus, &Isosurfacing::open_at(0.0)).unwrap();
    assert_solid(&mesh);
    assert_eq!(euler(&mesh), 0);
    assert!((mesh.volume() / (PI * 0.16 * TAU) - 1.0).abs() < 0.01);
    assert!((mesh.area() / (0.4 * TAU * TAU) - 1.0).abs() < 0.01);
}

#[test]
fn what_reaches_the_border_is_capped_or_open() {
    let ball = |p: Point3| 1.0 - p.to_vector().length();
    let grid = cube(0.8, 41);
    let capped = grid.isosurface_of(ball, &Isosurfacing::closed_at(0.0)).unwrap();
    assert_solid(&capped);
    assert_eq!(euler(&capped), 2);
    // A ball less six caps.
    let h = 0.2;
    let volume = 4.0 / 3.0 * PI - 6.0 * PI * h * h * (3.0 - h) / 3.0;
    assert!((capped.volume() / volume - 1.0).abs() < 2e-3);
    let open = grid.isosurface_of(ball, &Isosurfacing::open_at(0.0)).unwrap();
    assert!(!open.is_closed() && open.is_manifold() && open.is_oriented());
    assert_eq!(euler(&open), 2 - 6);
    // A single number, capped.
    let dot = small([1; 3]).isosurface(&[1.0], &Isosurfacing::closed_at(0.5)).unwrap();
    assert_solid(&dot);
    assert_eq!(dot.faces().len(), 8);
    assert!(small([1; 3]).isosurface(&[1.0], &Isosurfacing::open_at(0.5)).unwrap().faces().is_empty());
    assert!(small([0, 4, 4]).isosurface(&[], &Isosurfacing::closed_at(0.5)).unwrap().faces().is_empty());
}

#[test]
fn saddles_join_what_the_bilinear_surface_joins() {
    // Two high corners face each other on the lower side of one cell: apart below its saddle, together above.
    let mesh = |high: f64| {
        let values = [high, -1.0, -1.0, high, -1.0, -1.0, -1.0, -1.0];
        small([2; 3]).isosurface(&values, &Isosurfacing::closed_at(0.0)).unwrap()
    };
    let (apart, together) = (mesh(0.9), mesh(1.1));
    assert_solid(&apart);
    assert_solid(&together);
    assert_eq!(apart.pieces().unwrap().len(), 2);
    assert_eq!(together.pieces().unwrap().len(), 1);
}

#[test]
fn heights_that_the_grid_has_itself() {
    // Whole numbers only: every corner of the surface would lie on a corner of the grid.
    let values: Vec<f64> = (0..6 * 6 * 6).map(|k| f64::from((k * 7 + k / 5 * 3 + k / 31) % 3)).collect();
    for level in [0.0, 1.0, 2.0] {
        let mesh = small([6; 3]).isosurface(&values, &Isosurfacing::closed_at(level)).unwrap();
        assert_solid(&mesh);
        let least = mesh.triangles().map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).fold(1.0, f64::min);
        assert!(least > 1e-9, "{least}");
    }
}

#[test]
fn bad_input_is_refused() {
    let how = Isosurfacing::closed_at(0.0);
    let mut values = vec![1.0; 27];
    assert!(small([3; 3]).isosurface(&values[..26], &how).is_err());
    assert!(small([3; 3]).isosurface(&values, &Isosurfacing::closed_at(f64::NAN)).is_err());
    assert!(matches!(
        small([3; 3]).isosurface(&values, &Isosurfacing { most_faces: 20, ..how }),
        Err(Error::Invalid { .. })
    ));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        values[13] = bad;
        assert!(small([3; 3]).isosurface(&values, &how).is_err());
    }
    values[13] = f64::MAX;
    values[14] = -f64::MAX;
    assert_solid(&small([3; 3]).isosurface(&values, &Isosurfacing::closed_at(-1.0)).unwrap());
    let unit = Vector3::new(1.0, 1.0, 1.0);
    assert!(ScalarGrid::new(Point3::new(f64::NAN, 0.0, 0.0), unit, [3; 3]).is_err());
    assert!(ScalarGrid::new(Point3::ORIGIN, unit * -1.0, [3; 3]).is_err());
    assert!(ScalarGrid::new(Point3::new(1e12, 0.0, 0.0), unit, [3; 3]).is_err());
    assert!(ScalarGrid::new(Point3::ORIGIN, unit, [1 << 20, 1 << 20, 3]).is_err());
    // An error of the field ends the work.
    let mut layers = 0;
    let stopped = how.mesh(&small([4; 3]), |_, _| {
        layers += 1;
        if layers == 2 { Err(Error::NotFinite("field")) } else { Ok(()) }
    });
    assert!(stopped.is_err() && layers == 2);
}

/// A little generator (the 64-bit mixer of G. Steele and others, 2014).
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

proptest! {
    /// White noise meets every pattern; few different numbers meet every tie.
    #[test]
    fn closed_and_manifold_on_noise(seed: u64, n in 1_usize..9, m in 1_usize..9, steps in 0_u32..6) {
        let mut r = random(seed);
        let value = |x: f64| if steps == 0 { x - 0.5 } else { (x * f64::from(steps + 1)).floor() - 1.0 };
        let values: Vec<f64> = (0..n * m * 7).map(|_| value(r())).collect();
        let mesh = small([n, m, 7]).isosurface(&values, &Isosurfacing::closed_at(0.0)).unwrap();
        if values.iter().any(|v| *v >= 0.0) {
            assert_solid(&mesh);
        } else {
            prop_assert!(mesh.faces().is_empty());
        }
        // The other side of it.
        let open = small([n, m, 7]).isosurface(&values, &Isosurfacing::open_at(0.0)).unwrap();
        prop_assert!(open.is_manifold() && open.is_oriented());
    }
}

fn ball(x: f64, y: f64, z: f64, radius: f64, strength: f64) -> Metaball {
    Metaball { center: Point3::new(x, y, z), radius, strength }
}

const MANY: usize = 1 << 24;

#[test]
fn one_soft_ball_is_a_sphere() {
    for (strength, level) in [(1.0, 0.2), (3.0, 0.1)] {
        let field = MetaballField::new(&[ball(3.0, -4.0, 5.0, 2.0, strength)]).unwrap();
        let radius = 2.0 * (1.0 - (level / strength).cbrt()).sqrt();
        let mesh = field.mesh(level, 0.05, MANY, || true).unwrap();
        assert_solid(&mesh);
        assert!((mesh.volume() / (4.0 / 3.0 * PI * radius.powi(3)) - 1.0).abs() < 3e-3);
        for p in mesh.vertices() {
            assert!((p.distance_to(Point3::new(3.0, -4.0, 5.0)) - radius).abs() < 5e-3);
            assert!((field.at(*p) / level - 1.0).abs() < 0.05);
        }
    }
}

#[test]
fn soft_balls_melt_together_and_eat_away() {
    let pieces = |balls: &[Metaball]| {
        let mesh = MetaballField::new(balls).unwrap().mesh(0.2, 0.06, MANY, || true).unwrap();
        assert_solid(&mesh);
        mesh.pieces().unwrap().len()
    };
    // Each is a sphere of radius 0.644 by itself; between them each adds (1 − d²)³.
    let apart = (1.0_f64 - 0.1_f64.cbrt()).sqrt();
    assert_eq!(pieces(&[ball(-apart - 0.05, 0.0, 0.0, 1.0, 1.0), ball(apart + 0.05, 0.0, 0.0, 1.0, 1.0)]), 2);
    assert_eq!(pieces(&[ball(-apart + 0.05, 0.0, 0.0, 1.0, 1.0), ball(apart - 0.05, 0.0, 0.0, 1.0, 1.0)]), 1);
    let bitten = [ball(0.0, 0.0, 0.0, 1.0, 1.0), ball(0.0, 0.0, 0.0, 0.4, -1.0)];
    assert_eq!(pieces(&bitten), 2, "a hollow ball");
    let field = MetaballField::new(&[ball(0.0, 0.0, 0.0, 1.0, -1.0)]).unwrap();
    assert!(field.mesh(0.2, 0.06, MANY, || true).unwrap().faces().is_empty());
}

#[test]
fn soft_balls_that_cannot_be() {
    assert!(MetaballField::new(&[]).unwrap().mesh(0.2, 0.1, MANY, || true).unwrap().faces().is_empty());
    assert!(MetaballField::new(&[ball(0.0, 0.0, 0.0, 0.0, 1.0)]).is_err());
    assert!(MetaballField::new(&[ball(0.0, 0.0, 0.0, 1e300, 1.0)]).is_err());
    assert!(MetaballField::new(&[ball(f64::NAN, 0.0, 0.0, 1.0, 1.0)]).is_err());
    let one = MetaballField::new(&[ball(0.0, 0.0, 0.0, 1.0, 1.0)]).unwrap();
    for (level, cell) in [(0.0, 0.1), (-1.0, 0.1), (f64::NAN, 0.1), (0.2, 0.0), (0.2, f64::NAN), (0.2, 1e-9)]
    {
        assert!(one.mesh(level, cell, MANY, || true).is_err());
    }
    assert!(one.mesh(0.2, 0.01, 100, || true).is_err());
    let mut asked = 0;
    let stopped = one.mesh(0.2, 0.1, MANY, || {
        asked += 1;
        asked < 5
    });
    assert!(stopped.is_err() && asked == 5);
}

#[test]
fn a_hundred_thousand_balls() {
    let mut r = random(7);
    let balls: Vec<Metaball> =
        (0..100_000).map(|_| ball(60.0 * r(), 60.0 * r(), 60.0 * r(), 0.5 + r(), 1.0)).collect();
    let field = MetaballField::new(&balls).unwrap();
    let clock = std::time::Instant::now();
    let mesh = field.mesh(0.9, 0.4, MANY, || true).unwrap();
    let seconds = clock.elapsed().as_secs_f64();
    println!("{} faces in {seconds:.2} s", mesh.faces().len());
    assert!(mesh.faces().len() > 100_000);
    assert!(mesh.is_closed() && mesh.is_manifold() && mesh.is_oriented());
    // The tree and the layers see one field.
    let by_hand = |p: Point3| -> f64 {
        balls
            .iter()
            .map(|b| {
                let share = (p - b.center).length_squared() / (b.radius * b.radius);
                (1.0 - share).max(0.0).powi(3)
            })
            .sum()
    };
    for p in mesh.vertices().iter().step_by(20_011) {
        assert!((field.at(*p) - by_hand(*p)).abs() < 1e-12 * (1.0 + by_hand(*p)));
    }
}
