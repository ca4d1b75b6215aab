//! A definition is made, changed, undone, saved and opened again, as a user would.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{Mirror, Studio, texts};
use katydid_definition::archive::Limits;
use katydid_definition::document::{Document, Special, ids};
use katydid_session::protocol::{
    Alignment, Connection, Control, Edit, GroupChange, Initial, ListItemView, ListModeView, MappingView,
    ObjectChange, ObjectKindView, PanelChange, PortChange, Setting, WireView,
};
use katydid_session::{Editor, Refusal, Solution};
use katydid_solver::{Engine, Options};
use uuid::Uuid;

/// Two sliders, an addition, a panel that shows it, and a group around the sliders.
fn story() -> (Studio, [Uuid; 5]) {
    let mut studio = Studio::empty();
    let (a, b) = (studio.slider(2.0, 0.0, 10.0), studio.slider(3.0, 0.0, 10.0));
    let sum = studio.place("Addition", [300.0, 40.0]);
    studio.wire(a, sum, 0);
    studio.wire(b, sum, 1);
    let panel = studio.place("Panel", [500.0, 40.0]);
    studio.wire(sum, panel, 0);
    let group = studio.id();
    studio.make(Edit::Group { id: group, objects: vec![a, b] });
    (studio, [a, b, sum, panel, group])
}

#[test]
fn a_strangers_first_ten_minutes() {
    let (mut studio, [a, b, sum, panel, group]) = story();
    assert_eq!(studio.texts(panel), ["5"]);
    studio.make(Edit::Set { object: a, to: Setting::Number { value: 4.0 } });
    assert_eq!(studio.texts(panel), ["7"]);
    studio.make(Edit::ChangeGroup { group, change: GroupChange::Label { text: "numbers".to_owned() } });
    studio.make(Edit::ChangePort {
        port: studio.output(sum, 0),
        change: PortChange::Expression { text: Some("x * 10".to_owned()) },
    });
    assert_eq!(studio.texts(panel), ["70"]);
    studio.make(Edit::Move { objects: vec![(a, [10.0, 200.0]), (b, [10.0, 240.0])] });
    assert_eq!(studio.object(a).bounds.map(|[x, y, ..]| [x, y]), Some([10.0, 200.0]));

    let made = studio.editor.document().to_ghx().unwrap();
    let mut undone = 0;
    while studio.undo() {
        undone += 1;
    }
    assert!(undone >= 14, "{undone}");
    assert!(studio.editor.document().objects.is_empty());
    assert_eq!(studio.editor.document().to_ghx().unwrap(), Document::new().to_ghx().unwrap());
    while studio.redo() {}
    assert_eq!(studio.editor.document().to_ghx().unwrap(), made);

    for bytes in [made.into_bytes(), studio.editor.document().to_gh().unwrap()] {
        let again = Document::read(&bytes, &Limits::default()).unwrap();
        let mut engine = Engine::new(again, Options::default());
        engine.solve();
        assert_eq!(texts(&engine, panel), ["70"]);
        assert!(engine.document().problems().is_empty(), "{:?}", engine.document().problems());
    }
}

#[test]
fn a_drag_is_one_step_and_can_be_abandoned() {
    let (mut studio, [a, ..]) = story();
    let value = |studio: &Studio| match studio.object(a).special() {
        Some(Special::Slider(slider)) => slider.value,
        other => panic!("{other:?}"),
    };
    for k in 0..100 {
        studio.drag(&Edit::Set { object: a, to: Setting::Number { value: f64::from(k) / 10.0 } }, 7);
    }
    assert_eq!(value(&studio), 9.9);
    assert_eq!(studio.editor.undo_name(), Some("Set Number Slider"));
    studio.undo();
    assert_eq!(value(&studio), 2.0);
    studio.redo();
    assert_eq!(value(&studio), 9.9);
    for k in 0..10 {
        studio.drag(&Edit::Set { object: a, to: Setting::Number { value: f64::from(k) } }, 8);
    }
    let change = studio.editor.abandon(8);
    studio.follow(&change);
    assert_eq!(value(&studio), 9.9);
    assert!(studio.editor.abandon(8).is_empty());
    assert_eq!(studio.editor.redo_name(), None);
}

#[test]
fn saved_and_changed_are_told_apart() {
    let (mut studio, [a, ..]) = story();
    assert!(studio.editor.is_changed());
    studio.editor.note_saved(None);
    assert!(!studio.editor.is_changed());
    studio.make(Edit::Set { object: a, to: Setting::Number { value: 1.0 } });
    assert!(studio.editor.is_changed());
    studio.undo();
    assert!(!studio.editor.is_changed());
    studio.undo();
    assert!(studio.editor.is_changed());
}

