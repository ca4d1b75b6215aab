//! Colours, vectors, sets of points and numbers, and items by their places.

use katydid_component::{Context, List, Message, component};
use katydid_data::{Colour, Value};
use katydid_geometry::{Curve, Interval, Plane, Point3, Vector3};

/// The finite points of a set.
///
/// # Errors
/// There are none, or one is not finite.
fn checked(points: &List<'_, Point3>) -> Result<Vec<Point3>, Message> {
    let points: Vec<Point3> = points.present().collect();
    match points.iter().find(|p| !p.is_finite()) {
        Some(_) => Err(Message::error("A point is not finite")),
        None if points.is_empty() => Err(Message::error("There are no points")),
        None => Ok(points),
    }
}

/// Whether points lie on one line, within the tolerance of the document. Stands for Pufferfish's Are Points Collinear.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3071",
    name = "Are Points Collinear",
    nick = "PtsCoLinr",
    at = "Pufferfish/Point"
)]
#[output("Collinear", "C", "Whether they do; so do one point and two.")]
fn are_collinear(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<bool, Message> {
    let points = checked(&points)?;
    let first = points.first().copied().unwrap_or(Point3::ORIGIN);
    let away = |p: &Point3| *p - first;
    let far =
        points.iter().map(away).fold(Vector3::ZERO, |far, v| if v.length() > far.length() { v } else { far });
    let Some(along) = far.unitized() else { return Ok(true) };
    Ok(points.iter().all(|p| away(p).cross(along).length() <= context.tolerance().absolute))
}

/// Whether points lie in one plane, within the tolerance of the document. Stands for Pufferfish's Are Points Coplanar.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3072",
    name = "Are Points Coplanar",
    nick = "PtsCoPlnr",
    at = "Pufferfish/Point"
)]
#[output("Coplanar", "C", "Whether they do; so do points of one line.")]
fn are_coplanar(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<bool, Message> {
    // Points that no plane fits best are few, or lie on one line.
    Ok(Plane::fit(&checked(&points)?)
        .map_or(true, |(_, deviation)| deviation <= context.tolerance().absolute))
}

/// The point with red, green and blue of a colour for its coordinates, 0 to 255 each. Stands for Pufferfish's Color To Point.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3073",
    name = "Color To Point",
    nick = "Col2Pt",
    at = "Pufferfish/Color"
)]
#[output("Point", "P", "The point.")]
#[output("Alpha", "a", "How opaque the colour is, 0 to 255.")]
fn color_to_point(
    /// The colour.
    #[port("Color", "Cl")]
    colour: Colour,
) -> (Point3, i32) {
    let [x, y, z] = [colour.r, colour.g, colour.b].map(f64::from);
    (Point3::new(x, y, z), i32::from(colour.a))
}

/// The opposite of a colour: each channel becomes what it lacks of 255. Stands for Pufferfish's Invert Color.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3074",
    name = "Invert Color",
    nick = "InvCol",
    at = "Pufferfish/Color"
)]
#[output("Inverted", "I", "The opposite.")]
fn invert_color(
    /// The colour.
    #[port("Color", "Cl")]
    colour: Colour,
    /// Whether what is opaque becomes transparent, too.
    #[port("Alpha", "a", default = false)]
    alpha: bool,
) -> Colour {
    let a = if alpha { 255 - colour.a } else { colour.a };
    Colour { a, r: 255 - colour.r, g: 255 - colour.g, b: 255 - colour.b }
}

/// How much red, green and blue count in a grey, by the number of the scheme.
const LUMINOSITIES: [[f64; 3]; 4] =
    [[0.2989, 0.5870, 0.1140], [0.2627, 0.6780, 0.0593], [0.2126, 0.7152, 0.0722], [1.0 / 3.0; 3]];

