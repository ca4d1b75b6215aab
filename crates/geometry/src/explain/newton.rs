//! Newton's method for the nearest point.

use super::thresholds::{MOST_STEPS, SMALLEST_STEP, STARTS};
use super::{Algorithm, Explanation, Quantity, Round, Step};
use crate::{Curve, Direction, Error, Interval, Point3, Quadrant, Result, Surface, Vector3};

fn told(name: String, rule: &str, values: &[f64]) -> Step {
    Step { made: Quantity::measured(name, values), rule: rule.to_owned(), terms: Vec::new() }
}

fn finite(p: Point3) -> Result<()> {
    if [p.x, p.y, p.z].iter().all(|x| x.is_finite()) { Ok(()) } else { Err(Error::NotFinite("the point")) }
}

/// So many places of a domain, both ends among them.
fn places(domain: Interval, count: usize) -> impl Iterator<Item = f64> {
    #[allow(clippy::cast_precision_loss, reason = "a count of a few hundred")]
    let part = move |k: usize| k as f64 / (count - 1) as f64;
    (0..count).map(move |k| domain.start + (domain.end - domain.start) * part(k))
}

/// The first place of those with the smallest value.
fn smallest<T: Copy>(places: impl Iterator<Item = (T, f64)>) -> Option<T> {
    places
        .fold(None, |best: Option<(T, f64)>, (place, value)| match best {
            Some((_, least)) if !(value < least) => best,
            _ => Some((place, value)),
        })
        .map(|(place, _)| place)
}

/// The point of a curve that is nearest to P, from the nearest of evenly spaced parameters on: where f(t) = (C(t) − P)·C′(t)
/// is 0 the line to P is perpendicular to the curve, and each step goes to where the tangent of f is 0. At an end of the
/// domain it stops, as it does where f′ is not positive and the step would lead away.
///
/// # Errors
/// The point is not finite.
///
/// Source: Piegl and Tiller, *The NURBS Book*, 2nd edition, section 6.1.
pub fn newton_on_curve(curve: &Curve, point: Point3) -> Result<Explanation> {
    finite(point)?;
    let domain = curve.domain();
    let starts = places(domain, STARTS.0).map(|t| (t, (curve.point_at(t) - point).length()));
    let mut t = smallest(starts).unwrap_or(domain.start);
    let given = vec![Quantity::given("P", &[point.x, point.y, point.z]), Quantity::measured("t0", &[t])];
    let mut rounds = Vec::new();
    for k in 0..MOST_STEPS {
        let (at, derivatives) = curve.derivatives(t, 2, t >= domain.end);
        let [first, second] = [0, 1].map(|i| derivatives.get(i).copied().unwrap_or(Vector3::ZERO));
        let off = at - point;
        let value = off.dot(first);
        let slope = first.dot(first) + off.dot(second);
        let next = if slope > 0.0 { (t - value / slope).clamp(domain.start, domain.end) } else { t };
        rounds.push(Round {
            steps: vec![
                told(format!("C(t{k})"), "", &[at.x, at.y, at.z]),
                told(format!("f(t{k})"), "(C − P)·C′", &[value]),
                told(format!("f′(t{k})"), "C′·C′ + (C − P)·C″", &[slope]),
                told(format!("t{}", k + 1), &format!("t{k} − f / f′"), &[next]),
            ],
        });
        let step = (next - t).abs();
        t = next;
        if !(step > SMALLEST_STEP * (domain.end - domain.start).abs()) {
            break;
        }
    }
    let at = curve.point_at(t);
    let result = vec![
        Quantity::measured("t", &[t]),
        Quantity::measured("C(t)", &[at.x, at.y, at.z]),
        Quantity::measured("distance", &[(at - point).length()]),
    ];
    Ok(Explanation { algorithm: Algorithm::Newton, given, rounds, result })
}

