//! Laws of the text form: what is written reads back the same, whatever the document; nothing panics.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod kd_catalogue;

use katydid_definition::archive::{Chunk, Colour, Decimal, ItemValue, Version};
use katydid_definition::diff::{Options, compare};
use katydid_definition::document::{
    Branch, Document, Mapping, NewPort, Object, Persistent, Side, Stored, StoredGeometry, ids,
};
use katydid_definition::kd::{self, Catalogue, NoCatalogue};
use katydid_geometry::{Interval, Line, Plane, Point3, Vector3};
use kd_catalogue::Few;
use proptest::prelude::*;
use uuid::Uuid;

/// Texts that could be misread: quotes, signs, line ends, words of the language.
fn words() -> impl Strategy<Value = String> {
    prop_oneof![
        "[a-z]{1,6}( [a-z0-9]{1,4}){0,2}",
        "\\PC{0,12}",
        "[\"`'\\\\\n\r\t #{}()|=,.$@*-]{0,10}",
        Just("true".to_owned()),
        Just("else".to_owned()),
        Just("a\r\nb\r\n".to_owned()),
        Just("\"\"\"\n x\n".to_owned()),
        Just(String::new()),
    ]
}

fn numbers() -> impl Strategy<Value = f64> {
    let few = (-100i32..100).prop_map(f64::from);
    prop_oneof![any::<f64>(), few, Just(f64::NAN), Just(-0.0), Just(1e300)]
}

fn value() -> impl Strategy<Value = Stored> {
    let x = || -1e6..1e6;
    prop_oneof![
        Just(Stored::Null),
        any::<f64>().prop_map(Stored::Number),
        (-50i32..50).prop_map(|n| Stored::Number(f64::from(n))),
        any::<i32>().prop_map(Stored::Integer),
        any::<bool>().prop_map(Stored::Boolean),
        words().prop_map(Stored::Text),
        any::<[u8; 4]>().prop_map(|[a, r, g, b]| Stored::Colour(Colour { a, r, g, b })),
        any::<i64>().prop_map(Stored::Time),
        any::<u128>().prop_map(|id| Stored::Guid(Uuid::from_u128(id))),
        words().prop_map(Stored::Content),
        (x(), x(), x()).prop_map(|(x, y, z)| Stored::Point(Point3::new(x, y, z))),
        (x(), x(), x()).prop_map(|(x, y, z)| Stored::Vector(Vector3::new(x, y, z))),
        (x(), x()).prop_map(|(a, b)| Stored::Domain(Interval::new(a, b))),
        (x(), x()).prop_map(|(a, b)| {
            Stored::Line(Box::new(Line::new(Point3::new(a, b, 0.0), Point3::new(b, a, 1.0))))
        }),
        x().prop_map(|x| Stored::Plane(Box::new(Plane { origin: Point3::new(x, 0.0, x), ..Plane::XY }))),
        prop::collection::vec(0i32..5, 0..3).prop_map(Stored::Path),
        prop::collection::vec(any::<u8>(), 0..200).prop_map(|bytes| {
            let on_data = Some(bytes);
            Stored::Geometry(Box::new(StoredGeometry {
                on_data,
                edge: Some(-1),
                ..StoredGeometry::default()
            }))
        }),
    ]
}

fn persistent() -> impl Strategy<Value = Option<Persistent>> {
    let branch = (prop::collection::vec(0i32..4, 0..3), prop::collection::vec(value(), 0..4))
        .prop_map(|(path, items)| Branch { path, items });
    prop::option::of(prop::collection::vec(branch, 0..3).prop_map(|branches| Persistent { branches }))
}

