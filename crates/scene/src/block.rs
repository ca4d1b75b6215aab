//! How the lines of a text stand about the point that it is written at.

use crate::font;

/// The height of a capital, over the size of the type.
const CAPITAL: f64 = 0.75;
/// How far lines stand apart.
const LINE: f64 = 1.2;
/// How far letters reach below their line.
const BELOW: f64 = 0.25;

/// A text of some lines, in units of the type's size: x to the right and y up from the point.
pub struct Block<'a> {
    lines: Vec<&'a str>,
    /// 0 for the left, 1 for the middle, 2 for the right at the point.
    across: f64,
    /// How far below the point the first line stands.
    first: f64,
}

impl<'a> Block<'a> {
    /// `justification` is 1 to 9 as on a telephone: 1 top left, 5 in the middle, 9 bottom right.
    pub fn new(text: &'a str, justification: i32) -> Self {
        let lines: Vec<&str> = text.lines().collect();
        let count = lines.len().max(1) as f64;
        let place = justification.clamp(1, 9) - 1;
        let first = match place / 3 {
            0 => CAPITAL,
            1 => 0.5 * CAPITAL - 0.5 * LINE * (count - 1.0),
            _ => -LINE * (count - 1.0),
        };
        Self { lines, across: f64::from(place % 3), first }
    }

    /// The lines with where each starts, on its base line.
    pub fn lines(&self) -> impl Iterator<Item = ([f64; 2], &'a str)> {
        self.lines.iter().enumerate().map(|(k, line)| {
            let left = -0.5 * self.across * font::width(line, 1.0);
            ([left, -(self.first + LINE * k as f64)], *line)
        })
    }

    /// The rectangle around it: the least and the greatest x and y.
    pub fn extent(&self) -> [f64; 4] {
        let wide = self.lines.iter().map(|line| font::width(line, 1.0)).fold(0.0, f64::max);
        let left = -0.5 * self.across * wide;
        let last = self.lines.len().saturating_sub(1) as f64;
        [left, -(self.first + LINE * last + BELOW), left + wide, CAPITAL - self.first]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_stands_about_its_point() {
        let [left, low, right, high] = Block::new("word", 5).extent();
        assert!((left + right).abs() < 1e-12 && low < -0.3 && high > 0.3, "{low} {high}");
        let [left, low, right, high] = Block::new("two\nlines", 7).extent();
        assert!(left == 0.0 && right > 1.0 && (-0.3..0.0).contains(&low) && high > 1.5, "{low} {high}");
        let [_, low, right, high] = Block::new("word", 3).extent();
        assert!(right == 0.0 && high == 0.0 && low < -0.7);
        let starts: Vec<[f64; 2]> = Block::new("a\nb", 7).lines().map(|(at, _)| at).collect();
        assert_eq!(starts, [[0.0, 1.2], [0.0, 0.0]]);
    }
}
