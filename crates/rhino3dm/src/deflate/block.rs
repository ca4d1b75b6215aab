use super::bits::BitWriter;
use super::codes::HuffmanCode;
use super::symbols::{
    CODE_LENGTH_EXTRA, CODE_LENGTH_ORDER, CODE_LENGTHS, Coded, DISTANCE_EXTRA, DISTANCES, END_OF_BLOCK,
    LENGTH_EXTRA, LITERALS_AND_LENGTHS, of_distance, of_length,
};

/// A block ends when it has so many symbols.
const MOST_SYMBOLS: usize = 16383;
/// The kinds of blocks (RFC 1951, section 3.2.3).
const STORED: u32 = 0;
const FIXED: u32 = 1;
const DYNAMIC: u32 = 2;

/// A literal, or a match when its distance is not 0.
#[derive(Debug, Clone, Copy)]
struct Symbol {
    distance: u16,
    /// The literal, or the length of the match.
    value: u16,
}

/// Symbols collected for one block.
#[derive(Debug)]
pub(super) struct Block {
    symbols: Vec<Symbol>,
    literals: Vec<u32>,
    distances: Vec<u32>,
}

impl Block {
    pub(super) fn new() -> Self {
        let mut block = Self {
            symbols: Vec::with_capacity(MOST_SYMBOLS),
            literals: vec![0; LITERALS_AND_LENGTHS],
            distances: vec![0; DISTANCES],
        };
        block.clear();
        block
    }

    fn clear(&mut self) {
        self.symbols.clear();
        self.literals.fill(0);
        self.distances.fill(0);
        self.literals[END_OF_BLOCK] = 1;
    }

    /// Adds a literal; says whether the block is full.
    pub(super) fn literal(&mut self, byte: u8) -> bool {
        self.literals[usize::from(byte)] += 1;
        self.symbols.push(Symbol { distance: 0, value: u16::from(byte) });
        self.symbols.len() == MOST_SYMBOLS
    }

    /// Adds a match of 3 to 258 bytes at a distance of 1 to 32768; says whether the block is full.
    pub(super) fn repeat(&mut self, length: u16, distance: u16) -> bool {
        self.literals[of_length(u32::from(length)).symbol] += 1;
        self.distances[of_distance(u32::from(distance)).symbol] += 1;
        self.symbols.push(Symbol { distance, value: length });
        self.symbols.len() == MOST_SYMBOLS
    }

    /// Writes the block in the form that is shortest; `plain` is what it stands for. Empties it.
    pub(super) fn write(&mut self, plain: &[u8], is_last: bool, out: &mut BitWriter) {
        let literals = HuffmanCode::from_frequencies(&self.literals, 15);
        let distances = HuffmanCode::from_frequencies(&self.distances, 15);
        let header = Header::new(&literals, &distances);
        let fixed = fixed_codes();
        let bytes = |bits: u64| (bits + 3 + 7) >> 3;
        let dynamic_size = bytes(self.cost(&literals, &distances) + header.cost());
        let fixed_size = bytes(self.cost(&fixed[0], &fixed[1]));
        let last = u32::from(is_last);
        if plain.len() as u64 + 4 <= dynamic_size.min(fixed_size)
            && let Ok(length) = u16::try_from(plain.len())
        {
            out.bits(STORED << 1 | last, 3);
            out.align();
            out.bytes(&length.to_le_bytes());
            out.bytes(&(!length).to_le_bytes());
            out.bytes(plain);
        } else if fixed_size <= dynamic_size {
            out.bits(FIXED << 1 | last, 3);
            self.write_symbols(&fixed[0], &fixed[1], out);
        } else {
            out.bits(DYNAMIC << 1 | last, 3);
            header.write(&literals, &distances, out);
            self.write_symbols(&literals, &distances, out);
        }
        self.clear();
    }

    /// Bits of all symbols and the end mark.
    fn cost(&self, literals: &HuffmanCode, distances: &HuffmanCode) -> u64 {
        let length_extra = |s: usize| s.checked_sub(END_OF_BLOCK + 1).map_or(0, |i| LENGTH_EXTRA[i]);
        literals.cost(&self.literals, length_extra) + distances.cost(&self.distances, |s| DISTANCE_EXTRA[s])
    }

    fn write_symbols(&self, literals: &HuffmanCode, distances: &HuffmanCode, out: &mut BitWriter) {
        for symbol in &self.symbols {
            if symbol.distance == 0 {
                send(literals, usize::from(symbol.value), out);
            } else {
                send_coded(literals, of_length(u32::from(symbol.value)), out);
                send_coded(distances, of_distance(u32::from(symbol.distance)), out);
            }
        }
        send(literals, END_OF_BLOCK, out);
    }
}

