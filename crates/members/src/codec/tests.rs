//! The form, byte by byte and both ways.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use proptest::prelude::*;

use super::*;
use crate::{Handles, Value};
use katydid_geometry::Point3;

#[test]
fn bytes_of_values_are_those_of_the_table() {
    let bytes = |value: &Value| encode(value, &mut Handles::default()).unwrap();
    assert_eq!(bytes(&Value::Int(-2)), [b'i', 0xfe, 255, 255, 255, 255, 255, 255, 255]);
    assert_eq!(bytes(&Value::from("hé")), [b's', 3, 0, 0, 0, b'h', 0xc3, 0xa9]);
    assert_eq!(bytes(&Value::List(vec![Value::Null, Value::Bool(true)])), [b'l', 2, 0, 0, 0, b'N', b'T']);
    let point = bytes(&Value::Point(Point3::new(1.0, 2.0, 3.0)));
    assert_eq!(point, [&b"p"[..], &1f64.to_le_bytes(), &2f64.to_le_bytes(), &3f64.to_le_bytes()].concat());
}

#[test]
fn counts_beyond_the_message_are_refused_before_they_cost_anything() {
    for tag in *b"sblmDJPWOuU" {
        let bytes = [tag, 255, 255, 255, 255];
        assert!(decode(&bytes, &Handles::default()).is_err(), "{}", char::from(tag));
    }
    let mut pipe = &[255u8, 255, 255, 255][..];
    assert!(matches!(receive(&mut pipe), Err(Error::TooLarge(_))));
}

#[test]
fn values_nest_so_deep_and_no_deeper() {
    let nested = |depth: usize| {
        let mut bytes = [b'l', 1, 0, 0, 0].repeat(depth);
        bytes.push(b'N');
        bytes
    };
    assert!(decode(&nested(DEEPEST), &Handles::default()).is_ok());
    assert!(decode(&nested(DEEPEST + 1), &Handles::default()).is_err());
}

#[test]
fn geometry_that_is_not_held_is_named() {
    let mut bytes = vec![b'G'];
    bytes.extend(7u64.to_le_bytes());
    bytes.extend([4, 0, 0, 0]);
    bytes.extend(b"Mesh");
    let error = decode(&bytes, &Handles::default()).unwrap_err().to_string();
    assert!(error.contains("Mesh 7 is not held"), "{error}");
}

fn values() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::Bool),
        any::<i64>().prop_map(Value::Int),
        (-1e9..1e9).prop_map(Value::Number),
        ".*".prop_map(Value::Text),
        prop::collection::vec(-1e9..1e9, 0..5).prop_map(Value::Numbers),
        (".*", any::<i64>()).prop_map(|(name, whole)| Value::Enum(name, whole)),
        any::<[i32; 4]>().prop_map(Value::Face),
    ];
    leaf.prop_recursive(4, 64, 6, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..6).prop_map(Value::List),
            prop::collection::vec((inner.clone(), inner.clone()), 0..4).prop_map(Value::Map),
            prop::collection::vec(
                (prop::collection::vec(any::<i32>(), 0..3), prop::collection::vec(inner, 0..4)),
                0..4
            )
            .prop_map(Value::Tree),
        ]
    })
}

proptest! {
    #[test]
    fn what_is_written_is_read(value in values()) {
        let mut handles = Handles::default();
        let bytes = encode(&value, &mut handles).unwrap();
        prop_assert_eq!(decode(&bytes, &handles).unwrap(), value);
    }

    #[test]
    fn any_bytes_are_a_value_or_an_error(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = decode(&bytes, &Handles::default());
    }
}