fn item_value() -> impl Strategy<Value = ItemValue> {
    prop_oneof![
        any::<bool>().prop_map(ItemValue::Bool),
        any::<u8>().prop_map(ItemValue::Byte),
        any::<i32>().prop_map(ItemValue::Int32),
        any::<i64>().prop_map(ItemValue::Int64),
        any::<f32>().prop_filter("one NaN", |x| !x.is_nan()).prop_map(ItemValue::Single),
        any::<f64>().prop_filter("one NaN", |x| !x.is_nan()).prop_map(ItemValue::Double),
        (any::<[u32; 3]>(), 0u32..29, any::<bool>()).prop_map(|([low, middle, high], scale, minus)| {
            ItemValue::Decimal(Decimal { low, middle, high, flags: scale << 16 | u32::from(minus) << 31 })
        }),
        any::<i64>().prop_map(ItemValue::Date),
        any::<u128>().prop_map(|id| ItemValue::Guid(Uuid::from_u128(id))),
        words().prop_map(ItemValue::String),
        prop::collection::vec(any::<u8>(), 0..150).prop_map(ItemValue::ByteArray),
        prop::collection::vec(any::<u8>(), 0..150).prop_map(ItemValue::Bitmap),
        prop::collection::vec(-1e9..1e9f64, 0..4).prop_map(ItemValue::DoubleArray),
        any::<[i32; 2]>().prop_map(ItemValue::Point),
        any::<[i32; 4]>().prop_map(ItemValue::Rectangle),
        (any::<[i16; 4]>()).prop_map(|v| ItemValue::RectangleF(v.map(|n| f32::from(n) / 7.0))),
        (any::<[i16; 3]>()).prop_map(|v| ItemValue::Point3d(v.map(|n| f64::from(n) / 7.0))),
        (any::<[i16; 4]>()).prop_map(|v| ItemValue::Interval2d(v.map(f64::from))),
        any::<[i32; 3]>()
            .prop_map(|[major, minor, revision]| { ItemValue::Version(Version { major, minor, revision }) }),
    ]
}

/// Changes that somebody makes to an object.
#[derive(Debug, Clone)]
struct Plan {
    kind: usize,
    nickname: String,
    state: (bool, bool),
    wires: Vec<(usize, usize)>,
    kept: Vec<Option<Persistent>>,
    mapping: u8,
    expression: Option<String>,
    settings: Vec<(String, Option<i32>, ItemValue)>,
    place: Option<[i16; 4]>,
    fixed_id: Option<u128>,
}

fn plan() -> impl Strategy<Value = Plan> {
    (
        (0usize..9, words(), any::<(bool, bool)>()),
        prop::collection::vec((0usize..8, 0usize..3), 0..4),
        prop::collection::vec(persistent(), 4),
        (0u8..3, prop::option::of(words())),
        prop::collection::vec((words(), prop::option::of(0i32..3), item_value()), 0..3),
        (prop::option::of(any::<[i16; 4]>()), prop::option::of(any::<u128>())),
    )
        .prop_map(
            |((kind, nickname, state), wires, kept, (mapping, expression), settings, (place, fixed_id))| {
                Plan { kind, nickname, state, wires, kept, mapping, expression, settings, place, fixed_id }
            },
        )
}

const KINDS: [&str; 7] = ["Construct Point", "Vector XYZ", "Move", "Square", "List Item", "Merge", "Number"];

fn build(plans: &[Plan]) -> Document {
    let mut document = Document::new();
    let mut next = 1000u128;
    for plan in plans {
        next += 100;
        let id = plan.fixed_id.map_or(Uuid::from_u128(next), Uuid::from_u128);
        let facts = KINDS.get(plan.kind).and_then(|name| Few.by_name(name, false));
        let mut object = match (&facts, plan.kind) {
            (Some(facts), _) if facts.floating => {
                Object::new_parameter(facts.guid, &facts.name, &plan.nickname, id)
            }
            (Some(facts), _) => Object::new_component(facts.guid, &facts.name, &plan.nickname, id),
            (None, 7) => Object::new_parameter(ids::PANEL, "Panel", &plan.nickname, id),
            _ => Object::new_component(Uuid::from_u128(77), &plan.nickname, &plan.nickname, id),
        };
        if !object.is_floating() {
            for side in [Side::Input, Side::Output] {
                let ports = facts.as_ref().map(|f| if side == Side::Input { &f.inputs } else { &f.outputs });
                let count = ports.map_or(2, Vec::len);
                for k in 0..count {
                    next += 1;
                    let known = ports.and_then(|ports| ports.get(k));
                    let name = known.map_or(plan.nickname.clone(), |port| port.name.clone());
                    let nickname = known.map_or(plan.nickname.clone(), |port| port.nickname.clone());
                    let variable = facts.as_ref().is_some_and(|facts| facts.is_variable());
                    object.add_port(
                        side,
                        &NewPort {
                            id: Uuid::from_u128(next),
                            name,
                            nickname,
                            type_id: variable.then_some(ids::DATA),
                            ..NewPort::default()
                        },
                    );
                }
            }
        }
        for (k, kept) in plan.kept.iter().enumerate().take(object.inputs.len()) {
            object.set_persistent(k, kept.as_ref()).unwrap();
            let sources: Vec<Uuid> = plan
                .wires
                .iter()
                .skip(k)
                .filter_map(|(o, p)| document.objects.get(*o).and_then(|o| o.outputs.get(*p)))
                .map(|port| port.id)
                .collect();
            object.set_sources(k, &sources).unwrap();
            let mapping = [Mapping::None, Mapping::Flatten, Mapping::Graft][usize::from(plan.mapping)];
            object.set_mapping(Side::Input, k, mapping).unwrap();
        }
        if let (Some(text), Some(port)) = (&plan.expression, object.inputs.first().cloned())
            && let Some(chunk) = port.place.find_mut(object.container_mut())
        {
            chunk.set("InternalExpression", text.as_str());
        }
        object.set_locked(plan.state.0);
        object.set_hidden(plan.state.1);
        for (name, index, value) in &plan.settings {
            // Names that mean something stay as they are.
            let name = format!("x{name}");
            match index {
                Some(index) => object.container_mut().set_at(&name, *index, value.clone()),
                None => object.container_mut().set(&name, value.clone()),
            }
            let mut chunk = Chunk { name: name.clone(), index: *index, ..Chunk::default() };
            chunk.set(&name, value.clone());
            object.container_mut().set_child(chunk);
        }
        object.refresh();
        if let Some([x, y, w, h]) = plan.place {
            object.set_place([x, y, w, h].map(f32::from), [f32::from(x) / 3.0, f32::from(y) + 0.5]);
        }
        document.objects.push(object);
    }
    document
}

