//! Surface / Primitive: spheres by points.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Matrix, Plane, Point3, Sphere, Surface, intersect};

use super::primitive::sphere_surface;
use super::warning;

/// The sphere through four points.
///
/// Points in one plane have none: a warning.
#[component(
    "b083c06d-9a71-4f40-b354-1d80bba1e858",
    name = "Sphere 4Pt",
    nick = "Sph4Pt",
    at = "Surface/Primitive"
)]
#[output("Center", "C", "Its centre.")]
#[output("Radius", "R", "Its radius.")]
#[output("Sphere", "S", "The sphere.")]
fn sphere_4pt(
    /// A point.
    #[port("Point 1", "P1")]
    a: Point3,
    /// Another point.
    #[port("Point 2", "P2")]
    b: Point3,
    /// A third point, not in line with them.
    #[port("Point 3", "P3")]
    c: Point3,
    /// A fourth point, not in one plane with them.
    #[port("Point 4", "P4")]
    d: Point3,
) -> Result<(Point3, f64, Shared<Surface>), Message> {
    // The centre lies in the planes halfway between the first point and the others.
    let halfway = |p: Point3| Plane::from_normal(a.lerp(p, 0.5), p - a);
    let center = match (halfway(b), halfway(c), halfway(d)) {
        (Ok(p), Ok(q), Ok(r)) => intersect::three_planes(&p, &q, &r),
        _ => None,
    };
    let center = center.ok_or_else(|| Message::warning("No sphere goes through four points of a plane"))?;
    let sphere = Sphere::around(center, center.distance_to(a)).map_err(warning)?;
    Ok((center, sphere.radius, sphere_surface(sphere)?))
}

/// The sphere nearest to points: the sum of the squares of their distances from it is the smallest.
///
/// At least four points that are not in one plane are needed.
#[component(
    "e7ffb3af-2d77-4804-a260-755308bf8285",
    name = "Sphere Fit",
    nick = "SFit",
    at = "Surface/Primitive"
)]
#[output("Center", "C", "Its centre.")]
#[output("Radius", "R", "Its radius.")]
#[output("Sphere", "S", "The sphere.")]
fn sphere_fit(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<(Point3, f64, Shared<Surface>), Message> {
    let points: Vec<Point3> = points.present().filter(|p| p.is_finite()).collect();
    let found = fit(context, &points)?;
    let sphere =
        found.ok_or_else(|| Message::warning("The points lie in a plane, or are fewer than four"))?;
    Ok((sphere.center(), sphere.radius, sphere_surface(sphere)?))
}

/// Starts with the sphere that is nearest in |p − c|² − r², whose equations are linear, and improves it by
/// Gauss–Newton steps on the distances themselves.
pub(crate) fn fit(context: &Context<'_>, points: &[Point3]) -> Result<Option<Sphere>, Message> {
    if points.len() < 4 {
        return Ok(None);
    }
    // Measured from their middle in their own size, so that the equations are well scaled.
    let n = points.len() as f64;
    let middle = points.iter().fold(Point3::ORIGIN, |sum, p| sum + p.to_vector() / n);
    let size = points.iter().map(|p| p.distance_to(middle)).fold(0.0, f64::max);
    if !(size > 0.0 && size.is_finite()) {
        return Ok(None);
    }
    // Points in a plane or on a line have no nearest sphere.
    if !Plane::fit(points).is_ok_and(|(_, off)| off > 1e-9 * size) {
        return Ok(None);
    }
    let local: Vec<[f64; 3]> = points.iter().map(|p| ((*p - middle) / size).into()).collect();
    let rows = local.iter().map(|&[x, y, z]| ([x, y, z, 1.0], x * x + y * y + z * z));
    let Some([a, b, c, d]) = least_squares(rows)? else { return Ok(None) };
    let mut center = [a / 2.0, b / 2.0, c / 2.0];
    let mut radius = (d + (a * a + b * b + c * c) / 4.0).sqrt();
    for _ in 0..64 {
        context.check()?;
        let rows = local.iter().filter_map(|p| {
            let v = [0, 1, 2].map(|i| p[i] - center[i]);
            let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
            (length > 0.0).then(|| ([v[0] / length, v[1] / length, v[2] / length, 1.0], length - radius))
        });
        let Some(step) = least_squares(rows)? else { break };
        (0..3).for_each(|i| center[i] += step[i]);
        radius += step[3];
        if step.iter().all(|s| s.abs() < 1e-14) {
            break;
        }
    }
    let center = middle + katydid_geometry::Vector3::from(center) * size;
    Ok(Sphere::around(center, radius * size).ok())
}

/// The solution of an overdetermined system of four unknowns by its normal equations, when it has one.
fn least_squares(rows: impl Iterator<Item = ([f64; 4], f64)>) -> Result<Option<[f64; 4]>, Message> {
    let (mut left, mut right) = ([0.0; 16], [0.0; 4]);
    for (row, value) in rows {
        for (i, a) in row.iter().enumerate() {
            right[i] += a * value;
            for (j, b) in row.iter().enumerate() {
                left[4 * i + j] += a * b;
            }
        }
    }
    let solved = Matrix::new(4, 4, left.to_vec())?.solve(&Matrix::new(4, 1, right.to_vec())?, 1e-12)?;
    Ok(solved.and_then(|s| <[f64; 4]>::try_from(s.values()).ok()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Point3, Sphere};

    #[test]
    fn spheres_by_points() {
        let ball = Sphere::around(Point3::new(100.0, -2.0, 3.0), 5.0).unwrap();
        let on: Vec<Point3> = [(0.1, 0.2), (1.5, -0.9), (3.0, 0.4), (4.4, 1.2), (5.0, -0.3), (2.0, 0.9)]
            .map(|(u, v)| ball.point_at(u, v))
            .to_vec();
        let four = || (0..4).fold(Trial::of("Sphere 4Pt"), |trial, i| trial.item(on[i]));
        assert_eq!(four().texts(0), ["{0}: {100, -2, 3}"]);
        assert_eq!(four().texts(1), ["{0}: 5"]);
        assert_eq!(four().texts(2), ["{0}: Untrimmed Surface"]);
        let fit = || Trial::of("Sphere Fit").list(on.clone());
        assert_eq!(fit().texts(0), ["{0}: {100, -2, 3}"]);
        assert_eq!(fit().texts(1), ["{0}: 5"]);
        let flat =
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.3, 0.3]].map(|[x, y]| Point3::new(x, y, 2.0));
        assert!(Trial::of("Sphere Fit").list(flat).message().contains("plane"));
        let four = flat[..4].iter().fold(Trial::of("Sphere 4Pt"), |trial, p| trial.item(*p));
        assert!(four.message().contains("plane"));
        assert!(Trial::of("Sphere Fit").list([Point3::ORIGIN; 4]).message().contains("plane"));
    }

    #[test]
    fn a_fit_balances_distances_inside_and_outside() {
        // Six points on the axes at distance 1, and six at 3: by symmetry the radius is the mean.
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let all = axes
            .iter()
            .flat_map(|a| [1.0, -1.0, 3.0, -3.0].map(|s| Point3::new(s * a[0], s * a[1], s * a[2])));
        let fit: Vec<Point3> = all.collect();
        assert_eq!(Trial::of("Sphere Fit").list(fit).texts(1), ["{0}: 2"]);
    }
}
