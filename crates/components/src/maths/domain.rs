//! Maths / Domain.

use katydid_component::{Context, List, Message, component};
use katydid_data::Domain2;
use katydid_geometry::{Interval, Point3};

/// The smallest range that holds all numbers; none without numbers.
fn range(numbers: impl IntoIterator<Item = f64>) -> Option<Interval> {
    let mut numbers = numbers.into_iter().filter(|x| !x.is_nan());
    let first = numbers.next()?;
    let (min, max) = numbers.fold((first, first), |(min, max), x| (x.min(min), x.max(max)));
    Some(Interval::new(min, max))
}

/// A number of pieces, 1 or more.
fn pieces(n: i32) -> Result<usize, Message> {
    match usize::try_from(n) {
        Ok(n) if n > 0 => Ok(n),
        _ => Err(Message::error(format!("{n} pieces cannot be made: there must be at least one"))),
    }
}

/// Piece `i` of `n` equal ones.
fn piece(domain: Interval, i: usize, n: usize) -> Interval {
    let at = |i: usize| domain.at(i as f64 / n as f64);
    Interval::new(at(i), at(i + 1))
}

/// The smallest range that holds a list of numbers. Nulls are skipped; an empty list has no range.
#[component("f44b92b0-3b5b-493a-86f4-fd7408c3daf3", name = "Bounds", nick = "Bnd", at = "Maths/Domain")]
#[output("Domain", "I", "From the smallest number to the largest.")]
fn bounds(
    /// The numbers.
    #[port("Numbers", "N")]
    numbers: List<f64>,
) -> Option<Interval> {
    match numbers.as_slice() {
        Some(numbers) => range(numbers.iter().copied()),
        None => range(numbers.present()),
    }
}

/// The smallest ranges of x and y that hold a list of points. Nulls are skipped.
#[component("dd53b24c-003a-4a04-b185-a44d91633cbe", name = "Bounds 2D", nick = "Bnd", at = "Maths/Domain")]
#[output("Domain", "I", "The ranges: u of the x coordinates, v of the y coordinates.")]
fn bounds_2d(
    /// The points.
    #[port("Coordinates", "C")]
    points: List<Point3>,
) -> Option<Domain2> {
    let u = range(points.present().map(|p| p.x))?;
    Some(Domain2 { u, v: range(points.present().map(|p| p.y))? })
}

/// Makes ranges that follow one another from a list of numbers.
///
/// Additive, the numbers are the lengths of the ranges, the first of which begins at 0. Otherwise they are the
/// ends: each range goes from one number to the next.
#[component(
    "95992b33-89e1-4d36-bd35-2754a11af21e",
    name = "Consecutive Domains",
    nick = "Consec",
    at = "Maths/Domain"
)]
#[output("Domains", "D", "The ranges.")]
fn consecutive_domains(
    /// Lengths or ends. Nulls are skipped.
    #[port("Numbers", "N")]
    numbers: List<f64>,
    /// Whether the numbers are lengths.
    #[port("Additive", "A", default = true)]
    additive: bool,
) -> Vec<Interval> {
    if additive {
        let mut end = 0.0;
        let next = |length: f64| {
            let start = end;
            end += length;
            Interval::new(start, end)
        };
        return numbers.present().map(next).collect();
    }
    numbers.present().zip(numbers.present().skip(1)).map(|(a, b)| Interval::new(a, b)).collect()
}

/// Makes a range of two numbers. The start may be larger than the end: then the range runs down.
#[component(
    "d1a28e95-cf96-4936-bf34-8bf142d731bf",
    name = "Construct Domain",
    nick = "Dom",
    at = "Maths/Domain"
)]
#[output("Domain", "I", "The range.")]
fn construct_domain(
    /// Where the range starts.
    #[port("Domain start", "A", default = 0.0)]
    start: f64,
    /// Where it ends.
    #[port("Domain end", "B", default = 1.0)]
    end: f64,
) -> Interval {
    Interval::new(start, end)
}

/// Makes a range in two directions of four numbers.
#[component(
    "9083b87f-a98c-4e41-9591-077ae4220b19",
    name = "Construct Domain²",
    nick = "Dom²Num",
    at = "Maths/Domain"
)]
#[output("2D Domain", "I²", "The range in u and v.")]
fn construct_domain2_of_numbers(
    /// Where u starts.
    #[port("U min", "U0", default = 0.0)]
    u0: f64,
    /// Where u ends.
    #[port("U max", "U1", default = 1.0)]
    u1: f64,
    /// Where v starts.
    #[port("V min", "V0", default = 0.0)]
    v0: f64,
    /// Where v ends.
    #[port("V max", "V1", default = 1.0)]
    v1: f64,
) -> Domain2 {
    Domain2 { u: Interval::new(u0, u1), v: Interval::new(v0, v1) }
}

