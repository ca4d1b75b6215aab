//! Which input moves an output: here, and over the whole range.

mod borders;
mod differences;
mod here;
mod morris;
pub(crate) mod sample;
mod variance;

use katydid_component::Cancel;

pub use differences::Derivative;
pub use here::{End, Here, Slope};
pub use morris::Screening;
pub(crate) use sample::value_of;
pub use variance::Share;

use crate::probe::{Probe, one_number};
use crate::thresholds::{MOST_EFFECT_SOLVES, WALKS};
use crate::{Prepared, StudyError, Variable};

/// What moves an output where the definition stands: the derivative of its number by each slider and number of a gene pool, and from
/// where to where that holds. Toggles and lists are left out, as they have no nearby values.
///
/// The numbers need not be such as sliders round to; sliders of whole numbers are moved by steps.
///
/// # Errors
/// The first output of the definition is not one number as it stands, or somebody asked to stop.
pub fn effects_here(prepared: &Prepared, cancel: &Cancel) -> Result<(f64, Vec<Here>), StudyError> {
    here_of(&mut Probe::new(prepared), cancel)
}

/// [`effects_here`], by a probe of the definition.
pub(crate) fn here_of(probe: &mut Probe, cancel: &Cancel) -> Result<(f64, Vec<Here>), StudyError> {
    // A solve that was ended has no number.
    let stopped = |error| if cancel.is_cancelled() { StudyError::Stopped } else { error };
    let value = one_number(probe).map_err(stopped)?;
    let mut found = Vec::new();
    for index in 0..probe.variables().len() {
        found.extend(here::look(probe, index));
        if cancel.is_cancelled() {
            return Err(StudyError::Stopped);
        }
    }
    Ok((value, found))
}

/// What an input does to an output over the whole ranges of all inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranged {
    /// The input.
    pub name: String,
    /// How large its effects are; `None` where there are too few.
    pub screening: Option<Screening>,
    /// Its share in the output's variance; `None` where the output does not change.
    pub share: Option<Share>,
}

/// How effects over the whole range are looked for.
#[derive(Debug, Clone)]
pub struct RangeSettings {
    /// How many pairs of points there are: the solves are so many times the number of inputs and two more. Shares are best for
    /// powers of two.
    pub pairs: usize,
    /// What random numbers begin with.
    pub seed: u64,
    /// How many points are solved side by side.
    pub workers: usize,
    /// Stops it from outside.
    pub cancel: Cancel,
}

/// The effects of all variables on the first output over their whole ranges: Morris's screening and Sobol's shares; the number of
/// points that were solved; and how many of them gave no number and do not count.
///
/// # Errors
/// An input has no range, there are too many points, or somebody asked to stop.
#[cfg(feature = "studies")]
pub fn effects_over_range(
    prepared: &Prepared,
    settings: &RangeSettings,
) -> Result<(Vec<Ranged>, usize, usize), StudyError> {
    let points = RangePoints::new(prepared, settings.pairs, settings.seed)?;
    let values = sample::solve_all(prepared, settings.workers, points.points().to_vec(), &settings.cancel)?;
    Ok(points.ranged(prepared.variables(), &values))
}

/// The points that effects over whole ranges are found from.
#[derive(Debug)]
pub(crate) struct RangePoints {
    walks: morris::Walks,
    pairs: variance::Pairs,
    points: Vec<Vec<crate::Cell>>,
}

impl RangePoints {
    /// # Errors
    /// An input has no range, or there are too many points.
    pub(crate) fn new(prepared: &Prepared, pairs: usize, seed: u64) -> Result<Self, StudyError> {
        let space = sample::Space::of(prepared.variables())?;
        let dimensions = space.dimensions();
        let solves = pairs.saturating_mul(dimensions + 2).saturating_add(WALKS * (dimensions + 1));
        if solves > MOST_EFFECT_SOLVES {
            return Err(StudyError::Unfit(format!("{solves} points are more than {MOST_EFFECT_SOLVES}")));
        }
        let walks = morris::Walks::new(dimensions, WALKS, seed);
        let pairs = variance::Pairs::new(dimensions, pairs, seed);
        let of_walks = walks.points.iter().map(|point| space.point(point));
        let points = of_walks.chain(pairs.points().map(|point| space.point(&point))).collect();
        Ok(Self { walks, pairs, points })
    }

    pub(crate) fn points(&self) -> &[Vec<crate::Cell>] {
        &self.points
    }

    /// The effects, by the values at all points; how many points there are, and how many gave no number.
    pub(crate) fn ranged(
        &self,
        variables: &[Variable],
        values: &[Option<f64>],
    ) -> (Vec<Ranged>, usize, usize) {
        let (of_walks, of_pairs) = values.split_at_checked(self.walks.points.len()).unwrap_or((values, &[]));
        let screenings = self.walks.screened(of_walks);
        let shares = self.pairs.shares(of_pairs);
        let ranged = variables.iter().zip(screenings).enumerate().map(|(at, (variable, screening))| Ranged {
            name: variable.name.clone(),
            screening,
            share: shares.as_ref().and_then(|shares| shares.get(at)).copied(),
        });
        (ranged.collect(), self.points.len(), values.iter().filter(|value| value.is_none()).count())
    }
}
