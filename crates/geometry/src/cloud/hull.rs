use super::{check_points2, turn};
use crate::thresholds;
use crate::{Point2, Result, Vector2};

/// Fewer points are sorted as they are.
const WORTH_THINNING: usize = 64;

/// The corners of the convex hull of points in a plane, counter-clockwise from the leftmost (of those the lowest), by
/// their indices. Points on its straight sides are no corners; of points in one place the first counts. Points on one
/// line give the two ends, points in one place one.
///
/// The monotone chain of A. M. Andrew (*Another efficient algorithm for convex hulls in two dimensions*, 1979) with
/// exact turns, after what lies well inside an octagon of extreme points is set aside (S. Akl, G. Toussaint, 1978).
///
/// # Errors
/// A coordinate is not finite or beyond 3.2e60, or there are 2²⁹ points or more.
pub fn convex_hull(points: &[Point2]) -> Result<Vec<usize>> {
    check_points2(points)?;
    let mut order = if points.len() < WORTH_THINNING {
        points.iter().copied().zip(0..).collect()
    } else {
        outer_points(points)
    };
    order.sort_unstable_by(|(p, i): &(Point2, u32), (q, j)| {
        p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(i.cmp(j))
    });
    order.dedup_by(|a, b| a.0 == b.0);
    if order.len() < 3 {
        return Ok(order.iter().map(|&(_, i)| i as usize).collect());
    }
    let mut out: Vec<(Point2, u32)> = Vec::new();
    chain(&mut out, order.iter().copied());
    out.pop();
    let mut back = Vec::new();
    chain(&mut back, order.iter().rev().copied());
    back.pop();
    out.extend(back);
    Ok(out.into_iter().map(|(_, i)| i as usize).collect())
}

/// Goes along points in order and keeps to the right: whatever does not turn left is dropped.
fn chain(out: &mut Vec<(Point2, u32)>, points: impl Iterator<Item = (Point2, u32)>) {
    for p in points {
        while let [.., a, b] = out.as_slice() {
            if turn(a.0, b.0, p.0) > 0.0 {
                break;
            }
            out.pop();
        }
        out.push(p);
    }
}

/// The points that are not well inside the octagon of the points farthest in eight directions.
fn outer_points(points: &[Point2]) -> Vec<(Point2, u32)> {
    let first = points.first().copied().unwrap_or_default();
    // Four directions and their opposites in one pass.
    let (mut far, mut low, mut high) = ([first; 8], [f64::INFINITY; 4], [f64::NEG_INFINITY; 4]);
    for &p in points {
        for (k, s) in [p.x, p.x + p.y, p.y, p.y - p.x].into_iter().enumerate() {
            if s > high[k] {
                (high[k], far[k]) = (s, p);
            }
            if s < low[k] {
                (low[k], far[k + 4]) = (s, p);
            }
        }
    }
    // A side as n·p < c for what is inside; c a little less, so that rounding sets nothing aside that counts.
    let scale = far.iter().fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
    let sides: Vec<(Vector2, f64)> = (0..8)
        .filter_map(|k| {
            let (a, b) = (far[k], far[(k + 1) % 8]);
            let n = (b - a).perpendicular();
            (a != b).then(|| (n, n.dot(a.to_vector()) + thresholds::ROUNDING * n.length() * scale))
        })
        .collect();
    let inside = |p: Point2| sides.len() > 2 && sides.iter().all(|(n, c)| n.x * p.x + n.y * p.y > *c);
    points.iter().copied().zip(0..).filter(|&(p, _)| !inside(p)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hulls_of_few_points() {
        let hull = |points: &[[f64; 2]]| {
            convex_hull(&points.iter().copied().map(Point2::from).collect::<Vec<_>>()).unwrap()
        };
        assert_eq!(hull(&[]), [0_usize; 0]);
        assert_eq!(hull(&[[1.0, 1.0]]), [0]);
        assert_eq!(hull(&[[1.0, 1.0], [1.0, 1.0]]), [0]);
        assert_eq!(hull(&[[1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [0.0, 0.0]]), [3, 1]);
        assert_eq!(
            hull(&[[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0], [0.5, 0.0], [0.5, 0.5]]),
            [3, 2, 1, 0]
        );
        assert!(convex_hull(&[Point2::new(f64::NAN, 0.0)]).is_err());
    }

    #[test]
    fn a_grid_and_a_circle() {
        let grid: Vec<Point2> =
            (0..2500).map(|i| Point2::new(f64::from(i % 50) / 10.0, f64::from(i / 50) / 10.0)).collect();
        assert_eq!(convex_hull(&grid).unwrap(), [0, 49, 2499, 2450]);
        let circle: Vec<Point2> =
            (0..500).map(|i| Vector2::X.rotated(f64::from(i) * 0.01).to_point()).collect();
        assert_eq!(convex_hull(&circle).unwrap().len(), 500);
        let same = vec![Point2::new(0.1, 0.7); 100];
        assert_eq!(convex_hull(&same).unwrap(), [0]);
        let line: Vec<Point2> = (0..100).map(|i| Point2::new(f64::from(i), 0.5)).collect();
        assert_eq!(convex_hull(&line).unwrap(), [0, 99]);
    }
}
