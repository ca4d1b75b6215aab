//! Parts that are one put together.

use super::{Continuity, Curve, PolyCurve, PolylineCurve};
use crate::thresholds;
use crate::{Arc, Interval, Line, Point3, Result, Tolerance};

impl Curve {
    /// The curve with straight and circular parts recognised as lines and arcs, and neighbours on one line or one
    /// circle put together, within the tolerance: no point moves by more than `tolerance.absolute`, and lines and arcs
    /// are merged only where they go on within `tolerance.angle`. A chain of lines becomes a polyline.
    ///
    /// # Errors
    /// A part has no extent.
    pub fn simplified(&self, tolerance: &Tolerance) -> Result<Self> {
        let mut parts: Vec<Self> = Vec::new();
        self.collect_simple(tolerance, &mut parts)?;
        let mut merged: Vec<Self> = Vec::new();
        // Vertices swallowed by the last line: none may be farther from it than the tolerance.
        let mut swallowed: Vec<Point3> = Vec::new();
        for part in parts {
            let joined = match (merged.last(), &part) {
                (Some(Self::Line(a)), Self::Line(b)) => {
                    let line = Line::new(a.line.from, b.line.to);
                    let smooth = a.line.direction().angle_to(b.line.direction());
                    swallowed.push(b.line.from);
                    let near = swallowed.iter().all(|&p| line.distance_to(p) <= tolerance.absolute);
                    let ok = smooth.is_some_and(|x| x <= tolerance.angle) && near && line.length() > 0.0;
                    ok.then(|| Self::from(line))
                }
                (Some(Self::Arc(a)), Self::Arc(b)) => merged_arcs(&a.arc, &b.arc, tolerance).map(Self::from),
                _ => None,
            };
            match joined {
                Some(joined) => {
                    merged.pop();
                    merged.push(joined);
                }
                None => {
                    swallowed.clear();
                    merged.push(part);
                }
            }
        }
        if merged.iter().all(|c| matches!(c, Self::Line(_))) && merged.len() > 1 {
            let mut points = vec![self.start()];
            points.extend(merged.iter().map(Self::end));
            return Ok(PolylineCurve::new(points)?.into());
        }
        if merged.len() == 1
            && let Some(only) = merged.pop()
        {
            return Ok(only);
        }
        Ok(PolyCurve::new(merged)?.into())
    }

    fn collect_simple(&self, tolerance: &Tolerance, out: &mut Vec<Self>) -> Result<()> {
        match self {
            Self::Line(_) | Self::Arc(_) => out.push(self.clone()),
            Self::Poly(c) => {
                for s in c.segments() {
                    s.collect_simple(tolerance, out)?;
                }
            }
            _ => {
                if let Some(points) = self.as_polyline() {
                    let segments = points.windows(2).filter(|w| w[0] != w[1]);
                    out.extend(segments.map(|w| Self::from(Line::new(w[0], w[1]))));
                    return Ok(());
                }
                if let Some(line) = self.as_line(tolerance.absolute) {
                    out.push(line.into());
                    return Ok(());
                }
                if let Some(arc) = self.as_arc(tolerance.absolute) {
                    out.push(arc.into());
                    return Ok(());
                }
                let domain = self.domain();
                let mut cuts: Vec<f64> = self.discontinuities(Continuity::C2, tolerance);
                cuts.retain(|&t| domain.start < t && t < domain.end);
                cuts.insert(0, domain.start);
                cuts.push(domain.end);
                let mut rest: Option<Interval> = None;
                for w in cuts.windows(2) {
                    let range = Interval::new(w[0], w[1]);
                    let part = self.trimmed(range)?;
                    let simple: Option<Self> = part
                        .as_line(tolerance.absolute)
                        .map(Into::into)
                        .or_else(|| part.as_arc(tolerance.absolute).map(Into::into));
                    match simple {
                        Some(simple) => {
                            if let Some(r) = rest.take() {
                                out.push(self.trimmed(r)?);
                            }
                            out.push(simple);
                        }
                        None => rest = Some(rest.map_or(range, |r| Interval::new(r.start, range.end))),
                    }
                }
                if let Some(r) = rest {
                    out.push(self.trimmed(r)?);
                }
            }
        }
        Ok(())
    }
}

/// One arc for two that follow each other on one circle.
fn merged_arcs(a: &Arc, b: &Arc, tolerance: &Tolerance) -> Option<Arc> {
    let (ca, cb) = (a.circle, b.circle);
    let near = ca.center().distance_to(cb.center()) <= 0.25 * tolerance.absolute
        && (ca.radius - cb.radius).abs() <= 0.25 * tolerance.absolute;
    let turned = ca.plane.z_axis.angle_to(cb.plane.z_axis)?;
    if !(near
        && turned * ca.radius <= 0.25 * tolerance.absolute
        && a.end().distance_to(b.start()) <= tolerance.absolute)
    {
        return None;
    }
    let end = a.angle.end + b.angle.length();
    (end - a.angle.start <= std::f64::consts::TAU * (1.0 + thresholds::WHOLE_TURN)).then(|| Arc {
        circle: ca,
        angle: Interval::new(a.angle.start, end.min(a.angle.start + std::f64::consts::TAU)),
    })
}
