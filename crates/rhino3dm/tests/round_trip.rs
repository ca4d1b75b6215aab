//! What is written comes back, for every version that is written.
#![allow(clippy::unwrap_used, reason = "helpers of tests only")]

use katydid_3dm::{
    Attributes, Error, Group, KeptRecord, Layer, Limits, Model, ModelObject, Object, ObjectMode, PointCloud,
    Table, UnitScale,
};
use katydid_geometry::{
    Arc, ArcCurve, Circle, Curve, Interval, Line, LineCurve, Mesh, MeshFace, NurbsCurve, NurbsSurface, Plane,
    PlaneSurface, Point3, PolyCurve, PolylineCurve, RevolutionSurface, SumSurface, Surface, Tolerance, Units,
    Vector3,
};
use proptest::prelude::*;
use uuid::Uuid;

const VERSIONS: [i32; 5] = [4, 50, 60, 70, 80];

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![-1e6..1e6, Just(0.0), Just(-0.0), Just(1.0 / 3.0), -1e-9..1e-9, Just(1e-60)]
}

fn point() -> impl Strategy<Value = Point3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Point3::from)
}

fn domain() -> impl Strategy<Value = Interval> {
    (-1e3..1e3, 1e-3..1e3).prop_map(|(start, length)| Interval::new(start, start + length))
}

fn simple_curve() -> impl Strategy<Value = Curve> {
    let line = (point(), point(), domain())
        .prop_map(|(from, to, domain)| LineCurve { line: Line::new(from, to), domain }.into());
    let arc = (point(), -3.0..3.0, 1e-3..1e3, 0.0..6.0, 1e-3..6.25, domain()).prop_map(
        |(origin, turn, radius, from, angle, domain): (Point3, f64, f64, f64, f64, _)| {
            let x = Vector3::new(turn.cos(), turn.sin(), 0.25);
            let plane = Plane::from_axes(origin, x, Vector3::new(-turn.sin(), turn.cos(), 0.5)).unwrap();
            let circle = Circle { plane, radius };
            ArcCurve { arc: Arc { circle, angle: Interval::new(from, from + angle) }, domain }.into()
        },
    );
    let polyline = prop::collection::vec((point(), 1e-3..10.0), 2..20).prop_map(|vertices| {
        let steps = vertices.iter().scan(0.0, |t, (_, step)| {
            *t += step;
            Some(*t)
        });
        let parameters = steps.collect();
        let points = vertices.iter().map(|(p, _)| *p).collect();
        PolylineCurve::with_parameters(points, parameters).unwrap().into()
    });
    let nurbs = (1_usize..6, prop::collection::vec((point(), 1e-3..10.0), 6..15), any::<bool>()).prop_map(
        |(degree, controls, rational): (usize, Vec<(Point3, f64)>, bool)| {
            let spans = controls.len() - degree;
            let inner = (0..=spans).map(|i| i as f64 * 0.7);
            let mut knots = vec![0.0; degree - 1];
            knots.extend(inner);
            knots.extend(vec![spans as f64 * 0.7; degree - 1]);
            let (points, weights): (Vec<_>, Vec<_>) = controls.into_iter().unzip();
            if rational {
                NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap().into()
            } else {
                NurbsCurve::new(degree, points, knots).unwrap().into()
            }
        },
    );
    prop_oneof![line, arc, polyline, nurbs]
}

fn curve() -> impl Strategy<Value = Curve> {
    let joined = prop::collection::vec(simple_curve(), 1..5).prop_map(|segments| {
        // Joints that are the ends of segments but for rounding would come back as those ends.
        let joints = (0..=segments.len()).map(|i| i as f64 / 7.0 - 1.0).collect();
        PolyCurve::with_parameters(segments, joints).unwrap().into()
    });
    prop_oneof![4 => simple_curve(), 1 => joined].boxed()
}

