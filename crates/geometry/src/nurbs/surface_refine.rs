//! Knots, degree and pieces of surfaces: every line of control points in a direction is treated as a curve's.

use super::blossom::{over_knots, raised};
use super::curve::Controls;
use super::evaluate::de_boor;
use super::knots::{MAX_DEGREE, span_index};
use super::refine::{make_knots_periodic, map_controls};
use super::surface::{Direction, check_net};
use super::{NurbsCurve, NurbsSurface};
use crate::nurbs::thresholds::SAME_KNOT;
use crate::thresholds;
use crate::{Error, Interval, Result};

/// The grid with rows and columns exchanged; `columns` is the length of a row.
pub(crate) fn transposed<T: Copy>(points: &[T], columns: usize) -> Vec<T> {
    let mut out = Vec::with_capacity(points.len());
    for column in 0..columns {
        out.extend(points.iter().skip(column).step_by(columns));
    }
    out
}

/// Applies a function to each line of points along a direction.
fn lines<const N: usize>(
    points: &[[f64; N]],
    counts: [usize; 2],
    direction: Direction,
    f: impl Fn(&[[f64; N]]) -> Option<Vec<[f64; N]>>,
) -> Option<Vec<[f64; N]>> {
    let apply = |points: &[[f64; N]], length: usize| {
        let mut out = Vec::with_capacity(points.len());
        for line in points.chunks(length) {
            out.extend(f(line)?);
        }
        Some(out)
    };
    match direction {
        Direction::V => apply(points, counts[1]),
        Direction::U => {
            let done = apply(&transposed(points, counts[1]), counts[0])?;
            let length = done.len() / counts[1];
            Some(transposed(&done, length))
        }
    }
}

impl NurbsSurface {
    /// The same surface over other knots in one direction, of the same degree or one higher.
    fn over(&self, direction: Direction, degree: usize, new_knots: Vec<f64>) -> Result<Self> {
        let mut counts = self.counts;
        counts[direction.index()] = (new_knots.len() + 1).saturating_sub(degree);
        check_net(counts)?;
        let (old, knots) = (self.degree(direction), self.knots(direction));
        let controls = if degree == old {
            map_controls(
                &self.controls,
                |p| lines(p, self.counts, direction, |line| over_knots(old, knots, line, &new_knots)),
                |p| lines(p, self.counts, direction, |line| over_knots(old, knots, line, &new_knots)),
            )
        } else {
            map_controls(
                &self.controls,
                |p| lines(p, self.counts, direction, |line| raised(old, knots, line, &new_knots)),
                |p| lines(p, self.counts, direction, |line| raised(old, knots, line, &new_knots)),
            )
        };
        let controls = controls.ok_or(Error::degenerate("knot vector", "a control point acts on no span"))?;
        self.with_line(direction, degree, new_knots, controls)
    }

    /// The surface with one direction's degree, knots and so count replaced, together with all control points.
    pub(crate) fn with_line(
        &self,
        direction: Direction,
        degree: usize,
        new_knots: Vec<f64>,
        controls: Controls,
    ) -> Result<Self> {
        let (mut degrees, mut counts, mut knots) = (self.degrees, self.counts, self.knots.clone());
        degrees[direction.index()] = degree;
        counts[direction.index()] = (new_knots.len() + 1).saturating_sub(degree);
        knots[direction.index()] = new_knots;
        Self::from_controls(degrees, counts, controls, knots)
    }

    /// A parameter so near to a knot that nothing could tell them apart becomes that knot.
    pub(crate) fn snapped(&self, direction: Direction, t: f64) -> f64 {
        let domain = self.domain(direction);
        let tolerance = SAME_KNOT * domain.start.abs().max(domain.end.abs()).max(thresholds::LEAST_DIVISOR);
        let knots = self.knots(direction);
        let first = knots.partition_point(|&k| t - k > tolerance);
        knots.get(first).copied().filter(|k| (k - t).abs() <= tolerance).unwrap_or(t)
    }