/// The grey that is as light as a colour. Stands for Pufferfish's Grayscale Color.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3075",
    name = "Grayscale Color",
    nick = "GrayCol",
    at = "Pufferfish/Color"
)]
#[output("Grayscaled", "G", "The grey.")]
fn grayscale_color(
    /// The colour.
    #[port("Color", "Cl")]
    colour: Colour,
    /// How much red, green and blue count: 0 as television had it (0.2989, 0.587, 0.114), 1 as in Rec. 2020 (0.2627, 0.678, 0.0593), 2
    /// as in Rec. 709 (0.2126, 0.7152, 0.0722), 3 all the same.
    #[port("Luminosity Type", "L", default = 0)]
    scheme: i32,
    /// Whether the grey is opaque, whatever the colour is.
    #[port("Alpha", "a", default = false)]
    opaque: bool,
) -> Result<Colour, Message> {
    let shares = usize::try_from(scheme).ok().and_then(|scheme| LUMINOSITIES.get(scheme));
    let Some([r, g, b]) = shares else {
        return Err(Message::error(format!("The luminosity type is {scheme}: it must be from 0 to 3")));
    };
    let light = r * f64::from(colour.r) + g * f64::from(colour.g) + b * f64::from(colour.b);
    let grey = light.round().clamp(0.0, 255.0) as u8;
    Ok(Colour { a: if opaque { 255 } else { colour.a }, r: grey, g: grey, b: grey })
}

/// The vector of a set that has the smallest angle to another one, of several the first; vectors without length do not count. Stands
/// for Pufferfish's Closest Vector.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3076",
    name = "Closest Vector",
    nick = "ClsstVec",
    at = "Pufferfish/Vector"
)]
#[output("Closest", "C", "The vector.")]
#[output("Index", "i", "Its place in the set, from 0.")]
#[output("Angle", "A", "The angle, in radians.")]
fn closest_vector(
    /// The vector that it is close to.
    #[port("Reference", "R")]
    reference: Vector3,
    /// The set.
    #[port("Targets", "T")]
    targets: List<Vector3>,
    /// Whether the result has the length of the reference.
    #[port("Keep Length", "K", default = false)]
    keep: bool,
) -> Result<(Vector3, i32, f64), Message> {
    let mut best: Option<(usize, Vector3, f64)> = None;
    for (place, target) in targets.iter().enumerate() {
        let Some((target, angle)) = target.and_then(|v| Some((v, reference.angle_to(v)?))) else { continue };
        if best.is_none_or(|(_, _, least)| angle < least) {
            best = Some((place, target, angle));
        }
    }
    let (place, vector, angle) = best.ok_or_else(|| Message::error("No two vectors have lengths"))?;
    let vector = if keep { vector * (reference.length() / vector.length()) } else { vector };
    Ok((vector, i32::try_from(place).unwrap_or(i32::MAX), angle))
}

/// The items of a list at some places, in the order of the places, and the others in their own order. Stands for Pufferfish's Dispatch
/// Indices.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3077",
    name = "Dispatch Indices",
    nick = "DispDexs",
    at = "Pufferfish/List"
)]
#[output("At i", "i=", "The items at the places.")]
#[output("Not i", "i≠", "The other items.")]
fn dispatch_indices(
    context: &Context<'_>,
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
    /// The places, from 0.
    #[port("Indices", "i")]
    places: List<i32>,
) -> Result<(Vec<Option<Value>>, Vec<Option<Value>>), Message> {
    context.items(list.len().saturating_add(places.len()))?;
    let mut taken = vec![false; list.len()];
    let mut at = Vec::with_capacity(places.len());
    for place in places.present() {
        match usize::try_from(place).ok().and_then(|k| Some((k, taken.get_mut(k)?))) {
            Some((k, slot)) => {
                *slot = true;
                at.push(list.get(k));
            }
            None => context.warn(format!("The list has no item {place}: there are {}", list.len())),
        }
    }
    let rest = list.iter().zip(taken).filter(|(_, taken)| !taken).map(|(item, _)| item).collect();
    Ok((at, rest))
}

