//! What an array holds: numbers, characters and truth values without tags, everything else as values.
//!
//! A value of another kind than the rest makes all of them values with tags, so that any value can be stored: the kind
//! is a matter of room and speed, not of the array's type.

use std::ops::Range;

use super::value::Value;

/// The elements of an array.
#[derive(Debug, Clone)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Elements {
    Bool(Vec<bool>),
    U8(Vec<u8>),
    Char(Vec<u16>),
    I32(Vec<i32>),
    I64(Vec<i64>),
    F32(Vec<f32>),
    F64(Vec<f64>),
    Values(Vec<Value>),
}

/// The same expression for whatever kind of elements there are.
macro_rules! each {
    ($elements:expr, $list:ident => $do:expr) => {
        match $elements {
            Elements::Bool($list) => $do,
            Elements::U8($list) => $do,
            Elements::Char($list) => $do,
            Elements::I32($list) => $do,
            Elements::I64($list) => $do,
            Elements::F32($list) => $do,
            Elements::F64($list) => $do,
            Elements::Values($list) => $do,
        }
    };
}

/// The same expression for two of one kind; the last for two that differ.
macro_rules! both {
    ($a:expr, $b:expr, ($x:ident, $y:ident) => $do:expr, $else:expr) => {
        match ($a, $b) {
            (Elements::Bool($x), Elements::Bool($y)) => $do,
            (Elements::U8($x), Elements::U8($y)) => $do,
            (Elements::Char($x), Elements::Char($y)) => $do,
            (Elements::I32($x), Elements::I32($y)) => $do,
            (Elements::I64($x), Elements::I64($y)) => $do,
            (Elements::F32($x), Elements::F32($y)) => $do,
            (Elements::F64($x), Elements::F64($y)) => $do,
            (Elements::Values($x), Elements::Values($y)) => $do,
            _ => $else,
        }
    };
}

/// The elements that a vector makes room for at first.
const FIRST_ROOM: usize = 4;

impl Elements {
    /// Bytes of each element where the first is this one.
    pub fn width(first: Value) -> usize {
        match first {
            Value::Bool(_) | Value::U8(_) => 1,
            Value::Char(_) => 2,
            Value::I32(_) | Value::F32(_) => 4,
            Value::I64(_) | Value::F64(_) => 8,
            _ => 16,
        }
    }

