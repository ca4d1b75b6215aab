//! Places where two surfaces have one tangent plane: found by Newton's method, and told by how the surfaces bend there.

use katydid_elementary::Elementary;

use crate::Vector3;
use crate::chart::Chart;
use crate::chart::thresholds::{FOUND, LEAST_BEND, NO_BEND, ONE_PLANE, TOUCH_DAMPING};
use crate::trace::{Condition, Four, Pair, on, solved};

/// Newton's method on a regular place is done in far fewer steps.
const MOST_STEPS: usize = 40;

/// A condition with its derivatives by the four parameters, in units of length, of shares of the domains.
type Row = ([f64; 4], f64);

/// The parameters near `x` at which the surfaces have parallel tangent planes and the way between them is square to both;
/// on a curve of such places that which meets the condition, else the nearest. `None` without convergence.
///
/// # Method
/// Four equations in the parameters: the way times both derivatives of the first surface is 0, and its normal times both of
/// the second. Their Jacobian is regular where the difference of the second fundamental forms is (X. Ye and T. Maekawa,
/// *Differential geometry of intersection curves of two surfaces*, CAGD 16, 1999, for the conditions). Along a curve it has
/// rank 3, and the condition makes it regular: least squares, with damping where a step does not help.
pub(super) fn touching(pair: &Pair<'_>, x: Four, condition: Option<Condition>) -> Option<Four> {
    let mut x = x;
    let mut rest = size_of(&rows(pair, x, condition)?);
    let mut damping = 0.0;
    for _ in 0..MOST_STEPS {
        let rows = rows(pair, x, condition)?;
        let mut m = [[0.0; 5]; 4];
        for (slopes, value) in &rows {
            for i in 0..4 {
                for j in 0..4 {
                    m[i][j] += slopes[i] * slopes[j];
                }
                m[i][4] -= slopes[i] * value;
            }
        }
        let largest = (0..4).map(|i| m[i][i]).fold(0.0, f64::max);
        for (i, row) in m.iter_mut().enumerate() {
            row[i] += damping * largest;
        }
        let step = solved(m)?;
        let next: Four = std::array::from_fn(|k| x[k] + step[k] * pair.domain(k).length());
        let jets = pair.jets(x);
        let moved = (0..4)
            .map(|k| (jets[k / 2][1 + k % 2] * (step[k] * pair.domain(k).length())).length())
            .fold(0.0, f64::max);
        let left = self::rows(pair, next, condition).map_or(f64::INFINITY, |r| size_of(&r));
        if moved <= FOUND * pair.size() {
            return Some(if left <= rest { next } else { x });
        }
        if left < rest {
            (x, rest, damping) = (next, left, damping * 0.1);
            if damping < TOUCH_DAMPING {
                damping = 0.0;
            }
        } else {
            damping = (damping * 10.0).max(TOUCH_DAMPING);
            if damping > 1.0 {
                return None;
            }
        }
    }
    None
}

fn size_of(rows: &[Row]) -> f64 {
    rows.iter().map(|r| r.1 * r.1).sum::<f64>().sqrt()
}

