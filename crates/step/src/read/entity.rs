//! Entities by name, and their attributes by type.

use std::collections::HashSet;

use crate::part21::{Instance, Structure, Value};
use crate::{Error, Result};

/// Entities that refer to entities deeper than this are taken to run in a circle.
pub(super) const DEEPEST: usize = 64;

/// The entities of a file.
pub(super) struct File {
    structure: Structure,
}

/// One record of an entity: its type and attributes.
#[derive(Clone, Copy)]
pub(super) struct Record<'a> {
    pub(super) id: u64,
    pub(super) keyword: &'a str,
    values: &'a [Value],
}

impl File {
    pub(super) fn new(structure: Structure) -> Self {
        Self { structure }
    }

    /// How many entities there are.
    pub(super) fn count(&self) -> usize {
        self.structure.instances.len()
    }

    fn instance(&self, id: u64) -> Result<&Instance> {
        self.structure.instances.get(&id).ok_or_else(|| Error::entity(id, "it is named, but does not exist"))
    }

    /// The record of an entity of one type; the first of one of several.
    pub(super) fn record(&self, id: u64) -> Result<Record<'_>> {
        let instance = self.instance(id)?;
        let first = instance.records.first().ok_or_else(|| Error::entity(id, "it has no type"))?;
        Ok(Record { id, keyword: &first.0, values: &first.1 })
    }

    /// The record of a type that the entity has, if it has it.
    pub(super) fn part(&self, id: u64, keyword: &str) -> Option<Record<'_>> {
        let instance = self.structure.instances.get(&id)?;
        let (keyword, values) = instance.records.iter().find(|(word, _)| word == keyword)?;
        Some(Record { id, keyword, values })
    }

    /// Whether an entity is of a type.
    pub(super) fn is(&self, id: u64, keyword: &str) -> bool {
        self.part(id, keyword).is_some()
    }

    /// Whether an entity is of several types at once.
    pub(super) fn is_complex(&self, id: u64) -> bool {
        self.structure.instances.get(&id).is_some_and(|instance| instance.records.len() > 1)
    }

    /// All records of all entities, by name.
    pub(super) fn records(&self) -> impl Iterator<Item = Record<'_>> {
        self.structure.instances.iter().flat_map(|(id, instance)| {
            instance.records.iter().map(|(keyword, values)| Record { id: *id, keyword, values })
        })
    }

    /// The records of one entity.
    pub(super) fn records_of(&self, id: u64) -> impl Iterator<Item = Record<'_>> {
        let records = self.structure.instances.get(&id).map_or(&[] as &[_], |instance| &instance.records);
        records.iter().map(move |(keyword, values)| Record { id, keyword, values })
    }

    /// All records of a type.
    pub(super) fn all<'a>(&'a self, keyword: &'a str) -> impl Iterator<Item = Record<'a>> {
        self.records().filter(move |record| record.keyword == keyword)
    }

    /// All entities that an entity refers to.
    pub(super) fn references(&self, id: u64) -> Vec<u64> {
        let mut out = Vec::new();
        let mut seen = HashSet::new();
        if let Some(instance) = self.structure.instances.get(&id) {
            for (_, values) in &instance.records {
                values.iter().for_each(|value| collect(value, &mut out));
            }
        }
        out.retain(|id| seen.insert(*id));
        out
    }
}

fn collect(value: &Value, out: &mut Vec<u64>) {
    match value {
        Value::Reference(id) => out.push(*id),
        Value::List(values) => values.iter().for_each(|value| collect(value, out)),
        Value::Typed(_, value) => collect(value, out),
        _ => {}
    }
}

