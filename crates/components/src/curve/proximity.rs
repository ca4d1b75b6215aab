//! Curve / Analysis: where curves come near other things, and how low and high they reach.

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::intersect::{NearestPair, nearest_on_curves, nearest_to_shape};
use katydid_geometry::{
    ClosestOnSurface, Continuity, Curve, Interval, MeshTree, Plane, Point3, Tolerance, Vector3,
};

/// The points at which two curves are nearest to each other, and how far they are apart there.
///
/// Of several such pairs it gives one. Curves that meet are 0 apart.
#[component(
    "6b7ba278-5c9d-42f1-a61d-6209cbd44907",
    name = "Curve Proximity",
    nick = "CrvProx",
    at = "Curve/Analysis"
)]
#[output("Point A", "A", "The point on the first curve.")]
#[output("Point B", "B", "The point on the second curve.")]
#[output("Distance", "D", "How far they are apart.")]
fn curve_proximity(
    context: &Context<'_>,
    /// A curve.
    #[port("Curve A", "A")]
    a: &Curve,
    /// Another curve.
    #[port("Curve B", "B")]
    b: &Curve,
) -> Result<(Point3, Point3, f64), Message> {
    let pair = nearest_on_curves(a, b, 1e-3 * context.tolerance().absolute)?;
    Ok((pair.point_a, pair.point_b, pair.distance))
}

/// Where a curve comes nearest to any geometry; `None` for what is no point, curve, Brep or mesh.
fn nearest(curve: &Curve, other: &Value, tolerance: f64) -> Result<Option<NearestPair>, Message> {
    let to_point = |q: Point3| -> Result<NearestPair, Message> {
        let near = curve.closest_point(q)?;
        let (point_a, distance) = (near.point, near.distance);
        Ok(NearestPair { a: near.parameter, b: 0.0, point_a, point_b: q, distance })
    };
    Ok(Some(match other {
        Value::Point(q) => to_point(*q)?,
        Value::Surface(surface) => {
            let closest = ClosestOnSurface::new(surface)?;
            nearest_to_shape(curve, tolerance, |p| Ok(closest.nearest(p)?.point))?
        }
        Value::Brep(_) | Value::Kept(_) if other.brep().is_some() => match other.brep() {
            Some(brep) => {
                let closest = ClosestOnBrep::new(brep.map_err(Message::warning)?)?;
                nearest_to_shape(curve, tolerance, |p| Ok(closest.nearest(p)?.point))?
            }
            None => return Ok(None),
        },
        Value::Mesh(mesh) => {
            let tree = MeshTree::new(mesh);
            nearest_to_shape(curve, tolerance, |p| tree.nearest(p))?
        }
        other => {
            let to = |kind| cast::value(other, kind, &cast::Rules::default());
            match (to(Kind::Curve), to(Kind::Mesh)) {
                (Some(Value::Curve(b)), _) => nearest_on_curves(curve, &b, 1e-3 * tolerance)?,
                (_, Some(mesh @ Value::Mesh(_))) => return nearest(curve, &mesh, tolerance),
                _ => return Ok(None),
            }
        }
    }))
}

/// Which of several things a curve comes nearest to: points, curves, Breps or meshes.
///
/// Of equally near ones the first counts. Nulls, and types that nothing can be near to yet, are passed over.
#[component(
    "748f214a-bc64-4556-9da5-4fa59a30c5c7",
    name = "Curve Nearest Object",
    nick = "CrvNear",
    at = "Curve/Analysis"
)]
#[output("Point A", "A", "The point on the curve.")]
#[output("Point B", "B", "The point on the nearest thing.")]
#[output("Index", "I", "Its place in the list.")]
fn curve_nearest_object(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The things to look at.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
) -> Result<(Point3, Point3, i32), Message> {
    let mut best: Option<(NearestPair, usize)> = None;
    for (i, item) in geometry.iter().enumerate() {
        context.check()?;
        let Some(Geometry(value)) = item else { continue };
        let Some(pair) = nearest(curve, &value, context.tolerance().absolute)? else {
            context.warn(format!("A {} cannot be looked at yet", value.kind().name()));
            continue;
        };
        if best.is_none_or(|(b, _)| pair.distance < b.distance) {
            best = Some((pair, i));
        }
    }
    let (pair, i) = best.ok_or_else(|| Message::warning("There is nothing to come near to"))?;
    Ok((pair.point_a, pair.point_b, i32::try_from(i).unwrap_or(i32::MAX)))
}

