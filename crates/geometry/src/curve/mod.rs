//! Curves of every kind behind one type.

mod arc_curve;
mod batch;
mod biarc;
pub(crate) mod blend;
mod blend_through;
mod bounds;
mod classify;
mod closest;
mod closest_local;
mod closest_part;
mod comb;
mod connect;
mod continuity;
mod convert;
mod discontinuity;
mod divide;
mod divide_deviation;
mod edit;
mod edit_points;
mod elliptic;
mod ends;
mod evaluate;
mod explode;
mod extend;
mod extrema;
mod fillet;
mod finite;
mod frames;
mod join;
mod length;
mod line_curve;
mod periodic;
mod piece;
mod poly_curve;
mod polygon;
mod polyline_curve;
mod rebuild;
mod region;
mod sections;
mod simplify;
mod speed;
mod spiral;
mod tessellate;
mod thresholds;
pub(crate) mod traced;
mod tween;
mod two_views;

pub use arc_curve::ArcCurve;
pub use closest::{ClosestOnCurve, CurvePoint};
pub(crate) use closest_local::along_span;
pub use comb::CurvatureSample;
pub use connect::connect_curves;
pub use continuity::{ContinuityTolerance, JoinContinuity};
pub use discontinuity::Continuity;
pub(crate) use ends::with_ends;
pub(crate) use evaluate::curvature;
pub use extend::ExtensionStyle;
pub use extrema::CurvatureExtremum;
pub use fillet::CornerPiece;
pub(crate) use join::chained;
pub use join::join_curves;
pub use length::ArcLength;
pub use line_curve::LineCurve;
pub(crate) use piece::{Piece, Shape};
#[cfg(feature = "serde")]
pub(crate) use poly_curve::MAX_NESTING;
pub use poly_curve::PolyCurve;
pub use polygon::regular_polygon;
pub use polyline_curve::PolylineCurve;
pub use region::Containment;
pub use tessellate::PolylineLimits;
pub use tween::TweenMatch;
pub use two_views::curves_of_two_views;

use crate::{Arc, Circle, Interval, Line, NurbsCurve, Point3};

/// Any curve: a map from its domain, an increasing interval, to points.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// A straight segment.
    Line(LineCurve),
    /// An arc or a full circle.
    Arc(ArcCurve),
    /// A chain of straight segments.
    Polyline(PolylineCurve),
    /// A NURBS curve.
    Nurbs(NurbsCurve),
    /// Curves end to end.
    Poly(PolyCurve),
}

impl Curve {
    /// The parameters of the start and the end.
    pub fn domain(&self) -> Interval {
        match self {
            Self::Line(c) => c.domain,
            Self::Arc(c) => c.domain,
            Self::Polyline(c) => c.domain(),
            Self::Nurbs(c) => c.domain(),
            Self::Poly(c) => c.domain(),
        }
    }

    /// The point at parameter `t`. Outside the domain the first or last piece goes on by its own formula.
    pub fn point_at(&self, t: f64) -> Point3 {
        match self {
            Self::Line(c) => c.point_at(t),
            Self::Arc(c) => c.point_at(t),
            Self::Polyline(c) => c.point_at(t),
            Self::Nurbs(c) => c.point_at(t),
            Self::Poly(c) => c.point_at(t),
        }
    }

    /// The point at the start of the domain.
    pub fn start(&self) -> Point3 {
        self.point_at(self.domain().start)
    }

    /// The point at the end of the domain.
    pub fn end(&self) -> Point3 {
        self.point_at(self.domain().end)
    }
}

impl From<LineCurve> for Curve {
    fn from(c: LineCurve) -> Self {
        Self::Line(c)
    }
}

impl From<ArcCurve> for Curve {
    fn from(c: ArcCurve) -> Self {
        Self::Arc(c)
    }
}

impl From<PolylineCurve> for Curve {
    fn from(c: PolylineCurve) -> Self {
        Self::Polyline(c)
    }
}

impl From<NurbsCurve> for Curve {
    fn from(c: NurbsCurve) -> Self {
        Self::Nurbs(c)
    }
}

impl From<PolyCurve> for Curve {
    fn from(c: PolyCurve) -> Self {
        Self::Poly(c)
    }
}

impl From<Line> for Curve {
    fn from(line: Line) -> Self {
        Self::Line(line.into())
    }
}

impl From<Arc> for Curve {
    fn from(arc: Arc) -> Self {
        Self::Arc(arc.into())
    }
}

impl From<Circle> for Curve {
    fn from(circle: Circle) -> Self {
        Self::Arc(circle.into())
    }
}
