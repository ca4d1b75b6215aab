//! LunchBox Util: curves as arcs, wires as nodes and lists of ends, and what lies in one place twice.

use std::collections::HashMap;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder};
use katydid_geometry::biarc::tangent_arc;
use katydid_geometry::{Curve, Point3};

/// Points in the cubes of a grid: those within a distance of a place lie in its cube and the 26 round it.
struct Places {
    size: f64,
    cubes: HashMap<[i64; 3], Vec<usize>>,
    points: Vec<Point3>,
}

impl Places {
    /// # Errors
    /// The tolerance is not greater than 0.
    fn new(context: &Context<'_>) -> Result<Self, Message> {
        let size = context.tolerance().absolute;
        if !(size > 0.0 && size.is_finite()) {
            return Err(Message::error("The tolerance of the document is not greater than 0"));
        }
        Ok(Self { size, cubes: HashMap::new(), points: Vec::new() })
    }

    fn cube(&self, p: Point3) -> [i64; 3] {
        // Beyond what whole numbers hold all share the last cube, which is slow but not wrong.
        [p.x, p.y, p.z].map(|x| (x / self.size).floor() as i64)
    }

    /// The numbers of the points within the tolerance of a place, in no order.
    fn near(&self, p: Point3) -> Vec<usize> {
        let [x, y, z] = self.cube(p);
        let mut found = Vec::new();
        for dx in -1..=1 {
            for dy in -1..=1 {
                for dz in -1..=1 {
                    let key = [x.saturating_add(dx), y.saturating_add(dy), z.saturating_add(dz)];
                    let inside = self.cubes.get(&key).into_iter().flatten().copied();
                    let close =
                        |k: &usize| self.points.get(*k).is_some_and(|q| q.distance_to(p) <= self.size);
                    found.extend(inside.filter(close));
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Adds a point and gives its number.
    fn add(&mut self, p: Point3) -> usize {
        let number = self.points.len();
        self.cubes.entry(self.cube(p)).or_default().push(number);
        self.points.push(p);
        number
    }

    /// The number of the first point within the tolerance, or of the point itself, added.
    fn number(&mut self, p: Point3) -> usize {
        match self.near(p).first() {
            Some(known) => *known,
            None => self.add(p),
        }
    }
}

fn integer(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// Replaces a curve by arcs that touch one another: each begins where the curve is at a parameter, in the direction in which the
/// arc before ends, and ends at the next parameter. Stands for LunchBox's Arc Divide; that the first arc leaves along the curve's
/// own tangent is our reading. Where an arc would be straight it is a line, and its centre is null.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c61",
    name = "Arc Divide",
    nick = "ArcDivide",
    at = "LunchBox/Util"
)]
#[output("Arcs", "Arcs", "The arcs, one between each two parameters.")]
#[output("Centers", "Centers", "Their centres.")]
fn arc_divide(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Parameters of the curve, at least two. They are taken in rising order.
    #[port("t Parameters", "t")]
    parameters: List<f64>,
) -> Result<(Vec<Shared<Curve>>, Vec<Option<Point3>>), Message> {
    let mut parameters: Vec<f64> = parameters.present().collect();
    if parameters.len() < 2 || parameters.iter().any(|t| !t.is_finite()) {
        return Err(Message::error("Arcs need at least two parameters, all of them finite"));
    }
    context.items(parameters.len().saturating_mul(2))?;
    parameters.sort_by(f64::total_cmp);
    parameters.dedup();
    let places: Vec<Point3> = parameters.iter().map(|t| curve.point_at(*t)).collect();
    let start = parameters.first().copied().unwrap_or(0.0);
    let mut direction = curve
        .tangent_at(start)
        .ok_or_else(|| Message::error(format!("The curve has no tangent at {start}")))?;
    let (mut arcs, mut centers) = (Vec::new(), Vec::new());
    for pair in places.windows(2) {
        let &[from, to] = pair else { continue };
        let arc = tangent_arc(from, direction, to)?;
        if let Some(tangent) = arc.tangent_at(arc.domain().end) {
            direction = tangent;
        }
        centers.push(match &arc {
            Curve::Arc(arc) => Some(arc.arc.circle.plane.origin),
            _ => None,
        });
        arcs.push(Shared::new(arc));
    }
    Ok((arcs, centers))
}

/// The ends of wires as a list of nodes, in which each place stands once, and for each wire the numbers of its ends. Stands for
/// LunchBox's Deconstruct Wireframe. Ends nearer than the tolerance of the document are one node.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c62",
    name = "Deconstruct Wireframe",
    nick = "DeWire",
    at = "LunchBox/Util"
)]
#[output("Nodes", "Nodes", "The nodes, in the order in which wires name them.")]
#[output("Curve Definition", "CrvDef", "A branch for each wire: the numbers of its start and its end.", kind = Integer)]
fn deconstruct_wireframe(
    context: &Context<'_>,
    /// The wires.
    #[port("Curves", "Crvs")]
    curves: List<Shared<Curve>>,
) -> Result<(Vec<Point3>, Tree), Message> {
    context.items(curves.len().saturating_mul(4))?;
    let mut places = Places::new(context)?;
    let mut ends = TreeBuilder::<i32>::new();
    for (k, curve) in curves.present().enumerate() {
        context.check()?;
        ends.branch(context.path().child(k));
        for end in [curve.start(), curve.end()] {
            ends.push(Some(integer(places.number(end))));
        }
    }
    Ok((places.points, ends.finish()))
}

/// The points of a list without those that come again. Stands for LunchBox's Sort Duplicate Points; that points nearer than the
/// tolerance of the document are the same, and what the indices are, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c63",
    name = "Sort Duplicate Points",
    nick = "Sort Pts",
    at = "LunchBox/Util"
)]
#[output("Unique Points", "Unique", "The points, each once, in the order of the list.")]
#[output("Indices", "Indices", "For each point of the list the number of the one that stands for it.")]
fn sort_points(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "Pts")]
    points: List<Point3>,
) -> Result<(Vec<Point3>, Vec<i32>), Message> {
    context.items(points.len().saturating_mul(2))?;
    let mut places = Places::new(context)?;
    let indices = points.present().map(|p| integer(places.number(p))).collect();
    Ok((places.points, indices))
}

