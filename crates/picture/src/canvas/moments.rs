//! Calendars and clocks.

use std::f64::consts::TAU;

use katydid_data::DateTime;
use katydid_definition::document::special::{Calendar, Clock};
use katydid_elementary::Elementary;

use super::capsule::{body, middle, window};
use super::{Placed, theme};
use crate::drawing::{Item, Path, Shape};
use crate::font;

const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];
/// Weeks begin on Mondays (ISO 8601).
const WEEKDAYS: [&str; 7] = ["Mo", "Tu", "We", "Th", "Fr", "Sa", "Su"];
/// The head, the names of the days, and as many weeks as a month can touch.
const ROWS: usize = 8;

/// The month that a calendar shows, with its day marked.
pub(super) fn calendar(one: &Placed<'_>, calendar: &Calendar) -> Vec<Item> {
    let (mut items, [x, y, w, h]) = window(one);
    let [year, month] = calendar.shown;
    let row = h / ROWS as f64;
    let column = w / WEEKDAYS.len() as f64;
    let size = theme::NAME.min(0.6 * row).min(0.55 * column);
    let at = |k: usize, line: usize| [x + column * (k as f64 + 0.5), y + row * (line as f64 + 0.5)];
    let name = usize::try_from(month - 1).ok().and_then(|k| MONTHS.get(k)).copied().unwrap_or_default();
    let head = font::fitted(&format!("{name} {year}"), size, w);
    items.push(middle([x + 0.5 * w, y + 0.5 * row], head, size, theme::INK));
    for (k, name) in WEEKDAYS.iter().enumerate() {
        items.push(middle(at(k, 1), (*name).to_owned(), 0.85 * size, theme::FAINT));
    }
    // Day 1 of year 1 was a Monday.
    let Some(first) = DateTime::on([year, month, 1]) else { return items };
    let before = usize::try_from((first.ticks / DateTime::DAY).rem_euclid(7)).unwrap_or(0);
    for day in 1..=31 {
        let date = [year, month, day];
        if DateTime::on(date).is_none() {
            break;
        }
        let cell = before + usize::try_from(day - 1).unwrap_or(0);
        let centre = at(cell % 7, 2 + cell / 7);
        let chosen = date == calendar.day.date();
        if chosen {
            let mark = [centre[0] - 0.45 * column, centre[1] - 0.45 * row, 0.9 * column, 0.9 * row];
            items.push(Shape::filled(Path::rounded(mark, 3.0), theme::BAND).into());
        }
        let ink = if chosen { theme::WHITE } else { theme::INK };
        items.push(middle(centre, day.to_string(), size, ink));
    }
    items
}

/// A dial with two hands, and the time in figures below.
pub(super) fn clock(one: &Placed<'_>, clock: &Clock) -> Vec<Item> {
    let mut items = body(one, theme::capsule(one).0);
    let [x, y, w, h] = one.frame.rect;
    let r = (0.5 * w - 6.0).min(0.5 * h - 14.0).max(2.0);
    let (cx, cy) = (x + 0.5 * w, y + 6.0 + r);
    items.push(Shape::filled(Path::circle([cx, cy], r), theme::PAPER).outlined(theme::EDGE, 1.0).into());
    // Turns are counted from the top, clockwise.
    let place = |turn: f64, share: f64| {
        let (sin, cos) = (TAU * turn).sine_cosine();
        [cx + share * r * sin, cy - share * r * cos]
    };
    for hour in 0..12 {
        let turn = f64::from(hour) / 12.0;
        let from = if hour % 3 == 0 { 0.82 } else { 0.9 };
        let tick = Path::polyline([place(turn, from), place(turn, 0.97)]);
        items.push(Shape::stroked(tick, theme::EDGE, 1.0).into());
    }
    let seconds = clock.time.time_of_day() as f64 / DateTime::SECOND as f64;
    for (turn, share, width) in [(seconds / 43_200.0, 0.5, 2.6), (seconds / 3600.0, 0.78, 1.6)] {
        let hand = Path::polyline([[cx, cy], place(turn, share)]);
        items.push(Shape::stroked(hand, theme::BAND, width).into());
    }
    let text = clock.time.to_string();
    let time = font::fitted(text.split(' ').nth(1).unwrap_or_default(), theme::NAME, w - 8.0);
    items.push(middle([cx, y + h - 9.0], time, theme::NAME, theme::INK));
    items
}
