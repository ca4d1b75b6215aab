//! Sections of surfaces by planes.

mod seams;

use super::curve_curve::check;
use super::thresholds::{
    CUTS, HEIGHT_OF_PLACE, HEIGHT_OF_PLANE, HEIGHT_OF_SIZE, IN_PLANE, JOINED, JOINED_LEAST,
};
use super::zeros::{self, Cell};
use crate::curve::traced::{Sample, joined, sampled_closely};
use crate::{Curve, Direction, Error, NurbsSurface, Plane, Quadrant, Result, Surface, Tolerance};

/// The curves in which a plane cuts a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceSection {
    /// The curves, joined where they meet: lines, arcs and circles where they are such to rounding, isocurves where the
    /// plane goes through a side or a knot line, else cubics within the tolerance.
    pub curves: Vec<Curve>,
    /// Whether the search came to its end. `false` says that something may be missing, on a surface that lies next to
    /// the plane over a wide range.
    pub complete: bool,
}

/// The curves in which a plane cuts a surface, each within `tolerance` of surface and plane.
///
/// The distance of the surface from the plane is a Bernstein polynomial over each Bézier patch (times the weights). Parts
/// whose coefficients have one sign are discarded. Where they grow all along u, or all along v, the section in the
/// part consists of graphs over the other parameter, whose ends are roots on the four sides: all of them. Other parts
/// are split (after the marching methods in N. Patrikalakis and T. Maekawa, *Shape Interrogation*, 5.8, with this proof
/// instead of starting points). So all curves in which the surface passes through the plane are found, loops that lie
/// within a patch among them, but for places smaller than 10⁻⁶ of a patch. Sides and knot lines that lie in the plane
/// belong to the section where the surface passes through the plane there or ends. Where the surface only touches the
/// plane, in points or along a curve within a patch, and over areas that lie in it, nothing is reported besides the
/// border of such an area where that is a side or a knot line.
///
/// # Errors
/// The plane or the tolerance is not finite, or the tolerance not above 0.
pub fn surface_plane(surface: &Surface, plane: &Plane, tolerance: &Tolerance) -> Result<SurfaceSection> {
    check(tolerance.absolute)?;
    if !plane.is_finite() {
        return Err(Error::NotFinite("plane"));
    }
    let limit = tolerance.absolute;
    if !(limit > 0.0) {
        return Err(Error::OutOfRange { what: "tolerance", value: limit, must: "greater than 0" });
    }
    let nurbs = surface.to_nurbs()?;
    let Some(bounds) = crate::BoundingBox::from_points(nurbs.control_points()) else {
        return Err(Error::NotFinite("surface"));
    };
    let size = bounds.diagonal().length();
    let far = bounds.max_distance_to(plane.origin);
    let range = bounds.range_of_distances(plane);
    // Far from the origin every coordinate has lost digits before.
    let remote = [bounds.min, bounds.max, plane.origin].map(|p| p.to_vector().length());
    let noise = HEIGHT_OF_SIZE * size
        + HEIGHT_OF_PLACE * far
        + HEIGHT_OF_PLANE * remote.into_iter().fold(0.0, f64::max);
    if range.start > noise || range.end < -noise {
        return Ok(SurfaceSection { curves: Vec::new(), complete: true });
    }
    let patches = nurbs.bezier_patches()?;
    let cells = patches.iter().enumerate().map(|(i, patch)| heights(i, patch, plane));
    let (stretches, complete) = zeros::stretches(cells, noise);
    let mut rows: Vec<Vec<Sample>> = Vec::with_capacity(stretches.len());
    for stretch in &stretches {
        let Some(patch) = patches.get(stretch.patch()) else { continue };
        rows.extend(sampled_closely(0.0, 1.0, 2, 0.5 * limit, |x| {
            Ok(Some(sample(stretch.place(x), patch, plane)))
        })?);
    }
    // Crossings on the common side of two parts agree to rounding; other curves keep further apart than this.
    let gap = (JOINED * size).min(0.25 * limit).max(4.0 * noise);
    let mut curves = joined(&rows, gap, tolerance.angle)?;
    let lines = seams::in_plane(surface, &nurbs, &patches, plane, noise.max(IN_PLANE * size))?;
    if !lines.is_empty() {
        curves.extend(lines);
        curves = crate::join_curves(&curves, gap.max(JOINED_LEAST * size), false);
    }
    Ok(SurfaceSection { curves, complete })
}

/// A surface whose derivatives across a patch span less than this part of the square of the longer one has no normal.
const SINGULAR: f64 = 1e-8;

/// The distance of a Bézier patch from a plane, times the weights.
fn heights(index: usize, patch: &NurbsSurface, plane: &Plane) -> Cell {
    let (n, o) = (plane.z_axis, plane.origin);
    let values = patch
        .homogeneous_points()
        .iter()
        // By differences from the plane's origin, which keeps digits far away from that of the world.
        .map(|p| n.x * (p[0] - o.x * p[3]) + n.y * (p[1] - o.y * p[3]) + n.z * (p[2] - o.z * p[3]))
        .collect();
    let ranges = Direction::BOTH.map(|d| {
        let domain = patch.domain(d);
        [domain.start, domain.end]
    });
    Cell::new(index, ranges, patch.counts(), values)
}

