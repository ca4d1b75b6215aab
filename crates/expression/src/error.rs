use crate::Span;
use crate::format::FormatError;

/// Any failure of this crate.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The text is not an expression, or uses a name nobody gave.
    #[error(transparent)]
    Parse(#[from] ParseError),
    /// The expression cannot be computed for these values.
    #[error(transparent)]
    Evaluate(#[from] EvalError),
    /// A format string cannot be applied.
    #[error(transparent)]
    Format(#[from] FormatError),
}

/// Why a text is not an expression, and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{kind}")]
pub struct ParseError {
    /// The place in the text.
    pub span: Span,
    /// The reason.
    pub kind: ParseErrorKind,
}

impl ParseError {
    pub(crate) fn new(span: Span, kind: ParseErrorKind) -> Self {
        Self { span, kind }
    }

    /// The message, the text, and carets under the place.
    pub fn render(&self, source: &str) -> String {
        self.span.render(source, &self.to_string())
    }
}

/// The reasons for which a text is refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ParseErrorKind {
    /// Nothing but blanks.
    #[error("the expression is empty")]
    Empty,
    /// Longer than [`crate::MAX_LENGTH`].
    #[error("the expression is longer than {0} bytes")]
    TooLong(usize),
    /// Nested deeper than [`crate::MAX_DEPTH`].
    #[error("the expression nests deeper than {0} levels")]
    TooDeep(usize),
    /// A character that has no meaning here.
    #[error("the character '{0}' has no meaning here")]
    UnexpectedCharacter(char),
    /// A text that does not end.
    #[error("closing quote missing for the text opened here")]
    UnclosedText,
    /// Digits that are not a number, or one too large.
    #[error("'{0}' is not a number in range")]
    BadNumber(String),
    /// A value was needed.
    #[error("a value is missing: found {found} instead")]
    MissingValue {
        /// What stands there.
        found: String,
    },
    /// Two values with nothing between them.
    #[error("an operator is missing before {found}")]
    MissingOperator {
        /// What stands there.
        found: String,
    },
    /// An opening bracket without its partner.
    #[error("closing bracket missing for the '{0}' opened here")]
    Unclosed(char),
    /// A closing bracket without its partner.
    #[error("this '{0}' closes nothing")]
    StrayClose(char),
    /// A closing bracket of another kind.
    #[error("'{open}' is closed by '{close}'")]
    MismatchedClose {
        /// The opening bracket.
        open: char,
        /// The closing one found.
        close: char,
    },
    /// A comma outside a call or a point.
    #[error("a comma may only separate the arguments of a function or the coordinates of a point")]
    StrayComma,
    /// `{…}` with one, or more than three, coordinates.
    #[error("a point has two or three coordinates, not {0}")]
    PointSize(usize),
    /// A member other than X, Y, Z and O.
    #[error("unknown member '.{0}': there are .X, .Y, .Z and .O")]
    UnknownMember(String),
    /// A call of something that is not a function.
    #[error("unknown function '{name}'{}", hint(.suggestion))]
    UnknownFunction {
        /// The name as written.
        name: String,
        /// The nearest known name.
        suggestion: Option<String>,
    },
    /// A name that is neither variable nor constant.
    #[error("unknown name '{name}'{}", hint(.suggestion))]
    UnknownName {
        /// The name as written.
        name: String,
        /// The nearest known name.
        suggestion: Option<String>,
    },
    /// A function's name without brackets.
    #[error("'{name}' is a function: write {signature}")]
    FunctionWithoutArguments {
        /// The name as written.
        name: String,
        /// How it is called.
        signature: &'static str,
    },
    /// Too few or too many arguments.
    #[error("{signature} takes {takes}, not {given}")]
    ArgumentCount {
        /// How it is called.
        signature: &'static str,
        /// The counts allowed, in words.
        takes: String,
        /// The count given.
        given: usize,
    },
}

fn hint(suggestion: &Option<String>) -> String {
    suggestion.as_ref().map_or_else(String::new, |s| format!(": did you mean '{s}'?"))
}

/// Why an expression has no value, and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{kind}")]
pub struct EvalError {
    /// The place in the text: the operator or the function's name.
    pub span: Span,
    /// The reason.
    pub kind: EvalErrorKind,
}

impl EvalError {
    pub(crate) fn new(span: Span, kind: EvalErrorKind) -> Self {
        Self { span, kind }
    }

    /// The message, the text, and carets under the place.
    pub fn render(&self, source: &str) -> String {
        self.span.render(source, &self.to_string())
    }
}

/// The reasons for which an expression has no value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EvalErrorKind {
    /// `/`, `\` or `%` by zero, or a mean of reciprocals of zero.
    #[error("division by zero")]
    DivisionByZero,
    /// An operator between two types it does not know.
    #[error("'{operator}' cannot join {} and {}", with_article(.left), with_article(.right))]
    OperandTypes {
        /// The operator's symbol.
        operator: &'static str,
        /// Type on its left.
        left: &'static str,
        /// Type on its right.
        right: &'static str,
    },
    /// An operator on a type it does not know.
    #[error("'{operator}' cannot be applied to {}", with_article(.operand))]
    OperandType {
        /// The operator's symbol.
        operator: &'static str,
        /// Type of the operand.
        operand: &'static str,
    },
    /// An argument of the wrong type.
    #[error("argument {position} of {function} must be {expected}, not {}", with_article(.found))]
    ArgumentType {
        /// The function.
        function: &'static str,
        /// Which argument, counted from 1.
        position: usize,
        /// What it takes, with its article.
        expected: &'static str,
        /// Type given.
        found: &'static str,
    },
    /// An argument outside what the function is defined for.
    #[error("{function}: {reason}")]
    OutOfRange {
        /// The function or operator.
        function: &'static str,
        /// The rule it breaks, with the value.
        reason: String,
    },
    /// The result is infinite or not a number; the place is where that began.
    #[error("the result is not a finite number: '{operation}' gives {value}")]
    NotFinite {
        /// The operator or function where it began.
        operation: &'static str,
        /// "infinity" or "not a number".
        value: &'static str,
    },
    /// A text above [`crate::MAX_TEXT`].
    #[error("the text would be longer than {0} bytes")]
    TextTooLong(usize),
    /// `Format` with a pattern that cannot be applied.
    #[error("Format: {0}")]
    Format(#[from] FormatError),
    /// Fewer values than names at binding.
    #[error("no value given for the variable '{0}'")]
    MissingVariable(String),
    /// The program does not fit together: a fault of this crate, not of the text.
    #[error("the compiled expression is damaged")]
    Damaged,
}

/// "a Number", "an Integer".
fn with_article(name: &str) -> String {
    let article = if name.starts_with(['A', 'E', 'I', 'O', 'U']) { "an" } else { "a" };
    format!("{article} {name}")
}
