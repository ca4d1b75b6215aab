//! Constructors of `NurbsCurve`, and its lists: control points and knots, which scripts set one by one.

use katydid_geometry::{Curve, Point3};

use super::beyond;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Record, Shape};
use crate::unfinished::UnfinishedNurbs;
use crate::wire::Read;
use crate::{Fault, Value};

type Index = Count<0, 10_000_000>;

pub(super) fn enter(table: &mut Endpoints) {
    makers(table);
    points(table);
    weights(table);
    knots(table);
}

fn makers(table: &mut Endpoints) {
    table.member("NurbsCurve.new other", |c: Curve| match c {
        Curve::Nurbs(_) => Ok(c),
        _ => Err(Fault::bad_request("other is no NurbsCurve")),
    });
    table.member("NurbsCurve.new degree pointCount", |degree: Count<1, 11>, count: Count<2, 1_000_000>| {
        UnfinishedNurbs::new(degree.0, count.0, false).map(UnfinishedNurbs::shape)
    });
    table.member(
        "NurbsCurve.new dimension rational order pointCount",
        |dimension: Count<1, 4>, rational: bool, order: Count<2, 12>, count: Count<2, 1_000_000>| {
            if dimension.0 != 3 {
                return Err(Fault::not_supported(format!("a NurbsCurve of {} dimensions", dimension.0)));
            }
            UnfinishedNurbs::new(order.0 - 1, count.0, rational).map(UnfinishedNurbs::shape)
        },
    );
}

fn points(table: &mut Endpoints) {
    table.member("NurbsCurvePointList.get_Count this", |c: Written| Ok(c.0.points.len()));
    table.member("NurbsCurvePointList.ToArray this", |c: Written| {
        Ok((0..c.0.points.len()).filter_map(|i| control_point(&c.0, i)).collect::<Vec<Record>>())
    });
    table.member("NurbsCurvePointList.get_Item this index", |c: Written, i: Index| {
        control_point(&c.0, i.0).ok_or_else(|| beyond(i.0, c.0.points.len()))
    });
    table.member("NurbsCurvePointList.GetPoint this index", |c: Written, i: Index| {
        let point = c.0.points.get(i.0).copied();
        Ok((point.is_some(), point))
    });
    table.member(
        "NurbsCurvePointList.SetPoint &this index point",
        |Written(mut c): Written, i: Index, to: Point3| {
            let count = c.points.len();
            *c.points.get_mut(i.0).ok_or_else(|| beyond(i.0, count))? = to;
            Ok((true, c.shape()))
        },
    );
}

fn weights(table: &mut Endpoints) {
    table.member("NurbsCurvePointList.GetWeight this index", |c: Written, i: Index| {
        c.0.weight(i.0).ok_or_else(|| beyond(i.0, c.0.points.len()))
    });
    table.member(
        "NurbsCurvePointList.SetWeight &this index weight",
        |Written(mut c): Written, i: Index, weight: f64| {
            if !(weight.is_finite() && weight > 0.0) {
                return Err(Fault::bad_request(format!("weight is {weight}, which must be greater than 0")));
            }
            if !c.set_weight(i.0, weight) {
                return Err(beyond(i.0, c.points.len()));
            }
            Ok((true, c.shape()))
        },
    );
}

fn knots(table: &mut Endpoints) {
    table.member("NurbsCurve.get_Knots this", |c: Written| Ok(c.0.knots));
    table.member("NurbsCurveKnotList.ToArray this", |c: Written| Ok(c.0.knots));
    table.member("NurbsCurveKnotList.get_Count this", |c: Written| Ok(c.0.knots.len()));
    table.member("NurbsCurveKnotList.get_Item this index", |c: Written, i: Index| {
        c.0.knots.get(i.0).copied().ok_or_else(|| beyond(i.0, c.0.knots.len()))
    });
    table.member(
        "NurbsCurveKnotList.set_Item &this index value",
        |Written(mut c): Written, i: Index, knot: f64| {
            let count = c.knots.len();
            *c.knots.get_mut(i.0).ok_or_else(|| beyond(i.0, count))? = knot;
            Ok(((), c.shape()))
        },
    );
    table.member("NurbsCurveKnotList.CreateUniformKnots &this knotSpacing", |c: Written, spacing: f64| {
        uniform(c, spacing, true)
    });
    table.member("NurbsCurveKnotList.CreatePeriodicKnots &this knotSpacing", |c: Written, spacing: f64| {
        uniform(c, spacing, false)
    });
}

/// Evenly spaced knots with 0 as the start of the domain, as `ON_MakeClampedUniformKnotVector` and
/// `ON_MakePeriodicUniformKnotVector` of openNURBS make them: clamped ones are repeated at both ends.
pub(super) fn space(
    knots: &mut [f64],
    degree: usize,
    points: usize,
    spacing: f64,
    clamped: bool,
) -> Result<(), Fault> {
    if !(spacing.is_finite() && spacing > 0.0) {
        return Err(Fault::bad_request(format!("knotSpacing is {spacing}, which must be greater than 0")));
    }
    let (first, last) = (degree.saturating_sub(1), points.saturating_sub(1));
    for (i, knot) in knots.iter_mut().enumerate() {
        let place = if clamped { i.clamp(first, last) } else { i };
        #[expect(clippy::cast_precision_loss, reason = "at most a million points")]
        let steps = place as f64 - first as f64;
        *knot = steps * spacing;
    }
    Ok(())
}

fn uniform(Written(mut c): Written, spacing: f64, clamped: bool) -> Result<(bool, Shape), Fault> {
    space(&mut c.knots, c.degree, c.points.len(), spacing, clamped)?;
    Ok((true, c.shape()))
}

/// A NURBS curve, finished or not, by its numbers.
struct Written(UnfinishedNurbs);

impl Read for Written {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Ok(Self(UnfinishedNurbs::of(&Curve::read(json)?.to_nurbs()?)))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        if let Value::Geometry(Geometry { shape: Shape::Unfinished(own), .. }) = value {
            return Ok(Self((**own).clone()));
        }
        Ok(Self(UnfinishedNurbs::of(&Curve::of_value(value)?.to_nurbs()?)))
    }

    fn type_name() -> String {
        "NurbsCurve".into()
    }
}

/// A `ControlPoint`.
fn control_point(c: &UnfinishedNurbs, place: usize) -> Option<Record> {
    Some(control_point_record(*c.points.get(place)?, c.weight(place)?))
}

/// A `ControlPoint` of a place in space and a weight.
pub(super) fn control_point_record(at: Point3, weight: f64) -> Record {
    let fields = vec![
        ("Location", Value::Point(at)),
        ("Weight", Value::Number(weight)),
        ("X", Value::Number(at.x)),
        ("Y", Value::Number(at.y)),
        ("Z", Value::Number(at.z)),
    ];
    Record { class: "ControlPoint", fields }
}
