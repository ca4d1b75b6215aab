//! Sound breps, and ways to break one rule of validity at a time: by name, and at random.

#![allow(unreachable_pub, dead_code, clippy::unwrap_used, reason = "shared by tests that each use a part")]

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use katydid_geometry::brep::{Brep, Iso, LoopKind, Parts, TrimKind};
use katydid_geometry::construct;
use katydid_geometry::{
    Arc, ArcCurve, Box3, Circle, Curve, Cylinder, Interval, Line, LineCurve, Plane, Point3, PolyCurve, Side,
    Sphere, Tolerance, Vector3,
};

/// One thing that is done to a brep's parts.
pub type Change = fn(&mut Parts);

/// A way to break a box, the kind of part that must be named for it, and words that must stand in the reason.
pub struct Way {
    pub part: &'static str,
    pub why: &'static str,
    pub change: Change,
}

const fn way(part: &'static str, why: &'static str, change: Change) -> Way {
    Way { part, why, change }
}

/// A box of 3 by 4 by 5.
pub fn cuboid() -> Brep {
    let side = |length: f64| Interval::new(0.0, length);
    construct::box_brep(&Box3 { plane: Plane::XY, x: side(3.0), y: side(4.0), z: side(5.0) }).unwrap()
}

/// A box, a ball with a seam and poles, a cylinder with caps, and a disc with a hole.
pub fn shapes() -> Vec<(&'static str, Brep)> {
    let tolerance = Tolerance::default();
    let rings = [3.0, 1.0].map(|radius| Circle::new(Plane::XY, radius).unwrap().into());
    let disc = Brep::planar_faces(&rings, &tolerance).unwrap().breps.remove(0);
    let tube = Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 4.0)).unwrap();
    vec![
        ("box", cuboid()),
        ("ball", construct::sphere(&Sphere::new(Plane::XY, 2.0).unwrap()).unwrap()),
        ("cylinder", construct::cylinder(&tube, [true; 2]).unwrap()),
        ("disc", disc),
    ]
}

fn segment(from: Point3, to: Point3) -> Option<katydid_geometry::Curve> {
    Some(LineCurve { line: Line::new(from, to), domain: Interval::UNIT }.into())
}

fn trim_curve(parts: &mut Parts, trim: usize, to: impl Fn(Point3) -> Point3) {
    let place = parts.trims[trim].part.curve.unwrap();
    let domain = parts.trims[trim].part.domain;
    let curve = parts.curves_2d[place].as_ref().unwrap();
    let (a, b) = (to(curve.start()), to(curve.end()));
    parts.curves_2d[place] = Some(LineCurve { line: Line::new(a, b), domain }.into());
}

