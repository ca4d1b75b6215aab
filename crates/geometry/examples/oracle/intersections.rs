//! Intersections with a closed form.

use katydid_geometry::{BoundingBox, Circle, Line, Plane, Point3, intersect};
use serde_json::Value;

use crate::read::{self, Read};
use crate::report::{Case, EVALUATION};

/// Random cases are never tangent to within this.
const TOUCH: f64 = 1e-10;

pub(crate) fn compare(v: &Value, case: &mut Case) -> Read<()> {
    let (input, out) = (&v["in"], &v["out"]);
    match read::text(&input["f"])? {
        "LineLine" => line_line(input, out, case),
        "LinePlane" => {
            let (line, plane) = (read::line(&input["a"])?, read::plane(&input["plane"])?);
            let got = intersect::line_plane(&line, &plane);
            case.equal("found", got.is_some(), read::truth(&out[0])?);
            if let Some(t) = got {
                let sin = line.unit_direction().map_or(1.0, |d| d.dot(plane.z_axis).abs());
                let want = read::number(&out[1])?;
                case.number(
                    "t",
                    t,
                    want,
                    want.abs().max(1.0) + magnitude(&line) / sin / line.length(),
                    EVALUATION,
                );
            }
            Ok(())
        }
        "PlanePlane" => plane_plane(input, out, case),
        "PlanePlanePlane" => {
            let planes: Vec<Plane> = read::list(&input["p"])?.iter().map(read::plane).collect::<Read<_>>()?;
            let [a, b, c] = planes.as_slice() else { return Err("not three planes".into()) };
            let got = intersect::three_planes(a, b, c);
            case.equal("found", got.is_some(), read::truth(&out[0])?);
            if let Some(p) = got {
                let volume = a.z_axis.dot(b.z_axis.cross(c.z_axis)).abs();
                let size = planes.iter().map(|p| p.origin.to_vector().length()).fold(0.0, f64::max);
                // The error of a normal moves the point by its distance over the volume.
                case.point("point", p, read::point(&out[1])?, size / (volume * volume), EVALUATION);
            }
            Ok(())
        }
        "LineCircle" => line_circle(input, out, case),
        "LineSphere" => line_sphere(input, out, case),
        "PlaneSphere" => {
            let (plane, center) = (read::plane(&input["plane"])?, read::point(&input["c"])?);
            let got = intersect::plane_sphere(&plane, center, read::number(&input["r"])?, TOUCH);
            section(got, out, case)
        }
        "SphereSphere" => {
            let sphere = |v: &Value| Ok::<_, String>((read::point(&v[0])?, read::number(&v[1])?));
            let got = intersect::sphere_sphere(sphere(&input["a"])?, sphere(&input["b"])?, TOUCH);
            section(got, out, case)
        }
        "LineBox" => {
            let line = read::line(&input["a"])?;
            let bounds = BoundingBox { min: read::point(&input["min"])?, max: read::point(&input["max"])? };
            let got = intersect::line_bounding_box(&line, &bounds, 0.0);
            case.equal("found", got.is_some(), read::truth(&out[0])?);
            if let Some(got) = got {
                let want = read::interval(&out[1])?;
                let scale = want.start.abs().max(want.end.abs()).max(1.0);
                case.numbers("t", &[got.start, got.end], &[want.start, want.end], scale, EVALUATION);
            }
            Ok(())
        }
        other => Err(format!("{other} is no intersection that is known")),
    }
}

fn magnitude(line: &Line) -> f64 {
    line.from.to_vector().length().max(line.to.to_vector().length())
}

/// The number of solutions that the name of an answer stands for, such as `LineCircleIntersection.Multiple`.
fn count(v: &Value) -> Read<usize> {
    match read::text(v)?.rsplit('.').next() {
        Some("None") => Ok(0),
        Some("Single" | "Point") => Ok(1),
        Some("Multiple" | "Circle") => Ok(2),
        _ => Err(format!("{v} is no count that is known")),
    }
}

fn line_line(input: &Value, out: &Value, case: &mut Case) -> Read<()> {
    let (a, b) = (read::line(&input["a"])?, read::line(&input["b"])?);
    let got = intersect::line_line(&a, &b);
    case.equal("found", got.is_some(), read::truth(&out[0])?);
    if let Some((s, t)) = got {
        let (u, v) = (a.unit_direction().unwrap_or_default(), b.unit_direction().unwrap_or_default());
        // Nearly parallel lines lose digits with the square of the sine between them.
        let sin = u.cross(v).length();
        let reach = a.from.distance_to(b.from).max(a.length()).max(b.length());
        let scale = |l: &Line| 1.0_f64.max(reach / l.length()) / (sin * sin);
        case.number("s", s, read::number(&out[1])?, scale(&a), EVALUATION);
        case.number("t", t, read::number(&out[2])?, scale(&b), EVALUATION);
    }
    Ok(())
}

