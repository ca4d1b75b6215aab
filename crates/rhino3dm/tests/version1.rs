//! Version 1 where the official reader cannot be asked: what it gives up on, and what it does not check.
#![allow(clippy::unwrap_used, reason = "helpers of tests only")]

mod common;

use katydid_3dm::{Limits, Model, Object, WarningKind};
use katydid_geometry::{Curve, Point3};

fn chunk(typecode: u32, body: &[u8]) -> Vec<u8> {
    let length = u32::try_from(body.len()).unwrap_or(u32::MAX);
    [&typecode.to_le_bytes()[..], &length.to_le_bytes(), body].concat()
}

fn doubles(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
}

/// The end of a list of attributes.
fn end() -> Vec<u8> {
    [0xFFFF_FFFF_u32.to_le_bytes(), [0; 4]].concat()
}

fn archive(chunks: &[Vec<u8>]) -> Vec<u8> {
    [b"3D Geometry File Format        1".to_vec(), chunks.concat()].concat()
}

#[test]
fn a_point_with_an_arrow_may_state_no_length() {
    let word = b"RhAnnotateArrow\0";
    let mut data = [16_u32.to_le_bytes(), 24_u32.to_le_bytes()].concat();
    data.extend(word);
    data.extend(doubles(&[2.0, 3.0, 6.0]));
    let mut point = chunk(0x0010_0001, &[]);
    point.extend(doubles(&[1.0, 1.0, 1.0]));
    point.extend(chunk(0x4000_0001, &data));
    point.extend(end());
    let plain = chunk(0x0010_0001, &[doubles(&[4.0, 5.0, 6.0]), end()].concat());
    let model = Model::read_strict(&archive(&[point, plain]), &Limits::default()).unwrap();
    let [arrow, point] = model.objects.as_slice() else { panic!("{} objects", model.objects.len()) };
    let Object::Curve(Curve::Line(arrow)) = &arrow.geometry else { panic!("{:?}", arrow.geometry) };
    assert_eq!((arrow.line.from, arrow.line.to), (Point3::new(1.0, 1.0, 1.0), Point3::new(3.0, 4.0, 7.0)));
    assert_eq!((arrow.domain.start, arrow.domain.end), (0.0, 7.0));
    assert_eq!(point.geometry, Object::Point(Point3::new(4.0, 5.0, 6.0)));
}

#[test]
fn a_changed_number_in_a_curve_is_noticed() {
    let Some((_, bytes)) =
        common::archives().into_iter().find(|(path, _)| path.to_string_lossy().contains("v1_three_curves"))
    else {
        return;
    };
    let whole = Model::read_strict(&bytes, &Limits::default()).unwrap();
    // The last of its curves ends shortly before the end of the archive.
    let place = bytes.windows(4).rposition(|four| four == 0x0001_0109_u32.to_le_bytes()).unwrap() + 80;
    let mut broken = bytes.clone();
    broken[place] ^= 1;
    let error = Model::read_strict(&broken, &Limits::default()).unwrap_err();
    assert!(error.to_string().contains("CRC mismatch"), "{error}");
    assert_eq!(error.path().unwrap().to_string(), "curve › substance › spline › substance");
    let model = Model::read(&broken, &Limits::default()).unwrap();
    assert_eq!(model.objects.len(), whole.objects.len());
    assert_eq!(model.warnings[0].kind, WarningKind::Checksum);
}

#[test]
fn a_cut_archive_gives_the_objects_before_the_cut() {
    let point = |x: f64| chunk(0x0010_0001, &[doubles(&[x, 0.0, 0.0]), end()].concat());
    let bytes = archive(&[point(1.0), point(2.0), point(3.0)]);
    for cut in 32..bytes.len() {
        let model = Model::read(&bytes[..cut], &Limits::default()).unwrap();
        assert_eq!(model.objects.len(), (cut - 32) / 40, "cut at {cut}");
    }
}
