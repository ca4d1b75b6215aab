//! The limits of explanations.

/// Newton's method takes no more steps than this: it doubles the digits in each, and stops for want of digits before.
pub(super) const MOST_STEPS: usize = 30;
/// Starting places along a curve, and along each side of a surface's domain: the nearest of them lies in the basin of the
/// nearest point, unless the shape turns more than once between two.
pub(super) const STARTS: (usize, usize) = (128, 24);
/// A step of this part of the domain changes no digit that is shown.
pub(super) const SMALLEST_STEP: f64 = 1e-14;
/// What is left of a vector once its shares along the others are gone: less than this part of it is rounding.
pub(super) const SMALLEST_REST: f64 = 1e-12;
/// A product of matrices is told up to so many entries: more is not read.
pub(super) const MOST_ENTRIES: usize = 400;
/// So many terms an entry at most, for the same reason.
pub(super) const MOST_TERMS: usize = 100;
