//! How dimension styles show lengths: by units from version 60 on, by a format and a factor before.

use crate::unit_scale::unit_metres;

/// How lengths are shown: as version 60 numbers it, and by what they are multiplied.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Length {
    pub(crate) display: i32,
    pub(crate) factor: f64,
}

/// The numbers of displays that are not simply units.
const MODEL_UNITS: i32 = 0;
const INCHES_FRACTIONAL: i32 = 1;
const FEET_AND_INCHES: i32 = 2;
/// The numbers of the formats before version 60.
const FRACTIONAL: i32 = 1;
const OLD_FEET_AND_INCHES: i32 = 2;
/// Displays with the unit they show; those in which one looks for the unit that a factor stands for come first.
const UNITS: [(i32, i32); 9] =
    [(3, 2), (4, 3), (5, 4), (6, 5), (7, 8), (8, 9), (9, 10), (INCHES_FRACTIONAL, 8), (FEET_AND_INCHES, 9)];
const SOUGHT: usize = 7;
const INCHES: i32 = 8;
/// Greater numbers stand for none.
const UNSET: f64 = 1.234_321_012_343_21e308;
/// How near a factor must be to that of a unit.
const CLOSE: f64 = 0.001;

impl Length {
    /// Lengths in the units of the model.
    pub(crate) const MODEL: Self = Self { display: MODEL_UNITS, factor: 1.0 };

    /// The unit of archives that is shown; 0 for that of the model.
    pub(super) fn unit(self) -> i32 {
        UNITS.iter().find(|(display, _)| *display == self.display).map_or(0, |(_, unit)| *unit)
    }

    /// The format before version 60.
    pub(super) fn format(self) -> i32 {
        match self.display {
            INCHES_FRACTIONAL => FRACTIONAL,
            FEET_AND_INCHES => OLD_FEET_AND_INCHES,
            _ => 0,
        }
    }

    /// Format and factor before version 60, in a model of the given unit.
    pub(super) fn to_older(self, model: i32) -> (i32, f64) {
        let factor = if is_set(self.factor) { self.factor } else { 1.0 };
        if self.display == FEET_AND_INCHES {
            return (OLD_FEET_AND_INCHES, factor);
        }
        match (unit_metres(model), unit_metres(self.unit())) {
            (Some(model), Some(shown)) => (self.format(), factor * (model / shown)),
            _ => (0, factor),
        }
    }

    /// What a format and factor of before version 60 mean in a model of the given unit.
    pub(super) fn from_older(format: i32, factor: f64, model: i32) -> Self {
        if format == OLD_FEET_AND_INCHES {
            return Self { display: FEET_AND_INCHES, factor: 1.0 };
        }
        let factor = if is_set(factor) { factor } else { 1.0 };
        let as_it_is = Self { display: MODEL_UNITS, factor };
        let Some(metres) = unit_metres(model) else { return as_it_is };
        let fractional = |display: i32, unit: i32| {
            if format == FRACTIONAL && unit == INCHES { INCHES_FRACTIONAL } else { display }
        };
        if (1.0 - factor).abs() <= CLOSE {
            return Self { display: fractional(MODEL_UNITS, model), factor: 1.0 };
        }
        let units = UNITS.iter().take(SOUGHT).filter_map(|(display, unit)| {
            let of_unit = metres / unit_metres(*unit)?;
            let apart = (of_unit - factor).abs();
            (apart <= CLOSE * of_unit).then_some((apart, fractional(*display, *unit)))
        });
        let nearest = units.min_by(|(a, _), (b, _)| a.total_cmp(b));
        nearest.map_or(as_it_is, |(_, display)| Self { display, factor: 1.0 })
    }
}

fn is_set(factor: f64) -> bool {
    factor > 0.0 && factor < UNSET
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_factor_near_that_of_a_unit_stands_for_the_unit() {
        let millimetres = Length { display: 3, factor: 1.0 };
        assert_eq!(Length::from_older(0, 1000.0, 4), millimetres);
        assert_eq!(Length::from_older(0, 1000.5, 4), millimetres);
        assert_eq!(Length::from_older(0, 1002.0, 4), Length { display: 0, factor: 1002.0 });
        assert_eq!(Length::from_older(FRACTIONAL, 1.0, INCHES).display, INCHES_FRACTIONAL);
        assert_eq!(millimetres.to_older(4), (0, 1000.0));
        // A model without a unit cannot be shown in another.
        assert_eq!(millimetres.to_older(0), (0, 1.0));
    }
}
