//! From the model to the picture: named views, zoom to extents, projection.

use katydid_geometry::{Point3, Vector3};

/// A direction to look from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum View {
    /// From the front, right and above, with a lens of 50 mm.
    Perspective,
    /// From above: x to the right, y up.
    Top,
    /// From the front: x to the right, z up.
    Front,
    /// From the right: y to the right, z up.
    Right,
    /// From the front, right and above, along the diagonal of a cube; parallel.
    Isometric,
}

impl View {
    /// The word for it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Perspective => "perspective",
            Self::Top => "top",
            Self::Front => "front",
            Self::Right => "right",
            Self::Isometric => "isometric",
        }
    }

    /// The direction towards the viewer, and one that is up on the picture.
    fn directions(self) -> (Vector3, Vector3) {
        match self {
            Self::Perspective => (Vector3::new(0.44, -0.76, 0.48), Vector3::Z),
            Self::Isometric => (Vector3::new(1.0, -1.0, 1.0), Vector3::Z),
            Self::Top => (Vector3::Z, Vector3::Y),
            Self::Front => (-Vector3::Y, Vector3::Z),
            Self::Right => (Vector3::X, Vector3::Z),
        }
    }

    /// The axes of the world plane that the view's grid lies on: 0 for x, 1 for y, 2 for z.
    pub(crate) const fn grid_axes(self) -> [usize; 2] {
        match self {
            Self::Perspective | Self::Isometric | Self::Top => [0, 1],
            Self::Front => [0, 2],
            Self::Right => [1, 2],
        }
    }
}

/// Half the width of a picture over its distance, for a lens of 50 mm: 18 / 50.
const LENS: f64 = 0.36;

/// A camera that sees a model whole.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Camera {
    /// Coordinates are measured from here: near the model, so that no digits are lost far from the world's origin.
    origin: Point3,
    right: Vector3,
    up: Vector3,
    back: Vector3,
    /// Where x and y are 0 on the picture.
    centre: [f64; 2],
    projection: Projection,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Projection {
    Parallel {
        /// What the middle of the picture shows.
        at: [f64; 2],
        /// Pixels a unit.
        scale: f64,
    },
    Perspective {
        /// The camera's place; its third coordinate is the distance from the origin.
        eye: [f64; 3],
        /// The distance in pixels at which a unit is a pixel.
        focal: f64,
        /// The distance at which depth grows as fast as lengths.
        middle: f64,
    },
}

/// Nothing nearer than this share of the camera's distance is drawn.
const NEAR: f64 = 1e-3;

impl Camera {
    /// The camera that looks in a view's direction and sees all the points inside a picture's margins.
    pub(crate) fn fit(view: View, points: &[Point3], size: [f64; 2], margin: f64) -> Self {
        let (back, up) = view.directions();
        let back = back.unitized().unwrap_or(Vector3::Z);
        let right = up.cross(back).unitized().unwrap_or(Vector3::X);
        let up = back.cross(right);
        let bounds = katydid_geometry::BoundingBox::from_points(points.iter().copied());
        let origin = bounds.map_or(Point3::ORIGIN, |b| b.center());
        let mut camera = Self {
            origin,
            right,
            up,
            back,
            centre: size.map(|x| 0.5 * x),
            projection: Projection::Parallel { at: [0.0; 2], scale: 1.0 },
        };
        let room = size.map(|x| (x - 2.0 * margin).max(0.3 * x).max(1.0));
        let places: Vec<[f64; 3]> = points.iter().map(|p| camera.turned(*p)).collect();
        camera.projection = match view {
            View::Perspective => perspective(&places, room, size),
            _ => parallel(&places, room),
        };
        camera
    }

    /// Coordinates along the picture's right and up and towards the viewer.
    fn turned(&self, p: Point3) -> [f64; 3] {
        let v = p - self.origin;
        [self.right.dot(v), self.up.dot(v), self.back.dot(v)]
    }

    /// How far before the camera a place is, over the nearest distance that is drawn: 1 and more is seen.
    fn nearness(&self, p: Point3) -> f64 {
        match self.projection {
            Projection::Parallel { .. } => 1.0,
            Projection::Perspective { eye, middle, .. } => (eye[2] - self.turned(p)[2]) / (NEAR * middle),
        }
    }

    /// Where a point is on the picture: x, y in pixels and its depth, larger for nearer. `None` behind the camera.
    pub(crate) fn project(&self, p: Point3) -> Option<[f64; 3]> {
        let [x, y, z] = self.turned(p);
        let [cx, cy] = self.centre;
        let at = match self.projection {
            Projection::Parallel { at, scale } => {
                [cx + scale * (x - at[0]), cy - scale * (y - at[1]), scale * z]
            }
            Projection::Perspective { eye, focal, middle } => {
                let w = eye[2] - z;
                // What was cut at the nearest distance may lie a little before it.
                if !(w > 0.5 * NEAR * middle) {
                    return None;
                }
                // Depth goes with 1/w, so that planes stay planes.
                let k = focal / w;
                [cx + k * (x - eye[0]), cy - k * (y - eye[1]), k * middle]
            }
        };
        at.iter().all(|x| x.is_finite()).then_some(at)
    }

