//! Archives whose tables are not where they should be, or not at all.
#![allow(clippy::unwrap_used, reason = "helpers of tests only")]

mod common;

use katydid_3dm::{Layer, Limits, Model, Object, WarningKind};
use katydid_geometry::{Line, Point3};

/// Offset behind the 32 bytes of the header.
const FIRST: usize = 32;
const END_OF_FILE: u32 = 0x7FFF;
const LAYERS: u32 = 0x1000_0011;
const OBJECTS: u32 = 0x1000_0013;
const BITMAPS: u32 = 0x1000_0016;

fn sample() -> Model {
    let mut model = Model { notes: "robust".into(), ..Model::default() };
    model.layers.extend([Layer::new("below"), Layer::new("above")]);
    for i in 0..20 {
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0 + f64::from(i), 2.0, 3.0));
        model.objects.push(Object::Curve(line.into()).into());
    }
    model.objects[7].attributes.layer = Some(1);
    model
}

/// The chunks at the top, headers and all.
fn chunks(bytes: &[u8]) -> Vec<(u32, Vec<u8>)> {
    let mut all = Vec::new();
    let mut rest = &bytes[FIRST..];
    while !rest.is_empty() {
        let number = |bytes: &[u8]| bytes.iter().rev().fold(0_u32, |n, byte| n << 8 | u32::from(*byte));
        let (typecode, length) = (number(&rest[..4]), 12 + number(&rest[4..12]) as usize);
        let (chunk, after) = rest.split_at(length);
        all.push((typecode, chunk.to_vec()));
        rest = after;
    }
    all
}

fn joined(bytes: &[u8], chunks: &[(u32, Vec<u8>)]) -> Vec<u8> {
    let mut all = bytes[..FIRST].to_vec();
    chunks.iter().for_each(|(_, chunk)| all.extend(chunk));
    all
}

fn long_chunk(typecode: u32, body: &[u8]) -> Vec<u8> {
    [&typecode.to_le_bytes()[..], &(body.len() as u64).to_le_bytes(), body].concat()
}

#[test]
fn tables_may_be_absent() {
    let bytes = sample().write(70).unwrap();
    for (missing, _) in chunks(&bytes) {
        let rest: Vec<_> = chunks(&bytes).into_iter().filter(|(typecode, _)| *typecode != missing).collect();
        let model = Model::read(&joined(&bytes, &rest), &Limits::default()).unwrap();
        let expected = if missing == OBJECTS { 0 } else { 20 };
        assert_eq!(model.objects.len(), expected, "without {missing:08X}: {:?}", model.warnings);
        assert_eq!(model.layers.len(), if missing == LAYERS { 0 } else { 2 }, "without {missing:08X}");
    }
}

#[test]
fn tables_may_stand_in_any_order() {
    let sample = sample();
    let bytes = sample.write(70).unwrap();
    let mut all = chunks(&bytes);
    // The comment and the properties come first, the end mark last: what is between them is turned around.
    let last = all.len() - 1;
    all[2..last].reverse();
    let model = Model::read_strict(&joined(&bytes, &all), &Limits::default()).unwrap();
    assert_eq!(model.layers, Model::read(&bytes, &Limits::default()).unwrap().layers);
    assert_eq!(model.objects[7].attributes.layer, Some(1));
    assert_eq!(model.objects.len(), 20);
}

#[test]
fn the_end_mark_may_be_missing() {
    let bytes = sample().write(70).unwrap();
    let mut all = chunks(&bytes);
    assert_eq!(all.pop().unwrap().0, END_OF_FILE);
    let cut = joined(&bytes, &all);
    let model = Model::read(&cut, &Limits::default()).unwrap();
    assert_eq!(model.objects.len(), 20);
    assert!(model.warnings.iter().any(|w| w.message.contains("end mark")));
    let error = Model::read_strict(&cut, &Limits::default()).unwrap_err();
    assert_eq!(error.offset(), Some(cut.len()));
}

#[test]
fn unknown_tables_and_chunks_are_passed_over() {
    let bytes = sample().write(70).unwrap();
    let mut all = chunks(&bytes);
    for typecode in [0x1000_0024, 0x1000_0099, 0x0040_0010, 0x4000_8765, 0x2000_8070] {
        all.insert(3, (typecode, long_chunk(typecode, &[7; 100])));
    }
    let model = Model::read_strict(&joined(&bytes, &all), &Limits::default()).unwrap();
    assert_eq!((model.objects.len(), model.layers.len()), (20, 2));
    assert_eq!(model.skipped["unknown"], 5);
}

