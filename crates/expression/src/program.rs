use crate::arithmetic::{binary, postfix, prefix};
use crate::ast::NodeKind;
use crate::columns::Lanes;
use crate::functions::{Function, call};
use crate::lexer::lower_case;
use crate::operator::{Binary, Postfix, Prefix};
use crate::{Error, EvalError, EvalErrorKind, Expression, ParseError, ParseErrorKind, Span, Variant, names};

/// An expression bound to its variables, ready to be evaluated any number of times, from any thread.
#[derive(Debug, Clone)]
pub struct Program {
    pub(crate) steps: Vec<Step>,
    names: Vec<String>,
    pub(crate) lanes: Option<Lanes>,
}

/// One step of the stack machine, with the place an error of it is shown at.
#[derive(Debug, Clone)]
pub(crate) struct Step {
    pub(crate) code: Code,
    pub(crate) span: Span,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Code {
    Constant(Variant),
    Variable(usize),
    Binary(Binary),
    Prefix(Prefix),
    Postfix(Postfix),
    Point(usize),
    Call(Function, usize),
}

impl Code {
    fn takes(&self) -> usize {
        match self {
            Self::Constant(_) | Self::Variable(_) => 0,
            Self::Prefix(_) | Self::Postfix(_) => 1,
            Self::Binary(_) => 2,
            Self::Point(count) | Self::Call(_, count) => *count,
        }
    }

    fn operation(&self) -> &'static str {
        match self {
            Self::Constant(_) | Self::Variable(_) => "value",
            Self::Binary(operator) => operator.symbol(),
            Self::Prefix(operator) => operator.symbol(),
            Self::Postfix(operator) => operator.symbol(),
            Self::Point(_) => "{ }",
            Self::Call(function, _) => function.name(),
        }
    }
}

impl Expression {
    /// Resolves every name: to the slot of the variable of that name (any case; the first of equal names), else
    /// to the constant. What does not depend on variables is computed once, here.
    ///
    /// # Errors
    /// When a name is neither; the error points at it and proposes the nearest known name.
    pub fn bind(&self, variables: &[&str]) -> Result<Program, ParseError> {
        let names: Vec<String> = variables.iter().map(|n| lower_case(n.trim())).collect();
        let mut folder = Folder { steps: Vec::with_capacity(self.nodes.len()), values: Vec::new() };
        for node in &self.nodes {
            let code = match &node.kind {
                NodeKind::Literal(value) => Code::Constant(value.clone()),
                NodeKind::Name(name) => match names.iter().position(|n| n == name) {
                    Some(slot) => Code::Variable(slot),
                    None => Code::Constant(
                        names::constant(name).ok_or_else(|| unknown_name(name, node.span, &names))?,
                    ),
                },
                NodeKind::Binary(operator) => Code::Binary(*operator),
                NodeKind::Prefix(operator) => Code::Prefix(*operator),
                NodeKind::Postfix(operator) => Code::Postfix(*operator),
                NodeKind::Point(count) => Code::Point(*count),
                NodeKind::Call(function, count) => Code::Call(*function, *count),
            };
            folder.push(Step { code, span: node.span });
        }
        let steps = folder.steps;
        let lanes = Lanes::of(&steps);
        Ok(Program { steps, names, lanes })
    }
}

fn unknown_name(name: &str, span: Span, variables: &[String]) -> ParseError {
    let kind = match Function::named(name) {
        Some(function) => ParseErrorKind::FunctionWithoutArguments {
            name: name.to_string(),
            signature: function.help().signature,
        },
        None => {
            let mut known: Vec<&str> = variables.iter().map(String::as_str).collect();
            known.extend(names::constants());
            let suggestion = names::nearest(name, known.into_iter());
            ParseErrorKind::UnknownName { name: name.to_string(), suggestion }
        }
    };
    ParseError::new(span, kind)
}

/// Computes constant parts while the steps are written.
struct Folder {
    steps: Vec<Step>,
    /// For each value on the stack at this point, where its steps begin.
    values: Vec<usize>,
}

impl Folder {
    fn push(&mut self, step: Step) {
        let takes = step.code.takes();
        let first_value = self.values.len().saturating_sub(takes);
        let start = self.values.get(first_value).copied().unwrap_or(self.steps.len());
        let operands = self.steps.get(start..).unwrap_or_default();
        let constant = takes > 0
            && operands.len() == takes
            && operands.iter().all(|s| matches!(s.code, Code::Constant(_)));
        self.values.truncate(first_value);
        self.values.push(start);
        if constant {
            let mut stack: Vec<Variant> = Vec::with_capacity(takes);
            for operand in operands {
                if let Code::Constant(value) = &operand.code {
                    stack.push(value.clone());
                }
            }
            // A failure is left in place: it belongs to evaluating, with its own place.
            if apply(&step.code, &mut stack).is_ok()
                && let Some(value) = stack.pop()
                && value.is_finite()
            {
                self.steps.truncate(start);
                self.steps.push(Step { code: Code::Constant(value), span: step.span });
                return;
            }
        }
        self.steps.push(step);
    }
}

