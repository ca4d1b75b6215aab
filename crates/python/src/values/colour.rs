use katydid_data::Colour as Data;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// A colour of four channels from 0 to 255 each: red, green, blue, and opacity.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Colour(pub(crate) Data);

#[pymethods]
impl Colour {
    /// The colour of its channels.
    #[new]
    #[pyo3(signature = (r, g, b, a=255))]
    fn new(r: u8, g: u8, b: u8, a: u8) -> Self {
        Self(Data::argb(a, r, g, b))
    }

    /// Red.
    #[getter]
    fn r(&self) -> u8 {
        self.0.r
    }

    /// Green.
    #[getter]
    fn g(&self) -> u8 {
        self.0.g
    }

    /// Blue.
    #[getter]
    fn b(&self) -> u8 {
        self.0.b
    }

    /// Opacity: 255 is opaque.
    #[getter]
    fn a(&self) -> u8 {
        self.0.a
    }

    fn __len__(&self) -> usize {
        4
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        PyTuple::new(py, [self.0.r, self.0.g, self.0.b, self.0.a])?.call_method0("__iter__")
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }

    fn __hash__(&self) -> u64 {
        u64::from(u32::from_le_bytes([self.0.r, self.0.g, self.0.b, self.0.a]))
    }

    fn __repr__(&self) -> String {
        format!("Colour({}, {}, {}, {})", self.0.r, self.0.g, self.0.b, self.0.a)
    }

    fn __getnewargs__(&self) -> (u8, u8, u8, u8) {
        (self.0.r, self.0.g, self.0.b, self.0.a)
    }
}
