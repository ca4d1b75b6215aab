use std::fmt;

/// A moment: .NET ticks of 100 ns since the start of year 1, without a time zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct DateTime {
    /// The ticks.
    pub ticks: i64,
}

/// Year, month and day of a count of days since 0001-01-01, by the Gregorian calendar run backwards.
/// Howard Hinnant, "chrono-compatible low-level date algorithms".
fn civil_from_days(days: i64) -> (i64, u32, u32) {
    // Shift the epoch to 0000-03-01, so that the leap day ends the year.
    let z = days + 306;
    let era = z.div_euclid(146_097);
    let day_of_era = z.rem_euclid(146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let mp = (5 * day_of_year + 2) / 153;
    let day = (day_of_year - (153 * mp + 2) / 5 + 1) as u32;
    let month = if mp < 10 { mp + 3 } else { mp - 9 } as u32;
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    (year, month, day)
}

/// The ticks of 1970-01-01, .NET's own constant.
const UNIX_EPOCH: i64 = 621_355_968_000_000_000;

/// The years that .NET's dates have.
const YEARS: std::ops::RangeInclusive<i32> = 1..=9999;

impl DateTime {
    /// The ticks of a second.
    pub const SECOND: i64 = 10_000_000;
    /// The ticks of a day.
    pub const DAY: i64 = 86_400 * Self::SECOND;

    /// The start of a day of the Gregorian calendar; `None` for a day that the month does not have, and outside the years
    /// 1 to 9999.
    pub fn on([year, month, day]: [i32; 3]) -> Option<Self> {
        if !YEARS.contains(&year) {
            return None;
        }
        let days = Self::day(year.into(), month.into(), day.into())?;
        Some(Self { ticks: days * Self::DAY })
    }

    /// Its year, month (1 to 12) and day by the Gregorian calendar.
    pub fn date(self) -> [i32; 3] {
        let (year, month, day) = civil_from_days(self.ticks.div_euclid(Self::DAY));
        [year, i64::from(month), i64::from(day)].map(|part| i32::try_from(part).unwrap_or(i32::MAX))
    }

    /// The ticks since midnight.
    pub fn time_of_day(self) -> i64 {
        self.ticks.rem_euclid(Self::DAY)
    }

    /// The moment some time after 1970-01-01 00:00 UTC, as clocks of machines count; `None` beyond the year 9999.
    pub fn since_1970(elapsed: std::time::Duration) -> Option<Self> {
        const LAST: i64 = 3_155_378_975_999_999_999;
        let ticks = i64::try_from(elapsed.as_nanos() / 100).ok()?.checked_add(UNIX_EPOCH)?;
        (ticks <= LAST).then_some(Self { ticks })
    }

    /// Days from 0001-01-01 to a date of the Gregorian calendar; `None` for a day that the month does not have.
    pub(crate) fn day(year: i64, month: i64, day: i64) -> Option<i64> {
        let y = if month <= 2 { year - 1 } else { year };
        let year_of_era = y.rem_euclid(400);
        let day_of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
        let day_of_era = year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
        let days = y.div_euclid(400) * 146_097 + day_of_era - 306;
        (civil_from_days(days) == (year, month as u32, day as u32)).then_some(days)
    }
}

impl fmt::Display for DateTime {
    /// `2024-02-29 13:05:09`, the seconds whole.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let seconds = self.ticks.div_euclid(10_000_000);
        let (days, rest) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
        let (y, m, d) = civil_from_days(days);
        write!(f, "{y:04}-{m:02}-{d:02} {:02}:{:02}:{:02}", rest / 3600, rest / 60 % 60, rest % 60)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_dates() {
        // .NET's own constants for 1970-01-01 and for the last day that it has.
        assert_eq!(DateTime::on([1970, 1, 1]), Some(DateTime { ticks: UNIX_EPOCH }));
        let last = DateTime { ticks: 3_155_378_975_999_999_999 };
        assert_eq!(last.date(), [9999, 12, 31]);
        assert_eq!(last.time_of_day(), DateTime::DAY - 1);
        assert_eq!(DateTime::on([2024, 2, 29]).map(DateTime::date), Some([2024, 2, 29]));
        for none in [
            [2023, 2, 29],
            [0, 1, 1],
            [10_000, 1, 1],
            [2024, 13, 1],
            [2024, 0, 1],
            [2024, 1, 0],
            [2024, 4, 31],
        ] {
            assert_eq!(DateTime::on(none), None, "{none:?}");
        }
        for extreme in [i64::MIN, i64::MAX] {
            let _ = (DateTime { ticks: extreme }.date(), DateTime { ticks: extreme }.time_of_day());
        }
    }

    #[test]
    fn ticks_are_dates() {
        assert_eq!(DateTime { ticks: 0 }.to_string(), "0001-01-01 00:00:00");
        // .NET's own constant for 1970-01-01.
        let start = DateTime::since_1970(std::time::Duration::ZERO).unwrap();
        assert_eq!(start.to_string(), "1970-01-01 00:00:00");
        assert_eq!(DateTime::since_1970(std::time::Duration::MAX), None);
        let leap = 621_355_968_000_000_000 + (19_782 * 86_400 + 47_109) * 10_000_000;
        assert_eq!(DateTime { ticks: leap }.to_string(), "2024-02-29 13:05:09");
    }
}