/// Texts without those that come again. Stands for LunchBox's Sort Duplicate Values; what the indices are is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c64",
    name = "Sort Duplicate Values",
    nick = "Sort Val",
    at = "LunchBox/Util"
)]
#[output("Unique Values", "Unique", "The texts, each once, in the order of the list.")]
#[output("Indices", "Indices", "For each text of the list the number of the one that stands for it.")]
fn sort_values(
    context: &Context<'_>,
    /// Texts, or numbers as texts.
    #[port("Value List", "Values")]
    values: List<Shared<str>>,
) -> Result<(Vec<Shared<str>>, Vec<i32>), Message> {
    context.items(values.len().saturating_mul(2))?;
    let (mut numbers, mut unique, mut indices) = (HashMap::new(), Vec::new(), Vec::new());
    for value in values.present() {
        let number = *numbers.entry(value.clone()).or_insert_with(|| {
            unique.push(value);
            unique.len() - 1
        });
        indices.push(integer(number));
    }
    Ok((unique, indices))
}

/// At how many places along them two curves are compared, beside their middles.
const COMPARED: usize = 16;

/// Points of a curve at even lengths.
fn samples(curve: &Curve) -> Vec<Point3> {
    let at =
        |part: f64| curve.parameter_at_normalized_length(part).unwrap_or_else(|| curve.domain().at(part));
    (0..=COMPARED).map(|k| curve.point_at(at(k as f64 / COMPARED as f64))).collect()
}

