//! Closed forms, as far as surfaces reach, and common areas.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing test may panic")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::{BranchKind, SurfaceBranch, SurfaceContactKind, SurfaceMeeting, surface_with_surface};
use crate::{
    Cone, Curve, Cylinder, Direction, Interval, NurbsSurface, Plane, PlaneSurface, Point3, Sphere, Surface,
    Tolerance, Torus, Vector3, Xform,
};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

/// The surfaces' meeting, with every branch on both surfaces by its images, for the surfaces as they are, exchanged, and as
/// NURBS copies.
fn meet(a: &Surface, b: &Surface) -> SurfaceMeeting {
    let tolerance = Tolerance { absolute: 1e-5, ..Tolerance::default() };
    let met = surface_with_surface(a, b, &tolerance).unwrap();
    let size = a.bounding_box().unwrap().diagonal().length();
    for branch in all(&met) {
        on_both(branch, [a, b], 1e-6 * size);
    }
    let swapped = surface_with_surface(b, a, &tolerance).unwrap();
    assert_eq!(summary(&met), summary(&swapped), "swapped");
    let copies = [a, b].map(|s| Surface::from(s.to_nurbs().unwrap()));
    let copied = surface_with_surface(&copies[0], &copies[1], &tolerance).unwrap();
    assert_eq!(summary(&met), summary(&copied), "copied");
    for branch in all(&copied) {
        on_both(branch, [&copies[0], &copies[1]], 1e-6 * size);
    }
    met
}

fn all(met: &SurfaceMeeting) -> impl Iterator<Item = &SurfaceBranch> {
    met.branches
        .iter()
        .chain(met.contacts.iter().flat_map(|c| c.curve.iter().chain(c.border.iter().flatten())))
}

fn on_both(branch: &SurfaceBranch, surfaces: [&Surface; 2], near: f64) {
    let domain = branch.curve.domain();
    for k in 0..=50 {
        let share = f64::from(k) / 50.0;
        let p = branch.curve.point_at(domain.at(share));
        for (surface, image) in surfaces.iter().zip(&branch.parameters) {
            let uv = image.point_at(image.domain().at(share));
            let [u, v] = [(Direction::U, uv.x), (Direction::V, uv.y)].map(|(d, t)| {
                let domain = surface.domain(d);
                if domain.contains(t) {
                    t
                } else if surface.is_closed(d) {
                    domain.wrapped(t)
                } else {
                    assert!((domain.clamp(t) - t).abs() < 1e-9 * domain.length(), "{t} {domain:?}");
                    domain.clamp(t)
                }
            });
            let off = surface.point_at(u, v).distance_to(p);
            assert!(off < near, "{off} at {share}");
        }
    }
}

/// Kinds and counts, and the length to seven digits.
fn summary(met: &SurfaceMeeting) -> (Vec<String>, Vec<String>, bool, i64) {
    let mut branches: Vec<String> =
        met.branches.iter().map(|b| format!("{:?} {}", b.kind, b.closed)).collect();
    branches.sort();
    let mut contacts: Vec<String> = met
        .contacts
        .iter()
        .map(|c| format!("{:?} {} {}", c.kind, c.curve.is_some(), c.border.len()))
        .collect();
    contacts.sort();
    let length: f64 = all(met).map(|b| b.curve.length()).sum();
    (branches, contacts, met.complete, (length * 1e6).round() as i64)
}

fn ball(center: Point3, radius: f64) -> Surface {
    Sphere::around(center, radius).unwrap().into()
}

fn floor(plane: Plane, side: f64) -> Surface {
    let range = Interval::new(-side, side);
    PlaneSurface::new(plane, range, range).unwrap().into()
}

fn tube(plane: Plane, radius: f64, low: f64, high: f64) -> Surface {
    Cylinder::new(plane, radius, Interval::new(low, high)).unwrap().into()
}

fn kinds(met: &SurfaceMeeting) -> Vec<BranchKind> {
    met.branches.iter().map(|b| b.kind).collect()
}

fn contacts(met: &SurfaceMeeting) -> Vec<SurfaceContactKind> {
    met.contacts.iter().map(|c| c.kind).collect()
}

