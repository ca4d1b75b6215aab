//! The order of many numbers.

/// So many numbers are sorted in one go, which takes some tens of milliseconds: in between one looks whether anybody waits.
const RUN: usize = 1 << 20;

/// The places of numbers from the smallest to the largest, those of equal ones in order; −0 equals 0. Numbers that are
/// none (NaN) come first or last, by their sign.
///
/// A number's leading bits and its place are packed into one integer, and integers are what a machine sorts quickest.
/// Where leading bits are equal, all of them tell. When `go_on` says no there is none: where there are more than [`RUN`]
/// numbers the result may be empty.
pub(super) fn ascending(numbers: &[f64], go_on: impl Fn() -> bool) -> Vec<usize> {
    // So many bits hold every place.
    let width = usize::BITS - numbers.len().saturating_sub(1).leading_zeros();
    let places = 1_u64.checked_shl(width).map_or(u64::MAX, |end| end - 1);
    let pack = |(place, &x): (usize, &f64)| rank(x) & !places | place as u64;
    let mut packed: Vec<u64> = numbers.iter().enumerate().map(pack).collect();
    if !sorted_in_runs(&mut packed, RUN, go_on) {
        return Vec::new();
    }
    let mut order: Vec<usize> = packed.iter().map(|packed| (packed & places) as usize).collect();
    let mut rest = order.as_mut_slice();
    for run in packed.chunk_by(|a, b| a & !places == b & !places) {
        let Some((alike, others)) = std::mem::take(&mut rest).split_at_mut_checked(run.len()) else { break };
        if alike.len() > 1 {
            whole(numbers, alike);
        }
        rest = others;
    }
    order
}

/// Sorts runs of so many, which are then merged two by two. `false` when it was given up in between.
fn sorted_in_runs(all: &mut [u64], run: usize, go_on: impl Fn() -> bool) -> bool {
    if all.len() <= run {
        all.sort_unstable();
        return true;
    }
    let sorted = all.chunks_mut(run).all(|part| {
        part.sort_unstable();
        go_on()
    });
    let mut size = run;
    while sorted && size < all.len() {
        size = size.saturating_mul(2);
        // A stable sort finds the two runs, and only merges them.
        let merged = all.chunks_mut(size).all(|pair| {
            pair.sort();
            go_on()
        });
        if !merged {
            return false;
        }
    }
    sorted
}

/// Sorts places by all bits of their numbers.
fn whole(numbers: &[f64], places: &mut [usize]) {
    let key = |place: usize| (rank(numbers.get(place).copied().unwrap_or(0.0)), place);
    let mut keys: Vec<(u64, usize)> = places.iter().map(|&place| key(place)).collect();
    keys.sort_unstable();
    for (place, (_, sorted)) in places.iter_mut().zip(keys) {
        *place = sorted;
    }
}

/// An integer that grows with the number: the bits of positive numbers do, those of negative ones fall.
fn rank(x: f64) -> u64 {
    // −0 becomes 0.
    let bits = (x + 0.0).to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use proptest::prelude::*;

    use super::sorted_in_runs;

    fn ascending(numbers: &[f64]) -> Vec<usize> {
        super::ascending(numbers, || true)
    }

    fn stable(numbers: &[f64]) -> Vec<usize> {
        let mut places: Vec<usize> = (0..numbers.len()).collect();
        places.sort_by(|&a, &b| numbers[a].partial_cmp(&numbers[b]).unwrap());
        places
    }

    #[test]
    fn few_and_equal_numbers() {
        assert_eq!(ascending(&[]), [0; 0]);
        assert_eq!(ascending(&[f64::NAN]), [0]);
        assert_eq!(ascending(&[0.0, -0.0, -1.0, 0.0]), [2, 0, 1, 3]);
        assert_eq!(ascending(&[f64::INFINITY, 1.0, f64::NEG_INFINITY, -5e-324]), [2, 3, 1, 0]);
        // Numbers that differ in their last bits only.
        let close: Vec<f64> =
            (0..3000_u64).map(|i| f64::from_bits(1.0_f64.to_bits() + i * 7919 % 3001)).collect();
        assert_eq!(ascending(&close), stable(&close));
    }

    #[test]
    fn it_is_given_up_between_two_runs() {
        let asked = Cell::new(0);
        let twice = || {
            asked.set(asked.get() + 1);
            asked.get() < 3
        };
        let mut all: Vec<u64> = (0..100).rev().collect();
        assert!(!sorted_in_runs(&mut all, 10, twice));
        assert_eq!((asked.get(), all[0], all[30], all[99]), (3, 90, 69, 0), "three runs are sorted");
    }

    proptest! {
        #[test]
        fn runs_are_merged(mut all in prop::collection::vec(0..50_u64, 0..200), run in 1..40_usize) {
            let mut wanted = all.clone();
            wanted.sort_unstable();
            prop_assert!(sorted_in_runs(&mut all, run, || true));
            prop_assert_eq!(all, wanted);
        }

        #[test]
        fn as_a_stable_sort(numbers in prop::collection::vec(
            prop_oneof![any::<f64>().prop_filter("a number", |x| !x.is_nan()), (-3..3).prop_map(f64::from)],
            0..300,
        )) {
            prop_assert_eq!(ascending(&numbers), stable(&numbers));
        }
    }
}
