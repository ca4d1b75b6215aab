//! Calendars and clocks: objects that hold a moment.

use katydid_component::{Context, Message, component};
use katydid_data::{DateTime, Tree};
use katydid_definition::archive::{Chunk, ItemValue};

/// The first moment that an object has stored, under whatever name.
fn stored(chunk: &Chunk, depth: usize) -> Option<DateTime> {
    let own = chunk.items.iter().find_map(|item| match item.value {
        ItemValue::Date(ticks) => Some(DateTime { ticks }),
        _ => None,
    });
    let inside = || chunk.chunks.iter().find_map(|chunk| stored(chunk, depth.checked_sub(1)?));
    own.or_else(inside)
}

fn moment(context: &Context<'_>) -> Result<DateTime, Message> {
    stored(context.settings(), 4).ok_or_else(|| Message::error("No moment is stored in this object"))
}

/// A date, picked from a calendar.
#[component(
    "ab898d46-b8b3-4ed5-b28f-4f8047920262",
    name = "Calendar",
    nick = "",
    at = "Params/Input",
    floating
)]
#[output("Date", "D", "The date.")]
fn calendar(
    context: &Context<'_>,
    /// Not used: the date is stored in the calendar.
    #[port("Date", "D", optional, kind = Time)]
    _data: &Tree,
) -> Result<DateTime, Message> {
    moment(context)
}

/// A time of the day, set on a clock face.
#[component("f8a94819-1e2b-4d67-9100-9e983ac493cc", name = "Clock", nick = "", at = "Params/Input", floating)]
#[output("Time", "T", "The time.")]
fn clock(
    context: &Context<'_>,
    /// Not used: the time is stored in the clock.
    #[port("Time", "T", optional, kind = Time)]
    _data: &Tree,
) -> Result<DateTime, Message> {
    moment(context)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::ItemValue;

    #[test]
    fn moments_are_stored() {
        for name in ["Calendar", "Clock"] {
            let at = ItemValue::Date(621_355_968_000_000_000);
            assert_eq!(Trial::of(name).setting("Any", at).texts(0), ["{0}: 1970-01-01 00:00:00"]);
            assert_eq!(Trial::of(name).message(), "No moment is stored in this object");
        }
    }
}