#[test]
fn conics_keep_their_kind() {
    let slanted = |origin: Point3, way: Vector3| Plane::from_normal(origin, way).unwrap();
    let pipe = tube(Plane::XY, 1.0, -3.0, 3.0);
    let met = meet(&pipe, &floor(slanted(p(0.1, 0.0, 0.2), Vector3::new(1.0, 0.0, 2.0)), 5.0));
    assert_eq!(kinds(&met), vec![BranchKind::Ellipse]);
    assert!(met.complete && met.branches[0].closed && met.contacts.is_empty());
    // Two rulings.
    let met = meet(&pipe, &floor(slanted(p(0.5, 0.0, 0.0), Vector3::X), 5.0));
    assert_eq!(kinds(&met), vec![BranchKind::Line; 2]);
    assert!((met.branches[0].curve.length() - 6.0).abs() < 1e-12);
    let cone: Surface = Cone::new(Plane::XY, 4.0, 2.0).unwrap().into();
    // Half angle with tan 1/2: a plane along a ruling beyond the axis gives a parabola, a steeper one a hyperbola.
    let met = meet(&cone, &floor(slanted(p(0.0, 0.0, 1.0), Vector3::new(2.0, 0.0, -1.0)), 9.0));
    assert_eq!(kinds(&met), vec![BranchKind::Parabola]);
    let met = meet(&cone, &floor(slanted(p(0.5, 0.0, 0.0), Vector3::X), 9.0));
    assert_eq!(kinds(&met), vec![BranchKind::Hyperbola]);
    let met = meet(&cone, &floor(slanted(p(0.0, 0.0, 2.0), Vector3::new(0.3, 0.1, 1.0)), 9.0));
    assert_eq!(kinds(&met), vec![BranchKind::Ellipse]);
    let met = meet(&cone, &floor(Plane::XY.offset(2.0), 9.0));
    assert_eq!(kinds(&met), vec![BranchKind::Circle]);
    let circle = met.branches[0].curve.as_circle(1e-12).unwrap();
    assert!((circle.radius - 1.0).abs() < 1e-12);
}

#[test]
fn branches_end_on_sides_and_poles() {
    // Through both poles of a ball: two halves of a great circle.
    let upright = Plane::from_normal(Point3::ORIGIN, Vector3::new(1.0, 2.0, 0.0)).unwrap();
    let met = meet(&ball(Point3::ORIGIN, 2.0), &floor(upright, 5.0));
    assert_eq!(kinds(&met), vec![BranchKind::Circle; 2]);
    assert!(met.branches.iter().all(|b| !b.closed && (b.curve.length() - 2.0 * PI).abs() < 1e-12));
    // A floor that holds a part of the circle only: its corner is at the centre.
    let quarter: Surface =
        PlaneSurface::new(Plane::XY.offset(0.5), Interval::new(0.0, 5.0), Interval::new(0.0, 5.0))
            .unwrap()
            .into();
    let met = meet(&ball(Point3::ORIGIN, 2.0), &quarter);
    let [arc] = &met.branches[..] else { panic!("{}", met.branches.len()) };
    assert!((arc.curve.length() - FRAC_PI_2 * 3.75_f64.sqrt()).abs() < 1e-9, "{}", arc.curve.length());
    // A square inside the circle's reach: four arcs beyond its sides are missing.
    let met = meet(&ball(Point3::ORIGIN, 2.0), &floor(Plane::XY, 1.8));
    assert_eq!(kinds(&met), vec![BranchKind::Circle; 4]);
    let angle = FRAC_PI_2 - 2.0 * (1.8_f64 / 2.0).acos();
    for arc in &met.branches {
        assert!((arc.curve.length() - 2.0 * angle).abs() < 1e-8, "{}", arc.curve.length());
    }
    // One that it touches from inside is whole.
    let met = meet(&ball(Point3::ORIGIN, 2.0), &floor(Plane::XY, 2.0));
    assert_eq!(met.branches.len(), 1);
    assert!(met.branches[0].closed);
}

#[test]
fn branches_run_along_the_product_of_the_normals() {
    let a = ball(Point3::ORIGIN, 2.0);
    let b = floor(Plane::XY.offset(0.5), 5.0);
    for (first, second) in [(&a, &b), (&b, &a)] {
        let met = meet(first, second);
        let branch = &met.branches[0];
        let t = branch.curve.domain().at(0.3);
        let both = [first, second];
        let normals = both.iter().zip(&branch.parameters).map(|(s, image)| {
            let uv = image.point_at(image.domain().at(0.3));
            let wrapped =
                |d: Direction, x: f64| if s.domain(d).contains(x) { x } else { s.domain(d).wrapped(x) };
            s.normal_at(wrapped(Direction::U, uv.x), wrapped(Direction::V, uv.y)).unwrap()
        });
        let [m, n] = <[Vector3; 2]>::try_from(normals.collect::<Vec<_>>()).unwrap();
        assert!(branch.curve.tangent_at(t).unwrap().dot(m.cross(n)) > 0.1);
    }
}

