//! What an hour of work is made of: steps, undone and done again, saved, and seen by whoever joins.

use crate::common::{Mirror, Studio, texts};
use crate::made::story;
use katydid_definition::archive::Limits;
use katydid_definition::document::{Document, Special};
use katydid_session::Editor;
use katydid_session::protocol::{Connection, Edit, GroupChange, PortChange, Setting};
use katydid_solver::{Engine, Options};
use uuid::Uuid;

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
