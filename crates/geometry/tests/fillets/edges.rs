//! Single edges, chains and whole rims, rounded.

use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

use katydid_geometry::brep::{FilletBlend, FilletRail};
use katydid_geometry::construct;
use katydid_geometry::{
    Brep, Circle, Curve, Cylinder, Interval, Line, NurbsCurve, Plane, Point3, PolylineCurve, Tolerance,
    Vector3,
};

use super::{ELL, GAP, TOLERANCE, cuboid, holds, near, outline, p, prism};

fn ell() -> Brep {
    prism(&ELL, 3.0)
}

/// The edges whose middle a rule holds for.
fn edges(brep: &Brep, rule: impl Fn(Point3) -> bool) -> Vec<usize> {
    (0..brep.edges().len())
        .filter(|edge| rule(brep.edge_point(*edge, brep.edges()[*edge].part.domain.middle()).unwrap()))
        .collect()
}

fn rounded(brep: &Brep, edges: &[usize], radius: f64) -> katydid_geometry::Result<Brep> {
    with(brep, edges, radius, FilletBlend::Arc, FilletRail::RollingBall)
}

fn with(
    brep: &Brep,
    edges: &[usize],
    radius: f64,
    blend: FilletBlend,
    rail: FilletRail,
) -> katydid_geometry::Result<Brep> {
    let all: Vec<(usize, f64)> = edges.iter().map(|edge| (*edge, radius)).collect();
    brep.filleted(&all, blend, rail, &TOLERANCE)
}

#[test]
fn one_edge_of_a_box() {
    let cube = cuboid(4.0, 5.0, 6.0);
    for edge in 0..12 {
        let length = cube.edge_as_curve(edge).unwrap().unwrap().length();
        let made = rounded(&cube, &[edge], 1.0).unwrap();
        holds(&made, 120.0 - GAP * length, 1e-11);
        assert_eq!((made.faces().len(), made.edges().len(), made.vertices().len()), (7, 15, 10));
    }
}

#[test]
fn parallel_edges_of_a_box() {
    let cube = cuboid(4.0, 5.0, 6.0);
    let upright = edges(&cube, |m| near(m.z, 3.0));
    assert_eq!(upright.len(), 4);
    holds(&rounded(&cube, &upright, 1.5).unwrap(), 120.0 - 4.0 * GAP * 2.25 * 6.0, 1e-11);
    let smooth = with(&cube, &upright, 1.0, FilletBlend::Smooth, FilletRail::RollingBall).unwrap();
    assert_eq!(smooth.faults(), []);
    assert!(smooth.is_solid());
}

#[test]
fn all_edges_of_a_box() {
    let cube = cuboid(4.0, 5.0, 6.0);
    let every: Vec<usize> = (0..12).collect();
    for r in [0.25, 1.0, 1.9] {
        let [a, b, c] = [4.0, 5.0, 6.0].map(|n| n - 2.0 * r);
        let volume = a * b * c
            + 2.0 * r * (a * b + b * c + c * a)
            + PI * r * r * (a + b + c)
            + 4.0 / 3.0 * PI * r * r * r;
        let made = rounded(&cube, &every, r).unwrap();
        holds(&made, volume, 1e-11);
        assert_eq!((made.faces().len(), made.edges().len(), made.vertices().len()), (26, 48, 24));
    }
    // 2 takes all of the shortest edges.
    let error = rounded(&cube, &every, 2.0).unwrap_err().to_string();
    assert!(error.contains("too large") && error.contains("edge"), "{error}");
}

#[test]
fn edges_that_meet_at_an_angle() {
    // The area at a depth is that of the outline, inset: A − L s + k s², k the sum of the tangents of half the turns.
    let inset = |area: f64, length: f64, k: f64, height: f64, r: f64| {
        area * height - length * GAP * r * r + k * r * r * r * (5.0 / 3.0 - PI / 2.0)
    };
    let cube = cuboid(4.0, 5.0, 6.0);
    let top = edges(&cube, |m| near(m.z, 6.0));
    holds(&rounded(&cube, &top, 1.0).unwrap(), inset(20.0, 18.0, 4.0, 6.0, 1.0), 1e-11);
    let corners: Vec<(f64, f64)> = (0..6)
        .map(|k| (3.0 * (TAU * f64::from(k) / 6.0).cos(), 3.0 * (TAU * f64::from(k) / 6.0).sin()))
        .collect();
    let hexagon = prism(&corners, 2.0);
    let top = edges(&hexagon, |m| near(m.z, 2.0));
    assert_eq!(top.len(), 6);
    let k = 6.0 * (PI / 6.0).tan();
    holds(&rounded(&hexagon, &top, 0.5).unwrap(), inset(13.5 * 3.0_f64.sqrt(), 18.0, k, 2.0, 0.5), 1e-11);
    // One corner of an L turns the other way.
    let top = edges(&ell(), |m| near(m.z, 3.0));
    assert_eq!(top.len(), 6);
    holds(&rounded(&ell(), &top, 0.75).unwrap(), inset(14.0, 18.0, 4.0, 3.0, 0.75), 1e-11);
    // Two of them alone: one mitre, and an end on a side wall each.
    let two: Vec<usize> = edges(&cube, |m| near(m.z, 6.0) && (near(m.y, 0.0) || near(m.x, 0.0)));
    let volume = 120.0 - 9.0 * GAP + (5.0 / 3.0 - PI / 2.0);
    holds(&rounded(&cube, &two, 1.0).unwrap(), volume, 1e-11);
}