/// Makes a range in two directions of two ranges.
#[component(
    "8555a743-36c1-42b8-abcc-06d9cb94519f",
    name = "Construct Domain²",
    nick = "Dom²",
    at = "Maths/Domain"
)]
#[output("2D Domain", "I²", "The range in u and v.")]
fn construct_domain2(
    /// The range of u.
    #[port("Domain U", "U", default = Interval::UNIT)]
    u: Interval,
    /// The range of v.
    #[port("Domain V", "V", default = Interval::UNIT)]
    v: Interval,
) -> Domain2 {
    Domain2 { u, v }
}

/// The two ends of a range, in the direction it runs.
#[component(
    "825ea536-aebb-41e9-af32-8baeb2ecb590",
    name = "Deconstruct Domain",
    nick = "DeDomain",
    at = "Maths/Domain"
)]
#[output("Start", "S", "Where it starts.")]
#[output("End", "E", "Where it ends.")]
fn deconstruct_domain(
    /// The range.
    #[port("Domain", "I")]
    domain: Interval,
) -> (f64, f64) {
    (domain.start, domain.end)
}

/// The four ends of a range in two directions.
#[component(
    "47c30f9d-b685-4d4d-9b20-5b60e48d5af8",
    name = "Deconstruct Domain²",
    nick = "DeDom2Num",
    at = "Maths/Domain"
)]
#[output("U min", "U0", "Where u starts.")]
#[output("U max", "U1", "Where u ends.")]
#[output("V min", "V0", "Where v starts.")]
#[output("V max", "V1", "Where v ends.")]
fn deconstruct_domain2_to_numbers(
    /// The range in u and v.
    #[port("Domain", "I")]
    domain: Domain2,
) -> (f64, f64, f64, f64) {
    (domain.u.start, domain.u.end, domain.v.start, domain.v.end)
}

/// The two ranges of a range in two directions.
#[component(
    "f0adfc96-b175-46a6-80c7-2b0ee17395c4",
    name = "Deconstruct Domain²",
    nick = "DeDom2",
    at = "Maths/Domain"
)]
#[output("U component", "U", "The range of u.")]
#[output("V component", "V", "The range of v.")]
fn deconstruct_domain2(
    /// The range in u and v.
    #[port("Domain", "I")]
    domain: Domain2,
) -> (Interval, Interval) {
    (domain.u, domain.v)
}

/// Cuts a range into equal pieces.
#[component(
    "75ef4190-91a2-42d9-a245-32a7162b0384",
    name = "Divide Domain",
    nick = "Div",
    at = "Maths/Domain"
)]
#[output("Segments", "S", "The pieces, in the direction of the range.")]
fn divide_domain(
    context: &Context<'_>,
    /// The range.
    #[port("Domain", "I", default = Interval::UNIT)]
    domain: Interval,
    /// How many pieces, 1 or more.
    #[port("Count", "C", default = 10)]
    count: i32,
) -> Result<Vec<Interval>, Message> {
    let n = pieces(count)?;
    context.items(n)?;
    Ok((0..n).map(|i| piece(domain, i, n)).collect())
}

/// Cuts a range in two directions into equal pieces, those of the same u one after the other.
#[component(
    "75ac008b-1bc2-4edd-b967-667d628b9d24",
    name = "Divide Domain²",
    nick = "Divide",
    at = "Maths/Domain"
)]
#[output("Segments", "S", "The pieces; v changes fastest.")]
fn divide_domain2(
    context: &Context<'_>,
    /// The range in u and v. A surface stands for its own.
    #[port("Domain", "I")]
    domain: Domain2,
    /// How many pieces along u, 1 or more.
    #[port("U Count", "U", default = 10)]
    u_count: i32,
    /// How many pieces along v, 1 or more.
    #[port("V Count", "V", default = 10)]
    v_count: i32,
) -> Result<Vec<Domain2>, Message> {
    let (nu, nv) = (pieces(u_count)?, pieces(v_count)?);
    context.items(nu.saturating_mul(nv))?;
    let cell = |i, j| Domain2 { u: piece(domain.u, i, nu), v: piece(domain.v, j, nv) };
    Ok((0..nu).flat_map(|i| (0..nv).map(move |j| cell(i, j))).collect())
}

