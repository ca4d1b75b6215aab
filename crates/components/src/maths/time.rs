//! Maths / Time.

use katydid_component::{Context, Message, component};
use katydid_data::DateTime;

const SECOND: i64 = 10_000_000;
pub(super) const DAY: i64 = 86_400 * SECOND;
/// The first moment after the last that .NET can tell: the start of the year 10000.
const END: i64 = 3_652_059 * DAY;

/// Days since 0001-01-01 of a day of the Gregorian calendar. Howard Hinnant, "chrono-compatible low-level date
/// algorithms".
pub(super) fn days(year: i32, month: i32, day: i32) -> i64 {
    let (y, m, d) = (i64::from(year), i64::from(month), i64::from(day));
    let y = if m <= 2 { y - 1 } else { y };
    let era = y.div_euclid(400);
    let year_of_era = y.rem_euclid(400);
    let day_of_year = (153 * ((m + 9) % 12) + 2) / 5 + d - 1;
    era * 146_097 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 306
}

/// Year, month and day of a count of days since 0001-01-01; the inverse of [`days`], from the same source.
fn calendar(days: i64) -> (i32, i32, i32) {
    let z = days + 306;
    let era = z.div_euclid(146_097);
    let day_of_era = z.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let m = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * m + 2) / 5 + 1;
    let month = if m < 10 { m + 3 } else { m - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    (year as i32, month as i32, day as i32)
}

pub(super) fn moment(ticks: i64) -> Result<DateTime, Message> {
    match (0..END).contains(&ticks) {
        true => Ok(DateTime { ticks }),
        false => Err(Message::error("The result lies outside the years 1 to 9999")),
    }
}

fn part(name: &str, x: i32, range: std::ops::RangeInclusive<i32>) -> Result<i64, Message> {
    if range.contains(&x) {
        return Ok(i64::from(x));
    }
    Err(Message::error(format!("The {name} {x} does not lie between {} and {}", range.start(), range.end())))
}

fn clock(hour: i32, minute: i32, second: i32) -> Result<i64, Message> {
    let (h, m) = (part("hour", hour, 0..=23)?, part("minute", minute, 0..=59)?);
    Ok((h * 3600 + m * 60 + part("second", second, 0..=59)?) * SECOND)
}

/// Makes a moment of a day and a time of day.
///
/// A part outside its range, such as the 30th of February, is an error.
#[component(
    "0c2f0932-5ddc-4ece-bd84-a3a059d3df7a",
    name = "Construct Date",
    nick = "Date",
    at = "Maths/Time"
)]
#[output("Date", "D", "The moment.")]
fn construct_date(
    /// The year, 1 to 9999.
    #[port("Year", "Y")]
    year: i32,
    /// The month, 1 to 12.
    #[port("Month", "M")]
    month: i32,
    /// The day of the month, from 1.
    #[port("Day", "D")]
    day: i32,
    /// The hour, 0 to 23.
    #[port("Hour", "h", default = 0)]
    hour: i32,
    /// The minute, 0 to 59.
    #[port("Minute", "m", default = 0)]
    minute: i32,
    /// The second, 0 to 59.
    #[port("Second", "s", default = 0)]
    second: i32,
) -> Result<DateTime, Message> {
    part("year", year, 1..=9999)?;
    part("month", month, 1..=12)?;
    let (next_year, next_month) = if month == 12 { (year + 1, 1) } else { (year, month + 1) };
    let last = days(next_year, next_month, 1) - days(year, month, 1);
    part("day", day, 1..=i32::try_from(last).unwrap_or(31))?;
    moment(days(year, month, day) * DAY + clock(hour, minute, second)?)
}

/// The day and the time of day of a moment.
#[component(
    "d5e28df8-495b-4892-bca8-60748743d955",
    name = "Deconstruct Date",
    nick = "DDate",
    at = "Maths/Time"
)]
#[output("Year", "Y", "The year.")]
#[output("Month", "M", "The month, 1 to 12.")]
#[output("Day", "D", "The day of the month, from 1.")]
#[output("Hour", "h", "The hour, 0 to 23.")]
#[output("Minute", "m", "The minute, 0 to 59.")]
#[output("Second", "s", "The second, 0 to 59.")]
fn deconstruct_date(
    /// The moment.
    #[port("Date", "D")]
    date: DateTime,
) -> (i32, i32, i32, i32, i32, i32) {
    let (year, month, day) = calendar(date.ticks.div_euclid(DAY));
    // Below a day, so that it fits.
    let seconds = (date.ticks.rem_euclid(DAY) / SECOND) as i32;
    (year, month, day, seconds / 3600, seconds / 60 % 60, seconds % 60)
}

/// Makes a time of day.
#[component(
    "595aded2-8916-402d-87a3-a825244bbe3d",
    name = "Construct Time",
    nick = "Time",
    at = "Maths/Time"
)]
#[output("Time", "T", "The time, on the first day there is.")]
fn construct_time(
    /// The hour, 0 to 23.
    #[port("Hour", "H", default = 0)]
    hour: i32,
    /// The minute, 0 to 59.
    #[port("Minute", "M", default = 0)]
    minute: i32,
    /// The second, 0 to 59.
    #[port("Second", "S", default = 0)]
    second: i32,
) -> Result<DateTime, Message> {
    moment(clock(hour, minute, second)?)
}

