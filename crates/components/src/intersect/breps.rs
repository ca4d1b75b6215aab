//! Intersect / Physical and Shape: Breps with Breps.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::brep::{BrepMeeting, Fuse};
use katydid_geometry::{Brep, Curve, Point3};

/// What two Breps have in common, with a warning where something may be missing.
fn meeting(context: &Context<'_>, a: &Brep, b: &Brep) -> Result<BrepMeeting, Message> {
    let found = a.meeting(b, &context.tolerance())?;
    if !found.complete {
        context.warn("Faces are tangent to each other or lie upon each other: some meetings may be missing");
    }
    Ok(found)
}

/// The curves and points that two Breps have in common.
///
/// Curves run where faces pass through each other or end on each other, and are joined where they meet: lines, circles
/// and arcs as such. Points are where faces only touch. Surfaces are Breps of one face.
#[component(
    "904e4b56-484a-4814-b35f-aa4baf362117",
    name = "Brep | Brep",
    nick = "BBX",
    at = "Intersect/Physical"
)]
#[output("Curves", "C", "The common curves.")]
#[output("Points", "P", "The points in which faces touch.")]
fn brep_brep(
    context: &Context<'_>,
    /// A Brep.
    #[port("Brep A", "A")]
    a: Shared<Brep>,
    /// Another Brep.
    #[port("Brep B", "B")]
    b: Shared<Brep>,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    let found = meeting(context, &a, &b)?;
    context.items(found.curves.len() + found.points.len())?;
    Ok((found.curves.into_iter().map(Shared::new).collect(), found.points))
}

/// The parts into which others cut a Brep. Where the fuse of all of them is not decided, the curves in which they meet cut
/// it.
fn parts(
    context: &Context<'_>,
    brep: &Shared<Brep>,
    cutters: &[Shared<Brep>],
) -> Result<Vec<Shared<Brep>>, Message> {
    let all: Vec<Brep> = std::iter::once(brep).chain(cutters).map(|b| Brep::clone(b)).collect();
    let fused = Fuse::new(&all, &context.tolerance()).and_then(|fuse| fuse.faces_of(0));
    context.check()?;
    let parts: Vec<Brep> = match fused {
        Ok(found) => found.into_iter().map(|(_, made)| made.brep).collect(),
        Err(_) => along_curves(context, brep, cutters)?,
    };
    context.items(parts.len())?;
    if parts.len() <= 1 {
        return Ok(vec![Shared::clone(brep)]);
    }
    Ok(parts.into_iter().map(Shared::new).collect())
}

fn along_curves(context: &Context<'_>, brep: &Brep, cutters: &[Shared<Brep>]) -> Result<Vec<Brep>, Message> {
    let mut curves = Vec::new();
    for cutter in cutters {
        context.check()?;
        curves.extend(meeting(context, brep, cutter)?.curves);
    }
    let parts = brep.split_along(&curves, &context.tolerance(), || context.check().is_ok());
    context.check()?;
    Ok(parts?)
}

/// Cuts a Brep with another one.
///
/// The parts stay open where they were cut. A Brep that the cutter does not part, or without a cutter, comes back whole.
#[component(
    "ef6b26f4-f820-48d6-b0c5-85898ef8888b",
    name = "Split Brep",
    nick = "Split",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The parts.")]
fn split_brep(
    context: &Context<'_>,
    /// The Brep to cut.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The Brep to cut with.
    #[port("Cutter", "C")]
    cutter: Option<Shared<Brep>>,
) -> Result<Vec<Shared<Brep>>, Message> {
    parts(context, &brep, cutter.as_slice())
}

/// Cuts a Brep with many others at once.
///
/// The parts stay open where they were cut. A Brep that no cutter parts comes back whole.
#[component(
    "03f22640-ff80-484e-bb53-a4025c5faa07",
    name = "Split Brep Multiple",
    nick = "SplitMul",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The parts.")]
fn split_brep_multiple(
    context: &Context<'_>,
    /// The Brep to cut.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The Breps to cut with.
    #[port("Cutters", "C")]
    cutters: List<'_, Shared<Brep>>,
) -> Result<Vec<Shared<Brep>>, Message> {
    let cutters: Vec<Shared<Brep>> = cutters.iter().flatten().map(|c| Shared::clone(&c)).collect();
    parts(context, &brep, &cutters)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Plane, PlaneSurface, Point3, Sphere, Surface};

    fn ball(x: f64) -> Surface {
        Sphere::around(Point3::new(x, 0.0, 0.0), 5.0).unwrap().into()
    }

    fn floor(height: f64) -> Surface {
        let side = Interval::new(-20.0, 20.0);
        PlaneSurface::new(Plane::XY.offset(height), side, side).unwrap().into()
    }

    #[test]
    fn balls_meet_in_a_circle() {
        let trial = || Trial::of("Brep | Brep").item(ball(0.0)).item(ball(6.0));
        let curves = trial().run().outputs.into_iter().next().unwrap();
        assert_eq!(curves.item_count(), 1);
        // 8π
        assert_eq!(Trial::of("Length").tree(curves).texts(0).join(" "), "{0;0}: 25.132741");
        assert_eq!(trial().run().outputs[1].item_count(), 0);
    }

    #[test]
    fn a_floor_cuts_a_ball_in_two() {
        let made = Trial::of("Split Brep").item(ball(0.0)).item(floor(3.0)).run();
        assert!(made.messages.is_empty(), "{:?}", made.messages);
        let parts = made.outputs.into_iter().next().unwrap();
        assert_eq!(parts.item_count(), 2);
        // Caps of a sphere: 2πrh, with heights of 2 and 8.
        let areas = Trial::of("Area").tree(parts).texts(0).join(" ");
        assert!(areas.contains("62.83185") && areas.contains("251.32741"), "{areas}");
    }

    #[test]
    fn two_floors_cut_a_ball_in_three() {
        let made = Trial::of("Split Brep Multiple").item(ball(0.0)).list([floor(3.0), floor(-3.0)]).run();
        assert_eq!(made.outputs[0].item_count(), 3);
        let beside = Trial::of("Split Brep").item(ball(0.0)).item(floor(9.0)).run();
        assert_eq!(beside.outputs[0].item_count(), 1);
    }
}
