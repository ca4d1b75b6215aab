//! The inputs that a study sets.

mod placed;

use katydid_definition::document::special::{GenePool, Rounding, Slider};
use katydid_definition::document::{Document, Object, Special};
use katydid_session::{InputError, assign_input, edit_inside, find_input};
use uuid::Uuid;

use crate::{Cell, StudyError, inside};

/// An input that a study sets: a slider, a number of a gene pool, a toggle, a list, a panel, a parameter.
#[derive(Debug, Clone)]
pub struct Variable {
    /// What it is called in the plan and in tables.
    pub name: String,
    /// The place of its object in the document; where it is inside a cluster, that of the cluster.
    pub object: usize,
    /// The places of the objects on the way into the cluster, its own at the end; empty where it is in none.
    within: Vec<usize>,
    kind: Kind,
}

#[derive(Debug, Clone)]
enum Kind {
    Slider(Slider),
    Gene {
        index: usize,
        pool: GenePool,
    },
    /// So many entries.
    List(usize),
    Toggle,
    Other,
}

impl Variable {
    /// The input of that name or id. A number of a gene pool is its name, a dot and the number's place from 0: `Genes.2`. An
    /// input inside a cluster has the cluster's name or id and a slash before its own: `Tower/height`.
    ///
    /// # Errors
    /// There is no such input, or there are several.
    pub fn find(document: &Document, name: &str) -> Result<Self, StudyError> {
        Self::find_outside(document, name).or_else(|error| {
            let (cluster, inner, rest) = inside::entered(document, name)?.ok_or(error)?;
            Ok(Self::find(&inner, rest)?.inside(cluster, name.to_owned()))
        })
    }

    /// One of a document inside a cluster, as a variable of the document that the cluster stands in.
    pub(crate) fn inside(self, cluster: usize, name: String) -> Self {
        let within = std::iter::once(self.object).chain(self.within).collect();
        Self { name, object: cluster, within, kind: self.kind }
    }

    fn find_outside(document: &Document, name: &str) -> Result<Self, StudyError> {
        let (object, gene) = match (find_input(document, name), gene(name)) {
            (Ok(object), _) => (object, None),
            (Err(_), Some((pool, index))) => (find_input(document, pool)?, Some(index)),
            (Err(error), None) => return Err(error.into()),
        };
        Self::of(document, object, gene, name.to_owned())
    }

    /// The input that an object is, or a number of it.
    ///
    /// # Errors
    /// The object is none, or a gene pool without the place of a number.
    pub fn of(
        document: &Document,
        object: usize,
        gene: Option<usize>,
        name: String,
    ) -> Result<Self, StudyError> {
        let at = document.objects.get(object);
        let at = at.ok_or_else(|| StudyError::Unfit(format!("'{name}' is not there")))?;
        Self::at(at, vec![object], gene, name)
    }

    /// The input that an object is, or a number of it. `path` is the places of the clusters that it is inside of, and its own at
    /// the end.
    ///
    /// # Errors
    /// The object is none, or a gene pool without the place of a number.
    pub(crate) fn at(
        at: &Object,
        path: Vec<usize>,
        gene: Option<usize>,
        name: String,
    ) -> Result<Self, StudyError> {
        let unfit = |why: &str| StudyError::Unfit(format!("'{name}' {why}"));
        let (&object, within) = path.split_first().ok_or_else(|| unfit("is not there"))?;
        let within = within.to_vec();
        let kind = match (at.special(), gene) {
            (Some(Special::GenePool(pool)), Some(index)) if index < pool.values.len() => {
                Kind::Gene { index, pool }
            }
            (Some(Special::GenePool(pool)), _) => {
                return Err(unfit(&format!(
                    "is a gene pool of {} numbers: set them as '{name}.0' and so on",
                    pool.values.len()
                )));
            }
            (_, Some(_)) => return Err(unfit("is no number of a gene pool")),
            (Some(Special::Slider(slider)), None) => Kind::Slider(slider),
            (Some(Special::ValueList(list)), None) => Kind::List(list.items.len()),
            (Some(Special::Toggle(_)), None) => Kind::Toggle,
            (_, None) => Kind::Other,
        };
        Ok(Self { name, object, within, kind })
    }

    /// The smallest and the largest number that it takes; `None` for what is no number.
    pub fn limits(&self) -> Option<[f64; 2]> {
        let ordered = |a: f64, b: f64| [a.min(b), a.max(b)];
        match &self.kind {
            Kind::Slider(slider) => Some(ordered(slider.min, slider.max)),
            Kind::Gene { pool, .. } => Some(ordered(pool.min, pool.max)),
            _ => None,
        }
    }

    /// The distance of the numbers it takes, where it is no less than 1: of whole, even and odd numbers.
    pub fn step(&self) -> Option<f64> {
        match &self.kind {
            Kind::Slider(slider) => match slider.rounding {
                Rounding::Integer => Some(1.0),
                Rounding::Even | Rounding::Odd => Some(2.0),
                Rounding::Real => (slider.digits == 0).then_some(1.0),
            },
            Kind::Gene { pool, .. } => (pool.decimals <= 0).then_some(1.0),
            _ => None,
        }
    }

    /// All values that a toggle or a list can have.
    pub fn choices(&self) -> Option<Vec<Cell>> {
        match &self.kind {
            Kind::Toggle => Some(vec![Cell::Boolean(false), Cell::Boolean(true)]),
            #[allow(clippy::cast_precision_loss, reason = "lists have few entries")]
            Kind::List(n) => Some((0..*n).map(|k| Cell::Number(k as f64)).collect()),
            _ => None,
        }
    }

