//! Deformations along axes and curves.

use std::borrow::Cow;

use katydid_component::{Context, Message, component};
use katydid_data::Geometry;
use katydid_geometry::morph::{Bend, Flow, Maelstrom, Stretch, Taper, Twist};
use katydid_geometry::{Arc, Curve, Line, Plane, Point3};

use super::{Manner, morphed, sound};

/// Lengthens or shortens geometry along an axis.
///
/// What lies behind the start of the axis stays; what lies beside it is scaled along it, so that the axis gets the new
/// length; what lies beyond its end is shifted with the end.
#[component(
    "2a27f87c-61c5-47c2-a0b7-7863f31a3594",
    name = "Stretch",
    nick = "Stretch",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The stretched geometry.")]
fn stretch(
    context: &Context<'_>,
    /// What to stretch.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// Where to stretch, and in which direction.
    #[port("Axis", "X", default = Line::new(Point3::ORIGIN, Point3::new(10.0, 10.0, 0.0)))]
    axis: Line,
    /// The length that the axis gets, in units.
    #[port("Length", "L", default = 20.0)]
    length: f64,
    /// Whether geometry keeps its shape and is moved as its middle is.
    #[port("Rigid", "R", default = false)]
    rigid: bool,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &Stretch::new(sound(axis)?, length)?, Manner::of(rigid))
}

/// Makes geometry narrower or wider along an axis.
///
/// What is at the distance R0 from the axis at its start keeps it, and at the end of the axis the same distance becomes
/// R1; between the two the factor changes evenly.
#[component("ad0ee51e-c86f-4668-8de5-b55b850f6001", name = "Taper", nick = "Taper", at = "Transform/Morph")]
#[output("Geometry", "G", "The tapered geometry.")]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn taper(
    context: &Context<'_>,
    /// What to taper.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The axis.
    #[port("Axis", "X")]
    axis: Line,
    /// A distance from the axis at its start; not zero.
    #[port("Start", "R0")]
    start: f64,
    /// What that distance becomes at the end of the axis.
    #[port("End", "R1")]
    end: f64,
    /// Whether it acts only in the horizontal direction across the axis; for a vertical axis that is x.
    #[port("Flat", "F", default = false)]
    flat: bool,
    /// Whether it goes on beyond the ends of the axis; else the factor stays there.
    #[port("Infinite", "I", default = false)]
    infinite: bool,
    /// Whether geometry keeps its shape and is moved as its middle is.
    #[port("Rigid", "R", default = false)]
    rigid: bool,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &Taper::new(sound(axis)?, start, end, flat, infinite)?, Manner::of(rigid))
}

/// Twists geometry about an axis, by the right-hand rule.
#[component("9509cb30-d24f-4f55-a5ac-bf0b12a06cfa", name = "Twist", nick = "Twist", at = "Transform/Morph")]
#[output("Geometry", "G", "The twisted geometry.")]
fn twist(
    context: &Context<'_>,
    /// What to twist.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The axis: nothing is turned at its start.
    #[port("Axis", "X")]
    axis: Line,
    /// The turn at the end of the axis, in radians.
    #[port("Angle", "A")]
    angle: f64,
    /// Whether it goes on beyond the ends of the axis; else the turn stays as it is there.
    #[port("Infinite", "I", default = false)]
    infinite: bool,
    /// Whether geometry keeps its shape and is moved as its middle is.
    #[port("Rigid", "R", default = false)]
    rigid: bool,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &Twist::new(sound(axis)?, angle, infinite)?, Manner::of(rigid))
}

/// Bends geometry so that a straight axis becomes an arc of the same length.
///
/// The axis starts where the arc starts and runs along its tangent there. What lies behind the start stays, what lies
/// beyond the end goes on straight.
#[component(
    "539f5564-4fc0-4fc1-a7d3-b802fa2ef072",
    name = "Bend Deform",
    nick = "Bend",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The bent geometry.")]
fn bend_deform(
    context: &Context<'_>,
    /// What to bend.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The arc that the axis becomes.
    #[port("Bending Arc", "B")]
    arc: Arc,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &Bend::new(&arc)?, Manner::Bent)
}

/// Turns geometry like a whirl about the normal of a plane.
///
/// Within the first radius it is turned by the whole angle, beyond the second not at all, and evenly less between them.
#[component(
    "134a849b-0ff4-4f36-bdd5-95e3996bae8b",
    name = "Maelstrom",
    nick = "Maelstrom",
    at = "Transform/Morph"
)]
#[output("Geometry", "G", "The turned geometry.")]
fn maelstrom(
    context: &Context<'_>,
    /// What to turn.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The plane of the whirl, about its origin.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The radius of the whole turn.
    #[port("First", "R0")]
    first: f64,
    /// The radius without a turn; not the same as the first.
    #[port("Second", "R1")]
    second: f64,
    /// The whole turn, in radians.
    #[port("Angle", "A")]
    angle: f64,
    /// Whether geometry keeps its shape and is moved as its middle is.
    #[port("Rigid", "R", default = false)]
    rigid: bool,
) -> Result<Geometry, Message> {
    morphed(context, &geometry, &Maelstrom::new(plane, first, second, angle)?, Manner::of(rigid))
}

