//! Domains, random numbers and places.

use std::f64::consts::TAU;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Value, cast};
use katydid_elementary::Elementary;
use katydid_geometry::{Interval, Line, Plane, Point3, Rectangle, Vector3};

/// Moves the ends of a domain: the first number is taken from its start, the second one added to its end. Stands for Heteroptera's
/// Domain Expand.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd401",
    name = "Domain Expand",
    nick = "DExpand",
    at = "Heteroptera/Fundamental"
)]
#[output("Interval", "D", "The domain.")]
fn domain_expand(
    /// The domain.
    #[port("Domain", "D")]
    domain: Interval,
    /// What is taken from its start.
    #[port("T0", "A", default = 0.0)]
    before: f64,
    /// What is added to its end.
    #[port("T1", "B", default = 0.0)]
    behind: f64,
) -> Interval {
    Interval::new(domain.start - before, domain.end + behind)
}

/// Makes a domain longer by a number at both ends; a negative number makes it shorter. Stands for Heteroptera's Domain Expand
/// (Symmetric).
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd402",
    name = "Domain Expand (Symmetric)",
    nick = "DExpSym",
    at = "Heteroptera/Fundamental"
)]
#[output("Interval", "D", "The domain.")]
fn domain_expand_symmetric(
    /// The domain.
    #[port("Domain", "D")]
    domain: Interval,
    /// How much longer it becomes at each end.
    #[port("Number", "N", default = 1.0)]
    by: f64,
) -> Interval {
    // A domain that runs down grows downwards.
    let by = if domain.is_decreasing() { -by } else { by };
    Interval::new(domain.start - by, domain.end + by)
}

/// The domain of a length about a number in its middle. Stands for Heteroptera's Domain (Symmetric).
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd403",
    name = "Domain (Symmetric)",
    nick = "DomSym",
    at = "Heteroptera/Fundamental"
)]
#[output("Interval", "D", "The domain.")]
fn domain_symmetric(
    /// The length.
    #[port("Length", "X", default = 1.0)]
    length: f64,
    /// The middle.
    #[port("Base", "O", default = 0.0)]
    middle: f64,
) -> Interval {
    Interval::new(middle - 0.5 * length, middle + 0.5 * length)
}

/// SplitMix64 (G. Steele and others, *Fast splittable pseudorandom number generators*, 2014).
struct Chance(u64);

impl Chance {
    fn new(seed: i32) -> Self {
        Self(u64::from(seed.cast_unsigned()).wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number from 0 to below 1, of 53 random bits.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A place among so many.
    fn place(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count.saturating_sub(1))
    }
}

const OTHERS: &str = "The random numbers are Katydid's own: Heteroptera has others";

/// A count of items.
///
/// # Errors
/// It is negative, or there are more than may be made.
fn count(context: &Context<'_>, number: i32) -> Result<usize, Message> {
    let count = usize::try_from(number)
        .map_err(|_| Message::error(format!("The number is {number}: it must not be negative")))?;
    context.items(count)?;
    Ok(count)
}

/// Random numbers about a mean, as close to it as a standard deviation says: they have a normal distribution (Box and Muller 1958, *A
/// note on the generation of random normal deviates*). Stands for Heteroptera's Gaussian Random, which has other numbers each time;
/// here they are the same in each run.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd404",
    name = "Gaussian Random",
    nick = "GaussianRandom",
    at = "Heteroptera/Uncertainty"
)]
#[output("Random", "R", "The numbers.")]
fn gaussian_random(
    context: &Context<'_>,
    /// How many.
    #[port("Number", "N", default = 10)]
    number: i32,
    /// The mean.
    #[port("Mu Factor", "M", default = 0.0)]
    mean: f64,
    /// The standard deviation.
    #[port("Sigma", "S", default = 1.0)]
    deviation: f64,
) -> Result<Vec<f64>, Message> {
    context.tell(Message::remark(OTHERS));
    let mut chance = Chance::new(1);
    let mut next = || {
        // 1 - u is above 0, where the logarithm ends.
        let radius = (-2.0 * (1.0 - chance.unit()).logarithm()).sqrt();
        mean + deviation * radius * (TAU * chance.unit()).cosine()
    };
    Ok((0..count(context, number)?).map(|_| next()).collect())
}

