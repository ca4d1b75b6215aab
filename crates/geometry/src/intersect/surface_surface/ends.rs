//! Curves that stop short of a place where they cross another one are led into it.
//!
//! Steps are proved up to where the surfaces are nearly tangent. The crossing itself is known to rounding
//! from its own search, so that one more piece reaches it: an arc that turns as much after its middle as before.

use super::rows::Row;
use super::{SurfaceContact, SurfaceContactKind};
use crate::chart::thresholds::{AT_CONTACT, INTO_CONTACT, SAME_PLACE};
use crate::trace::{Four, Pair, Place, on};

/// Adds the crossing to each end of an open curve that stops before it.
pub(super) fn led_in(pair: &Pair<'_>, rows: &mut [Row], contacts: &[SurfaceContact]) {
    for row in rows.iter_mut().filter(|r| !r.closed) {
        if let Some(place) = row.places.last().and_then(|end| reached(pair, end, 1.0, contacts)) {
            row.places.push(place);
        }
        if let Some(place) = row.places.first().and_then(|end| reached(pair, end, -1.0, contacts)) {
            row.places.insert(0, place);
        }
    }
}

/// The crossing that a curve runs into beyond its end, along its tangent (1) or against it (-1).
fn reached(pair: &Pair<'_>, end: &Place, sign: f64, contacts: &[SurfaceContact]) -> Option<Place> {
    let size = pair.size();
    let on_side = (0..4).any(|k| {
        let domain = pair.domain(k);
        end.x[k] <= domain.start + pair.slack(k) || end.x[k] >= domain.end - pair.slack(k)
    });
    if on_side {
        return None;
    }
    contacts
        .iter()
        .filter(|c| c.kind == SurfaceContactKind::Crossing)
        .filter_map(|c| {
            let way = c.point.to_vector() - end.point;
            let gap = way.length();
            if gap > AT_CONTACT * size || gap <= SAME_PLACE * size {
                return None;
            }
            let along = way * (sign / gap);
            (along.dot(end.tangent) >= INTO_CONTACT).then_some((gap, along, c))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(gap, along, contact)| {
            let mut x: Four = [0.0; 4];
            for s in 0..2 {
                let at = pair.charts[s].unwrapped(contact.at[s], on(end.x, s));
                x[2 * s] = at[0];
                x[2 * s + 1] = at[1];
            }
            Place {
                x,
                point: contact.point.to_vector(),
                tangent: along * (2.0 * along.dot(end.tangent)) - end.tangent,
                velocity: std::array::from_fn(|k| 2.0 * sign * (x[k] - end.x[k]) / gap - end.velocity[k]),
                angle: 0.0,
            }
        })
}
