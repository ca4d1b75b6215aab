//! Sequences out of a rule.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_expression::{Dialect, Variant, format};
use katydid_geometry::Interval;

use crate::sets::count;

/// Counts up in equal steps: Start, Start + Step, Start + 2 Step ...
#[component("e64c5fb1-845c-4ab1-8911-5f338516ba67", name = "Series", nick = "Series", at = "Sets/Sequence")]
#[output("Series", "S", "The numbers.")]
fn series(
    context: &Context<'_>,
    /// The first number.
    #[port("Start", "S", default = 0.0)]
    start: f64,
    /// From one number to the next; negative counts down.
    #[port("Step", "N", default = 1.0)]
    step: f64,
    /// How many numbers, 0 or more.
    #[port("Count", "C", default = 10)]
    n: i32,
) -> Result<Vec<f64>, Message> {
    let n = count(n, "Count")?;
    context.items(n)?;
    Ok((0..n).map(|i| start + i as f64 * step).collect())
}

/// Divides a domain into equal steps and gives the numbers between them, both ends included: one more than
/// there are steps. Fewer than 0 steps give no numbers.
#[component("9445ca40-cc73-4861-a455-146308676855", name = "Range", nick = "Range", at = "Sets/Sequence")]
#[output("Range", "R", "The numbers, from the start of the domain to its end.")]
fn range(
    context: &Context<'_>,
    /// From where to where.
    #[port("Domain", "D", default = Interval::new(0.0, 1.0))]
    domain: Interval,
    /// How many steps; 0 gives the start alone.
    #[port("Steps", "N", default = 10)]
    steps: i32,
) -> Result<Vec<f64>, Message> {
    let Ok(steps) = count(steps, "Steps") else {
        context.tell(Message::remark(format!("{steps} steps give no numbers")));
        return Ok(Vec::new());
    };
    context.items(steps.saturating_add(1))?;
    if steps == 0 {
        return Ok(vec![domain.start]);
    }
    Ok((0..=steps).map(|i| domain.at(i as f64 / steps as f64)).collect())
}

/// Starts with two numbers; from then on each number is the sum of the two before it.
///
/// A sum beyond the largest number is an error.
#[component("fe99f302-3d0d-4389-8494-bd53f7935a02", name = "Fibonacci", nick = "Fib", at = "Sets/Sequence")]
#[output("Series", "S", "The numbers.")]
fn fibonacci(
    context: &Context<'_>,
    /// The first number.
    #[port("Seed A", "A", default = 0.0)]
    a: f64,
    /// The second number.
    #[port("Seed B", "B", default = 1.0)]
    b: f64,
    /// How many numbers, 0 or more.
    #[port("Number", "N", default = 10)]
    n: i32,
) -> Result<Vec<f64>, Message> {
    let n = count(n, "Number")?;
    context.items(n)?;
    let mut numbers = Vec::with_capacity(n);
    let (mut a, mut b) = (a, b);
    for i in 0..n {
        if !a.is_finite() {
            return Err(Message::error(format!("From place {i} on the numbers are too large")));
        }
        numbers.push(a);
        (a, b) = (b, a + b);
    }
    Ok(numbers)
}

/// Names in a row from a pool of characters: A, B ... Z, AA, AB ...
///
/// A format, such as `Axis {0}`, can put more text around each name.
#[component(
    "01640871-69ea-40ac-9380-4660d6d28bd2",
    name = "Char Sequence",
    nick = "CharSeq",
    at = "Sets/Sequence"
)]
#[output("Sequence", "S", "The names.")]
fn char_sequence(
    context: &Context<'_>,
    /// How many names, 0 or more.
    #[port("Count", "C", default = 10)]
    n: i32,
    /// The characters, in order; at least one.
    #[port("Char Pool", "P", default = "ABCDEFGHIJKLMNOPQRSTUVWXYZ")]
    pool: Arc<str>,
    /// What is written for each name, which stands at `{0}`.
    #[port("Format", "F", default = "{0}", optional)]
    pattern: Arc<str>,
) -> Result<Vec<Arc<str>>, Message> {
    let n = count(n, "Count")?;
    context.items(n)?;
    let pool: Vec<char> = pool.chars().collect();
    if pool.is_empty() {
        return Err(Message::error("The pool has no characters"));
    }
    let mut names = Vec::with_capacity(n);
    for i in 0..n {
        let name = name(i, &pool, |characters| context.bytes(4 * characters))?;
        let text = match &*pattern {
            "{0}" => name,
            pattern => format(pattern, &[Variant::text(name)], Dialect::Modern)
                .map_err(|error| Message::error(error.to_string()))?,
        };
        context.bytes(text.len())?;
        names.push(text.into());
    }
    Ok(names)
}

