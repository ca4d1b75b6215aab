//! Maths / Util: means, interpolation and smoothing of lists.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary;

use super::comparison;
use super::linear::Numbers;

/// The mean of a list of numbers, points, vectors, colours, domains or times. Nulls are skipped; an empty list
/// has none.
#[component("7986486c-621a-48fb-8f27-a28a22c91cc9", name = "Average", nick = "Avr", at = "Maths/Util")]
#[output("Arithmetic mean", "AM", "The mean.")]
fn average(
    /// The values.
    #[port("Input", "I")]
    input: List<Value>,
) -> Result<Option<Value>, Message> {
    mean(&input)
}

fn mean(input: &List<'_, Value>) -> Result<Option<Value>, Message> {
    let values = input.present().map(|value| Numbers::of(&value)).collect::<Result<Vec<_>, _>>()?;
    let n = values.len() as f64;
    let sum = Numbers::sum(values.into_iter().map(|value| (value, 1.0)))?;
    Ok(sum.map(|sum| sum.over(n).value()))
}

/// The arithmetic, geometric and harmonic means of a list of numbers.
///
/// The geometric and harmonic means are those of positive numbers; with others they are null.
#[component("0bb7682f-333c-4bb7-b6fe-91ed2c886100", name = "Mean", nick = "Mean", at = "Scalar/Util")]
#[output("Arithmetic mean", "AM", "The sum by the count.")]
#[output("Geometric mean", "GM", "The root of the product.")]
#[output("Harmonic mean", "HM", "The count by the sum of the inverses.")]
fn means(
    /// The numbers.
    #[port("Input", "I")]
    input: List<f64>,
) -> (Option<f64>, Option<f64>, Option<f64>) {
    let n = input.present().count() as f64;
    if n == 0.0 {
        return (None, None, None);
    }
    let over = |f: fn(f64) -> f64| input.present().map(f).sum::<f64>() / n;
    let positive = input.present().all(|x| x > 0.0);
    let harmonic = || over(f64::recip).recip();
    (Some(over(|x| x)), positive.then(|| over(f64::logarithm).exponential()), positive.then(harmonic))
}

/// The mean of a list in which each value counts as much as its weight.
///
/// The last weight serves for all values that have none of their own. Weights that add up to zero are an error.
#[component(
    "338666eb-14c5-4d9b-82e2-2b5be60655df",
    name = "Weighted Average",
    nick = "Wav",
    at = "Maths/Util"
)]
#[output("Arithmetic mean", "AM", "The mean.")]
fn weighted_average(
    /// Numbers, points, vectors, colours, domains or times. Nulls are skipped.
    #[port("Input", "I")]
    input: List<Value>,
    /// The weights.
    #[port("Weights", "W")]
    weights: List<f64>,
) -> Result<Option<Value>, Message> {
    let last = weights.len().saturating_sub(1);
    let mut terms = Vec::new();
    let mut total = 0.0;
    for (i, value) in input.iter().enumerate() {
        if let (Some(value), Some(weight)) = (value, weights.get(i.min(last))) {
            terms.push((Numbers::of(&value)?, weight));
            total += weight;
        }
    }
    let sum = Numbers::sum(terms)?;
    if total == 0.0 && sum.is_some() {
        return Err(Message::error("The weights add up to zero"));
    }
    Ok(sum.map(|sum| sum.over(total).value()))
}

/// How the values between two samples come about; the numbers are those that files hold.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Blend {
    Block,
    Linear,
    Cubic,
    Catmull,
}

impl Blend {
    fn read(context: &Context<'_>) -> Self {
        match context.settings().i32("Interpolation") {
            Some(1) => Self::Block,
            Some(3) => Self::Cubic,
            Some(4) => Self::Catmull,
            _ => Self::Linear,
        }
    }

    /// How much each of four samples in a row counts at `h` between the second and the third.
    fn weights(self, h: f64) -> [f64; 4] {
        let (h2, h3) = (h * h, h * h * h);
        match self {
            Self::Block if h < 0.5 => [0.0, 1.0, 0.0, 0.0],
            Self::Block => [0.0, 0.0, 1.0, 0.0],
            Self::Linear => [0.0, 1.0 - h, h, 0.0],
            // The polynomial with differences for slopes: d-c-a+b, a-b-(d-c-a+b), c-a, b.
            Self::Cubic => [-h3 + 2.0 * h2 - h, h3 - 2.0 * h2 + 1.0, -h3 + h2 + h, h3 - h2],
            // Catmull and Rom, with slopes of half those differences.
            Self::Catmull => [
                0.5 * (-h3 + 2.0 * h2 - h),
                0.5 * (3.0 * h3 - 5.0 * h2 + 2.0),
                0.5 * (-3.0 * h3 + 4.0 * h2 + h),
                0.5 * (h3 - h2),
            ],
        }
    }
}

