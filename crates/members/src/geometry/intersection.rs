//! Where curves meet curves, planes, surfaces and breps, and where planes cut breps.

use std::sync::Arc;

use katydid_geometry::brep::{BrepPiercing, ClosestOnBrep};
use katydid_geometry::intersect::{
    CurveIntersections, SurfaceIntersections, curve_curve, curve_plane, curve_self, curve_with_surface,
};
use katydid_geometry::{Brep, Curve, Interval, Line, Plane, Point3, Surface};
use serde_json::Value as Json;

use super::answer::{Answer, Outcome};
use super::argument::{Turn, Within};
use super::brep_face::Face;
use super::table::Endpoints;
use crate::{Fault, Record, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("intersect/intersection/curveplane-curve_plane_double", with_plane);
    table.add("intersect/intersection/curveself-curve_double", |c: Curve, t: Within| {
        Ok(of_curves(&c, &c, &curve_self(&c, t.0)?))
    });
    table.add(
        "intersect/intersection/curvecurve-curve_curve_double_double",
        |a: Curve, b: Curve, t: Within, _: f64| Ok(of_curves(&a, &b, &curve_curve(&a, &b, t.0)?)),
    );
    table.add(
        "intersect/intersection/curvecurvevalidate-curve_curve_double_double_intarray_textlog",
        |a: Curve, b: Curve, t: Within, _: f64| Ok(checked(of_curves(&a, &b, &curve_curve(&a, &b, t.0)?))),
    );
    table.add(
        "intersect/intersection/curvesurfacevalidate-curve_surface_double_double_intarray_textlog",
        |c: Curve, s: Surface, t: Within, _: f64| {
            Ok(checked(of_surface(&c, &s, &curve_with_surface(&c, &s, t.0)?)))
        },
    );
    table.add(
        "intersect/intersection/curvesurfacevalidate-curve_interval_surface_double_double_intarray_textlog",
        |c: Curve, part: Interval, s: Surface, t: Within, _: f64| {
            let c = c.sub_curve(part.ordered())?;
            Ok(checked(of_surface(&c, &s, &curve_with_surface(&c, &s, t.0)?)))
        },
    );
    table.add(
        "intersect/intersection/curveline-curve_line_double_double",
        |a: Curve, line: Line, t: Within, _: f64| with_line(&a, line, t),
    );
    table.add(
        "intersect/intersection/curvesurface-curve_surface_double_double",
        |c: Curve, s: Surface, t: Within, _: f64| Ok(of_surface(&c, &s, &curve_with_surface(&c, &s, t.0)?)),
    );
    table.add(
        "intersect/intersection/curvesurface-curve_interval_surface_double_double",
        |c: Curve, part: Interval, s: Surface, t: Within, _: f64| {
            let c = c.sub_curve(part.ordered())?;
            Ok(of_surface(&c, &s, &curve_with_surface(&c, &s, t.0)?))
        },
    );
    table.add(
        "intersect/intersection/curvebrep-curve_brep_double_curvearray_point3darray",
        |c: Curve, b: Brep, t: Within| curves_and_points(&c, &pierced(&c, b, t)?),
    );
    table.add(
        "intersect/intersection/curvebrep-curve_brep_double_double_doublearray",
        |c: Curve, b: Brep, t: Within, _: Turn| {
            let found = pierced(&c, b, t)?;
            Ok((true, found.crossings.iter().map(|crossing| crossing.t).collect::<Vec<f64>>()))
        },
    );
    table.add(
        "intersect/intersection/curvebrepface-curve_brepface_double_curvearray_point3darray",
        |c: Curve, f: Face, t: Within| curves_and_points(&c, &pierced(&c, f.brep(), t)?),
    );
    table.add(
        "intersect/intersection/brepplane-brep_plane_double_curvearray_point3darray",
        |b: Brep, plane: Plane, t: Within| {
            let found = b.section(&plane, &t.tolerance())?;
            Ok((true, found.curves, found.points))
        },
    );
    table.add(
        "intersect/intersection/brepbrep-brep_brep_double_curvearray_point3darray",
        |a: Brep, b: Brep, t: Within| met(&a, &b, t),
    );
    table.add(
        "intersect/intersection/brepsurface-brep_surface_double_curvearray_point3darray",
        |a: Brep, s: Surface, t: Within| met(&a, &Brep::from_surface(s)?, t),
    );
    table.add(
        "intersect/intersection/surfacesurface-surface_surface_double_curvearray_point3darray",
        |a: Surface, b: Surface, t: Within| met(&Brep::from_surface(a)?, &Brep::from_surface(b)?, t),
    );
}

