//! Every constructor of breps on random and degenerate inputs, from a seed.

#![allow(unreachable_pub, dead_code, reason = "shared by tests that each use a part")]

pub mod random;

use katydid_geometry::construct::{self, LoftOptions, LoftStyle, Miter, PipeCap, SweepFrame, SweepOptions};
use katydid_geometry::{
    Box3, Brep, Cone, Curve, Cylinder, Error, Interval, Line, Plane, Point3, Result, Sphere, Surface,
    Tolerance, Torus, Vector3,
};
use random::{Random, closed, curve, open};

pub const TOLERANCE: Tolerance = Tolerance { absolute: 0.001, angle: std::f64::consts::PI / 180.0 };

/// A constructor by name, with random input for it.
pub type Case = (&'static str, fn(&mut Random) -> Result<Vec<Brep>>);

fn one(brep: Result<Brep>) -> Result<Vec<Brep>> {
    brep.map(|b| vec![b])
}

fn family(random: &mut Random) -> Result<Vec<Curve>> {
    let count = 2 + random.below(4);
    if random.one_in(2) {
        let base = Plane::XY;
        return (0..count)
            .map(|k| {
                let plane = base.offset(random.between(0.5, 2.0) * k as f64);
                closed(random, &plane)
            })
            .collect();
    }
    (0..count).map(|_| if random.one_in(8) { curve(random) } else { open(random) }).collect()
}

pub fn cases() -> Vec<Case> {
    vec![
        ("box", |r| {
            let shape = Box3 { plane: r.plane(9.0), x: r.range(5.0), y: r.range(5.0), z: r.range(5.0) };
            one(construct::box_brep(&shape))
        }),
        ("sphere", |r| one(construct::sphere(&Sphere::new(r.plane(9.0), r.size())?))),
        ("quad sphere", |r| one(construct::quad_sphere(&Sphere::new(r.plane(9.0), r.size())?))),
        ("cylinder", |r| {
            let shape = Cylinder::new(r.plane(9.0), r.size(), r.range(5.0))?;
            one(construct::cylinder(&shape, [r.one_in(2), r.one_in(2)]))
        }),
        ("cone", |r| {
            let shape = Cone::new(r.plane(9.0), r.between(-5.0, 5.0), r.size())?;
            one(construct::cone(&shape, r.one_in(2)))
        }),
        ("torus", |r| one(construct::torus(&Torus::new(r.plane(9.0), r.size(), r.size())?))),
        ("plane surface", |r| one(construct::plane_surface(&r.plane(9.0), r.range(5.0), r.range(5.0)))),
        ("extrude", |r| {
            let profile = curve(r)?;
            let direction = if r.one_in(12) { Vector3::ZERO } else { r.vector(5.0) };
            one(construct::extrude(&profile, direction, r.one_in(2), &TOLERANCE))
        }),
        ("extrude along", |r| {
            let (profile, path) = (curve(r)?, curve(r)?);
            one(construct::extrude_along(&profile, &path, r.one_in(2), &TOLERANCE))
        }),
        ("extrude to point", |r| {
            let profile = curve(r)?;
            let apex = if r.one_in(8) { profile.start() } else { r.point(9.0) };
            one(construct::extrude_to_point(&profile, apex, r.one_in(2), &TOLERANCE))
        }),
        ("extrude brep", |r| {
            let base = base(r)?;
            one(match r.below(3) {
                0 => construct::extrude_brep(&base, r.vector(5.0), &TOLERANCE),
                1 => construct::extrude_brep_along(&base, &open(r)?, &TOLERANCE),
                _ => construct::extrude_brep_to_point(&base, r.point(9.0), &TOLERANCE),
            })
        }),
        ("planar faces", |r| {
            let plane = r.plane(9.0);
            let mut curves = Vec::new();
            for _ in 0..1 + r.below(4) {
                let place = plane.with_origin(plane.at(r.between(-3.0, 3.0), r.between(-3.0, 3.0), 0.0));
                curves.push(closed(r, &place)?);
            }
            if r.one_in(4) {
                curves.push(curve(r)?);
            }
            Ok(Brep::planar_faces(&curves, &TOLERANCE)?.breps)
        }),
        ("ruled", |r| one(construct::ruled(&curve(r)?, &curve(r)?, &TOLERANCE))),
        ("loft", |r| {
            let styles = [
                LoftStyle::Normal,
                LoftStyle::Loose,
                LoftStyle::Tight,
                LoftStyle::Straight,
                LoftStyle::Uniform,
            ];
            let options = LoftOptions {
                style: styles[r.below(5)],
                closed: r.one_in(3),
                adjust: r.one_in(2),
                rebuild: r.one_in(6).then_some(8),
                refit: r.one_in(6).then_some(0.01),
                start: r.one_in(10).then(|| r.point(9.0)),
                end: None,
            };
            one(construct::loft(&family(r)?, &options, &TOLERANCE))
        }),
        ("revolve", |r| {
            let axis = Line::new(r.point(5.0), r.point(5.0));
            let profile = if r.one_in(4) { on_axis(r, &axis)? } else { curve(r)? };
            let turn = if r.one_in(2) { 6.3 } else { r.between(0.1, 6.0) };
            one(construct::revolve(&profile, axis, Interval::new(0.0, turn), &TOLERANCE))
        }),
        ("rail revolve", |r| {
            let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
            let rail = if r.one_in(3) { curve(r)? } else { closed(r, &Plane::XY)? };
            let profile = if r.one_in(2) { on_axis(r, &axis)? } else { curve(r)? };
            one(construct::rail_revolve(&profile, &rail, axis, r.one_in(2), &TOLERANCE))
        }),
        ("edge surface", |r| {
            let (a, b, c, d) = (r.point(4.0), r.point(4.0), r.point(4.0), r.point(4.0));
            let side = |r: &mut Random, p: Point3, q: Point3| -> Result<Curve> {
                let side: Curve = match r.below(4) {
                    0 => katydid_geometry::Arc::through(p, r.point(4.0), q)?.into(),
                    1 => katydid_geometry::NurbsCurve::bezier(&[p, r.point(4.0), r.point(4.0), q])?.into(),
                    2 => katydid_geometry::PolylineCurve::new(vec![p, r.point(4.0), q])?.into(),
                    _ => Line::new(p, q).into(),
                };
                Ok(if r.one_in(2) { side.reversed() } else { side })
            };
            let sides = match r.below(4) {
                0 => vec![side(r, a, b)?, side(r, d, c)?],
                1 => vec![side(r, a, b)?, side(r, b, c)?, side(r, c, a)?],
                2 => vec![side(r, a, b)?, side(r, c, d)?, side(r, b, c)?, side(r, d, a)?],
                _ => vec![side(r, a, b)?, side(r, b, c)?, side(r, c, d)?, side(r, d, a)?],
            };
            one(construct::edge_surface(&sides, &TOLERANCE))
        }),
        ("four point surface", |r| {
            let d = r.one_in(2).then(|| r.point(3.0));
            one(construct::four_point_surface(r.point(3.0), r.point(3.0), r.point(3.0), d))
        }),
        ("sweep one", |r| {
            let rail = rail(r)?;
            let mut sections = Vec::new();
            for _ in 0..1 + r.below(3) {
                let t = rail.domain().at(r.between(0.0, 1.0));
                let frame = rail.perpendicular_frame_at(t).unwrap_or(Plane::XY);
                let small = if r.one_in(2) { closed(r, &frame)? } else { open(r)? };
                let scaled = small.transformed(&katydid_geometry::Xform::scale(frame.origin, 0.1))?;
                sections.push(scaled);
            }
            let frame = if r.one_in(3) { SweepFrame::Roadlike(Vector3::Z) } else { SweepFrame::Freeform };
            let miter = [Miter::None, Miter::Trim, Miter::Rotate][r.below(3)];
            construct::sweep_one(&rail, &sections, &SweepOptions { frame, miter }, &TOLERANCE)
        }),
        ("sweep two", |r| {
            let first = rail(r)?;
            let second = match r.below(3) {
                0 => rail(r)?,
                _ => first.transformed(&katydid_geometry::Xform::translation(r.vector(2.0)))?,
            };
            let mut sections = Vec::new();
            for _ in 0..1 + r.below(3) {
                let x = if r.one_in(4) { 0.0 } else { r.between(0.0, 1.0) };
                let (p, q) = (first.point_at(first.domain().at(x)), second.point_at(second.domain().at(x)));
                let section: Curve = match r.below(3) {
                    0 => katydid_geometry::Arc::through(p, p.lerp(q, 0.5) + r.vector(1.0), q)?.into(),
                    1 => katydid_geometry::NurbsCurve::bezier(&[p, r.point(4.0), q])?.into(),
                    _ => Line::new(p, q).into(),
                };
                sections.push(if r.one_in(3) { section.reversed() } else { section });
            }
            construct::sweep_two([&first, &second], &sections, r.one_in(2), &TOLERANCE)
        }),
        ("pipe", |r| {
            let rail = rail(r)?;
            let cap = [PipeCap::None, PipeCap::Flat, PipeCap::Round][r.below(3)];
            let radius = if r.one_in(12) { r.size() } else { r.between(0.01, 0.4) };
            if r.one_in(3) {
                let radii: Vec<(f64, f64)> = (0..1 + r.below(4))
                    .map(|_| (rail.domain().at(r.between(0.0, 1.0)), r.between(0.05, 0.4)))
                    .collect();
                return one(construct::pipe_variable(&rail, &radii, cap, &TOLERANCE));
            }
            one(construct::pipe(&rail, radius, cap, &TOLERANCE))
        }),
        ("trimmed surface", |r| {
            let surface = surface(r)?;
            let mut loops = Vec::new();
            for _ in 0..1 + r.below(3) {
                loops.push(parameter_loop(r, &surface)?);
            }
            Brep::from_parameter_loops(&surface, &loops, &TOLERANCE)
        }),
        ("pulled holes", |r| {
            let surface = surface(r)?;
            let whole = Brep::from_surface(surface.clone())?;
            let mut curves = Vec::new();
            for _ in 0..1 + r.below(2) {
                let [u, v] =
                    katydid_geometry::Direction::BOTH.map(|d| surface.domain(d).at(r.between(0.1, 0.9)));
                let Some(frame) = surface.frame_at(u, v) else { continue };
                let small = closed(r, &frame)?;
                let small = small.transformed(&katydid_geometry::Xform::scale(frame.origin, 0.2))?;
                curves.extend(surface.pull_curve(&small, &TOLERANCE)?);
            }
            let curves: Vec<Curve> = curves.into_iter().filter(Curve::is_closed).collect();
            if r.one_in(2) {
                whole.face_with_holes(0, &curves, &TOLERANCE)
            } else {
                whole.face_inside(0, &curves, &TOLERANCE)
            }
        }),
        ("split face", |r| {
            let surface = surface(r)?;
            let loops = [parameter_loop(r, &surface)?];
            let trimmed = Brep::from_parameter_loops(&surface, &loops, &TOLERANCE)?;
            let whole = trimmed.into_iter().next().ok_or(Error::Unsupported("an empty region"))?;
            let [u, v] = katydid_geometry::Direction::BOTH.map(|d| surface.domain(d).at(r.between(0.1, 0.9)));
            let mut out = whole.face_split_at(0, [&[u], &[v]], &TOLERANCE)?;
            out.push(whole.shrunk_face(0, &TOLERANCE)?);
            out.push(whole.untrimmed_face(0)?);
            out.push(surface.isotrimmed(
                Interval::new(u, surface.domain(katydid_geometry::Direction::U).end),
                Interval::new(v, v + 1.0),
            )?);
            Ok(out)
        }),
        ("copy trims", |r| {
            let source = surface(r)?;
            let loops = [parameter_loop(r, &source)?];
            let trimmed = Brep::from_parameter_loops(&source, &loops, &TOLERANCE)?;
            let whole = trimmed.into_iter().next().ok_or(Error::Unsupported("an empty region"))?;
            let target = surface(r)?;
            if r.one_in(3) {
                whole.retrimmed(0, &target, &TOLERANCE)
            } else {
                whole.copied_trims(0, &target, &TOLERANCE)
            }
        }),
        ("cap", |r| {
            let plane = r.plane(9.0);
            let tube = construct::extrude(&closed(r, &plane)?, r.vector(5.0), false, &TOLERANCE)?;
            Ok(vec![tube.capped(&TOLERANCE)?.0])
        }),
        ("join", |r| {
            let solid = base(r)?;
            let solid = construct::extrude_brep(&solid, r.vector(4.0), &TOLERANCE)?;
            let mut faces = solid.exploded()?;
            if r.one_in(2) {
                faces.pop();
            }
            for face in &mut faces {
                if r.one_in(3) {
                    *face = face.clone().flipped();
                }
            }
            Ok(Brep::join(&faces, &TOLERANCE)?.breps)
        }),
    ]
}

/// A surface of any kind, of a size that curves fit on.
fn surface(random: &mut Random) -> Result<Surface> {
    let plane = random.plane(5.0);
    Ok(match random.below(7) {
        0 => katydid_geometry::PlaneSurface::new(plane, Interval::new(-3.0, 3.0), Interval::new(-2.0, 4.0))?
            .into(),
        1 => Sphere::new(plane, random.between(2.0, 5.0))?.into(),
        2 => Cylinder::new(plane, random.between(1.0, 3.0), Interval::new(0.0, 6.0))?.into(),
        3 => Torus::new(plane, 5.0, random.between(1.0, 3.0))?.into(),
        4 => Cone::new(plane, 4.0, 3.0)?.into(),
        5 => katydid_geometry::SumSurface::new(open(random)?, open(random)?, Vector3::ZERO)?.into(),
        _ => {
            let points: Vec<Point3> = (0..25)
                .map(|k| {
                    Point3::new(2.0 * f64::from(k / 5), 2.0 * f64::from(k % 5), random.between(-1.0, 1.0))
                })
                .collect();
            katydid_geometry::NurbsSurface::clamped_uniform([3, 3], [5, 5], &points)?.into()
        }
    })
}

/// A closed curve in the parameter plane of a surface, now and then over its sides.
fn parameter_loop(random: &mut Random, surface: &Surface) -> Result<Curve> {
    let [u, v] = katydid_geometry::Direction::BOTH.map(|d| surface.domain(d));
    let shape = closed(random, &Plane::XY)?;
    let (x, y) = (random.between(0.05, 0.95), random.between(0.05, 0.95));
    let size = random.between(0.02, 0.12);
    let map = katydid_geometry::Xform::from_columns(
        Vector3::X * (size * u.length()),
        Vector3::Y * (size * v.length()),
        Vector3::Z,
        Point3::new(u.at(x), v.at(y), 0.0),
    );
    shape.transformed(&map)
}

/// A rail as designers draw them, now and then a wild one.
fn rail(random: &mut Random) -> Result<Curve> {
    if random.one_in(5) {
        return curve(random);
    }
    let plane = random.plane(5.0);
    Ok(match random.below(5) {
        0 => closed(random, &plane)?,
        1 => {
            let points = (0..3 + random.below(3))
                .map(|k| Point3::new(2.0 * k as f64, random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
            katydid_geometry::PolylineCurve::new(points.collect())?.into()
        }
        2 => {
            let points: Vec<Point3> = (0..3 + random.below(4))
                .map(|k| Point3::new(2.0 * k as f64, random.between(-1.0, 1.0), random.between(-1.0, 1.0)))
                .collect();
            katydid_geometry::NurbsCurve::interpolate(
                3,
                &points,
                katydid_geometry::KnotSpacing::Chord,
                None,
                None,
            )?
            .into()
        }
        3 => Line::new(random.point(5.0), random.point(5.0)).into(),
        _ => katydid_geometry::Arc::through(random.point(5.0), random.point(5.0), random.point(5.0))?.into(),
    })
}

/// A curve from one place of an axis to another.
fn on_axis(random: &mut Random, axis: &Line) -> Result<Curve> {
    let (a, b) = (axis.at(random.between(-1.0, 1.0)), axis.at(random.between(-1.0, 2.0)));
    let via = random.point(5.0);
    if random.one_in(3) {
        return Ok(katydid_geometry::Arc::through(a, via, b)?.into());
    }
    Ok(katydid_geometry::PolylineCurve::new(vec![a, via, b])?.into())
}

/// An open brep.
fn base(random: &mut Random) -> Result<Brep> {
    let plane = random.plane(5.0);
    match random.below(3) {
        0 => {
            let outer = closed(random, &plane)?;
            let inner = outer.transformed(&katydid_geometry::Xform::scale(plane.origin, 0.5))?;
            let found = Brep::planar_faces(&[outer, inner], &TOLERANCE)?;
            found.breps.into_iter().next().ok_or(Error::Unsupported("a region without area"))
        }
        1 => construct::extrude(&open(random)?, random.vector(4.0), false, &TOLERANCE),
        _ => construct::extrude(&closed(random, &plane)?, random.vector(4.0), false, &TOLERANCE),
    }
}
