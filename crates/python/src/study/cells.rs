//! Cells of tables and Python's values.

use katydid_study::Cell;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyList, PyString};

use crate::arrays::numbers_out;
use crate::errors::KatydidError;

/// A value that a program asks for as a cell. Numbers that are not finite are refused.
pub(super) fn cell_in(value: &Bound<'_, PyAny>) -> PyResult<Cell> {
    if value.is_none() {
        return Ok(Cell::Null);
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(Cell::Text(text.extract()?));
    }
    if value.cast::<PyBool>().is_ok() || value.get_type().name()?.to_string().starts_with("bool") {
        return Ok(Cell::Boolean(value.is_truthy()?));
    }
    let number: f64 = value
        .extract()
        .map_err(|_| PyTypeError::new_err("an input of a point is a number, a truth value or a text"))?;
    if !number.is_finite() {
        return Err(PyTypeError::new_err(format!("{number} is not a finite number")));
    }
    Ok(Cell::Number(number))
}

fn cell_out<'py>(py: Python<'py>, cell: &Cell) -> PyResult<Bound<'py, PyAny>> {
    Ok(match cell {
        Cell::Null => py.None().into_bound(py),
        Cell::Boolean(on) => PyBool::new(py, *on).to_owned().into_any(),
        Cell::Number(x) => x.into_pyobject(py)?.into_any(),
        Cell::Text(text) => PyString::new(py, text).into_any(),
    })
}

/// A column: an array of numbers, NaN where there is nothing, where all its cells are numbers or nothing; else a list.
pub(super) fn column_out<'py>(py: Python<'py>, cells: &[Cell]) -> PyResult<Bound<'py, PyAny>> {
    if cells.iter().all(|cell| matches!(cell, Cell::Number(_) | Cell::Null)) {
        let numbers: Vec<f64> = cells.iter().map(|cell| cell.number().unwrap_or(f64::NAN)).collect();
        return numbers_out(py, &numbers);
    }
    list_out(py, cells)
}

/// Cells as a list.
pub(super) fn list_out<'py>(py: Python<'py>, cells: &[Cell]) -> PyResult<Bound<'py, PyAny>> {
    let cells: Vec<_> = cells.iter().map(|cell| cell_out(py, cell)).collect::<PyResult<_>>()?;
    Ok(PyList::new(py, cells)?.into_any())
}

/// Points as bytes, one for each: so they travel to other processes.
pub(super) fn points_out<'py>(py: Python<'py>, points: &[Vec<Cell>]) -> PyResult<Bound<'py, PyList>> {
    PyList::new(py, points.iter().map(|point| PyBytes::new(py, &Cell::to_bytes(point))))
}

pub(super) fn points_in(points: Vec<Bound<'_, PyBytes>>) -> PyResult<Vec<Vec<Cell>>> {
    let damaged = || KatydidError::new_err("a point is damaged");
    points.iter().map(|point| Cell::of_bytes(point.as_bytes()).ok_or_else(damaged)).collect()
}
