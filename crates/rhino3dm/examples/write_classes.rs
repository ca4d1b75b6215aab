//! Writes annotations of all generations and other small classes: `write_classes OUT.3dm VERSION`.
//!
//! What each object is, by its name, is known to the comparison with other readers.

use katydid_3dm::{
    Annotation, Annotation2, Annotation2Kind, Annotation5, Annotation5Kind, AnnotationKind, BlockReference,
    ClippingPlane, Dimension, Light, LightStyle, Model, ModelObject, NurbsCage, Object, Participants,
    StoredPlane, TextContent, TextDot,
};
use katydid_geometry::{Interval, Plane, Point2, Point3, Vector2, Vector3, Xform};
use uuid::Uuid;

fn frame() -> Plane {
    let (x, y) = (Vector3::new(0.8, 0.6, 0.0), Vector3::new(-0.6, 0.8, 0.0));
    Plane { origin: Point3::new(1.0, 2.0, 3.0), x_axis: x, y_axis: y, z_axis: Vector3::new(0.0, 0.0, 1.0) }
}

fn annotation(kind: AnnotationKind) -> Object {
    let is_mark = matches!(kind, AnnotationKind::CentreMark { .. });
    let mut text =
        TextContent::new("{\\rtf1\\deff0{\\fonttbl{\\f0 Arial;}}\\f0 Text \\u197? \\b bold\\b0\\par second}");
    text.width = 12.5;
    if is_mark {
        text.rich_text.clear();
    }
    Object::Annotation(Box::new(Annotation {
        kind,
        text,
        style: Uuid::nil(),
        overrides: None,
        plane: frame().into(),
        horizontal: Vector2::X,
        scales_text: true,
    }))
}

fn newest() -> Vec<(&'static str, Object)> {
    let dimension = || Dimension {
        user_text: "about <>".into(),
        text_moved: true,
        text_point: Some(Point2::new(1.5, 2.25)),
        distance_scale: 2.0,
        ..Dimension::default()
    };
    let p = Point2::new;
    let kinds = vec![
        ("text", AnnotationKind::Text),
        ("leader", AnnotationKind::Leader { points: vec![p(0.0, 0.0), p(1.0, 1.0), p(3.0, 1.0)] }),
        (
            "linear",
            AnnotationKind::Linear {
                dimension: dimension(),
                aligned: false,
                end: p(5.0, 1.0),
                line: p(5.0, 2.0),
            },
        ),
        (
            "aligned",
            AnnotationKind::Linear {
                dimension: dimension(),
                aligned: true,
                end: p(4.0, 0.0),
                line: p(4.0, 2.0),
            },
        ),
        (
            "angular",
            AnnotationKind::Angular {
                dimension: dimension(),
                three_points: false,
                directions: [Vector2::X, Vector2::Y],
                offsets: [1.0, 1.5],
                arc: p(2.0, 2.0),
            },
        ),
        (
            "angular of three points",
            AnnotationKind::Angular {
                dimension: dimension(),
                three_points: true,
                directions: [Vector2::X, Vector2::new(0.0, -1.0)],
                offsets: [2.0, 2.5],
                arc: p(3.0, -3.0),
            },
        ),
        (
            "radius",
            AnnotationKind::Radial {
                dimension: dimension(),
                diameter: false,
                on_circle: p(3.0, 4.0),
                line: p(6.0, 8.0),
            },
        ),
        (
            "diameter",
            AnnotationKind::Radial {
                dimension: dimension(),
                diameter: true,
                on_circle: p(3.0, 4.0),
                line: p(7.0, 8.0),
            },
        ),
        (
            "ordinate",
            AnnotationKind::Ordinate {
                dimension: dimension(),
                direction: 1,
                point: p(3.0, 1.0),
                leader: p(3.5, 6.0),
                kinks: [0.5, 0.25],
            },
        ),
        ("centre mark", AnnotationKind::CentreMark { dimension: dimension(), radius: 2.5 }),
    ];
    kinds.into_iter().map(|(name, kind)| (name, annotation(kind))).collect()
}

fn annotation_5(kind: Annotation5Kind, number: i32, points: &[[f64; 2]]) -> Object {
    Object::Annotation5(Box::new(Annotation5 {
        kind,
        number,
        text_display: 2,
        plane: frame().into(),
        points: points.iter().map(|[x, y]| Point2::new(*x, *y)).collect(),
        text: "Maß <>".into(),
        user_positioned_text: false,
        style: 0,
        text_height: 1.25,
        justification: if number == 7 { (1 << 18) + 1 } else { 0 },
        scales_text: true,
        text_formula: String::new(),
    }))
}

fn annotation_2(kind: Annotation2Kind, number: i32, points: &[[f64; 2]]) -> Object {
    Object::Annotation2(Box::new(Annotation2 {
        kind,
        number,
        plane: frame().into(),
        points: points.iter().map(|[x, y]| Point2::new(*x, *y)).collect(),
        user_text: "old".into(),
        default_text: "<>".into(),
        user_positioned_text: false,
    }))
}

