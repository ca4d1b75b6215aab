use super::check_points3;
use crate::box_tree::{Bounds, BoxTree, bounds_of};
#[cfg(feature = "parallel")]
use crate::cancellation::CancellationToken;
use crate::{Point3, Result, cancellation};

/// So many points lie side by side in a leaf: it is quicker to look at them all than to go farther down.
const RUN: usize = 8;

/// Points in a tree, to find those near a place.
///
/// A k-d tree with runs of points for leaves (Friedman, Bentley and Finkel 1977): the points are kept in the order of the
/// leaves, so that a search reads memory that lies together.
#[derive(Debug, Clone)]
pub struct PointTree {
    /// Over the runs: run `k` has the points from `k * RUN`.
    tree: BoxTree,
    points: Vec<Placed>,
}

/// A point and its index in the list that was given.
type Placed = ([f64; 3], u32);

/// A point found: the squared distance and the index.
type Found = (f64, u32);

impl PointTree {
    /// The tree over points.
    ///
    /// # Errors
    /// A coordinate is not finite or beyond 3.2e60, or there are 2²⁹ points or more.
    pub fn new(points: &[Point3]) -> Result<Self> {
        check_points3(points)?;
        let mut points: Vec<Placed> = (0..).zip(points).map(|(i, &p)| (p.into(), i)).collect();
        arrange(&mut points);
        let boxes: Vec<Bounds> = points.chunks(RUN).map(|run| bounds_of(run.iter().map(|p| p.0))).collect();
        Ok(Self { tree: BoxTree::in_order(&boxes), points })
    }

    fn run(&self, k: usize) -> &[Placed] {
        let start = (k * RUN).min(self.points.len());
        let end = (start + RUN).min(self.points.len());
        self.points.get(start..end).unwrap_or_default()
    }

    /// The index of the point nearest to a place, of equally near ones the first; `None` without points.
    pub fn closest(&self, place: Point3) -> Option<usize> {
        let q: [f64; 3] = place.into();
        let mut best = (f64::INFINITY, u32::MAX);
        self.tree.visit_near(&q, f64::INFINITY, |k| {
            for (p, i) in self.run(k) {
                let d = squared_distance(p, &q);
                if d < best.0 || (d == best.0 && *i < best.1) {
                    best = (d, *i);
                }
            }
            best.0.next_up()
        });
        (best.1 != u32::MAX).then_some(best.1 as usize)
    }

    /// The indices of the points nearest to a place, at most `count`, the nearest first, of equally near ones the
    /// first. Only those are looked at that are neither nearer than `least` nor farther than `most`, and not `skip`.
    pub fn nearest(
        &self,
        place: Point3,
        count: usize,
        [least, most]: [f64; 2],
        skip: Option<usize>,
    ) -> Vec<usize> {
        let mut found = Vec::new();
        self.nearest_into(place.into(), count, [least, most], skip, &mut found);
        found.into_iter().map(|(_, i)| i as usize).collect()
    }

    pub(super) fn nearest_into(
        &self,
        q: [f64; 3],
        count: usize,
        [least, most]: [f64; 2],
        skip: Option<usize>,
        found: &mut Vec<Found>,
    ) {
        found.clear();
        if count == 0 || !(most >= 0.0) {
            return;
        }
        let low = if least > 0.0 { least * least } else { 0.0 };
        // A little more, so that points at the limit are seen.
        let limit = |squared: f64| squared.next_up();
        let mut reach = limit(most * most);
        let skip = skip.and_then(|i| u32::try_from(i).ok());
        self.tree.visit_near(&q, reach, |k| {
            for &(p, i) in self.run(k) {
                let d = squared_distance(&p, &q);
                if d < low || !(d < reach) || Some(i) == skip {
                    continue;
                }
                let candidate = (d, i);
                let before = |a: &Found| a.0.total_cmp(&candidate.0).then(a.1.cmp(&candidate.1)).is_lt();
                if found.len() < count || found.last().is_some_and(|last| !before(last)) {
                    found.insert(found.partition_point(before), candidate);
                    found.truncate(count);
                    if found.len() == count {
                        reach = found.last().map_or(reach, |f| limit(f.0));
                    }
                }
            }
            reach
        });
    }

    /// Calls `visit` with the points in boxes that are `wanted`; what is visited may change what is wanted.
    pub(super) fn visit_wanted<S>(
        &self,
        state: &mut S,
        wanted: impl Fn(&S, &Bounds) -> bool,
        mut visit: impl FnMut(&mut S, usize),
    ) {
        self.tree.visit_wanted(state, &wanted, |state, k| {
            for &(p, i) in self.run(k) {
                if wanted(state, &[p, p]) {
                    visit(state, i as usize);
                }
            }
        });
    }
}

