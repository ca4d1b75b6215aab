//! Rows of parallel planes, to cut things with.

use katydid_component::{Context, List, Message};
use katydid_geometry::{Curve, Interval, Plane};

/// The planes at all multiples of a distance from a first one that meet a range of heights over it, in order.
///
/// # Errors
/// The distance is not above 0, or makes too many planes.
pub(crate) fn row(
    context: &Context<'_>,
    first: &Plane,
    heights: Interval,
    distance: f64,
) -> Result<Vec<Plane>, Message> {
    if !(distance > 0.0 && distance.is_finite()) {
        return Err(Message::error(format!("Distance is {distance}, which must be greater than 0")));
    }
    // A plane that only touches an end of the range counts, rounding or not.
    let slack = context.tolerance().absolute.min(0.5 * distance) / distance;
    let low = (heights.start / distance - slack).ceil();
    let high = (heights.end / distance + slack).floor();
    if !(low.is_finite() && high.is_finite()) || high - low > 1e9 {
        return Err(Message::error("There are too many planes: the distance is too small for this shape"));
    }
    let count = (high - low).max(-1.0) as i64 + 1;
    context.items(usize::try_from(count).unwrap_or(0))?;
    Ok((0..count).map(|k| first.offset((low + k as f64) * distance)).collect())
}

/// The planes at offsets from a first one, or, without offsets, at distances from plane to plane.
///
/// # Errors
/// There are neither.
pub(crate) fn placed(
    first: &Plane,
    offsets: &List<'_, f64>,
    distances: &List<'_, f64>,
) -> Result<Vec<Plane>, Message> {
    let places: Vec<f64> = if offsets.is_empty() {
        let mut sum = 0.0;
        let step = |d| {
            sum += d;
            sum
        };
        distances.present().map(step).collect()
    } else {
        offsets.present().collect()
    };
    if places.is_empty() {
        return Err(Message::error("Offsets or distances are needed"));
    }
    Ok(places.into_iter().map(|place| first.offset(place)).collect())
}

/// The parameters at which a curve meets a plane, in order. A stretch in the plane counts with its two ends, the seam of
/// a closed curve once.
///
/// # Errors
/// The plane is not finite.
pub(crate) fn places_in(context: &Context<'_>, curve: &Curve, plane: &Plane) -> Result<Vec<f64>, Message> {
    let mut places = curve.intersect_plane(plane, context.tolerance().absolute)?;
    let domain = curve.domain();
    if curve.is_closed() && places.len() > 1 && places.first() == Some(&domain.start) {
        places.retain(|&t| t < domain.end);
    }
    Ok(places)
}