    /// The same surface with the knot `t` repeated `multiplicity` times at least in one direction. A surface that is
    /// periodic in it stays so.
    ///
    /// By blossoming along each line of control points; the classic way is W. Boehm, *Inserting new knots into
    /// B-spline curves*, CAD 12 (1980).
    ///
    /// # Errors
    /// `t` is outside the domain, or the multiplicity is above the degree.
    pub fn insert_knot(&self, direction: Direction, t: f64, multiplicity: usize) -> Result<Self> {
        let (degree, domain) = (self.degree(direction), self.domain(direction));
        let t = self.snapped(direction, t);
        if !domain.contains(t) {
            return Err(Error::OutOfRange { what: "knot", value: t, must: "inside the surface's domain" });
        }
        if multiplicity > degree {
            return Err(Error::OutOfRange {
                what: "knot multiplicity",
                value: multiplicity as f64,
                must: "at most the degree",
            });
        }
        let mut knots = self.knots(direction).to_vec();
        let present = knots.iter().filter(|&&k| k == t).count();
        if present >= multiplicity {
            return Ok(self.clone());
        }
        if t == domain.start || t == domain.end {
            return self.clamped(direction);
        }
        let at = knots.partition_point(|&k| k < t);
        knots.splice(at..at, std::iter::repeat_n(t, multiplicity - present));
        if self.is_periodic(direction) {
            make_knots_periodic(degree, &mut knots);
        }
        self.over(direction, degree, knots)
    }

    /// The same surface with all of `parameters` as further knots of one direction, each as often as it is listed.
    /// Ends are clamped.
    ///
    /// # Errors
    /// A parameter is not strictly inside the domain, or a knot's multiplicity would be above the degree.
    pub fn refined(&self, direction: Direction, parameters: &[f64]) -> Result<Self> {
        let (degree, domain) = (self.degree(direction), self.domain(direction));
        let mut knots = clamped_knots(self.knots(direction), degree);
        for &t in parameters {
            let t = self.snapped(direction, t);
            if !(domain.start < t && t < domain.end) {
                return Err(Error::OutOfRange {
                    what: "knot",
                    value: t,
                    must: "strictly inside the surface's domain",
                });
            }
            knots.push(t);
        }
        knots.sort_by(f64::total_cmp);
        super::knots::check_knots(degree, (knots.len() + 1).saturating_sub(degree), &knots)?;
        self.over(direction, degree, knots)
    }

    /// The same surface with full knot multiplicity at both ends of one direction, so that it begins and ends in
    /// control points.
    ///
    /// # Errors
    /// A new control point is not finite.
    pub fn clamped(&self, direction: Direction) -> Result<Self> {
        let degree = self.degree(direction);
        self.over(direction, degree, clamped_knots(self.knots(direction), degree))
    }

    /// The same surface with a higher degree in one direction; every knot of it becomes as much more multiple. Ends
    /// are clamped first. A degree that is not higher changes nothing.
    ///
    /// # Errors
    /// The degree wanted is above 31.
    pub fn raised_to(&self, direction: Direction, degree: usize) -> Result<Self> {
        if degree > MAX_DEGREE {
            return Err(Error::OutOfRange { what: "degree", value: degree as f64, must: "from 1 to 31" });
        }
        if degree <= self.degree(direction) {
            return Ok(self.clone());
        }
        let mut surface = self.clamped(direction)?;
        while surface.degree(direction) < degree {
            let old = surface.knots(direction);
            let mut knots = Vec::with_capacity(2 * old.len());
            for (i, &k) in old.iter().enumerate() {
                knots.push(k);
                if old.get(i + 1) != Some(&k) {
                    knots.push(k);
                }
            }
            surface = surface.over(direction, surface.degree(direction) + 1, knots)?;
        }
        Ok(surface)
    }

    /// The part over a range of one parameter, clamped at its ends, with its part of the domain.
    ///
    /// # Errors
    /// The range does not increase or leaves the domain.
    pub fn trimmed(&self, direction: Direction, range: Interval) -> Result<Self> {
        let domain = self.domain(direction);
        let (a, b) = (self.snapped(direction, range.start), self.snapped(direction, range.end));
        if !(a < b && domain.start <= a && b <= domain.end) {
            return Err(Error::Invalid {
                what: "trim range",
                why: format!(
                    "{} to {} is not an increasing part of {} to {}",
                    range.start, range.end, domain.start, domain.end
                ),
            });
        }
        self.between(direction, a, b)
    }

    /// The surface continued by the polynomials of its outermost spans to a larger range of one parameter.
    ///
    /// # Errors
    /// The range does not hold the domain, or a weight of the continuation is not greater than 0.
    pub fn extended(&self, direction: Direction, range: Interval) -> Result<Self> {
        let domain = self.domain(direction);
        if !(range.is_increasing() && range.start <= domain.start && domain.end <= range.end) {
            return Err(Error::Invalid {
                what: "extension",
                why: format!(
                    "{} to {} does not hold {} to {}",
                    range.start, range.end, domain.start, domain.end
                ),
            });
        }
        let degree = self.degree(direction);
        let mut knots = clamped_knots(self.knots(direction), degree);
        let n = knots.len();
        knots[..degree].fill(range.start);
        knots[n - degree..].fill(range.end);
        self.over(direction, degree, knots)
    }

