//! Points, directions and frames.

use std::cell::Cell;

use super::entity::{File, Record};
use super::unit::Units;
use crate::{Error, Result};
use katydid_geometry::{Line, Plane, Point3, Vector3};

/// The geometry of one representation: its entities in the document's unit.
#[derive(Clone, Copy)]
pub(super) struct Space<'a> {
    pub(super) file: &'a File,
    /// Lengths of the representation in the document's unit.
    pub(super) scale: f64,
    pub(super) units: Units,
    /// How near places are that count as one, in the document's unit.
    pub(super) tolerance: f64,
    /// How many entities may still be looked at: those that hold each other many times would never end.
    pub(super) budget: &'a Cell<usize>,
}

fn triple(record: &Record<'_>) -> Result<[f64; 3]> {
    match record.reals(1)?.as_slice() {
        [x, y, z] => Ok([*x, *y, *z]),
        [x, y] => Ok([*x, *y, 0.0]),
        _ => Err(record.refuse("it has neither two nor three coordinates")),
    }
}

impl Space<'_> {
    /// Takes one from the budget.
    pub(super) fn spend(&self) -> Result<()> {
        let left = self.budget.get().checked_sub(1);
        self.budget.set(left.unwrap_or(0));
        left.map(drop).ok_or_else(|| Error::TooLarge("its entities hold each other too often".into()))
    }

    pub(super) fn length(&self, record: &Record<'_>, place: usize) -> Result<f64> {
        Ok(record.real(place)? * self.scale)
    }

    pub(super) fn angle(&self, record: &Record<'_>, place: usize) -> Result<f64> {
        Ok(record.real(place)? * self.units.radians)
    }

    pub(super) fn point(&self, id: u64) -> Result<Point3> {
        let record = self.file.record(id)?;
        if record.keyword != "CARTESIAN_POINT" {
            return Err(record.refuse("only CARTESIAN_POINT is read where a point should be"));
        }
        let [x, y, z] = triple(&record)?.map(|x| x * self.scale);
        let point = Point3::new(x, y, z);
        if point.is_finite() { Ok(point) } else { Err(record.refuse("it lies too far out")) }
    }

    pub(super) fn direction(&self, id: u64) -> Result<Vector3> {
        let record = self.file.record(id)?;
        let [x, y, z] = triple(&record)?;
        Vector3::new(x, y, z).unitized().ok_or_else(|| record.refuse("it has no direction"))
    }

    /// A direction with its length.
    pub(super) fn vector(&self, id: u64) -> Result<Vector3> {
        let record = self.file.record(id)?;
        let vector = self.direction(record.reference(1)?)? * self.length(&record, 2)?;
        if vector.length() > 0.0 { Ok(vector) } else { Err(record.refuse("it has no length")) }
    }

    /// A frame; what it leaves out is as Part 42 says: z up, and x along the world's as far as it goes.
    pub(super) fn frame(&self, id: u64) -> Result<Plane> {
        let record = self.file.record(id)?;
        let origin = self.point(record.reference(1)?)?;
        let z = record.maybe(2).map_or(Ok(Vector3::Z), |id| self.direction(id))?;
        let usual = if z.cross(Vector3::X).length() > 1e-9 { Vector3::X } else { Vector3::Y };
        let x = record.maybe(3).map_or(Ok(usual), |id| self.direction(id))?;
        let across = |x: Vector3| (x - z * x.dot(z)).unitized();
        let x_axis = if z.cross(x).length() > 1e-9 { across(x) } else { across(usual) };
        let x_axis = x_axis.ok_or_else(|| record.refuse("its axes have one direction"))?;
        Ok(Plane { origin, x_axis, y_axis: z.cross(x_axis), z_axis: z })
    }

    /// An axis.
    pub(super) fn axis(&self, id: u64) -> Result<Line> {
        let record = self.file.record(id)?;
        let origin = self.point(record.reference(1)?)?;
        let z = record.maybe(2).map_or(Ok(Vector3::Z), |id| self.direction(id))?;
        Ok(Line::new(origin, origin + z))
    }
}
