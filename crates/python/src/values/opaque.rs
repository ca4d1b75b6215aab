use katydid_data::{Value, text};
use pyo3::prelude::*;

/// A value that Python has no class for: a material, a field, an object of a Rhino model. It goes back into a definition
/// as it is.
#[pyclass(frozen, from_py_object, module = "katydid")]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Item(pub(crate) Value);

#[pymethods]
impl Item {
    /// The name of its type.
    #[getter]
    fn kind(&self) -> &'static str {
        self.0.kind().name()
    }

    /// The text that a panel shows.
    fn __str__(&self) -> String {
        text::value(&self.0, &text::Style::default())
    }

    fn __repr__(&self) -> String {
        format!("<{}: {}>", self.kind(), self.__str__())
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get() == self)
    }
}
