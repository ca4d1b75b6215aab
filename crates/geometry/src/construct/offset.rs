//! Surfaces at a distance from others.

use crate::construct::thresholds::{BESIDE_SINGULARITY, KINK, KINK_OF_CURVATURE};
use crate::nurbs::surface_through_pieces;
use crate::thresholds;
use crate::{
    Brep, Curve, Direction, Error, Line, LineCurve, NurbsSurface, Point3, Quadrant, Result,
    RevolutionSurface, Surface, Tolerance, Vector3, Xform,
};

/// The most places at which a surface is taken in one direction.
const MOST: usize = 600;

/// The surface at a distance from another along its normals, over the same domain: exact for planes and for lines and
/// arcs turned about an axis, elsewhere a bicubic through so many of its points that half-way between them it is
/// within the tolerance. A distance of a radius of curvature or more, at which the result would fold over, is refused
/// where one of those points shows it.
///
/// # Errors
/// A distance that is not finite, a surface with kinks or without normals, an offset that folds over, shrinks to a
/// point or passes the axis it is turned about, or one that cannot be followed within the tolerance.
pub fn offset_surface(surface: &Surface, distance: f64, tolerance: &Tolerance) -> Result<Surface> {
    let limit = tolerance.positive_distance()?;
    if !distance.is_finite() {
        return Err(Error::NotFinite("distance of the offset"));
    }
    if distance == 0.0 {
        return Ok(surface.clone());
    }
    match surface {
        Surface::Plane(plane) => surface.transformed(&Xform::translation(plane.plane().z_axis * distance)),
        Surface::Revolution(turned) => match turned_offset(surface, turned, distance)? {
            Some(exact) => Ok(exact),
            None => sampled(surface, |_, _| distance, limit),
        },
        _ => sampled(surface, |_, _| distance, limit),
    }
}

/// The surface at distances from another along its normals that go evenly from one corner to the next: a share of the
/// way along both domains is the same share of the way between the distances. They are those where both parameters
/// begin, where the second ends, where the first ends, and where both end. A bicubic within the tolerance.
///
/// # Errors
/// As [`offset_surface`].
pub fn offset_surface_variably(
    surface: &Surface,
    distances: [f64; 4],
    tolerance: &Tolerance,
) -> Result<Surface> {
    let limit = tolerance.positive_distance()?;
    if !distances.iter().all(|d| d.is_finite()) {
        return Err(Error::NotFinite("distance of the offset"));
    }
    let [a, b, c, d] = distances;
    let [us, vs] = Direction::BOTH.map(|direction| surface.domain(direction));
    let distance = |u: f64, v: f64| {
        let (x, y) = (us.normalized(u), vs.normalized(v));
        (a * (1.0 - y) + b * y) * (1.0 - x) + (c * (1.0 - y) + d * y) * x
    };
    sampled(surface, distance, limit)
}

/// The faces of a brep at a distance from them along their normals, joined where they still meet. Faces that are
/// trimmed are trimmed in the same way again unless `trimmed` is false.
///
/// # Errors
/// As [`offset_surface`].
pub fn offset_brep(brep: &Brep, distance: f64, trimmed: bool, tolerance: &Tolerance) -> Result<Vec<Brep>> {
    let mut faces = Vec::new();
    for (place, face) in brep.faces().iter().enumerate().filter(|(_, face)| !face.deleted) {
        let surface = brep.face_surface(place).ok_or(Error::degenerate("brep", "a face has no surface"))?;
        let distance = if face.reversed { -distance } else { distance };
        let turn = |made: Brep| if face.reversed { made.flipped() } else { made };
        let whole = brep.sub_brep(&[place])?.as_surface().is_some();
        let smooth = Brep::from_kinked_surface(surface, tolerance)?;
        if trimmed && !whole {
            faces.extend(trimmed_offset(brep, place, distance, tolerance)?.into_iter().map(turn));
            continue;
        }
        for part in 0..smooth.faces().len() {
            let Some(part) = smooth.face_surface(part) else { continue };
            faces.push(turn(Brep::from_surface(offset_surface(part, distance, tolerance)?)?));
        }
    }
    if faces.len() == 1 { Ok(faces) } else { Ok(Brep::join(&faces, tolerance)?.breps) }
}

