//! Surfaces through a net of curves.

use super::check;
use super::edge_surface::summed;
use crate::construct::thresholds::{CROSSING_RANGE, SAME_SHARE};
use crate::intersect::nearest_on_curves;
use crate::nurbs::{Skinning, curve_through, skinned, surface_through};
use crate::thresholds;
use crate::{Brep, Curve, Error, Interval, NurbsCurve, Point3, Result, Tolerance, compatible_curves};

/// Gaps between crossing curves up to this part of the net's size are closed.
const LARGEST_GAP: f64 = 1e-3;
/// The most crossings.
const MOST_CROSSINGS: usize = 2_500;
/// The most places at which a curve is taken.
const MOST_PLACES: usize = 1_000;

/// The surface through two sets of curves, each of which crosses all of the other set: W. Gordon's (1969; P&T, *The
/// NURBS Book*, §10.5), the sum of the surfaces through either set less that through the crossings. Curves may come in
/// any order and direction; what sticks out beyond the outermost curves is cut off. u runs along the first set; curves
/// of one set that all close give a surface that closes, with a seam along the first curve of the other.
///
/// Curves whose parameters at the crossings do not fit are taken anew by their lengths, within the tolerance. Where
/// curves miss each other by a gap the surface passes between them.
///
/// # Errors
/// Fewer than two curves in a set (three across closed ones) or too many crossings; curves that do not cross or cross
/// in another order than their neighbours; curves with kinks.
pub fn network_surface(first: &[Curve], second: &[Curve], tolerance: &Tolerance) -> Result<Brep> {
    let limit = check(&first.iter().chain(second).collect::<Vec<_>>(), tolerance)?;
    if first.len() < 2 || second.len() < 2 || first.len().saturating_mul(second.len()) > MOST_CROSSINGS {
        return Err(Error::Invalid {
            what: "net of curves",
            why: format!(
                "it must have at least 2 by 2 curves and at most {MOST_CROSSINGS} crossings, got {} by {}",
                first.len(),
                second.len()
            ),
        });
    }
    let net = Net::new(first.to_vec(), second.to_vec(), limit)?;
    let [us, vs] =
        [net.parameters(&net.first, &net.places[0])?, net.parameters(&net.second, &net.places[1])?];
    let along = fitted(&net.first, &net.places[0], &us, 0.25 * limit)?;
    let across = fitted(&net.second, &net.places[1], &vs, 0.25 * limit)?;
    let by_first = skinned(&along, Skinning::Through, &vs, false)?;
    let by_second = skinned(&across, Skinning::Through, &us, false)?.transposed();
    // Crossings with v running fastest.
    let grid: Vec<Point3> =
        (0..us.len()).flat_map(|j| net.points.iter().filter_map(move |row| row.get(j)).copied()).collect();
    let by_points = surface_through(&grid, [&us, &vs])?;
    let surface = summed(&[by_first, by_second, by_points], &[1.0, 1.0, -1.0])?;
    Brep::from_kinked_surface(&surface.into(), tolerance)
}

/// Curves in order, and where they cross.
struct Net {
    first: Vec<Curve>,
    second: Vec<Curve>,
    /// For each curve of either set its parameters at the curves of the other.
    places: [Vec<Vec<f64>>; 2],
    /// For each curve of the first set its crossings with the second.
    points: Vec<Vec<Point3>>,
}

impl Net {
    fn new(mut first: Vec<Curve>, mut second: Vec<Curve>, limit: f64) -> Result<Self> {
        let bounds = first.iter().chain(&second).map(Curve::bounding_box).reduce(|a, b| a.union(&b));
        let gap = limit.max(LARGEST_GAP * bounds.map_or(0.0, |b| b.diagonal().length()));
        let meet = |a: &Curve, b: &Curve| {
            let found = nearest_on_curves(a, b, 0.1 * limit)?;
            if found.distance <= gap {
                Ok(found)
            } else {
                Err(Error::degenerate("net of curves", "not all curves cross"))
            }
        };
        let sorted = |curves: Vec<Curve>, keys: Vec<f64>| {
            let mut keyed: Vec<(f64, Curve)> = keys.into_iter().zip(curves).collect();
            keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
            keyed.into_iter().map(|(_, curve)| curve).collect::<Vec<_>>()
        };
        let none = || Error::degenerate("net of curves", "there are no curves");
        let keys =
            second.iter().map(|b| Ok(meet(first.first().ok_or_else(none)?, b)?.a)).collect::<Result<_>>()?;
        second = sorted(second, keys);
        let keys =
            first.iter().map(|a| Ok(meet(a, second.first().ok_or_else(none)?)?.b)).collect::<Result<_>>()?;
        first = sorted(first, keys);
        let closed = [&first, &second].map(|set| set.iter().all(Curve::is_closed));
        for (k, is_closed) in closed.into_iter().enumerate() {
            let (own, other) = if k == 0 { (&mut first, &second) } else { (&mut second, &first) };
            let Some(seam) = other.first().filter(|_| is_closed) else { continue };
            if other.len() < 3 {
                return Err(Error::degenerate("net of curves", "across closed curves there must be three"));
            }
            for curve in own.iter_mut() {
                let (at, domain) = (meet(curve, seam)?.a, curve.domain());
                let is_there = [domain.start, domain.end]
                    .iter()
                    .any(|t| (t - at).abs() <= thresholds::SAME_PARAMETER * domain.length());
                if !is_there {
                    *curve = curve.with_seam(at)?;
                }
            }
        }
        let mut net = Self { first, second, places: Default::default(), points: Vec::new() };
        net.cross(closed, meet)?;
        Ok(net)
    }