/// Numbers that divide a domain into parts of about one length: those between its ends are moved by up to half a part times the
/// errancy. Stands for Heteroptera's Careless Range; how far numbers are moved is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd405",
    name = "Careless Range",
    nick = "CarelessRange",
    at = "Heteroptera/Uncertainty"
)]
#[output("Range", "R", "The numbers, one more than parts.")]
#[output("Interval", "I", "The parts.")]
fn careless_range(
    context: &Context<'_>,
    /// The domain.
    #[port("Domain", "D", default = Interval::new(0.0, 1.0))]
    domain: Interval,
    /// The number of parts, at least 1.
    #[port("Steps", "N", default = 10)]
    steps: i32,
    /// From 0, where all parts are as long, to 1.
    #[port("Errancy", "E", default = 0.5)]
    errancy: f64,
    /// Another seed gives other numbers.
    #[port("Seed", "S", default = 1)]
    seed: i32,
) -> Result<(Vec<f64>, Vec<Interval>), Message> {
    if steps < 1 {
        return Err(Message::error(format!("Steps is {steps}: it must be at least 1")));
    }
    if !(0.0..=1.0).contains(&errancy) {
        return Err(Message::error(format!("The errancy is {errancy}: it must be from 0 to 1")));
    }
    context.tell(Message::remark(OTHERS));
    let parts = count(context, steps)?;
    let mut chance = Chance::new(seed);
    let mut at = |place: usize| {
        let moved = if place == 0 || place == parts { 0.0 } else { errancy * (chance.unit() - 0.5) };
        domain.at((place as f64 + moved) / parts as f64)
    };
    let numbers: Vec<f64> = (0..=parts).map(&mut at).collect();
    let intervals = numbers.iter().zip(numbers.iter().skip(1)).map(|(a, b)| Interval::new(*a, *b)).collect();
    Ok((numbers, intervals))
}

/// Items drawn from a list by chance; one may be drawn several times. Stands for Heteroptera's Dice; the choice of its menu to draw each
/// once is not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd406",
    name = "Dice",
    nick = "Dice",
    at = "Heteroptera/Uncertainty"
)]
#[output("Result", "R", "The items that are drawn.", kind = Generic)]
#[output("Index", "I", "The place of each in the list.")]
fn dice(
    context: &Context<'_>,
    /// The items.
    #[port("Data", "D")]
    data: List<Value>,
    /// How many are drawn.
    #[port("Number", "N", default = 1)]
    number: i32,
    /// Another seed draws others.
    #[port("Seed (Optional)", "S", default = 1)]
    seed: i32,
) -> Result<(Vec<Option<Value>>, Vec<i32>), Message> {
    context.tell(Message::remark(OTHERS));
    let draws = count(context, number)?;
    if data.is_empty() && draws > 0 {
        return Err(Message::error("There is nothing to draw from"));
    }
    let mut chance = Chance::new(seed);
    let places: Vec<usize> = (0..draws).map(|_| chance.place(data.len())).collect();
    let items = places.iter().map(|place| data.get(*place)).collect();
    Ok((items, places.into_iter().map(|place| i32::try_from(place).unwrap_or(i32::MAX)).collect()))
}

