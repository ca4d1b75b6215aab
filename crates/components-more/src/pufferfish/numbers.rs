//! Numbers and domains: rounding, splitting, bringing to 0 to 1, and graphs that curves draw.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Curve, Interval, Line, Plane, Point3, Rectangle, Vector3};

/// A number's whole part and what is left. Stands for Pufferfish's Deconstruct Number.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f303c",
    name = "Deconstruct Number",
    nick = "DeNum",
    at = "Pufferfish/Number"
)]
#[output("Integer", "I", "The whole part, nearer to 0.")]
#[output("Remainder", "R", "What is left.")]
fn deconstruct(
    /// The number.
    #[port("Number", "N")]
    number: f64,
) -> Result<(i32, f64), Message> {
    let whole = number.trunc();
    if whole.abs() <= f64::from(i32::MAX) {
        Ok((whole as i32, number - whole))
    } else {
        Err(Message::error("The number is too large for a whole one"))
    }
}

/// The highest and the lowest of numbers. Stands for Pufferfish's Highest & Lowest Numbers.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f303d",
    name = "Highest & Lowest Numbers",
    nick = "HiLoNums",
    at = "Pufferfish/Number"
)]
#[output("Highest", "H", "The highest.")]
#[output("Lowest", "L", "The lowest.")]
fn highest_lowest(
    /// The numbers.
    #[port("Numbers", "N")]
    numbers: List<f64>,
) -> Result<(f64, f64), Message> {
    let extreme = |choose: fn(f64, f64) -> f64| numbers.present().reduce(choose);
    extreme(f64::max).zip(extreme(f64::min)).ok_or_else(|| Message::warning("There are no numbers"))
}

/// True for false, false for true. Stands for Pufferfish's Invert Boolean.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f303e",
    name = "Invert Boolean",
    nick = "InvBool",
    at = "Pufferfish/Number"
)]
#[output("Inverted", "I", "The other one.")]
fn invert(
    /// The Boolean.
    #[port("Boolean", "B")]
    value: bool,
) -> bool {
    !value
}

/// A number less one. Stands for Pufferfish's X Minus One.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f303f",
    name = "X Minus One",
    nick = "x-1",
    at = "Pufferfish/Number"
)]
#[output("Result", "R", "x - 1.")]
fn minus_one(
    /// The number.
    #[port("x", "x")]
    x: f64,
) -> f64 {
    x - 1.0
}

/// A number and one. Stands for Pufferfish's X Plus One.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3040",
    name = "X Plus One",
    nick = "x+1",
    at = "Pufferfish/Number"
)]
#[output("Result", "R", "x + 1.")]
fn plus_one(
    /// The number.
    #[port("x", "x")]
    x: f64,
) -> f64 {
    x + 1.0
}

/// Whether two numbers are within a tolerance of each other. Stands for Pufferfish's Equality Within Tolerance.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3041",
    name = "Equality Within Tolerance",
    nick = "EqualsT",
    at = "Pufferfish/Number"
)]
#[output("Equal", "=", "Whether they are.")]
#[output("Not Equal", "!=", "Whether they are not.")]
fn equality(
    /// One number.
    #[port("A", "A")]
    a: f64,
    /// The other one.
    #[port("B", "B")]
    b: f64,
    /// The tolerance.
    #[port("Tolerance", "t", default = 0.001)]
    tolerance: f64,
) -> (bool, bool) {
    let equal = (a - b).abs() <= tolerance;
    (equal, !equal)
}

/// The distance below which two places are one: 1e-12. Stands for Pufferfish's Zero Distance Tolerance.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3042",
    name = "Zero Distance Tolerance",
    nick = "ZeroDt",
    at = "Pufferfish/Number"
)]
#[output("Tolerance", "t", "1e-12, in units.")]
fn zero_tolerance() -> f64 {
    1e-12
}