/// Finds the first range in a list that holds a number.
#[component("0b5c7fad-0473-41aa-bf52-d7a861dcaa29", name = "Find Domain", nick = "FDom", at = "Maths/Domain")]
#[output("Index", "I", "Which range holds the number; -1 when none does.")]
#[output("Neighbour", "N", "Which range is nearest to the number; -1 for an empty list.")]
fn find_domain(
    /// The ranges.
    #[port("Domains", "D")]
    domains: List<Interval>,
    /// The number.
    #[port("Number", "N")]
    number: f64,
    /// Whether the ends do not belong to a range.
    #[port("Strict", "S", default = false)]
    strict: bool,
) -> (i32, i32) {
    let holds = |d: &Interval| match strict {
        true => d.min() < number && number < d.max(),
        false => d.contains(number),
    };
    let index = |i: usize| i32::try_from(i).unwrap_or(i32::MAX);
    let found = domains.iter().position(|d| d.as_ref().is_some_and(holds)).map_or(-1, index);
    let mut nearest = (f64::INFINITY, found);
    if found < 0 {
        for (i, domain) in domains.iter().enumerate() {
            let away = domain.map_or(f64::INFINITY, |d| (number - d.clamp(number)).abs());
            if away < nearest.0 {
                nearest = (away, index(i));
            }
        }
    }
    (found, nearest.1)
}

/// Whether a number lies in a range, the ends included, and how far outside it lies.
#[component("f217f873-92f1-47ae-ad71-ca3c5a45c3f8", name = "Includes", nick = "Inc", at = "Maths/Domain")]
#[output("Includes", "I", "Whether the number lies in the range.")]
#[output("Deviation", "D", "How far it is from the nearer end; 0 inside.")]
fn includes(
    /// The number.
    #[port("Value", "V")]
    value: f64,
    /// The range.
    #[port("Domain", "D", default = Interval::UNIT)]
    domain: Interval,
) -> (bool, f64) {
    (domain.contains(value), (value - domain.clamp(value)).abs())
}

fn remap(value: f64, source: Interval, target: Interval) -> f64 {
    target.at(source.normalized(value))
}

/// Carries numbers over from one range to another in proportion. Numbers outside the source go outside the target.
#[component(
    "2fcc2743-8339-4cdf-a046-a1f17439191d",
    name = "Remap Numbers",
    nick = "ReMap",
    at = "Maths/Domain",
    also("fa314286-867b-41fa-a7f6-3f474197bb81")
)]
#[output("Mapped", "R", "The number in the target.")]
#[output("Clipped", "C", "The same, at most at the target's ends.")]
fn remap_numbers(
    /// The number.
    #[port("Value", "V")]
    value: f64,
    /// The range it comes from. Either range may run down.
    #[port("Source", "S", default = Interval::UNIT)]
    source: Interval,
    /// The range it goes to.
    #[port("Target", "T", default = Interval::UNIT)]
    target: Interval,
) -> (f64, f64) {
    let mapped = remap(value, source, target);
    (mapped, target.clamp(mapped))
}

