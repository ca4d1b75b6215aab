//! Collecting items one by one into a column.

use std::sync::Arc as Shared;

use katydid_geometry::{Point3, Vector3};

use crate::{Column, Geometry, Item, Items, Value};

/// A growing run of items.
pub trait Run<T>: Default + Clone + std::fmt::Debug + Send {
    /// Nothing yet, with room for `n`.
    fn with_capacity(n: usize) -> Self;
    /// Adds an item.
    fn push(&mut self, item: T);
    /// Adds the place of a null.
    fn push_null(&mut self);
    /// Adds all of another run behind these.
    fn append(&mut self, other: Self);
    /// Adds items that lie in a row.
    fn extend_from(&mut self, items: Vec<T>);
    /// The number of places so far.
    fn len(&self) -> usize;
    /// Whether there are none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// The column, with the mask of its nulls.
    fn finish(self, nulls: Option<Vec<bool>>) -> Column;
}

impl<T: Item<Run = Self>> Run<T> for Vec<T> {
    fn with_capacity(n: usize) -> Self {
        Self::with_capacity(n)
    }

    #[inline]
    fn push(&mut self, item: T) {
        self.push(item);
    }

    fn push_null(&mut self) {
        self.push(T::placeholder());
    }

    fn append(&mut self, mut other: Self) {
        // Room that was made for all pieces is kept.
        if self.is_empty() && self.capacity() < other.len() {
            *self = other;
        } else {
            self.append(&mut other);
        }
    }

    fn extend_from(&mut self, items: Self) {
        Run::append(self, items);
    }

    fn len(&self) -> usize {
        self.len()
    }

    fn finish(self, nulls: Option<Vec<bool>>) -> Column {
        T::column(self, nulls)
    }
}

/// A run of values of any type. While all are numbers, or points, and so on, they lie as such: a component that
/// takes anything is nearly as fast over a million numbers as one that takes numbers.
#[derive(Debug, Clone)]
pub enum ValueRun {
    /// Only nulls so far, this many.
    Nulls(usize),
    /// All numbers.
    Numbers(Vec<f64>),
    /// All integers.
    Integers(Vec<i32>),
    /// All booleans.
    Booleans(Vec<bool>),
    /// All points.
    Points(Vec<Point3>),
    /// All vectors.
    Vectors(Vec<Vector3>),
    /// Of several types, or of another.
    Values(Vec<Value>),
}

impl Default for ValueRun {
    fn default() -> Self {
        Self::Nulls(0)
    }
}

impl ValueRun {
    /// Begins a typed run, or gives one up whose type does not fit.
    #[cold]
    fn turn(&mut self, value: Value) {
        fn begin<T: Item>(nulls: usize, first: T) -> Vec<T> {
            let mut run = vec![T::placeholder(); nulls];
            run.push(first);
            run
        }
        if let &mut Self::Nulls(n) = self {
            *self = match value {
                Value::Number(x) => Self::Numbers(begin(n, x)),
                Value::Integer(x) => Self::Integers(begin(n, x)),
                Value::Boolean(x) => Self::Booleans(begin(n, x)),
                Value::Point(x) => Self::Points(begin(n, x)),
                Value::Vector(x) => Self::Vectors(begin(n, x)),
                other => Self::Values(begin(n, other)),
            };
            return;
        }
        let mut values: Vec<Value> = std::mem::take(self).into_values();
        values.push(value);
        *self = Self::Values(values);
    }

    fn into_values(self) -> Vec<Value> {
        match self {
            Self::Nulls(n) => vec![Value::placeholder(); n],
            Self::Numbers(run) => run.into_iter().map(Value::Number).collect(),
            Self::Integers(run) => run.into_iter().map(Value::Integer).collect(),
            Self::Booleans(run) => run.into_iter().map(Value::Boolean).collect(),
            Self::Points(run) => run.into_iter().map(Value::Point).collect(),
            Self::Vectors(run) => run.into_iter().map(Value::Vector).collect(),
            Self::Values(run) => run,
        }
    }
}

impl Run<Value> for ValueRun {
    fn with_capacity(_: usize) -> Self {
        // The type is not known yet, so neither is the size of a place.
        Self::Nulls(0)
    }

    #[inline]
    fn push(&mut self, value: Value) {
        match (&mut *self, value) {
            (Self::Numbers(run), Value::Number(x)) => run.push(x),
            (Self::Points(run), Value::Point(x)) => run.push(x),
            (Self::Vectors(run), Value::Vector(x)) => run.push(x),
            (Self::Integers(run), Value::Integer(x)) => run.push(x),
            (Self::Booleans(run), Value::Boolean(x)) => run.push(x),
            (Self::Values(run), value) => run.push(value),
            (_, value) => self.turn(value),
        }
    }

    fn push_null(&mut self) {
        match self {
            Self::Nulls(n) => *n += 1,
            Self::Numbers(run) => run.push_null(),
            Self::Integers(run) => run.push_null(),
            Self::Booleans(run) => run.push_null(),
            Self::Points(run) => run.push_null(),
            Self::Vectors(run) => run.push_null(),
            Self::Values(run) => run.push(Value::placeholder()),
        }
    }

