//! NURBS surfaces made from points and curves.

use katydid_geometry::construct::{network_surface, rail_revolve};
use katydid_geometry::intersect::curve_curve;
use katydid_geometry::{
    Brep, Curve, Interval, KnotSpacing, Line, NurbsSurface, Plane, Point3, Surface, Tolerance,
    clamped_uniform_knots,
};

use super::answer::Outcome;
use super::argument::{Count, Some1, Turn, Waiting, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add(
        "nurbssurface/createfromcorners-point3d_point3d_point3d_point3d",
        |a: Point3, b: Point3, c: Point3, d: Point3| {
            Ok(Surface::from(NurbsSurface::from_corners(a, b, c, d)?))
        },
    );
    table.add(
        "nurbssurface/createfromcorners-point3d_point3d_point3d_point3d_double",
        |a: Point3, b: Point3, c: Point3, d: Point3, _: Within| {
            Ok(Surface::from(NurbsSurface::from_corners(a, b, c, d)?))
        },
    );
    table.add("nurbssurface/createfromcorners-point3d_point3d_point3d", |a: Point3, b: Point3, c: Point3| {
        Ok(Surface::from(NurbsSurface::from_triangle(a, b, c)?))
    });
    table.add(
        "nurbssurface/createfrompoints-point3darray_int_int_int_int",
        |points: Some1<Point3>, nu: Lines, nv: Lines, u: Degree, v: Degree| {
            grid(&points.0, nu, nv)?;
            Ok(Surface::from(NurbsSurface::clamped_uniform([u.0, v.0], [nu.0, nv.0], &points.0)?))
        },
    );
    table.add(
        "nurbssurface/createthroughpoints-point3darray_int_int_int_int_bool_bool",
        |points: Some1<Point3>,
         nu: Lines,
         nv: Lines,
         u: Degree,
         v: Degree,
         closed_u: bool,
         closed_v: bool| {
            grid(&points.0, nu, nv)?;
            let (degrees, closed) = ([u.0, v.0], [closed_u, closed_v]);
            let spacing = KnotSpacing::Chord;
            Ok(Surface::from(NurbsSurface::interpolate(degrees, [nu.0, nv.0], &points.0, spacing, closed)?))
        },
    );
    table.add(
        "nurbssurface/createfromplane-plane_interval_interval_int_int_int_int",
        |plane: Plane, u: Interval, v: Interval, du: Degree, dv: Degree, nu: Lines, nv: Lines| {
            of_plane(&plane, [u, v], [du.0, dv.0], [nu.0, nv.0])
        },
    );
    table.add(
        "nurbssurface/createrailrevolvedsurface-curve_curve_line_bool",
        |profile: Curve, rail: Curve, axis: Line, scale: bool| {
            sole_surface(&rail_revolve(&profile, &rail, axis, scale, &Tolerance::default())?)
        },
    );
    table.add(
        "nurbssurface/createnetworksurface-curvearray_int_int_curvearray_int_int_double_double_double_int",
        |u: Some1<Curve>, _: i32, _: i32, v: Some1<Curve>, _: i32, _: i32, t: Within, _: Within, a: Turn| {
            // No error is 0.
            Ok((sole_surface(&network_surface(&u.0, &v.0, &a.and(t))?)?, 0))
        },
    );
    table.add(
        "nurbssurface/createnetworksurface-curvearray_int_double_double_double_int",
        |curves: Some1<Curve>, _: i32, t: Within, _: Within, a: Turn, w: Waiting| {
            let [u, v] = families(curves.0, t, &w)?;
            Ok((sole_surface(&network_surface(&u, &v, &a.and(t))?)?, 0))
        },
    );
}

/// Curves in two sets, none of which crosses another one of its set: those that cross the first curve, and so on.
fn families(curves: Vec<Curve>, tolerance: Within, waiting: &Waiting) -> Outcome<[Vec<Curve>; 2]> {
    let mut sides: Vec<Option<usize>> = vec![None; curves.len()];
    let mut meets = vec![Vec::new(); curves.len()];
    for (i, a) in curves.iter().enumerate() {
        for (k, b) in curves.iter().enumerate().skip(i + 1) {
            waiting.check()?;
            if !curve_curve(a, b, tolerance.0)?.crossings.is_empty() {
                for (own, other) in [(i, k), (k, i)] {
                    meets.get_mut(own).into_iter().for_each(|met| met.push(other));
                }
            }
        }
    }
    let mut next = vec![(0, 0)];
    while let Some((i, side)) = next.pop() {
        let (Some(own), Some(met)) = (sides.get_mut(i), meets.get(i)) else { continue };
        match own {
            Some(known) if *known != side => {
                return Err(Fault::bad_request(
                    "curves do not come in two sets, of which each crosses the other",
                ));
            }
            Some(_) => {}
            None => {
                *own = Some(side);
                next.extend(met.iter().map(|other| (*other, 1 - side)));
            }
        }
    }
    if let Some(i) = sides.iter().position(Option::is_none) {
        return Err(Fault::bad_request(format!("curves: curve {i} crosses none of the others' network")));
    }
    let of = |side: usize| {
        let fitting = curves.iter().zip(&sides).filter(move |(_, own)| **own == Some(side));
        fitting.map(|(curve, _)| curve.clone()).collect::<Vec<Curve>>()
    };
    Ok([of(0), of(1)])
}

type Lines = Count<2, 10_000>;
type Degree = Count<1, 11>;

/// Refuses points that are no grid.
fn grid(points: &[Point3], nu: Lines, nv: Lines) -> Outcome<()> {
    let expected = nu.0.saturating_mul(nv.0);
    if points.len() == expected {
        return Ok(());
    }
    Err(Fault::bad_request(format!("points has {} items, not uCount × vCount = {expected}", points.len())))
}

/// The most control points.
const MOST: usize = 1_000_000;

/// A rectangle of a plane with its parameters as coordinates.
fn of_plane(
    plane: &Plane,
    ranges: [Interval; 2],
    degrees: [usize; 2],
    counts: [usize; 2],
) -> Outcome<Surface> {
    let total: usize = counts.iter().product();
    if total > MOST {
        return Err(Fault::too_large(format!(
            "the surface would have {total} control points, more than {MOST}"
        )));
    }
    let (mut knots, mut places) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
    for k in 0..2 {
        let (degree, count) = (degrees[k], counts[k]);
        if count <= degree {
            return Err(Fault::bad_request(format!("{count} points are too few for degree {degree}")));
        }
        let spans = (count - degree) as f64;
        let domain = ranges[k].ordered();
        let own = clamped_uniform_knots(degree, count)?;
        knots[k] = own.iter().map(|t| domain.at(t / spans)).collect();
        // Control points at the Greville abscissae make parameters coordinates.
        places[k] = knots[k].windows(degree).map(|w| w.iter().sum::<f64>() / degree as f64).collect();
    }
    let [us, vs]: [Vec<f64>; 2] = places;
    let points = us.iter().flat_map(|u| vs.iter().map(|v| plane.at(*u, *v, 0.0))).collect();
    Ok(NurbsSurface::new(degrees, counts, points, knots)?.into())
}

/// The surface of a brep of one face.
pub(super) fn sole_surface(brep: &Brep) -> Outcome<Surface> {
    match (brep.faces().len(), brep.face_surface(0)) {
        (1, Some(surface)) => Ok(surface.clone()),
        (count, _) => Err(Fault::failed(format!("the result has {count} faces, and is no single surface"))),
    }
}