fn mesh() -> impl Strategy<Value = Mesh> {
    (prop::collection::vec(point(), 4..400), any::<bool>(), prop::collection::vec(any::<[u32; 4]>(), 0..50))
        .prop_map(|(vertices, coloured, corners)| {
            let count = vertices.len() as u32;
            let faces = corners.into_iter().map(|corners| match corners.map(|c| c % count) {
                [a, b, c, d] if c == d || a % 2 == 0 => MeshFace::Triangle([a, b, c]),
                corners => MeshFace::Quad(corners),
            });
            let faces = faces.collect();
            let colours =
                if coloured { (0..count).map(|i| [i as u8, 1, 2, 255 - i as u8]).collect() } else { vec![] };
            Mesh::from_parts(vertices, faces, vec![], colours).unwrap()
        })
}

fn surface() -> impl Strategy<Value = Surface> {
    let plane =
        (point(), [domain(), domain()], [domain(), domain()]).prop_map(|(origin, extents, domains)| {
            let plane = Plane::from_normal(origin, Vector3::new(0.3, -0.2, 0.9)).unwrap();
            PlaneSurface::with_domains(plane, extents, domains).unwrap().into()
        });
    let sum = (curve(), curve(), point())
        .prop_map(|(a, b, shift)| SumSurface::new(a, b, shift.to_vector()).unwrap().into());
    let revolution = (curve(), point(), -6.0..6.0, 1e-3..6.25, domain(), any::<bool>()).prop_map(
        |(profile, from, start, angle, domain, transposed): (_, Point3, f64, f64, _, _)| {
            let axis = Line::new(from, from + Vector3::new(1e6, 2e6, 3e6));
            let angle = Interval::new(start, start + angle);
            let made = RevolutionSurface::with_domain(profile, axis, angle, domain).unwrap();
            if transposed { made.transposed().into() } else { made.into() }
        },
    );
    let nurbs = ([2_usize..5, 2_usize..5], prop::collection::vec((point(), 1e-3..10.0), 36), any::<bool>())
        .prop_map(|(orders, controls, rational)| {
            let knots = orders.map(|order: usize| {
                let inner = (0..=7 - order).map(|i| i as f64 * 0.7);
                let end = (7 - order) as f64 * 0.7;
                let ends = order - 2;
                std::iter::repeat_n(0.0, ends).chain(inner).chain(std::iter::repeat_n(end, ends)).collect()
            });
            let degrees = orders.map(|order| order - 1);
            let (points, weights): (Vec<_>, Vec<_>) = controls.into_iter().unzip();
            if rational {
                NurbsSurface::with_weights(degrees, [6, 6], &points, &weights, knots).unwrap().into()
            } else {
                NurbsSurface::new(degrees, [6, 6], points, knots).unwrap().into()
            }
        });
    prop_oneof![plane, sum, revolution, nurbs].boxed()
}