/// Every rule of validity, broken in a box.
pub fn ways() -> Vec<Way> {
    let unset = Interval::new(1.0, 1.0);
    assert!(!unset.is_increasing());
    vec![
        way("brep", "no edges", |p| p.edges.clear()),
        way("brep", "no loops", |p| p.loops.clear()),
        way("brep", "no surfaces", |p| p.surfaces.clear()),
        way("brep", "no trims", |p| p.trims.clear()),
        way("brep", "no parameter curves", |p| p.curves_2d.clear()),
        way("brep", "no space curves", |p| p.curves_3d.clear()),
        way("brep", "no vertices", |p| p.vertices.clear()),
        way("parameter curve", "leaves the parameter plane", |p| {
            trim_curve(p, 0, |q| q + Vector3::Z);
        }),
        way("vertex", "tolerance", |p| p.vertices[2].tolerance = -1.0),
        way("vertex", "names edges", |p| p.vertices[1].deleted = true),
        way("vertex", "is deleted", |p| p.edges[0].deleted = true),
        way("vertex", "named 2 times", |p| {
            let edge = p.vertices[0].edges[0];
            p.vertices[0].edges.push(edge);
        }),
        way("vertex", "does not end here", |p| {
            let other = (0..p.edges.len()).find(|e| !p.vertices[0].edges.contains(e)).unwrap();
            p.vertices[0].edges.push(other);
        }),
        way("edge", "tolerance is not set", |p| p.edges[2].tolerance = -1.0),
        way("edge", "has no curve", |p| p.curves_3d[4] = None),
        way("edge", "has no curve", |p| p.edges[4].part.curve = None),
        way("edge", "does not increase", |p| p.edges[1].part.domain = Interval::new(1.0, 1.0)),
        way("edge", "does not increase", |p| p.edges[1].part.range = Interval::new(1.0, 0.0)),
        way("edge", "beyond its curve", |p| p.edges[1].part.range = Interval::new(0.0, 100.0)),
        way("edge", "open, but has one vertex", |p| p.edges[3].vertices[0] = p.edges[3].vertices[1]),
        way("edge", "no vertex at its start", |p| p.edges[3].vertices[0] = None),
        way("edge", "does not name it", |p| p.vertices[0].edges.clear()),
        way("edge", "is deleted", |p| p.trims[0].deleted = true),
        way("edge", "more than once", |p| {
            let trim = p.edges[0].trims[0];
            p.edges[0].trims.push(trim);
        }),
        way("edge", "does not run along it", |p| {
            let other = p.edges[1].trims[0];
            p.edges[0].trims.push(other);
        }),
        way("edge", "names other parts", |p| p.edges[5].deleted = true),
        way("trim", "has no curve", |p| p.curves_2d[3] = None),
        way("trim", "tolerances are not set", |p| p.trims[3].tolerance[1] = -1.0),
        way("trim", "does not increase", |p| p.trims[3].part.domain = Interval::new(1.0, 1.0)),
        way("trim", "beyond its curve", |p| p.trims[3].part.range = Interval::new(-50.0, 100.0)),
        way("trim", "direction is stated", |p| p.trims[5].iso = Iso::InnerU),
        way("trim", "in no loop", |p| p.trims[5].in_loop = None),
        way("trim", "no vertex at an end", |p| p.trims[5].vertices[0] = None),
        way("trim", "vertices are not those", |p| p.trims[0].reversed = !p.trims[0].reversed),
        way("trim", "away from that of its edge", |p| {
            let place = p.edges[0].part.curve.unwrap();
            let moved = p.curves_3d[place]
                .as_ref()
                .map(|c| Line::new(c.start() + Vector3::Z * 0.5, c.end() + Vector3::Z * 0.5).into());
            p.curves_3d[place] = moved;
            p.edges[0].part.range = p.curves_3d[place].as_ref().unwrap().domain();
            p.edges[0].part.domain = p.edges[0].part.range;
        }),
        way("trim", "its edge does not name it", |p| {
            p.edges[0].trims.truncate(1);
        }),
        way("trim", "mated, but its edge has no other", |p| p.edges[0].trims.truncate(1)),
        way("trim", "boundary, but its edge has other", |p| p.trims[0].kind = TrimKind::Boundary),
        way("trim", "kind is not known", |p| p.trims[0].kind = TrimKind::Unknown),
        way("trim", "singular, but has an edge", |p| p.trims[0].kind = TrimKind::Singular),
        way("trim", "no edge, and is not singular", |p| p.trims[0].edge = None),
        way("trim", "is a seam, and its edge has", |p| p.trims[0].kind = TrimKind::Seam),
        way("loop", "do not share a vertex", |p| p.loops[0].trims.swap(0, 1)),
        way("loop", "begins at", |p| trim_curve(p, 0, |q| q + Vector3::X * 0.1)),
        way("loop", "has no trims", |p| p.loops[1].trims.clear()),
        way("loop", "is not in it", |p| p.loops[1].trims[0] = 0),
        way("loop", "more than once", |p| {
            let first = p.loops[1].trims[0];
            p.loops[1].trims.push(first);
        }),
        way("loop", "kind is not known", |p| p.loops[1].kind = LoopKind::Unknown),
        way("loop", "bounds no face", |p| p.loops[1].face = None),
        way("loop", "slit", |p| p.loops[1].kind = LoopKind::Slit),
        way("loop", "names other parts", |p| p.loops[1].deleted = true),
        way("face", "first loop is not outer", |p| p.loops[3].kind = LoopKind::Inner),
        way("face", "later loop is not a hole", |p| p.faces[0].loops.push(1)),
        way("face", "bounds another", |p| p.faces[0].loops.push(1)),
        way("face", "more than once", |p| {
            let own = p.faces[0].loops[0];
            p.faces[0].loops.push(own);
        }),
        way("face", "has no loops", |p| p.faces[2].loops.clear()),
        way("face", "no surface", |p| p.surfaces[2] = None),
        way("face", "no surface", |p| p.faces[2].surface = None),
        way("face", "names other parts", |p| p.faces[2].deleted = true),
    ]
}

