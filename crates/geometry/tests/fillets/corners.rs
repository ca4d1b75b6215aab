//! Corners where rounded edges of mixed convexity or of different radii meet, against closed forms.

use std::f64::consts::{FRAC_PI_2, PI};

use katydid_geometry::brep::{FilletBlend, FilletRail};
use katydid_geometry::construct;
use katydid_geometry::{Brep, CancellationToken, ClosestOnSurface, Curve, Point3, PolylineCurve, Vector3};

use super::{ELL, GAP, TOLERANCE, cuboid, holds, near, outline, p, prism};

/// What is left beside an arc of radius 1, squared and summed over its height.
const SQUARES: f64 = 5.0 / 3.0 - FRAC_PI_2;

/// Every edge with the radius that a rule gives for its middle.
fn radii(brep: &Brep, rule: impl Fn(Point3) -> Option<f64>) -> Vec<(usize, f64)> {
    let middle = |edge: usize| brep.edge_point(edge, brep.edges()[edge].part.domain.middle()).unwrap();
    (0..brep.edges().len()).filter_map(|edge| Some((edge, rule(middle(edge))?))).collect()
}

fn rounded(brep: &Brep, edges: &[(usize, f64)]) -> katydid_geometry::Result<Brep> {
    brep.filleted(edges, FilletBlend::Arc, FilletRail::RollingBall, &TOLERANCE)
}

/// The volume of a prism whose upright edges are rounded with one radius and those of top and bottom with another: the
/// area at a depth is that of the rounded outline, inset, A − P s + π s².
fn rounded_prism(corners: &[(f64, f64)], height: f64, upright: f64, flat: f64) -> f64 {
    let count = corners.len();
    let at = |k: usize| corners[k % count];
    let area: f64 = (0..count).map(|k| at(k).0 * at(k + 1).1 - at(k + 1).0 * at(k).1).sum::<f64>() / 2.0;
    let length: f64 = (0..count).map(|k| (at(k).0 - at(k + 1).0).hypot(at(k).1 - at(k + 1).1)).sum();
    let turn = |k: usize| {
        let (a, b, c) = (at(k), at(k + 1), at(k + 2));
        ((b.0 - a.0) * (c.1 - b.1) - (b.1 - a.1) * (c.0 - b.0)).signum()
    };
    let turns: f64 = (0..count).map(turn).sum();
    let area = area - turns * GAP * upright * upright;
    let length = length - count as f64 * (2.0 - FRAC_PI_2) * upright;
    height * area - 2.0 * length * GAP * flat * flat + 2.0 * PI * flat * flat * flat * SQUARES
}

#[test]
fn every_edge_of_a_bracket() {
    let bracket = prism(&ELL, 3.0);
    for r in [0.1, 0.4, 0.9] {
        let made = rounded(&bracket, &radii(&bracket, |_| Some(r))).unwrap();
        holds(&made, rounded_prism(&ELL, 3.0, r, r), 1e-11);
        assert_eq!(made.faces().len(), 8 + 18 + 10 + 2);
    }
    for (upright, flat) in [(0.5, 0.2), (0.9, 0.7)] {
        let all = radii(&bracket, |m| Some(if near(m.z, 1.5) { upright } else { flat }));
        holds(&rounded(&bracket, &all).unwrap(), rounded_prism(&ELL, 3.0, upright, flat), 1e-11);
    }
}

/// The largest angle between the faces on both sides of an edge.
fn largest_turn(brep: &Brep) -> f64 {
    let face = |trim: usize| brep.loops()[brep.trims()[trim].in_loop.unwrap()].face.unwrap();
    let mut worst = 0.0_f64;
    for edge in 0..brep.edges().len() {
        let &[a, b] = brep.edges()[edge].trims.as_slice() else { panic!("a naked edge") };
        let faces = [face(a), face(b)];
        let feet = faces.map(|face| ClosestOnSurface::new(brep.face_surface(face).unwrap()).unwrap());
        let domain = brep.edges()[edge].part.domain;
        for k in 1..12 {
            let point = brep.edge_point(edge, domain.at(f64::from(k) / 12.0)).unwrap();
            let normals = [0, 1].map(|k| {
                let foot = feet[k].nearest(point).unwrap();
                let normal = brep.face_surface(faces[k]).unwrap().normal_at(foot.u, foot.v).unwrap();
                if brep.faces()[faces[k]].reversed { -normal } else { normal }
            });
            worst = worst.max(normals[0].angle_to(normals[1]).unwrap());
        }
    }
    worst
}

