//! The length unit.

use crate::part21::{Id, Sheet, real};

/// Prefixes of the SI and what they stand for.
const PREFIXES: [(f64, &str); 9] = [
    (1e-9, ".NANO."),
    (1e-6, ".MICRO."),
    (1e-3, ".MILLI."),
    (1e-2, ".CENTI."),
    (1e-1, ".DECI."),
    (1.0, "$"),
    (10.0, ".DECA."),
    (100.0, ".HECTO."),
    (1e3, ".KILO."),
];

/// Units that are none of the SI.
const NAMES: [(f64, &str); 4] = [(0.0254, "INCH"), (0.3048, "FOOT"), (0.9144, "YARD"), (1609.344, "MILE")];

/// The unit of that many metres.
pub(super) fn length(sheet: &mut Sheet, metres: f64) -> Id {
    let same = |known: f64| (known - metres).abs() <= 1e-9 * known;
    if let Some((_, prefix)) = PREFIXES.iter().find(|(known, _)| same(*known)) {
        return sheet.put(format_args!("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.))"));
    }
    let name = NAMES.iter().find(|(known, _)| same(*known)).map_or("UNIT", |(_, name)| name);
    let metre = sheet.put("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))");
    let measure =
        sheet.put(format_args!("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),{metre})", real(metres)));
    let dimensions = sheet.put("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
    sheet
        .put(format_args!("(CONVERSION_BASED_UNIT('{name}',{measure})LENGTH_UNIT()NAMED_UNIT({dimensions}))"))
}
