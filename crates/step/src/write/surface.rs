//! Surfaces.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::chart::{Chart, linear};
use super::{curve, direction, flag, frame, point};
use crate::Result;
use crate::part21::{Id, Sheet, list, real};
use katydid_elementary::Elementary;
use katydid_geometry::{
    Arc, ArcCurve, Curve, Direction, LineCurve, NurbsSurface, Plane, RevolutionSurface, SumSurface, Surface,
    Vector3,
};

/// Lengths below this part of the size are rounding.
const ROUNDING: f64 = 1e-12;

/// A surface in the file.
pub(super) struct Put {
    pub(super) id: Id,
    pub(super) chart: Chart,
}

pub(super) fn put(sheet: &mut Sheet, surface: &Surface) -> Result<Put> {
    match surface {
        Surface::Plane(s) => {
            let frame = frame(sheet, s.plane());
            Ok(Put { id: sheet.put(format_args!("PLANE('',{frame})")), chart: Chart::NONE })
        }
        Surface::Sum(s) => sum(sheet, s),
        Surface::Revolution(s) => revolution(sheet, s),
        Surface::Nurbs(s) => match flat_patch(s) {
            Some(plane) => {
                let frame = frame(sheet, &plane);
                Ok(Put { id: sheet.put(format_args!("PLANE('',{frame})")), chart: Chart::NONE })
            }
            None => Ok(Put { id: spline(sheet, s)?, chart: Chart::SAME }),
        },
    }
}

/// The plane of a surface between four points of one plane, which Rhino has for flat faces. On a plane edges lie
/// exactly; onto a b-spline programs project them.
fn flat_patch(surface: &NurbsSurface) -> Option<Plane> {
    if surface.degrees() != [1, 1] || surface.counts() != [2, 2] || surface.is_rational() {
        return None;
    }
    let [a, b, c, d] = *surface.control_points().as_slice() else { return None };
    let size = (d - a).length().max((c - b).length());
    // The surface runs from a along v to b, and along u to c.
    let plane = Plane::from_axes(a, c - a, b - a).ok()?;
    let normal = plane.z_axis;
    let is_flat = plane.signed_distance(d).abs() <= ROUNDING * size;
    let turns = [[a, c, b], [c, d, a], [d, b, c], [b, a, d]];
    let is_convex =
        turns.iter().all(|[at, u, v]| (*u - *at).cross(*v - *at).dot(normal) > ROUNDING * size * size);
    (is_flat && is_convex).then_some(plane)
}

fn spline(sheet: &mut Sheet, surface: &NurbsSurface) -> Result<Id> {
    let mut surface = surface.clone();
    for d in Direction::BOTH {
        surface = surface.clamped(d)?;
    }
    let [rows, columns] = surface.counts();
    let points: Vec<Id> = surface.control_points().into_iter().map(|p| point(sheet, p)).collect();
    let grid = |cells: Vec<String>| list(cells.chunks(columns.max(1)).take(rows).map(list::<&String>));
    let points = grid(points.iter().map(ToString::to_string).collect());
    let [p, q] = surface.degrees();
    let [u, v] = Direction::BOTH.map(|d| {
        let (counts, values) = curve::knots(surface.knots(d));
        (list(counts), list(values.into_iter().map(real)))
    });
    let [u_closed, v_closed] = Direction::BOTH.map(|d| flag(surface.is_closed(d)));
    if surface.is_rational() {
        let weights = grid(surface.weights().into_iter().map(real).collect());
        return Ok(sheet.put(format_args!(
            "(BOUNDED_SURFACE()B_SPLINE_SURFACE({p},{q},{points},.UNSPECIFIED.,{u_closed},{v_closed},.F.)\
             B_SPLINE_SURFACE_WITH_KNOTS({},{},{},{},.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_SURFACE({weights})REPRESENTATION_ITEM('')SURFACE())",
            u.0, v.0, u.1, v.1
        )));
    }
    Ok(sheet.put(format_args!(
        "B_SPLINE_SURFACE_WITH_KNOTS('',{p},{q},{points},.UNSPECIFIED.,{u_closed},{v_closed},.F.,{},{},{},{},.UNSPECIFIED.)",
        u.0, v.0, u.1, v.1
    )))
}

