//! Curve / Util: offsets.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Curve, NurbsCurve, OffsetCorner, Plane, Point3, Vector3};

use super::{shared, warning};

fn own_plane(curve: &Curve) -> Result<Plane, Message> {
    match curve.plane(1e-6 * curve.bounding_box().diagonal().length()) {
        Some(plane) => Ok(plane),
        None => Ok(Plane::fit(&curve.hull_points()).map_err(warning)?.0),
    }
}

/// The plane to offset a curve in: the given one, or, where the curve is flat in another one, that, looking to the same
/// side.
fn facing(curve: &Curve, given: &Plane, context: &Context<'_>) -> Plane {
    let limit = context.tolerance().absolute;
    if curve.extent_along(given.z_axis).length() <= limit {
        return *given;
    }
    match curve.plane(limit) {
        // A straight curve lies in many planes: the one with its direction that is nearest to the given one.
        Some(_) if curve.is_linear(limit) => {
            let along = curve.end() - curve.start();
            let across = given.z_axis.cross(along);
            Plane::from_axes(curve.start(), along, across).map_or(*given, |plane| {
                if plane.z_axis.dot(given.z_axis) < 0.0 { plane.flipped() } else { plane }
            })
        }
        Some(own) if own.z_axis.dot(given.z_axis) < 0.0 => own.flipped(),
        Some(own) => own,
        None => *given,
    }
}

/// The curves at a distance beside a curve.
///
/// Lines, arcs, polylines and joined lines and arcs with sharp corners keep their parts, loops included. All else is
/// kept clear of the curve: loops are cut away, so several curves may come back, and where nothing is left a warning
/// says so. Without a plane the offset goes to the side where it becomes longer.
#[component(
    "1a38d325-98de-455c-93f1-bca431bc1243",
    name = "Offset Curve",
    nick = "Offset",
    at = "Curve/Util"
)]
#[output("Curve", "C", "The offset.")]
fn offset_curve(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far to the right of the curve's direction, as seen against the plane's normal; negative to the left. So a counter-clockwise closed curve grows.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// The plane to offset in. A flat curve that does not lie along it is offset in its own plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Option<Plane>,
    /// How the outsides of corners are filled: 0 not at all, 1 sharp, 2 round, 3 smooth, 4 by a chamfer.
    #[port("Corners", "C", default = 1)]
    corners: i32,
) -> Result<Vec<Shared<Curve>>, Message> {
    let corner = match corners {
        0 => OffsetCorner::None,
        1 => OffsetCorner::Sharp,
        2 => OffsetCorner::Round,
        3 => OffsetCorner::Smooth,
        4 => OffsetCorner::Chamfer,
        _ => return Err(Message::error(format!("There is no corner type {corners}: it goes from 0 to 4"))),
    };
    let beside = |plane: &Plane, distance: f64| -> Result<Vec<Curve>, Message> {
        if corner == OffsetCorner::Sharp
            && let Ok(one) = curve.offset_in_plane(plane, distance)
        {
            return Ok(vec![one]);
        }
        let all = curve.offset(plane, distance, corner, &context.tolerance())?;
        if all.is_empty() {
            return Err(Message::warning("Nothing of the curve is left at this distance"));
        }
        Ok(all)
    };
    let offset = match plane {
        Some(plane) => beside(&facing(curve, &plane, context), distance)?,
        None => {
            let plane = own_plane(curve)?;
            let length = |curves: &[Curve]| curves.iter().map(Curve::length).sum::<f64>();
            match (beside(&plane, distance), beside(&plane, -distance)) {
                (Ok(a), Ok(b)) if length(&b) > length(&a) => b,
                (Ok(a), _) => a,
                (Err(_), Ok(b)) => b,
                (Err(error), Err(_)) => return Err(error),
            }
        }
    };
    Ok(offset.into_iter().map(shared).collect())
}

/// The polylines at a distance beside a polyline, with sharp corners.
///
/// Where sides would cross each other or turn round, what comes too near to the polyline is cut away; several
/// polylines may be left. If nothing is left, the uncleaned offset comes back and is marked as not valid.
#[component("e2c6cab3-91ea-4c01-900c-646642d3e436", name = "Offset Polyline", nick = "OP", at = "Curve/Util")]
#[output("Offset", "O", "The offsets.")]
#[output("Valid", "V", "Whether each keeps its distance all along.")]
fn offset_polyline(
    context: &Context<'_>,
    /// A flat polyline; it is offset in its own plane.
    #[port("Polyline", "P")]
    polyline: &Curve,
    /// How far to the right of the polyline's direction, as seen from above (or, if it stands upright, against its plane's normal); negative to the left.
    #[port("Distance", "D")]
    distance: f64,
) -> Result<(Vec<Shared<Curve>>, Vec<bool>), Message> {
    if polyline.as_polyline().is_none() {
        return Err(Message::error("The curve is no polyline"));
    }
    let plane = own_plane(polyline)?;
    let plane = if plane.z_axis.z < -1e-9 { plane.flipped() } else { plane };
    let clean = polyline.offset(&plane, distance, OffsetCorner::Sharp, &context.tolerance())?;
    if clean.is_empty() {
        return Ok((vec![shared(polyline.offset_in_plane(&plane, distance)?)], vec![false]));
    }
    let valid = vec![true; clean.len()];
    Ok((clean.into_iter().map(shared).collect(), valid))
}

