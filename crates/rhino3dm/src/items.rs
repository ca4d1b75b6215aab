//! Arrays of numbers of one width, read from bytes and written to them without a copy an item.

use std::borrow::Cow;

use bytemuck::{Pod, Zeroable};

use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

/// What arrays consist of: numbers side by side, little-endian in archives.
pub(crate) trait Item: Pod + Zeroable {
    /// Bytes of one number.
    const WIDTH: usize;
}

impl Item for [u8; 4] {
    const WIDTH: usize = 1;
}
impl Item for [f32; 2] {
    const WIDTH: usize = 4;
}
impl Item for [f32; 3] {
    const WIDTH: usize = 4;
}
impl Item for [u32; 4] {
    const WIDTH: usize = 4;
}
impl Item for [f64; 2] {
    const WIDTH: usize = 8;
}
impl Item for [f64; 3] {
    const WIDTH: usize = 8;
}

/// Turns numbers as archives have them into those of this machine, or back.
fn swap_bytes(bytes: &mut [u8], width: usize) {
    if cfg!(target_endian = "big") {
        bytes.chunks_exact_mut(width).for_each(<[u8]>::reverse);
    }
}

/// Room for `size` bytes of items, filled by `fill`.
fn filled<T: Item>(size: usize, fill: impl FnOnce(&mut [u8]) -> Result<()>) -> Result<Vec<T>> {
    let mut items = vec![T::zeroed(); size / size_of::<T>()];
    let bytes = bytemuck::cast_slice_mut::<T, u8>(&mut items);
    fill(bytes)?;
    swap_bytes(bytes, T::WIDTH);
    Ok(items)
}

impl Reader<'_> {
    /// A count, then as many items.
    pub(crate) fn items<T: Item>(&mut self, what: &'static str) -> Result<Vec<T>> {
        let count = self.count(size_of::<T>(), what)?;
        self.items_of(count, what)
    }

    /// `count` items without a count of their own.
    pub(crate) fn items_of<T: Item>(&mut self, count: usize, what: &'static str) -> Result<Vec<T>> {
        let bytes = self.take(count.saturating_mul(size_of::<T>()), what)?;
        filled(bytes.len(), |room| {
            room.copy_from_slice(bytes);
            Ok(())
        })
    }

    /// A compressed buffer of whole items, inflated straight into them.
    pub(crate) fn compressed_items<T: Item>(&mut self, what: &'static str) -> Result<Vec<T>> {
        let offset = self.offset();
        let buffer = self.compressed_buffer(what)?;
        let size = buffer.size();
        if size % size_of::<T>() != 0 {
            let why = format!("{size} bytes are no whole number of items of {}", size_of::<T>());
            return Err(Error::malformed(offset, what, why));
        }
        filled(size, |room| buffer.inflate_into(self.context(), room))
    }
}

impl Writer {
    /// A count and the items.
    pub(crate) fn items<T: Item>(&mut self, items: &[T], what: &str) -> Result<()> {
        self.count(items.len(), what)?;
        self.items_of(items);
        Ok(())
    }

    /// The items without a count.
    pub(crate) fn items_of<T: Item>(&mut self, items: &[T]) {
        self.bytes(&bytes_of(items));
    }
}

/// The bytes of items as archives have them.
pub(crate) fn bytes_of<T: Item>(items: &[T]) -> Cow<'_, [u8]> {
    let bytes = bytemuck::cast_slice::<T, u8>(items);
    if cfg!(target_endian = "big") {
        let mut swapped = bytes.to_vec();
        swap_bytes(&mut swapped, T::WIDTH);
        return Cow::Owned(swapped);
    }
    Cow::Borrowed(bytes)
}
