//! Breps with breps: the curves in which their faces meet.

use std::sync::Arc as Shared;

use super::{Brep, ClosestOnBrep};
use crate::chart::thresholds::{FLAT_FACE, PARALLEL_FACES};
use crate::intersect::{SurfaceContactKind, common, surface_plane};
use crate::{Curve, Error, Plane, Point3, Result, Surface, Tolerance, cancellation, join_curves};

/// What two breps have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct BrepMeeting {
    /// The curves in which faces pass through each other, touch, or end on each other, joined.
    pub curves: Vec<Curve>,
    /// Points in which faces touch.
    pub points: Vec<Point3>,
    /// Whether the search came to its end on every pair of faces. `false` says that something may be missing: where
    /// faces lie upon each other and are not flat, or what they do where they touch is not decided.
    pub complete: bool,
}

/// Places of a curve that must lie on another one for both to be the same.
const SAME: [f64; 5] = [0.0, 0.21, 0.5, 0.77, 1.0];

impl Brep {
    /// The curves and points that the faces of two breps have in common, within `tolerance`.
    ///
    /// Flat faces cut others as planes do, with lines, circles and arcs as such
    /// ([`surface_plane`](crate::intersect::surface_plane())); all other pairs meet as
    /// [`surface_with_surface`](crate::intersect::surface_with_surface()) tells, also where they touch: in closed form
    /// where there is one. The parts within the trims of both faces are kept. Curved faces that lie upon each other have
    /// the borders of the common area in common; where flat faces do, the curves of the faces beside them are what is
    /// found.
    ///
    /// # Errors
    /// The tolerance is not above 0; a brep has no faces; a pair of faces is not supported; or the work was stopped.
    pub fn meeting(&self, other: &Self, tolerance: &Tolerance) -> Result<BrepMeeting> {
        let limit = tolerance.positive_distance()?;
        let sides = [self, other].map(|b| ClosestOnBrep::new(Shared::new(b.clone())));
        let [first, second] = sides;
        let sides = [first?, second?];
        let mut out = BrepMeeting { curves: Vec::new(), points: Vec::new(), complete: true };
        for a in sides[0].sheets() {
            for b in sides[1].sheets() {
                cancellation::check()?;
                if a.bounds.distance_to_box(&b.bounds) > limit {
                    continue;
                }
                let faces = [(&sides[0], a.face), (&sides[1], b.face)];
                let found = surfaces_of(faces, tolerance)?;
                out.complete &= found.complete;
                for curve in &found.curves {
                    for part in faces[0].0.curve_within(a.face, curve, limit)? {
                        for part in faces[1].0.curve_within(b.face, &part, limit)? {
                            add(&mut out.curves, part, 2.0 * limit)?;
                        }
                    }
                }
                for p in found.points {
                    let mut on_both = true;
                    for (search, face) in faces {
                        on_both = on_both && is_on(search, face, p, limit)?;
                    }
                    if on_both && !out.points.iter().any(|q| q.distance_to(p) <= 2.0 * limit) {
                        out.points.push(p);
                    }
                }
            }
        }
        out.curves = join_curves(&out.curves, 2.0 * limit, false);
        Ok(out)
    }
}