/// Sorted, and without what the catalogue says in its own words.
fn bare(chunk: &mut Chunk) {
    chunk.remove("Description");
    chunk.chunks.iter_mut().for_each(bare);
    chunk.items.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    if chunk.name != "DefinitionObjects" {
        chunk.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    }
}

/// Document to text to document, and nothing differs.
fn comes_back(document: &Document, catalogue: &dyn Catalogue) {
    let text = kd::write(document, catalogue).unwrap().text;
    let again = match kd::read(&text, catalogue) {
        Ok(read) => read.document,
        Err(problems) => panic!("{problems}\n{text}"),
    };
    let (mut a, mut b) = (document.to_archive().root, again.to_archive().root);
    bare(&mut a);
    bare(&mut b);
    assert!(a == b, "{text}\n{a:#?}\n{b:#?}");
    assert_eq!(kd::format(&text).unwrap(), text, "what is written is set the usual way");
    assert_eq!(kd::write(&again, catalogue).unwrap().text, text, "the text is stable");
    assert_eq!(compare(document, &again, &Options { layout: true }), []);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, ..ProptestConfig::default() })]

    #[test]
    fn documents_come_back(plans in prop::collection::vec(plan(), 0..7)) {
        let document = build(&plans);
        comes_back(&document, &Few);
        comes_back(&document, &NoCatalogue);
    }

    #[test]
    fn numbers_come_back(x in numbers(), y in numbers()) {
        let mut document = Document::new();
        let mut object = Object::new_parameter(ids::DATA, "Data", "d", Uuid::from_u128(5));
        let values = Persistent::list(vec![Stored::Number(x), Stored::Domain(Interval::new(x, y))]);
        object.set_persistent(0, Some(&values)).unwrap();
        document.objects.push(object);
        let text = kd::write(&document, &NoCatalogue).unwrap().text;
        let again = kd::read(&text, &NoCatalogue).unwrap().document;
        let kept = again.objects[0].persistent(&again.objects[0].inputs[0]).unwrap();
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
        match kept.branches[0].items.as_slice() {
            [Stored::Number(a), Stored::Domain(i)] => {
                prop_assert!(same(*a, x) && same(i.start, x) && same(i.end, y), "{}", text);
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn no_text_panics(text in "[A-Za-z0-9_ (){}\\[\\]=,.:;|@$'\"`#*/~!+\n-]{0,80}") {
        if let Ok(tidy) = kd::format(&text) {
            prop_assert_eq!(kd::format(&tidy).unwrap(), tidy.clone(), "{}", text);
            let (a, b) = (kd::read(&text, &Few), kd::read(&tidy, &Few));
            prop_assert_eq!(a.map(|read| read.document).ok(), b.map(|read| read.document).ok(), "{}", text);
        }
    }

    #[test]
    fn broken_texts_do_not_panic(at in 0usize..400, cut in 0usize..20, put in "\\PC{0,3}") {
        let text = include_str!("../../../examples/attractor.kd");
        let mut letters: Vec<char> = text.chars().collect();
        let at = at.min(letters.len());
        letters.splice(at..(at + cut).min(letters.len()), put.chars());
        let text: String = letters.into_iter().collect();
        if let Err(problems) = kd::read(&text, &Few) {
            prop_assert!(problems.to_string().contains("line "));
        }
        if let Ok(tidy) = kd::format(&text) {
            prop_assert_eq!(kd::format(&tidy).unwrap(), tidy.clone());
        }
    }
}
