//! Changes to objects, and what they leave alone.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod shared;

use katydid_definition::Error;
use katydid_definition::archive::{Chunk, Colour, Decimal, ItemValue, Limits};
use katydid_definition::document::special::{ListMode, Rounding, Slider};
use katydid_definition::document::{
    Access, Document, Mapping, NewPort, Object, Persistent, Side, Special, Stored, ids,
};
use katydid_geometry::{Interval, Point3};
use uuid::Uuid;

fn open(bytes: &[u8]) -> Result<Document, Error> {
    Document::read(bytes, &Limits::default())
}

fn container(component: Uuid, items: &[(&str, ItemValue)]) -> Object {
    let mut object = Object::new(component, "thing");
    object.set_id(Uuid::from_u128(7));
    for (name, value) in items {
        object.container_mut().set(name, value.clone());
    }
    object.refresh();
    object
}

#[test]
fn sliders_keep_their_rules() {
    let slider =
        |rounding, min, max, digits| Slider { value: 0.0, min, max, rounding, digits, expression: None };
    for (slider, x, y) in [
        (slider(Rounding::Real, 0.0, 10.0, 2), 2.34567, 2.35),
        (slider(Rounding::Real, 0.0, 10.0, 2), 99.0, 10.0),
        (slider(Rounding::Real, 0.333, 10.0, 2), 0.0, 0.333),
        (slider(Rounding::Integer, -5.0, 5.0, 3), 2.5, 2.0),
        (slider(Rounding::Integer, 0.5, 5.0, 3), 0.5, 1.0),
        (slider(Rounding::Even, 0.0, 9.0, 0), 9.0, 8.0),
        (slider(Rounding::Odd, 0.0, 8.0, 0), 8.0, 7.0),
        (slider(Rounding::Odd, 0.0, 8.0, 0), -3.0, 1.0),
        (slider(Rounding::Even, 3.0, 3.0, 0), 7.0, 3.0),
        (slider(Rounding::Real, f64::MIN, f64::MAX, 3), 1e300, 1e300),
    ] {
        assert_eq!(slider.fit(x), y, "{slider:?} at {x}");
    }
    let mut object = container(ids::NUMBER_SLIDER, &[("SourceCount", 0.into())]);
    let mut chunk = Chunk::new("Slider");
    for (name, value) in [("Min", 0.0), ("Max", 10.0), ("Value", 1.0)] {
        chunk.set(name, value);
    }
    chunk.set("Digits", 1);
    object.container_mut().set_child(chunk);
    assert_eq!(object.set_slider(4.26), Ok(4.3));
    assert!(matches!(object.special(), Some(Special::Slider(Slider { value: 4.3, .. }))));
    assert!(object.set_slider(f64::NAN).is_err());
    assert!(object.set_toggle(true).is_err());
    assert_eq!(object.set_slider(-1.0), Ok(0.0));
}

#[test]
fn edits_change_nothing_else() {
    for path in shared::definitions().into_iter().take(120) {
        let mut document = open(&std::fs::read(path).unwrap()).unwrap();
        let before = document.to_archive().root;
        for object in &mut document.objects {
            match object.special() {
                Some(Special::Slider(slider)) => {
                    object.set_slider(slider.value).unwrap();
                }
                Some(Special::Panel(panel)) => drop(object.set_panel_text(&panel.text)),
                Some(Special::Toggle(on)) => object.set_toggle(on).unwrap(),
                Some(Special::Colour(colour)) => object.set_colour(colour).unwrap(),
                Some(Special::ValueList(list)) if list.mode != ListMode::CheckList => {
                    let chosen: Vec<_> = (0..list.items.len()).filter(|i| list.items[*i].selected).collect();
                    drop(object.select(&chosen));
                }
                Some(Special::MdSlider(slider)) => object.set_md_slider(slider.value).unwrap(),
                _ => {}
            }
            let ports: Vec<_> = object.inputs.iter().map(|port| port.sources.clone()).collect();
            for (k, sources) in ports.iter().enumerate() {
                object.set_sources(k, sources).unwrap();
            }
            let nickname = object.nickname.clone();
            object.set_nickname(&nickname);
            object.set_locked(object.locked);
        }
        let after = document.to_archive().root;
        // Sliders saved with noise below their digits are rounded, and old files order their items freely.
        let slid = |root: &Chunk| strip(&sorted(root));
        assert!(slid(&before) == slid(&after));
    }
}

