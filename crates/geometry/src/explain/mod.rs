//! Algorithms with every step told: for teaching, and for looking at what a result came from.
//!
//! The results are those of the kernel's own functions; here each intermediate point and number has a name, a rule and its
//! value, as an exact fraction where all that goes in are fractions with small denominators.
//!
//! ```
//! use katydid_geometry::{NurbsCurve, Point3, explain};
//! # fn main() -> katydid_geometry::Result<()> {
//! let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]].map(|[x, y]| Point3::new(x, y, 0.0));
//! let curve = NurbsCurve::new(3, points.to_vec(), vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0])?;
//! let told = explain::de_casteljau(&curve, 0.25)?;
//! assert_eq!(told.rounds[0].steps[0].to_string(), "M = 3/4 A + 1/4 B = (1/4, 1/2, 0)");
//! # Ok(())
//! # }
//! ```

mod combine;
mod fraction;
mod gram_schmidt;
mod insertion;
mod newton;
mod number;
mod product;
mod spline;
mod thresholds;

use std::fmt;

pub use fraction::Fraction;
pub use gram_schmidt::gram_schmidt;
pub use insertion::knot_insertion;
pub use newton::{newton_on_curve, newton_on_surface};
pub use number::Number;
pub use product::matrix_product;
pub use spline::{de_boor, de_casteljau};

/// An algorithm that tells its steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Algorithm {
    /// A point of a Bézier curve by dividing lines.
    DeCasteljau,
    /// A point of a NURBS curve from the control points of its span.
    DeBoor,
    /// A knot more, with the curve as it was.
    KnotInsertion,
    /// The point of a curve or surface nearest to a point.
    Newton,
    /// Vectors made perpendicular and of length 1.
    GramSchmidt,
    /// Rows times columns.
    MatrixProduct,
}

impl Algorithm {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::DeCasteljau,
        Self::DeBoor,
        Self::KnotInsertion,
        Self::Newton,
        Self::GramSchmidt,
        Self::MatrixProduct,
    ];

    /// Its name in files and commands.
    pub const fn name(self) -> &'static str {
        match self {
            Self::DeCasteljau => "de-casteljau",
            Self::DeBoor => "de-boor",
            Self::KnotInsertion => "knot-insertion",
            Self::Newton => "newton",
            Self::GramSchmidt => "gram-schmidt",
            Self::MatrixProduct => "matrix-product",
        }
    }

    /// The one of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|algorithm| algorithm.name() == name)
    }
}

/// What has a name and numbers: one number, or the coordinates of a point or vector.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// Its numbers.
    pub numbers: Vec<Number>,
}

/// One step: a new quantity, and how it comes of those before.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// What it gives.
    pub made: Quantity,
    /// The rule, in symbols: `(u − U4) / (U7 − U4)`; empty where `terms` say it.
    pub rule: String,
    /// What is added up: a factor and a name each. Empty where it is no such sum.
    pub terms: Vec<(Number, String)>,
}

/// Steps that do not need one another.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Round {
    /// The steps.
    pub steps: Vec<Step>,
}

/// An algorithm at work.
#[derive(Debug, Clone, PartialEq)]
pub struct Explanation {
    /// Which one.
    pub algorithm: Algorithm,
    /// What it begins with.
    pub given: Vec<Quantity>,
    /// What it does, in turn.
    pub rounds: Vec<Round>,
    /// What comes out.
    pub result: Vec<Quantity>,
}

impl Quantity {
    fn new(name: impl Into<String>, numbers: Vec<Number>) -> Self {
        Self { name: name.into(), numbers }
    }

    fn measured(name: impl Into<String>, values: &[f64]) -> Self {
        Self::new(name, values.iter().copied().map(Number::measured).collect())
    }

    fn given(name: impl Into<String>, values: &[f64]) -> Self {
        Self::new(name, values.iter().copied().map(Number::given).collect())
    }
}

impl fmt::Display for Quantity {
    /// `name = 2/5`, or `name = (1, 2, 3)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.name, values(&self.numbers))
    }
}

fn values(numbers: &[Number]) -> String {
    match numbers {
        [one] => one.to_string(),
        many => format!("({})", many.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
    }
}

impl fmt::Display for Step {
    /// `M = 3/4 A + 1/4 B = (1/4, 1/2, 0)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.made.name)?;
        if !self.rule.is_empty() {
            write!(f, " = {}", self.rule)?;
        }
        for (place, (factor, name)) in self.terms.iter().enumerate() {
            let sign = if place == 0 { " = " } else { " + " };
            write!(f, "{sign}{factor} {name}")?;
        }
        write!(f, " = {}", values(&self.made.numbers))
    }
}

impl fmt::Display for Explanation {
    /// A line each for what is given, for every step and for the result; an empty line between the rounds.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = |f: &mut fmt::Formatter<'_>, quantities: &[Quantity]| {
            quantities.iter().try_for_each(|quantity| writeln!(f, "  {quantity}"))
        };
        lines(f, &self.given)?;
        for round in &self.rounds {
            writeln!(f)?;
            round.steps.iter().try_for_each(|step| writeln!(f, "  {step}"))?;
        }
        writeln!(f)?;
        lines(f, &self.result)
    }
}