    /// Finds all crossings, and turns curves to cross the others in their order.
    fn cross(
        &mut self,
        closed: [bool; 2],
        meet: impl Fn(&Curve, &Curve) -> Result<crate::intersect::NearestPair>,
    ) -> Result<()> {
        let [n, m] = [self.first.len(), self.second.len()];
        let mut along = vec![vec![0.0; m]; n];
        let mut across = vec![vec![0.0; n]; m];
        self.points = vec![Vec::with_capacity(m + 1); n];
        for (i, a) in self.first.iter().enumerate() {
            for (j, b) in self.second.iter().enumerate() {
                let found = meet(a, b)?;
                along[i][j] = found.a;
                across[j][i] = found.b;
                self.points[i].push(found.point_a.lerp(found.point_b, 0.5));
            }
        }
        for (curves, places, closed) in
            [(&mut self.first, &mut along, closed[0]), (&mut self.second, &mut across, closed[1])]
        {
            for (curve, row) in curves.iter_mut().zip(places.iter_mut()) {
                let domain = curve.domain();
                if closed && let Some(start) = row.first_mut() {
                    *start = domain.start;
                }
                let last = row.len() - 1;
                if row[last] < row[usize::from(closed)] {
                    *curve = curve.reversed();
                    let turned = curve.domain();
                    for t in row.iter_mut() {
                        *t = turned.start + (domain.end - *t);
                    }
                    if closed {
                        row[0] = turned.start;
                    }
                }
                if closed {
                    row.push(curve.domain().end);
                }
                let least = CROSSING_RANGE * domain.length();
                if row.windows(2).any(|w| !(w[1] - w[0] > least)) {
                    return Err(Error::degenerate("net of curves", "the curves do not cross in one order"));
                }
            }
        }
        if closed[0] {
            self.second.extend(self.second.first().cloned());
            across.extend(across.first().cloned());
            self.points.iter_mut().for_each(|row| row.extend(row.first().copied()));
        }
        if closed[1] {
            self.first.extend(self.first.first().cloned());
            along.extend(along.first().cloned());
            self.points.extend(self.points.first().cloned());
        }
        self.places = [along, across];
        Ok(())
    }

    /// The parameters of the surface at the crossings: those of the curves when they agree, else by length.
    fn parameters(&self, curves: &[Curve], places: &[Vec<f64>]) -> Result<Vec<f64>> {
        let Some(model) = places.first() else {
            return Err(Error::degenerate("net of curves", "it is empty"));
        };
        let share = |row: &[f64], t: f64| (t - row[0]) / (row[row.len() - 1] - row[0]);
        let agree = |row: &Vec<f64>| {
            row.iter().zip(model).all(|(t, s)| (share(row, *t) - share(model, *s)).abs() <= SAME_SHARE)
        };
        let lengths: Vec<f64> = (curves.iter().zip(places))
            .map(|(curve, row)| curve.length_between(Interval::new(row[0], row[row.len() - 1])))
            .collect();
        let whole = lengths.iter().sum::<f64>() / lengths.len() as f64;
        if !(whole > 0.0) {
            return Err(Error::degenerate(
                "net of curves",
                "a set of curves has no length between the others",
            ));
        }
        if places.iter().all(agree) {
            return Ok(model.iter().map(|t| whole * share(model, *t)).collect());
        }
        let mut out = vec![0.0; model.len()];
        for ((curve, row), length) in curves.iter().zip(places).zip(&lengths) {
            for (sum, t) in out.iter_mut().zip(row) {
                *sum +=
                    curve.length_between(Interval::new(row[0], *t)) / length * whole / curves.len() as f64;
            }
        }
        if out.windows(2).any(|w| !(w[1] - w[0] > thresholds::SAME_PARAMETER * whole)) {
            return Err(Error::degenerate("net of curves", "two curves of a set coincide"));
        }
        Ok(out)
    }
}

