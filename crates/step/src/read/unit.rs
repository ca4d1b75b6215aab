//! Units of a representation.

use super::entity::{DEEPEST, File};
use crate::Result;

/// What numbers of a representation mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Units {
    /// The length unit in metres.
    pub(super) metres: f64,
    /// The angle unit in radians.
    pub(super) radians: f64,
    /// How near places are that count as one, in units of length.
    pub(super) tolerance: Option<f64>,
}

impl Units {
    /// The units of a context; millimetres and radians where it tells none.
    pub(super) fn of(file: &File, context: u64) -> Result<Self> {
        let mut units = Self { metres: 1e-3, radians: 1.0, tolerance: None };
        if let Some(record) = file.part(context, "GLOBAL_UNIT_ASSIGNED_CONTEXT") {
            for unit in record.references(0)? {
                if file.is(unit, "LENGTH_UNIT") {
                    units.metres = size(file, unit, 0)?;
                } else if file.is(unit, "PLANE_ANGLE_UNIT") {
                    units.radians = size(file, unit, 0)?;
                }
            }
        }
        if let Some(record) = file.part(context, "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT") {
            let first = record.references(0)?.first().copied();
            let value = first.and_then(|id| file.record(id).ok()?.real(0).ok());
            units.tolerance = value.filter(|x| *x > 0.0);
        }
        Ok(units)
    }
}

/// A unit in metres or radians.
fn size(file: &File, id: u64, depth: usize) -> Result<f64> {
    let record = file.record(id)?;
    if depth > DEEPEST {
        return Err(record.refuse("units that refer to each other in a circle"));
    }
    if let Some(si) = file.part(id, "SI_UNIT") {
        return Ok(si.word(0).map_or(1.0, prefix));
    }
    let Some(based) = file.part(id, "CONVERSION_BASED_UNIT") else {
        return Err(record.refuse("a unit that is not known"));
    };
    let measure = based.reference(1)?;
    let record = file
        .records_of(measure)
        .find(|r| r.real(0).is_ok() && r.maybe(1).is_some())
        .ok_or_else(|| based.refuse("its factor is not told"))?;
    let size = record.real(0)? * size(file, record.reference(1)?, depth + 1)?;
    if size > 0.0 && size.is_finite() { Ok(size) } else { Err(based.refuse("a unit without size")) }
}

fn prefix(word: &str) -> f64 {
    match word {
        "EXA" => 1e18,
        "PETA" => 1e15,
        "TERA" => 1e12,
        "GIGA" => 1e9,
        "MEGA" => 1e6,
        "KILO" => 1e3,
        "HECTO" => 1e2,
        "DECA" => 1e1,
        "DECI" => 1e-1,
        "CENTI" => 1e-2,
        "MILLI" => 1e-3,
        "MICRO" => 1e-6,
        "NANO" => 1e-9,
        "PICO" => 1e-12,
        "FEMTO" => 1e-15,
        "ATTO" => 1e-18,
        _ => 1.0,
    }
}
