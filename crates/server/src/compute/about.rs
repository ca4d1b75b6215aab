//! What the server says of itself.

use std::time::{Duration, SystemTime, UNIX_EPOCH};

use axum::http::StatusCode;
use serde_json::json;

use super::refusal::Refusal;
use super::route::Route;
use super::sent::{JSON, Sent};
use super::service::Service;

/// The version of Rhino.Compute whose ways are followed.
const COMPUTE: &str = "8.0.0.0";
/// And of Rhino: clients choose by the first number.
const RHINO: &str = "8.0.0.0";

pub(crate) fn answer(service: &Service, route: Route) -> Sent {
    let version = env!("CARGO_PKG_VERSION");
    match route {
        Route::Home => Sent::text("compute.rhino3d"),
        Route::Robots => Sent::text("User-agent: *\nDisallow: / "),
        Route::Icon => Sent::text("Handled"),
        Route::Version => {
            Sent::json(&json!({"rhino": RHINO, "compute": COMPUTE, "git_sha": null, "katydid": version}))
        }
        Route::Time => Sent::new(JSON, format!("\"{}\"", utc(SystemTime::now()))),
        Route::Children => Sent::text(service.config.workers().to_string()),
        Route::Idle => Sent::text(match service.idle.seconds() {
            Some(seconds) => seconds.to_string(),
            None => "-1".to_owned(),
        }),
        Route::Validate if service.lock.is_open() => Sent::text("Valid (no API key configured)"),
        Route::Validate => Sent::text("Valid"),
        Route::RhinoPlugins | Route::GrasshopperPlugins => Sent::json(&json!({ "Katydid": version })),
        Route::Script => {
            let message = "scripts are not run here";
            Sent::json(&json!({"error": "ScriptingDisabled", "message": message, "errors": [message]}))
                .with_status(StatusCode::FORBIDDEN)
        }
        _ => Refusal::missing("there is nothing at this address").into(),
    }
}

/// A moment as .NET writes it: `2026-11-22T10:04:32.1234567Z`.
fn utc(moment: SystemTime) -> String {
    let since = moment.duration_since(UNIX_EPOCH).unwrap_or(Duration::ZERO);
    let (seconds, ticks) = (since.as_secs(), since.subsec_nanos() / 100);
    let [year, month, day] = date(seconds / 86_400);
    let (hour, minute, second) = (seconds / 3600 % 24, seconds / 60 % 60, seconds % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{ticks:07}Z")
}

/// Year, month and day, so many days after the first of January 1970.
///
/// Years are counted from the first of March, so that the leap day is the last of a year; four hundred of them have
/// always the same number of days. Source: derived from the rule of the Gregorian calendar.
fn date(days: u64) -> [u64; 3] {
    const ERA: u64 = 146_097;
    // From the first of March of the year 0.
    let days = days + 719_468;
    let (era, day) = (days / ERA, days % ERA);
    // Leap days before this day of the era: one in four years, none in a hundred, but one in four hundred.
    let year = (day - day / 1460 + day / 36_524 - day / (ERA - 1)) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    // Five months from March on have 153 days, and so have the next five.
    let month = (5 * day + 2) / 153;
    let first = (153 * month + 2) / 5;
    let is_next = month >= 10;
    let year = 400 * era + year + u64::from(is_next);
    [year, if is_next { month - 9 } else { month + 3 }, day - first + 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments() {
        for (seconds, text) in [
            (0, "1970-01-01T00:00:00"),
            (951_782_400, "2000-02-29T00:00:00"),
            (951_868_800, "2000-03-01T00:00:00"),
            (1_709_164_799, "2024-02-28T23:59:59"),
            (1_735_689_599, "2024-12-31T23:59:59"),
            (4_107_542_400, "2100-03-01T00:00:00"),
        ] {
            let moment = UNIX_EPOCH + Duration::from_secs(seconds);
            assert_eq!(utc(moment), format!("{text}.0000000Z"));
        }
    }
}
