//! Curves of the parameter plane lifted to their surface.

use crate::brep::with_ends;
use crate::thresholds;
use crate::{
    ClosestOnSurface, Curve, Direction, Error, Interval, LineCurve, NurbsCurve, Point3, Result, Surface,
    Tolerance, Vector3, Xform,
};

/// The most halvings of one stretch.
const DEEPEST: u32 = 12;
/// Places inside a piece at which it is compared with what it stands for.
const PROBES: [f64; 3] = [0.25, 0.5, 0.75];

/// The image of a curve in the parameter plane, within the tolerance: exact on planes and along lines of constant
/// parameter, elsewhere a cubic with the curve's own parameter.
pub(crate) fn lifted(surface: &Surface, flat: &Curve, limit: f64) -> Result<Curve> {
    if let Surface::Plane(plane) = surface {
        let [u, v] = [plane.domain(Direction::U), plane.domain(Direction::V)];
        let corner = plane.point_at(u.start, v.start);
        let x = (plane.point_at(u.end, v.start) - corner) / u.length();
        let y = (plane.point_at(u.start, v.end) - corner) / v.length();
        let origin = corner - x * u.start - y * v.start;
        return flat.transformed(&Xform::from_columns(x, y, plane.plane().z_axis, origin));
    }
    if let Some(curve) = along_isocurve(surface, flat)? {
        return Ok(curve);
    }
    let formula = |t: f64, below: bool| -> Result<(Point3, Vector3)> {
        let [place, slope] = flat.jet_at::<2>(t, below);
        let d = surface.derivatives(place.x, place.y, 1, surface.inner_quadrant(place.x, place.y));
        Ok((d.point(), d.get(1, 0) * slope.x + d.get(0, 1) * slope.y))
    };
    let curve = followed(&flat.smooth_stretches(), limit, formula)?;
    Ok(curve.into())
}

impl Surface {
    /// The curve in space that a curve in the parameter plane (x is u, y is v) stands for, within the tolerance: exact
    /// on planes and along straight lines of constant parameter.
    ///
    /// # Errors
    /// The curve leaves the domain, the tolerance is not above 0, or the image cannot be followed within it.
    pub fn image_of(&self, flat: &Curve, tolerance: &Tolerance) -> Result<Curve> {
        let limit = tolerance.positive_distance()?;
        let bounds = flat.bounding_box();
        let reach = [(bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y)];
        for (direction, (low, high)) in Direction::BOTH.into_iter().zip(reach) {
            let domain = self.domain(direction);
            let near = thresholds::SAME_PARAMETER * domain.length();
            if !(low >= domain.start - near && high <= domain.end + near) {
                return Err(Error::degenerate("parameter curve", "it leaves the domain of the surface"));
            }
        }
        lifted(self, flat, limit)
    }

    /// The curve at a height over a surface on which another lies, along the normals of the surface at its points,
    /// within the tolerance.
    ///
    /// # Errors
    /// A height that is not finite, a place where the surface or the curve has no direction, or a curve that cannot be
    /// followed within the tolerance.
    pub fn curve_above(&self, curve: &Curve, height: f64, tolerance: &Tolerance) -> Result<Curve> {
        let limit = tolerance.positive_distance()?;
        if !height.is_finite() {
            return Err(Error::NotFinite("height of the curve"));
        }
        let search = ClosestOnSurface::new(self)?;
        let at = |t: f64| -> Result<Point3> {
            let p = curve.point_at(t);
            let near = search.nearest(p)?;
            let none = Error::degenerate("surface", "it has no normal under the curve");
            Ok(p + self.normal_at(near.u, near.v).ok_or(none)? * height)
        };
        let domain = curve.domain();
        let formula = |t: f64, below: bool| -> Result<(Point3, Vector3)> {
            // The slope by differences, from the side that the stretch lies on.
            let h = thresholds::DIFFERENCE_STEP * domain.length();
            let (a, b) = match below {
                _ if t - h < domain.start => (t, t + h),
                _ if t + h > domain.end => (t - h, t),
                true => (t - h, t),
                false => (t, t + h),
            };
            Ok((at(t)?, (at(b)? - at(a)?) / (b - a)))
        };
        Ok(followed(&curve.smooth_stretches(), limit, formula)?.into())
    }
}

