//! Curves made of points, planes and numbers.

use katydid_geometry::{
    Arc, Circle, Curve as Kernel, Ellipse, Interval as Range, KnotSpacing, Line, NurbsCurve, Point3,
    PolylineCurve, Rectangle, join_curves, regular_polygon,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::{Curve, IntervalLike, PlaneLike, PointLike, VectorLike};
use crate::arrays::{numbers_in, numbers_out, points_in, points_out};
use crate::errors::kernel;

/// A number that is finite, by its name.
fn finite(name: &'static str, x: f64) -> PyResult<f64> {
    if x.is_finite() { Ok(x) } else { Err(kernel(katydid_geometry::Error::NotFinite(name))) }
}

fn whole(curve: Kernel) -> PyResult<Curve> {
    curve.check_finite().map_err(kernel)?;
    Ok(curve.into())
}

#[pymethods]
impl Curve {
    /// The straight line between two points.
    #[staticmethod]
    fn line(start: PointLike, end: PointLike) -> PyResult<Self> {
        whole(Line::new(start.0, end.0).into())
    }

    /// The polyline through points, an array of shape (n, 3).
    #[staticmethod]
    #[pyo3(signature = (points, *, closed=false))]
    fn polyline(points: &Bound<'_, PyAny>, closed: bool) -> PyResult<Self> {
        let mut points = points_in(points)?;
        if let (true, Some(first)) = (closed && points.first() != points.last(), points.first().copied()) {
            points.push(first);
        }
        whole(PolylineCurve::new(points).map_err(kernel)?.into())
    }

    /// The circle of a radius about the origin of a plane, in that plane.
    #[staticmethod]
    #[pyo3(signature = (plane, radius))]
    fn circle(plane: PlaneLike, radius: f64) -> PyResult<Self> {
        whole(Circle::new(plane.0, radius).map_err(kernel)?.into())
    }

    /// The part of a circle between two angles in radians from the plane's x axis.
    #[staticmethod]
    fn arc(plane: PlaneLike, radius: f64, angles: IntervalLike) -> PyResult<Self> {
        let circle = Circle::new(plane.0, radius).map_err(kernel)?;
        whole(Arc::new(circle, angles.0).map_err(kernel)?.into())
    }

    /// The arc from a point through a second to a third.
    #[staticmethod]
    fn arc_through(a: PointLike, b: PointLike, c: PointLike) -> PyResult<Self> {
        whole(Arc::through(a.0, b.0, c.0).map_err(kernel)?.into())
    }

    /// The ellipse with its radii along a plane's axes.
    #[staticmethod]
    fn ellipse(plane: PlaneLike, radius_x: f64, radius_y: f64) -> PyResult<Self> {
        let ellipse = Ellipse::new(plane.0, radius_x, radius_y).map_err(kernel)?;
        let turn = Range::new(0.0, std::f64::consts::TAU);
        whole(ellipse.arc_to_nurbs(turn, turn).map_err(kernel)?.into())
    }

    /// The rectangle about a plane's origin, with its sides along the axes.
    #[staticmethod]
    fn rectangle(plane: PlaneLike, width: f64, height: f64) -> PyResult<Self> {
        let half = |name, x: f64| finite(name, x).map(|x| Range::new(-0.5 * x, 0.5 * x));
        let rectangle = Rectangle { plane: plane.0, x: half("width", width)?, y: half("height", height)? };
        whole(rectangle.to_polyline().map_err(kernel)?.into())
    }

    /// The regular polygon with its corners on a circle, the first on the plane's x axis.
    #[staticmethod]
    fn polygon(plane: PlaneLike, radius: f64, sides: usize) -> PyResult<Self> {
        whole(regular_polygon(&plane.0, radius, sides).map_err(kernel)?.into())
    }

    /// The NURBS curve of control points, an array of shape (n, 3).
    ///
    /// Without knots they are uniform; with them there are n + degree - 1, as in openNURBS. Weights have shape (n,).
    #[staticmethod]
    #[pyo3(signature = (points, degree=3, *, weights=None, knots=None, periodic=false))]
    fn nurbs(
        points: &Bound<'_, PyAny>,
        degree: usize,
        weights: Option<&Bound<'_, PyAny>>,
        knots: Option<&Bound<'_, PyAny>>,
        periodic: bool,
    ) -> PyResult<Self> {
        let points = points_in(points)?;
        let weights = weights.map(numbers_in).transpose()?;
        let curve = match (knots.map(numbers_in).transpose()?, periodic) {
            (Some(_), true) => {
                return Err(PyValueError::new_err("a curve with knots of its own is periodic by them"));
            }
            (Some(knots), false) => NurbsCurve::new(degree, points.clone(), knots),
            (None, true) => NurbsCurve::periodic_uniform(degree, &points),
            (None, false) => NurbsCurve::clamped_uniform(degree, &points),
        };
        let curve = curve.map_err(kernel)?;
        let curve = match weights {
            Some(_) if periodic => return Err(PyValueError::new_err("weights need knots, or an open curve")),
            Some(weights) => {
                NurbsCurve::with_weights(degree, &points, &weights, curve.knots().to_vec()).map_err(kernel)?
            }
            None => curve,
        };
        whole(curve.into())
    }

    /// The curve through points, an array of shape (n, 3). `spacing` is "uniform", "chord" or "sqrt".
    #[staticmethod]
    #[pyo3(signature = (points, degree=3, *, spacing="chord", start_tangent=None, end_tangent=None, closed=false))]
    fn interpolate(
        points: &Bound<'_, PyAny>,
        degree: usize,
        spacing: &str,
        start_tangent: Option<VectorLike>,
        end_tangent: Option<VectorLike>,
        closed: bool,
    ) -> PyResult<Self> {
        let points = points_in(points)?;
        let spacing = match spacing {
            "uniform" => KnotSpacing::Uniform,
            "chord" => KnotSpacing::Chord,
            "sqrt" => KnotSpacing::SquareRootChord,
            other => {
                return Err(PyValueError::new_err(format!(
                    "spacing is \"uniform\", \"chord\" or \"sqrt\", not {other:?}"
                )));
            }
        };
        let made = if closed {
            NurbsCurve::interpolate_periodic(degree, &points, spacing)
        } else {
            let tangent = |vector: Option<VectorLike>| vector.map(|vector| vector.0);
            NurbsCurve::interpolate(degree, &points, spacing, tangent(start_tangent), tangent(end_tangent))
        };
        whole(made.map_err(kernel)?.into())
    }

    /// Curves that meet end to end within a tolerance as one each.
    #[staticmethod]
    #[pyo3(signature = (curves, tolerance=0.001))]
    fn join(curves: Vec<Self>, tolerance: f64) -> Vec<Self> {
        let curves: Vec<Kernel> = curves.iter().map(|curve| (*curve.0).clone()).collect();
        join_curves(&curves, tolerance, false).into_iter().map(Self::from).collect()
    }

    /// The degree; of a curve of another kind that of its NURBS form.
    #[getter]
    fn degree(&self) -> PyResult<usize> {
        self.0.to_nurbs().map(|curve| curve.degree()).map_err(kernel)
    }

    /// The control points as an array of shape (n, 3); of a curve of another kind those of its NURBS form.
    #[getter]
    fn control_points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let points: Vec<Point3> = self.0.to_nurbs().map_err(kernel)?.control_points();
        points_out(py, &points)
    }

    /// The weights of the control points as an array of shape (n,).
    #[getter]
    fn weights<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        numbers_out(py, &self.0.to_nurbs().map_err(kernel)?.weights())
    }

    /// The knots as an array of shape (n + degree - 1,), as openNURBS has them.
    #[getter]
    fn knots<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        numbers_out(py, self.0.to_nurbs().map_err(kernel)?.knots())
    }

    /// The same curve as one NURBS curve, exactly.
    fn to_nurbs(&self) -> PyResult<Self> {
        whole(self.0.to_nurbs().map_err(kernel)?.into())
    }
}
