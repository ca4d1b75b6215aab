use super::check_points3;
use crate::box_tree::{Bounds, BoxTree};
#[cfg(feature = "parallel")]
use crate::patience::Patience;
use crate::{Point3, Result, patience};

/// Points in a tree, to find those near a place.
#[derive(Debug, Clone)]
pub struct PointTree {
    tree: BoxTree,
    points: Vec<[f64; 3]>,
}

/// A point found: the squared distance and the index.
type Found = (f64, u32);

impl PointTree {
    /// The tree over points.
    ///
    /// # Errors
    /// A coordinate is not finite or beyond 3.2e60, or there are 2²⁹ points or more.
    pub fn new(points: &[Point3]) -> Result<Self> {
        check_points3(points)?;
        let points: Vec<[f64; 3]> = points.iter().map(|&p| p.into()).collect();
        let boxes: Vec<_> = points.iter().map(|&p| [p, p]).collect();
        Ok(Self { tree: BoxTree::by_place(&boxes), points })
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
        self.tree.visit_near(&q, reach, |i| {
            let Some(p) = self.points.get(i) else { return reach };
            let d = squared_distance(p, &q);
            if d < low || Some(i) == skip {
                return reach;
            }
            let candidate = (d, i as u32);
            let before = |a: &Found| a.0.total_cmp(&candidate.0).then(a.1.cmp(&candidate.1)).is_lt();
            if found.len() < count || found.last().is_some_and(|last| !before(last)) {
                found.insert(found.partition_point(before), candidate);
                found.truncate(count);
                if found.len() == count {
                    reach = found.last().map_or(reach, |f| limit(f.0));
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
        visit: impl FnMut(&mut S, usize),
    ) {
        self.tree.visit_wanted(state, wanted, visit);
    }
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
        patience::check_now()?;
        Ok(tree.nearest(p, count, distances, Some(i)))
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        let patience = Patience::now();
        let near = |at: (usize, &Point3)| patience.during(|| near(at));
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
        assert!(PointTree::new(&[]).unwrap().nearest(Point3::ORIGIN, 3, all, None).is_empty());
    }
}
