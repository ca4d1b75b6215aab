//! Booleans of Breps.

use katydid_geometry::brep::Made;
use katydid_geometry::{Brep as Kernel, Result, Tolerance};
use pyo3::prelude::*;

use super::{Brep, tolerance};
use crate::work::interruptible;

/// A Brep, or a list of them: what a boolean gave is taken by the next.
#[derive(FromPyObject)]
pub(crate) enum Breps {
    One(Brep),
    Many(Vec<Brep>),
}

impl Breps {
    fn kernel(&self) -> Vec<Kernel> {
        match self {
            Self::One(brep) => vec![(*brep.0).clone()],
            Self::Many(all) => all.iter().map(|brep| (*brep.0).clone()).collect(),
        }
    }
}

/// A boolean of the kernel.
type Operation = fn(&[Kernel], &[Kernel], &Tolerance) -> Result<Vec<Made>>;

/// The tolerance of operators.
const TOLERANCE: f64 = 0.001;

impl Brep {
    fn boolean(
        py: Python<'_>,
        a: Vec<Kernel>,
        b: Vec<Kernel>,
        within: f64,
        make: Operation,
    ) -> PyResult<Vec<Self>> {
        let made = interruptible(py, move || make(&a, &b, &tolerance(within)))?;
        Ok(made.into_iter().map(|m| m.brep.into()).collect())
    }

    fn own(&self) -> Vec<Kernel> {
        vec![(*self.0).clone()]
    }
}

fn united(a: &[Kernel], b: &[Kernel], tolerance: &Tolerance) -> Result<Vec<Made>> {
    let all: Vec<Kernel> = a.iter().chain(b).cloned().collect();
    Kernel::union(&all, tolerance)
}

#[pymethods]
impl Brep {
    /// The solids that this one and another, or several, fill together; all must be closed. What is not decided is an
    /// error that names the case, the faces and the place.
    #[pyo3(signature = (other, tolerance=0.001))]
    fn union(&self, py: Python<'_>, other: Breps, tolerance: f64) -> PyResult<Vec<Self>> {
        Self::boolean(py, self.own(), other.kernel(), tolerance, united)
    }

    /// What is left of this Brep outside of another, or of several: any number of Breps. An open one divides what it meets,
    /// and what lies behind it is inside.
    #[pyo3(signature = (other, tolerance=0.001))]
    fn difference(&self, py: Python<'_>, other: Breps, tolerance: f64) -> PyResult<Vec<Self>> {
        Self::boolean(py, self.own(), other.kernel(), tolerance, Kernel::difference)
    }

    /// What this Brep has in common with another, or with any of several.
    #[pyo3(signature = (other, tolerance=0.001))]
    fn intersection(&self, py: Python<'_>, other: Breps, tolerance: f64) -> PyResult<Vec<Self>> {
        Self::boolean(py, self.own(), other.kernel(), tolerance, Kernel::intersection)
    }

    fn __or__(&self, py: Python<'_>, other: Breps) -> PyResult<Vec<Self>> {
        self.union(py, other, TOLERANCE)
    }

    fn __sub__(&self, py: Python<'_>, other: Breps) -> PyResult<Vec<Self>> {
        self.difference(py, other, TOLERANCE)
    }

    fn __and__(&self, py: Python<'_>, other: Breps) -> PyResult<Vec<Self>> {
        self.intersection(py, other, TOLERANCE)
    }

    fn __ror__(&self, py: Python<'_>, other: Breps) -> PyResult<Vec<Self>> {
        Self::boolean(py, other.kernel(), self.own(), TOLERANCE, united)
    }

    fn __rsub__(&self, py: Python<'_>, other: Breps) -> PyResult<Vec<Self>> {
        Self::boolean(py, other.kernel(), self.own(), TOLERANCE, Kernel::difference)
    }

    fn __rand__(&self, py: Python<'_>, other: Breps) -> PyResult<Vec<Self>> {
        Self::boolean(py, other.kernel(), self.own(), TOLERANCE, Kernel::intersection)
    }
}
