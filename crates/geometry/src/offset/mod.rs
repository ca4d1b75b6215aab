//! Offsets in a plane.

mod approximate;
mod chain;
mod corner;
mod mitre;
mod restyle;
mod simple;
mod thresholds;
mod trim;
mod validity;

use crate::curve::{ArcCurve, Continuity, Curve, Shape};
use crate::offset::thresholds::{EXACT_ANGLE, EXACT_OFFSET, INSIDE_UNIT};
use crate::polynomial::{Hodograph, dot};
use crate::{Arc, Circle, Error, Interval, Line, Plane, Result, Tolerance};
pub(crate) use chain::{Sets, gather};
use corner::{Bridge, Corner, bridge};
pub(crate) use simple::right_of;
use validity::Cap;

/// What fills the gap that an offset leaves on the outside of a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum OffsetCorner {
    /// Nothing: the parts stay apart.
    None,
    /// The tangents, to where they meet.
    #[default]
    Sharp,
    /// An arc about the corner.
    Round,
    /// A curve with the tangents and curvatures of both sides.
    Smooth,
    /// A straight segment.
    Chamfer,
}

/// A smooth part of an offset and where it came from.
#[derive(Debug, Clone)]
struct RawPart {
    curve: Curve,
    /// For one that is not exact, what it approximates the offset of, by the same parameter.
    source: Option<Curve>,
    /// The corner that it goes round.
    corner: Option<Corner>,
}

impl RawPart {
    fn exact(curve: Curve) -> Self {
        Self { curve, source: None, corner: None }
    }
}

/// An offset before its loops are cut away.
struct Raw {
    parts: Vec<RawPart>,
    /// The smooth parts of the source.
    smooth: Vec<Curve>,
    /// Filled corners with another border than an arc.
    caps: Vec<Cap>,
}

