//! The area of a surface, where its middle is, and how it is spread.

use katydid_elementary::Elementary;

use super::Surface;
use crate::quadrature::{GAUSS_6, GAUSS_10};
use crate::surface::thresholds::{AREA_SHARE, FINEST_AREA};
use crate::{Direction, Error, NurbsSurface, Point3, Quadrant, Result, Vector3};

/// The area of an untrimmed surface and the moments of it, as of a thin sheet of density 1.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SurfaceArea {
    /// In square units.
    pub area: f64,
    /// The middle: the mean of all points by area.
    pub centroid: Point3,
    /// The integrals of xx, yy, zz, xy, yz and zx about the centroid.
    pub second_moments: [f64; 6],
}

/// The most halvings of a rectangle, and how many rectangles may be looked at.
const DEEPEST: u32 = 40;
const MOST: u32 = 20_000;

impl NurbsSurface {
    /// The area with its centroid and second moments, to within a fraction of the area (10⁻¹³ to 0.1; others count as
    /// the nearest of them); the moments to the same fraction of area times size, or size squared.
    ///
    /// Gauss–Legendre rules of 6 and 10 points each way on every polynomial patch, halved where they differ by more
    /// than is allowed: collapsed sides and creases are closed in on. At most 20,000 rectangles are looked at.
    ///
    /// # Errors
    /// The surface has no area, or a number overflows.
    pub fn area_within(&self, fraction: f64) -> Result<SurfaceArea> {
        let middle = self.control_points();
        let centre = middle.iter().fold(Vector3::ZERO, |s, p| s + p.to_vector()) / middle.len() as f64;
        let size = middle.iter().map(|p| p.distance_to(centre.to_point())).fold(f64::MIN_POSITIVE, f64::max);
        let density = |u: f64, v: f64| {
            let [p, by_u, by_v] = self.partials_at(u, v, Quadrant::NorthEast);
            let patch = by_u.cross(by_v).length();
            let p = (p - centre) / size;
            [1.0, p.x, p.y, p.z, p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x]
                .map(|x| x * patch)
        };
        let fraction = fraction.clamp(FINEST_AREA, 0.1);
        let (us, vs) = (self.span_parameters(Direction::U), self.span_parameters(Direction::V));
        let mut patches = Vec::with_capacity(us.len() * vs.len());
        for u in us.windows(2) {
            for v in vs.windows(2) {
                let cell = [[u[0], u[1]], [v[0], v[1]]];
                patches.push((cell, rule(&density, cell, &GAUSS_10), 0_u32));
            }
        }
        let total: f64 = patches.iter().map(|p| p.1[0]).sum();
        let share = 1.0 / patches.len().max(1) as f64;
        let mut sum = [0.0; 10];
        let mut looked = 0;
        while let Some((cell, fine, depth)) = patches.pop() {
            looked += 1;
            let coarse = rule(&density, cell, &GAUSS_6);
            let error = (0..10).map(|k| (fine[k] - coarse[k]).abs()).fold(0.0, f64::max);
            // The finer rule has gained at least half as many digits again as the two have in common.
            let scale = fine[0].abs();
            let estimate =
                if scale > 0.0 { error.min(scale * (100.0 * error / scale).raised_to(1.5)) } else { error };
            let allowed = fraction * fine[0].max(0.1 * share * total);
            if !(estimate > allowed) || depth >= DEEPEST || looked >= MOST {
                (0..10).for_each(|k| sum[k] += fine[k]);
                continue;
            }
            // Across the direction in which halving changes the integral more.
            let halves = |d: usize| {
                let middle = 0.5 * (cell[d][0] + cell[d][1]);
                let (mut low, mut high) = (cell, cell);
                low[d][1] = middle;
                high[d][0] = middle;
                [low, high].map(|c| (c, rule(&density, c, &GAUSS_10), depth + 1))
            };
            let both = [halves(0), halves(1)];
            let change = |h: &[(Cell, [f64; 10], u32); 2]| {
                (0..10).map(|k| (h[0].1[k] + h[1].1[k] - fine[k]).abs()).fold(0.0, f64::max)
            };
            let [u, v] = both;
            patches.extend(if change(&u) >= change(&v) { u } else { v });
        }
        let area = sum[0];
        if !(area > 0.0) {
            return Err(Error::degenerate("surface", "it has no area"));
        }
        let mean = Vector3::new(sum[1], sum[2], sum[3]) / area;
        let centroid = (centre + mean * size).to_point();
        let m = [mean.x, mean.y, mean.z];
        let moment = |k: usize, a: usize, b: usize| (sum[k] - area * m[a] * m[b]) * size * size;
        let second_moments = [
            moment(4, 0, 0),
            moment(5, 1, 1),
            moment(6, 2, 2),
            moment(7, 0, 1),
            moment(8, 1, 2),
            moment(9, 2, 0),
        ];
        if !(area.is_finite() && centroid.is_finite() && second_moments.iter().all(|x| x.is_finite())) {
            return Err(Error::NotFinite("area of the surface"));
        }
        Ok(SurfaceArea { area, centroid, second_moments })
    }
}

type Cell = [[f64; 2]; 2];

/// The product rule over a rectangle.
fn rule(f: &impl Fn(f64, f64) -> [f64; 10], cell: Cell, gauss: &[[f64; 2]]) -> [f64; 10] {
    let middle = cell.map(|[a, b]| 0.5 * (a + b));
    let half = cell.map(|[a, b]| 0.5 * (b - a));
    let mut sum = [0.0; 10];
    for &[x, wx] in gauss {
        for &[y, wy] in gauss {
            for (sx, sy) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                let value = f(middle[0] + sx * half[0] * x, middle[1] + sy * half[1] * y);
                (0..10).for_each(|k| sum[k] += wx * wy * value[k]);
            }
        }
    }
    sum.map(|x| x * half[0] * half[1])
}

impl Surface {
    /// The area of the whole surface, to about 10⁻¹⁰ of itself, with its centroid and second moments.
    ///
    /// # Errors
    /// The surface has no area, or a number overflows.
    pub fn area(&self) -> Result<SurfaceArea> {
        self.area_within(AREA_SHARE)
    }

    /// The area to within a fraction of itself, see [`NurbsSurface::area_within`].
    ///
    /// # Errors
    /// As [`Surface::area`].
    pub fn area_within(&self, fraction: f64) -> Result<SurfaceArea> {
        match self {
            Self::Nurbs(s) => s.area_within(fraction),
            _ => self.to_nurbs()?.area_within(fraction),
        }
    }
}
