//! Maths / Operators.

use katydid_component::{Context, List, ManyItems, Message, component};
use katydid_data::Value;

use super::arithmetic;

type Binary = fn(&Value, &Value) -> Result<Value, Message>;

/// Left to right over the inputs that have data; a null on one of them makes the result null.
fn fold(context: &Context<'_>, terms: ManyItems<Value>, operator: Binary) -> Result<Option<Value>, Message> {
    let mut result: Option<Value> = None;
    for (k, term) in terms.into_iter().enumerate() {
        let term = match term {
            Some(term) => term,
            None if context.has_data(k) => return Ok(None),
            None => continue,
        };
        result = Some(match result {
            None => term,
            Some(sum) => operator(&sum, &term)?,
        });
    }
    if let Some(Value::Text(text)) = &result {
        context.bytes(text.len())?;
    }
    Ok(result)
}

/// Adds its inputs: numbers, points and vectors, domains, colours; texts are joined.
///
/// A point plus a vector is a point. Inputs without data are left out.
#[component(
    "a0d62394-a118-422d-abb3-6af115c75b25",
    name = "Addition",
    nick = "A+B",
    at = "Maths/Operators",
    also(
        "d18db32b-7099-4eea-85c4-8ba675ee8ec3",
        "cae37d1c-8146-4e0b-9cf1-14cb3e337b94",
        "58669268-a825-4688-8072-7d3508fcf91c"
    )
)]
#[output("Result", "R", "The sum.")]
fn addition(
    context: &Context<'_>,
    /// A term of the sum.
    #[port("A", "A", optional)]
    terms: ManyItems<Value>,
) -> Result<Option<Value>, Message> {
    fold(context, terms, arithmetic::add)
}

/// Divides A by B as real numbers, integers too. A vector or domain can be divided by a number.
///
/// Dividing by zero is an error.
#[component(
    "9c85271f-89fa-4e9f-9f4a-d75802120ccc",
    name = "Division",
    nick = "A/B",
    at = "Maths/Operators",
    also("ec875825-61e4-4c1c-a343-0e0cee0b321b", "cb4ec4a1-f48e-4685-b58c-72ed27b53681")
)]
#[output("Result", "R", "The quotient.")]
fn division(
    /// What is divided.
    #[port("A", "A")]
    a: Value,
    /// What it is divided by; not zero.
    #[port("B", "B")]
    b: Value,
) -> Result<Value, Message> {
    arithmetic::divide(&a, &b)
}

/// Adds up a list, and shows the sum after each item.
///
/// Nulls are skipped. Points add up by their coordinates.
#[component(
    "5b850221-b527-4bd6-8c62-e94168cd6efa",
    name = "Mass Addition",
    nick = "MA",
    at = "Maths/Operators",
    also("74d95062-0bec-4a4e-9026-5141fca954a6", "bb64b2fb-f87a-432f-86f8-393f4ee21310")
)]
#[output("Result", "R", "The sum of the whole list; nothing for an empty one.")]
#[output("Partial Results", "Pr", "The sum of the items so far, one an item.")]
fn mass_addition(
    context: &Context<'_>,
    /// The terms.
    #[port("Input", "I")]
    input: List<Value>,
) -> Result<(Option<Value>, Vec<Value>), Message> {
    running(context, input, arithmetic::add)
}

fn running(
    context: &Context<'_>,
    input: List<'_, Value>,
    operator: Binary,
) -> Result<(Option<Value>, Vec<Value>), Message> {
    context.items(input.len())?;
    let mut partial: Vec<Value> = Vec::with_capacity(input.len());
    for term in input.present() {
        let next = match partial.last() {
            None => term,
            Some(sum) => operator(sum, &term)?,
        };
        if let Value::Text(text) = &next {
            context.bytes(text.len())?;
        }
        partial.push(next);
    }
    Ok((partial.last().cloned(), partial))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Point3, Vector3};

    #[test]
    fn addition_of_points_vectors_and_texts() {
        let trial = Trial::of("Addition").item(Point3::new(1.0, 2.0, 3.0)).item(Vector3::new(2.0, 2.0, 2.0));
        assert_eq!(trial.texts(0), ["{0}: {3, 4, 5}"]);
        assert_eq!(Trial::of("Addition").item("3.5").item(2).texts(0), ["{0}: 5.5"]);
        assert_eq!(Trial::of("Addition").item("ab").item("c").texts(0), ["{0}: abc"]);
    }

    #[test]
    fn division_by_zero_is_an_error() {
        assert_eq!(Trial::of("Division").item(1.0).item(0.0).message(), "Division by zero");
        assert_eq!(Trial::of("Division").item(7).item(2).texts(0), ["{0}: 3.5"]);
    }

    #[test]
    fn mass_addition_shows_the_way() {
        assert_eq!(Trial::of("Mass Addition").list([1.0, 2.0, 3.5]).texts(1), ["{0}: 1, 3, 6.5"]);
    }
}
