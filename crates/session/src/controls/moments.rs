//! The Calendar and the Clock.

use katydid_data::DateTime;
use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::{Object, Special, ids};

use super::{FACE, Row, decimal, finite};
use crate::Refusal;
use crate::protocol::Control;

// The sizes are those in files; the hand that places one sets it to the present.
pub(super) const CALENDAR: Row = Row {
    components: &[ids::CALENDAR],
    is_set_by_hand: true,
    begin: |container| {
        let day = DateTime::on([2000, 1, 1]).unwrap_or_default();
        container.set("LocalDate", ItemValue::Date(day.ticks + 1));
        let mut attributes = Chunk::new("Attributes");
        attributes.set("DisplayMonth", decimal(1.0, 0));
        attributes.set("DisplayYear", decimal(2000.0, 0));
        container.set_child(attributes);
    },
    view: |_, special| {
        let Special::Calendar(calendar) = special else { return None };
        Some(Control::Calendar { date: calendar.day.date(), shown: calendar.shown })
    },
    shape: |object, control| {
        let Control::Calendar { date, .. } = control else { return Ok(false) };
        object.set_calendar(*date)?;
        Ok(true)
    },
    size: |_, _| Some([214.0, 262.0]),
    ..FACE
};

pub(super) const CLOCK: Row = Row {
    components: &[ids::CLOCK],
    is_set_by_hand: true,
    begin: |container| container.set("LocalTime", ItemValue::Date(DateTime::DAY / 2)),
    view: |_, special| {
        let Special::Clock(clock) = special else { return None };
        Some(Control::Clock { seconds: clock.time.time_of_day() as f64 / DateTime::SECOND as f64 })
    },
    shape: |object, control| {
        let Control::Clock { seconds } = control else { return Ok(false) };
        set_clock(object, *seconds)?;
        Ok(true)
    },
    size: |_, _| Some([160.0, 184.0]),
    ..FACE
};

/// Sets a clock to so many seconds since midnight, to the tick.
pub(crate) fn set_clock(object: &mut Object, seconds: f64) -> Result<(), Refusal> {
    finite(&[seconds])?;
    // Beyond what a day has the conversion saturates, and is refused.
    object.set_clock((seconds * DateTime::SECOND as f64).round() as i64)?;
    Ok(())
}
