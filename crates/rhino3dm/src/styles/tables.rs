//! The tables of styles of a model, as an archive of some version has them.

use std::collections::HashMap;

use uuid::Uuid;

use super::{Font, Style, newer, older};
use crate::chunk::{Context, Reader, Writer};
use crate::class_object::{ClassObject, UserData};
use crate::ids::made_id;
use crate::tables::{KeptRecord, Table};
use crate::version::Version;
use crate::{Limits, Result, typecode};

/// The styles of a model that are of another form than those of the archive to be written, and where annotations
/// find them.
#[derive(Debug, Default)]
pub(crate) struct Styles {
    /// Every dimension style that could be read, with its user data and its place in the table.
    entries: Vec<Entry>,
    /// The places among the entries by identifier.
    by_id: HashMap<Uuid, usize>,
    /// The number of the model's unit.
    unit: i32,
    /// Whether the records are written anew: they are of the other form.
    converts: bool,
}

#[derive(Debug)]
struct Entry {
    style: Style,
    user_data: Vec<UserData>,
    place: i32,
}

/// A version whose rules the styles of annotations follow.
const NEWEST: i32 = 80;

/// Whether archives of a version have the newer form.
fn is_new(archive: i32) -> bool {
    archive >= 60
}

impl Styles {
    /// The styles among the kept records of a model with a unit, by its number, for an archive of the given version.
    pub(crate) fn of(kept: &[KeptRecord], unit: i32, version: Version) -> Self {
        let mut styles = Self { unit, ..Self::default() };
        let fonts: Vec<Option<Font>> = records(kept, Table::TextStyles)
            .map(|record| record.with_class(Font::read_style).ok().flatten())
            .collect();
        let mut all_read = true;
        for (record, place) in records(kept, Table::DimensionStyles).zip(0..) {
            let read = record.with_class(|object| {
                let style = match newer::read(object)? {
                    Some(style) => Some(style),
                    None => older::read(object, &fonts, unit)?,
                };
                Ok(style.map(|style| (style, object.user_data.clone())))
            });
            match read {
                Ok(Some((style, user_data))) => {
                    styles.by_id.entry(style.id).or_insert(styles.entries.len());
                    styles.entries.push(Entry { style, user_data, place });
                }
                _ => all_read = false,
            }
            styles.converts |= is_new(record.archive_version) != is_new(version.archive);
        }
        // Those that cannot be read keep their form where that can be, and so do all the others then.
        styles.converts &= all_read;
        styles
    }

    /// A style by its identifier, with its place in the table.
    fn find(&self, id: Uuid) -> Option<(i32, &Style)> {
        let entry = self.entries.get(*self.by_id.get(&id)?)?;
        Some((entry.place, &entry.style))
    }

    /// The place in the table of the style of an annotation, and the numbers that count for it: those of the style,
    /// but for some of its own, which are the bytes of a class object. Readers give annotations without a style that is there the current one.
    pub(crate) fn of_annotation(&self, style: Uuid, own: Option<&[u8]>) -> (i32, Style) {
        let (place, style) = self.find(style).unzip();
        let style = style.cloned().unwrap_or_default();
        let own = own.and_then(|bytes| {
            let context = Context::new(&Limits::default());
            let mut reader = Reader::new(bytes, Version::unstated(NEWEST), &context);
            newer::read(&ClassObject::read(&mut reader).ok()?).ok()?
        });
        (place.unwrap_or(-1), own.map_or_else(|| style.clone(), |own| style.with(&own)))
    }

    /// Whether the records of the tables are written from these styles and not as they were.
    pub(crate) fn replaces(&self, table: Table) -> bool {
        self.converts && matches!(table, Table::TextStyles | Table::DimensionStyles)
    }

    /// The records of the table of text styles: before version 60 one a dimension style.
    pub(crate) fn write_text_styles(&self, w: &mut Writer) -> Result<()> {
        if !self.converts || is_new(w.version().archive) {
            return Ok(());
        }
        self.entries.iter().zip(0..).try_for_each(|(entry, number)| {
            w.chunk(typecode::TEXT_STYLE_RECORD, |w| {
                let place = u64::from(u32::try_from(number).unwrap_or_default());
                let id = made_id(place, entry.style.name.as_bytes());
                entry.style.font.write_style(number, id, w)
            })
        })
    }

    /// The records of the table of dimension styles.
    pub(crate) fn write_dimension_styles(&self, w: &mut Writer) -> Result<()> {
        if !self.converts {
            return Ok(());
        }
        self.entries.iter().zip(0..).try_for_each(|(entry, number)| {
            let others: Vec<UserData> =
                entry.user_data.iter().filter(|data| !older::holds(data)).cloned().collect();
            w.chunk(typecode::DIMENSION_STYLE_RECORD, |w| {
                if is_new(w.version().archive) {
                    let mut style = Style { number, ..entry.style.clone() };
                    if style.id.is_nil() {
                        // Styles of early archives have none.
                        style.id = made_id(u64::try_from(number).unwrap_or_default(), style.name.as_bytes());
                    }
                    newer::write(&style, &others, self.unit, w)
                } else {
                    older::write(&entry.style, number, &others, self.unit, w)
                }
            })
        })
    }
}

fn records(kept: &[KeptRecord], table: Table) -> impl Iterator<Item = &KeptRecord> {
    kept.iter().filter(move |record| record.table == table)
}