#[test]
fn a_wrapper_before_the_header_is_passed_over() {
    let bytes = sample().write(70).unwrap();
    let mut wrapped = vec![0xD0, 0xCF, 0x11, 0xE0, 0xA1, 0xB1, 0x1A, 0xE1];
    wrapped.resize(1536, 0);
    wrapped.extend(&bytes);
    let model = Model::read_strict(&wrapped, &Limits::default()).unwrap();
    assert_eq!(model.objects.len(), 20);
}

/// Whatever length a table states, its records are read, and those of the tables behind it.
#[test]
fn wrong_lengths_of_tables_are_put_right() {
    let bytes = sample().write(70).unwrap();
    let all = chunks(&bytes);
    for place in 0..all.len() {
        let (typecode, chunk) = &all[place];
        if typecode >> 28 != 1 {
            continue;
        }
        let stated = chunk.len() as u64 - 12;
        for wrong in [0, 5, stated / 2, stated + 1, stated + 200, 1 << 40, u64::MAX] {
            let mut broken = all.clone();
            broken[place].1[4..12].copy_from_slice(&wrong.to_le_bytes());
            let broken = joined(&bytes, &broken);
            let model = Model::read(&broken, &Limits::default()).unwrap();
            let what = format!("{typecode:08X} of {wrong} bytes: {:?}", model.warnings);
            assert_eq!((model.objects.len(), model.layers.len()), (20, 2), "{what}");
            if wrong != stated {
                assert!(model.warnings.iter().any(|w| w.kind == WarningKind::LeftOut), "{what}");
                assert!(Model::read_strict(&broken, &Limits::default()).is_err(), "{what}");
            }
        }
    }
}

#[test]
fn rubbish_between_tables_costs_nothing_but_itself() {
    let bytes = sample().write(70).unwrap();
    let mut all = chunks(&bytes);
    let place = all.iter().position(|(typecode, _)| *typecode == BITMAPS).unwrap();
    all.insert(place, (0, vec![0; 33]));
    all.insert(place + 2, (0, b"%PDF-1.7 and so on, for a while".to_vec()));
    let broken = joined(&bytes, &all);
    let model = Model::read(&broken, &Limits::default()).unwrap();
    assert_eq!((model.objects.len(), model.layers.len()), (20, 2), "{:?}", model.warnings);
    assert!(Model::read_strict(&broken, &Limits::default()).is_err());
}

#[test]
fn a_cut_archive_gives_what_is_before_the_cut() {
    let bytes = sample().write(70).unwrap();
    let mut most = 0;
    for cut in 0..bytes.len() {
        match Model::read(&bytes[..cut], &Limits::default()) {
            Ok(model) => {
                assert!(model.objects.len() >= most, "cut at {cut}");
                most = model.objects.len();
                assert!(model.warnings.iter().any(|w| w.kind == WarningKind::LeftOut), "cut at {cut}");
            }
            Err(error) => assert!(cut < FIRST, "cut at {cut}: {error}"),
        }
        let error = Model::read_strict(&bytes[..cut], &Limits::default()).unwrap_err();
        assert!(error.offset().unwrap() <= cut, "cut at {cut}: {error}");
    }
    assert_eq!(most, 20);
}

/// A record that is broken is left out alone, and the error says where it lies.
#[test]
fn the_path_to_a_broken_record_is_told() {
    let bytes = sample().write(70).unwrap();
    let place = bytes.windows(4).position(|four| four == 0x2000_8070_u32.to_le_bytes()).unwrap();
    // The class identifier's own length, 12 bytes into the class chunk of the first record.
    let class =
        place + bytes[place..].windows(4).position(|four| four == 0x0002_FFFB_u32.to_le_bytes()).unwrap();
    let mut broken = bytes.clone();
    broken[class + 4] = 0xFF;
    broken[class + 5] = 0xFF;
    let model = Model::read(&broken, &Limits::default()).unwrap();
    assert_eq!(model.objects.len(), 19);
    let warning = &model.warnings[0];
    assert_eq!((warning.kind, model.skipped["object"]), (WarningKind::LeftOut, 1));
    let error = Model::read_strict(&broken, &Limits::default()).unwrap_err();
    assert_eq!(error.path().unwrap().to_string(), "object table › object record › class");
    assert_eq!(error.offset(), Some(class + 12));
    assert!(error.to_string().contains("chunk body needs 65535 bytes"), "{error}");
}

#[test]
fn every_real_archive_is_read_strictly() {
    for (path, bytes) in common::archives() {
        if let Err(error) = Model::read_strict(&bytes, &Limits::default()) {
            panic!("{}: {error}", path.display());
        }
    }
}
