//! `Curve`: evaluation, parts, and changes in place.

use katydid_geometry::{Continuity, ContinuityTolerance, Curve, Interval, Plane, Point3, Vector3};

use super::{Named, ZERO};
use crate::Fault;
use crate::geometry::answer::Outcome;
use crate::geometry::argument::{Count, choice};
use crate::geometry::table::Endpoints;
use crate::wire::Read;

pub(super) fn enter(table: &mut Endpoints) {
    table.member("Curve.get_Domain this", |c: Curve| Ok(c.domain()));
    table.member("Curve.set_Domain &this domain", |c: Curve, to: Interval| Ok(((), c.with_domain(to)?)));
    table.member("Curve.get_Degree this", |c: Curve| Ok(degree(&c)));
    table.member("Curve.get_Dimension this", |_: Curve| Ok(3));
    table.member("Curve.get_SpanCount this", |c: Curve| Ok(spans(&c)?.len().saturating_sub(1)));
    table.member("Curve.SpanDomain this spanIndex", |c: Curve, i: Count<0, 1_000_000>| {
        let ends = spans(&c)?;
        match ends.get(i.0..i.0 + 2) {
            Some([start, end]) => Ok(Interval::new(*start, *end)),
            _ => Err(Fault::bad_request(format!("spanIndex is {}, of {}", i.0, ends.len() - 1))),
        }
    });
    table.member("Curve.IsContinuous this continuityType t", |c: Curve, kind: Smoothness, t: f64| {
        Ok(c.is_continuous_at(t, kind.0, &ContinuityTolerance::default()))
    });
    table.member(
        "Curve.GetNextDiscontinuity this continuityType t0 t1",
        |c: Curve, kind: Smoothness, start: f64, end: f64| {
            let found = c.next_discontinuity(kind.0, start, end, &ContinuityTolerance::default());
            Ok((found.is_some(), found))
        },
    );
    table.member("Curve.get_IsClosed this", |c: Curve| Ok(c.is_closed()));
    table.member("Curve.get_IsPeriodic this", |c: Curve| Ok(c.is_periodic()));
    table.member("Curve.get_PointAtStart this", |c: Curve| Ok(c.start()));
    table.member("Curve.get_PointAtEnd this", |c: Curve| Ok(c.end()));
    table.member("Curve.get_PointAtMid this", |c: Curve| {
        let middle = c.parameter_at_normalized_length(0.5).unwrap_or_else(|| c.domain().at(0.5));
        Ok(c.point_at(middle))
    });
    table.member("Curve.get_TangentAtStart this", |c: Curve| Ok(tangent(&c, c.domain().start)));
    table.member("Curve.get_TangentAtEnd this", |c: Curve| Ok(tangent(&c, c.domain().end)));
    table.member("Curve.PointAt this t", |c: Curve, t: f64| Ok(c.point_at(t)));
    table.member("Curve.TangentAt this t", |c: Curve, t: f64| Ok(tangent(&c, t)));
    table.member("Curve.CurvatureAt this t", |c: Curve, t: f64| Ok(c.curvature_at(t)));
    table.member("Curve.TorsionAt this t", |c: Curve, t: f64| Ok(c.torsion_at(t)));
    table.member("Curve.FrameAt this t", |c: Curve, t: f64| {
        let frame = c.frame_at(t);
        Ok((frame.is_some(), frame))
    });
    table.member("Curve.DerivativeAt this t derivativeCount", |c: Curve, t: f64, n: Count<0, 32>| {
        let (point, derivatives) = c.derivatives(t, n.0, false);
        let point = Vector3::new(point.x, point.y, point.z);
        Ok(std::iter::once(point).chain(derivatives).collect::<Vec<_>>())
    });
    table.member("Curve.DuplicateCurve this", |c: Curve| Ok(c));
    table.member("Curve.HasNurbsForm this", |c: Curve| Ok(i32::from(c.to_nurbs().is_ok())));
    table.member("Curve.ToNurbsCurve this", |c: Curve| Ok(Curve::from(c.to_nurbs()?)));
    table.member("Curve.ToNurbsCurve this subdomain", |c: Curve, part: Interval| {
        Ok(Curve::from(c.trimmed(part)?.to_nurbs()?))
    });
    table.member("Curve.Reverse &this", |c: Curve| Ok((true, c.reversed())));
    table.member("Curve.Trim this t0 t1", |c: Curve, start: f64, end: f64| trimmed(&c, start, end));
    table.member("Curve.Trim this domain", |c: Curve, part: Interval| trimmed(&c, part.start, part.end));
    table.member("Curve.Split this t", |c: Curve, t: f64| Ok(c.split_at(&[t])?));
    table.member("Curve.Split this t", |c: Curve, t: Vec<f64>| Ok(c.split_at(&t)?));
    table.member("Curve.ChangeClosedCurveSeam &this t", |c: Curve, t: f64| {
        Ok(match c.is_closed() {
            true => (true, c.with_seam(t)?),
            false => (false, c),
        })
    });
    table.member("Curve.SetStartPoint &this point", |c: Curve, to: Point3| with_end(&c, true, to));
    table.member("Curve.SetEndPoint &this point", |c: Curve, to: Point3| with_end(&c, false, to));
    table.member("Curve.Reparameterize &this", |c: Curve| Ok((true, c.with_domain(Interval::UNIT)?)));
    table.member("Curve.GetSubCurves this", |c: Curve| Ok(c.explode(true)?));
    table.member("Curve.ControlPolygon this", |c: Curve| {
        Ok(crate::Value::Polyline(c.to_nurbs()?.control_points()))
    });
    table.member("Curve.ClosedCurveOrientation this", |c: Curve| Ok(orientation(&c, &Plane::XY)));
    table.member("Curve.ClosedCurveOrientation this plane", |c: Curve, plane: Plane| {
        Ok(orientation(&c, &plane))
    });
    table.member("Curve.ClosedCurveOrientation this upDirection", |c: Curve, up: Vector3| {
        Ok(orientation(&c, &Plane::from_normal(Point3::ORIGIN, up)?))
    });
    table.member("Curve.IsClosable this tolerance", |c: Curve, tolerance: f64| Ok(closable(&c, tolerance)));
    table.member(
        "Curve.IsClosable this tolerance minimumAbsoluteSize minimumRelativeSize",
        |c: Curve, tolerance: f64, _: f64, _: f64| Ok(closable(&c, tolerance)),
    );
}

