//! Ports: added, named, modified, and with values of their own.

use crate::common::{Studio, texts};
use katydid_definition::archive::Limits;
use katydid_definition::document::Document;
use katydid_session::Solution;
use katydid_session::protocol::{Connection, Edit, MappingView, PortChange, WireView};
use katydid_solver::{Engine, Options};
use uuid::Uuid;

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
