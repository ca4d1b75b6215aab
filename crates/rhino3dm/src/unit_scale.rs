//! Length units and tolerances as archives state them (section 5).

use katydid_geometry::{Tolerance, Units};

use crate::Result;
use crate::chunk::{Reader, Writer};

/// A length unit outside those the kernel has names for.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitScale {
    /// Its number in archives.
    pub number: i32,
    /// Its name.
    pub name: String,
    /// Its length in metres.
    pub metres: f64,
}

/// Unit number, unit, metres per unit. The units the kernel has names for.
const UNITS: &[(i32, Units, f64)] = &[
    (0, Units::None, 1.0),
    (1, Units::Microns, 1e-6),
    (2, Units::Millimeters, 1e-3),
    (3, Units::Centimeters, 1e-2),
    (4, Units::Meters, 1.0),
    (5, Units::Kilometers, 1e3),
    (8, Units::Inches, 0.0254),
    (9, Units::Feet, 0.3048),
    (10, Units::Miles, 1609.344),
    (19, Units::Yards, 0.9144),
];

/// Units the kernel has no name for: number, name, metres per unit.
const OTHER_UNITS: &[(i32, &str, f64)] = &[
    (6, "microinches", 2.54e-8),
    (7, "mils", 2.54e-5),
    (11, "a custom unit", 1.0),
    (12, "angstroms", 1e-10),
    (13, "nanometers", 1e-9),
    (14, "decimeters", 1e-1),
    (15, "dekameters", 1e1),
    (16, "hectometers", 1e2),
    (17, "megameters", 1e6),
    (18, "gigameters", 1e9),
    (20, "printer points", 0.0254 / 72.0),
    (21, "printer picas", 0.0254 / 6.0),
    (22, "nautical miles", 1852.0),
    (23, "astronomical units", 1.495_978_707e11),
    (24, "light years", 9.460_730_472_580_8e15),
    (25, "parsecs", 3.085_677_58e16),
];

const WHAT: &str = "units";
const CUSTOM: i32 = 11;

/// Units and tolerances as a file states them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StoredUnits {
    pub(crate) units: Units,
    pub(crate) scale: Option<UnitScale>,
    pub(crate) tolerance: Tolerance,
    pub(crate) relative_tolerance: f64,
    /// How lengths are shown, and with how many digits.
    pub(crate) display: [i32; 2],
    /// The absolute and the angle tolerance, where one of them cannot be any.
    pub(crate) impossible: Option<[f64; 2]>,
}

/// Reads the body of a units record.
pub(crate) fn read_units(mut body: Reader<'_>) -> Result<StoredUnits> {
    let stored = read_stored_units(&mut body)?;
    body.finish();
    Ok(stored)
}

/// Reads units and tolerances inside of something else.
pub(crate) fn read_stored_units(body: &mut Reader<'_>) -> Result<StoredUnits> {
    let version = body.i32(WHAT)?;
    let number = body.i32(WHAT)?;
    let tolerances = [body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?];
    let mut display = [0, 3];
    if version >= 101 {
        display = [body.i32("length display")?, body.i32("length digits")?];
    }
    let mut custom = None;
    if version >= 102 {
        custom = Some((body.f64(WHAT)?, body.string("unit name")?));
    }
    Ok(StoredUnits { display, ..stored_units(number, tolerances, custom) })
}

/// Units by their number, absolute, angle and relative tolerance, and what a custom unit is in metres and called.
pub(crate) fn stored_units(
    number: i32,
    [absolute, angle, relative_tolerance]: [f64; 3],
    custom: Option<(f64, String)>,
) -> StoredUnits {
    let mut tolerance = Tolerance::default();
    // Tolerances that cannot be any are left at the default.
    if absolute.is_finite() && absolute > 0.0 {
        tolerance.absolute = absolute;
    }
    if angle.is_finite() && angle > 0.0 {
        tolerance.angle = angle;
    }
    let (units, scale) = match UNITS.iter().find(|(known, ..)| *known == number) {
        Some((_, units, _)) => (*units, None),
        None => {
            let other = OTHER_UNITS.iter().find(|(known, ..)| *known == number);
            let (name, metres) = other.map_or(("an unknown unit", 1.0), |(_, name, metres)| (*name, *metres));
            let custom = custom.filter(|(metres, _)| number == CUSTOM && metres.is_finite() && *metres > 0.0);
            let (metres, name) = custom.map_or((metres, name.to_owned()), |(metres, own)| {
                (metres, if own.is_empty() { name.to_owned() } else { own })
            });
            (Units::None, Some(UnitScale { number, name, metres }))
        }
    };
    let kept = [tolerance.absolute, tolerance.angle] == [absolute, angle];
    let impossible = (!kept && absolute.is_finite() && angle.is_finite()).then_some([absolute, angle]);
    StoredUnits { units, scale, tolerance, relative_tolerance, display: [0, 3], impossible }
}

/// The number of a unit in archives, and its length in metres.
pub(crate) fn unit_number(units: Units) -> (i32, f64) {
    let known = UNITS.iter().find(|(_, known, _)| *known == units);
    known.map_or((0, 1.0), |(number, _, metres)| (*number, *metres))
}

/// Writes the body of a units record.
pub(crate) fn write_units(stored: &StoredUnits, w: &mut Writer) -> Result<()> {
    let (mut number, mut metres) = unit_number(stored.units);
    let mut name = "";
    if let Some(scale) = &stored.scale {
        (number, metres) = (scale.number, scale.metres);
        if number == CUSTOM {
            name = &scale.name;
        }
    }
    w.i32(102);
    w.i32(number);
    let default = Tolerance::default();
    let [absolute, angle] = stored.impossible.unwrap_or([f64::NAN; 2]);
    for (ours, theirs, default) in [
        (stored.tolerance.absolute, absolute, default.absolute),
        (stored.tolerance.angle, angle, default.angle),
    ] {
        w.f64(if ours == default && theirs.is_finite() { theirs } else { ours });
    }
    w.f64(stored.relative_tolerance);
    stored.display.iter().for_each(|number| w.i32(*number));
    w.f64(metres);
    w.string(name)
}

/// The length in metres of a unit by its number in archives, when it has one.
pub(crate) fn unit_metres(number: i32) -> Option<f64> {
    // No unit at all and one of somebody's own have none.
    if number == 0 || number == CUSTOM {
        return None;
    }
    let known = UNITS.iter().map(|(known, _, metres)| (*known, *metres));
    let all = known.chain(OTHER_UNITS.iter().map(|(known, _, metres)| (*known, *metres)));
    all.into_iter().find(|(known, _)| *known == number).map(|(_, metres)| metres)
}
