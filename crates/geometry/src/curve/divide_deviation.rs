//! Segments of a curve that stray equally far from their chords.

use super::{ArcLength, Curve};
use crate::curve::thresholds::{EVEN_SPREAD, NO_DEVIATION, SEARCH_DONE};
use crate::{Error, Line, Point3, Result};

/// The most segments; the work grows with their number.
const MOST: usize = 10_000;

/// Points along the curve, close enough together that the farthest from a chord is next to one of them.
struct Samples<'a> {
    curve: &'a Curve,
    parameters: Vec<f64>,
    points: Vec<Point3>,
}

impl Samples<'_> {
    fn miss(chord: &Line, p: Point3) -> f64 {
        chord.distance_to(p)
    }

    /// The distance of the sample farthest from the chord over `from`…`to`, and its index.
    fn farthest(&self, chord: &Line, from: f64, to: f64) -> (f64, Option<usize>) {
        let first = self.parameters.partition_point(|&t| t <= from);
        let mut best = (0.0, None);
        for (i, (&t, &p)) in self.parameters.iter().zip(&self.points).enumerate().skip(first) {
            if t >= to {
                break;
            }
            let d = Self::miss(chord, p);
            if d > best.0 {
                best = (d, Some(i));
            }
        }
        best
    }

    /// The largest distance of the curve from its chord over `from`…`to`: golden section next to the farthest sample.
    fn deviation(&self, from: f64, to: f64) -> f64 {
        let chord = Line::new(self.curve.point_at(from), self.curve.point_at(to));
        let (coarse, at) = self.farthest(&chord, from, to);
        let f = |t: f64| Self::miss(&chord, self.curve.point_at(t));
        let (mut a, mut b) = match at {
            Some(i) => (
                self.parameters.get(i.wrapping_sub(1)).map_or(from, |t| t.max(from)),
                self.parameters.get(i + 1).map_or(to, |t| t.min(to)),
            ),
            None => (from, to),
        };
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        let (mut fc, mut fd) = (f(c), f(d));
        for _ in 0..30 {
            if fc > fd {
                (b, d, fd) = (d, c, fc);
                c = b - GOLDEN * (b - a);
                fc = f(c);
            } else {
                (a, c, fc) = (c, d, fd);
                d = a + GOLDEN * (b - a);
                fd = f(d);
            }
        }
        coarse.max(fc).max(fd)
    }

    /// The largest distance of the curve from its chord over `from`…`to`, by the parabola through the farthest sample and
    /// its neighbours: quick, and true to a few parts in a million.
    fn quick_deviation(&self, from: f64, to: f64) -> f64 {
        let chord = Line::new(self.curve.point_at(from), self.curve.point_at(to));
        let (best, Some(i)) = self.farthest(&chord, from, to) else {
            return Self::miss(&chord, self.curve.point_at(0.5 * (from + to)));
        };
        let at = |k: usize| self.parameters.get(k).copied().zip(self.points.get(k).copied());
        let inside = |t: f64| from < t && t < to;
        let before =
            i.checked_sub(1).and_then(at).filter(|p| inside(p.0)).map(|(t, p)| (t, Self::miss(&chord, p)));
        let after = at(i + 1).filter(|p| inside(p.0)).map(|(t, p)| (t, Self::miss(&chord, p)));
        // At the ends of the chord the distance is 0.
        let ((s, f), (u, h)) = (before.unwrap_or((from, 0.0)), after.unwrap_or((to, 0.0)));
        let t = self.parameters.get(i).copied().unwrap_or(s);
        let (left, right) = ((best - f) / (t - s), (h - best) / (u - t));
        let bend = (right - left) / (u - s);
        if !(bend < 0.0) {
            return best;
        }
        let slope = left + bend * (t - s);
        let top = best - slope * slope / (4.0 * bend);
        if top.is_finite() { top.clamp(best, 2.0 * best) } else { best }
    }

    /// The end of the first segment from `from` on that strays by `limit`, or the end of the curve.
    fn step(&self, from: f64, limit: f64) -> f64 {
        let end = self.curve.domain().end;
        let first = self.parameters.partition_point(|&t| t <= from);
        let mut low = from;
        let mut high = None;
        for &t in self.parameters.iter().skip(first) {
            if self.quick_deviation(from, t) > limit {
                high = Some(t);
                break;
            }
            low = t;
        }
        let mut high = match high {
            Some(t) => t,
            None if self.quick_deviation(from, end) <= limit => return end,
            None => end,
        };
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if self.quick_deviation(from, middle) <= limit {
                low = middle;
            } else {
                high = middle;
            }
        }
        if low > from { low } else { high }
    }

    /// How unequal the segments are: the largest difference of their deviations, as a part of the largest.
    fn spread(&self, ends: &[f64]) -> f64 {
        let (low, high) = ends.windows(2).fold((f64::INFINITY, 0.0_f64), |(low, high), w| {
            let d = self.quick_deviation(w[0], w[1]);
            (low.min(d), high.max(d))
        });
        if high > 0.0 { (high - low) / high } else { 0.0 }
    }

    /// Moves the joints until the segments stray equally. A deviation grows about with the square of the length: joints
    /// are put where they share the sum of (deviations' roots over lengths) equally (C. de Boor, *Good approximation by
    /// splines with variable knots*, 1973). Then each goes to where the segments on both sides of it stray equally: between
    /// its neighbours such a place always exists.
    fn balance(&self, ends: &mut Vec<f64>) {
        /// Many segments have no way to go: each follows from the one before.
        const MOST_BALANCED: usize = 64;
        if ends.len() > MOST_BALANCED {
            return;
        }
        let mut best = (self.spread(ends), ends.clone());
        let mut here = ends.clone();
        for _ in 0..60 {
            if best.0 <= EVEN_SPREAD {
                break;
            }
            let roots: Vec<f64> = here.windows(2).map(|w| self.quick_deviation(w[0], w[1]).sqrt()).collect();
            let share = roots.iter().sum::<f64>() / roots.len() as f64;
            let mut next = here.clone();
            let (mut i, mut before) = (0, 0.0);
            for k in 1..roots.len() {
                let want = share * k as f64;
                while i + 1 < roots.len() && before + roots[i] < want {
                    before += roots[i];
                    i += 1;
                }
                let x = ((want - before) / roots[i]).clamp(0.0, 1.0);
                let there = if x.is_finite() { here[i] + (here[i + 1] - here[i]) * x } else { here[i + 1] };
                // Part of the way: places of equal share move with the segments.
                next[k] = 0.3 * here[k] + 0.7 * there;
            }
            if next.windows(2).any(|w| !(w[0] < w[1])) {
                break;
            }
            let spread = self.spread(&next);
            if spread < best.0 {
                best = (spread, next.clone());
            }
            here = next;
        }
        *ends = best.1;
        let mut last = f64::INFINITY;
        for _ in 0..30 {
            let spread = self.spread(ends);
            if spread <= EVEN_SPREAD || spread > 0.98 * last {
                break;
            }
            last = spread;
            for i in 1..ends.len().saturating_sub(1) {
                let (a, b) = (ends[i - 1], ends[i + 1]);
                let (mut from, mut to) = (a, b);
                for _ in 0..40 {
                    let t = 0.5 * (from + to);
                    if self.quick_deviation(a, t) < self.quick_deviation(t, b) {
                        from = t;
                    } else {
                        to = t;
                    }
                }
                ends[i] = 0.5 * (from + to);
            }
        }
    }
}