/// A curve whose control points are moved, each from the place on the curve that it belongs to.
fn moved(
    curve: &Curve,
    aside: impl FnOnce(&[f64]) -> Result<Vec<Vector3>, Message>,
) -> Result<Shared<Curve>, Message> {
    let nurbs = curve.to_nurbs()?;
    let domain = curve.domain();
    // The first and last points of a periodic curve belong to places on its other side.
    let around = |t: f64| {
        if nurbs.is_periodic() && !(domain.start <= t && t <= domain.end) {
            domain.start + (t - domain.start).rem_euclid(domain.length())
        } else {
            domain.clamp(t)
        }
    };
    let places: Vec<f64> = nurbs.greville_abscissae().into_iter().map(around).collect();
    let points: Vec<Point3> =
        nurbs.control_points().into_iter().zip(aside(&places)?).map(|(p, v)| p + v).collect();
    let moved = NurbsCurve::with_weights(nurbs.degree(), &points, &nurbs.weights(), nurbs.knots().to_vec())?;
    Ok(shared(Curve::Nurbs(moved.to_non_rational().unwrap_or(moved))))
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
    moved(curve, |places| {
        let aside = |&t: &f64| curve.tangent_at(t).and_then(|t| t.cross(plane.z_axis).unitized());
        let aside = |t: &f64| aside(t).map(|v| v * distance).ok_or_else(no_direction);
        places.iter().map(aside).collect()
    })
}

fn no_direction() -> Message {
    Message::warning("The curve has no direction in the plane")
}

/// Moves the control points of a curve in space sideways, along frames that do not twist about it. Their number stays,
/// and the distance is only roughly kept.
///
/// The frames start to the right of the curve in the plane that fits it best, so that a flat curve is moved as by
/// Offset Curve Loose.
#[component(
    "c6fe61e7-25e2-4333-9172-f4e2a123fcfe",
    name = "Offset Loose 3D",
    nick = "Offset (3D)",
    at = "Curve/Util"
)]
#[output("Curve", "C", "The moved curve.")]
fn offset_loose_3d(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far, to the right at the start; negative to the left.
    #[port("Distance", "D")]
    distance: f64,
) -> Result<Shared<Curve>, Message> {
    let fitted = own_plane(curve)?;
    let up = if fitted.z_axis.z < -1e-9 { -fitted.z_axis } else { fitted.z_axis };
    moved(curve, |places| {
        let start = curve.domain().start;
        let wanted: Vec<f64> = std::iter::once(start).chain(places.iter().copied()).collect();
        let frames = curve.perpendicular_frames(&wanted);
        let first = frames.first().copied().flatten().ok_or_else(no_direction)?;
        let right = first.z_axis.cross(up).unitized().unwrap_or(first.x_axis);
        let (x, y) = (right.dot(first.x_axis), right.dot(first.y_axis));
        let aside = |frame: &Option<Plane>| {
            frame.map(|f| (f.x_axis * x + f.y_axis * y) * distance).ok_or_else(no_direction)
        };
        frames.iter().skip(1).map(aside).collect()
    })
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
        let corner =
            |kind: i32| Trial::of("Offset Curve").item(square()).item(1.0).item(Plane::XY).item(kind);
        assert_eq!(length(corner(2)), "{0}: 22.283185");
        assert_eq!(length(corner(4)), "{0}: 21.656854");
        assert_eq!(corner(0).run().outputs[0].item_count(), 4);
        assert!(corner(5).message().contains("0 to 4"));
        let gone = Trial::of("Offset Curve").item(square()).item(-3.0).item(Plane::XY).item(2);
        assert!(gone.message().contains("Nothing"));
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

    #[test]
    fn beside_polylines_and_in_space() {
        let polyline = |d: f64| Trial::of("Offset Polyline").item(square()).item(d);
        assert_eq!(length(polyline(1.0)), "{0}: 24");
        assert_eq!(polyline(1.0).texts(1).join(""), "{0;0}: True");
        assert_eq!(polyline(-3.0).texts(1).join(""), "{0;0}: False");
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        assert!(Trial::of("Offset Polyline").item(circle).item(1.0).message().contains("no polyline"));
        // A flat curve as in its plane; a line moves as a whole.
        let flat = Trial::of("Offset Loose 3D").item(circle).item(0.5).run().outputs[0].clone();
        let loose = Trial::of("Offset Curve Loose").item(circle).item(0.5).item(Plane::XY);
        let lengths =
            |tree| Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(tree).texts(0).join("");
        assert_eq!(lengths(flat), lengths(loose.run().outputs[0].clone()));
        let line = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 4.0));
        assert_eq!(length(Trial::of("Offset Loose 3D").item(line).item(1.0)), "{0}: 4");
    }
}
