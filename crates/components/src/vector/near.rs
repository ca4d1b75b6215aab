//! Which points of a list lie near each other.

use katydid_geometry::Point3;

/// Points in order of x, so that those near a place are found in a short run.
pub(super) struct ByX<'a> {
    points: &'a [Point3],
    order: Vec<usize>,
}

impl<'a> ByX<'a> {
    pub(super) fn new(points: &'a [Point3]) -> Self {
        let mut order: Vec<usize> = (0..points.len()).collect();
        let x = |i: usize| points.get(i).map_or(0.0, |p| p.x);
        order.sort_by(|&a, &b| x(a).total_cmp(&x(b)));
        Self { points, order }
    }

    /// The indices of the points at most `distance` from `p`, in order of x.
    pub(super) fn within(&self, p: Point3, distance: f64) -> impl Iterator<Item = usize> + '_ {
        let x = |i: usize| self.points.get(i).map_or(0.0, |q| q.x);
        // A little early and late, so that rounding of the bounds loses none.
        let slack = distance.abs() + 1e-12 * (p.x.abs() + distance.abs());
        let first = self.order.partition_point(|&i| x(i) < p.x - slack);
        let run = self.order.get(first..).unwrap_or(&[]);
        run.iter()
            .copied()
            .take_while(move |&i| x(i) <= p.x + slack)
            .filter(move |&i| self.points.get(i).is_some_and(|q| q.distance_to(p) <= distance))
    }
}
