//! Faces between curves, trims, and breps joined, closed and merged.

use katydid_geometry::brep::{FilletBlend, FilletRail};
use katydid_geometry::construct;
use katydid_geometry::{
    Brep, Curve, Direction, Error, Interval, Point3, PolylineCurve, Result, Vector3, Xform,
};

use super::inputs::{base, parameter_loop, solid, surface};
use super::random::{closed, curve};
use super::{Case, TOLERANCE, one};

pub fn cases() -> Vec<Case> {
    vec![
        ("planar faces", |r| {
            let plane = r.plane(9.0);
            let mut curves = Vec::new();
            for _ in 0..1 + r.below(4) {
                let (x, y) = (r.between(-3.0, 3.0) * r.scale, r.between(-3.0, 3.0) * r.scale);
                let place = plane.with_origin(plane.at(x, y, 0.0));
                curves.push(closed(r, &place)?);
            }
            if r.one_in(4) {
                curves.push(curve(r)?);
            }
            Ok(Brep::planar_faces(&curves, &TOLERANCE)?.breps)
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
                let [u, v] = Direction::BOTH.map(|d| surface.domain(d).at(r.between(0.1, 0.9)));
                let Some(frame) = surface.frame_at(u, v) else { continue };
                let small = closed(r, &frame)?;
                let small = small.transformed(&Xform::scale(frame.origin, 0.2))?;
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
            let [u, v] = Direction::BOTH.map(|d| surface.domain(d).at(r.between(0.1, 0.9)));
            let mut out = whole.face_split_at(0, [&[u], &[v]], &TOLERANCE)?;
            out.push(whole.shrunk_face(0, &TOLERANCE)?);
            out.push(whole.untrimmed_face(0)?);
            out.push(
                surface.isotrimmed(
                    Interval::new(u, surface.domain(Direction::U).end),
                    Interval::new(v, v + 1.0),
                )?,
            );
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
        ("nested boundaries", |r| {
            let plane = r.plane(9.0);
            let outer = closed(r, &plane)?;
            let mut curves = vec![outer.clone()];
            for _ in 0..1 + r.below(4) {
                // Now and then two of one size, or one that touches another.
                let size = [0.8, 0.6, 0.5, 0.25, 1.0, 0.6][r.below(6)];
                let inner = outer.transformed(&Xform::scale(plane.origin, size))?;
                curves.push(if r.one_in(2) { inner.reversed() } else { inner });
            }
            if r.one_in(3) {
                let aside = closed(r, &plane)?;
                curves.push(aside.transformed(&Xform::scale(plane.origin, 0.1))?);
            }
            Ok(Brep::planar_faces(&curves, &TOLERANCE)?.breps)
        }),
        ("retrim", |r| {
            let source = surface(r)?;
            let loops = [parameter_loop(r, &source)?];
            let trimmed = Brep::from_parameter_loops(&source, &loops, &TOLERANCE)?;
            let face = trimmed.into_iter().next().ok_or(Error::Unsupported("an empty region"))?;
            let near = match r.below(3) {
                0 => source.clone(),
                1 => source.transformed(&Xform::translation(r.vector(0.05)))?,
                _ => source.to_nurbs()?.into(),
            };
            face.retrimmed(0, &near, &TOLERANCE)
        }),
        ("isotrim", |r| {
            let surface = surface(r)?;
            let [u, v] = Direction::BOTH.map(|d| {
                let domain = surface.domain(d);
                Interval::new(domain.at(r.between(-0.2, 0.6)), domain.at(r.between(0.3, 1.2)))
            });
            one(surface.isotrimmed(u, v))
        }),
        ("split by isocurves", |r| {
            let shape = solid(r)?;
            let face = r.below(shape.faces().len());
            let Some(surface) = shape.face_surface(face) else { return Ok(Vec::new()) };
            let mut cuts = [Vec::new(), Vec::new()];
            for (d, list) in Direction::BOTH.into_iter().zip(&mut cuts) {
                for _ in 0..r.below(4) {
                    let at = [0.0, 1.0, 0.5, r.between(0.0, 1.0)][r.below(4)];
                    list.push(surface.domain(d).at(at));
                }
            }
            shape.face_split_at(face, [&cuts[0], &cuts[1]], &TOLERANCE)
        }),
        ("cap holes", |r| {
            let shape = solid(r)?;
            let mut faces = shape.exploded()?;
            for _ in 0..1 + r.below(2) {
                if faces.len() > 1 {
                    faces.remove(r.below(faces.len()));
                }
            }
            let open = Brep::join(&faces, &TOLERANCE)?.breps;
            open.iter().map(|brep| Ok(brep.capped(&TOLERANCE)?.0)).collect()
        }),
        ("merge faces", |r| {
            let shape = match r.below(3) {
                0 => solid(r)?,
                1 => {
                    // A polyline with corners on its sides gives walls in one plane.
                    let (a, b, c) = (r.point(4.0), r.point(4.0), r.point(4.0));
                    let corners = vec![a, a.lerp(b, 0.3), a.lerp(b, 0.7), b, c, c.lerp(a, 0.5), a];
                    let profile: Curve = PolylineCurve::new(corners)?.into();
                    construct::extrude(&profile, r.vector(4.0), r.one_in(2), &TOLERANCE)?
                }
                _ => {
                    let plane = r.plane(5.0);
                    let k = r.scale;
                    let side = |a: f64, b: f64| -> Result<Brep> {
                        construct::plane_surface(&plane, Interval::new(a * k, b * k), Interval::new(0.0, k))
                    };
                    let middle = r.between(0.5, 3.0);
                    let gap = [0.0, 0.0, 5e-4, 0.1][r.below(4)] / k;
                    return Brep::join(&[side(0.0, middle)?, side(middle + gap, 4.0)?], &TOLERANCE)?
                        .breps
                        .iter()
                        .map(|b| b.with_coplanar_faces_merged(&TOLERANCE))
                        .collect();
                }
            };
            one(shape.with_coplanar_faces_merged(&TOLERANCE))
        }),
        ("fillet edges", |r| {
            let shape = match r.below(4) {
                // Straight walls, sheared now and then.
                0 => {
                    let corners =
                        [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0), (0.0, 0.0)];
                    let (plane, k) = (r.plane(5.0), r.scale);
                    let point = |(x, y): &(f64, f64)| plane.at(k * x, k * y, 0.0);
                    let profile: Curve = PolylineCurve::new(corners.iter().map(point).collect())?.into();
                    let slant = if r.one_in(2) { r.vector(0.8) } else { Vector3::ZERO };
                    construct::extrude(&profile, plane.z_axis * (3.0 * k) + slant, true, &TOLERANCE)?
                }
                _ => solid(r)?,
            };
            // Seams now and then only.
            let seams = r.one_in(8);
            let between_faces = |edge: &usize| {
                let faces =
                    shape.edges()[*edge].trims.iter().map(|t| shape.loops()[shape.trims()[*t].in_loop?].face);
                let faces: Vec<Option<usize>> = faces.collect();
                seams || matches!(faces.as_slice(), [a, b] if a != b)
            };
            let edges: Vec<usize> = (0..shape.edges().len()).filter(between_faces).collect();
            let count = edges.len();
            if count == 0 {
                return Ok(Vec::new());
            }
            let radius = r.scale * [0.02, 0.1, 0.3, r.between(0.01, 1.0)][r.below(4)];
            let wanted = match r.below(4) {
                0 => edges,
                1 => vec![edges[r.below(count)], edges[r.below(count)]],
                _ => vec![edges[r.below(count)]],
            };
            let blend =
                [FilletBlend::Arc, FilletBlend::Arc, FilletBlend::Chamfer, FilletBlend::Smooth][r.below(4)];
            let rails =
                [FilletRail::RollingBall, FilletRail::DistanceFromEdge, FilletRail::DistanceBetweenRails]
                    [r.below(3)];
            let wanted: Vec<(usize, f64)> = wanted.into_iter().map(|edge| (edge, radius)).collect();
            one(shape.filleted(&wanted, blend, rails, &TOLERANCE))
        }),
        ("join solids", |r| {
            let (a, b) = (solid(r)?, solid(r)?);
            let mut breps = vec![a.clone(), b];
            if r.one_in(2) {
                breps.push(a.flipped());
            }
            Ok(Brep::join(&breps, &TOLERANCE)?.breps)
        }),
        ("parts", |r| {
            let shape = solid(r)?;
            let mut out = shape.connected_components()?;
            let faces: Vec<usize> = (0..shape.faces().len()).filter(|_| r.one_in(2)).collect();
            if !faces.is_empty() {
                out.push(shape.sub_brep(&faces)?);
            }
            out.push(Brep::merged(&[shape.clone(), shape.clone().flipped()]));
            out.push(shape.clone().turned_outward());
            // Also mirrored, stretched and sheared.
            let map = Xform::from_columns(r.way(), r.way(), r.way(), Point3::ORIGIN);
            out.extend(shape.transformed(&map));
            Ok(out)
        }),
    ]
}
