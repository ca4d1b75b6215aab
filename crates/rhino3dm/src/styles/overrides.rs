//! Which numbers of a style are its own and not its parent's, as versions count them.

/// How many numbers styles have that may be their own, before version 60 and from then on.
pub(super) const OLDER: usize = 66;
pub(super) const NEWER: usize = 115;

/// The numbers that count as different ones from version 60 on: first and last before, and the first since.
const RUNS: [(usize, usize, usize); 27] = [
    (2, 4, 3),
    (5, 8, 7),
    (9, 9, 78),
    (9, 9, 79),
    (12, 13, 13),
    (14, 14, 12),
    (15, 18, 15),
    (20, 20, 20),
    (21, 22, 13),
    (23, 27, 21),
    (28, 28, 6),
    (29, 29, 80),
    (30, 31, 26),
    (34, 37, 28),
    (38, 41, 32),
    (42, 42, 36),
    (43, 43, 29),
    (44, 45, 38),
    (46, 49, 40),
    (50, 51, 44),
    (52, 53, 46),
    (54, 54, 48),
    (55, 57, 49),
    (58, 59, 53),
    (60, 62, 55),
    (63, 63, 58),
    (64, 65, 59),
];

/// From before version 60 to later.
pub(super) fn to_newer(older: &[bool]) -> Vec<bool> {
    let mut newer = vec![false; NEWER];
    for (old, new) in pairs() {
        if let Some(own) = newer.get_mut(new) {
            *own |= older.get(old).copied().unwrap_or_default();
        }
    }
    newer
}

/// From version 60 and later to before.
pub(super) fn to_older(newer: &[bool]) -> Vec<bool> {
    let mut older = vec![false; OLDER];
    for (old, new) in pairs() {
        if let Some(own) = older.get_mut(old) {
            *own |= newer.get(new).copied().unwrap_or_default();
        }
    }
    older
}

fn pairs() -> impl Iterator<Item = (usize, usize)> {
    RUNS.iter().flat_map(|(first, last, new)| (*first..=*last).zip(*new..))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_find_their_way_back() {
        for old in [2, 4, 7, 9, 16, 25, 28, 31, 54, 59, 64] {
            let mut older = vec![false; OLDER];
            older[old] = true;
            assert!(to_older(&to_newer(&older))[old], "{old}");
        }
    }
}