#[test]
fn a_wire_that_makes_a_loop_is_refused_with_its_way() {
    let mut studio = Studio::empty();
    let [a, b, c] = ["Negative", "Absolute", "Sine"].map(|name| studio.place(name, [0.0, 0.0]));
    studio.wire(a, b, 0);
    studio.wire(b, c, 0);
    let edit = Edit::Connect { from: studio.output(c, 0), to: studio.input(a, 0), how: Connection::Replace };
    let refused = studio.try_do(&edit).unwrap_err();
    assert!(matches!(refused, Refusal::Loop(_)), "{refused}");
    assert!(refused.to_string().contains("Neg") && refused.to_string().contains("Sin"), "{refused}");
    let edit = Edit::Connect { from: studio.output(a, 0), to: studio.input(a, 0), how: Connection::Add };
    assert!(studio.try_do(&edit).unwrap_err().to_string().contains("would read itself"));
}

#[test]
fn wires_are_replaced_added_removed_moved_and_joined() {
    let mut studio = Studio::empty();
    let (a, b) = (studio.slider(1.0, 0.0, 9.0), studio.slider(2.0, 0.0, 9.0));
    let [number, sum] = ["Number", "Mass Addition"].map(|name| studio.place(name, [300.0, 0.0]));
    let to = number;
    studio.make(Edit::Connect { from: a, to, how: Connection::Replace });
    studio.make(Edit::Connect { from: b, to, how: Connection::Add });
    assert_eq!(studio.object(number).inputs[0].sources, [a, b]);
    assert!(studio.make(Edit::Connect { from: b, to, how: Connection::Add }).is_empty());
    studio.make(Edit::Rewire { from: number, to: studio.input(sum, 0), input: None });
    assert!(studio.object(number).inputs[0].sources.is_empty());
    assert_eq!(studio.object(sum).inputs[0].sources, [a, b]);
    assert_eq!(studio.texts(sum), ["3"]);
    let relay = studio.id();
    let into = studio.input(sum, 0);
    studio.make(Edit::InsertRelay { id: relay, from: b, to: into, at: [150.0, 0.0] });
    assert_eq!(studio.object(sum).inputs[0].sources, [a, relay]);
    assert_eq!(studio.texts(sum), ["3"]);
    studio.make(Edit::RemoveAndJoin { object: relay });
    assert_eq!(studio.object(sum).inputs[0].sources, [a, b]);
    studio.make(Edit::Rewire { from: a, to: b, input: None });
    assert_eq!(studio.object(sum).inputs[0].sources, [b]);
    studio.make(Edit::Connect { from: b, to: into, how: Connection::Remove });
    assert!(studio.object(sum).inputs[0].sources.is_empty());
    studio.make(Edit::Connect { from: a, to: into, how: Connection::Replace });
    studio.make(Edit::Remove { objects: vec![a] });
    assert!(studio.object(sum).inputs[0].sources.is_empty());
    let slider = Edit::Connect { from: b, to: b, how: Connection::Add };
    assert!(studio.try_do(&slider).is_err());
}

#[test]
fn a_wire_dropped_in_the_void_finds_the_port_that_suits_it() {
    let mut studio = Studio::empty();
    let circle = studio.place("Circle CNR", [0.0, 0.0]);
    let radius = studio.slider(2.0, 0.0, 10.0);
    let id = studio.id();
    let component = katydid_component::registry::by_name("Move").unwrap().guid;
    let with = Some(Initial::Wire { port: studio.output(circle, 0) });
    studio.make(Edit::Place { id, component, at: [300.0, 0.0], with });
    assert_eq!(studio.object(id).inputs[0].sources, [studio.output(circle, 0)]);
    let id = studio.id();
    let component = katydid_component::registry::by_name("Circle CNR").unwrap().guid;
    studio.make(Edit::Place { id, component, at: [300.0, 90.0], with: Some(Initial::Wire { port: radius }) });
    assert_eq!(studio.object(id).inputs[2].sources, [radius]);
    let id = studio.id();
    let input = studio.input(circle, 0);
    let component = katydid_component::registry::by_name("Construct Point").unwrap().guid;
    studio.make(Edit::Place { id, component, at: [-300.0, 0.0], with: Some(Initial::Wire { port: input }) });
    assert_eq!(studio.object(circle).inputs[0].sources, [studio.output(id, 0)]);
}

