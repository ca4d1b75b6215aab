//! Curve / Util: take apart, join, turn round, extend, simplify.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{
    Arc, ArcCurve, Curve, ExtensionStyle, Interval, Point3, PolyCurve, PolylineCurve, join_curves,
};

use super::shared;

/// Takes a curve apart into its segments: single lines, arcs, and smooth pieces between kinks.
#[component("afb96615-c59a-45c9-9cac-e27acb1c7ca0", name = "Explode", nick = "Explode", at = "Curve/Util")]
#[output("Segments", "S", "The segments in order.")]
#[output("Vertices", "V", "The starts of all segments and the end of the last.")]
fn explode(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Whether segments are taken apart again; otherwise a joined curve only gives what it was joined of.
    #[port("Recursive", "R", default = true)]
    recursive: bool,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    let segments = curve.explode(recursive)?;
    let mut vertices: Vec<Point3> = segments.iter().map(Curve::start).collect();
    vertices.extend(segments.last().map(Curve::end));
    Ok((segments.into_iter().map(Shared::new).collect(), vertices))
}

/// Joins curves whose ends meet, within the document's tolerance. Nulls are skipped.
#[component("8073a420-6bec-49e3-9b18-367f6fd76ac3", name = "Join Curves", nick = "Join", at = "Curve/Util")]
#[output("Curves", "C", "The joined curves, and those that meet no other.")]
fn join(
    context: &Context<'_>,
    /// The curves, in any order.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// Whether curves keep their directions, so that only an end joins a start.
    #[port("Preserve", "P", default = false)]
    preserve: bool,
) -> Vec<Shared<Curve>> {
    let curves: Vec<Curve> = curves.present().map(|c| (*c).clone()).collect();
    join_curves(&curves, context.tolerance().absolute, preserve).into_iter().map(Shared::new).collect()
}

/// Turns a curve round. With a guide it is only turned when it runs against it.
#[component("22990b1f-9be6-477c-ad89-f775cd347105", name = "Flip Curve", nick = "Flip", at = "Curve/Util")]
#[output("Curve", "C", "The curve, turned or not.")]
#[output("Flag", "F", "Whether it was turned.")]
fn flip_curve(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// A curve that shows the direction.
    #[port("Guide", "G")]
    guide: Option<Shared<Curve>>,
) -> (Shared<Curve>, bool) {
    let against = guide.is_none_or(|guide| {
        let own = curve.tangent_at(curve.domain().start);
        let near = guide.closest_point(curve.start()).ok();
        let along = near.and_then(|near| guide.tangent_at(near.parameter));
        own.zip(along).is_some_and(|(a, b)| a.dot(b) < 0.0)
    });
    (shared(if against { curve.reversed() } else { curve.clone() }), against)
}

/// Moves the start of a closed curve along it. An open curve stays as it is, with a warning.
#[component("42ad8dc1-b0c0-40df-91f5-2c46e589e6c2", name = "Seam", nick = "Seam", at = "Curve/Util")]
#[output("Curve", "C", "The curve from there.")]
fn seam(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter of the new start, in the curve's own domain.
    #[port("Seam", "t")]
    seam: f64,
) -> Result<Shared<Curve>, Message> {
    if !curve.is_closed() {
        context.warn("An open curve has no seam");
        return Ok(shared(curve.clone()));
    }
    Ok(shared(curve.with_seam(seam)?))
}

