//! The operators as written: what the lexer finds and how the printer spells it.

use crate::operator::{Binary, Postfix, Prefix};

/// An operator sign or word; signs serve several roles until the parser knows the position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Symbol {
    Plus,
    Minus,
    Not,
    Infix(Binary),
    After(Postfix),
}

impl Symbol {
    /// The infix operator that this sign is between two values.
    pub(crate) fn infix(self) -> Option<Binary> {
        match self {
            Self::Plus => Some(Binary::Add),
            Self::Minus => Some(Binary::Subtract),
            Self::Infix(operator) => Some(operator),
            Self::Not | Self::After(_) => None,
        }
    }

    /// The operator that this sign is before a value.
    pub(crate) fn prefix(self) -> Option<Prefix> {
        match self {
            Self::Plus => Some(Prefix::Plus),
            Self::Minus => Some(Prefix::Minus),
            Self::Not => Some(Prefix::Not),
            Self::Infix(_) | Self::After(_) => None,
        }
    }

    /// The operator's word, `None` when `name` (lower case) is an ordinary name.
    pub(crate) fn word(name: &str) -> Option<Self> {
        Some(match name {
            "and" => Self::Infix(Binary::And),
            "or" => Self::Infix(Binary::Or),
            "xor" => Self::Infix(Binary::Xor),
            "not" => Self::Not,
            _ => return None,
        })
    }

    /// The operator at the start of `first` `second`, and how many characters it takes.
    pub(crate) fn sign(first: char, second: Option<char>) -> Option<(Self, usize)> {
        use Symbol::{After, Infix};
        let two = match (first, second) {
            ('<', Some('>')) | ('!', Some('=')) => Some(Binary::NotEqual),
            ('<', Some('=')) => Some(Binary::LessOrEqual),
            ('>', Some('=')) => Some(Binary::GreaterOrEqual),
            ('=', Some('=')) => Some(Binary::Equal),
            _ => None,
        };
        if let Some(operator) = two {
            return Some((Infix(operator), 2));
        }
        let symbol = match first {
            '+' => Self::Plus,
            // The hyphen, the minus sign and the dashes a text editor makes of it.
            '-' | '−' | '–' => Self::Minus,
            '*' | '∗' => Infix(Binary::Multiply),
            '/' | '÷' | '∕' => Infix(Binary::Divide),
            '\\' => Infix(Binary::IntegerDivide),
            '%' => Infix(Binary::Modulus),
            '^' => Infix(Binary::Power),
            '&' => Infix(Binary::Join),
            '=' => Infix(Binary::Equal),
            '≠' => Infix(Binary::NotEqual),
            '<' => Infix(Binary::Less),
            '>' => Infix(Binary::Greater),
            '≤' | '⩽' => Infix(Binary::LessOrEqual),
            '≥' | '⩾' => Infix(Binary::GreaterOrEqual),
            '≈' => Infix(Binary::Near),
            '×' | '⨯' => Infix(Binary::Cross),
            '·' | '•' | '∙' | '⋅' => Infix(Binary::Dot),
            '∠' => Infix(Binary::Angle),
            '!' => After(Postfix::Factorial),
            '²' => After(Postfix::Square),
            '³' => After(Postfix::Cube),
            '°' => After(Postfix::Degree),
            'ⅈ' => After(Postfix::Imaginary),
            _ => return None,
        };
        Some((symbol, 1))
    }
}
