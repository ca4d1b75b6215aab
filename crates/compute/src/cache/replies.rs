use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use super::lock;

/// Replies of requests that allow it, by definition and content of the request. The oldest use goes first.
#[derive(Debug)]
pub(crate) struct Replies {
    most: usize,
    kept: Mutex<Kept>,
}

/// A definition and the digest of a request.
type Key = (String, [u8; 32]);

#[derive(Debug, Default)]
struct Kept {
    entries: HashMap<Key, (Arc<[u8]>, u64)>,
    bytes: usize,
    clock: u64,
}

/// What an entry takes besides its reply.
const ENTRY: usize = 200;

impl Replies {
    /// A store for so many bytes.
    pub(crate) fn new(most: usize) -> Self {
        Self { most, kept: Mutex::default() }
    }

    /// The reply that was kept.
    pub(crate) fn get(&self, definition: &str, digest: [u8; 32]) -> Option<Arc<[u8]>> {
        let kept = &mut *lock(&self.kept);
        let (body, used) = kept.entries.get_mut(&(definition.to_owned(), digest))?;
        kept.clock += 1;
        *used = kept.clock;
        Some(body.clone())
    }

    /// Keeps a reply, unless it is larger than a tenth of the room.
    pub(crate) fn put(&self, definition: &str, digest: [u8; 32], body: Arc<[u8]>) {
        let weight = |key: &Key, body: &[u8]| ENTRY + key.0.len() + body.len();
        let key = (definition.to_owned(), digest);
        let own = weight(&key, &body);
        if own > self.most / 10 {
            return;
        }
        let kept = &mut *lock(&self.kept);
        kept.clock += 1;
        kept.bytes += own;
        if let Some((old, _)) = kept.entries.insert(key.clone(), (body, kept.clock)) {
            kept.bytes -= weight(&key, &old);
        }
        while kept.bytes > self.most {
            let oldest = kept.entries.iter().min_by_key(|(_, (_, used))| *used).map(|(key, _)| key.clone());
            let Some(oldest) = oldest else { break };
            if let Some((body, _)) = kept.entries.remove(&oldest) {
                kept.bytes -= weight(&oldest, &body);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_use_goes_first() {
        let replies = Replies::new(20_000);
        let digest = |n: u8| [n; 32];
        let body = |n: u8| Arc::from(vec![n; 1500].as_slice());
        for n in 0..20 {
            replies.put("d", digest(n), body(n));
            replies.get("d", digest(0)).unwrap();
        }
        assert!(replies.get("d", digest(1)).is_none());
        assert_eq!(replies.get("d", digest(19)).unwrap()[0], 19);
        assert!(replies.get("e", digest(19)).is_none());
        assert!(lock(&replies.kept).bytes <= 20_000);
        replies.put("d", digest(99), Arc::from(vec![0; 5000].as_slice()));
        assert!(replies.get("d", digest(99)).is_none());
    }
}