#[test]
fn concave_edges() {
    let inner = edges(&ell(), |m| near(m.x, 2.0) && near(m.y, 2.0));
    assert_eq!(inner.len(), 1);
    let made = rounded(&ell(), &inner, 1.5).unwrap();
    holds(&made, 42.0 + GAP * 2.25 * 3.0, 1e-11);
    let upright = edges(&ell(), |m| near(m.z, 1.5));
    holds(&rounded(&ell(), &upright, 0.5).unwrap(), 42.0 - 4.0 * GAP * 0.25 * 3.0, 1e-11);
}

/// What an arc of radius r leaves of the square in a right angle, and its moment about a line through the corner.
fn left_over(r: f64) -> (f64, f64) {
    let disc = PI / 4.0 * r * r;
    (GAP * r * r, r * r * r / 2.0 - disc * (r - 4.0 * r / (3.0 * PI)))
}

#[test]
fn circular_edges() {
    let solid =
        construct::cylinder(&Cylinder::new(Plane::XY, 3.0, Interval::new(0.0, 4.0)).unwrap(), [true; 2]);
    let solid = solid.unwrap();
    let rims: Vec<usize> =
        (0..solid.edges().len()).filter(|e| solid.edge_curve(*e).unwrap().is_closed()).collect();
    assert_eq!(rims.len(), 2);
    for r in [0.5, 1.9] {
        let (area, moment) = left_over(r);
        let less = TAU * (3.0 * area - moment);
        holds(&rounded(&solid, &rims[..1], r).unwrap(), 36.0 * PI - less, 1e-10);
        holds(&rounded(&solid, &rims, r).unwrap(), 36.0 * PI - 2.0 * less, 1e-10);
    }
    let cut = with(&solid, &rims[..1], 1.0, FilletBlend::Chamfer, FilletRail::DistanceFromEdge).unwrap();
    holds(&cut, 36.0 * PI - TAU * 0.5 * (3.0 - 1.0 / 3.0), 1e-10);
    for r in [3.0, 3.5, 4.5] {
        let error = rounded(&solid, &rims[..1], r).unwrap_err().to_string();
        assert!(error.contains(&format!("edge {}", rims[0])) && error.contains("too large"), "{error}");
    }
}

#[test]
fn a_boss_on_a_plate_and_a_hole() {
    let profile: Curve = PolylineCurve::new(
        [(0.0, 0.0), (5.0, 0.0), (5.0, 1.0), (2.0, 1.0), (2.0, 4.0), (0.0, 4.0)]
            .iter()
            .map(|(x, z)| p(*x, 0.0, *z))
            .collect(),
    )
    .unwrap()
    .into();
    let axis = Line::new(p(0.0, 0.0, 0.0), p(0.0, 0.0, 1.0));
    let boss = construct::revolve(&profile, axis, Interval::new(0.0, TAU), &TOLERANCE).unwrap();
    let boss = if boss.is_solid() { boss } else { boss.capped(&TOLERANCE).unwrap().0 };
    let foot: Vec<usize> = (0..boss.edges().len())
        .filter(|e| {
            let q = boss.edge_point(*e, boss.edges()[*e].part.domain.start).unwrap();
            near(q.z, 1.0)
                && near(q.x.hypot(q.y), 2.0)
                && boss.edge_as_curve(*e).unwrap().unwrap().is_closed()
        })
        .collect();
    assert_eq!(foot.len(), 1);
    let (area, moment) = left_over(0.75);
    let volume = PI * (25.0 + 4.0 * 3.0) + TAU * (2.0 * area + moment);
    holds(&rounded(&boss, &foot, 0.75).unwrap(), volume, 1e-10);
    // A plate with a hole: its rim is convex.
    let square = outline(&[(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)]);
    let hole: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
    let base = Brep::planar_faces(&[square, hole], &TOLERANCE).unwrap().breps.remove(0);
    let plate = construct::extrude_brep(&base, Vector3::Z * 2.0, &TOLERANCE).unwrap();
    let rim: Vec<usize> = (0..plate.edges().len())
        .filter(|e| {
            let curve = plate.edge_as_curve(*e).unwrap().unwrap();
            curve.is_closed() && near(curve.start().z, 2.0)
        })
        .collect();
    assert_eq!(rim.len(), 1);
    let (area, moment) = left_over(1.0);
    let volume = 2.0 * (64.0 - 4.0 * PI);
    holds(&rounded(&plate, &rim, 1.0).unwrap(), volume - TAU * (2.0 * area + moment), 1e-10);
    let error = rounded(&plate, &rim, 1.99).map(|b| b.faces().len());
    assert_eq!(error, Ok(plate.faces().len() + 1));
    let error = rounded(&plate, &rim, 2.01).unwrap_err().to_string();
    assert!(error.contains("too large"), "{error}");
}