/// Adds up days, hours, minutes and seconds, each with a fraction.
#[component(
    "f151b0b9-cef8-4809-96fc-9b14f1c3a7b9",
    name = "Construct Smooth Time",
    nick = "SmTime",
    at = "Maths/Time"
)]
#[output("Time", "T", "The time, from the first day there is.")]
fn construct_smooth_time(
    /// Days.
    #[port("Days", "D", default = 0.0)]
    day: f64,
    /// Hours.
    #[port("Hours", "H", default = 0.0)]
    hour: f64,
    /// Minutes.
    #[port("Minutes", "M", default = 0.0)]
    minute: f64,
    /// Seconds.
    #[port("Seconds", "S", default = 0.0)]
    second: f64,
) -> Result<DateTime, Message> {
    let seconds = ((day * 24.0 + hour) * 60.0 + minute) * 60.0 + second;
    moment((seconds * SECOND as f64).round() as i64)
}

/// The day of one moment with the time of day of another.
#[component(
    "31534405-6573-4be6-8bf8-262e55847a3a",
    name = "Combine Date & Time",
    nick = "CDate",
    at = "Maths/Time"
)]
#[output("Result", "R", "The day and the time together.")]
fn combine_date_and_time(
    /// The moment whose day is taken.
    #[port("Date", "D")]
    date: DateTime,
    /// The moment whose time of day is taken.
    #[port("Time", "T")]
    time: DateTime,
) -> Result<DateTime, Message> {
    moment(date.ticks.div_euclid(DAY).saturating_mul(DAY).saturating_add(time.ticks.rem_euclid(DAY)))
}

/// `a` at 0, `b` at 1. The difference of two moments has its digits to the tick for some thirty years.
fn between(a: DateTime, b: DateTime, t: f64) -> Result<DateTime, Message> {
    let span = b.ticks.saturating_sub(a.ticks) as f64;
    moment(a.ticks.saturating_add((span * t).round() as i64))
}

/// Moments at equal distances from one moment to another.
#[component("38a4e722-ad5a-4229-a170-e27ae1345538", name = "Date Range", nick = "RDate", at = "Maths/Time")]
#[output("Range", "R", "The moments, one more than there are steps.")]
fn date_range(
    context: &Context<'_>,
    /// The first moment.
    #[port("Time A", "A")]
    a: DateTime,
    /// The last moment.
    #[port("Time B", "B")]
    b: DateTime,
    /// How many steps, 1 or more.
    #[port("Count", "N", default = 10)]
    count: i32,
) -> Result<Vec<DateTime>, Message> {
    if count < 1 {
        return Err(Message::error(format!("{count} steps cannot be made: there must be at least one")));
    }
    context.items(usize::try_from(count).unwrap_or(usize::MAX).saturating_add(1))?;
    (0..=count).map(|i| between(a, b, f64::from(i) / f64::from(count))).collect()
}

/// The moment between two others, or beyond them.
#[component(
    "4083802b-3dd9-4b13-9756-bf5441213e70",
    name = "Interpolate Date",
    nick = "IntDate",
    at = "Maths/Time"
)]
#[output("Date", "D", "The moment.")]
fn interpolate_date(
    /// The moment at 0.
    #[port("Date A", "A")]
    a: DateTime,
    /// The moment at 1.
    #[port("Date B", "B")]
    b: DateTime,
    /// How far from A to B.
    #[port("Interpolation", "t", default = 0.5)]
    t: f64,
) -> Result<DateTime, Message> {
    between(a, b, t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use katydid_component::testing::Trial;

    fn date(parts: [i32; 6]) -> Trial {
        parts.into_iter().fold(Trial::of("Construct Date"), Trial::item)
    }

    #[test]
    fn days_and_the_calendar_agree() {
        assert_eq!(days(1970, 1, 1), 719_162);
        for day in (0..3_652_059).step_by(97).chain(738_000..740_000) {
            let (y, m, d) = calendar(day);
            assert_eq!(days(y, m, d), day);
        }
    }

    #[test]
    fn dates_there_and_back() {
        assert_eq!(date([2024, 2, 29, 13, 5, 9]).texts(0), ["{0}: 2024-02-29 13:05:09"]);
        assert_eq!(date([2023, 2, 29, 0, 0, 0]).message(), "The day 29 does not lie between 1 and 28");
        assert_eq!(date([2023, 12, 31, 24, 0, 0]).message(), "The hour 24 does not lie between 0 and 23");
        let moment = DateTime { ticks: days(2024, 2, 29) * DAY + 47_109 * SECOND };
        let part = |k| Trial::of("Deconstruct Date").item(moment).texts(k).concat().replace("{0}: ", "");
        assert_eq!([0, 1, 2, 3, 4, 5].map(part), ["2024", "2", "29", "13", "5", "9"]);
    }

    #[test]
    fn times() {
        let noon = Trial::of("Construct Time").item(12).item(30).item(0);
        assert_eq!(noon.texts(0), ["{0}: 0001-01-01 12:30:00"]);
        let smooth = Trial::of("Construct Smooth Time").item(1.5).item(0.5).item(0).item(30);
        assert_eq!(smooth.texts(0), ["{0}: 0001-01-02 12:30:30"]);
        assert!(Trial::of("Construct Smooth Time").item(-1.0).message().contains("outside"));
        let (a, b) = (DateTime { ticks: 10 * DAY }, DateTime { ticks: 12 * DAY + 5 * SECOND });
        assert_eq!(Trial::of("Combine Date & Time").item(a).item(b).texts(0), ["{0}: 0001-01-11 00:00:05"]);
        let end = DateTime { ticks: 12 * DAY };
        assert_eq!(
            Trial::of("Date Range").item(a).item(end).item(2).texts(0),
            ["{0;0}: 0001-01-11 00:00:00, 0001-01-12 00:00:00, 0001-01-13 00:00:00"]
        );
        assert!(Trial::of("Date Range").item(a).item(end).item(0).message().starts_with("0 steps"));
        assert_eq!(
            Trial::of("Interpolate Date").item(a).item(end).item(0.25).texts(0),
            ["{0}: 0001-01-11 12:00:00"]
        );
    }
}
