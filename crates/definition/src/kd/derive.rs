use uuid::Uuid;

/// An id that follows from another id and a name: the same each time, so that a text needs no ids.
///
/// Two FNV-1a hashes of 64 bits with different starts, marked as a GUID of version 8 (RFC 9562, 5.8: custom).
pub fn id(parent: Uuid, name: &str) -> Uuid {
    of_bytes(parent, name.as_bytes())
}

/// As [`id`], of any bytes.
pub(super) fn of_bytes(parent: Uuid, name: &[u8]) -> Uuid {
    let hash = |start: u64| {
        let bytes = parent.as_bytes().iter().chain(name);
        bytes.fold(start, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3))
    };
    // The second start is the first, hashed once more.
    let high = hash(0xcbf2_9ce4_8422_2325);
    let low = hash(0xaf63_bd4c_8601_b7df ^ high.rotate_left(32));
    let bits = u128::from(high) << 64 | u128::from(low);
    let version = 0x8u128 << 76;
    let variant = 0x2u128 << 62;
    Uuid::from_u128(bits & !(0xfu128 << 76) & !(0x3u128 << 62) | version | variant)
}

/// What the ids of a document's objects derive from when it is no cluster.
pub(super) const ROOT: Uuid = Uuid::from_u128(0x6b61_7479_6469_8064_8b64_746f_7069_6373);

#[cfg(test)]
mod tests {
    use super::{ROOT, id};

    #[test]
    fn ids_differ_and_stay() {
        let a = id(ROOT, "A");
        assert_ne!(a, id(ROOT, "B"));
        assert_ne!(id(a, "A"), a);
        assert_eq!(a.get_version_num(), 8);
        assert_eq!(a, id(ROOT, "A"));
    }
}
