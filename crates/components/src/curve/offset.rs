//! Curve / Util: offsets.

use std::sync::Arc as Shared;

use katydid_component::{Message, component};
use katydid_geometry::{Curve, NurbsCurve, Plane, Point3};

use super::{shared, warning};

fn own_plane(curve: &Curve) -> Result<Plane, Message> {
    match curve.plane(1e-6 * curve.bounding_box().diagonal().length()) {
        Some(plane) => Ok(plane),
        None => Ok(Plane::fit(&curve.hull_points()).map_err(warning)?.0),
    }
}

/// The curve at a distance beside a curve. Corners stay sharp.
///
/// Lines, arcs, polylines and joined curves of these. Without a plane the offset goes to the side where it becomes longer.
#[component(
    "1a38d325-98de-455c-93f1-bca431bc1243",
    name = "Offset Curve",
    nick = "Offset",
    at = "Curve/Util"
)]
#[output("Curve", "C", "The offset.")]
fn offset_curve(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far to the right of the curve's direction, as seen against the plane's normal; negative to the left. So a counter-clockwise closed curve grows.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// The plane to offset in.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Option<Plane>,
    /// How corners are closed: 1 for sharp ones, the only way that is supported for curves with corners.
    #[port("Corners", "C", default = 1)]
    corners: i32,
) -> Result<Vec<Shared<Curve>>, Message> {
    if !(0..=4).contains(&corners) {
        return Err(Message::error(format!("There is no corner type {corners}: it goes from 0 to 4")));
    }
    let has_corners = curve.as_polyline().is_some_and(|p| p.len() > 2) || matches!(curve, Curve::Poly(_));
    if corners != 1 && has_corners {
        return Err(Message::error("Only sharp corners (1) are supported yet"));
    }
    let offset = match plane {
        Some(plane) => curve.offset_in_plane(&plane, distance)?,
        None => {
            let plane = own_plane(curve)?;
            let (right, left) =
                (curve.offset_in_plane(&plane, distance), curve.offset_in_plane(&plane, -distance));
            match (right, left) {
                (Ok(a), Ok(b)) if b.length() > a.length() => b,
                (Ok(a), _) => a,
                (Err(_), Ok(b)) => b,
                (Err(error), Err(_)) => return Err(error.into()),
            }
        }
    };
    Ok(vec![shared(offset)])
}

/// Moves the control points of a curve sideways. Their number stays, and the distance is only roughly kept.
#[component(
    "80e55fc2-933b-4bfb-a353-12358786dba8",
    name = "Offset Curve Loose",
    nick = "Offset (L)",
    at = "Curve/Util"
)]
#[output("Curve", "C", "The moved curve.")]
fn offset_curve_loose(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far to the right of the curve's direction, as seen against the plane's normal; negative to the left.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// The plane to move in; without it the one that fits the curve best.
    #[port("Plane", "P")]
    plane: Option<Plane>,
) -> Result<Shared<Curve>, Message> {
    let plane = match plane {
        Some(plane) => plane,
        None => own_plane(curve)?,
    };
    if curve.as_polyline().is_some() {
        return Ok(shared(curve.offset_in_plane(&plane, distance)?));
    }
    let nurbs = curve.to_nurbs()?;
    let mut points: Vec<Point3> = Vec::with_capacity(nurbs.point_count());
    let domain = curve.domain();
    for (p, t) in nurbs.control_points().into_iter().zip(nurbs.greville_abscissae()) {
        let aside = curve.tangent_at(domain.clamp(t)).and_then(|t| t.cross(plane.z_axis).unitized());
        let aside = aside.ok_or_else(|| Message::warning("The curve has no direction in the plane"))?;
        points.push(p + aside * distance);
    }
    let weights = nurbs.weights();
    let moved = NurbsCurve::with_weights(nurbs.degree(), &points, &weights, nurbs.knots().to_vec())?;
    Ok(shared(Curve::Nurbs(moved.to_non_rational().unwrap_or(moved))))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    fn square() -> Curve {
        let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 0.0]];
        PolylineCurve::new(points.map(Point3::from).to_vec()).unwrap().into()
    }

    fn length(trial: Trial) -> String {
        let curve = trial.run().outputs[0].clone();
        Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(curve.flatten()).texts(0).join("")
    }

    #[test]
    fn beside_a_curve() {
        assert_eq!(length(Trial::of("Offset Curve").item(square()).item(1.0)), "{0}: 24");
        assert_eq!(length(Trial::of("Offset Curve").item(square()).item(-1.0)), "{0}: 8");
        let outwards =
            Trial::of("Offset Curve").item(square().reversed()).item(-1.0).tree(katydid_data::Tree::empty());
        assert_eq!(length(outwards), "{0}: 24");
        let round = Trial::of("Offset Curve").item(square()).item(1.0).item(Plane::XY).item(2);
        assert!(round.message().contains("sharp"));
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        assert_eq!(length(Trial::of("Offset Curve").item(circle).item(1.0)), "{0}: 12.566371");
        let line = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0));
        assert_eq!(length(Trial::of("Offset Curve Loose").item(line).item(1.0).item(Plane::XY)), "{0}: 4");
        assert_eq!(length(Trial::of("Offset Curve Loose").item(square()).item(1.0)), "{0}: 24");
        let bent = Trial::of("Nurbs Curve")
            .list([[0.0, 0.0, 0.0], [2.0, 3.0, 0.0], [4.0, 0.0, 0.0]].map(Point3::from));
        let moved = Trial::of("Offset Curve Loose")
            .tree(bent.item(2).run().outputs[0].clone())
            .item(1.0)
            .item(Plane::XY);
        assert_eq!(
            Trial::of("Control Points").tree(moved.run().outputs[0].clone()).run().outputs[0].item_count(),
            3
        );
    }
}
