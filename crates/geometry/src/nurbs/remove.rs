//! Knots taken out again: the same curve, or one within a tolerance, with fewer control points.

use super::NurbsCurve;
use super::curve::Controls;
use super::deviation::Approximation;
use crate::nurbs::thresholds::REMOVAL_ROUNDING;
use crate::{Error, Result};

type Point = [f64; 4];

/// The curve in the textbook form, moved to around the origin: homogeneous bounds grow with the coordinates.
struct Work {
    degree: usize,
    knots: Vec<f64>,
    points: Vec<Point>,
    rational: bool,
    center: [f64; 3],
    /// The greatest distance of a control point from the origin.
    reach: f64,
}

/// One knot's removal, worked out.
struct Removal {
    /// The new control points from index `first` on; the one in the middle is left out.
    first: usize,
    points: Vec<Point>,
    /// How far the curve can move.
    bound: f64,
}

fn distance(a: &Point, b: &Point) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

impl Work {
    fn new(curve: &NurbsCurve) -> Self {
        let places = curve.control_points();
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for p in places.iter().map(|&p| <[f64; 3]>::from(p)) {
            for i in 0..3 {
                low[i] = low[i].min(p[i]);
                high[i] = high[i].max(p[i]);
            }
        }
        let center: [f64; 3] = std::array::from_fn(|i| 0.5 * low[i] + 0.5 * high[i]);
        let points = curve
            .homogeneous_points()
            .iter()
            .map(|p| [p[0] - center[0] * p[3], p[1] - center[1] * p[3], p[2] - center[2] * p[3], p[3]])
            .collect();
        let reach = distance(&[low[0], low[1], low[2], 0.0], &[high[0], high[1], high[2], 0.0]) * 0.5;
        let knots = curve.textbook_knots();
        Self { degree: curve.degree, knots, points, rational: curve.is_rational(), center, reach }
    }

    fn into_curve(self) -> Result<NurbsCurve> {
        let c = self.center;
        let back = |p: &Point| [p[0] + c[0] * p[3], p[1] + c[1] * p[3], p[2] + c[2] * p[3], p[3]];
        let knots = self.knots.get(1..self.knots.len().saturating_sub(1)).unwrap_or(&[]).to_vec();
        let controls = if self.rational {
            Controls::Rational(self.points.iter().map(back).collect())
        } else {
            let plain = |p: Point| [p[0], p[1], p[2]];
            Controls::Plain(self.points.iter().map(|p| plain(back(p))).collect())
        };
        NurbsCurve::from_controls(self.degree, controls, knots)
    }

    /// The removal of the knot at index r, the last of its `s` equal ones (P&T, *The NURBS Book*, algorithm A5.8 for
    /// one removal). The bound is theirs, with the weights after the removal: |C − Ĉ| ≤ B(1 + |C|)/ŵ for rational
    /// curves, B for others.
    fn removal(&self, r: usize, s: usize) -> Option<Removal> {
        let (p, u) = (self.degree, *self.knots.get(r)?);
        let (first, last) = (r.checked_sub(p)?, r.checked_sub(s)?);
        let off = first.checked_sub(1)?;
        let point = |i: usize| self.points.get(i);
        let ratio = |i: usize| -> Option<f64> {
            let (a, b) = (self.knots.get(i)?, self.knots.get(i + p + 1)?);
            Some((u - a) / (b - a))
        };
        let mut new = vec![[0.0; 4]; last + 2 - off];
        *new.first_mut()? = *point(off)?;
        *new.last_mut()? = *point(last + 1)?;
        let (mut i, mut j) = (first, last);
        let (mut low, mut high) = (1, last - off);
        while j > i {
            let (a, b) = (ratio(i)?, ratio(j)?);
            new[low] = std::array::from_fn(|c| (self.points[i][c] - (1.0 - a) * new[low - 1][c]) / a);
            new[high] = std::array::from_fn(|c| (self.points[j][c] - b * new[high + 1][c]) / (1.0 - b));
            i += 1;
            low += 1;
            j -= 1;
            high -= 1;
        }
        let step = if j < i {
            distance(&new[low - 1], &new[high + 1])
        } else {
            let a = ratio(i)?;
            let between: Point = std::array::from_fn(|c| a * new[low + 1][c] + (1.0 - a) * new[low - 1][c]);
            distance(point(i)?, &between)
        };
        // What is kept: all but the one in the middle, which is left out.
        let middle = (2 * r - s - p) / 2;
        let mut kept: Vec<Point> = new.get(1..new.len() - 1)?.to_vec();
        kept.remove(middle.checked_sub(first)?);
        let bound = if self.rational {
            let around = kept.iter().chain(self.points.get(off..=last + 1)?);
            let least = around.map(|p| p[3]).fold(f64::INFINITY, f64::min);
            if !(least > 0.0) {
                return None;
            }
            step * (1.0 + self.reach) / least
        } else {
            step
        };
        bound.is_finite().then_some(Removal { first, points: kept, bound })
    }

    fn apply(&mut self, r: usize, s: usize, removal: Removal) {
        let last = r - s;
        self.points.splice(removal.first..=last, removal.points);
        self.knots.remove(r);
    }

