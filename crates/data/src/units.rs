//! Units by their names.

use katydid_geometry::Units;

/// The units that a document may have, by the names that Rhino has for them.
pub const ALL: [Units; 10] = [
    Units::None,
    Units::Microns,
    Units::Millimeters,
    Units::Centimeters,
    Units::Meters,
    Units::Kilometers,
    Units::Inches,
    Units::Feet,
    Units::Yards,
    Units::Miles,
];

/// The units of a name, in any case and in either spelling: `Millimeters`, `metres`.
pub fn named(name: &str) -> Option<Units> {
    let name = name.trim().to_lowercase().replace("metre", "meter");
    ALL.into_iter().find(|units| units.name().to_lowercase() == name)
}

/// The length of a unit in metres; that of no unit is taken for one.
pub const fn metres(units: Units) -> f64 {
    match units {
        Units::None | Units::Meters => 1.0,
        Units::Microns => 1e-6,
        Units::Millimeters => 1e-3,
        Units::Centimeters => 1e-2,
        Units::Kilometers => 1e3,
        Units::Inches => 0.0254,
        Units::Feet => 0.3048,
        Units::Yards => 0.9144,
        Units::Miles => 1609.344,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_of_units() {
        // What the lengths are as decimals, no product of doubles is to the last bit.
        let are_one = |a: f64, b: f64| (a - b).abs() <= 2.0 * f64::EPSILON * b;
        assert!(are_one(1760.0 * metres(Units::Yards), metres(Units::Miles)));
        assert!(are_one(3.0 * metres(Units::Feet), metres(Units::Yards)));
        assert!(are_one(12.0 * metres(Units::Inches), metres(Units::Feet)));
    }

    #[test]
    fn units_are_known_in_either_spelling() {
        assert!(ALL.into_iter().all(|units| named(units.name()) == Some(units)));
        assert_eq!(named(" MILLIMETRES "), Some(Units::Millimeters));
        assert_eq!(named("Metres"), Some(Units::Meters));
        assert_eq!(named("Parsecs"), None);
        assert_eq!(named(""), None);
    }
}
