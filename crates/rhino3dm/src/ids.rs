//! Identifiers that no two things share.

use std::collections::HashSet;

use uuid::Uuid;

/// The identifiers of a list of things.
#[derive(Debug)]
pub(crate) struct Ids {
    taken: HashSet<Uuid>,
    /// The identifier that each thing keeps.
    own: Vec<Option<Uuid>>,
}

impl Ids {
    /// Each thing keeps the identifier it wants, unless that is nil or one before wants it, too.
    pub(crate) fn of(wanted: impl ExactSizeIterator<Item = Uuid>) -> Self {
        let mut taken = HashSet::with_capacity(wanted.len());
        let own = wanted.map(|id| (!id.is_nil() && taken.insert(id)).then_some(id)).collect();
        Self { taken, own }
    }

    /// The identifier of the thing in a place: its own, or one made from the place and some content.
    pub(crate) fn get(&self, place: usize, content: &[u8]) -> Uuid {
        if let Some(own) = self.own.get(place).copied().flatten() {
            return own;
        }
        let mut number = place as u64;
        loop {
            let id = made_id(number, content);
            if !self.taken.contains(&id) {
                return id;
            }
            number = number.wrapping_add(1 << 32);
        }
    }
}

/// An identifier of version 8 (custom, RFC 9562) from the FNV-1a hash of some bytes; it ends with the low 48 bits of
/// the number, so that no two numbers share one.
pub(crate) fn made_id(number: u64, content: &[u8]) -> Uuid {
    const BASIS: u128 = 0x6C62_272E_07BB_0142_62B8_2175_6295_C58D;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013B;
    const NUMBER: u128 = (1 << 48) - 1;
    let bytes = content.iter().copied().chain(number.to_le_bytes());
    let hash = bytes.fold(BASIS, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    let id = hash & !NUMBER | u128::from(number) & NUMBER;
    uuid::Builder::from_custom_bytes(id.to_be_bytes()).into_uuid()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_to_want_an_identifier_keeps_it() {
        let [a, b] = [Uuid::from_u128(1), Uuid::from_u128(2)];
        let ids = Ids::of([Uuid::nil(), a, a, b].into_iter());
        assert_eq!([ids.get(1, b""), ids.get(3, b"")], [a, b]);
        let made = [ids.get(0, b"same"), ids.get(2, b"same")];
        assert!(made[0] != made[1] && !made.contains(&a) && !made.contains(&b));
    }

    #[test]
    fn a_made_identifier_is_not_one_that_is_wanted() {
        let made = made_id(0, b"content");
        let ids = Ids::of([Uuid::nil(), made].into_iter());
        assert_eq!(ids.get(1, b""), made);
        assert_ne!(ids.get(0, b"content"), made);
    }
}
