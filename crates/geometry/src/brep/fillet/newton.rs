//! Small systems of equations, by Newton's method.

/// The most steps.
const STEPS: usize = 40;
/// How often a step that makes things worse is halved.
const HALVINGS: usize = 8;
/// What is left of the equations, as a part of the size of the figure, when they count as solved.
const SOLVED: f64 = 1e-10;

/// The solution of linear equations, by elimination with the largest pivot of each column.
pub(super) fn linear<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> Option<[f64; N]> {
    for k in 0..N {
        let pivot = (k..N).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs()))?;
        if !(a[pivot][k].abs() > 0.0 && a[pivot][k].is_finite()) {
            return None;
        }
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..N {
            let factor = a[i][k] / a[k][k];
            for j in k..N {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..N).rev() {
        for j in k + 1..N {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
    b.iter().all(|x| x.is_finite()).then_some(b)
}

/// The derivatives of equations by central differences, each column for one of the given steps.
pub(super) fn jacobian<const N: usize>(
    x: &[f64; N],
    steps: &[f64; N],
    f: impl Fn(&[f64; N]) -> Option<[f64; N]>,
) -> Option<[[f64; N]; N]> {
    let mut out = [[0.0; N]; N];
    for j in 0..N {
        let (mut ahead, mut behind) = (*x, *x);
        ahead[j] += steps[j];
        behind[j] -= steps[j];
        let (ahead, behind) = (f(&ahead)?, f(&behind)?);
        for (row, (a, b)) in out.iter_mut().zip(ahead.iter().zip(behind)) {
            row[j] = 0.5 * (a - b);
        }
    }
    Some(out)
}

fn norm<const N: usize>(f: &[f64; N]) -> f64 {
    f.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Where all equations are 0, from a place nearby. Their values are lengths, `size` is that of the figure, and `steps`
/// are small changes of the unknowns.
pub(super) fn solve<const N: usize>(
    start: [f64; N],
    steps: &[f64; N],
    size: f64,
    f: impl Fn(&[f64; N]) -> Option<[f64; N]>,
) -> Option<[f64; N]> {
    let mut x = start;
    let mut value = f(&x)?;
    for _ in 0..STEPS {
        let left = norm(&value);
        if left == 0.0 {
            break;
        }
        let slopes = jacobian(&x, steps, &f)?;
        // Where the equations touch, as those of tangent surfaces do, the last steps have no slope.
        let Some(move_by) = linear(slopes, value) else { break };
        let mut factor = 1.0;
        let mut better = None;
        for _ in 0..HALVINGS {
            let mut next = x;
            for j in 0..N {
                next[j] -= factor * move_by[j] * steps[j];
            }
            if let Some(at) = f(&next).filter(|at| norm(at) < left) {
                better = Some((next, at));
                break;
            }
            factor *= 0.5;
        }
        // Nothing better within rounding.
        let Some((next, at)) = better else { break };
        (x, value) = (next, at);
    }
    (norm(&value) <= SOLVED * size).then_some(x)
}