impl Curve {
    /// The curves at a distance to the right of this one, seen along its direction with the plane's normal up; a
    /// negative distance goes to the left. So a counter-clockwise closed curve grows. Loops are removed: every point
    /// of the result is at least the distance away from the curve (a chamfer or a blend at a corner may come nearer
    /// to such corners, and to nothing else), and what has no such point is empty.
    ///
    /// Lines and arcs give exact lines and arcs. Other curves give cubics with the certified property that the point
    /// at each parameter is within `tolerance.absolute` of the exact offset of one point of the curve: Hermite pieces
    /// halved until Bernstein coefficients bound both parts of the error (derived), then thinned by
    /// [`NurbsCurve::remove_knots`](crate::NurbsCurve::remove_knots). Parts where the radius of curvature is below
    /// the distance on the inner side are cut out at their cusps. The rest is cut at all crossings of parts, at the
    /// ends of their overlaps, and for open curves and curves that cross themselves also where they meet the offset
    /// on the other side and the circles about the ends. A stretch is kept where the exact offset at its parameters
    /// is far enough from the curve; stretches are put together at the cuts, and what comes back to a cut is a curve
    /// of its own. Chamfers and blends take the place of round corners in the result, where they cross nothing and
    /// come too near to nothing but such corners; elsewhere the corner stays round. A chamfer spans what is left of a
    /// corner, a blend only a whole one.
    ///
    /// What comes back: of a closed curve that does not cross or touch itself, closed curves that touch neither
    /// themselves nor each other but at single points (with [`OffsetCorner::None`], the open stretches of them). Of
    /// an open curve, open curves, which end where the curve's ends come too near, and closed ones around holes. A
    /// curve that crosses itself gives that part of the border of all points near to it which lies to the asked
    /// side: mostly open curves that end where this side goes over into the other. Features of the border smaller
    /// than three tolerances may be missing.
    ///
    /// Sources: W. Tiller and E. Hanson, *Offsets of two-dimensional profiles*, IEEE CG&A 4 (1984); G. Elber, I. Lee,
    /// M. Kim, *Comparing offset curve approximation methods*, IEEE CG&A 17 (1997), for the alternatives.
    ///
    /// # Errors
    /// The distance is not finite, the tolerance not above 0, the curve not parallel to the plane within it, a
    /// part without direction, a curve so wild that it needs thousands of cubics, or parts that meet so often (hundreds
    /// of thousands of pairs, more than about a second of work) that it is refused.
    pub fn offset(
        &self,
        plane: &Plane,
        distance: f64,
        corner: OffsetCorner,
        tolerance: &Tolerance,
    ) -> Result<Vec<Self>> {
        if !(distance.is_finite() && plane.is_finite()) {
            return Err(Error::NotFinite("offset distance or plane"));
        }
        if !(tolerance.absolute > 0.0 && tolerance.absolute.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance.absolute,
                must: "finite and greater than 0",
            });
        }
        let height = self.extent_along(plane.z_axis);
        if !(height.length() <= tolerance.absolute) {
            return Err(Error::degenerate("curve to offset", "it does not lie parallel to the plane"));
        }
        if distance == 0.0 {
            return Ok(vec![self.clone()]);
        }
        if corner == OffsetCorner::Sharp
            && let Some(plain) = self.plain_mitre(plane, distance, tolerance.absolute)
        {
            return Ok(vec![plain]);
        }
        // Chamfers and blends take the place of arcs in what is left.
        let drawn = match corner {
            OffsetCorner::Chamfer | OffsetCorner::Smooth => OffsetCorner::Round,
            other => other,
        };
        let raw = self.raw_offset(plane, distance, drawn, tolerance)?;
        trim::cleaned(self, &raw, plane, distance, corner, tolerance)
    }

    /// The offsets of all smooth parts in order, with the gaps at outer corners filled, inverted parts left out.
    fn raw_offset(
        &self,
        plane: &Plane,
        distance: f64,
        corner: OffsetCorner,
        tolerance: &Tolerance,
    ) -> Result<Raw> {
        let smooth = self.smooth_parts()?;
        let mut groups: Vec<Vec<RawPart>> = Vec::with_capacity(smooth.len());
        for part in &smooth {
            groups.push(offset_part(part, plane, distance, tolerance.absolute)?);
        }
        let n = smooth.len();
        let mut bridges: Vec<Vec<RawPart>> = vec![Vec::new(); n];
        let mut caps = Vec::new();
        let closed = self.is_closed();
        for i in 0..if closed { n } else { n.saturating_sub(1) } {
            let j = (i + 1) % n;
            let Bridge { parts, cap } = bridge(&smooth[i], &smooth[j], plane, distance, corner)?;
            bridges[i] = parts;
            caps.extend(cap);
            if corner == OffsetCorner::Sharp && i != j {
                let (first, second) = two(&mut groups, i, j);
                corner::merge_lines(first, &mut bridges[i], second);
            }
        }
        let mut parts = Vec::new();
        for (group, bridge) in groups.into_iter().zip(bridges) {
            parts.extend(group);
            parts.extend(bridge);
        }
        Ok(Raw { parts, smooth, caps })
    }

    /// The curve as parts without kinks, lines and arcs recognised.
    pub(crate) fn smooth_parts(&self) -> Result<Vec<Self>> {
        match self {
            Self::Poly(c) => {
                let mut out = Vec::new();
                for s in c.segments() {
                    out.extend(s.smooth_parts()?);
                }
                Ok(out)
            }
            Self::Line(c) if c.line.from == c.line.to => Ok(Vec::new()),
            Self::Line(_) | Self::Arc(_) => Ok(vec![self.clone()]),
            _ => {
                if let Some(points) = self.as_polyline() {
                    let segments = points.windows(2).filter(|w| w[0] != w[1]);
                    return Ok(segments.map(|w| Line::new(w[0], w[1]).into()).collect());
                }
                let tight = Tolerance { absolute: EXACT_OFFSET, angle: EXACT_ANGLE };
                let domain = self.domain();
                let mut cuts = self.discontinuities(Continuity::G1, &tight);
                let size = self.hull_points().iter().fold(0.0_f64, |m, p| m.max(p.to_vector().length()));
                let exact = crate::thresholds::ROUNDING * size;
                // Spans in one place are no part, and where a span turns straight back one part ends.
                let mut still: Vec<f64> = Vec::new();
                for piece in self.pieces() {
                    let Shape::Span(c, j) = piece.shape else { continue };
                    let points: Vec<_> = c.span_hull(j).collect();
                    if points.iter().all(|p| p.distance_to(points[0]) <= exact) {
                        still.push(piece.whole.start);
                        cuts.extend([piece.whole.start, piece.whole.end]);
                    } else {
                        cuts.extend(cusps(&c.bezier_points(j)).map(|x| piece.whole.at(x)));
                    }
                }
                cuts.sort_by(f64::total_cmp);
                cuts.dedup();
                cuts.retain(|&t| domain.start < t && t < domain.end);
                cuts.insert(0, domain.start);
                cuts.push(domain.end);
                cuts.windows(2)
                    .filter(|w| !still.contains(&w[0]))
                    .map(|w| {
                        let part = self.trimmed(Interval::new(w[0], w[1]))?;
                        if let Some(line) = part.as_line(exact) {
                            return Ok(line.into());
                        }
                        Ok(part.as_arc(exact).map_or(part, Into::into))
                    })
                    .collect()
            }
        }
    }
}

