//! Polygons extruded with sides that lean.

use katydid_elementary::Elementary;

use crate::construct::thresholds::UPRIGHT;
use crate::thresholds;
use crate::{Brep, Error, Plane, Point3, PolylineCurve, Result, Tolerance, Vector3};

/// The solid between two heights over a flat closed polyline, whose sides lean inwards by an angle each (radians from
/// the normal of its plane; below 0 they lean outwards). The polyline is the section at height 0; heights count along
/// the normal about which it runs counter-clockwise. Side k belongs to the polyline's segment k; with fewer angles the
/// last one counts for the rest. Sides that meet exactly at the top give an edge or a tip there.
///
/// # Errors
/// A polyline that is not flat, crosses itself or has fewer than three corners; heights that are equal; angles that
/// are not below a right angle; neighbours on one line that lean differently; or sides that meet below the top: roofs
/// are not supported.
pub fn extrude_angled(
    corners: &[Point3],
    heights: [f64; 2],
    angles: &[f64],
    tolerance: &Tolerance,
) -> Result<Brep> {
    let limit = tolerance.positive_distance()?;
    let mut points = corners.to_vec();
    points.dedup_by(|b, a| a.distance_to(*b) <= limit);
    if points.len() > 1 && points.first().zip(points.last()).is_some_and(|(a, b)| a.distance_to(*b) <= limit)
    {
        points.pop();
    }
    let n = points.len();
    if n < 3 {
        return Err(Error::degenerate("angled extrusion", "the polyline has fewer than three corners"));
    }
    let [low, high] = [heights[0].min(heights[1]), heights[0].max(heights[1])];
    if !(high - low > limit && high.is_finite() && low.is_finite()) {
        return Err(Error::degenerate("angled extrusion", "its heights are equal"));
    }
    let Some(last) = angles.last() else {
        return Err(Error::degenerate("angled extrusion", "there is no angle"));
    };
    let right = std::f64::consts::FRAC_PI_2;
    let leans = (0..n).map(|k| *angles.get(k).unwrap_or(last));
    let leans: Vec<f64> = leans
        .map(|a| {
            let fits = a.is_finite() && a.abs() < right - UPRIGHT;
            if fits {
                Ok(a.tangent())
            } else {
                Err(Error::OutOfRange { what: "angle", value: a, must: "less than a right angle" })
            }
        })
        .collect::<Result<_>>()?;
    let plane = plane_of(&points, limit)?;
    let ways = ways(&points, &plane, &leans)?;
    let section = |h: f64| -> Vec<Point3> {
        points.iter().zip(&ways).map(|(p, way)| *p + (*way + plane.z_axis) * h).collect()
    };
    let rings = [section(low), section(high)];
    for ring in [&rings[0], &rings[1], &points] {
        for k in 0..n {
            let (side, own) = (ring[(k + 1) % n] - ring[k], points[(k + 1) % n] - points[k]);
            if side.dot(own) < -limit * own.length() {
                return Err(Error::degenerate("angled extrusion", "its sides meet between its heights"));
            }
        }
        if crosses_itself(ring, &plane, limit) {
            return Err(Error::degenerate("angled extrusion", "its sides run into each other"));
        }
    }
    let mut faces = Vec::with_capacity(n + 2);
    let mut add = |mut ring: Vec<Point3>| -> Result<()> {
        ring.dedup_by(|b, a| a.distance_to(*b) <= limit);
        while ring.len() > 1 && ring.first().zip(ring.last()).is_some_and(|(a, b)| a.distance_to(*b) <= limit)
        {
            ring.pop();
        }
        if ring.len() > 2 {
            ring.extend(ring.first().copied());
            faces.extend(Brep::planar_faces(&[PolylineCurve::new(ring)?.into()], tolerance)?.breps);
        }
        Ok(())
    };
    for k in 0..n {
        let next = (k + 1) % n;
        add(vec![rings[0][k], rings[0][next], rings[1][next], rings[1][k]])?;
    }
    let [bottom, top] = rings;
    add(bottom)?;
    add(top)?;
    let solid = Brep::joined_into_one(&faces, tolerance)?;
    if solid.is_solid() {
        Ok(solid)
    } else {
        Err(Error::degenerate("angled extrusion", "its faces do not close"))
    }
}

/// The plane of a flat polygon, about whose normal it runs counter-clockwise.
fn plane_of(points: &[Point3], limit: f64) -> Result<Plane> {
    let (plane, off) = Plane::fit(points)?;
    if off > limit {
        return Err(Error::degenerate("angled extrusion", "the polyline is not flat"));
    }
    let origin = plane.origin;
    let turn = (points.iter().zip(points.iter().cycle().skip(1)))
        .fold(Vector3::ZERO, |sum, (p, q)| sum + (*p - origin).cross(*q - origin));
    Ok(if turn.dot(plane.z_axis) < 0.0 { plane.flipped() } else { plane })
}

