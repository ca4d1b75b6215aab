//! The Maths tab.

mod arithmetic;
pub(crate) mod comparison;
mod complex;
pub(crate) mod formula;
mod linear;
mod unary;

mod averages;
mod calendars;
mod domain;
mod matrix;
mod operators;
mod polynomials;
mod script;
mod time;
mod trig;
mod util;