#[test]
fn conics_cross_where_surfaces_touch() {
    let lying = Plane::from_normal(Point3::ORIGIN, Vector3::X).unwrap();
    let met = meet(&tube(lying, 2.0, -9.0, 9.0), &tube(Plane::XY, 2.0, -9.0, 9.0));
    assert_eq!(kinds(&met), vec![BranchKind::Ellipse; 2]);
    assert!(met.complete && met.branches.iter().all(|b| b.closed));
    assert_eq!(contacts(&met), vec![SurfaceContactKind::Crossing; 2]);
    for c in &met.contacts {
        assert!((c.point.y.abs() - 2.0).abs() < 1e-12 && c.gap < 1e-12, "{:?}", c.point);
    }
    // Villarceau's circles.
    let ring: Surface = Torus::new(Plane::XY, 5.0, 2.0).unwrap().into();
    let (sin, cos) = (0.4_f64, (1.0_f64 - 0.16).sqrt());
    let bitangent = Plane::from_normal(Point3::ORIGIN, Vector3::new(sin, 0.0, cos)).unwrap();
    let met = meet(&ring, &floor(bitangent, 9.0));
    assert_eq!(kinds(&met), vec![BranchKind::Circle; 2]);
    assert_eq!(contacts(&met), vec![SurfaceContactKind::Crossing; 2]);
    for b in &met.branches {
        assert!((b.curve.length() - 10.0 * PI).abs() < 1e-9);
    }
}

#[test]
fn touches_keep_their_kind() {
    let met = meet(&ball(p(0.0, 0.0, 1.0), 1.0), &floor(Plane::XY, 3.0));
    assert_eq!(contacts(&met), vec![SurfaceContactKind::Point]);
    assert!(met.contacts[0].point.distance_to(Point3::ORIGIN) < 1e-12 && met.contacts[0].gap < 1e-12);
    let met = meet(
        &tube(Plane::XY, 1.0, -3.0, 3.0),
        &floor(Plane::from_normal(p(1.0, 0.0, 0.0), Vector3::X).unwrap(), 2.0),
    );
    assert_eq!(contacts(&met), vec![SurfaceContactKind::Curve]);
    let line = met.contacts[0].curve.as_ref().unwrap();
    assert!(line.kind == BranchKind::Line && (line.curve.length() - 4.0).abs() < 1e-12);
    let met = meet(&tube(Plane::XY, 1.0, -3.0, 3.0), &ball(p(0.0, 0.0, 0.2), 1.0));
    assert_eq!(contacts(&met), vec![SurfaceContactKind::Curve]);
    assert!(met.contacts[0].curve.as_ref().unwrap().closed);
    // The surfaces touch beyond the floor: not at all.
    let beside: Surface =
        PlaneSurface::new(Plane::XY, Interval::new(0.5, 3.0), Interval::new(0.5, 3.0)).unwrap().into();
    assert!(meet(&ball(p(0.0, 0.0, 1.0), 1.0), &beside).contacts.is_empty());
}

/// The signed area that images of border loops go around in one domain.
fn around(loops: &[Vec<SurfaceBranch>], s: usize) -> f64 {
    let mut sum = 0.0;
    for image in loops.iter().flatten().map(|b| &b.parameters[s]) {
        let n = 2000;
        let at = |k: usize| image.point_at(image.domain().at(k as f64 / n as f64));
        for k in 0..n {
            let (a, b) = (at(k), at(k + 1));
            sum += 0.5 * (a.x * b.y - b.x * a.y);
        }
    }
    sum
}

fn area(met: &SurfaceMeeting) -> &Vec<Vec<SurfaceBranch>> {
    let [only] = &met.contacts[..] else { panic!("{:?}", contacts(met)) };
    assert!(only.kind == SurfaceContactKind::Overlap && met.complete && met.branches.is_empty());
    &only.border
}