/// A trimmed face at a distance. Where the surface folds over beyond the trims, only the part inside them is taken.
fn trimmed_offset(brep: &Brep, face: usize, distance: f64, tolerance: &Tolerance) -> Result<Vec<Brep>> {
    let of = |brep: &Brep, face: usize| {
        let surface = brep.face_surface(face).ok_or(Error::degenerate("brep", "a face has no surface"))?;
        brep.copied_trims(face, &offset_surface(surface, distance, tolerance)?, tolerance)
    };
    of(brep, face).or_else(|error| of(&brep.shrunk_face(face, tolerance)?, 0).map_err(|_| error))
}

/// The surface whose control points are those of another, each moved along the normal at its Greville parameters: as
/// light as the other, and at the distance only about.
///
/// # Errors
/// A distance that is not finite, or a surface that has no normals.
pub fn offset_surface_loosely(surface: &Surface, distance: f64) -> Result<NurbsSurface> {
    if !distance.is_finite() {
        return Err(Error::NotFinite("distance of the offset"));
    }
    let nurbs = surface.to_nurbs()?;
    let whole = Surface::from(nurbs.clone());
    let [us, vs] = Direction::BOTH.map(|d| {
        let domain = nurbs.domain(d);
        nurbs.greville_abscissae(d).into_iter().map(|t| domain.clamp(t)).collect::<Vec<_>>()
    });
    let mut points = nurbs.control_points().into_iter();
    let mut moved = Vec::with_capacity(nurbs.point_count());
    for &u in &us {
        for &v in &vs {
            let normal = normal(&whole, u, v)?;
            moved.extend(points.next().map(|p| p + normal * distance));
        }
    }
    let knots = Direction::BOTH.map(|d| nurbs.knots(d).to_vec());
    if nurbs.is_rational() {
        return NurbsSurface::with_weights(nurbs.degrees(), nurbs.counts(), &moved, &nurbs.weights(), knots);
    }
    NurbsSurface::new(nurbs.degrees(), nurbs.counts(), moved, knots)
}

/// A line or an arc in a plane through the axis stays one.
fn turned_offset(surface: &Surface, turned: &RevolutionSurface, distance: f64) -> Result<Option<Surface>> {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d).middle());
    let (Some(normal), middle) = (surface.normal_at(u, v), surface.point_at(u, v)) else { return Ok(None) };
    // The normal where the profile itself lies.
    let axis = turned.axis();
    let own = |p: Point3| {
        let along = axis.unit_direction()?;
        let arm = p - axis.from;
        (arm - along * arm.dot(along)).unitized().map(|out| (out, along))
    };
    let profile = turned.profile();
    let start = profile.point_at(profile.domain().middle());
    let (Some((there, along)), Some((here, _))) = (own(middle), own(start)) else { return Ok(None) };
    let normal = here * normal.dot(there) + along * normal.dot(along);
    if (normal.length() - 1.0).abs() > thresholds::PARALLEL {
        return Ok(None);
    }
    let moved: Curve = match profile {
        Curve::Line(line) => {
            let shift = normal * distance;
            let moved = LineCurve {
                line: Line::new(line.line.from + shift, line.line.to + shift),
                domain: line.domain,
            };
            let out = |p: Point3| (p - axis.from).dot(here);
            if [moved.line.from, moved.line.to].iter().any(|p| out(*p) < -thresholds::ROUNDING) {
                return Err(Error::degenerate("offset", "it would pass its axis"));
            }
            moved.into()
        }
        Curve::Arc(arc) => {
            let center = arc.arc.circle.center();
            let flat = arc.arc.circle.plane.z_axis;
            if flat.dot(along).abs() > thresholds::PARALLEL || flat.dot(here).abs() > thresholds::PARALLEL {
                return Ok(None);
            }
            let outward = normal.dot(start - center) > 0.0;
            let radius = arc.arc.circle.radius + if outward { distance } else { -distance };
            if !(radius > thresholds::SAME_POINT * arc.arc.circle.radius) {
                return Err(Error::degenerate("offset", "it would shrink to a point"));
            }
            let mut moved = *arc;
            moved.arc.circle.radius = radius;
            let moved: Curve = moved.into();
            let least = |curve: &Curve| curve.extent_along(here).start - axis.from.to_vector().dot(here);
            if least(&moved) < least(profile).min(0.0) - thresholds::SAME_POINT * radius {
                return Err(Error::degenerate("offset", "it would pass its axis"));
            }
            moved
        }
        _ => return Ok(None),
    };
    let made = RevolutionSurface::with_domain(
        moved,
        axis,
        turned.angle(),
        surface.domain(turned.angle_direction()),
    )?;
    let made = if turned.angle_direction() == Direction::U { made } else { made.transposed() };
    Ok(Some(made.into()))
}

