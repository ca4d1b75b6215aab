//! Objects of archives that nothing computes with: as values they keep every number, and their user data.
#![allow(clippy::unwrap_used, reason = "helpers of tests only")]

use katydid_3dm::{
    Annotation, Annotation2, Annotation2Kind, Annotation5, Annotation5Kind, AnnotationKind, BlockReference,
    CurveForm, Hatch, HatchLoop, Light, Limits, Object, PointCloud, StoredPlane, SubDObject, TextContent,
    TextDot, UserData,
};
use katydid_data::Value;
use katydid_geometry::{Circle, Curve, Plane, Point2, Point3, Vector2, Xform};
use uuid::Uuid;

const PLANE: StoredPlane = StoredPlane { frame: Plane::YZ, equation: None };

fn objects() -> Vec<Object> {
    let points = || vec![Point2::new(0.0, 0.0), Point2::new(1.0, 2.0)];
    let circle: Curve = Circle::new(Plane::XY, 3.0).unwrap().into();
    vec![
        Object::TextDot(TextDot::new(Point3::new(1.0, 2.0, 3.0), "dot ⌀")),
        Object::BlockReference(Box::new(BlockReference::new(Uuid::from_u128(5), Xform::IDENTITY))),
        Object::Light(Box::new(Light { name: "lamp".into(), ..Light::default() })),
        Object::Hatch(Box::new(Hatch {
            plane: PLANE,
            scale: 2.0,
            rotation: 0.5,
            pattern: 4,
            loops: vec![HatchLoop { outer: true, curve: CurveForm::of(&circle, 2) }],
            base_point: Point2::new(1.0, 2.0),
        })),
        Object::SubD(Box::<SubDObject>::default()),
        Object::PointCloud(PointCloud { points: vec![Point3::ORIGIN], ..PointCloud::default() }),
        Object::Annotation(Box::new(Annotation {
            kind: AnnotationKind::Leader { points: points() },
            text: TextContent::new("text"),
            style: Uuid::from_u128(3),
            overrides: None,
            plane: PLANE,
            horizontal: Vector2::Y,
            scales_text: false,
        })),
        Object::Annotation5(Box::new(Annotation5 {
            kind: Annotation5Kind::Linear,
            number: 1,
            text_display: 2,
            plane: PLANE,
            points: points(),
            text: "one\r\ntwo".into(),
            user_positioned_text: true,
            style: 4,
            text_height: 1.5,
            justification: 0,
            scales_text: false,
            text_formula: String::new(),
        })),
        Object::Annotation2(Box::new(Annotation2 {
            kind: Annotation2Kind::Leader,
            number: 6,
            plane: PLANE,
            points: points(),
            user_text: "mine".into(),
            default_text: "<>".into(),
            user_positioned_text: false,
        })),
    ]
}

/// User data of a stranger; its body is a checksum over nothing.
fn stranger() -> UserData {
    UserData {
        class: Uuid::from_u128(11),
        item: Uuid::from_u128(12),
        application: Uuid::from_u128(13),
        copy_count: 7,
        transform: [0.25; 16],
        archive_version: 50,
        opennurbs_version: 200_912_314,
        body: vec![0; 4],
    }
}

#[test]
fn objects_become_values_that_hold_all_of_them() {
    for object in objects() {
        let name = object.class_name();
        let value = Value::from_object(object.clone(), &[stranger()]);
        let Some(Value::Kept(raw)) = value else { panic!("{name} is not kept: {value:?}") };
        assert_eq!(raw.user_data, [stranger()], "{name}");
        assert_eq!(raw.parse(&Limits::default()).unwrap(), object, "{name}");
    }
}

#[test]
fn objects_as_bytes_stay_the_bytes_they_were() {
    for object in objects() {
        for version in [4, 50, 60, 70, 80] {
            let Ok(raw) = object.to_raw(version, &[stranger()]) else { continue };
            let value = Value::from_raw(raw.clone()).unwrap();
            let Some(Value::Kept(kept)) = value else { panic!("{} is not kept", object.class_name()) };
            assert_eq!(*kept, raw, "{} of version {version}", object.class_name());
        }
    }
}
