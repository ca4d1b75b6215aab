//! Members of lists and texts that are operations of their own.

use super::heap::Obj;
use super::machine::{null_reference, out_of_range};
use super::state::{Raise, State};
use super::value::Value;

fn list_range() -> Raise {
    Raise::new(
        "ArgumentOutOfRangeException",
        "Index was out of range. Must be non-negative and less than the size of the collection.\nParameter name: index",
    )
}

fn index(value: Value) -> Option<usize> {
    match value {
        Value::I32(i) => usize::try_from(i).ok(),
        _ => None,
    }
}

impl State {
    #[inline]
    pub(super) fn count(&self, list: Value) -> Result<Value, Raise> {
        match list {
            Value::Ref(handle) => match self.heap.get(handle) {
                Obj::List(_, items, _) => Ok(Value::I32(items.len() as i32)),
                _ => Err(null_reference()),
            },
            _ => Err(null_reference()),
        }
    }

    #[inline]
    pub(super) fn item(&self, list: Value, i: Value) -> Result<Value, Raise> {
        let Value::Ref(handle) = list else { return Err(null_reference()) };
        let Obj::List(_, items, _) = self.heap.get(handle) else { return Err(null_reference()) };
        index(i).and_then(|i| items.get(i)).ok_or_else(list_range)
    }

    #[inline]
    pub(super) fn set_item(&mut self, list: Value, i: Value, value: Value) -> Result<(), Raise> {
        let Value::Ref(handle) = list else { return Err(null_reference()) };
        let Some(Obj::List(_, items, version)) = self.heap.get_mut(handle) else {
            return Err(null_reference());
        };
        if !index(i).is_some_and(|i| items.set(i, value)) {
            return Err(list_range());
        }
        *version = version.wrapping_add(1);
        Ok(())
    }

    #[inline]
    pub(super) fn add_item(&mut self, list: Value, value: Value) -> Result<(), Raise> {
        let Value::Ref(handle) = list else { return Err(null_reference()) };
        let Some(Obj::List(_, items, version)) = self.heap.get_mut(handle) else {
            return Err(null_reference());
        };
        if items.len() < items.capacity() {
            items.push(value);
            *version = version.wrapping_add(1);
            return Ok(());
        }
        let more = items.bytes_to_grow(value);
        self.reserve(more)?;
        self.heap.bytes += more;
        if let Some(Obj::List(_, items, version)) = self.heap.get_mut(handle) {
            items.push(value);
            *version = version.wrapping_add(1);
        }
        Ok(())
    }

    #[inline]
    pub(super) fn text_length(&self, text: Value) -> Result<Value, Raise> {
        self.heap.str(text).map(|units| Value::I32(units.len() as i32)).ok_or_else(null_reference)
    }

    #[inline]
    pub(super) fn text_item(&self, text: Value, i: Value) -> Result<Value, Raise> {
        let units = self.heap.str(text).ok_or_else(null_reference)?;
        index(i).and_then(|i| units.get(i)).map(|unit| Value::Char(*unit)).ok_or_else(out_of_range)
    }
}