/// Whether the carrier of a curve has parameters that follow linearly from the curve's, and which they are at its
/// ends.
fn carrier_range(curve: &Curve) -> Option<[f64; 2]> {
    let domain = curve.domain();
    match curve {
        Curve::Line(c) => Some([0.0, c.line.length()]),
        Curve::Arc(c) => Some([c.arc.angle.start, c.arc.angle.end]),
        Curve::Nurbs(_) | Curve::Polyline(_) => Some([domain.start, domain.end]),
        Curve::Poly(_) => None,
    }
}

/// The sum of a curve and a segment is an extrusion; all others become b-splines.
fn sum(sheet: &mut Sheet, surface: &SumSurface) -> Result<Put> {
    let [a, b] = surface.curves();
    let (swapped, swept, ruling) = match (a, b) {
        (other, Curve::Line(line)) => (false, other, line),
        (Curve::Line(line), other) => (true, other, line),
        _ => {
            let is_same = [a, b].into_iter().all(|c| matches!(c, Curve::Nurbs(_) | Curve::Polyline(_)));
            let id = spline(sheet, &surface.to_nurbs()?)?;
            return Ok(Put { id, chart: Chart { is_exact: is_same, ..Chart::SAME } });
        }
    };
    // Programs integrate over extrusions of b-splines less well than over the same surface as a b-spline.
    if !matches!(swept, Curve::Line(_) | Curve::Arc(_)) {
        let is_exact = !matches!(swept, Curve::Poly(_));
        let id = spline(sheet, &surface.to_nurbs()?)?;
        return Ok(Put { id, chart: Chart { is_exact, ..Chart::SAME } });
    }
    let Some(along) = ruling.line.unit_direction() else {
        return Err(katydid_geometry::Error::Degenerate {
            what: "extrusion",
            why: "its direction has no length",
        }
        .into());
    };
    let moved = ruling.line.from.to_vector() + surface.shift();
    let swept = swept.transformed(&katydid_geometry::Xform::translation(moved))?;
    let length = [0.0, ruling.line.length()];
    let ruling_map = linear(ruling.domain, length);
    let ends = carrier_range(&swept);
    let swept_map = ends.map_or([1.0, 0.0], |ends| linear(swept.domain(), ends));
    let maps = if swapped { [ruling_map, swept_map] } else { [swept_map, ruling_map] };
    let chart = Chart { swapped, maps, is_exact: ends.is_some() };
    if let Curve::Line(line) = &swept
        && let (Some(x), true) = (line.line.unit_direction(), ends.is_some())
        && let Ok(plane) = Plane::from_axes(line.line.from, x, along)
    {
        let frame = frame(sheet, &plane);
        // Its parameters are not those of the plane's coordinates; nobody needs curves on planes.
        let chart = Chart { is_exact: false, ..chart };
        return Ok(Put { id: sheet.put(format_args!("PLANE('',{frame})")), chart });
    }
    if let Curve::Arc(arc) = &swept
        && let Some(put) = cylinder_of_arc(sheet, arc, along, chart, length)
    {
        return Ok(put);
    }
    let profile = curve::carrier(sheet, &swept)?;
    let along = direction(sheet, along);
    let vector = sheet.put(format_args!("VECTOR('',{along},1.)"));
    let id = sheet.put(format_args!("SURFACE_OF_LINEAR_EXTRUSION('',{profile},{vector})"));
    Ok(Put { id, chart })
}

