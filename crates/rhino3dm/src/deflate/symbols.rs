//! The alphabets of RFC 1951: literals and lengths, distances, code lengths.

/// Literals, the end mark and lengths.
pub(super) const LITERALS_AND_LENGTHS: usize = 286;
/// The symbol behind the last literal.
pub(super) const END_OF_BLOCK: usize = 256;
pub(super) const DISTANCES: usize = 30;
pub(super) const CODE_LENGTHS: usize = 19;

/// Extra bits of each length symbol from 257 on.
pub(super) const LENGTH_EXTRA: [u8; 29] =
    [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
/// Extra bits of each distance symbol.
pub(super) const DISTANCE_EXTRA: [u8; DISTANCES] =
    [0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13];
/// Extra bits of each symbol for code lengths.
pub(super) const CODE_LENGTH_EXTRA: [u8; CODE_LENGTHS] =
    [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 3, 7];
/// In which order the lengths of the code for code lengths are sent.
pub(super) const CODE_LENGTH_ORDER: [usize; CODE_LENGTHS] =
    [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

/// A symbol with the value of its extra bits and how many those are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coded {
    pub(super) symbol: usize,
    pub(super) extra: u32,
    pub(super) extra_bits: u32,
}

/// The symbol of a match of 3 to 258 bytes.
pub(super) fn of_length(length: u32) -> Coded {
    if length == 258 {
        return Coded { symbol: 285, extra: 0, extra_bits: 0 };
    }
    let (step, extra, extra_bits) = steps(length - 3, 2);
    Coded { symbol: 257 + step, extra, extra_bits }
}

/// The symbol of a distance of 1 to 32768.
pub(super) fn of_distance(distance: u32) -> Coded {
    let (symbol, extra, extra_bits) = steps(distance - 1, 1);
    Coded { symbol, extra, extra_bits }
}

/// Symbols stand for ranges that double in length, 2^`fine` of one length: the symbol of a value, and its place in
/// its range.
fn steps(value: u32, fine: u32) -> (usize, u32, u32) {
    if value < 2 << fine {
        return (value as usize, 0, 0);
    }
    let extra_bits = value.ilog2() - fine;
    let step = ((extra_bits << fine) + (value >> extra_bits)) as usize;
    (step, value & ((1 << extra_bits) - 1), extra_bits)
}
