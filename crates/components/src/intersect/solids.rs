//! Intersect / Shape: unions, differences and intersections of solids, and what they trim and enclose.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::Brep;
use katydid_geometry::brep::{Fuse, Made};

/// The closed Breps of a list; an open one is an error that names it. Nulls are skipped.
fn solids(list: &List<'_, Shared<Brep>>, name: &str) -> Result<Vec<Brep>, Message> {
    let mut out = Vec::new();
    for (place, brep) in list.iter().enumerate() {
        let Some(brep) = brep else { continue };
        if !brep.is_solid() {
            return Err(Message::error(format!("Brep {place} of {name} is not closed")));
        }
        out.push(Brep::clone(&brep));
    }
    Ok(out)
}

/// The Breps of a list, without nulls.
fn known(list: &List<'_, Shared<Brep>>) -> Vec<Brep> {
    list.iter().flatten().map(|brep| Brep::clone(&brep)).collect()
}

fn made(context: &Context<'_>, all: Vec<Made>) -> Result<Vec<Shared<Brep>>, Message> {
    context.items(all.len())?;
    Ok(all.into_iter().map(|m| Shared::new(m.brep)).collect())
}

/// Joins solids: what is inside any of them.
///
/// Solids that do not meet come back apart. Flat faces that lie in one plane stay apart; Merge Faces joins them. A case
/// that is not decided is an error with its kind, the faces and the place: there is no result that may be wrong.
#[component(
    "10434a15-da85-4281-bb64-a2b3a995b9c6",
    name = "Solid Union",
    nick = "SUnion",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The solids, one for each part that hangs together.")]
fn solid_union(
    context: &Context<'_>,
    /// Closed Breps; nulls are skipped.
    #[port("Breps", "B")]
    breps: List<'_, Shared<Brep>>,
) -> Result<Vec<Shared<Brep>>, Message> {
    made(context, Brep::union(&solids(&breps, "B")?, &context.tolerance())?)
}

/// Takes Breps away from Breps: what is inside one of the first and in none of the second.
///
/// Each of the first is cut by all of the second, and the parts come in the order of the first. One that no other meets
/// comes back whole. Breps may be open: one that is open divides what it meets, and what lies behind it, on the side away
/// from its normals, is inside; the result is open where it was. A case that is not decided is an error.
#[component(
    "fab11c30-2d9c-4d15-ab3c-2289f1ae5c21",
    name = "Solid Difference",
    nick = "SDiff",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The Breps that are left.")]
fn solid_difference(
    context: &Context<'_>,
    /// Breps to cut; nulls are skipped.
    #[port("Breps A", "A")]
    a: List<'_, Shared<Brep>>,
    /// Breps to take away; nulls are skipped.
    #[port("Breps B", "B")]
    b: List<'_, Shared<Brep>>,
) -> Result<Vec<Shared<Brep>>, Message> {
    let (a, b) = (known(&a), known(&b));
    let mut out = Vec::new();
    for solid in a {
        context.check()?;
        out.extend(Brep::difference(&[solid], &b, &context.tolerance())?);
    }
    made(context, out)
}

/// The common parts of Breps: what is inside one of the first and in one of the second.
///
/// Breps that have nothing in common give nothing. They may be open: one that is open divides what it meets, and what lies
/// behind it, on the side away from its normals, is inside. A case that is not decided is an error.
#[component(
    "5723c845-cafc-442d-a667-8c76532845e6",
    name = "Solid Intersection",
    nick = "SInt",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The Breps that both have in common.")]
fn solid_intersection(
    context: &Context<'_>,
    /// Some Breps; nulls are skipped.
    #[port("Breps A", "A")]
    a: List<'_, Shared<Brep>>,
    /// The others; nulls are skipped.
    #[port("Breps B", "B")]
    b: List<'_, Shared<Brep>>,
) -> Result<Vec<Shared<Brep>>, Message> {
    let (a, b) = (known(&a), known(&b));
    let found = Brep::intersection(&a, &b, &context.tolerance())?;
    if found.is_empty() && !a.is_empty() && !b.is_empty() {
        context.warn("The Breps have no part in common");
    }
    made(context, found)
}

/// Takes away the parts of a shape that lie inside solids.
///
/// The shape may be open or closed; where it was cut it stays open. What touches a solid stays. A cutter may be open: it
/// takes away what lies behind it, on the side away from its normals, of what it cuts through.
#[component(
    "f0b70e8e-7337-4ce4-a7bb-317fc971f918",
    name = "Trim Solid",
    nick = "Trim",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The parts outside of all cutters.")]
fn trim_solid(
    context: &Context<'_>,
    /// The Brep to trim.
    #[port("Shape", "S")]
    shape: Shared<Brep>,
    /// The Breps to trim with; nulls are skipped.
    #[port("Cutters", "T")]
    cutters: List<'_, Shared<Brep>>,
) -> Result<Vec<Shared<Brep>>, Message> {
    let mut all = vec![Brep::clone(&shape)];
    all.extend(known(&cutters));
    made(context, Fuse::new(&all, &context.tolerance())?.outside_of_others(0)?)
}