/// Makes a curve longer at its ends, or shorter by a negative length.
///
/// Closed curves stay as they are, with a warning.
#[component("62cc9684-6a39-422e-aefa-ed44643557b9", name = "Extend Curve", nick = "Ext", at = "Curve/Util")]
#[output("Curve", "C", "The extended curve.")]
fn extend_curve(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// 0 adds straight lines; 1 goes on in arcs with the curvature of the end, 2 smoothly, as the end itself goes on.
    #[port("Type", "T", default = 0)]
    kind: i32,
    /// The length to add at the start; a negative one shortens the curve.
    #[port("Start", "L0", default = 0.0)]
    start: f64,
    /// The length to add at the end; a negative one shortens the curve.
    #[port("End", "L1", default = 0.0)]
    end: f64,
) -> Result<Shared<Curve>, Message> {
    if !(0..=2).contains(&kind) {
        return Err(Message::error(format!("There is no type {kind}: 0 is line, 1 arc, 2 smooth")));
    }
    let mut out = curve.clone();
    if start < 0.0 || end < 0.0 {
        let total = out.length();
        let (from, to) = ((-start).max(0.0), total - (-end).max(0.0));
        let range = (out.parameter_at_length(from), out.parameter_at_length(to));
        let (Some(a), Some(b)) = range else {
            return Err(Message::error("Nothing would be left of the curve"));
        };
        if !(a < b) {
            return Err(Message::error("Nothing would be left of the curve"));
        }
        out = out.trimmed(Interval::new(a, b))?;
    }
    let (start, end) = (start.max(0.0), end.max(0.0));
    if start == 0.0 && end == 0.0 {
        return Ok(shared(out));
    }
    if out.is_closed() {
        context.warn("A closed curve has no ends to extend");
        return Ok(shared(out));
    }
    match &out {
        Curve::Arc(c) if kind > 0 => {
            let r = c.arc.circle.radius;
            let angle = Interval::new(c.arc.angle.start - start / r, c.arc.angle.end + end / r);
            let arc = Arc::new(c.arc.circle, angle)?;
            let speed = c.domain.length() / c.arc.length();
            let domain = Interval::new(c.domain.start - start * speed, c.domain.end + end * speed);
            let grown = arc.is_circle();
            if grown {
                context.warn("The arc has become a full circle");
            }
            Ok(shared(Curve::Arc(if grown { ArcCurve::new(arc) } else { ArcCurve { arc, domain } })))
        }
        _ => {
            let style = match kind {
                0 => ExtensionStyle::Line,
                1 => ExtensionStyle::Arc,
                _ => ExtensionStyle::Smooth,
            };
            Ok(shared(out.extended(start, end, style)?))
        }
    }
}

/// Makes a curve of fewer pieces: straight parts become lines, round ones arcs, and corners that hardly turn go.
#[component(
    "922dc7e5-0f0e-4c21-ae4b-f6a8654e63f6",
    name = "Simplify Curve",
    nick = "Simplify",
    at = "Curve/Util"
)]
#[output("Curve", "C", "The simpler curve.")]
#[output("Simplified", "S", "Whether anything changed.")]
fn simplify_curve(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far the curve may move; the document's tolerance when nothing is given.
    #[port("Tolerance", "t")]
    tolerance: Option<f64>,
    /// By how much a corner that goes may turn, in radians; the document's when nothing is given.
    #[port("Angle Tolerance", "a")]
    angle: Option<f64>,
) -> (Shared<Curve>, bool) {
    let tolerance = tolerance.unwrap_or(context.tolerance().absolute);
    let angle = angle.unwrap_or(context.tolerance().angle);
    let simple = simpler(curve, tolerance, angle);
    let changed = simple != *curve;
    (shared(simple), changed)
}

fn simpler(curve: &Curve, tolerance: f64, angle: f64) -> Curve {
    let same_domain = |c: Curve| c.with_domain(curve.domain()).unwrap_or(c);
    match curve {
        Curve::Line(_) | Curve::Arc(_) => return curve.clone(),
        _ => {}
    }
    if let Some(line) = curve.as_line(tolerance) {
        return same_domain(line.into());
    }
    if let Some(points) = curve.as_polyline() {
        let kept = without_straight_corners(&points, tolerance, angle);
        if kept.len() == points.len() && matches!(curve, Curve::Polyline(_)) {
            return curve.clone();
        }
        return PolylineCurve::new(kept).map_or_else(|_| curve.clone(), Curve::from);
    }
    if let Some(arc) = curve.as_arc(tolerance) {
        return same_domain(arc.into());
    }
    match curve {
        Curve::Poly(c) => {
            let segments: Vec<Curve> = c.segments().iter().map(|s| simpler(s, tolerance, angle)).collect();
            PolyCurve::new(segments).map_or_else(|_| curve.clone(), Curve::from)
        }
        other => other.clone(),
    }
}

