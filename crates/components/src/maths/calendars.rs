//! Maths / Time: days of other calendars than ours.
//!
//! E. M. Reingold, N. Dershowitz, "Calendrical Calculations" (4th edition, 2018): the arithmetic calendars. Days count from
//! 0001-01-01 of the Gregorian calendar, which is their fixed day 1.

use katydid_component::{Context, Message, component};
use katydid_data::DateTime;
use katydid_definition::archive::Chunk;

use super::time::{DAY, days, moment};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Calendar {
    Gregorian,
    Julian,
    Hebrew,
    Hijri,
    /// The Gregorian calendar with years counted from another one: what to add to its years.
    Counted(i32),
}

/// Calendars by what .NET calls them.
const NAMES: [(&str, Calendar); 8] = [
    ("Gregorian", Calendar::Gregorian),
    ("Julian", Calendar::Julian),
    ("Hebrew", Calendar::Hebrew),
    ("Hijri", Calendar::Hijri),
    ("Korean", Calendar::Counted(-2333)),
    ("Taiwan", Calendar::Counted(1911)),
    ("ThaiBuddhist", Calendar::Counted(-543)),
    ("Thai", Calendar::Counted(-543)),
];

/// The calendar that a text names, `JulianCalendar` and `Thai Buddhist` too.
fn named(text: &str) -> Option<Calendar> {
    let letters: String = text.chars().filter(|c| c.is_ascii_alphabetic()).collect::<String>().to_lowercase();
    let letters = letters.strip_suffix("calendar").unwrap_or(&letters);
    NAMES.iter().find(|(name, _)| name.to_lowercase() == letters).map(|(_, calendar)| *calendar)
}

/// The calendar that is chosen in the object's menu: under what name files keep it is not documented, so any text that
/// names one counts.
fn chosen(settings: &Chunk) -> Option<Calendar> {
    settings
        .items
        .iter()
        .filter(|item| !["Name", "NickName", "Description"].contains(&item.name.as_str()))
        .find_map(|item| named(item.value.as_str()?))
}

/// The day after 29 February in leap years, of calendars with the months of the Romans.
fn roman_month(month: i64, leap: bool) -> i64 {
    match month {
        ..=2 => 0,
        _ if leap => -1,
        _ => -2,
    }
}

/// The fixed day of a day of the Julian calendar.
fn julian(year: i64, month: i64, day: i64) -> i64 {
    let leap = year.rem_euclid(4) == 0;
    let before = year - 1;
    -2 + 365 * before
        + before.div_euclid(4)
        + (367 * month - 362).div_euclid(12)
        + roman_month(month, leap)
        + day
}

/// The fixed day of a day of the arithmetic Islamic calendar, with leap years 2, 5, 7, 10, 13, 16, 18, 21, 24, 26 and 29 of
/// each 30.
fn hijri(year: i64, month: i64, day: i64) -> i64 {
    const EPOCH: i64 = 227_015;
    let months = 29 * (month - 1) + month.div_euclid(2);
    EPOCH - 1 + (year - 1) * 354 + (3 + 11 * year).div_euclid(30) + months + day
}

/// Days from the epoch to the new year of a year of the Hebrew calendar, with the delays that keep feasts off some days of
/// the week.
fn hebrew_new_year(year: i64) -> i64 {
    let elapsed = |year: i64| {
        let months = (235 * year - 234).div_euclid(19);
        let parts = 12_084 + 13_753 * months;
        let days = 29 * months + parts.div_euclid(25_920);
        if (3 * (days + 1)).rem_euclid(7) < 3 { days + 1 } else { days }
    };
    let (before, this, after) = (elapsed(year - 1), elapsed(year), elapsed(year + 1));
    let delay = if after - this == 356 { 2 } else { i64::from(this - before == 382) };
    this + delay
}

/// The fixed day of a day of the Hebrew calendar. Months count from the new year in autumn, Tishri, as .NET counts them; a
/// leap year has 13.
fn hebrew(year: i64, month: i64, day: i64) -> i64 {
    const EPOCH: i64 = -1_373_427;
    let before: i64 = (1..month).map(|month| hebrew_month(year, month)).sum();
    EPOCH + hebrew_new_year(year) + before + day - 1
}

fn hebrew_is_leap(year: i64) -> bool {
    (7 * year + 1).rem_euclid(19) < 7
}

/// The days of a month, counted from Tishri.
fn hebrew_month(year: i64, month: i64) -> i64 {
    let length = hebrew_new_year(year + 1) - hebrew_new_year(year);
    let leap = hebrew_is_leap(year);
    match month {
        // Heshvan is long in complete years, Kislev short in deficient ones.
        2 => 29 + i64::from(length % 10 == 5),
        3 => 30 - i64::from(length % 10 == 3),
        1 | 5 => 30,
        4 => 29,
        // Adar has 29 days; in leap years there is one of 30 days before it.
        6 if leap => 30,
        month => {
            let from_nisan = month - if leap { 7 } else { 6 };
            if from_nisan > 0 && from_nisan % 2 == 1 { 30 } else { 29 }
        }
    }
}