/// Shows `see` every shape broken in every way that it has a place for.
pub fn each_way(see: impl Fn(&Brep)) {
    let mut shown = Shown::default();
    for (k, way) in ways().into_iter().enumerate() {
        for (name, brep) in shapes() {
            let mut parts = brep.into_parts();
            let changed = catch_unwind(AssertUnwindSafe(|| (way.change)(&mut parts)));
            let Ok(brep) = Brep::from_parts(parts) else { continue };
            if changed.is_ok() {
                shown.show(&format!("{name} with way {k} ({}: {})", way.part, way.why), &brep, &see);
            }
        }
    }
}

/// Shows `see` every shape broken at random, `usual` times each, or as often as `KATYDID_CASES` says.
pub fn each_at_random(usual: u64, see: impl Fn(&Brep)) {
    let cases = std::env::var("KATYDID_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(usual);
    let mut shown = Shown::default();
    for (name, brep) in shapes() {
        for seed in 0..cases {
            let mut parts = brep.clone().into_parts();
            break_at_random(&mut parts, &mut Dice(seed));
            if let Ok(brep) = Brep::from_parts(parts) {
                shown.show(&format!("{name} broken by seed {seed}"), &brep, &see);
            }
        }
    }
}

/// What took longest of all that was shown: told at the end, for whoever looks.
#[derive(Default)]
struct Shown {
    longest: Duration,
    of: String,
}

impl Shown {
    fn show(&mut self, name: &str, brep: &Brep, see: &impl Fn(&Brep)) {
        let begun = Instant::now();
        let seen = catch_unwind(AssertUnwindSafe(|| see(brep)));
        assert!(seen.is_ok(), "{name} makes something panic");
        if begun.elapsed() > self.longest {
            self.longest = begun.elapsed();
            name.clone_into(&mut self.of);
        }
    }
}

impl Drop for Shown {
    fn drop(&mut self) {
        println!("the slowest took {:?}: {}", self.longest, self.of);
    }
}

/// Parts that name places that are not there, or numbers that are none: these are no breps at all.
pub fn impossible() -> Vec<(&'static str, Change)> {
    vec![
        ("vertex to edge", |p| p.vertices[0].edges.push(12)),
        ("edge to vertex", |p| p.edges[0].vertices[1] = Some(8)),
        ("edge to curve", |p| p.edges[0].part.curve = Some(usize::MAX)),
        ("edge to trim", |p| p.edges[0].trims.push(24)),
        ("trim to curve", |p| p.trims[0].part.curve = Some(24)),
        ("trim to edge", |p| p.trims[0].edge = Some(12)),
        ("trim to loop", |p| p.trims[0].in_loop = Some(6)),
        ("trim to vertex", |p| p.trims[0].vertices[0] = Some(8)),
        ("loop to trim", |p| p.loops[0].trims.push(24)),
        ("loop to face", |p| p.loops[0].face = Some(6)),
        ("face to loop", |p| p.faces[0].loops.push(6)),
        ("face to surface", |p| p.faces[0].surface = Some(6)),
        ("point of a vertex", |p| p.vertices[0].point = Point3::new(f64::NAN, 0.0, 0.0)),
        ("tolerance of a vertex", |p| p.vertices[0].tolerance = f64::NAN),
        ("domain of an edge", |p| p.edges[0].part.domain = Interval::new(0.0, f64::INFINITY)),
        ("range of a trim", |p| p.trims[0].part.range = Interval::new(f64::NAN, 1.0)),
        ("tolerance of a trim", |p| p.trims[0].tolerance[0] = f64::INFINITY),
        ("end of a space curve", |p| p.curves_3d[3] = wild_segment(f64::NAN, 1.0)),
        ("domain of a space curve", |p| p.curves_3d[3] = wild_segment(0.0, f64::INFINITY)),
        ("end of a parameter curve", |p| p.curves_2d[7] = wild_segment(f64::NEG_INFINITY, 1.0)),
        ("radius of a space curve", |p| p.curves_3d[0] = Some(wild_arc())),
        ("segment of a poly-curve", |p| {
            p.curves_3d[0] = PolyCurve::new(vec![wild_arc()]).map(Curve::from).ok();
        }),
    ]
}

/// A segment that holds two numbers as they come.
fn wild_segment(x: f64, end: f64) -> Option<Curve> {
    let line = Line::new(Point3::ORIGIN, Point3::new(x, 1.0, 0.0));
    Some(LineCurve { line, domain: Interval { start: 0.0, end } }.into())
}

/// An arc whose radius is no number.
fn wild_arc() -> Curve {
    let circle = Circle { plane: Plane::XY, radius: f64::NAN };
    ArcCurve { arc: Arc { circle, angle: Interval::UNIT }, domain: Interval::UNIT }.into()
}

/// Numbers from a seed: splitmix64 (S. Vigna).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % n.max(1) as u64) as usize
    }

    /// A place in a list, or none.
    fn place(&mut self, length: usize) -> Option<usize> {
        if length == 0 || self.below(6) == 0 { None } else { Some(self.below(length)) }
    }

    fn number(&mut self) -> f64 {
        [0.0, 1.0, -1.0, 0.5, 1e-12, 1e12, -3.7, 1e300, f64::MIN_POSITIVE][self.below(9)]
    }
}

