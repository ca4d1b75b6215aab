//! Surfaces through grids of points.

use super::NurbsSurface;
use super::evaluate::basis;
use super::interpolate::KnotSpacing;
use super::knots::{MAX_DEGREE, span_index};
use super::refine::make_knots_periodic;
use super::surface_construct::check_grid;
use super::surface_refine::transposed;
use crate::linear::Banded;
use crate::nurbs::thresholds::KNOT_STEP;
use crate::{Error, Point3, Result};

/// How lines of points in one direction are interpolated: parameters and knots are the same for all of them.
pub(super) struct Lines {
    degree: usize,
    periodic: bool,
    parameters: Vec<f64>,
    pub(super) knots: Vec<f64>,
}

impl Lines {
    pub(super) fn new(degree: usize, periodic: bool, count: usize, parameters: Vec<f64>) -> Result<Self> {
        if degree == 0 || degree > MAX_DEGREE {
            return Err(Error::OutOfRange { what: "degree", value: degree as f64, must: "from 1 to 31" });
        }
        let least = if periodic { degree.max(3) } else { degree + 1 };
        if count < least {
            return Err(Error::Invalid {
                what: "points to interpolate",
                why: format!("degree {degree} needs at least {least} in its direction, got {count}"),
            });
        }
        let t = &parameters;
        let mut knots;
        if periodic {
            if degree.is_multiple_of(2) {
                return Err(Error::Unsupported("periodic interpolation of even degree"));
            }
            let outer = degree - 1;
            knots = vec![0.0; outer];
            knots.extend_from_slice(t);
            knots.extend(std::iter::repeat_n(0.0, outer));
            make_knots_periodic(degree, &mut knots);
        } else {
            // Knots are means of `degree` parameters (P&T, *The NURBS Book*, eq. 9.8).
            let (first, last) = (t[0], t[count - 1]);
            knots = vec![first; degree];
            knots.extend((1..count - degree).map(|i| t[i..i + degree].iter().sum::<f64>() / degree as f64));
            knots.extend(std::iter::repeat_n(last, degree));
        }
        Ok(Self { degree, periodic, parameters, knots })
    }

    /// The control points of the line through `points`.
    pub(super) fn solve(&self, points: &[[f64; 3]]) -> Result<Vec<[f64; 3]>> {
        let (n, p) = (points.len(), self.degree);
        let mut values = [0.0; MAX_DEGREE + 1];
        // In a periodic line unknown i is control point i + (degree − 1)/2, which acts most at point i; folding
        // 0, n − 1, 1, n − 2, … makes the cyclic band an ordinary one.
        let shift = if self.periodic { (p - 1) / 2 } else { 0 };
        let fold = |i: usize| match (self.periodic, 2 * i < n) {
            (false, _) => i,
            (true, true) => 2 * i,
            (true, false) => 2 * (n - 1 - i) + 1,
        };
        let half = if self.periodic { (2 * shift + 3).min(n) } else { p };
        let mut system = Banded::new(n, half, vec![[0.0; 3]; n])?;
        for (i, &point) in points.iter().enumerate() {
            let t = self.parameters.get(i).copied().unwrap_or(f64::NAN);
            let j = span_index(&self.knots, p, t, !self.periodic && i + 1 == n);
            basis(p, &self.knots, j, t, &mut values);
            for (k, &value) in values.iter().enumerate().take(p + 1) {
                if value != 0.0 {
                    let column = if self.periodic { fold((j + k + n - shift) % n) } else { j + k };
                    system.add(fold(i), column, value);
                }
            }
            system.set_right(fold(i), point);
        }
        let solved =
            system.solve().ok_or(Error::degenerate("points", "the interpolation has no solution"))?;
        if !self.periodic {
            return Ok(solved);
        }
        Ok((0..n + p).filter_map(|i| solved.get(fold((i + n - shift) % n)).copied()).collect())
    }

    fn control_count(&self, count: usize) -> usize {
        if self.periodic { count + self.degree } else { count }
    }
}