#[test]
fn new_objects_begin_as_in_grasshopper() {
    let mut studio = Studio::empty();
    for (name, inputs, outputs) in [
        ("Merge", vec!["D1", "D2"], vec!["R"]),
        ("Entwine", vec!["{0;0}", "{0;1}", "{0;2}"], vec!["R"]),
        ("Expression", vec!["x", "y"], vec!["R"]),
        ("List Item", vec!["L", "i", "W"], vec!["i"]),
        ("Move", vec!["G", "T"], vec!["G", "X"]),
    ] {
        let id = studio.place(name, [100.0, 100.0]);
        let object = studio.object(id);
        let names = |ports: &[katydid_definition::document::Port]| -> Vec<String> {
            ports.iter().map(|port| port.nickname.clone()).collect()
        };
        assert_eq!(names(&object.inputs), inputs, "{name}");
        assert_eq!(names(&object.outputs), outputs, "{name}");
        let [x, y, w, h] = object.bounds.unwrap();
        assert!((x + 0.5 * w - 100.0).abs() <= 1.0 && (y + 0.5 * h - 100.0).abs() <= 1.0);
    }
    let id = studio.place("Move", [0.0, 0.0]);
    assert_eq!(studio.object(id).persistent(&studio.object(id).inputs[1]).unwrap().count(), 1);
    // Move is 67 × 44 in real files.
    let [_, _, w, h] = studio.object(id).bounds.unwrap();
    assert!((w - 67.0).abs() <= 3.0 && h == 44.0, "{w} {h}");
    let view = studio.editor.state(&[]).unwrap();
    let view = view.objects.iter().find(|view| view.id == id).unwrap();
    assert_eq!(view.inputs.iter().map(|port| port.at).collect::<Vec<_>>(), [12.0, 32.0]);
    assert!(view.previews && view.kind == ObjectKindView::Component);
    for component in katydid_component::registry::all() {
        let id = Uuid::from_u128(component.guid.as_u128() ^ 1);
        let edit = Edit::Place { id, component: component.guid, at: [0.0, 0.0], with: None };
        let only_inside = [ids::CLUSTER_INPUT, ids::CLUSTER_OUTPUT, ids::CLUSTER].contains(&component.guid);
        match studio.editor.apply(&edit, None, &[]) {
            Ok(change) => assert_eq!(change.difference.put.len(), 1, "{}", component.name),
            Err(refusal) => assert!(only_inside, "{}: {refusal}", component.name),
        }
    }
    let state = studio.editor.state(&[]).unwrap();
    for view in &state.objects {
        assert!(view.bounds[2] >= 20.0 && view.bounds[3] >= 16.0, "{}: {:?}", view.name, view.bounds);
        for port in view.inputs.iter().chain(&view.outputs) {
            assert!(port.at >= 0.0 && port.at <= view.bounds[3], "{}", view.name);
        }
    }
    let again = Document::read(&studio.editor.document().to_gh().unwrap(), &Limits::default()).unwrap();
    assert_eq!(again.objects.len(), state.objects.len());
    assert!(again.problems().is_empty(), "{:?}", again.problems());
}

#[test]
fn ports_are_added_named_and_taken_away() {
    let mut studio = Studio::empty();
    let merge = studio.place("Merge", [0.0, 0.0]);
    let nicknames = |studio: &Studio, id: Uuid| -> Vec<String> {
        studio.object(id).inputs.iter().map(|port| port.nickname.clone()).collect()
    };
    let (first, second) = (studio.input(merge, 0), studio.input(merge, 1));
    let id = studio.id();
    let add = Edit::AddPort { object: merge, input: true, index: 1, id: Some(id) };
    studio.make(add.clone());
    assert!(studio.make(add).is_empty());
    assert_eq!(nicknames(&studio, merge), ["D1", "D2", "D3"]);
    assert_eq!([0, 1, 2].map(|k| studio.input(merge, k)), [first, id, second]);
    studio.make(Edit::ChangePort { port: id, change: PortChange::Nickname { text: "mine".to_owned() } });
    studio.make(Edit::AddPort { object: merge, input: true, index: 9, id: None });
    assert_eq!(nicknames(&studio, merge), ["D1", "mine", "D3", "D4"]);
    studio.make(Edit::RemovePort { port: first });
    assert_eq!(nicknames(&studio, merge), ["mine", "D2", "D3"]);
    let expression = studio.place("Expression", [0.0, 0.0]);
    studio.make(Edit::AddPort { object: expression, input: true, index: 2, id: None });
    assert_eq!(nicknames(&studio, expression), ["x", "y", "z"]);
    let sine = studio.place("Sine", [0.0, 0.0]);
    assert!(studio.try_do(&Edit::AddPort { object: sine, input: true, index: 0, id: None }).is_err());
    assert!(studio.try_do(&Edit::RemovePort { port: studio.input(sine, 0) }).is_err());
    let object = studio.object(merge);
    let parameters = object.container().child("ParameterData").unwrap();
    assert_eq!(parameters.i32("InputCount"), Some(3));
    assert_eq!(parameters.list("InputId").len(), 3);
}

