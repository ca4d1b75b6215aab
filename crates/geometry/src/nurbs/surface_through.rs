//! Surfaces with given knots through points at their Greville abscissae.

use super::evaluate::basis;
use super::knots::{MAX_DEGREE, span_index};
use super::{Direction, NurbsSurface};
use crate::linear::Banded;
use crate::{Error, Point3, Result};

/// The control points of the line through points at its Greville abscissae.
fn line(degree: usize, knots: &[f64], places: &[f64], points: &[Point3]) -> Result<Vec<Point3>> {
    let n = points.len();
    let mut system = Banded::new(n, degree, vec![[0.0; 3]; n])?;
    let mut values = [0.0; MAX_DEGREE + 1];
    for (i, (&t, point)) in places.iter().zip(points).enumerate() {
        let j = span_index(knots, degree, t, i + 1 == n);
        basis(degree, knots, j, t, &mut values);
        for (k, &value) in values.iter().enumerate().take(degree + 1) {
            if value != 0.0 {
                system.add(i, j + k, value);
            }
        }
        system.set_right(i, [point.x, point.y, point.z]);
    }
    let solved = system.solve_totally_positive();
    let none =
        || Error::Invalid { what: "knots", why: "no surface with them goes through all points".into() };
    let mut out: Vec<Point3> = solved.ok_or_else(none)?.into_iter().map(Point3::from).collect();
    // The ends are on the curve, without rounding.
    if let (Some(first), Some(&point)) = (out.first_mut(), points.first()) {
        *first = point;
    }
    if let (Some(last), Some(&point)) = (out.last_mut(), points.last()) {
        *last = point;
    }
    Ok(out)
}

impl NurbsSurface {
    /// The surface without weights and with the degrees and knots of this one, whose point at each pair of Greville
    /// abscissae ([`NurbsSurface::greville_abscissae`]) is the one given, v running fastest. Knots are clamped.
    ///
    /// # Errors
    /// A number that is not finite, or too few points.
    pub(crate) fn through(&self, points: &[Point3]) -> Result<Self> {
        let [rows, columns] = self.counts();
        if points.len() != rows * columns {
            return Err(Error::Invalid {
                what: "points",
                why: format!("{} for {rows} by {columns}", points.len()),
            });
        }
        let [us, vs] = Direction::BOTH.map(|d| self.greville_abscissae(d));
        let [p, q] = self.degrees();
        let mut net = Vec::with_capacity(points.len());
        for row in points.chunks_exact(columns) {
            net.extend(line(q, self.knots(Direction::V), &vs, row)?);
        }
        let mut controls = net.clone();
        for j in 0..columns {
            let column: Vec<Point3> = net.iter().skip(j).step_by(columns).copied().collect();
            let solved = line(p, self.knots(Direction::U), &us, &column)?;
            for (place, point) in controls.iter_mut().skip(j).step_by(columns).zip(solved) {
                *place = point;
            }
        }
        let knots = Direction::BOTH.map(|d| self.knots(d).to_vec());
        Self::new(self.degrees(), self.counts(), controls, knots)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_comes_back() {
        let knots = vec![0.0, 0.0, 0.0, 0.4, 1.0, 1.0, 1.0];
        let blank = vec![Point3::ORIGIN; 25];
        let frame = NurbsSurface::new([3, 3], [5, 5], blank, [knots.clone(), knots]).unwrap();
        let map = |u: f64, v: f64| Point3::new(u * u * u - v, u * v * v, 2.0 * u + v * v * v);
        let [us, vs] = Direction::BOTH.map(|d| frame.greville_abscissae(d));
        let points: Vec<Point3> = us.iter().flat_map(|u| vs.iter().map(move |v| map(*u, *v))).collect();
        let made = frame.through(&points).unwrap();
        for i in 0..=10 {
            for j in 0..=10 {
                let (u, v) = (f64::from(i) / 10.0, f64::from(j) / 10.0);
                assert!(made.point_at(u, v).distance_to(map(u, v)) < 1e-12);
            }
        }
    }
}
