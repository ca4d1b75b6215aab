//! Slits in flat pieces that cross each other, so that they can be put together.

use super::{FillRule, Region};
use crate::cancellation::check;
use crate::intersect::plane_plane;
use crate::{Curve, Error, Interval, Line, Plane, Point3, PolylineCurve, Result, Vector3};

/// A flat piece with its slits.
#[derive(Debug, Clone, PartialEq)]
pub struct Slit {
    /// What is left of it.
    pub region: Region,
    /// The places in the list of the pieces that it is put together with.
    pub others: Vec<usize>,
}

/// Cuts half-lap slits into flat pieces, each the inside of a closed planar curve, where two of them cross.
///
/// Two pieces cross along stretches of the line that their planes have in common. Each stretch is halved: the piece
/// that comes first in the list is slit from the middle to its rim on one side, the other one from the middle to its
/// rim on the other side, so that they slide into each other. The sides are those of the line's direction, which is
/// taken to run upwards (along growing z; where it is level along growing y, then x): the first piece is slit at the
/// upper side. A slit is `width` wide, and reaches half of `gap` beyond the middle.
///
/// # Errors
/// The width is not above 0, the gap not from 0 on; a curve is not closed or not planar.
pub fn slits(curves: &[Curve], width: f64, gap: f64, tolerance: f64) -> Result<Vec<Slit>> {
    if !(width > 0.0 && width.is_finite()) {
        return Err(Error::OutOfRange { what: "width of a slit", value: width, must: "finite and above 0" });
    }
    if !(gap >= 0.0 && gap.is_finite()) {
        return Err(Error::OutOfRange { what: "gap of a slit", value: gap, must: "finite and at least 0" });
    }
    let pieces = curves.iter().map(|curve| Piece::new(curve, tolerance)).collect::<Result<Vec<_>>>()?;
    let mut cuts: Vec<Vec<Curve>> = vec![Vec::new(); pieces.len()];
    let mut others: Vec<Vec<usize>> = vec![Vec::new(); pieces.len()];
    for (i, a) in pieces.iter().enumerate() {
        for (j, b) in pieces.iter().enumerate().skip(i + 1) {
            check()?;
            let Some(line) = common_line(a, b) else { continue };
            let [inside_a, inside_b] = [a.stretches(&line, tolerance)?, b.stretches(&line, tolerance)?];
            for (m, s) in inside_a.iter().enumerate() {
                for (n, t) in inside_b.iter().enumerate() {
                    let (low, high) = (s.start.max(t.start), s.end.min(t.end));
                    if !(high - low > tolerance) {
                        continue;
                    }
                    let middle = 0.5 * (low + high);
                    let up = Interval::new(middle - 0.5 * gap, beyond(&inside_a, m, width, true));
                    let down = Interval::new(beyond(&inside_b, n, width, false), middle + 0.5 * gap);
                    cuts[i].push(a.slot(&line, up, width)?);
                    cuts[j].push(b.slot(&line, down, width)?);
                    others[i].push(j);
                    others[j].push(i);
                }
            }
        }
    }
    let mut out = Vec::with_capacity(pieces.len());
    for ((piece, cuts), mut others) in pieces.into_iter().zip(cuts).zip(others) {
        let region = if cuts.is_empty() {
            piece.region
        } else {
            let slots = Region::new(&cuts, FillRule::Any, piece.region.plane(), tolerance)?;
            piece.region.difference(&slots, tolerance)?
        };
        others.dedup();
        out.push(Slit { region, others });
    }
    Ok(out)
}

/// Where a slit through the rim at one end of a stretch ends: outside, by the width of a slit at most, so that a rim
/// that runs askew is cut through, and no farther than halfway to the next stretch.
fn beyond(stretches: &[Interval], at: usize, width: f64, up: bool) -> f64 {
    let Some(own) = stretches.get(at) else { return 0.0 };
    if up {
        let room = stretches.get(at + 1).map_or(f64::INFINITY, |next| 0.5 * (next.start - own.end));
        own.end + width.min(room)
    } else {
        let before = at.checked_sub(1).and_then(|k| stretches.get(k));
        own.start - width.min(before.map_or(f64::INFINITY, |last| 0.5 * (own.start - last.end)))
    }
}

/// The line that two planes have in common, at a point near both pieces, along a unit vector that runs upwards.
fn common_line(a: &Piece, b: &Piece) -> Option<Line> {
    let line = plane_plane(a.region.plane(), b.region.plane())?;
    let along = line.unit_direction()?;
    let down = along.z < 0.0 || (along.z == 0.0 && (along.y < 0.0 || (along.y == 0.0 && along.x < 0.0)));
    let along = if down { -along } else { along };
    let start = line.from + along * (a.region.plane().origin - line.from).dot(along);
    let line = Line::new(start, start + along);
    line.is_finite().then_some(line)
}

struct Piece {
    region: Region,
    /// The control points of its outline.
    hull: Vec<Point3>,
}