#[test]
fn every_modifier_of_a_port_is_set_and_taken_back() {
    let mut studio = Studio::empty();
    let [line, sine, gate, evaluate] =
        ["Line", "Sine", "Gate Not", "Evaluate Curve"].map(|name| studio.place(name, [0.0, 0.0]));
    let ports =
        [studio.input(line, 0), studio.input(sine, 0), studio.input(gate, 0), studio.input(evaluate, 0)];
    let before = studio.editor.document().to_ghx().unwrap();
    let changes = |on: bool| {
        vec![
            (
                ports[0],
                PortChange::Mapping { mapping: if on { MappingView::Graft } else { MappingView::None } },
            ),
            (ports[0], PortChange::Reverse { on }),
            (ports[0], PortChange::Simplify { on }),
            (ports[3], PortChange::Reparameterize { on }),
            (ports[2], PortChange::Invert { on }),
            (ports[1], PortChange::Degrees { on }),
            (ports[1], PortChange::Expression { text: on.then(|| "x + 1".to_owned()) }),
            (ports[0], PortChange::Wire { wire: if on { WireView::Hidden } else { WireView::Normal } }),
            (ports[0], PortChange::Principal { on }),
        ]
    };
    for (port, change) in changes(true) {
        assert!(!studio.make(Edit::ChangePort { port, change: change.clone() }).is_empty(), "{change:?}");
        assert!(studio.make(Edit::ChangePort { port, change: change.clone() }).is_empty(), "{change:?}");
    }
    let state = studio.editor.state(&[]).unwrap();
    let sine = state.objects.iter().find(|view| view.id == sine).unwrap();
    assert_eq!(sine.strip.as_deref(), Some("Degrees"));
    for (port, change) in changes(false) {
        studio.make(Edit::ChangePort { port, change });
    }
    assert_eq!(studio.editor.document().to_ghx().unwrap(), before);
    assert!(
        studio
            .try_do(&Edit::ChangePort { port: ports[0], change: PortChange::Unitize { on: true } })
            .is_err()
    );
}

#[test]
fn values_are_kept_by_type_and_taken_out() {
    let mut studio = Studio::empty();
    let [number, point, text] = ["Number", "Point", "Text"].map(|name| studio.place(name, [0.0, 0.0]));
    let keep = |port: Uuid, text: &str| Edit::Keep { port, values: Some(text.to_owned()) };
    studio.make(keep(number, "1\n2.5\n{0;1}\n3"));
    assert_eq!(studio.texts(number), ["1", "2.5", "3"]);
    assert_eq!(studio.object(number).persistent(&studio.object(number).inputs[0]).unwrap().branches.len(), 2);
    studio.make(keep(point, "1, 2, 3\n{4, 5, 6}"));
    assert_eq!(studio.texts(point), ["{1, 2, 3}", "{4, 5, 6}"]);
    studio.make(keep(text, "<script>alert(1)</script>"));
    assert_eq!(studio.texts(text), ["<script>alert(1)</script>"]);
    assert!(studio.try_do(&keep(number, "seven")).is_err());
    assert!(studio.try_do(&keep(number, "NaN")).is_err());
    studio.make(Edit::Keep { port: number, values: None });
    assert!(!studio.object(number).inputs[0].has_persistent);
    // Extracted, the value stands in a parameter before the input, which reads it from there.
    let circle = studio.place("Circle CNR", [0.0, 0.0]);
    studio.make(keep(studio.input(circle, 2), "4"));
    let id = studio.id();
    studio.make(Edit::Extract { port: studio.input(circle, 2), id });
    assert_eq!(studio.texts(id), ["4"]);
    assert_eq!(studio.object(circle).inputs[2].sources, [id]);
    assert_eq!(studio.object(id).name, "Number");
}

