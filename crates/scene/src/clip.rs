//! Lines cut by outlines.

/// The stretches of a line in a plane that are inside outlines, by the even-odd rule: the points where it goes in and
/// out in turn, as places along the line from `from` in direction `along`.
pub(crate) fn inside(outlines: &[Vec<[f64; 2]>], from: [f64; 2], along: [f64; 2]) -> Vec<[f64; 2]> {
    let mut cuts = Vec::new();
    let across = |p: [f64; 2]| along[0] * (p[1] - from[1]) - along[1] * (p[0] - from[0]);
    let place = |p: [f64; 2]| along[0] * (p[0] - from[0]) + along[1] * (p[1] - from[1]);
    for outline in outlines {
        for (k, &p) in outline.iter().enumerate() {
            let Some(&q) = outline.get((k + 1) % outline.len()) else { continue };
            let (d, e) = (across(p), across(q));
            if (d < 0.0) != (e < 0.0) {
                let t = d / (d - e);
                cuts.push(place([p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t]));
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    cuts.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hole_interrupts_the_inside() {
        let square = |r: f64| vec![[-r, -r], [r, -r], [r, r], [-r, r]];
        let stretches = inside(&[square(2.0), square(1.0)], [0.0, 0.5], [1.0, 0.0]);
        assert_eq!(stretches, [[-2.0, -1.0], [1.0, 2.0]]);
    }
}
