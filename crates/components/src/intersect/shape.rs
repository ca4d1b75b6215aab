//! Intersect / Shape: regions that closed curves enclose, put together and cut.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::region::Region;
use katydid_geometry::{Curve, Interval, Plane};

use super::{closed_curves, plane_of};

/// The borders as an output gives them: of each piece the outline, then its holes.
fn borders(context: &Context<'_>, region: Region) -> Result<Vec<Shared<Curve>>, Message> {
    let curves: Vec<Shared<Curve>> =
        region.into_faces().into_iter().flat_map(|f| f.into_curves()).map(Shared::new).collect();
    context.items(curves.len())?;
    Ok(curves)
}

/// The outlines of all that closed curves enclose together.
///
/// Curves of every kind, projected into the plane; a piece of an arc stays an arc. Outlines run counter-clockwise about
/// the normal of the plane; holes come after their outlines and run clockwise. A curve inside another one adds nothing.
/// Places within the tolerance of each other are one. Open curves are left out with a warning.
#[component(
    "1222394f-0d33-4f31-9101-7281bde89fe5",
    name = "Region Union",
    nick = "RUnion",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The outlines and holes.")]
fn region_union(
    context: &Context<'_>,
    /// Closed curves.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// The plane; without it that of the first planar curve, with the normal upwards.
    #[port("Plane", "P")]
    plane: Option<Plane>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let curves = closed_curves(context, "C", &curves);
    if curves.is_empty() {
        return Ok(Vec::new());
    }
    let plane = plane_of(context, plane, curves.iter())?;
    borders(context, Region::union_of(&curves, &plane, context.tolerance().absolute)?)
}

/// What both lists prepare for an operation; nothing when neither has a closed curve.
fn both(
    context: &Context<'_>,
    a: &List<'_, Shared<Curve>>,
    b: &List<'_, Shared<Curve>>,
    plane: Option<Plane>,
) -> Result<Option<(Vec<Curve>, Vec<Curve>, Plane)>, Message> {
    let (a, b) = (closed_curves(context, "A", a), closed_curves(context, "B", b));
    if a.is_empty() && b.is_empty() {
        return Ok(None);
    }
    let plane = plane_of(context, plane, a.iter().chain(&b))?;
    Ok(Some((a, b, plane)))
}

/// The curves of a list in groups: each by itself where none goes over another, so that the borders between cells that
/// only touch stay; else all together.
fn groups(curves: Vec<Curve>, plane: &Plane, tolerance: f64) -> Result<Vec<Vec<Curve>>, Message> {
    if curves.len() > 1 {
        let apart: f64 = curves.iter().map(|curve| curve.signed_area_in(plane).0.abs()).sum();
        // Borders may lie the tolerance within one another.
        let slack: f64 = curves.iter().map(Curve::length).sum::<f64>() * tolerance;
        if apart > Region::union_of(&curves, plane, tolerance)?.area() + slack {
            return Ok(vec![curves]);
        }
    }
    Ok(curves.into_iter().map(|curve| vec![curve]).collect())
}

/// The rectangle around some curves in the coordinates of a plane.
fn extent(curves: &[Curve], plane: &Plane) -> Option<[Interval; 2]> {
    let boxes = curves.iter().map(|curve| curve.bounding_box_in(plane));
    boxes.map(|b| [b.x, b.y]).reduce(|[x, y], [u, v]| [x.union(u), y.union(v)])
}

/// What the curves of one list enclose, without what those of another one enclose.
///
/// Where the first curves only touch one another, each is cut by itself and the borders between them stay.
///
///
/// Curves of every kind, projected into the plane; a piece of an arc stays an arc. Outlines run counter-clockwise about
/// the normal of the plane; holes come after their outlines and run clockwise. Where nothing is left the result is empty.
/// Open curves are left out with a warning.
#[component(
    "f72c480b-7ee6-42ef-9821-c371e9203b44",
    name = "Region Difference",
    nick = "RDiff",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The outlines and holes.")]
fn region_difference(
    context: &Context<'_>,
    /// The closed curves to take away from.
    #[port("Curves A", "A")]
    curves_a: List<Shared<Curve>>,
    /// The closed curves to take away.
    #[port("Curves B", "B")]
    curves_b: List<Shared<Curve>>,
    /// The plane; without it that of the first planar curve, with the normal upwards.
    #[port("Plane", "P")]
    plane: Option<Plane>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let Some((a, b, plane)) = both(context, &curves_a, &curves_b, plane)? else { return Ok(Vec::new()) };
    let tolerance = context.tolerance().absolute;
    let mut out = Vec::new();
    for a in groups(a, &plane, tolerance)? {
        context.check()?;
        out.extend(borders(context, Region::difference_of(&a, &b, &plane, tolerance)?)?);
    }
    Ok(out)
}

/// What the curves of two lists both enclose.
///
/// Where the curves of a list only touch one another, as cells do, each is cut by itself and the borders between them
/// stay: cells and an outline give cells within the outline.
///
/// Curves of every kind, projected into the plane; a piece of an arc stays an arc. Outlines run counter-clockwise about
/// the normal of the plane; holes come after their outlines and run clockwise. Where nothing is common the result is
/// empty. Open curves are left out with a warning.
#[component(
    "477c2e7b-c5e5-421e-b8b2-ba60cdf5398b",
    name = "Region Intersection",
    nick = "RInt",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The outlines and holes.")]