#[test]
fn data_is_internalised_whatever_it_is() {
    let mut studio = Studio::empty();
    let circle = studio.place("Circle CNR", [0.0, 0.0]);
    let [curve, number, data] = ["Curve", "Number", "Data"].map(|name| studio.place(name, [300.0, 0.0]));
    let slider = studio.slider(4.0, 0.0, 10.0);
    studio.make(Edit::Keep { port: studio.input(circle, 0), values: Some("0,0,0".to_owned()) });
    studio.make(Edit::Connect { from: slider, to: studio.input(circle, 2), how: Connection::Replace });
    studio.make(Edit::Connect { from: studio.output(circle, 0), to: curve, how: Connection::Replace });
    studio.make(Edit::Connect { from: curve, to: data, how: Connection::Replace });
    studio.make(Edit::Connect { from: slider, to: number, how: Connection::Replace });
    assert!(studio.try_do(&Edit::Internalise { port: number }).unwrap_err().to_string().contains("solved"));
    let shown = [studio.texts(curve), studio.texts(number), studio.texts(data)];
    for port in [data, curve, number, studio.output(circle, 0)] {
        let report = |id: Uuid| {
            let at = studio.engine.document().objects.iter().position(|object| object.id == id)?;
            studio.engine.report(at).cloned()
        };
        let solution = Solution::new(studio.engine.document(), &report);
        let edit = Edit::Internalise { port };
        let change = studio.editor.apply_with(&edit, None, &[], &solution).unwrap();
        studio.follow(&change);
        assert!(studio.editor.apply(&edit, None, &[]).unwrap().is_empty());
        studio.engine.solve();
    }
    studio.make(Edit::Remove { objects: vec![circle, slider] });
    assert_eq!([studio.texts(curve), studio.texts(number), studio.texts(data)], shown);
    let again = Document::read(&studio.editor.document().to_gh().unwrap(), &Limits::default()).unwrap();
    let mut engine = Engine::new(again, Options::default());
    engine.solve();
    assert_eq!(texts(&engine, curve), shown[0]);
}

#[test]
fn controls_take_what_suits_them() {
    let mut studio = Studio::empty();
    let list = studio.place("Value List", [0.0, 0.0]);
    let item = |name: &str, expression: &str| ListItemView {
        name: name.to_owned(),
        expression: expression.to_owned(),
        selected: false,
    };
    let items = vec![item("a", "1+1"), item("b", "\"text\"")];
    studio.make(Edit::Reshape {
        object: list,
        control: Control::ValueList { mode: ListModeView::DropDown, items },
    });
    assert_eq!(studio.texts(list), ["2"]);
    studio.make(Edit::Set { object: list, to: Setting::Choose { chosen: vec![1] } });
    assert_eq!(studio.texts(list), ["text"]);
    assert!(studio.try_do(&Edit::Set { object: list, to: Setting::Choose { chosen: vec![7] } }).is_err());
    let toggle = studio.place("Boolean Toggle", [0.0, 0.0]);
    studio.make(Edit::Set { object: toggle, to: Setting::Switch { on: true } });
    assert_eq!(studio.texts(toggle), ["True"]);
    let panel = studio.place("Panel", [0.0, 0.0]);
    studio.make(Edit::Set { object: panel, to: Setting::Text { text: "a\nb".to_owned() } });
    studio.make(Edit::ChangePanel { object: panel, change: PanelChange::Multiline { on: false } });
    assert_eq!(studio.texts(panel), ["a", "b"]);
    for (name, to) in [
        ("Control Knob", Setting::Number { value: 3.5 }),
        ("Digit Scroller", Setting::Number { value: 12.25 }),
        ("MD Slider", Setting::Place { value: [0.25, 0.5, 0.0] }),
        ("Gene Pool", Setting::Gene { index: 3, value: 7.0 }),
        ("Colour Swatch", Setting::Colour { colour: [1, 2, 3, 255] }),
    ] {
        let id = studio.place(name, [0.0, 0.0]);
        let edit = Edit::Set { object: id, to };
        assert!(!studio.make(edit.clone()).is_empty(), "{name}");
        assert!(studio.make(edit).is_empty(), "{name}");
        let view = studio.editor.state(&[]).unwrap().objects.into_iter().find(|view| view.id == id).unwrap();
        let control = view.control.unwrap();
        assert!(studio.make(Edit::Reshape { object: id, control }).is_empty(), "{name}");
    }
}

/// What a face is told of any control can be sent back, and changes nothing.
#[test]
fn what_a_control_shows_is_what_it_takes() {
    let mut studio = Studio::empty();
    for component in katydid_component::registry::all() {
        let id = Uuid::from_u128(component.guid.as_u128() ^ 1);
        let edit = Edit::Place { id, component: component.guid, at: [0.0, 0.0], with: None };
        let _ = studio.editor.apply(&edit, None, &[]);
    }
    for view in studio.editor.state(&[]).unwrap().objects {
        let Some(control) = view.control else { continue };
        if matches!(control, Control::Script { .. }) {
            continue;
        }
        let edit = Edit::Reshape { object: view.id, control };
        let change = studio.editor.apply(&edit, None, &[]).unwrap_or_else(|r| panic!("{}: {r}", view.name));
        assert!(change.is_empty(), "{}: {edit:?}", view.name);
    }
}

#[test]
fn a_button_gives_its_other_value_while_it_is_held() {
    let mut studio = Studio::empty();
    let button = studio.place("Button", [0.0, 0.0]);
    assert_eq!(studio.texts(button), ["False"]);
    let before = studio.editor.revision();
    for (down, text) in [(true, "True"), (false, "False")] {
        let held = studio.editor.press(button, down, &[]).unwrap();
        studio.engine.apply(&held).unwrap();
        studio.engine.solve();
        assert_eq!(texts(&studio.engine, button), [text]);
    }
    assert_eq!(studio.editor.revision(), before);
}

