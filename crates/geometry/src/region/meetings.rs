//! Where parts of curves meet, worked out once for all tolerances that are tried.

use crate::region::thresholds::MEETS_FINE;
use std::borrow::Cow;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

use super::sources::Sources;
use crate::intersect::{CurveIntersections, curve_curve, curve_self};
use crate::{Error, Result};

/// The most pairs of parts of parts: a few seconds, and more where there are many parts.
const MOST_VISITS: u64 = 10_000_000;
const MORE_VISITS: u64 = 1000;
/// What took fewer is found again as fast as it is looked up.
const WORTH_KEEPING: u64 = 100;

/// The meetings of pairs of parts. They are found as exactly as numbers allow, so that a finer tolerance of the
/// arrangement leaves them as they are.
#[derive(Debug, Default)]
pub(super) struct Meetings {
    fine: f64,
    found: HashMap<(usize, usize), CurveIntersections>,
    visits: u64,
}

impl Meetings {
    /// Where two parts meet, or where one meets itself, in an arrangement of a tolerance.
    ///
    /// # Errors
    /// All meetings together take too much work.
    pub(super) fn of(
        &mut self,
        sources: &Sources,
        pair: (usize, usize),
        tolerance: f64,
    ) -> Result<Cow<'_, CurveIntersections>> {
        let fine = (MEETS_FINE * sources.scale).min(tolerance);
        if fine != self.fine {
            self.found.clear();
            self.fine = fine;
        }
        let room = match self.found.entry(pair) {
            Entry::Occupied(known) => return Ok(Cow::Borrowed(known.into_mut())),
            Entry::Vacant(room) => room,
        };
        let curve = |i: usize| &sources.parts[i].curve;
        let (i, j) = pair;
        let found = if i == j { curve_self(curve(i), fine)? } else { curve_curve(curve(i), curve(j), fine)? };
        self.visits += found.visits;
        if self.visits > MOST_VISITS + MORE_VISITS * sources.parts.len() as u64 {
            return Err(too_much());
        }
        // Of a million pairs of lines nothing is kept.
        Ok(if found.visits > WORTH_KEEPING { Cow::Borrowed(room.insert(found)) } else { Cow::Owned(found) })
    }
}

pub(super) fn too_much() -> Error {
    let why = "its curves meet too often to be told apart".into();
    Error::Invalid { what: "region", why }
}
