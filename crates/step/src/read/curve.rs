//! Curves in space.

use std::f64::consts::TAU;

use super::entity::{DEEPEST, Record};
use super::place::Space;
use super::spline;
use crate::Result;
use katydid_elementary::Elementary;
use katydid_geometry::{
    Arc, ArcCurve, Circle, Curve, Interval, Line, LineCurve, NurbsCurve, Plane, Point3, PolyCurve,
    PolylineCurve, Vector3, Xform,
};

/// A curve as the file has it: without ends where its formula has none.
pub(super) enum Carrier {
    Line { point: Point3, along: Vector3 },
    Ellipse { plane: Plane, radii: [f64; 2] },
    Parabola { plane: Plane, focus: f64 },
    Hyperbola { plane: Plane, radii: [f64; 2] },
    Bounded(Curve),
}

/// Angles nearer than this are one.
const SAME_ANGLE: f64 = 1e-9;

impl Carrier {
    /// The part from one point to another, walked along the carrier or against it. Ends in one place mean all of a
    /// closed curve.
    pub(super) fn between(&self, ends: [Point3; 2], same: bool, tolerance: f64) -> Result<Curve> {
        let [start, end] = if same { ends } else { [ends[1], ends[0]] };
        let curve = match self {
            Self::Line { .. } => Ok(LineCurve::new(Line::new(start, end)).into()),
            Self::Ellipse { plane, radii } => {
                let angle = |p: Point3| {
                    let [x, y, _] = plane.coordinates(p);
                    (y / radii[1]).arctangent_of(x / radii[0])
                };
                let from = angle(start);
                let mut turn = (angle(end) - from).rem_euclid(TAU);
                let is_small = turn <= SAME_ANGLE || turn >= TAU - SAME_ANGLE;
                if start.distance_to(end) <= tolerance && (is_small || start == end) {
                    turn = TAU;
                }
                self.arc(from, turn)
            }
            Self::Parabola { .. } | Self::Hyperbola { .. } => {
                self.branch(self.parameter(start), self.parameter(end))
            }
            Self::Bounded(curve) => part(curve, start, end, tolerance),
        }?;
        Ok(if same { curve } else { curve.reversed() })
    }

    /// The arc of a circle or ellipse from an angle on.
    fn arc(&self, from: f64, turn: f64) -> Result<Curve> {
        let Self::Ellipse { plane, radii: [a, b] } = self else { return self.whole() };
        let angle = Interval::new(from, from + turn);
        if (a - b).abs() <= 1e-14 * a {
            let arc = Arc::new(Circle::new(*plane, *a)?, angle)?;
            return Ok(ArcCurve { arc, domain: angle }.into());
        }
        let arc = Arc::new(Circle::new(Plane::XY, 1.0)?, angle)?;
        let (x, y, o) = (plane.x_axis * *a, plane.y_axis * *b, plane.origin);
        let rows = [
            [x.x, y.x, plane.z_axis.x, o.x],
            [x.y, y.y, plane.z_axis.y, o.y],
            [x.z, y.z, plane.z_axis.z, o.z],
            [0.0, 0.0, 0.0, 1.0],
        ];
        Ok(arc.to_nurbs(angle)?.transformed(&Xform { rows })?.into())
    }

    /// The parameter of a point of a parabola or hyperbola.
    fn parameter(&self, p: Point3) -> f64 {
        match self {
            Self::Parabola { plane, focus } => plane.coordinates(p)[1] / (2.0 * focus),
            Self::Hyperbola { plane, radii } => (plane.coordinates(p)[1] / radii[1]).area_sine(),
            _ => 0.0,
        }
    }

    /// A parabola or hyperbola between two parameters: one conic section in Bernstein form (P&T, §7.3).
    fn branch(&self, a: f64, b: f64) -> Result<Curve> {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let (points, weight) = match self {
            Self::Parabola { plane, focus } => {
                let at = |square: f64, t: f64| plane.at(focus * square, 2.0 * focus * t, 0.0);
                ([at(a * a, a), at(a * b, middle), at(b * b, b)], 1.0)
            }
            Self::Hyperbola { plane, radii } => {
                let at = |t: f64, w: f64| {
                    plane.at(radii[0] * t.hyperbolic_cosine() / w, radii[1] * t.hyperbolic_sine() / w, 0.0)
                };
                ([at(a, 1.0), at(middle, half.hyperbolic_cosine()), at(b, 1.0)], half.hyperbolic_cosine())
            }
            _ => return self.whole(),
        };
        let (points, backwards) =
            if a <= b { (points, false) } else { ([points[2], points[1], points[0]], true) };
        let range = [a.min(b), a.max(b)];
        let knots = vec![range[0], range[0], range[1], range[1]];
        let curve: Curve = NurbsCurve::with_weights(2, &points, &[1.0, weight, 1.0], knots)?.into();
        Ok(if backwards { curve.reversed() } else { curve })
    }