#[test]
fn objects_are_aligned_spread_and_reordered() {
    let mut studio = Studio::empty();
    let all: Vec<Uuid> =
        (0..3).map(|k| studio.place("Panel", [f32::from(k as u8) * 300.0, 17.0 * k as f32])).collect();
    studio.make(Edit::Align { objects: all.clone(), how: Alignment::Top });
    let tops: Vec<f32> = all.iter().map(|id| studio.object(*id).bounds.unwrap()[1]).collect();
    assert!(tops.iter().all(|top| *top == tops[0]));
    studio.make(Edit::Move { objects: vec![(all[1], [400.0, 0.0])] });
    studio.make(Edit::Align { objects: all.clone(), how: Alignment::SpreadAcross });
    let lefts: Vec<f32> = all.iter().map(|id| studio.object(*id).bounds.unwrap()[0]).collect();
    assert!((lefts[1] - lefts[0] - (lefts[2] - lefts[1])).abs() < 1e-3, "{lefts:?}");
    studio.make(Edit::Arrange { objects: vec![all[2]], back: true });
    let order: Vec<Uuid> = studio.editor.document().objects.iter().map(|object| object.id).collect();
    assert_eq!(order, [all[2], all[0], all[1]]);
    studio.undo();
    assert_eq!(studio.editor.document().objects[2].id, all[2]);
    studio.make(Edit::Resize { object: all[0], bounds: [1.0, 2.0, 300.0, 200.0] });
    assert_eq!(studio.object(all[0]).bounds, Some([1.0, 2.0, 300.0, 200.0]));
    studio.make(Edit::Change { objects: all.clone(), change: ObjectChange::Disabled { on: true } });
    assert!(all.iter().all(|id| studio.object(*id).locked));
}

#[test]
fn groups_nest_and_ungroup() {
    let (mut studio, [a, b, sum, panel, group]) = story();
    let outer = studio.id();
    studio.make(Edit::Group { id: outer, objects: vec![group, sum] });
    let ring = GroupChange::Members { members: vec![outer] };
    assert!(studio.try_do(&Edit::ChangeGroup { group, change: ring }).is_err());
    let state = studio.editor.state(&[]).unwrap();
    let bounds = |id: Uuid| state.objects.iter().find(|view| view.id == id).unwrap().bounds;
    let [x, y, w, h] = bounds(outer);
    for id in [a, b, sum] {
        let [l, t, width, height] = bounds(id);
        assert!(x <= l && y <= t && l + width <= x + w && t + height <= y + h);
    }
    studio.make(Edit::Ungroup { groups: vec![group] });
    let Some(Special::Group(left)) = studio.object(outer).special() else { panic!() };
    assert_eq!(left.members, [a, b, sum]);
    studio.make(Edit::Remove { objects: vec![a, b, sum] });
    assert_eq!(studio.editor.document().objects.len(), 1);
    assert_eq!(studio.editor.document().objects[0].id, panel);
}

