//! Curves that openNURBS calls invalid in a class of their own, and takes as NURBS curves.

use std::f64::consts::TAU;

use katydid_geometry::{Curve, NurbsCurve};

/// Up to this angle short of a whole turn an arc counts as a circle.
const TURN: f64 = 2.328_306_436_538_696_3e-10;

/// The same curve with the same parameters as a NURBS curve, where its own class would not do: for a segment between
/// points that coincide, a polyline that runs there and back or stays in a place, an arc of all but a whole turn whose
/// ends lie apart.
pub(super) fn as_nurbs(curve: &Curve) -> Option<NurbsCurve> {
    if is_sound(curve) {
        return None;
    }
    curve.to_nurbs().ok().filter(|nurbs| nurbs.domain() == curve.domain())
}

/// Whether a curve can be written in its own class.
pub(super) fn is_sound(curve: &Curve) -> bool {
    match curve {
        Curve::Line(c) => !c.line.from.coincides(c.line.to),
        Curve::Polyline(c) => {
            let points = c.points();
            let is_flat = points.len() < 4 && curve.start().coincides(curve.end());
            !is_flat && points.windows(2).all(|pair| pair[0] != pair[1])
        }
        Curve::Arc(c) => {
            let short = (c.arc.angle.length().abs() - TAU).abs();
            short > TURN || curve.start().coincides(curve.end())
        }
        Curve::Nurbs(_) | Curve::Poly(_) => true,
    }
}
