//! The inputs that a study sets.

use katydid_data::{Tree, Value};
use katydid_definition::document::special::{GenePool, Rounding, Slider};
use katydid_definition::document::{Document, Object, Special};
use katydid_session::{InputError, assign_input, find_input};
use katydid_solver::Engine;

use crate::{Cell, StudyError};

/// An input that a study sets: a slider, a number of a gene pool, a toggle, a list, a panel, a parameter.
#[derive(Debug, Clone)]
pub struct Variable {
    /// What it is called in the plan and in tables.
    pub name: String,
    /// The place of its object in the document.
    pub object: usize,
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
    /// The input of that name or id. A number of a gene pool is its name, a dot and the number's place from 0: `Genes.2`.
    ///
    /// # Errors
    /// There is no such input, or there are several.
    pub fn find(document: &Document, name: &str) -> Result<Self, StudyError> {
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
        let unfit = |why: &str| StudyError::Unfit(format!("'{name}' {why}"));
        let at = document.objects.get(object).ok_or_else(|| unfit("is not there"))?;
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
        Ok(Self { name, object, kind })
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

    /// The place of a number in its gene pool.
    pub fn gene(&self) -> Option<usize> {
        match &self.kind {
            Kind::Gene { index, .. } => Some(*index),
            _ => None,
        }
    }

    /// Makes a slider whose number goes through an expression take numbers to 12 digits: what is given to it from outside would
    /// go past the expression.
    pub(crate) fn refine(&self, engine: &mut Engine) {
        if let Kind::Slider(Slider { expression: Some(_), rounding: Rounding::Real, .. }) = &self.kind {
            engine.edit(self.object, |object| {
                if let Some(chunk) = object.container_mut().child_mut("Slider") {
                    chunk.set("Digits", 12_i32);
                }
            });
        }
    }

    /// Puts it at a number to all its digits, without a change of the document where that can be. `genes` are the numbers of
    /// its pool that are not as in the document.
    pub(crate) fn place(&self, engine: &mut Engine, x: f64, genes: &[(usize, f64)]) {
        match &self.kind {
            Kind::Slider(Slider { expression: Some(_), .. }) => {
                engine.edit(self.object, |object| {
                    // A number outside the limits is refused where it comes from.
                    let _ = object.set_slider(x);
                });
            }
            Kind::Slider(_) => engine.give(self.object, 0, Some(Tree::item(Value::Number(x)))),
            Kind::Gene { pool, .. } => {
                let mut values: Vec<f64> = pool.values.iter().map(|x| rounded(*x, pool)).collect();
                for (index, x) in genes {
                    if let Some(value) = values.get_mut(*index) {
                        *value = *x;
                    }
                }
                engine.give(self.object, 0, Some(Tree::list(values)));
            }
            _ => {}
        }
    }

    fn takes(&self, x: f64) -> bool {
        self.limits().is_some_and(|[min, max]| min <= x && x <= max)
    }

    /// Sets it in an object of the document.
    ///
    /// # Errors
    /// It does not take the value.
    pub(crate) fn set(&self, object: &mut Object, cell: &Cell) -> Result<(), InputError> {
        let refuse =
            |reason: String| InputError::Refused { name: self.name.clone(), value: cell.to_string(), reason };
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