/// The unit normal, beside places that have none.
fn normal(surface: &Surface, u: f64, v: f64) -> Result<Vector3> {
    let [du, dv] = Direction::BOTH.map(|d| surface.domain(d));
    let none = Error::degenerate("surface", "it has no normal");
    if let Some(normal) = surface.normal_at(u, v) {
        return Ok(normal);
    }
    let nearer = |t: f64, middle: f64| t + BESIDE_SINGULARITY * (middle - t);
    surface.normal_at(nearer(u, du.middle()), nearer(v, dv.middle())).ok_or(none)
}

/// Refuses a distance at which a surface folds over: one not below a radius of curvature on its side. Points without
/// normals are passed over.
fn check_folds(surface: &Surface, distance: &impl Fn(f64, f64) -> f64, us: &[f64], vs: &[f64]) -> Result<()> {
    for &u in us {
        for &v in vs {
            let Ok(bend) = surface.curvature_at(u, v) else { continue };
            if bend.principal.iter().any(|k| distance(u, v) * k >= 1.0) {
                return Err(Error::degenerate(
                    "offset",
                    "it folds over: the distance is not below a radius of curvature",
                ));
            }
        }
    }
    Ok(())
}

/// The parameters inside the domain at which the first or the second derivative along a direction jumps.
fn jumps(surface: &Surface, direction: Direction) -> Vec<f64> {
    let spans = surface.span_parameters(direction);
    let across = surface.domain(direction.other());
    let jumps_at = |t: f64, width: f64| {
        [0.05, 0.31, 0.62, 0.95].into_iter().any(|x| {
            let s = across.at(x);
            let along = |below: bool| {
                let (u, v, sides) = match direction {
                    Direction::U => (t, s, [below, false]),
                    Direction::V => (s, t, [false, below]),
                };
                let d = surface.derivatives(u, v, 2, Quadrant::new(sides[0], sides[1]));
                match direction {
                    Direction::U => [d.get(1, 0), d.get(2, 0)],
                    Direction::V => [d.get(0, 1), d.get(0, 2)],
                }
            };
            let (before, after) = (along(true), along(false));
            let size = before[0].length().max(after[0].length());
            (after[0] - before[0]).length() > KINK * size
                || (after[1] - before[1]).length() * width > KINK_OF_CURVATURE * size
        })
    };
    spans.windows(3).filter(|w| jumps_at(w[1], (w[1] - w[0]).min(w[2] - w[1]))).map(|w| w[1]).collect()
}

