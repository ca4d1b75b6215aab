//! The surfaces of strips and cones.

use super::pieces::Piece;
use super::rail::Rail;
use crate::construct::loft::collapsed;
use crate::construct::thresholds::SAME_SHARE;
use crate::{Brep, Curve, Interval, NurbsCurve, NurbsSurface, Point3, Result, Tolerance, Vector3};

/// The most places at which a strip is held to its rails.
const MOST: usize = 8192;

/// The surface of a piece; nothing where a cone has no area.
pub(super) fn surface(
    rails: &[Rail; 2],
    piece: &Piece,
    limit: f64,
    tolerance: &Tolerance,
) -> Result<Option<Brep>> {
    match piece {
        Piece::Cone { rail, range, apex } => {
            let base = rails[*rail].curve.trimmed(Interval::new(range[0], range[1]))?.to_nurbs()?;
            let apex = collapsed(&base, rails[1 - *rail].curve.point_at(*apex))?;
            let cone = if *rail == 0 {
                NurbsSurface::ruled(&base, &apex)?
            } else {
                NurbsSurface::ruled(&apex, &base)?
            };
            // An apex on the line of a straight base.
            Ok(Brep::from_kinked_surface(&cone.into(), tolerance).ok())
        }
        Piece::Strip(rulings) => {
            let surface = strip(rails, rulings, limit)?;
            Brep::from_kinked_surface(&surface.into(), tolerance).map(Some)
        }
    }
}

/// The surface over rulings: exact where both rails go at the same pace.
fn strip(rails: &[Rail; 2], rulings: &[[f64; 2]], limit: f64) -> Result<NurbsSurface> {
    let (first, last) = (rulings[0], rulings[rulings.len() - 1]);
    let ranges = [0, 1].map(|side| Interval::new(first[side], last[side]));
    let same_pace =
        rulings.iter().all(|r| (ranges[0].normalized(r[0]) - ranges[1].normalized(r[1])).abs() <= SAME_SHARE);
    if same_pace {
        let part = |side: usize| -> Result<NurbsCurve> {
            let part = rails[side].curve.trimmed(ranges[side])?;
            part.with_domain(Interval::UNIT)?.to_nurbs()
        };
        return NurbsSurface::ruled(&part(0)?, &part(1)?);
    }
    // The pace of the rulings: the mean of their shares of both rails.
    let pace: Vec<f64> =
        rulings.iter().map(|r| 0.5 * (ranges[0].normalized(r[0]) + ranges[1].normalized(r[1]))).collect();
    let sides = [0, 1].map(|side| {
        let parameters: Vec<f64> = rulings.iter().map(|r| r[side]).collect();
        Paced { curve: &rails[side].curve, slopes: slopes(&pace, &parameters), parameters }
    });
    let at = fitting_places(&sides, &pace, limit);
    NurbsSurface::ruled(&sides[0].through(&at)?, &sides[1].through(&at)?)
}

/// A rail at the pace of the rulings: its parameter is a cubic between each two of them.
struct Paced<'a> {
    curve: &'a Curve,
    parameters: Vec<f64>,
    slopes: Vec<f64>,
}

/// A place between two rulings: the first of them, and the share of the way to the next, with the pace there.
type Place = (usize, f64, f64);

impl Paced<'_> {
    /// The point and its derivative by the pace.
    fn at(&self, pace: &[f64], (k, share, _): Place) -> (Point3, Vector3) {
        let Some(step) = pace.get(k + 1).map(|next| next - pace[k]) else {
            let t = self.parameters[k];
            let (point, d) = self.curve.derivatives(t, 1, true);
            return (point, d[0] * self.slopes[k]);
        };
        let (p, q) = (self.parameters[k], self.parameters[k + 1]);
        let (m, n) = (self.slopes[k] * step, self.slopes[k + 1] * step);
        let x = share;
        let t = p + x * (m + x * ((3.0 * (q - p) - 2.0 * m - n) + x * (m + n - 2.0 * (q - p))));
        let slope =
            (m + x * (2.0 * (3.0 * (q - p) - 2.0 * m - n) + x * 3.0 * (m + n - 2.0 * (q - p)))) / step;
        let (point, d) = self.curve.derivatives(t.clamp(p, q), 1, false);
        (point, d[0] * slope)
    }

    /// The cubic with the points and derivatives at places.
    fn through(&self, at: &(Vec<f64>, Vec<Place>)) -> Result<NurbsCurve> {
        let (pace, places) = at;
        let (points, derivatives): (Vec<Point3>, Vec<Vector3>) =
            places.iter().map(|place| self.at(pace, *place)).unzip();
        let parameters: Vec<f64> = places.iter().map(|place| place.2).collect();
        NurbsCurve::hermite_through(&points, &derivatives, &parameters)
    }
}