    fn between(&self, direction: Direction, a: f64, b: f64) -> Result<Self> {
        let degree = self.degree(direction);
        let inside = self.knots(direction).iter().copied().filter(|&k| a < k && k < b);
        let ends = |t: f64| std::iter::repeat_n(t, degree);
        self.over(direction, degree, ends(a).chain(inside).chain(ends(b)).collect())
    }

    /// The parts before and after `t` in one direction.
    ///
    /// # Errors
    /// `t` is not inside the domain.
    pub fn split(&self, direction: Direction, t: f64) -> Result<(Self, Self)> {
        let domain = self.domain(direction);
        Ok((
            self.trimmed(direction, Interval::new(domain.start, t))?,
            self.trimmed(direction, Interval::new(t, domain.end))?,
        ))
    }

    /// The exact curve along which `direction` varies while the other parameter stays at `constant`; rational where
    /// the surface is, over the same knots.
    ///
    /// # Errors
    /// `constant` is not a number, or so far outside the domain that a weight is not greater than 0.
    pub fn isocurve(&self, direction: Direction, constant: f64) -> Result<NurbsCurve> {
        if !constant.is_finite() {
            return Err(Error::NotFinite("isocurve parameter"));
        }
        let across = direction.other();
        let (degree, knots) = (self.degree(across), self.knots(across));
        let j = span_index(knots, degree, constant, false);
        let value = |line: &[[f64; 3]]| Some(vec![de_boor(degree, knots, line, j, constant)]);
        let value4 = |line: &[[f64; 4]]| Some(vec![de_boor(degree, knots, line, j, constant)]);
        let controls = map_controls(
            &self.controls,
            |p| lines(p, self.counts, across, value),
            |p| lines(p, self.counts, across, value4),
        )
        .ok_or(Error::degenerate("isocurve", "it has no control points"))?;
        NurbsCurve::from_controls(self.degree(direction), controls, self.knots(direction).to_vec())
    }

    /// The same surface with every knot of full multiplicity, in both directions: its control points are those of
    /// its Bézier patches.
    ///
    /// # Errors
    /// A new control point is not finite.
    pub fn piecewise_bezier(&self) -> Result<Self> {
        let mut surface = self.clone();
        for direction in Direction::BOTH {
            let degree = self.degree(direction);
            let spans = self.span_parameters(direction);
            let knots = spans.iter().flat_map(|&t| std::iter::repeat_n(t, degree)).collect();
            surface = surface.over(direction, degree, knots)?;
        }
        Ok(surface)
    }

    /// The polynomial pieces as Bézier surfaces, each over its own part of the domain, v running fastest.
    ///
    /// # Errors
    /// As [`NurbsSurface::piecewise_bezier`].
    pub fn bezier_patches(&self) -> Result<Vec<Self>> {
        let whole = self.piecewise_bezier()?;
        let [p, q] = self.degrees;
        let [us, vs] = Direction::BOTH.map(|d| self.span_parameters(d));
        let mut patches = Vec::with_capacity(us.len().saturating_sub(1) * vs.len().saturating_sub(1));
        for (i, u) in us.windows(2).enumerate() {
            for (j, v) in vs.windows(2).enumerate() {
                let ends = |w: &[f64], degree: usize| {
                    w.iter().flat_map(|&t| std::iter::repeat_n(t, degree)).collect::<Vec<_>>()
                };
                let part = [i * p, i * p + p + 1, j * q, j * q + q + 1];
                let controls = match &whole.controls {
                    Controls::Plain(points) => Controls::Plain(window(points, whole.counts[1], part)),
                    Controls::Rational(points) => Controls::Rational(window(points, whole.counts[1], part)),
                };
                let knots = [ends(u, p), ends(v, q)];
                patches.push(Self::from_controls(self.degrees, [p + 1, q + 1], controls, knots)?);
            }
        }
        Ok(patches)
    }
}

/// Rows `r0..r1` and columns `c0..c1` of a grid.
fn window<T: Copy>(points: &[T], columns: usize, [r0, r1, c0, c1]: [usize; 4]) -> Vec<T> {
    let mut out = Vec::with_capacity((r1 - r0) * (c1 - c0));
    for row in r0..r1 {
        out.extend_from_slice(points.get(row * columns + c0..row * columns + c1).unwrap_or(&[]));
    }
    out
}

fn clamped_knots(knots: &[f64], degree: usize) -> Vec<f64> {
    let mut out = knots.to_vec();
    let n = out.len();
    let (start, end) = (out[degree - 1], out[n - degree]);
    out[..degree].fill(start);
    out[n - degree..].fill(end);
    out
}
