//! Intersect / Region: curves cut by what closed curves enclose.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::region::Region;
use katydid_geometry::{Curve, Plane};

use super::{closed_curves, closes, plane_of};

/// The pieces inside and outside.
type Pieces = (Vec<Shared<Curve>>, Vec<Shared<Curve>>);

fn trimmed(
    context: &Context<'_>,
    curve: &Curve,
    regions: &[Curve],
    plane: Option<Plane>,
) -> Result<Pieces, Message> {
    let tolerance = context.tolerance().absolute;
    if !regions.iter().all(|r| closes(r, tolerance)) {
        return Err(Message::error("The region is open and has no inside"));
    }
    // A straight curve lies in many planes, and then the regions decide.
    let plane =
        plane_of(context, plane, std::iter::once(curve).filter(|c| !c.is_linear(tolerance)).chain(regions))?;
    let region = Region::union_of(regions, &plane, tolerance)?;
    let cut = region.trim(curve, tolerance)?;
    context.items(cut.inside.len().saturating_add(cut.outside.len()))?;
    let shared = |list: Vec<Curve>| list.into_iter().map(Shared::new).collect();
    Ok((shared(cut.inside), shared(cut.outside)))
}

/// Cuts a curve where it enters or leaves what a closed curve encloses.
///
/// Both are seen at right angles to the plane; the pieces stay where they are. A stretch on the outline counts as
/// inside, and a curve that does not cross it comes back whole. An open region is an error.
#[component(
    "3092caf0-7cf9-4885-bcc0-e635d878832a",
    name = "Trim with Region",
    nick = "Trim",
    at = "Intersect/Region"
)]
#[output("Inside", "Ci", "The pieces inside, in the order of the curve.")]
#[output("Outside", "Co", "The pieces outside, in the order of the curve.")]
fn trim_with_region(
    context: &Context<'_>,
    /// The curve to cut.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The closed curve.
    #[port("Region", "R")]
    region: &Curve,
    /// The plane; without it that of the curve, or of the region when the curve is straight.
    #[port("Plane", "P")]
    plane: Option<Plane>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    trimmed(context, curve, std::slice::from_ref(region), plane)
}

/// Cuts a curve where it enters or leaves what several closed curves enclose together.
///
/// Both are seen at right angles to the plane; the pieces stay where they are. A stretch on an outline counts as inside,
/// and a curve that crosses none comes back whole. Open regions are left out with a warning.
#[component(
    "26949c81-9b50-43b7-ac49-3203deb6eec7",
    name = "Trim with Regions",
    nick = "Trim",
    at = "Intersect/Region"
)]
#[output("Inside", "Ci", "The pieces inside any of the regions, in the order of the curve.")]
#[output("Outside", "Co", "The pieces outside all regions, in the order of the curve.")]
fn trim_with_regions(
    context: &Context<'_>,
    /// The curve to cut.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The closed curves.
    #[port("Regions", "R")]
    regions: List<Shared<Curve>>,
    /// The plane; without it that of the curve, or of the first region when the curve is straight.
    #[port("Plane", "P")]
    plane: Option<Plane>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    let regions = closed_curves(context, "R", &regions);
    if regions.is_empty() {
        return Ok((Vec::new(), vec![Shared::new(curve.clone())]));
    }
    trimmed(context, curve, &regions, plane)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3};

    fn circle(x: f64, radius: f64) -> Curve {
        Circle { plane: Plane::XY.with_origin(Point3::new(x, 0.0, 0.0)), radius }.into()
    }

    fn line(z: f64) -> Line {
        Line::new(Point3::new(-5.0, 0.0, z), Point3::new(5.0, 0.0, z))
    }

    /// The start and end of each curve of an output.
    fn ends(trial: Trial, output: usize) -> Vec<String> {
        let curves = trial.run().outputs[output].clone().flatten();
        let points = Trial::of("End Points").tree(curves).run();
        let both = [0, 1].map(|k| katydid_component::testing::texts(&points.outputs[k]).join(""));
        both.to_vec()
    }

    #[test]
    fn trims() {
        let one = || Trial::of("Trim with Region").item(line(0.0)).item(circle(0.0, 2.0));
        assert_eq!(ends(one(), 0), ["{0}: {-2, 0, 0}", "{0}: {2, 0, 0}"]);
        assert_eq!(ends(one(), 1), ["{0}: {-5, 0, 0}, {2, 0, 0}", "{0}: {-2, 0, 0}, {5, 0, 0}"]);
        // Seen in the plane of the region; the piece stays above it.
        let above = Trial::of("Trim with Region").item(line(3.0)).item(circle(0.0, 2.0));
        assert_eq!(ends(above, 0), ["{0}: {-2, 0, 3}", "{0}: {2, 0, 3}"]);
        let whole = Trial::of("Trim with Region").item(line(0.0)).item(circle(9.0, 2.0)).run();
        assert_eq!([whole.outputs[0].item_count(), whole.outputs[1].item_count()], [0, 1]);
        let open = Trial::of("Trim with Region").item(line(0.0)).item(line(1.0));
        assert!(open.message().contains("open"));
        let two =
            || Trial::of("Trim with Regions").item(line(0.0)).list([circle(0.0, 2.0), circle(3.0, 1.5)]);
        assert_eq!(ends(two(), 0), ["{0}: {-2, 0, 0}", "{0}: {4.5, 0, 0}"]);
        assert_eq!(two().run().outputs[1].item_count(), 2);
    }
}
