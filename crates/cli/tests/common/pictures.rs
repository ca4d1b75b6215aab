//! Pictures beside pictures that somebody has looked at.

use std::fs;
use std::path::Path;

/// The red, green and blue of all pixels, and the width.
fn pixels(path: &Path) -> (Vec<u8>, u32) {
    let decoder = png::Decoder::new(std::io::BufReader::new(fs::File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb, "{}", path.display());
    (bytes, info.width)
}

/// How much two pictures differ: the mean difference of a channel, and the part of channels that are clearly another.
fn difference(a: &[u8], b: &[u8]) -> (f64, f64) {
    let differences = a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b)));
    let (sum, far) = differences.fold((0.0, 0.0), |(sum, far), d| (sum + d, far + f64::from(d > 48.0)));
    (sum / a.len() as f64, far / a.len() as f64)
}

/// Whether there is something on a picture, and it is the one that was looked at, but for rounding.
pub(crate) fn assert_alike(name: &str, drawn: &Path, kept: &Path) {
    let (found, width) = pixels(drawn);
    assert!(found.iter().filter(|x| **x < 200).count() > 100, "{name}: there is nothing on the picture");
    let (expected, expected_width) = pixels(kept);
    assert_eq!((found.len(), width), (expected.len(), expected_width), "{name}: another size");
    let (mean, far) = difference(&found, &expected);
    assert!(
        mean < 0.4 && far < 0.004,
        "{name}: the picture is not the one that was looked at: {mean:.3} of 255 on average, {:.2} % clearly another. \
         If that is right, draw it anew (CONTRIBUTING.md says how), look, and keep it.",
        100.0 * far
    );
}
