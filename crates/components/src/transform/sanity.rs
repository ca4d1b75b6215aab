//! Transform / Euclidean: a joke of Grasshopper's.

use katydid_component::{Context, List, Message, component};
use katydid_data::Geometry;
use katydid_geometry::Xform;

use crate::sets::dotnet_random::DotNetRandom;

/// Bends geometry at random, which is a joke of Grasshopper's, and hands it on as it was beside that.
///
/// How it is bent there is not documented: here each item is sheared and scaled, the same way each time.
#[component(
    "03b3db66-d7e8-4d2d-bc0c-122913317254",
    name = "Sanity XForm",
    nick = "MWHAHAHA!!",
    at = "Transform/Euclidean"
)]
#[output("Geometry", "G", "The geometry as it was.")]
#[output("Wackometry", "W", "The geometry bent.")]
fn sanity_xform(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
) -> Result<(Vec<Option<Geometry>>, Vec<Option<Geometry>>), Message> {
    context.tell(Message::remark(
        "How geometry is bent is not documented, and a joke: each item is sheared and scaled",
    ));
    let mut random = DotNetRandom::new(1);
    let mut bent = Vec::with_capacity(geometry.len());
    for item in geometry.iter() {
        let mut xform = Xform::IDENTITY;
        // Off the diagonal less than a third, so that the map keeps a volume.
        for (i, row) in xform.rows.iter_mut().take(3).enumerate() {
            for (j, x) in row.iter_mut().take(3).enumerate() {
                *x = if i == j { 1.0 + random.next_double() } else { (random.next_double() - 0.5) * 0.6 };
            }
        }
        bent.push(item.map(|item| item.0.transformed(&xform).map(Geometry)).transpose()?);
    }
    Ok((geometry.iter().collect(), bent))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::Point3;

    #[test]
    fn geometry_passes_and_is_bent() {
        let points = [Point3::new(1.0, 2.0, 3.0), Point3::new(1.0, 2.0, 3.0)];
        let run = || Trial::of("Sanity XForm").list(points).run();
        let (out, again) = (run(), run());
        assert_eq!(texts(&out.outputs[0]), ["{0}: {1, 2, 3}, {1, 2, 3}"]);
        let bent = out.outputs[1].column();
        assert_eq!(bent.len(), 2);
        assert_ne!(bent.get(0), bent.get(1));
        assert_eq!(texts(&out.outputs[1]), texts(&again.outputs[1]));
    }
}
