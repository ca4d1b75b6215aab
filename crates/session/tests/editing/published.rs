//! Which inputs the player shows: kept in the document, through every format.

use katydid_definition::archive::Limits;
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_session::protocol::{DocumentState, Edit, PlayerInput};
use uuid::Uuid;

use crate::common::Studio;

fn input(object: Uuid, label: &str, help: &str) -> PlayerInput {
    PlayerInput { object, label: label.to_owned(), help: help.to_owned() }
}

fn published(studio: &Studio) -> Option<Vec<PlayerInput>> {
    let DocumentState { document, .. } = studio.editor.state(&[]).unwrap();
    document.player
}

#[test]
fn what_is_published_is_saved_and_taken_back() {
    let mut studio = Studio::empty();
    let [a, b] = [1.0, 2.0].map(|value| studio.slider(value, 0.0, 10.0));
    assert_eq!(published(&studio), None);
    let inputs = vec![input(b, "Breadth", "From wall to wall, \"clear\""), input(a, "", "")];
    studio.make(Edit::Publish { inputs: Some(inputs.clone()) });
    assert_eq!(published(&studio).as_ref(), Some(&inputs));
    assert!(
        studio.make(Edit::Publish { inputs: Some(inputs.clone()) }).is_empty(),
        "the same again is no step"
    );
    // Grasshopper's archives keep it beside the units.
    for bytes in
        [studio.editor.document().to_gh().unwrap(), studio.editor.document().to_ghx().unwrap().into_bytes()]
    {
        let again = Studio::new(Document::read(&bytes, &Limits::default()).unwrap());
        assert_eq!(published(&again).as_ref(), Some(&inputs));
    }
    // The text form has it among what it has no words for, and the objects keep their ids.
    let text = kd::write(studio.editor.document(), &Registry).unwrap().text;
    let again = Studio::new(kd::read(&text, &Registry).unwrap().document);
    assert_eq!(published(&again).as_ref(), Some(&inputs));
    assert_eq!((again.object(a).id, again.object(b).id), (a, b));
    studio.make(Edit::Publish { inputs: Some(vec![]) });
    assert_eq!(published(&studio), Some(vec![]), "none at all is another thing than finding them");
    studio.make(Edit::Publish { inputs: None });
    assert_eq!(published(&studio), None);
    assert!(studio.undo() && studio.undo());
    assert_eq!(published(&studio).as_ref(), Some(&inputs));
    assert!(studio.undo());
    assert_eq!(published(&studio), None);
}

#[test]
fn what_is_not_there_and_what_is_too_much_is_refused() {
    let mut studio = Studio::empty();
    let a = studio.slider(1.0, 0.0, 10.0);
    let wrong = [
        vec![input(Uuid::from_u128(9), "", "")],
        vec![input(a, "", ""), input(a, "again", "")],
        vec![input(a, &"x".repeat(2_001), "")],
    ];
    for inputs in wrong {
        assert!(studio.try_do(&Edit::Publish { inputs: Some(inputs) }).is_err());
    }
    assert_eq!(published(&studio), None);
}
