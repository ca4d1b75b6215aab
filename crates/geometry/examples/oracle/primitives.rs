//! Spheres, cylinders, revolutions, extrusions and ruled surfaces. Boxes and what the files say about breps belong to
//! solids.

use katydid_geometry::{
    Curve, Cylinder, Direction, Interval, Line, NurbsSurface, Point3, Result, RevolutionSurface, Sphere,
    SumSurface, Surface, Vector3,
};
use serde_json::Value;

use crate::read::{self, Read};
use crate::report::{Case, EVALUATION};
use crate::surfaces::same_surface;

pub(crate) fn compare(v: &Value, case: &mut Case) -> Read<()> {
    let input = &v["in"];
    let kind = read::text(&input["f"])?;
    let Some(made) = constructed(kind, input)? else {
        // Only a brep: nothing of it is a surface's.
        case.equal("kind", kind, "Box");
        return Ok(());
    };
    let Some(surface) = case.made("construction", made) else { return Ok(()) };
    for (field, want) in v["out"].as_object().ok_or("no answers in the case")? {
        one(&surface, input, field, want, case)?;
    }
    Ok(())
}

fn constructed(kind: &str, input: &Value) -> Read<Option<Result<Surface>>> {
    let turn = Interval::new(0.0, std::f64::consts::TAU);
    let number = |name: &str| read::number(&input[name]);
    Ok(Some(match kind {
        "Sphere" => Sphere::around(read::point(&input["c"])?, number("r")?).map(Into::into),
        "Cylinder" => {
            let height = Interval::new(0.0, number("h")?);
            Cylinder::new(read::plane(&input["plane"])?, number("r")?, height).map(Into::into)
        }
        "RevSurface caps" => {
            let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
            RevolutionSurface::new(read::curve(&input["profile"])?.into(), axis, turn).map(Into::into)
        }
        "Extrusion.Create circle" => {
            let height = number("h")?;
            katydid_geometry::Circle::from_normal(read::point(&input["c"])?, Vector3::Z, number("r")?)
                .and_then(|c| c.to_nurbs())
                .and_then(|c| SumSurface::extrusion(Curve::from(c), Vector3::Z * height))
                .map(Into::into)
        }
        "CreateRuledSurface" => {
            NurbsSurface::ruled(&read::curve(&input["a"])?, &read::curve(&input["b"])?).map(Into::into)
        }
        "Box" => return Ok(None),
        other => return Err(format!("{other} is no primitive that is known")),
    }))
}

fn one(surface: &Surface, input: &Value, field: &str, want: &Value, case: &mut Case) -> Read<()> {
    match field {
        "brep" => {}
        "Nurbs" => {
            if let Some(got) = case.made(field, surface.to_nurbs()) {
                same_surface(field, &got, want, None, case)?;
            }
        }
        "Domain" => {
            for (d, want) in Direction::BOTH.into_iter().zip(read::list(want)?) {
                let (got, want) = (surface.domain(d), read::interval(want)?);
                case.numbers(field, &[got.start, got.end], &[want.start, want.end], 1.0, EVALUATION);
            }
        }
        "PointAt" => {
            // One answer, or several.
            let answers = if want[0].is_array() { read::list(want)?.clone() } else { vec![want.clone()] };
            for a in answers {
                let got = surface.point_at(read::number(&a[0])?, read::number(&a[1])?);
                case.point(field, got, read::point(&a[2])?, 1.0, EVALUATION);
            }
        }
        "IsSphere" => case.equal(field, surface.as_sphere(1e-9).is_some(), read::truth(want)?),
        "IsCylinder" => case.equal(field, surface.as_cylinder(1e-9).is_some(), read::truth(want)?),
        "ClosestPoint" | "ClosestParameter" => {
            let Some(sphere) =
                case.made("sphere", Sphere::around(read::point(&input["c"])?, read::number(&input["r"])?))
            else {
                return Ok(());
            };
            let q = read::point(&input["q"])?;
            if field == "ClosestPoint" {
                let (got, want) = (sphere.closest_point(q), read::point(want)?);
                case.number(field, (got.distance_to(q) - want.distance_to(q)).max(0.0), 0.0, 1.0, 1e-9);
                case.point(
                    field,
                    got,
                    want,
                    sphere.center().to_vector().length() + sphere.radius,
                    EVALUATION,
                );
            } else {
                let got = sphere.closest_parameters(q);
                case.equal(field, got.is_some(), read::truth(&want[0])?);
                if let Some((u, v)) = got {
                    let near = 10.0 / q.distance_to(sphere.center());
                    case.number("longitude", u, read::number(&want[1])?, near.max(7.0), EVALUATION);
                    case.number("latitude", v, read::number(&want[2])?, near.max(7.0), EVALUATION);
                }
            }
        }
        _ => case.miss(field, "a field that is not known".into()),
    }
    Ok(())
}