    /// The part of a parabola or hyperbola that has the shadows of points on its plane, cast in a direction; of other
    /// curves all.
    pub(super) fn under(&self, points: &[Point3], along: Vector3) -> Result<Curve> {
        let (Self::Parabola { plane, .. } | Self::Hyperbola { plane, .. }) = self else {
            return self.whole();
        };
        let across = along.dot(plane.z_axis);
        let shadow = |p: Point3| {
            let by = plane.coordinates(p)[2] / across;
            self.parameter(p - along * by)
        };
        let (low, high) = points
            .iter()
            .map(|p| shadow(*p))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), t| (a.min(t), b.max(t)));
        if !(low < high && low.is_finite() && high.is_finite()) {
            return Err(katydid_geometry::Error::Degenerate { what: "curve", why: "it has no ends" }.into());
        }
        let margin = 0.01 * (high - low);
        self.branch(low - margin, high + margin)
    }

    /// All of a curve that has ends or closes.
    pub(super) fn whole(&self) -> Result<Curve> {
        match self {
            Self::Bounded(curve) => Ok(curve.clone()),
            Self::Ellipse { .. } => self.arc(0.0, TAU),
            _ => Err(katydid_geometry::Error::Degenerate { what: "curve", why: "it has no ends" }.into()),
        }
    }
}

/// The part of a curve between points on it.
fn part(curve: &Curve, start: Point3, end: Point3, tolerance: f64) -> Result<Curve> {
    let domain = curve.domain();
    let is_at = |p: Point3, q: Point3| p.distance_to(q) <= tolerance;
    if is_at(curve.start(), start) && is_at(curve.end(), end) {
        return Ok(curve.clone());
    }
    let a = if is_at(curve.start(), start) { domain.start } else { curve.closest_point(start)?.parameter };
    let b = if is_at(curve.end(), end) { domain.end } else { curve.closest_point(end)?.parameter };
    if curve.is_closed() {
        if start == end || (a - b).abs() <= 1e-12 * domain.length() {
            return Ok(curve.with_seam(a)?);
        }
        let b = if b == domain.start { domain.end } else { b };
        let a = if a == domain.end { domain.start } else { a };
        return Ok(curve.sub_curve(Interval::new(a, b))?);
    }
    Ok(curve.sub_curve(Interval::new(a, b))?)
}

