//! Sums, differences, products, quotients.

use katydid_component::{Call, Context, List, ManyItems, Message, Outcome, component, whole};
use katydid_data::{Column, Item, Value};

use super::super::arithmetic;

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

/// The same for columns of numbers as they lie, integers among them; `None` for other data.
fn fold_numbers(call: &Call<'_>, operator: impl Fn(f64, f64) -> f64 + Sync) -> Option<Outcome> {
    whole::reals(call, |columns, count| {
        let (first, others) = columns.split_first()?;
        let mut result = match **first {
            [one] => vec![one; count],
            ref many => many.to_vec(),
        };
        for column in others {
            match **column {
                [one] => result.iter_mut().for_each(|x| *x = operator(*x, one)),
                ref many => result.iter_mut().zip(many).for_each(|(x, &y)| *x = operator(*x, y)),
            }
        }
        Some(result)
    })
}

fn sums(call: &Call<'_>) -> Option<Outcome> {
    fold_numbers(call, |a, b| a + b)
}

fn differences(call: &Call<'_>) -> Option<Outcome> {
    fold_numbers(call, |a, b| a - b)
}

fn products(call: &Call<'_>) -> Option<Outcome> {
    fold_numbers(call, |a, b| a * b)
}

/// Quotients, where no divisor is zero.
fn quotients(call: &Call<'_>) -> Option<Outcome> {
    let divisors = call.inputs.get(1)?.column();
    let has_zero = match (f64::slice(divisors), i32::slice(divisors)) {
        (Some(numbers), _) => numbers.contains(&0.0),
        (_, Some(integers)) => integers.contains(&0),
        _ => true,
    };
    if has_zero { None } else { fold_numbers(call, |a, b| a / b) }
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
    ),
    columns = sums
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

/// Subtracts from its first input all the others: numbers, points and vectors, domains, colours.
///
/// The difference of two points is the vector between them. Inputs without data are left out.
#[component(
    "9c007a04-d0d9-48e4-9da3-9ba142bc4d46",
    name = "Subtraction",
    nick = "A-B",
    at = "Maths/Operators",
    also(
        "2c56ab33-c7cc-4129-886c-d5856b714010",
        "babecca6-9813-4146-b150-cd72f743e47c",
        "f4a20a34-97e6-4ff5-9b26-7f7ed7a1e333"
    ),
    columns = differences
)]
#[output("Result", "R", "The difference.")]
fn subtraction(
    context: &Context<'_>,
    /// First what is subtracted from, then what is subtracted.
    #[port("A", "A", optional)]
    terms: ManyItems<Value>,
) -> Result<Option<Value>, Message> {
    fold(context, terms, arithmetic::subtract)
}

/// Multiplies its inputs. A number scales a point, vector, domain or colour; two vectors give their dot product.
///
/// Inputs without data are left out.
#[component(
    "ce46b74e-00c9-43c4-805a-193b69ea4a11",
    name = "Multiplication",
    nick = "A×B",
    at = "Maths/Operators",
    also(
        "b8963bb1-aa57-476e-a20e-ed6cf635a49c",
        "2f643ab6-b9a4-4923-b3da-f9d52b0cba14",
        "3e6383e9-af39-427b-801a-19ca916160fa"
    ),
    columns = products
)]
#[output("Result", "R", "The product.")]
fn multiplication(
    context: &Context<'_>,
    /// A factor.
    #[port("A", "A", optional)]
    factors: ManyItems<Value>,
) -> Result<Option<Value>, Message> {
    fold(context, factors, arithmetic::multiply)
}

/// Divides A by B as real numbers, integers too. A vector or domain can be divided by a number.
///
/// Dividing by zero is an error.
#[component(
    "9c85271f-89fa-4e9f-9f4a-d75802120ccc",
    name = "Division",
    nick = "A/B",
    at = "Maths/Operators",
    also("ec875825-61e4-4c1c-a343-0e0cee0b321b", "cb4ec4a1-f48e-4685-b58c-72ed27b53681"),
    columns = quotients
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
) -> Result<(Option<Value>, Column), Message> {
    running(context, input, arithmetic::add, |sum, x| sum + x)
}

/// Multiplies a list together, and shows the product after each item. Nulls are skipped.
#[component(
    "e44c1bd7-72cc-4697-80c9-02787baf7bb4",
    name = "Mass Multiplication",
    nick = "MM",
    at = "Maths/Operators",
    also("921775f7-bf22-4cfc-a4db-c415a56069c4")
)]
#[output("Result", "R", "The product of the whole list; nothing for an empty one.")]
#[output("Partial Results", "Pr", "The product of the items so far, one an item.")]
fn mass_multiplication(
    context: &Context<'_>,
    /// The factors.
    #[port("Input", "I")]
    input: List<Value>,
) -> Result<(Option<Value>, Column), Message> {
    running(context, input, arithmetic::multiply, |product, x| product * x)
}

/// The differences between neighbours in a list: each item less the one before it, one fewer than there are
/// items. Points give vectors. Nulls are skipped.
#[component(
    "dd17d442-3776-40b3-ad5b-5e188b56bd4c",
    name = "Relative Differences",
    nick = "RelDif",
    at = "Maths/Operators"
)]
#[output("Differenced", "D", "The differences.")]
fn relative_differences(
    /// Numbers, points or vectors.
    #[port("Values", "V")]
    values: List<Value>,
) -> Result<Vec<Value>, Message> {
    let next = values.present().skip(1);
    values.present().zip(next).map(|(a, b)| arithmetic::subtract(&b, &a)).collect()
}

