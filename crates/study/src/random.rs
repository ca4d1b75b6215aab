//! Random numbers that are the same on every machine and for any order of asking.

/// The odd constant of Weyl's sequence in SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators").
const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// Mixes the bits of a number: the finaliser of SplitMix64.
pub(crate) fn mixed(x: u64) -> u64 {
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// A number for three: as if drawn at random, and always the same.
pub(crate) fn hashed(seed: u64, a: u64, b: u64) -> u64 {
    let first = mixed(seed.wrapping_add(GAMMA)).wrapping_add(a);
    mixed(mixed(first.wrapping_add(GAMMA)).wrapping_add(b).wrapping_add(GAMMA))
}

/// Bits as a number from 0 to 1, without 1: the upper 53 of them.
#[allow(clippy::cast_precision_loss, reason = "53 bits fit")]
pub(crate) fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_mixed_as_in_splitmix64() {
        // The first numbers for the seed 1234567, as the algorithm's published test vectors have them.
        let expected = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!(
            [1, 2, 3].map(|k: u64| mixed(1_234_567_u64.wrapping_add(k.wrapping_mul(GAMMA)))),
            expected
        );
    }

    #[test]
    fn numbers_are_spread_evenly() {
        let mut counts = [0; 10];
        for k in 0..100_000 {
            counts[(10.0 * unit(hashed(5, 2, k))) as usize] += 1;
        }
        // Four standard deviations of a binomial count: 4*sqrt(100000*0.1*0.9).
        assert!(counts.iter().all(|n: &i32| (n - 10_000).abs() < 380), "{counts:?}");
    }
}
