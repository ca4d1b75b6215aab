//! The random numbers of .NET's seeded `System.Random`, which definitions rely on for their looks.

/// One more than the largest number the generator draws.
const SPAN: i32 = i32::MAX;
/// What Knuth starts the table from.
const START: i32 = 161_803_398;

/// Knuth's subtractive generator as .NET has it (The Art of Computer Programming 2, section 3.2.2): for one
/// seed it gives the numbers that `new Random(seed)` gives in every version of .NET.
#[derive(Debug, Clone)]
pub(crate) struct DotNetRandom {
    /// The last 55 numbers, in a ring; place 0 stays empty.
    ring: [i32; 56],
    at: usize,
    behind: usize,
}

impl DotNetRandom {
    /// A generator for a seed. A seed and its negative give the same numbers.
    pub(crate) fn new(seed: i32) -> Self {
        let mut ring = [0_i32; 56];
        let mut last = START.wrapping_sub(seed.checked_abs().unwrap_or(i32::MAX));
        let mut next = 1_i32;
        ring[55] = last;
        for i in 1..55 {
            let place = 21 * i % 55;
            ring[place] = next;
            next = positive(last.wrapping_sub(next));
            last = ring[place];
        }
        for _ in 0..4 {
            for i in 1..56 {
                ring[i] = positive(ring[i].wrapping_sub(ring[1 + (i + 30) % 55]));
            }
        }
        Self { ring, at: 0, behind: 21 }
    }

    /// A whole number from 0 to below `i32::MAX`.
    fn sample(&mut self) -> i32 {
        let step = |place: usize| if place >= 55 { 1 } else { place + 1 };
        self.at = step(self.at);
        self.behind = step(self.behind);
        let mut drawn = self.ring[self.at].wrapping_sub(self.ring[self.behind]);
        if drawn == SPAN {
            drawn -= 1;
        }
        let drawn = positive(drawn);
        self.ring[self.at] = drawn;
        drawn
    }

    /// A number from 0 to below 1.
    pub(crate) fn next_double(&mut self) -> f64 {
        f64::from(self.sample()) * (1.0 / f64::from(SPAN))
    }

    /// A whole number from 0 to below `max`; 0 when there is none.
    pub(crate) fn next_below(&mut self, max: usize) -> usize {
        let max = i32::try_from(max).unwrap_or(i32::MAX);
        (self.next_double() * f64::from(max)) as usize
    }

    /// A whole number from `low` to `high`, both included; the ends may stand in any order.
    pub(crate) fn next_between(&mut self, low: i32, high: i32) -> i32 {
        let (low, high) = (i64::from(low.min(high)), i64::from(low.max(high)));
        let range = high - low + 1;
        let part = if range <= i64::from(i32::MAX) { self.next_double() } else { self.large_sample() };
        let drawn = low + (part * range as f64) as i64;
        i32::try_from(drawn.min(high)).unwrap_or(i32::MAX)
    }

    /// A number from 0 to below 1 in finer steps, from two draws, for ranges beyond 31 bits.
    fn large_sample(&mut self) -> f64 {
        let size = self.sample();
        let drawn = if self.sample() % 2 == 0 { -f64::from(size) } else { f64::from(size) };
        (drawn + f64::from(SPAN - 1)) / (2.0 * f64::from(SPAN) - 1.0)
    }
}

fn positive(x: i32) -> i32 {
    if x < 0 { x.wrapping_add(SPAN) } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_of_two_seeds() {
        for (seed, expected) in [
            (0, [1_559_595_546, 1_755_192_844, 1_649_316_166]),
            (1, [534_011_718, 237_820_880, 1_002_897_798]),
            (-1, [534_011_718, 237_820_880, 1_002_897_798]),
        ] {
            let mut random = DotNetRandom::new(seed);
            assert_eq!(expected.map(|_| random.sample()), expected, "seed {seed}");
        }
    }

    #[test]
    fn broken_numbers_of_four_seeds() {
        let check = |seed: i32, expected: &[f64]| {
            let mut random = DotNetRandom::new(seed);
            for &x in expected {
                assert_eq!(random.next_double(), x, "seed {seed}");
            }
        };
        check(0, &[0.726_243_269_967_959_8, 0.817_325_359_590_968_7, 0.768_022_689_394_663_4]);
        check(1, &[0.248_668_584_157_092_78, 0.110_743_977_181_028_56, 0.467_010_679_872_245_87]);
        check(2, &[0.771_093_898_346_225_7, 0.404_162_594_771_088_4]);
        check(3, &[0.293_519_212_535_358_6, 0.697_581_212_361_148_2]);
    }

    #[test]
    fn whole_numbers_below_ten() {
        for (seed, expected) in [(1, [2, 1, 4, 7, 6, 4, 3, 9, 1, 6]), (2, [7, 4, 1, 9, 1, 3, 8, 4, 2, 0])] {
            let mut random = DotNetRandom::new(seed);
            assert_eq!(expected.map(|_| random.next_below(10)), expected, "seed {seed}");
            let mut random = DotNetRandom::new(seed);
            assert_eq!(expected.map(|_| random.next_between(9, 0) as usize), expected, "seed {seed}");
        }
    }

    #[test]
    fn every_seed_and_range_stays_inside() {
        for seed in [i32::MIN, i32::MAX, -7, 161_803_398] {
            let mut random = DotNetRandom::new(seed);
            for _ in 0..200 {
                assert!((0.0..1.0).contains(&random.next_double()));
                assert_eq!(random.next_between(5, 5), 5);
                assert!((-3..=-1).contains(&random.next_between(-1, -3)));
                random.next_between(i32::MIN, i32::MAX);
                assert_eq!(random.next_below(0), 0);
            }
        }
    }
}
