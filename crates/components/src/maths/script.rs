//! Maths / Script: formulas over the inputs.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use katydid_component::{Call, Context, ManyItems, Message, Outcome, component, whole};
use katydid_data::{Value, formula as values};
use katydid_expression::Variant;

use super::formula::Formula;

/// What a formula computes with: null for a variable without data.
fn variable(name: &str, value: Option<Value>) -> Result<Variant, Message> {
    let Some(value) = value else { return Ok(Variant::Null) };
    let refuse =
        || Message::error(format!("The variable {name} is a {}, which formulas do not take", value.kind()));
    values::variant(&value).ok_or_else(refuse)
}

/// Computes a formula. Its variables are the nicknames of the inputs, in any case.
///
/// The formula is stored in the component: `x^2 + sin(y)`, `if(x > 2, "large", "small")`, `{x, y, 0}`. A variable
/// without data makes the result null. An error shows the place in the formula.
#[component(
    "9df5e896-552d-4c8c-b9ca-4fc147ffa022",
    name = "Expression",
    nick = "Expression",
    at = "Maths/Script",
    also("ef4ead41-6762-4adf-8a20-12b973bdf008"),
    columns = expression_of_numbers
)]
#[output("Result", "R", "The value of the formula.")]
fn expression(
    context: &Context<'_>,
    /// A variable.
    #[port("Variable x", "x", optional)]
    variables: ManyItems<Value>,
) -> Result<Option<Value>, Message> {
    let formula = context.prepared(|| {
        let text = context.settings().str("Expression").filter(|text| !text.trim().is_empty());
        let text = text.ok_or_else(|| Message::error("No formula is stored in this component"))?;
        let names: Vec<&str> = (0..context.input_count()).map(|k| context.input_name(k)).collect();
        Formula::new(text, &names)
    })?;
    let name = |k| context.input_name(k);
    let variables = variables.into_iter().enumerate();
    let variables: Result<Vec<Variant>, Message> = variables.map(|(k, v)| variable(name(k), v)).collect();
    formula.evaluate(&variables?)
}

/// A formula about numbers over whole columns of them.
fn expression_of_numbers(call: &Call<'_>) -> Option<Outcome> {
    let text = call.settings.str("Expression")?;
    let names: Vec<&str> = call.input_names.iter().map(String::as_str).collect();
    let formula = Formula::new(text, &names).ok()?;
    whole::numbers(call, |columns, count| formula.of_numbers(columns, count))
}

/// The last formula read, so that a formula that comes over a wire is read once and not for each item.
type Last = RefCell<Option<Rc<Formula>>>;

fn evaluated(
    context: &Context<'_>,
    text: &str,
    names: &[&str],
    variables: impl IntoIterator<Item = Option<Value>>,
) -> Result<Option<Value>, Message> {
    let last: &Last = context.prepared(|| Ok(Last::default()))?;
    let known = last.borrow().as_ref().filter(|formula| formula.text() == text).cloned();
    let formula = match known {
        Some(formula) => formula,
        None => {
            let formula = Rc::new(Formula::new(text, names)?);
            last.replace(Some(Rc::clone(&formula)));
            formula
        }
    };
    let named = names.iter().zip(variables);
    let variables: Result<Vec<Variant>, Message> = named.map(|(name, v)| variable(name, v)).collect();
    formula.evaluate(&variables?)
}

/// Computes a formula that comes in as a text. Its variables are the nicknames of the other inputs.
#[component("cc2b626f-6eff-4d08-9829-2877560693f4", name = "Evaluate", nick = "Eval", at = "Maths/Script")]
#[output("Result", "r", "The value of the formula.")]
fn evaluate(
    context: &Context<'_>,
    /// The formula.
    #[port("Expression", "F")]
    text: Arc<str>,
    /// A variable.
    #[port("Variable t", "t", optional)]
    variables: ManyItems<Value>,
) -> Result<Option<Value>, Message> {
    let names: Vec<&str> = (1..context.input_count()).map(|k| context.input_name(k)).collect();
    evaluated(context, &text, &names, variables)
}

/// Computes a formula without variables that comes in as a text. An early form of Evaluate.
#[component(
    "579c9f8c-6fb6-419b-8086-523a2dc99e8a",
    name = "Eval [OBSOLETE]",
    nick = "Eval",
    at = "Maths/Script"
)]
#[output("Value", "V", "The value of the formula.")]
fn eval(
    context: &Context<'_>,
    /// The formula.
    #[port("Expression", "E")]
    text: Arc<str>,
) -> Result<Option<Value>, Message> {
    evaluated(context, &text, &[], [])
}