    /// A line through points as it is seen: several lines when parts of it are behind the camera.
    pub(crate) fn polyline(&self, points: &[Point3]) -> Vec<Vec<[f64; 3]>> {
        let parts = crate::clip::polyline(points, |p| self.nearness(p) - 1.0);
        let seen = |part: Vec<Point3>| part.into_iter().filter_map(|p| self.project(p)).collect();
        parts.into_iter().map(seen).collect()
    }

    /// Whether all of a face is before the camera.
    pub(crate) fn sees(&self, p: Point3) -> bool {
        self.nearness(p) >= 1.0
    }

    /// A signed distance that is above 0 for what is seen.
    pub(crate) fn before(&self, p: Point3) -> f64 {
        self.nearness(p) - 1.0
    }

    /// How many units of the model a pixel is at a point; never 0.
    pub(crate) fn unit(&self, p: Point3) -> f64 {
        match self.projection {
            Projection::Parallel { scale, .. } => 1.0 / scale,
            Projection::Perspective { eye, focal, middle } => {
                (eye[2] - self.turned(p)[2]).max(NEAR * middle) / focal
            }
        }
    }

    /// Points of the model that are seen `pixels` beside a point, to the right, left, above and below.
    pub(crate) fn around(&self, p: Point3, pixels: f64) -> [Point3; 4] {
        let r = pixels * self.unit(p);
        [self.right, -self.right, self.up, -self.up].map(|v| p + v * r)
    }

    /// Where a direction points on the picture, for a parallel look at the middle: right, down, towards the viewer.
    pub(crate) fn direction(&self, v: Vector3) -> [f64; 3] {
        [self.right.dot(v), -self.up.dot(v), self.back.dot(v)]
    }

    /// The direction towards the viewer from a point.
    pub(crate) fn towards_viewer(&self, p: Point3) -> Vector3 {
        match self.projection {
            Projection::Parallel { .. } => self.back,
            Projection::Perspective { eye, .. } => {
                let place = self.origin + self.right * eye[0] + self.up * eye[1] + self.back * eye[2];
                (place - p).unitized().unwrap_or(self.back)
            }
        }
    }

    /// The direction to the lamp, which the viewer carries on the forehead: from above and the left a little.
    pub(crate) fn towards_lamp(&self, p: Point3) -> Vector3 {
        let v = self.towards_viewer(p) + self.up * 0.35 - self.right * 0.25;
        v.unitized().unwrap_or(self.back)
    }
}

fn range(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values.fold(None, |r: Option<[f64; 2]>, x| Some(r.map_or([x, x], |[a, b]| [a.min(x), b.max(x)])))
}

fn parallel(places: &[[f64; 3]], room: [f64; 2]) -> Projection {
    let ranges = [0, 1, 2].map(|k| range(places.iter().map(|p| p[k])).unwrap_or([0.0; 2]));
    let [x, y, z] = ranges.map(|[a, b]| b - a);
    let largest = x.max(y).max(z);
    // What has no width seen from here, and a single point, still needs a scale.
    let least = if largest > 0.0 { 1e-3 * largest } else { 2.0 };
    let scale = (room[0] / x.max(least)).min(room[1] / y.max(least));
    let at = [ranges[0], ranges[1]].map(|[a, b]| a + 0.5 * (b - a));
    Projection::Parallel { at, scale }
}