/// The opposite of a value: of a number, a point, a vector, both ends of a domain. A colour is inverted.
#[component("a3371040-e552-4bc8-b0ff-10a840258e88", name = "Negative", nick = "Neg", at = "Maths/Operators")]
#[output("Result", "y", "The opposite.")]
fn negative(
    /// The value.
    #[port("Value", "x")]
    x: Value,
) -> Result<Value, Message> {
    match x {
        // The opposite of 0 is 0, without a sign.
        Value::Number(x) => Ok(Value::Number(0.0 - x)),
        other => arithmetic::negate(&other),
    }
}

/// A value without its sign: the size of a number or complex number, the coordinates of a vector or point
/// without theirs.
#[component("28124995-cf99-4298-b6f4-c75a8e379f18", name = "Absolute", nick = "Abs", at = "Maths/Operators")]
#[output("Result", "y", "The value without sign.")]
fn absolute(
    /// The value.
    #[port("Value", "x")]
    x: Value,
) -> Result<Value, Message> {
    match x {
        Value::Number(x) => Ok(Value::Number(x.abs())),
        other => arithmetic::absolute(&other),
    }
}

fn running(
    context: &Context<'_>,
    input: List<'_, Value>,
    operator: Binary,
    real: fn(f64, f64) -> f64,
) -> Result<(Option<Value>, Column), Message> {
    context.items(input.len())?;
    if let Some(numbers) = input.slice_of::<f64>() {
        return Ok(running_numbers(numbers, real));
    }
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
    Ok((partial.last().cloned(), Column::of_values(partial, None)))
}

/// The same for numbers as they lie.
fn running_numbers(numbers: &[f64], real: fn(f64, f64) -> f64) -> (Option<Value>, Column) {
    let mut total = None;
    let partial: Vec<f64> = numbers
        .iter()
        .map(|&x| {
            let next = total.map_or(x, |sum| real(sum, x));
            total = Some(next);
            next
        })
        .collect();
    (total.map(Value::Number), f64::column(partial, None))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;
    use katydid_geometry::{Point3, Vector3};

    /// Columns that are taken as a whole, and those that are too uneven for that.
    #[test]
    fn columns_of_numbers() {
        let with = |name: &str| Trial::of(name).list([1.5, 2.5, -4.0]);
        assert_eq!(with("Addition").item(2).texts(0), ["{0}: 3.5, 4.5, -2"]);
        assert_eq!(with("Subtraction").list([1, 2, 3]).item(0.5).texts(0), ["{0}: 0, 0, -7.5"]);
        assert_eq!(with("Multiplication").list([2, 4]).texts(0), ["{0}: 3, 10, -16"]);
        assert_eq!(Trial::of("Multiplication").list([3, 4]).list([5, 6]).texts(0), ["{0}: 15, 24"]);
        assert_eq!(with("Division").item(2).texts(0), ["{0}: 0.75, 1.25, -2"]);
        let by_zero = || with("Division").list([3.0, 0.0, 2.0]);
        assert_eq!(by_zero().texts(0), ["{0}: 0.5, null, -2"]);
        assert!(by_zero().message().contains("zero"));
        let gaps = Trial::of("Addition").gaps([Some(1.0), None]).item(1.0);
        assert_eq!(gaps.texts(0), ["{0}: 2, null"]);
    }

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

    #[test]
    fn differences_and_products() {
        assert_eq!(Trial::of("Subtraction").item("3.6").item("2").texts(0), ["{0}: 1.6"]);
        let points =
            Trial::of("Subtraction").item(Point3::new(1.0, 2.0, 3.0)).item(Point3::new(1.0, 1.0, 1.0));
        assert_eq!(points.texts(0), ["{0}: {0, 1, 2}"]);
        assert_eq!(Trial::of("Multiplication").item("3.6").item("2").texts(0), ["{0}: 7.2"]);
        assert_eq!(Trial::of("Multiplication").item(3).tree(Tree::empty()).item(2).texts(0), ["{0}: 6"]);
        assert_eq!(Trial::of("Division").item("3.6").item("2").texts(0), ["{0}: 1.8"]);
        let vector = Trial::of("Multiplication").item(Vector3::new(1.0, 2.0, 0.0)).item(2.5);
        assert_eq!(vector.texts(0), ["{0}: {2.5, 5, 0}"]);
        assert_eq!(Trial::of("Mass Multiplication").list([2, 3, 4]).texts(1), ["{0}: 2, 6, 24"]);
        assert_eq!(Trial::of("Mass Multiplication").gaps([Some(2.0), None]).texts(0), ["{0}: 2"]);
        assert_eq!(Trial::of("Relative Differences").list([1, 4, 2]).texts(0), ["{0}: 3, -2"]);
        assert_eq!(Trial::of("Relative Differences").list([1]).run().outputs[0].item_count(), 0);
    }

    #[test]
    fn signs() {
        assert_eq!(Trial::of("Negative").list([2.5, -1.0, 0.0]).texts(0), ["{0}: -2.5, 1, 0"]);
        assert_eq!(Trial::of("Absolute").item(-3).texts(0), ["{0}: 3"]);
        assert_eq!(Trial::of("Negative").item(i32::MIN).texts(0), ["{0}: 2.147484e+9"]);
    }
}
