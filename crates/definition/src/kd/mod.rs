//! The text form of a definition, .kd: one statement an object.
//!
//! ```text
//! katydid 1
//! units millimetres
//!
//! r    = Number Slider(5.18, 0..10)
//! grid = Square(Size = r, Extent X = 10, Extent Y = 10) -> Points |flatten
//! some = List Item(grid.Points, [0, 4, 9])
//! group the grid: r, grid
//! ```
//!
//! The grammar, with examples, is in `docs/kd.md`. [`read`] makes a document of a text, [`write()`] a text of a document,
//! and [`format`](fn@format) sets a text the usual way. What an object's statement does not say is kept as changes to
//! the tree of the archive in blocks at the end, so that nothing is lost: [`write()`] builds its own text again, and
//! writes down what differs.
//!
//! ```
//! use katydid_definition::kd::{self, NoCatalogue};
//!
//! let text = "on = Boolean Toggle(true)\nshown = Panel(on)\n";
//! let read = kd::read(text, &NoCatalogue)?;
//! assert_eq!(read.document.objects[1].inputs[0].sources, [read.document.objects[0].id]);
//! let written = kd::write(&read.document, &NoCatalogue).unwrap();
//! assert_eq!(written.text, format!("katydid 1\n\n{text}"));
//! # Ok::<(), katydid_definition::kd::Problems>(())
//! ```

mod arrange;
mod ast;
mod build;
mod catalogue;
mod derive;
mod labels;
mod layout;
mod lexer;
mod object;
mod own;
mod parse_parts;
mod parser;
mod pipeline;
mod problem;
mod raw_value;
mod residue;
mod slot;
mod statement;
mod text;
mod timing;
mod value;
mod write;

use katydid_geometry::Units;

pub use arrange::arrange;
pub use catalogue::{Catalogue, Expect, Facts, NoCatalogue, PortFacts};
pub use derive::id as derived_id;
pub use problem::{Problem, Problems};
pub use slot::counted;
pub use write::{Written, write};

use self::catalogue::Known;
use self::problem::Fault;
use crate::archive::{Archive, Encoding, ItemValue};
use crate::document::{Document, Object, Persistent, Stored};

/// A text, read.
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// The document.
    pub document: Document,
    /// The length unit, where the text names one; no archive keeps it.
    pub units: Option<Units>,
}

/// Reads a text.
///
/// # Errors
/// With everything that is wrong with the text: signs that mean nothing, components and objects that nobody knows,
/// inputs too many.
pub fn read(text: &str, catalogue: &dyn Catalogue) -> Result<Definition, Problems> {
    let module = parser::parse(text).map_err(|faults| Problems::of(text, faults))?;
    let mut faults = Vec::new();
    let units = module.units.as_ref().and_then(|name| match units(&name.text) {
        Some(units) => Some(units),
        None => {
            let fault = Fault::new(name.span.at, name.span.len, "there is no such unit");
            faults.push(fault.hint("millimetres, metres, inches, feet …"));
            None
        }
    });
    let root = build::build(&module, &Known(catalogue), None, build::Insides::Packed, &mut faults);
    if !faults.is_empty() {
        return Err(Problems::of(text, faults));
    }
    match Document::from_archive(Archive::new(root, Encoding::Binary)) {
        Ok(document) => Ok(Definition { document, units }),
        Err(error) => Err(Problems::of(text, vec![Fault::new(0, 1, error.to_string())])),
    }
}

/// Sets a text the usual way: one blank here, none there, long lists over several lines. Comments stay.
///
/// # Errors
/// When the text is no text of the form; whether its components are known does not matter.
pub fn format(text: &str) -> Result<String, Problems> {
    parser::parse(text).map_err(|faults| Problems::of(text, faults))?;
    Ok(layout::tidy(text))
}

/// The name that each object of a document goes by in its text, in the order of the document: its nickname, and of several
/// with the same one a number behind all but the first (`Pt`, `Pt'2`). Without the backquotes that some need in a text.
pub fn labels(document: &Document) -> Vec<String> {
    let objects = &document.objects;
    labels::assign(objects, &statement::order(objects)).iter().map(labels::Label::key).collect()
}

/// Whether there are comments in a text; documents do not keep them.
pub fn has_comments(text: &str) -> bool {
    lexer::lex(text).0.iter().any(|token| token.kind == lexer::Kind::Comment)
}

/// A length unit by its name, in either spelling.
fn units(name: &str) -> Option<Units> {
    Some(match name.to_lowercase().replace("metre", "meter").as_str() {
        "none" => Units::None,
        "microns" | "micrometers" => Units::Microns,
        "millimeters" | "mm" => Units::Millimeters,
        "centimeters" | "cm" => Units::Centimeters,
        "meters" | "m" => Units::Meters,
        "kilometers" | "km" => Units::Kilometers,
        "inches" => Units::Inches,
        "feet" => Units::Feet,
        "yards" => Units::Yards,
        "miles" => Units::Miles,
        _ => return None,
    })
}

/// The bytes of a value by a number that follows from them, so that equal ones read alike.
fn number(bytes: &[u8]) -> u32 {
    let id = derive::of_bytes(derive::ROOT, bytes);
    u32::try_from(id.as_u128() >> 96).unwrap_or(0)
}

/// The values of a port, as the text form has them.
pub(crate) fn values_form(values: &Persistent) -> String {
    value::print(values, Expect::Number, &mut number)
}

/// The values of a port for a reader: `3` whether it is whole by its type or not.
pub(crate) fn values_words(values: &Persistent) -> String {
    let mut values = values.clone();
    for item in values.branches.iter_mut().flat_map(|branch| &mut branch.items) {
        if let Stored::Integer(n) = item {
            *item = Stored::Number(f64::from(*n));
        }
    }
    values_form(&values)
}

/// A value of the archive, as the text form has it.
pub(crate) fn value_form(value: &ItemValue) -> String {
    match value {
        ItemValue::String(string) => text::quote(string, '"'),
        other => raw_value::print(other, "", 0, &mut number),
    }
}

/// The settings that an object's statement has among its inputs.
pub(crate) fn own_settings(object: &Object) -> Vec<String> {
    own::print(object)
}