#[test]
fn planes_overlap() {
    // A square of 4 and one of 2 turned by 45° about its corner.
    let a: Surface =
        PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 4.0)).unwrap().into();
    let inside =
        Plane::from_axes(p(2.0, 1.0, 0.0), Vector3::new(1.0, 1.0, 0.0), Vector3::new(-1.0, 1.0, 0.0))
            .unwrap();
    let b = |side: f64| -> Surface {
        PlaneSurface::new(inside, Interval::new(0.0, side), Interval::new(0.0, side)).unwrap().into()
    };
    let met = meet(&a, &b(1.0));
    assert_eq!(area(&met).len(), 1);
    assert!((around(area(&met), 0) - 1.0).abs() < 1e-9, "{}", around(area(&met), 0));
    // Now its left and right corners stick out: (2 ± 2.12, 3.12), and its top at 5.24.
    let met = meet(&a, &b(3.0));
    let want = {
        // Clip the square by the larger one: 9 less the corners beyond x = 0, x = 4 and y = 4.
        let h = 3.0 / 2.0_f64.sqrt();
        let (side, top) = (h - 2.0, 1.0 + 2.0 * h - 4.0);
        9.0 - 2.0 * side * side - top * top
    };
    assert!((around(area(&met), 0) - want).abs() < 1e-9, "{} {want}", around(area(&met), 0));
    // Side by side they have a line in common.
    let c: Surface =
        PlaneSurface::new(Plane::XY, Interval::new(4.0, 6.0), Interval::new(1.0, 7.0)).unwrap().into();
    let met = meet(&a, &c);
    assert_eq!(contacts(&met), vec![SurfaceContactKind::Curve]);
    assert!((met.contacts[0].curve.as_ref().unwrap().curve.length() - 3.0).abs() < 1e-9);
    // Apart: nothing.
    let d: Surface =
        PlaneSurface::new(Plane::XY, Interval::new(4.5, 6.0), Interval::new(1.0, 7.0)).unwrap().into();
    assert!(meet(&a, &d).contacts.is_empty());
}

#[test]
fn quadrics_overlap() {
    // Two pipes one in the other: a ring from 1 to 3.
    let met = meet(&tube(Plane::XY, 1.0, -2.0, 3.0), &tube(Plane::XY.rotated(1.0), 1.0, 1.0, 5.0));
    assert_eq!(area(&met).len(), 2);
    assert!(area(&met).iter().flatten().all(|b| b.closed && b.kind == BranchKind::Circle));
    let heights: Vec<f64> = area(&met).iter().flatten().map(|b| b.curve.start().z).collect();
    assert!(
        heights.iter().any(|z| (z - 1.0).abs() < 1e-12) && heights.iter().any(|z| (z - 3.0).abs() < 1e-12)
    );
    // A half pipe from 0° to 180° and one from 90° to 270°.
    let half = |turn: f64| -> Surface {
        let whole = tube(Plane::XY.rotated(turn), 1.0, 0.0, 2.0);
        let d = if whole.is_closed(Direction::U) { Direction::U } else { Direction::V };
        let domain = whole.domain(d);
        whole.trimmed(d, Interval::new(domain.start, domain.middle())).unwrap()
    };
    let met = meet(&half(0.0), &half(FRAC_PI_2));
    assert_eq!(area(&met).len(), 1);
    let length: f64 = area(&met)[0].iter().map(|b| b.curve.length()).sum();
    assert!((length - (4.0 + PI)).abs() < 1e-8, "{length}");
    // Equal balls with other poles, and equal rings with other seams, as a whole.
    let turned = Plane::from_normal(Point3::ORIGIN, Vector3::new(1.0, 2.0, 3.0)).unwrap();
    let met = meet(&ball(Point3::ORIGIN, 2.0), &Sphere::new(turned, 2.0).unwrap().into());
    assert!(area(&met).is_empty());
    let ring = |turn: f64| -> Surface { Torus::new(Plane::XY.rotated(turn), 5.0, 2.0).unwrap().into() };
    assert!(area(&meet(&ring(0.0), &ring(1.0))).is_empty());
    // A cap of a ball on it.
    let cap: Surface = Sphere::new(turned, 2.0).unwrap().into();
    let v = cap.domain(Direction::V);
    let cap = cap.trimmed(Direction::V, Interval::new(v.at(0.8), v.end)).unwrap();
    let met = meet(&ball(Point3::ORIGIN, 2.0), &cap);
    assert_eq!(area(&met).len(), 1);
    assert!(area(&met)[0][0].closed);
}

/// A wavy bicubic patch.
fn wave() -> NurbsSurface {
    let n = 7;
    let points: Vec<Point3> = (0..n * n)
        .map(|k| {
            let (i, j) = ((k / n) as f64, (k % n) as f64);
            p(i, j, 0.7 * (1.3 * i).sin() * (1.1 * j + 0.4).cos())
        })
        .collect();
    let knots = || crate::clamped_uniform_knots(3, n).unwrap();
    NurbsSurface::new([3, 3], [n, n], points, [knots(), knots()]).unwrap()
}