/// The value at a place in a list, between its items too: 0 is the first item, 1 the last.
///
/// Numbers, points, vectors, colours, domains and times can be interpolated: in blocks, along straight lines, or
/// along smooth curves.
#[component(
    "e168ff6b-e5c0-48f1-b831-f6996bf3b459",
    name = "Interpolate data",
    nick = "Interp",
    at = "Maths/Util"
)]
#[output("Value", "V", "The value there.")]
fn interpolate_data(
    context: &Context<'_>,
    /// The samples. Nulls are skipped.
    #[port("Data", "D")]
    data: List<Value>,
    /// The place, 0 to 1.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<Option<Value>, Message> {
    // Looked up by place without a copy of the list, unless there are gaps to close.
    let gaps: Option<Vec<Value>> = data.iter().any(|v| v.is_none()).then(|| data.present().collect());
    let n = gaps.as_ref().map_or(data.len(), Vec::len);
    let sample = |i: usize| match &gaps {
        Some(values) => values.get(i).cloned(),
        None => data.get(i),
    };
    let Some(last) = n.checked_sub(1) else { return Ok(None) };
    if t.is_nan() {
        return Err(Message::error("The parameter is not a number"));
    }
    let place = t.clamp(0.0, 1.0) * last as f64;
    let i = (place.floor() as usize).min(last);
    let weights = Blend::read(context).weights(place - i as f64);
    let neighbours = [i.saturating_sub(1), i, (i + 1).min(last), (i + 2).min(last)];
    let mut terms = Vec::with_capacity(4);
    for (at, weight) in neighbours.into_iter().zip(weights).filter(|(_, weight)| *weight != 0.0) {
        if let Some(value) = sample(at) {
            if weight == 1.0 {
                return Ok(Some(value));
            }
            terms.push((Numbers::of(&value)?, weight));
        }
    }
    Ok(Numbers::sum(terms)?.map(Numbers::value))
}

/// Removes the smallest and the largest values of a list; the others stay in their order.
#[component(
    "bd96f893-d57b-4f04-90d0-dca0d72ff2f9",
    name = "Truncate",
    nick = "Trunc",
    at = "Maths/Util",
    also("a8de2000-073d-412d-a0b2-3a4894ba71f8")
)]
#[output("Result", "T", "What is left.")]
fn truncate(
    /// Numbers, texts or points. Nulls are skipped.
    #[port("Input", "I")]
    input: List<Value>,
    /// How much to remove, 0 to 1, half of it at each end: with 0.5 a quarter of all values at each.
    #[port("Truncation factor", "t", default = 0.25)]
    factor: f64,
) -> Result<Vec<Value>, Message> {
    let values: Vec<Value> = input.present().collect();
    let order = comparison::order(&values)?;
    let n = values.len();
    let cut = ((n as f64 * factor.clamp(0.0, 1.0) * 0.5).round() as usize).min(n / 2);
    let mut kept: Vec<usize> = order.get(cut..n - cut).unwrap_or_default().to_vec();
    kept.sort_unstable();
    Ok(kept.into_iter().filter_map(|i| values.get(i).cloned()).collect())
}