impl Curve {
    /// The parameters that cut the curve into `count` segments whose largest distances from their chords are equal,
    /// and these distances: count + 1 parameters with both ends on an open curve, count on a closed one, whose first
    /// segment starts at the seam. A straight curve is cut into equal lengths.
    ///
    /// Derived: for a bound on the distance segments are made as long as it allows, one after the other; the bound for
    /// which the last one ends with the curve is found by halving. Where a curve that bends to and fro leaves them uneven,
    /// each joint of up to 63 segments is moved to where its two segments stray equally. Distances agree to about 10⁻³ of
    /// themselves where the curve bends; with straight parts or kinks they may have to differ.
    ///
    /// # Errors
    /// A count of 0 or above 10,000, or a curve without length.
    pub fn divide_by_deviation(&self, count: usize) -> Result<(Vec<f64>, Vec<f64>)> {
        if count == 0 || count > MOST {
            return Err(Error::OutOfRange {
                what: "number of segments",
                value: count as f64,
                must: "from 1 to 10,000",
            });
        }
        let measure = ArcLength::new(self);
        let total = measure.total();
        if !(total > 0.0) {
            return Err(Error::degenerate("curve", "it has no length to divide"));
        }
        let domain = self.domain();
        let dense = (16 * count).max(512);
        let mut parameters: Vec<f64> =
            (0..=dense).map(|i| measure.parameter_at(total * i as f64 / dense as f64)).collect();
        parameters.extend(self.pieces().iter().map(|p| p.whole.start));
        parameters.retain(|&t| domain.start < t && t < domain.end);
        parameters.sort_by(f64::total_cmp);
        parameters.dedup();
        let points = self.points_at(&parameters);
        let samples = Samples { curve: self, parameters, points };
        let whole = samples.deviation(domain.start, domain.end);
        let ends = if count == 1 {
            vec![domain.start, domain.end]
        } else if whole <= NO_DEVIATION * total {
            let mut ends = self.divide_by_count(count)?;
            if ends.len() == count {
                ends.push(domain.end);
            }
            ends
        } else {
            let walk = |limit: f64| {
                let mut ends = vec![domain.start];
                let mut t = domain.start;
                for _ in 0..count {
                    t = samples.step(t, limit);
                    ends.push(t);
                    if t >= domain.end {
                        break;
                    }
                }
                ends
            };
            let (mut low, mut high) = (0.0, whole);
            let mut best = walk(high);
            for _ in 0..44 {
                let middle = 0.5 * (low + high);
                let ends = walk(middle);
                if ends.last().is_some_and(|&t| t >= domain.end) {
                    (high, best) = (middle, ends);
                } else {
                    low = middle;
                }
                if high - low <= SEARCH_DONE * high {
                    break;
                }
            }
            // Where a kink lets a bound suddenly suffice, fewer segments reach the end: the longest are halved.
            while best.len() <= count {
                let longest = (1..best.len()).max_by(|&i, &j| {
                    let d = |k: usize| samples.deviation(best[k - 1], best[k]);
                    d(i).total_cmp(&d(j)).then((best[i] - best[i - 1]).total_cmp(&(best[j] - best[j - 1])))
                });
                let Some(i) = longest else { break };
                best.insert(i, 0.5 * (best[i - 1] + best[i]));
            }
            if let Some(last) = best.last_mut() {
                *last = domain.end;
            }
            samples.balance(&mut best);
            best
        };
        let deviations = ends.windows(2).map(|w| samples.deviation(w[0], w[1])).collect();
        let mut ends = ends;
        if self.is_closed() {
            ends.pop();
        }
        Ok((ends, deviations))
    }
}

