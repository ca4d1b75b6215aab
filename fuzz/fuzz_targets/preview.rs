//! Geometry for a viewport: whatever numbers there are, what comes out keeps its own word: arrays lie inside the bytes,
//! positions are finite, indices point at positions.

#![no_main]

use katydid_data::cast::Rules;
use katydid_data::{Column, Path, Tree, Value};
use katydid_definition::document::{Object, ids};
use katydid_geometry::{Circle, Curve, Line, Mesh, MeshFace, Plane, Point3, PolylineCurve, Sphere, Surface, Vector3};
use katydid_session::display::{Fineness, Shown, encode};
use katydid_session::protocol::{PreviewHeader, Slice, SliceType};
use libfuzzer_sys::fuzz_target;

fn values(data: &[u8]) -> Vec<Value> {
    let mut numbers = data.chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap_or_default()));
    let mut next = || numbers.next();
    let mut values = Vec::new();
    while let Some(kind) = next() {
        let mut point = || Some(Point3::new(next()?, next()?, next()?));
        let (Some(a), Some(b)) = (point(), point()) else { break };
        values.push(match kind.to_bits() % 8 {
            0 => Value::Point(a),
            1 => Value::from(Line::new(a, b)),
            2 => Value::from(Plane { origin: a, ..Plane::XY }),
            3 => Circle::new(Plane { origin: a, ..Plane::XY }, b.x).map_or(Value::Point(b), Value::from),
            4 => Sphere::around(a, b.x).map_or(Value::Point(b), |ball| Value::from(Surface::from(ball))),
            5 => {
                let points = vec![a, b, a + Vector3::X, b + Vector3::Y];
                Mesh::new(points, vec![MeshFace::Quad([0, 1, 2, 3])]).map_or(Value::Point(b), Value::from)
            }
            6 => PolylineCurve::new(vec![a, b, a + Vector3::Z])
                .map_or(Value::Point(b), |line| Value::from(Curve::from(line))),
            _ => Value::Vector(b - a),
        });
    }
    values
}

fn check(bytes: &[u8]) {
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
    let length = number(8) as usize;
    let header: PreviewHeader = serde_json::from_slice(&bytes[12..12 + length]).expect("a head");
    let arrays = &bytes[(12 + length).next_multiple_of(8)..];
    let size = |slice: &Slice| match slice.kind {
        SliceType::F32 | SliceType::U32 => 4,
        SliceType::U16 => 2,
        SliceType::I8 | SliceType::U8 => 1,
    };
    let of = |slice: &Slice| &arrays[slice.offset as usize..][..size(slice) * slice.count as usize];
    for part in &header.parts {
        let positions = of(&part.positions);
        for x in positions.chunks_exact(4) {
            assert!(f32::from_le_bytes(x.try_into().expect("four bytes")).is_finite());
        }
        let points = positions.len() / 12;
        if let Some(indices) = &part.indices {
            for index in of(indices).chunks_exact(size(indices)) {
                let index = index.iter().rev().fold(0_usize, |n, byte| n << 8 | usize::from(*byte));
                assert!(index < points);
            }
        }
        for (slice, each) in [(&part.normals, 3), (&part.colours, 4), (&part.values, 1), (&part.mean, 1)] {
            if let Some(slice) = slice {
                of(slice);
                assert_eq!(slice.count as usize, each * points);
            }
        }
    }
}

fuzz_target!(|data: &[u8]| {
    let object = Object::new_parameter(ids::GEOMETRY, "Geometry", "Geo", uuid::Uuid::from_u128(1));
    let outputs = [Tree::branch_at(Path::zero(), Column::of_values(values(data), None))];
    let shown = Shown { object: &object, outputs: &outputs, inputs: &[] };
    for fineness in [Fineness::Draft { triangles: 100, exact: false }, Fineness::Coarse] {
        for preview in encode(&[shown], &Rules::default(), fineness, || true) {
            preview.geometry.iter().for_each(|geometry| check(&geometry.bytes));
        }
    }
});