    /// Where the interior knots stand: the index of the last of equal ones, and how many there are.
    fn interior(&self) -> Vec<(usize, usize)> {
        let p = self.degree;
        let (start, end) = (self.knots[p], self.knots[self.knots.len() - p - 1]);
        let mut out = Vec::new();
        let mut i = p + 1;
        while i < self.knots.len() && self.knots[i] < end {
            let t = self.knots[i];
            let count = self.knots[i..].iter().take_while(|&&k| k == t).count();
            if t > start {
                out.push((i + count - 1, count));
            }
            i += count;
        }
        out
    }
}

impl NurbsCurve {
    /// The curve with the knot `t` taken out up to `times` times, as long as the curve moves by no more than
    /// `tolerance` in all, and how often that was possible. Ends are clamped first. P&T, algorithm A5.8; the bound is
    /// certified, so a removal that is possible may be missed on rational curves with very unequal weights.
    ///
    /// # Errors
    /// `t` is no knot inside the domain, or the tolerance is not 0 or more.
    pub fn remove_knot(&self, t: f64, times: usize, tolerance: f64) -> Result<(Self, usize)> {
        check_tolerance(tolerance)?;
        let curve = self.clamped()?;
        let (domain, t) = (curve.domain(), curve.snapped(t));
        if !(domain.start < t && t < domain.end && curve.multiplicity(t) > 0) {
            return Err(Error::OutOfRange { what: "knot", value: t, must: "a knot inside the domain" });
        }
        let mut work = Work::new(&curve);
        let (mut removed, mut spent) = (0, 0.0);
        while removed < times {
            let Some(&(r, s)) = work.interior().iter().find(|&&(r, _)| work.knots[r] == t) else { break };
            match work.removal(r, s) {
                Some(removal) if spent + removal.bound <= tolerance => {
                    spent += removal.bound;
                    work.apply(r, s, removal);
                    removed += 1;
                }
                _ => break,
            }
        }
        Ok((work.into_curve()?, removed))
    }

    /// The curve with every knot taken out whose absence moves it by no more than `tolerance`, cheapest first; the
    /// deviation is the certified bound of [`NurbsCurve::deviation_from`] and never above the tolerance. Tolerance 0
    /// takes out what is superfluous but for rounding (10⁻¹⁴ of the size). Ends are clamped first; end points stay.
    ///
    /// After W. Tiller, *Knot-removal algorithms for NURBS curves and surfaces*, CAD 24 (1992), with errors summed
    /// up span by span (P&T, algorithm A9.8).
    ///
    /// # Errors
    /// The tolerance is not 0 or more.
    pub fn remove_knots(&self, tolerance: f64) -> Result<Approximation> {
        self.remove_knots_keeping(tolerance, &[])
    }

    /// [`NurbsCurve::remove_knots`] that leaves given knots alone.
    pub(crate) fn remove_knots_keeping(&self, tolerance: f64, keep: &[f64]) -> Result<Approximation> {
        check_tolerance(tolerance)?;
        let curve = self.clamped()?;
        let start = Work::new(&curve);
        let mut allowed = tolerance
            .max(REMOVAL_ROUNDING * (start.reach + start.center.iter().map(|x| x.abs()).sum::<f64>()));
        for _ in 0..3 {
            let reduced = reduced(Work::new(&curve), allowed, keep).into_curve()?;
            let deviation = if reduced.point_count() == curve.point_count() {
                0.0
            } else {
                curve.deviation_from(&reduced)?
            };
            if deviation <= tolerance.max(allowed) {
                return Ok(Approximation { curve: reduced, deviation });
            }
            allowed *= 0.5;
        }
        Ok(Approximation { curve, deviation: 0.0 })
    }
}

fn check_tolerance(tolerance: f64) -> Result<()> {
    if tolerance >= 0.0 {
        Ok(())
    } else {
        Err(Error::OutOfRange { what: "tolerance", value: tolerance, must: "0 or more" })
    }
}

/// Removes knots, the cheapest first, while the sums of bounds stay allowed on every span.
fn reduced(mut work: Work, allowed: f64, keep: &[f64]) -> Work {
    let p = work.degree;
    // What has been spent on the span that starts at each knot.
    let mut spent = vec![0.0_f64; work.knots.len()];
    // The bounds of single removals, remembered by knot index until a neighbour changes.
    let mut known: Vec<Option<f64>> = vec![None; work.knots.len()];
    loop {
        let mut best: Option<(usize, usize, f64)> = None;
        for (r, s) in work.interior() {
            if keep.contains(&work.knots[r]) {
                continue;
            }
            let bound = match known[r] {
                Some(bound) => bound,
                None => {
                    let bound = work.removal(r, s).map_or(f64::INFINITY, |x| x.bound);
                    known[r] = Some(bound);
                    bound
                }
            };
            let reach = spent[r.saturating_sub(p + 1)..(r + p + 1).min(spent.len())].iter();
            let sum = bound + reach.copied().fold(0.0, f64::max);
            if sum <= allowed && best.is_none_or(|(_, _, b)| bound < b) {
                best = Some((r, s, bound));
            }
        }
        let Some((r, s, bound)) = best else { return work };
        let Some(removal) = work.removal(r, s) else { return work };
        work.apply(r, s, removal);
        let range = r.saturating_sub(p + 1)..(r + p + 1).min(spent.len());
        for e in &mut spent[range.clone()] {
            *e += bound;
        }
        let joined = spent.remove(r);
        if let Some(e) = spent.get_mut(r.saturating_sub(1)) {
            *e = e.max(joined);
        }
        known.remove(r);
        let around = r.saturating_sub(2 * p + 2)..(r + 2 * p + 2).min(known.len());
        known[around].fill(None);
    }
}
