//! Curves with uniform knots from their control points, and Bézier curves.

use super::NurbsCurve;
use super::knots::MAX_DEGREE;
use crate::{Error, Point3, Result};

/// Uniform clamped knots 0, …, 0, 1, 2, …, n, …, n for `count` control points, in the openNURBS form.
///
/// # Errors
/// The degree is not 1…31, or there are fewer than degree + 1 control points.
pub fn clamped_uniform_knots(degree: usize, count: usize) -> Result<Vec<f64>> {
    check(degree, count, degree + 1)?;
    let last = (count - degree) as f64;
    let inner = (1..count - degree).map(|i| i as f64);
    Ok(std::iter::repeat_n(0.0, degree).chain(inner).chain(std::iter::repeat_n(last, degree)).collect())
}

/// Uniform simple knots 1 − degree, …, 0, 1, 2, … for `count` control points, in the openNURBS form. The domain
/// starts at 0.
///
/// # Errors
/// The degree is not 1…31, or there are fewer than degree + 1 control points.
pub fn periodic_uniform_knots(degree: usize, count: usize) -> Result<Vec<f64>> {
    check(degree, count, degree + 1)?;
    Ok((0..count + degree - 1).map(|i| i as f64 - (degree as f64 - 1.0)).collect())
}

fn check(degree: usize, count: usize, least: usize) -> Result<()> {
    if degree == 0 || degree > MAX_DEGREE {
        return Err(Error::OutOfRange { what: "degree", value: degree as f64, must: "from 1 to 31" });
    }
    if count < least {
        return Err(Error::Invalid {
            what: "NURBS control points",
            why: format!("degree {degree} needs at least {least} of them, got {count}"),
        });
    }
    Ok(())
}

impl NurbsCurve {
    /// The clamped uniform curve with these control points; domain 0…count − degree.
    ///
    /// # Errors
    /// Fewer than degree + 1 points, a degree outside 1…31, or a point that is not finite.
    pub fn clamped_uniform(degree: usize, points: &[Point3]) -> Result<Self> {
        let knots = clamped_uniform_knots(degree, points.len())?;
        Self::new(degree, points.to_vec(), knots)
    }

    /// The periodic uniform curve around these control points: the first `degree` of them are repeated at the end,
    /// so there are count + degree; all knots are simple and the domain is 0…count.
    ///
    /// # Errors
    /// Fewer points than the degree or than 2, a degree outside 1…31, or a point that is not finite.
    pub fn periodic_uniform(degree: usize, points: &[Point3]) -> Result<Self> {
        check(degree, points.len(), degree.max(2))?;
        let wrapped: Vec<_> = points.iter().chain(points.iter().take(degree)).copied().collect();
        let knots = periodic_uniform_knots(degree, wrapped.len())?;
        Self::new(degree, wrapped, knots)
    }

    /// The Bézier curve with these control points, over 0…1.
    ///
    /// # Errors
    /// Fewer than 2 or more than 32 points, or one that is not finite.
    pub fn bezier(points: &[Point3]) -> Result<Self> {
        let degree = points.len().saturating_sub(1);
        Self::clamped_uniform(degree, points)
    }
}
