//! The curve of given knots that comes nearest to points, in the sense of least squares.

use super::evaluate::{basis, derivatives};
use super::knots::{MAX_DEGREE, check_knots, span_index};
use super::refine::make_knots_periodic;
use super::{KnotSpacing, NurbsCurve};
use crate::linear::Banded;
use crate::nurbs::thresholds::{LEAST_CHORD, NO_PIVOT};
use crate::{Error, Interval, Point3, Result, Vector3};

/// A point or derivative that a least-squares curve must have exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExactCondition {
    /// Where, inside the domain.
    pub parameter: f64,
    /// 0 for the point, 1 for the first derivative, and so on up to the degree.
    pub order: usize,
    /// The point (as a vector from the origin) or the derivative.
    pub value: Vector3,
}

/// What a least-squares curve heeds beside its points.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LeastSquares<'a> {
    /// How much each point counts, 0 or more; all alike when not given.
    pub weights: Option<&'a [f64]>,
    /// The curve need not start in the first and end in the last point.
    pub free_ends: bool,
    /// The first derivative at the start.
    pub start_derivative: Option<Vector3>,
    /// The first derivative at the end.
    pub end_derivative: Option<Vector3>,
    /// More that must hold exactly.
    pub exact: &'a [ExactCondition],
}

impl KnotSpacing {
    /// Increasing parameters for points, from 0 to 1; points that repeat the one before get a parameter a little
    /// larger.
    pub fn parameters(self, points: &[Point3]) -> Vec<f64> {
        let steps: Vec<f64> = points
            .windows(2)
            .map(|w| match self {
                Self::Uniform => 1.0,
                Self::Chord => w[0].distance_to(w[1]),
                Self::SquareRootChord => w[0].distance_to(w[1]).sqrt(),
            })
            .collect();
        let sum: f64 = steps.iter().sum();
        let least = if sum > 0.0 { LEAST_CHORD * sum } else { 1.0 };
        let steps: Vec<f64> = steps.iter().map(|s| s.max(least)).collect();
        let total: f64 = steps.iter().sum();
        let mut t = 0.0;
        let mut out = Vec::with_capacity(points.len());
        out.push(0.0);
        for s in &steps {
            t += s;
            out.push(t / total);
        }
        if let (Some(last), true) = (out.last_mut(), points.len() > 1) {
            *last = 1.0;
        }
        out
    }
}

/// Clamped knots for `count` control points such that every span holds parameters of points (P&T, *The NURBS Book*,
/// eq. 9.68 and 9.69).
///
/// # Errors
/// The degree is not 1…31, there are fewer than degree + 1 control points or fewer parameters than control points,
/// or the parameters do not increase.
pub fn placed_knots(degree: usize, count: usize, parameters: &[f64]) -> Result<Vec<f64>> {
    super::uniform::clamped_uniform_knots(degree, count)?;
    check_parameters(parameters)?;
    if parameters.len() < count {
        return Err(Error::Invalid {
            what: "points to fit",
            why: format!("{count} control points need at least as many points, got {}", parameters.len()),
        });
    }
    let (first, last) = (parameters[0], parameters[parameters.len() - 1]);
    let step = parameters.len() as f64 / (count - degree) as f64;
    let mut knots = vec![first; degree];
    for j in 1..count - degree {
        let place = j as f64 * step;
        let i = (place as usize).clamp(1, parameters.len() - 1);
        let a = place - place.floor();
        knots.push((1.0 - a) * parameters[i - 1] + a * parameters[i]);
    }
    knots.extend(std::iter::repeat_n(last, degree));
    Ok(knots)
}

fn check_parameters(parameters: &[f64]) -> Result<()> {
    if !parameters.iter().all(|t| t.is_finite()) {
        return Err(Error::NotFinite("parameter of a point"));
    }
    if parameters.len() < 2
        || parameters.windows(2).any(|w| w[0] > w[1])
        || parameters.first() == parameters.last()
    {
        return Err(Error::Invalid { what: "parameters of points", why: "they must increase".into() });
    }
    Ok(())
}

