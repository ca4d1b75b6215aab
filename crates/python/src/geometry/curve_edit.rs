//! Curves made of curves, and points of curves on polylines.

use katydid_geometry::{ExtensionStyle, OffsetCorner, PolylineLimits, TweenMatch};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::{Curve, IntervalLike, PlaneLike, tolerance};
use crate::arrays::{numbers_in, points_out};
use crate::errors::kernel;

#[pymethods]
impl Curve {
    /// The curve run through the other way.
    fn reversed(&self) -> Self {
        self.0.reversed().into()
    }

    /// The part over a range of parameters.
    fn trimmed(&self, domain: IntervalLike) -> PyResult<Self> {
        self.0.trimmed(domain.0).map(Self::from).map_err(kernel)
    }

    /// The same curve with another range of parameters.
    fn with_domain(&self, domain: IntervalLike) -> PyResult<Self> {
        self.0.with_domain(domain.0).map(Self::from).map_err(kernel)
    }

    /// The closed curve with its seam at a parameter.
    fn with_seam(&self, t: f64) -> PyResult<Self> {
        self.0.with_seam(t).map(Self::from).map_err(kernel)
    }

    /// The parts between parameters, an array of shape (n,).
    fn split(&self, t: &Bound<'_, PyAny>) -> PyResult<Vec<Self>> {
        let t = match t.extract::<f64>() {
            Ok(t) => vec![t],
            Err(_) => numbers_in(t)?,
        };
        Ok(self.0.split_at(&t).map_err(kernel)?.into_iter().map(Self::from).collect())
    }

    /// The segments of which it is joined.
    #[pyo3(signature = (*, recursive=true))]
    fn explode(&self, recursive: bool) -> PyResult<Vec<Self>> {
        Ok(self.0.explode(recursive).map_err(kernel)?.into_iter().map(Self::from).collect())
    }

    /// The curve made longer at its ends. `style` is "line", "arc" or "smooth".
    #[pyo3(signature = (start=0.0, end=0.0, *, style="line"))]
    fn extended(&self, start: f64, end: f64, style: &str) -> PyResult<Self> {
        let style = match style {
            "line" => ExtensionStyle::Line,
            "arc" => ExtensionStyle::Arc,
            "smooth" => ExtensionStyle::Smooth,
            other => {
                return Err(PyValueError::new_err(format!(
                    "style is \"line\", \"arc\" or \"smooth\", not {other:?}"
                )));
            }
        };
        self.0.extended(start, end, style).map(Self::from).map_err(kernel)
    }

    /// Curves at a distance in a plane, its own where none is given: positive to the right as seen along the normal's
    /// tip. `corner` is "none", "sharp", "round", "smooth" or "chamfer".
    #[pyo3(signature = (distance, plane=None, *, corner="sharp", tolerance=0.001))]
    fn offset(
        &self,
        py: Python<'_>,
        distance: f64,
        plane: Option<PlaneLike>,
        corner: &str,
        tolerance: f64,
    ) -> PyResult<Vec<Self>> {
        let corner = match corner {
            "none" => OffsetCorner::None,
            "sharp" => OffsetCorner::Sharp,
            "round" => OffsetCorner::Round,
            "smooth" => OffsetCorner::Smooth,
            "chamfer" => OffsetCorner::Chamfer,
            other => {
                return Err(PyValueError::new_err(format!(
                    "corner is \"none\", \"sharp\", \"round\", \"smooth\" or \"chamfer\", not {other:?}"
                )));
            }
        };
        let plane = match plane {
            Some(plane) => plane.0,
            None => self.0.plane(tolerance).unwrap_or(katydid_geometry::Plane::XY),
        };
        let curve = self.0.clone();
        let made = crate::work::interruptible(py, move || {
            curve.offset(&plane, distance, corner, &self::tolerance(tolerance))
        })?;
        Ok(made.into_iter().map(Self::from).collect())
    }

    /// The curve with its corners rounded by arcs of a radius, where there is room.
    #[pyo3(signature = (radius, *, tolerance=0.001))]
    fn filleted(&self, radius: f64, tolerance: f64) -> PyResult<Self> {
        self.0
            .fillet_corners(radius, &self::tolerance(tolerance))
            .map(|(curve, _)| curve.into())
            .map_err(kernel)
    }

    /// A curve of a degree and a number of control points that follows this one, and the largest distance from it.
    #[pyo3(signature = (count, degree=3, *, keep_tangents=true))]
    fn rebuilt(&self, count: usize, degree: usize, keep_tangents: bool) -> PyResult<(Self, f64)> {
        let made = self.0.rebuilt(degree, count, keep_tangents).map_err(kernel)?;
        Ok((katydid_geometry::Curve::from(made.curve).into(), made.deviation))
    }

    /// The curve between this one and another: this one at 0, the other at 1.
    fn tween(&self, other: &Self, x: f64) -> PyResult<Self> {
        let made = self.0.tween(&other.0, x, TweenMatch::ControlPoints).map_err(kernel)?;
        Ok(katydid_geometry::Curve::from(made).into())
    }

    /// Points on the curve, as an array of shape (n, 3), such that it stays within a distance of the polyline through them.
    #[pyo3(signature = (tolerance=0.001))]
    fn to_polyline<'py>(&self, py: Python<'py>, tolerance: f64) -> PyResult<Bound<'py, PyAny>> {
        let made = py.detach(|| self.0.to_polyline(&PolylineLimits::within(tolerance))).map_err(kernel)?;
        points_out(py, made.points())
    }

    /// The corners of a polyline as an array of shape (n, 3); none for a curve that is not made of straight segments.
    fn corners<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.0.as_polyline().map(|points| points_out(py, &points)).transpose()
    }
}