/// Whether the search came to its end, and the curves and points that two Breps have in common.
fn met(a: &Brep, b: &Brep, within: Within) -> Result<(bool, Vec<Curve>, Vec<Point3>), Fault> {
    let found = a.meeting(b, &within.tolerance())?;
    Ok((found.complete, found.curves, found.points))
}

/// An `IntersectionEvent`: a point, or a stretch from one point to another.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Event {
    /// The points on the first shape; twice the same for a point.
    a: [Point3; 2],
    /// The points on the second shape.
    b: [Point3; 2],
    /// The parameters on the first curve.
    on_a: Interval,
    /// The parameters on the second curve.
    on_b: Interval,
    /// The parameters on the surface.
    on_surface: Option<[f64; 2]>,
    is_point: bool,
}

impl Answer for Event {
    fn name() -> String {
        "Rhino.Geometry.Intersect.IntersectionEvent".into()
    }

    fn json(self) -> Result<Json, Fault> {
        self.record().json()
    }

    fn value(self) -> Result<Value, Fault> {
        self.record().value()
    }
}

/// An event, for what its class has.
pub(super) fn sample() -> Record {
    let nowhere = [Point3::ORIGIN; 2];
    let (on_a, on_b) = (Interval::UNIT, Interval::UNIT);
    Event { a: nowhere, b: nowhere, on_a, on_b, on_surface: None, is_point: true }.record()
}

impl Event {
    fn record(self) -> Record {
        let [u, v] = self.on_surface.unwrap_or_default();
        let fields = vec![
            ("IsPoint", Value::Bool(self.is_point)),
            ("IsOverlap", Value::Bool(!self.is_point)),
            ("PointA", Value::Point(self.a[0])),
            ("PointA2", Value::Point(self.a[1])),
            ("PointB", Value::Point(self.b[0])),
            ("PointB2", Value::Point(self.b[1])),
            ("ParameterA", Value::Number(self.on_a.start)),
            ("ParameterB", Value::Number(self.on_b.start)),
            ("OverlapA", Value::Interval(self.on_a)),
            ("OverlapB", Value::Interval(self.on_b)),
            ("SurfaceU", Value::Number(u)),
            ("SurfaceV", Value::Number(v)),
        ];
        Record { class: "IntersectionEvent", fields }
    }
}

/// Events with what a check of them found: none is wrong, and there is nothing to say.
fn checked(events: Vec<Event>) -> (Vec<Event>, Vec<i32>, Json) {
    (events, Vec::new(), Json::from(""))
}

/// The events in the order of the first curve.
fn sorted(mut events: Vec<Event>) -> Vec<Event> {
    events.sort_by(|x, y| x.on_a.start.total_cmp(&y.on_a.start));
    events
}

fn of_curves(a: &Curve, b: &Curve, found: &CurveIntersections) -> Vec<Event> {
    let points = found.crossings.iter().map(|c| Event {
        a: [a.point_at(c.a); 2],
        b: [b.point_at(c.b); 2],
        on_a: Interval::new(c.a, c.a),
        on_b: Interval::new(c.b, c.b),
        on_surface: None,
        is_point: true,
    });
    let stretches = found.overlaps.iter().map(|o| Event {
        a: [a.point_at(o.a.start), a.point_at(o.a.end)],
        b: [b.point_at(o.b.start), b.point_at(o.b.end)],
        on_a: o.a,
        on_b: o.b,
        on_surface: None,
        is_point: false,
    });
    sorted(points.chain(stretches).collect())
}

