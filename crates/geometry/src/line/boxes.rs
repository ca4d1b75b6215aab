//! Boxes and segments.

use crate::{BoundingBox, Line};

impl BoundingBox {
    /// The twelve edges: four around the bottom, four around the top, then the four upright ones.
    pub fn edges(&self) -> [Line; 12] {
        let c = self.corners();
        let pairs =
            [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)];
        pairs.map(|(i, j): (usize, usize)| Line::new(c[i], c[j]))
    }

    /// The least distance from the solid box to a segment, 0 when they meet.
    ///
    /// Exact: between the parameters where the segment crosses the box's six planes the square of the distance is one
    /// quadratic, and the whole is convex.
    pub fn distance_to_segment(&self, line: &Line) -> f64 {
        let d = line.direction();
        let mut cuts = vec![0.0, 1.0];
        for (from, d, low, high) in [
            (line.from.x, d.x, self.min.x, self.max.x),
            (line.from.y, d.y, self.min.y, self.max.y),
            (line.from.z, d.z, self.min.z, self.max.z),
        ] {
            cuts.extend([(low - from) / d, (high - from) / d].into_iter().filter(|t| 0.0 < *t && *t < 1.0));
        }
        cuts.sort_by(f64::total_cmp);
        let mut best = f64::INFINITY;
        for w in cuts.windows(2) {
            let [start, end] = [w[0], w[1]];
            // In between each coordinate is below, inside or above throughout: the outside ones count.
            let p = line.at(0.5 * (start + end));
            let out = p - self.closest_point(p);
            let kept = |o: f64, d: f64| if o == 0.0 { 0.0 } else { d };
            let slope = crate::Vector3::new(kept(out.x, d.x), kept(out.y, d.y), kept(out.z, d.z));
            let squared = slope.length_squared();
            let shift = if squared > 0.0 { -out.dot(slope) / squared } else { 0.0 };
            let t = (0.5 * (start + end) + shift).clamp(start, end);
            for t in [start, t, end] {
                best = best.min(self.distance_to(line.at(t)));
            }
        }
        best
    }

    /// The greatest distance from points of the box to points of a segment.
    pub fn max_distance_to_segment(&self, line: &Line) -> f64 {
        self.max_distance_to(line.from).max(self.max_distance_to(line.to))
    }
}
