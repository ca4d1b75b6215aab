//! Formulas that users write: read once, computed on values.

use katydid_component::Message;
use katydid_data::{Value, formula};
use katydid_expression::{Expression, Program, Variant};

/// A formula with its variables, ready to be computed.
#[derive(Debug)]
pub(crate) struct Formula {
    text: String,
    program: Program,
}

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// A message that shows the place, when the text is no formula or names an unknown variable.
    pub(crate) fn new(text: &str, variables: &[&str]) -> Result<Self, Message> {
        let program = Expression::parse(text).and_then(|expression| expression.bind(variables));
        let program = program.map_err(|error| Message::error(error.render(text)))?;
        Ok(Self { text: text.to_owned(), program })
    }

    /// The value for these variables; `None` for null.
    ///
    /// # Errors
    /// A message that shows the place, when there is no such value.
    pub(crate) fn evaluate(&self, values: &[Variant]) -> Result<Option<Value>, Message> {
        match self.program.evaluate(values) {
            Ok(result) => Ok(formula::value(result)),
            Err(error) => Err(Message::error(error.render(&self.text))),
        }
    }

    /// So many values for columns of numbers, one column for each variable; a column that is shorter repeats its last
    /// number. They are those of [`Formula::evaluate`] to the last bit; `None` where the formula is not about numbers
    /// alone, or a value has no result.
    pub(crate) fn of_numbers(&self, columns: &[&[f64]], count: usize) -> Option<Vec<f64>> {
        self.program.evaluate_numbers(columns, count)?.ok()
    }

    /// The text it was read from.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }
}

/// The value of a formula without variables.
///
/// # Errors
/// As [`Formula`].
pub(crate) fn constant(text: &str) -> Result<Option<Value>, Message> {
    Formula::new(text, &[])?.evaluate(&[])
}