/// The tree with items and chunks in the order of their names.
fn sorted(chunk: &Chunk) -> Chunk {
    let mut chunk = chunk.clone();
    chunk.items.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    chunk.chunks = chunk.chunks.iter().map(sorted).collect();
    chunk.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    chunk
}

/// The tree without slider values and without flags that say no.
fn strip(chunk: &Chunk) -> Chunk {
    let mut chunk = chunk.clone();
    let slider = chunk.name == "Slider";
    chunk.items.retain(|item| match item.name.as_str() {
        "Value" => !slider,
        "Hidden" | "Locked" => item.value != ItemValue::Bool(false),
        _ => true,
    });
    chunk.chunks = chunk.chunks.iter().map(strip).collect();
    chunk
}

#[test]
fn values_are_kept_and_taken_out() {
    let mut object = container(ids::DATA, &[("SourceCount", 0.into())]);
    assert!(object.is_floating());
    let values = Persistent::list(vec![
        Stored::Null,
        Stored::Number(1.5),
        Stored::Integer(-3),
        Stored::Boolean(true),
        Stored::Text("π\r\n".to_owned()),
        Stored::Colour(Colour::new(255, 1, 2, 3)),
        Stored::Time(1),
        Stored::Guid(Uuid::from_u128(9)),
        Stored::Point(Point3::new(1.0, 2.0, 3.0)),
        Stored::Vector(Point3::new(1.0, 2.0, 3.0).to_vector()),
        Stored::Domain(Interval::new(3.0, 1.0)),
        Stored::Domain2([Interval::UNIT, Interval::new(0.0, 2.0)]),
        Stored::Complex([1.0, -1.0]),
        Stored::MeshFace([0, 1, 2, -1]),
        Stored::Path(vec![0, 1]),
        Stored::Content("Outer::Inner".to_owned()),
    ]);
    object.set_persistent(0, Some(&values)).unwrap();
    let mut document = Document::new();
    document.objects.push(object);
    let again = open(&document.to_gh().unwrap()).unwrap();
    let object = &again.objects[0];
    assert_eq!(object.persistent(&object.inputs[0]).as_ref(), Some(&values));
    let branch = object.container().child("PersistentData").unwrap().child_at("Branch", 0).unwrap();
    assert_eq!(
        branch.child_at("Item", 1).unwrap().str("TypeName"),
        Some("Grasshopper.Kernel.Types.GH_Number")
    );
    assert_eq!(open(document.to_ghx().unwrap().as_bytes()).unwrap().objects, again.objects);
    let mut object = again.objects[0].clone();
    object.set_persistent(0, None).unwrap();
    assert!(!object.inputs[0].has_persistent);
    assert!(object.set_persistent(1, None).is_err());
    object.set_sources(0, &[Uuid::from_u128(1), Uuid::from_u128(2)]).unwrap();
    assert_eq!(object.inputs[0].sources.len(), 2);
    object.set_mapping(Side::Input, 0, Mapping::Graft).unwrap();
    assert_eq!(object.inputs[0].modifiers.mapping, Mapping::Graft);
    let mut document = Document::new();
    document.objects = vec![object.clone(), object];
    let problems = document.problems();
    assert_eq!(problems.iter().filter(|p| p.contains("not in the document")).count(), 4, "{problems:?}");
    assert!(problems.iter().any(|p| p.contains("same id")), "{problems:?}");
    let again = open(&document.to_gh().unwrap()).unwrap();
    assert_eq!(again.to_archive().root.child("Definition").unwrap().chunks.len(), 3);
    assert!(again.problems().iter().all(|p| !p.contains("announces")));
}

