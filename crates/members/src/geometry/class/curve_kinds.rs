//! The classes of curves: how they are made, and what each has beside `Curve`.

use katydid_geometry::{
    Arc, Circle, Curve, Ellipse, Interval, KnotSpacing, Line, LineCurve, NurbsCurve, Point2, Point3,
    PolyCurve, PolylineCurve,
};

use super::beyond;
use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;
use crate::shape::Shape;
use crate::{Fault, Value};

type Index = Count<0, 10_000_000>;

pub(super) fn enter(table: &mut Endpoints) {
    lines(table);
    arcs(table);
    polylines(table);
    nurbs(table);
    poly(table);
}

fn lines(table: &mut Endpoints) {
    table.member("LineCurve.new from to", |from: Point3, to: Point3| Ok(line(Line::new(from, to))));
    table.member("LineCurve.new from to", |from: Point2, to: Point2| {
        let flat = |p: Point2| Point3::new(p.x, p.y, 0.0);
        Ok(line(Line::new(flat(from), flat(to))))
    });
    table.member("LineCurve.new line", |own: Line| Ok(line(own)));
    table.member("LineCurve.new line t0 t1", |own: Line, start: f64, end: f64| {
        Ok(line(own).with_domain(Interval::new(start, end))?)
    });
    table.member("LineCurve.new other", |c: Curve| match c {
        Curve::Line(_) => Ok(c),
        _ => Err(Fault::bad_request("other is no LineCurve")),
    });
    table.member("LineCurve.get_Line this", |c: Curve| Ok(Line::new(c.start(), c.end())));
}

/// A line as a curve; its domain is its length, as RhinoCommon has it.
fn line(line: Line) -> Curve {
    let length = line.from.distance_to(line.to);
    let curve = Curve::from(LineCurve::new(line));
    // A line without length keeps the domain that it has.
    curve.with_domain(Interval::new(0.0, length)).unwrap_or(curve)
}

fn arcs(table: &mut Endpoints) {
    table.member("ArcCurve.new arc", |arc: Arc| Ok(Curve::from(arc)));
    table.member("ArcCurve.new circle", |circle: Circle| Ok(Curve::from(circle)));
    table.member("ArcCurve.new arc t0 t1", |arc: Arc, start: f64, end: f64| {
        Ok(Curve::from(arc).with_domain(Interval::new(start, end))?)
    });
    table.member("ArcCurve.new circle t0 t1", |circle: Circle, start: f64, end: f64| {
        Ok(Curve::from(circle).with_domain(Interval::new(start, end))?)
    });
    table.member("ArcCurve.get_Arc this", |c: Curve| arc_of(&c));
    table.member("ArcCurve.get_Radius this", |c: Curve| Ok(arc_of(&c)?.circle.radius));
    table.member("ArcCurve.get_AngleRadians this", |c: Curve| Ok(arc_of(&c)?.angle.length().abs()));
    table.member("ArcCurve.get_AngleDegrees this", |c: Curve| {
        Ok(arc_of(&c)?.angle.length().abs().to_degrees())
    });
    table.member("ArcCurve.get_IsCompleteCircle this", |c: Curve| Ok(c.is_closed()));
}

fn arc_of(curve: &Curve) -> Outcome<Arc> {
    curve.as_arc(super::ZERO).ok_or_else(|| Fault::bad_request("this is no arc"))
}

fn polylines(table: &mut Endpoints) {
    table.member("PolylineCurve.new points", |points: Vec<Point3>| {
        Ok(Curve::from(PolylineCurve::new(points)?))
    });
    table.member("PolylineCurve.new other", |polyline: PolylineCurve| Ok(Curve::from(polyline)));
    table.member("PolylineCurve.get_PointCount this", |p: PolylineCurve| Ok(p.points().len()));
    table.member("PolylineCurve.Point this index", |p: PolylineCurve, i: Index| {
        p.points().get(i.0).copied().ok_or_else(|| beyond(i.0, p.points().len()))
    });
    table.member("PolylineCurve.Parameter this index", |p: PolylineCurve, i: Index| {
        p.parameters().get(i.0).copied().ok_or_else(|| beyond(i.0, p.points().len()))
    });
    table.member("PolylineCurve.SetPoint &this index point", |p: PolylineCurve, i: Index, to: Point3| {
        let (mut points, parameters) = p.into_parts();
        let count = points.len();
        *points.get_mut(i.0).ok_or_else(|| beyond(i.0, count))? = to;
        Ok(((), Curve::from(PolylineCurve::with_parameters(points, parameters)?)))
    });
    table
        .member("PolylineCurve.ToPolyline this", |p: PolylineCurve| Ok(Value::Polyline(p.points().to_vec())));
    table.member("PolylineCurve.ToArray this", |p: PolylineCurve| Ok(p.points().to_vec()));
}

type Degree = Count<1, 11>;

