//! Effects and inputs for a wanted result found in slices, where one thread does everything: a web page's worker.
//!
//! A search that is broken off begins again in the next slice. What the definition gave is kept, so that it comes to where it was
//! without a solve, and goes on: the answer is the one that it gives in one piece.

mod known;

use std::time::Duration;

use katydid_component::Cancel;
use web_time::Instant;

pub(crate) use known::Known;

use crate::effects::{Here, RangePoints, Ranged, here_of, value_of};
use crate::prepared::Left;
use crate::probe::Probe;
use crate::solve_for::{Clock, search};
use crate::{Effort, Prepared, Solution, StudyError};

/// A prepared definition that is asked in slices. A slice ends with the first solve that is done after its time, and has one at
/// least. Each inquiry is about one question.
#[derive(Debug)]
pub struct Inquiry {
    prepared: Prepared,
    probe: Option<Probe>,
    ranges: Option<Ranges>,
    began: Instant,
}

/// Points over whole ranges, and what is known of them.
#[derive(Debug)]
struct Ranges {
    points: RangePoints,
    values: Vec<Option<f64>>,
    left: Option<Left>,
}

impl Inquiry {
    /// Begins; the time of an [`Effort`] counts from here.
    pub fn new(prepared: Prepared) -> Self {
        Self { prepared, probe: None, ranges: None, began: Instant::now() }
    }

    /// The definition that it asks.
    pub fn prepared(&self) -> &Prepared {
        &self.prepared
    }

    /// A slice of [`effects_here`](crate::effects_here); `None` until it is found.
    ///
    /// # Errors
    /// As there.
    pub fn effects_here(&mut self, slice: Duration) -> Option<Result<(f64, Vec<Here>), StudyError>> {
        self.slice(slice, |probe, _| here_of(probe, &Cancel::default()))
    }

    /// A slice of [`solve_for`](crate::solve_for()); `None` until it is found.
    ///
    /// # Errors
    /// As there.
    pub fn solve_for(
        &mut self,
        wanted: &[f64],
        effort: Effort,
        slice: Duration,
    ) -> Option<Result<Solution, StudyError>> {
        self.slice(slice, |probe, began| {
            let clock = Clock { began, time: effort.time };
            search(probe, wanted, effort.rounds, &clock, &Cancel::default())
        })
    }

    fn slice<T>(
        &mut self,
        slice: Duration,
        search: impl FnOnce(&mut Probe, Instant) -> Result<T, StudyError>,
    ) -> Option<Result<T, StudyError>> {
        let until = Instant::now() + slice;
        let probe = self.probe.get_or_insert_with(|| Probe::new(&self.prepared));
        probe.begin_slice(until);
        let found = search(probe, self.began);
        (!probe.is_over()).then_some(found)
    }

    /// A slice of `effects_over_range`, with so many pairs of points; `None` until it is found.
    ///
    /// # Errors
    /// As there.
    #[allow(clippy::type_complexity, reason = "what it gives is the answer in one piece")]
    pub fn effects_over_range(
        &mut self,
        pairs: usize,
        seed: u64,
        slice: Duration,
    ) -> Option<Result<(Vec<Ranged>, usize, usize), StudyError>> {
        let until = Instant::now() + slice;
        let Self { prepared, ranges, .. } = self;
        if ranges.is_none() {
            match RangePoints::new(prepared, pairs, seed) {
                Ok(points) => *ranges = Some(Ranges { points, values: Vec::new(), left: None }),
                Err(error) => return Some(Err(error)),
            }
        }
        let Ranges { points, values, left } = ranges.as_mut()?;
        let mut worker = prepared.take_up(left.take());
        for point in points.points().iter().skip(values.len()) {
            values.push(value_of(&worker.solve(point)));
            if Instant::now() >= until {
                break;
            }
        }
        *left = Some(worker.leave());
        (values.len() == points.points().len()).then(|| Ok(points.ranged(prepared.variables(), values)))
    }
}
