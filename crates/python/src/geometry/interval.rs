use katydid_geometry::Interval as Range;
use pyo3::exceptions::{PyIndexError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use super::repr::numbers;

/// A directed range of numbers, from `start` to `end`: the domain of a curve, say.
///
/// Wherever a range is asked for, any two numbers will do.
#[pyclass(frozen, sequence, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Interval(pub(crate) Range);

/// A range, or any two numbers.
pub(crate) struct IntervalLike(pub(crate) Range);

impl<'a, 'py> FromPyObject<'a, 'py> for IntervalLike {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(range) = object.cast::<Interval>() {
            return Ok(Self(range.get().0));
        }
        let two: PyResult<[f64; 2]> =
            object.extract::<(f64, f64)>().map(Into::into).or_else(|_| object.extract());
        let two = two.map_err(|_| PyTypeError::new_err("a range is expected: an Interval or two numbers"))?;
        Ok(Self(Range::new(two[0], two[1])))
    }
}

#[pymethods]
impl Interval {
    /// The range from a start to an end.
    #[new]
    #[pyo3(signature = (start=0.0, end=1.0))]
    fn new(start: f64, end: f64) -> Self {
        Self(Range::new(start, end))
    }

    /// Where the range begins.
    #[getter]
    fn start(&self) -> f64 {
        self.0.start
    }

    /// Where it ends.
    #[getter]
    fn end(&self) -> f64 {
        self.0.end
    }

    /// The length; negative where the end is smaller than the start.
    #[getter]
    fn length(&self) -> f64 {
        self.0.length()
    }

    /// The number at `x` of the way: the start at 0, the end at 1.
    fn at(&self, x: f64) -> f64 {
        self.0.at(x)
    }

    /// So many numbers evenly from start to end, both among them, as an array of shape (n,).
    fn linspace<'py>(&self, py: Python<'py>, count: usize) -> PyResult<Bound<'py, PyAny>> {
        let mut numbers = Vec::new();
        numbers.try_reserve_exact(count).map_err(|_| crate::errors::too_large(count))?;
        let last = count.saturating_sub(1).max(1) as f64;
        numbers.extend((0..count).map(|i| self.0.at(i as f64 / last)));
        crate::arrays::numbers_out(py, &numbers)
    }

    fn __contains__(&self, number: f64) -> bool {
        self.0.contains(number)
    }

    fn __len__(&self) -> usize {
        2
    }

    fn __getitem__(&self, index: isize) -> PyResult<f64> {
        match index {
            0 | -2 => Ok(self.0.start),
            1 | -1 => Ok(self.0.end),
            _ => Err(PyIndexError::new_err("a range has a start and an end")),
        }
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        PyTuple::new(py, [self.0.start, self.0.end])?.call_method0("__iter__")
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
        PyTuple::new(py, [self.0.start, self.0.end])?.hash()
    }

    fn __repr__(&self) -> String {
        format!("Interval({})", numbers([self.0.start, self.0.end]))
    }

    fn __getnewargs__(&self) -> (f64, f64) {
        (self.0.start, self.0.end)
    }
}
