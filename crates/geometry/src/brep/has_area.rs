//! Whether a surface is more than a curve or a point.

use crate::{Curve, Direction, Error, Interval, Line, LineCurve, Point3, Result, Surface, Vector3};

/// A normal shorter than this part of what the surface's size lets expect is none.
const NO_NORMAL: f64 = 1e-12;
/// Shares of the domains at which a surface is looked at.
const PLACES: [f64; 5] = [0.137, 0.319, 0.5, 0.684, 0.891];

/// The greatest size and area that a few places of a surface speak of.
#[derive(Default)]
struct Extent {
    first: Option<Point3>,
    size: f64,
    area: f64,
}

impl Extent {
    /// A point, and what both parameters move it by over their whole domains.
    fn include(&mut self, point: Point3, u: Vector3, v: Vector3) {
        let origin = *self.first.get_or_insert(point);
        self.size = self.size.max(point.distance_to(origin)).max(u.length()).max(v.length());
        self.area = self.area.max(u.cross(v).length());
    }
}

impl Surface {
    /// A sum of curves with every polyline of one segment made a line.
    pub(crate) fn with_segments_as_lines(self) -> Self {
        let Self::Sum(sum) = &self else { return self };
        if !sum.curves().iter().any(|curve| matches!(curve, Curve::Polyline(_))) {
            return self;
        }
        let [a, b] = sum.curves().clone().map(Curve::with_segment_as_line);
        crate::SumSurface::new(a, b, sum.shift()).map_or(self, Self::Sum)
    }

    /// Whether points are an affine function of the parameters: of planes, and of lines drawn straight.
    pub(crate) fn is_affine(&self) -> bool {
        match self {
            Self::Plane(_) => true,
            Self::Sum(s) => matches!(s.curves(), [Curve::Line(_), Curve::Line(_)]),
            _ => false,
        }
    }

    /// Refuses a surface that is a curve or a point.
    pub(crate) fn check_area(&self) -> Result<()> {
        let [u, v] = Direction::BOTH.map(|d| self.domain(d));
        let mut extent = Extent::default();
        match self {
            Self::Sum(s) => {
                // Each direction has derivatives of its own, whatever the other parameter.
                let along = |curve: &Curve| -> Vec<(Point3, Vector3)> {
                    let domain = curve.domain();
                    let places: &[f64] = if matches!(curve, Curve::Line(_)) { &[0.5] } else { &PLACES };
                    let jet = |x: &f64| {
                        let [p, d] = curve.jet_at::<2>(domain.at(*x), false);
                        (p.to_point(), d * domain.length())
                    };
                    places.iter().map(jet).collect()
                };
                let [first, second] = s.curves().each_ref().map(along);
                for (p, du) in &first {
                    for (q, dv) in &second {
                        extent.include(*p + q.to_vector(), *du, *dv);
                    }
                }
            }
            _ => {
                for x in PLACES {
                    for y in PLACES {
                        let (s, t) = (u.at(x), v.at(y));
                        let d = self.derivatives(s, t, 1, self.inner_quadrant(s, t));
                        extent.include(d.point(), d.get(1, 0) * u.length(), d.get(0, 1) * v.length());
                    }
                }
            }
        }
        if !(extent.size.is_finite() && extent.area.is_finite()) {
            return Err(Error::NotFinite("surface"));
        }
        if extent.area > NO_NORMAL * extent.size * extent.size && extent.area > 0.0 {
            return Ok(());
        }
        Err(Error::degenerate("surface", "it has no area"))
    }
}

impl Curve {
    /// A polyline of one segment as a line.
    pub(crate) fn with_segment_as_line(self) -> Self {
        match &self {
            Self::Polyline(c) => match (c.points(), c.parameters()) {
                (&[from, to], &[start, end]) => {
                    LineCurve { line: Line::new(from, to), domain: Interval::new(start, end) }.into()
                }
                _ => self,
            },
            _ => self,
        }
    }
}
