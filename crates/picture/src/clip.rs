//! Cutting away what lies on the wrong side: lines and outlines against a plane given by a signed distance.

use katydid_geometry::Point3;

/// The parts of a line through points where `distance` is 0 or more. `distance` is linear in space.
pub(crate) fn polyline(points: &[Point3], distance: impl Fn(Point3) -> f64) -> Vec<Vec<Point3>> {
    let mut parts: Vec<Vec<Point3>> = Vec::new();
    let mut inside = false;
    for (k, &p) in points.iter().enumerate() {
        let d = distance(p);
        let before = k.checked_sub(1).and_then(|k| points.get(k)).map(|&q| (q, distance(q)));
        if let Some((q, e)) = before
            && (d < 0.0) != (e < 0.0)
        {
            let cut = q.lerp(p, e / (e - d));
            if inside {
                parts.last_mut().into_iter().for_each(|part| part.push(cut));
            } else {
                parts.push(vec![cut]);
            }
        } else if d >= 0.0 && !inside {
            parts.push(Vec::new());
        }
        inside = d >= 0.0;
        if inside {
            parts.last_mut().into_iter().for_each(|part| part.push(p));
        }
    }
    parts
}

/// The part of a convex outline where `distance` is 0 or more (Sutherland and Hodgman); the payload of corners is
/// blended along cut sides.
pub(crate) fn polygon<T: Copy>(
    corners: &[(Point3, T)],
    distance: impl Fn(Point3) -> f64,
    blend: impl Fn(T, T, f64) -> T,
) -> Vec<(Point3, T)> {
    let mut out = Vec::with_capacity(corners.len() + 1);
    for (k, &(p, a)) in corners.iter().enumerate() {
        let Some(&(q, b)) = corners.get((k + 1) % corners.len()) else { continue };
        let (d, e) = (distance(p), distance(q));
        if d >= 0.0 {
            out.push((p, a));
        }
        if (d < 0.0) != (e < 0.0) {
            let t = d / (d - e);
            out.push((p.lerp(q, t), blend(a, b, t)));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point3 {
        Point3::new(x, y, 0.0)
    }

    #[test]
    fn lines_are_cut_where_they_cross() {
        let zigzag = [p(0.0, -1.0), p(1.0, 1.0), p(2.0, -1.0), p(3.0, 1.0)];
        let parts = polyline(&zigzag, |p| p.y);
        assert_eq!(parts, [vec![p(0.5, 0.0), p(1.0, 1.0), p(1.5, 0.0)], vec![p(2.5, 0.0), p(3.0, 1.0)]]);
        assert_eq!(polyline(&zigzag, |_| 1.0), [zigzag.to_vec()]);
        assert!(polyline(&zigzag, |_| -1.0).is_empty() && polyline(&[], |_| 1.0).is_empty());
    }

    #[test]
    fn outlines_are_cut_with_what_they_carry() {
        let square = [(p(0.0, -1.0), 0.0), (p(2.0, -1.0), 2.0), (p(2.0, 1.0), 2.0), (p(0.0, 1.0), 0.0)];
        let cut = polygon(&square, |p| p.y, |a, b, t| a + (b - a) * t);
        let corners = [(p(2.0, 0.0), 2.0), (p(2.0, 1.0), 2.0), (p(0.0, 1.0), 0.0), (p(0.0, 0.0), 0.0)];
        assert_eq!(cut, corners);
        assert!(polygon(&square, |_| -1.0, |a, _, _| a).is_empty());
    }
}
