//! Curve / Primitive and Spline: arcs and circles that touch circles, chains of links, and boards in rooms.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{
    Arc, Circle, Curve, Line, Plane, Point3, PolylineCurve, Rectangle, Vector3, hanging_chain,
    longest_rectangle, swing_arcs,
};

use super::{shared, warning};

/// The two arcs of a radius that touch two circles from outside, like a rounded notch between them.
///
/// The second circle is projected into the plane of the first. A radius too small to bridge the gap, or a circle within
/// the other, gives none: a warning.
#[component(
    "f1c0783b-60e9-42a7-8081-925bc755494c",
    name = "Tangent Arcs",
    nick = "TArc",
    at = "Curve/Primitive"
)]
#[output("Arc A", "A", "The arc on the left of the way from circle to circle.")]
#[output("Arc B", "B", "The arc on the right.")]
fn tangent_arcs(
    /// The circle where the arcs start.
    #[port("Circle A", "A")]
    a: Circle,
    /// The circle where they end.
    #[port("Circle B", "B")]
    b: Circle,
    /// The radius of the arcs, above 0.
    #[port("Radius", "R")]
    radius: f64,
) -> Result<(Arc, Arc), Message> {
    let [left, right] = a.tangent_arcs(&b, radius).map_err(warning)?;
    Ok((left, right))
}

/// The two circles of a radius that touch two circles from outside. An early form of Tangent Arcs.
#[component(
    "0a80e903-e15b-4992-9675-19b2c488e853",
    name = "Circle Fit [OBSOLETE]",
    nick = "CFit",
    at = "Curve/Spline",
    old
)]
#[output("Fit A", "A", "The circle on the left of the way from centre to centre.")]
#[output("Fit B", "B", "The circle on the right.")]
fn early_circle_fit(
    /// A circle.
    #[port("Circle A", "A")]
    a: Circle,
    /// Another circle.
    #[port("Circle B", "B")]
    b: Circle,
    /// The radius of the touching circles, above 0.
    #[port("Radius", "R")]
    radius: f64,
) -> Result<(Circle, Circle), Message> {
    let [left, right] = a.tangent_arcs(&b, radius).map_err(warning)?;
    Ok((left.circle, right.circle))
}

/// A chain of stiff links between two points, each with its own length and weight.
///
/// Links hang so that all forces are in balance. Together they must be longer than the way between the points; else
/// there is a warning and no chain.
#[component(
    "769f9064-17f5-4c4a-921f-c3a0ee05ba3a",
    name = "Catenary Ex",
    nick = "CatEx",
    at = "Curve/Spline"
)]
#[output("Catenary", "C", "The chain as a polyline.")]
#[output("Segments", "S", "The links.")]
fn catenary_ex(
    /// One end.
    #[port("Point A", "A")]
    a: Point3,
    /// The other end.
    #[port("Point B", "B")]
    b: Point3,
    /// The lengths of the links, each above 0.
    #[port("Lengths", "L")]
    lengths: List<f64>,
    /// The weights of the links; only their ratios count. Fewer weights than links: the last one goes on.
    #[port("Weights", "W", optional)]
    weights: List<f64>,
    /// The direction in which it hangs; its length does not matter.
    #[port("Gravity", "G", default = Vector3::new(0.0, 0.0, -1.0))]
    gravity: Vector3,
) -> Result<(Shared<Curve>, Vec<Shared<Curve>>), Message> {
    let lengths: Vec<f64> = lengths.present().collect();
    let mut weights: Vec<f64> = weights.present().collect();
    weights.resize(lengths.len(), weights.last().copied().unwrap_or(1.0));
    let joints = hanging_chain(a, b, &lengths, &weights, gravity).map_err(warning)?;
    let links = joints.windows(2).filter_map(|w| match *w {
        [p, q] => Some(shared(Line::new(p, q))),
        _ => None,
    });
    let links = links.collect();
    Ok((shared(PolylineCurve::new(joints).map_err(warning)?), links))
}