/// The isocurve under a straight axial line.
fn along_isocurve(surface: &Surface, flat: &Curve) -> Result<Option<Curve>> {
    let Curve::Line(LineCurve { line, .. }) = flat else { return Ok(None) };
    let (a, b) = (line.from, line.to);
    let (direction, constant, from, to) = if a.y == b.y && a.x != b.x {
        (Direction::U, a.y, a.x, b.x)
    } else if a.x == b.x && a.y != b.y {
        (Direction::V, a.x, a.y, b.y)
    } else {
        return Ok(None);
    };
    let range = Interval::new(from.min(to), from.max(to));
    let domain = surface.domain(direction);
    let Some(range) = range.intersection(domain).filter(|r| r.is_increasing()) else { return Ok(None) };
    let whole = surface.isocurve(direction, constant)?;
    let part = whole.trimmed(range)?;
    Ok(Some(if from > to { part.reversed() } else { part }))
}

/// The cubic through points and derivatives of a formula, halved until it is within the limit of it.
pub(in crate::brep) fn followed(
    stretches: &[Interval],
    limit: f64,
    mut formula: impl FnMut(f64, bool) -> Result<(Point3, Vector3)>,
) -> Result<NurbsCurve> {
    let (mut points, mut slopes, mut places) = (Vec::new(), Vec::new(), Vec::new());
    let mut parts: Vec<NurbsCurve> = Vec::new();
    for stretch in stretches {
        points.clear();
        slopes.clear();
        places.clear();
        let first = formula(stretch.start, false)?;
        let last = formula(stretch.end, true)?;
        points.push(first.0);
        slopes.push(first.1);
        places.push(stretch.start);
        let mut stack = vec![(stretch.start, first, stretch.end, last, 0)];
        while let Some((s, a, t, b, depth)) = stack.pop() {
            let h = t - s;
            let hermite = NurbsCurve::hermite(a.0, a.1 * h, b.0, b.1 * h)?;
            let mut worst = 0.0_f64;
            for x in PROBES {
                worst = worst.max(formula(s + h * x, false)?.0.distance_to(hermite.point_at(x)));
            }
            // A stretch is looked at in halves at least once.
            if (worst <= limit && depth > 0) || worst == 0.0 {
                points.push(b.0);
                slopes.push(b.1);
                places.push(t);
                continue;
            }
            if depth >= DEEPEST {
                return Err(Error::degenerate("trim", "its image cannot be followed within the tolerance"));
            }
            let middle = s + 0.5 * h;
            let m = formula(middle, false)?;
            stack.push((middle, m, t, b, depth + 1));
            stack.push((s, a, middle, m, depth + 1));
        }
        parts.push(NurbsCurve::hermite_through(&points, &slopes, &places)?);
    }
    joined(parts)
}

/// Pieces end to end as one curve, with full knots between them.
fn joined(parts: Vec<NurbsCurve>) -> Result<NurbsCurve> {
    if let [only] = parts.as_slice() {
        return Ok(only.clone());
    }
    let domain =
        parts.first().zip(parts.last()).map(|(a, b)| Interval::new(a.domain().start, b.domain().end));
    let mut places: Vec<f64> = parts.iter().map(|p| p.domain().start).collect();
    places.extend(domain.map(|d| d.end));
    let segments = parts.into_iter().map(Curve::from).collect();
    let chain: Curve = crate::PolyCurve::with_parameters(segments, places)?.into();
    chain.to_nurbs()
}

/// A curve of the parameter plane whose z has become a hair off 0, put back.
pub(super) fn in_parameter_plane(curve: &Curve) -> Result<Curve> {
    crate::brep::flatten::flattened(curve, &crate::Plane::XY)
}

/// A curve of the parameter plane made to end exactly where asked.
pub(super) fn ending(curve: &Curve, ends: [Point3; 2]) -> Result<Curve> {
    with_ends(curve, ends)
}