/// The angle tolerance where nothing else is said: one degree. Stands for Pufferfish's Default Angle Tolerance.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3043",
    name = "Default Angle Tolerance",
    nick = "DefAt",
    at = "Pufferfish/Number"
)]
#[output("Degrees", "D", "In degrees.")]
#[output("Radians", "R", "In radians.")]
fn default_angle() -> (f64, f64) {
    (1.0, 1_f64.to_radians())
}

/// The angle tolerance of the document. Stands for Pufferfish's Document Angle Tolerance.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3044",
    name = "Document Angle Tolerance",
    nick = "DocAt",
    at = "Pufferfish/Number"
)]
#[output("Degrees", "D", "In degrees.")]
#[output("Radians", "R", "In radians.")]
fn document_angle(context: &Context<'_>) -> (f64, f64) {
    let angle = context.tolerance().angle;
    (angle.to_degrees(), angle)
}

/// The distance tolerance of the document. Stands for Pufferfish's Document Distance Tolerance.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3045",
    name = "Document Distance Tolerance",
    nick = "DocDt",
    at = "Pufferfish/Number"
)]
#[output("Tolerance", "t", "In units.")]
fn document_distance(context: &Context<'_>) -> f64 {
    context.tolerance().absolute
}

/// The first number divided by all others, one after another. Stands for Pufferfish's Mass Division.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3046",
    name = "Mass Division",
    nick = "MDiv",
    at = "Pufferfish/Number"
)]
#[output("Result", "R", "What is left.", kind = Number)]
#[output("Partial Results", "Pr", "What is left after each number.")]
fn mass_division(
    /// The numbers.
    #[port("Input", "I")]
    numbers: List<f64>,
) -> Result<(f64, Vec<f64>), Message> {
    let mut numbers = numbers.present();
    let mut result = numbers.next().ok_or_else(|| Message::warning("There are no numbers"))?;
    let mut partial = vec![result];
    for x in numbers {
        if x == 0.0 {
            return Err(Message::error("A number cannot be divided by 0"));
        }
        result /= x;
        partial.push(result);
    }
    Ok((result, partial))
}

/// The first number less all others. Stands for Pufferfish's Mass Subtraction.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3047",
    name = "Mass Subtraction",
    nick = "MSub",
    at = "Pufferfish/Number"
)]
#[output("Result", "R", "What is left.", kind = Number)]
#[output("Partial Results", "Pr", "What is left after each number.")]
fn mass_subtraction(
    /// The numbers.
    #[port("Input", "I")]
    numbers: List<f64>,
) -> Result<(f64, Vec<f64>), Message> {
    let mut numbers = numbers.present();
    let mut result = numbers.next().ok_or_else(|| Message::warning("There are no numbers"))?;
    let mut partial = vec![result];
    for x in numbers {
        result -= x;
        partial.push(result);
    }
    Ok((result, partial))
}

/// Numbers brought to 0 to 1: the lowest to 0, the highest to 1; all the same become 0. Stands for Pufferfish's Reparameterize Numbers.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3048",
    name = "Reparameterize Numbers",
    nick = "ReparamNums",
    at = "Pufferfish/Number"
)]
#[output("Reparameterized", "R", "The numbers, nulls where there are nulls.")]
fn reparameterize(
    /// The numbers.
    #[port("Numbers", "N")]
    numbers: List<f64>,
    /// Whether the lowest goes to 1 and the highest to 0.
    #[port("Invert", "I", default = false)]
    invert: bool,
) -> Vec<Option<f64>> {
    let low = numbers.present().fold(f64::INFINITY, f64::min);
    let high = numbers.present().fold(f64::NEG_INFINITY, f64::max);
    let unit = |x: f64| if high > low { (x - low) / (high - low) } else { 0.0 };
    numbers.iter().map(|x| x.map(|x| if invert { 1.0 - unit(x) } else { unit(x) })).collect()
}