/// Two smooth curves of arcs that wind through a row of circles, each of which touches the next.
///
/// The first circle has the given radius; the others have the radius with which they touch the one before. The curves
/// pass each circle on opposite sides, and change sides from circle to circle.
#[component("3edc4fbd-24c6-43de-aaa8-5bdf0704373d", name = "Swing Arc", nick = "Swing", at = "Curve/Spline")]
#[output("Curve A", "A", "The curve that passes the first circle on the left.")]
#[output("Curve B", "B", "The curve that passes it on the right.")]
#[output("Circles", "C", "The circles.")]
fn swing_arc(
    /// The centres of the circles, at least two; they are projected into the plane.
    #[port("Centers", "C")]
    centers: List<Point3>,
    /// The plane of the arcs.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The radius of the first circle, above 0.
    #[port("Radius", "R")]
    radius: f64,
) -> Result<(Shared<Curve>, Shared<Curve>, Vec<Circle>), Message> {
    let centers: Vec<Point3> = centers.present().collect();
    let swing = swing_arcs(&centers, &plane, radius).map_err(warning)?;
    Ok((shared(swing.left), shared(swing.right), swing.circles))
}

/// The longest rectangle of a given width that lies in a room, in any direction.
///
/// Where none fits there is a warning.
#[component(
    "c21e7bd5-b1f2-4448-ac56-206f98f90aa7",
    name = "TwoByFourJam",
    nick = "2x4 Jam",
    at = "Curve/Primitive"
)]
#[output("Rectangle", "R", "The rectangle, its x along its length.")]
fn two_by_four_jam(
    context: &Context<'_>,
    /// The outline of the room: a closed flat curve.
    #[port("Room", "R")]
    room: &Curve,
    /// The width of the rectangle, above 0.
    #[port("Width", "W")]
    width: f64,
    /// How many directions are tried before the best are turned further; 1 to 1000.
    #[port("Samples", "S", default = 36)]
    samples: i32,
) -> Result<Rectangle, Message> {
    let samples = usize::try_from(samples).unwrap_or(0);
    longest_rectangle(room, width, samples, context.tolerance().absolute).map_err(warning)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Interval, Plane, Point3, Rectangle};

    fn p(x: f64, y: f64) -> Point3 {
        Point3::new(x, y, 0.0)
    }

    fn ring(x: f64) -> Circle {
        Circle { plane: Plane::XY.with_origin(p(x, 0.0)), radius: 2.0 }
    }

    #[test]
    fn touching_arcs() {
        let arcs = || Trial::of("Tangent Arcs").item(ring(0.0)).item(ring(8.0));
        assert_eq!(arcs().item(3.0).texts(0), ["{0}: Arc(R:3.00 mm A:106.260205\u{b0})"]);
        assert!(arcs().item(1.0).message().contains("large enough"));
        let circles = Trial::of("Circle Fit [OBSOLETE]").item(ring(0.0)).item(ring(8.0)).item(3.0);
        assert_eq!(circles.texts(1), ["{0}: Circle(R:3.00 mm)"]);
    }

    #[test]
    fn links_hang() {
        let chain =
            Trial::of("Catenary Ex").item(p(0.0, 0.0)).item(p(6.0, 0.0)).list([5.0, 5.0]).run().outputs;
        assert_eq!(chain[1].item_count(), 2);
        let ends = Trial::of("End Points").tree(chain[1].clone()).texts(1).join("");
        assert!(ends.starts_with("{0;0}: {3, 0, -4}"), "{ends}");
        let short = Trial::of("Catenary Ex").item(p(0.0, 0.0)).item(p(6.0, 0.0)).list([2.0, 3.0]);
        assert!(short.message().contains("distance"));
    }

    #[test]
    fn arcs_swing() {
        let swing = Trial::of("Swing Arc").list([p(0.0, 0.0), p(3.0, 0.0)]).default().item(1.0).run().outputs;
        assert_eq!(texts(&swing[2]), ["{0;0}: Circle(R:1.00 mm), Circle(R:2.00 mm)"]);
        let length = Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(swing[0].clone());
        assert_eq!(length.texts(0), ["{0}: 9.424778"]);
        assert!(Trial::of("Swing Arc").list([p(0.0, 0.0)]).default().item(1.0).message().contains("centres"));
    }

    #[test]
    fn boards_in_rooms() {
        let side = Interval::new(0.0, 4.0);
        let room = Rectangle { plane: Plane::XY, x: side, y: side };
        let board = |w: f64| Trial::of("TwoByFourJam").item(room).item(w).item(45);
        assert_eq!(board(0.5).texts(0), ["{0}: Rectangle (w=5.156854, h=0.5)"]);
        assert!(board(5.7).message().contains("fits"));
        assert!(board(0.0).message().contains("greater than 0"));
    }
}