/// The middle of the box around geometry, along the axes of the world, and the length of its diagonal. Stands for Heteroptera's Center;
/// the choices of its menu (one centre for all, in the XY plane, at the foot) are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd407",
    name = "Center",
    nick = "Center",
    at = "Heteroptera/Geometry"
)]
#[output("Center", "C", "The middle.")]
#[output("Dimension", "D", "The length of the diagonal.")]
fn center(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(Point3, f64), Message> {
    let found = cast::value(&geometry.0, katydid_data::Kind::Box, context.rules());
    let Some(Value::Box(around)) = found else {
        return Err(Message::error(format!("A {} has no box around it", geometry.0.kind().name())));
    };
    let (a, b) = (
        around.plane.at(around.x.start, around.y.start, around.z.start),
        around.plane.at(around.x.end, around.y.end, around.z.end),
    );
    Ok((a + (b - a) * 0.5, (b - a).length()))
}

/// The point of a rectangle at two numbers that run from 0 to 1 over its sides; others lie outside. Stands for Heteroptera's Evaluate
/// Rectangle.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd408",
    name = "Evaluate Rectangle",
    nick = "EvalRect",
    at = "Heteroptera/Geometry"
)]
#[output("Point", "P", "The point.")]
fn evaluate_rectangle(
    /// The rectangle.
    #[port("Rectangle", "R")]
    rectangle: Rectangle,
    /// The place along its x side.
    #[port("U", "U", default = 0.5)]
    u: f64,
    /// The place along its y side.
    #[port("V", "V", default = 0.5)]
    v: f64,
) -> Point3 {
    rectangle.plane.at(rectangle.x.at(u), rectangle.y.at(v), 0.0)
}

