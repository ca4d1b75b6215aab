//! The operations by their names.

use super::{Fuse, Made, audit};
use crate::{Brep, Result, Tolerance};

impl Brep {
    /// The solids that some solids fill together. What does not meet stays apart; an empty list gives nothing.
    ///
    /// # Errors
    /// As [`Fuse::new`] and [`Fuse::solids`].
    pub fn union(solids: &[Self], tolerance: &Tolerance) -> Result<Vec<Made>> {
        if solids.is_empty() {
            return Ok(Vec::new());
        }
        let made = Fuse::new(solids, tolerance)?.solids(|inside| inside.iter().any(|x| *x))?;
        audit::volumes(audit::Operation::Union, solids, &[], &made)?;
        Ok(made)
    }

    /// What is left of some breps outside of all tools. Open ones are taken as in [`Fuse::oriented`].
    ///
    /// # Errors
    /// As [`Fuse::new`] and [`Fuse::oriented`].
    pub fn difference(solids: &[Self], tools: &[Self], tolerance: &Tolerance) -> Result<Vec<Made>> {
        let made = Self::two_sided(solids, tools, tolerance, |a, b| a && !b)?;
        audit::volumes(audit::Operation::Difference, solids, tools, &made)?;
        Ok(made)
    }

    /// What lies in one of the first breps and in one of the others. Open ones are taken as in [`Fuse::oriented`].
    ///
    /// # Errors
    /// As [`Fuse::new`] and [`Fuse::oriented`].
    pub fn intersection(solids: &[Self], others: &[Self], tolerance: &Tolerance) -> Result<Vec<Made>> {
        let made = Self::two_sided(solids, others, tolerance, |a, b| a && b)?;
        audit::volumes(audit::Operation::Intersection, solids, others, &made)?;
        Ok(made)
    }

    fn two_sided(
        first: &[Self],
        second: &[Self],
        tolerance: &Tolerance,
        wanted: impl Fn(bool, bool) -> bool,
    ) -> Result<Vec<Made>> {
        if first.is_empty() {
            return Ok(Vec::new());
        }
        let all: Vec<&Self> = first.iter().chain(second).collect();
        let split = first.len();
        let any = |inside: Option<&[bool]>| inside.is_some_and(|i| i.iter().any(|x| *x));
        Fuse::of(&all, tolerance)?.oriented(|i| wanted(any(i.get(..split)), any(i.get(split..))))
    }
}