    /// One value many times.
    pub fn repeated(value: Value, n: usize) -> Self {
        match value {
            Value::Bool(x) => Self::Bool(vec![x; n]),
            Value::U8(x) => Self::U8(vec![x; n]),
            Value::Char(x) => Self::Char(vec![x; n]),
            Value::I32(x) => Self::I32(vec![x; n]),
            Value::I64(x) => Self::I64(vec![x; n]),
            Value::F32(x) => Self::F32(vec![x; n]),
            Value::F64(x) => Self::F64(vec![x; n]),
            value => Self::Values(vec![value; n]),
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        each!(self, list => list.len())
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The bytes that are taken up.
    pub fn bytes(&self) -> usize {
        each!(self, list => list.capacity().saturating_mul(size_of_first(list)))
    }

    /// An element.
    #[inline]
    pub fn get(&self, i: usize) -> Option<Value> {
        match self {
            Self::Bool(list) => list.get(i).map(|x| Value::Bool(*x)),
            Self::U8(list) => list.get(i).map(|x| Value::U8(*x)),
            Self::Char(list) => list.get(i).map(|x| Value::Char(*x)),
            Self::I32(list) => list.get(i).map(|x| Value::I32(*x)),
            Self::I64(list) => list.get(i).map(|x| Value::I64(*x)),
            Self::F32(list) => list.get(i).map(|x| Value::F32(*x)),
            Self::F64(list) => list.get(i).map(|x| Value::F64(*x)),
            Self::Values(list) => list.get(i).copied(),
        }
    }

    /// Sets an element; false where there is no such place.
    #[inline]
    pub fn set(&mut self, i: usize, value: Value) -> bool {
        fn put<T>(list: &mut [T], i: usize, x: T) -> bool {
            list.get_mut(i).map(|slot| *slot = x).is_some()
        }
        match (&mut *self, value) {
            (Self::Bool(list), Value::Bool(x)) => put(list, i, x),
            (Self::U8(list), Value::U8(x)) => put(list, i, x),
            (Self::Char(list), Value::Char(x)) => put(list, i, x),
            (Self::I32(list), Value::I32(x)) => put(list, i, x),
            (Self::I64(list), Value::I64(x)) => put(list, i, x),
            (Self::F32(list), Value::F32(x)) => put(list, i, x),
            (Self::F64(list), Value::F64(x)) => put(list, i, x),
            (Self::Values(list), x) => put(list, i, x),
            (_, x) => self.set_tagged(i, x),
        }
    }

    /// Sets an element of another kind than the rest.
    #[cold]
    fn set_tagged(&mut self, i: usize, value: Value) -> bool {
        let mut values = self.to_values();
        let Some(slot) = values.get_mut(i) else { return false };
        *slot = value;
        *self = Self::Values(values);
        true
    }

    /// Adds an element behind the last. The first one says of which kind they are.
    #[inline]
    pub fn push(&mut self, value: Value) {
        match (&mut *self, value) {
            (Self::Bool(list), Value::Bool(x)) => list.push(x),
            (Self::U8(list), Value::U8(x)) => list.push(x),
            (Self::Char(list), Value::Char(x)) => list.push(x),
            (Self::I32(list), Value::I32(x)) => list.push(x),
            (Self::I64(list), Value::I64(x)) => list.push(x),
            (Self::F32(list), Value::F32(x)) => list.push(x),
            (Self::F64(list), Value::F64(x)) => list.push(x),
            (Self::Values(list), x) if !list.is_empty() => list.push(x),
            (_, x) => self.push_other(x),
        }
    }

    /// Adds the first element, or one of another kind than the rest.
    #[cold]
    fn push_other(&mut self, value: Value) {
        if self.is_empty() {
            *self = Self::repeated(value, 1);
            return;
        }
        let mut values = self.to_values();
        values.push(value);
        *self = Self::Values(values);
    }

    /// Puts an element before another; false where there is no such place.
    pub fn insert(&mut self, at: usize, value: Value) -> bool {
        if at > self.len() {
            return false;
        }
        self.push(value);
        each!(self, list => list[at..].rotate_right(1));
        true
    }

    /// Takes some away; false where they are not all there.
    pub fn remove(&mut self, range: Range<usize>) -> bool {
        let fits = range.start <= range.end && range.end <= self.len();
        if fits {
            each!(self, list => drop(list.drain(range)));
        }
        fits
    }

    /// Takes all away.
    pub fn clear(&mut self) {
        each!(self, list => list.clear());
    }

    /// How many have room without more bytes.
    pub fn capacity(&self) -> usize {
        each!(self, list => list.capacity())
    }

    /// The bytes that the next element needs when there is no room for it: vectors double.
    pub fn bytes_to_grow(&self, next: Value) -> usize {
        let width =
            if self.is_empty() { Self::width(next) } else { each!(self, list => size_of_first(list)) };
        self.capacity().max(FIRST_ROOM).saturating_mul(width)
    }

    /// All in order.
    pub fn to_values(&self) -> Vec<Value> {
        (0..self.len()).filter_map(|i| self.get(i)).collect()
    }

    /// The references among them.
    pub fn references(&self) -> &[Value] {
        match self {
            Self::Values(list) => list,
            _ => &[],
        }
    }

    /// Some in order; none where they are not all there.
    pub fn part(&self, range: Range<usize>) -> Option<Self> {
        Some(match self {
            Self::Bool(list) => Self::Bool(list.get(range)?.to_vec()),
            Self::U8(list) => Self::U8(list.get(range)?.to_vec()),
            Self::Char(list) => Self::Char(list.get(range)?.to_vec()),
            Self::I32(list) => Self::I32(list.get(range)?.to_vec()),
            Self::I64(list) => Self::I64(list.get(range)?.to_vec()),
            Self::F32(list) => Self::F32(list.get(range)?.to_vec()),
            Self::F64(list) => Self::F64(list.get(range)?.to_vec()),
            Self::Values(list) => Self::Values(list.get(range)?.to_vec()),
        })
    }

    /// Writes others from a place on; false where they do not fit.
    pub fn put(&mut self, at: usize, others: &Self) -> bool {
        let Some(end) = at.checked_add(others.len()).filter(|end| *end <= self.len()) else { return false };
        both!(&mut *self, others, (own, new) => {
            own[at..end].copy_from_slice(new);
            return true;
        }, {});
        (0..others.len()).all(|i| others.get(i).is_some_and(|value| self.set(at + i, value)))
    }

    /// Turns the order of some around; false where they are not all there.
    pub fn reverse(&mut self, range: Range<usize>) -> bool {
        each!(self, list => list.get_mut(range).map(<[_]>::reverse).is_some())
    }
}

fn size_of_first<T>(_: &[T]) -> usize {
    size_of::<T>()
}

impl From<Vec<Value>> for Elements {
    /// Without tags where all are of one kind.
    fn from(values: Vec<Value>) -> Self {
        macro_rules! packed {
            ($($kind:ident),*) => {
                match values.first() {
                    $(Some(Value::$kind(_)) if values.iter().all(|v| matches!(v, Value::$kind(_))) => {
                        let plain = |v: Value| if let Value::$kind(x) = v { Some(x) } else { None };
                        Self::$kind(values.into_iter().filter_map(plain).collect())
                    })*
                    _ => Self::Values(values),
                }
            };
        }
        packed!(Bool, U8, Char, I32, I64, F32, F64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [Value; 7] = [
        Value::Bool(true),
        Value::U8(7),
        Value::Char(65),
        Value::I32(-3),
        Value::I64(1 << 40),
        Value::F32(0.5),
        Value::F64(-0.25),
    ];

    #[test]
    fn what_is_set_is_read_and_takes_the_room_of_its_kind() {
        for (value, width) in KINDS.into_iter().zip([1, 1, 2, 4, 8, 4, 8]) {
            let mut own = Elements::repeated(value, 10);
            assert_eq!((own.len(), own.bytes(), Elements::width(value)), (10, 10 * width, width));
            assert!(own.set(9, value) && !own.set(10, value));
            assert_eq!((own.get(9), own.get(10)), (Some(value), None));
        }
    }

    #[test]
    fn a_value_of_another_kind_keeps_the_rest() {
        for value in KINDS {
            let mut own = Elements::from(vec![value; 3]);
            assert!(!matches!(own, Elements::Values(_)));
            assert!(own.set(1, Value::Null) && !own.set(3, Value::Null));
            assert_eq!(own.to_values(), [value, Value::Null, value]);
        }
        assert_eq!(Elements::from(vec![Value::I32(1), Value::Null]).to_values().len(), 2);
    }

    #[test]
    fn elements_are_added_and_taken_away() {
        for value in KINDS {
            let mut own = Elements::from(Vec::new());
            (0..3).for_each(|_| own.push(value));
            assert!(!matches!(own, Elements::Values(_)));
            assert!(own.insert(1, value) && !own.insert(5, value));
            assert!(own.remove(0..2) && !own.remove(1..3));
            own.push(Value::Null);
            assert_eq!(own.to_values(), [value, value, Value::Null]);
            own.clear();
            own.push(value);
            assert_eq!(own.to_values(), [value]);
        }
    }

    #[test]
    fn parts_are_copied_and_turned_around() {
        let mut own = Elements::from((0..6).map(Value::I32).collect::<Vec<_>>());
        let part = own.part(1..3);
        assert!(own.part(4..7).is_none());
        assert!(part.as_ref().is_some_and(|part| own.put(4, part)));
        assert!(part.is_some_and(|part| !own.put(5, &part)));
        assert!(own.reverse(0..3) && !own.reverse(5..7));
        assert_eq!(own.to_values(), [2, 1, 0, 3, 1, 2].map(Value::I32));
        assert!(own.put(0, &Elements::repeated(Value::F64(9.0), 1)));
        assert_eq!(own.get(0), Some(Value::F64(9.0)));
    }
}
