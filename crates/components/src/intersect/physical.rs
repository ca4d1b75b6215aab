//! Intersect / Physical: curves with curves.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::intersect::{self, CurveIntersections};
use katydid_geometry::{BoxIndex, Curve, Point3};

/// Points and both parameters.
type Meetings = Vec<(Point3, f64, f64)>;

/// All points in the order of the first curve; a shared stretch counts with its two ends.
fn meetings(context: &Context<'_>, a: &Curve, found: &CurveIntersections) -> Result<Meetings, Message> {
    if !found.complete {
        context.warn("The curves lie so close together that some meetings may be missing");
    }
    let mut all: Meetings = found.crossings.iter().map(|c| (c.point, c.a, c.b)).collect();
    for stretch in &found.overlaps {
        all.push((a.point_at(stretch.a.start), stretch.a.start, stretch.b.start));
        all.push((a.point_at(stretch.a.end), stretch.a.end, stretch.b.end));
    }
    all.sort_by(|x, y| x.1.total_cmp(&y.1).then(x.2.total_cmp(&y.2)));
    context.items(all.len().saturating_mul(3))?;
    Ok(all)
}

/// Where two curves meet, in the order of the first.
///
/// They meet where they come within the tolerance of each other. A stretch that they share counts with its two ends.
#[component(
    "84627490-0fb2-4498-8138-ad134ee4cb36",
    name = "Curve | Curve",
    nick = "CCX",
    at = "Intersect/Physical"
)]
#[output("Points", "P", "The points.")]
#[output("Params A", "tA", "Their parameters on the first curve.")]
#[output("Params B", "tB", "Their parameters on the second curve.")]
fn curve_curve(
    context: &Context<'_>,
    /// A curve.
    #[port("Curve A", "A")]
    a: &Curve,
    /// Another curve.
    #[port("Curve B", "B")]
    b: &Curve,
) -> Result<(Vec<Point3>, Vec<f64>, Vec<f64>), Message> {
    let found = intersect::curve_curve(a, b, context.tolerance().absolute)?;
    let all = meetings(context, a, &found)?;
    Ok((
        all.iter().map(|m| m.0).collect(),
        all.iter().map(|m| m.1).collect(),
        all.iter().map(|m| m.2).collect(),
    ))
}

/// Where a curve meets itself.
///
/// Each meeting is one point and two parameters: those at which the curve comes there first are listed before those at
/// which it comes again. That a closed curve ends where it starts does not count.
#[component(
    "0991ac99-6a0b-47a9-b07d-dd510ca57f0f",
    name = "Curve | Self",
    nick = "CX",
    at = "Intersect/Physical"
)]
#[output("Points", "P", "The points.")]
#[output("Params", "t", "The parameters: all of the first passes, then all of the second.")]
fn curve_self(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(Vec<Point3>, Vec<f64>), Message> {
    let found = intersect::curve_self(curve, context.tolerance().absolute)?;
    let all = meetings(context, curve, &found)?;
    let parameters = all.iter().map(|m| m.1).chain(all.iter().map(|m| m.2)).collect();
    Ok((all.iter().map(|m| m.0).collect(), parameters))
}

/// Where curves of a list meet each other, pair by pair.
///
/// Where a curve meets itself does not count.
#[component(
    "931e6030-ccb3-4a7b-a89a-99dcce8770cd",
    name = "Multiple Curves",
    nick = "MCX",
    at = "Intersect/Physical"
)]
#[output("Points", "P", "The points.")]
#[output("Index A", "iA", "For each the place of the first curve in the list.")]
#[output("Index B", "iB", "For each the place of the second curve in the list.")]
#[output("Param A", "tA", "The parameters on the first curves.")]
#[output("Param B", "tB", "The parameters on the second curves.")]
fn multiple_curves(
    context: &Context<'_>,
    /// The curves.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
) -> Result<(Vec<Point3>, Vec<i32>, Vec<i32>, Vec<f64>, Vec<f64>), Message> {
    let curves: Vec<_> = curves.iter().enumerate().filter_map(|(i, c)| Some((i, c?))).collect();
    let boxes: Vec<_> = curves.iter().map(|(_, c)| c.bounding_box()).collect();
    let tolerance = context.tolerance().absolute;
    let index = BoxIndex::new(&boxes);
    let mut out = (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (k, ((i, a), bounds)) in curves.iter().zip(&boxes).enumerate() {
        context.check()?;
        for (j, b) in
            index.near(bounds, tolerance).into_iter().filter(|l| *l > k).filter_map(|l| curves.get(l))
        {
            context.check()?;
            let found = intersect::curve_curve(a, b, tolerance)?;
            for (point, s, t) in meetings(context, a, &found)? {
                out.0.push(point);
                out.1.push(i32::try_from(*i).unwrap_or(i32::MAX));
                out.2.push(i32::try_from(*j).unwrap_or(i32::MAX));
                out.3.push(s);
                out.4.push(t);
            }
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    fn p(x: f64, y: f64) -> Point3 {
        Point3::new(x, y, 0.0)
    }

    #[test]
    fn two_curves() {
        let (a, b) = (Line::new(p(0.0, 0.0), p(4.0, 0.0)), Line::new(p(1.0, -1.0), p(1.0, 3.0)));
        let cross = || Trial::of("Curve | Curve").item(a).item(b);
        let all: Vec<String> = (0..3).map(|k| cross().texts(k).join("")).collect();
        assert_eq!(all, ["{0;0}: {1, 0, 0}", "{0;0}: 0.25", "{0;0}: 0.25"]);
        let shared = Trial::of("Curve | Curve").item(a).item(Line::new(p(9.0, 0.0), p(3.0, 0.0)));
        assert_eq!(shared.texts(0), ["{0;0}: {3, 0, 0}, {4, 0, 0}"]);
        let above = Line::new(Point3::new(1.0, -1.0, 1.0), Point3::new(1.0, 1.0, 1.0));
        assert_eq!(Trial::of("Curve | Curve").item(a).item(above).run().outputs[0].item_count(), 0);
        let ring = |x: f64| Circle { plane: Plane { origin: p(x, 0.0), ..Plane::XY }, radius: 5.0 };
        let rings = Trial::of("Curve | Curve").item(ring(0.0)).item(ring(8.0));
        assert_eq!(rings.texts(0), ["{0;0}: {4, 3, 0}, {4, -3, 0}"]);
    }

    #[test]
    fn one_curve_and_many() {
        let bow = vec![p(0.0, 0.0), p(2.0, 2.0), p(2.0, 0.0), p(0.0, 2.0)];
        let bow = Curve::from(PolylineCurve::new(bow).unwrap());
        assert_eq!(Trial::of("Curve | Self").item(bow.clone()).texts(0), ["{0;0}: {1, 1, 0}"]);
        assert_eq!(Trial::of("Curve | Self").item(bow).texts(1), ["{0;0}: 0.5, 2.5"]);
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        assert_eq!(Trial::of("Curve | Self").item(circle).run().outputs[0].item_count(), 0);

        let lines = || [0.0, 1.0, 2.0].map(|y| Line::new(p(0.0, y), p(4.0, 2.0 - y)));
        let many = || Trial::of("Multiple Curves").list(lines());
        assert_eq!(many().texts(0), ["{0}: {2, 1, 0}, {2, 1, 0}, {2, 1, 0}"]);
        assert_eq!(many().texts(1), ["{0}: 0, 0, 1"]);
        assert_eq!(many().texts(2), ["{0}: 1, 2, 2"]);
    }
}
