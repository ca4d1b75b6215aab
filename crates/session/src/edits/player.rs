//! Which inputs the player shows. Grasshopper has no such list: it stands in the table where documents keep values by
//! name, as units do, and Grasshopper leaves it there.

use katydid_definition::document::Document;

use super::settings::{TABLE, definition, definition_mut, part};
use crate::Refusal;
use crate::editor::Draft;
use crate::protocol::PlayerInput;

const PLAYER: &str = "Katydid.Player";
/// A player has no more inputs than a person can look over.
const MOST: usize = 1_000;
/// The most letters of a label, and of what is said of an input.
const MOST_LETTERS: usize = 2_000;

/// The inputs that a document publishes; none where it says nothing, or nothing that can be read.
pub(crate) fn published(document: &Document) -> Option<Vec<PlayerInput>> {
    let text = definition(document.frame()).child(TABLE)?.str(PLAYER)?;
    let inputs: Vec<PlayerInput> = serde_json::from_str(text).ok()?;
    (inputs.len() <= MOST).then_some(inputs)
}

/// Publishes inputs, or none in particular.
pub(super) fn publish(draft: &mut Draft<'_>, inputs: Option<&[PlayerInput]>) -> Result<(), Refusal> {
    if !draft.within.is_empty() {
        return Err(Refusal::Senseless("only the inputs of the definition itself are published".to_owned()));
    }
    if published(&draft.document).as_deref() == inputs {
        return Ok(());
    }
    let text = inputs.map(|inputs| checked(draft, inputs)).transpose()?;
    let table = part(definition_mut(draft.document.tree_mut()), TABLE);
    match text {
        Some(text) => table.set(PLAYER, text.as_str()),
        None => {
            table.remove(PLAYER);
        }
    }
    let frame = draft.document.frame().clone();
    draft.document.set_frame(frame);
    Ok(())
}

/// The inputs as text, where they are objects of the document, each once.
fn checked(draft: &mut Draft<'_>, inputs: &[PlayerInput]) -> Result<String, Refusal> {
    if inputs.len() > MOST {
        return Err(Refusal::Senseless(format!("no more than {MOST} inputs are published")));
    }
    for (k, input) in inputs.iter().enumerate() {
        draft.object(input.object)?;
        if inputs.iter().take(k).any(|before| before.object == input.object) {
            return Err(Refusal::Senseless("an input is published twice".to_owned()));
        }
        if [&input.label, &input.help].iter().any(|text| text.chars().count() > MOST_LETTERS) {
            return Err(Refusal::Senseless(format!("a text of an input has at most {MOST_LETTERS} letters")));
        }
    }
    serde_json::to_string(inputs).map_err(|error| Refusal::Senseless(error.to_string()))
}