#[test]
fn a_chain_without_kinks() {
    // A rectangle with round corners, extruded: its whole rim follows from one of its edges.
    let outline = {
        let solid = prism(&[(0.0, 0.0), (8.0, 0.0), (8.0, 6.0), (0.0, 6.0)], 3.0);
        let upright = edges(&solid, |m| near(m.z, 1.5));
        rounded(&solid, &upright, 2.0).unwrap()
    };
    let area = 48.0 - 4.0 * GAP * 4.0;
    let length = 28.0 - 16.0 + TAU * 2.0;
    let top = edges(&outline, |m| near(m.z, 3.0));
    assert_eq!(top.len(), 8);
    let r = 0.8;
    let volume = 3.0 * area - length * GAP * r * r + PI * r * r * r * (5.0 / 3.0 - PI / 2.0);
    let made = rounded(&outline, &top[..1], r).unwrap();
    holds(&made, volume, 1e-10);
    assert_eq!(made.faces().len(), outline.faces().len() + 8);
    holds(&rounded(&outline, &top, r).unwrap(), volume, 1e-10);
}

#[test]
fn a_free_form_rim() {
    let points: Vec<Point3> = (0..8)
        .map(|k| {
            let (sin, cos) = (TAU * f64::from(k) / 8.0).sin_cos();
            let r = if k % 2 == 0 { 5.0 } else { 4.2 };
            p(r * cos, r * sin, 0.0)
        })
        .collect();
    let profile: Curve = NurbsCurve::periodic_uniform(3, &points).unwrap().into();
    let solid = construct::extrude(&profile, Vector3::Z * 3.0, true, &TOLERANCE).unwrap();
    let area = profile.signed_area_in(&Plane::XY).0.abs();
    let rim: Vec<usize> = (0..solid.edges().len())
        .filter(|e| {
            let curve = solid.edge_as_curve(*e).unwrap().unwrap();
            curve.is_closed() && near(curve.start().z, 3.0)
        })
        .collect();
    let r: f64 = 0.7;
    let volume = 3.0 * area - profile.length() * GAP * r * r + PI * r * r * r * (5.0 / 3.0 - PI / 2.0);
    let made = rounded(&solid, &rim, r).unwrap();
    holds(&made, volume, 1e-5);
    // The new face touches both others: along its rails its normal is theirs.
    let whole = &made;
    let touching = |edge: &usize| {
        let ends = whole.edges()[*edge].trims.iter().map(|t| {
            let own = &whole.trims()[*t];
            let face = whole.loops()[own.in_loop.unwrap()].face.unwrap();
            let (surface, turned) = (whole.face_surface(face).unwrap(), whole.faces()[face].reversed);
            move |x: f64| {
                let uv =
                    whole.trim_point(*t, own.part.domain.at(if own.reversed { 1.0 - x } else { x })).unwrap();
                let normal = surface.normal_at(uv.x, uv.y).unwrap();
                if turned { -normal } else { normal }
            }
        });
        let ends: Vec<_> = ends.collect();
        let turns = (1..100).map(|k| {
            let x = f64::from(k) / 100.0;
            ends[0](x).angle_to(ends[1](x)).unwrap()
        });
        turns.fold(0.0, f64::max) <= TOLERANCE.angle
    };
    let count =
        (0..made.edges().len()).filter(|e| made.edges()[*e].trims.len() == 2).filter(touching).count();
    // Both rails, and the seams of the wall and of the new face.
    assert_eq!(count, 4);
    for blend in [FilletBlend::Chamfer, FilletBlend::Smooth] {
        let other = with(&solid, &rim, r, blend, FilletRail::RollingBall).unwrap();
        assert_eq!(other.faults(), []);
        assert!(other.is_solid());
    }
}

