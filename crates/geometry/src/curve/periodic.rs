//! Curves and surfaces that close made periodic: smooth where they close, and all along.

use super::Curve;
use crate::{Direction, Error, NurbsCurve, NurbsSurface, Point3, Result, periodic_uniform_knots};

impl NurbsCurve {
    /// The periodic curve in the place of one that closes, over the same domain, with even simple knots: without kinks,
    /// there and everywhere. Its different control points are those of the curve, or when it is to be `near`, as many
    /// as make it go through the curve's points at its edit parameters. A curve that is periodic stays as it is.
    ///
    /// # Errors
    /// A curve that does not close, a degree of 1, fewer than three different control points or than the degree, or,
    /// when it is to be near, a curve with weights.
    pub fn to_periodic(&self, near: bool) -> Result<Self> {
        if self.is_periodic() {
            return Ok(self.clone());
        }
        let degree = self.degree();
        if degree < 2 || !Curve::from(self.clone()).is_closed() {
            return Err(Error::degenerate("curve to make periodic", "it does not close, or is of degree 1"));
        }
        let clamped = self.clamped()?;
        let mut points = clamped.homogeneous_points();
        points.pop();
        let different = points.len();
        if different < degree.max(3) {
            return Err(Error::degenerate("curve to make periodic", "it has too few control points"));
        }
        points.extend_from_within(..degree);
        let domain = self.domain();
        let knots = periodic_uniform_knots(degree, points.len())?;
        let knots: Vec<f64> = knots.iter().map(|t| domain.at(t / different as f64)).collect();
        let plain = |points: &[[f64; 4]]| points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        if self.is_rational() {
            if near {
                return Err(Error::Unsupported("periodic curves near curves with weights"));
            }
            return Self::rational(degree, points, knots);
        }
        let made = Self::new(degree, plain(&points), knots)?;
        if !near {
            return Ok(made);
        }
        let wanted: Vec<Point3> = made.edit_parameters().into_iter().map(|t| self.point_at(t)).collect();
        made.through_edit_points(&wanted)
    }
}

impl NurbsSurface {
    /// The surface that is periodic in one direction in the place of one that closes in it:
    /// [`NurbsCurve::to_periodic`] of each of its rows.
    ///
    /// # Errors
    /// As there.
    pub fn to_periodic(&self, direction: Direction, near: bool) -> Result<Self> {
        if self.is_periodic(direction) {
            return Ok(self.clone());
        }
        if direction == Direction::V {
            return Ok(self.transposed().to_periodic(Direction::U, near)?.transposed());
        }
        if self.is_rational() && near {
            return Err(Error::Unsupported("periodic surfaces near surfaces with weights"));
        }
        let [rows, columns] = self.counts();
        let mut made = Vec::with_capacity(columns);
        for j in 0..columns {
            let row: Vec<[f64; 4]> = (0..rows).filter_map(|i| self.homogeneous_point(i, j)).collect();
            let (degree, knots) = (self.degree(direction), self.knots(direction).to_vec());
            let row = if self.is_rational() {
                NurbsCurve::rational(degree, row, knots)?
            } else {
                NurbsCurve::new(degree, row.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect(), knots)?
            };
            made.push(row.to_periodic(near)?);
        }
        let none = Error::degenerate("surface", "it has no control points");
        let first = made.first().ok_or(none)?;
        let counts = [first.point_count(), columns];
        let knots = [first.knots().to_vec(), self.knots(Direction::V).to_vec()];
        let net: Vec<[f64; 4]> = (0..counts[0])
            .flat_map(|i| made.iter().filter_map(move |row| row.homogeneous_point(i)))
            .collect();
        if self.is_rational() {
            return Self::rational(self.degrees(), counts, net, knots);
        }
        let net = net.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        Self::new(self.degrees(), counts, net, knots)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NurbsSurface, Vector3};

    fn drop_shape() -> NurbsCurve {
        let corners = [(0.0, 0.0), (2.0, 0.0), (4.0, 1.0), (4.0, 3.0), (1.0, 4.0), (-1.0, 2.0), (0.0, 0.0)];
        let corners: Vec<Point3> = corners.iter().map(|(x, y)| Point3::new(*x, *y, 0.0)).collect();
        NurbsCurve::clamped_uniform(3, &corners).unwrap()
    }

    #[test]
    fn closes_smoothly() {
        let kinked = drop_shape();
        for near in [false, true] {
            let made = kinked.to_periodic(near).unwrap();
            assert!(made.is_periodic());
            assert_eq!(made.domain(), kinked.domain());
            assert_eq!(made.distinct_control_points().len(), 6);
            let curve = Curve::from(made.clone());
            let domain = curve.domain();
            let (a, b) = (curve.derivatives(domain.start, 2, false), curve.derivatives(domain.end, 2, true));
            assert!(a.0.distance_to(b.0) < 1e-12);
            assert!(a.1.iter().zip(&b.1).all(|(a, b)| (*a - *b).length() < 1e-9));
            if near {
                for t in made.edit_parameters() {
                    assert!(made.point_at(t).distance_to(kinked.point_at(t)) < 1e-9);
                }
            } else {
                assert_eq!(made.distinct_control_points(), kinked.control_points()[..6]);
            }
        }
        let open = NurbsCurve::clamped_uniform(3, &kinked.control_points()[..5]).unwrap();
        assert!(open.to_periodic(false).is_err());
    }

    #[test]
    fn tubes_close_smoothly() {
        let shift = Vector3::new(0.0, 0.0, 2.0);
        let top = drop_shape().transformed(&crate::Xform::translation(shift)).unwrap();
        let tube = NurbsSurface::ruled(&drop_shape(), &top).unwrap();
        for (surface, along) in [(tube.clone(), Direction::U), (tube.transposed(), Direction::V)] {
            let made = surface.to_periodic(along, false).unwrap();
            assert!(made.is_periodic(along));
            assert!(made.to_periodic(along, true).is_ok());
            assert!(made.to_periodic(along.other(), false).is_err());
        }
    }
}