/// `Continuity`, of which the kinds at a locus count as the plain ones.
struct Smoothness(Continuity);

impl Read for Smoothness {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        choice(
            json,
            "continuity",
            &[
                ("None", Continuity::C0),
                ("C0_continuous", Continuity::C0),
                ("C1_continuous", Continuity::C1),
                ("C2_continuous", Continuity::C2),
                ("G1_continuous", Continuity::G1),
                ("G2_continuous", Continuity::G2),
                ("C0_locus_continuous", Continuity::C0),
                ("C1_locus_continuous", Continuity::C1),
                ("C2_locus_continuous", Continuity::C2),
                ("G1_locus_continuous", Continuity::G1),
                ("G2_locus_continuous", Continuity::G2),
            ],
        )
        .map(Self)
    }

    fn type_name() -> String {
        "Continuity".into()
    }
}

/// The tangent, zero where there is none.
fn tangent(curve: &Curve, t: f64) -> Vector3 {
    curve.tangent_at(t).unwrap_or(Vector3::ZERO)
}

fn degree(curve: &Curve) -> usize {
    match curve {
        Curve::Line(_) | Curve::Polyline(_) => 1,
        Curve::Arc(_) => 2,
        Curve::Nurbs(nurbs) => nurbs.degree(),
        Curve::Poly(poly) => poly.segments().iter().map(degree).max().unwrap_or(1),
    }
}

/// The parameters between which the curve is one piece.
fn spans(curve: &Curve) -> Outcome<Vec<f64>> {
    Ok(match curve {
        Curve::Polyline(polyline) => polyline.parameters().to_vec(),
        other => other.to_nurbs()?.span_parameters(),
    })
}

/// The part between two parameters, backwards over the seam of a closed curve; nothing where there is no such part.
fn trimmed(curve: &Curve, start: f64, end: f64) -> Outcome<Option<Curve>> {
    if start == end {
        return Ok(None);
    }
    let part = Interval::new(start, end);
    let made = if curve.is_closed() { curve.sub_curve(part) } else { curve.trimmed(part) };
    Ok(made.ok())
}

/// The curve with its start or end moved: a line and a polyline by its point, others as NURBS by their first or last
/// control point.
fn with_end(curve: &Curve, at_start: bool, to: Point3) -> Outcome<(bool, Curve)> {
    if curve.is_closed() {
        return Ok((false, curve.clone()));
    }
    let nurbs = curve.to_nurbs()?;
    let place = if at_start { 0 } else { nurbs.point_count() - 1 };
    let moved = nurbs.with_control_point(place, to)?;
    Ok((
        true,
        match curve {
            Curve::Line(line) => {
                let (from, end) = if at_start { (to, line.line.to) } else { (line.line.from, to) };
                Curve::from(katydid_geometry::Line::new(from, end)).with_domain(line.domain)?
            }
            Curve::Polyline(polyline) => {
                let mut points = polyline.points().to_vec();
                let end = if at_start { points.first_mut() } else { points.last_mut() };
                if let Some(end) = end {
                    *end = to;
                }
                let parameters = polyline.parameters().to_vec();
                katydid_geometry::PolylineCurve::with_parameters(points, parameters)?.into()
            }
            _ => moved.into(),
        },
    ))
}

/// `CurveOrientation`: −1 clockwise, 1 counter-clockwise, 0 for a curve that is open or encloses nothing.
fn orientation(curve: &Curve, plane: &Plane) -> Named {
    let area = if curve.is_closed() { curve.signed_area_in(plane).0 } else { 0.0 };
    let turn = match area {
        area if area > 0.0 => 1,
        area if area < 0.0 => -1,
        _ => 0,
    };
    Named("CurveOrientation", turn)
}

/// Whether the ends are near enough that the curve could be closed.
fn closable(curve: &Curve, tolerance: f64) -> bool {
    let gap = curve.start().distance_to(curve.end());
    curve.is_closed() || (gap <= tolerance.max(ZERO) && curve.length() > 4.0 * tolerance.max(0.0))
}

/// The tolerance that RhinoCommon recognises shapes with, or one that a script gives.
pub(super) fn within(tolerance: Option<f64>) -> f64 {
    tolerance.map_or(ZERO, |tolerance| tolerance.max(ZERO))
}
