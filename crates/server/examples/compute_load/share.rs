//! Percentiles.

use std::time::Duration;

/// The value below which so large a part of sorted values lies.
pub(crate) fn at<T>(sorted: &[T], part: f64) -> Option<&T> {
    sorted.get(((sorted.len() as f64 * part) as usize).min(sorted.len().saturating_sub(1)))
}

pub(crate) fn milliseconds(sorted: &[Duration], part: f64) -> f64 {
    at(sorted, part).map_or(0.0, |time| time.as_secs_f64() * 1e3)
}