fn sampled(surface: &Surface, distance: impl Fn(f64, f64) -> f64, limit: f64) -> Result<Surface> {
    let spans = Direction::BOTH.map(|d| surface.span_parameters(d));
    let at = |u: f64, v: f64| -> Result<Point3> {
        crate::cancellation::check()?;
        Ok(surface.point_at(u, v) + normal(surface, u, v)? * distance(u, v))
    };
    let places = |spans: &[f64], parts: usize| -> Vec<f64> {
        let inner = spans.windows(2).flat_map(|w| {
            let [a, b] = [w[0], w[1]];
            (0..parts).map(move |k| a + (b - a) * (k as f64 / parts as f64))
        });
        inner.chain(spans.last().copied()).collect()
    };
    // Beside a line where the curvature jumps the offset bends otherwise than before it.
    let breaks = Direction::BOTH.map(|d| jumps(surface, d));
    let mut parts = [0, 1].map(|k: usize| match spans[k].len() {
        0..=4 => 4,
        5..=100 if !breaks[k].is_empty() => 4,
        _ => 2,
    });
    check_folds(surface, &distance, &places(&spans[0], 8), &places(&spans[1], 8))?;
    loop {
        let [us, vs] = [0, 1].map(|k: usize| places(&spans[k], parts[k]));
        if us.len() > MOST || vs.len() > MOST {
            return Err(Error::degenerate(
                "offset",
                "it cannot be followed within the tolerance: are there kinks?",
            ));
        }
        let mut points = Vec::with_capacity(us.len() * vs.len());
        for &u in &us {
            for &v in &vs {
                points.push(at(u, v)?);
            }
        }
        let made = surface_through_pieces(&points, [&us, &vs], [&breaks[0], &breaks[1]])?;
        let halves = |ts: &[f64]| ts.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect::<Vec<_>>();
        let miss = |us: &[f64], vs: &[f64]| -> Result<f64> {
            let mut worst = 0.0_f64;
            for &u in us {
                for &v in vs {
                    worst = worst.max(made.point_at(u, v).distance_to(at(u, v)?));
                }
            }
            Ok(worst)
        };
        let (hu, hv) = (halves(&us), halves(&vs));
        let missed = [miss(&hu, &vs)?, miss(&us, &hv)?];
        if missed.iter().sum::<f64>() <= 0.5 * limit {
            check_folds(surface, &distance, &us, &vs)?;
            return Ok(made.into());
        }
        let worse = missed[0].max(missed[1]);
        for k in 0..2 {
            if missed[k] > 0.1 * worse {
                parts[k] *= 2;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cone, Cylinder, Interval, Plane, PlaneSurface, Sphere, SumSurface, Torus};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-4, ..Tolerance::default() }
    }

    fn apart(a: &Surface, b: &Surface) -> [f64; 2] {
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        let [u, v] = Direction::BOTH.map(|d| b.domain(d));
        for i in 0..=20 {
            for j in 0..=20 {
                let p = b.point_at(u.at(f64::from(i) / 20.0), v.at(f64::from(j) / 20.0));
                let d = a.closest_point(p).unwrap().distance;
                (least, most) = (least.min(d), most.max(d));
            }
        }
        [least, most]
    }

    #[test]
    fn round_surfaces_stay_round() {
        let ball: Surface = Sphere { plane: Plane::XY, radius: 2.0 }.into();
        let larger = offset_surface(&ball, 1.0, &tolerance()).unwrap();
        assert!((larger.area().unwrap().area - 36.0 * std::f64::consts::PI).abs() < 1e-6);
        assert!(offset_surface(&ball, -2.0, &tolerance()).is_err());
        let tube: Surface = Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 3.0)).unwrap().into();
        let wider = offset_surface(&tube, 1.0, &tolerance()).unwrap();
        assert!((wider.area().unwrap().area - 12.0 * std::f64::consts::PI).abs() < 1e-8);
        assert!(offset_surface(&tube, -1.5, &tolerance()).is_err());
        for surface in [
            Surface::from(Torus::new(Plane::XY, 5.0, 1.0).unwrap()),
            Surface::from(Cone::new(Plane::XY, 2.0, 1.0).unwrap()),
        ] {
            let moved = offset_surface(&surface, 0.5, &tolerance());
            let Ok(moved) = moved else { continue };
            assert!(matches!(moved, Surface::Revolution(_)));
            assert_eq!(moved.domain(Direction::U), surface.domain(Direction::U));
            assert_eq!(moved.domain(Direction::V), surface.domain(Direction::V));
        }
    }

    #[test]
    fn free_surfaces_are_followed() {
        let points: Vec<Point3> = (0..25)
            .map(|k| Point3::new(f64::from(k / 5), f64::from(k % 5), f64::from(k * k % 7) * 0.2))
            .collect();
        let surface: Surface = NurbsSurface::clamped_uniform([3, 3], [5, 5], &points).unwrap().into();
        let moved = offset_surface(&surface, 0.2, &tolerance()).unwrap();
        let [least, most] = apart(&surface, &moved);
        assert!(least > 0.2 - 1e-4 && most < 0.2 + 1e-4, "{least} {most}");
        let (u, v) = (0.7, 1.2);
        let side = (moved.point_at(u, v) - surface.point_at(u, v)).dot(surface.normal_at(u, v).unwrap());
        assert!((side - 0.2).abs() < 1e-4);
        let loose = offset_surface_loosely(&surface, 0.2).unwrap();
        assert_eq!(loose.counts(), [5, 5]);
    }

    #[test]
    fn distances_go_evenly_between_corners() {
        let ball: Surface = Sphere { plane: Plane::XY, radius: 4.0 }.into();
        let part = ball.sub_surface(Interval::new(0.2, 1.4), Interval::new(-0.4, 0.9)).unwrap();
        let flat: Surface =
            PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 3.0)).unwrap().into();
        for surface in [part, flat] {
            let made = offset_surface_variably(&surface, [0.1, 0.4, -0.3, 0.8], &tolerance()).unwrap();
            let [us, vs] = Direction::BOTH.map(|d| surface.domain(d));
            for (x, y, d) in
                [(0.0, 0.0, 0.1), (0.0, 1.0, 0.4), (1.0, 0.0, -0.3), (1.0, 1.0, 0.8), (0.5, 0.5, 0.25)]
            {
                let (u, v) = (us.at(x), vs.at(y));
                let wanted = surface.point_at(u, v) + surface.normal_at(u, v).unwrap() * d;
                assert!(made.point_at(u, v).distance_to(wanted) < 1e-4, "{x} {y}");
            }
        }
    }

    /// A parabolic trough of curvature 2 a at its bottom folds over from a distance of 1 / (2 a) inwards.
    #[test]
    fn folds_are_refused() {
        let a = 0.5;
        // x from −2 to 2 and z = a x² as a quadratic Bézier.
        let points = [(-2.0, 4.0 * a), (0.0, -4.0 * a), (2.0, 4.0 * a)].map(|(x, z)| Point3::new(x, 0.0, z));
        let profile = crate::NurbsCurve::bezier(&points).unwrap();
        let trough: Surface = SumSurface::extrusion(profile.into(), Vector3::Y).unwrap().into();
        let inward = trough.normal_at(trough.domain(Direction::U).middle(), 0.5).unwrap().z.signum();
        let offset = |d: f64| offset_surface(&trough, d * inward, &tolerance());
        assert!(offset(0.9).is_ok() && offset(-3.0).is_ok());
        assert!(offset(1.1).is_err_and(|e| e.to_string().contains("folds over")));
        // A torus grown beyond its own hole.
        let ring: Surface = Torus::new(Plane::XY, 2.0, 1.0).unwrap().into();
        let out = ring.normal_at(0.0, 0.0).unwrap().x.signum();
        assert!(offset_surface(&ring, 0.9 * out, &tolerance()).is_ok());
        assert!(offset_surface(&ring, 1.1 * out, &tolerance()).is_err());
    }

    /// Walls over lines and arcs that go over into each other: the offset is that of the outline, by the exact distance.
    #[test]
    fn walls_whose_curvature_jumps() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 3.0], [0.0, 3.0], [0.0, 0.0]];
        let corners = corners.map(|[x, y]| Point3::new(x, y, 0.0)).to_vec();
        let sharp: Curve = crate::PolylineCurve::new(corners).unwrap().into();
        let (outline, _) = sharp.fillet_corners(0.3, &tolerance()).unwrap();
        let walls: Surface = SumSurface::extrusion(outline, Vector3::Z).unwrap().into();
        let length = 2.0 * (1.4 + 2.4) + std::f64::consts::TAU * 0.3;
        for distance in [0.1, -0.1] {
            let made = offset_surface(&walls, distance, &tolerance()).unwrap();
            let [least, most] = apart(&walls, &made);
            assert!((least - 0.1).abs() < 2e-4 && (most - 0.1).abs() < 2e-4, "{least} {most}");
            let out = walls.normal_at(0.1, 0.5).unwrap().y < 0.0;
            let grown = if out { distance } else { -distance };
            let wanted = length + std::f64::consts::TAU * grown;
            assert!((made.area().unwrap().area - wanted).abs() < 1e-3);
            assert!(made.kinks(Direction::U, Tolerance::default().angle).is_empty());
        }
    }

    #[test]
    fn trims_and_kinks_are_kept() {
        let flat: Surface =
            PlaneSurface::new(Plane::XY, Interval::new(-3.0, 3.0), Interval::new(-3.0, 3.0)).unwrap().into();
        let ring: Curve = crate::Circle { plane: Plane::XY, radius: 2.0 }.into();
        let disc = Brep::from_parameter_loops(&flat, &[ring], &tolerance()).unwrap();
        let moved = offset_brep(&disc[0], 1.5, true, &tolerance()).unwrap();
        let bounds = moved[0].bounding_box_in(&Plane::XY).unwrap();
        assert!((bounds.z.start - 1.5).abs() < 1e-9 && (bounds.x.length() - 4.0).abs() < 1e-9);
        let untrimmed = offset_brep(&disc[0], 1.5, false, &tolerance()).unwrap();
        assert!(untrimmed[0].as_surface().is_some());
        let bent = crate::PolylineCurve::new(vec![
            Point3::ORIGIN,
            Point3::new(2.0, 0.0, 0.0),
            Point3::new(2.0, 2.0, 0.0),
        ]);
        let walls: Surface = SumSurface::extrusion(bent.unwrap().into(), Vector3::Z).unwrap().into();
        let walls = Brep::from_kinked_surface(&walls, &tolerance()).unwrap();
        let moved = offset_brep(&walls, 0.5, true, &tolerance()).unwrap();
        assert_eq!(moved.len(), 2, "apart from each other");
    }
}
