//! stub
#![allow(missing_docs)]
use katydid_geometry::{Plane, Point3};
use std::sync::Arc;
pub mod format {
    pub fn parse_number(s: &str) -> Option<f64> {
        s.trim().parse().ok()
    }
}
pub struct Expression;
pub struct Program;
#[derive(Debug)]
pub struct E;
impl E {
    pub fn render(&self, _: &str) -> String {
        String::new()
    }
}
#[derive(Clone)]
pub enum Variant {
    Null,
    Boolean(bool),
    Integer(i32),
    Number(f64),
    Text(Arc<str>),
    Point(Point3),
    Plane(Plane),
    Complex { re: f64, im: f64 },
}
impl Expression {
    pub fn parse(_: &str) -> Result<Self, E> {
        Err(E)
    }
    pub fn bind(&self, _: &[&str]) -> Result<Program, E> {
        Err(E)
    }
}
impl Program {
    pub fn evaluate(&self, _: &[Variant]) -> Result<Variant, E> {
        Err(E)
    }
    pub fn evaluate_numbers(&self, _: &[&[f64]], _: usize) -> Option<Result<Vec<f64>, E>> {
        None
    }
}
