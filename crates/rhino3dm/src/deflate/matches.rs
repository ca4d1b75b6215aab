//! Finding what came before: chains of places with the same three bytes, and a look one byte ahead for a longer
//! match.

use super::bits::BitWriter;
use super::block::Block;

const SHORTEST: usize = 3;
const LONGEST: usize = 258;
/// How far back a match may lie: the window less what the original keeps free of it.
const FARTHEST: usize = 32768 - (LONGEST + SHORTEST + 1);
/// A shortest match farther than this costs more than three literals.
const TOO_FAR: usize = 4096;
/// A match of this length is good: fewer places are searched for a better one.
const GOOD: usize = 32;
/// Places searched for each match.
const CHAIN: usize = 4096;
const WINDOW: usize = 32768;
const HASHES: usize = 32768;
/// No place. The first byte of a stream is never matched, since its place is this too.
const NONE: usize = 0;

#[derive(Debug, Clone, Copy)]
struct Match {
    length: usize,
    start: usize,
}

const NO_MATCH: Match = Match { length: SHORTEST - 1, start: 0 };

/// The places of the last window by the hash of their three bytes.
struct Chains<'a> {
    plain: &'a [u8],
    heads: Vec<u32>,
    before: Vec<u32>,
}

impl<'a> Chains<'a> {
    fn new(plain: &'a [u8]) -> Self {
        Self { plain, heads: vec![0; HASHES], before: vec![0; WINDOW] }
    }

    /// Enters a place and gives the last one of the same hash. Places without three bytes are not entered.
    fn enter(&mut self, place: usize) -> usize {
        let Some(&[a, b, c]) = self.plain[place..].first_chunk::<3>() else { return NONE };
        let hash = (usize::from(a) << 10 ^ usize::from(b) << 5 ^ usize::from(c)) & (HASHES - 1);
        let head = self.heads[hash];
        self.before[place % WINDOW] = head;
        self.heads[hash] = u32::try_from(place).unwrap_or(0);
        head as usize
    }

    /// The longest match at `place` that is longer than `known`, searched from `candidate` back.
    fn longest(&self, place: usize, candidate: usize, known: Match) -> Match {
        let left = self.plain.len() - place;
        let most = LONGEST.min(left);
        let scan = &self.plain[place..place + most];
        let nearest_excluded = place.saturating_sub(FARTHEST);
        let mut best = Match { length: known.length, start: known.start };
        let mut tries = if known.length >= GOOD { CHAIN / 4 } else { CHAIN };
        let mut candidate = candidate;
        if best.length >= most {
            return Match { length: best.length.min(left), start: best.start };
        }
        // A longer match ends in these two bytes; most candidates fail here, so they are looked at first.
        let mut last_two = pair(scan, best.length - 1);
        loop {
            if pair(self.plain, candidate + best.length - 1) == last_two {
                let length = common_length(scan, &self.plain[candidate..candidate + most]);
                if length > best.length {
                    best = Match { length, start: candidate };
                    if length >= most {
                        break;
                    }
                    last_two = pair(scan, length - 1);
                }
            }
            candidate = self.before[candidate % WINDOW] as usize;
            tries -= 1;
            if candidate <= nearest_excluded || tries == 0 {
                break;
            }
        }
        best
    }
}

/// The two bytes at a place.
fn pair(bytes: &[u8], place: usize) -> Option<[u8; 2]> {
    bytes.get(place..place + 2).and_then(|two| two.try_into().ok())
}

/// How many bytes from the first on are the same.
fn common_length(a: &[u8], b: &[u8]) -> usize {
    let (a_words, _) = a.as_chunks::<8>();
    let (b_words, _) = b.as_chunks::<8>();
    let mut length = 0;
    for (x, y) in a_words.iter().zip(b_words) {
        let differ = u64::from_le_bytes(*x) ^ u64::from_le_bytes(*y);
        if differ != 0 {
            return length + differ.trailing_zeros() as usize / 8;
        }
        length += 8;
    }
    length + a[length..].iter().zip(&b[length..]).take_while(|(x, y)| x == y).count()
}

/// Writes all bytes as blocks, the last of them marked.
pub(super) fn deflate(plain: &[u8], out: &mut BitWriter) {
    let mut chains = Chains::new(plain);
    let mut block = Block::new();
    let mut block_start = 0;
    let mut place = 0;
    let mut current = NO_MATCH;
    // Whether the byte before `place` still waits for what becomes of it.
    let mut waiting = false;
    while place < plain.len() {
        let candidate = chains.enter(place);
        let previous = std::mem::replace(&mut current, NO_MATCH);
        if candidate != NONE && previous.length < LONGEST && place - candidate <= FARTHEST {
            current = chains.longest(place, candidate, previous);
            if current.length == SHORTEST && place - current.start > TOO_FAR {
                current.length = SHORTEST - 1;
            }
        }
        let full = if previous.length >= SHORTEST && current.length <= previous.length {
            // What the last byte began is no worse than what this one begins.
            let end = place - 1 + previous.length;
            (place + 1..end).for_each(|inside| {
                chains.enter(inside);
            });
            let distance = place - 1 - previous.start;
            current = NO_MATCH;
            waiting = false;
            place = end;
            block.repeat(narrow(previous.length), narrow(distance))
        } else if waiting {
            let full = block.literal(plain[place - 1]);
            if full {
                block.write(&plain[block_start..place], false, out);
                block_start = place;
            }
            place += 1;
            false
        } else {
            waiting = true;
            place += 1;
            false
        };
        if full {
            block.write(&plain[block_start..place], false, out);
            block_start = place;
        }
    }
    if waiting {
        block.literal(plain[place - 1]);
    }
    block.write(&plain[block_start..], true, out);
}

fn narrow(n: usize) -> u16 {
    u16::try_from(n).unwrap_or(u16::MAX)
}
