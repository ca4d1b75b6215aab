//! Lengths that are written in words.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::units::metres;
use katydid_geometry::Units;

/// The signs of units, longer ones before those they begin with.
const SIGNS: [(&str, Units); 27] = [
    ("millimeters", Units::Millimeters),
    ("millimetres", Units::Millimeters),
    ("centimeters", Units::Centimeters),
    ("centimetres", Units::Centimeters),
    ("kilometers", Units::Kilometers),
    ("kilometres", Units::Kilometers),
    ("meters", Units::Meters),
    ("metres", Units::Meters),
    ("meter", Units::Meters),
    ("metre", Units::Meters),
    ("inches", Units::Inches),
    ("inch", Units::Inches),
    ("miles", Units::Miles),
    ("mile", Units::Miles),
    ("yards", Units::Yards),
    ("yard", Units::Yards),
    ("feet", Units::Feet),
    ("foot", Units::Feet),
    ("mm", Units::Millimeters),
    ("cm", Units::Centimeters),
    ("km", Units::Kilometers),
    ("in", Units::Inches),
    ("ft", Units::Feet),
    ("yd", Units::Yards),
    ("m", Units::Meters),
    ("'", Units::Feet),
    ("\"", Units::Inches),
];

/// A length in metres; parts without a unit are in `unit`. Parts stand one behind the other: `5'-10 1/2"`.
fn length(text: &str, unit: Units) -> Option<f64> {
    let small = text.trim().to_lowercase().replace(['’', '′'], "'").replace(['”', '″'], "\"");
    let (sign, mut rest) = match small.strip_prefix('-') {
        Some(rest) => (-1.0, rest.trim_start()),
        None => (1.0, small.as_str()),
    };
    let mut sum = 0.0;
    loop {
        let (value, behind) = number(rest)?;
        let (unit, behind) = sign_of(behind.trim_start()).unwrap_or((unit, behind));
        sum += value * metres(unit);
        // Between the parts a dash is no minus.
        rest = behind.trim_start().trim_start_matches('-').trim_start();
        if rest.is_empty() {
            return Some(sign * sum).filter(|sum| sum.is_finite());
        }
    }
}

fn sign_of(text: &str) -> Option<(Units, &str)> {
    SIGNS.iter().find_map(|(sign, unit)| text.strip_prefix(sign).map(|rest| (*unit, rest)))
}

/// A number at the start of a text, and what follows it: `10`, `10.5`, `1/2`, `10 1/2` or `10-1/2`.
fn number(text: &str) -> Option<(f64, &str)> {
    let (first, rest) = digits(text)?;
    if let Some((second, rest)) = rest.strip_prefix('/').and_then(digits) {
        return (second != 0.0).then(|| (first / second, rest));
    }
    let between = rest.trim_start_matches([' ', '-']);
    let fraction = digits(between).and_then(|(over, rest)| {
        let (under, rest) = digits(rest.strip_prefix('/')?)?;
        (under != 0.0).then(|| (over / under, rest))
    });
    match fraction {
        Some((fraction, behind)) if between.len() < rest.len() => Some((first + fraction, behind)),
        _ => Some((first, rest)),
    }
}

fn digits(text: &str) -> Option<(f64, &str)> {
    let end = text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
    let (digits, rest) = text.split_at(end);
    Some((digits.parse().ok()?, rest))
}

/// The number of units of the model that a text such as `5'-10 1/2"`, `3.5 m` or `120cm` says. A number without a unit is one of the
/// model's. The units are those of the Rhino model, else those of the definition. Stands for Human's Convert
/// To Document Units.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd316",
    name = "Convert To Document Units",
    nick = "DocUnits",
    at = "Human/Misc"
)]
#[output("Value in Document Units", "V", "The length.")]
fn document_units(
    context: &Context<'_>,
    /// The length in words.
    #[port("Value string", "V")]
    text: Shared<str>,
) -> Result<f64, Message> {
    let unit = units(context);
    let length = length(&text, unit).ok_or_else(|| Message::error(format!("{text} is no length")))?;
    Ok(length / metres(unit))
}

/// The units of the model.
fn units(context: &Context<'_>) -> Units {
    context.model().map_or(context.rules().units, |model| model.units)
}

#[cfg(test)]
mod tests {
    use katydid_3dm::Model;
    use katydid_component::RhinoModel;
    use katydid_component::testing::Trial;
    use katydid_geometry::Units;

    fn of(text: &str, units: Units) -> Trial {
        let model = Model { units, ..Model::default() };
        Trial::of("Convert To Document Units").item(text).model(RhinoModel::new(model))
    }

    #[test]
    fn lengths_in_words() {
        let inches = |text: &str| of(text, Units::Inches).texts(0);
        assert_eq!(inches("5'-10\""), ["{0}: 70"]);
        assert_eq!(inches("5' 10 1/2\""), ["{0}: 70.5"]);
        assert_eq!(inches("5'-10-1/2\""), ["{0}: 70.5"]);
        assert_eq!(inches("1/2 in"), ["{0}: 0.5"]);
        assert_eq!(inches("-2 feet"), ["{0}: -24"]);
        assert_eq!(inches("7"), ["{0}: 7"]);
        assert_eq!(of("1.5 m", Units::Millimeters).texts(0), ["{0}: 1500"]);
        assert_eq!(of("120cm", Units::Meters).texts(0), ["{0}: 1.2"]);
    }

    #[test]
    fn what_is_no_length() {
        for text in ["", "long", "5 parsecs", "1/0 m", "-"] {
            assert_eq!(of(text, Units::Meters).message(), format!("{text} is no length"));
        }
    }
}