/// A number rounded to so many places behind the point, or cut off there. Stands for Pufferfish's Round To Decimal Place; the ports are
/// our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3049",
    name = "Round To Decimal Place",
    nick = "RoundD",
    at = "Pufferfish/Number"
)]
#[output("Rounded", "R", "The number.")]
fn round_decimal(
    /// The number.
    #[port("Number", "N")]
    number: f64,
    /// The places, from 0 to 15.
    #[port("Decimal Place", "D", default = 2)]
    places: i32,
    /// Whether the rest is cut off, not rounded.
    #[port("Truncate", "T", default = false)]
    truncate: bool,
) -> f64 {
    let scale = 10_f64.powi(places.clamp(0, 15));
    let scaled = number * scale;
    if !scaled.is_finite() {
        return number;
    }
    (if truncate { scaled.trunc() } else { scaled.round_ties_even() }) / scale
}

/// A number rounded to a multiple of another. Stands for Pufferfish's Round To Factor; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f304a",
    name = "Round To Factor",
    nick = "RoundF",
    at = "Pufferfish/Number"
)]
#[output("Nearest", "N", "The nearest multiple.")]
#[output("Floor", "F", "The one below.")]
#[output("Ceiling", "C", "The one above.")]
fn round_factor(
    /// The number.
    #[port("Number", "N")]
    number: f64,
    /// The factor; not 0.
    #[port("Factor", "F", default = 1.0)]
    factor: f64,
) -> Result<(f64, f64, f64), Message> {
    let factor = factor.abs();
    if !(factor > 0.0 && factor.is_finite()) {
        return Err(Message::error("The factor must not be 0"));
    }
    let parts = number / factor;
    Ok((parts.round() * factor, parts.floor() * factor, parts.ceil() * factor))
}

/// Numbers rounded to the nearest of others. Stands for Pufferfish's Round To Nearest.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f304b",
    name = "Round To Nearest",
    nick = "RoundN",
    at = "Pufferfish/Number"
)]
#[output("Rounded", "R", "The nearest of y for each of x.")]
fn round_nearest(
    /// The numbers.
    #[port("x", "x")]
    numbers: List<f64>,
    /// What they are rounded to.
    #[port("y", "y")]
    to: List<f64>,
    /// Whether x is brought to the range of y first.
    #[port("Remap", "R", default = false)]
    remap: bool,
) -> Result<Vec<Option<f64>>, Message> {
    let mut sorted: Vec<f64> = to.present().collect();
    sorted.sort_by(f64::total_cmp);
    let (Some(low), Some(high)) = (sorted.first().copied(), sorted.last().copied()) else {
        return Err(Message::warning("There are no numbers to round to"));
    };
    let least = numbers.present().fold(f64::INFINITY, f64::min);
    let most = numbers.present().fold(f64::NEG_INFINITY, f64::max);
    let nearest = |x: f64| {
        let x = if remap && most > least { low + (x - least) / (most - least) * (high - low) } else { x };
        let above = sorted.partition_point(|y| *y < x);
        let candidates = [above.checked_sub(1), Some(above)].into_iter().flatten();
        candidates
            .filter_map(|i| sorted.get(i))
            .copied()
            .reduce(|a, b| if (b - x).abs() < (a - x).abs() { b } else { a })
    };
    Ok(numbers.iter().map(|x| x.and_then(nearest)).collect())
}

/// Odd and even numbers apart, others in neither. Stands for Pufferfish's Odd & Even Numbers; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f304c",
    name = "Odd & Even Numbers",
    nick = "OddEveNums",
    at = "Pufferfish/Number"
)]
#[output("Odd", "O", "The odd numbers.", kind = Number)]
#[output("Even", "E", "The even numbers.", kind = Number)]
fn odd_even(
    /// The numbers.
    #[port("Numbers", "N")]
    numbers: List<f64>,
    /// Whether a null stands where the number went to the other list.
    #[port("Nulls", "P", default = false)]
    nulls: bool,
) -> (Vec<Option<f64>>, Vec<Option<f64>>) {
    let (mut odd, mut even) = (Vec::new(), Vec::new());
    for x in numbers.present() {
        let rest = x.rem_euclid(2.0);
        let (is_odd, is_even) = (rest == 1.0, rest == 0.0);
        if is_odd || nulls {
            odd.push(is_odd.then_some(x));
        }
        if is_even || nulls {
            even.push(is_even.then_some(x));
        }
    }
    (odd, even)
}

