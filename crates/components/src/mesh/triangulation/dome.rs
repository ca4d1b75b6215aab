//! Domes of flat facets.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::cloud::{Facet, facets};
use katydid_geometry::{Box3, Curve, Mesh, MeshFace, Point3};

use super::present;
use crate::mesh::shared;
use crate::surface::sphere::fit;

/// A dome of flat facets around a sphere that fits points best: each facet touches the sphere in the direction of a
/// point, and ends where it meets the next ones.
///
/// Points in a plane have no sphere. Points that lie in one direction from its middle share a facet. The dome comes as a
/// mesh whose faces look outwards.
#[component(
    "190c0070-8cbf-4347-94c2-d84bbb488d55",
    name = "Facet Dome",
    nick = "Facet",
    at = "Mesh/Triangulation"
)]
#[output(
    "Pattern",
    "P",
    "The outlines of the facets, in the order of the points; null where nothing is left."
)]
#[output("Dome", "D", "All facets as one mesh.", kind = Brep)]
fn facet_dome(
    context: &Context<'_>,
    /// The points, at least four; nulls have no facet.
    #[port("Points", "P")]
    points: List<Point3>,
    /// A box that ends all facets. Without one an open dome ends a facet's size beyond its points.
    #[port("Box", "B", optional)]
    bounds: Option<Box3>,
    /// How far a facet reaches at most from where it touches the sphere, greater than 0. Without one facets meet.
    #[port("Radius", "R", optional)]
    radius: Option<f64>,
) -> Result<(Vec<Option<Shared<Curve>>>, Option<Shared<Mesh>>), Message> {
    let count = points.len();
    let (places, points) = present(&points);
    context.items(count.saturating_mul(8))?;
    if radius.is_some_and(|r| !(r > 0.0 && r.is_finite())) {
        return Err(Message::error("The radius must be greater than 0"));
    }
    let sphere = fit(context, &points)?.ok_or_else(|| {
        Message::error("The points are fewer than four or lie in a plane: no sphere fits them")
    })?;
    // In the box's own frame, so that it lies along the axes.
    let frame = bounds.map(|b| b.plane).unwrap_or(katydid_geometry::Plane::XY);
    let local: Vec<Point3> = points.iter().map(|&p| frame.coordinates(p).into()).collect();
    let center: Point3 = frame.coordinates(sphere.center()).into();
    let own = katydid_geometry::Sphere::around(center, sphere.radius)?;
    let ends = bounds.map(|b| Box3 { plane: katydid_geometry::Plane::XY, ..b }.bounding_box());
    let mut all: Vec<Facet> = facets(&local, &own, ends.as_ref())?;
    let out_of_frame = |p: Point3| frame.at(p.x, p.y, p.z);
    for facet in &mut all {
        let p = facet.plane;
        facet.plane.origin = out_of_frame(p.origin);
        for axis in [&mut facet.plane.x_axis, &mut facet.plane.y_axis, &mut facet.plane.z_axis] {
            *axis = frame.x_axis * axis.x + frame.y_axis * axis.y + frame.z_axis * axis.z;
        }
    }
    let mut pattern = vec![None; count];
    for (facet, &at) in all.iter().zip(&places) {
        if let Some(slot) = pattern.get_mut(at) {
            *slot = facet.outline(radius)?.map(Shared::new);
        }
    }
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for facet in all {
        let ring = radius.map_or_else(|| facet.clone(), |r| facet.clone().within(r)).corners();
        let start = vertices.len() as u32;
        let fan = (2..ring.len() as u32).map(|k| MeshFace::Triangle([start, start + k - 1, start + k]));
        faces.extend(fan);
        vertices.extend(ring);
    }
    if faces.is_empty() {
        context.warn("Nothing is left of the dome");
        return Ok((pattern, None));
    }
    Ok((pattern, Some(shared(Mesh::new(vertices, faces)?.with_normals()))))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Box3, Interval, Plane, Point3, Vector3};

    fn axes() -> Vec<Point3> {
        let c = Point3::new(3.0, 4.0, 5.0);
        [Vector3::X, Vector3::Y, Vector3::Z].iter().flat_map(|&d| [c + d * 2.0, c - d * 2.0]).collect()
    }

    fn number(texts: &[String]) -> f64 {
        texts[0].split([':', ',']).nth(1).and_then(|t| t.trim().parse().ok()).unwrap_or(f64::NAN)
    }

    #[test]
    fn a_cube() {
        let run = Trial::of("Facet Dome").list(axes()).run();
        assert!((number(&Trial::of("Area").tree(run.outputs[1].clone()).texts(0)) - 96.0).abs() < 1e-3);
        assert!((number(&Trial::of("Volume").tree(run.outputs[1].clone()).texts(0)) - 64.0).abs() < 1e-3);
        assert_eq!(run.outputs[0].item_count(), 6);
        let round = Trial::of("Facet Dome").list(axes()).default().item(1.0).run();
        let areas = Trial::of("Area").tree(round.outputs[0].clone()).texts(0);
        assert!((number(&areas) - std::f64::consts::PI).abs() < 1e-3, "{areas:?}");
    }

    #[test]
    fn in_a_box_and_without_a_sphere() {
        let frame = Plane::XY.with_origin(Point3::new(3.0, 4.0, 5.0)).rotated(0.5);
        let side = Interval::new(-9.0, 9.0);
        let half = Box3 { plane: frame, x: side, y: side, z: Interval::new(-9.0, 0.0) };
        let run = Trial::of("Facet Dome").list(axes()).item(half).run();
        let mut five = texts(&run.outputs[0]);
        assert_eq!(five.remove(0).matches("null").count(), 1);
        assert!((number(&Trial::of("Area").tree(run.outputs[1].clone()).texts(0)) - 48.0).abs() < 1e-3);
        let flat = (0..9).map(|i| Point3::new(f64::from(i % 3), f64::from(i / 3), 1.0));
        assert!(Trial::of("Facet Dome").list(flat).message().contains("no sphere"));
        assert!(
            Trial::of("Facet Dome").list(axes()).default().item(-1.0).message().contains("greater than 0")
        );
    }
}