/// The stretches of curves between their outermost crossings, with these at the given parameters, with common knots.
fn fitted(curves: &[Curve], places: &[Vec<f64>], parameters: &[f64], limit: f64) -> Result<Vec<NurbsCurve>> {
    let domain = Interval::new(parameters[0], parameters[parameters.len() - 1]);
    let linear = |row: &Vec<f64>| {
        let share = |t: f64| (t - row[0]) / (row[row.len() - 1] - row[0]);
        row.iter().zip(parameters).all(|(t, u)| (share(*t) - domain.normalized(*u)).abs() <= SAME_SHARE)
    };
    if places.iter().all(linear) {
        let mut exact = Vec::with_capacity(curves.len());
        for (curve, row) in curves.iter().zip(places) {
            let range = Interval::new(row[0], row[row.len() - 1]);
            let part = if range == curve.domain() { curve.clone() } else { curve.trimmed(range)? };
            exact.push(part.to_nurbs()?.with_domain(domain)?);
        }
        if !exact.iter().any(NurbsCurve::is_rational) {
            return compatible_curves(&exact);
        }
    }
    let maps: Vec<Monotone> = places.iter().map(|row| Monotone::new(parameters, row)).collect();
    let mut parts = (24 / parameters.len()).max(2);
    loop {
        let mut ts: Vec<f64> = Vec::new();
        for w in parameters.windows(2) {
            ts.extend((0..parts).map(|k| w[0] + (w[1] - w[0]) * (k as f64 / parts as f64)));
        }
        ts.push(domain.end);
        if ts.len() > MOST_PLACES {
            return Err(Error::degenerate("net of curves", "a curve has a kink, or cannot be followed"));
        }
        let at = |k: usize, t: f64| curves[k].point_at(maps[k].at(t));
        let mut made = Vec::with_capacity(curves.len());
        for k in 0..curves.len() {
            made.push(curve_through(&ts.iter().map(|t| at(k, *t)).collect::<Vec<_>>(), &ts)?);
        }
        let middle = |w: &[f64]| 0.5 * (w[0] + w[1]);
        let follows = made.iter().enumerate().all(|(k, curve)| {
            ts.windows(2).all(|w| curve.point_at(middle(w)).distance_to(at(k, middle(w))) <= limit)
        });
        if follows {
            return Ok(made);
        }
        parts *= 2;
    }
}

/// A smooth increasing map through given pairs (F. Fritsch and J. Butland, *A method for constructing local monotone
/// piecewise cubic interpolants*, 1984).
struct Monotone {
    from: Vec<f64>,
    to: Vec<f64>,
    slopes: Vec<f64>,
}

impl Monotone {
    fn new(from: &[f64], to: &[f64]) -> Self {
        let n = from.len();
        let step = |k: usize| (to[k + 1] - to[k]) / (from[k + 1] - from[k]);
        let slopes = (0..n)
            .map(|k| match k {
                0 => step(0),
                k if k + 1 == n => step(n - 2),
                k => 2.0 / (1.0 / step(k - 1) + 1.0 / step(k)),
            })
            .collect();
        Self { from: from.to_vec(), to: to.to_vec(), slopes }
    }

    fn at(&self, t: f64) -> f64 {
        let k = self.from.partition_point(|x| *x <= t).clamp(1, self.from.len() - 1) - 1;
        let h = self.from[k + 1] - self.from[k];
        let x = ((t - self.from[k]) / h).clamp(0.0, 1.0);
        let y = 1.0 - x;
        (1.0 + 2.0 * x) * y * y * self.to[k]
            + (3.0 - 2.0 * x) * x * x * self.to[k + 1]
            + h * x * y * (y * self.slopes[k] - x * self.slopes[k + 1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Direction, Line, NurbsSurface, Plane, Surface, Vector3};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-3, ..Tolerance::default() }
    }

    fn hills() -> NurbsSurface {
        let points: Vec<Point3> = (0..36)
            .map(|k| Point3::new(f64::from(k / 6), f64::from(k % 6), f64::from(k * k % 5) * 0.4))
            .collect();
        NurbsSurface::clamped_uniform([3, 3], [6, 6], &points).unwrap()
    }

    fn lies_on(surface: &Surface, curve: &Curve, within: f64) {
        for k in 0..=40 {
            let p = curve.point_at(curve.domain().at(f64::from(k) / 40.0));
            let d = surface.closest_point(p).unwrap().distance;
            assert!(d < within, "{d} off at {k}");
        }
    }

