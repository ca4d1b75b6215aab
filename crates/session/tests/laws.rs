//! Laws of editing, on edits of any kind in any order.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{Mirror, Studio, results};
use katydid_component::registry;
use katydid_definition::document::Document;
use katydid_session::journal::{MemoryStore, Source};
use katydid_session::protocol::{
    Alignment, Connection, Edit, GroupChange, MappingView, ObjectChange, PortChange, Setting,
};
use katydid_session::{Editor, NoResults};
use katydid_solver::{Engine, Options};
use proptest::prelude::*;
use uuid::Uuid;

const PLACED: [&str; 9] = [
    "Number Slider",
    "Addition",
    "Panel",
    "Merge",
    "Number",
    "Series",
    "Boolean Toggle",
    "Value List",
    "Mass Addition",
];

/// What is done, by numbers that are read as places among what is there.
#[derive(Debug, Clone, Copy)]
struct Move {
    what: u8,
    a: usize,
    b: usize,
    x: f32,
    gesture: Option<u64>,
}

fn moves() -> impl Strategy<Value = Vec<Move>> {
    let one = (0..26_u8, 0..40_usize, 0..40_usize, -500.0_f32..500.0, prop::option::of(0..4_u64))
        .prop_map(|(what, a, b, x, gesture)| Move { what, a, b, x, gesture });
    prop::collection::vec(one, 1..40)
}

