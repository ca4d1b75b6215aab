//! Transform / Util: groups, and transforms as data.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Compound, Geometry, Group, Tree};
use katydid_geometry::Xform;

/// Makes one group of a list of geometry. What happens to the group happens to all members.
#[component("874eebe7-835b-4f4f-9811-97e031c41597", name = "Group", nick = "Group", at = "Transform/Util")]
#[output("Group", "G", "The group.")]
fn group(
    /// The members; nulls and groups may be among them.
    #[port("Objects", "O")]
    objects: List<Geometry>,
) -> Shared<Group> {
    Shared::new(Group { members: objects.iter().map(|o| o.map(|g| g.0)).collect() })
}

/// The members of a group. Groups within it stay groups.
#[component(
    "a45f59c8-11c1-4ea7-9e10-847061b80d75",
    name = "Ungroup",
    nick = "Ungroup",
    at = "Transform/Util"
)]
#[output("Objects", "O", "Its members in order.")]
fn ungroup(
    /// The group.
    #[port("Group", "G")]
    group: &Group,
) -> Vec<Option<Geometry>> {
    group.members.iter().map(|m| m.clone().map(Geometry)).collect()
}

/// One group of the members of two.
#[component(
    "15204c6d-bba8-403d-9e8f-6660ab8e0df5",
    name = "Merge Group",
    nick = "GMerge",
    at = "Transform/Util"
)]
#[output("Group", "G", "The group of all members.")]
fn merge_group(
    /// The group whose members come first.
    #[port("Group A", "A")]
    a: &Group,
    /// The group whose members follow.
    #[port("Group B", "B")]
    b: &Group,
) -> Shared<Group> {
    Shared::new(Group { members: a.members.iter().chain(&b.members).cloned().collect() })
}

/// Picks members out of a group by their places.
///
/// A place outside the group is left out with a warning, unless places wrap round.
#[component(
    "fd03419e-e1cc-4603-8a57-6dfa56ed5dec",
    name = "Split Group",
    nick = "GSplit",
    at = "Transform/Util"
)]
#[output("Group A", "A", "The group of the members picked, in order.")]
#[output("Group B", "B", "The group of the others.")]
fn split_group(
    context: &Context<'_>,
    /// The group.
    #[port("Group", "G")]
    group: &Group,
    /// The places of the members to pick, from 0.
    #[port("Indices", "I")]
    indices: List<i32>,
    /// Whether places outside the group count on from its other end.
    #[port("Wrap", "W", default = true)]
    wrap: bool,
) -> (Shared<Group>, Shared<Group>) {
    let n = i64::try_from(group.members.len()).unwrap_or(i64::MAX);
    let mut picked = vec![false; group.members.len()];
    for i in indices.present().map(i64::from) {
        let i = if wrap && n > 0 { i.rem_euclid(n) } else { i };
        match usize::try_from(i).ok().and_then(|i| picked.get_mut(i)) {
            Some(place) => *place = true,
            None => context.warn(format!("There is no member {i} in the group")),
        }
    }
    let members = |wanted: bool| {
        let all = group.members.iter().zip(&picked);
        Shared::new(Group { members: all.filter(|(_, p)| **p == wanted).map(|(m, _)| m.clone()).collect() })
    };
    (members(true), members(false))
}

/// Applies a transform to geometry.
#[component(
    "610e689b-5adc-47b3-af8f-e3a32b7ea341",
    name = "Transform",
    nick = "Transform",
    at = "Transform/Util"
)]
#[output("Geometry", "G", "The image.")]
fn transform(
    /// What to transform.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The map.
    #[port("Transform", "T")]
    transform: Xform,
) -> Result<Geometry, Message> {
    Ok(Geometry(geometry.0.transformed(&transform)?))
}

/// One transform that does what a list of transforms does one after the other, the first one first. Nulls are skipped.
#[component("ca80054a-cde0-4f69-a132-10502b24866d", name = "Compound", nick = "Comp", at = "Transform/Util")]
#[output("Compound", "X", "All of them in one.")]
fn compound(
    /// The transforms in order.
    #[port("Transforms", "T")]
    transforms: List<Xform>,
) -> Shared<Compound> {
    Shared::new(Compound { parts: transforms.present().collect() })
}