fn nurbs(table: &mut Endpoints) {
    table.member(
        "NurbsCurve.Create periodic degree points",
        |periodic: bool, Count(degree): Degree, points: Vec<Point3>| {
            Ok(Curve::from(if periodic {
                NurbsCurve::periodic_uniform(degree, &points)?
            } else {
                NurbsCurve::clamped_uniform(degree.min(points.len().saturating_sub(1)).max(1), &points)?
            }))
        },
    );
    table.member("Curve.CreateControlPointCurve points", |points: Vec<Point3>| control_points(&points, 3));
    table.member(
        "Curve.CreateControlPointCurve points degree",
        |points: Vec<Point3>, Count(degree): Degree| control_points(&points, degree),
    );
    table.member("NurbsCurve.CreateFromLine line", |own: Line| Ok(Curve::from(line(own).to_nurbs()?)));
    table.member("NurbsCurve.CreateFromArc arc", |arc: Arc| Ok(Curve::from(Curve::from(arc).to_nurbs()?)));
    table.member("NurbsCurve.CreateFromCircle circle", |circle: Circle| {
        Ok(Curve::from(Curve::from(circle).to_nurbs()?))
    });
    table.member("NurbsCurve.CreateFromEllipse ellipse", |e: Ellipse| Ok(Curve::from(e.to_nurbs()?)));
    table.member(
        "NurbsCurve.CreateFromFitPoints points tolerance periodic",
        |p: Vec<Point3>, _: f64, closed: bool| {
            Ok(Curve::from(match closed {
                true => NurbsCurve::interpolate_periodic(3, &p, KnotSpacing::Chord)?,
                false => NurbsCurve::interpolate(3, &p, KnotSpacing::Chord, None, None)?,
            }))
        },
    );
    table.member("NurbsCurve.get_Order this", |c: Curve| Ok(c.to_nurbs()?.order()));
    table.member("NurbsCurve.get_IsRational this", |c: Curve| Ok(c.to_nurbs()?.is_rational()));
    table.member("NurbsCurve.get_HasBezierSpans this", |c: Curve| Ok(c.to_nurbs()?.has_bezier_spans()));
    table.member("NurbsCurve.IncreaseDegree &this desiredDegree", |c: Curve, Count(degree): Degree| {
        let nurbs = c.to_nurbs()?;
        Ok(match degree < nurbs.degree() {
            true => (false, c),
            false => (true, nurbs.raised_to(degree)?.into()),
        })
    });
    table.member("NurbsCurve.GrevilleParameters this", |c: Curve| Ok(c.to_nurbs()?.greville_abscissae()));
    table.member("NurbsCurve.MakePiecewiseBezier &this setEndWeightsToOne", |c: Curve, _: bool| {
        Ok((true, Curve::from(c.to_nurbs()?.with_bezier_spans()?)))
    });
}

fn control_points(points: &[Point3], degree: usize) -> Outcome<Curve> {
    let degree = degree.min(points.len().saturating_sub(1)).max(1);
    // Where the last point is the first, RhinoCommon makes the curve periodic.
    match points {
        [first, inner @ .., last] if first.distance_to(*last) <= super::ZERO && inner.len() > degree => {
            let around: Vec<Point3> = std::iter::once(*first).chain(inner.iter().copied()).collect();
            Ok(NurbsCurve::periodic_uniform(degree, &around)?.into())
        }
        _ => Ok(NurbsCurve::clamped_uniform(degree, points)?.into()),
    }
}

fn poly(table: &mut Endpoints) {
    table.member("PolyCurve.new", || Ok(Shape::Empty("PolyCurve")));
    for signature in ["PolyCurve.Append &this curve", "PolyCurve.AppendSegment &this curve"] {
        table.member(signature, |own: Shape, next: Curve| {
            let mut segments = match own.curve() {
                Some(curve) => match curve.as_ref() {
                    Curve::Poly(poly) => poly.segments().to_vec(),
                    other => vec![other.clone()],
                },
                None => Vec::new(),
            };
            segments.push(next);
            Ok((true, Curve::from(PolyCurve::new(segments)?)))
        });
    }
    table.member("PolyCurve.get_SegmentCount this", |own: Shape| Ok(segments(&own).len()));
    table.member("PolyCurve.SegmentCurve this index", |own: Shape, i: Index| {
        let segments = segments(&own);
        segments.get(i.0).cloned().ok_or_else(|| beyond(i.0, segments.len()))
    });
    table.member("PolyCurve.Explode this", |own: Shape| Ok(segments(&own)));
    table.member("PolyCurve.SegmentDomain this segmentIndex", |c: Curve, i: Index| match &c {
        Curve::Poly(poly) if i.0 < poly.segments().len() => Ok(poly.segment_domain(i.0)),
        _ => Err(beyond(i.0, 0)),
    });
    table.member("PolyCurve.get_HasGap this", |c: Curve| {
        Ok(matches!(&c, Curve::Poly(poly) if poly.largest_gap() > super::ZERO))
    });
}

fn segments(shape: &Shape) -> Vec<Curve> {
    match shape.curve().as_deref() {
        Some(Curve::Poly(poly)) => poly.segments().to_vec(),
        Some(other) => vec![other.clone()],
        None => Vec::new(),
    }
}