/// As Rhino 8 writes a Calendar: a tick after midnight, and the month that is shown as decimals.
#[test]
fn calendars_and_clocks_keep_what_files_have() {
    const STORED: i64 = 638_839_872_000_000_001;
    let kept = [("SourceCount", 0.into()), ("LocalDate", ItemValue::Date(STORED))];
    let mut calendar = container(ids::CALENDAR, &kept);
    let mut attributes = Chunk::new("Attributes");
    for (name, value) in [("DisplayMonth", "5"), ("DisplayYear", "2025")] {
        attributes.set(name, value.parse::<Decimal>().unwrap());
    }
    calendar.container_mut().set_child(attributes);
    let read = |object: &Object| match object.special() {
        Some(Special::Calendar(calendar)) => (calendar.day.date(), calendar.shown),
        other => panic!("{other:?}"),
    };
    assert_eq!(read(&calendar), ([2025, 5, 28], [2025, 5]));
    calendar.set_calendar([2024, 2, 29]).unwrap();
    assert_eq!(read(&calendar), ([2024, 2, 29], [2024, 2]));
    let c = calendar.container();
    // 19,782 days after 1970-01-01, by the calendar; the tick stays.
    assert_eq!(c.date("LocalDate"), Some(621_355_968_000_000_000 + 19_782 * 864_000_000_000 + 1));
    assert_eq!(c.child("Attributes").unwrap().decimal("DisplayMonth").unwrap().to_string(), "2");
    for none in [[2023, 2, 29], [0, 1, 1], [10_000, 1, 1], [i32::MIN, i32::MAX, i32::MIN]] {
        assert!(calendar.set_calendar(none).is_err(), "{none:?}");
    }
    assert!(calendar.set_clock(0).is_err() && calendar.set_dial(1.0).is_err());

    // A name that is stored is kept, and so is the day.
    let kept = [("SourceCount", 0.into()), ("At", ItemValue::Date(STORED))];
    let mut clock = container(ids::CLOCK, &kept);
    clock.set_clock(12 * 36_000_000_000).unwrap();
    assert_eq!(clock.container().date("At"), Some(STORED - 1 + 12 * 36_000_000_000));
    assert!(clock.container().date("LocalTime").is_none());
    for none in [-1, 864_000_000_000, i64::MAX, i64::MIN] {
        assert!(clock.set_clock(none).is_err(), "{none}");
    }
    assert!(clock.set_calendar([2024, 1, 1]).is_err());
    let mut fresh = container(ids::CLOCK, &[("SourceCount", 0.into())]);
    assert_eq!(fresh.special(), None);
    fresh.set_clock(1).unwrap();
    assert!(matches!(fresh.special(), Some(Special::Clock(clock)) if clock.time.ticks == 1));
}

