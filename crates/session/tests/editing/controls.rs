//! Objects with a face of their own: sliders, panels, lists, buttons.

use crate::common::{Mirror, Studio, texts};
use crate::made::story;
use katydid_definition::archive::Limits;
use katydid_definition::document::{Document, ids};
use katydid_session::protocol::{
    Connection, Control, Edit, ListItemView, ListModeView, ObjectChange, ObjectKindView, PanelChange, Setting,
};
use uuid::Uuid;

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
        ("Calendar", Setting::Date { date: [2024, 2, 29] }),
        ("Clock", Setting::Time { seconds: 50_700.0 }),
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

#[test]
fn days_and_times_are_picked() {
    let mut studio = Studio::empty();
    let calendar = studio.place("Calendar", [0.0, 0.0]);
    // As large as in a file of Rhino 8.
    assert_eq!(studio.object(calendar).bounds.map(|[_, _, w, h]| [w, h]), Some([214.0, 262.0]));
    let pick = |date| Edit::Set { object: calendar, to: Setting::Date { date } };
    studio.make(pick([2025, 5, 28]));
    assert_eq!(studio.texts(calendar), ["2025-05-28 00:00:00"]);
    let control = |studio: &Studio, id: Uuid| {
        let state = studio.editor.state(&[]).unwrap();
        state.objects.into_iter().find(|view| view.id == id).and_then(|view| view.control).unwrap()
    };
    let shown = Control::Calendar { date: [2025, 5, 28], shown: [2025, 5] };
    assert_eq!(control(&studio, calendar), shown);
    for none in
        [[2025, 2, 29], [0, 1, 1], [10_000, 1, 1], [2025, 13, 1], [2025, 4, 31], [i32::MIN; 3], [i32::MAX; 3]]
    {
        assert!(studio.try_do(&pick(none)).is_err(), "{none:?}");
    }
    assert_eq!(control(&studio, calendar), shown);

    let clock = studio.place("Clock", [0.0, 0.0]);
    let turn = |seconds| Edit::Set { object: clock, to: Setting::Time { seconds } };
    studio.make(turn(50_700.0));
    assert_eq!(studio.texts(clock), ["0001-01-01 14:05:00"]);
    for none in [-1.0, 86_400.0, 1e300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(studio.try_do(&turn(none)).is_err(), "{none}");
    }
    assert_eq!(control(&studio, clock), Control::Clock { seconds: 50_700.0 });
    assert!(studio.try_do(&Edit::Set { object: clock, to: Setting::Date { date: [2025, 1, 1] } }).is_err());
    assert!(studio.try_do(&Edit::Set { object: calendar, to: Setting::Time { seconds: 1.0 } }).is_err());
    for id in [calendar, clock] {
        let state = studio.editor.state(&[]).unwrap();
        let view = state.objects.iter().find(|view| view.id == id).unwrap();
        assert!(view.kind == ObjectKindView::Control && view.inputs.is_empty() && view.outputs.len() == 1);
    }

    // Both come back from every form of file as they are.
    let archive = Document::read(&studio.editor.document().to_gh().unwrap(), &Limits::default()).unwrap();
    assert_eq!(archive.objects.iter().map(|object| object.special()).collect::<Vec<_>>(), {
        studio.editor.document().objects.iter().map(|object| object.special()).collect::<Vec<_>>()
    });
}

#[test]
fn panels_keep_the_file_that_they_stream_to() {
    let mut studio = Studio::empty();
    let panel = studio.place("Panel", [0.0, 0.0]);
    let stream = |file: Option<&str>| Edit::ChangePanel {
        object: panel,
        change: PanelChange::Stream { file: file.map(str::to_owned) },
    };
    studio.make(stream(Some(" C:\\data\\widths.txt ")));
    let properties =
        |studio: &Studio| studio.object(panel).container().child("PanelProperties").unwrap().clone();
    assert_eq!(properties(&studio).bool("Stream"), Some(true));
    assert_eq!(properties(&studio).str("StreamPath"), Some("C:\\data\\widths.txt"));
    let streams = katydid_session::panel_streams(studio.editor.document());
    assert_eq!(streams.iter().map(|one| one.file.as_deref()).collect::<Vec<_>>(), [Some("widths.txt")]);
    assert!(studio.make(stream(Some("C:\\data\\widths.txt"))).is_empty());
    for broken in ["a\0b".to_owned(), "a".repeat(5000)] {
        assert!(studio.try_do(&stream(Some(&broken))).is_err());
    }
    // The path stays where it is only switched off.
    studio.make(stream(None));
    assert_eq!(properties(&studio).bool("Stream"), Some(false));
    assert_eq!(properties(&studio).str("StreamPath"), Some("C:\\data\\widths.txt"));
    assert!(katydid_session::panel_streams(studio.editor.document()).is_empty());
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