/// The curves of a list without those that come again, in whichever direction they run. Stands for LunchBox's Sort Duplicate
/// Curves; that two curves are the same where 17 places at even lengths along them are within the tolerance of the document, and
/// what the indices are, is our reading. Closed curves that begin in different places are different.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c65",
    name = "Sort Duplicate Curves",
    nick = "Sort Crv",
    at = "LunchBox/Util"
)]
#[output("Unique Curves", "Unique", "The curves, each once, in the order of the list.")]
#[output("Indices", "Indices", "For each curve of the list the number of the one that stands for it.")]
fn sort_curves(
    context: &Context<'_>,
    /// The curves.
    #[port("Curves", "Crvs")]
    curves: List<Shared<Curve>>,
) -> Result<(Vec<Shared<Curve>>, Vec<i32>), Message> {
    context.items(curves.len().saturating_mul(2))?;
    context.bytes(curves.len().saturating_mul(24 * (COMPARED + 1)))?;
    // Curves that are the same have their middles in one place.
    let mut middles = Places::new(context)?;
    let limit = middles.size;
    let (mut unique, mut known, mut indices) = (Vec::new(), Vec::<Vec<Point3>>::new(), Vec::new());
    for curve in curves.present() {
        context.check()?;
        let points = samples(&curve);
        let middle = points.get(COMPARED / 2).copied().unwrap_or(Point3::ORIGIN);
        let same = |k: &usize| {
            let Some(other) = known.get(*k) else { return false };
            let near = |(a, b): (&Point3, &Point3)| a.distance_to(*b) <= limit;
            points.iter().zip(other).all(near) || points.iter().rev().zip(other).all(near)
        };
        let found = middles.near(middle).into_iter().find(same);
        let number = found.unwrap_or_else(|| {
            unique.push(curve);
            middles.add(middle)
        });
        if found.is_none() {
            known.push(points);
        }
        indices.push(integer(number));
    }
    Ok((unique, indices))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Arc, Circle, Curve, Interval, Line, Plane, Point3};

    fn line(a: [f64; 3], b: [f64; 3]) -> Line {
        Line::new(Point3::from(a), Point3::from(b))
    }

    #[test]
    fn arcs_touch() {
        let half = Arc::new(Circle { plane: Plane::XY, radius: 2.0 }, Interval::new(0.0, 3.0)).unwrap();
        let domain = Curve::from(katydid_geometry::ArcCurve::new(half)).domain();
        let trial = Trial::of("Arc Divide").item(half).list([0.0, 0.3, 0.55, 1.0].map(|t| domain.at(t)));
        let out = trial.run().outputs;
        assert_eq!([out[0].item_count(), out[1].item_count()], [3, 3]);
        // Arcs through points of a circle, along its tangent, are parts of it.
        for center in out[1].column().iter() {
            let Some(Value::Point(p)) = center else { panic!("{center:?}") };
            assert!(p.distance_to(Point3::ORIGIN) < 1e-9, "{p:?}");
        }
        let straight =
            Trial::of("Arc Divide").item(line([0.; 3], [4., 0., 0.])).list([0.0, 1.0]).run().outputs;
        assert!(straight[1].column().is_null(0));
        let one = Trial::of("Arc Divide").item(line([0.; 3], [4., 0., 0.])).list([0.0]);
        assert!(one.message().contains("two parameters"));
        let bad = Trial::of("Arc Divide").item(line([0.; 3], [4., 0., 0.])).list([0.0, f64::NAN]);
        assert!(bad.message().contains("finite"));
    }

    #[test]
    fn a_square_of_wires() {
        let at = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let near = [1.0 + 4e-4, -3e-4, 0.0];
        let wires = [line(at[0], at[1]), line(near, at[2]), line(at[2], at[3]), line(at[3], at[0])];
        let of = || Trial::of("Deconstruct Wireframe").list(wires);
        assert_eq!(of().run().outputs[0].item_count(), 4);
        assert_eq!(of().texts(1), ["{0;0}: 0, 1", "{0;1}: 1, 2", "{0;2}: 2, 3", "{0;3}: 3, 0"]);
    }

    #[test]
    fn what_comes_again() {
        let points =
            [[0., 0., 0.], [5., 0., 0.], [0., 0., 5e-4], [5., 0., 0.], [0., 0., 2e-3]].map(Point3::from);
        assert_eq!(Trial::of("Sort Duplicate Points").list(points).texts(1), ["{0}: 0, 1, 0, 1, 2"]);
        let far = [Point3::new(1e300, 0., 0.), Point3::new(-1e300, 0., 0.), Point3::new(1e300, 0., 0.)];
        assert_eq!(Trial::of("Sort Duplicate Points").list(far).texts(1), ["{0}: 0, 1, 0"]);
        let values = Trial::of("Sort Duplicate Values").list(["oak", "elm", "oak", "ash", "elm"]);
        assert_eq!(values.texts(0), ["{0}: oak, elm, ash"]);
        let values = Trial::of("Sort Duplicate Values").list(["oak", "elm", "oak", "ash", "elm"]);
        assert_eq!(values.texts(1), ["{0}: 0, 1, 0, 2, 1"]);
    }

    #[test]
    fn curves_that_come_again() {
        let (a, b) = ([0., 0., 0.], [2., 0., 0.]);
        let bow = Arc::through(Point3::from(a), Point3::new(1., 1., 0.), Point3::from(b)).unwrap();
        let list = [
            Value::from(line(a, b)),
            Value::from(bow),
            Value::from(line(b, a)),
            Value::from(line([0., 1e-4, 0.], [2., -1e-4, 0.])),
            // Its middle is that of the first, and it is another.
            Value::from(line([1., -1., 0.], [1., 1., 0.])),
        ];
        assert_eq!(Trial::of("Sort Duplicate Curves").list(list).texts(1), ["{0}: 0, 1, 0, 0, 2"]);
    }
}
