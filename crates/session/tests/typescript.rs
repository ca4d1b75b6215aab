//! Writes the types of the protocol as TypeScript, for the studio: one file a type.
#![cfg(feature = "typescript")]
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::path::Path;

use katydid_session::protocol::{Event, PreviewHeader, Request, SaveFormat};
use ts_rs::{Config, TS};

#[test]
fn the_types_of_the_studio_are_those_of_the_session() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studio/src/core/protocol");
    // Counters stay far below 2^53 here: JavaScript's own numbers hold them.
    let config = Config::new().with_out_dir(folder).with_large_int("number");
    Request::export_all(&config).unwrap();
    Event::export_all(&config).unwrap();
    PreviewHeader::export_all(&config).unwrap();
    SaveFormat::export_all(&config).unwrap();
}