#[test]
fn rails_that_run_into_themselves_are_refused() {
    // A rounded U, whose arms are 2 wide: from a radius of 1 on nothing of their tops would be left.
    let points =
        [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (4.0, 6.0), (4.0, 2.0), (2.0, 2.0), (2.0, 6.0), (0.0, 6.0)];
    let points: Vec<Point3> = points.iter().map(|(x, y)| p(*x, *y, 0.0)).collect();
    let profile: Curve = NurbsCurve::periodic_uniform(3, &points).unwrap().into();
    let solid = construct::extrude(&profile, Vector3::Z * 4.0, true, &TOLERANCE).unwrap();
    let rim: Vec<usize> = (0..solid.edges().len())
        .filter(|e| {
            let curve = solid.edge_as_curve(*e).unwrap().unwrap();
            curve.is_closed() && near(curve.start().z, 4.0)
        })
        .collect();
    let small = rounded(&solid, &rim, 0.1).unwrap();
    assert!(small.is_solid());
    for r in [1.2, 1.5, 3.0] {
        let error = rounded(&solid, &rim, r).unwrap_err().to_string();
        assert!(error.contains(&format!("edge {}", rim[0])), "{error}");
    }
}

#[test]
fn oblique_ends() {
    // A block sheared along its edges: their ends are cut by slanting faces, and exact still.
    let profile = outline(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]);
    let solid = construct::extrude(&profile, Vector3::new(1.0, 0.5, 5.0), true, &TOLERANCE).unwrap();
    // The section of a fillet of an edge, square to it, times its length: ends that are parallel cancel.
    let along = Vector3::new(1.0, 0.5, 5.0).unitized().unwrap();
    for edge in edges(&solid, |m| near(m.z, 2.5)) {
        let made = rounded(&solid, &[edge], 0.6).unwrap();
        let walls = [Vector3::X, Vector3::Y].map(|v| (v - along * v.dot(along)).unitized().unwrap());
        let corner = edge_angle(&solid, edge, walls);
        let kite = 0.36 / (0.5 * corner).tan();
        let less = (kite - 0.36 * (PI - corner) / 2.0) * Vector3::new(1.0, 0.5, 5.0).length();
        holds(&made, 60.0 - less, 1e-10);
    }
}

/// The inner angle of a parallelogram's corner at an edge, its sides along two directions.
fn edge_angle(solid: &Brep, edge: usize, [x, y]: [Vector3; 2]) -> f64 {
    let m = solid.edge_point(edge, solid.edges()[edge].part.domain.middle()).unwrap();
    let x = if m.x > 2.5 { -x } else { x };
    let y = if m.y > 1.75 { -y } else { y };
    x.angle_to(y).unwrap()
}

#[test]
fn chamfers_and_metrics() {
    let cube = cuboid(4.0, 5.0, 6.0);
    let edge = edges(&cube, |m| near(m.z, 3.0))[0];
    let cut = |rail, d| with(&cube, &[edge], d, FilletBlend::Chamfer, rail).unwrap();
    holds(&cut(FilletRail::DistanceFromEdge, 1.0), 120.0 - 3.0, 1e-12);
    holds(&cut(FilletRail::RollingBall, 1.0), 120.0 - 3.0, 1e-12);
    holds(&cut(FilletRail::DistanceBetweenRails, 1.0), 120.0 - 1.5, 1e-12);
    let round = with(&cube, &[edge], 1.0, FilletBlend::Arc, FilletRail::DistanceBetweenRails).unwrap();
    holds(&round, 120.0 - GAP * FRAC_1_SQRT_2 * FRAC_1_SQRT_2 * 6.0, 1e-11);
    // In a hexagonal prism the angle is 120 degrees: a ball of radius 1 touches at 1 / tan 60°.
    let corners: Vec<(f64, f64)> = (0..6)
        .map(|k| (3.0 * (TAU * f64::from(k) / 6.0).cos(), 3.0 * (TAU * f64::from(k) / 6.0).sin()))
        .collect();
    let hexagon = prism(&corners, 2.0);
    let upright = edges(&hexagon, |m| near(m.z, 1.0))[0];
    let volume = 13.5 * 3.0_f64.sqrt() * 2.0;
    let d: f64 = 0.5;
    let triangle = 0.5 * d * d * (PI * 2.0 / 3.0).sin();
    let made = with(&hexagon, &[upright], d, FilletBlend::Chamfer, FilletRail::DistanceFromEdge).unwrap();
    holds(&made, volume - 2.0 * triangle, 1e-12);
    // All edges of a box cut off: the corners become triangles.
    let every: Vec<usize> = (0..12).collect();
    let made = with(&cube, &every, 1.0, FilletBlend::Chamfer, FilletRail::RollingBall).unwrap();
    let [a, b, c] = [2.0, 3.0, 4.0];
    let volume = a * b * c + 2.0 * (a * b + b * c + c * a) + 2.0 * (a + b + c) + 8.0 / 6.0;
    holds(&made, volume, 1e-12);
}

