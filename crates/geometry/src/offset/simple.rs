//! Offsets of lines, arcs and polylines one to one, without cleaning.

use crate::curve::{ArcCurve, Curve, LineCurve, PolyCurve, PolylineCurve};
use crate::offset::thresholds::{LEVEL, TURNS_BACK};
use crate::thresholds;
use crate::{Arc, Circle, Error, Line, Plane, Point3, Result, Vector3};

impl Curve {
    /// The curve at a distance to its right, seen along its direction with the plane's normal up; a negative distance
    /// goes to the left. So a counter-clockwise closed curve grows. Corners of polylines stay sharp.
    ///
    /// Lines, arcs, polylines, and poly-curves of lines and arcs that join smoothly or at corners of two lines, keep
    /// their structure; the result is not cleaned of loops where the distance is larger than the shape allows. Other
    /// curves go through [`Curve::offset`] with the default tolerance.
    ///
    /// # Errors
    /// The curve is not parallel to the plane, an arc would vanish, or another curve's offset is empty or falls apart.
    pub fn offset_in_plane(&self, plane: &Plane, distance: f64) -> Result<Self> {
        if !distance.is_finite() {
            return Err(Error::NotFinite("offset distance"));
        }
        if distance == 0.0 {
            return Ok(self.clone());
        }
        match self {
            Self::Line(c) => {
                let n = right_of(c.line.direction(), plane)?;
                let v = n * distance;
                Ok(LineCurve { line: Line::new(c.line.from + v, c.line.to + v), domain: c.domain }.into())
            }
            Self::Arc(c) => {
                Ok(ArcCurve { arc: offset_arc(&c.arc, plane, distance)?, domain: c.domain }.into())
            }
            Self::Polyline(c) => {
                let points = offset_vertices(c.points(), self.is_closed(), plane, distance)?;
                if points.len() == c.points().len() {
                    return Ok(PolylineCurve::with_parameters(points, c.parameters().to_vec())?.into());
                }
                Ok(PolylineCurve::new(points)?.into())
            }
            Self::Poly(c) => {
                if let Some(points) = self.as_polyline() {
                    let points = offset_vertices(&points, self.is_closed(), plane, distance)?;
                    return Ok(PolylineCurve::new(points)?.into());
                }
                offset_segments(c, self.is_closed(), plane, distance)
                    .or_else(|refused| self.only_offset(plane, distance).map_err(|_| refused))
            }
            Self::Nurbs(c) if c.degree() == 1 => {
                let points = offset_vertices(&c.control_points(), self.is_closed(), plane, distance)?;
                Ok(PolylineCurve::new(points)?.into())
            }
            Self::Nurbs(_) => self.only_offset(plane, distance),
        }
    }
}

impl Curve {
    /// The cleaned offset, when it is one curve.
    fn only_offset(&self, plane: &Plane, distance: f64) -> Result<Self> {
        let mut all =
            self.offset(plane, distance, super::OffsetCorner::Sharp, &crate::Tolerance::default())?;
        match (all.pop(), all.len()) {
            (Some(only), 0) => Ok(only),
            (None, _) => Err(Error::degenerate("curve to offset", "nothing is left at this distance")),
            (Some(_), others) => Err(Error::Invalid {
                what: "curve to offset",
                why: format!("its offset falls apart into {} curves", others + 1),
            }),
        }
    }
}

/// The unit vector to the right of a direction in a plane.
pub(crate) fn right_of(direction: Vector3, plane: &Plane) -> Result<Vector3> {
    direction
        .unitized()
        .and_then(|d| d.cross(plane.z_axis).unitized())
        .ok_or(Error::degenerate("curve to offset", "a segment has no direction in the plane"))
}

fn offset_arc(arc: &Arc, plane: &Plane, distance: f64) -> Result<Arc> {
    let own = arc.circle.plane;
    let side = own.z_axis.parallel_to(plane.z_axis, LEVEL);
    if side == 0 {
        return Err(Error::degenerate("arc to offset", "it does not lie parallel to the plane"));
    }
    let radius = arc.circle.radius + f64::from(side) * distance;
    let circle = Circle::new(own, radius)
        .map_err(|_| Error::degenerate("arc to offset", "the distance is not smaller than its radius"))?;
    Ok(Arc { circle, ..*arc })
}

/// The vertices of a polyline offset with sharp corners; a reversal of direction gives two vertices.
fn offset_vertices(points: &[Point3], closed: bool, plane: &Plane, distance: f64) -> Result<Vec<Point3>> {
    let mut points = points.to_vec();
    points.dedup();
    let sides = points.windows(2).map(|w| right_of(w[1] - w[0], plane)).collect::<Result<Vec<Vector3>>>()?;
    let (Some(&first), Some(&last)) = (sides.first(), sides.last()) else {
        return Err(Error::degenerate("polyline to offset", "all its points are in one place"));
    };
    let n = points.len();
    let mut out = Vec::with_capacity(n + 2);
    for (i, &p) in points.iter().enumerate() {
        let before = if i > 0 {
            sides[i - 1]
        } else if closed {
            last
        } else {
            first
        };
        let after = if i + 1 < n {
            sides[i]
        } else if closed {
            first
        } else {
            last
        };
        // The meeting point of the two offset lines is p + d·(a + b)/(1 + a·b).
        let denominator = 1.0 + before.dot(after);
        if denominator > TURNS_BACK {
            out.push(p + (before + after) * (distance / denominator));
        } else {
            out.extend([p + before * distance, p + after * distance]);
        }
    }
    Ok(out)
}

fn offset_segments(curve: &PolyCurve, closed: bool, plane: &Plane, distance: f64) -> Result<Curve> {
    let mut parts = curve
        .segments()
        .iter()
        .map(|s| match s {
            Curve::Line(_) | Curve::Arc(_) => s.offset_in_plane(plane, distance),
            _ => Err(Error::Unsupported("offset of a poly-curve with other segments than lines and arcs")),
        })
        .collect::<Result<Vec<_>>>()?;
    let n = parts.len();
    for i in 0..if closed { n } else { n - 1 } {
        let j = (i + 1) % n;
        let (end, start) = (parts[i].end(), parts[j].start());
        if end.distance_to(start) <= thresholds::SAME_POINT * (1.0 + distance.abs()) {
            continue;
        }
        let (Curve::Line(a), Curve::Line(b)) = (&parts[i], &parts[j]) else {
            return Err(Error::Unsupported("offset of a corner between a line and an arc or two arcs"));
        };
        let (s, _) = crate::intersect::line_line(&a.line, &b.line)
            .ok_or(Error::degenerate("poly-curve to offset", "it turns straight back"))?;
        let corner = a.line.at(s);
        let (a, b) = (
            LineCurve { line: Line::new(a.line.from, corner), ..*a },
            LineCurve { line: Line::new(corner, b.line.to), ..*b },
        );
        parts[i] = a.into();
        parts[j] = b.into();
    }
    Ok(PolyCurve::with_parameters(parts, curve.parameters().to_vec())?.into())
}