fn older() -> Vec<(&'static str, Object)> {
    let linear = [[0.0, 0.0], [0.0, 2.0], [5.0, 0.0], [5.0, 2.0], [2.5, 2.0]];
    let radial = [[0.0, 0.0], [3.0, 4.0], [7.0, 8.0], [6.0, 8.0]];
    let angular = [[2.0, 0.0], [0.0, 2.0], [2.0, 2.0], [1.0, 1.0]];
    let right_angle = std::f64::consts::FRAC_PI_2;
    let radius = 8.0_f64.sqrt();
    vec![
        ("text 5", annotation_5(Annotation5Kind::Text, 7, &[])),
        ("leader 5", annotation_5(Annotation5Kind::Leader, 6, &[[0.0, 0.0], [1.0, 1.0], [3.0, 1.0]])),
        ("linear 5", annotation_5(Annotation5Kind::Linear, 1, &linear)),
        ("aligned 5", annotation_5(Annotation5Kind::Linear, 2, &linear)),
        ("radius 5", annotation_5(Annotation5Kind::Radial, 5, &radial)),
        ("diameter 5", annotation_5(Annotation5Kind::Radial, 4, &radial)),
        ("angular 5", annotation_5(Annotation5Kind::Angular { angle: right_angle, radius }, 3, &angular)),
        (
            "ordinate 5",
            annotation_5(
                Annotation5Kind::Ordinate { direction: 0, kinks: [0.5, 0.25] },
                8,
                &[[3.0, 1.0], [3.5, 6.0]],
            ),
        ),
        ("linear 2", annotation_2(Annotation2Kind::Linear, 1, &linear)),
        ("radius 2", annotation_2(Annotation2Kind::Radial, 5, &radial)),
        ("angular 2", annotation_2(Annotation2Kind::Angular { angle: right_angle, radius }, 3, &angular)),
        (
            "text 2",
            annotation_2(
                Annotation2Kind::Text { font: "Arial".into(), weight: 400, height: 2.0 },
                7,
                &[[0.0, 0.0]],
            ),
        ),
        ("leader 2", annotation_2(Annotation2Kind::Leader, 6, &[[0.0, 0.0], [1.0, 1.0], [3.0, 1.0]])),
    ]
}

fn others() -> Result<Vec<(&'static str, Object)>, Box<dyn std::error::Error>> {
    let mut dot = TextDot::new(Point3::new(1.0, 2.0, 3.0), "dot ⌀");
    dot.secondary_text = "more".into();
    dot.height = 17;
    let xform = Xform {
        rows: [[0.0, -2.0, 0.0, 5.0], [2.0, 0.0, 0.0, 6.0], [0.0, 0.0, 2.0, 7.0], [0.0, 0.0, 0.0, 1.0]],
    };
    let clipping = ClippingPlane {
        surface_plane: frame().into(),
        domains: [Interval::new(0.0, 4.0), Interval::new(0.0, 2.0)],
        extents: [Interval::new(-2.0, 2.0), Interval::new(-1.0, 1.0)],
        plane: StoredPlane::from(frame()),
        enabled: true,
        id: Uuid::from_u128(7),
        viewports: vec![Uuid::from_u128(8), Uuid::from_u128(9)],
        depth: 2.5,
        depth_enabled: true,
        participants: Participants { enabled: true, layers: vec![0], ..Participants::default() },
    };
    let corners = (0..8).flat_map(|i| [i >> 2 & 1, i >> 1 & 1, i & 1].map(f64::from)).collect();
    let knots = [vec![0.0, 1.0], vec![0.0, 1.0], vec![0.0, 1.0]];
    let cage = NurbsCage::new(3, false, [2; 3], knots, [2; 3], corners)?;
    Ok(vec![
        ("dot", Object::TextDot(dot)),
        ("block", Object::BlockReference(Box::new(BlockReference::new(Uuid::from_u128(5), xform)))),
        ("clipping plane", Object::ClippingPlane(Box::new(clipping))),
        ("cage", Object::NurbsCage(Box::new(cage))),
    ])
}

fn lights() -> Vec<(&'static str, Object)> {
    let light = |name, style| {
        let light = Light {
            style,
            name: String::from(name),
            intensity: 0.75,
            watts: 60.0,
            diffuse: [255, 200, 100, 255],
            location: Point3::new(1.0, 2.0, 3.0),
            direction: Vector3::new(0.0, 1.0, -2.0),
            length: Vector3::new(4.0, 0.0, 0.0),
            width: Vector3::new(0.0, 3.0, 0.0),
            spot_angle: 30.0,
            hot_spot: 0.5,
            shadow_intensity: 0.25,
            ..Light::default()
        };
        (name, Object::Light(Box::new(light)))
    };
    vec![
        light("directional", LightStyle::Directional),
        light("point", LightStyle::Point),
        light("spot", LightStyle::Spot),
        light("linear", LightStyle::Linear),
        light("rectangular", LightStyle::Rectangular),
        light("ambient", LightStyle::Ambient),
    ]
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [output, version] = arguments.as_slice() else {
        return Err("usage: write_classes OUT.3dm VERSION".into());
    };
    let version: i32 = version.parse()?;
    let mut model = Model::default();
    let named = |(name, object): (&str, Object)| {
        let mut object = ModelObject::from(object);
        object.attributes.name = String::from(name);
        object
    };
    if version >= 60 {
        model.objects.extend(newest().into_iter().map(named));
    }
    model.objects.extend(older().into_iter().chain(others()?).map(named));
    model.lights.extend(lights().into_iter().map(named));
    model.write_to(version, &mut std::fs::File::create(output)?)?;
    Ok(())
}
