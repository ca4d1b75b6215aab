//! Bytes made to hurt: chunks nested without end, buffers that inflate without end, counts without end.

use std::time::{Duration, Instant};

use katydid_3dm::{Error, Limits, Model, Object};

/// The longest that any of them may take.
const WAIT: Duration = Duration::from_secs(60);

fn header(version: u32) -> Vec<u8> {
    format!("3D Geometry File Format {version:>8}").into_bytes()
}

fn chunk(typecode: u32, body: &[u8]) -> Vec<u8> {
    [&typecode.to_le_bytes()[..], &(body.len() as u64).to_le_bytes(), body].concat()
}

/// A chunk with the CRC of a body without chunks in it.
fn chunk_with_crc(typecode: u32, body: &[u8]) -> Vec<u8> {
    chunk(typecode, &[body, &crc32fast::hash(body).to_le_bytes()].concat())
}

fn in_time<T>(what: &str, read: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let value = read();
    let time = start.elapsed();
    println!("{what}: {time:?}");
    assert!(time < WAIT, "{what} took {time:?}");
    value
}

/// An archive whose object table holds one record with the given class body.
fn with_object(class: [u8; 16], body: &[u8]) -> Vec<u8> {
    let class = [chunk_with_crc(0x0002_FFFB, &class), chunk_with_crc(0x0002_FFFC, body)].concat();
    let record = chunk_with_crc(0x2000_8070, &chunk(0x0002_7FFA, &class));
    [header(70), chunk(0x1000_0013, &record)].concat()
}

/// 4ED7D4E4-E947-11D3-BFE5-0010830122F0
const MESH: [u8; 16] =
    [0xE4, 0xD4, 0xD7, 0x4E, 0x47, 0xE9, 0xD3, 0x11, 0xBF, 0xE5, 0, 0x10, 0x83, 1, 0x22, 0xF0];
/// 4ED7D4E0-E947-11D3-BFE5-0010830122F0
const POLYCURVE: [u8; 16] =
    [0xE0, 0xD4, 0xD7, 0x4E, 0x47, 0xE9, 0xD3, 0x11, 0xBF, 0xE5, 0, 0x10, 0x83, 1, 0x22, 0xF0];

#[test]
fn a_document_of_another_kind_is_told_from_an_archive() {
    let error = Model::read(b"%PDF-1.7\n%\xE2\xE3\xCF\xD3\n1 0 obj", &Limits::default()).unwrap_err();
    assert!(matches!(error, Error::NotAnArchive { .. }));
    assert_eq!(error.offset(), Some(0));
    assert!(error.to_string().contains("%PDF-1.7"), "{error}");
    let large = vec![b'3'; 40 << 20];
    in_time("40 MiB of something else", || Model::read(&large, &Limits::default()).unwrap_err());
}

#[test]
fn chunks_nested_a_hundred_thousand_deep_are_refused() {
    // Each is 12 bytes longer than the one in it.
    let mut nested = Vec::new();
    for depth in (0..100_000_u64).rev() {
        nested.extend(0x0002_7FFA_u32.to_le_bytes());
        nested.extend((depth * 12).to_le_bytes());
    }
    for table in [0x1000_0013_u32, 0x1000_0011, 0x1000_0014, 0x1000_0017, 0x1000_0012] {
        let record = chunk(0x2000_8070, &nested);
        let bytes = [header(70), chunk(table, &record)].concat();
        in_time("nested chunks", || {
            Model::read(&bytes, &Limits::default()).unwrap();
            Model::read_strict(&bytes, &Limits::default()).unwrap_err();
        });
    }
    // Polycurves in polycurves, as deep as a body can name them.
    let mut body = vec![0x10];
    for _ in 0..20_000 {
        let class = [chunk_with_crc(0x0002_FFFB, &POLYCURVE)].concat();
        let mut head = vec![0x10];
        head.extend(1_i32.to_le_bytes());
        head.extend([0; 56]);
        head.extend(2_i32.to_le_bytes());
        head.extend([0; 16]);
        head.extend(chunk(
            0x0002_7FFA,
            &[class, chunk_with_crc(0x0002_FFFC, &body[..body.len().min(5000)])].concat(),
        ));
        body = head;
    }
    let bytes = with_object(POLYCURVE, &body);
    in_time("nested polycurves", || Model::read(&bytes, &Limits::default()).unwrap());
}

#[test]
fn buffers_inflate_no_further_than_the_archive_pays_for() {
    use std::io::Write;
    let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
    let zeros = vec![0_u8; 1 << 20];
    for _ in 0..1024 {
        encoder.write_all(&zeros).unwrap();
    }
    let stream = encoder.finish().unwrap();
    // A mesh of so many vertices: header, no parameters, faces of one byte an index, then the buffer.
    let count = (1_u32 << 30) / 12;
    let mut body = vec![0x37];
    body.extend(count.to_le_bytes());
    body.extend(0_i32.to_le_bytes());
    body.extend([0; 80 + 64 + 4 + 5]);
    body.extend(4_i32.to_le_bytes());
    body.extend((1_u32 << 30).to_le_bytes());
    body.extend([0; 4]);
    body.push(1);
    body.extend(chunk_with_crc(0x4000_8000, &stream));
    let bytes = with_object(MESH, &body);
    let strict = in_time("a bomb", || Model::read_strict(&bytes, &Limits::default()).unwrap_err());
    assert!(matches!(strict.reason(), Error::TooLarge { .. }), "{strict}");
    assert_eq!(strict.path().unwrap().to_string(), "object table › object record › class › class data");
    let model = in_time("a bomb", || Model::read(&bytes, &Limits::default()).unwrap());
    assert!(matches!(model.objects[0].geometry, Object::Kept(_)));
}

#[test]
fn counts_of_two_thousand_million_are_refused_before_anything_is_allocated() {
    let model = {
        let mut model = Model::default();
        let points =
            (0..50).map(|i| katydid_geometry::Point3::new(f64::from(i), f64::from(i * i), 0.0)).collect();
        let curve = katydid_geometry::NurbsCurve::new(1, points, (0..50).map(f64::from).collect()).unwrap();
        model.objects.push(Object::Curve(curve.into()).into());
        model
    };
    for version in [4, 50, 60, 70] {
        let bytes = model.write(version).unwrap();
        let start = Instant::now();
        for place in 32..bytes.len().saturating_sub(4) {
            for count in [i32::MAX, -1, i32::MIN, 0x4000_0000] {
                let mut broken = bytes.clone();
                broken[place..place + 4].copy_from_slice(&count.to_le_bytes());
                let _ = Model::read(&broken, &Limits::default());
            }
        }
        println!("{:?} each", start.elapsed() / u32::try_from(4 * bytes.len()).unwrap());
    }
}
