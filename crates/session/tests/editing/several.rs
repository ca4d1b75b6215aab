//! Many objects at a time: aligned, grouped, copied, and made into clusters.

use crate::common::Studio;
use crate::made::story;
use katydid_definition::document::{Special, ids};
use katydid_session::protocol::{Alignment, Connection, Edit, GroupChange, Initial, ObjectChange};
use uuid::Uuid;

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
