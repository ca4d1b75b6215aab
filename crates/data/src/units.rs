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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_known_in_either_spelling() {
        assert!(ALL.into_iter().all(|units| named(units.name()) == Some(units)));
        assert_eq!(named(" MILLIMETRES "), Some(Units::Millimeters));
        assert_eq!(named("Metres"), Some(Units::Meters));
        assert_eq!(named("Parsecs"), None);
        assert_eq!(named(""), None);
    }
}
