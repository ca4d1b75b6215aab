//! What a request says about caches.

/// What a request may take from earlier ones, and leave for later ones: the part of RFC 9111 that a request can ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CacheControl {
    /// It may take what is kept, and leave what may be kept.
    #[default]
    Allowed,
    /// `no-cache`: everything is fetched and solved anew; a definition may be kept.
    NoCache,
    /// `no-store`: everything is fetched and solved anew, and nothing of it is kept.
    NoStore,
}

impl CacheControl {
    /// What the value of a header `Cache-Control` asks for. Directives that do not concern this cache are ignored, as the
    /// standard wants it.
    pub fn of_header(value: &str) -> Self {
        let asked = |directive: &str| {
            let (name, argument) = directive.split_once('=').unwrap_or((directive, ""));
            match name.trim().to_ascii_lowercase().as_str() {
                "no-store" => Self::NoStore,
                "no-cache" => Self::NoCache,
                // An answer that is older than nothing is a new one.
                "max-age" if argument.trim().trim_matches('"').parse() == Ok(0_u64) => Self::NoCache,
                _ => Self::Allowed,
            }
        };
        value.split(',').map(asked).fold(Self::Allowed, Self::stricter)
    }

    /// The one of two that allows less.
    #[must_use]
    pub fn stricter(self, other: Self) -> Self {
        match (self, other) {
            (Self::NoStore, _) | (_, Self::NoStore) => Self::NoStore,
            (Self::NoCache, _) | (_, Self::NoCache) => Self::NoCache,
            _ => Self::Allowed,
        }
    }

    /// Whether results and replies of earlier requests may be taken.
    pub fn reads(self) -> bool {
        self == Self::Allowed
    }

    /// Whether something may be kept for later requests.
    pub fn keeps(self) -> bool {
        self != Self::NoStore
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directives_are_found_among_others() {
        for (value, asked) in [
            ("", CacheControl::Allowed),
            ("max-age=60, only-if-cached", CacheControl::Allowed),
            ("max-age=00, x", CacheControl::NoCache),
            ("max-age=\"0\"", CacheControl::NoCache),
            ("max-age", CacheControl::Allowed),
            (" No-Cache ", CacheControl::NoCache),
            ("no-cache,NO-STORE", CacheControl::NoStore),
            ("no-store , no-cache", CacheControl::NoStore),
            ("no-stores, not-no-cache, =no-store", CacheControl::Allowed),
        ] {
            assert_eq!(CacheControl::of_header(value), asked, "{value}");
        }
    }

    #[test]
    fn what_is_allowed() {
        use CacheControl::{Allowed, NoCache, NoStore};
        let all = [Allowed, NoCache, NoStore];
        assert_eq!(all.map(|one| (one.reads(), one.keeps())), [(true, true), (false, true), (false, false)]);
        for one in all {
            assert_eq!((one.stricter(NoStore), one.stricter(Allowed)), (NoStore, one));
        }
    }
}
