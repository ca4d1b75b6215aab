use katydid_geometry::Interval;

use crate::Result;
use crate::archive::{Chunk, Decimal, ItemValue};
use crate::document::edit::set_number;
use crate::document::{Object, ids};

/// An MD Slider: a point in a square or cube.
#[derive(Debug, Clone, PartialEq)]
pub struct MdSlider {
    /// Where the grip stands, 0 to 1 along each axis.
    pub value: [f64; 3],
    /// The ranges of x, y and z.
    pub domains: [Interval; 3],
    /// 0 in every known file: two axes, z stays 0.
    pub mode: i32,
}

/// A Control Knob.
#[derive(Debug, Clone, PartialEq)]
pub struct Knob {
    /// The value.
    pub value: f64,
    /// The smallest value, where `limited`.
    pub min: f64,
    /// The largest value, where `limited`.
    pub max: f64,
    /// Whether the limits hold.
    pub limited: bool,
    /// What one turn is worth.
    pub range: f64,
    /// Digits after the point.
    pub decimals: i32,
}

/// A Digit Scroller.
#[derive(Debug, Clone, PartialEq)]
pub struct DigitScroller {
    /// The value.
    pub value: f64,
    /// How many digits are shown.
    pub digits: i32,
    /// After how many digits the point stands.
    pub radix: i32,
    /// The text before the digits.
    pub prefix: String,
    /// The text after the digits.
    pub suffix: String,
}

/// A Gene Pool: a list of numbers between the same limits.
#[derive(Debug, Clone, PartialEq)]
pub struct GenePool {
    /// The numbers, not yet rounded.
    pub values: Vec<f64>,
    /// Digits after the point that the output is rounded to.
    pub decimals: i32,
    /// The smallest value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
}

impl MdSlider {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        let domain = |name| c.interval(name).map_or(Interval::UNIT, |[a, b]| Interval::new(a, b));
        Some(Self {
            value: c.point3d("slider_value")?,
            domains: [domain("x_domain"), domain("y_domain"), domain("z_domain")],
            mode: c.i32("SliderMode").unwrap_or(0),
        })
    }
}

impl Knob {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        let chunk = c.child("DialData")?;
        Some(Self {
            value: chunk.f64("Value")?,
            min: chunk.f64("Minimum").unwrap_or(0.0),
            max: chunk.f64("Maximum").unwrap_or(0.0),
            limited: chunk.bool("Limit").unwrap_or(false),
            range: chunk.f64("Range").unwrap_or(1.0),
            decimals: chunk.i32("Decimals").unwrap_or(2),
        })
    }
}

impl DigitScroller {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        let chunk = c.child("Scroller")?;
        Some(Self {
            value: chunk.f64("Value")?,
            digits: chunk.i32("Digits").unwrap_or(0),
            radix: chunk.i32("Radix").unwrap_or(0),
            prefix: chunk.str("Prefix").unwrap_or_default().to_owned(),
            suffix: chunk.str("Suffix").unwrap_or_default().to_owned(),
        })
    }
}

impl GenePool {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        let chunk = c.child("GeneData")?;
        Some(Self {
            values: chunk.list("Value").into_iter().filter_map(|(_, value)| value.as_f64()).collect(),
            decimals: chunk.i32("Decimals").unwrap_or(2),
            min: chunk.f64("Minimum")?,
            max: chunk.f64("Maximum")?,
        })
    }
}

impl Object {
    /// Turns a Control Knob or Digit Scroller to `x`; a knob with limits stays within them. Says where it
    /// stands.
    ///
    /// # Errors
    /// When the object is neither, or `x` is not finite or has too many digits.
    pub fn set_dial(&mut self, x: f64) -> Result<f64> {
        let error = self.refuse(format!("{x} cannot be stored"));
        if !x.is_finite() {
            return Err(error);
        }
        let (place, x) = match self.component {
            ids::CONTROL_KNOB => {
                let knob = Knob::read(self.container()).ok_or_else(|| self.refuse("it has no dial"))?;
                let limited = if knob.limited { x.max(knob.min).min(knob.max) } else { x };
                ("DialData", limited)
            }
            ids::DIGIT_SCROLLER => ("Scroller", x),
            _ => return Err(self.refuse("it is not a Control Knob or Digit Scroller")),
        };
        let chunk = self.container_mut().child_mut(place);
        chunk.and_then(|chunk| set_number(chunk, "Value", x)).ok_or(error)?;
        Ok(x)
    }

    /// Moves the grip of an MD Slider: 0 to 1 along each axis, clamped.
    ///
    /// # Errors
    /// When the object is no MD Slider or a number is not finite.
    pub fn set_md_slider(&mut self, value: [f64; 3]) -> Result<()> {
        if self.component != ids::MD_SLIDER {
            return Err(self.refuse("it is not an MD Slider"));
        }
        if !value.iter().all(|x| x.is_finite()) {
            return Err(self.refuse("its value must be finite"));
        }
        let value = ItemValue::Point3d(value.map(|x| x.clamp(0.0, 1.0)));
        self.container_mut().set("slider_value", value);
        Ok(())
    }

    /// Sets one number of a Gene Pool, within its limits.
    ///
    /// # Errors
    /// When the object is no Gene Pool, has no number of this index, or `x` is not finite.
    pub fn set_gene(&mut self, index: usize, x: f64) -> Result<()> {
        let pool = if self.component == ids::GENE_POOL { GenePool::read(self.container()) } else { None };
        let pool = pool.ok_or_else(|| self.refuse("it is not a Gene Pool"))?;
        if index >= pool.values.len() {
            return Err(self.refuse(format!("it has {} numbers, none with index {index}", pool.values.len())));
        }
        let error = self.refuse(format!("{x} cannot be stored"));
        if !x.is_finite() {
            return Err(error);
        }
        let places = u32::try_from(pool.decimals.clamp(0, 15)).unwrap_or(0);
        let value = Decimal::from_f64(x.max(pool.min).min(pool.max), places);
        let chunk = self.container_mut().child_mut("GeneData");
        let (Some(value), Some(chunk), Ok(index)) = (value, chunk, i32::try_from(index)) else {
            return Err(error);
        };
        chunk.set_at("Value", index, value);
        Ok(())
    }
}