fn send(code: &HuffmanCode, symbol: usize, out: &mut BitWriter) {
    let code = code.codes[symbol];
    out.bits(u32::from(code.bits), u32::from(code.length));
}

fn send_coded(code: &HuffmanCode, coded: Coded, out: &mut BitWriter) {
    send(code, coded.symbol, out);
    out.bits(coded.extra, coded.extra_bits);
}

/// The codes that need no header (RFC 1951, section 3.2.6).
fn fixed_codes() -> [HuffmanCode; 2] {
    let mut lengths = [8_u8; 288];
    lengths[144..256].fill(9);
    lengths[256..280].fill(7);
    [HuffmanCode::from_lengths(&lengths), HuffmanCode::from_lengths(&[5; DISTANCES])]
}

/// The codes of a block, run-length coded and coded once more (RFC 1951, section 3.2.7).
struct Header {
    runs: Vec<Coded>,
    frequencies: Vec<u32>,
    code: HuffmanCode,
    /// How many lengths of `code` are sent.
    sent: usize,
}

impl Header {
    fn new(literals: &HuffmanCode, distances: &HuffmanCode) -> Self {
        let mut runs = Vec::new();
        for code in [literals, distances] {
            let lengths: Vec<u8> = code.codes[..=code.last].iter().map(|c| c.length).collect();
            run_lengths(&lengths, &mut runs);
        }
        let mut frequencies = vec![0; CODE_LENGTHS];
        runs.iter().for_each(|run| frequencies[run.symbol] += 1);
        let code = HuffmanCode::from_frequencies(&frequencies, 7);
        let used = CODE_LENGTH_ORDER.iter().rposition(|s| code.codes[*s].length > 0);
        Self { runs, frequencies, sent: used.unwrap_or(0).max(3) + 1, code }
    }

    /// Bits of the header behind the kind of block.
    fn cost(&self) -> u64 {
        let runs = self.code.cost(&self.frequencies, |s| CODE_LENGTH_EXTRA[s]);
        runs + 3 * self.sent as u64 + 5 + 5 + 4
    }

    fn write(&self, literals: &HuffmanCode, distances: &HuffmanCode, out: &mut BitWriter) {
        let small = |n: usize| u32::try_from(n).unwrap_or(0);
        out.bits(small(literals.last + 1 - 257), 5);
        out.bits(small(distances.last), 5);
        out.bits(small(self.sent - 4), 4);
        for symbol in CODE_LENGTH_ORDER.iter().take(self.sent) {
            out.bits(u32::from(self.code.codes[*symbol].length), 3);
        }
        self.runs.iter().for_each(|run| send_coded(&self.code, *run, out));
    }
}

/// Runs of one length: themselves when short, else a symbol that repeats the last length 3 to 6 times (16) or zero 3
/// to 10 (17) or 11 to 138 times (18). A run that was repeated goes on with the same symbol.
fn run_lengths(lengths: &[u8], runs: &mut Vec<Coded>) {
    let mut previous: Option<u8> = None;
    for run in lengths.chunk_by(|a, b| a == b) {
        let length = run.first().copied().unwrap_or_default();
        let mut left = run.len();
        while left > 0 {
            let repeats = previous == Some(length);
            let most = match (length, repeats) {
                (0, _) => 138,
                (_, true) => 6,
                (_, false) => 7,
            };
            let count = left.min(most);
            left -= count;
            push_run(length, count, repeats, runs);
            previous = Some(length);
        }
    }
}

fn push_run(length: u8, count: usize, repeats: bool, runs: &mut Vec<Coded>) {
    let plain = Coded { symbol: usize::from(length), extra: 0, extra_bits: 0 };
    let value = |base: usize| u32::try_from(count.saturating_sub(base)).unwrap_or(0);
    if length == 0 {
        match count {
            0..3 => runs.extend(std::iter::repeat_n(plain, count)),
            3..11 => runs.push(Coded { symbol: 17, extra: value(3), extra_bits: 3 }),
            _ => runs.push(Coded { symbol: 18, extra: value(11), extra_bits: 7 }),
        }
    } else if repeats {
        if count < 3 {
            runs.extend(std::iter::repeat_n(plain, count));
        } else {
            runs.push(Coded { symbol: 16, extra: value(3), extra_bits: 2 });
        }
    } else if count < 4 {
        runs.extend(std::iter::repeat_n(plain, count));
    } else {
        runs.push(plain);
        runs.push(Coded { symbol: 16, extra: value(4), extra_bits: 2 });
    }
}