/// Carries geometry along with a curve that is laid over another one.
///
/// What lies beside a point of the base lies the same way beside the point of the target. Sideways directions follow both
/// curves with as little turn about them as possible, and at their starts differ by the smallest turn between the
/// tangents.
#[component("c3249da4-3f8e-4400-833e-e4e984d28657", name = "Flow", nick = "Flow", at = "Transform/Morph")]
#[output("Geometry", "G", "The geometry along the target.")]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn flow(
    context: &Context<'_>,
    /// What to carry.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The curve beside which the geometry lies.
    #[port("Base", "C0")]
    base: &Curve,
    /// The curve beside which it shall lie.
    #[port("Target", "C1")]
    target: &Curve,
    /// Whether the base is followed backwards.
    #[port("Reverse Base", "R0", default = false)]
    reverse_base: bool,
    /// Whether the target is followed backwards.
    #[port("Reverse Target", "R1", default = false)]
    reverse_target: bool,
    /// Whether the whole base becomes the whole target; else lengths are kept, and a target that is too short goes on
    /// straight.
    #[port("Stretch", "S", default = false)]
    stretch: bool,
    /// Whether geometry keeps its shape and is moved as its middle is.
    #[port("Rigid", "R", default = false)]
    rigid: bool,
) -> Result<Geometry, Message> {
    let base = directed(base, reverse_base);
    let target = directed(target, reverse_target);
    morphed(context, &geometry, &Flow::new(&base, &target, stretch)?, Manner::of(rigid))
}

fn directed(curve: &Curve, backwards: bool) -> Cow<'_, Curve> {
    if backwards { Cow::Owned(curve.reversed()) } else { Cow::Borrowed(curve) }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Circle, Interval};

    use super::*;

    fn line(a: [f64; 3], b: [f64; 3]) -> Line {
        Line::new(a.into(), b.into())
    }

    fn first(trial: Trial) -> Value {
        trial.run().outputs.first().unwrap().column().get(0).unwrap()
    }

    #[test]
    fn stretch_doubles_its_axis() {
        let axis = line([0.0; 3], [10.0, 0.0, 0.0]);
        let trial = |g: Value, rigid: bool| Trial::of("Stretch").item(g).item(axis).item(20.0).item(rigid);
        assert_eq!(trial(axis.into(), false).texts(0), ["{0}: Line(L:20.00 mm)"]);
        assert_eq!(trial(Point3::new(5.0, 1.0, 0.0).into(), false).texts(0), ["{0}: {10, 1, 0}"]);
        let Value::Line(whole) = first(trial(line([4.0, 1.0, 0.0], [6.0, 1.0, 0.0]).into(), true)) else {
            panic!("a line")
        };
        assert!(whole.from.distance_to(Point3::new(9.0, 1.0, 0.0)) < 1e-9);
        assert!(whole.to.distance_to(Point3::new(11.0, 1.0, 0.0)) < 1e-9);
        let none = Trial::of("Stretch").item(axis).item(line([1.0; 3], [1.0; 3])).item(20.0);
        assert!(none.default().message().contains("no length"));
        let solid = katydid_geometry::Box3 {
            plane: Plane::XY,
            x: Interval::UNIT,
            y: Interval::UNIT,
            z: Interval::UNIT,
        };
        let Value::Brep(long) = first(trial(solid.into(), false)) else { panic!("a solid") };
        assert!(long.is_valid() && long.is_solid());
    }

    #[test]
    fn taper_and_twist_follow_their_axis() {
        let up = line([0.0; 3], [0.0, 0.0, 2.0]);
        let p = Point3::new(2.0, 0.0, 2.0);
        let taper = Trial::of("Taper").item(p).item(up).item(2.0).item(1.0);
        assert_eq!(taper.default().default().default().texts(0), ["{0}: {1, 0, 2}"]);
        let twist = Trial::of("Twist").item(p).item(up).item(FRAC_PI_2).default().default();
        assert_eq!(twist.texts(0), ["{0}: {0, 2, 2}"]);
        let zero = Trial::of("Taper").item(p).item(up).item(0.0).item(1.0);
        assert!(zero.default().default().default().message().contains("start"));
    }

    #[test]
    fn a_line_bends_into_the_arc() {
        let circle = Circle { plane: Plane::XY, radius: 2.0 };
        let arc = Arc::new(circle, Interval::new(0.0, PI)).unwrap();
        let axis = line([2.0, 0.0, 0.0], [2.0, 2.0 * PI, 0.0]);
        let Value::Curve(bent) = first(Trial::of("Bend Deform").item(axis).item(arc)) else {
            panic!("a curve")
        };
        assert!((bent.length() - 2.0 * PI).abs() < 1e-9);
        assert!(bent.end().distance_to(Point3::new(-2.0, 0.0, 0.0)) < 1e-9);
    }

    #[test]
    fn maelstrom_and_flow() {
        let p = Point3::new(1.0, 0.0, 3.0);
        let whirl = Trial::of("Maelstrom").item(p).default().item(2.0).item(4.0).item(FRAC_PI_2).default();
        assert_eq!(whirl.texts(0), ["{0}: {0, 1, 3}"]);
        let base = line([0.0; 3], [4.0, 0.0, 0.0]);
        let flow = |reverse: bool| {
            let trial = Trial::of("Flow").item(p).item(base).item(base).item(reverse).item(reverse);
            trial.default().default()
        };
        assert_eq!(flow(false).texts(0), ["{0}: {1, 0, 3}"]);
        assert_eq!(flow(true).texts(0), ["{0}: {1, 0, 3}"]);
    }
}