#[test]
fn what_is_copied_is_pasted_with_new_ids_and_its_wires() {
    let (mut studio, [a, b, sum, panel, group]) = story();
    let text = studio.editor.copy(&[sum, panel, group], &[]).unwrap();
    assert!(text.contains("<Archive name=\"Root\">") && text.contains("<chunk name=\"Clipboard\">"));
    let seed = studio.id();
    let paste = Edit::Paste { text: text.clone(), at: Some([900.0, 500.0]), seed };
    let change = studio.make(paste.clone());
    assert_eq!(change.made.len(), 3);
    let again = studio.make(paste);
    assert!(again.is_empty());
    assert_eq!(again.made.len(), 3);
    let [new_sum, new_panel] = [change.made[1], change.made[2]];
    let made: Vec<&str> = change.made.iter().map(|id| studio.object(*id).name.as_str()).collect();
    assert!(made.contains(&"Addition") && made.contains(&"Panel") && made.contains(&"Group"), "{made:?}");
    let pick = |name: &str| *change.made.iter().find(|id| studio.object(**id).name == name).unwrap();
    let (new_sum, new_panel) = (
        pick("Addition").max(new_sum.min(pick("Addition"))),
        pick("Panel").max(new_panel.min(pick("Panel"))),
    );
    // Wires from outside lead to what is there, wires between the copies to the copies.
    assert_eq!(studio.object(new_sum).inputs[0].sources, [a]);
    assert_eq!(studio.object(new_sum).inputs[1].sources, [b]);
    assert_eq!(studio.object(new_panel).inputs[0].sources, [studio.output(new_sum, 0)]);
    assert_eq!(studio.texts(new_panel), ["5"]);
    assert!(studio.editor.document().problems().is_empty());
    // Into another document wires from outside do not come along.
    let mut other = Studio::empty();
    let change = other.make(Edit::Paste { text, at: None, seed });
    assert_eq!(change.made.len(), 3);
    assert!(other.editor.document().problems().is_empty());
    // And so do files and Katydid's own text.
    let file = studio.editor.document().to_ghx().unwrap();
    other.make(Edit::Paste { text: file, at: None, seed: Uuid::from_u128(77) });
    let kd = "r = Number Slider(2, 0..10)\nc = Circle CNR(Radius = r)\n".to_owned();
    let change = other.make(Edit::Paste { text: kd, at: Some([0.0, 0.0]), seed: Uuid::from_u128(78) });
    assert_eq!(change.made.len(), 2);
    assert!(other.try_do(&Edit::Paste { text: "<html>".to_owned(), at: None, seed }).is_err());
    assert!(other.try_do(&Edit::Paste { text: "\u{0}garbage".to_owned(), at: None, seed }).is_err());
    let seed = studio.id();
    let change = studio.make(Edit::Duplicate { objects: vec![a, sum], by: [30.0, 40.0], seed });
    assert_eq!(change.made.len(), 2);
    assert_eq!(studio.object(change.made[1]).inputs[0].sources, [change.made[0]]);
}

#[test]
fn a_cluster_is_made_entered_changed_and_exploded() {
    let (mut studio, [a, b, sum, panel, _]) = story();
    assert_eq!(studio.texts(panel), ["5"]);
    let id = studio.id();
    studio.make(Edit::MakeCluster { id, objects: vec![sum] });
    assert_eq!((studio.object(id).inputs.len(), studio.object(id).outputs.len()), (2, 1));
    assert_eq!(studio.object(id).inputs[0].sources, [a]);
    assert_eq!(studio.texts(panel), ["5"]);
    // Inside, the result is made negative.
    let inside = studio.editor.state(&[id]).unwrap();
    assert_eq!(inside.objects.len(), 4);
    let hook = inside.objects.iter().find(|view| view.component == ids::CLUSTER_OUTPUT).unwrap();
    let new = studio.id();
    let component = katydid_component::registry::by_name("Negative").unwrap().guid;
    let with = Some(Initial::Wire {
        port: inside.objects.iter().find(|view| view.name == "Addition").unwrap().outputs[0].id,
    });
    let edit = Edit::Place { id: new, component, at: [0.0, 0.0], with };
    let change = studio.editor.apply(&edit, None, &[id]).unwrap();
    studio.follow(&change);
    assert!(studio.editor.patch(&change, &[id]).is_some() && studio.editor.patch(&change, &[]).is_some());
    let from =
        studio.editor.state(&[id]).unwrap().objects.iter().find(|view| view.id == new).unwrap().outputs[0].id;
    let edit = Edit::Connect { from, to: hook.inputs[0].id, how: Connection::Replace };
    let change = studio.editor.apply(&edit, None, &[id]).unwrap();
    studio.follow(&change);
    assert_eq!(studio.texts(panel), ["-5"]);
    // A new input inside is a new port outside, and goes with it.
    let third = studio.id();
    let edit = Edit::Place { id: third, component: ids::CLUSTER_INPUT, at: [0.0, 0.0], with: None };
    let change = studio.editor.apply(&edit, None, &[id]).unwrap();
    studio.follow(&change);
    assert_eq!(studio.object(id).inputs.len(), 3);
    let change = studio.editor.apply(&Edit::Remove { objects: vec![third] }, None, &[id]).unwrap();
    studio.follow(&change);
    assert_eq!(studio.object(id).inputs.len(), 2);
    assert_eq!(studio.texts(panel), ["-5"]);
    let before = studio.editor.document().objects.len();
    studio.make(Edit::ExplodeCluster { cluster: id });
    assert_eq!(studio.editor.document().objects.len(), before + 1);
    assert_eq!(studio.texts(panel), ["-5"]);
    assert!(studio.editor.document().problems().is_empty(), "{:?}", studio.editor.document().problems());
    let _ = b;
    let refused = studio.editor.apply(&Edit::Remove { objects: vec![] }, None, &[panel]).unwrap_err();
    assert!(refused.to_string().contains("not a cluster"), "{refused}");
}