/// The lengths of a curve from each of some points on it to the next, whatever the direction. Stands for Pufferfish's Curve Length
/// Between; that points keep their order is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3078",
    name = "Curve Length Between",
    nick = "CrvLenBtwn",
    at = "Pufferfish/Curve"
)]
#[output("Lengths", "L", "The lengths, one less than points.")]
#[output("Parameters", "t", "The parameters of the points.")]
fn length_between(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The points; the nearest of the curve count.
    #[port("Points", "P", optional)]
    points: List<Point3>,
    /// The parameters; where there are any, points do not count.
    #[port("Parameters", "t", optional)]
    parameters: List<f64>,
    /// Whether lengths are parts of the whole one.
    #[port("Normalized", "N", default = false)]
    normalized: bool,
) -> Result<(Vec<f64>, Vec<f64>), Message> {
    context.items(points.len().saturating_add(parameters.len()).saturating_mul(2))?;
    let domain = curve.domain();
    let given: Vec<f64> = parameters.present().collect();
    let found = if given.is_empty() {
        let parameter = |p: Point3| -> Result<f64, Message> { Ok(curve.closest_point(p)?.parameter) };
        points.present().map(parameter).collect::<Result<Vec<f64>, Message>>()?
    } else if given.iter().all(|t| t.is_finite()) {
        given.into_iter().map(|t| domain.clamp(t)).collect()
    } else {
        return Err(Message::error("A parameter is not finite"));
    };
    let whole = if normalized { curve.length() } else { 1.0 };
    let between = |(a, b): (&f64, &f64)| curve.length_between(Interval::new(a.min(*b), a.max(*b))) / whole;
    Ok((found.iter().zip(found.iter().skip(1)).map(between).collect(), found))
}

