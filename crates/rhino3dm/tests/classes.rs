//! Annotations, hatches, lights and the other small classes: what is written comes back, and broken bytes never
//! panic.
#![allow(clippy::unwrap_used, reason = "helpers of tests only")]

use katydid_3dm::{
    Annotation, Annotation2, Annotation2Kind, Annotation5, Annotation5Kind, AnnotationKind, BlockReference,
    ClippingPlane, CurveForm, DetailView, Dimension, Error, Hatch, HatchLoop, Light, LightStyle, Localizer,
    MorphControl, MorphShape, NurbsCage, Object, Participants, StoredPlane, TextContent, TextDot,
};
use katydid_geometry::{
    Circle, Curve, Interval, Line, NurbsCurve, Plane, Point2, Point3, Vector2, Vector3, Xform,
};
use proptest::prelude::*;
use uuid::Uuid;

const VERSIONS: [i32; 5] = [4, 50, 60, 70, 80];

fn plane() -> StoredPlane {
    StoredPlane {
        frame: Plane::YZ.with_origin(Point3::new(1.0, 2.0, 3.0)),
        equation: Some([1.0, 0.0, -0.0, 9.5]),
    }
}

fn nurbs(dimension: i32) -> CurveForm {
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
    let curve = NurbsCurve::new(2, points.to_vec(), vec![0.0, 0.0, 1.0, 1.0]).unwrap();
    CurveForm::of(&curve.into(), dimension)
}

fn annotation(kind: AnnotationKind) -> Object {
    let mut text = TextContent::new("{\\rtf1 a\\u8364?}");
    text.wrapped = true;
    Object::Annotation(Box::new(Annotation {
        kind,
        text,
        style: Uuid::from_u128(3),
        overrides: None,
        plane: plane(),
        horizontal: Vector2::Y,
        scales_text: false,
    }))
}

fn annotations() -> Vec<Object> {
    let dimension =
        || Dimension { text_moved: true, text_point: Some(Point2::new(1.0, 2.0)), ..Dimension::default() };
    let p = Point2::new;
    let kinds = vec![
        AnnotationKind::Text,
        AnnotationKind::Leader { points: vec![p(0.0, 0.0), p(1.0, 3.0)] },
        AnnotationKind::Linear { dimension: dimension(), aligned: true, end: p(5.0, 1.0), line: p(5.0, 2.0) },
        AnnotationKind::Linear {
            dimension: dimension(),
            aligned: false,
            end: p(5.0, 1.0),
            line: p(5.0, 2.0),
        },
        AnnotationKind::Angular {
            dimension: dimension(),
            three_points: true,
            directions: [Vector2::X, Vector2::Y],
            offsets: [1.0, 2.0],
            arc: p(3.0, 4.0),
        },
        AnnotationKind::Radial {
            dimension: dimension(),
            diameter: true,
            on_circle: p(1.0, 1.0),
            line: p(2.0, 2.0),
        },
        AnnotationKind::Radial {
            dimension: dimension(),
            diameter: false,
            on_circle: p(1.0, 1.0),
            line: p(2.0, 2.0),
        },
        AnnotationKind::Ordinate {
            dimension: dimension(),
            direction: 2,
            point: p(1.0, 1.0),
            leader: p(5.0, 1.0),
            kinks: [0.5, 0.25],
        },
        AnnotationKind::CentreMark { dimension: Dimension::default(), radius: 2.5 },
    ];
    kinds.into_iter().map(annotation).collect()
}

fn older_annotations() -> Vec<Object> {
    let five = |kind, number| {
        Object::Annotation5(Box::new(Annotation5 {
            kind,
            number,
            text_display: 2,
            plane: plane(),
            points: vec![Point2::new(0.0, 0.0), Point2::new(1.0, 2.0)],
            text: "one\r\ntwo".into(),
            user_positioned_text: true,
            style: 4,
            text_height: 1.5,
            // What version 4 has no place for is left at what it stands for there.
            justification: 0,
            scales_text: false,
            text_formula: String::new(),
        }))
    };
    let two = |kind, number| {
        Object::Annotation2(Box::new(Annotation2 {
            kind,
            number,
            plane: plane(),
            points: vec![Point2::new(0.0, 0.0), Point2::new(1.0, 2.0)],
            user_text: "mine".into(),
            default_text: "<>".into(),
            user_positioned_text: false,
        }))
    };
    vec![
        five(Annotation5Kind::Text, 7),
        five(Annotation5Kind::Leader, 6),
        five(Annotation5Kind::Linear, 1),
        five(Annotation5Kind::Angular { angle: 1.0, radius: 2.0 }, 3),
        five(Annotation5Kind::Radial, 5),
        five(Annotation5Kind::Ordinate { direction: 1, kinks: [1.0, 2.0] }, 8),
        two(Annotation2Kind::Linear, 1),
        two(Annotation2Kind::Radial, 4),
        two(Annotation2Kind::Angular { angle: 1.0, radius: 2.0 }, 3),
        two(Annotation2Kind::Text { font: "Arial".into(), weight: 700, height: 3.0 }, 7),
        two(Annotation2Kind::Leader, 6),
    ]
}

