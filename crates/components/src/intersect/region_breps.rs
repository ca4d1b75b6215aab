//! Intersect / Region: curves cut by Breps.

use std::rc::Rc;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::{Brep, Containment, Curve, Point3};

use crate::prepared;

/// Pieces of a curve inside and outside.
type Sides = (Vec<Shared<Curve>>, Vec<Shared<Curve>>);

fn searches(context: &Context<'_>, breps: &[Shared<Brep>]) -> Result<Vec<Rc<ClosestOnBrep>>, Message> {
    breps.iter().map(|b| prepared::brep(context, b)).collect()
}

/// The pieces into which Breps cut a curve, in its order, and the points where they do.
fn cut(
    context: &Context<'_>,
    curve: &Curve,
    breps: &[Rc<ClosestOnBrep>],
) -> Result<(Vec<Curve>, Vec<Point3>), Message> {
    let mut found: Vec<(f64, Point3)> = Vec::new();
    for brep in breps {
        context.check()?;
        let met = brep.curve_crossings(curve, context.tolerance().absolute)?;
        if !met.complete {
            context.warn("The curve runs along a Brep: some cuts may be missing");
        }
        found.extend(met.crossings.iter().map(|c| (c.t, c.point)));
        for overlap in &met.overlaps {
            found.extend([overlap.start, overlap.end].map(|t| (t, curve.point_at(t))));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let near = context.tolerance().absolute;
    found.dedup_by(|b, a| a.1.distance_to(b.1) <= near);
    let places: Vec<f64> = found.iter().map(|f| f.0).collect();
    Ok((curve.split_at(&places)?, found.into_iter().map(|f| f.1).collect()))
}

fn sides(context: &Context<'_>, curve: &Curve, breps: &[Shared<Brep>]) -> Result<Sides, Message> {
    for (place, brep) in breps.iter().enumerate() {
        if !brep.is_solid() {
            return Err(Message::error(format!("Brep {place} is not closed and has no inside")));
        }
    }
    let breps = searches(context, breps)?;
    let (mut inside, mut outside) = (Vec::new(), Vec::new());
    for piece in cut(context, curve, &breps)?.0 {
        let middle = piece.point_at(piece.domain().middle());
        let mut within = false;
        for brep in &breps {
            within = within || brep.contains(middle, context.tolerance().absolute)? != Containment::Outside;
        }
        if within { inside.push(Shared::new(piece)) } else { outside.push(Shared::new(piece)) }
    }
    context.items(inside.len() + outside.len())?;
    Ok((inside, outside))
}

/// Cuts a curve where it enters or leaves a solid.
///
/// A stretch on the boundary counts as inside, and a curve that does not cross it comes back whole. An open Brep is an
/// error.
#[component(
    "3eba04bc-00e8-416d-b58f-a3dc8b3e22e2",
    name = "Trim with Brep",
    nick = "Trim",
    at = "Intersect/Region"
)]
#[output("Inside", "Ci", "The pieces inside, in the order of the curve.")]
#[output("Outside", "Co", "The pieces outside, in the order of the curve.")]
fn trim_with_brep(
    context: &Context<'_>,
    /// The curve to cut.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The closed Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    sides(context, curve, &[brep])
}

/// Cuts a curve where it enters or leaves what several solids fill together.
///
/// A stretch on a boundary counts as inside; it is cut at every boundary. An open Brep is an error.
#[component(
    "916e7ebc-524c-47ce-8936-e50a09a7b43c",
    name = "Trim with Breps",
    nick = "Trim",
    at = "Intersect/Region"
)]
#[output("Inside", "Ci", "The pieces inside any of the Breps, in the order of the curve.")]
#[output("Outside", "Co", "The pieces outside all Breps, in the order of the curve.")]
fn trim_with_breps(
    context: &Context<'_>,
    /// The curve to cut.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The closed Breps; nulls are skipped.
    #[port("Brep", "B")]
    breps: List<'_, Shared<Brep>>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    let all: Vec<Shared<Brep>> = breps.iter().flatten().map(|b| Shared::clone(&b)).collect();
    sides(context, curve, &all)
}

/// Cuts a curve where it passes through a Brep.
///
/// Where it runs along a face it is cut at both ends of the stretch. A curve that does not meet the Brep comes back whole.
#[component(
    "4bdc2eb0-24ed-4c90-a27b-a32db069eaef",
    name = "Split with Brep",
    nick = "Split",
    at = "Intersect/Region"
)]
#[output("Curve", "C", "The pieces, in the order of the curve.")]
#[output("Points", "P", "The points where it is cut.")]
fn split_with_brep(
    context: &Context<'_>,
    /// The curve to cut.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The Brep to cut with.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    split(context, curve, &[brep])
}

/// Cuts a curve where it passes through any of several Breps.
///
/// Where it runs along a face it is cut at both ends of the stretch. A curve that meets no Brep comes back whole.
#[component(
    "5b742537-9bcb-4f06-9613-866da5bf845e",
    name = "Split with Breps",
    nick = "Split",
    at = "Intersect/Region"
)]
#[output("Curve", "C", "The pieces, in the order of the curve.")]
#[output("Points", "P", "The points where it is cut.")]
fn split_with_breps(
    context: &Context<'_>,
    /// The curve to cut.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The Breps to cut with; nulls are skipped.
    #[port("Brep", "B")]
    breps: List<'_, Shared<Brep>>,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    let all: Vec<Shared<Brep>> = breps.iter().flatten().map(|b| Shared::clone(&b)).collect();
    split(context, curve, &all)
}

fn split(
    context: &Context<'_>,
    curve: &Curve,
    breps: &[Shared<Brep>],
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    let (pieces, points) = cut(context, curve, &searches(context, breps)?)?;
    context.items(pieces.len() + points.len())?;
    Ok((pieces.into_iter().map(Shared::new).collect(), points))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Line, Point3, Sphere, Surface};

    fn ball(x: f64) -> Surface {
        Sphere::around(Point3::new(x, 0.0, 0.0), 1.0).unwrap().into()
    }

    fn line() -> Line {
        Line::new(Point3::new(-3.0, 0.0, 0.0), Point3::new(7.0, 0.0, 0.0))
    }

    #[test]
    fn a_line_through_balls() {
        let made = Trial::of("Trim with Brep").item(line()).item(ball(0.0)).run();
        assert_eq!(made.outputs[0].item_count(), 1);
        assert_eq!(made.outputs[1].item_count(), 2);
        let made = Trial::of("Trim with Breps").item(line()).list([ball(0.0), ball(4.0)]).run();
        assert_eq!(made.outputs[0].item_count(), 2);
        assert_eq!(made.outputs[1].item_count(), 3);
        let made = Trial::of("Split with Breps").item(line()).list([ball(0.0), ball(4.0)]).run();
        assert_eq!(made.outputs[0].item_count(), 5);
        assert_eq!(made.outputs[1].item_count(), 4);
        let made = Trial::of("Split with Brep").item(line()).item(ball(40.0)).run();
        assert_eq!(made.outputs[0].item_count(), 1);
        assert_eq!(made.outputs[1].item_count(), 0);
    }
}