/// Declares the early forms of Evaluate, whose variables have fixed names.
macro_rules! fixed {
    ($($function:ident, $guid:tt, $name:tt, $nick:tt, ($out:tt, $out_nick:tt), ($text:tt, $text_nick:tt), [$(($variable:ident, $port:tt, $variable_nick:tt)),*];)*) => {$(
        #[doc = "Computes a formula that comes in as a text, over variables with fixed names."]
        #[doc = "An early form of Evaluate."]
        #[component($guid, name = $name, nick = $nick, at = "Maths/Script")]
        #[output($out, $out_nick, "The value of the formula.")]
        #[allow(clippy::too_many_arguments, reason = "an argument is a port")]
        fn $function(
            context: &Context<'_>,
            #[doc = "The formula."]
            #[port($text, $text_nick)]
            text: Arc<str>,
            $(
                #[doc = "A variable."]
                #[port($port, $variable_nick)]
                $variable: Value,
            )*
        ) -> Result<Option<Value>, Message> {
            evaluated(context, &text, &[$($variable_nick),*], [$(Some($variable)),*])
        }
    )*};
}

fixed! {
    f1, "0b7d1129-7b88-4322-aad3-56fd1036a8f6", "F1", "F(x)", ("Result", "r"), ("Function", "F"), [(x, "x", "x")];
    f2, "00ec9ecd-4e1d-45ba-a8fc-dff716dbd9e4", "F2", "F(x,y)", ("Result", "r"), ("Function", "F"), [(x, "x", "x"), (y, "y", "y")];
    f3, "2f77b45b-034d-4053-8872-f38d87cbc676", "F3", "F(x,y,z)", ("Result", "r"), ("Function", "F"),
        [(x, "x", "x"), (y, "y", "y"), (z, "z", "z")];
    f4, "07efd5e1-d7f4-4205-ab99-83e68175564e", "F4", "F(a,b,c,d)", ("Result", "r"), ("Function", "F"),
        [(a, "a", "a"), (b, "b", "b"), (c, "c", "c"), (d, "d", "d")];
    f5, "322f0e6e-d434-4d07-9f8d-f214bb248cb1", "F5", "F(a,b,c,d,x)", ("Result", "r"), ("Function", "F"),
        [(a, "a", "a"), (b, "b", "b"), (c, "c", "c"), (d, "d", "d"), (x, "x", "x")];
    f6, "4783b96f-6197-4058-a688-b4ba04c00962", "F6", "F(a,b,c,d,x,y)", ("Result", "r"), ("Function", "F"),
        [(a, "a", "a"), (b, "b", "b"), (c, "c", "c"), (d, "d", "d"), (x, "x", "x"), (y, "y", "y")];
    f7, "e9628b21-49d6-4e56-900e-49f4bd4adc85", "F7", "F(a,b,c,d,x,y,z)", ("Result", "r"), ("Function", "F"),
        [(a, "a", "a"), (b, "b", "b"), (c, "c", "c"), (d, "d", "d"), (x, "x", "x"), (y, "y", "y"), (z, "z", "z")];
    f8, "f2a97ac6-4f11-4c81-834d-50ecd782675c", "F8", "F(a,b,c,d,w,x,y,z)", ("Result", "r"), ("Function", "F"),
        [(a, "a", "a"), (b, "b", "b"), (c, "c", "c"), (d, "d", "d"), (w, "w", "w"), (x, "x", "x"), (y, "y", "y"),
         (z, "z", "z")];
    old_x, "d3e721b4-f5ea-4e40-85fc-b68616939e47", "F(x) [OBSOLETE]", "F(x)", ("Result Y", "y"), ("Function", "F"),
        [(x, "Variable X", "x")];
    old_x_y, "d2b10b82-f612-4763-91ca-0cbdbe276171", "F(x,y) [OBSOLETE]", "F(x,y)", ("Result", "r"), ("Function", "F"),
        [(x, "Variable x", "x"), (y, "Variable y", "y")];
    old_x_y_z, "e1c4bccc-4ecf-4f18-885d-dfd8983e572a", "F(x,y,z) [OBSOLETE]", "F(x,y,z)", ("Result", "r"), ("Function", "F"),
        [(x, "Variable x", "x"), (y, "Variable y", "y"), (z, "Variable z", "z")];
    old_a_b_c_d, "0f3a13d4-5bb7-499e-9b57-56bb6dce93fd", "F(a,b,c,d) [OBSOLETE]", "F(a,b,c,d)", ("Result R", "R"), ("Function", "F"),
        [(a, "Variable a", "a"), (b, "Variable b", "b"), (c, "Variable c", "c"), (d, "Variable d", "d")];
    old_six, "655c5f2f-1e40-42b8-a93a-f05032794449", "Evaluate Expression [OBSOLETE]", "Eval", ("Value", "V"), ("Expression", "E"),
        [(a, "Variable a", "a"), (b, "Variable b", "b"), (c, "Variable c", "c"), (x, "Variable x", "x"),
         (y, "Variable y", "y"), (z, "Variable z", "z")];
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;
    use katydid_geometry::{Line, Point3};

    fn formula(text: &str) -> Trial {
        Trial::of("Expression").setting("Expression", text).names(["x", "Radius"])
    }

    #[test]
    fn variables_are_the_nicknames() {
        assert_eq!(formula("x * radius - 1").list([2.0, 3.0]).item(10.0).texts(0), ["{0}: 19, 29"]);
        assert_eq!(formula("if(x≥2, \"big\", RADIUS)").list([1, 2]).item(5).texts(0), ["{0}: 5, big"]);
        assert_eq!(formula("{x, radius, 0}").item(1).item(2).texts(0), ["{0}: {1, 2, 0}"]);
        let p = Point3::new(1.0, 2.0, 3.0);
        assert_eq!(formula("x.y + 1").item(p).item(0).texts(0), ["{0}: 3"]);
    }

    /// Columns of numbers are computed at once: with one number for all, with trees of one shape, and not where the shapes
    /// differ, a path is longer or a value has no result.
    #[test]
    fn columns_of_numbers() {
        let sum = || formula("x + 10 * radius");
        let tree = |a: f64| [("{0;0}", [a, a + 1.0]), ("{0;1}", [a + 2.0, a + 3.0])];
        assert_eq!(sum().branches(tree(1.0)).item(2.0).texts(0), ["{0;0}: 21, 22", "{0;1}: 23, 24"]);
        assert_eq!(sum().item(2.0).branches(tree(1.0)).texts(0), ["{0;0}: 12, 22", "{0;1}: 32, 42"]);
        assert_eq!(sum().branches(tree(1.0)).branches(tree(0.0)).texts(0), ["{0;0}: 1, 12", "{0;1}: 23, 34"]);
        assert_eq!(sum().list([1.0, 2.0, 3.0]).list([0.0, 1.0]).texts(0), ["{0}: 1, 12, 13"]);
        assert_eq!(sum().list([1.0, 2.0]).branches([("{0;4}", [1.0])]).texts(0), ["{0;4}: 11, 12"]);
        let divided = formula("x / radius").list([1.0, 2.0]).list([0.0, 4.0]);
        assert_eq!(divided.texts(0), ["{0}: null, 0.5"]);
    }

    #[test]
    fn nulls_and_errors() {
        assert_eq!(formula("x + 1").gaps([Some(1), None]).item(0).texts(0), ["{0}: 2, null"]);
        assert_eq!(formula("x + 1").item(1).tree(Tree::empty()).texts(0), ["{0}: 2"]);
        assert!(formula("x + y").item(1).item(1).message().contains("\n  x + y\n"));
        assert!(formula("1 / x").item(0).item(1).message().starts_with("division by zero"));
        assert_eq!(Trial::of("Expression").item(1).message(), "No formula is stored in this component");
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        assert_eq!(
            formula("x").item(line).item(1).message(),
            "The variable x is a Line, which formulas do not take"
        );
    }

    #[test]
    fn formulas_over_a_wire() {
        let trial = Trial::of("Evaluate").names(["F", "t"]).list(["t^2", "t + 1", "t^2"]).list([3, 4, 5]);
        assert_eq!(trial.texts(0), ["{0}: 9, 5, 25"]);
        assert_eq!(Trial::of("F2").item("x/y").item(1).item(4).texts(0), ["{0}: 0.25"]);
        let eight = Trial::of("F8").item("a+b+c+d+w+x+y*z");
        assert_eq!((1..=8).fold(eight, Trial::item).texts(0), ["{0}: 77"]);
        assert_eq!(Trial::of("Eval [OBSOLETE]").item("2^8").texts(0), ["{0}: 256"]);
    }
}
