//! Curves from what is seen of them from two sides.

use super::Curve;
use crate::nurbs::curve_through;
use crate::thresholds;
use crate::{Error, Interval, Point3, Result, Tolerance, Vector3};

/// The fewest and the most points of a piece.
const FEWEST: usize = 8;
const MOST: usize = 4096;
/// Halvings with which a place is found.
const HALVINGS: u32 = 60;

/// A stretch of a curve along which its height only grows, or only falls.
struct Climb<'a> {
    curve: &'a Curve,
    range: Interval,
    heights: Interval,
    up: Vector3,
}

impl Climb<'_> {
    fn height(&self, t: f64) -> f64 {
        self.curve.point_at(t).to_vector().dot(self.up)
    }

    /// The place at a height, as a share of the stretch seen from its low end.
    fn share_at(&self, height: f64) -> f64 {
        let (mut low, mut high) = (0.0_f64, 1.0_f64);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.height(self.parameter(middle)) < height { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    fn parameter(&self, share: f64) -> f64 {
        if self.heights.start <= self.heights.end { self.range.at(share) } else { self.range.at(1.0 - share) }
    }

    fn least(&self) -> f64 {
        self.heights.start.min(self.heights.end)
    }

    fn most(&self) -> f64 {
        self.heights.start.max(self.heights.end)
    }
}

/// The curves that look like one curve seen along one direction, and like another seen along another: where the
/// extrusions of both along these directions meet, within the tolerance. Stretches on which a curve runs across both
/// directions, along which both have the same height all along, give none.
///
/// Both are cut where they turn back in the direction at right angles to both views; of each pair of stretches that share
/// heights there is one piece, and pieces that meet are joined.
///
/// # Errors
/// Directions that are parallel or without length, a tolerance that is not above 0, or a piece that cannot be followed
/// within it.
pub fn curves_of_two_views(
    curves: [&Curve; 2],
    views: [Vector3; 2],
    tolerance: &Tolerance,
) -> Result<Vec<Curve>> {
    let limit = tolerance.positive_distance()?;
    let parallel = || Error::degenerate("directions of the views", "they are parallel");
    let [Some(a), Some(b)] = views.map(|view| view.unitized()) else { return Err(parallel()) };
    let across = a.cross(b);
    let Some(up) = across.unitized().filter(|_| across.length() > thresholds::PARALLEL) else {
        return Err(parallel());
    };
    let [first, second] = [climbs(curves[0], up, limit)?, climbs(curves[1], up, limit)?];
    let mut pieces = Vec::new();
    for one in &first {
        for other in &second {
            let heights = Interval::new(one.least().max(other.least()), one.most().min(other.most()));
            if heights.end - heights.start > limit {
                pieces.push(piece([one, other], heights, [a, b], limit)?);
            }
        }
    }
    Ok(crate::join_curves(&pieces, 2.0 * limit, false))
}

/// The stretches of a curve along which its height grows or falls.
fn climbs(curve: &Curve, up: Vector3, limit: f64) -> Result<Vec<Climb<'_>>> {
    let domain = curve.domain();
    let turns = curve.turning_points(up)?;
    let kinks = curve.smooth_stretches().into_iter().map(|range| range.end);
    let mut cuts: Vec<f64> = turns.into_iter().chain(kinks).chain([domain.start, domain.end]).collect();
    cuts.retain(|t| domain.contains(*t));
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|b, a| *b - *a <= thresholds::SAME_PARAMETER * domain.length());
    let climb = |pair: &[f64]| {
        let range = Interval::new(pair[0], pair[1]);
        let heights = [range.start, range.end].map(|t| curve.point_at(t).to_vector().dot(up));
        let heights = Interval::new(heights[0], heights[1]);
        ((heights.end - heights.start).abs() > limit).then_some(Climb { curve, range, heights, up })
    };
    Ok(cuts.windows(2).filter_map(climb).collect())
}

