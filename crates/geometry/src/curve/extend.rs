//! Curves made longer at their ends.

use super::{ArcCurve, Curve, PolyCurve};
use crate::curve::thresholds::{LENGTH_DONE, LENGTH_SHARE, STRAIGHT_EXTENSION};
use crate::quadrature::integrate;
use crate::{Arc, Circle, Error, Interval, Plane, Result};

/// How a curve goes on beyond its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ExtensionStyle {
    /// Straight, along the tangent.
    Line,
    /// By an arc with the tangent and curvature of the end; straight where that is straight.
    Arc,
    /// As the end itself goes on: lines straight, arcs round, NURBS curves by their last polynomial, so that all
    /// derivatives are continuous.
    Smooth,
}

impl Curve {
    /// The curve made longer by `at_start` and `at_end`, lengths along the extension; 0 adds nothing. The domain
    /// grows: by the lengths for lines and arcs, by the parameter that the polynomial needs for smooth extensions.
    ///
    /// # Errors
    /// The curve is closed, a length is negative or not finite, an end has no direction, an arc would become more
    /// than a full circle, or a rational curve's extension reaches infinity before the length.
    pub fn extended(&self, at_start: f64, at_end: f64, style: ExtensionStyle) -> Result<Self> {
        for value in [at_start, at_end] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange {
                    what: "extension",
                    value,
                    must: "a finite length, 0 or more",
                });
            }
        }
        if style == ExtensionStyle::Line {
            return self.extended_by_lines(at_start, at_end);
        }
        if self.is_closed() {
            return Err(Error::degenerate("curve", "a closed curve has no ends to extend"));
        }
        let longer = if at_end > 0.0 { self.end_extended(at_end, style)? } else { self.clone() };
        if at_start > 0.0 {
            Ok(longer.reversed().end_extended(at_start, style)?.reversed())
        } else {
            Ok(longer)
        }
    }

    fn end_extended(&self, length: f64, style: ExtensionStyle) -> Result<Self> {
        match (self, style) {
            (Self::Line(_) | Self::Polyline(_), _) => self.extended_by_lines(0.0, length),
            (Self::Arc(c), _) => arc_extended(c, length),
            (Self::Nurbs(c), ExtensionStyle::Smooth) => {
                if c.degree() == 1 {
                    return self.extended_by_lines(0.0, length);
                }
                let domain = c.domain();
                let end = parameter_beyond(c, length)?;
                Ok(c.extended_to(Interval::new(domain.start, end))?.into())
            }
            (Self::Poly(c), ExtensionStyle::Smooth) => {
                let (mut segments, mut parameters) = c.clone().into_parts();
                if let (Some(last), Some(t)) = (segments.pop(), parameters.last_mut()) {
                    let longer = last.end_extended(length, style)?;
                    *t += (longer.domain().length() / last.domain().length() - 1.0)
                        * c.segment_domain(segments.len()).length();
                    segments.push(longer);
                }
                Ok(PolyCurve::with_parameters(segments, parameters)?.into())
            }
            (_, ExtensionStyle::Line | ExtensionStyle::Arc) => {
                let t = self.domain().end;
                let tangent = self
                    .tangent_on_side(t, true)
                    .ok_or(Error::degenerate("curve", "it has no direction at its end"))?;
                let k = self.curvature_on_side(t, true);
                let Some(toward) = k.unitized().filter(|_| k.length() * length > STRAIGHT_EXTENSION) else {
                    return self.extended_by_lines(0.0, length);
                };
                let radius = 1.0 / k.length();
                let frame = Plane::from_axes(self.end() + toward * radius, -toward, tangent)?;
                let angle = length / radius;
                if angle > std::f64::consts::TAU {
                    return Err(more_than_a_turn(length));
                }
                let arc = Arc::new(Circle::new(frame, radius)?, Interval::new(0.0, angle))?;
                let (mut segments, mut parameters) = match self {
                    Self::Poly(c) => c.clone().into_parts(),
                    other => (vec![other.clone()], vec![self.domain().start, t]),
                };
                segments.push(ArcCurve::new(arc).into());
                parameters.push(t + length);
                Ok(PolyCurve::with_parameters(segments, parameters)?.into())
            }
        }
    }
}

fn more_than_a_turn(length: f64) -> Error {
    Error::OutOfRange {
        what: "extension",
        value: length,
        must: "short enough not to go round more than once",
    }
}

fn arc_extended(c: &ArcCurve, length: f64) -> Result<Curve> {
    let more = length / c.arc.circle.radius;
    let sweep = c.arc.angle.length();
    if sweep + more > std::f64::consts::TAU {
        return Err(more_than_a_turn(length));
    }
    let angle = Interval::new(c.arc.angle.start, c.arc.angle.end + more);
    let domain = Interval::new(c.domain.start, c.domain.end + c.domain.length() * more / sweep);
    Ok(ArcCurve { arc: Arc { angle, ..c.arc }, domain }.into())
}

/// The parameter beyond the end at which the last polynomial has gone on by a length: Newton's method on the length,
/// in steps that do not more than double the range.
fn parameter_beyond(c: &crate::NurbsCurve, length: f64) -> Result<f64> {
    let end = c.domain().end;
    let speed = |t: f64| c.derivatives(t, 1, true).1.first().map_or(0.0, |d| d.length());
    let span = c.span_parameters();
    let last = span.len().checked_sub(2).and_then(|i| span.get(i)).map_or(1.0, |t| end - t);
    let lost = Error::degenerate("curve", "its last polynomial does not go on that far");
    let mut low = end;
    let mut gone = 0.0;
    let mut step = last;
    let first = speed(end);
    if first > 0.0 {
        step = step.min(length / first);
    }
    for _ in 0..200 {
        let next = low + step;
        let part = integrate(&|t| [speed(t)], low, next, LENGTH_SHARE * length)[0];
        if !part.is_finite() {
            return Err(lost);
        }
        if (gone + part - length).abs() <= LENGTH_DONE * length {
            return Ok(next);
        }
        if gone + part < length {
            gone += part;
            low = next;
            let v = speed(next);
            let newton = (length - gone) / v;
            step = if newton.is_finite() { newton.min(2.0 * step) } else { step };
            if next > end + 1e6 * c.domain().length() {
                return Err(lost);
            }
        } else {
            // Too far: the wanted point is inside, at the secant's place.
            step *= ((length - gone) / part).clamp(0.05, 0.999);
        }
        if low + step == low {
            return Ok(low);
        }
    }
    Err(lost)
}