/// The edit that a move stands for on this document; none where there is nothing to do it with.
fn edit(document: &Document, step: Move, next: &mut u128) -> Option<Edit> {
    *next += 1;
    let new = Uuid::from_u128(*next << 80 | 7);
    let Move { what, a, b, x, .. } = step;
    let component = |k: usize| registry::by_name(PLACED[k % PLACED.len()]).unwrap().guid;
    let objects = &document.objects;
    let object = |k: usize| objects.get(k % objects.len().max(1));
    let id = |k: usize| object(k).map(|object| object.id);
    let output = |k: usize| {
        object(k)
            .and_then(|object| object.outputs.get(k / 7 % object.outputs.len().max(1)))
            .map(|port| port.id)
    };
    let input = |k: usize| {
        object(k).and_then(|object| object.inputs.get(k / 5 % object.inputs.len().max(1))).map(|port| port.id)
    };
    Some(match what {
        0..5 => Edit::Place { id: new, component: component(a), at: [x, x], with: None },
        5..9 => {
            let how = [Connection::Add, Connection::Replace, Connection::Add, Connection::Remove][b % 4];
            Edit::Connect { from: output(a)?, to: input(b)?, how }
        }
        9 => Edit::Remove { objects: vec![id(a)?, id(b)?] },
        10 => Edit::Move { objects: vec![(id(a)?, [x, -x])] },
        11 => Edit::Set { object: id(a)?, to: Setting::Number { value: f64::from(x) } },
        12 => Edit::Set { object: id(a)?, to: Setting::Switch { on: x > 0.0 } },
        13 => Edit::Group { id: new, objects: vec![id(a)?, id(b)?] },
        14 => Edit::Change { objects: vec![id(a)?], change: ObjectChange::Disabled { on: x > 0.0 } },
        15 => Edit::ChangePort {
            port: input(a)?,
            change: PortChange::Mapping {
                mapping: if x > 0.0 { MappingView::Graft } else { MappingView::None },
            },
        },
        16 => Edit::Keep { port: input(a)?, values: (x > 0.0).then(|| format!("{x}")) },
        17 => Edit::AddPort { object: id(a)?, input: true, index: u32::try_from(b).ok()?, id: Some(new) },
        18 => Edit::RemovePort { port: input(a)? },
        19 => Edit::Duplicate { objects: vec![id(a)?, id(b)?], by: [x, 5.0], seed: new },
        20 => Edit::Arrange { objects: vec![id(a)?], back: x > 0.0 },
        21 => Edit::Extract { port: input(a)?, id: new },
        22 => Edit::MakeCluster { id: new, objects: vec![id(a)?, id(b)?] },
        23 => Edit::ExplodeCluster { cluster: objects.iter().find(|object| object.name == "Cluster")?.id },
        24 => Edit::Rewire { from: output(a)?, to: output(b)?, input: (x > 200.0).then_some(x > 300.0) },
        _ => match b % 4 {
            0 => Edit::Align {
                objects: objects.iter().map(|object| object.id).collect(),
                how: Alignment::SpreadDown,
            },
            1 => Edit::Ungroup { groups: vec![id(a)?] },
            2 => Edit::ChangeGroup { group: id(a)?, change: GroupChange::Members { members: vec![id(b)?] } },
            _ => Edit::Settings {
                units: Some(if x > 0.0 { "Meters" } else { "Feet" }.to_owned()),
                tolerance: None,
                angle_tolerance: None,
                preview_normal: None,
                preview_selected: None,
                name: None,
                author: Some("A".to_owned()),
                description: None,
            },
        },
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..Default::default() })]

    /// Undo of all gives the first document byte for byte, redo of all the last; each edit sent twice does no more than
    /// once; faces that follow patches show what faces that join show.
    #[test]
    fn what_is_done_can_be_undone_and_redone(moves in moves()) {
        let mut studio = Studio::empty();
        let first = studio.editor.document().to_gh().unwrap();
        let mut mirror = Mirror::new(&studio.editor);
        let mut next = 1;
        for step in moves {
            let Some(edit) = edit(studio.editor.document(), step, &mut next) else { continue };
            let before = studio.editor.document().to_gh().unwrap();
            match studio.editor.apply(&edit, step.gesture, &[]) {
                Ok(change) => {
                    studio.follow(&change);
                    mirror.follow(studio.editor.patch(&change, &[]));
                    let again = studio.editor.apply(&edit, step.gesture, &[]).unwrap();
                    prop_assert!(again.is_empty(), "twice: {edit:?}");
                    prop_assert_eq!(&again.made, &change.made);
                }
                Err(_) => prop_assert_eq!(studio.editor.document().to_gh().unwrap(), before),
            }
            prop_assert_eq!(&mirror.objects, &studio.editor.state(&[]).unwrap().objects);
        }
        let last = studio.editor.document().to_gh().unwrap();
        while let Some(change) = studio.editor.undo() {
            mirror.follow(studio.editor.patch(&change, &[]));
            prop_assert_eq!(&mirror.objects, &studio.editor.state(&[]).unwrap().objects);
        }
        prop_assert_eq!(studio.editor.document().to_gh().unwrap(), first);
        while studio.editor.redo().is_some() {}
        prop_assert_eq!(studio.editor.document().to_gh().unwrap(), last);
    }

    /// An engine that follows by differences has the results of one that begins with the document, also when solves
    /// between are cancelled.
    #[test]
    fn an_engine_that_follows_has_the_results_of_a_fresh_one(moves in moves()) {
        let mut studio = Studio::empty();
        let mut next = 1;
        for (k, step) in moves.into_iter().enumerate() {
            let Some(edit) = edit(studio.editor.document(), step, &mut next) else { continue };
            if let Ok(change) = studio.editor.apply(&edit, None, &[]) {
                studio.follow(&change);
            }
            if k % 3 == 0 {
                let cancel = katydid_component::Cancel::default();
                if k % 2 == 0 {
                    cancel.cancel();
                }
                studio.engine.options_mut().cancel = cancel;
                studio.engine.solve();
            }
            if k % 7 == 6 && let Some(change) = studio.editor.undo() {
                studio.follow(&change);
            }
        }
        studio.engine.options_mut().cancel = Default::default();
        let summary = studio.engine.solve();
        prop_assert_eq!(summary.unfinished, 0);
        let options = Options { rules: studio.editor.rules(), ..Options::default() };
        let mut fresh = Engine::new(Document::clone(studio.editor.document()), options);
        fresh.solve();
        prop_assert_eq!(results(&studio.engine), results(&fresh));
    }

    /// A journal that ends anywhere gives a document that there was, and whole it gives the last one with its history.
    #[test]
    fn a_journal_cut_short_anywhere_is_a_state_that_was(moves in moves(), cut in 0.0..1.0_f64) {
        katydid_components::link();
        let store = MemoryStore::default();
        let source = Source { path: Some("a.gh".to_owned()), hash: "1".to_owned() };
        let open = |bytes: &[u8]| {
            let store = MemoryStore::default();
            *store.0.lock().unwrap() = bytes.to_vec();
            Editor::with_journal(Document::new(), Default::default(), source.clone(), Box::new(store)).unwrap()
        };
        let mut editor =
            Editor::with_journal(Document::new(), Default::default(), source.clone(), Box::new(store.clone())).unwrap();
        let mut states = vec![editor.document().to_gh().unwrap()];
        let mut next = 1;
        for (k, step) in moves.into_iter().enumerate() {
            let Some(edit) = edit(editor.document(), step, &mut next) else { continue };
            let _ = editor.apply_with(&edit, step.gesture, &[], &NoResults);
            states.push(editor.document().to_gh().unwrap());
            if k % 5 == 4 {
                editor.undo();
                states.push(editor.document().to_gh().unwrap());
            }
            if k % 11 == 10 {
                editor.redo();
            }
            states.push(editor.document().to_gh().unwrap());
        }
        editor.flush();
        let bytes = store.0.lock().unwrap().clone();
        let restored = open(&bytes);
        prop_assert_eq!(restored.document().to_gh().unwrap(), editor.document().to_gh().unwrap());
        prop_assert_eq!((restored.undo_name(), restored.redo_name()), (editor.undo_name(), editor.redo_name()));
        let mut both = (restored, editor);
        loop {
            let undone = (both.0.undo().is_some(), both.1.undo().is_some());
            prop_assert_eq!(undone.0, undone.1);
            if !undone.0 {
                break;
            }
            prop_assert_eq!(both.0.document().to_gh().unwrap(), both.1.document().to_gh().unwrap());
        }
        let part = open(&bytes[..(bytes.len() as f64 * cut) as usize]);
        prop_assert!(states.contains(&part.document().to_gh().unwrap()));
    }
}
