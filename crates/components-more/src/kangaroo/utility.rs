//! Utility: points and lines that stand twice, all pairs, polylines cut at corners.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Line, Point3, PolylineCurve};

use super::collisions::pairs;
use super::thresholds::SMALLEST_CELL;

/// A polyline as an item; none of fewer than two points.
pub(super) fn polyline(points: Vec<Point3>) -> Option<Value> {
    PolylineCurve::new(points).ok().map(|curve| Value::from(Curve::Polyline(curve)))
}

/// Whether two points differ by less than `t` along each axis.
fn same(a: Point3, b: Point3, t: f64) -> bool {
    (a.x - b.x).abs() < t && (a.y - b.y).abs() < t && (a.z - b.z).abs() < t
}

/// Points met so far, in cells.
struct Met {
    size: f64,
    cells: std::collections::HashMap<[i64; 3], Vec<usize>>,
}

impl Met {
    fn new(tolerance: f64) -> Self {
        Self { size: tolerance.max(SMALLEST_CELL), cells: Default::default() }
    }

    fn cell(&self, p: Point3) -> [i64; 3] {
        [p.x, p.y, p.z].map(|x| (x / self.size).floor() as i64)
    }

    /// The numbers of those that may be near, in order.
    fn near(&self, p: Point3) -> Vec<usize> {
        let [x, y, z] = self.cell(p);
        let mut found: Vec<usize> = (0..27)
            .flat_map(|k| {
                let key = [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1];
                let key = [x.saturating_add(key[0]), y.saturating_add(key[1]), z.saturating_add(key[2])];
                self.cells.get(&key).cloned().unwrap_or_default()
            })
            .collect();
        found.sort_unstable();
        found
    }

    fn add(&mut self, p: Point3, i: usize) {
        let key = self.cell(p);
        self.cells.entry(key).or_default().push(i);
    }
}

fn tolerance(t: f64) -> Result<f64, Message> {
    if t >= 0.0 && t.is_finite() {
        Ok(t)
    } else {
        Err(Message::error("The tolerance is not a number of at least 0"))
    }
}

/// The points without those that stand nearer than a tolerance, along each axis, to one before them. Stands for Kangaroo 2's
/// removeDuplicatePts.
#[component(
    "5e2f9e3f-d467-46f6-870c-6fa7cd01e1ed",
    name = "removeDuplicatePts",
    nick = "dupPt",
    at = "Kangaroo2/Utility"
)]
#[output("Unique points", "Q", "The points that are left, in their order.")]
fn remove_duplicate_points(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The distance along each axis below which two points are one, in units.
    #[port("tolerance", "t", default = 0.01)]
    t: f64,
) -> Result<Vec<Point3>, Message> {
    let t = tolerance(t)?;
    let mut met = Met::new(t);
    let mut kept: Vec<Point3> = Vec::new();
    for p in points.present() {
        context.check()?;
        let known = |i: usize| kept.get(i).is_some_and(|q| same(p, *q, t) || p == *q);
        if !met.near(p).into_iter().any(known) {
            met.add(p, kept.len());
            kept.push(p);
        }
    }
    Ok(kept)
}

/// The lines without those whose ends stand nearer than a tolerance to the ends of one before them, in either order. Stands
/// for Kangaroo 2's removeDuplicateLines.
#[component(
    "5b882297-9063-439e-82b9-70961f743c5d",
    name = "removeDuplicateLines",
    nick = "dupLn",
    at = "Kangaroo2/Utility"
)]
#[output("Unique lines", "Q", "The lines that are left, in their order.")]
fn remove_duplicate_lines(
    context: &Context<'_>,
    /// The lines.
    #[port("Lines", "L")]
    lines: List<Line>,
    /// The distance below which two ends are one, in units.
    #[port("tolerance", "t", default = 0.01)]
    t: f64,
) -> Result<Vec<Line>, Message> {
    let t = tolerance(t)?;
    let mut met = Met::new(t);
    let mut kept: Vec<Line> = Vec::new();
    let one = |a: Point3, b: Point3| a == b || a.distance_to(b) < t;
    for line in lines.present() {
        context.check()?;
        let known = |i: usize| {
            kept.get(i).is_some_and(|own| {
                one(own.from, line.from) && one(own.to, line.to)
                    || one(own.from, line.to) && one(own.to, line.from)
            })
        };
        // The middles of such lines are as near as their ends.
        let middle = line.midpoint();
        if !met.near(middle).into_iter().any(known) {
            met.add(middle, kept.len());
            kept.push(line);
        }
    }
    Ok(kept)
}

/// A line between every pair of points. Stands for Kangaroo 2's interconnectPoints.
#[component(
    "a412ddf4-4899-4456-8325-f3f9a8134a25",
    name = "interconnectPoints",
    nick = "inter",
    at = "Kangaroo2/Utility"
)]
#[output("Interconnections", "I", "The lines, from each point to those after it.")]
fn interconnect_points(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<Vec<Line>, Message> {
    let points: Vec<Point3> = points.present().collect();
    context.items(points.len().saturating_mul(points.len().saturating_sub(1)) / 2)?;
    pairs(&points)
}

/// Cuts a polyline where it turns by more than an angle. Stands for Kangaroo 2's SplitAtCorners.
#[component(
    "74953dd1-9af7-4736-983c-f258302de692",
    name = "SplitAtCorners",
    nick = "SplitAtCorners",
    at = "Kangaroo2/Utility"
)]
#[output("Corners", "C", "The points where it turns by more than the angle.")]
#[output("Segments", "S", "The polylines between them.")]
fn split_at_corners(
    /// The polyline.
    #[port("Polyline", "P")]
    curve: &Curve,
    /// The angle, in radians.
    #[port("Angle", "A", default = 0.5)]
    angle: f64,
) -> Result<(Vec<Point3>, Vec<Option<Value>>), Message> {
    let points = curve.as_polyline().ok_or_else(|| Message::error("The curve is not a polyline"))?;
    let (mut corners, mut pieces, mut piece) = (Vec::new(), Vec::new(), Vec::new());
    for (i, p) in points.iter().enumerate() {
        piece.push(*p);
        let around = (i.checked_sub(1).and_then(|k| points.get(k)), points.get(i + 1));
        let (Some(before), Some(after)) = around else { continue };
        if (*p - *before).angle_to(*after - *p).is_some_and(|turn| turn > angle) {
            corners.push(*p);
            pieces.push(std::mem::replace(&mut piece, vec![*p]));
        }
    }
    pieces.push(piece);
    Ok((corners, pieces.into_iter().map(polyline).filter(Option::is_some).collect()))
}

/// Shows points as dots; nothing comes out. Stands for Kangaroo 2's DotDisplay.
#[component(
    "d27b55c6-9d5f-4d05-be7b-b91009aad383",
    name = "DotDisplay",
    nick = "Dot",
    at = "Kangaroo2/Utility"
)]
fn dot_display(
    /// The points.
    #[port("Points", "P")]
    _points: List<Point3>,
) {
}