/// A whole number in parts that are as equal as can be; the first are the larger. Stands for Pufferfish's Partition Number.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f304d",
    name = "Partition Number",
    nick = "PartNum",
    at = "Pufferfish/Number"
)]
#[output("Partition", "P", "The parts.")]
fn partition(
    context: &Context<'_>,
    /// The number.
    #[port("Number", "N")]
    number: i32,
    /// How many parts.
    #[port("Divisions", "D", default = 2)]
    parts: i32,
) -> Result<Vec<i32>, Message> {
    if parts < 1 {
        return Err(Message::error("There must be at least one part"));
    }
    context.items(usize::try_from(parts).unwrap_or(0))?;
    let (size, rest) = (number.div_euclid(parts), number.rem_euclid(parts));
    Ok((0..parts).map(|i| size + i32::from(i < rest)).collect())
}

/// A part of a number in hundredths. Stands for Pufferfish's Percentage; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f304e",
    name = "Percentage",
    nick = "Pcent",
    at = "Pufferfish/Number"
)]
#[output("Result", "R", "The part.")]
fn percentage(
    /// The number.
    #[port("Number", "N")]
    number: f64,
    /// Hundredths of it.
    #[port("Percent", "%", default = 50.0)]
    percent: f64,
) -> f64 {
    number * percent / 100.0
}

/// The domain from -x to x. Stands for Pufferfish's Two Way Domain.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f304f",
    name = "Two Way Domain",
    nick = "2WayDom",
    at = "Pufferfish/Domain"
)]
#[output("Domain", "D", "The domain.")]
fn two_way(
    /// How far it goes to both sides.
    #[port("Number", "N", default = 1.0)]
    number: f64,
) -> Interval {
    Interval::new(-number, number)
}

/// A number in a domain: its start at 0, its end at 1. Stands for Pufferfish's Slide Within Domain; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3050",
    name = "Slide Within Domain",
    nick = "SlideInDom",
    at = "Pufferfish/Domain"
)]
#[output("Number", "N", "The number.")]
fn slide(
    /// The domain.
    #[port("Domain", "D")]
    domain: Interval,
    /// Where in it.
    #[port("Slide", "S", default = 0.5)]
    slide: f64,
) -> f64 {
    domain.at(slide)
}

/// Brings numbers through a graph that curves draw in a rectangle: from its x axis up to a curve, and over to its y axis. Stands for
/// Pufferfish's Curve Graph Mapper; of several hits the lowest counts, and labels and the background are not drawn.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3051",
    name = "Curve Graph Mapper",
    nick = "CrvGraphMap",
    at = "Pufferfish/Number"
)]
#[output("Mapped", "M", "The numbers on the y axis; null where no curve is hit.", kind = Number)]
#[output("Graph Curves", "gC", "The curves.", kind = Curve)]
#[output("Graph Points", "gP", "Where the curves are hit.", kind = Point)]
#[output("Value Lines", "vL", "Lines from the x axis to the curves.", kind = Line)]
#[output("Value Points", "vP", "The numbers on the x axis.", kind = Point)]
#[output("Mapped Lines", "mL", "Lines from the curves to the y axis.", kind = Line)]
#[output("Mapped Points", "mP", "The results on the y axis.", kind = Point)]
#[output("Boundary", "B", "The rectangle.")]
#[output("Out Of Bounds", "O", "Whether each number lies outside the x axis.", kind = Boolean)]
#[output("Intersected", "I", "Whether each number hits a curve.", kind = Boolean)]
fn graph_mapper(
    context: &Context<'_>,
    /// The curves.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// The rectangle.
    #[port("Rectangle", "R")]
    rectangle: Rectangle,
    /// The numbers.
    #[port("Values", "V")]
    values: List<f64>,
    /// The range of the x axis; that of the numbers when nothing is given.
    #[port("X Axis", "X", optional)]
    x_axis: Option<Interval>,
    /// The range of the y axis; that of the numbers when nothing is given.
    #[port("Y Axis", "Y", optional)]
    y_axis: Option<Interval>,
    /// Whether the x axis is at the top.
    #[port("Flip", "F", default = false)]
    flip: bool,
    /// Whether the rectangle is fitted to the curves first.
    #[port("Snap", "S", default = false)]
    snap: bool,
    /// The size of labels, which are not drawn.
    #[port("Text Size", "T", optional)]
    _size: Option<f64>,
) -> Result<
    (
        Vec<Option<f64>>,
        Vec<Shared<Curve>>,
        Vec<Option<Point3>>,
        Vec<Option<Line>>,
        Vec<Option<Point3>>,
        Vec<Option<Line>>,
        Vec<Option<Point3>>,
        Rectangle,
        Vec<bool>,
        Vec<bool>,
    ),
    Message,