/// The solid that Breps enclose together.
///
/// The Breps may be open, and reach beyond each other: what sticks out is cut off. Where they enclose several solids the
/// union of all of them is given.
#[component(
    "b57bf805-046a-4360-ad76-51aeddfe9720",
    name = "Boundary Volume",
    nick = "BVol",
    at = "Intersect/Shape"
)]
#[output("Solid", "S", "The solid.")]
fn boundary_volume(
    context: &Context<'_>,
    /// The Breps that bound the solid; nulls are skipped.
    #[port("Boundaries", "B")]
    boundaries: List<'_, Shared<Brep>>,
) -> Result<Option<Shared<Brep>>, Message> {
    let all: Vec<Brep> = boundaries.iter().flatten().map(|b| Brep::clone(&b)).collect();
    if all.is_empty() {
        return Ok(None);
    }
    let found: Vec<Brep> =
        Fuse::new(&all, &context.tolerance())?.volumes()?.into_iter().map(|(_, m)| m.brep).collect();
    let whole = if found.len() > 1 {
        Brep::union(&found, &context.tolerance())?.into_iter().map(|m| m.brep).collect()
    } else {
        found
    };
    match <[Brep; 1]>::try_from(whole) {
        Ok([only]) => Ok(Some(Shared::new(only))),
        Err(none) if none.is_empty() => Err(Message::warning("The Breps enclose no volume")),
        Err(several) => {
            context.warn("The Breps enclose several volumes that do not hang together");
            Ok(Some(Shared::new(Brep::merged(&several))))
        }
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{
        BoundingBox, Box3, Brep, Circle, Curve, Interval, Plane, PlaneSurface, Point3, Sphere, Surface,
        Tolerance,
    };

    fn cuboid(min: f64, max: f64) -> Box3 {
        let [min, max] = [min, max].map(|x| Point3::new(x, x, x));
        Box3::from(BoundingBox { min, max })
    }

    fn volumes(trial: Trial) -> Vec<String> {
        let made = trial.run().outputs.into_iter().next().unwrap();
        Trial::of("Volume").tree(made).texts(0)
    }

    #[test]
    fn boxes_that_overlap() {
        let both = |name: &str| Trial::of(name).list([cuboid(0.0, 2.0)]).list([cuboid(1.0, 3.0)]);
        assert_eq!(volumes(both("Solid Difference")), ["{0}: 7"]);
        assert_eq!(volumes(both("Solid Intersection")), ["{0}: 1"]);
        let union = Trial::of("Solid Union").list([cuboid(0.0, 2.0), cuboid(1.0, 3.0)]);
        assert_eq!(volumes(union), ["{0}: 15"]);
    }

    #[test]
    fn an_open_shape_is_no_solid() {
        let side = Interval::new(-1.0, 1.0);
        let sheet: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let made = Trial::of("Solid Union").list([sheet]).run();
        assert!(made.messages.iter().any(|m| m.text.contains("Brep 0 of B is not closed")), "{made:?}");
    }

    /// A floor that looks up, and one that looks down.
    fn floors() -> [Surface; 2] {
        let side = Interval::new(-2.0, 2.0);
        let floor = |plane| PlaneSurface::new(plane, side, side).unwrap().into();
        [floor(Plane::XY), floor(Plane::XY.flipped())]
    }

    fn measured(what: &str, trial: Trial) -> Vec<String> {
        let made = trial.run().outputs.into_iter().next().unwrap();
        Trial::of(what).tree(made).texts(0)
    }

    #[test]
    fn a_floor_without_a_box() {
        // A floor of 4 by 4 with a pit of 2 by 2 and 1 deep, or a room on it: the part of the box behind the floor.
        for floor in floors() {
            let pit = Trial::of("Solid Difference").list([floor]).list([cuboid(-1.0, 1.0)]);
            assert_eq!(measured("Area", pit), ["{0}: 24"]);
        }
        let [up, down] = floors();
        // What the box has below a floor that looks up, and above one that looks down: 2 by 2 by 1.
        for floor in [up.clone(), down] {
            let common = Trial::of("Solid Intersection").list([cuboid(-1.0, 1.0)]).list([floor]);
            assert_eq!(measured("Volume", common), ["{0}: 4"]);
        }
        // A box without what is below the floor.
        let rest = Trial::of("Solid Difference").list([cuboid(-1.0, 2.0)]).list([up]);
        assert_eq!(measured("Volume", rest), ["{0}: 18"]);
    }

    #[test]
    fn a_disc_without_a_disc_in_its_plane_is_a_ring() {
        let disc = |radius: f64, plane: Plane| -> Brep {
            let rim: Curve = Circle::new(plane, radius).unwrap().into();
            Brep::planar_faces(&[rim], &Tolerance::default()).unwrap().breps.remove(0)
        };
        for plane in [Plane::XY, Plane::XY.flipped()] {
            let ring = Trial::of("Solid Difference").list([disc(5.0, Plane::XY)]).list([disc(0.5, plane)]);
            // 24.75 π
            assert_eq!(measured("Area", ring), ["{0}: 77.754418"]);
        }
    }

    #[test]
    fn a_floor_that_ends_in_a_box_does_not_divide_it() {
        let side = Interval::new(0.0, 2.0);
        let floor: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let made = Trial::of("Solid Difference").list([floor]).list([cuboid(-1.0, 1.0)]).run();
        assert!(!made.messages.is_empty() && made.outputs[0].item_count() == 0, "{made:?}");
    }

    #[test]
    fn a_box_is_trimmed_by_a_floor() {
        let [up, _] = floors();
        // The upper half without its floor: 4 walls of 2 by 1 and a top of 2 by 2.
        let above = Trial::of("Trim Solid").item(cuboid(-1.0, 1.0)).list([up]);
        assert_eq!(measured("Area", above), ["{0;0}: 12"]);
    }

    #[test]
    fn a_sheet_is_trimmed_by_a_ball() {
        let side = Interval::new(-2.0, 2.0);
        let sheet: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let ball: Surface = Sphere::around(Point3::ORIGIN, 1.0).unwrap().into();
        let made = Trial::of("Trim Solid").item(sheet).list([ball]).run().outputs.into_iter().next().unwrap();
        // 16 − π
        assert_eq!(Trial::of("Area").tree(made).texts(0), ["{0;0}: 12.858407"]);
    }
}
