#![allow(missing_docs)]
use crate::*;
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix;
impl Matrix {
    pub fn identity(_: usize) -> Self {
        Self
    }
    pub fn from_rows(_: &[Vec<f64>]) -> Result<Self> {
        Ok(Self)
    }
    pub fn rows(&self) -> usize {
        0
    }
    pub fn columns(&self) -> usize {
        0
    }
    pub fn add(&self, _: &Self) -> Result<Self> {
        Ok(Self)
    }
    pub fn scaled(&self, _: f64) -> Self {
        Self
    }
    pub fn multiply(&self, _: &Self) -> Result<Self> {
        Ok(Self)
    }
}
impl Rectangle {
    pub fn corners(&self) -> [Point3; 4] {
        [Point3::ORIGIN; 4]
    }
}
impl Box3 {
    pub fn corners(&self) -> [Point3; 8] {
        [Point3::ORIGIN; 8]
    }
}
impl Curve {
    pub fn is_linear(&self, _: f64) -> bool {
        false
    }
    pub fn as_circle(&self, _: f64) -> Option<Circle> {
        None
    }
    pub fn as_arc(&self, _: f64) -> Option<Arc> {
        None
    }
    pub fn as_polyline(&self) -> Option<Vec<Point3>> {
        None
    }
    pub fn plane(&self, _: f64) -> Option<Plane> {
        None
    }
    pub fn bounding_box(&self) -> BoundingBox {
        BoundingBox { min: Point3::ORIGIN, max: Point3::ORIGIN }
    }
}
impl BoundingBox {
    pub fn from_points(_: impl IntoIterator<Item = Point3>) -> Option<Self> {
        None
    }
    pub fn union(&self, _: &Self) -> Self {
        *self
    }
}
impl Mesh {
    pub fn from_box(_: &Box3, _: usize, _: usize, _: usize) -> Result<Self> {
        Err(Error::Unsupported(""))
    }
}
impl crate::Curve {
    pub fn with_domain(&self, _: crate::Interval) -> crate::Result<Self> {
        Ok(self.clone())
    }
}