> {
    let curves: Vec<Shared<Curve>> = curves.present().collect();
    let mut frame = rectangle;
    if snap && !curves.is_empty() {
        let boxes: Vec<_> = curves.iter().map(|curve| curve.bounding_box_in(&frame.plane)).collect();
        let all = |of: fn(&katydid_geometry::Box3) -> Interval| boxes.iter().map(of).reduce(Interval::union);
        (frame.x, frame.y) = (all(|b| b.x).unwrap_or(frame.x), all(|b| b.y).unwrap_or(frame.y));
    }
    let bounds = || {
        let low = values.present().fold(f64::INFINITY, f64::min);
        let high = values.present().fold(f64::NEG_INFINITY, f64::max);
        if low < high { Interval::new(low, high) } else { Interval::UNIT }
    };
    let (x_axis, y_axis) = (x_axis.unwrap_or_else(bounds), y_axis.unwrap_or_else(bounds));
    let tolerance = context.tolerance().absolute;
    let normal: Vector3 = frame.plane.x_axis;
    let (mut mapped, mut hits, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    let (mut starts, mut across, mut ends) = (Vec::new(), Vec::new(), Vec::new());
    let (mut outside, mut hit_any) = (Vec::new(), Vec::new());
    context.items(values.len().saturating_mul(6))?;
    let base = if flip { frame.y.max() } else { frame.y.min() };
    for value in values.iter() {
        context.check()?;
        let Some(value) = value else {
            mapped.push(None);
            hits.push(None);
            lines.push(None);
            starts.push(None);
            across.push(None);
            ends.push(None);
            outside.push(true);
            hit_any.push(false);
            continue;
        };
        let share = x_axis.normalized(value);
        let x = frame.x.min() + share * frame.x.length().abs();
        let foot = frame.plane.at(x, base, 0.0);
        let cut = Plane::from_normal(foot, normal)?;
        let mut best: Option<(f64, Point3)> = None;
        for curve in &curves {
            for t in curve.intersect_plane(&cut, tolerance)? {
                let p = curve.point_at(t);
                let [_, y, _] = frame.plane.coordinates(p);
                let inside = y >= frame.y.min() - tolerance && y <= frame.y.max() + tolerance;
                let nearer = |known: f64| if flip { y > known } else { y < known };
                if inside && best.is_none_or(|(known, _)| nearer(known)) {
                    best = Some((y, p));
                }
            }
        }
        let height = frame.y.length().abs();
        let result = best.map(|(y, _)| {
            let share = if height > 0.0 { (y - frame.y.min()) / height } else { 0.0 };
            y_axis.at(if flip { 1.0 - share } else { share })
        });
        let point = best.map(|(_, p)| p);
        let end = best.map(|(y, _)| frame.plane.at(frame.x.min(), y, 0.0));
        mapped.push(result);
        hits.push(point);
        lines.push(point.map(|p| Line::new(foot, p)));
        starts.push(Some(foot));
        across.push(point.zip(end).map(|(a, b)| Line::new(a, b)));
        ends.push(end);
        outside.push(!(0.0..=1.0).contains(&share));
        hit_any.push(best.is_some());
    }
    Ok((mapped, curves, hits, lines, starts, across, ends, frame, outside, hit_any))
}
