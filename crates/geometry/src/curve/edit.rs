//! The same curve in another place, direction or domain, and parts of it.

use super::{ArcCurve, Curve, LineCurve, PolyCurve, PolylineCurve};
use crate::curve::thresholds::LEAST_TRIM;
use crate::{Arc, Error, Interval, Line, Point3, Result, Xform};

/// The part of a segment that is rounding.
const SPECK: f64 = 1e-12;

impl Curve {
    /// The same points walked from the end to the start; the domain a…b becomes −b…−a, as in openNURBS.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let negated = |d: Interval| Interval::new(-d.end, -d.start);
        match self {
            Self::Line(c) => LineCurve { line: c.line.reversed(), domain: negated(c.domain) }.into(),
            Self::Arc(c) => ArcCurve { arc: c.arc.reversed(), domain: negated(c.domain) }.into(),
            Self::Polyline(c) => Self::Polyline(c.reversed()),
            Self::Nurbs(c) => c.reversed().into(),
            Self::Poly(c) => Self::Poly(c.reversed()),
        }
    }

    /// The exact image. Arcs stay arcs where angles survive the map and become rational NURBS curves of degree 2
    /// where they do not; a mirrored arc is walked as its original is.
    ///
    /// # Errors
    /// A number overflows, or a projective map sends part of the curve to infinity.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        match self {
            Self::Line(c) => {
                let line = c.line.transformed(xform);
                if !line.is_finite() {
                    return Err(Error::NotFinite("transformed line"));
                }
                Ok(LineCurve { line, domain: c.domain }.into())
            }
            Self::Arc(c) => match c.arc.transformed(xform) {
                Some(arc) => Ok(ArcCurve { arc, domain: c.domain }.into()),
                None => Ok(c.to_nurbs()?.transformed(xform)?.into()),
            },
            Self::Polyline(c) => {
                let points = c.points().iter().map(|&p| xform.point(p)).collect();
                Ok(PolylineCurve::with_parameters(points, c.parameters().to_vec())?.into())
            }
            Self::Nurbs(c) => Ok(c.transformed(xform)?.into()),
            Self::Poly(c) => {
                let segments = c.segments().iter().map(|s| s.transformed(xform)).collect::<Result<_>>()?;
                Ok(PolyCurve::with_parameters(segments, c.parameters().to_vec())?.into())
            }
        }
    }

    /// The same curve over another domain; the parameter is mapped linearly.
    ///
    /// # Errors
    /// The domain does not increase, or is too small to hold the curve's own parameters apart.
    pub fn with_domain(&self, domain: Interval) -> Result<Self> {
        if !domain.is_increasing() {
            return Err(Error::Invalid {
                what: "domain",
                why: format!("{} to {} does not increase", domain.start, domain.end),
            });
        }
        let old = self.domain();
        if old == domain {
            return Ok(self.clone());
        }
        let mapped = |ts: &[f64]| ts.iter().map(|&t| domain.at(old.normalized(t))).collect::<Vec<_>>();
        Ok(match self {
            Self::Line(c) => LineCurve { domain, ..*c }.into(),
            Self::Arc(c) => ArcCurve { domain, ..*c }.into(),
            Self::Polyline(c) => {
                PolylineCurve::with_parameters(c.points().to_vec(), mapped(c.parameters()))?.into()
            }
            Self::Nurbs(c) => c.with_domain(domain)?.into(),
            Self::Poly(c) => {
                PolyCurve::with_parameters(c.segments().to_vec(), mapped(c.parameters()))?.into()
            }
        })
    }

    /// The part between two parameters, with its part of the domain.
    ///
    /// # Errors
    /// The range does not increase or leaves the domain.
    pub fn trimmed(&self, range: Interval) -> Result<Self> {
        let domain = self.domain();
        let (a, b) = (range.start, range.end);
        if !(a < b && domain.start <= a && b <= domain.end) {
            return Err(Error::Invalid {
                what: "trim range",
                why: format!("{a} to {b} is not an increasing part of {} to {}", domain.start, domain.end),
            });
        }
        if range == domain {
            return Ok(self.clone());
        }
        match self {
            Self::Line(c) => {
                Ok(LineCurve { line: Line::new(c.point_at(a), c.point_at(b)), domain: range }.into())
            }
            Self::Arc(c) => {
                let angle = Interval::new(c.angle_at(a), c.angle_at(b));
                if !(angle.start < angle.end) {
                    return Err(Error::degenerate("trimmed arc", "nothing is left of it"));
                }
                Ok(ArcCurve { arc: Arc { angle, ..c.arc }, domain: range }.into())
            }
            Self::Polyline(c) => {
                let ends = [c.point_at(a), c.point_at(b)];
                // A corner that only rounding has left beside an end is the end.
                let mut inside: Vec<(f64, Point3)> = (c.parameters().iter().copied())
                    .zip(c.points().iter().copied())
                    .filter(|(t, _)| a < *t && *t < b)
                    .collect();
                if inside.first().is_some_and(|(_, p)| ends[0].coincides(*p)) {
                    inside.remove(0);
                }
                if inside.last().is_some_and(|(_, p)| ends[1].coincides(*p)) {
                    inside.pop();
                }
                let (mut ts, mut points) = (vec![a], vec![ends[0]]);
                for (t, p) in inside {
                    ts.push(t);
                    points.push(p);
                }
                ts.push(b);
                points.push(ends[1]);
                Ok(PolylineCurve::with_parameters(points, ts)?.into())
            }
            Self::Nurbs(c) => Ok(c.trimmed(range)?.into()),
            Self::Poly(c) => {
                let (mut segments, mut ts) = (Vec::new(), vec![a]);
                for (i, segment) in c.segments().iter().enumerate() {
                    let part = c.segment_domain(i);
                    let Some(both) = part.intersection(range).filter(|r| r.start < r.end) else { continue };
                    // What only rounding has left of a segment is not kept.
                    if both.length() <= SPECK * part.length() && range.length() > LEAST_TRIM * part.length() {
                        continue;
                    }
                    let own = segment.domain();
                    let inner = Interval::new(
                        if both.start == part.start {
                            own.start
                        } else {
                            c.to_segment_parameter(i, both.start)
                        },
                        if both.end == part.end { own.end } else { c.to_segment_parameter(i, both.end) },
                    );
                    if inner.start < inner.end {
                        segments.push(segment.trimmed(inner)?);
                        ts.push(both.end);
                    }
                }
                if let Some(last) = ts.last_mut() {
                    *last = b;
                }
                if segments.len() == 1
                    && let Some(only) = segments.pop()
                {
                    return only.with_domain(range);
                }
                Ok(PolyCurve::with_parameters(segments, ts)?.into())
            }
        }
    }

    /// The part from one parameter to another. On a closed curve a range that decreases goes through the seam and
    /// the part's domain starts at `range.start`; on an open one it is the part between, walked backwards.
    ///
    /// # Errors
    /// The range is empty or leaves the domain.
    pub fn sub_curve(&self, range: Interval) -> Result<Self> {
        if range.start <= range.end {
            return self.trimmed(range);
        }
        if !self.is_closed() {
            return Ok(self.trimmed(range.reversed())?.reversed());
        }
        let domain = self.domain();
        if range.start == domain.end {
            return self.trimmed(Interval::new(domain.start, range.end));
        }
        let first = self.trimmed(Interval::new(range.start, domain.end))?;
        if range.end == domain.start {
            return Ok(first);
        }
        over_seam(first, self.trimmed(Interval::new(domain.start, range.end))?)
    }

    /// The same closed curve starting at `t`: the domain starts there and keeps its length.
    ///
    /// # Errors
    /// The curve is open, or `t` is outside its domain.
    pub fn with_seam(&self, t: f64) -> Result<Self> {
        if !self.is_closed() {
            return Err(Error::degenerate("curve", "an open curve has no seam to move"));
        }
        let domain = self.domain();
        if t == domain.start || t == domain.end {
            return Ok(self.clone());
        }
        if let Self::Arc(c) = self {
            let start = c.angle_at(t);
            if !domain.contains(t) {
                return Err(Error::OutOfRange { what: "seam", value: t, must: "inside the domain" });
            }
            let angle = Interval::new(start, start + std::f64::consts::TAU);
            let domain = Interval::new(t, t + domain.length());
            return Ok(ArcCurve { arc: Arc { angle, ..c.arc }, domain }.into());
        }
        let first = self.trimmed(Interval::new(t, domain.end))?;
        over_seam(first, self.trimmed(Interval::new(domain.start, t))?)
    }

    /// The pieces between parameters, in order. Parameters outside the domain are ignored, and so are those that rounding
    /// alone tells apart from another one or from an end of the domain.
    ///
    /// A closed curve is cut into as many pieces as there are parameters: unless it is cut at its seam, the piece
    /// over the seam is one, and it is the last, as Rhino has it. Without a parameter the curve comes back whole.
    ///
    /// # Errors
    /// A piece is too short to be a curve.
    pub fn split_at(&self, parameters: &[f64]) -> Result<Vec<Self>> {
        let domain = self.domain();
        let mut cuts: Vec<f64> = parameters.iter().copied().filter(|t| domain.contains(*t)).collect();
        cuts.sort_by(f64::total_cmp);
        // Parameters that were computed carry a few roundings of the largest number in the domain.
        let rounding = 16.0 * f64::EPSILON * domain.start.abs().max(domain.end.abs());
        cuts.dedup_by(|a, b| (*a - *b).abs() <= rounding);
        let at_seam = cuts.first().is_some_and(|t| t - domain.start <= rounding)
            || cuts.last().is_some_and(|t| domain.end - t <= rounding);
        cuts.retain(|&t| t - domain.start > rounding && domain.end - t > rounding);
        if cuts.is_empty() {
            return Ok(vec![self.clone()]);
        }
        let mut ends = vec![domain.start];
        ends.append(&mut cuts);
        ends.push(domain.end);
        let mut parts =
            ends.windows(2).map(|w| self.trimmed(Interval::new(w[0], w[1]))).collect::<Result<Vec<_>>>()?;
        if self.is_closed() && !at_seam && parts.len() > 1 {
            let first = parts.remove(0);
            if let Some(last) = parts.pop() {
                parts.push(over_seam(last, first)?);
            }
        }
        Ok(parts)
    }

    /// The curve with straight pieces of given lengths added at its ends along the tangents; 0 adds none. The domain
    /// grows by the lengths. A line or polyline stays one.
    ///
    /// # Errors
    /// The curve is closed, a length is negative or not finite, or there is no tangent at the end.
    pub fn extended_by_lines(&self, at_start: f64, at_end: f64) -> Result<Self> {
        for value in [at_start, at_end] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange {
                    what: "extension",
                    value,
                    must: "a finite length, 0 or more",
                });
            }
        }
        if self.is_closed() {
            return Err(Error::degenerate("curve", "a closed curve has no ends to extend"));
        }
        let none = Error::degenerate("curve", "it has no direction at its end");
        let domain = self.domain();
        let before = self.start() - self.tangent_at(domain.start).ok_or(none.clone())? * at_start;
        let after = self.end() + self.tangent_on_side(domain.end, true).ok_or(none)? * at_end;
        match self {
            Self::Line(c) => {
                let domain = Interval::new(domain.start - at_start, domain.end + at_end);
                let line = Line::new(
                    if at_start > 0.0 { before } else { c.line.from },
                    if at_end > 0.0 { after } else { c.line.to },
                );
                Ok(LineCurve { line, domain }.into())
            }
            Self::Polyline(c) => {
                let (mut points, mut ts) = (c.points().to_vec(), c.parameters().to_vec());
                if let (Some(p), Some(t)) = (points.first_mut(), ts.first_mut()) {
                    *p = if at_start > 0.0 { before } else { *p };
                    *t -= at_start;
                }
                if let (Some(p), Some(t)) = (points.last_mut(), ts.last_mut()) {
                    *p = if at_end > 0.0 { after } else { *p };
                    *t += at_end;
                }
                Ok(PolylineCurve::with_parameters(points, ts)?.into())
            }
            _ => {
                let (mut segments, mut ts) = (Vec::new(), Vec::new());
                if at_start > 0.0 {
                    segments.push(Line::new(before, self.start()).into());
                    ts.push(domain.start - at_start);
                }
                ts.push(domain.start);
                match self {
                    Self::Poly(c) => {
                        segments.extend_from_slice(c.segments());
                        ts.extend_from_slice(c.parameters().get(1..).unwrap_or(&[]));
                    }
                    other => {
                        segments.push(other.clone());
                        ts.push(domain.end);
                    }
                }
                if at_end > 0.0 {
                    segments.push(Line::new(self.end(), after).into());
                    ts.push(domain.end + at_end);
                }
                if segments.len() == 1 {
                    return Ok(self.clone());
                }
                Ok(PolyCurve::with_parameters(segments, ts)?.into())
            }
        }
    }
}

