#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing test may panic")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::{Axis, Carrier, CarrierMeeting, Conic, carrier_carrier};
use crate::{Plane, Point3, Tolerance, Vector3, Xform};

/// What is equal to rounding at the size of these cases.
const EXACT: Tolerance = Tolerance { absolute: 1e-9, angle: 1e-9 };
/// Pairs of each family: more than 10,000 in all.
const TIMES: usize = 420;

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

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn sign(&mut self) -> f64 {
        if self.unit() < 0.5 { -1.0 } else { 1.0 }
    }
}

fn direction(azimuth: f64, polar: f64) -> Vector3 {
    let ((sa, ca), (sp, cp)) = (azimuth.sin_cos(), polar.sin_cos());
    Vector3::new(sp * ca, sp * sa, cp)
}

fn plane(origin: Point3, normal: Vector3) -> Carrier {
    Carrier::Plane(Plane::from_normal(origin, normal).unwrap())
}

fn at(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn sphere(center: Point3, radius: f64) -> Carrier {
    Carrier::Sphere { center, radius }
}

fn cylinder(origin: Point3, direction: Vector3, radius: f64) -> Carrier {
    Carrier::Cylinder { axis: Axis { origin, direction }, radius }
}

fn cone(origin: Point3, direction: Vector3, half_angle: f64) -> Carrier {
    Carrier::Cone { axis: Axis { origin, direction }, half_angle }
}

fn torus(z: f64, major_radius: f64, minor_radius: f64) -> Carrier {
    let axis = Axis { origin: at(0.0, 0.0, z), direction: Vector3::Z };
    Carrier::Torus { axis, major_radius, minor_radius }
}

fn moved(c: &Carrier, x: &Xform) -> Carrier {
    let on =
        |a: &Axis| Axis { origin: x.point(a.origin), direction: x.vector(a.direction).unitized().unwrap() };
    match c {
        Carrier::Plane(p) => Carrier::Plane(p.transformed(x).unwrap()),
        Carrier::Sphere { center, radius } => Carrier::Sphere { center: x.point(*center), radius: *radius },
        Carrier::Cylinder { axis, radius } => Carrier::Cylinder { axis: on(axis), radius: *radius },
        Carrier::Cone { axis, half_angle } => Carrier::Cone { axis: on(axis), half_angle: *half_angle },
        Carrier::Torus { axis, major_radius, minor_radius } => {
            Carrier::Torus { axis: on(axis), major_radius: *major_radius, minor_radius: *minor_radius }
        }
    }
}

/// The unit normal at a point of the surface; none at an apex.
fn normal(c: &Carrier, p: Point3) -> Option<Vector3> {
    let e = 1e-6;
    let value = |p: Point3| match c {
        Carrier::Plane(plane) => plane.signed_distance(p),
        Carrier::Sphere { center, radius } => p.distance_to(*center) - radius,
        Carrier::Cylinder { axis, radius } => axis.split(p).1.length() - radius,
        Carrier::Cone { axis, half_angle } => {
            let (z, way) = axis.split(p);
            way.length() * half_angle.cos() - z.abs() * half_angle.sin()
        }
        Carrier::Torus { axis, major_radius, minor_radius } => {
            let (z, way) = axis.split(p);
            (way.length() - major_radius).hypot(z) - minor_radius
        }
    };
    let slope = |d: Vector3| (value(p + d * e) - value(p - d * e)) / (2.0 * e);
    Vector3::new(slope(Vector3::X), slope(Vector3::Y), slope(Vector3::Z)).unitized()
}

fn letter(c: &Conic) -> char {
    match c {
        Conic::Line(_) => 'l',
        Conic::Circle(_) => 'c',
        Conic::Ellipse(_) => 'e',
        Conic::Parabola { .. } => 'p',
        Conic::Hyperbola { .. } => 'h',
    }
}

/// Letters of the curves (capitals where they touch) and a dot for each point, in order; `=` for the same surface, `?`
/// without a closed form. Everything is checked to lie on both surfaces, and to touch or cross them as it says.
fn told(a: &Carrier, b: &Carrier) -> String {
    let Some(met) = carrier_carrier(a, b, &EXACT) else { return "?".into() };
    let CarrierMeeting::Parts { curves, points } = met else { return "=".into() };
    let mut out = String::new();
    for curve in &curves {
        let own = letter(&curve.conic);
        out.push(if curve.tangent { own.to_ascii_uppercase() } else { own });
        let (mut least, mut most) = (1.0_f64, 0.0_f64);
        for k in -20..=20 {
            let p = curve.conic.at(f64::from(k) * PI / 20.0);
            let size = 10.0 + p.to_vector().length();
            for s in [a, b] {
                assert!(s.distance_to(p) <= 1e-12 * size, "{own} {a:?} {b:?} {:e}", s.distance_to(p) / size);
            }
            if let (Some(m), Some(n)) = (normal(a, p), normal(b, p)) {
                let sine = m.cross(n).length();
                (least, most) = (least.min(sine), most.max(sine));
            }
        }
        if curve.tangent {
            assert!(most < 2e-4, "{a:?} {b:?} {most}");
        } else {
            assert!(most > 1e-4, "{a:?} {b:?} {least} {most}");
        }
    }
    for p in &points {
        out.push('.');
        for s in [a, b] {
            assert!(s.distance_to(*p) <= 1e-12 * (10.0 + p.to_vector().length()), "{a:?} {b:?} {p:?}");
        }
    }
    let mut letters: Vec<char> = out.chars().collect();
    letters.sort_unstable();
    letters.into_iter().collect()
}

/// A family of pairs, each moved and turned, both ways round.
fn family(name: &str, mut pair: impl FnMut(&mut Random) -> (Carrier, Carrier, String)) {
    let mut random = Random(name.bytes().fold(7, |s, b| s.wrapping_mul(31).wrapping_add(u64::from(b))));
    for k in 0..TIMES {
        let (a, b, want) = pair(&mut random);
        let turn = Xform::rotation(
            random.within(0.0, TAU),
            direction(random.within(0.0, TAU), random.within(0.0, PI)),
            Point3::ORIGIN,
        );
        let way = Vector3::new(random.within(-9.0, 9.0), random.within(-9.0, 9.0), random.within(-9.0, 9.0));
        let motion =
            if k == 0 { Xform::translation(Vector3::ZERO) } else { Xform::translation(way) * turn.unwrap() };
        let (a, b) = (moved(&a, &motion), moved(&b, &motion));
        assert_eq!(told(&a, &b), want, "{name} {k}: {a:?} {b:?}");
        assert_eq!(told(&b, &a), want, "{name} {k} swapped: {a:?} {b:?}");
    }
}

/// One of several.
fn pick<T: Copy>(random: &mut Random, of: &[T]) -> T {
    of[((random.unit() * of.len() as f64) as usize).min(of.len() - 1)]
}

#[test]
fn planes_cut_planes_and_spheres() {
    family("plane plane", |r| {
        let (tilt, off, want) = pick(
            r,
            &[(0.0, 0.0, "="), (0.0, 2.0, ""), (0.3, 0.0, "l"), (FRAC_PI_2, 1.0, "l"), (1e-3, 1.0, "l")],
        );
        (
            plane(at(1.0, 2.0, off), Vector3::Z),
            plane(at(0.0, 0.0, 0.0), direction(r.within(0.0, TAU), tilt)),
            want.into(),
        )
    });
    family("plane sphere", |r| {
        let radius = r.within(0.1, 5.0);
        let (part, want) = pick(r, &[(0.0, "c"), (0.5, "c"), (0.999, "c"), (1.0, "."), (1.01, "")]);
        let d = part * radius * r.sign();
        (plane(at(3.0, 1.0, d), Vector3::Z), sphere(Point3::ORIGIN, radius), want.into())
    });
}

#[test]
fn planes_cut_cylinders() {
    family("plane cylinder", |r| {
        let radius = r.within(0.1, 5.0);
        let tilt = r.within(0.01, 1.5);
        let (polar, part, want) = pick(
            r,
            &[
                (0.0, 3.0, "c"),
                (tilt, 0.3, "e"),
                (FRAC_PI_2, 0.0, "ll"),
                (FRAC_PI_2, 0.7, "ll"),
                (FRAC_PI_2, 1.0, "L"),
                (FRAC_PI_2, 1.2, ""),
            ],
        );
        let n = direction(r.within(0.0, TAU), polar);
        (
            plane(Point3::ORIGIN + n * (part * radius), n),
            cylinder(at(0.0, 0.0, 2.0), Vector3::Z, radius),
            want.into(),
        )
    });
}

#[test]
fn planes_cut_cones() {
    family("plane cone", |r| {
        let angle = r.within(0.1, 1.4);
        let ruling = FRAC_PI_2 - angle;
        let (flat, steep) = (ruling * r.within(0.1, 0.95), ruling + angle * r.within(0.05, 0.95));
        let (polar, h, want) = pick(
            r,
            &[
                (0.0, 1.5, "c"),
                (0.0, 0.0, "."),
                (flat, 1.5, "e"),
                (flat, 0.0, "."),
                (ruling, 1.5, "p"),
                (ruling, 0.0, "L"),
                (steep, 1.5, "hh"),
                (steep, 0.0, "ll"),
                (FRAC_PI_2, 1.0, "hh"),
                (FRAC_PI_2, 0.0, "ll"),
            ],
        );
        let n = direction(r.within(0.0, TAU), polar);
        (plane(Point3::ORIGIN + n * (h * r.sign()), n), cone(Point3::ORIGIN, Vector3::Z, angle), want.into())
    });
}

#[test]
fn planes_cut_tori() {
    family("plane torus", |r| {
        let minor = r.within(0.2, 2.0);
        let major = minor * r.within(1.1, 4.0);
        let tilt = r.within(0.05, 1.5);
        let reach = major * tilt.sin() + minor;
        let (polar, h, want) = pick(
            r,
            &[
                (0.0, 0.0, "cc"),
                (0.0, 0.5 * minor, "cc"),
                (0.0, minor, "C"),
                (0.0, 1.1 * minor, ""),
                (FRAC_PI_2, 0.0, "cc"),
                ((minor / major).asin(), 0.0, "cc"),
                (tilt, reach, "."),
                (tilt, 1.01 * reach, ""),
                (FRAC_PI_2, 0.5 * major, "?"),
                (FRAC_PI_2, major + minor, "."),
            ],
        );
        let n = direction(r.within(0.0, TAU), polar);
        (plane(Point3::ORIGIN + n * (h * r.sign()), n), torus(0.0, major, minor), want.into())
    });
}

#[test]
fn spheres_meet_spheres_and_tubes() {
    family("sphere sphere", |r| {
        let (p, q) = (r.within(1.0, 3.0), r.within(3.1, 5.0));
        let between = (q - p) + 2.0 * p * r.within(0.05, 0.95);
        let (d, want) = pick(
            r,
            &[
                (0.0, ""),
                (0.5 * (q - p), ""),
                (q - p, "."),
                (between, "c"),
                (p + q, "."),
                (1.1 * (p + q), ""),
            ],
        );
        (sphere(Point3::ORIGIN, p), sphere(at(0.0, d, 0.0), q), want.into())
    });
    family("same sphere", |r| {
        let p = r.within(1.0, 3.0);
        (sphere(Point3::ORIGIN, p), sphere(Point3::ORIGIN, p), "=".into())
    });
    family("sphere cylinder", |r| {
        let p = r.within(1.0, 3.0);
        let (d, q, want) = pick(
            r,
            &[
                (0.0, 0.9 * p, ""),
                (0.0, p, "C"),
                (0.0, 1.2 * p, "cc"),
                (0.3 * p, 0.6 * p, ""),
                (0.3 * p, 0.7 * p, "."),
                (2.0 * p, p, "."),
                (2.0 * p, 0.9 * p, ""),
                (0.5 * p, p, "?"),
            ],
        );
        (cylinder(at(0.0, 0.0, 1.0), Vector3::Z, p), sphere(at(0.0, d, 4.0), q), want.into())
    });
    family("sphere cone", |r| {
        let angle = r.within(0.1, 1.3);
        let h = r.within(1.0, 4.0);
        let least = h * angle.sin();
        let (q, want) = pick(
            r,
            &[(0.9 * least, ""), (least, "C"), (0.5 * (least + h), "cc"), (h, ".c"), (1.3 * h, "cc")],
        );
        let up = r.sign();
        (cone(Point3::ORIGIN, Vector3::Z * up, angle), sphere(at(0.0, 0.0, h), q), want.into())
    });
    family("sphere beside cone", |r| {
        let angle = r.within(0.1, 1.3);
        let z = r.within(0.2, 3.0);
        let x = z * angle.tan() * r.within(1.1, 2.0);
        let off = x * angle.cos() - z * angle.sin();
        let (q, want) = pick(r, &[(0.9 * off, ""), (off, ".")]);
        (cone(Point3::ORIGIN, Vector3::Z, angle), sphere(at(x, 0.0, z), q), want.into())
    });
    // In the plane across the apex both nappes are equally near.
    let both = told(&cone(Point3::ORIGIN, Vector3::Z, 0.5), &sphere(at(2.0, 0.0, 0.0), 2.0 * 0.5f64.cos()));
    assert_eq!(both, "..");
    family("sphere torus", |r| {
        let (major, minor) = (r.within(2.0, 4.0), r.within(0.3, 1.5));
        let out = major.hypot(1.0);
        let (x, z, q, want) = pick(
            r,
            &[
                (0.0, 1.0, out - minor, "C"),
                (0.0, 1.0, out, "cc"),
                (0.0, 1.0, out + minor, "C"),
                (0.0, 1.0, 0.9 * (out - minor), ""),
                (0.0, 1.0, 1.1 * (out + minor), ""),
                (major, 0.0, minor, "C"),
                (major, 0.0, 0.8 * minor, ""),
                (major, 0.0, 1.2 * minor, "?"),
                (major, 3.0, 3.0 - minor, "."),
                (major, 3.0, 0.9 * (3.0 - minor), ""),
                (1.0, 0.0, 1.0 + major + minor, "."),
                (1.0, 0.0, 1.1 * (1.0 + major + minor), ""),
                (major + 0.1, 0.0, minor - 0.1, "."),
            ],
        );
        (torus(0.0, major, minor), sphere(at(x, 0.0, z), q), want.into())
    });
}

#[test]
fn cylinders_meet_cylinders() {
    family("cylinders side by side", |r| {
        let (p, q) = (r.within(1.0, 2.0), r.within(2.1, 3.0));
        let between = (q - p) + 2.0 * p * r.within(0.05, 0.95);
        let (d, want) = pick(
            r,
            &[(0.0, ""), (0.5 * (q - p), ""), (q - p, "L"), (between, "ll"), (p + q, "L"), (p + q + 0.1, "")],
        );
        (cylinder(Point3::ORIGIN, Vector3::Z, p), cylinder(at(0.0, d, 7.0), -Vector3::Z, q), want.into())
    });
    family("same cylinder", |r| {
        let p = r.within(1.0, 2.0);
        (cylinder(Point3::ORIGIN, Vector3::Z, p), cylinder(at(0.0, 0.0, 7.0), -Vector3::Z, p), "=".into())
    });
    family("crossed cylinders", |r| {
        let (p, q) = (r.within(1.0, 2.0), r.within(2.1, 3.0));
        let tilt = r.within(0.1, 3.0);
        let (d, q, want) =
            pick(r, &[(0.0, p, "ee"), (0.0, q, "?"), (p + q, q, "."), (1.1 * (p + q), q, ""), (0.1, p, "?")]);
        (
            cylinder(Point3::ORIGIN, Vector3::Z, p),
            cylinder(at(d, 0.0, 3.0), direction(FRAC_PI_2, tilt), q),
            want.into(),
        )
    });
}

#[test]
fn cones_meet_cylinders_and_cones() {
    family("cone in cylinder", |r| {
        let (angle, p) = (r.within(0.1, 1.4), r.within(0.5, 3.0));
        (cone(Point3::ORIGIN, Vector3::Z, angle), cylinder(at(0.0, 0.0, 5.0), Vector3::Z, p), "cc".into())
    });
    family("cone and cylinder around a sphere", |r| {
        let (angle, h) = (r.within(0.15, 1.3), r.within(1.0, 4.0));
        let own = r.within(0.1, 3.0);
        let free =
            if (own - angle).abs() < 0.05 || (PI - own - angle).abs() < 0.05 { angle + 0.1 } else { own };
        let (tilt, want) = pick(r, &[(free, "ee"), (angle, "Le"), (FRAC_PI_2, "ee")]);
        let c = cylinder(at(0.0, 0.0, h), direction(r.within(0.0, TAU), tilt), h * angle.sin());
        (cone(Point3::ORIGIN, Vector3::Z, angle), c, want.into())
    });
    family("cones about one axis", |r| {
        let (p, q) = (r.within(0.2, 0.7), r.within(0.8, 1.4));
        let (d, q, want) = pick(r, &[(0.0, p, "="), (0.0, q, "."), (1.5, p, "c"), (1.5, q, "cc")]);
        (cone(Point3::ORIGIN, Vector3::Z, p), cone(at(0.0, 0.0, d), -Vector3::Z, q), want.into())
    });
    family("cones moved", |r| {
        let p = r.within(0.3, 1.2);
        let inside = p * r.within(0.1, 0.9);
        let outside = p + (FRAC_PI_2 - p) * r.within(0.1, 1.0);
        let (polar, want) = pick(r, &[(inside, "e"), (p, "L"), (outside, "hh"), (FRAC_PI_2, "hh")]);
        let other = Point3::ORIGIN + direction(r.within(0.0, TAU), polar) * 2.0;
        (cone(Point3::ORIGIN, Vector3::Z, p), cone(other, Vector3::Z, p), want.into())
    });
    family("cones around a sphere", |r| {
        let (p, q) = (r.within(0.2, 0.5), r.within(0.2, 0.5));
        let tilt = r.within(1.2, 1.9);
        let h = r.within(1.0, 3.0);
        let far = h * p.sin() / q.sin();
        let d = direction(r.within(0.0, TAU), tilt);
        // Two slim cones that cross: each plane cuts all rulings.
        (cone(Point3::ORIGIN, Vector3::Z, p), cone(at(0.0, 0.0, h) - d * far, d, q), "ee".into())
    });
}

#[test]
fn cones_from_one_apex_share_rulings() {
    family("cones from one apex", |r| {
        let (p, q) = (r.within(0.1, 1.4), r.within(0.1, 1.4));
        let tilt = r.within(0.05, FRAC_PI_2);
        let (b, other) = (direction(0.0, tilt), cone(Point3::ORIGIN, direction(0.0, tilt), q));
        // By how often the rulings of one pass through the other.
        let side = |k: usize| {
            let d = direction(TAU * k as f64 / 3600.0 + 1e-4, p);
            d.dot(b).abs() > q.cos()
        };
        let count = (0..3600).filter(|k| side(*k) != side(k + 1)).count();
        let want = if count == 0 { ".".to_owned() } else { "l".repeat(count) };
        (cone(Point3::ORIGIN, Vector3::Z, p), other, want)
    });
    family("cones that touch along a ruling", |r| {
        let (p, q) = (r.within(0.1, 0.6), r.within(0.7, 0.9));
        let tilt = pick(r, &[p + q, q - p, PI - p - q, PI - (q - p)]);
        (cone(Point3::ORIGIN, Vector3::Z, p), cone(Point3::ORIGIN, direction(0.3, tilt), q), "L".into())
    });
}

#[test]
fn tori_meet_what_turns_about_their_axis() {
    family("torus cylinder", |r| {
        let (major, minor) = (r.within(2.0, 4.0), r.within(0.3, 1.5));
        let (p, want) = pick(
            r,
            &[
                (major, "cc"),
                (major + 0.5 * minor, "cc"),
                (major + minor, "C"),
                (major - minor, "C"),
                (1.1 * (major + minor), ""),
                (0.9 * (major - minor), ""),
            ],
        );
        (torus(1.0, major, minor), cylinder(at(0.0, 0.0, 9.0), Vector3::Z, p), want.into())
    });
    family("torus cone", |r| {
        let (major, minor) = (r.within(2.0, 4.0), r.within(0.3, 1.0));
        let angle = r.within(0.3, 0.8);
        // The apex below the middle by what puts the ruling at a distance from the middle circle.
        let (part, want) = pick(r, &[(0.0, "cc"), (0.7, "cc"), (1.0, "C"), (1.2, "")]);
        let z = (major * angle.cos() + part * minor * r.sign()) / angle.sin();
        (torus(0.0, major, minor), cone(at(0.0, 0.0, -z), Vector3::Z, angle), want.into())
    });
    family("torus torus", |r| {
        let (minor, other) = (r.within(0.3, 0.6), r.within(0.7, 1.0));
        let (d, want) =
            pick(r, &[(other - minor, "C"), (other + minor, "C"), (0.9, "cc"), (0.05, ""), (2.0, "")]);
        let turn = r.within(0.0, TAU);
        (torus(0.0, 3.5, minor), torus(d * turn.sin(), 3.5 + d * turn.cos(), other), want.into())
    });
    assert_eq!(told(&torus(1.0, 2.0, 1.0), &torus(1.0, 2.0, 1.0)), "=");
}

#[test]
fn carriers_are_told_inside_nurbs() {
    use crate::{Cone, Cylinder, Interval, Sphere, Surface, Torus};
    let frame = Plane::from_normal(at(1.0, 2.0, 3.0), Vector3::new(1.0, 2.0, 2.0)).unwrap();
    let surfaces: [Surface; 4] = [
        Sphere::new(frame, 2.0).unwrap().into(),
        Cylinder::new(frame, 2.0, Interval::new(0.0, 3.0)).unwrap().into(),
        Cone::new(frame, 3.0, 2.0).unwrap().into(),
        Torus::new(frame, 3.0, 1.0).unwrap().into(),
    ];
    for surface in surfaces {
        let copy = Surface::from(surface.to_nurbs().unwrap());
        let (own, of_copy) = (Carrier::of(&surface, 1e-9).unwrap(), Carrier::of(&copy, 1e-9).unwrap());
        assert_eq!(told(&own, &of_copy), "=", "{own:?} {of_copy:?}");
    }
}

#[test]
fn conics_are_exact_over_a_box() {
    let bounds = crate::BoundingBox::from_points([at(-3.0, -4.0, -5.0), at(6.0, 5.0, 4.0)]).unwrap();
    let frame = Plane::from_normal(at(0.5, 0.2, 0.1), Vector3::new(1.0, 2.0, 3.0)).unwrap();
    let conics = [
        Conic::Line(Axis { origin: frame.origin, direction: frame.z_axis }),
        Conic::Parabola { plane: frame, focal: 0.7 },
        Conic::Hyperbola { plane: frame, a: 0.4, b: 1.3 },
    ];
    for conic in conics {
        let curve = conic.over(&bounds).unwrap().unwrap();
        // Each point of the box on the conic is on the curve, and the curve is on the conic.
        for k in -400..=400 {
            let p = conic.at(f64::from(k) * 0.02);
            if bounds.contains(p) {
                assert!(curve.closest_point(p).unwrap().distance < 1e-10, "{conic:?} {k}");
            }
        }
        for k in 0..=40 {
            let p = curve.point_at(curve.domain().at(f64::from(k) / 40.0));
            let [x, y, z] = frame.coordinates(p);
            let off = match conic {
                Conic::Line(_) => x.hypot(y),
                Conic::Parabola { focal, .. } => z.hypot(y - x * x / (4.0 * focal)),
                Conic::Hyperbola { a, b, .. } => z.hypot((x / a).powi(2) - (y / b).powi(2) - 1.0),
                _ => 0.0,
            };
            assert!(off < 1e-10, "{conic:?} {k} {off}");
        }
    }
}

/// Over steps of all lengths the gradient changes by no more than is stated, and by that much somewhere.
#[test]
fn gradients_change_no_more_than_stated() {
    let axis = direction(0.7, 1.1);
    let carriers = [
        (plane(at(0.1, 0.2, 0.3), axis), 1.0),
        (sphere(at(1.0, -0.5, 0.2), 1.3), 0.99),
        (cylinder(at(0.2, 0.1, -0.4), axis, 0.8), 0.95),
        (cone(at(0.5, 0.3, 0.1), axis, 0.6), 0.3),
        (torus(0.2, 2.0, 0.7), 0.3),
    ];
    for (carrier, sharp) in carriers {
        let mut random = Random(7);
        let (mut closest, mut told) = (0.0_f64, 0);
        for _ in 0..20_000 {
            let mut somewhere = |size: f64| [0; 3].map(|_| random.within(-size, size));
            let [x, y, z] = somewhere(3.0);
            let p = at(x, y, z);
            let [x, y, z] = somewhere(1.0);
            let step = Vector3::new(x, y, z) * (10.0_f64).powf(-random.within(0.0, 4.0));
            let Some(most) = carrier.gradient_change(p, step.length()) else { continue };
            let change = (carrier.gradient(p + step) - carrier.gradient(p)).length();
            assert!(
                change <= most * (1.0 + 1e-9) + 1e-12,
                "{carrier:?} {p:?} {step:?}: {change} over {most}"
            );
            if most > 0.0 {
                closest = closest.max(change / most);
            }
            told += 1;
        }
        assert!(
            told > 5_000 && (matches!(carrier, Carrier::Plane(_)) || closest > sharp),
            "{carrier:?} {told} {closest}"
        );
    }
}