#[test]
fn dials_and_lists_are_turned() {
    let mut knob = container(ids::CONTROL_KNOB, &[("SourceCount", 0.into())]);
    let mut dial = Chunk::new("DialData");
    for (name, value) in [("Minimum", "0"), ("Maximum", "10"), ("Value", "6.42")] {
        dial.set(name, value.parse::<Decimal>().unwrap());
    }
    dial.set("Limit", true);
    knob.container_mut().set_child(dial);
    assert_eq!(knob.set_dial(11.0), Ok(10.0));
    assert_eq!(knob.set_dial(0.1), Ok(0.1));
    let dial = knob.container().child("DialData").unwrap();
    assert_eq!(dial.decimal("Value").unwrap().to_string(), "0.1");
    assert!(knob.set_dial(f64::INFINITY).is_err());
    assert!(knob.set_gene(0, 1.0).is_err() && knob.set_md_slider([0.0; 3]).is_err());
    assert!(knob.set_calendar([2025, 1, 1]).is_err() && knob.set_clock(0).is_err());

    let mut pool = container(ids::GENE_POOL, &[("SourceCount", 0.into())]);
    let mut genes = Chunk::new("GeneData");
    genes.set("Decimals", 1);
    for (name, value) in [("Minimum", "0"), ("Maximum", "10")] {
        genes.set(name, value.parse::<Decimal>().unwrap());
    }
    genes.set_at("Value", 0, "5".parse::<Decimal>().unwrap());
    pool.container_mut().set_child(genes);
    pool.set_gene(0, 7.77).unwrap();
    assert!(pool.set_gene(1, 0.0).is_err());
    let Some(Special::GenePool(pool)) = pool.special() else { panic!("no pool") };
    assert_eq!(pool.values, [7.8]);

    let mut list = container(ids::VALUE_LIST, &[("SourceCount", 0.into()), ("ListMode", 1.into())]);
    for (k, name) in (0..).zip(["Red", "Green", "Blue"]) {
        let mut item = Chunk::indexed("ListItem", k);
        item.set("Name", name);
        item.set("Expression", k.to_string());
        item.set("Selected", k == 0);
        list.container_mut().set_child(item);
    }
    list.select_named("blue").unwrap();
    let Some(Special::ValueList(values)) = list.special() else { panic!("no list") };
    assert_eq!(values.items.iter().map(|item| item.selected).collect::<Vec<_>>(), [false, false, true]);
    assert!(list.select(&[0, 1]).is_err() && list.select(&[3]).is_err() && list.select_named("x").is_err());
    list.container_mut().set("ListMode", 0);
    list.select(&[0, 1]).unwrap();
    list.select(&[]).unwrap();
}

#[test]
fn new_objects_are_wired_and_saved() {
    let id = Uuid::from_u128;
    let number = Uuid::from_u128(0x3e8c_a6be_fda8_4aaf_b5c0_3c54_c8bb_7312);
    let mut a = Object::new_parameter(ids::PANEL, "Panel", "A", id(1));
    a.set_place([0.0, 0.0, 50.0, 20.0], [25.0, 10.0]);
    a.set_panel_text("5").unwrap();
    let mut sum = Object::new_component(id(100), "Sum", "S", id(2));
    let values = Some(Persistent::item(Stored::Number(3.0)));
    let port = NewPort { id: id(3), name: "A".to_owned(), access: Access::List, ..NewPort::default() };
    assert_eq!(sum.add_port(Side::Input, &port), 0);
    assert_eq!(
        sum.add_port(Side::Input, &NewPort { id: id(4), persistent: values.clone(), ..port.clone() }),
        1
    );
    assert_eq!(sum.add_port(Side::Output, &NewPort { id: id(5), ..port.clone() }), 0);
    sum.set_sources(0, &[id(1)]).unwrap();
    let mut merge = Object::new_component(id(101), "Merge", "M", id(6));
    for k in 0..3 {
        let port = NewPort { id: id(10 + k), type_id: Some(number), ..port.clone() };
        merge.add_port(Side::Input, &port);
    }
    merge.set_sources(1, &[id(5), id(1)]).unwrap();
    let mut document = Document::new();
    document.objects = vec![a, sum, merge];
    let again = open(&document.to_gh().unwrap()).unwrap();
    assert_eq!(again.objects.iter().map(|o| o.inputs.len()).collect::<Vec<_>>(), [1, 2, 3]);
    assert_eq!(again.problems(), Vec::<String>::new());
    assert_eq!(again.wires().count(), 3);
    let sum = &again.objects[1];
    assert!(!sum.variable && sum.inputs[0].access == Access::List && !sum.is_floating());
    assert_eq!(sum.persistent(&sum.inputs[1]), values);
    let merge = &again.objects[2];
    assert!(merge.variable && merge.inputs[2].type_id == Some(number));
    assert_eq!(merge.container().child("ParameterData").unwrap().i32("InputCount"), Some(3));
    assert_eq!(again.objects[0].pivot, Some([25.0, 10.0]));
}
