//! Every curve as one NURBS curve.

use super::{Curve, PolyCurve};
use crate::{NurbsCurve, Result};

impl Curve {
    /// The exact NURBS form over the same domain. Lines and polylines have degree 1, arcs are rational of degree 2
    /// (only the joints and middles of their spans keep their parameter), a poly-curve takes the highest degree among
    /// its segments and has full knot multiplicity at its joints.
    ///
    /// # Errors
    /// A degenerate arc, or parameters too close to be knots.
    pub fn to_nurbs(&self) -> Result<NurbsCurve> {
        match self {
            Self::Line(c) => {
                NurbsCurve::new(1, vec![c.line.from, c.line.to], vec![c.domain.start, c.domain.end])
            }
            Self::Arc(c) => c.to_nurbs(),
            Self::Polyline(c) => NurbsCurve::new(1, c.points().to_vec(), c.parameters().to_vec()),
            Self::Nurbs(c) => Ok(c.clone()),
            Self::Poly(c) => joined(c),
        }
    }
}

fn joined(curve: &PolyCurve) -> Result<NurbsCurve> {
    let mut parts = Vec::with_capacity(curve.segments().len());
    for (i, segment) in curve.segments().iter().enumerate() {
        parts.push(segment.to_nurbs()?.with_domain(curve.segment_domain(i))?.clamped()?);
    }
    let degree = parts.iter().map(NurbsCurve::degree).max().unwrap_or(1);
    let rational = parts.iter().any(NurbsCurve::is_rational);
    let mut knots: Vec<f64> = Vec::new();
    let mut points: Vec<[f64; 4]> = Vec::new();
    for part in &parts {
        let part = part.raised_to(degree)?;
        let mut own = part.homogeneous_points();
        if let (Some(last), Some(first)) = (points.last(), own.first()) {
            // Weights of a whole part may be scaled freely: make them agree at the joint.
            let scale = last[3] / first[3];
            for p in &mut own {
                *p = p.map(|x| x * scale);
            }
            points.pop();
            knots.extend(part.knots().iter().skip(degree));
        } else {
            knots.extend(part.knots());
        }
        points.extend(own);
    }
    if rational {
        NurbsCurve::rational(degree, points, knots)
    } else {
        let plain = points.iter().map(|p| crate::Point3::new(p[0], p[1], p[2])).collect();
        NurbsCurve::new(degree, plain, knots)
    }
}