fn object() -> impl Strategy<Value = Object> {
    prop_oneof![
        point().prop_map(Object::Point),
        prop::collection::vec(point(), 0..30).prop_map(|points| Object::PointCloud(PointCloud::from(points))),
        curve().prop_map(Object::Curve),
        surface().prop_map(Object::Surface),
        mesh().prop_map(Object::from),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn objects_come_back_equal(object in object()) {
        for version in VERSIONS {
            let form = object.to_on_data(version).unwrap();
            let back = Object::from_on_data(form.archive3dm, form.opennurbs, &form.data).unwrap();
            prop_assert_eq!(&back, &object);
        }
    }

    #[test]
    fn models_come_back_equal(
        objects in prop::collection::vec((object(), "[a-zé𝄞]{0,6}", any::<bool>()), 0..6),
        names in prop::collection::vec("[A-Z ]{1,9}", 1..4),
    ) {
        let mut model = Model { units: Units::Feet, ..Model::default() };
        model.layers.extend(names.into_iter().map(Layer::new));
        let layers = model.layers.len();
        for (i, (geometry, name, marked)) in objects.into_iter().enumerate() {
            let attributes = Attributes {
                id: Uuid::from_u128(7 + i as u128),
                user_strings: if marked { vec![("key".into(), name.clone())] } else { vec![] },
                name,
                layer: Some(i % layers),
                colour: marked.then_some([1, 2, 3, 200]),
                ..Attributes::default()
            };
            model.objects.push(ModelObject { attributes, ..geometry.into() });
        }
        for version in VERSIONS {
            let back = Model::read(&model.write(version).unwrap(), &Limits::default()).unwrap();
            prop_assert_eq!(&back.warnings, &vec![]);
            for (ours, theirs) in back.objects.iter().zip(&model.objects) {
                prop_assert_eq!(&ours.geometry, &theirs.geometry);
                prop_assert_eq!(&ours.attributes, &theirs.attributes);
            }
            prop_assert_eq!((back.objects.len(), back.units), (model.objects.len(), Units::Feet));
        }
    }
}

fn read(model: &Model, version: i32) -> Model {
    Model::read(&model.write(version).unwrap(), &Limits::default()).unwrap()
}

#[test]
fn what_is_not_geometry_comes_back() {
    let top = Layer { id: Uuid::from_u128(1), colour: [9, 8, 7, 255], ..Layer::new("top") };
    let under = Layer {
        id: Uuid::from_u128(2),
        parent: Some(top.id),
        visible: false,
        locked: true,
        ..Layer::new("ünder")
    };
    let mut model = Model {
        units: Units::None,
        unit_scale: Some(UnitScale { number: 11, name: "ell".into(), metres: 0.6858 }),
        tolerance: Tolerance { absolute: 0.5, angle: 0.25 },
        relative_tolerance: 0.125,
        notes: "two\nlines".into(),
        layers: vec![top, under],
        groups: vec![Group::new("first"), Group::new("")],
        ..Model::default()
    };
    let attributes = Attributes {
        id: Uuid::from_u128(3),
        url: "https://example.org".into(),
        layer: Some(1),
        visible: false,
        mode: ObjectMode::Hidden,
        wire_density: -1,
        groups: vec![0, 1],
        ..Attributes::default()
    };
    model.objects.push(ModelObject { attributes, ..Object::Point(Point3::ORIGIN).into() });
    for version in VERSIONS {
        let back = read(&model, version);
        assert_eq!(back.layers, model.layers);
        assert_eq!(back.layer_path(1).as_deref(), Some("top::ünder"));
        assert_eq!(back.objects, model.objects);
        assert_eq!(
            (back.units, &back.unit_scale, &back.notes),
            (model.units, &model.unit_scale, &model.notes)
        );
        assert_eq!((back.tolerance, back.relative_tolerance), (model.tolerance, 0.125));
        assert_eq!((back.archive_version, back.application.as_str()), (version, "Katydid"));
        assert_eq!(back.warnings.len(), 1, "the custom unit: {:?}", back.warnings);
    }
}

#[test]
fn every_object_gets_an_identifier_of_its_own_and_always_the_same() {
    let mut model = Model::default();
    let mut object = ModelObject::from(Object::Point(Point3::ORIGIN));
    model.objects.push(object.clone());
    model.objects.push(object.clone());
    object.attributes.id = Uuid::from_u128(5);
    model.objects.push(object.clone());
    model.objects.push(object);
    let ids: Vec<Uuid> = read(&model, 70).objects.iter().map(|o| o.attributes.id).collect();
    let distinct: std::collections::HashSet<&Uuid> = ids.iter().collect();
    assert_eq!((distinct.len(), ids[2]), (4, Uuid::from_u128(5)));
    assert!(ids.iter().all(|id| !id.is_nil()));
    assert_eq!(model.write(70).unwrap(), model.write(70).unwrap());
}

#[test]
fn refusals_name_the_reason() {
    let mut model = Model::default();
    assert!(matches!(model.write(5), Err(Error::UnsupportedVersion(5))));
    let mut object = ModelObject::from(Object::Point(Point3::ORIGIN));
    object.attributes.layer = Some(1);
    model.objects.push(object);
    assert!(model.write(70).unwrap_err().to_string().contains("layer 1"));

    let limits = Limits::default();
    assert!(matches!(Model::read(b"", &limits), Err(Error::NotAnArchive { .. })));
    assert!(matches!(Model::read(b"PK\x03\x04 and so on", &limits), Err(Error::NotAnArchive { .. })));
    let unknown = Model::read(b"3D Geometry File Format       13", &limits).unwrap_err();
    assert_eq!(unknown.to_string(), "version 13 is not supported yet");
    let bytes = Model::default().write(70).unwrap();
    let cut = Model::read_strict(&bytes[..bytes.len() / 2], &limits).unwrap_err();
    assert!(matches!(cut.reason(), Error::Truncated { .. }), "{cut}");
}

#[test]
fn an_archive_behind_a_wrapper_is_found() {
    let mut model = Model::default();
    model.objects.push(Object::Point(Point3::new(1.0, 2.0, 3.0)).into());
    let mut bytes = vec![0xD0; 700];
    bytes.extend(model.write(50).unwrap());
    let back = Model::read(&bytes, &Limits::default()).unwrap();
    assert_eq!(back.objects[0].geometry, model.objects[0].geometry);
}

#[test]
fn numbers_the_kernel_refuses_are_an_error_alone_and_kept_bytes_in_an_archive() {
    let mut model = Model::default();
    model.objects.push(Object::Point(Point3::new(f64::NAN, 0.0, 0.0)).into());
    let form = model.objects[0].geometry.to_on_data(70).unwrap();
    let alone = Object::from_on_data(form.archive3dm, form.opennurbs, &form.data).unwrap_err();
    assert!(alone.to_string().contains("not a finite number"), "{alone}");
    let back = read(&model, 70);
    assert!(matches!(back.objects[0].geometry, Object::Kept(_)));
    assert!(back.warnings[0].message.contains("kept as bytes"));
}

#[test]
fn what_a_record_says_of_the_history_of_its_object_is_carried() {
    // A chunk inside: of a version 4 archive, with lengths of 4 bytes.
    let inner = [&[0x00, 0x80, 0x00, 0x40, 8, 0, 0, 0][..], &[1, 2, 3, 4], &crc32(&[1, 2, 3, 4])].concat();
    let own = [9, 8, 7];
    let body = [&own[..], &inner, &crc32(&own)].concat();
    let history = KeptRecord {
        table: Table::Objects,
        typecode: 0x0200_8074,
        value: body.len() as i64,
        body,
        archive_version: 4,
        opennurbs_version: 200_712_190,
    };
    let mut model = Model::default();
    let point = Object::Point(Point3::ORIGIN);
    model.objects.push(ModelObject { history: Some(Box::new(history.clone())), ..point.into() });
    let back = |version| Model::read(&model.write(version).unwrap(), &Limits::default()).unwrap();
    assert_eq!(back(4).objects[0].history.as_ref().unwrap().body, history.body);
    let wide = back(50).objects.remove(0).history.unwrap();
    assert_eq!((wide.body.len(), wide.archive_version), (history.body.len() + 4, 50));
    assert!(model.losses(50).unwrap().is_empty());
    assert_eq!(model.losses(70).unwrap()[0].what, "history of an object of a version 4 archive");
    assert_eq!(back(70).objects[0].history, None);
}

fn crc32(bytes: &[u8]) -> [u8; 4] {
    crc32fast::hash(bytes).to_le_bytes()
}

/// openNURBS takes the ends of segments for joints that differ from them by rounding only: what is written leaves it no
/// such choice, or trims and edges would reach beyond their curves.
#[test]
fn joints_of_polycurves_stay_where_they_are() {
    let line = |from: f64, domain: Interval| -> Curve {
        let (a, b) = (Point3::new(from, 0.0, 0.0), Point3::new(from + 1.0, 0.0, 0.0));
        LineCurve { line: Line::new(a, b), domain }.into()
    };
    let (joint, end) = (0.345_678, 0.365_223);
    let shift = 1.0 + f64::EPSILON;
    for (first, second, last) in
        [(joint, joint, end * shift), (joint * shift, joint * shift, end), (joint, joint, end)]
    {
        let segments =
            vec![line(0.0, Interval::new(0.321_733, first)), line(1.0, Interval::new(second, last))];
        let joints = [0.321_733, joint, end];
        let curve = PolyCurve::with_parameters(segments, joints.to_vec()).unwrap();
        let form = Object::Curve(curve.into()).to_on_data(70).unwrap();
        let back = Object::from_on_data(form.archive3dm, form.opennurbs, &form.data).unwrap();
        assert!(matches!(&back, Object::Curve(Curve::Poly(c)) if c.parameters() == joints), "{back:?}");
    }
}