fn region_intersection(
    context: &Context<'_>,
    /// Closed curves.
    #[port("Curves A", "A")]
    curves_a: List<Shared<Curve>>,
    /// Other closed curves.
    #[port("Curves B", "B")]
    curves_b: List<Shared<Curve>>,
    /// The plane; without it that of the first planar curve, with the normal upwards.
    #[port("Plane", "P")]
    plane: Option<Plane>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let Some((a, b, plane)) = both(context, &curves_a, &curves_b, plane)? else { return Ok(Vec::new()) };
    let tolerance = context.tolerance().absolute;
    let others: Vec<(Vec<Curve>, Option<[Interval; 2]>)> = groups(b, &plane, tolerance)?
        .into_iter()
        .map(|group| {
            let extent = extent(&group, &plane);
            (group, extent)
        })
        .collect();
    let mut out = Vec::new();
    for a in groups(a, &plane, tolerance)? {
        let Some(own) = extent(&a, &plane) else { continue };
        for (b, extent) in &others {
            context.check()?;
            let meets = |(x, y): (&Interval, &Interval)| {
                x.min() <= y.max() + tolerance && y.min() <= x.max() + tolerance
            };
            if extent.is_some_and(|other| own.iter().zip(&other).all(meets)) {
                out.extend(borders(context, Region::intersection_of(&a, b, &plane, tolerance)?)?);
            }
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_data::{Tree, Value};
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    fn circle(x: f64, z: f64, radius: f64) -> Circle {
        Circle { plane: Plane::XY.with_origin(Point3::new(x, 0.0, z)), radius }
    }

    fn square(x: f64) -> Curve {
        let corners = [[x, 0.0, 0.0], [x + 2.0, 0.0, 0.0], [x + 2.0, 2.0, 0.0], [x, 2.0, 0.0], [x, 0.0, 0.0]];
        PolylineCurve::new(corners.map(Point3::from).to_vec()).unwrap().into()
    }

    /// The number of curves and the sum of their areas, holes negative.
    fn area(result: &Tree) -> (usize, f64) {
        let mut sum = 0.0;
        let mut count = 0;
        for value in result.branches().flat_map(|b| b.iter()) {
            let Some(Value::Curve(curve)) = value else { continue };
            sum += curve.signed_area_in(&Plane::XY).0;
            count += 1;
        }
        (count, sum)
    }

    fn near((count, sum): (usize, f64), want: usize, area: f64) {
        assert!(count == want && (sum - area).abs() < 1e-9, "{count} {sum}");
    }

    #[test]
    fn unions() {
        let union = |list: Vec<Curve>| area(&Trial::of("Region Union").list(list).run().outputs[0]);
        near(union(vec![square(0.0), square(1.0)]), 1, 6.0);
        near(union(vec![square(0.0), square(2.0)]), 1, 8.0);
        near(union(vec![square(0.0), square(5.0)]), 2, 8.0);
        near(union(vec![circle(0.0, 0.0, 1.0).into(), circle(0.0, 0.0, 3.0).into()]), 1, 9.0 * PI);
        // Clockwise curves enclose as much, and others are seen in the plane of the first.
        near(union(vec![square(0.0).reversed(), circle(1.0, 7.0, 0.5).into()]), 1, 4.0 + PI / 8.0);
        let open = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        let mixed = Trial::of("Region Union").list(vec![square(0.0), open.into()]);
        assert!(mixed.message().contains("open"));
        near(area(&Trial::of("Region Union").list(vec![square(0.0), open.into()]).run().outputs[0]), 1, 4.0);
        let tilted =
            Plane::from_axes(Point3::ORIGIN, [1.0, 0.0, 0.0].into(), [0.0, 0.0, 1.0].into()).unwrap();
        let edge_on = Trial::of("Region Union").list(vec![square(0.0)]).item(tilted).run();
        assert_eq!(edge_on.outputs[0].item_count(), 0);
    }

    #[test]
    fn differences_and_intersections() {
        let both = |name: &str, a: Vec<Curve>, b: Vec<Curve>| {
            area(&Trial::of(name).list(a).list(b).run().outputs[0])
        };
        near(both("Region Difference", vec![square(0.0), square(4.0)], vec![square(1.0)]), 2, 6.0);
        let hole = vec![circle(1.0, 0.0, 0.5).into()];
        near(both("Region Difference", vec![circle(1.0, 0.0, 2.0).into()], hole), 2, 3.75 * PI);
        near(both("Region Difference", vec![square(0.0)], vec![square(0.0)]), 0, 0.0);
        near(
            both("Region Intersection", vec![square(0.0), square(4.0)], vec![square(1.0), square(5.0)]),
            2,
            4.0,
        );
        near(both("Region Intersection", vec![square(0.0)], vec![square(3.0)]), 0, 0.0);
        // Cells that touch stay apart on both sides; curves that overlap count as one.
        let cells = || vec![square(0.0), square(2.0), square(4.0)];
        near(both("Region Intersection", cells(), vec![circle(3.0, 0.0, 10.0).into()]), 3, 12.0);
        near(both("Region Intersection", vec![circle(3.0, 0.0, 10.0).into()], cells()), 3, 12.0);
        near(both("Region Intersection", cells(), cells()), 3, 12.0);
        near(both("Region Intersection", vec![square(0.0), square(1.0)], vec![square(0.5)]), 1, 4.0);
        near(both("Region Difference", cells(), vec![square(1.0)]), 3, 8.0);
    }
}
