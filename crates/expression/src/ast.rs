use std::fmt;

use crate::functions::Function;
use crate::operator::{Binary, Postfix, Prefix, level};
use crate::{Dialect, ParseError, Span, Variant, number_text};

/// An expression, read and checked: its functions exist and have the right number of arguments.
///
/// The tree is kept flat, operands before their operator, so that neither evaluating nor dropping a long chain
/// needs the machine's stack. Printing gives a text that reads back as the same tree; two expressions are equal
/// when their trees are, whatever the layout of their texts.
#[derive(Debug, Clone)]
pub struct Expression {
    pub(crate) nodes: Vec<Node>,
}

/// A step of the tree with its place: the operator's sign or the function's name.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    pub(crate) kind: NodeKind,
    pub(crate) span: Span,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum NodeKind {
    Literal(Variant),
    /// A variable or constant, in lower case.
    Name(String),
    Binary(Binary),
    Prefix(Prefix),
    Postfix(Postfix),
    /// A point of so many coordinates.
    Point(usize),
    Call(Function, usize),
}

impl NodeKind {
    /// How many values the step takes; it always gives one.
    pub(crate) fn takes(&self) -> usize {
        match self {
            Self::Literal(_) | Self::Name(_) => 0,
            Self::Prefix(_) | Self::Postfix(_) => 1,
            Self::Binary(_) => 2,
            Self::Point(count) | Self::Call(_, count) => *count,
        }
    }
}

impl Expression {
    /// Reads an expression.
    ///
    /// # Errors
    /// With the place and the reason when the text is empty, too long, nested too deep, or not well formed, and
    /// when it calls an unknown function or one with the wrong number of arguments. Names are looked up later,
    /// by [`Expression::bind`].
    pub fn parse(source: &str) -> Result<Self, ParseError> {
        crate::parser::parse(source)
    }

    /// The names that need a value: lower case, each once, in the order of their first use. Constants (`pi`,
    /// `e`, `phi`, …) are left out; a variable of such a name hides the constant when bound.
    pub fn variables(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for node in &self.nodes {
            if let NodeKind::Name(name) = &node.kind
                && crate::names::constant(name).is_none()
                && !names.contains(&name.as_str())
            {
                names.push(name);
            }
        }
        names
    }
}

impl PartialEq for Expression {
    fn eq(&self, other: &Self) -> bool {
        self.nodes.iter().map(|n| &n.kind).eq(other.nodes.iter().map(|n| &n.kind))
    }
}

impl std::str::FromStr for Expression {
    type Err = ParseError;
    fn from_str(source: &str) -> Result<Self, ParseError> {
        Self::parse(source)
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut stack: Vec<(String, u8)> = Vec::new();
        for node in &self.nodes {
            let rest = stack.len().saturating_sub(node.kind.takes());
            let printed = match &node.kind {
                NodeKind::Literal(value) => (literal(value), level::PRIMARY),
                NodeKind::Name(name) => (name.clone(), level::PRIMARY),
                NodeKind::Binary(operator) => {
                    let at = operator.level();
                    // The exponent takes signs by itself, but not what binds looser than a postfix.
                    let right_at = if *operator == Binary::Power { level::POSTFIX } else { at + 1 };
                    let right = stack.pop().map(|p| bracketed(p, right_at)).unwrap_or_default();
                    let mut text = stack.pop().map(|p| bracketed(p, at)).unwrap_or_default();
                    if *operator == Binary::Power {
                        text.push('^');
                    } else {
                        text.push(' ');
                        text.push_str(operator.symbol());
                        text.push(' ');
                    }
                    text.push_str(&right);
                    (text, at)
                }
                NodeKind::Prefix(operator) => {
                    let operand = stack.pop().map(|p| bracketed(p, level::PREFIX)).unwrap_or_default();
                    let blank = if *operator == Prefix::Not { " " } else { "" };
                    (format!("{}{blank}{operand}", operator.symbol()), level::PREFIX)
                }
                NodeKind::Postfix(Postfix::Unitize) => {
                    let (operand, _) = stack.pop().unwrap_or_default();
                    (format!("[{operand}]"), level::PRIMARY)
                }
                NodeKind::Postfix(operator) => {
                    let mut text = stack.pop().map(|p| bracketed(p, level::POSTFIX)).unwrap_or_default();
                    text.push_str(operator.symbol());
                    (text, level::POSTFIX)
                }
                NodeKind::Point(_) => (format!("{{{}}}", list(&mut stack, rest)), level::PRIMARY),
                NodeKind::Call(function, _) => {
                    (format!("{}({})", function.name(), list(&mut stack, rest)), level::PRIMARY)
                }
            };
            stack.push(printed);
        }
        f.write_str(stack.last().map_or("", |(text, _)| text))
    }
}

fn bracketed((text, at): (String, u8), least: u8) -> String {
    if at < least { format!("({text})") } else { text }
}

fn list(stack: &mut Vec<(String, u8)>, from: usize) -> String {
    stack.drain(from..).map(|(text, _)| text).collect::<Vec<_>>().join(", ")
}

fn literal(value: &Variant) -> String {
    match value {
        Variant::Number(x) => decimal(*x),
        Variant::Complex { im, .. } => format!("{}i", decimal(*im)),
        Variant::Text(text) => format!("\"{}\"", text.replace('"', "\"\"")),
        other => other.to_text(Dialect::Modern),
    }
}

/// A number that reads back as a number and not as an integer.
fn decimal(x: f64) -> String {
    let text = number_text(x, Dialect::Modern);
    if text.contains(['.', 'E']) { text } else { format!("{text}.0") }
}
