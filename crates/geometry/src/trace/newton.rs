//! Points of the common curve by Newton's method in four unknowns.

use super::thresholds::{MET, PIVOT, ROOM};
use super::{Four, Pair};
use crate::Vector3;

/// What tells a point of the curve from the others.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Condition {
    /// It lies in the plane through a point across a direction.
    Slice { through: Vector3, across: Vector3 },
    /// One of the four parameters has a value.
    Fixed { parameter: usize, value: f64 },
}

/// Newton's method converges in far fewer steps or not at all.
const MOST_STEPS: usize = 16;

impl Pair<'_> {
    /// The point of the curve with the condition, from parameters near it. `None` when the method does not converge to
    /// a point on both surfaces.
    pub(crate) fn polished(&self, start: Four, condition: Condition) -> Option<Four> {
        let mut x = start;
        let limit = 0.5 * self.size();
        let mut last = f64::INFINITY;
        let mut slow = 0;
        for _ in 0..MOST_STEPS {
            let jets = self.jets(x);
            let away = jets[0][0] - jets[1][0];
            // By shares of the domains, so that no direction's unit matters.
            let columns: [Vector3; 4] = std::array::from_fn(|k| {
                let sign = if k < 2 { 1.0 } else { -1.0 };
                jets[k / 2][1 + k % 2] * (sign * self.domain(k).length())
            });
            let mut m = [[0.0; 5]; 4];
            for (k, c) in columns.iter().enumerate() {
                (m[0][k], m[1][k], m[2][k]) = (c.x, c.y, c.z);
            }
            (m[0][4], m[1][4], m[2][4]) = (-away.x, -away.y, -away.z);
            match condition {
                Condition::Slice { through, across } => {
                    for k in 0..4 {
                        m[3][k] = 0.5 * across.dot(if k < 2 { columns[k] } else { -columns[k] });
                    }
                    m[3][4] = -across.dot((jets[0][0] + jets[1][0]) * 0.5 - through);
                }
                Condition::Fixed { parameter, value } => {
                    // In the unit of length of that direction, as the other rows are.
                    let unit = columns[parameter].length().max(ROOM * limit);
                    m[3][parameter] = unit;
                    m[3][4] = unit * (value - x[parameter]) / self.domain(parameter).length();
                }
            }
            let step = solved(m)?;
            let moved = (0..4).map(|k| (step[k].abs()) * columns[k].length()).fold(0.0, f64::max);
            if !(moved < limit) {
                return None;
            }
            for k in 0..4 {
                x[k] += step[k] * self.domain(k).length();
            }
            if moved <= self.noise {
                break;
            }
            slow = if moved > 0.5 * last { slow + 1 } else { 0 };
            if slow > 3 {
                break;
            }
            last = moved;
        }
        if let Condition::Fixed { parameter, value } = condition {
            // To the last bit, so that a place on a side is on it.
            x[parameter] = value;
        }
        let ends = [0, 1].map(|s| self.charts[s].jet(super::on(x, s))[0]);
        let gap = (ends[0] - ends[1]).length();
        (gap <= MET * self.noise).then_some(x)
    }
}

/// The solution of four linear equations, by elimination with full pivoting. Unknowns without any influence stay as they
/// are: at a pole a parameter moves nothing.
pub(crate) fn solved(mut m: [[f64; 5]; 4]) -> Option<Four> {
    let largest = m.iter().flat_map(|r| &r[..4]).fold(0.0, |a: f64, x| a.max(x.abs()));
    if !(largest > 0.0) || !largest.is_finite() {
        return None;
    }
    let mut order = [0, 1, 2, 3];
    let mut rank = 4;
    for k in 0..4 {
        let (mut best, mut at) = (0.0, (k, k));
        for i in k..4 {
            for j in k..4 {
                if m[i][j].abs() > best {
                    (best, at) = (m[i][j].abs(), (i, j));
                }
            }
        }
        if best <= PIVOT * largest {
            rank = k;
            break;
        }
        m.swap(k, at.0);
        for row in &mut m {
            row.swap(k, at.1);
        }
        order.swap(k, at.1);
        for i in k + 1..4 {
            let factor = m[i][k] / m[k][k];
            for j in k..5 {
                m[i][j] -= factor * m[k][j];
            }
        }
    }
    let mut y = [0.0; 4];
    for k in (0..rank).rev() {
        let sum: f64 = (k + 1..4).map(|j| m[k][j] * y[j]).sum();
        y[k] = (m[k][4] - sum) / m[k][k];
    }
    let mut out = [0.0; 4];
    for k in 0..4 {
        out[order[k]] = y[k];
    }
    out.iter().all(|x| x.is_finite()).then_some(out)
}