/// An arc moved along its axis.
fn cylinder_of_arc(
    sheet: &mut Sheet,
    arc: &ArcCurve,
    along: Vector3,
    mut chart: Chart,
    length: [f64; 2],
) -> Option<Put> {
    let Plane { origin, x_axis, y_axis, .. } = arc.arc.circle.plane;
    let z_axis = x_axis.cross(y_axis);
    let side = z_axis.dot(along);
    if z_axis.cross(along).length() > ROUNDING {
        return None;
    }
    if side < 0.0 && length[1] > 0.0 {
        let map = &mut chart.maps[usize::from(!chart.swapped)];
        *map = map.map(|x| -x);
    }
    let frame = frame(sheet, &Plane { origin, x_axis, y_axis, z_axis });
    let id = sheet.put(format_args!("CYLINDRICAL_SURFACE('',{frame},{})", real(arc.arc.circle.radius)));
    Some(Put { id, chart })
}

/// A surface of revolution in the coordinates of its axis.
struct Turned<'a> {
    surface: &'a RevolutionSurface,
    origin: katydid_geometry::Point3,
    axis: Vector3,
    size: f64,
}

impl Turned<'_> {
    /// The height along the axis and the arm from it.
    fn polar(&self, p: katydid_geometry::Point3) -> (f64, Vector3) {
        let w = p - self.origin;
        let height = w.dot(self.axis);
        (height, w - self.axis * height)
    }

    fn is_small(&self, length: f64) -> bool {
        length.abs() <= ROUNDING * self.size
    }

    /// A frame on the axis at a height, its x axis along an arm.
    fn frame(&self, height: f64, x_axis: Vector3) -> Plane {
        let origin = self.origin + self.axis * height;
        Plane { origin, x_axis, y_axis: self.axis.cross(x_axis), z_axis: self.axis }
    }

    /// The chart whose first parameter is the angle, when the profile's parameter goes between two values.
    fn chart(&self, turn: f64, profile: Option<[f64; 2]>) -> Chart {
        let s = self.surface;
        let along = s.angle_direction();
        let angle = s.angle();
        let angle_map = linear(s.domain(along), [turn * angle.start, turn * angle.end]);
        let profile_map = profile.map_or([1.0, 0.0], |ends| linear(s.profile().domain(), ends));
        let swapped = along == Direction::V;
        let maps = if swapped { [profile_map, angle_map] } else { [angle_map, profile_map] };
        Chart { swapped, maps, is_exact: profile.is_some() }
    }

    /// A line beside the axis in one plane with it makes a cylinder or cone.
    fn ruled(&self, sheet: &mut Sheet, profile: &LineCurve) -> Option<Put> {
        let (h0, a0) = self.polar(profile.line.from);
        let (h1, a1) = self.polar(profile.line.to);
        let (r0, r1) = (a0.length(), a1.length());
        let x = if r0 >= r1 { a0.unitized()? } else { a1.unitized()? };
        let off = |arm: Vector3, r: f64| !self.is_small((arm - x * r).length());
        if off(a0, r0) || off(a1, r1) || self.is_small(h1 - h0) {
            return None;
        }
        if self.is_small(r1 - r0) {
            let frame = frame(sheet, &self.frame(h0, x));
            let id = sheet.put(format_args!("CYLINDRICAL_SURFACE('',{frame},{})", real(r0.max(r1))));
            return Some(Put { id, chart: self.chart(1.0, Some([0.0, h1 - h0])) });
        }
        // The radius grows along the axis of a cone.
        let turn = ((r1 - r0) * (h1 - h0)).signum();
        let (height, radius) = if r0 < r1 { (h0, r0) } else { (h1, r1) };
        let Plane { origin, x_axis, y_axis, z_axis } = self.frame(height, x);
        let place = Plane { origin, x_axis, y_axis: y_axis * turn, z_axis: z_axis * turn };
        let frame = frame(sheet, &place);
        let half = ((r1 - r0) / (h1 - h0)).abs().arctangent();
        let radius = if self.is_small(radius) { 0.0 } else { radius };
        let id = sheet.put(format_args!("CONICAL_SURFACE('',{frame},{},{})", real(radius), real(half)));
        let ends = [h0, h1].map(|h| turn * (h - height));
        Some(Put { id, chart: self.chart(turn, Some(ends)) })
    }

    /// An arc in one plane with the axis makes a sphere or torus.
    fn round(&self, sheet: &mut Sheet, profile: &ArcCurve) -> Option<Put> {
        let circle = &profile.arc.circle;
        let Plane { origin: center, x_axis: cx, y_axis: cy, .. } = circle.plane;
        let normal = cx.cross(cy);
        if normal.dot(self.axis).abs() > ROUNDING || !self.is_small((self.origin - center).dot(normal)) {
            return None;
        }
        let (height, arm) = self.polar(center);
        let major = arm.length();
        let is_sphere = self.is_small(major);
        let x = if is_sphere {
            self.polar(circle.at(profile.arc.angle.middle())).1.unitized()?
        } else {
            arm.unitized()?
        };
        if !is_sphere && major <= circle.radius * (1.0 + 1e-9) {
            return None;
        }
        let sense = normal.dot(x.cross(self.axis)).signum();
        let start = cx.dot(self.axis).arctangent_of(cx.dot(x));
        let mut ends = [profile.arc.angle.start, profile.arc.angle.end].map(|angle| start + sense * angle);
        let turns = TAU * (0.5 * (ends[0] + ends[1]) / TAU).round();
        ends = ends.map(|angle| angle - turns);
        let frame = self.frame(height, x);
        if is_sphere {
            if ends.iter().any(|angle| angle.abs() > FRAC_PI_2 + 1e-9) {
                return None;
            }
            let frame = super::frame(sheet, &frame);
            let id = sheet.put(format_args!("SPHERICAL_SURFACE('',{frame},{})", real(circle.radius)));
            return Some(Put { id, chart: self.chart(1.0, Some(ends)) });
        }
        debug_assert!(ends.iter().all(|angle| angle.abs() <= 2.0 * PI + 1e-9));
        let frame = super::frame(sheet, &frame);
        let id =
            sheet.put(format_args!("TOROIDAL_SURFACE('',{frame},{},{})", real(major), real(circle.radius)));
        Some(Put { id, chart: self.chart(1.0, Some(ends)) })
    }
}

