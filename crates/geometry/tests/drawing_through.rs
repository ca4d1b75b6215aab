//! Drawings of solids that go through one another, beside outlines sampled closely.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::f64::consts::TAU;
use std::sync::Arc;

use katydid_geometry::construct;
use katydid_geometry::drawing::{DrawingOptions, Drawn, View, Visibility, drawing};
use katydid_geometry::{
    Box3, Brep, Circle, Cylinder, Interval, Line, Mesh, NurbsSurface, Plane, Point3, Sphere, Surface,
    Tolerance, Vector3,
};

/// Numbers without order, the same ones each time.
struct Dice(u64);

impl Dice {
    fn next(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn point(&mut self, reach: f64) -> Point3 {
        Point3::new(self.next(-reach, reach), self.next(-reach, reach), self.next(-reach, reach))
    }

    fn frame(&mut self, reach: f64) -> Plane {
        let origin = self.point(reach);
        let (x, y) = (self.point(1.0).to_vector(), self.point(1.0).to_vector());
        Plane::from_axes(origin, x, y).unwrap()
    }
}

/// A convex solid about the origin of its frame.
#[derive(Clone, Copy)]
enum Solid {
    Ball(Plane, f64),
    Block(Plane, [f64; 3]),
    Tube(Plane, f64, f64),
}

impl Solid {
    fn brep(&self) -> Brep {
        match *self {
            Self::Ball(frame, radius) => {
                Brep::from_surface(Sphere::new(frame, radius).unwrap().into()).unwrap()
            }
            Self::Block(plane, [a, b, c]) => {
                let side = |x: f64| Interval::new(-x, x);
                construct::box_brep(&Box3 { plane, x: side(a), y: side(b), z: side(c) }).unwrap()
            }
            Self::Tube(frame, radius, half) => {
                let tube = Cylinder::new(frame, radius, Interval::new(-half, half)).unwrap();
                let open = Brep::from_surface(tube.into()).unwrap();
                open.capped(&Tolerance::default()).unwrap().0
            }
        }
    }

    /// Whether a line upwards from a point comes out of the solid above it.
    fn covers(&self, p: Point3) -> bool {
        let (Self::Ball(frame, _) | Self::Block(frame, _) | Self::Tube(frame, ..)) = self;
        let q = frame.coordinates(p);
        let d = [frame.x_axis.z, frame.y_axis.z, frame.z_axis.z];
        let slab = |c: usize, half: f64| {
            let (s, t) = ((-half - q[c]) / d[c], (half - q[c]) / d[c]);
            [s.min(t), s.max(t)]
        };
        let round = |axes: &[usize], radius: f64| {
            let dot = |u: [f64; 3], v: [f64; 3]| axes.iter().map(|c| u[*c] * v[*c]).sum::<f64>();
            let (a, b, c) = (dot(d, d), dot(q, d), dot(q, q) - radius * radius);
            let square = b * b - a * c;
            // Nothing is above where the line passes by.
            if square < 0.0 { [0.0; 2] } else { [-1.0, 1.0].map(|sign| (-b + sign * square.sqrt()) / a) }
        };
        let ranges = match *self {
            Self::Ball(_, radius) => vec![round(&[0, 1, 2], radius)],
            Self::Block(_, sides) => (0..3).map(|c| slab(c, sides[c])).collect(),
            Self::Tube(_, radius, half) => vec![round(&[0, 1], radius), slab(2, half)],
        };
        let low = ranges.iter().map(|r| r[0]).fold(f64::NEG_INFINITY, f64::max);
        let high = ranges.iter().map(|r| r[1]).fold(f64::INFINITY, f64::min);
        high > low && high > 1e-5
    }

