//! Which boxes come near each other.

use crate::BoundingBox;

/// Pairs of boxes that come within reach of each other, by a sweep along x: within one list, or of one and another.
/// Sorted; `None` when there are more than `most`.
pub(crate) fn near_pairs(
    first: &[BoundingBox],
    second: Option<&[BoundingBox]>,
    reach: f64,
    most: usize,
) -> Option<Vec<(usize, usize)>> {
    let all: Vec<&BoundingBox> = first.iter().chain(second.unwrap_or(&[])).collect();
    let own = first.len();
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&i, &j| all[i].min.x.total_cmp(&all[j].min.x));
    let mut out = Vec::new();
    for (k, &i) in order.iter().enumerate() {
        for &j in order.get(k + 1..).unwrap_or(&[]) {
            let (p, q) = (all[i], all[j]);
            if q.min.x > p.max.x + reach {
                break;
            }
            let apart = |a: f64, b: f64, c: f64, d: f64| a > d + reach || c > b + reach;
            if (second.is_some() && (i < own) == (j < own))
                || apart(p.min.y, p.max.y, q.min.y, q.max.y)
                || apart(p.min.z, p.max.z, q.min.z, q.max.z)
            {
                continue;
            }
            if out.len() >= most {
                return None;
            }
            let (low, high) = (i.min(j), i.max(j));
            out.push((low, if second.is_some() { high - own } else { high }));
        }
    }
    out.sort_unstable();
    Some(out)
}