fn revolution(sheet: &mut Sheet, surface: &RevolutionSurface) -> Result<Put> {
    let axis = surface.axis();
    let Some(unit) = axis.unit_direction() else {
        return Err(katydid_geometry::Error::Degenerate { what: "axis", why: "it has no direction" }.into());
    };
    let profile = surface.profile();
    let size = profile.bounding_box().diagonal().length().max((profile.start() - axis.from).length());
    let turned = Turned { surface, origin: axis.from, axis: unit, size };
    let plain = match profile {
        Curve::Line(line) => turned.ruled(sheet, line),
        Curve::Arc(arc) => turned.round(sheet, arc),
        _ => None,
    };
    if let Some(put) = plain {
        return Ok(put);
    }
    let on_axis = |p| turned.is_small(turned.polar(p).1.length());
    let (carrier, range) = match profile {
        // Programs see the poles of a surface at the ends of its profile, which a whole circle has not.
        Curve::Arc(arc) if on_axis(profile.start()) || on_axis(profile.end()) => {
            let angle = arc.arc.angle;
            let angle = angle.shifted(angle.start.rem_euclid(TAU) - angle.start);
            let arc = ArcCurve { arc: Arc { circle: arc.arc.circle, angle }, domain: angle };
            (curve::bounded(sheet, &arc.into())?, Some([angle.start, angle.end]))
        }
        _ => (curve::carrier(sheet, profile)?, carrier_range(profile)),
    };
    let origin = point(sheet, axis.from);
    let along = direction(sheet, unit);
    let place = sheet.put(format_args!("AXIS1_PLACEMENT('',{origin},{along})"));
    let id = sheet.put(format_args!("SURFACE_OF_REVOLUTION('',{carrier},{place})"));
    Ok(Put { id, chart: turned.chart(1.0, range) })
}