/// The fewest of evenly taken places at which cubics stay within the tolerance of both rails.
fn fitting_places(sides: &[Paced<'_>; 2], pace: &[f64], limit: f64) -> (Vec<f64>, Vec<Place>) {
    let last = pace.len() - 1;
    let at_rulings = |step: usize| -> Vec<Place> {
        let mut out: Vec<Place> = (0..last).step_by(step).map(|k| (k, 0.0, pace[k])).collect();
        out.push((last, 0.0, pace[last]));
        out
    };
    let between = |parts: usize| -> Vec<Place> {
        let inside = |k: usize| {
            (0..parts).map(move |part| {
                let share = part as f64 / parts as f64;
                (k, share, pace[k] + share * (pace[k + 1] - pace[k]))
            })
        };
        let mut out: Vec<Place> = (0..last).flat_map(inside).collect();
        out.push((last, 0.0, pace[last]));
        out
    };
    let coarse = [64, 32, 16, 8, 4, 2, 1].into_iter().filter(|step| *step <= last.max(1)).map(at_rulings);
    let fine = [2, 4, 8, 16, 32, 64].into_iter().filter(|parts| parts * last <= MOST).map(between);
    let mut finest = Vec::new();
    for places in coarse.chain(fine) {
        if sides.iter().all(|side| side.is_near(pace, &places, 0.25 * limit)) {
            return (pace.to_vec(), places);
        }
        finest = places;
    }
    (pace.to_vec(), finest)
}

impl Paced<'_> {
    /// Whether cubics between places stay within a distance of the rail: at the rulings, and at quarters of the way to
    /// the next ruling or, where there are places between, to the next of them.
    fn is_near(&self, pace: &[f64], places: &[Place], distance: f64) -> bool {
        let Ok(curve) = self.through(&(pace.to_vec(), places.to_vec())) else { return false };
        let last = pace.len() - 1;
        let looks = 4 * ((places.len() - 1) / last).max(1);
        (0..last).all(|k| {
            (0..looks).map(|look| look as f64 / looks as f64).all(|share| {
                let s = pace[k] + share * (pace[k + 1] - pace[k]);
                curve.point_at(s).distance_to(self.at(pace, (k, share, s)).0) <= distance
            })
        })
    }
}

/// Slopes at nodes that keep what rises between them rising (Fritsch and Butland, *A method for constructing local
/// monotone piecewise cubic interpolants*, 1984).
fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let steps: Vec<(f64, f64)> =
        x.windows(2).zip(y.windows(2)).map(|(x, y)| (x[1] - x[0], (y[1] - y[0]) / (x[1] - x[0]))).collect();
    let inner = |pair: &[(f64, f64)]| {
        let ((h, d), (k, e)) = (pair[0], pair[1]);
        if d * e <= 0.0 {
            return 0.0;
        }
        let (a, b) = (2.0 * k + h, k + 2.0 * h);
        (a + b) / (a / d + b / e)
    };
    let mut out = Vec::with_capacity(x.len());
    out.extend(steps.first().map(|step| end_slope(step, steps.get(1))));
    out.extend(steps.windows(2).map(inner));
    out.extend(steps.last().map(|step| end_slope(step, steps.len().checked_sub(2).map(|k| &steps[k]))));
    out
}

/// The slope at an end, by the parabola through three nodes, kept between 0 and three times that of the last step.
fn end_slope((h, d): &(f64, f64), next: Option<&(f64, f64)>) -> f64 {
    let Some((k, e)) = next else { return *d };
    let slope = ((2.0 * h + k) * d - h * e) / (h + k);
    slope.clamp(0.0, 3.0 * d)
}