/// Vertices that lie on the line between their neighbours, and turn less than `angle` there, are left out.
fn without_straight_corners(points: &[Point3], tolerance: f64, angle: f64) -> Vec<Point3> {
    let mut kept: Vec<Point3> = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        let straight = kept.last().zip(points.get(i + 1)).is_some_and(|(&a, &b)| {
            let turn = (p - a).angle_to(b - p).unwrap_or(0.0);
            turn <= angle && katydid_geometry::Line::new(a, b).distance_to(p) <= tolerance
        });
        if !straight {
            kept.push(p);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Arc, Circle, Curve, Interval, Line, Plane, Point3, PolylineCurve};

    fn line(a: f64, b: f64) -> Line {
        Line::new(Point3::new(a, 0.0, 0.0), Point3::new(b, 0.0, 0.0))
    }

    fn polyline(points: &[[f64; 2]]) -> Curve {
        PolylineCurve::new(points.iter().map(|&[x, y]| Point3::new(x, y, 0.0)).collect()).unwrap().into()
    }

    fn length(trial: Trial) -> String {
        let curve = trial.run().outputs[0].clone();
        Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(curve).texts(0).join("")
    }

    #[test]
    fn apart_and_together() {
        let square = polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
        let parts = Trial::of("Explode").item(square).run();
        assert_eq!((parts.outputs[0].item_count(), parts.outputs[1].item_count()), (3, 4));
        let joined = Trial::of("Join Curves").list([line(0.0, 1.0), line(2.0, 1.0), line(5.0, 6.0)]).run();
        assert_eq!(joined.outputs[0].item_count(), 2);
        let kept = Trial::of("Join Curves").list([line(0.0, 1.0), line(2.0, 1.0)]).item(true).run();
        assert_eq!(kept.outputs[0].item_count(), 2);
        assert_eq!(texts(&kept.outputs[0])[0].split(':').next(), Some("{0;0}"));
    }

    #[test]
    fn directions_and_seams() {
        let flipped = Trial::of("Flip Curve").item(line(0.0, 1.0)).run();
        assert_eq!(texts(&flipped.outputs[1]), ["{0}: True"]);
        let guided = Trial::of("Flip Curve").item(line(0.0, 1.0)).item(line(-5.0, 9.0)).run();
        assert_eq!(texts(&guided.outputs[1]), ["{0}: False"]);
        let square = polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
        let moved = Trial::of("Seam").item(square).item(1.0).run().outputs[0].clone();
        assert_eq!(Trial::of("End Points").tree(moved).texts(0), ["{0}: {1, 0, 0}"]);
        assert!(Trial::of("Seam").item(line(0.0, 1.0)).item(0.5).message().contains("no seam"));
    }

    #[test]
    fn longer_and_shorter() {
        let extend = |kind: i32, a: f64, b: f64| {
            Trial::of("Extend Curve").item(line(0.0, 4.0)).item(kind).item(a).item(b)
        };
        assert_eq!(length(extend(0, 1.0, 2.0)), "{0}: 7");
        assert_eq!(length(extend(2, -1.0, 2.0)), "{0}: 5");
        assert!(extend(0, -3.0, -3.0).message().contains("Nothing"));
        assert!(extend(5, 1.0, 1.0).message().contains("type"));
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let arc = Arc::new(circle, Interval::new(0.0, 1.0)).unwrap();
        let on = Trial::of("Extend Curve").item(arc).item(1).item(0.5).item(0.25);
        assert_eq!(length(on), "{0}: 1.75");
    }

    #[test]
    fn simpler_curves() {
        let bent = polyline(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 5.0]]);
        let simple = Trial::of("Simplify Curve").item(bent).run();
        assert_eq!(texts(&simple.outputs[1]), ["{0}: True"]);
        assert_eq!(
            Trial::of("Control Points").tree(simple.outputs[0].clone()).run().outputs[0].item_count(),
            3
        );
        assert_eq!(Trial::of("Simplify Curve").item(line(0.0, 1.0)).texts(1), ["{0}: False"]);
    }
}