#[test]
fn every_face_goes_on_smoothly() {
    let bracket = prism(&ELL, 3.0);
    let made = rounded(&bracket, &radii(&bracket, |_| Some(0.5))).unwrap();
    assert!(largest_turn(&made) < 1e-9, "{}", largest_turn(&made));
    let cube = cuboid(4.0, 5.0, 6.0);
    let all = radii(&cube, |m| {
        Some(if near(m.z, 3.0) {
            1.2
        } else if near(m.x, 2.0) {
            0.5
        } else {
            0.9
        })
    });
    let made = rounded(&cube, &all).unwrap();
    assert_eq!(made.faults(), []);
    assert!(made.is_solid());
    assert!(largest_turn(&made) < 1e-3, "{}", largest_turn(&made));
}

/// A step outline and others whose corners are all right angles.
fn outlines() -> Vec<Vec<(f64, f64)>> {
    vec![
        ELL.to_vec(),
        vec![(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (4.0, 2.0), (4.0, 5.0), (2.0, 5.0), (2.0, 2.0), (0.0, 2.0)],
        vec![(0.0, 0.0), (6.0, 0.0), (6.0, 5.0), (4.0, 5.0), (4.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)],
        vec![
            (2.0, 0.0),
            (4.0, 0.0),
            (4.0, 2.0),
            (6.0, 2.0),
            (6.0, 4.0),
            (4.0, 4.0),
            (4.0, 6.0),
            (2.0, 6.0),
            (2.0, 4.0),
            (0.0, 4.0),
            (0.0, 2.0),
            (2.0, 2.0),
        ],
        vec![(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (4.0, 2.0), (4.0, 4.0), (2.0, 4.0), (2.0, 6.0), (0.0, 6.0)],
    ]
}

/// Numbers from 0 to 1, always the same ones.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[test]
fn random_prisms_with_random_radii() {
    let mut dice = Dice(7);
    for (n, outline) in outlines().into_iter().enumerate() {
        for round in 0..3 {
            let height = 2.5 + dice.roll();
            let upright = 0.1 + 0.85 * dice.roll();
            // One radius for all, or a smaller one above and below.
            let flat = if round == 0 { upright } else { upright * (0.2 + 0.75 * dice.roll()) };
            let solid = prism(&outline, height);
            let all = radii(&solid, |m| Some(if near(m.z, 0.5 * height) { upright } else { flat }));
            let made = rounded(&solid, &all).unwrap_or_else(|e| panic!("{n} {upright} {flat}: {e}"));
            holds(&made, rounded_prism(&outline, height, upright, flat), 1e-10);
        }
    }
}

#[test]
fn any_edges_of_any_radii_are_sound_or_refused_by_name() {
    let mut dice = Dice(11);
    let (mut sound, mut refused) = (0, 0);
    for round in 0..40 {
        let outline = &outlines()[round % 5];
        let solid = prism(outline, 3.0);
        let share = dice.roll();
        let wanted = [0.2, 0.5, 0.95, 1.0, 1.3].map(|most| most * (0.3 + 0.7 * dice.roll()));
        let edges: Vec<(usize, f64)> = (0..solid.edges().len())
            .filter(|_| dice.roll() < share)
            .collect::<Vec<_>>()
            .into_iter()
            .map(|edge| (edge, wanted[(dice.roll() * 5.0) as usize % if round % 2 == 0 { 1 } else { 3 }]))
            .collect();
        match rounded(&solid, &edges) {
            Ok(made) => {
                assert_eq!(made.faults(), []);
                assert!(made.is_solid());
                sound += 1;
            }
            Err(error) => {
                let error = error.to_string();
                assert!(error.contains("edge"), "{error}");
                refused += 1;
            }
        }
    }
    assert!(sound > refused, "{sound} sound, {refused} refused");
}

/// Flat faces joined to a solid.
fn joined(faces: &[Vec<Point3>]) -> Brep {
    let faces = faces.iter().map(|corners| {
        let mut corners = corners.clone();
        corners.push(corners[0]);
        let outline: Curve = PolylineCurve::new(corners).unwrap().into();
        Brep::planar_faces(&[outline], &TOLERANCE).unwrap().breps.remove(0)
    });
    let mut made = Brep::join(&faces.collect::<Vec<_>>(), &TOLERANCE).unwrap().breps;
    assert_eq!(made.len(), 1);
    made.remove(0)
}

/// A block of 2 × 2 × 2 in a corner of a plate of 6 × 6 × 1: at one corner of its foot two edges turn in and one out.
fn block_on_plate() -> Brep {
    let square = |x: f64, y: f64, a: f64, z: f64| -> Vec<Point3> {
        vec![p(x, y, z), p(x + a, y, z), p(x + a, y + a, z), p(x, y + a, z)]
    };
    let mut faces = vec![square(0.0, 0.0, 6.0, 0.0), square(0.0, 0.0, 2.0, 3.0)];
    faces.push(vec![
        p(2.0, 0.0, 1.0),
        p(6.0, 0.0, 1.0),
        p(6.0, 6.0, 1.0),
        p(0.0, 6.0, 1.0),
        p(0.0, 2.0, 1.0),
        p(2.0, 2.0, 1.0),
    ]);
    faces.push(vec![p(6.0, 0.0, 0.0), p(6.0, 6.0, 0.0), p(6.0, 6.0, 1.0), p(6.0, 0.0, 1.0)]);
    faces.push(vec![p(0.0, 6.0, 0.0), p(6.0, 6.0, 0.0), p(6.0, 6.0, 1.0), p(0.0, 6.0, 1.0)]);
    faces.push(vec![p(2.0, 0.0, 1.0), p(2.0, 2.0, 1.0), p(2.0, 2.0, 3.0), p(2.0, 0.0, 3.0)]);
    faces.push(vec![p(0.0, 2.0, 1.0), p(2.0, 2.0, 1.0), p(2.0, 2.0, 3.0), p(0.0, 2.0, 3.0)]);
    let side = [(0.0, 0.0), (6.0, 0.0), (6.0, 1.0), (2.0, 1.0), (2.0, 3.0), (0.0, 3.0)];
    faces.push(side.iter().map(|(x, z)| p(*x, 0.0, *z)).collect());
    faces.push(side.iter().map(|(y, z)| p(0.0, *y, *z)).collect());
    joined(&faces)
}

#[test]
fn a_foot_that_turns_in_round_an_edge_that_turns_out() {
    let solid = block_on_plate();
    let plain = 36.0 + 8.0;
    holds(&solid, plain, 1e-12);
    let is_post = |m: Point3| near(m.x, 2.0) && near(m.y, 2.0);
    let is_foot = |m: Point3| near(m.z, 1.0) && (near(m.x, 2.0) || near(m.y, 2.0));
    for (post, foot) in [(0.5, 0.5), (0.8, 0.3), (0.3, 0.8)] {
        let edges = radii(&solid, |m| is_post(m).then_some(post).or(is_foot(m).then_some(foot)));
        assert_eq!(edges.len(), 3);
        let made = rounded(&solid, &edges).unwrap();
        // The foot runs along the post: what it adds at a height is L s + π/4 s².
        let length = 4.0 - 2.0 * post + FRAC_PI_2 * post;
        let more = length * GAP * foot * foot + PI / 4.0 * foot * foot * foot * SQUARES;
        holds(&made, plain - 2.0 * GAP * post * post + more, 1e-11);
    }
    // One edge of the foot alone ends beyond the corner, on the wall that goes on there.
    for edge in radii(&solid, |m| is_foot(m).then_some(0.6)) {
        holds(&rounded(&solid, &[edge]).unwrap(), plain + 2.0 * GAP * 0.36, 1e-11);
    }
    let every = radii(&solid, |_| Some(0.4));
    let made = rounded(&solid, &every).unwrap();
    // The volume is that which Open CASCADE's rolling ball leaves.
    holds(&made, 42.058_750_922_03, 1e-9);
    assert!(largest_turn(&made) < 1e-3);
}

#[test]
fn an_edge_that_ends_where_the_outline_turns_in() {
    let bracket = prism(&ELL, 3.0);
    for end in [0.0, 3.0] {
        let edge = radii(&bracket, |m| (near(m.z, end) && near(m.x, 3.0) && near(m.y, 2.0)).then_some(0.7));
        assert_eq!(edge.len(), 1);
        holds(&rounded(&bracket, &edge).unwrap(), 42.0 - 2.0 * GAP * 0.49, 1e-11);
        let made =
            bracket.filleted(&edge, FilletBlend::Chamfer, FilletRail::RollingBall, &TOLERANCE).unwrap();
        holds(&made, 42.0 - 0.49, 1e-12);
    }
}

/// The edges of a box that meet at its first corner, along x, y and z.
fn at_corner(m: Point3) -> Option<usize> {
    let zero = [m.x, m.y, m.z].map(|c| near(c, 0.0));
    match zero {
        [false, true, true] => Some(0),
        [true, false, true] => Some(1),
        [true, true, false] => Some(2),
        _ => None,
    }
}

/// Simpson's rule.
fn sum_over(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let steps = 4000;
    let h = (to - from) / f64::from(steps);
    let weight = |k: u32| {
        if k == 0 || k == steps {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    (0..=steps).map(|k| weight(k) * f(from + h * f64::from(k))).sum::<f64>() * h / 3.0
}

#[test]
fn three_radii_at_a_corner_of_a_box() {
    let cube = cuboid(4.0, 5.0, 6.0);
    let sizes = [4.0, 5.0, 6.0];
    for (large, small) in [(3.0, 1.0), (1.0, 0.25), (0.5, 0.499)] {
        for axis in 0..3 {
            let edges = radii(&cube, |m| at_corner(m).map(|k| if k == axis { large } else { small }));
            let made = rounded(&cube, &edges).unwrap();
            let others: f64 = sizes.iter().sum::<f64>() - sizes[axis] - 2.0 * large + FRAC_PI_2 * large;
            let less = GAP * large * large * sizes[axis] + others * GAP * small * small
                - PI / 4.0 * small * small * small * SQUARES;
            holds(&made, 120.0 - less, 1e-11);
        }
    }
    // All three different: round the arc the radius follows a cubic of the arc's own parameter.
    let [large, one, two] = [2.0, 1.0, 0.4];
    let edges = radii(&cube, |m| at_corner(m).map(|k| [one, two, large][k]));
    let made = rounded(&cube, &edges).unwrap();
    let moment = |r: f64| r * r * r / 2.0 - PI / 4.0 * r * r * (r - 4.0 * r / (3.0 * PI));
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let angle = |t: f64| {
        let b = [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t) * half, t * t];
        (b[1] + b[2]).atan2(b[0] + b[1])
    };
    let around = sum_over(0.0, 1.0, |t| {
        let h = 1e-5;
        let speed = (angle(t + h) - angle(t - h)) / (2.0 * h);
        let r = one + (two - one) * t * t * (3.0 - 2.0 * t);
        speed * (large * GAP * r * r - moment(r))
    });
    let less = GAP * (6.0 * large * large + (4.0 - large) * one * one + (5.0 - large) * two * two) + around;
    holds(&made, 120.0 - less, 1e-6);
}

/// What a small ball takes of the mitre between two large cylinders at right angles, above the plane of their axes: two
/// walls as seen from where the axes meet, less the canal of the ball.
fn off_the_mitre(large: f64, small: f64) -> f64 {
    let root = 2.0_f64.sqrt();
    let canal = sum_over(0.0, FRAC_PI_2, |a| {
        let d = (1.0 + a.sin().powi(2)).sqrt();
        let m = 0.5 * (a.sin().powi(2)).min(1.0).acos();
        let (reach, speed, bend) = ((large - small) * root / d, (large - small) * d, small * root / (d * d));
        small
            * (2.0 * m.sin() * (reach * speed + small * bend)
                + reach * bend * (m + m.sin() * m.cos())
                + 2.0 * m * small * speed)
    });
    2.0 * large * large * small / 3.0 - canal / 3.0
}

#[test]
fn a_small_radius_between_two_large_ones() {
    let cube = cuboid(4.0, 5.0, 6.0);
    for (large, small) in [(1.0, 0.5), (2.0, 0.3), (1.0, 0.95)] {
        let edges = radii(&cube, |m| at_corner(m).map(|k| [large, large, small][k]));
        let made = rounded(&cube, &edges).unwrap();
        let less = GAP * large * large * 9.0 - SQUARES * large.powi(3)
            + GAP * small * small * (6.0 - large)
            + off_the_mitre(large, small);
        holds(&made, 120.0 - less, 1e-6);
    }
    // The top of a box, and its upright edges with less.
    let all = radii(&cube, |m| if near(m.z, 6.0) { Some(1.0) } else { near(m.z, 3.0).then_some(0.4) });
    let made = rounded(&cube, &all).unwrap();
    let less = GAP * 18.0 - 4.0 * SQUARES + 4.0 * (GAP * 0.16 * 5.0 + off_the_mitre(1.0, 0.4));
    holds(&made, 120.0 - less, 1e-6);
}

#[test]
fn two_radii_of_three_edges_at_a_corner() {
    let cube = cuboid(4.0, 5.0, 6.0);
    for (r, s) in [(2.0, 1.0), (1.0, 0.3), (0.5, 0.45)] {
        for (first, second) in [(0, 1), (1, 0), (2, 1)] {
            let pick = |k: usize| if k == first { Some(r) } else { (k == second).then_some(s) };
            let edges = radii(&cube, |m| at_corner(m).and_then(pick));
            assert_eq!(edges.len(), 2);
            let made = rounded(&cube, &edges).unwrap();
            let sizes = [4.0, 5.0, 6.0];
            let inset = |r: f64, z: f64| r - (r * r - (r - z) * (r - z)).sqrt();
            // In the half-angle the roots are smooth.
            let common = sum_over(0.0, FRAC_PI_2, |a| {
                let z = s * (1.0 - a.cos());
                inset(r, z) * inset(s, z) * s * a.sin()
            });
            let volume = 120.0 - GAP * (sizes[first] * r * r + sizes[second] * s * s) + common;
            holds(&made, volume, 1e-6);
        }
    }
}

#[test]
fn flat_facets() {
    let cut = |brep: &Brep, edges: &[(usize, f64)]| {
        brep.filleted(edges, FilletBlend::Chamfer, FilletRail::DistanceFromEdge, &TOLERANCE)
    };
    let bracket = prism(&ELL, 3.0);
    for d in [0.2, 0.7] {
        let made = cut(&bracket, &radii(&bracket, |_| Some(d))).unwrap();
        // The area at a depth is the inset outline, less a triangle of the depth at each corner (more where it turns in).
        let middle = (3.0 - 2.0 * d) * (14.0 - 2.0 * d * d);
        let ends = 14.0 * d - 9.0 * d * d + 4.0 * d * d * d / 3.0 - 2.0 * d * d * d / 3.0;
        holds(&made, middle + 2.0 * ends, 1e-12);
        assert_eq!(made.faces().len(), 8 + 18 + 12);
    }
    // Three different ones at a corner: the prisms, less what two have in common, and the tetrahedron of all three.
    let cube = cuboid(4.0, 5.0, 6.0);
    let edges = radii(&cube, |m| at_corner(m).map(|k| [1.0, 0.5, 1.5][k]));
    let made = cut(&cube, &edges).unwrap();
    assert_eq!(made.faults(), []);
    assert!(made.is_solid() && made.faces().len() == 10);
    // Two different ones: the smaller runs into the larger.
    let edges = radii(&cube, |m| at_corner(m).and_then(|k| [Some(1.0), Some(0.5), None][k]));
    let common = sum_over(0.0, 0.5, |z| (1.0 - z) * (0.5 - z));
    holds(&cut(&cube, &edges).unwrap(), 120.0 - 4.0 * 0.5 - 5.0 * 0.125 + common, 1e-11);
}

/// A right pyramid over a regular polygon with an inscribed circle of radius 1.
fn pyramid(sides: u32, height: f64) -> Brep {
    let outer = 1.0 / (PI / f64::from(sides)).cos();
    let corner = |k: u32| {
        let (sin, cos) = (2.0 * PI * f64::from(k) / f64::from(sides)).sin_cos();
        p(outer * cos, outer * sin, 0.0)
    };
    let base: Curve = PolylineCurve::new((0..=sides).map(|k| corner(k % sides)).collect()).unwrap().into();
    construct::extrude_to_point(&base, p(0.0, 0.0, height), true, &TOLERANCE).unwrap()
}

#[test]
fn the_tip_of_a_pyramid() {
    for (sides, height) in [(3, 1.5), (4, 1.0), (4, 3.0), (5, 1.5), (8, 2.0)] {
        let solid = pyramid(sides, height);
        let n = f64::from(sides);
        let side = 2.0 * (PI / n).tan();
        let slant = 1.0_f64.hypot(height);
        let (base, walls) = (n * side / 2.0, n * side * slant / 2.0);
        let volume = base * height / 3.0;
        let inner = 3.0 * volume / (base + walls);
        let r = 0.2 * inner;
        // What is left is the pyramid shrunk towards the middle of its inner ball, with all within r of it (Steiner).
        let k = 1.0 - r / inner;
        let foot = PI - (height / 1.0).atan();
        let wall = |a: f64| Vector3::new(height * a.cos(), height * a.sin(), 1.0);
        let ridge = wall(0.0).angle_to(wall(2.0 * PI / n)).unwrap();
        let rise = (1.0 / (PI / n).cos()).hypot(height);
        let turns = n * (side * foot + rise * ridge);
        let expected = volume * k.powi(3)
            + r * (base + walls) * k * k
            + r * r * k * turns / 2.0
            + 4.0 / 3.0 * PI * r.powi(3);
        let made =
            rounded(&solid, &radii(&solid, |_| Some(r))).unwrap_or_else(|e| panic!("{sides} {height}: {e}"));
        holds(&made, expected, 1e-9);
        assert!(largest_turn(&made) < 1e-3);
        let all = radii(&solid, |_| Some(r));
        let flat = solid.filleted(&all, FilletBlend::Chamfer, FilletRail::RollingBall, &TOLERANCE).unwrap();
        assert_eq!(flat.faults(), []);
        assert!(flat.is_solid());
    }
}

#[test]
fn one_edge_that_ends_at_the_tip() {
    // The rounding of one ridge is cut off by the two walls across, on both sides of the ridge across.
    let solid = pyramid(4, 2.0);
    let volume = 8.0 / 3.0;
    for edge in radii(&solid, |m| (!near(m.z, 0.0)).then_some(0.3)) {
        let made = rounded(&solid, &[edge]).unwrap();
        assert_eq!((made.faces().len(), made.vertices().len()), (6, 5 - 2 + 5));
        // Between the foot and the tip, over the section: the area between the corner and the arc, whose length along the
        // ridge changes with the place across.
        let wall = |x: f64, y: f64| Vector3::new(2.0 * x, 2.0 * y, 1.0).unitized().unwrap();
        let way = Vector3::new(-1.0, -1.0, 2.0).unitized().unwrap();
        let (n1, n2) = (wall(1.0, 0.0), wall(0.0, 1.0));
        let half = 0.5 * n1.angle_to(n2).unwrap();
        let up = (n1 + n2).unitized().unwrap();
        let side = up.cross(way);
        let tip = p(0.0, 0.0, 2.0);
        let centre = tip - up * (0.3 / half.cos());
        let across = [wall(-1.0, 0.0), wall(0.0, -1.0)];
        let length = |q: Point3| {
            let high = across.iter().map(|n| (tip - q).dot(*n) / way.dot(*n)).fold(f64::INFINITY, f64::min);
            high - (-q.z / way.z)
        };
        let removed = sum_over(0.0, half, |a| {
            let arm = up * a.cos() + side * a.sin();
            // Along a ray from the ball's centre the length is even, and Simpson's rule exact.
            let [from, to] = [0.3, 0.3 / (half - a).cos()];
            let at = |r: f64| r * length(centre + arm * r);
            (to - from) / 6.0 * (at(from) + 4.0 * at(0.5 * (from + to)) + at(to))
        });
        holds(&made, volume - 2.0 * removed, 1e-10);
    }
}

#[test]
fn what_there_is_no_room_for_is_refused_by_name() {
    let bracket = prism(&ELL, 3.0);
    let all = |r: f64| rounded(&bracket, &radii(&bracket, |_| Some(r)));
    // From 1 on nothing of the narrow sides would be left.
    for r in [1.0, 1.0 + 1e-9, 1.2, 5.0] {
        let error = all(r).unwrap_err().to_string();
        assert!(error.contains("edge") && error.contains("too large"), "{error}");
    }
    assert!(all(1.0 - 1e-3).unwrap().is_solid());
    // In a later step edges keep the names that they had.
    let low = prism(&ELL, 1.0);
    let names = radii(&low, |m| Some(if near(m.z, 0.5) { 0.7 } else { 0.6 }));
    let error = rounded(&low, &names).unwrap_err().to_string();
    let named = error.split("edge ").nth(1).and_then(|rest| rest.split(&[':', ' '][..]).next());
    let named: usize = named.unwrap().parse().unwrap();
    assert!(named < bracket.edges().len(), "{error}");
}

#[test]
fn nobody_waits_for_ever() {
    let bracket = prism(&ELL, 3.0);
    let all = radii(&bracket, |_| Some(0.3));
    let none = CancellationToken::new(|| false);
    assert_eq!(none.during(|| rounded(&bracket, &all)), Err(katydid_geometry::Error::Stopped));
}

#[test]
fn a_slanted_bracket() {
    let profile = outline(&ELL);
    // The volumes are those that Open CASCADE's rolling ball leaves.
    for (slant, volume) in [
        (Vector3::new(0.4, 0.0, 3.0), 41.978_673_971_5),
        (Vector3::new(-0.5, 0.3, 3.0), 41.947_147_473_9),
        (Vector3::new(0.3, 0.6, 3.0), 41.988_382_740_0),
    ] {
        let bracket = construct::extrude(&profile, slant, true, &TOLERANCE).unwrap();
        let inner = |m: Point3| near(m.x, 2.0 + 0.5 * slant.x) && near(m.y, 2.0 + 0.5 * slant.y);
        let foot = |m: Point3| near(m.z, 0.0) && m.y > 1.0 && (near(m.x, 2.0) || near(m.y, 2.0));
        let edges = radii(&bracket, |m| (inner(m) || foot(m)).then_some(0.3));
        assert_eq!(edges.len(), 3);
        let made = rounded(&bracket, &edges).unwrap();
        holds(&made, volume, 1e-7);
    }
}
