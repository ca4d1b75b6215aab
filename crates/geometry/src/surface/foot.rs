//! The nearest places of a surface for points along a curve.

use super::local_foot::LocalFoot;
use super::{ClosestOnSurface, Surface};
use crate::surface::thresholds::{FOOT_STEP, NEARER_ONLY, SETTLED_FOOT};
use crate::thresholds;
use crate::{Direction, Point3, Result, Side, Vector3};

/// The parameters along a curve that lies on a surface or near it.
pub(crate) struct Foot<'a> {
    local: LocalFoot<'a>,
    index: ClosestOnSurface,
    last: Option<[f64; 2]>,
}

impl<'a> Foot<'a> {
    pub(crate) fn new(surface: &'a Surface) -> Result<Self> {
        let periods = Direction::BOTH
            .map(|d| surface.is_closed(d).then(|| surface.domain(d).length()).filter(|p| *p > 0.0));
        let local = LocalFoot { surface, periods };
        Ok(Self { local, index: ClosestOnSurface::new(surface)?, last: None })
    }

    /// The place nearest to a point, on that turn of a closed surface that is nearest to a known place.
    pub(crate) fn at(&mut self, p: Point3, near: Option<[f64; 2]>) -> Result<[f64; 2]> {
        // Where the foot is about known, only a nearer one is looked for.
        let guess = near.map(|near| self.local.polished(near, p, 0.05));
        let guess = guess.and_then(|(uv, step)| (step < SETTLED_FOOT).then_some(uv));
        let reach = guess.map(|uv| self.image(Point3::new(uv[0], uv[1], 0.0)).distance_to(p));
        let reach = reach.filter(|reach| reach.is_finite());
        let found = match reach {
            Some(reach) => self.index.nearest_within(p, (1.0 - NEARER_ONLY) * reach)?,
            None => Some(self.index.nearest(p)?),
        };
        let Some(found) = found else {
            self.last = guess;
            return Ok(guess.unwrap_or_default());
        };
        let mut uv = [found.u, found.v];
        if let Some(near) = near.or(self.last) {
            for k in 0..2 {
                if let Some(period) = self.local.periods[k] {
                    uv[k] += ((near[k] - uv[k]) / period).round() * period;
                }
            }
            // Along a singular side every parameter is as good: the known one is.
            for (k, direction) in Direction::BOTH.into_iter().enumerate() {
                let across = self.local.surface.domain(direction.other());
                let other = uv[1 - k];
                let sides = match direction {
                    Direction::U => [Side::South, Side::North],
                    Direction::V => [Side::West, Side::East],
                };
                let least = thresholds::SAME_PARAMETER * across.length();
                if ((other - across.start).abs() < least && self.local.surface.is_singular(sides[0]))
                    || ((other - across.end).abs() < least && self.local.surface.is_singular(sides[1]))
                {
                    uv[k] = near[k];
                }
            }
        }
        let (uv, _) = self.local.polished(uv, p, FOOT_STEP);
        self.last = Some(uv);
        Ok(uv)
    }

    /// See [`LocalFoot::slope`].
    pub(crate) fn slope(&self, uv: [f64; 2], place: Vector3, velocity: Vector3) -> Option<[f64; 2]> {
        self.local.slope(uv, place, velocity)
    }

    /// How a place of the surface moves whose parameters change at a rate.
    pub(crate) fn velocity(&self, uv: [f64; 2], rate: [f64; 2]) -> Vector3 {
        let [by_u, by_v] = self.local.partials(uv);
        by_u * rate[0] + by_v * rate[1]
    }

    /// The image of parameters on any turn.
    pub(crate) fn image(&self, uv: Point3) -> Point3 {
        self.local.image(uv)
    }
}