#[test]
fn what_cannot_be_is_refused() {
    let cube = cuboid(4.0, 5.0, 6.0);
    let says = |edges: &[(usize, f64)], words: &str| {
        let error = cube.filleted(edges, FilletBlend::Arc, FilletRail::RollingBall, &TOLERANCE);
        let error = error.unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    };
    says(&[(12, 1.0)], "edge 12: there is no such edge; the shape has 12 edges");
    says(&[(3, 0.0)], "edge 3: its radius is 0");
    says(&[(3, -1.0)], "edge 3: its radius is -1");
    says(&[(3, f64::NAN)], "edge 3: its radius is NaN");
    says(&[(3, f64::INFINITY)], "edge 3: its radius is inf");
    says(&[(3, 1.0), (3, 1.0)], "edge 3: it is given twice");
    says(&[(3, 100.0)], "edge 3: the radius is too large");
    says(&[(3, 1e300)], "edge 3: the radius");
    // On four faces that no one ball touches.
    let roof = outline(&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)]);
    let roof = construct::extrude_to_point(&roof, p(2.0, 1.0, 3.0), true, &TOLERANCE).unwrap();
    let ridges: Vec<(usize, f64)> = edges(&roof, |m| !near(m.z, 0.0)).into_iter().map(|e| (e, 0.2)).collect();
    let error = roof.filleted(&ridges, FilletBlend::Arc, FilletRail::RollingBall, &TOLERANCE).unwrap_err();
    let error = error.to_string();
    assert!(error.contains("vertex") && error.contains("not supported yet"), "{error}");
    let none = cube.filleted(&[], FilletBlend::Arc, FilletRail::RollingBall, &TOLERANCE).unwrap();
    assert_eq!(none, cube);
    let sheet =
        construct::plane_surface(&Plane::XY, Interval::new(0.0, 1.0), Interval::new(0.0, 1.0)).unwrap();
    let error = rounded(&sheet, &[0], 0.1).unwrap_err().to_string();
    assert!(error.contains("edge 0: it is naked"), "{error}");
    let bad = Tolerance { absolute: 0.0, ..TOLERANCE };
    assert!(cube.filleted(&[(0, 1.0)], FilletBlend::Arc, FilletRail::RollingBall, &bad).is_err());
    // Smooth edges and seams.
    let solid =
        construct::cylinder(&Cylinder::new(Plane::XY, 3.0, Interval::new(0.0, 4.0)).unwrap(), [true; 2]);
    let solid = solid.unwrap();
    let seam = (0..solid.edges().len()).find(|e| !solid.edge_curve(*e).unwrap().is_closed()).unwrap();
    assert!(rounded(&solid, &[seam], 0.5).unwrap_err().to_string().contains("seam"));
}

#[test]
fn open_shapes_keep_their_borders() {
    let profile: Curve =
        PolylineCurve::new(vec![p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0), p(4.0, 3.0, 0.0)]).unwrap().into();
    let sheet = construct::extrude(&profile, Vector3::Z * 5.0, false, &TOLERANCE).unwrap();
    let fold = edges(&sheet, |m| near(m.x, 4.0) && near(m.y, 0.0));
    let made = rounded(&sheet, &fold, 1.0).unwrap();
    assert_eq!(made.faults(), []);
    assert_eq!((made.faces().len(), made.naked_edges().len()), (3, 8));
    let area = made.area_properties(1e-12, || true).unwrap().amount;
    assert!((area - 5.0 * (3.0 + 2.0 + PI / 2.0)).abs() < 1e-9, "{area}");
}