#[test]
fn patches_of_one_surface_overlap() {
    let whole = wave();
    let window = |u: [f64; 2], v: [f64; 2]| -> Surface {
        let [du, dv] = Direction::BOTH.map(|d| whole.domain(d));
        let part = whole.trimmed(Direction::U, Interval::new(du.at(u[0]), du.at(u[1]))).unwrap();
        part.trimmed(Direction::V, Interval::new(dv.at(v[0]), dv.at(v[1]))).unwrap().into()
    };
    let [du, dv] = Direction::BOTH.map(|d| whole.domain(d).length());
    let all = Surface::from(whole.clone());
    for (a, b, part) in [
        (all.clone(), window([0.21, 0.63], [0.37, 0.71]), 0.42 * 0.34),
        (window([0.0, 0.6], [0.1, 0.7]), window([0.4, 1.0], [0.3, 0.9]), 0.2 * 0.4),
        (all, window([0.0, 0.5], [0.0, 1.0]), 0.5),
    ] {
        let met = meet(&a, &b);
        assert_eq!(area(&met).len(), 1, "{part}");
        let own = around(area(&met), 0);
        assert!((own - part * du * dv).abs() < 1e-6 * du * dv, "{own} {}", part * du * dv);
    }
}

/// A generator of numbers between 0 and 1 (S. Vigna's splitmix64).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    fn way(&mut self) -> Vector3 {
        loop {
            let w = Vector3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if w.length() > 0.1 && w.length() < 1.0 {
                return w.unitized().unwrap();
            }
        }
    }
}

/// Balls, planes, pipes and rings in random places: circles and points by the triangle of their sizes. How many pairs went wrong.
fn wrong(pairs: u64, first: u64) -> usize {
    let mut wrong = 0;
    for k in first..first + pairs {
        let r = &mut Random(0xBEEF + k);
        let center = p(r.between(-3.0, 3.0), r.between(-3.0, 3.0), r.between(-3.0, 3.0));
        let frame = Plane::from_normal(center, r.way()).unwrap().rotated(r.between(0.0, TAU));
        let radius = r.between(0.2, 2.0);
        let as_copy = k % 2 == 0;
        // Every fifth pair touches exactly.
        let tangent = k % 5 == 0;
        let (a, b, want): (Surface, Surface, Vec<f64>) = match k % 4 {
            0 => {
                let other = r.between(0.2, 2.0);
                let d = if tangent { radius + other } else { r.between(0.0, 1.3 * (radius + other)) };
                let x = (d * d + radius * radius - other * other) / (2.0 * d);
                let h = radius * radius - x * x;
                let want = if tangent || h < 0.0 { vec![] } else { vec![h.sqrt()] };
                (ball(center, radius), ball(center + r.way() * d, other), want)
            }
            1 => {
                let d = if tangent { radius } else { r.between(0.0, 1.3 * radius) };
                let way = frame.z_axis;
                let h = radius * radius - d * d;
                let want = if tangent || h < 0.0 { vec![] } else { vec![h.sqrt()] };
                (ball(center, radius), floor(Plane::from_normal(center + way * d, way).unwrap(), 9.0), want)
            }
            2 => {
                // A ball on the axis of a pipe.
                let own = r.between(0.2, 2.0);
                let h = own * own - radius * radius;
                let want = if h < 0.0 { vec![] } else { vec![radius; 2] };
                (tube(frame, radius, -5.0, 5.0), ball(center, own), want)
            }
            _ => {
                let major = radius + r.between(0.5, 3.0);
                let z = if tangent { radius } else { r.between(0.0, 1.2 * radius) };
                let h = radius * radius - z * z;
                let want = if tangent || h < 0.0 { vec![] } else { vec![major - h.sqrt(), major + h.sqrt()] };
                (Torus::new(frame, major, radius).unwrap().into(), floor(frame.offset(z), 9.0), want)
            }
        };
        let copy = |s: Surface| if as_copy { Surface::from(s.to_nurbs().unwrap()) } else { s };
        let (a, b) = (copy(a), copy(b));
        let met =
            surface_with_surface(&a, &b, &Tolerance { absolute: 1e-4, ..Tolerance::default() }).unwrap();
        let mut radii: Vec<f64> = met
            .branches
            .iter()
            .filter_map(|b| match &b.curve {
                Curve::Arc(arc) if b.closed => Some(arc.arc.circle.radius),
                _ => None,
            })
            .collect();
        radii.sort_by(f64::total_cmp);
        // A circle's radius is the root of a difference: what rounding leaves of it.
        let same = radii.len() == want.len()
            && radii.len() == met.branches.len()
            && radii.iter().zip(&want).all(|(x, y)| (x - y).abs() < 1e-11 / y.max(1e-3));
        let touches = match (tangent, k % 4) {
            (true, 0 | 1) => contacts(&met) == vec![SurfaceContactKind::Point],
            (true, 3) => contacts(&met) == vec![SurfaceContactKind::Curve],
            _ => met.contacts.is_empty(),
        };
        if !(same && touches && met.complete) {
            wrong += 1;
            println!("pair {k}: {radii:?} for {want:?}, {:?} {}", contacts(&met), met.complete);
        }
    }
    wrong
}