impl<'a> Record<'a> {
    fn value(&self, place: usize) -> Result<&'a Value> {
        self.values.get(place).ok_or_else(|| self.error(place, "is missing"))
    }

    fn error(&self, place: usize, why: &str) -> Error {
        Error::entity(self.id, format!("attribute {} of {} {why}", place + 1, self.keyword))
    }

    /// An error of the entity as a whole.
    pub(super) fn refuse(&self, why: impl std::fmt::Display) -> Error {
        Error::entity(self.id, format!("{}: {why}", self.keyword))
    }

    pub(super) fn real(&self, place: usize) -> Result<f64> {
        number(self.value(place)?).ok_or_else(|| self.error(place, "is no number"))
    }

    pub(super) fn count(&self, place: usize) -> Result<usize> {
        match self.value(place)? {
            Value::Integer(n) => usize::try_from(*n).map_err(|_| self.error(place, "is negative")),
            _ => Err(self.error(place, "is no integer")),
        }
    }

    pub(super) fn text(&self, place: usize) -> &'a str {
        match self.values.get(place) {
            Some(Value::Text(text)) => text,
            _ => "",
        }
    }

    pub(super) fn word(&self, place: usize) -> Result<&'a str> {
        match self.value(place)? {
            Value::Word(word) => Ok(word),
            _ => Err(self.error(place, "is no word between points")),
        }
    }

    pub(super) fn flag(&self, place: usize) -> Result<bool> {
        match self.word(place)? {
            "T" => Ok(true),
            "F" => Ok(false),
            _ => Err(self.error(place, "is neither true nor false")),
        }
    }

    pub(super) fn reference(&self, place: usize) -> Result<u64> {
        self.maybe(place).ok_or_else(|| self.error(place, "names no entity"))
    }

    /// An entity, where one is named.
    pub(super) fn maybe(&self, place: usize) -> Option<u64> {
        match self.values.get(place) {
            Some(Value::Reference(id)) => Some(*id),
            _ => None,
        }
    }

    fn list(&self, place: usize) -> Result<&'a [Value]> {
        match self.value(place)? {
            Value::List(values) => Ok(values),
            _ => Err(self.error(place, "is no list")),
        }
    }

    pub(super) fn references(&self, place: usize) -> Result<Vec<u64>> {
        self.refs(place, self.list(place)?)
    }

    fn refs(&self, place: usize, values: &[Value]) -> Result<Vec<u64>> {
        let each = values.iter().map(|value| match value {
            Value::Reference(id) => Ok(*id),
            _ => Err(self.error(place, "holds something that names no entity")),
        });
        each.collect()
    }

    pub(super) fn reals(&self, place: usize) -> Result<Vec<f64>> {
        self.numbers(place, self.list(place)?)
    }

    fn numbers(&self, place: usize, values: &[Value]) -> Result<Vec<f64>> {
        let each =
            values.iter().map(|v| number(v).ok_or_else(|| self.error(place, "holds what is no number")));
        each.collect()
    }

    pub(super) fn counts(&self, place: usize) -> Result<Vec<usize>> {
        let each = self.list(place)?.iter().map(|value| match value {
            Value::Integer(n) => {
                usize::try_from(*n).map_err(|_| self.error(place, "holds a negative number"))
            }
            _ => Err(self.error(place, "holds what is no integer")),
        });
        each.collect()
    }

    /// Lists of entities.
    pub(super) fn reference_grid(&self, place: usize) -> Result<Vec<Vec<u64>>> {
        let rows = self.list(place)?.iter().map(|row| match row {
            Value::List(values) => self.refs(place, values),
            _ => Err(self.error(place, "is no list of lists")),
        });
        rows.collect()
    }

    /// Lists of numbers.
    pub(super) fn real_grid(&self, place: usize) -> Result<Vec<Vec<f64>>> {
        let rows = self.list(place)?.iter().map(|row| match row {
            Value::List(values) => self.numbers(place, values),
            _ => Err(self.error(place, "is no list of lists")),
        });
        rows.collect()
    }

    /// Of a list that may hold an entity or a typed number or both: the entity and the number.
    pub(super) fn select(&self, place: usize) -> (Option<u64>, Option<f64>) {
        let values = self.list(place).unwrap_or(&[]);
        let id = values.iter().find_map(|value| match value {
            Value::Reference(id) => Some(*id),
            _ => None,
        });
        (id, values.iter().find_map(number))
    }
}

fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Integer(n) => Some(*n as f64),
        Value::Real(x) => Some(*x),
        Value::Typed(_, value) => match value.as_ref() {
            Value::Integer(n) => Some(*n as f64),
            Value::Real(x) => Some(*x),
            _ => None,
        },
        _ => None,
    }
}