/// The nearest place from which everything is inside the margins: each side of the view is a plane, and the farthest
/// point over each of them says where it must lie.
fn perspective(places: &[[f64; 3]], room: [f64; 2], size: [f64; 2]) -> Projection {
    let focal = 0.5 * size[0].max(size[1]) / LENS;
    let side = |k: usize, t: f64| {
        let reach = |sign: f64| range(places.iter().map(|p| sign * p[k] + t * p[2])).map_or(0.0, |r| r[1]);
        let (a, b) = (reach(1.0), reach(-1.0));
        (0.5 * (a - b), 0.5 * (a + b) / t)
    };
    let (x, far_x) = side(0, 0.5 * room[0] / focal);
    let (y, far_y) = side(1, 0.5 * room[1] / focal);
    let [low, high] = range(places.iter().map(|p| p[2])).unwrap_or([0.0; 2]);
    let spread = [0, 1].map(|k| range(places.iter().map(|p| p[k])).map_or(0.0, |[a, b]| b - a));
    let largest = spread[0].max(spread[1]).max(high - low);
    let largest = if largest > 0.0 { largest } else { 2.0 };
    // Never nearer than the model is large: it would look like through a fish's eye. A longer lens fills the picture.
    let fits = far_x.max(far_y);
    let far = fits.max(high + largest);
    let middle = (far - 0.5 * (low + high)).max(1e-12);
    let (mut eye, mut focal) = ([x, y, far], focal);
    if far > fits {
        let seen = |k: usize, centre: f64| {
            range(places.iter().map(|p| (p[k] - centre) / (far - p[2]))).unwrap_or([0.0; 2])
        };
        // The middle moves towards where both sides are equally far.
        for _ in 0..8 {
            for k in 0..2 {
                let [a, b] = seen(k, eye[k]);
                eye[k] += 0.5 * (a + b) * middle;
            }
        }
        let zoom = |k: usize| {
            let [a, b] = seen(k, eye[k]);
            0.5 * room[k] / b.max(-a).max(1e-3 * largest / middle)
        };
        focal = zoom(0).min(zoom(1));
    }
    Projection::Perspective { eye, focal, middle }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [f64; 2] = [400.0, 300.0];

    fn cube() -> Vec<Point3> {
        let at = |k: u32| Point3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2));
        (0..8).map(|k| at(k) + Vector3::new(1e6, -3.0, 0.0)).collect()
    }

    #[test]
    fn every_view_sees_everything_and_fills_the_room() {
        for view in [View::Perspective, View::Top, View::Front, View::Right, View::Isometric] {
            let camera = Camera::fit(view, &cube(), SIZE, 20.0);
            let seen: Vec<[f64; 3]> = cube().iter().map(|p| camera.project(*p).unwrap()).collect();
            let x = range(seen.iter().map(|p| p[0])).unwrap();
            let y = range(seen.iter().map(|p| p[1])).unwrap();
            assert!(x[0] > 19.9 && x[1] < 380.1 && y[0] > 19.9 && y[1] < 280.1, "{view:?} {x:?} {y:?}");
            assert!(x[1] - x[0] > 359.0 || y[1] - y[0] > 259.0, "{view:?} {x:?} {y:?}");
        }
    }

    #[test]
    fn top_front_and_right_have_their_axes() {
        let points = [Point3::ORIGIN, Point3::new(2.0, 2.0, 2.0)];
        let origin_and = |view: View, v: Vector3| {
            let camera = Camera::fit(view, &points, SIZE, 0.0);
            let [a, b] = [Point3::ORIGIN, Point3::ORIGIN + v].map(|p| camera.project(p).unwrap());
            [b[0] - a[0], a[1] - b[1], b[2] - a[2]].map(|x| (x * 1e6).round() / 1e6)
        };
        let s = 150.0;
        assert_eq!(origin_and(View::Top, Vector3::X), [s, 0.0, 0.0]);
        assert_eq!(origin_and(View::Top, Vector3::Z), [0.0, 0.0, s]);
        assert_eq!(origin_and(View::Front, Vector3::Z), [0.0, s, 0.0]);
        assert_eq!(origin_and(View::Front, -Vector3::Y), [0.0, 0.0, s]);
        assert_eq!(origin_and(View::Right, Vector3::Y), [s, 0.0, 0.0]);
        assert_eq!(origin_and(View::Right, Vector3::X), [0.0, 0.0, s]);
    }

    #[test]
    fn a_perspective_keeps_lines_straight_in_depth_too() {
        let camera = Camera::fit(View::Perspective, &cube(), SIZE, 0.0);
        let corners = cube();
        let (a, b) = (corners[0], corners[7]);
        let [p, q, m] = [a, b, a.lerp(b, 0.3)].map(|p| camera.project(p).unwrap());
        let t = (m[0] - p[0]) / (q[0] - p[0]);
        for k in 1..3 {
            assert!((m[k] - p[k] - t * (q[k] - p[k])).abs() < 1e-6);
        }
    }

    #[test]
    fn what_is_behind_the_camera_is_not_seen() {
        let camera = Camera::fit(View::Perspective, &cube(), SIZE, 0.0);
        let middle = Point3::new(1e6 + 0.5, -2.5, 0.5);
        let behind = middle + camera.towards_viewer(middle) * 100.0;
        assert_eq!(camera.project(behind), None);
        let seen = camera.polyline(&[middle, behind]);
        assert_eq!((seen.len(), seen[0].len()), (1, 2));
    }

    #[test]
    fn a_point_alone_and_nothing_at_all_have_a_view() {
        for view in [View::Perspective, View::Top] {
            let camera = Camera::fit(view, &[Point3::new(5.0, 5.0, 5.0)], SIZE, 20.0);
            let [x, y, _] = camera.project(Point3::new(5.0, 5.0, 5.0)).unwrap();
            assert!((x - 200.0).abs() < 1e-9 && (y - 150.0).abs() < 1e-9);
            assert!(Camera::fit(view, &[], SIZE, 20.0).project(Point3::ORIGIN).is_some());
        }
    }
}