impl Space<'_> {
    /// The formula of a curve.
    pub(super) fn carrier(&self, id: u64, depth: usize) -> Result<Carrier> {
        let record = self.file.record(id)?;
        self.spend()?;
        if depth > DEEPEST {
            return Err(record.refuse("curves that refer to each other in a circle"));
        }
        if self.file.is_complex(id) || spline::is_curve(record.keyword) {
            return Ok(Carrier::Bounded(spline::curve(self, id)?));
        }
        match record.keyword {
            "LINE" => Ok(Carrier::Line {
                point: self.point(record.reference(1)?)?,
                along: self.vector(record.reference(2)?)?,
            }),
            "CIRCLE" => {
                let radius = self.radius(&record, 2)?;
                Ok(Carrier::Ellipse { plane: self.frame(record.reference(1)?)?, radii: [radius; 2] })
            }
            "ELLIPSE" => {
                Ok(Carrier::Ellipse { plane: self.frame(record.reference(1)?)?, radii: self.radii(&record)? })
            }
            "HYPERBOLA" => Ok(Carrier::Hyperbola {
                plane: self.frame(record.reference(1)?)?,
                radii: self.radii(&record)?,
            }),
            "PARABOLA" => Ok(Carrier::Parabola {
                plane: self.frame(record.reference(1)?)?,
                focus: self.radius(&record, 2)?,
            }),
            "POLYLINE" => {
                let points =
                    record.references(1)?.into_iter().map(|p| self.point(p)).collect::<Result<Vec<_>>>()?;
                Ok(Carrier::Bounded(match points.as_slice() {
                    [a, b] => LineCurve::new(Line::new(*a, *b)).into(),
                    _ => PolylineCurve::new(points).map_err(|e| record.refuse(e))?.into(),
                }))
            }
            "SURFACE_CURVE" | "SEAM_CURVE" | "INTERSECTION_CURVE" | "BOUNDED_SURFACE_CURVE" => {
                self.carrier(record.reference(1)?, depth + 1)
            }
            "TRIMMED_CURVE" => self.trimmed(&record, depth).map(Carrier::Bounded),
            "COMPOSITE_CURVE" => self.composite(&record, depth).map(Carrier::Bounded),
            _ => Err(record.refuse("curves of this type are not supported")),
        }
    }

    fn radius(&self, record: &Record<'_>, place: usize) -> Result<f64> {
        let radius = self.length(record, place)?;
        if radius > 0.0 && radius.is_finite() {
            Ok(radius)
        } else {
            Err(record.refuse("its radius is not above 0"))
        }
    }

    fn radii(&self, record: &Record<'_>) -> Result<[f64; 2]> {
        Ok([self.radius(record, 2)?, self.radius(record, 3)?])
    }

    fn trimmed(&self, record: &Record<'_>, depth: usize) -> Result<Curve> {
        let basis = self.carrier(record.reference(1)?, depth + 1)?;
        let is_forward = record.flag(4)?;
        let trims = [record.select(2), record.select(3)];
        let by_points = record.word(5).is_ok_and(|word| word == "CARTESIAN");
        let mut ends = [Point3::ORIGIN; 2];
        let mut parameters = [0.0; 2];
        let mut has_parameters = true;
        for ((trim, end), parameter) in trims.into_iter().zip(&mut ends).zip(&mut parameters) {
            has_parameters &= trim.1.is_some();
            *parameter = trim.1.unwrap_or_default();
            match trim {
                (Some(point), None) => *end = self.point(point)?,
                (Some(point), Some(_)) if by_points => *end = self.point(point)?,
                (_, Some(t)) => {
                    *end = self.at(&basis, t).ok_or_else(|| record.refuse("an end is not on it"))?
                }
                _ => return Err(record.refuse("an end is not told")),
            }
        }
        // Parameters tell which way round, and a whole turn from none.
        if has_parameters
            && !by_points
            && let Carrier::Ellipse { .. } = basis
        {
            let [a, b] = parameters.map(|t| t * self.units.radians);
            let (from, to) = if is_forward { (a, b) } else { (b, a) };
            let turn = (to - from).rem_euclid(TAU);
            let arc = basis.arc(from, if turn <= SAME_ANGLE { TAU } else { turn })?;
            return Ok(if is_forward { arc } else { arc.reversed() });
        }
        if has_parameters
            && !by_points
            && let Carrier::Bounded(curve) = &basis
        {
            let [a, b] = if is_forward { parameters } else { [parameters[1], parameters[0]] };
            let domain = curve.domain();
            let cut = curve.sub_curve(Interval::new(domain.clamp(a), domain.clamp(b)))?;
            return Ok(if is_forward { cut } else { cut.reversed() });
        }
        basis.between(ends, is_forward, self.tolerance)
    }

    /// The point of a carrier at a parameter of the file.
    fn at(&self, carrier: &Carrier, t: f64) -> Option<Point3> {
        let angle = t * self.units.radians;
        let p = match carrier {
            Carrier::Line { point, along } => *point + *along * t,
            Carrier::Ellipse { plane, radii } => {
                plane.at(radii[0] * angle.cosine(), radii[1] * angle.sine(), 0.0)
            }
            Carrier::Parabola { plane, focus } => plane.at(focus * t * t, 2.0 * focus * t, 0.0),
            Carrier::Hyperbola { plane, radii } => {
                plane.at(radii[0] * t.hyperbolic_cosine(), radii[1] * t.hyperbolic_sine(), 0.0)
            }
            Carrier::Bounded(curve) => curve.point_at(curve.domain().clamp(t)),
        };
        p.is_finite().then_some(p)
    }

    fn composite(&self, record: &Record<'_>, depth: usize) -> Result<Curve> {
        let mut segments = Vec::new();
        for segment in record.references(1)? {
            let segment = self.file.record(segment)?;
            let curve = self.carrier(segment.reference(2)?, depth + 1)?.whole()?;
            segments.push(if segment.flag(1)? { curve } else { curve.reversed() });
        }
        match segments.as_slice() {
            [one] => Ok(one.clone()),
            _ => Ok(PolyCurve::new(segments).map_err(|error| record.refuse(error))?.into()),
        }
    }
}