/// Runs one step other than a variable on the stack.
fn apply(code: &Code, stack: &mut Vec<Variant>) -> Result<(), EvalErrorKind> {
    let mut pop = || stack.pop().ok_or(EvalErrorKind::Damaged);
    let value = match code {
        Code::Constant(value) => value.clone(),
        Code::Variable(_) => return Err(EvalErrorKind::Damaged),
        Code::Binary(operator) => {
            let right = pop()?;
            binary(*operator, &pop()?, &right)?
        }
        Code::Prefix(operator) => prefix(*operator, &pop()?)?,
        Code::Postfix(operator) => postfix(*operator, &pop()?)?,
        Code::Point(count) => {
            let from = stack.len().checked_sub(*count).ok_or(EvalErrorKind::Damaged)?;
            let value = point(stack.get(from..).unwrap_or_default())?;
            stack.truncate(from);
            value
        }
        Code::Call(function, count) => {
            let from = stack.len().checked_sub(*count).ok_or(EvalErrorKind::Damaged)?;
            let value = call(*function, stack.get(from..).unwrap_or_default())?;
            stack.truncate(from);
            value
        }
    };
    stack.push(value);
    Ok(())
}

/// `{x, y}` lies at z = 0.
fn point(values: &[Variant]) -> Result<Variant, EvalErrorKind> {
    if values.iter().any(Variant::is_null) {
        return Ok(Variant::Null);
    }
    let mut coordinates = [0.0; 3];
    for (i, (value, slot)) in values.iter().zip(&mut coordinates).enumerate() {
        let number = crate::arithmetic::Scalar::of(value).and_then(crate::arithmetic::Scalar::real);
        *slot = number.ok_or(EvalErrorKind::ArgumentType {
            function: "a point",
            position: i + 1,
            expected: "a number",
            found: value.type_name(),
        })?;
    }
    let [x, y, z] = coordinates;
    Ok(Variant::point(x, y, z))
}

impl Program {
    /// The variables' names in the order of their slots, lower case.
    pub fn variables(&self) -> &[String] {
        &self.names
    }

    /// Whether the result does not depend on any variable.
    pub fn is_constant(&self) -> bool {
        !self.steps.iter().any(|s| matches!(s.code, Code::Variable(_)))
    }

    /// The value for these variables, in the order given to [`Expression::bind`]; further values are not looked
    /// at. NaN and infinity may occur on the way, as in `1/(1+e^x)`, but not in the result.
    ///
    /// # Errors
    /// With the place of the operator or function: wrong types, division by zero, arguments outside a function's
    /// domain, a result that is not finite, a text that is too long. Both branches of `if` are computed, so an
    /// error in the one not chosen is an error too.
    pub fn evaluate(&self, values: &[Variant]) -> Result<Variant, EvalError> {
        let mut stack: Vec<Variant> = Vec::with_capacity(8);
        let mut first_not_finite: Option<(Span, &'static str, bool)> = None;
        for step in &self.steps {
            let fail = |kind| EvalError::new(step.span, kind);
            if let Code::Variable(slot) = step.code {
                let missing = || {
                    let name = self.names.get(slot).cloned().unwrap_or_default();
                    fail(EvalErrorKind::MissingVariable(name))
                };
                stack.push(values.get(slot).ok_or_else(missing)?.clone());
            } else {
                apply(&step.code, &mut stack).map_err(fail)?;
            }
            if first_not_finite.is_none()
                && let Some(value) = stack.last()
                && !value.is_finite()
            {
                let nan = !matches!(value, Variant::Number(x) if x.is_infinite());
                first_not_finite = Some((step.span, step.code.operation(), nan));
            }
        }
        let value = stack.pop().ok_or(EvalError::new(Span::default(), EvalErrorKind::Damaged))?;
        match first_not_finite {
            Some((span, operation, nan)) if !value.is_finite() => {
                let value = if nan { "not a number" } else { "infinity" };
                Err(EvalError::new(span, EvalErrorKind::NotFinite { operation, value }))
            }
            _ => Ok(value),
        }
    }
}

/// Reads and evaluates an expression without variables, such as the items of a value list.
///
/// # Errors
/// What [`Expression::parse`], [`Expression::bind`] and [`Program::evaluate`] report.
pub fn evaluate(source: &str) -> Result<Variant, Error> {
    Ok(Expression::parse(source)?.bind(&[])?.evaluate(&[])?)
}
