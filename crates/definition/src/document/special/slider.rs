use crate::archive::Chunk;
use crate::document::edit::set_number;
use crate::document::{Object, ids};
use crate::{Error, Result};

/// A Number Slider.
#[derive(Debug, Clone, PartialEq)]
pub struct Slider {
    /// The value, before the expression.
    pub value: f64,
    /// The smallest value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
    /// Which numbers it takes.
    pub rounding: Rounding,
    /// Digits after the point; counts only where all numbers are taken.
    pub digits: u32,
    /// An expression in `x` that the value goes through.
    pub expression: Option<String>,
}

/// Which numbers a slider takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// All, to so many digits after the point.
    Real,
    /// Whole numbers.
    Integer,
    /// Even numbers.
    Even,
    /// Odd numbers.
    Odd,
}

impl Slider {
    pub(super) fn read(container: &Chunk) -> Option<Self> {
        let chunk = container.child("Slider")?;
        Some(Self {
            value: chunk.f64("Value")?,
            min: chunk.f64("Min")?,
            max: chunk.f64("Max")?,
            rounding: match chunk.i32("Interval") {
                Some(1) => Rounding::Integer,
                Some(2) => Rounding::Even,
                Some(3) => Rounding::Odd,
                _ => Rounding::Real,
            },
            digits: chunk.i32("Digits").and_then(|digits| u32::try_from(digits).ok()).unwrap_or(3).min(12),
            expression: chunk.str("Expression").filter(|text| !text.trim().is_empty()).map(str::to_owned),
        })
    }

    /// The value nearest to `x` that the slider can stand at: within its limits, and rounded by its rule.
    pub fn fit(&self, x: f64) -> f64 {
        let (min, max) = (self.min.min(self.max), self.min.max(self.max));
        let x = x.max(min).min(max);
        // A rule with a step: numbers k·step + first. Rounding may step over a limit, so step back.
        let stepped = |step: f64, first: f64| {
            let at = |k: f64| k * step + first;
            let k = ((x - first) / step).round_ties_even();
            let fitted = [at(k), at(k - 1.0), at(k + 1.0)];
            fitted.into_iter().find(|v| (min..=max).contains(v)).unwrap_or(x)
        };
        match self.rounding {
            Rounding::Real => {
                let places = usize::try_from(self.digits).unwrap_or(12);
                let rounded = format!("{x:.places$}").parse().unwrap_or(x);
                f64::max(rounded, min).min(max)
            }
            Rounding::Integer => stepped(1.0, 0.0),
            Rounding::Even => stepped(2.0, 0.0),
            Rounding::Odd => stepped(2.0, 1.0),
        }
    }
}

impl Object {
    /// Moves a Number Slider as near to `x` as its limits and rounding let it, and says where it stands.
    ///
    /// # Errors
    /// When the object is no Number Slider or `x` is not finite.
    pub fn set_slider(&mut self, x: f64) -> Result<f64> {
        let slider = if self.component == ids::NUMBER_SLIDER { Slider::read(self.container()) } else { None };
        let slider = slider.ok_or_else(|| self.refuse("it is not a Number Slider"))?;
        if !x.is_finite() {
            return Err(self.refuse(format!("{x} is not a finite number")));
        }
        let value = slider.fit(x);
        let error: Error = self.refuse(format!("{value} cannot be stored"));
        let chunk = self.container_mut().child_mut("Slider");
        chunk.and_then(|chunk| set_number(chunk, "Value", value)).ok_or(error)?;
        Ok(value)
    }
}
