//! Identifiers that no two things share.

use std::collections::HashSet;

use uuid::Uuid;

/// The identifiers given out so far.
#[derive(Debug, Default)]
pub(super) struct Ids(HashSet<Uuid>);

impl Ids {
    /// The wanted identifier, or one made from a place and some content when it is nil or taken.
    pub(super) fn take(&mut self, wanted: Uuid, place: usize, content: &[u8]) -> Uuid {
        if !wanted.is_nil() && self.0.insert(wanted) {
            return wanted;
        }
        let mut round = place as u64;
        loop {
            let id = made_id(round, content);
            if self.0.insert(id) {
                return id;
            }
            round = round.wrapping_add(1 << 32);
        }
    }
}

/// An identifier of version 8 (custom, RFC 9562) from the FNV-1a hash of a number and some bytes.
pub(crate) fn made_id(number: u64, content: &[u8]) -> Uuid {
    const BASIS: u128 = 0x6C62_272E_07BB_0142_62B8_2175_6295_C58D;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013B;
    let bytes = content.iter().copied().chain(number.to_le_bytes());
    let hash = bytes.fold(BASIS, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    uuid::Builder::from_custom_bytes(hash.to_be_bytes()).into_uuid()
}
