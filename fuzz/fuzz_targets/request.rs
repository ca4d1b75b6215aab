//! What a face may send: reading never panics, and what is read is written and read again the same.

#![no_main]

use katydid_session::protocol::Request;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let Ok(request) = serde_json::from_str::<Request>(text) else { return };
    let written = serde_json::to_string(&request).expect("a request has a text");
    let again: Request = serde_json::from_str(&written).expect("what was written can be read");
    assert_eq!(serde_json::to_string(&again).ok(), Some(written));
});