#[cfg(test)]
mod tests {
    use crate::{Circle, Curve, Line, NurbsCurve, Plane, Point3};

    #[test]
    fn circles_are_cut_evenly() {
        let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
        let (t, d) = circle.divide_by_deviation(6).unwrap();
        assert_eq!((t.len(), d.len()), (6, 6));
        let sagitta = 2.0 * (1.0 - (std::f64::consts::PI / 6.0).cos());
        for (i, t) in t.iter().enumerate() {
            let want = circle.point_at(circle.domain().at(i as f64 / 6.0));
            assert!(circle.point_at(*t).distance_to(want) < 1e-5);
        }
        assert!(d.iter().all(|d| (d - sagitta).abs() < 1e-5), "{d:?}");
    }

    #[test]
    fn deviations_are_equal() {
        let points = [[0.0, 0.0], [1.0, 3.0], [2.0, -4.0], [5.0, 1.0], [9.0, 0.0]];
        let points: Vec<Point3> = points.iter().map(|&[x, y]| Point3::new(x, y, 0.0)).collect();
        let curve: Curve = NurbsCurve::clamped_uniform(3, &points).unwrap().into();
        for count in [1, 2, 5, 17] {
            let (t, d) = curve.divide_by_deviation(count).unwrap();
            assert_eq!((t.len(), d.len()), (count + 1, count));
            let (low, high) = d.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), &d| (l.min(d), h.max(d)));
            assert!(high - low < 5e-3 * high, "{count}: {d:?}");
        }
    }

    #[test]
    fn straight_curves_and_bad_counts() {
        let line: Curve = Line::new(Point3::ORIGIN, Point3::new(8.0, 0.0, 0.0)).into();
        let (t, d) = line.divide_by_deviation(4).unwrap();
        assert_eq!(t, [0.0, 2.0, 4.0, 6.0, 8.0]);
        assert!(d.iter().all(|&d| d < 1e-15));
        assert!(line.divide_by_deviation(0).is_err());
    }
}
