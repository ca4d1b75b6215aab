//! Wires between ports.

use crate::common::Studio;
use katydid_session::Refusal;
use katydid_session::protocol::{Connection, Edit, Initial};

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
