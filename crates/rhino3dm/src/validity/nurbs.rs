//! Knots, control points and weights.

use super::Verdict;
use super::numbers::is_set;
use crate::{NurbsForm, NurbsSurfaceForm};

/// A knot vector of so many control points, as many knots as those and the order less two.
fn knots(order: i32, count: usize, knots: &[f64], what: &str) -> Verdict {
    let order = usize::try_from(order).unwrap_or(0);
    let said = |why: &str| Err(format!("the knots{what} {why}"));
    if order < 2 {
        return said("are of an order below 2");
    }
    if count < order {
        return said("have fewer control points than their order");
    }
    if knots.len() != count + order - 2 {
        return said("are too few or too many");
    }
    if !knots.iter().copied().all(is_set) {
        return said("hold what is no number");
    }
    let rises = |from: usize, to: usize| knots.get(from).zip(knots.get(to)).is_some_and(|(a, b)| a < b);
    if !rises(order - 2, order - 1) || !rises(count - 2, count - 1) {
        return said("have no first or last span");
    }
    if !knots.is_sorted() {
        return said("do not increase");
    }
    if !(0..count - 1).all(|i| rises(i, i + order - 1)) {
        return said("repeat a knot more often than the degree");
    }
    Ok(())
}

/// Control points, weights among them, are numbers.
fn control_points(numbers: &[f64], width: usize, count: usize) -> Verdict {
    if count.checked_mul(width) != Some(numbers.len()) {
        return Err("it has too few or too many control points".into());
    }
    match numbers.iter().copied().all(is_set) {
        true => Ok(()),
        false => Err("a control point is no number".into()),
    }
}

fn width(dimension: i32, rational: bool) -> Result<usize, String> {
    match usize::try_from(dimension) {
        Ok(dimension) if dimension > 0 => Ok(dimension.saturating_add(usize::from(rational))),
        _ => Err(format!("its dimension is {dimension}")),
    }
}

/// A NURBS curve.
pub(super) fn curve(form: &NurbsForm) -> Verdict {
    let width = width(form.dimension, form.rational)?;
    let count = form.numbers.len() / width;
    knots(form.order, count, &form.knots, "")?;
    control_points(&form.numbers, width, count)?;
    if form.rational {
        weights(form, width)?;
        // A rational line must have a length; a plain one need not.
        if form.dimension <= 3 && form.order == 2 && count == 2 {
            let point = |i: usize| -> Vec<f64> {
                let numbers = form.numbers.get(i * width..(i + 1) * width).unwrap_or_default();
                let weight = numbers.last().copied().unwrap_or(1.0);
                numbers.iter().take(width - 1).map(|x| x / weight).collect()
            };
            if point(0) == point(1) {
                return Err("it is a line without length".into());
            }
        }
    }
    Ok(())
}

/// The denominator is zero nowhere, as far as weights tell: no run of zeros as long as the order, and where two weights
/// of a span of full knots stand side by side they have one sign.
fn weights(form: &NurbsForm, width: usize) -> Verdict {
    let order = usize::try_from(form.order).unwrap_or(0);
    let mut zeros = 0;
    let mut sign = 0.0;
    for (i, weight) in form.numbers.iter().skip(width - 1).step_by(width).copied().enumerate() {
        zeros = if weight == 0.0 { zeros + 1 } else { 0 };
        if zeros >= order {
            return Err("its weights are zero over a span".into());
        }
        if !is_full(&form.knots, order, i) {
            continue;
        }
        if weight == 0.0 {
            return Err("a weight at a full knot is zero".into());
        }
        if sign == 0.0 {
            sign = weight.signum();
        } else if weight * sign <= 0.0 {
            return Err("its weights change their sign".into());
        }
    }
    Ok(())
}

/// Whether the curve goes through a control point because as many knots as its degree fall together there.
fn is_full(knots: &[f64], order: usize, i: usize) -> bool {
    let last = order.checked_sub(2).and_then(|n| i.checked_add(n));
    knots.get(i).zip(last.and_then(|j| knots.get(j))).is_some_and(|(a, b)| a == b)
}

/// A NURBS surface.
pub(super) fn surface(form: &NurbsSurfaceForm) -> Verdict {
    let width = width(form.dimension, form.rational)?;
    let counts = form.counts.map(|n| usize::try_from(n).unwrap_or(0));
    for ((order, count), (list, what)) in
        form.orders.into_iter().zip(counts).zip(form.knots.iter().zip([" in u", " in v"]))
    {
        knots(order, count, list, what)?;
    }
    control_points(&form.numbers, width, counts[0].saturating_mul(counts[1]))
}