/// The point of a surface that is nearest to P, from the nearest of a grid of parameters on: where f = (S − P)·Su and
/// g = (S − P)·Sv are 0 the line to P is perpendicular to the surface; each step solves their linear parts.
///
/// # Errors
/// The point is not finite.
///
/// Source: Piegl and Tiller, *The NURBS Book*, 2nd edition, section 6.1.
pub fn newton_on_surface(surface: &Surface, point: Point3) -> Result<Explanation> {
    finite(point)?;
    let [du, dv] = [Direction::U, Direction::V].map(|direction| surface.domain(direction));
    let grid = places(du, STARTS.1).flat_map(|u| places(dv, STARTS.1).map(move |v| (u, v)));
    let starts = grid.map(|(u, v)| ((u, v), (surface.point_at(u, v) - point).length()));
    let (mut u, mut v) = smallest(starts).unwrap_or((du.start, dv.start));
    let given =
        vec![Quantity::given("P", &[point.x, point.y, point.z]), Quantity::measured("(u0, v0)", &[u, v])];
    let mut rounds = Vec::new();
    for k in 0..MOST_STEPS {
        let all = surface.derivatives(u, v, 2, Quadrant::NorthEast);
        let of = |i, j| all.get(i, j);
        let at = surface.point_at(u, v);
        let off = at - point;
        let (su, sv) = (of(1, 0), of(0, 1));
        let (f, g) = (off.dot(su), off.dot(sv));
        let fu = su.dot(su) + off.dot(of(2, 0));
        let fv = su.dot(sv) + off.dot(of(1, 1));
        let gv = sv.dot(sv) + off.dot(of(0, 2));
        let det = fu * gv - fv * fv;
        // Where the matrix is not positive the step leads away from a nearest point.
        let is_good = fu > 0.0 && det > 0.0;
        let (nu, nv) =
            if is_good { (u - (f * gv - g * fv) / det, v - (g * fu - f * fv) / det) } else { (u, v) };
        let (nu, nv) = (nu.clamp(du.start, du.end), nv.clamp(dv.start, dv.end));
        rounds.push(Round {
            steps: vec![
                told(format!("S(u{k}, v{k})"), "", &[at.x, at.y, at.z]),
                told(format!("(f, g) at {k}"), "((S − P)·Su, (S − P)·Sv)", &[f, g]),
                told(format!("(fu, fv, gv) at {k}"), "", &[fu, fv, gv]),
                told(format!("(u{0}, v{0})", k + 1), "", &[nu, nv]),
            ],
        });
        let step = ((nu - u) / (du.end - du.start)).abs().max(((nv - v) / (dv.end - dv.start)).abs());
        (u, v) = (nu, nv);
        if !(step > SMALLEST_STEP) {
            break;
        }
    }
    let at = surface.point_at(u, v);
    let result = vec![
        Quantity::measured("(u, v)", &[u, v]),
        Quantity::measured("S(u, v)", &[at.x, at.y, at.z]),
        Quantity::measured("distance", &[(at - point).length()]),
    ];
    Ok(Explanation { algorithm: Algorithm::Newton, given, rounds, result })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Plane, Sphere};

    #[test]
    fn the_nearest_point_of_a_circle() {
        let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
        let told = newton_on_curve(&circle, Point3::new(3.0, 4.0, 0.0)).unwrap();
        let at = &told.result[1].numbers;
        assert!((at[0].value - 1.2).abs() < 1e-12 && (at[1].value - 1.6).abs() < 1e-12);
        assert!((told.result[2].numbers[0].value - 3.0).abs() < 1e-12);
        assert!(newton_on_curve(&circle, Point3::new(f64::NAN, 0.0, 0.0)).is_err());
    }

    #[test]
    fn the_nearest_point_of_a_sphere() {
        let sphere = Surface::from(Sphere::new(Plane::XY, 2.0).unwrap());
        let told = newton_on_surface(&sphere, Point3::new(2.0, 1.0, 2.0)).unwrap();
        let at: Vec<f64> = told.result[1].numbers.iter().map(|n| n.value).collect();
        for (found, expected) in at.iter().zip([4.0 / 3.0, 2.0 / 3.0, 4.0 / 3.0]) {
            assert!((found - expected).abs() < 1e-12, "{at:?}");
        }
        assert!((told.result[2].numbers[0].value - 1.0).abs() < 1e-12);
    }
}
