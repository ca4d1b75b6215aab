//! The body of a request to the compute server, and a header about caches: reading never panics, and no more is kept than
//! the limits allow.

#![no_main]

use katydid_compute::{CacheControl, RequestLimits, SolveRequest};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    if let Ok(text) = std::str::from_utf8(data) {
        let asked = CacheControl::of_header(text);
        assert_eq!(asked.stricter(asked), asked);
    }
    let limits = RequestLimits { items: 100, branches: 20, bytes: 1 << 16 };
    let Ok(request) = SolveRequest::read(data, &limits) else { return };
    let branches = || request.values.iter().flat_map(|tree| &tree.branches);
    assert!(branches().count() + request.values.len() <= 2 * limits.branches);
    assert!(branches().map(|(_, items)| items.len()).sum::<usize>() <= limits.items);
    let rules = request.rules(None);
    assert!(rules.tolerance.absolute > 0.0 && rules.tolerance.angle > 0.0);
});