/// Where a Bézier curve stands still inside its domain, with rounding.
fn cusps(points: &[[f64; 4]]) -> impl Iterator<Item = f64> {
    let tangent = Hodograph::new(points).tangent;
    let squared = dot(&tangent, &tangent);
    let slope = squared.derivative();
    let limit = crate::thresholds::NO_LENGTH_SQUARED * squared.size();
    let roots = slope.roots(crate::thresholds::POLYNOMIAL_ZERO * slope.size());
    roots.into_iter().filter(move |&x| INSIDE_UNIT < x && x < 1.0 - INSIDE_UNIT && squared.at(x) <= limit)
}

/// Two different elements of a list at once.
fn two<T>(list: &mut [T], i: usize, j: usize) -> (&mut T, &mut T) {
    if i < j {
        let (a, b) = list.split_at_mut(j);
        (&mut a[i], &mut b[0])
    } else {
        let (a, b) = list.split_at_mut(i);
        (&mut b[0], &mut a[j])
    }
}

/// The offset of one smooth part: nothing where it would be turned inside out.
fn offset_part(part: &Curve, plane: &Plane, distance: f64, tolerance: f64) -> Result<Vec<RawPart>> {
    match part {
        Curve::Line(c) => {
            let v = right_of(c.line.direction(), plane)? * distance;
            let line = Line::new(c.line.from + v, c.line.to + v);
            Ok(vec![RawPart::exact(line.into())])
        }
        Curve::Arc(c) => {
            let own = c.arc.circle.plane;
            let side = if own.z_axis.dot(plane.z_axis) >= 0.0 { 1.0 } else { -1.0 };
            let radius = c.arc.circle.radius + side * distance;
            if !(radius > crate::thresholds::ROUNDING * c.arc.circle.radius) {
                return Ok(Vec::new());
            }
            let circle = Circle::new(own, radius)?;
            let arc: ArcCurve = Arc { circle, ..c.arc }.into();
            Ok(vec![RawPart::exact(arc.into())])
        }
        other => {
            let source = other.to_nurbs()?;
            let parts = approximate::offset_nurbs(&source, plane, distance, tolerance)?;
            let source: Curve = source.into();
            Ok(parts
                .into_iter()
                .map(|c| RawPart { curve: c.into(), source: Some(source.clone()), corner: None })
                .collect())
        }
    }
}