/// Numbers that go up and down turned into such as only go up: each stands as far from the one before as it did, and the first and the
/// last are carried to the ends of a domain. Stands for Pufferfish's Linearize Numbers.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3079",
    name = "Linearize Numbers",
    nick = "LinearNums",
    at = "Pufferfish/Number"
)]
#[output("Linearized", "L", "The numbers; all at the start of the domain where they are all the same.")]
#[output(
    "Actual",
    "A",
    "The domain of the numbers before they are carried: from the first on, as far as all steps together."
)]
#[output("Original", "O", "The domain of the numbers as they came.")]
fn linearize_numbers(
    context: &Context<'_>,
    /// The numbers.
    #[port("Numbers", "N")]
    numbers: List<f64>,
    /// The domain.
    #[port("Domain", "I", default = Interval::UNIT)]
    domain: Interval,
) -> Result<(Vec<f64>, Interval, Interval), Message> {
    context.items(numbers.len())?;
    let numbers: Vec<f64> = numbers.present().collect();
    let first = numbers.first().copied().ok_or_else(|| Message::error("There are no numbers"))?;
    if !numbers.iter().all(|x| x.is_finite()) {
        return Err(Message::error("A number is not finite"));
    }
    let mut sums = vec![0.0];
    for (a, b) in numbers.iter().zip(numbers.iter().skip(1)) {
        sums.push(sums.last().copied().unwrap_or(0.0) + (b - a).abs());
    }
    let total = sums.last().copied().unwrap_or(0.0);
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let most = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let at = |sum: f64| domain.at(if total > 0.0 { sum / total } else { 0.0 });
    Ok((sums.into_iter().map(at).collect(), Interval::new(first, first + total), Interval::new(least, most)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Colour, Value};
    use katydid_geometry::{Interval, Line, Point3, Vector3};

    fn truth(trial: Trial) -> bool {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Boolean(truth)) => truth,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn points_on_a_line_and_in_a_plane() {
        let points = |places: &[[f64; 3]]| -> Vec<Point3> {
            places.iter().map(|[x, y, z]| Point3::new(*x, *y, *z)).collect()
        };
        let line = points(&[[0.0; 3], [2.0; 3], [1.0; 3]]);
        let flat = points(&[[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 3.0, 1.0], [2.0, 2.0, 1.0]]);
        let solid = points(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 2.0]]);
        let of = |name: &str, set: &[Point3]| truth(Trial::of(name).list(set.to_vec()));
        let answers = [&line, &flat, &solid]
            .map(|set| (of("Are Points Collinear", set), of("Are Points Coplanar", set)));
        assert_eq!(answers, [(true, true), (false, true), (false, false)]);
        assert!(of("Are Points Collinear", &line[..1]) && of("Are Points Coplanar", &flat[..2]));
        for name in ["Are Points Collinear", "Are Points Coplanar"] {
            assert_eq!(
                Trial::of(name).item(Point3::new(f64::NAN, 0.0, 0.0)).message(),
                "A point is not finite"
            );
            let none: [Option<Point3>; 1] = [None];
            assert_eq!(Trial::of(name).gaps(none).message(), "There are no points");
        }
    }

    #[test]
    fn colours_are_changed() {
        let colour = Colour::argb(200, 255, 10, 0);
        let point = |k: usize| Trial::of("Color To Point").item(colour).texts(k);
        assert_eq!((point(0), point(1)), (vec!["{0}: {255, 10, 0}".into()], vec!["{0}: 200".into()]));
        let inverted = |alpha: bool| {
            let trial = Trial::of_guid("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3074").item(colour).item(alpha);
            trial.run().outputs[0].column().get(0)
        };
        assert_eq!(inverted(false), Some(Value::Colour(Colour::argb(200, 0, 245, 255))));
        assert_eq!(inverted(true), Some(Value::Colour(Colour::argb(55, 0, 245, 255))));
        let grey = |scheme: i32| Trial::of("Grayscale Color").item(Colour::rgb(255, 0, 0)).item(scheme);
        assert_eq!(
            [0, 1, 2, 3].map(|scheme| grey(scheme).texts(0)[0].clone()),
            ["{0}: 76,76,76", "{0}: 67,67,67", "{0}: 54,54,54", "{0}: 85,85,85"]
        );
        assert!(grey(4).message().contains("from 0 to 3") && grey(-1).message().contains("from 0 to 3"));
        let opaque = Trial::of("Grayscale Color").item(colour).default().item(true);
        assert!(
            matches!(opaque.run().outputs[0].column().get(0), Some(Value::Colour(grey)) if grey.a == 255)
        );
    }

    #[test]
    fn the_vector_of_the_smallest_angle() {
        let targets = [Vector3::ZERO, Vector3::Y, Vector3::new(5.0, 5.0, 0.0), -Vector3::X];
        let trial = |keep: bool| {
            Trial::of("Closest Vector").item(Vector3::new(2.0, 0.0, 0.0)).list(targets).item(keep)
        };
        assert_eq!(trial(false).texts(0), ["{0}: {5, 5, 0}"]);
        assert_eq!(trial(false).texts(1), ["{0}: 2"]);
        assert_eq!(trial(false).texts(2), ["{0}: 0.785398"]);
        assert_eq!(trial(true).texts(0), ["{0}: {1.414214, 1.414214, 0}"]);
        let none = Trial::of("Closest Vector").item(Vector3::X).item(Vector3::ZERO);
        assert_eq!(none.message(), "No two vectors have lengths");
    }

    #[test]
    fn items_by_their_places() {
        let trial = |places: [i32; 2]| Trial::of("Dispatch Indices").list(["a", "b", "c", "d"]).list(places);
        assert_eq!(trial([3, 1]).texts(0), ["{0}: d, b"]);
        assert_eq!(trial([3, 1]).texts(1), ["{0}: a, c"]);
        assert_eq!(trial([4, -1]).texts(1), ["{0}: a, b, c, d"]);
        assert!(trial([0, 4]).message().contains("no item 4"));
    }

    #[test]
    fn lengths_from_point_to_point() {
        let line = || Line::new(Point3::ORIGIN, Point3::new(10.0, 0.0, 0.0));
        let places = [1.0, 4.0, 2.0].map(|x| Point3::new(x, 5.0, 0.0));
        let trial = |normalized: bool| {
            Trial::of("Curve Length Between").item(line()).list(places).default().item(normalized)
        };
        assert_eq!(trial(false).texts(0), ["{0;0}: 3, 2"]);
        assert_eq!(trial(true).texts(0), ["{0;0}: 0.3, 0.2"]);
        assert_eq!(trial(false).texts(1).len(), 1);
        let none = Trial::of("Curve Length Between").item(line());
        assert_eq!(none.run().outputs[0].item_count(), 0);
        let broken = Trial::of("Curve Length Between").item(line()).default().list([f64::NAN]);
        assert_eq!(broken.message(), "A parameter is not finite");
    }

    #[test]
    fn waves_become_steps() {
        let trial = |numbers: &[f64]| {
            Trial::of("Linearize Numbers").list(numbers.to_vec()).item(Interval::new(0.0, 10.0))
        };
        let wave = [1.0, 3.0, 0.0, 0.0];
        assert_eq!(trial(&wave).texts(0), ["{0;0}: 0, 4, 10, 10"]);
        assert_eq!(trial(&wave).texts(1), ["{0}: 1 To 6"]);
        assert_eq!(trial(&wave).texts(2), ["{0}: 0 To 3"]);
        assert_eq!(trial(&[7.0, 7.0]).texts(0), ["{0;0}: 0, 0"]);
        assert_eq!(trial(&[f64::INFINITY]).message(), "A number is not finite");
    }
}