fn others() -> Vec<Object> {
    let numbers = (0..24).map(f64::from).collect();
    let knots = || vec![0.0, 1.0];
    let cage = NurbsCage::new(3, false, [2; 3], [knots(), knots(), knots()], [2; 3], numbers).unwrap();
    let localizer = Localizer {
        kind: 4,
        point: Point3::new(1.0, 2.0, 3.0),
        direction: Vector3::new(0.0, 0.0, 1.0),
        range: Interval::new(2.0, 1.0),
        curve: Some(nurbs(3)),
        surface: None,
    };
    let morph = |shape| MorphControl {
        shape,
        captives: vec![Uuid::from_u128(5)],
        localizers: vec![localizer.clone()],
        tolerance: 0.01,
        quick_preview: true,
        preserve_structure: false,
    };
    let clipping = ClippingPlane {
        surface_plane: plane(),
        domains: [Interval::new(0.0, 4.0), Interval::new(0.0, 2.0)],
        extents: [Interval::new(-2.0, 2.0), Interval::new(-1.0, 1.0)],
        plane: plane(),
        enabled: false,
        id: Uuid::from_u128(7),
        viewports: vec![Uuid::from_u128(8)],
        depth: 2.5,
        depth_enabled: true,
        participants: Participants {
            enabled: true,
            exclude: false,
            objects: vec![Uuid::from_u128(9)],
            layers: vec![2, 1],
        },
    };
    let light = Light { style: LightStyle::Linear, name: "long".into(), index: 3, ..Light::default() };
    vec![
        Object::TextDot(TextDot::new(Point3::new(1.0, 2.0, 3.0), "dot ⌀")),
        Object::BlockReference(Box::new(BlockReference::new(
            Uuid::from_u128(5),
            Xform::scale(Point3::ORIGIN, 2.0),
        ))),
        Object::Light(Box::new(light)),
        Object::Light(Box::new(Light { style: LightStyle::Unknown(99), ..Light::default() })),
        Object::ClippingPlane(Box::new(clipping)),
        Object::Hatch(Box::new(hatch(Point2::ORIGIN))),
        Object::NurbsCage(Box::new(cage.clone())),
        Object::MorphControl(Box::new(morph(MorphShape::Cage { before: Xform::IDENTITY, after: cage }))),
        Object::MorphControl(Box::new(morph(MorphShape::Curve { before: nurbs(3), after: nurbs(3) }))),
    ]
}

fn hatch(base_point: Point2) -> Hatch {
    let circle: Curve = Circle::new(Plane::XY, 3.0).unwrap().into();
    let line: Curve = Line::new(Point3::ORIGIN, Point3::new(1.0, 1.0, 0.0)).into();
    let part = |outer, curve| HatchLoop { outer, curve };
    Hatch {
        plane: plane(),
        scale: 2.0,
        rotation: 0.5,
        pattern: 4,
        loops: vec![
            part(true, CurveForm::of(&circle, 2)),
            part(false, CurveForm::of(&line, 2)),
            part(false, nurbs(2)),
        ],
        base_point,
    }
}

fn read_back(object: &Object, version: i32) -> Object {
    let written = object.to_on_data(version).unwrap();
    Object::from_on_data(written.archive3dm, written.opennurbs, &written.data).unwrap()
}

#[test]
fn every_version_gives_back_what_was_written() {
    for version in VERSIONS {
        for object in older_annotations().into_iter().chain(others()) {
            assert_eq!(read_back(&object, version), object, "version {version}");
        }
        for object in annotations() {
            if version >= 60 {
                assert_eq!(read_back(&object, version), object, "version {version}");
            } else if object.class_name() == "Centermark" {
                let refused = object.check_writable(version);
                assert!(matches!(refused, Err(Error::CannotWrite { .. })), "version {version}");
                assert!(object.to_on_data(version).is_err());
            } else {
                object.check_writable(version).unwrap();
                let Object::Annotation(newer) = &object else { panic!("no annotation") };
                let Object::Annotation5(older) = read_back(&object, version) else { panic!("no older form") };
                assert_eq!(older.kind == Annotation5Kind::Text, newer.kind == AnnotationKind::Text);
                assert!(older.points.iter().all(|p| p.x.is_finite() && p.y.is_finite()));
            }
        }
    }
}

