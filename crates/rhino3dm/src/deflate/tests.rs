use std::io::Read;

use super::zlib;

fn inflated(stream: &[u8]) -> Vec<u8> {
    let mut plain = Vec::new();
    flate2::read::ZlibDecoder::new(stream).read_to_end(&mut plain).unwrap();
    plain
}

/// A generator of numbers that are the same everywhere.
fn numbers(seed: u64) -> impl Iterator<Item = u64> {
    let mut state = seed;
    std::iter::repeat_with(move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 33
    })
}

#[test]
fn what_is_deflated_is_inflated() {
    for size in [0, 1, 2, 3, 4, 10, 257, 258, 259, 1000, 32_768, 40_000, 100_000, 300_000] {
        let noise: Vec<u8> = numbers(1).map(|n| n as u8).take(size).collect();
        let few: Vec<u8> = numbers(2).map(|n| (n % 3) as u8).take(size).collect();
        let words: Vec<u8> = numbers(3).flat_map(|n| [(n % 19) as u8; 7]).take(size).collect();
        let steps: Vec<u8> =
            (0..size as u32).flat_map(|i| (i as f32 * 0.25).to_le_bytes()).take(size).collect();
        let skewed: Vec<u8> = numbers(4).map(|n| (n | 1 << 20).trailing_zeros() as u8).take(size).collect();
        let rare: Vec<u8> =
            (0..size).map(|i| (0..30).find(|k| i % (1 << k) != 0).unwrap_or(31) as u8).collect();
        for plain in [vec![7; size], noise, few, words, steps, skewed, rare] {
            assert_eq!(inflated(&zlib(&plain)), plain, "{size} bytes");
        }
    }
}

/// Checksums of streams that zlib 1.2.13 gives at level 9 for the bytes made here.
#[test]
fn streams_are_those_of_zlib() {
    let steps: Vec<u8> = (0..20_000_u32).flat_map(|i| (i as f32 * 0.37).to_le_bytes()).collect();
    let text: Vec<u8> = numbers(5).flat_map(|n| format!("{} ", n % 977).into_bytes()).take(200_000).collect();
    let noise: Vec<u8> = numbers(6).map(|n| n as u8).take(50_000).collect();
    let short = b"a few words, a few words more".to_vec();
    let expected = [(54999, 0x62978E37), (83997, 0xD931D9D9), (50026, 0xB1C9A2BE), (28, 0xAC476CD2)];
    for (plain, (length, crc)) in [steps, text, noise, short].iter().zip(expected) {
        let stream = zlib(plain);
        assert_eq!((stream.len(), crc32fast::hash(&stream)), (length, crc));
    }
}
