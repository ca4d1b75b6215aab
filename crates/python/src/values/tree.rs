use katydid_data::{Branch, Path, Tree as Data, text};
use pyo3::exceptions::{PyKeyError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString, PyTuple};

use super::{column_to_python, given, to_python};

/// Data of a definition: branches by their paths, each a list of items. It never changes.
///
/// It is a mapping of paths, tuples of whole numbers, to branches. A branch of numbers, truth values, points or vectors is
/// a NumPy array, where NumPy is installed and no item is missing; any other is a list, with `None` for what is missing.
#[pyclass(frozen, mapping, module = "katydid")]
#[derive(Debug, Clone)]
pub(crate) struct Tree(pub(crate) Data);

/// A path, of a tuple or list of whole numbers, one number, or a text such as "{0;1}".
pub(crate) fn path(object: &Bound<'_, PyAny>) -> PyResult<Path> {
    if let Ok(text) = object.cast::<PyString>() {
        let text = text.to_string();
        return text
            .trim()
            .parse()
            .map_err(|_| PyValueError::new_err(format!("{text:?} is no path such as \"{{0;1}}\"")));
    }
    if let Ok(number) = object.extract::<i32>() {
        return Ok(Path::from([number]));
    }
    let numbers: Vec<i32> = object.extract().map_err(|_| {
        PyTypeError::new_err("a path is a tuple of whole numbers, or a text such as \"{0;1}\"")
    })?;
    Ok(Path::from(numbers.as_slice()))
}

impl Tree {
    fn find(&self, key: &Bound<'_, PyAny>) -> PyResult<Option<Branch<'_>>> {
        let wanted = path(key)?;
        let place = self.0.paths().iter().position(|path| *path == wanted);
        Ok(place.and_then(|place| self.0.branch(place)))
    }

    fn branch<'py>(&self, py: Python<'py>, branch: &Branch<'_>) -> PyResult<Bound<'py, PyAny>> {
        column_to_python(py, self.0.column(), branch.range())
    }
}

fn key<'py>(py: Python<'py>, path: &Path) -> PyResult<Bound<'py, PyTuple>> {
    PyTuple::new(py, path.elements())
}

#[pymethods]
impl Tree {
    /// The tree of what may be given to an input: a dict of lists by paths, a list, a list of lists, an array, one item.
    #[new]
    #[pyo3(signature = (data=None))]
    fn new(data: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        match data {
            Some(data) => given(data, katydid_data::Kind::Generic).map(Self),
            None => Ok(Self(Data::empty())),
        }
    }

    /// The paths of the branches, in order.
    #[getter]
    fn paths<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyTuple>>> {
        self.0.paths().iter().map(|path| key(py, path)).collect()
    }

    /// The name of the type that all items have.
    #[getter]
    fn kind(&self) -> &'static str {
        self.0.column().kind().name()
    }

    /// How many items there are in all branches together.
    #[getter]
    fn item_count(&self) -> usize {
        self.0.item_count()
    }

    /// The only item; an error where there are more or none.
    #[getter]
    fn item<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match self.0.item_count() {
            1 => to_python(py, self.0.column().get(0).as_ref()),
            count => Err(PyValueError::new_err(format!("the tree has {count} items, not one"))),
        }
    }

    /// All items of all branches in order, as a list.
    fn flat<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let items = PyList::empty(py);
        for value in self.0.column().iter() {
            items.append(to_python(py, value.as_ref())?)?;
        }
        Ok(items)
    }

    /// All items of all branches in order, as an array: of shape (n,) for numbers and truth values, (n, 3) for points and
    /// vectors. An error where they are none of these, or some are missing.
    fn array<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let made = column_to_python(py, self.0.column(), 0..self.0.item_count())?;
        if crate::arrays::has_numpy(py) && made.is_instance_of::<PyList>() {
            if self.0.item_count() == 0 {
                return crate::arrays::numbers_out(py, &[]);
            }
            let kind = self.kind();
            return Err(PyTypeError::new_err(format!(
                "items of the type {kind}, some of them missing perhaps, make no array"
            )));
        }
        Ok(made)
    }

    /// The branches by their paths, as a dict.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for branch in self.0.branches() {
            dict.set_item(key(py, branch.path())?, self.branch(py, &branch)?)?;
        }
        Ok(dict)
    }

    /// The paths.
    fn keys<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyTuple>>> {
        self.paths(py)
    }

    /// The branches.
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.0.branches().map(|branch| self.branch(py, &branch)).collect()
    }

    /// Paths and branches.
    fn items<'py>(&self, py: Python<'py>) -> PyResult<Vec<(Bound<'py, PyTuple>, Bound<'py, PyAny>)>> {
        self.0.branches().map(|branch| Ok((key(py, branch.path())?, self.branch(py, &branch)?))).collect()
    }

    /// The branch at a path, or what is given in its place.
    #[pyo3(signature = (path, default=None))]
    fn get<'py>(
        &self,
        py: Python<'py>,
        path: &Bound<'py, PyAny>,
        default: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        match self.find(path)? {
            Some(branch) => self.branch(py, &branch).map(Some),
            None => Ok(default),
        }
    }

    /// One branch with all items.
    fn flattened(&self) -> Self {
        Self(self.0.flatten())
    }

    /// A branch for each item.
    fn grafted(&self) -> Self {
        Self(self.0.graft())
    }

    /// The tree without what the beginnings of all paths have in common.
    fn simplified(&self) -> Self {
        Self(self.0.simplify(false))
    }

    fn __getitem__<'py>(&self, py: Python<'py>, path: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        match self.find(path)? {
            Some(branch) => self.branch(py, &branch),
            None => Err(PyKeyError::new_err(path.clone().unbind())),
        }
    }

    fn __contains__(&self, path: &Bound<'_, PyAny>) -> bool {
        self.find(path).is_ok_and(|found| found.is_some())
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        PyTuple::new(py, self.paths(py)?)?.call_method0("__iter__")
    }

    fn __len__(&self) -> usize {
        self.0.branch_count()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let Ok(other) = other.cast::<Self>() else { return false };
        let (a, b) = (&self.0, &other.get().0);
        let ends =
            |tree: &Data| (0..tree.branch_count()).map(|branch| tree.range(branch).end).collect::<Vec<_>>();
        a.paths() == b.paths() && ends(a) == ends(b) && a.column().iter().eq(b.column().iter())
    }

    fn __repr__(&self) -> String {
        format!("<Tree: {} branches, {} items, {}>", self.0.branch_count(), self.0.item_count(), self.kind())
    }

    /// What a panel shows, a line an item.
    fn __str__(&self) -> String {
        let style = text::Style::default();
        let mut lines = Vec::new();
        for branch in self.0.branches() {
            lines.push(branch.path().to_string());
            lines.extend(branch.iter().map(|value| format!("  {}", text::item(value.as_ref(), &style))));
        }
        lines.join("\n")
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyDict>,))> {
        // Items one by one: an array would not say whether its rows are points or vectors.
        let dict = PyDict::new(py);
        for branch in self.0.branches() {
            let items = PyList::empty(py);
            for value in branch.iter() {
                items.append(to_python(py, value.as_ref())?)?;
            }
            dict.set_item(key(py, branch.path())?, items)?;
        }
        Ok((py.get_type::<Self>().into_any(), (dict,)))
    }
}