    #[test]
    fn curves_of_a_surface_in_any_order() {
        let hills = hills();
        let iso = |d: Direction, t: f64| Curve::from(hills.isocurve(d, t).unwrap());
        let at = [0.0, 0.4, 1.1, 1.9, 2.6, 3.0];
        let mut first: Vec<Curve> = at.iter().map(|t| iso(Direction::U, *t)).collect();
        let mut second: Vec<Curve> = at.iter().map(|t| iso(Direction::V, *t)).collect();
        let exact = network_surface(&first, &second, &tolerance()).unwrap();
        assert_eq!(exact.faults(), []);
        let surface = exact.face_surface(0).unwrap().clone();
        first.iter().chain(&second).for_each(|curve| lies_on(&surface, curve, 1e-8));
        first.swap(0, 4);
        first[2] = first[2].reversed();
        second.swap(1, 3);
        second[5] = second[5].reversed();
        let again = network_surface(&first, &second, &tolerance()).unwrap();
        let surface = again.face_surface(0).unwrap().clone();
        first.iter().chain(&second).for_each(|curve| lies_on(&surface, curve, 1e-8));
    }

    #[test]
    fn curves_with_other_parameters_and_overhang() {
        let hills = hills();
        let at = [0.2, 1.0, 2.7];
        let bent = |curve: NurbsCurve| -> Curve {
            // The same points at lengths.
            let curve = Curve::from(curve);
            let ts = curve.divide_by_count(60).unwrap();
            let ts: Vec<f64> = ts.into_iter().take(60).chain([curve.domain().end]).collect();
            let points: Vec<Point3> = ts.iter().map(|t| curve.point_at(*t)).collect();
            let places: Vec<f64> = (0..points.len()).map(|k| k as f64).collect();
            curve_through(&points, &places).unwrap().into()
        };
        let first: Vec<Curve> = at.iter().map(|t| bent(hills.isocurve(Direction::U, *t).unwrap())).collect();
        let second: Vec<Curve> =
            at.iter().map(|t| hills.isocurve(Direction::V, *t).unwrap().into()).collect();
        let made = network_surface(&first, &second, &tolerance()).unwrap();
        assert_eq!(made.faults(), []);
        let surface = made.face_surface(0).unwrap().clone();
        let inner = |curve: &Curve| {
            let ends = [at[0], at[2]].map(|t| curve.domain().at(t / 3.0 * 0.9 + 0.05));
            curve.trimmed(Interval::new(ends[0], ends[1])).unwrap()
        };
        second.iter().for_each(|curve| lies_on(&surface, &inner(curve), 5e-3));
    }

    #[test]
    fn a_tube_of_rings_and_rails() {
        let rings: Vec<Curve> = [0.0, 1.0, 2.0, 3.0]
            .iter()
            .map(|z| Curve::from(Circle { plane: Plane::XY.offset(*z), radius: 1.0 }))
            .collect();
        let rails: Vec<Curve> = (0..4)
            .map(|k| {
                let foot = Circle { plane: Plane::XY, radius: 1.0 }
                    .at(f64::from(k) * std::f64::consts::FRAC_PI_2 + 0.3);
                Curve::from(Line::new(foot, foot + Vector3::Z * 3.0))
            })
            .collect();
        let tube = network_surface(&rings, &rails, &tolerance()).unwrap();
        assert_eq!(tube.faults(), []);
        let area = tube.face_surface(0).unwrap().area().unwrap().area;
        assert!((area - 6.0 * std::f64::consts::PI).abs() < 1e-2, "{area}");
    }

    #[test]
    fn nets_that_are_none() {
        let line = |y: f64| Curve::from(Line::new(Point3::new(0.0, y, 0.0), Point3::new(1.0, y, 0.0)));
        let up = |x: f64, z: f64| Curve::from(Line::new(Point3::new(x, 0.0, z), Point3::new(x, 1.0, z)));
        let error = |a: &[Curve], b: &[Curve]| network_surface(a, b, &tolerance()).unwrap_err().to_string();
        assert!(error(&[line(0.0)], &[up(0.0, 0.0), up(1.0, 0.0)]).contains("2 by 2"));
        assert!(error(&[line(0.0), line(1.0)], &[up(0.0, 5.0), up(1.0, 0.0)]).contains("cross"));
        assert!(error(&[line(0.0), line(0.0)], &[up(0.0, 0.0), up(1.0, 0.0)]).contains("order"));
        let flat =
            network_surface(&[line(0.0), line(1.0)], &[up(0.0, 0.0), up(1.0, 0.0)], &tolerance()).unwrap();
        assert!((flat.face_surface(0).unwrap().area().unwrap().area - 1.0).abs() < 1e-12);
    }
}