/// Puts points into the order of the leaves of a tree that halves its list of runs, as [`BoxTree::in_order`] does: halved
/// along the longest side. The recursion is as deep as the tree.
fn arrange(points: &mut [Placed]) {
    let runs = points.len().div_ceil(RUN);
    if runs < 2 {
        return;
    }
    let bounds = bounds_of(points.iter().map(|p| p.0));
    let side = |c: usize| bounds[1][c] - bounds[0][c];
    let longest = (1..3).fold(0, |best, c| if side(c) > side(best) { c } else { best });
    let half = runs / 2 * RUN;
    points.select_nth_unstable_by(half, |a, b| a.0[longest].total_cmp(&b.0[longest]));
    let (left, right) = points.split_at_mut(half);
    arrange(left);
    arrange(right);
}

fn squared_distance(p: &[f64; 3], q: &[f64; 3]) -> f64 {
    let d: [f64; 3] = std::array::from_fn(|k| p[k] - q[k]);
    d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
}

/// For every point the indices of its nearest others, at most `count` of them, the nearest first, at distances from
/// `least` to `most`.
///
/// # Errors
/// As [`PointTree::new`].
pub fn proximity(points: &[Point3], count: usize, distances: [f64; 2]) -> Result<Vec<Vec<usize>>> {
    let tree = PointTree::new(points)?;
    let near = |(i, &p): (usize, &Point3)| {
        cancellation::check_now()?;
        Ok(tree.nearest(p, count, distances, Some(i)))
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        let token = CancellationToken::now();
        let near = |at: (usize, &Point3)| token.during(|| near(at));
        let all = points.par_iter().enumerate().with_min_len(256).map(near);
        crate::parallel::waiting(|| all.collect())
    }
    #[cfg(not(feature = "parallel"))]
    points.iter().enumerate().map(near).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_of_a_row() {
        let row: Vec<Point3> = (0..10).map(|i| Point3::new(f64::from(i), 0.0, 0.0)).collect();
        let all = [0.0, f64::INFINITY];
        assert_eq!(proximity(&row, 3, all).unwrap()[4], [3, 5, 2]);
        assert_eq!(proximity(&row, 2, [1.5, 2.0]).unwrap()[0], [2]);
        assert_eq!(proximity(&row, 99, [0.0, 1.0]).unwrap()[9], [8]);
        assert_eq!(proximity(&row, 0, all).unwrap()[9], [0_usize; 0]);
        assert!(proximity(&[Point3::new(f64::NAN, 0.0, 0.0)], 1, all).is_err());
        let tree = PointTree::new(&row).unwrap();
        assert_eq!(tree.nearest(Point3::new(2.6, 0.0, 0.0), 1, all, None), [3]);
        assert_eq!(tree.closest(Point3::new(2.6, 0.0, 0.0)), Some(3));
        // Halfway between two: the first.
        assert_eq!(tree.closest(Point3::new(4.5, 1.0, 0.0)), Some(4));
        let empty = PointTree::new(&[]).unwrap();
        assert!(empty.nearest(Point3::ORIGIN, 3, all, None).is_empty());
        assert_eq!(empty.closest(Point3::ORIGIN), None);
    }

    /// As many points as fill runs, one fewer and one more, points that lie together and points in a row, against all
    /// looked at.
    #[test]
    fn the_closest_is_that_of_all_looked_at() {
        let wave = |i: usize, k: f64| (i as f64 * k).sin() * 10.0;
        for n in [1, 7, 8, 9, 16, 17, 63, 64, 65, 1000] {
            let spread: Vec<Point3> =
                (0..n).map(|i| Point3::new(wave(i, 1.3), wave(i, 2.7), wave(i, 0.7))).collect();
            let row: Vec<Point3> = (0..n).map(|i| Point3::new((i % 5) as f64, 0.0, 0.0)).collect();
            for points in [spread, row] {
                let tree = PointTree::new(&points).unwrap();
                for k in 0..50 {
                    let place = Point3::new(wave(k, 3.1), wave(k, 1.9), wave(k, 5.3));
                    let squared = |i: &usize| squared_distance(&points[*i].into(), &place.into());
                    let mut all: Vec<usize> = (0..n).collect();
                    all.sort_by(|a, b| squared(a).total_cmp(&squared(b)));
                    assert_eq!(tree.closest(place), all.first().copied());
                    let near: Vec<usize> = all.iter().copied().take(5).collect();
                    assert_eq!(tree.nearest(place, 5, [0.0, f64::INFINITY], None), near);
                    let mut seen = Vec::new();
                    let within = |b: &Bounds| crate::box_tree::squared_distance_to(b, &place.into()) <= 25.0;
                    tree.visit_wanted(&mut seen, |_, b| within(b), |seen, i| seen.push(i));
                    seen.sort_unstable();
                    let want: Vec<usize> = (0..n).filter(|i| squared(i) <= 25.0).collect();
                    assert_eq!(seen, want);
                }
            }
        }
    }
}
