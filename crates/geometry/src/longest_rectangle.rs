//! The longest board that lies flat in a room.

use katydid_elementary::Elementary;

use crate::thresholds;
use crate::{Curve, Error, Interval, Plane, Point2, PolylineLimits, Rectangle, Result};

/// The outline is not followed more exactly than this, in model units.
const LEAST_TOLERANCE: f64 = 1e-9;
/// The search for the best turn ends when its step is no more radians.
const TURN_DONE: f64 = 1e-10;

/// The most directions that are tried.
const MOST: usize = 1000;
/// The most heights of corners that are looked at in one direction.
const MOST_HEIGHTS: usize = 128;

/// The longest rectangle of a given width inside a closed flat curve, lying in any direction: its x along the length.
///
/// So many directions between 0 and 180° are tried as `samples`, and those of the longer straight sides; the best
/// three are then turned until no small turn makes them longer. In each direction the free length is a concave function
/// between the heights of corners, whose top is found by ternary search in the three best of such ranges (of rooms
/// with many corners not all heights are looked at). Curved sides are polylines within `tolerance`. So it is the longest
/// of those near the directions tried, not proven to be the longest of all.
///
/// # Errors
/// A curve that is open or not flat, a width that is not above 0 or for which nothing fits, or a number of samples
/// outside 1…1000.
pub fn longest_rectangle(room: &Curve, width: f64, samples: usize, tolerance: f64) -> Result<Rectangle> {
    if !(width > 0.0 && width.is_finite()) {
        return Err(Error::OutOfRange { what: "width", value: width, must: "finite and greater than 0" });
    }
    if !(1..=MOST).contains(&samples) {
        return Err(Error::OutOfRange { what: "samples", value: samples as f64, must: "from 1 to 1000" });
    }
    if !room.is_closed() {
        return Err(Error::degenerate("room", "its outline is open"));
    }
    let plane = room.plane(tolerance).ok_or(Error::degenerate("room", "its outline is not flat"))?;
    let outline = room.to_polyline(&PolylineLimits::within(tolerance.max(LEAST_TOLERANCE)))?;
    let mut corners: Vec<Point2> = outline
        .points()
        .iter()
        .map(|p| {
            let [x, y, _] = plane.coordinates(*p);
            Point2 { x, y }
        })
        .collect();
    corners.pop();
    let room = Room { corners, width };
    let half_turn = std::f64::consts::PI;
    let mut angles: Vec<f64> = (0..samples).map(|i| half_turn * i as f64 / samples as f64).collect();
    let mut sides: Vec<(f64, f64)> = room
        .sides()
        .map(|(a, b)| {
            ((b.x - a.x).hypotenuse(b.y - a.y), (b.y - a.y).arctangent_of(b.x - a.x).rem_euclid(half_turn))
        })
        .collect();
    sides.sort_by(|a, b| b.0.total_cmp(&a.0));
    angles.extend(sides.iter().take(24).map(|s| s.1));
    let mut found: Vec<(f64, [f64; 3])> = angles
        .into_iter()
        .filter_map(|angle| room.longest_along(angle).map(|place| (angle, place)))
        .collect();
    let length = |f: &(f64, [f64; 3])| f.1[1] - f.1[0];
    found.sort_by(|a, b| length(b).total_cmp(&length(a)));
    found.truncate(3);
    let mut best: Option<(f64, [f64; 3])> = None;
    for start in found {
        let mut here = start;
        let mut turn = half_turn / samples.max(8) as f64;
        while turn > TURN_DONE {
            let next = [-turn, turn]
                .into_iter()
                .filter_map(|t| room.longest_along(here.0 + t).map(|place| (here.0 + t, place)))
                .max_by(|a, b| length(a).total_cmp(&length(b)));
            match next {
                Some(next) if length(&next) > length(&here) => here = next,
                _ => turn *= 0.5,
            }
        }
        if best.as_ref().is_none_or(|b| length(&here) > length(b)) {
            best = Some(here);
        }
    }
    let (angle, [from, to, low]) =
        best.ok_or(Error::degenerate("rectangle", "none of this width fits into the room"))?;
    let (sin, cos) = angle.sine_cosine();
    let x_axis = plane.x_axis * cos + plane.y_axis * sin;
    let own = Plane::from_axes(plane.origin, x_axis, plane.z_axis.cross(x_axis))?;
    Ok(Rectangle { plane: own, x: Interval::new(from, to), y: Interval::new(low, low + width) })
}

struct Room {
    corners: Vec<Point2>,
    width: f64,
}