/// One curve from the part that ends at a seam and the part that starts there. The domain starts with the first's.
fn over_seam(first: Curve, second: Curve) -> Result<Curve> {
    let (a, b) = (first.domain(), second.domain());
    let shifted = Interval::new(a.end, a.end + b.length());
    match (&first, &second) {
        (Curve::Arc(x), Curve::Arc(y)) if x.arc.circle == y.arc.circle => {
            let angle = Interval::new(x.arc.angle.start, x.arc.angle.end + y.arc.angle.length());
            let arc = Arc { circle: x.arc.circle, angle };
            Ok(ArcCurve { arc, domain: Interval::new(a.start, shifted.end) }.into())
        }
        (Curve::Polyline(x), Curve::Polyline(y)) => {
            let mut points = x.points().to_vec();
            let mut ts = x.parameters().to_vec();
            points.extend_from_slice(y.points().get(1..).unwrap_or(&[]));
            ts.extend(y.parameters().iter().skip(1).map(|t| a.end + (t - b.start)));
            Ok(PolylineCurve::with_parameters(points, ts)?.into())
        }
        _ => {
            let was_one = matches!((&first, &second), (Curve::Nurbs(_), Curve::Nurbs(_)));
            let (mut segments, mut ts) = (Vec::new(), vec![a.start]);
            for (part, end) in [(first, a.end), (second, shifted.end)] {
                let shift = end - part.domain().end;
                match part {
                    Curve::Poly(c) => {
                        ts.extend(c.parameters().iter().skip(1).map(|t| t + shift));
                        segments.extend(c.into_parts().0);
                    }
                    other => {
                        ts.push(end);
                        segments.push(other);
                    }
                }
            }
            let all_nurbs = segments.iter().all(|s| matches!(s, Curve::Nurbs(_)));
            let joined: Curve = PolyCurve::with_parameters(segments, ts)?.into();
            // What was one NURBS curve stays one, with a full knot at the old seam.
            if all_nurbs && was_one { Ok(joined.to_nurbs()?.into()) } else { Ok(joined) }
        }
    }
}

impl PolylineCurve {
    /// The same vertices from the last to the first, with negated parameters.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let points = self.points().iter().rev().copied().collect();
        let parameters = self.parameters().iter().rev().map(|t| -t).collect();
        Self::from_checked(points, parameters)
    }
}

impl PolyCurve {
    /// The same segments from the last to the first, each reversed.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let segments = self.segments().iter().rev().map(Curve::reversed).collect();
        let parameters = self.parameters().iter().rev().map(|t| -t).collect();
        self.with_same_depth(segments, parameters)
    }
}
