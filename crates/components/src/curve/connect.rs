//! Curve / Spline: curves that lead from one to the next.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Curve, Point3, connect_curves};

use super::{shared, warning};

/// A continuity that a port asks for, 0 to 2.
fn order(continuity: i32) -> Result<u8, Message> {
    u8::try_from(continuity).ok().filter(|&g| g <= 2).ok_or_else(|| {
        Message::error(format!("There is no continuity {continuity}: 0 is position, 1 tangency, 2 curvature"))
    })
}

/// The curve that leads from the end of one curve to the start of another.
///
/// It goes on with both in position, direction or curvature. Ends in one place need no blend: a warning.
#[component(
    "5909dbcb-4950-4ce4-9433-7cf9e62ee011",
    name = "Blend Curve",
    nick = "BlendC",
    at = "Curve/Spline"
)]
#[output("Blend", "B", "The curve between them.")]
fn blend_curve(
    /// The curve whose end is left.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The curve whose start is reached.
    #[port("Curve B", "B")]
    b: &Curve,
    /// How far the blend follows the direction of the first curve; above 0, 1 is usual.
    #[port("Bulge A", "Fa", default = 1.0)]
    bulge_a: f64,
    /// How far it follows the direction of the second curve.
    #[port("Bulge B", "Fb", default = 1.0)]
    bulge_b: f64,
    /// 0 for a straight line, 1 for equal directions, 2 for equal curvature.
    #[port("Continuity", "C", default = 2)]
    continuity: i32,
) -> Result<Shared<Curve>, Message> {
    a.blend_to(b, [order(continuity)?; 2], [bulge_a, bulge_b]).map(shared).map_err(warning)
}

/// The curve that leads from the end of one curve to the start of another by way of a point.
///
/// How far it follows both directions is chosen so that it passes through the point. Where it cannot, in space or on
/// the inner side of the way, it comes as near as it can, with a warning.
#[component(
    "14cf43b6-5eb9-460f-899c-bdece732213a",
    name = "Blend Curve Pt",
    nick = "BlendCPt",
    at = "Curve/Spline"
)]
#[output("Blend", "B", "The curve between them.")]
fn blend_curve_pt(
    context: &Context<'_>,
    /// The curve whose end is left.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The curve whose start is reached.
    #[port("Curve B", "B")]
    b: &Curve,
    /// The point to pass through.
    #[port("Point", "P")]
    point: Point3,
    /// 0 for a straight line, 1 for equal directions, 2 for equal curvature.
    #[port("Continuity", "C", default = 1)]
    continuity: i32,
) -> Result<Shared<Curve>, Message> {
    let (blend, miss) = a.blend_through(b, [order(continuity)?; 2], point).map_err(warning)?;
    if miss > context.tolerance().absolute {
        context.warn("No blend passes through the point: this is the nearest");
    }
    Ok(shared(blend))
}

/// Makes one curve of several: from the end of each a blend leads to the start of the next.
///
/// Curves keep their order and directions. Ends that meet already are joined as they are. Nulls are skipped.
#[component(
    "d0a1b843-873d-4d1d-965c-b5423b35f327",
    name = "Connect Curves",
    nick = "Connect",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The whole curve.")]
fn connect(
    context: &Context<'_>,
    /// The curves.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// How blends go on: 0 in position, 1 in direction, 2 in curvature.
    #[port("Continuity", "G", default = 2)]
    continuity: i32,
    /// Whether a last blend leads back to the first curve.
    #[port("Close", "L", default = false)]
    close: bool,
    /// How far blends follow the directions of the curves; above 0, 1 is usual.
    #[port("Bulge", "B", default = 1.0)]
    bulge: f64,
) -> Result<Shared<Curve>, Message> {
    let curves: Vec<Curve> = curves.present().map(|c| (*c).clone()).collect();
    connect_curves(&curves, order(continuity)?, close, bulge, context.tolerance().absolute)
        .map(shared)
        .map_err(warning)
}

/// Moves the end of one curve so that it goes on into the start of another.
///
/// Only the control points at that end move: one for position, two for direction, three for curvature.
#[component(
    "282bf4eb-668a-4a2c-81af-2432ac863ddd",
    name = "Match Curve",
    nick = "MatchCrv",
    at = "Curve/Spline"
)]
#[output("Match", "M", "The changed curve.")]
fn match_curve(
    /// The curve to change.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The curve whose start its end is moved to.
    #[port("Curve B", "B")]
    b: &Curve,
    /// 0 for equal position, 1 for equal direction, 2 for equal curvature.
    #[port("Continuity", "C", default = 1)]
    continuity: i32,
) -> Result<Shared<Curve>, Message> {
    let order = order(continuity)?;
    let mut nurbs = a.to_nurbs()?;
    // A cubic has the control points that direction and curvature ask for.
    let needed = usize::from(order) + 1;
    if order > 0 && (nurbs.degree() < needed || nurbs.point_count() < needed + 1) {
        nurbs = nurbs.raised_to(nurbs.degree().max(needed))?;
    }
    nurbs.matched_to(true, b, order).map(shared).map_err(warning)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Curve, Line, Point3, Vector3};

    fn p(x: f64, y: f64) -> Point3 {
        Point3::new(x, y, 0.0)
    }

    fn up() -> Line {
        Line::new(p(0.0, -1.0), p(0.0, 0.0))
    }

    fn down() -> Line {
        Line::new(p(4.0, 0.0), p(4.0, -1.0))
    }

    fn curve(trial: Trial) -> Curve {
        let outcome = trial.run();
        match outcome.outputs[0].column().get(0) {
            Some(Value::Curve(curve)) => (*curve).clone(),
            other => panic!("{other:?} {:?}", outcome.messages),
        }
    }

    #[test]
    fn blends() {
        let blend = |g: i32, f: f64| Trial::of("Blend Curve").item(up()).item(down()).item(f).item(f).item(g);
        assert_eq!(curve(blend(0, 1.0)).length(), 4.0);
        let smooth = curve(blend(1, 1.0));
        // ¾ of a leg that is a third of the way.
        assert!(smooth.point_at(0.5).distance_to(p(2.0, 1.0)) < 1e-12);
        assert!(smooth.tangent_at(0.0).unwrap().dot(Vector3::Y) > 1.0 - 1e-12);
        assert!(curve(blend(2, 1.0)).curvature_at(0.0).length() < 1e-9);
        assert!(blend(3, 1.0).message().contains("continuity 3"));
        assert!(blend(1, 0.0).message().contains("bulge"));
        let through = |q: Point3| Trial::of("Blend Curve Pt").item(up()).item(down()).item(q).item(1);
        assert!(curve(through(p(1.5, 2.5))).closest_point(p(1.5, 2.5)).unwrap().distance < 1e-9);
        assert!(through(Point3::new(2.0, 2.0, 3.0)).message().contains("nearest"));
    }

    #[test]
    fn connected_and_matched() {
        let connect = || Trial::of("Connect Curves").list([up(), down()]).item(0);
        assert_eq!(curve(connect()).length(), 6.0);
        assert!(curve(connect().item(true)).is_closed());
        let none = Trial::of("Connect Curves").gaps([None::<Line>]);
        assert!(none.message().contains("none"));
        let matched = |g: i32| curve(Trial::of("Match Curve").item(up()).item(down()).item(g));
        assert_eq!(matched(0).end(), p(4.0, 0.0));
        let end = matched(1);
        assert!(end.tangent_at(end.domain().end).unwrap().dot(-Vector3::Y) > 1.0 - 1e-9);
        assert_eq!(end.start(), p(0.0, -1.0));
    }
}
