//! Curves.

use katydid_geometry::Curve;
use serde_json::{Value, json};

use crate::numbers::{plane, point, points};

pub(crate) fn curve(curve: &Curve) -> Value {
    let domain = curve.domain();
    let domain = [domain.start, domain.end];
    match curve {
        Curve::Line(c) => {
            json!({"kind": "line", "domain": domain, "from": point(c.line.from), "to": point(c.line.to)})
        }
        Curve::Arc(c) => json!({"kind": "arc", "domain": domain, "plane": plane(&c.arc.circle.plane),
            "radius": c.arc.circle.radius, "angle": [c.arc.angle.start, c.arc.angle.end]}),
        Curve::Polyline(c) => json!({"kind": "polyline", "domain": domain, "points": points(c.points()),
            "parameters": c.parameters()}),
        Curve::Nurbs(c) => json!({"kind": "nurbs", "domain": domain, "degree": c.degree(),
            "rational": c.is_rational(), "knots": c.knots(), "points": c.homogeneous_points()}),
        Curve::Poly(c) => {
            let segments: Vec<Value> = c.segments().iter().map(self::curve).collect();
            json!({"kind": "poly", "domain": domain, "parameters": c.parameters(), "segments": segments})
        }
    }
}
