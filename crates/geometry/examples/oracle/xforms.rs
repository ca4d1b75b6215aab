//! Transforms.

use katydid_geometry::{BoundingBox, Plane, Point3, Xform};
use serde_json::Value;

use crate::curves::boxes;
use crate::read::{self, Read};
use crate::report::{CONSTRUCTION, Case, EVALUATION};

pub(crate) fn compare(v: &Value, case: &mut Case) -> Read<()> {
    let (input, out) = (&v["in"], &v["out"]);
    let m = read::xform(&out["m"])?;
    if let Some(made) = constructed(input)?
        && let Some(made) = case.made("m", made)
    {
        matrices("m", &made, &m, CONSTRUCTION, case);
    }
    for (field, want) in out.as_object().ok_or("no answers in the case")? {
        one(&m, out, field, want, case)?;
    }
    Ok(())
}

/// The matrix of a constructor; `None` where the file gives the matrix only.
fn constructed(input: &Value) -> Read<Option<katydid_geometry::Result<Xform>>> {
    let point = |name: &str| read::point(&input[name]);
    let vector = |name: &str| read::vector(&input[name]);
    let plane = |name: &str| read::plane(&input[name]);
    Ok(Some(match read::text(&input["ctor"])? {
        "Rotation" => Xform::rotation(read::number(&input["angle"])?, vector("axis")?, point("center")?),
        "RotationSinCos" => {
            let (sin, cos) = read::number(&input["angle"])?.sin_cos();
            Xform::rotation_sin_cos(sin, cos, vector("axis")?, point("center")?)
        }
        "RotationVectorToVector" => {
            Xform::rotation_between(vector("start")?, vector("end")?, point("center")?)
        }
        "Translation" => Ok(Xform::translation(vector("v")?)),
        "ScaleUniform" => Ok(Xform::scale(point("anchor")?, read::number(&input["s"])?)),
        "ScalePlane" => {
            let s = point("s")?;
            Ok(Xform::scale_non_uniform(&plane("plane")?, s.x, s.y, s.z))
        }
        "Mirror" => Plane::from_normal(point("point")?, vector("normal")?).map(|p| Xform::mirror(&p)),
        "PlaneToPlane" => Ok(Xform::plane_to_plane(&plane("a")?, &plane("b")?)),
        "ChangeBasis" => Ok(Xform::change_basis(&plane("a")?, &plane("b")?)),
        "PlanarProjection" => Ok(Xform::planar_projection(&plane("plane")?)),
        "Shear" => Ok(Xform::in_frame(&plane("plane")?, vector("x")?, vector("y")?, vector("z")?)),
        "Product" => Ok(read::xform(&input["a"])? * read::xform(&input["b"])?),
        _ => return Ok(None),
    }))
}

fn size(m: &Xform) -> f64 {
    m.rows.iter().flatten().fold(1.0_f64, |a, x| a.max(x.abs()))
}

fn matrices(field: &str, got: &Xform, want: &Xform, tolerance: f64, case: &mut Case) {
    case.numbers(field, got.rows.as_flattened(), want.rows.as_flattened(), size(want), tolerance);
}

fn one(m: &Xform, out: &Value, field: &str, want: &Value, case: &mut Case) -> Read<()> {
    match field {
        // The matrix itself was compared; the point is an input.
        "m" | "pointIn" => {}
        "IsValid" => case.equal(field, m.is_finite(), read::truth(want)?),
        "IsAffine" => case.equal(field, m.is_affine(), read::truth(want)?),
        "IsLinear" => case.equal(field, m.is_linear(), read::truth(want)?),
        "IsRotation" => case.equal(field, m.is_rotation(1e-12), read::truth(want)?),
        "IsIdentity" => case.equal(field, m.is_identity(1e-12), read::truth(want)?),
        "RigidType" => {
            let got = match m.rigid_type(1e-9) {
                1 => "Rigid",
                -1 => "RigidReversing",
                _ => "NotRigid",
            };
            case.equal(field, got, read::text(want)?);
        }
        "SimilarityType" => {
            let got = match m.similarity_type(1e-9) {
                1 => "OrientationPreserving",
                -1 => "OrientationReversing",
                _ => "NotSimilarity",
            };
            case.equal(field, got, read::text(want)?);
        }
        "Determinant" => {
            // Of the size of the product of the rows' lengths, which bounds it.
            let bound: f64 = m.rows.iter().map(|r| r.iter().map(|x| x * x).sum::<f64>().sqrt()).product();
            case.number(field, m.determinant(), read::number(want)?, bound, EVALUATION);
        }
        "Inverse" => match m.inverse() {
            Some(got) => {
                let want = read::xform(want)?;
                // Both carry errors of the size of the condition number.
                let scale = size(&want) * (size(m) * size(&want)).max(1.0);
                case.numbers(field, got.rows.as_flattened(), want.rows.as_flattened(), scale, EVALUATION);
            }
            None => case.miss(field, "there is none".into()),
        },
        "Transpose" => matrices(field, &m.transposed(), &read::xform(want)?, 0.0, case),
        "point" => {
            let (p, want) = (read::point(&out["pointIn"])?, read::point(want)?);
            case.point(field, m.point(p), want, magnitude(m, p), EVALUATION);
        }
        "vector" => {
            let (p, want) = (read::point(&out["pointIn"])?, read::vector(want)?);
            case.vector(field, m.vector(p.to_vector()), want, magnitude(m, p), EVALUATION);
        }
        "bboxOf[-1-2-3,123]" => {
            let (min, max) = (Point3::new(-1.0, -2.0, -3.0), Point3::new(1.0, 2.0, 3.0));
            let got = BoundingBox { min, max }.transformed(m);
            boxes(field, got, want, magnitude(m, max), case)?;
        }
        _ => case.miss(field, "a field that is not known".into()),
    }
    Ok(())
}

/// How large the sums get that make an image, over the divisor of a projective map.
fn magnitude(m: &Xform, p: Point3) -> f64 {
    let sum = |r: &[f64; 4]| (r[0] * p.x).abs() + (r[1] * p.y).abs() + (r[2] * p.z).abs() + r[3].abs();
    let rows = m.rows.iter().map(sum).fold(0.0, f64::max);
    let r = &m.rows[3];
    let w = (r[0] * p.x + r[1] * p.y + r[2] * p.z + r[3]).abs();
    rows / w * sum(r) / w
}