impl NurbsCurve {
    /// The non-rational curve of a degree and knots (openNURBS form) whose points at `parameters` are nearest to
    /// `points`: the sum of weighted squared distances is least. Unless [`LeastSquares::free_ends`] is set it starts
    /// in the first and ends in the last point; the knots must be clamped for that.
    ///
    /// Normal equations, banded, with Lagrange multipliers for what must be exact (P&T, *The NURBS Book*, §9.4 and
    /// algorithms A9.6 and A9.7).
    ///
    /// # Errors
    /// Knots or parameters that do not fit or do not increase, counts that differ, weights below 0, numbers that are
    /// not finite, or a system without a unique solution: some control point has too few points in its support, or
    /// exact conditions contradict each other.
    pub fn least_squares(
        degree: usize,
        knots: &[f64],
        points: &[Point3],
        parameters: &[f64],
        options: &LeastSquares<'_>,
    ) -> Result<Self> {
        let n = (knots.len() + 1).saturating_sub(degree);
        check_knots(degree, n, knots)?;
        check_points(points, parameters, options.weights)?;
        check_parameters(parameters)?;
        let clamped = knots[0] == knots[degree - 1] && knots[knots.len() - degree] == knots[knots.len() - 1];
        let derivatives_given = options.start_derivative.is_some() || options.end_derivative.is_some();
        if !clamped && (!options.free_ends || derivatives_given) {
            return Err(Error::Invalid {
                what: "knots of the fit",
                why: "fixed ends and end derivatives need full multiplicity at the ends".into(),
            });
        }
        // Control points that are known: the ends, and with a derivative their neighbours.
        let mut fixed: Vec<Option<Vector3>> = vec![None; n];
        if !options.free_ends {
            fixed[0] = points.first().map(|p| p.to_vector());
            fixed[n - 1] = points.last().map(|p| p.to_vector());
        }
        let mut exact: Vec<ExactCondition> = options.exact.to_vec();
        for (at_end, d) in [(false, options.start_derivative), (true, options.end_derivative)] {
            let Some(d) = d else { continue };
            if !d.is_finite() {
                return Err(Error::NotFinite("end derivative"));
            }
            let (end, next, sign) = if at_end { (n - 1, n - 2, -1.0) } else { (0, 1, 1.0) };
            let width = if at_end {
                knots[knots.len() - degree] - knots[knots.len() - degree - 1]
            } else {
                knots[degree] - knots[degree - 1]
            };
            match fixed[end] {
                Some(p) if fixed[next].is_none() => {
                    fixed[next] = Some(p + d * (sign * width / degree as f64))
                }
                _ => {
                    let parameter = if at_end { knots[knots.len() - 1] } else { knots[0] };
                    exact.push(ExactCondition { parameter, order: 1, value: d });
                }
            }
        }
        let domain = Interval::new(knots[degree - 1], knots[n - 1]);
        let mut system = Rows::new(n, degree, fixed);
        let mut values = [0.0; MAX_DEGREE + 1];
        for (i, (p, &t)) in points.iter().zip(parameters).enumerate() {
            if !domain.contains(t) {
                return Err(Error::OutOfRange {
                    what: "parameter",
                    value: t,
                    must: "inside the knots' domain",
                });
            }
            let weight = options.weights.and_then(|w| w.get(i)).copied().unwrap_or(1.0);
            let j = span_index(knots, degree, t, t >= domain.end);
            basis(degree, knots, j, t, &mut values);
            system.add(j, &values[..=degree], p.to_vector(), weight);
        }
        let solved = system.solve(knots, &exact)?;
        Self::new(degree, solved, knots.to_vec())
    }