/// The parameters of the points of all `lines`: means of each line's own, as shares of its length, times the mean
/// length (P&T, algorithm A9.3). Lines without length are left out.
fn parameters(lines: &[Point3], count: usize, periodic: bool, spacing: KnotSpacing) -> Result<Vec<f64>> {
    let steps = if periodic { count } else { count - 1 };
    if spacing == KnotSpacing::Uniform {
        return Ok((0..=steps).map(|i| i as f64).collect());
    }
    let (mut shares, mut length, mut used) = (vec![0.0; steps], 0.0, 0.0);
    for line in lines.chunks(count) {
        let next = line.iter().cycle().skip(1);
        let chords: Vec<f64> = line
            .iter()
            .zip(next)
            .take(steps)
            .map(|(a, b)| {
                let chord = a.distance_to(*b);
                if spacing == KnotSpacing::SquareRootChord { chord.sqrt() } else { chord }
            })
            .collect();
        let total: f64 = chords.iter().sum();
        if total > 0.0 && total.is_finite() {
            for (share, chord) in shares.iter_mut().zip(&chords) {
                *share += chord / total;
            }
            (length, used) = (length + total, used + 1.0);
        }
    }
    if used == 0.0 {
        return Err(Error::degenerate("points", "no line of them has a length"));
    }
    let mut t = 0.0;
    let mut out = vec![0.0];
    for share in shares {
        let step = share * (length / used) / used;
        if !(t + step > t + KNOT_STEP * t.abs()) {
            return Err(Error::degenerate("points", "two neighbouring lines of them coincide"));
        }
        t += step;
        out.push(t);
    }
    Ok(out)
}

impl NurbsSurface {
    /// The surface of given degrees through a grid of points, v running fastest; closed and smooth in the directions
    /// that `periodic` marks, whose first line of points is then not repeated at the end.
    ///
    /// A direction has as many control points as points (and `degree` more where it is periodic), with averaged
    /// knots (P&T, *The NURBS Book*, algorithm A9.4). Its parameters are those of its lines on the average.
    ///
    /// # Errors
    /// The points are no such grid or not finite; too few for the degree; two neighbouring lines of them coincide;
    /// a periodic direction of even degree.
    pub fn interpolate(
        degrees: [usize; 2],
        counts: [usize; 2],
        points: &[Point3],
        spacing: KnotSpacing,
        periodic: [bool; 2],
    ) -> Result<Self> {
        let [tu, tv] = Self::interpolation_parameters(counts, points, spacing, periodic)?;
        let u = Lines::new(degrees[0], periodic[0], counts[0], tu)?;
        let v = Lines::new(degrees[1], periodic[1], counts[1], tv)?;
        let all = [u.control_count(counts[0]), v.control_count(counts[1])];
        let start: Vec<[f64; 3]> = points.iter().map(|&p| p.into()).collect();
        let mut rows = Vec::with_capacity(counts[0] * all[1]);
        for row in start.chunks(counts[1]) {
            rows.extend(v.solve(row)?);
        }
        let mut columns = Vec::with_capacity(all[0] * all[1]);
        for column in transposed(&rows, all[1]).chunks(counts[0]) {
            columns.extend(u.solve(column)?);
        }
        let net = transposed(&columns, all[0]).into_iter().map(Point3::from).collect();
        Self::new(degrees, all, net, [u.knots, v.knots])
    }

    /// The parameters at which [`NurbsSurface::interpolate`] takes on its points, in u and in v: point (i, j) at the
    /// i-th and the j-th. In a periodic direction there is one more, where the surface closes.
    ///
    /// # Errors
    /// The points are no such grid or not finite, or two neighbouring lines of them coincide.
    pub fn interpolation_parameters(
        counts: [usize; 2],
        points: &[Point3],
        spacing: KnotSpacing,
        periodic: [bool; 2],
    ) -> Result<[Vec<f64>; 2]> {
        check_grid(counts, points.len())?;
        if !points.iter().all(|p| p.is_finite()) {
            return Err(Error::NotFinite("point to interpolate"));
        }
        if counts[0] < 2 || counts[1] < 2 {
            return Err(Error::Invalid {
                what: "points to interpolate",
                why: format!("a grid must be at least 2 by 2, not {} by {}", counts[0], counts[1]),
            });
        }
        let along_u = transposed(points, counts[1]);
        Ok([
            parameters(&along_u, counts[0], periodic[0], spacing)?,
            parameters(points, counts[1], periodic[1], spacing)?,
        ])
    }
}
