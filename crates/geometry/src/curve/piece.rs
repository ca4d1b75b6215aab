//! Any curve as a list of smooth pieces: segments, arcs and single NURBS spans.

use katydid_elementary::Elementary;

use super::Curve;
use crate::{Arc, Interval, NurbsCurve, Point3, Vector3};

/// What a piece is made of.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Shape<'a> {
    /// A straight segment over 0…1.
    Segment(Point3, Point3),
    /// An arc over its angles.
    Arc(&'a Arc),
    /// Span j of a NURBS curve over its two knots.
    Span(&'a NurbsCurve, usize),
}

/// A smooth piece of a curve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece<'a> {
    /// Its part of the whole curve's domain.
    pub(crate) whole: Interval,
    /// The same range in the shape's own parameter.
    pub(crate) own: Interval,
    pub(crate) shape: Shape<'a>,
}

impl Piece<'_> {
    /// The point and two derivatives by the shape's own parameter.
    pub(crate) fn jet(&self, u: f64) -> [Vector3; 3] {
        match self.shape {
            Shape::Segment(a, b) => [a.lerp(b, u).to_vector(), b - a, Vector3::ZERO],
            Shape::Arc(arc) => {
                let (sin, cos) = u.sine_cosine();
                let (r, plane) = (arc.circle.radius, &arc.circle.plane);
                let out = plane.x_axis * (r * cos) + plane.y_axis * (r * sin);
                let along = plane.y_axis * (r * cos) - plane.x_axis * (r * sin);
                [plane.origin.to_vector() + out, along, -out]
            }
            Shape::Span(curve, j) => curve.jet(j, u),
        }
    }

    pub(crate) fn point(&self, u: f64) -> Point3 {
        match self.shape {
            Shape::Segment(_, b) if u == 1.0 => b,
            Shape::Segment(a, b) => a.lerp(b, u),
            Shape::Arc(arc) => arc.circle.at(u),
            Shape::Span(curve, j) => curve.point_in(j, u),
        }
    }

    pub(crate) fn start(&self) -> Point3 {
        self.point(self.own.start)
    }

    pub(crate) fn end(&self) -> Point3 {
        self.point(self.own.end)
    }

    /// The whole curve's parameter for a shape's own.
    pub(crate) fn whole_parameter(self, u: f64) -> f64 {
        if self.own == self.whole { u } else { self.whole.at(self.own.normalized(u)) }
    }

    /// The shape's own parameter for the whole curve's.
    pub(crate) fn own_parameter(self, t: f64) -> f64 {
        if self.own == self.whole { t } else { self.own.at(self.whole.normalized(t)) }
    }

    /// The homogeneous control points of the piece as Bézier curves over equal parts of its own range: one for a
    /// segment or a span, up to four for an arc. The shape is exact; inside an arc the parameter is not.
    pub(crate) fn beziers(&self) -> Vec<Vec<[f64; 4]>> {
        match self.shape {
            Shape::Segment(a, b) => vec![vec![[a.x, a.y, a.z, 1.0], [b.x, b.y, b.z, 1.0]]],
            Shape::Arc(arc) => match arc.to_nurbs(Interval::UNIT) {
                Ok(nurbs) => nurbs.spans().map(|j| nurbs.bezier_points(j)).collect(),
                Err(_) => Vec::new(),
            },
            Shape::Span(curve, j) => vec![curve.bezier_points(j)],
        }
    }
}

impl Curve {
    /// The smooth pieces in order. Between pieces anything may happen, inside none.
    pub(crate) fn pieces(&self) -> Vec<Piece<'_>> {
        let mut out = Vec::new();
        self.collect_pieces(self.domain(), &mut out);
        out
    }

    fn collect_pieces<'a>(&'a self, whole: Interval, out: &mut Vec<Piece<'a>>) {
        let domain = self.domain();
        let outer = |t: f64| if domain == whole { t } else { whole.at(domain.normalized(t)) };
        match self {
            Self::Line(c) => {
                out.push(Piece { whole, own: Interval::UNIT, shape: Shape::Segment(c.line.from, c.line.to) });
            }
            Self::Arc(c) => out.push(Piece { whole, own: c.arc.angle, shape: Shape::Arc(&c.arc) }),
            Self::Polyline(c) => {
                for (p, t) in c.points().windows(2).zip(c.parameters().windows(2)) {
                    let whole = Interval::new(outer(t[0]), outer(t[1]));
                    out.push(Piece { whole, own: Interval::UNIT, shape: Shape::Segment(p[0], p[1]) });
                }
            }
            Self::Nurbs(c) => {
                for j in c.spans() {
                    let own = Interval::new(c.knots()[j + c.degree() - 1], c.knots()[j + c.degree()]);
                    let whole = Interval::new(outer(own.start), outer(own.end));
                    out.push(Piece { whole, own, shape: Shape::Span(c, j) });
                }
            }
            Self::Poly(c) => {
                for (i, segment) in c.segments().iter().enumerate() {
                    let part = c.segment_domain(i);
                    segment.collect_pieces(Interval::new(outer(part.start), outer(part.end)), out);
                }
            }
        }
    }

    /// The smooth stretches of the curve.
    pub(crate) fn smooth_stretches(&self) -> Vec<Interval> {
        self.pieces().iter().map(|p| p.whole).collect()
    }
}