/// The transforms that a compound was made of, in order. A single transform gives itself.
#[component("915f8f93-f5d1-4a7b-aecb-c327bab88ffb", name = "Split", nick = "Split", at = "Transform/Util")]
#[output("Fragments", "F", "The parts, the one that is done first in front.")]
fn split(
    /// The transform to take apart.
    #[port("Transform", "T", kind = Compound)]
    transform: &Compound,
) -> Vec<Xform> {
    transform.parts.clone()
}

/// Shows a transform as a matrix of four rows and four columns, and hands it on.
#[component(
    "93c24899-f456-4785-84f2-314958b9347b",
    name = "Transform Matrix",
    nick = "Matrix",
    at = "Transform/Util",
    floating
)]
#[output("Transform", "T", "The transform.", kind = Transform)]
fn transform_matrix(
    /// The transform to show.
    #[port("Transform", "T", optional, kind = Transform)]
    transform: &Tree,
) -> Tree {
    transform.clone()
}

/// The transform that undoes another.
///
/// A transform that flattens cannot be undone: that is an error.
#[component(
    "51f61166-7202-45aa-9126-3d83055b269e",
    name = "Inverse Transform",
    nick = "Inverse",
    at = "Transform/Util"
)]
#[output("Transform", "T", "Its inverse.")]
fn inverse_transform(
    /// The transform to undo.
    #[port("Transform", "T")]
    transform: Xform,
) -> Result<Xform, Message> {
    transform.inverse().ok_or_else(|| Message::error("This transform flattens and cannot be undone"))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Plane, Point3, Vector3, Xform};

    const P: Point3 = Point3::new(1.0, 2.0, 3.0);

    #[test]
    fn groups() {
        let group = Trial::of("Group").gaps([Some(P), None, Some(Point3::ORIGIN)]).run();
        assert_eq!(texts(&group.outputs[0]), ["{0}: Group with 3 objects"]);
        let back = Trial::of("Ungroup").tree(group.outputs[0].clone()).texts(0);
        assert_eq!(back, ["{0;0}: {1, 2, 3}, null, {0, 0, 0}"]);
        let moved = Trial::of("Move").tree(group.outputs[0].clone()).item(Vector3::X).run();
        assert_eq!(texts(&moved.outputs[0]), ["{0}: Group with 3 objects"]);
        let both = Trial::of("Merge Group").tree(group.outputs[0].clone()).tree(moved.outputs[0].clone());
        assert_eq!(both.texts(0), ["{0}: Group with 6 objects"]);
        let split = Trial::of("Split Group").tree(group.outputs[0].clone()).list([0, -1]).run();
        assert_eq!(texts(&split.outputs[0]), ["{0}: Group with 2 objects"]);
        assert_eq!(texts(&split.outputs[1]), ["{0}: Group with 1 object"]);
        let outside = Trial::of("Split Group").tree(group.outputs[0].clone()).list([7]).item(false);
        assert!(outside.message().contains("no member 7"));
    }

    #[test]
    fn transforms() {
        let (scale, step) = (Xform::scale(Point3::ORIGIN, 2.0), Xform::translation(Vector3::X));
        let both = Trial::of("Compound").list([scale, step]).run().outputs[0].clone();
        assert_eq!(Trial::of("Transform").item(P).tree(both.clone()).texts(0), ["{0}: {3, 4, 6}"]);
        assert_eq!(texts(&both), ["{0}: Compound transform of 2 parts"]);
        let parts = Trial::of_guid("915f8f93-f5d1-4a7b-aecb-c327bab88ffb").tree(both.clone()).run();
        let part = |i: usize| parts.outputs[0].column().get(i).unwrap().as_transform().unwrap();
        assert_eq!((part(0), part(1)), (scale, step));
        let shown = Trial::of("Transform Matrix").tree(both.clone()).run();
        assert_eq!(shown.outputs[0].column().get(0), both.column().get(0));
        let squared = Trial::of("Multiplication").tree(both.clone()).item(step).run().outputs[0].clone();
        assert_eq!(squared.column().get(0).unwrap().as_transform(), Some(step * scale * step));
        let back = Trial::of("Inverse Transform").item(step).run().outputs[0].clone();
        assert_eq!(Trial::of("Transform").item(P).tree(back).texts(0), ["{0}: {0, 2, 3}"]);
        let flat = Trial::of("Inverse Transform").item(Xform::planar_projection(&Plane::XY));
        assert!(flat.message().contains("cannot be undone"));
    }
}