    /// What it stands at when it is set to a value: numbers are rounded as the slider rounds them.
    pub fn fitted(&self, cell: Cell) -> Cell {
        match (&self.kind, cell) {
            (Kind::Slider(slider), Cell::Number(x)) if self.takes(x) => Cell::Number(slider.fit(x)),
            (Kind::Gene { pool, .. }, Cell::Number(x)) if self.takes(x) => Cell::Number(rounded(x, pool)),
            (_, cell) => cell,
        }
    }

    /// Sets it in a document: what a study found, say.
    ///
    /// # Errors
    /// It does not take the value.
    pub fn write(&self, document: &mut Document, cell: &Cell) -> Result<(), StudyError> {
        let gone = || StudyError::Unfit(format!("'{}' is not there", self.name));
        let object = document.objects.get_mut(self.object).ok_or_else(gone)?;
        Ok(self.set(object, cell)?)
    }

    /// The number that the definition has it at; `None` for what is no slider and no gene.
    pub(crate) fn stands_at(&self) -> Option<f64> {
        match &self.kind {
            Kind::Slider(slider) => Some(slider.fit(slider.value)),
            Kind::Gene { index, pool } => pool.values.get(*index).map(|x| rounded(*x, pool)),
            _ => None,
        }
    }

    /// The ids of the clusters that it is inside of, the outermost first, and of its own object; `None` where the document has
    /// no such objects.
    pub fn ids(&self, document: &Document) -> Option<(Vec<Uuid>, Uuid)> {
        let mut object = document.objects.get(self.object)?.clone();
        let mut within = Vec::with_capacity(self.within.len());
        for at in &self.within {
            within.push(object.id);
            object = inside::content(&object).ok()?.objects.get(*at)?.clone();
        }
        Some((within, object.id))
    }

    /// The input inside clusters of these ids, the outermost first, that an object is, or a number of it.
    ///
    /// # Errors
    /// There is no such object, a cluster cannot be opened, or the object is no input.
    pub fn of_ids(
        document: &Document,
        within: &[Uuid],
        object: Uuid,
        gene: Option<usize>,
    ) -> Result<Self, StudyError> {
        let id = within.first().copied().unwrap_or(object);
        let place = document.objects.iter().position(|other| other.id == id);
        let missing = || StudyError::Unfit("there is no such input".to_owned());
        let place = place.ok_or_else(missing)?;
        let at = document.objects.get(place).ok_or_else(missing)?;
        let Some((_, deeper)) = within.split_first() else {
            let name = at.title().to_owned();
            return Self::of(document, place, gene, name);
        };
        let found = Self::of_ids(&inside::content(at)?, deeper, object, gene)?;
        let name = format!("{}/{}", at.title(), found.name);
        Ok(found.inside(place, name))
    }

    /// Whether two are numbers of the same object.
    pub fn is_beside(&self, other: &Self) -> bool {
        (self.object, &self.within) == (other.object, &other.within)
    }

    /// The place of a number in its gene pool.
    pub fn gene(&self) -> Option<usize> {
        match &self.kind {
            Kind::Gene { index, .. } => Some(*index),
            _ => None,
        }
    }

    fn takes(&self, x: f64) -> bool {
        self.limits().is_some_and(|[min, max]| min <= x && x <= max)
    }

    /// Sets it in its object of the document, or of the cluster that is given in its place.
    ///
    /// # Errors
    /// It does not take the value.
    pub(crate) fn set(&self, object: &mut Object, cell: &Cell) -> Result<(), InputError> {
        edit_inside(object, &self.within, |object| self.set_here(object, cell))
            .map_err(|refusal| self.refused(cell, refusal.to_string()))?
    }

    fn refused(&self, cell: &Cell, reason: String) -> InputError {
        InputError::Refused { name: self.name.clone(), value: cell.to_string(), reason }
    }

    fn set_here(&self, object: &mut Object, cell: &Cell) -> Result<(), InputError> {
        let refuse = |reason: String| self.refused(cell, reason);
        match (&self.kind, cell) {
            (Kind::Slider(_) | Kind::Gene { .. }, Cell::Number(x)) if !self.takes(*x) => {
                let [min, max] = self.limits().unwrap_or_default();
                Err(refuse(format!("it goes from {min} to {max}")))
            }
            (Kind::Slider(_), Cell::Number(x)) => {
                object.set_slider(*x).map(drop).map_err(|error| refuse(error.to_string()))
            }
            (Kind::Gene { index, .. }, Cell::Number(x)) => {
                object.set_gene(*index, *x).map_err(|error| refuse(error.to_string()))
            }
            (Kind::Gene { .. }, _) => Err(refuse("it is not a number".to_owned())),
            (_, cell) => assign_input(object, &cell.to_string()),
        }
    }
}

/// A number to the digits of a gene pool.
fn rounded(x: f64, pool: &GenePool) -> f64 {
    let places = usize::try_from(pool.decimals.clamp(0, 12)).unwrap_or(0);
    let rounded = format!("{x:.places$}").parse().unwrap_or(x);
    f64::max(rounded, pool.min).min(pool.max)
}

/// A name such as `Genes.2`, taken apart.
fn gene(name: &str) -> Option<(&str, usize)> {
    let (pool, index) = name.rsplit_once('.')?;
    Some((pool, index.parse().ok()?))
}
