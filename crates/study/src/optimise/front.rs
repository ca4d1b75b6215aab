//! The front of several goals (Pareto).

use super::goals::{Bound, Goal};
use super::nsga2::dominates;
use super::search::{Scored, order};

/// The places of the points that no other is better than: as good in every goal and better in one. Those that miss what must
/// hold are none. A point is its numbers: for each goal what the output is, and for each bound likewise; `None` for what has
/// no results. The places are in the order of the first goal.
pub(crate) fn front(points: &[Option<(Vec<f64>, Vec<f64>)>], goals: &[Goal], bounds: &[Bound]) -> Vec<usize> {
    let scored = points.iter().enumerate().filter_map(|(at, point)| {
        let (numbers, bounded) = point.as_ref()?;
        let holds = bounds.iter().zip(bounded).all(|(bound, x)| bound.missed(*x) == 0.0);
        let goals = goals.iter().zip(numbers).map(|(goal, x)| goal.worth(*x)).collect();
        holds.then_some((at, Scored { place: Vec::new(), goals, missed: 0.0 }))
    });
    let mut all: Vec<(usize, Scored)> = scored.collect();
    // What is best in the first goal goes first: little of what is on the front is taken off again.
    all.sort_by(|a, b| order(&a.1, &b.1));
    let mut front: Vec<(usize, Scored)> = Vec::new();
    for one in all {
        if front.iter().any(|(_, other)| dominates(other, &one.1)) {
            continue;
        }
        front.retain(|(_, other)| !dominates(&one.1, other));
        front.push(one);
    }
    front.into_iter().map(|(at, _)| at).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn it_has_all_that_no_other_is_better_than(points in proptest::collection::vec(proptest::collection::vec(0_u8..6, 3), 0..40)) {
            let goals = [Goal::Least, Goal::Most, Goal::Near(3.0)];
            let numbers = |point: &Vec<u8>| point.iter().map(|x| f64::from(*x)).collect::<Vec<f64>>();
            let given: Vec<_> = points.iter().map(|p| Some((numbers(p), vec![f64::from(p[0])]))).collect();
            let mut found = front(&given, &goals, &[Bound::AtMost(4.0)]);
            found.sort_unstable();
            let worth = |p: &Vec<u8>| [i32::from(p[0]), -i32::from(p[1]), (i32::from(p[2]) - 3).abs()];
            let better = |a: &Vec<u8>, b: &Vec<u8>| {
                let (a, b) = (worth(a), worth(b));
                (0..3).all(|k| a[k] <= b[k]) && a != b
            };
            let free: Vec<usize> = (0..points.len()).filter(|k| points[*k][0] <= 4).collect();
            let wanted: Vec<usize> =
                free.iter().copied().filter(|k| !free.iter().any(|o| better(&points[*o], &points[*k]))).collect();
            prop_assert_eq!(found, wanted);
        }
    }
}
