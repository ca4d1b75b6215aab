//! The operators, their precedence and their spelling.

/// Operators between two values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    IntegerDivide,
    Modulus,
    Power,
    Join,
    Cross,
    Dot,
    Angle,
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Near,
    And,
    Or,
    Xor,
}

/// Operators before a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Prefix {
    Plus,
    Minus,
    Not,
}

/// Operators after a value, and `[…]`, which binds as tightly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Postfix {
    Factorial,
    Square,
    Cube,
    Degree,
    Imaginary,
    X,
    Y,
    Z,
    Origin,
    /// `[v]`: the vector made one unit long. Files use it so: `(d2-(d2•T)*T)/(d1•d1)` with `T` = `[d1]` is the
    /// curvature vector only when T is the unit tangent.
    Unitize,
}

/// How tightly operators bind: the six levels of the original's parser (which level holds what is not
/// published), with the words below the comparisons, each looser than the one before.
pub(crate) mod level {
    pub(crate) const XOR: u8 = 1;
    pub(crate) const OR: u8 = 2;
    pub(crate) const AND: u8 = 3;
    pub(crate) const COMPARE: u8 = 4;
    pub(crate) const ADD: u8 = 5;
    pub(crate) const MULTIPLY: u8 = 6;
    pub(crate) const PREFIX: u8 = 7;
    pub(crate) const POWER: u8 = 8;
    pub(crate) const POSTFIX: u8 = 9;
    pub(crate) const PRIMARY: u8 = 10;
}

impl Binary {
    pub(crate) fn level(self) -> u8 {
        match self {
            Self::Xor => level::XOR,
            Self::Or => level::OR,
            Self::And => level::AND,
            Self::Equal
            | Self::NotEqual
            | Self::Less
            | Self::LessOrEqual
            | Self::Greater
            | Self::GreaterOrEqual
            | Self::Near => level::COMPARE,
            Self::Add | Self::Subtract | Self::Join => level::ADD,
            Self::Multiply
            | Self::Divide
            | Self::IntegerDivide
            | Self::Modulus
            | Self::Cross
            | Self::Dot
            | Self::Angle => level::MULTIPLY,
            Self::Power => level::POWER,
        }
    }

    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::IntegerDivide => "\\",
            Self::Modulus => "%",
            Self::Power => "^",
            Self::Join => "&",
            Self::Cross => "×",
            Self::Dot => "•",
            Self::Angle => "∠",
            Self::Equal => "=",
            Self::NotEqual => "≠",
            Self::Less => "<",
            Self::LessOrEqual => "≤",
            Self::Greater => ">",
            Self::GreaterOrEqual => "≥",
            Self::Near => "≈",
            Self::And => "and",
            Self::Or => "or",
            Self::Xor => "xor",
        }
    }
}

impl Prefix {
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Plus => "+",
            Self::Minus => "-",
            Self::Not => "not",
        }
    }
}

impl Postfix {
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Factorial => "!",
            Self::Square => "²",
            Self::Cube => "³",
            Self::Degree => "°",
            Self::Imaginary => "ⅈ",
            Self::X => ".X",
            Self::Y => ".Y",
            Self::Z => ".Z",
            Self::Origin => ".O",
            Self::Unitize => "[ ]",
        }
    }
}