/// A plane at the start of a line, which is one of its axes: 0 its x axis, 1 its y axis, 2 its normal. The other axes are as level as
/// they can be. Stands for Heteroptera's Plane By Line; the numbers of axes, and where the other axes point, are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd409",
    name = "Plane By Line",
    nick = "LinePlane",
    at = "Heteroptera/Vectors"
)]
#[output("Plane", "P", "The plane.")]
fn plane_by_line(
    /// The line.
    #[port("Line", "L")]
    line: Line,
    /// Which axis it is.
    #[port("Axis", "A", default = 2)]
    axis: i32,
) -> Result<Plane, Message> {
    let along = line.to - line.from;
    let level = Vector3::Z.cross(along);
    let level = if level.length() > 0.0 { level } else { Vector3::Y };
    match axis {
        0 => Ok(Plane::from_axes(line.from, along, level)?),
        1 => Ok(Plane::from_axes(line.from, -level, along)?),
        2 => Ok(Plane::from_axes(line.from, level, along.cross(level))?),
        _ => Err(Message::error(format!("The axis is {axis}: it is 0, 1 or 2"))),
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Interval, Line, Plane, Point3, Rectangle};

    fn numbers(tree: &katydid_data::Tree) -> Vec<f64> {
        let number = |at: usize| match tree.column().get(at) {
            Some(Value::Number(number)) => Some(number),
            _ => None,
        };
        (0..tree.item_count()).filter_map(number).collect()
    }

    #[test]
    fn domains_grow() {
        let domain = |a: f64, b: f64| Interval::new(a, b);
        let expand = Trial::of("Domain Expand").item(domain(0.0, 2.0)).item(1.0).item(3.0);
        assert_eq!(expand.texts(0), ["{0}: -1 To 5"]);
        let both = |a: f64, b: f64, by: f64| {
            Trial::of("Domain Expand (Symmetric)").item(domain(a, b)).item(by).texts(0)
        };
        assert_eq!(both(0.0, 2.0, 1.0), ["{0}: -1 To 3"]);
        assert_eq!(both(0.0, 2.0, -0.5), ["{0}: 0.5 To 1.5"]);
        assert_eq!(both(2.0, 0.0, 1.0), ["{0}: 3 To -1"]);
        assert_eq!(Trial::of("Domain (Symmetric)").item(4.0).item(1.0).texts(0), ["{0}: -1 To 3"]);
    }

    #[test]
    fn normal_numbers_have_their_mean_and_deviation() {
        let made = Trial::of("Gaussian Random").item(20_000).item(5.0).item(2.0).run();
        let drawn = numbers(&made.outputs[0]);
        let mean = drawn.iter().sum::<f64>() / drawn.len() as f64;
        let variance = drawn.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / drawn.len() as f64;
        // Both to within four standard errors.
        assert!((mean - 5.0).abs() < 4.0 * 2.0 / 20_000_f64.sqrt(), "{mean}");
        assert!((variance - 4.0).abs() < 4.0 * 4.0 * (2.0 / 20_000_f64).sqrt(), "{variance}");
        let within = drawn.iter().filter(|x| (*x - 5.0).abs() < 2.0).count();
        assert!((within as f64 / 20_000.0 - 0.6827).abs() < 0.014, "{within}");
        let negative = Trial::of("Gaussian Random").item(-1).run();
        assert!(negative.messages.iter().any(|m| m.text == "The number is -1: it must not be negative"));
    }

    #[test]
    fn a_range_with_errors() {
        let range = |errancy: f64| {
            Trial::of("Careless Range").item(Interval::new(0.0, 10.0)).item(5).item(errancy).item(3)
        };
        assert_eq!(range(0.0).texts(0), ["{0;0}: 0, 2, 4, 6, 8, 10"]);
        assert_eq!(texts(&range(0.0).run().outputs[1])[0].split(", ").next(), Some("{0;0}: 0 To 2"));
        let drawn = numbers(&range(1.0).run().outputs[0]);
        assert_eq!((drawn[0], drawn[5]), (0.0, 10.0));
        for (place, number) in drawn.iter().enumerate().take(5).skip(1) {
            assert!((number - 2.0 * place as f64).abs() <= 1.0, "{number}");
        }
        assert!(range(2.0).message().starts_with("The errancy is 2"));
        let none = Trial::of("Careless Range").item(Interval::new(0.0, 1.0)).item(0).message();
        assert_eq!(none, "Steps is 0: it must be at least 1");
    }

    #[test]
    fn items_are_drawn() {
        let draw = |seed: i32| Trial::of("Dice").list(["a", "b", "c"]).item(300).item(seed).run();
        let drawn = draw(1);
        let (items, places) = (&texts(&drawn.outputs[0])[0], &texts(&drawn.outputs[1])[0]);
        for (item, place) in [("a", "0"), ("b", "1"), ("c", "2")] {
            let counted = |text: &str, of: &str| {
                let list = text.split_once(": ").unwrap().1;
                list.split(", ").filter(|word| *word == of).count()
            };
            assert_eq!(counted(items, item), counted(places, place));
            assert!((60..140).contains(&counted(items, item)), "{item}");
        }
        assert_ne!(drawn.outputs[1], draw(2).outputs[1]);
    }

    #[test]
    fn places() {
        let line = Line::new(Point3::new(1.0, 0.0, 0.0), Point3::new(4.0, 4.0, 0.0));
        assert_eq!(Trial::of("Center").item(line).texts(0), ["{0}: {2.5, 2, 0}"]);
        assert_eq!(Trial::of("Center").item(line).texts(1), ["{0}: 5"]);
        let sheet = Rectangle { plane: Plane::XY, x: Interval::new(1.0, 3.0), y: Interval::new(0.0, 4.0) };
        let at = Trial::of("Evaluate Rectangle").item(sheet).item(0.5).item(0.25);
        assert_eq!(at.texts(0), ["{0}: {2, 1, 0}"]);
    }

    #[test]
    fn planes_have_the_line_as_an_axis() {
        let line = Line::new(Point3::new(1.0, 2.0, 3.0), Point3::new(1.0, 5.0, 7.0));
        let along = (line.to - line.from).unitized().unwrap();
        for axis in 0..3 {
            let made = Trial::of("Plane By Line").item(line).item(axis).run().outputs[0].column().get(0);
            let Some(Value::Plane(plane)) = made else { panic!("a plane") };
            let own = [plane.x_axis, plane.y_axis, plane.z_axis][usize::try_from(axis).unwrap()];
            assert!((own - along).length() < 1e-12, "{axis}");
            assert_eq!(plane.origin, line.from);
        }
        assert_eq!(Trial::of("Plane By Line").item(line).item(3).message(), "The axis is 3: it is 0, 1 or 2");
    }
}