/// Carries a list of numbers over from one range to another in proportion. An early form of the component of
/// the same name.
#[component(
    "9624aeeb-f2a1-49da-b1c7-8789db217177",
    name = "Remap Numbers",
    nick = "ReMap",
    at = "Maths/Domain",
    old
)]
#[output("Result", "R", "The numbers in the target.")]
fn remap_list(
    /// The numbers.
    #[port("Values", "V")]
    values: List<f64>,
    /// The range they come from.
    #[port("Source", "S", default = Interval::UNIT)]
    source: Interval,
    /// The range they go to.
    #[port("Target", "T", default = Interval::UNIT)]
    target: Interval,
) -> Vec<Option<f64>> {
    values.iter().map(|value| value.map(|v| remap(v, source, target))).collect()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Point3};

    #[test]
    fn bounds_skip_nulls() {
        assert_eq!(Trial::of("Bounds").gaps([Some(3.0), None, Some(-1.5)]).texts(0), ["{0}: -1.5 To 3"]);
        assert_eq!(Trial::of("Bounds").list([4]).texts(0), ["{0}: 4 To 4"]);
        assert_eq!(Trial::of("Bounds").list([0.0; 0]).texts(0), ["{0}: null"]);
        let points = [Point3::new(1.0, 5.0, 9.0), Point3::new(2.0, 4.0, 9.0)];
        assert_eq!(Trial::of("Bounds 2D").list(points).texts(0), ["{0}: u:{1 To 2} v:{4 To 5}"]);
    }

    #[test]
    fn making_and_taking_apart() {
        assert_eq!(Trial::of("Construct Domain").item("10").item(2).texts(0), ["{0}: 10 To 2"]);
        assert_eq!(Trial::of("Deconstruct Domain").item("10 to 2").texts(0), ["{0}: 10"]);
        let four = Trial::of_guid("9083b87f-a98c-4e41-9591-077ae4220b19").item(1).item(2).item(3).item(4);
        assert_eq!(four.texts(0), ["{0}: u:{1 To 2} v:{3 To 4}"]);
        let two = Trial::of_guid("8555a743-36c1-42b8-abcc-06d9cb94519f").item(5).item("2 to 3");
        assert_eq!(two.texts(0), ["{0}: u:{0 To 5} v:{2 To 3}"]);
        assert_eq!(
            Trial::of_guid("47c30f9d-b685-4d4d-9b20-5b60e48d5af8").item("u:{1 To 2} v:{3 To 4}").texts(3),
            ["{0}: 4"]
        );
        assert_eq!(
            Trial::of_guid("f0adfc96-b175-46a6-80c7-2b0ee17395c4").item("u:{1 To 2} v:{3 To 4}").texts(1),
            ["{0}: 3 To 4"]
        );
        let consecutive = |additive| Trial::of("Consecutive Domains").list([1, 2, 4]).item(additive).texts(0);
        assert_eq!(consecutive(true), ["{0;0}: 0 To 1, 1 To 3, 3 To 7"]);
        assert_eq!(consecutive(false), ["{0;0}: 1 To 2, 2 To 4"]);
    }

    #[test]
    fn dividing() {
        let halves = Trial::of("Divide Domain").item("4 to 0").item(2);
        assert_eq!(halves.texts(0), ["{0;0}: 4 To 2, 2 To 0"]);
        assert!(Trial::of("Divide Domain").item(1).item(0).message().starts_with("0 pieces"));
        let cells = Trial::of("Divide Domain²").item("u:{0 To 1} v:{0 To 2}").item(1).item(2);
        assert_eq!(cells.texts(0), ["{0;0}: u:{0 To 1} v:{0 To 1}, u:{0 To 1} v:{1 To 2}"]);
        let many = Trial::of("Divide Domain²").item("u:{0 To 1} v:{0 To 2}").item(i32::MAX).item(i32::MAX);
        assert!(many.message().contains("items"));
    }

    #[test]
    fn finding() {
        let domains = [Interval::new(0.0, 1.0), Interval::new(5.0, 1.0), Interval::new(9.0, 10.0)];
        let find = |x: f64, strict: bool| {
            let trial = || Trial::of("Find Domain").list(domains).item(x).item(strict);
            format!("{} {}", trial().texts(0).concat(), trial().texts(1).concat()).replace("{0}: ", "")
        };
        assert_eq!([find(1.0, false), find(1.5, true), find(8.0, false)], ["0 0", "1 1", "-1 2"]);
        assert_eq!(find(1.0, true), "-1 0");
        let include = |x: f64| Trial::of("Includes").item(x).item("3 to 1").texts(1).concat();
        assert_eq!([include(1.0), include(0.5), include(4.0)], ["{0}: 0", "{0}: 0.5", "{0}: 1"]);
    }

    #[test]
    fn remapping() {
        let map = |v: f64, s: &str, t: &str, out| {
            Trial::of_guid("2fcc2743-8339-4cdf-a046-a1f17439191d").item(v).item(s).item(t).texts(out).concat()
        };
        assert_eq!(map(5.0, "0 to 10", "20 to 10", 0), "{0}: 15");
        assert_eq!(map(15.0, "0 to 10", "20 to 10", 0), "{0}: 5");
        assert_eq!(map(15.0, "0 to 10", "20 to 10", 1), "{0}: 10");
        assert_eq!(map(7.0, "3 to 3", "0 to 1", 0), "{0}: 3");
        let list = Trial::of_guid("9624aeeb-f2a1-49da-b1c7-8789db217177")
            .gaps([Some(0.5), None])
            .item(1)
            .item("10 to 20");
        assert_eq!(list.texts(0), ["{0;0}: 15, null"]);
    }
}
