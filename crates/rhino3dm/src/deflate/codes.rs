//! Huffman codes of limited length, built as the original compressor builds them: among nodes of one frequency the
//! shallower goes first, and lengths beyond the limit are mended afterwards.

/// The longest code of any alphabet.
const MOST_BITS: usize = 15;

/// The bits of one symbol, in the order they are sent, and how many they are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Code {
    pub(super) bits: u16,
    pub(super) length: u8,
}

/// A code for the symbols of an alphabet.
#[derive(Debug)]
pub(super) struct HuffmanCode {
    pub(super) codes: Vec<Code>,
    /// The last symbol that has a code.
    pub(super) last: usize,
}

impl HuffmanCode {
    /// The code for symbols that occur so often. At least two symbols get one.
    pub(super) fn from_frequencies(frequencies: &[u32], most_bits: usize) -> Self {
        let mut tree = Tree::new(frequencies);
        tree.join();
        let lengths = tree.lengths(most_bits);
        let last = tree.last;
        Self { codes: assign(&lengths), last }
    }

    /// The code with these lengths.
    pub(super) fn from_lengths(lengths: &[u8]) -> Self {
        Self { codes: assign(lengths), last: lengths.len().saturating_sub(1) }
    }

    /// Bits that so frequent symbols take, extra bits included.
    pub(super) fn cost(&self, frequencies: &[u32], extra: impl Fn(usize) -> u8) -> u64 {
        let symbols = self.codes.iter().zip(frequencies).enumerate();
        symbols.map(|(s, (code, f))| u64::from(*f) * u64::from(code.length + extra(s))).sum()
    }
}

/// Codes of one length count up from the end of the shorter ones (RFC 1951, section 3.2.2).
fn assign(lengths: &[u8]) -> Vec<Code> {
    let mut counts = [0_u16; MOST_BITS + 1];
    lengths.iter().filter(|l| **l > 0).for_each(|l| counts[usize::from(*l)] += 1);
    let mut next = [0_u16; MOST_BITS + 2];
    for bits in 1..=MOST_BITS {
        next[bits + 1] = next[bits].wrapping_add(counts[bits]) << 1;
    }
    let code = |&length: &u8| {
        if length == 0 {
            return Code::default();
        }
        let place = &mut next[usize::from(length)];
        let bits = place.reverse_bits() >> (16 - u32::from(length));
        *place = place.wrapping_add(1);
        Code { bits, length }
    };
    lengths.iter().map(code).collect()
}

/// A Huffman tree under construction. Nodes below `symbols` are leaves.
struct Tree {
    symbols: usize,
    frequencies: Vec<u32>,
    depths: Vec<u8>,
    parents: Vec<usize>,
    /// A heap of nodes by frequency and depth, its root at 1.
    heap: Vec<usize>,
    /// All nodes, each pair before its parent.
    order: Vec<usize>,
    last: usize,
}

impl Tree {
    fn new(frequencies: &[u32]) -> Self {
        let symbols = frequencies.len();
        let mut heap = vec![0];
        heap.extend((0..symbols).filter(|s| frequencies[*s] > 0));
        let mut frequencies = frequencies.to_vec();
        frequencies.resize(2 * symbols, 0);
        let mut last = heap.iter().skip(1).last().copied();
        while heap.len() < 3 {
            // A code has two symbols at least: what does not occur stands in.
            let stand_in = match last {
                None => 0,
                Some(symbol) if symbol < 2 => symbol + 1,
                Some(_) => 0,
            };
            last = last.max(Some(stand_in));
            frequencies[stand_in] = 1;
            heap.push(stand_in);
        }
        Self {
            symbols,
            frequencies,
            depths: vec![0; 2 * symbols],
            parents: vec![0; 2 * symbols],
            heap,
            order: Vec::with_capacity(2 * symbols),
            last: last.unwrap_or(0),
        }
    }

    fn is_before(&self, a: usize, b: usize) -> bool {
        (self.frequencies[a], self.depths[a]) <= (self.frequencies[b], self.depths[b])
    }

    /// Lets the node at a place of the heap sink to where it belongs.
    fn sink(&mut self, mut place: usize) {
        let node = self.heap[place];
        let mut child = 2 * place;
        while child < self.heap.len() {
            if child + 1 < self.heap.len() && self.is_before(self.heap[child + 1], self.heap[child]) {
                child += 1;
            }
            if self.is_before(node, self.heap[child]) {
                break;
            }
            self.heap[place] = self.heap[child];
            place = child;
            child *= 2;
        }
        self.heap[place] = node;
    }

    /// Joins the two least frequent nodes until one is left.
    fn join(&mut self) {
        for place in (1..=(self.heap.len() - 1) / 2).rev() {
            self.sink(place);
        }
        let mut node = self.symbols;
        while self.heap.len() > 2 {
            let first = self.heap.swap_remove(1);
            self.sink(1);
            let second = self.heap[1];
            self.order.extend([first, second]);
            self.frequencies[node] = self.frequencies[first] + self.frequencies[second];
            self.depths[node] = self.depths[first].max(self.depths[second]) + 1;
            self.parents[first] = node;
            self.parents[second] = node;
            self.heap[1] = node;
            self.sink(1);
            node += 1;
        }
        self.order.push(self.heap[1]);
    }

    /// The length of each symbol's code, none above `most_bits`.
    fn lengths(&self, most_bits: usize) -> Vec<u8> {
        let mut lengths = vec![0_usize; 2 * self.symbols];
        let mut counts = [0_usize; MOST_BITS + 1];
        let mut beyond = 0_i32;
        for &node in self.order.iter().rev().skip(1) {
            let mut bits = lengths[self.parents[node]] + 1;
            if bits > most_bits {
                bits = most_bits;
                beyond += 1;
            }
            lengths[node] = bits;
            if node < self.symbols {
                counts[bits] += 1;
            }
        }
        if beyond > 0 {
            self.shorten(&mut lengths, counts, most_bits, beyond);
        }
        lengths[..self.symbols].iter().map(|l| u8::try_from(*l).unwrap_or(u8::MAX)).collect()
    }

    /// Makes room for the leaves that were cut short: each pair of them goes below a leaf that was higher. Then the
    /// least frequent leaves get the longest codes.
    fn shorten(
        &self,
        lengths: &mut [usize],
        mut counts: [usize; MOST_BITS + 1],
        most_bits: usize,
        beyond: i32,
    ) {
        let mut beyond = beyond;
        while beyond > 0 {
            let mut bits = most_bits - 1;
            while bits > 0 && counts[bits] == 0 {
                bits -= 1;
            }
            counts[bits] = counts[bits].saturating_sub(1);
            counts[bits + 1] += 2;
            counts[most_bits] = counts[most_bits].saturating_sub(1);
            beyond -= 2;
        }
        let mut leaves = self.order.iter().filter(|node| **node < self.symbols);
        for bits in (1..=most_bits).rev() {
            for leaf in leaves.by_ref().take(counts[bits]) {
                lengths[*leaf] = bits;
            }
        }
    }
}
