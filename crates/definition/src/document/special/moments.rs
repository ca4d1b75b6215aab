//! Calendars and clocks.

use katydid_data::DateTime;

use crate::Result;
use crate::archive::{Chunk, Decimal, Item, ItemValue};
use crate::document::edit::set_number;
use crate::document::{Object, ids};

/// The name under which a Calendar keeps its day, as read in a file of Rhino 8.
const DATE: &str = "LocalDate";
/// The name under which a new Clock keeps its time. No file with one is known: one that has another name keeps it.
const TIME: &str = "LocalTime";

/// A Calendar: a day, and the month that it shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Calendar {
    /// The day. What it holds beyond the day (files have a tick) goes out with it.
    pub day: DateTime,
    /// The year and month that are shown.
    pub shown: [i32; 2],
}

/// A Clock: a time of the day.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Clock {
    /// The time, and the day that is stored with it.
    pub time: DateTime,
}

/// The moment that an object keeps, with its name: one of this name, else the first there is.
fn stored(c: &Chunk, usual: &str) -> Option<(String, DateTime)> {
    let moment = |item: &Item| match item.value {
        ItemValue::Date(ticks) => Some((item.name.clone(), DateTime { ticks })),
        _ => None,
    };
    let mut moments = c.items.iter().filter_map(moment);
    let first = moments.next()?;
    if first.0 == usual {
        return Some(first);
    }
    Some(moments.find(|(name, _)| name == usual).unwrap_or(first))
}

impl Calendar {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        let (_, day) = stored(c, DATE)?;
        let attributes = c.child("Attributes");
        let part = |name| {
            let x = attributes.and_then(|chunk| chunk.f64(name))?;
            (x.fract() == 0.0).then_some(x as i32)
        };
        let [year, month, _] = day.date();
        let shown = match (part("DisplayYear"), part("DisplayMonth")) {
            (Some(year @ 1..=9999), Some(month @ 1..=12)) => [year, month],
            _ => [year, month],
        };
        Some(Self { day, shown })
    }
}

impl Clock {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        Some(Self { time: stored(c, TIME)?.1 })
    }
}

impl Object {
    /// Picks a day in a Calendar: year, month, day of the Gregorian calendar. Its month is shown then.
    ///
    /// # Errors
    /// When the object is no Calendar, or there is no such day.
    pub fn set_calendar(&mut self, date: [i32; 3]) -> Result<()> {
        if self.component != ids::CALENDAR {
            return Err(self.refuse("it is not a Calendar"));
        }
        let Some(day) = DateTime::on(date) else {
            let [year, month, day] = date;
            return Err(self.refuse(format!("there is no day {year:04}-{month:02}-{day:02}")));
        };
        // Grasshopper's own calendars hold a tick after midnight.
        let (name, rest) = stored(self.container(), DATE)
            .map_or((DATE.to_owned(), 1), |(name, old)| (name, old.time_of_day()));
        self.container_mut().set(&name, ItemValue::Date(day.ticks + rest));
        let [year, month, _] = date;
        if Calendar::read(self.container()).is_some_and(|calendar| calendar.shown == [year, month]) {
            return Ok(());
        }
        if let Some(attributes) = self.container_mut().child_mut("Attributes") {
            for (name, x) in [("DisplayMonth", month), ("DisplayYear", year)] {
                match Decimal::from_f64(x.into(), 0) {
                    Some(decimal) if attributes.item(name).is_none() => attributes.set(name, decimal),
                    _ => drop(set_number(attributes, name, x.into())),
                }
            }
        }
        Ok(())
    }

    /// Sets a Clock: ticks since midnight. The day that it keeps stays.
    ///
    /// # Errors
    /// When the object is no Clock, or a day has no such time.
    pub fn set_clock(&mut self, ticks: i64) -> Result<()> {
        if self.component != ids::CLOCK {
            return Err(self.refuse("it is not a Clock"));
        }
        if !(0..DateTime::DAY).contains(&ticks) {
            return Err(self.refuse("a time of the day is at least 0 and less than 24 hours"));
        }
        let (name, old) = stored(self.container(), TIME).unwrap_or((TIME.to_owned(), DateTime::default()));
        let midnight = old.ticks - old.time_of_day();
        let at = midnight.checked_add(ticks).unwrap_or(ticks);
        self.container_mut().set(&name, ItemValue::Date(at));
        Ok(())
    }
}
