//! Shapefiles out of arbitrary bytes: no panic, and no more points than the bytes can hold.
#![no_main]

use katydid_exchange::shp;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(map) = shp::read(bytes) else { return };
    let lines = map.lines.iter().chain(map.polygons.iter().flatten()).map(Vec::len).sum::<usize>();
    assert!((map.points.len() + lines) * 16 <= bytes.len());
});
