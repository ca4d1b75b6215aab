//! The black line below a capsule: what an object is set to.

use katydid_definition::document::Object;

/// What stands on the strip, when there is one.
pub(super) fn strip(object: &Object) -> Option<String> {
    let degrees = !object.is_floating() && object.inputs.iter().any(|port| port.modifiers.degrees);
    degrees.then(|| "Degrees".to_owned())
}