#[test]
fn settings_are_kept_in_the_file_and_change_the_results() {
    let (mut studio, [a, ..]) = story();
    let settings = |units: Option<&str>, tolerance: Option<f64>| Edit::Settings {
        units: units.map(str::to_owned),
        tolerance,
        angle_tolerance: None,
        preview_normal: Some([1, 2, 3, 4]),
        preview_selected: None,
        name: Some("A name".to_owned()),
        author: None,
        description: None,
    };
    let line = studio.place("Line", [0.0, 0.0]);
    studio.make(Edit::Keep { port: studio.input(line, 0), values: Some("0,0,0".to_owned()) });
    studio.make(Edit::Keep { port: studio.input(line, 1), values: Some("3,4,0".to_owned()) });
    assert_eq!(studio.texts(line), ["Line(L:5.00 mm)"]);
    let change = studio.make(settings(Some("metres"), Some(0.01)));
    assert!(change.rules.is_some());
    assert!(studio.make(settings(Some("Meters"), Some(0.01))).is_empty());
    let header = studio.editor.state(&[]).unwrap().document;
    assert_eq!(
        (header.units.as_str(), header.tolerance, header.preview_normal),
        ("Meters", 0.01, [1, 2, 3, 4])
    );
    let again = Document::read(&studio.editor.document().to_gh().unwrap(), &Limits::default()).unwrap();
    let again = Editor::new(again, Default::default());
    assert_eq!(again.state(&[]).unwrap().document.units, "Meters");
    assert!(studio.try_do(&settings(Some("furlongs"), None)).is_err());
    assert!(studio.try_do(&settings(None, Some(f64::NAN))).is_err());
    assert!(studio.try_do(&settings(None, Some(-1.0))).is_err());
    studio.undo();
    assert_eq!(studio.editor.state(&[]).unwrap().document.units, "Millimeters");
    let _ = a;
}

#[test]
fn a_face_that_follows_patches_shows_what_one_that_joins_shows() {
    let mut studio = Studio::empty();
    let mut mirror = Mirror::new(&studio.editor);
    let mut ids = Vec::new();
    let mut edits = Vec::new();
    for k in 0..4_u8 {
        let id = studio.id();
        ids.push(id);
        let component = katydid_component::registry::by_name(
            ["Number Slider", "Addition", "Panel", "Move"][usize::from(k)],
        )
        .unwrap()
        .guid;
        edits.push(Edit::Place { id, component, at: [f32::from(k) * 200.0, 0.0], with: None });
    }
    let group = studio.id();
    edits.extend([
        Edit::Group { id: group, objects: ids[..2].to_vec() },
        Edit::Move { objects: vec![(ids[0], [50.0, 300.0])] },
        Edit::Arrange { objects: vec![ids[3]], back: true },
        Edit::Connect {
            from: ids[0],
            to: katydid_definition::kd::derived_id(ids[1], "in 0"),
            how: Connection::Add,
        },
        Edit::Duplicate { objects: ids.clone(), by: [10.0, 10.0], seed: Uuid::from_u128(5) },
        Edit::Remove { objects: vec![ids[1], ids[2]] },
    ]);
    for edit in edits {
        let change = studio.make(edit);
        mirror.follow(studio.editor.patch(&change, &[]));
        assert_eq!(mirror.objects, studio.editor.state(&[]).unwrap().objects);
    }
    while let Some(change) = studio.editor.undo() {
        mirror.follow(studio.editor.patch(&change, &[]));
        assert_eq!(mirror.objects, studio.editor.state(&[]).unwrap().objects);
    }
}

#[test]
fn a_slider_is_called_by_the_input_it_feeds() {
    let (mut studio, [a, ..]) = story();
    let circle = studio.place("Circle CNR", [0.0, 0.0]);
    let slider = studio.slider(1.0, 0.0, 10.0);
    let mut mirror = Mirror::new(&studio.editor);
    let edit = Edit::Connect { from: slider, to: studio.input(circle, 2), how: Connection::Replace };
    let change = studio.make(edit);
    mirror.follow(studio.editor.patch(&change, &[]));
    let shown = |mirror: &Mirror, id: Uuid| {
        mirror.objects.iter().find(|view| view.id == id).unwrap().nickname.clone()
    };
    assert_eq!(shown(&mirror, slider), "Radius");
    assert_eq!(studio.object(slider).nickname, "");
    let change = studio.make(Edit::Change {
        objects: vec![slider],
        change: ObjectChange::Nickname { text: "own".to_owned() },
    });
    mirror.follow(studio.editor.patch(&change, &[]));
    assert_eq!(shown(&mirror, slider), "own");
    assert_eq!(shown(&mirror, a), "A");
    let change = studio.make(Edit::Disconnect { port: studio.input(circle, 2) });
    mirror.follow(studio.editor.patch(&change, &[]));
    assert_eq!(mirror.objects, studio.editor.state(&[]).unwrap().objects);
}