/// How corners move in the plane for each unit of height.
fn ways(points: &[Point3], plane: &Plane, leans: &[f64]) -> Result<Vec<Vector3>> {
    let n = points.len();
    let inward: Vec<Vector3> = (0..n)
        .map(|k| {
            let side = points[(k + 1) % n] - points[k];
            plane
                .z_axis
                .cross(side)
                .unitized()
                .ok_or(Error::degenerate("angled extrusion", "a side has no length"))
        })
        .collect::<Result<_>>()?;
    (0..n)
        .map(|k| {
            let before = (k + n - 1) % n;
            let ([a, b], [s, t]) = ([inward[before], inward[k]], [leans[before], leans[k]]);
            let sine = a.cross(b).dot(plane.z_axis);
            if sine.abs() < thresholds::PARALLEL {
                let on = a.dot(b) > 0.0 && (s - t).abs() < thresholds::ROUNDING;
                return if on {
                    Ok(b * t)
                } else {
                    Err(Error::degenerate("angled extrusion", "sides on one line lean differently"))
                };
            }
            // What moves by s against the one side and by t against the other.
            Ok((b.cross(plane.z_axis) * s + plane.z_axis.cross(a) * t) / sine)
        })
        .collect()
}

/// Whether sides of a polygon that are no neighbours meet.
fn crosses_itself(ring: &[Point3], plane: &Plane, limit: f64) -> bool {
    let n = ring.len();
    let flat: Vec<[f64; 2]> = ring
        .iter()
        .map(|p| {
            let [x, y, _] = plane.coordinates(*p);
            [x, y]
        })
        .collect();
    let side = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        let cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let length = (b[0] - a[0]).hypotenuse(b[1] - a[1]);
        if cross.abs() <= limit * length { 0.0 } else { cross.signum() }
    };
    (0..n).any(|i| {
        (i + 2..n).filter(|j| (j + 1) % n != i).any(|j| {
            let [a, b, c, d] = [flat[i], flat[(i + 1) % n], flat[j], flat[(j + 1) % n]];
            side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MeshSettings;

    fn square() -> Vec<Point3> {
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0]]
            .map(Point3::from)
            .to_vec()
    }

    fn made(corners: &[Point3], heights: [f64; 2], angles: &[f64]) -> Result<f64> {
        let brep =
            extrude_angled(corners, heights, angles, &Tolerance { absolute: 1e-6, ..Tolerance::default() })?;
        assert_eq!(brep.faults(), []);
        assert!(brep.is_solid());
        Ok(brep.mesh(&MeshSettings::default()).unwrap().welded().unwrap().volume())
    }

    #[test]
    fn prisms_frusta_and_pyramids() {
        let slope = 0.5_f64.atan();
        assert!((made(&square(), [0.0, 3.0], &[0.0]).unwrap() - 12.0).abs() < 1e-9);
        // From 2 by 2 to 1 by 1 over a height of 1.
        assert!((made(&square(), [0.0, 1.0], &[slope]).unwrap() - 7.0 / 3.0).abs() < 1e-9);
        assert!((made(&square(), [0.0, 2.0], &[slope]).unwrap() - 8.0 / 3.0).abs() < 1e-9);
        // One side leans over: a wedge on a box.
        assert!((made(&square(), [0.0, 2.0], &[slope, 0.0]).unwrap() - 6.0).abs() < 1e-9);
        assert!((made(&square(), [-1.0, 0.0], &[slope]).unwrap() - 19.0 / 3.0).abs() < 1e-9);
        let mut clockwise = square();
        clockwise.reverse();
        assert!((made(&clockwise, [0.0, 1.0], &[slope]).unwrap() - 7.0 / 3.0).abs() < 1e-9);
    }

    #[test]
    fn what_cannot_be_made() {
        let error =
            |heights: [f64; 2], angles: &[f64]| made(&square(), heights, angles).unwrap_err().to_string();
        assert!(error([0.0, 5.0], &[0.5]).contains("meet"));
        assert!(error([1.0, 1.0], &[0.5]).contains("equal"));
        assert!(error([0.0, 1.0], &[2.0]).contains("right angle"));
        assert!(error([0.0, 1.0], &[]).contains("no angle"));
        assert!(made(&square()[..2], [0.0, 1.0], &[0.0]).is_err());
        let bow = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]].map(Point3::from);
        assert!(made(&bow, [0.0, 1.0], &[0.0]).is_err());
    }
}
