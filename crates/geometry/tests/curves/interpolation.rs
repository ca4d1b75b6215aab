//! Curves through points: every degree, tangents at the ends, closed ones.

use katydid_geometry::{Curve, KnotSpacing, NurbsCurve, Point3, Vector3};

fn points(n: usize) -> Vec<Point3> {
    (0..n)
        .map(|i| i as f64)
        .map(|t| Point3::new(t + 0.3 * (2.1 * t).sin(), 3.0 * (0.9 * t).sin(), (0.7 * t).cos()))
        .collect()
}

const SPACINGS: [KnotSpacing; 3] = [KnotSpacing::Uniform, KnotSpacing::Chord, KnotSpacing::SquareRootChord];

/// Every point lies on the curve, and they lie there in order.
fn goes_through(c: &NurbsCurve, points: &[Point3], what: &str) {
    let curve: Curve = c.clone().into();
    let size = points.iter().fold(1.0_f64, |m, p| m.max(p.to_vector().length()));
    for p in points {
        let found = curve.closest_point(*p).unwrap();
        assert!(found.distance < 1e-9 * size, "{what}: {p:?} is {} off", found.distance);
    }
}

#[test]
fn every_degree_with_and_without_tangents() {
    let (start, end) = (Vector3::new(0.0, 2.0, 1.0), Vector3::new(1.0, 0.0, -1.0));
    for degree in [2, 3, 4, 5, 7, 9] {
        for n in [2, 5, 12, 60] {
            for spacing in SPACINGS {
                for tangents in 0..4 {
                    let (a, b) = ((tangents & 1 > 0).then_some(start), (tangents & 2 > 0).then_some(end));
                    let given = usize::from(a.is_some()) + usize::from(b.is_some());
                    let made = NurbsCurve::interpolate(degree, &points(n), spacing, a, b);
                    if degree != 3 && n + given <= degree {
                        assert!(made.is_err());
                        continue;
                    }
                    let c = made.unwrap();
                    let what = format!("degree {degree}, {n} points, {spacing:?}, tangents {tangents}");
                    goes_through(&c, &points(n), &what);
                    let domain = c.domain();
                    for (wanted, t, below) in [(a, domain.start, false), (b, domain.end, true)] {
                        let Some(wanted) = wanted.and_then(Vector3::unitized) else { continue };
                        let unit = c.derivatives(t, 1, below).1[0].unitized().unwrap();
                        assert!((unit - wanted).length() < 1e-9, "{what}: {unit:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn closed_curves_of_every_degree() {
    let ring: Vec<Point3> = (0..11)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 11.0)
        .map(|a| Point3::new(5.0 * a.cos() + (3.0 * a).sin(), 3.0 * a.sin(), (2.0 * a).cos()))
        .collect();
    for degree in [1, 2, 3, 4, 5, 6, 7] {
        for spacing in SPACINGS {
            for n in [10, 11] {
                let c = NurbsCurve::interpolate_periodic(degree, &ring[..n], spacing).unwrap();
                goes_through(&c, &ring[..n], &format!("degree {degree}, {n} points, {spacing:?}"));
                assert!(degree == 1 || c.is_periodic());
                let domain = c.domain();
                assert!(c.point_at(domain.start).distance_to(c.point_at(domain.end)) < 1e-10);
            }
        }
    }
}

#[test]
fn many_points() {
    let many = points(5_000);
    for degree in [2, 3, 5] {
        let c = NurbsCurve::interpolate(degree, &many, KnotSpacing::Chord, None, None).unwrap();
        // Chord lengths are the parameters.
        let mut t = 0.0;
        for w in many.windows(2) {
            assert!(c.point_at(t).distance_to(w[0]) < 1e-8, "degree {degree} at {t}");
            t += w[0].distance_to(w[1]);
        }
    }
}
