//! Sets / Sets: the nearest member of a set.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary;

use crate::sets::integer;
use crate::sets::key::same;

/// Finds the member of a set that is most like an item.
///
/// Numbers are compared by their difference, points and vectors by their distance, colours by their channels,
/// complex numbers and domains by their parts, texts by the letters one has to change. Of equally near members
/// the first counts; a member of another type is found only when there is nothing else.
#[component(
    "b4d4235f-14ff-4d4e-a29a-b358dcd2baf4",
    name = "Find similar member",
    nick = "FSim",
    at = "Sets/Sets"
)]
#[output("Hit", "H", "The nearest member.")]
#[output("Index", "i", "Its index in the set; -1 when there is none.")]
fn find_similar_member(
    context: &Context<'_>,
    /// What to look for.
    #[port("Data", "D")]
    data: Value,
    /// The set.
    #[port("Set", "S")]
    set: List<Value>,
) -> Result<(Option<Value>, i32), Message> {
    let mut best: Option<(f64, usize)> = None;
    for (i, item) in set.iter().enumerate() {
        if i % 256 == 0 {
            context.check()?;
        }
        let Some(item) = item else { continue };
        let distance = distance(&data, &item);
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, i));
        }
    }
    Ok(match best {
        Some((_, i)) => (set.get(i), integer(i)),
        None => (None, -1),
    })
}

/// How unlike two items are; infinite when they cannot be compared.
fn distance(a: &Value, b: &Value) -> f64 {
    let number = |v: &Value| match v {
        Value::Integer(i) => Some(f64::from(*i)),
        Value::Number(x) => Some(*x),
        Value::Boolean(b) => Some(f64::from(u8::from(*b))),
        _ => None,
    };
    if let (Some(a), Some(b)) = (number(a), number(b)) {
        return (a - b).abs();
    }
    match (a, b) {
        (Value::Point(a), Value::Point(b)) => a.distance_to(*b),
        (Value::Vector(a), Value::Vector(b)) => a.to_point().distance_to(b.to_point()),
        (Value::Complex(a), Value::Complex(b)) => (a.re - b.re).hypotenuse(a.im - b.im),
        (Value::Domain(a), Value::Domain(b)) => (a.start - b.start).abs() + (a.end - b.end).abs(),
        (Value::Colour(a), Value::Colour(b)) => [(a.a, b.a), (a.r, b.r), (a.g, b.g), (a.b, b.b)]
            .into_iter()
            .map(|(a, b)| f64::from(a.abs_diff(b)).powi(2))
            .sum::<f64>()
            .sqrt(),
        (Value::Text(a), Value::Text(b)) => edits(a, b),
        _ if same(Some(a), Some(b)) => 0.0,
        _ => f64::INFINITY,
    }
}

/// Beyond this many comparisons of letters two texts count as unlike.
const MOST_LETTERS: usize = 10_000_000;

/// The fewest letters to put in, take out or change to get from one text to the other (Levenshtein), by the
/// table of Wagner and Fischer (1974), row by row.
fn edits(a: &str, b: &str) -> f64 {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    if a.len().saturating_mul(b.len()) > MOST_LETTERS {
        return if a == b { 0.0 } else { f64::INFINITY };
    }
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.iter().enumerate() {
        let mut diagonal = i;
        let mut left = i + 1;
        if let Some(first) = row.first_mut() {
            *first = left;
        }
        for (to, cell) in b.iter().zip(row.iter_mut().skip(1)) {
            let changed = diagonal + usize::from(from != to);
            diagonal = *cell;
            left = changed.min(left + 1).min(*cell + 1);
            *cell = left;
        }
    }
    row.last().copied().unwrap_or(0) as f64
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Colour;
    use katydid_geometry::Point3;

    use super::*;

    #[test]
    fn the_nearest_member() {
        let near =
            |data: Value, set: Vec<Value>| Trial::of("Find similar member").item(data).list(set).texts(1);
        assert_eq!(near(2.4.into(), vec![1.into(), 3.into(), 2.into()]), ["{0}: 2"]);
        assert_eq!(near(2.5.into(), vec!["2".into(), 3.into(), 2.into()]), ["{0}: 1"]);
        let p = |x: f64| Value::from(Point3::new(x, 0.0, 0.0));
        assert_eq!(near(p(1.0), vec![p(9.0), p(0.5)]), ["{0}: 1"]);
        assert_eq!(near("kitten".into(), vec!["sitting".into(), "kitchen".into()]), ["{0}: 1"]);
        let grey = |g: u8| Value::from(Colour { a: 255, r: g, g, b: g });
        assert_eq!(near(grey(100), vec![grey(0), grey(120)]), ["{0}: 1"]);
        assert_eq!(near(1.into(), vec![]), ["{0}: -1"]);
    }

    #[test]
    fn letters_to_change() {
        for (a, b, n) in
            [("kitten", "sitting", 3.0), ("", "abc", 3.0), ("abc", "abc", 0.0), ("ab", "ba", 2.0)]
        {
            assert_eq!(edits(a, b), n);
        }
    }
}