/// The conditions at `x`; `None` where a surface is singular.
fn rows(pair: &Pair<'_>, x: Four, condition: Option<Condition>) -> Option<Vec<Row>> {
    let [[a, au, av, auu, auv, avv], [b, bs, bt, bss, bst, btt]] =
        [0, 1].map(|s| pair.charts[s].second_jet(on(x, s)));
    let shares = |row: [f64; 4]| -> [f64; 4] { std::array::from_fn(|k| row[k] * pair.domain(k).length()) };
    let way = a - b;
    let normal = au.cross(av);
    let turns = [auu.cross(av) + au.cross(auv), auv.cross(av) + au.cross(avv)];
    let mut out: Vec<Row> = Vec::with_capacity(5);
    let mut add = |value: f64, slopes: [f64; 4], unit: f64| {
        let row = (shares(slopes).map(|s| s * unit), value * unit);
        row.0.iter().chain([&row.1]).all(|x| x.is_finite()).then(|| out.push(row))
    };
    for (own, [by_u, by_v]) in [(au, [auu, auv]), (av, [auv, avv])] {
        let slopes = [au.dot(own) + way.dot(by_u), av.dot(own) + way.dot(by_v), -bs.dot(own), -bt.dot(own)];
        add(way.dot(own), slopes, 1.0 / own.length())?;
    }
    for (other, [by_s, by_t]) in [(bs, [bss, bst]), (bt, [bst, btt])] {
        let slopes = [turns[0].dot(other), turns[1].dot(other), normal.dot(by_s), normal.dot(by_t)];
        add(normal.dot(other), slopes, pair.size() / (normal.length() * other.length()))?;
    }
    match condition {
        None => {}
        Some(Condition::Slice { through, across }) => {
            let half = |v: Vector3| 0.5 * across.dot(v);
            add(across.dot((a + b) * 0.5 - through), [half(au), half(av), half(bs), half(bt)], 1.0)?;
        }
        Some(Condition::Fixed { parameter, value }) => {
            let mut slopes = [0.0; 4];
            slopes[parameter] = 1.0;
            let unit = [au, av, bs, bt][parameter].length();
            add(x[parameter] - value, slopes, unit)?;
        }
    }
    Some(out)
}

/// How two surfaces bend away from each other in the tangent plane that they have in common.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bends {
    /// The principal values of the difference of both second fundamental forms, the smaller one first.
    pub(super) values: [f64; 2],
    /// The unit directions that belong to them.
    pub(super) directions: [Vector3; 2],
}

impl Bends {
    /// Values up to this are none, for surfaces of a size.
    pub(super) fn flat(&self, size: f64) -> f64 {
        let [low, high] = self.values;
        NO_BEND * (low.abs() + high.abs()).max(LEAST_BEND / size)
    }

    /// The direction in which the surfaces stay together, if there is just one.
    pub(super) fn null_direction(&self, size: f64) -> Option<Vector3> {
        let flat = self.flat(size);
        match self.values.map(|x| x.abs() <= flat) {
            [true, false] => Some(self.directions[0]),
            [false, true] => Some(self.directions[1]),
            _ => None,
        }
    }
}

/// How the surfaces bend; `None` where they have no tangent plane in common.
pub(super) fn bends(pair: &Pair<'_>, x: Four) -> Option<Bends> {
    let forms = [0, 1].map(|s| {
        let [_, su, sv, suu, suv, svv] = pair.charts[s].second_jet(on(x, s));
        (su, sv, su.cross(sv).unitized(), [suu, suv, svv])
    });
    let normal = forms[0].2?;
    let other = forms[1].2?;
    if normal.cross(other).length() > ONE_PLANE {
        return None;
    }
    let e = forms[0].0.unitized()?;
    let f = normal.cross(e);
    let mut difference = [0.0; 3];
    for (s, (su, sv, _, [suu, suv, svv])) in forms.iter().enumerate() {
        let jet = [Vector3::ZERO, *su, *sv];
        let [p, q] = [Chart::lifted(&jet, e)?, Chart::lifted(&jet, f)?];
        let bend = |a: [f64; 2], b: [f64; 2]| {
            (*suu * (a[0] * b[0]) + *suv * (a[0] * b[1] + a[1] * b[0]) + *svv * (a[1] * b[1])).dot(normal)
        };
        let sign = if s == 0 { 1.0 } else { -1.0 };
        for (slot, value) in difference.iter_mut().zip([bend(p, p), bend(p, q), bend(q, q)]) {
            *slot += sign * value;
        }
    }
    let [a, b, c] = difference;
    let (mean, half) = (0.5 * (a + c), (0.5 * (a - c)).hypotenuse(b));
    let (sin, cos) = (0.5 * (2.0 * b).arctangent_of(a - c)).sine_cosine();
    let directions = [f * cos - e * sin, e * cos + f * sin];
    Some(Bends { values: [mean - half, mean + half], directions })
}
