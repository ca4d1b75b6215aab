//! Sets / Sequence: numbers by a rule over those before.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_expression::Variant;
use regex::Regex;

use super::super::count;
use crate::maths::formula::Formula;

/// A rule with the places that it looks back to.
struct Rule {
    formula: Formula,
    back: Vec<usize>,
}

impl Rule {
    /// Reads a rule: a formula in which `{-k}`, or `{i-k}` with any letter, is the number k places before.
    fn read(notation: &str) -> Result<Self, Message> {
        let term = Regex::new(r"\{\s*[A-Za-z]?\s*-\s*(\d{1,6})\s*\}");
        let term = term.map_err(|error| Message::error(error.to_string()))?;
        let mut back = Vec::new();
        for found in term.captures_iter(notation) {
            let k = found.get(1).and_then(|digits| digits.as_str().parse().ok()).unwrap_or(0);
            if k == 0 {
                return Err(Message::error(
                    "The notation looks 0 places back: a number cannot come from itself",
                ));
            }
            if !back.contains(&k) {
                back.push(k);
            }
        }
        let text = term.replace_all(notation, "(before$1)");
        let names: Vec<String> = back.iter().map(|k| format!("before{k}")).collect();
        let names: Vec<&str> = ["i"].into_iter().chain(names.iter().map(String::as_str)).collect();
        Ok(Self { formula: Formula::new(&text, &names)?, back })
    }
}

/// Numbers that follow from the ones before by a rule.
///
/// The rule is a formula: `{-1}` is the number before, `{-2}` the one before that, and `i` the place of the new number,
/// from 0. `{-1} + {-2}` from 0 and 1 gives the Fibonacci numbers.
#[component("e9b2d2a6-0377-4c1c-a89e-b3f219a95b4d", name = "Sequence", nick = "Seq", at = "Sets/Sequence")]
#[output("Sequence", "S", "The numbers, the first ones in front.")]
fn sequence(
    context: &Context<'_>,
    /// The rule.
    #[port("Notation", "N")]
    notation: std::sync::Arc<str>,
    /// How many numbers, the first ones among them.
    #[port("Length", "L", default = 10)]
    length: i32,
    /// The first numbers.
    #[port("Initial", "I", optional)]
    initial: List<f64>,
) -> Result<Vec<f64>, Message> {
    let length = count(length, "Length")?;
    context.items(length)?;
    let rule = Rule::read(&notation)?;
    let mut numbers: Vec<f64> = initial.present().take(length).collect();
    let farthest = rule.back.iter().copied().max().unwrap_or(0);
    if numbers.len() < farthest.min(length) {
        return Err(Message::error(format!(
            "The notation looks {farthest} places back, but there are {} first numbers",
            numbers.len()
        )));
    }
    while numbers.len() < length {
        let n = numbers.len();
        if n.is_multiple_of(1024) {
            context.check()?;
        }
        let before = |k: &usize| n.checked_sub(*k).and_then(|at| numbers.get(at)).copied().unwrap_or(0.0);
        let place = std::iter::once(Variant::Number(n as f64));
        let values: Vec<Variant> =
            place.chain(rule.back.iter().map(|k| Variant::Number(before(k)))).collect();
        let next = match rule.formula.evaluate(&values)? {
            Some(Value::Number(x)) => x,
            Some(Value::Integer(i)) => f64::from(i),
            Some(other) => {
                return Err(Message::error(format!(
                    "The notation gives a {} at place {n}, not a number",
                    other.kind()
                )));
            }
            None => return Err(Message::error(format!("The notation gives nothing at place {n}"))),
        };
        if !next.is_finite() {
            return Err(Message::error(format!("From place {n} on the numbers are too large")));
        }
        numbers.push(next);
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    fn sequence(notation: &str, length: i32, initial: &[f64]) -> Trial {
        Trial::of("Sequence").item(notation).item(length).list(initial.iter().copied())
    }

    #[test]
    fn rules() {
        assert_eq!(sequence("{-1} + {-2}", 8, &[0.0, 1.0]).texts(0), ["{0;0}: 0, 1, 1, 2, 3, 5, 8, 13"]);
        assert_eq!(sequence("2*{i-1}", 4, &[3.0]).texts(0), ["{0;0}: 3, 6, 12, 24"]);
        assert_eq!(sequence("i^2", 4, &[]).texts(0), ["{0;0}: 0, 1, 4, 9"]);
        // Newton's iteration for the root of 2.
        assert_eq!(sequence("({-1} + 2/{-1})/2", 6, &[1.0]).texts(0)[0].split(", ").last(), Some("1.414214"));
        assert_eq!(sequence("{-1}", 2, &[1.0, 2.0, 3.0]).texts(0), ["{0;0}: 1, 2"]);
    }

    #[test]
    fn rules_that_do_not_work() {
        assert!(sequence("{-2}", 5, &[1.0]).message().contains("2 places back"));
        assert!(sequence("{-0}", 5, &[1.0]).message().contains("itself"));
        assert!(sequence("{-1", 5, &[1.0]).run().messages.len() == 1);
        assert!(!sequence("{-1}^9", 50, &[9.0]).message().is_empty());
        assert!(sequence("\"a\"", 5, &[1.0]).message().contains("not a number"));
        assert!(sequence("1", -5, &[1.0]).message().contains("negative"));
    }
}