#[test]
fn random_closed_forms_are_right() {
    assert_eq!(wrong(200, 0), 0);
}

/// Run with `make test-branches`.
#[test]
#[ignore = "a minute of work: make test-branches"]
fn no_branch_of_many_closed_forms_is_wrong() {
    assert_eq!(wrong(10_000, 1000), 0);
}

/// Moves, scales, turns and other parameters change nothing of pairs with a closed form.
#[test]
fn closed_forms_keep_their_kind() {
    let slanted = Plane::from_normal(p(0.1, 0.0, 0.2), Vector3::new(1.0, 0.0, 2.0)).unwrap();
    let lying = Plane::from_normal(Point3::ORIGIN, Vector3::X).unwrap();
    let ring: Surface = Torus::new(Plane::XY, 2.0, 0.5).unwrap().into();
    let cone: Surface = Cone::new(Plane::XY, 4.0, 2.0).unwrap().into();
    let pairs = [
        (tube(Plane::XY, 1.0, -3.0, 3.0), floor(slanted, 5.0)),
        (tube(Plane::XY, 1.0, -3.0, 3.0), tube(lying, 1.0, -3.0, 3.0)),
        (tube(Plane::XY, 1.0, -3.0, 3.0), ball(p(0.0, 0.0, 0.5), 1.5)),
        (cone, floor(slanted, 5.0)),
        (ring, ball(p(0.0, 0.0, 0.3), 2.0)),
    ];
    for (i, (a, b)) in pairs.iter().enumerate() {
        let [a, b] = [a, b].map(|s| s.to_nurbs().unwrap());
        let run = |a: &NurbsSurface, b: &NurbsSurface, scale: f64| {
            let tolerance = Tolerance { absolute: 1e-5 * scale, ..Tolerance::default() };
            let met = super::surface_surface(a, b, &tolerance).unwrap();
            let mut kinds: Vec<String> =
                met.branches.iter().map(|b| format!("{:?} {}", b.kind, b.closed)).collect();
            kinds.sort();
            let length: f64 = met.branches.iter().map(|b| b.curve.length()).sum();
            ((kinds, contacts(&met), met.complete), length / scale)
        };
        let (want, length) = run(&a, &b, 1.0);
        assert!(want.2 && !want.0.is_empty() && want.0.iter().all(|k| !k.starts_with("Followed")), "{i}");
        let axis = Vector3::new(1.0, 2.0, 3.0).unitized().unwrap();
        for (name, xform, scale) in [
            ("small", Xform::scale(Point3::ORIGIN, 1e-3), 1e-3),
            ("large", Xform::scale(Point3::ORIGIN, 1e4), 1e4),
            ("turned", Xform::rotation(0.7, axis, Point3::ORIGIN).unwrap(), 1.0),
            ("moved", Xform::translation(Vector3::new(1e6, -1e6, 1e6)), 1.0),
        ] {
            let [a, b] = [&a, &b].map(|s| s.transformed(&xform).unwrap());
            let (own, long) = run(&a, &b, scale);
            assert_eq!(own, want, "{i} {name}");
            assert!((long - length).abs() < 1e-6 * length, "{i} {name} {long} {length}");
        }
        let raised = a
            .raised_to(Direction::U, 3)
            .unwrap()
            .insert_knot(Direction::V, a.domain(Direction::V).at(0.3), 1)
            .unwrap();
        for (name, other) in
            [("transposed", a.transposed()), ("reversed", a.reversed(Direction::U)), ("raised", raised)]
        {
            let (own, long) = run(&other, &b, 1.0);
            assert_eq!(own, want, "{i} {name}");
            assert!((long - length).abs() < 1e-9 * length, "{i} {name} {long} {length}");
        }
    }
}
