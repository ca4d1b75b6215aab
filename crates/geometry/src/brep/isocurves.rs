//! Lines of constant parameter on trimmed faces.

use super::{Brep, trimmed};
use crate::brep::thresholds::ISO_CROSSING;
use crate::region::Outline;
use crate::thresholds;
use crate::{Curve, Direction, Interval, Plane, Point3, Result, Vector3};

impl Brep {
    /// The parts inside its trims of the curve on a face along which the other parameter than `along` is constant, in
    /// order. A part that only runs along the border of the face is none.
    ///
    /// # Errors
    /// The face does not exist, a loop has no curves, or a part is too short to be a curve.
    pub fn face_isocurves(&self, face: usize, along: Direction, constant: f64) -> Result<Vec<Curve>> {
        let surface = self.face_surface(face).ok_or_else(trimmed::no_face)?;
        let mut inside = Vec::new();
        for range in self.iso_ranges(face, along, constant)? {
            // A line of constant parameter may be a single point, at a pole.
            if let Ok(curve) = surface.isocurve(along, constant) {
                inside.push(if curve.domain() == range { curve } else { curve.trimmed(range)? });
            }
        }
        Ok(inside)
    }

    /// Where a line of constant parameter runs inside the trims of a face.
    fn iso_ranges(&self, face: usize, along: Direction, constant: f64) -> Result<Vec<Interval>> {
        let surface = self.face_surface(face).ok_or_else(trimmed::no_face)?;
        let domain = surface.domain(along);
        let loops = self.face_loops(face)?;
        let (normal, at) = match along {
            Direction::V => (Vector3::X, Point3::new(constant, 0.0, 0.0)),
            Direction::U => (Vector3::Y, Point3::new(0.0, constant, 0.0)),
        };
        let plane = Plane::from_normal(at, normal)?;
        let across = surface.domain(along.other()).length();
        let mut stops = vec![domain.start, domain.end];
        for curve in &loops {
            for t in curve.intersect_plane(&plane, ISO_CROSSING * across)? {
                let p = curve.point_at(t);
                stops.push(if along == Direction::U { p.x } else { p.y });
            }
        }
        let least = thresholds::SAME_PARAMETER * domain.length();
        stops.retain(|t| domain.start <= *t && *t <= domain.end);
        stops.sort_by(f64::total_cmp);
        let outlines: Vec<Outline> = loops.iter().map(|curve| Outline::new(curve, &Plane::XY)).collect();
        let mut found: Vec<Interval> = Vec::new();
        for w in stops.windows(2) {
            let middle = 0.5 * (w[0] + w[1]);
            let uv = if along == Direction::U { [middle, constant] } else { [constant, middle] };
            if w[1] - w[0] <= least || outlines.iter().map(|o| o.winding(uv)).sum::<i32>() == 0 {
                continue;
            }
            match found.last_mut() {
                Some(last) if w[0] - last.end <= least => last.end = w[1],
                _ => found.push(Interval::new(w[0], w[1])),
            }
        }
        Ok(found)
    }

    /// The isocurves of a face inside its trims: those at the knots of its surface, and between two knots `density`
    /// more at equal steps.
    ///
    /// # Errors
    /// As [`Brep::face_isocurves`].
    pub fn face_wires(&self, face: usize, density: usize) -> Result<Vec<Curve>> {
        let surface = self.face_surface(face).ok_or_else(trimmed::no_face)?;
        let mut wires = Vec::new();
        for across in Direction::BOTH {
            let knots = surface.span_parameters(across);
            let last = knots.len().saturating_sub(2);
            for (k, w) in knots.windows(2).enumerate() {
                let range = Interval::new(w[0], w[1]);
                for step in 1..=density + usize::from(k < last) {
                    let t = range.at(step as f64 / (density + 1) as f64);
                    wires.extend(self.face_isocurves(face, across.other(), t)?);
                }
            }
        }
        Ok(wires)
    }
}