    /// The periodic curve with uniform knots over a domain, `count` different control points, whose points at
    /// `parameters` are nearest to `points` in the sense of least squares.
    ///
    /// # Errors
    /// Fewer than three control points or than the degree + 1, counts that differ, parameters outside the domain, or
    /// points that leave a control point undetermined.
    pub fn least_squares_periodic(
        degree: usize,
        count: usize,
        domain: Interval,
        points: &[Point3],
        parameters: &[f64],
    ) -> Result<Self> {
        let least = 3.max(degree + 1);
        if !(2..=MAX_DEGREE).contains(&degree) {
            return Err(Error::OutOfRange { what: "degree", value: degree as f64, must: "from 2 to 31" });
        }
        if count < least || count > 1_000_000 {
            return Err(Error::OutOfRange {
                what: "control points of a periodic curve",
                value: count as f64,
                must: "at least 3, more than the degree, and at most a million",
            });
        }
        if !domain.is_increasing() {
            return Err(Error::Invalid { what: "domain", why: "it does not increase".into() });
        }
        check_points(points, parameters, None)?;
        let mut knots = vec![0.0; count + 2 * degree - 1];
        for i in 0..=count {
            knots[degree - 1 + i] = domain.at(i as f64 / count as f64);
        }
        make_knots_periodic(degree, &mut knots);
        // Folding 0, n−1, 1, n−2, … makes the cyclic band an ordinary one of twice the width.
        let fold = |i: usize| if 2 * i < count { 2 * i } else { 2 * (count - 1 - i) + 1 };
        let mut system = Banded::new(count, (2 * degree + 1).min(count), vec![[0.0; 3]; count])?;
        let mut right = vec![Vector3::ZERO; count];
        let mut values = [0.0; MAX_DEGREE + 1];
        for (p, &t) in points.iter().zip(parameters) {
            if !domain.contains(t) {
                return Err(Error::OutOfRange { what: "parameter", value: t, must: "inside the domain" });
            }
            let j = span_index(&knots, degree, t, t >= domain.end);
            basis(degree, &knots, j, t, &mut values);
            for (a, &x) in values.iter().enumerate().take(degree + 1) {
                let row = (j + a) % count;
                right[row] += p.to_vector() * x;
                for (b, &y) in values.iter().enumerate().take(degree + 1) {
                    system.add(fold(row), fold((j + b) % count), x * y);
                }
            }
        }
        for (i, v) in right.iter().enumerate() {
            system.set_right(fold(i), (*v).into());
        }
        let solved = system.solve().ok_or_else(undetermined)?;
        let points = (0..count + degree).map(|i| solved[fold(i % count)].into()).collect();
        Self::new(degree, points, knots)
    }
}

fn undetermined() -> Error {
    Error::degenerate("points to fit", "they do not determine the curve: a control point has too few near it")
}

fn check_points(points: &[Point3], parameters: &[f64], weights: Option<&[f64]>) -> Result<()> {
    if points.len() != parameters.len() || weights.is_some_and(|w| w.len() != points.len()) {
        return Err(Error::Invalid {
            what: "points to fit",
            why: format!(
                "{} points, {} parameters, {:?} weights",
                points.len(),
                parameters.len(),
                weights.map(<[f64]>::len)
            ),
        });
    }
    if points.len() < 2 {
        return Err(Error::Invalid { what: "points to fit", why: "there must be at least 2".into() });
    }
    if !points.iter().all(|p| p.is_finite()) {
        return Err(Error::NotFinite("point to fit"));
    }
    if let Some(w) = weights.into_iter().flatten().find(|w| !(w.is_finite() && **w >= 0.0)) {
        return Err(Error::OutOfRange { what: "weight of a point", value: *w, must: "finite and 0 or more" });
    }
    Ok(())
}

/// The normal equations while they grow.
struct Rows {
    degree: usize,
    fixed: Vec<Option<Vector3>>,
    /// Entry (i, i + k) of the symmetric matrix at `upper[i][k]`.
    upper: Vec<Vec<f64>>,
    right: Vec<Vector3>,
}

impl Rows {
    fn new(n: usize, degree: usize, fixed: Vec<Option<Vector3>>) -> Self {
        Self { degree, fixed, upper: vec![vec![0.0; degree + 1]; n], right: vec![Vector3::ZERO; n] }
    }

    /// Adds one observation: the sum of `values` times control points from `first` on should be `target`.
    fn add(&mut self, first: usize, values: &[f64], target: Vector3, weight: f64) {
        let mut rest = target;
        for (k, &x) in values.iter().enumerate() {
            if let Some(p) = self.fixed[first + k] {
                rest -= p * x;
            }
        }
        for (a, &x) in values.iter().enumerate() {
            if self.fixed[first + a].is_some() {
                continue;
            }
            self.right[first + a] += rest * (weight * x);
            for (b, &y) in values.iter().enumerate().skip(a) {
                if self.fixed[first + b].is_none() {
                    self.upper[first + a][b - a] += weight * x * y;
                }
            }
        }
    }

    fn system(&self, right: Vec<[f64; 3]>) -> Option<Vec<[f64; 3]>> {
        let mut system = Banded::new(self.upper.len(), self.degree, right).ok()?;
        for (i, row) in self.upper.iter().enumerate() {
            if self.fixed[i].is_some() {
                system.add(i, i, 1.0);
                continue;
            }
            for (k, &x) in row.iter().enumerate() {
                system.add(i, i + k, x);
                if k > 0 {
                    system.add(i + k, i, x);
                }
            }
        }
        system.solve()
    }