impl Calendar {
    /// The fixed day, the days that the month has, and the months of the year.
    fn day(self, year: i64, month: i64) -> (i64, i64, i64) {
        match self {
            Self::Gregorian => Self::Counted(0).day(year, month),
            Self::Counted(shift) => {
                let y = year.saturating_add(i64::from(shift)).clamp(-9999, 19_999) as i32;
                let first = |y: i32, m: i64| days(y, m as i32, 1) + 1;
                let next = if month >= 12 { first(y + 1, 1) } else { first(y, month + 1) };
                (first(y, month), next - first(y, month), 12)
            }
            Self::Julian => {
                let next = if month >= 12 { julian(year + 1, 1, 1) } else { julian(year, month + 1, 1) };
                (julian(year, month, 1), next - julian(year, month, 1), 12)
            }
            Self::Hijri => {
                let next = if month >= 12 { hijri(year + 1, 1, 1) } else { hijri(year, month + 1, 1) };
                (hijri(year, month, 1), next - hijri(year, month, 1), 12)
            }
            Self::Hebrew => {
                let months = if hebrew_is_leap(year) { 13 } else { 12 };
                (hebrew(year, month, 1), hebrew_month(year, month), months)
            }
        }
    }
}

/// Makes a moment, the start of a day, of a day of another calendar.
///
/// The calendar is chosen in the object's menu: Julian, Hebrew, Hijri (the arithmetic one), Korean, Taiwan or Thai. Under
/// what name files keep it is not documented; where none is found the day is Gregorian, and a remark says so. Hebrew
/// months count from the new year in autumn.
#[component(
    "e5ff52c5-40df-4f43-ac3b-d2418d05ae32",
    name = "Construct Exotic Date",
    nick = "DateEx",
    at = "Maths/Time"
)]
#[output("Time", "T", "The moment.")]
fn construct_exotic_date(
    context: &Context<'_>,
    /// The year of the calendar.
    #[port("Year", "Y")]
    year: i32,
    /// The month, from 1.
    #[port("Month", "M")]
    month: i32,
    /// The day of the month, from 1.
    #[port("Day", "D")]
    day: i32,
) -> Result<DateTime, Message> {
    let calendar = chosen(context.settings()).unwrap_or_else(|| {
        context
            .tell(Message::remark("No calendar is stored under a name that is known: the day is Gregorian"));
        Calendar::Gregorian
    });
    let (y, m, d) = (i64::from(year), i64::from(month), i64::from(day));
    if !(1..=20_000).contains(&y) {
        return Err(Message::error(format!("The year {year} does not lie between 1 and 20000")));
    }
    let (_, _, months) = calendar.day(y, 1);
    if !(1..=months).contains(&m) {
        return Err(Message::error(format!("The month {month} does not lie between 1 and {months}")));
    }
    let (first, length, _) = calendar.day(y, m);
    if !(1..=length).contains(&d) {
        return Err(Message::error(format!("The day {day} does not lie between 1 and {length}")));
    }
    // The fixed day 1 is 0001-01-01.
    moment((first + d - 2).saturating_mul(DAY))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    fn on(calendar: &str, [year, month, day]: [i32; 3]) -> String {
        let trial = Trial::of("Construct Exotic Date").item(year).item(month).item(day);
        trial.setting("Calendar", calendar).texts(0).join("")
    }

    #[test]
    fn the_same_day_in_several_calendars() {
        // Sample data of Calendrical Calculations, appendix C: 1945-11-12 and 2038-11-10.
        for (calendar, date) in [
            ("Gregorian", [1945, 11, 12]),
            ("JulianCalendar", [1945, 10, 30]),
            ("Hijri", [1364, 12, 6]),
            ("Korean", [4278, 11, 12]),
            ("Taiwan", [34, 11, 12]),
            ("Thai Buddhist", [2488, 11, 12]),
            // 7 Kislev 5706: the third month from Tishri.
            ("Hebrew", [5706, 3, 7]),
        ] {
            assert_eq!(on(calendar, date), "{0}: 1945-11-12 00:00:00", "{calendar}");
        }
        assert_eq!(on("Julian", [2038, 10, 28]), "{0}: 2038-11-10 00:00:00");
        assert_eq!(on("Hijri", [1460, 10, 12]), "{0}: 2038-11-10 00:00:00");
        assert_eq!(on("Hebrew", [5799, 2, 12]), "{0}: 2038-11-10 00:00:00");
        // The new year of 5784, and Passover (15 Nisan) of the leap year 5784, in which Nisan is the eighth month.
        assert_eq!(on("Hebrew", [5784, 1, 1]), "{0}: 2023-09-16 00:00:00");
        assert_eq!(on("Hebrew", [5784, 8, 15]), "{0}: 2024-04-23 00:00:00");
    }

    #[test]
    fn days_that_are_not_there() {
        let said = |calendar: &str, [year, month, day]: [i32; 3]| {
            let trial = Trial::of("Construct Exotic Date").item(year).item(month).item(day);
            trial.setting("Calendar", calendar).message()
        };
        // 1900 was a leap year of Caesar's only.
        assert_eq!(on("Julian", [1900, 2, 29]), "{0}: 1900-03-13 00:00:00");
        assert_eq!(said("Gregorian", [1900, 2, 29]), "The day 29 does not lie between 1 and 28");
        assert_eq!(said("Hebrew", [5783, 13, 1]), "The month 13 does not lie between 1 and 12");
        assert_eq!(said("Hijri", [0, 1, 1]), "The year 0 does not lie between 1 and 20000");
        assert!(said("Thai", [542, 1, 1]).contains("outside the years"));
        assert!(said("Mayan", [2000, 1, 1]).contains("the day is Gregorian"));
    }
}