    fn append(&mut self, other: Self) {
        match (&mut *self, other) {
            (Self::Nulls(0), other) => *self = other,
            (Self::Nulls(n), Self::Nulls(m)) => *n += m,
            (Self::Numbers(run), Self::Numbers(mut other)) => run.append(&mut other),
            (Self::Integers(run), Self::Integers(mut other)) => run.append(&mut other),
            (Self::Booleans(run), Self::Booleans(mut other)) => run.append(&mut other),
            (Self::Points(run), Self::Points(mut other)) => run.append(&mut other),
            (Self::Vectors(run), Self::Vectors(mut other)) => run.append(&mut other),
            (_, Self::Nulls(m)) => (0..m).for_each(|_| Run::<Value>::push_null(self)),
            (_, other) => other.into_values().into_iter().for_each(|value| Run::<Value>::push(self, value)),
        }
    }

    fn extend_from(&mut self, items: Vec<Value>) {
        items.into_iter().for_each(|value| Run::<Value>::push(self, value));
    }

    fn len(&self) -> usize {
        match self {
            Self::Nulls(n) => *n,
            Self::Numbers(run) => run.len(),
            Self::Integers(run) => run.len(),
            Self::Booleans(run) => run.len(),
            Self::Points(run) => run.len(),
            Self::Vectors(run) => run.len(),
            Self::Values(run) => run.len(),
        }
    }

    fn finish(self, nulls: Option<Vec<bool>>) -> Column {
        let items = match self {
            Self::Nulls(n) => return Column::nulls(n),
            Self::Numbers(run) => Items::Numbers(Shared::new(run)),
            Self::Integers(run) => Items::Integers(Shared::new(run)),
            Self::Booleans(run) => Items::Booleans(Shared::new(run)),
            Self::Points(run) => Items::Points(Shared::new(run)),
            Self::Vectors(run) => Items::Vectors(Shared::new(run)),
            Self::Values(run) => return Column::of_values(run, nulls),
        };
        Column::new(items, nulls)
    }
}

impl Run<Geometry> for ValueRun {
    fn with_capacity(n: usize) -> Self {
        <Self as Run<Value>>::with_capacity(n)
    }

    #[inline]
    fn push(&mut self, Geometry(value): Geometry) {
        Run::<Value>::push(self, value);
    }

    fn push_null(&mut self) {
        Run::<Value>::push_null(self);
    }

    fn append(&mut self, other: Self) {
        Run::<Value>::append(self, other);
    }

    fn extend_from(&mut self, items: Vec<Geometry>) {
        items.into_iter().for_each(|item| Run::<Geometry>::push(self, item));
    }

    fn len(&self) -> usize {
        Run::<Value>::len(self)
    }

    fn finish(self, nulls: Option<Vec<bool>>) -> Column {
        Run::<Value>::finish(self, nulls)
    }
}

/// Collects items and nulls one by one into a column.
#[derive(Debug, Clone)]
pub struct Gather<T: Item> {
    items: T::Run,
    nulls: Option<Vec<bool>>,
}

impl<T: Item> Default for Gather<T> {
    fn default() -> Self {
        Self { items: T::Run::default(), nulls: None }
    }
}

impl<T: Item> Gather<T> {
    /// Nothing yet, with room for `n`.
    pub fn with_capacity(n: usize) -> Self {
        Self { items: T::Run::with_capacity(n), nulls: None }
    }

    /// Adds an item, or a null.
    #[inline]
    pub fn push(&mut self, item: Option<T>) {
        match item {
            Some(item) => {
                self.items.push(item);
                if let Some(nulls) = &mut self.nulls {
                    nulls.push(false);
                }
            }
            None => {
                let before = self.items.len();
                self.items.push_null();
                self.nulls.get_or_insert_with(|| vec![false; before]).push(true);
            }
        }
    }

    /// Adds items without nulls.
    pub fn extend(&mut self, items: Vec<T>) {
        if let Some(nulls) = &mut self.nulls {
            nulls.resize(nulls.len() + items.len(), false);
        }
        self.items.extend_from(items);
    }

    /// Adds all items of another run behind these.
    pub fn append(&mut self, other: Self) {
        if self.nulls.is_some() || other.nulls.is_some() {
            let (mine, theirs) = (self.items.len(), other.items.len());
            self.nulls
                .get_or_insert_with(|| vec![false; mine])
                .extend(other.nulls.unwrap_or_else(|| vec![false; theirs]));
        }
        self.items.append(other.items);
    }

    /// The number of places so far.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether nothing was added.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// The column.
    pub fn finish(self) -> Column {
        self.items.finish(self.nulls)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn any_value() -> impl Strategy<Value = Option<Value>> {
        prop_oneof![
            Just(None),
            any::<i32>().prop_map(|i| Some(Value::Integer(i))),
            (-9.0..9.0).prop_map(|x: f64| Some(Value::Number(x))),
            any::<bool>().prop_map(|b| Some(Value::Boolean(b))),
            Just(Some(Value::Point(Point3::ORIGIN))),
            Just(Some(Value::Vector(Vector3::X))),
            Just(Some(Value::text("a"))),
        ]
    }

    proptest! {
        #[test]
        fn what_goes_in_comes_out(
            a in prop::collection::vec(any_value(), 0..12),
            b in prop::collection::vec(any_value(), 0..12),
        ) {
            let run = |values: &[Option<Value>]| {
                let mut gather = Gather::<Value>::default();
                values.iter().for_each(|v| gather.push(v.clone()));
                gather
            };
            let mut both = run(&a);
            both.append(run(&b));
            let all: Vec<Option<Value>> = a.into_iter().chain(b).collect();
            prop_assert_eq!(both.len(), all.len());
            prop_assert_eq!(both.finish().iter().collect::<Vec<_>>(), all);
        }
    }
}