/// Evens out a list of numbers: each moves towards the mean of its neighbours, again and again.
#[component("57e1d392-e3fb-4de9-be98-982854a92351", name = "Blur Numbers", nick = "NBlur", at = "Maths/Util")]
#[output("Numbers", "N", "The numbers evened out.")]
fn blur_numbers(
    context: &Context<'_>,
    /// The numbers. Nulls are skipped.
    #[port("Numbers", "N")]
    numbers: List<f64>,
    /// How far they move at a time, 0 to 1.
    #[port("Strength", "S", default = 0.5)]
    strength: f64,
    /// How many times.
    #[port("Iterations", "I", default = 1)]
    iterations: i32,
    /// Whether the first and last number stay.
    #[port("Lock", "L", default = false)]
    lock: bool,
    /// Whether the last number is a neighbour of the first.
    #[port("Wrap", "W", default = false)]
    wrap: bool,
) -> Result<Vec<f64>, Message> {
    if iterations < 0 {
        return Err(Message::error(format!("{iterations} iterations cannot be made")));
    }
    let mut numbers: Vec<f64> = numbers.present().collect();
    let n = numbers.len();
    if n < 2 {
        return Ok(numbers);
    }
    for _ in 0..iterations {
        context.check()?;
        let at = |i: usize| numbers.get(i).copied();
        let blurred = |(i, x): (usize, &f64)| {
            if lock && (i == 0 || i == n - 1) {
                return *x;
            }
            let before = if i > 0 { at(i - 1) } else { at(n - 1).filter(|_| wrap) };
            let after = if i < n - 1 { at(i + 1) } else { at(0).filter(|_| wrap) };
            let mean = match (before, after) {
                (Some(a), Some(b)) => 0.5 * (a + b),
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => *x,
            };
            (1.0 - strength) * x + strength * mean
        };
        numbers = numbers.iter().enumerate().map(blurred).collect();
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Colour;
    use katydid_geometry::{Point3, Vector3};

    #[test]
    fn averages_of_simple_types() {
        assert_eq!(Trial::of("Average").gaps([Some(1.0), None, Some(4.0)]).texts(0), ["{0}: 2.5"]);
        assert_eq!(Trial::of("Average").list([1, 2]).texts(0), ["{0}: 1.5"]);
        assert_eq!(Trial::of("Average").list(["1", "4"]).texts(0), ["{0}: 2.5"]);
        let points = [Point3::new(1.0, 2.0, 3.0), Point3::new(3.0, 2.0, 1.0)];
        assert_eq!(Trial::of("Average").list(points).texts(0), ["{0}: {2, 2, 2}"]);
        let colours = [Colour::rgb(200, 0, 10), Colour::rgb(100, 0, 20)];
        assert_eq!(Trial::of("Average").list(colours).texts(0), ["{0}: 150,0,15"]);
        assert_eq!(Trial::of("Average").list([0.0; 0]).texts(0), ["{0}: null"]);
        assert_eq!(Trial::of("Average").list(["x!"]).message(), "The text x! is not a number");
        let mixed = Trial::of("Average").gaps([
            Some(katydid_data::Value::from(Vector3::new(1.0, 0.0, 0.0))),
            Some(katydid_data::Value::from(2.0)),
        ]);
        assert_eq!(mixed.message(), "Vector and Number have no average");
    }

    #[test]
    fn other_means() {
        let means = |out| Trial::of("Mean").list([2.0, 8.0]).texts(out).concat();
        assert_eq!([means(0), means(1), means(2)], ["{0}: 5", "{0}: 4", "{0}: 3.2"]);
        assert_eq!(Trial::of("Mean").list([-1.0, 2.0]).texts(1), ["{0}: null"]);
        let weighted = |w: &[f64]| Trial::of("Weighted Average").list([1.0, 5.0, 9.0]).list(w.to_vec());
        assert_eq!(weighted(&[3.0, 1.0]).texts(0), ["{0}: 3.4"]);
        assert_eq!(weighted(&[1.0, -0.5]).message(), "The weights add up to zero");
    }

    #[test]
    fn interpolation_goes_through_the_samples() {
        let at = |mode: i32, t: f64| {
            let trial = Trial::of("Interpolate data").setting("Interpolation", mode);
            trial.list([0.0, 10.0, 40.0]).item(t).texts(0).concat().replace("{0}: ", "")
        };
        for mode in 1..=4 {
            assert_eq!([at(mode, -1.0), at(mode, 0.5), at(mode, 1.0)], ["0", "10", "40"], "mode {mode}");
        }
        assert_eq!([at(1, 0.2), at(1, 0.3), at(2, 0.75)], ["0", "10", "25"]);
        // 0.5 (2·10 + (40-0)/2 + (0-50+160-40)/4 + (30-0-120+40)/8)
        assert_eq!(at(4, 0.75), "25.625");
        let colours = [Colour::rgb(0, 0, 0), Colour::rgb(100, 50, 0)];
        assert_eq!(Trial::of("Interpolate data").list(colours).item(0.5).texts(0), ["{0}: 50,25,0"]);
        assert_eq!(Trial::of("Interpolate data").gaps([None, Some(7)]).item(0.0).texts(0), ["{0}: 7"]);
    }

    #[test]
    fn truncating_and_blurring() {
        let cut = |t: f64| Trial::of("Truncate").list([5, 1, 4, 2]).item(t).texts(0).concat();
        assert_eq!([cut(0.0), cut(0.5), cut(1.0)], ["{0;0}: 5, 1, 4, 2", "{0;0}: 4, 2", "{0;0}:"]);
        let blur = |lock: bool, wrap: bool| {
            Trial::of("Blur Numbers")
                .list([0.0, 4.0, 0.0])
                .item(0.5)
                .item(1)
                .item(lock)
                .item(wrap)
                .texts(0)
                .concat()
        };
        assert_eq!(blur(false, false), "{0;0}: 2, 2, 2");
        assert_eq!(blur(true, false), "{0;0}: 0, 2, 0");
        assert_eq!(blur(false, true), "{0;0}: 1, 2, 1");
        assert!(Trial::of("Blur Numbers").list([1.0]).item(0.5).item(-1).message().contains("-1 iterations"));
    }
}
