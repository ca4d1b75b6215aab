//! The geometry that is shown, by the hash of its bytes.

use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Mutex, Weak};

use bytes::Bytes;
use katydid_studio::{framed_size, write_frame};

use crate::lock::held;

/// What was shown a moment ago is kept up to so many bytes: a client may be fetching it.
const LINGERING: usize = 128 << 20;

/// The geometry of an object.
#[derive(Debug)]
pub(crate) struct Geometry {
    /// The hash of the bytes.
    pub(crate) hash: String,
    /// A preview as the protocol lays it out.
    pub(crate) bytes: Bytes,
}

impl Geometry {
    /// Writes the geometry behind others that go through the socket in one frame ([`write_frame`]).
    pub(crate) fn write(&self, frame: &mut Vec<u8>) -> bool {
        write_frame(&self.hash, &self.bytes, frame)
    }

    /// How many bytes it takes in a frame.
    pub(crate) fn framed_size(&self) -> usize {
        framed_size(&self.bytes)
    }
}

/// All geometry that documents show, and what they showed last.
#[derive(Debug, Default)]
pub(crate) struct Geometries(Mutex<Shelves>);

#[derive(Debug, Default)]
struct Shelves {
    by_hash: HashMap<String, Weak<Geometry>>,
    lingering: VecDeque<Arc<Geometry>>,
    bytes: usize,
}

impl Geometries {
    /// Puts geometry where clients find it, as long as somebody holds it. Equal bytes are kept once.
    pub(crate) fn keep(&self, hash: String, bytes: Vec<u8>) -> Arc<Geometry> {
        let mut shelves = held(&self.0);
        if let Some(known) = shelves.by_hash.get(&hash).and_then(Weak::upgrade) {
            return known;
        }
        let geometry = Arc::new(Geometry { hash: hash.clone(), bytes: bytes.into() });
        shelves.by_hash.insert(hash, Arc::downgrade(&geometry));
        geometry
    }

    /// Takes back what is not shown any more; it can be had a moment longer.
    pub(crate) fn release(&self, geometry: Arc<Geometry>) {
        let mut shelves = held(&self.0);
        shelves.bytes += geometry.bytes.len();
        shelves.lingering.push_back(geometry);
        while shelves.bytes > LINGERING
            && let Some(oldest) = shelves.lingering.pop_front()
        {
            shelves.bytes -= oldest.bytes.len();
        }
        let known = shelves.by_hash.len();
        if known > 64 && known > 2 * shelves.lingering.len() {
            shelves.by_hash.retain(|_, geometry| geometry.strong_count() > 0);
        }
    }

    /// The bytes of that hash.
    pub(crate) fn get(&self, hash: &str) -> Option<Bytes> {
        let found = held(&self.0).by_hash.get(hash).and_then(Weak::upgrade)?;
        Some(found.bytes.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nobody_shows_is_forgotten_in_time() {
        let all = Geometries::default();
        for k in 0..40 {
            let geometry = all.keep(format!("{k}"), vec![0; 16 << 20]);
            all.release(geometry);
        }
        assert!(all.get("0").is_none() && all.get("39").is_some());
        let shelves = held(&all.0);
        assert!(shelves.bytes <= LINGERING && shelves.by_hash.len() <= 64);
    }

    #[test]
    fn equal_bytes_are_kept_once() {
        let all = Geometries::default();
        let (a, b) = (all.keep("x".to_owned(), vec![1]), all.keep("x".to_owned(), vec![1]));
        assert!(Arc::ptr_eq(&a, &b));
    }
}