/// The lowest and the highest place of a curve along world z, between two heights if they are given.
///
/// When no part of the curve lies between them there is a warning.
#[component(
    "a583f722-240a-4fc9-aa1d-021720a4516a",
    name = "Curve Depth",
    nick = "Depth",
    at = "Curve/Analysis"
)]
#[output("Minimum Parameter", "tMin", "The parameter of the lowest place.")]
#[output("Minimum Depth", "dMin", "Its height.")]
#[output("Maximum Parameter", "tMax", "The parameter of the highest place.")]
#[output("Maximum Depth", "dMax", "Its height.")]
fn curve_depth(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Places below this height do not count.
    #[port("Minimum", "Min")]
    low: Option<f64>,
    /// Places above this height do not count.
    #[port("Maximum", "Max")]
    high: Option<f64>,
) -> Result<(f64, f64, f64, f64), Message> {
    let domain = curve.domain();
    let limits = Interval::new(low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY));
    let mut places = vec![domain.start, domain.end];
    places.extend(curve.turning_points(Vector3::Z)?);
    // A kink may be as high as any place, also one at the end of a level stretch.
    places.extend(curve.discontinuities(Continuity::C1, &Tolerance { absolute: 1e-9, angle: 1e-9 }));
    for height in [low, high].into_iter().flatten().filter(|h| h.is_finite()) {
        places.extend(curve.intersect_plane(&Plane::XY.offset(height), 0.0)?);
    }
    let slack = 1e-9 * curve.bounding_box().diagonal().length();
    let mut heights: Vec<(f64, f64)> = places
        .into_iter()
        .map(|t| (t, curve.point_at(t).z))
        .filter(|(_, z)| limits.start - slack <= *z && *z <= limits.end + slack)
        .collect();
    heights.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.total_cmp(&b.0)));
    let none = || Message::warning("No part of the curve lies between these heights");
    let (low, high) = (heights.first().ok_or_else(none)?, heights.last().ok_or_else(none)?);
    Ok((low.0, low.1, high.0, high.1))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Tree, Value};
    use katydid_geometry::{Box3, Circle, Interval, Line, Mesh, Plane, Point3, Sphere, Surface};

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn ring(x: f64) -> Circle {
        Circle { plane: Plane::XY.with_origin(p(x, 0.0, 0.0)), radius: 2.0 }
    }

    #[test]
    fn near_curves() {
        let near = Trial::of("Curve Proximity").item(ring(0.0)).item(ring(7.0)).run().outputs;
        let all: Vec<String> = near.iter().flat_map(texts).map(|t| t.replace("-0,", "0,")).collect();
        assert_eq!(all, ["{0}: {2, 0, 0}", "{0}: {5, 0, 0}", "{0}: 3"]);
        let meet = Trial::of("Curve Proximity").item(ring(0.0)).item(ring(3.0));
        assert_eq!(meet.texts(2), ["{0}: 0"]);
    }

    #[test]
    fn near_things() {
        let line = Line::new(p(-9.0, 0.0, 5.0), p(9.0, 0.0, 5.0));
        let side = Interval::new(3.0, 4.0);
        let cube = Box3 { plane: Plane::XY, x: side, y: Interval::new(-0.5, 0.5), z: side };
        let things = || -> Vec<Value> {
            vec![
                p(1.0, 0.0, 3.5).into(),
                Surface::from(Sphere::around(p(-4.0, 0.0, 0.0), 3.75).unwrap()).into(),
                ring(0.0).into(),
                Mesh::cuboid(&cube, 1, 1, 1).unwrap().into(),
            ]
        };
        let near = Trial::of("Curve Nearest Object").item(line).list(things()).run().outputs;
        assert_eq!(texts(&near[2]), ["{0}: 3"]);
        let two =
            Trial::of("Curve Nearest Object").item(line).list(things().into_iter().take(3)).run().outputs;
        assert_eq!(texts(&two[2]), ["{0}: 1"]);
        assert_eq!(texts(&two[1]), ["{0}: {-4, 0, 3.75}"]);
        let one =
            Trial::of("Curve Nearest Object").item(line).list(things().into_iter().take(1)).run().outputs;
        assert_eq!(texts(&one[0]), ["{0}: {1, 0, 5}"]);
        let none = Trial::of("Curve Nearest Object").item(line).gaps([None::<Point3>]);
        assert!(none.message().contains("nothing"));
    }

    #[test]
    fn depths() {
        let upright = Circle { plane: Plane::XZ, radius: 3.0 };
        let depth = |low: Tree, high: Tree| Trial::of("Curve Depth").item(upright).tree(low).tree(high);
        let all = depth(Tree::empty(), Tree::empty()).run().outputs;
        assert_eq!((texts(&all[1]), texts(&all[3])), (vec!["{0}: -3".into()], vec!["{0}: 3".into()]));
        let limited = depth(Tree::item(Value::from(-1.0)), Tree::item(Value::from(2.0))).run().outputs;
        assert_eq!((texts(&limited[1]), texts(&limited[3])), (vec!["{0}: -1".into()], vec!["{0}: 2".into()]));
        let above = depth(Tree::item(Value::from(4.0)), Tree::empty());
        assert!(above.message().contains("between"));
    }
}