    /// Its outline and edges as seen from above: points at a share of each.
    fn curves(&self) -> Vec<Box<dyn Fn(f64) -> Point3>> {
        match *self {
            Self::Ball(frame, radius) => {
                let circle = Circle::new(Plane::XY.with_origin(frame.origin), radius).unwrap();
                vec![Box::new(move |x| circle.at(TAU * x))]
            }
            Self::Block(frame, sides) => {
                let mut out: Vec<Box<dyn Fn(f64) -> Point3>> = Vec::new();
                for c in 0..3 {
                    for k in 0..4 {
                        let corner = move |x: f64| {
                            let mut at = [0.0; 3];
                            at[c] = sides[c] * (2.0 * x - 1.0);
                            for (bit, other) in [(1, (c + 1) % 3), (2, (c + 2) % 3)] {
                                at[other] = if k & bit == 0 { -sides[other] } else { sides[other] };
                            }
                            frame.at(at[0], at[1], at[2])
                        };
                        out.push(Box::new(corner));
                    }
                }
                out
            }
            Self::Tube(frame, radius, half) => {
                let mut out: Vec<Box<dyn Fn(f64) -> Point3>> = Vec::new();
                for sign in [-1.0, 1.0] {
                    out.push(Box::new(move |x: f64| {
                        let (sin, cos) = (TAU * x).sin_cos();
                        frame.at(radius * cos, radius * sin, sign * half)
                    }));
                    let angle = frame.y_axis.z.atan2(frame.x_axis.z) + sign * 0.25 * TAU;
                    let (sin, cos) = angle.sin_cos();
                    out.push(Box::new(move |x: f64| {
                        frame.at(radius * cos, radius * sin, half * (2.0 * x - 1.0))
                    }));
                }
                out
            }
        }
    }
}

const SAMPLES: usize = 20_000;

/// The visible length of each solid's curves in the picture from above, and their whole length.
fn sampled(solids: &[Solid]) -> Vec<[f64; 2]> {
    let one = |solid: &Solid| {
        let mut out = [0.0; 2];
        for curve in solid.curves() {
            let flat = |x: f64| {
                let p = curve(x);
                Point3::new(p.x, p.y, 0.0)
            };
            let mut before = flat(0.0);
            for k in 0..SAMPLES {
                let after = flat((k + 1) as f64 / SAMPLES as f64);
                let p = curve((k as f64 + 0.5) / SAMPLES as f64);
                let length = before.distance_to(after);
                before = after;
                out[1] += length;
                if !solids.iter().any(|other| other.covers(p)) {
                    out[0] += length;
                }
            }
        }
        out
    };
    solids.iter().map(one).collect()
}

fn drawn(objects: &[Drawn]) -> Vec<[f64; 2]> {
    let options = DrawingOptions {
        tangent_edges: false,
        tangent_seams: false,
        clipping: Vec::new(),
        tolerance: Tolerance::default(),
    };
    let view = View::parallel(Plane::XY).unwrap();
    let made = drawing(objects, &view, &options, &|| true).unwrap();
    assert!(made.complete);
    let mut out = vec![[0.0; 2]; objects.len()];
    for one in &made.curves {
        let length = one.curve.length();
        out[one.object][1] += length;
        if one.visibility == Visibility::Visible {
            out[one.object][0] += length;
        }
    }
    out
}

fn check(pairs: usize, seed: u64, mut solid: impl FnMut(&mut Dice) -> Solid) {
    let mut dice = Dice(seed);
    for pair in 0..pairs {
        let solids = [solid(&mut dice), solid(&mut dice)];
        let objects: Vec<Drawn> = solids.iter().map(|s| Drawn::Brep(Arc::new(s.brep()))).collect();
        for (k, (got, want)) in drawn(&objects).iter().zip(sampled(&solids)).enumerate() {
            let slack = 1e-3 * want[1];
            assert!((got[0] - want[0]).abs() < slack, "pair {pair}, solid {k}: {got:?} {want:?}");
            assert!((got[1] - want[1]).abs() < slack, "pair {pair}, solid {k}: {got:?} {want:?}");
        }
    }
}

#[test]
fn spheres() {
    check(30, 1, |dice| Solid::Ball(Plane::XY.with_origin(dice.point(1.0)), dice.next(0.8, 2.0)));
}

#[test]
fn spheres_in_any_frame() {
    check(20, 2, |dice| Solid::Ball(dice.frame(1.0), dice.next(0.8, 2.0)));
}

#[test]
fn blocks() {
    check(25, 3, |dice| Solid::Block(dice.frame(0.8), [0.0; 3].map(|_| dice.next(0.5, 1.5))));
}

#[test]
fn tubes() {
    check(15, 4, |dice| Solid::Tube(dice.frame(0.8), dice.next(0.4, 1.0), dice.next(0.8, 2.0)));
}

#[test]
fn all_kinds() {
    let mut kind = 0;
    check(15, 5, |dice| {
        kind += 1;
        match kind % 4 {
            0 => Solid::Ball(dice.frame(0.8), dice.next(0.8, 1.5)),
            1 | 3 => Solid::Block(dice.frame(0.8), [0.0; 3].map(|_| dice.next(0.5, 1.5))),
            _ => Solid::Tube(dice.frame(0.8), dice.next(0.4, 1.0), dice.next(0.8, 2.0)),
        }
    });
}

#[test]
fn a_sphere_is_hidden_no_farther_than_the_other_covers_it() {
    let [a, b] = [(0.7405, -0.4264, 0.2063, 1.7108), (0.4321, 0.8308, 0.7208, 1.8937)]
        .map(|(x, y, z, r)| Solid::Ball(Plane::XY.with_origin(Point3::new(x, y, z)), r));
    let objects = [a, b].map(|s| Drawn::Brep(Arc::new(s.brep())));
    let seen = drawn(&objects)[1][0];
    assert!((seen - 8.066).abs() < 1e-3, "{seen}");
    assert!((seen - sampled(&[a, b])[1][0]).abs() < 2e-3, "{seen}");
}

/// As NURBS and as meshes surfaces have no closed form, and the drawing is the same.
#[test]
fn other_surfaces_of_the_same_shape() {
    let mut dice = Dice(6);
    for _ in 0..6 {
        let solids = [0; 2].map(|_| Solid::Ball(dice.frame(1.0), dice.next(0.8, 1.6)));
        let nurbs = |s: &Solid| -> Drawn {
            let surface: NurbsSurface = s.brep().face_surface(0).unwrap().to_nurbs().unwrap();
            Drawn::Brep(Arc::new(Brep::from_surface(Surface::Nurbs(surface)).unwrap()))
        };
        let objects: Vec<Drawn> = solids.iter().map(nurbs).collect();
        for (got, want) in drawn(&objects).iter().zip(sampled(&solids)) {
            assert!((got[0] - want[0]).abs() < 2e-3 * want[1], "{got:?} {want:?}");
        }
    }
}

#[test]
fn meshes_and_lines_through_each_other() {
    let mut dice = Dice(7);
    for _ in 0..20 {
        let solids = [0; 2].map(|_| Solid::Block(dice.frame(0.8), [0.0; 3].map(|_| dice.next(0.5, 1.5))));
        let mesh = |s: &Solid| {
            let Solid::Block(plane, [a, b, c]) = *s else { unreachable!() };
            let side = |x: f64| Interval::new(-x, x);
            let cuboid = Box3 { plane, x: side(a), y: side(b), z: side(c) };
            Drawn::Mesh(Arc::new(Mesh::cuboid(&cuboid, 3, 3, 3).unwrap()))
        };
        let ends = [dice.point(3.0), dice.point(3.0)];
        let mut objects: Vec<Drawn> = solids.iter().map(mesh).collect();
        objects.push(Drawn::Curve(Line::new(ends[0], ends[1]).into()));
        let got = drawn(&objects);
        for (got, want) in got.iter().zip(sampled(&solids)) {
            assert!((got[0] - want[0]).abs() < 1e-3 * want[1], "{got:?} {want:?}");
        }
        let places = (0..SAMPLES).map(|k| ends[0].lerp(ends[1], (k as f64 + 0.5) / SAMPLES as f64));
        let seen = places.filter(|p| !solids.iter().any(|s| s.covers(*p))).count();
        let flat = |v: Vector3| v.x.hypot(v.y);
        let length = flat(ends[1] - ends[0]);
        assert!((got[2][0] - length * seen as f64 / SAMPLES as f64).abs() < 1e-3 * length, "{got:?}");
    }
}
