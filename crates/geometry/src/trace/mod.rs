//! Following the curve that two surfaces have in common, by steps that are proved not to leave it for another one.

mod fit;
mod follow;
mod newton;
mod proof;

pub(crate) use fit::{fitted, fitted_within};
pub(crate) use follow::{Cubic, End, Followed, Limits, followed};
pub(crate) use newton::{Condition, solved};
pub(crate) use proof::Box4;

use crate::Vector3;
use crate::chart::{Carrier, Chart, thresholds};

/// The parameters on both surfaces: u and v on the first, then on the second.
pub(crate) type Four = [f64; 4];

/// Two surfaces that may meet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair<'a> {
    pub(crate) charts: [&'a Chart; 2],
    /// Distances below this are rounding.
    pub(crate) noise: f64,
    /// Which of the surfaces is a part of a plane or another carrier, covered once, and the carrier: what they have in common is
    /// a question of the other surface alone.
    pub(crate) carrier: Option<(usize, Carrier)>,
}

/// A place of the common curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    pub(crate) x: Four,
    /// Halfway between both surfaces.
    pub(crate) point: Vector3,
    /// The unit direction of the curve: along the product of the first normal and the second.
    pub(crate) tangent: Vector3,
    /// The derivative of the parameters by the length of the curve.
    pub(crate) velocity: Four,
    /// The sine of the angle between the surfaces.
    pub(crate) angle: f64,
}

/// The parameters on one of the surfaces.
pub(crate) fn on(x: Four, surface: usize) -> [f64; 2] {
    [x[2 * surface], x[2 * surface + 1]]
}

impl<'a> Pair<'a> {
    /// Two surfaces, and what is rounding on both.
    pub(crate) fn new(a: &'a Chart, b: &'a Chart) -> Self {
        let far = [a, b].map(|c| {
            let bounds = c.nurbs().hull_box();
            bounds.min.to_vector().length().max(bounds.max.to_vector().length())
        });
        Self { charts: [a, b], noise: thresholds::noise([a.size(), b.size()], far), carrier: None }
    }

    /// The smaller of the surfaces' sizes.
    pub(crate) fn size(&self) -> f64 {
        self.charts[0].size().min(self.charts[1].size())
    }

    /// The range of one of the four parameters.
    pub(crate) fn domain(&self, k: usize) -> crate::Interval {
        self.charts[k / 2].domain(k % 2)
    }

    /// Positions and derivatives on both.
    pub(crate) fn jets(&self, x: Four) -> [[Vector3; 3]; 2] {
        [self.charts[0].jet(on(x, 0)), self.charts[1].jet(on(x, 1))]
    }

    /// What the curve does at parameters that lie on it; `None` where the surfaces have one tangent plane or none.
    pub(crate) fn place(&self, x: Four) -> Option<Place> {
        let jets = self.jets(x);
        let [m, n] = [0, 1].map(|s| jets[s][1].cross(jets[s][2]).unitized());
        let cross = m?.cross(n?);
        let angle = cross.length();
        if !(angle > thresholds::TANGENT) {
            return None;
        }
        let tangent = cross / angle;
        let [a, b] = [Chart::lifted(&jets[0], tangent)?, Chart::lifted(&jets[1], tangent)?];
        Some(Place {
            x,
            point: (jets[0][0] + jets[1][0]) * 0.5,
            tangent,
            velocity: [a[0], a[1], b[0], b[1]],
            angle,
        })
    }

    /// The direction of the common curve at the middle of a box, if there is one: that of a carrier's contour where the other
    /// surface is.
    pub(crate) fn along(&self, b: Box4) -> Option<Vector3> {
        let middle = b.map(|[low, high]| 0.5 * (low + high));
        let normal = |s: usize| {
            let [_, u, v] = self.charts[s].jet(on(middle, s));
            u.cross(v).unitized()
        };
        match &self.carrier {
            Some((s, carrier)) => {
                let [point, u, v] = self.charts[1 - s].jet(on(middle, 1 - s));
                let out = carrier.gradient(point.to_point()).unitized()?;
                u.cross(v).unitized()?.cross(out).unitized()
            }
            None => normal(0)?.cross(normal(1)?).unitized(),
        }
    }

    /// How far one parameter may lie beyond its domain and still count as on its side.
    pub(crate) fn slack(&self, k: usize) -> f64 {
        thresholds::ON_SIDE * self.domain(k).length()
    }

    /// Which parameters lie beyond their domain, and at which end.
    pub(crate) fn beyond(&self, x: Four) -> [Option<bool>; 4] {
        std::array::from_fn(|k| {
            let domain = self.domain(k);
            if x[k] < domain.start - self.slack(k) {
                Some(false)
            } else if x[k] > domain.end + self.slack(k) {
                Some(true)
            } else {
                None
            }
        })
    }

    /// Parameters that are beyond their domain by rounding, put on its side.
    pub(crate) fn clamped(&self, x: Four) -> Four {
        std::array::from_fn(|k| self.domain(k).clamp(x[k]))
    }
}