/// The common curves and points of the surfaces of two faces.
fn surfaces_of(faces: [(&ClosestOnBrep, usize); 2], tolerance: &Tolerance) -> Result<BrepMeeting> {
    let surface = |(search, face): (&ClosestOnBrep, usize)| {
        search.brep().face_surface(face).cloned().ok_or(Error::degenerate("brep", "a face has no surface"))
    };
    let [a, b] = [surface(faces[0])?, surface(faces[1])?];
    let flat = [&a, &b].map(|s| s.plane(FLAT_FACE * s.bounding_box().map_or(0.0, |b| b.diagonal().length())));
    let mut out = BrepMeeting { curves: Vec::new(), points: Vec::new(), complete: true };
    let cut = |s: &Surface, plane: &Plane, out: &mut BrepMeeting| {
        let section = surface_plane(s, plane, tolerance)?;
        out.complete &= section.complete;
        out.curves.extend(section.curves);
        Ok::<_, Error>(())
    };
    match flat {
        [Some(p), Some(q)] if p.z_axis.cross(q.z_axis).length() <= PARALLEL_FACES => {}
        [_, Some(plane)] => cut(&a, &plane, &mut out)?,
        [Some(plane), None] => cut(&b, &plane, &mut out)?,
        [None, None] => {
            let (met, _) = common(&a, &b, tolerance)?;
            out.complete = met.complete
                && met.contacts.iter().all(|c| match c.kind {
                    SurfaceContactKind::Point | SurfaceContactKind::Crossing => true,
                    SurfaceContactKind::Curve => c.curve.is_some(),
                    SurfaceContactKind::Overlap => !c.border.is_empty(),
                    SurfaceContactKind::Undecided => false,
                });
            for contact in met.contacts {
                match contact.kind {
                    SurfaceContactKind::Point => out.points.push(contact.point),
                    SurfaceContactKind::Curve | SurfaceContactKind::Overlap => {
                        let own = contact.curve.into_iter().chain(contact.border.into_iter().flatten());
                        out.curves.extend(own.map(|branch| branch.curve));
                    }
                    SurfaceContactKind::Crossing | SurfaceContactKind::Undecided => {}
                }
            }
            out.curves.extend(met.branches.into_iter().map(|b| b.curve));
        }
    }
    Ok(out)
}

/// Whether a point of a face's surface lies within its trims.
fn is_on(search: &ClosestOnBrep, face: usize, p: Point3, limit: f64) -> Result<bool> {
    let Some(surface) = search.brep().face_surface(face) else { return Ok(false) };
    let near = surface.closest_point(p)?;
    Ok(near.distance <= 2.0 * limit
        && search.covers(face, near.u, near.v, limit)? != crate::Containment::Outside)
}

