//! Intersect / Shape: slits in flat pieces and in boxes that cross.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder, Value};
use katydid_geometry::{Box3, Brep, Curve, construct, region};

/// Cuts slits into flat pieces where they cross, so that they can be put together: ribs of a waffle, say.
///
/// Where two pieces cross, each is slit over half of the stretch that they share: the one that comes first in the list
/// at the upper side (towards growing z, of a level stretch towards growing y, then x), the other one at the lower
/// side, through to the rim. Which piece Grasshopper slits from which side is not documented.
#[component(
    "0feeeaca-8f1f-4d7c-a24a-8e7dd68604a2",
    name = "Region Slits",
    nick = "RSlits",
    at = "Intersect/Shape"
)]
#[output("Regions", "R", "The pieces with their slits, as trimmed surfaces: a branch for each curve.", kind = Surface)]
#[output("Topology", "T", "For each curve the places in the list of those that it crosses.", kind = Integer)]
fn region_slits(
    context: &Context<'_>,
    /// The outlines of the pieces: closed planar curves.
    #[port("Regions", "R")]
    regions: List<Shared<Curve>>,
    /// How wide a slit is, above 0: the thickness of the material.
    #[port("Width", "W", default = 1.0)]
    width: f64,
    /// How much room two slits leave between them where they meet, from 0 on.
    #[port("Gap", "G", default = 0.0)]
    gap: f64,
) -> Result<(Tree, Tree), Message> {
    let tolerance = context.tolerance();
    // What is no piece keeps its place in the list.
    let mut places = Vec::new();
    let mut curves = Vec::new();
    for (place, curve) in regions.iter().enumerate() {
        match curve {
            Some(curve) if curve.is_closed() && curve.is_planar(tolerance.absolute) => {
                places.push(place);
                curves.push((*curve).clone());
            }
            Some(_) => context.warn("A curve is left out: it is not closed, or not planar"),
            None => {}
        }
    }
    let mut made = region::slits(&curves, width, gap, tolerance.absolute)?.into_iter();
    let (mut pieces, mut crossed) = (TreeBuilder::<Value>::new(), TreeBuilder::<Value>::new());
    let path = context.path();
    for place in 0..regions.len() {
        pieces.branch(path.child(place));
        crossed.branch(path.child(place));
        if !places.contains(&place) {
            continue;
        }
        let Some(piece) = made.next() else { continue };
        for brep in Brep::planar_faces(&piece.region.curves(), &tolerance)?.breps {
            pieces.push(Some(Value::from(brep)));
        }
        for other in piece.others {
            let other = places.get(other).and_then(|k| i32::try_from(*k).ok());
            crossed.push(other.map(Value::from));
        }
    }
    context.tell(Message::remark(
        "Which piece is slit from which side is not documented: here the earlier one of the list is slit at the \
         upper side",
    ));
    Ok((pieces.finish(), crossed.finish()))
}

/// Cuts slits into boxes where they cross, so that they can be put together.
///
/// Where two boxes cross, each is cut over half of the stretch that they share: the one that comes first in the list at
/// the upper side (towards growing z, of a level stretch towards growing y, then x), the other one at the lower side. Boxes
/// whose thinnest sides are parallel are not cut. Which box Grasshopper slits from which side is not documented.
#[component(
    "2d3b6ef3-5c26-4e2f-bcb3-8ffb9fb0f7c3",
    name = "Box Slits",
    nick = "Slits",
    at = "Intersect/Shape"
)]
#[output("Breps", "B", "The boxes with their slits: a branch for each box.", kind = Brep)]
#[output("Topology", "T", "For each box the places in the list of those that it crosses.", kind = Integer)]
fn box_slits(
    context: &Context<'_>,
    /// The boxes. A null or a flat one keeps its place in the list.
    #[port("Boxes", "B")]
    boxes: List<Box3>,
    /// How much room a slit leaves, from 0 on: half of it on every side.
    #[port("Gap", "G", default = 0.0)]
    gap: f64,
) -> Result<(Tree, Tree), Message> {
    let mut places = Vec::new();
    let mut all = Vec::new();
    for (place, own) in boxes.iter().enumerate() {
        match own {
            Some(own) if own.flat_side().is_none() => {
                places.push(place);
                all.push(own);
            }
            Some(_) => context.warn("A box is left out: it is flat"),
            None => {}
        }
    }
    let mut made = construct::box_slits(&all, gap, &context.tolerance())?.into_iter();
    let (mut pieces, mut crossed) = (TreeBuilder::<Value>::new(), TreeBuilder::<Value>::new());
    let path = context.path();
    for place in 0..boxes.len() {
        pieces.branch(path.child(place));
        crossed.branch(path.child(place));
        if !places.contains(&place) {
            continue;
        }
        let Some(own) = made.next() else { continue };
        for brep in own.breps {
            pieces.push(Some(Value::from(brep)));
        }
        for other in own.others {
            let other = places.get(other).and_then(|k| i32::try_from(*k).ok());
            crossed.push(other.map(Value::from));
        }
    }
    Ok((pieces.finish(), crossed.finish()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Interval, Line, Plane, Point3, Rectangle};

    #[test]
    fn crossing_sheets_are_slit() {
        let sheet =
            |plane: Plane| Rectangle { plane, x: Interval::new(-1.0, 1.0), y: Interval::new(-1.0, 1.0) };
        let trial = || {
            let sheets = [sheet(Plane::XZ), sheet(Plane::YZ), sheet(Plane::XY.offset(7.0))];
            Trial::of("Region Slits").list(sheets).item(0.1)
        };
        let out = trial().run();
        assert_eq!(texts(&out.outputs[1]), ["{0;0}: 1", "{0;1}: 0", "{0;2}:"]);
        let areas = Trial::of("Area").tree(out.outputs[0].clone()).texts(0);
        assert_eq!(areas, ["{0;0}: 3.9", "{0;1}: 3.9", "{0;2}: 4"]);
        assert!(out.messages.iter().any(|m| m.text.contains("not documented")));
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        assert!(Trial::of("Region Slits").item(line).item(0.1).message().contains("not closed"));
        assert!(Trial::of("Region Slits").item(sheet(Plane::XY)).item(0.0).message().contains("width"));
    }
}
