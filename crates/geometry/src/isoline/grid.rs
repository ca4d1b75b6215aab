use super::Isoline;
use super::cell::{is_way, ways};
use super::join::Links;
use crate::{Error, Point2, Result};

/// No crossing.
const NONE: u32 = u32::MAX;

/// The lines of a given height over a grid of numbers, row by row with `columns` numbers a row, at unit distance:
/// number k stands at x = k mod columns, y = k div columns.
///
/// Marching squares: straight from side to side of every cell, at the places where the height is reached by linear
/// interpolation. Lines end only at the grid's border. A line that shrinks to a point is left out.
///
/// # Errors
/// A number is not finite, the numbers do not fill the rows, or there are 2³⁰ of them or more.
pub fn isolines(values: &[f64], columns: usize, level: f64) -> Result<Vec<Isoline>> {
    if !level.is_finite() || !values.iter().all(|v| v.is_finite()) {
        return Err(Error::NotFinite("height of a grid"));
    }
    if columns == 0 || !values.len().is_multiple_of(columns) || values.len() >= 1 << 30 {
        let why = format!("{} numbers in rows of {columns}", values.len());
        return Err(Error::Invalid { what: "grid of heights", why });
    }
    // Side 2k goes from number k to the right, side 2k + 1 up.
    let mut links = Links {
        next: vec![NONE; 2 * values.len()],
        starts: Vec::new(),
        entered: vec![false; 2 * values.len()],
    };
    for (j, rows) in values.windows(2 * columns).step_by(columns).enumerate() {
        let (low, high) = rows.split_at(columns);
        let mut left =
            (low.first().copied().unwrap_or(0.0) - level, high.first().copied().unwrap_or(0.0) - level);
        for (i, (&b, &c)) in low.iter().zip(high).enumerate().skip(1) {
            let (b, c) = (b - level, c - level);
            let (a, d) = left;
            left = (b, c);
            let highs = [a, b, c, d].map(|h| h >= 0.0);
            if highs == [true; 4] || highs == [false; 4] {
                continue;
            }
            let k = j * columns + i - 1;
            let sides = [2 * k, 2 * k + 3, 2 * (k + columns), 2 * k + 1];
            let (first, second) = ways([a, b, c, d]);
            for way in [Some(first), second].into_iter().flatten().filter(|w| is_way(*w)) {
                links.add(sides[usize::from(way[0])] as u32, sides[usize::from(way[1])] as u32);
            }
        }
    }
    let place = |side: u32| {
        let (k, upward) = (side as usize / 2, side % 2 == 1);
        let other = if upward { k + columns } else { k + 1 };
        let height = |k: usize| values.get(k).copied().unwrap_or(level) - level;
        let (from, to) = (height(k), height(other));
        let t = from / (from - to);
        let (x, y) = ((k % columns) as f64, (k / columns) as f64);
        if upward { Point2::new(x, y + t) } else { Point2::new(x + t, y) }
    };
    Ok(links.lines(place))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_on_a_grid() {
        let n = 64;
        let values: Vec<f64> = (0..n * n)
            .map(|k| {
                let (x, y) = ((k % n) as f64 - 31.3, (k / n) as f64 - 31.7);
                -x.hypot(y)
            })
            .collect();
        let lines = isolines(&values, n, -20.0).unwrap();
        assert_eq!(lines.len(), 1);
        assert!(lines[0].closed);
        let off = lines[0].points.iter().map(|p| (p.x - 31.3).hypot(p.y - 31.7) - 20.0).map(f64::abs);
        assert!(off.fold(0.0, f64::max) < 0.02);
        let area: f64 =
            lines[0].points.windows(2).map(|w| 0.5 * w[0].to_vector().cross(w[1].to_vector())).sum();
        assert!(area > 0.0, "what is high lies inside, to the left");
        // Four arcs where the circle is larger than the grid.
        let arcs = isolines(&values, n, -38.0).unwrap();
        assert_eq!(arcs.len(), 4);
        assert!(arcs.iter().all(|a| !a.closed));
    }

    #[test]
    fn odd_grids() {
        assert!(isolines(&[], 3, 0.0).unwrap().is_empty());
        assert!(isolines(&[1.0, 2.0, 3.0], 3, 2.0).unwrap().is_empty());
        assert!(isolines(&[1.0, -2.0, 3.0], 1, 0.0).unwrap().is_empty());
        assert!(isolines(&[1.0; 5], 3, 0.0).is_err());
        assert!(isolines(&[1.0; 5], 0, 0.0).is_err());
        assert!(isolines(&[f64::NAN; 4], 2, 0.0).is_err());
        // A peak that just reaches the height is a point, and no line.
        let mut peak = vec![0.0; 9];
        peak[4] = 1.0;
        assert!(isolines(&peak, 3, 1.0).unwrap().is_empty());
        assert_eq!(isolines(&peak, 3, 0.5).unwrap()[0].points.len(), 4);
    }
}