impl Piece {
    fn new(curve: &Curve, tolerance: f64) -> Result<Self> {
        let plane = curve.plane(tolerance).ok_or(Error::degenerate("curve", "it is not planar"))?;
        let hull = curve.hull_points();
        let centre = hull.iter().fold(Vector3::ZERO, |sum, p| sum + p.to_vector()) / hull.len().max(1) as f64;
        let plane = plane.with_origin(plane.closest_point(Point3::ORIGIN + centre));
        let region = Region::new(std::slice::from_ref(curve), FillRule::Any, &plane, tolerance)?;
        Ok(Self { region, hull })
    }

    /// The stretches of a line, in its units, that lie inside.
    fn stretches(&self, line: &Line, tolerance: f64) -> Result<Vec<Interval>> {
        let along = line.direction();
        let places = self.hull.iter().map(|p| (*p - line.from).dot(along));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), t| (a.min(t), b.max(t)));
        if !(high - low > tolerance) {
            return Ok(Vec::new());
        }
        let room = 0.01 * (high - low);
        let probe: Curve = Line::new(line.at(low - room), line.at(high + room)).into();
        let place = |p: Point3| (p - line.from).dot(along);
        let inside = self.region.trim(&probe, tolerance)?.inside;
        Ok(inside.iter().map(|c| Interval::new(place(c.start()), place(c.end()))).collect())
    }

    /// The rectangle of a slit along a stretch of a line.
    fn slot(&self, line: &Line, stretch: Interval, width: f64) -> Result<Curve> {
        let plane: &Plane = self.region.plane();
        let across = plane.z_axis.cross(line.direction()) * (0.5 * width);
        let [a, b] = [line.at(stretch.start), line.at(stretch.end)];
        let corners = vec![a - across, b - across, b + across, a + across, a - across];
        Ok(PolylineCurve::new(corners)?.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Rectangle};

    fn rectangle(plane: Plane, x: [f64; 2], y: [f64; 2]) -> Curve {
        let points =
            Rectangle { plane, x: Interval::new(x[0], x[1]), y: Interval::new(y[0], y[1]) }.corners();
        PolylineCurve::new(points.into_iter().chain([points[0]]).collect()).unwrap().into()
    }

    #[test]
    fn two_sheets_slide_into_each_other() {
        // Upright sheets 4 wide and 2 high, and one that reaches from z = 0.5 to 3.
        let sheets =
            [rectangle(Plane::XZ, [-2.0, 2.0], [0.0, 2.0]), rectangle(Plane::YZ, [-2.0, 2.0], [0.5, 3.0])];
        let made = slits(&sheets, 0.2, 0.1, 1e-6).unwrap();
        assert_eq!((made[0].others.as_slice(), made[1].others.as_slice()), (&[1][..], &[0][..]));
        // They share z from 0.5 to 2; the middle is 1.25.
        let lost = [0.2 * (2.0 - 1.25 + 0.05), 0.2 * (1.25 + 0.05 - 0.5)];
        assert!((8.0 - made[0].region.area() - lost[0]).abs() < 1e-9, "{}", made[0].region.area());
        assert!((10.0 - made[1].region.area() - lost[1]).abs() < 1e-9, "{}", made[1].region.area());
        assert!(made.iter().all(|one| one.region.faces().len() == 1));
        let on = |k: usize, z: f64| made[k].region.contains(Point3::new(0.0, 0.0, z), 1e-6).unwrap();
        assert_eq!(on(0, 0.6), crate::Containment::Inside);
        assert_eq!(on(0, 1.9), crate::Containment::Outside);
        assert_eq!(on(1, 0.6), crate::Containment::Outside);
        assert_eq!(on(1, 1.9), crate::Containment::Inside);
    }

    #[test]
    fn a_grid_of_ribs_and_a_disc() {
        let rib =
            |x: f64| rectangle(Plane::YZ.with_origin(Point3::new(x, 0.0, 0.0)), [-2.0, 2.0], [-1.0, 1.0]);
        let mut curves: Vec<Curve> = [-1.0, 0.0, 1.0].map(rib).to_vec();
        curves.push(Circle::new(Plane::XZ, 1.5).unwrap().into());
        let made = slits(&curves, 0.1, 0.0, 1e-6).unwrap();
        assert_eq!(made[3].others, [0, 1, 2]);
        assert_eq!((made[0].others.as_slice(), made[3].region.faces().len()), (&[3][..], 1));
        // In the middle the rib has z from −1 to 1 in common with the disc, so both slits meet at 0.
        assert!((8.0 - made[1].region.area() - 0.1).abs() < 1e-9);
    }

    #[test]
    fn pieces_apart_and_refused() {
        let flat = [0.0, 5.0].map(|z| rectangle(Plane::XY.offset(z), [0.0, 1.0], [0.0, 1.0]));
        let made = slits(&flat, 0.1, 0.0, 1e-6).unwrap();
        assert!(made.iter().all(|one| one.others.is_empty() && (one.region.area() - 1.0).abs() < 1e-12));
        assert!(slits(&flat, 0.0, 0.0, 1e-6).is_err() && slits(&flat, 0.1, -1.0, 1e-6).is_err());
        assert!(slits(&flat, f64::NAN, 0.0, 1e-6).is_err());
        let open: Curve = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).into();
        assert!(slits(&[open], 0.1, 0.0, 1e-6).is_err());
        assert!(slits(&[], 0.1, 0.0, 1e-6).unwrap().is_empty());
    }
}