/// The point of the section at a place, and its direction either way.
fn sample([u, v]: [f64; 2], patch: &NurbsSurface, plane: &Plane) -> Sample {
    let jet = patch.derivatives(u, v, 1, Quadrant::NorthEast);
    let [su, sv] = Direction::BOTH.map(|d| {
        let [i, j] = if d == Direction::U { [1, 0] } else { [0, 1] };
        jet.get(i, j) * patch.domain(d).length()
    });
    let normal = su.cross(sv);
    let direction = normal.cross(plane.z_axis);
    // In a pole what is left of a normal is rounding.
    let told = direction.length() > CUTS * normal.length()
        && normal.length() > SINGULAR * su.length().max(sv.length()).powi(2);
    Sample { point: jet.point(), direction: if told { direction.unitized() } else { None } }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::surface_plane;
    use crate::{
        Circle, Curve, Cylinder, Interval, NurbsCurve, NurbsSurface, Plane, PlaneSurface, Point3, Sphere,
        SumSurface, Surface, Tolerance, Torus, Vector3,
    };

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn cut(surface: &Surface, plane: &Plane) -> Vec<Curve> {
        let section = surface_plane(surface, plane, &Tolerance::default()).unwrap();
        assert!(section.complete);
        for curve in &section.curves {
            let domain = curve.domain();
            for k in 0..=60 {
                let q = curve.point_at(domain.at(f64::from(k) / 60.0));
                assert!(plane.signed_distance(q).abs() < 1e-3, "{q:?}");
                assert!(surface.closest_point(q).unwrap().distance < 1e-3, "{q:?}");
            }
        }
        section.curves
    }

    fn length(curves: &[Curve]) -> f64 {
        curves.iter().map(Curve::length).sum()
    }

    fn tilted(h: f64, n: Vector3) -> Plane {
        Plane::from_normal(Point3::ORIGIN, n).unwrap().offset(h)
    }

    #[test]
    fn spheres_have_circles() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 5.0).unwrap().into();
        // Level, through the poles along the seam, along a knot line, between, and aslant.
        for n in
            [Vector3::Z, Vector3::Y, Vector3::X, Vector3::new(1.0, 1.0, 0.0), Vector3::new(1.0, 2.0, 3.0)]
        {
            for h in [0.0, 3.0, -4.0] {
                let curves = cut(&ball, &tilted(h, n));
                let want = TAU * (25.0 - h * h).sqrt();
                assert!(
                    (length(&curves) - want).abs() < 2e-3,
                    "{n:?} {h}: {} {want} {}",
                    length(&curves),
                    curves.len()
                );
                assert_eq!(curves.len(), 1, "{n:?} {h}");
                assert!(curves[0].is_closed(), "{n:?} {h}");
            }
            assert!(cut(&ball, &tilted(5.1, n)).is_empty());
            assert!(cut(&ball, &tilted(5.0, n)).is_empty());
        }
        let [circle] = &cut(&ball, &tilted(3.0, Vector3::new(1.0, 2.0, 3.0)))[..] else { panic!("one") };
        assert!((circle.as_circle(1e-6).unwrap().radius - 4.0).abs() < 1e-9);
    }

    #[test]
    fn cylinders_and_tori() {
        let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 10.0)).unwrap().into();
        for z in [0.0, 10.0, 5.0, 3.3] {
            let curves = cut(&tube, &Plane::XY.offset(z));
            assert!(curves.len() == 1 && curves[0].is_closed(), "{z} {}", curves.len());
            assert!((length(&curves) - 2.0 * TAU).abs() < 1e-9, "{z}");
        }
        // Along the axis: two lines; aslant: an ellipse.
        let lines = cut(&tube, &Plane::YZ.offset(1.0));
        assert!(lines.len() == 2 && lines.iter().all(|l| matches!(l, Curve::Line(_))), "{lines:?}");
        assert!((length(&lines) - 20.0).abs() < 1e-9);
        let slant = Plane::from_normal(p(0.0, 0.0, 5.0), Vector3::new(1.0, 0.0, 1.0)).unwrap();
        let ellipse = cut(&tube, &slant);
        let want = crate::Ellipse::new(Plane::XY, 8f64.sqrt(), 2.0).unwrap().to_nurbs().unwrap();
        assert!(ellipse.len() == 1 && (length(&ellipse) - Curve::from(want).length()).abs() < 1e-3);
        let ring: Surface = Torus::new(Plane::XY, 5.0, 2.0).unwrap().into();
        assert!((length(&cut(&ring, &Plane::XY)) - TAU * 10.0).abs() < 1e-6);
        assert_eq!(cut(&ring, &Plane::YZ).len(), 2);
        assert_eq!(cut(&ring, &Plane::YZ.offset(2.5)).len(), 2);
        assert_eq!(cut(&ring, &Plane::YZ.offset(3.5)).len(), 1);
        // Villarceau: the plane touches twice, and cuts two circles of radius 5.
        let villarceau = tilted(0.0, Vector3::new(-2.0, 0.0, 21f64.sqrt()));
        assert!((length(&cut(&ring, &villarceau)) - 2.0 * TAU * 5.0).abs() < 0.05);
    }

    #[test]
    fn flat_surfaces() {
        let side = Interval::new(0.0, 4.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let diagonal = Plane::from_normal(p(2.0, 2.0, 0.0), Vector3::new(1.0, 1.0, 0.0)).unwrap();
        let [Curve::Line(line)] = &cut(&flat, &diagonal)[..] else { panic!("a line") };
        assert!((line.line.length() - 32f64.sqrt()).abs() < 1e-9);
        // A side in the plane, and the whole surface.
        assert!((length(&cut(&flat, &Plane::YZ)) - 4.0).abs() < 1e-9);
        assert!((length(&cut(&flat, &Plane::XY)) - 16.0).abs() < 1e-9);
        assert!(cut(&flat, &Plane::XY.offset(0.1)).is_empty());
    }

    #[test]
    fn freeform_surfaces() {
        let n = 7;
        let points: Vec<Point3> = (0..n * n)
            .map(|k| {
                let (i, j) = ((k / n) as f64, (k % n) as f64);
                p(i, j, 1.5 * (1.3 * i).sin() * (1.1 * j + 0.4).cos())
            })
            .collect();
        let knots = || crate::clamped_uniform_knots(3, n).unwrap();
        let surface: Surface = NurbsSurface::new([3, 3], [n, n], points, [knots(), knots()]).unwrap().into();
        // Islands and bays: what is open ends on the sides.
        for h in [-0.3, 0.05, 0.25, 0.4] {
            let curves = cut(&surface, &Plane::XY.offset(h));
            assert!(!curves.is_empty());
            for curve in &curves {
                let open = !curve.is_closed();
                if open {
                    for q in [curve.start(), curve.end()] {
                        let at = surface.closest_point(q).unwrap();
                        let domain = surface.domain(crate::Direction::U);
                        let near = |t: f64| (t - domain.start).abs() < 1e-3 || (t - domain.end).abs() < 1e-3;
                        assert!(near(at.u) || near(at.v), "{h} {at:?}");
                    }
                }
            }
        }
        // Every change of side along isocurves has a curve there.
        let plane = Plane::XY.offset(0.1);
        let curves = cut(&surface, &plane);
        for k in 1..12 {
            let iso = surface.isocurve(crate::Direction::U, 4.0 * f64::from(k) / 12.0).unwrap();
            for t in iso.intersect_plane(&plane, 1e-9).unwrap() {
                let q = iso.point_at(t);
                let miss = curves.iter().map(|c| c.closest_point(q).unwrap().distance).fold(9.0, f64::min);
                assert!(miss < 1e-3, "{q:?} {miss}");
            }
        }
    }

    #[test]
    fn creases_stay() {
        let corner =
            crate::PolylineCurve::new(vec![p(0.0, 0.0, 0.0), p(3.0, 0.0, 0.0), p(3.0, 4.0, 0.0)]).unwrap();
        let wall: Surface = SumSurface::extrusion(corner.into(), Vector3::new(0.0, 0.0, 5.0)).unwrap().into();
        for z in [0.0, 2.0, 2.5] {
            let curves = cut(&wall, &Plane::XY.offset(z));
            assert!(curves.len() == 1 && (curves[0].length() - 7.0).abs() < 1e-9, "{z} {curves:?}");
            assert_eq!(curves[0].as_polyline().map(|l| l.len()), Some(3), "{z} {curves:?}");
        }
        let spline = NurbsCurve::clamped_uniform(
            3,
            &[p(0.0, 0.0, 0.0), p(1.0, 4.0, 0.0), p(5.0, -3.0, 0.0), p(7.0, 0.0, 0.0)],
        );
        let spline: Curve = spline.unwrap().into();
        let wall: Surface =
            SumSurface::extrusion(spline.clone(), Vector3::new(0.0, 0.0, 5.0)).unwrap().into();
        assert!((length(&cut(&wall, &Plane::XY.offset(1.0))) - spline.length()).abs() < 1e-3);
        let half: Curve =
            crate::Arc::new(Circle::new(Plane::XY, 1.0).unwrap(), Interval::new(0.0, PI)).unwrap().into();
        let tunnel: Surface = SumSurface::extrusion(half, Vector3::new(0.0, 0.0, 5.0)).unwrap().into();
        assert_eq!(cut(&tunnel, &Plane::XZ).len(), 2);
    }
}