fn any<'a, T>(dice: &mut Dice, list: &'a mut [T]) -> Option<&'a mut T> {
    let place = dice.below(list.len());
    list.get_mut(place)
}

/// Changes a few things at random; what is named exists.
fn break_at_random(parts: &mut Parts, dice: &mut Dice) {
    for _ in 0..1 + dice.below(3) {
        change_one(parts, dice);
    }
}

fn change_one(parts: &mut Parts, dice: &mut Dice) -> Option<()> {
    let (vertices, edges, trims) = (parts.vertices.len(), parts.edges.len(), parts.trims.len());
    let (loops, faces, surfaces) = (parts.loops.len(), parts.faces.len(), parts.surfaces.len());
    let (flat, space) = (parts.curves_2d.len(), parts.curves_3d.len());
    match dice.below(26) {
        0 => any(dice, &mut parts.vertices)?.point = Point3::new(dice.number(), dice.number(), dice.number()),
        1 => any(dice, &mut parts.vertices)?.edges.clear(),
        2 => any(dice, &mut parts.edges)?.vertices[dice.below(2)] = dice.place(vertices),
        3 => any(dice, &mut parts.edges)?.part.curve = dice.place(space),
        4 => any(dice, &mut parts.edges)?.part.range = Interval::new(dice.number(), dice.number()),
        5 => any(dice, &mut parts.edges)?.part.domain = Interval::new(dice.number(), dice.number()),
        6 => any(dice, &mut parts.edges)?.trims.extend(dice.place(trims)),
        7 => any(dice, &mut parts.edges)?.trims.clear(),
        8 => any(dice, &mut parts.trims)?.part.curve = dice.place(flat),
        9 => any(dice, &mut parts.trims)?.part.range = Interval::new(dice.number(), dice.number()),
        10 => any(dice, &mut parts.trims)?.part.domain = Interval::new(dice.number(), dice.number()),
        11 => any(dice, &mut parts.trims)?.edge = dice.place(edges),
        12 => any(dice, &mut parts.trims)?.vertices[dice.below(2)] = dice.place(vertices),
        13 => any(dice, &mut parts.trims)?.in_loop = dice.place(loops),
        14 => any(dice, &mut parts.trims)?.reversed ^= true,
        15 => {
            any(dice, &mut parts.trims)?.iso = [Iso::None, Iso::InnerU, Iso::Side(Side::East)][dice.below(3)]
        }
        16 => {
            let kinds = [TrimKind::Singular, TrimKind::Seam, TrimKind::Boundary, TrimKind::Unknown];
            any(dice, &mut parts.trims)?.kind = kinds[dice.below(4)];
        }
        17 => any(dice, &mut parts.loops)?.trims.extend(dice.place(trims)),
        18 => {
            let list = &mut any(dice, &mut parts.loops)?.trims;
            let at = dice.below(list.len());
            if at < list.len() {
                list.remove(at);
            }
        }
        19 => any(dice, &mut parts.loops)?.face = dice.place(faces),
        20 => {
            any(dice, &mut parts.loops)?.kind =
                [LoopKind::Inner, LoopKind::Unknown, LoopKind::Slit][dice.below(3)]
        }
        21 => any(dice, &mut parts.faces)?.surface = dice.place(surfaces),
        22 => any(dice, &mut parts.faces)?.loops.extend(dice.place(loops)),
        23 => *any(dice, &mut parts.surfaces)? = None,
        24 => {
            let curve = any(dice, &mut parts.curves_2d)?;
            let at = |dice: &mut Dice| Point3::new(dice.number(), dice.number(), 0.0);
            *curve = segment(at(dice), at(dice)).filter(|_| dice.below(3) > 0);
        }
        _ => match dice.below(5) {
            0 => any(dice, &mut parts.vertices)?.deleted = true,
            1 => any(dice, &mut parts.edges)?.deleted = true,
            2 => any(dice, &mut parts.trims)?.deleted = true,
            3 => any(dice, &mut parts.loops)?.deleted = true,
            _ => any(dice, &mut parts.faces)?.deleted = true,
        },
    }
    Some(())
}