fn plane_plane(input: &Value, out: &Value, case: &mut Case) -> Read<()> {
    let (a, b) = (read::plane(&input["a"])?, read::plane(&input["b"])?);
    let got = intersect::plane_plane(&a, &b);
    case.equal("found", got.is_some(), read::truth(&out[0])?);
    if let Some(line) = got {
        let sin = a.z_axis.cross(b.z_axis).length();
        let size = a.origin.to_vector().length().max(b.origin.to_vector().length()) / (sin * sin);
        case.point("from", line.from, read::point(&out[1])?, size, EVALUATION);
        case.point("to", line.to, read::point(&out[2])?, size, EVALUATION);
    }
    Ok(())
}

fn line_circle(input: &Value, out: &Value, case: &mut Case) -> Read<()> {
    let line = read::line(&input["a"])?;
    let Some(circle) =
        case.made("circle", Circle::new(read::plane(&input["plane"])?, read::number(&input["r"])?))
    else {
        return Ok(());
    };
    let got = intersect::line_circle(&line, &circle, TOUCH);
    case.equal("count", got.count(), count(&out[0])?);
    // Without a solution the reference gives what its search ended with, which has no meaning.
    for (i, hit) in got.iter().enumerate() {
        let size = magnitude(&line) + circle.radius + circle.center().to_vector().length();
        let (t, p) = (read::number(&out[1 + 2 * i])?, read::point(&out[2 + 2 * i])?);
        case.number("t", hit.on_line, t, 1.0_f64.max(size / line.length()), EVALUATION);
        case.point("on the line", line.at(hit.on_line), p, size, EVALUATION);
        case.point("on the circle", circle.at(hit.angle), p, size, EVALUATION);
    }
    Ok(())
}

fn line_sphere(input: &Value, out: &Value, case: &mut Case) -> Read<()> {
    let (line, center, radius) =
        (read::line(&input["a"])?, read::point(&input["c"])?, read::number(&input["r"])?);
    let got = intersect::line_sphere(&line, center, radius, TOUCH);
    case.equal("count", got.count(), count(&out[0])?);
    let size = magnitude(&line) + radius + center.to_vector().length();
    if got.count() == 0 {
        // The reference gives the nearest points of the line and of the sphere.
        let on_line = line.at(line.closest_parameter(center));
        let outward = (on_line - center).unitized().unwrap_or_default();
        case.point("nearest on the line", on_line, read::point(&out[1])?, size, EVALUATION);
        case.point(
            "nearest on the sphere",
            center + outward * radius,
            read::point(&out[2])?,
            size,
            EVALUATION,
        );
    }
    // The order of the two is not said by the reference.
    let mut want: Vec<Point3> = vec![read::point(&out[1])?, read::point(&out[2])?];
    want.sort_by(|p, q| line.closest_parameter(*p).total_cmp(&line.closest_parameter(*q)));
    for (t, want) in got.iter().zip(want) {
        case.point("point", line.at(t), want, size, EVALUATION);
    }
    Ok(())
}

fn section(got: intersect::SphereSection, out: &Value, case: &mut Case) -> Read<()> {
    use intersect::SphereSection::{Circle, None, Point, Same};
    let found = match got {
        None => 0,
        Point(_) => 1,
        Circle(_) => 2,
        Same => 3,
    };
    case.equal("kind", found, count(&out[0])?);
    if let Circle(circle) = got {
        let (plane, radius) = (read::plane(&out[1])?, read::number(&out[2])?);
        let size = circle.center().to_vector().length() + 10.0;
        // A small circle has a radius with fewer digits.
        case.number("radius", circle.radius, radius, size * size / radius, EVALUATION);
        case.point("center", circle.center(), plane.origin, size, EVALUATION);
        case.vector("x", circle.plane.x_axis, plane.x_axis, 1.0, EVALUATION);
        case.vector("y", circle.plane.y_axis, plane.y_axis, 1.0, EVALUATION);
        case.vector("z", circle.plane.z_axis, plane.z_axis, 1.0, EVALUATION);
    }
    Ok(())
}