/// Name `i`: as numbers are written, but counting from 1 and without a zero. A pool of one character makes
/// names of `i + 1` characters, so `room` is asked first.
fn name(i: usize, pool: &[char], room: impl Fn(usize) -> Result<(), Message>) -> Result<String, Message> {
    if let [only] = pool {
        room(i + 1)?;
        return Ok(only.to_string().repeat(i + 1));
    }
    let mut characters: Vec<char> = Vec::new();
    let mut rest = i + 1;
    while rest > 0 {
        rest -= 1;
        characters.extend(pool.get(rest % pool.len()));
        rest /= pool.len();
    }
    Ok(characters.into_iter().rev().collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    use super::*;

    #[test]
    fn series_multiplies_its_step() {
        let trial = || Trial::of("Series").item(2).item(3);
        assert_eq!(trial().item(5).texts(0), ["{0;0}: 2, 5, 8, 11, 14"]);
        assert_eq!(trial().list([1, 0, 2]).texts(0), ["{0;0}: 2", "{0;1}:", "{0;2}: 2, 5"]);
        assert_eq!(trial().item(-1).message(), "Count is negative: -1");
        assert!(trial().item(i32::MAX).message().contains("items"));
        let exact = Trial::of("Series").item(0.0).item(0.1).item(11).run();
        assert_eq!(exact.outputs[0].column().get(10), Some(1.0.into()));
    }

    #[test]
    fn range_ends_at_its_end() {
        let range = |a: f64, b: f64, n: i32| Trial::of("Range").item(Interval::new(a, b)).item(n);
        assert_eq!(range(-10.0, 10.0, 5).texts(0), ["{0;0}: -10, -6, -2, 2, 6, 10"]);
        assert_eq!(range(1.0, 0.0, 2).texts(0), ["{0;0}: 1, 0.5, 0"]);
        assert_eq!(range(3.0, 4.0, 0).texts(0), ["{0;0}: 3"]);
        assert_eq!(range(3.0, 4.0, -1).texts(0), ["{0;0}:"]);
        assert_eq!(range(3.0, 4.0, -7).message(), "-7 steps give no numbers");
        assert_eq!(range(0.1, 0.7, 3).run().outputs[0].column().get(3), Some(0.7.into()));
        assert_eq!(
            Trial::of("Range").item("20").item("10").texts(0),
            ["{0;0}: 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20"]
        );
    }

    #[test]
    fn fibonacci_adds_the_last_two() {
        assert_eq!(Trial::of("Fibonacci").texts(0), ["{0;0}: 0, 1, 1, 2, 3, 5, 8, 13, 21, 34"]);
        let long = Trial::of("Fibonacci").default().default().item(2000);
        assert!(long.message().contains("too large"));
    }

    #[test]
    fn names_go_on_with_two_letters() {
        let names = |n: i32| Trial::of("Char Sequence").item(n);
        assert_eq!(names(4).item("AB").texts(0), ["{0;0}: A, B, AA, AB"]);
        assert_eq!(names(29).texts(0)[0].split(", ").last(), Some("AC"));
        assert_eq!(names(3).item("x").texts(0), ["{0;0}: x, xx, xxx"]);
        assert_eq!(names(2).default().item("Axis {0}").texts(0), ["{0;0}: Axis A, Axis B"]);
        assert_eq!(names(2).item("").message(), "The pool has no characters");
        assert!(names(1_000_000).item("x").message().contains("bytes"));
        assert!(!names(1).default().item("{1}").message().is_empty());
    }
}