fn of_surface(curve: &Curve, surface: &Surface, found: &SurfaceIntersections) -> Vec<Event> {
    let points = found.crossings.iter().map(|c| Event {
        a: [curve.point_at(c.t); 2],
        b: [surface.point_at(c.u, c.v); 2],
        on_a: Interval::new(c.t, c.t),
        on_b: Interval::new(0.0, 0.0),
        on_surface: Some([c.u, c.v]),
        is_point: true,
    });
    let stretches = found.overlaps.iter().map(|o| Event {
        a: [curve.point_at(o.t.start), curve.point_at(o.t.end)],
        b: [surface.point_at(o.from[0], o.from[1]), surface.point_at(o.to[0], o.to[1])],
        on_a: o.t,
        on_b: Interval::new(0.0, 0.0),
        on_surface: Some(o.from),
        is_point: false,
    });
    sorted(points.chain(stretches).collect())
}

/// `None` when curve and plane have nothing in common, as RhinoCommon says it.
fn with_plane(curve: Curve, plane: Plane, tolerance: Within) -> Outcome<Option<Vec<Event>>> {
    let found = curve_plane(&curve, &plane, tolerance.0)?;
    let ranges = found.crossings.iter().map(|&t| Interval::new(t, t)).chain(found.overlaps.iter().copied());
    let event = |range: Interval| {
        let on_curve = [curve.point_at(range.start), curve.point_at(range.end)];
        let in_plane = on_curve.map(|p| p - plane.z_axis * plane.signed_distance(p));
        let on_plane = |k: usize| in_plane.get(k).map_or([0.0; 3], |p| plane.coordinates(*p));
        let [u, v, _] = on_plane(0);
        Event {
            a: on_curve,
            b: in_plane,
            on_a: range,
            on_b: Interval::new(0.0, 0.0),
            on_surface: Some([u, v]),
            is_point: range.is_singleton(),
        }
    };
    let events = sorted(ranges.map(event).collect());
    Ok((!events.is_empty()).then_some(events))
}

/// The line has no ends; parameters on it count from 0 to 1 between its points.
fn with_line(curve: &Curve, line: Line, tolerance: Within) -> Outcome<Vec<Event>> {
    let length = line.length();
    if length <= 0.0 {
        return Err(Fault::bad_request("line has no length"));
    }
    // Long enough to pass everything that the curve reaches.
    let reach =
        curve.bounding_box().corners().map(|p| p.distance_to(line.from)).into_iter().fold(length, f64::max);
    let long = Curve::from(line.extended(2.0 * reach, 2.0 * reach));
    let found = curve_curve(curve, &long, tolerance.0)?;
    let to_line = |t: f64| line.closest_parameter(long.point_at(t));
    let mut events = of_curves(curve, &long, &found);
    for event in &mut events {
        event.on_b = Interval::new(to_line(event.on_b.start), to_line(event.on_b.end));
    }
    Ok(events)
}

fn pierced(curve: &Curve, brep: Brep, tolerance: Within) -> Outcome<BrepPiercing> {
    Ok(ClosestOnBrep::new(Arc::new(brep))?.curve_crossings(curve, tolerance.0)?)
}

fn curves_and_points(curve: &Curve, found: &BrepPiercing) -> Outcome<(bool, Vec<Curve>, Vec<Point3>)> {
    let overlaps =
        found.overlaps.iter().map(|range| Ok(curve.sub_curve(*range)?)).collect::<Outcome<Vec<Curve>>>()?;
    Ok((true, overlaps, found.crossings.iter().map(|crossing| crossing.point).collect()))
}
