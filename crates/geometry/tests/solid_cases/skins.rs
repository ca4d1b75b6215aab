//! Surfaces through curves, along rails, near points and beside other surfaces.

use katydid_geometry::construct::{
    self, LoftOptions, LoftStyle, Miter, PatchOptions, PipeCap, SweepFrame, SweepOptions,
};
use katydid_geometry::{
    Arc, Box3, Brep, Curve, Direction, Error, Line, NurbsCurve, Plane, Point3, PolylineCurve, Result,
    Vector3, Xform,
};

use super::inputs::{base, family, parameter_loop, rail, surface};
use super::random::{Random, closed, curve, open};
use super::{Case, TOLERANCE, one};

pub fn cases() -> Vec<Case> {
    vec![
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
        ("developable loft", |r| {
            let options = LoftOptions {
                style: LoftStyle::Developable,
                closed: r.one_in(6),
                adjust: r.one_in(2),
                start: r.one_in(10).then(|| r.point(9.0)),
                ..LoftOptions::default()
            };
            let sections = if r.one_in(2) { family(r)? } else { vec![curve(r)?, curve(r)?] };
            one(construct::loft(&sections, &options, &TOLERANCE))
        }),
        ("edge surface", |r| {
            let (a, b, c, d) = (r.point(4.0), r.point(4.0), r.point(4.0), r.point(4.0));
            let side = |r: &mut Random, p: Point3, q: Point3| -> Result<Curve> {
                let side: Curve = match r.below(4) {
                    0 => Arc::through(p, r.point(4.0), q)?.into(),
                    1 => NurbsCurve::bezier(&[p, r.point(4.0), r.point(4.0), q])?.into(),
                    2 => PolylineCurve::new(vec![p, r.point(4.0), q])?.into(),
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
                let scaled = small.transformed(&Xform::scale(frame.origin, 0.1))?;
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
                _ => first.transformed(&Xform::translation(r.vector(2.0)))?,
            };
            let mut sections = Vec::new();
            for _ in 0..1 + r.below(3) {
                let x = if r.one_in(4) { 0.0 } else { r.between(0.0, 1.0) };
                let (p, q) = (first.point_at(first.domain().at(x)), second.point_at(second.domain().at(x)));
                let section: Curve = match r.below(3) {
                    0 => Arc::through(p, p.lerp(q, 0.5) + r.vector(1.0), q)?.into(),
                    1 => NurbsCurve::bezier(&[p, r.point(4.0), q])?.into(),
                    _ => Line::new(p, q).into(),
                };
                sections.push(if r.one_in(3) { section.reversed() } else { section });
            }
            construct::sweep_two([&first, &second], &sections, r.one_in(2), &TOLERANCE)
        }),
        ("pipe", |r| {
            let rail = rail(r)?;
            let cap = [PipeCap::None, PipeCap::Flat, PipeCap::Round][r.below(3)];
            let radius = if r.one_in(12) { r.size() } else { r.between(0.01, 0.4) * r.scale };
            one(construct::pipe(&rail, radius, cap, &TOLERANCE))
        }),
        ("loft to points", |r| {
            let options = LoftOptions {
                style: [LoftStyle::Normal, LoftStyle::Loose, LoftStyle::Straight][r.below(3)],
                start: (!r.one_in(3)).then(|| r.point(9.0)),
                end: (!r.one_in(3)).then(|| r.point(9.0)),
                ..LoftOptions::default()
            };
            let sections = family(r)?;
            let count = 1 + r.below(sections.len());
            one(construct::loft(&sections[..count], &options, &TOLERANCE))
        }),
        ("loft of coincident sections", |r| {
            let mut sections = family(r)?;
            let again = sections[r.below(sections.len())].clone();
            sections.insert(r.below(sections.len()), if r.one_in(2) { again.reversed() } else { again });
            let style =
                [LoftStyle::Normal, LoftStyle::Loose, LoftStyle::Tight, LoftStyle::Straight][r.below(4)];
            let options =
                LoftOptions { style, closed: r.one_in(3), adjust: r.one_in(2), ..LoftOptions::default() };
            one(construct::loft(&sections, &options, &TOLERANCE))
        }),
        ("variable pipe", |r| {
            let rail = rail(r)?;
            let cap = [PipeCap::None, PipeCap::Flat, PipeCap::Round][r.below(3)];
            let scale = r.scale;
            let mut radii: Vec<(f64, f64)> = (0..1 + r.below(5))
                .map(|_| {
                    let radius = if r.one_in(20) { r.size() } else { r.between(0.05, 0.5) * scale };
                    (rail.domain().at(r.between(0.0, 1.0)), radius)
                })
                .collect();
            if r.one_in(10) {
                radii.push((rail.domain().start, 0.2 * scale));
                radii.push((rail.domain().start, 0.3 * scale));
            }
            one(construct::pipe_variable(&rail, &radii, cap, &TOLERANCE))
        }),
        ("network surface", |r| {
            let surface = surface(r)?;
            let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
            let mut sets = [Vec::new(), Vec::new()];
            for (k, d) in Direction::BOTH.into_iter().enumerate() {
                let across = [v, u][k];
                let count = 2 + r.below(3);
                for n in 0..count {
                    let at = (n as f64 + r.between(0.0, 0.3)) / count as f64;
                    let mut curve = surface.isocurve(d, across.at(at.min(1.0)))?;
                    match r.below(12) {
                        0 => curve = curve.reversed(),
                        1 => curve = curve.transformed(&Xform::translation(r.vector(0.001)))?,
                        2 => curve = super::random::degenerate(r)?,
                        _ => {}
                    }
                    sets[k].push(curve);
                }
            }
            let [first, second] = &sets;
            one(construct::network_surface(first, second, &TOLERANCE))
        }),
        ("patch", |r| {
            let mut curves = Vec::new();
            for _ in 0..r.below(4) {
                curves.push(if r.one_in(2) { closed(r, &Plane::XY)? } else { curve(r)? });
            }
            let points: Vec<Point3> = (0..r.below(8)).map(|_| r.point(4.0)).collect();
            let options = PatchOptions {
                spans: [r.below(9), 1 + r.below(8)],
                flexibility: [1.0, 0.1, 10.0, 1e-6, 0.0][r.below(5)],
                trimmed: r.one_in(2),
            };
            one(construct::patch(&curves, &points, &options, &TOLERANCE))
        }),
        ("fragment patch", |r| {
            let mut corners: Vec<Point3> = (0..2 + r.below(9)).map(|_| r.point(5.0)).collect();
            match r.below(6) {
                0 => corners.iter_mut().for_each(|p| p.z = 0.0),
                1 => corners.iter_mut().for_each(|p| *p = Point3::new(p.x, 0.0, 0.0)),
                2 => corners.push(corners[0]),
                3 => corners.insert(1, corners[0]),
                _ => {}
            }
            one(construct::fragment_patch(&corners, &TOLERANCE))
        }),
        ("offset surface", |r| {
            let surface = surface(r)?;
            let distance = [0.0, 0.1, -0.1, 0.5, -0.5, 1.5, -1.5, 4.0][r.below(8)] * r.scale;
            if r.one_in(4) {
                return one(Brep::from_surface(
                    construct::offset_surface_loosely(&surface, distance)?.into(),
                ));
            }
            one(Brep::from_surface(construct::offset_surface(&surface, distance, &TOLERANCE)?))
        }),
        ("offset brep", |r| {
            let shape = match r.below(3) {
                0 => base(r)?,
                1 => {
                    let surface = surface(r)?;
                    let loops = [parameter_loop(r, &surface)?];
                    let trimmed = Brep::from_parameter_loops(&surface, &loops, &TOLERANCE)?;
                    trimmed.into_iter().next().ok_or(Error::Unsupported("an empty region"))?
                }
                _ => construct::box_brep(&Box3 {
                    plane: r.plane(4.0),
                    x: r.range(3.0),
                    y: r.range(3.0),
                    z: r.range(3.0),
                })?,
            };
            let distance = r.between(-0.5, 0.5) * r.scale;
            construct::offset_brep(&shape, distance, r.one_in(2), &TOLERANCE)
        }),
    ]
}
