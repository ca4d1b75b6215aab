//! The union of many solids.

use manifold_rust::manifold::Manifold;
use manifold_rust::types::{Box as Bounds, WindingRule};

use super::{Solid, guarded};
use crate::{Result, cancellation, parallel};

/// So many solids are looked at together: each is held against the boxes of the others.
const TOGETHER: usize = 1000;

impl Solid {
    /// What is in any of them; nothing when there are none.
    ///
    /// # Method
    /// Solids whose boxes do not touch are put side by side without a cut, so that what is left to unite is as many
    /// sets as lie over one another at the densest place, about. The sets are united in pairs of about the same size.
    ///
    /// # Errors
    /// As [`Solid::union`].
    pub fn united(solids: &[Self]) -> Result<Self> {
        match solids {
            [] => return Ok(Self::nothing()),
            [one] => return Ok(one.clone()),
            _ => {}
        }
        let mut left = every(solids, Self::without_crossings)?;
        left.retain(|solid| !solid.is_empty());
        while left.len() > 1 {
            let mut united = Vec::new();
            for some in left.chunks(TOGETHER) {
                united.push(in_pairs(every(&apart(some)?, |set| composed(set))?)?);
            }
            left = united;
        }
        Ok(left.pop().unwrap_or_else(Self::nothing))
    }

    /// The same solid with a boundary that does not go through itself.
    fn without_crossings(&self) -> Result<Self> {
        if self.is_simple() {
            return Ok(self.clone());
        }
        cancellation::room::<[u64; 48]>(self.body.num_tri())?;
        guarded(|| self.body.rebuild_solid(WindingRule::Positive))
    }
}

fn every<T: Sync>(items: &[T], work: impl Fn(&T) -> Result<Solid> + Sync + Send) -> Result<Vec<Solid>> {
    let asked = |item: &T| {
        cancellation::check_now()?;
        work(item)
    };
    parallel::each(items, asked).into_iter().collect()
}

/// Sets of solids whose boxes do not touch, each solid in the first set where it has room.
fn apart(solids: &[Solid]) -> Result<Vec<Vec<&Solid>>> {
    let mut sets: Vec<(Vec<&Solid>, Vec<Bounds>)> = Vec::new();
    for solid in solids {
        cancellation::check()?;
        let bounds = solid.body.bounding_box();
        let has_room = |set: &&mut (Vec<_>, Vec<Bounds>)| !set.1.iter().any(|b| b.does_overlap_box(&bounds));
        match sets.iter_mut().find(has_room) {
            Some((members, boxes)) => {
                members.push(solid);
                boxes.push(bounds);
            }
            None => sets.push((vec![solid], vec![bounds])),
        }
    }
    Ok(sets.into_iter().map(|(members, _)| members).collect())
}

/// Solids that do not touch as one.
fn composed(set: &[&Solid]) -> Result<Solid> {
    if let [one] = set {
        return Ok((*one).clone());
    }
    cancellation::room::<[u64; 48]>(set.iter().map(|solid| solid.body.num_tri()).sum())?;
    let parts: Vec<Manifold> = set.iter().map(|solid| solid.body.clone()).collect();
    let made = guarded(|| Manifold::compose(&parts))?;
    Ok(Solid { proven: set.iter().all(|solid| solid.is_simple()), ..made })
}

/// Unites round by round, each with the one that is next in size: no triangle is handled more often than the number of
/// rounds, and a large part not once for each small one.
fn in_pairs(mut left: Vec<Solid>) -> Result<Solid> {
    while left.len() > 1 {
        left.sort_by_key(|solid| solid.body.num_tri());
        let pairs: Vec<&[Solid]> = left.chunks(2).collect();
        left = every(&pairs, |pair| match pair {
            [a, b] => a.union(b),
            rest => Ok(rest.first().cloned().unwrap_or_else(Solid::nothing)),
        })?;
    }
    Ok(left.pop().unwrap_or_else(Solid::nothing))
}