/// Adds a curve, unless it is there already: faces on both sides of an edge find what lies on it.
fn add(curves: &mut Vec<Curve>, curve: Curve, near: f64) -> Result<()> {
    let domain = curve.domain();
    for known in curves.iter() {
        let mut same = true;
        for share in SAME {
            same = same && known.closest_point_within(curve.point_at(domain.at(share)), near)?.is_some();
        }
        if same {
            return Ok(());
        }
    }
    curves.push(curve);
    Ok(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failing test may panic")]

    use std::f64::consts::TAU;

    use super::BrepMeeting;
    use crate::{
        Brep, Curve, Cylinder, Interval, Plane, PlaneSurface, Point3, Sphere, Surface, Tolerance, Vector3,
    };

    fn brep(surface: impl Into<Surface>) -> Brep {
        Brep::from_surface(surface.into()).unwrap()
    }

    fn meet(a: &Brep, b: &Brep) -> BrepMeeting {
        let met = a.meeting(b, &Tolerance::default()).unwrap();
        let swapped = b.meeting(a, &Tolerance::default()).unwrap();
        assert_eq!(met.curves.len(), swapped.curves.len());
        assert!((length(&met) - length(&swapped)).abs() < 1e-6);
        met
    }

    fn length(met: &BrepMeeting) -> f64 {
        met.curves.iter().map(Curve::length).sum()
    }

    fn ball(x: f64, radius: f64) -> Brep {
        brep(Sphere::around(Point3::new(x, 0.0, 0.0), radius).unwrap())
    }

    fn floor(side: f64) -> Brep {
        let side = Interval::new(-side, side);
        brep(PlaneSurface::new(Plane::XY, side, side).unwrap())
    }

    #[test]
    fn balls_meet_in_circles() {
        // Radii 5 and 5, centres 6 apart: a circle of radius 4.
        let met = meet(&ball(0.0, 5.0), &ball(6.0, 5.0));
        let [circle] = &met.curves[..] else { panic!("{met:?}") };
        assert!(met.complete && circle.is_closed());
        assert!((circle.as_circle(1e-6).unwrap().radius - 4.0).abs() < 1e-9);
        assert!(meet(&ball(0.0, 5.0), &ball(11.0, 5.0)).curves.is_empty());
    }

    #[test]
    fn a_ball_on_a_floor() {
        let met = meet(&ball(0.0, 5.0), &floor(20.0));
        assert!(met.complete && met.curves.len() == 1);
        assert!((length(&met) - 5.0 * TAU).abs() < 1e-6);
        // A floor that is smaller than the ball has its border inside.
        assert!(meet(&ball(0.0, 5.0), &floor(3.0)).curves.is_empty());
        // Half of the circle lies on half a floor.
        let half =
            PlaneSurface::new(Plane::XY, Interval::new(0.0, 20.0), Interval::new(-20.0, 20.0)).unwrap();
        let met = meet(&ball(0.0, 5.0), &brep(half));
        assert!((length(&met) - 2.5 * TAU).abs() < 1e-4, "{}", length(&met));
    }

    #[test]
    fn equal_cylinders_meet_in_two_ellipses() {
        let lying = Plane::from_normal(Point3::new(-10.0, 0.0, 0.0), Vector3::X).unwrap();
        let standing = Plane::XY.offset(-10.0);
        let tube = |p: Plane| brep(Cylinder::new(p, 2.0, Interval::new(0.0, 20.0)).unwrap());
        let met = meet(&tube(lying), &tube(standing));
        let ellipse = crate::Ellipse::new(Plane::XY, 8f64.sqrt(), 2.0).unwrap().to_nurbs().unwrap();
        assert!(met.complete);
        assert!((length(&met) - 2.0 * Curve::from(ellipse).length()).abs() < 1e-2, "{}", length(&met));
    }

    #[test]
    fn what_touches_is_told_exactly() {
        let tube = brep(Cylinder::new(Plane::XY.offset(-10.0), 2.0, Interval::new(0.0, 20.0)).unwrap());
        // A ball that fills the tube touches it along a circle.
        let met = meet(&tube, &ball(0.0, 2.0));
        let [circle] = &met.curves[..] else { panic!("{met:?}") };
        assert!(met.complete && met.points.is_empty());
        assert!((circle.as_circle(1e-9).unwrap().radius - 2.0).abs() < 1e-12);
        // One beside it touches in a point, one a little further away nowhere.
        let met = meet(&tube, &ball(5.0, 3.0));
        assert!(met.complete && met.curves.is_empty() && met.points.len() == 1, "{met:?}");
        assert!(met.points[0].distance_to(Point3::new(2.0, 0.0, 0.0)) < 1e-12);
        assert_eq!(meet(&tube, &ball(5.01, 3.0)).points, vec![]);
        // Tubes side by side have a ruling in common.
        let beside = Plane::XY.with_origin(Point3::new(5.0, 0.0, -4.0));
        let other = brep(Cylinder::new(beside, 3.0, Interval::new(0.0, 20.0)).unwrap());
        let met = meet(&tube, &other);
        assert!(met.complete && met.curves.len() == 1, "{met:?}");
        // The ends are those of the shorter tube, to a part of the tolerance.
        assert!((length(&met) - 14.0).abs() < 1e-6, "{}", length(&met));
    }

    #[test]
    fn balls_cut_rings_in_circles() {
        let ring = brep(crate::Torus::new(Plane::XY, 5.0, 1.0).unwrap());
        let copy = ring.face_surface(0).unwrap().to_nurbs().unwrap();
        for ring in [ring, brep(copy)] {
            // (r − 5)² + z² = 1 and r² + z² = 25 give 10 r = 49.
            let met = meet(&ring, &ball(0.0, 5.0));
            assert!(met.complete && met.curves.len() == 2, "{met:?}");
            let radius = 4.9;
            for circle in &met.curves {
                assert!((circle.as_circle(1e-9).unwrap().radius - radius).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn unequal_cylinders_meet_in_two_loops() {
        let lying = Plane::from_normal(Point3::new(-10.0, 0.0, 0.0), Vector3::X).unwrap();
        let tube = |p: Plane, r: f64| brep(Cylinder::new(p, r, Interval::new(0.0, 20.0)).unwrap());
        let met = meet(&tube(lying, 2.0), &tube(Plane::XY.offset(-10.0), 1.0));
        assert!(met.complete && met.curves.len() == 2, "{}", met.curves.len());
        // (cos t, sin t, √(4 − sin²t)) on both.
        let n = 20_000;
        let at = |k: usize| {
            let t = TAU * k as f64 / n as f64;
            Point3::new(t.cos(), t.sin(), (4.0 - t.sin().powi(2)).sqrt())
        };
        let want: f64 = (0..n).map(|k| at(k).distance_to(at(k + 1))).sum();
        assert!((length(&met) - 2.0 * want).abs() < 1e-3, "{} {want}", length(&met));
        assert!(met.curves.iter().all(Curve::is_closed));
    }
}