/// The piece over heights that two stretches share.
fn piece(climbs: [&Climb<'_>; 2], heights: Interval, views: [Vector3; 2], limit: f64) -> Result<Curve> {
    let [a, b] = views;
    let slant = a.dot(b);
    // What the stretches move by together tells the places apart, also where one of them turns.
    let shares = |h: f64| climbs.map(|climb| climb.share_at(h));
    let [low, high] = [shares(heights.start), shares(heights.end)];
    let at = |x: f64| -> Point3 {
        let (mut bottom, mut top) = (heights.start, heights.end);
        let wanted = (low[0] + low[1]) * (1.0 - x) + (high[0] + high[1]) * x;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (bottom + top);
            if shares(middle).iter().sum::<f64>() < wanted { bottom = middle } else { top = middle }
        }
        let h = match x {
            0.0 => heights.start,
            1.0 => heights.end,
            _ => 0.5 * (bottom + top),
        };
        let [s, t] = shares(h);
        let p = climbs[0].curve.point_at(climbs[0].parameter(s));
        let q = climbs[1].curve.point_at(climbs[1].parameter(t));
        // p + α a = q + β b, up to a height that is the same.
        let gap = q - p;
        let along = (gap.dot(a) - slant * gap.dot(b)) / (1.0 - slant * slant);
        p + a * along
    };
    let mut count = FEWEST;
    let mut points: Vec<Point3> = (0..=count).map(|k| at(k as f64 / count as f64)).collect();
    loop {
        let parameters: Vec<f64> = (0..=count).map(|k| k as f64 / count as f64).collect();
        let made = curve_through(&points, &parameters)?;
        let between: Vec<Point3> = (0..count).map(|k| at((k as f64 + 0.5) / count as f64)).collect();
        let off = between
            .iter()
            .enumerate()
            .map(|(k, p)| made.point_at((k as f64 + 0.5) / count as f64).distance_to(*p));
        if off.fold(0.0, f64::max) <= 0.5 * limit {
            return Ok(made.into());
        }
        if count >= MOST {
            return Err(Error::degenerate(
                "curve of two views",
                "it cannot be followed within the tolerance",
            ));
        }
        let last = points.pop();
        points = points.into_iter().zip(between).flat_map(|(p, q)| [p, q]).chain(last).collect();
        count *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Line, Plane};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-4, ..Tolerance::default() }
    }

    fn line(a: [f64; 3], b: [f64; 3]) -> Curve {
        Line::new(a.into(), b.into()).into()
    }

    #[test]
    fn lines_and_circles_from_above_and_from_the_front() {
        let views = [Vector3::Z, Vector3::Y * 3.0];
        let made = curves_of_two_views(
            [&line([0.0, 0.0, 0.0], [4.0, 2.0, 0.0]), &line([5.0, 9.0, 4.0], [1.0, 9.0, 0.0])],
            views,
            &tolerance(),
        )
        .unwrap();
        // From x = 1 to x = 4, where both can be seen.
        assert_eq!(made.len(), 1);
        let ends = [made[0].start(), made[0].end()];
        let wanted = [Point3::new(1.0, 0.5, 0.0), Point3::new(4.0, 2.0, 3.0)];
        for p in wanted {
            assert!(ends.iter().any(|q| q.distance_to(p) < 1e-9), "{ends:?}");
        }
        // A circle on a slope is an ellipse.
        let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
        let slope = line([-3.0, 0.0, -1.5], [3.0, 0.0, 1.5]);
        let made = curves_of_two_views([&circle, &slope], views, &tolerance()).unwrap();
        assert_eq!(made.len(), 1);
        assert!(made[0].is_closed());
        let domain = made[0].domain();
        for k in 0..50 {
            let p = made[0].point_at(domain.at(f64::from(k) / 50.0));
            assert!((p.x.hypot(p.y) - 2.0).abs() < 1e-4 && (p.z - 0.5 * p.x).abs() < 1e-4, "{p:?}");
        }
        // Two circles: two ellipses that cross, here in whatever pieces.
        let front: Curve = Circle::new(Plane::XZ, 2.0).unwrap().into();
        let made = curves_of_two_views([&circle, &front], views, &tolerance()).unwrap();
        let length: f64 = made.iter().map(Curve::length).sum();
        let ellipse: Curve =
            crate::Ellipse::new(Plane::XY, 8.0_f64.sqrt(), 2.0).unwrap().to_nurbs().unwrap().into();
        assert!((length - 2.0 * ellipse.length()).abs() < 1e-2, "{length}");
    }

    #[test]
    fn what_has_no_curve() {
        let (low, high) = (line([0.0; 3], [1.0, 1.0, 0.0]), line([3.0, 0.0, 0.0], [4.0, 0.0, 1.0]));
        assert!(
            curves_of_two_views([&low, &high], [Vector3::Z, Vector3::Y], &tolerance()).unwrap().is_empty()
        );
        assert!(curves_of_two_views([&low, &high], [Vector3::Z, -Vector3::Z], &tolerance()).is_err());
        assert!(curves_of_two_views([&low, &high], [Vector3::ZERO, Vector3::Z], &tolerance()).is_err());
    }
}