#[test]
fn newer_versions_hold_more() {
    let mut dot = TextDot::new(Point3::ORIGIN, "a");
    dot.secondary_text = "b".into();
    for version in VERSIONS {
        let Object::TextDot(back) = read_back(&Object::TextDot(dot.clone()), version) else { panic!() };
        assert_eq!(back.secondary_text, if version >= 60 { "b" } else { "" });
    }
    // The base point of a hatch: in user data in version 5, in the object from 6 on.
    let base = Point2::new(1.5, -2.0);
    for version in VERSIONS {
        let Object::Hatch(back) = read_back(&Object::Hatch(Box::new(hatch(base))), version) else { panic!() };
        assert_eq!(back.base_point, if version == 4 { Point2::ORIGIN } else { base });
    }
}

#[test]
fn hanging_text_stands_in_version_4() {
    let text = Annotation5 {
        kind: Annotation5Kind::Text,
        number: 7,
        text_display: 0,
        plane: Plane::XY.into(),
        points: Vec::new(),
        text: "wrapped\nhere".into(),
        user_positioned_text: false,
        style: 0,
        text_height: 2.0,
        justification: 1 << 18 | 1,
        scales_text: true,
        text_formula: String::new(),
    };
    let Object::Annotation5(back) = read_back(&Object::Annotation5(Box::new(text.clone())), 4) else {
        panic!()
    };
    assert_eq!(back.plane.frame.origin, Point3::new(0.0, -2.0, 0.0));
    assert_eq!((back.justification, back.text.as_str()), (0, "wrapped\r\nhere"));
    assert_eq!(
        read_back(&Object::Annotation5(Box::new(text.clone())), 70),
        Object::Annotation5(Box::new(text))
    );
}

#[test]
fn the_view_of_a_detail_is_carried_across() {
    // A chunk with its version, a nested chunk with a checksum, and its own checksum.
    let nested = |wide: bool| {
        let mut view = vec![1, 0, 0, 0, 0, 0, 0, 0];
        let own = crc32fast::hash(&view);
        view.extend(0x2000_8035_u32.to_le_bytes());
        let length = [12, 0, 0, 0, 0, 0, 0, 0];
        view.extend(&length[..if wide { 8 } else { 4 }]);
        view.extend([7; 8]);
        view.extend(crc32fast::hash(&[7; 8]).to_le_bytes());
        view.extend(own.to_le_bytes());
        view
    };
    let detail = |wide| {
        let detail =
            DetailView { boundary: nurbs(3), page_per_model: 0.5, view: nested(wide), view_is_wide: wide };
        Object::DetailView(Box::new(detail))
    };
    for version in VERSIONS {
        for wide in [false, true] {
            assert_eq!(read_back(&detail(wide), version), detail(version >= 50), "version {version}");
        }
    }
}

#[test]
fn sizes_that_lie_are_refused() {
    let knots = || vec![0.0, 1.0];
    let cage =
        |orders, counts| NurbsCage::new(3, true, orders, [knots(), knots(), knots()], counts, vec![0.0; 32]);
    assert!(cage([2; 3], [2; 3]).is_ok());
    assert!(cage([1, 2, 2], [2; 3]).is_err());
    assert!(cage([3, 2, 2], [2; 3]).is_err());
    assert!(cage([2; 3], [100_000; 3]).is_err());
    assert!(
        NurbsCage::new(3, false, [2; 3], [knots(), knots(), vec![1.0, 0.0]], [2; 3], vec![0.0; 24]).is_err()
    );
    assert!(
        NurbsCage::new(1, false, [2; 3], [knots(), knots(), knots()], [2; 3], vec![f64::NAN; 8]).is_err()
    );
}

proptest! {
    #[test]
    fn broken_bytes_never_panic(
        place in any::<prop::sample::Index>(),
        version in prop::sample::select(VERSIONS.to_vec()),
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in proptest::option::weighted(0.2, any::<prop::sample::Index>()),
    ) {
        let all: Vec<Object> = annotations().into_iter().chain(older_annotations()).chain(others()).collect();
        let object = place.get(&all);
        let Ok(written) = object.to_on_data(version) else { return Ok(()) };
        let mut bytes = written.data;
        for (at, value) in flips {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        if let Ok(broken) = Object::from_on_data(version, written.opennurbs, &bytes) {
            for version in VERSIONS {
                let _ = broken.to_on_data(version);
            }
            if let Object::Annotation(annotation) = &broken {
                annotation.plain_text();
            }
        }
    }
}

/// Counts of 2³¹ − 1 in every place where four bytes could be one.
#[test]
fn great_counts_are_refused_before_anything_is_allocated() {
    for object in annotations().into_iter().chain(older_annotations()).chain(others()) {
        let written = object.to_on_data(70).unwrap();
        for at in 0..written.data.len().saturating_sub(4) {
            for count in [i32::MAX, -1, i32::MIN] {
                let mut bytes = written.data.clone();
                bytes[at..at + 4].copy_from_slice(&count.to_le_bytes());
                let _ = Object::from_on_data(70, written.opennurbs, &bytes);
            }
        }
    }
}