    fn solve(self, knots: &[f64], exact: &[ExactCondition]) -> Result<Vec<Point3>> {
        let n = self.upper.len();
        // A control point that no observation reaches is undetermined however the elimination rounds.
        let most = self.upper.iter().map(|r| r[0]).fold(0.0, f64::max);
        if self.upper.iter().zip(&self.fixed).any(|(r, f)| f.is_none() && !(r[0] > NO_PIVOT * most)) {
            return Err(undetermined());
        }
        let right: Vec<[f64; 3]> = (0..n).map(|i| self.fixed[i].unwrap_or(self.right[i]).into()).collect();
        let mut solution = self.system(right).ok_or_else(undetermined)?;
        if !exact.is_empty() {
            self.satisfy(knots, exact, &mut solution)?;
        }
        Ok(solution.into_iter().map(Point3::from).collect())
    }

    /// Moves the solution to where the conditions hold, at the least cost: P − A⁻¹Mᵀ(MA⁻¹Mᵀ)⁻¹(MP − T).
    fn satisfy(&self, knots: &[f64], exact: &[ExactCondition], solution: &mut [[f64; 3]]) -> Result<()> {
        let (n, m, degree) = (self.upper.len(), exact.len(), self.degree);
        if m > n {
            return Err(Error::degenerate("exact conditions", "there are more of them than control points"));
        }
        let domain = Interval::new(knots[degree - 1], knots[n - 1]);
        let mut rows: Vec<(usize, Vec<f64>)> = Vec::with_capacity(m);
        for c in exact {
            if !(domain.contains(c.parameter) && c.value.is_finite() && c.order <= degree) {
                return Err(Error::OutOfRange {
                    what: "parameter of an exact condition",
                    value: c.parameter,
                    must: "inside the domain, with a finite value and an order up to the degree",
                });
            }
            let j = span_index(knots, degree, c.parameter, c.parameter >= domain.end);
            // The derivatives of the basis functions: those of curves with one control number 1 and the others 0.
            let row = (0..=degree)
                .map(|k| {
                    let mut unit = vec![[0.0; 1]; j + degree + 1];
                    unit[j + k] = [1.0];
                    let mut out = [[0.0; 1]; MAX_DEGREE + 1];
                    derivatives(degree, knots, &unit, j, c.parameter, &mut out[..=c.order]);
                    out[c.order][0]
                })
                .collect();
            rows.push((j, row));
        }
        // Columns of A⁻¹Mᵀ, three at a time.
        let mut columns: Vec<Vec<f64>> = Vec::with_capacity(m);
        for group in rows.chunks(3) {
            let mut right = vec![[0.0; 3]; n];
            for (slot, (j, row)) in group.iter().enumerate() {
                for (k, &x) in row.iter().enumerate() {
                    if self.fixed[j + k].is_none() {
                        right[j + k][slot] = x;
                    }
                }
            }
            let solved = self.system(right).ok_or_else(undetermined)?;
            for slot in 0..group.len() {
                columns.push(solved.iter().map(|v| v[slot]).collect());
            }
        }
        let apply = |(j, row): &(usize, Vec<f64>), column: &dyn Fn(usize) -> f64| -> f64 {
            row.iter().enumerate().map(|(k, &x)| x * column(j + k)).sum()
        };
        let missed = rows
            .iter()
            .zip(exact)
            .map(|(row, c)| {
                let wanted: [f64; 3] = c.value.into();
                std::array::from_fn(|d| apply(row, &|i| solution[i][d]) - wanted[d])
            })
            .collect();
        let mut small = Banded::new(m, m, missed)?;
        for (i, row) in rows.iter().enumerate() {
            for (k, column) in columns.iter().enumerate() {
                let free = |i: usize| if self.fixed[i].is_none() { column[i] } else { 0.0 };
                small.add(i, k, apply(row, &free));
            }
        }
        let contradiction = Error::degenerate("exact conditions", "they contradict each other or fixed ends");
        let multipliers = small.solve().ok_or_else(|| contradiction.clone())?;
        if !multipliers.iter().flatten().all(|x| x.is_finite()) {
            return Err(contradiction);
        }
        for (column, l) in columns.iter().zip(&multipliers) {
            for (i, p) in solution.iter_mut().enumerate() {
                if self.fixed[i].is_none() {
                    for d in 0..3 {
                        p[d] -= column[i] * l[d];
                    }
                }
            }
        }
        Ok(())
    }
}
