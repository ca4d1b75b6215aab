//! Maths / Operators.

mod comparisons;
mod gates;
mod powers;
mod series;
mod sums;