impl Room {
    fn sides(&self) -> impl Iterator<Item = (Point2, Point2)> + '_ {
        let n = self.corners.len();
        (0..n).map(move |i| (self.corners[i], self.corners[(i + 1) % n]))
    }

    /// The longest place in one direction, in turned coordinates: from x, to x, from y.
    fn longest_along(&self, angle: f64) -> Option<[f64; 3]> {
        let (sin, cos) = angle.sine_cosine();
        let turned: Vec<[f64; 2]> =
            self.corners.iter().map(|p| [p.x * cos + p.y * sin, p.y * cos - p.x * sin]).collect();
        let strip = Strip { corners: &turned, width: self.width };
        let mut heights: Vec<f64> = turned.iter().flat_map(|p| [p[1], p[1] - self.width]).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|a, b| (*a - *b).abs() <= thresholds::ROUNDING * self.width);
        let mut best: Option<[f64; 3]> = None;
        let mut offer = |y: f64| -> f64 {
            let Some([a, b]) = strip.longest_gap(y) else { return 0.0 };
            if best.is_none_or(|c| b - a > c[1] - c[0]) {
                best = Some([a, b, y]);
            }
            b - a
        };
        let thin = heights.len().div_ceil(MOST_HEIGHTS).max(1);
        let heights: Vec<f64> = heights.into_iter().step_by(thin).collect();
        for &y in &heights {
            offer(y);
        }
        let mut between: Vec<(f64, f64, f64)> =
            heights.windows(2).map(|w| (offer(0.5 * (w[0] + w[1])), w[0], w[1])).collect();
        between.sort_by(|a, b| b.0.total_cmp(&a.0));
        for &(length, mut a, mut b) in between.iter().take(3) {
            if length == 0.0 {
                break;
            }
            for _ in 0..60 {
                let (c, d) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
                if offer(c) < offer(d) {
                    a = c;
                } else {
                    b = d;
                }
            }
        }
        best
    }
}

/// A level strip of the room.
struct Strip<'a> {
    corners: &'a [[f64; 2]],
    width: f64,
}

impl Strip<'_> {
    /// The longest stretch of the strip over `y` that no side of the room enters and that lies inside.
    fn longest_gap(&self, y: f64) -> Option<[f64; 2]> {
        // A side that only touches the strip does not enter it.
        let slack = thresholds::SAME_POINT * self.width;
        let (low, high) = (y + slack, y + self.width - slack);
        let middle = 0.5 * (low + high);
        let n = self.corners.len();
        let mut blocked: Vec<[f64; 2]> = Vec::new();
        let mut crossings: Vec<f64> = Vec::new();
        for i in 0..n {
            let (a, b) = (self.corners[i], self.corners[(i + 1) % n]);
            let at = |y: f64| a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1]));
            if (a[1] <= middle) != (b[1] <= middle) {
                crossings.push(at(middle));
            }
            if a[1].max(b[1]) <= low || a[1].min(b[1]) >= high {
                continue;
            }
            let ends = if a[1] == b[1] {
                [a[0], b[0]]
            } else {
                let inside = |p: [f64; 2]| {
                    if p[1] < low {
                        at(low)
                    } else if p[1] > high {
                        at(high)
                    } else {
                        p[0]
                    }
                };
                [inside(a), inside(b)]
            };
            blocked.push([ends[0].min(ends[1]), ends[0].max(ends[1])]);
        }
        blocked.sort_by(|a, b| a[0].total_cmp(&b[0]));
        crossings.sort_by(f64::total_cmp);
        let mut best: Option<[f64; 2]> = None;
        let mut reached = blocked.first()?[0];
        for [from, to] in blocked {
            if from > reached && best.is_none_or(|b| from - reached > b[1] - b[0]) {
                let x = 0.5 * (reached + from);
                if crossings.partition_point(|&c| c < x) % 2 == 1 {
                    best = Some([reached, from]);
                }
            }
            reached = reached.max(to);
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::longest_rectangle;
    use crate::{Circle, Curve, Plane, Point3, PolylineCurve};

    fn room(corners: &[[f64; 2]]) -> Curve {
        let mut points: Vec<Point3> = corners.iter().map(|&[x, y]| Point3::new(x, y, 0.0)).collect();
        points.push(points[0]);
        PolylineCurve::new(points).unwrap().into()
    }

    #[test]
    fn boards_in_rooms() {
        // Along the long side of the L.
        let l = room(&[[0.0, 0.0], [10.0, 0.0], [10.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]]);
        let board = longest_rectangle(&l, 2.0, 18, 1e-6).unwrap();
        assert!((board.x.length() - 10.0).abs() < 1e-6, "{board:?}");
        assert!((board.y.length() - 2.0).abs() < 1e-12);
        // A narrow board in a square lies along its diagonal: √2·s − w.
        let square = room(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let board = longest_rectangle(&square, 0.5, 30, 1e-6).unwrap();
        assert!((board.x.length() - (32f64.sqrt() - 0.5)).abs() < 1e-6, "{board:?}");
        let circle: Curve = Circle::new(Plane::XY, 5.0).unwrap().into();
        let board = longest_rectangle(&circle, 6.0, 8, 1e-6).unwrap();
        assert!((board.x.length() - 8.0).abs() < 1e-3, "{board:?}");
    }

    #[test]
    fn what_cannot_be() {
        let square = room(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        assert!(longest_rectangle(&square, 6.0, 30, 1e-6).is_err());
        assert!(longest_rectangle(&square, 0.0, 30, 1e-6).is_err());
        assert!(longest_rectangle(&square, 1.0, 0, 1e-6).is_err());
        let line: Curve = crate::Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).into();
        assert!(longest_rectangle(&line, 1.0, 9, 1e-6).is_err());
    }
}
