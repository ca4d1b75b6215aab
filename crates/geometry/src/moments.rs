//! How much there is of something, where its middle lies and how it is spread.

use crate::{Error, Point3, Result, Vector3};

/// An area or a volume with its moments, as of a body of density 1.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MassProperties {
    /// The area in square units, or the volume in cubic ones.
    pub amount: f64,
    /// The mean of all points.
    pub centroid: Point3,
    /// The integrals of xx, yy, zz, xy, yz and zx about the centroid.
    pub second_moments: [f64; 6],
    /// How far the amount may be off, by the difference of two rules: an estimate, not a bound.
    pub error: f64,
}

impl MassProperties {
    /// The properties for the integrals of 1, x, y, z, xx, yy, zz, xy, yz and zx in coordinates from `centre` in
    /// units of `size`, for a body of `dimension` 2 or 3. A negative amount counts as seen from the other side.
    ///
    /// # Errors
    /// There is nothing, or a number overflows.
    pub(crate) fn of_integrals(
        integrals: [f64; 10],
        error: f64,
        centre: Point3,
        size: f64,
        dimension: i32,
    ) -> Result<Self> {
        let sign = if integrals[0] < 0.0 { -1.0 } else { 1.0 };
        let [amount, x, y, z, spread @ ..] = integrals.map(|value| sign * value);
        if !(amount > 0.0) {
            return Err(Error::degenerate("shape", "it encloses nothing"));
        }
        let mean = Vector3::new(x, y, z) / amount;
        let (m, unit) = ([mean.x, mean.y, mean.z], size.powi(dimension));
        let axes = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];
        let mut second_moments = [0.0; 6];
        for (k, (a, b)) in axes.into_iter().enumerate() {
            second_moments[k] = (spread[k] - amount * m[a] * m[b]) * unit * size * size;
        }
        let found = Self {
            amount: amount * unit,
            centroid: centre + mean * size,
            second_moments,
            error: error * unit,
        };
        let finite = found.amount.is_finite()
            && found.centroid.is_finite()
            && found.second_moments.iter().all(|x| x.is_finite());
        if finite { Ok(found) } else { Err(Error::NotFinite("moments of the shape")) }
    }

    /// The first moments about a point: the integrals of x, y and z from there.
    pub fn first_moments_about(&self, origin: Point3) -> Vector3 {
        (self.centroid - origin) * self.amount
    }

    /// The integrals of xx, yy, zz, xy, yz and zx about a point, by the parallel axis theorem.
    pub fn second_moments_about(&self, origin: Point3) -> [f64; 6] {
        let d = self.centroid - origin;
        let shift = [d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.y * d.z, d.z * d.x];
        let mut out = self.second_moments;
        for (moment, shift) in out.iter_mut().zip(shift) {
            *moment += self.amount * shift;
        }
        out
    }

    /// The moments of inertia about lines through a point along the world's axes: of yy + zz, zz + xx and xx + yy.
    pub fn inertia_about(&self, origin: Point3) -> Vector3 {
        let [x, y, z, ..] = self.second_moments_about(origin);
        Vector3::new(y + z, z + x, x + y)
    }

    /// The radii of gyration about lines through a point along the world's axes: the distances at which all of it
    /// would have the same inertia.
    pub fn gyration_about(&self, origin: Point3) -> Vector3 {
        let inertia = self.inertia_about(origin);
        let radius = |moment: f64| (moment / self.amount).max(0.0).sqrt();
        Vector3::new(radius(inertia.x), radius(inertia.y), radius(inertia.z))
    }

    /// Several bodies as one.
    ///
    /// # Errors
    /// There are none, or a number overflows.
    pub fn together(parts: &[Self]) -> Result<Self> {
        let first = parts.first().ok_or(Error::degenerate("shape", "it encloses nothing"))?;
        let centre = first.centroid;
        let (mut integrals, mut error) = ([0.0; 10], 0.0);
        for part in parts {
            let first = part.first_moments_about(centre);
            let second = part.second_moments_about(centre);
            let own = [part.amount, first.x, first.y, first.z].into_iter().chain(second);
            integrals.iter_mut().zip(own).for_each(|(sum, value)| *sum += value);
            error += part.error;
        }
        Self::of_integrals(integrals, error, centre, 1.0, 2)
    }
}
