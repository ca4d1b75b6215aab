//! Solids and surfaces made of curves and numbers, and what shapes have in common.

use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::construct::{
    self as make, LoftOptions, LoftStyle, Miter, PipeCap, SweepFrame, SweepOptions,
};
use katydid_geometry::{
    Brep as KernelBrep, Cone, Curve as KernelCurve, Cylinder, Interval as Range, Line, Sphere, Torus,
    intersect as meet,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;

use super::{Brep, Curve, IntervalLike, Plane, PlaneLike, Point, PointLike, Surface, VectorLike};
use crate::errors::{GeometryError, kernel};
use crate::work::interruptible;

fn shapes(curves: &[Curve]) -> Vec<KernelCurve> {
    curves.iter().map(|curve| (*curve.0).clone()).collect()
}

/// The sphere of a radius about a plane's origin or a point.
#[pyfunction]
pub(crate) fn sphere(plane: PlaneLike, radius: f64) -> PyResult<Brep> {
    make::sphere(&Sphere::new(plane.0, radius).map_err(kernel)?).map(Brep::from).map_err(kernel)
}

/// The cylinder of a radius and a height over a plane, closed by discs where `capped`.
#[pyfunction]
#[pyo3(signature = (plane, radius, height, *, capped=true))]
pub(crate) fn cylinder(plane: PlaneLike, radius: f64, height: f64, capped: bool) -> PyResult<Brep> {
    let shape = Cylinder::new(plane.0, radius, Range::new(0.0, height)).map_err(kernel)?;
    make::cylinder(&shape, [capped; 2]).map(Brep::from).map_err(kernel)
}

/// The cone with its base of a radius in a plane and its apex at a height over it, closed by a disc where `capped`.
#[pyfunction]
#[pyo3(signature = (plane, radius, height, *, capped=true))]
pub(crate) fn cone(plane: PlaneLike, radius: f64, height: f64, capped: bool) -> PyResult<Brep> {
    // The kernel's cone has its apex at the origin of its plane.
    let apex = plane.0.offset(height);
    make::cone(&Cone::new(apex, -height, radius).map_err(kernel)?, capped).map(Brep::from).map_err(kernel)
}

/// The torus about a plane's normal: the radius of its middle circle, and that of the tube.
#[pyfunction]
pub(crate) fn torus(plane: PlaneLike, major_radius: f64, minor_radius: f64) -> PyResult<Brep> {
    make::torus(&Torus::new(plane.0, major_radius, minor_radius).map_err(kernel)?)
        .map(Brep::from)
        .map_err(kernel)
}

/// The surface that a curve draws along a direction; a solid where the curve is closed and planar, and `capped`.
#[pyfunction]
#[pyo3(signature = (profile, direction, *, capped=false, tolerance=0.001))]
pub(crate) fn extrude(
    py: Python<'_>,
    profile: Curve,
    direction: VectorLike,
    capped: bool,
    tolerance: f64,
) -> PyResult<Brep> {
    let work = move || make::extrude(&profile.0, direction.0, capped, &super::tolerance(tolerance));
    interruptible(py, work).map(Brep::from)
}

/// The surface of a curve turned about the axis between two points, over angles in radians.
#[pyfunction]
#[pyo3(signature = (profile, axis, angles=IntervalLike(Range::new(0.0, std::f64::consts::TAU)), *, tolerance=0.001))]
pub(crate) fn revolve(
    py: Python<'_>,
    profile: Curve,
    axis: (PointLike, PointLike),
    angles: IntervalLike,
    tolerance: f64,
) -> PyResult<Brep> {
    let axis = Line::new(axis.0.0, axis.1.0);
    let work = move || make::revolve(&profile.0, axis, angles.0, &super::tolerance(tolerance));
    interruptible(py, work).map(Brep::from)
}

/// The surface through curves in their order. `style` is "normal", "loose", "tight", "straight", "developable" or
/// "uniform".
#[pyfunction]
#[pyo3(signature = (sections, *, style="normal", closed=false, adjust=true, tolerance=0.001))]
pub(crate) fn loft(
    py: Python<'_>,
    sections: Vec<Curve>,
    style: &str,
    closed: bool,
    adjust: bool,
    tolerance: f64,
) -> PyResult<Brep> {
    let style = match style {
        "normal" => LoftStyle::Normal,
        "loose" => LoftStyle::Loose,
        "tight" => LoftStyle::Tight,
        "straight" => LoftStyle::Straight,
        "developable" => LoftStyle::Developable,
        "uniform" => LoftStyle::Uniform,
        other => return Err(PyValueError::new_err(format!("there is no style of loft called {other:?}"))),
    };
    let options = LoftOptions { style, closed, adjust, ..LoftOptions::default() };
    let sections = shapes(&sections);
    interruptible(py, move || make::loft(&sections, &options, &super::tolerance(tolerance))).map(Brep::from)
}

/// The surfaces that sections draw along one rail, or two. Along one they turn as little as they can, or keep upright
/// against `up`.
#[pyfunction]
#[pyo3(signature = (rail, sections, *, second_rail=None, up=None, tolerance=0.001))]
pub(crate) fn sweep(
    py: Python<'_>,
    rail: Curve,
    sections: Vec<Curve>,
    second_rail: Option<Curve>,
    up: Option<VectorLike>,
    tolerance: f64,
) -> PyResult<Vec<Brep>> {
    let frame = up.map_or(SweepFrame::Freeform, |up| SweepFrame::Roadlike(up.0));
    let options = SweepOptions { frame, miter: Miter::default() };
    let sections = shapes(&sections);
    let made = interruptible(py, move || {
        let tolerance = super::tolerance(tolerance);
        match second_rail {
            Some(second) => make::sweep_two([&rail.0, &second.0], &sections, false, &tolerance),
            None => make::sweep_one(&rail.0, &sections, &options, &tolerance),
        }
    })?;
    Ok(made.into_iter().map(Brep::from).collect())
}

/// The pipe of a radius about a curve. `cap` is "none", "flat" or "round".
#[pyfunction]
#[pyo3(signature = (rail, radius, *, cap="flat", tolerance=0.001))]
pub(crate) fn pipe(py: Python<'_>, rail: Curve, radius: f64, cap: &str, tolerance: f64) -> PyResult<Brep> {
    let cap = match cap {
        "none" => PipeCap::None,
        "flat" => PipeCap::Flat,
        "round" => PipeCap::Round,
        other => {
            return Err(PyValueError::new_err(format!(
                "cap is \"none\", \"flat\" or \"round\", not {other:?}"
            )));
        }
    };
    interruptible(py, move || make::pipe(&rail.0, radius, cap, &super::tolerance(tolerance))).map(Brep::from)
}

/// The flat faces that closed planar curves bound; curves inside others are holes.
#[pyfunction]
#[pyo3(signature = (curves, tolerance=0.001))]
pub(crate) fn planar_faces(py: Python<'_>, curves: Vec<Curve>, tolerance: f64) -> PyResult<Vec<Brep>> {
    let curves = shapes(&curves);
    let made = interruptible(py, move || KernelBrep::planar_faces(&curves, &super::tolerance(tolerance)))?;
    Ok(made.breps.into_iter().map(Brep::from).collect())
}

/// A shape that others may meet.
#[derive(FromPyObject)]
pub(crate) enum Meeting<'py> {
    Curve(Curve),
    Surface(Surface),
    Brep(Brep),
    Plane(Plane),
    Other(Bound<'py, PyAny>),
}

/// What a curve has in common with another curve, a plane, a surface or a Brep: the points, and the parameters on the
/// curve where they are, in order.
#[pyfunction]
#[pyo3(signature = (curve, other, tolerance=0.001))]
pub(crate) fn intersect(
    py: Python<'_>,
    curve: Curve,
    other: Meeting<'_>,
    tolerance: f64,
) -> PyResult<(Vec<Point>, Vec<f64>)> {
    let work: std::boxed::Box<dyn FnOnce() -> Found + Send> = match other {
        Meeting::Curve(other) => std::boxed::Box::new(move || {
            let found = meet::curve_curve(&curve.0, &other.0, tolerance)?;
            Ok((found.crossings.iter().map(|one| (one.point, one.a)).collect(), found.complete))
        }),
        Meeting::Plane(plane) => std::boxed::Box::new(move || {
            let found = meet::curve_plane(&curve.0, &plane.0, tolerance)?;
            Ok((found.crossings.iter().map(|t| (curve.0.point_at(*t), *t)).collect(), true))
        }),
        Meeting::Surface(surface) => std::boxed::Box::new(move || {
            let found = meet::curve_with_surface(&curve.0, &surface.0, tolerance)?;
            Ok((found.crossings.iter().map(|one| (one.point, one.t)).collect(), found.complete))
        }),
        Meeting::Brep(brep) => std::boxed::Box::new(move || {
            let search = ClosestOnBrep::new(brep.0.clone())?;
            let found = search.curve_crossings(&curve.0, tolerance)?;
            Ok((found.crossings.iter().map(|one| (one.point, one.t)).collect(), found.complete))
        }),
        Meeting::Other(other) => {
            let name = other.get_type().name()?;
            return Err(PyTypeError::new_err(format!(
                "a curve meets curves, planes, surfaces and Breps, not {name}"
            )));
        }
    };
    let (found, complete) = interruptible(py, work)?;
    if !complete {
        return Err(GeometryError::new_err("the shapes run together so closely that not all could be found"));
    }
    Ok(found.into_iter().map(|(point, t)| (Point(point), t)).unzip())
}

/// Points and parameters, and whether they are all.
type Found = katydid_geometry::Result<(Vec<(katydid_geometry::Point3, f64)>, bool)>;
