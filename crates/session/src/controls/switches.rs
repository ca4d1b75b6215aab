//! The Boolean Toggle, of either kind, and the Button.

use katydid_definition::document::{Special, ids};

use super::{FACE, Row, short};
use crate::protocol::Control;

pub(super) const TOGGLE: Row = Row {
    components: &[ids::BOOLEAN_TOGGLE],
    is_set_by_hand: true,
    begin: |container| container.set("ToggleValue", false),
    view: |_, special| match special {
        Special::Toggle(on) => Some(Control::Toggle { on }),
        _ => None,
    },
    shape: |object, control| {
        let Control::Toggle { on } = control else { return Ok(false) };
        object.set_toggle(*on)?;
        Ok(true)
    },
    size: |_, title| Some([title + 72.0, 22.0]),
    ..FACE
};

pub(super) const TOGGLE_2: Row = Row {
    components: &[ids::BOOLEAN_TOGGLE_2],
    begin: |container| container.set("SwitchValue", false),
    ..TOGGLE
};

pub(super) const BUTTON: Row = Row {
    components: &[ids::BUTTON],
    begin: |container| {
        container.set("ExpressionNormal", "False");
        container.set("ExpressionPressed", "True");
    },
    view: |_, special| match special {
        Special::Button(button) => Some(Control::Button { normal: button.normal, pressed: button.pressed }),
        _ => None,
    },
    shape: |object, control| {
        let Control::Button { normal, pressed } = control else { return Ok(false) };
        let container = object.container_mut();
        container.set("ExpressionNormal", short(normal)?);
        container.set("ExpressionPressed", short(pressed)?);
        Ok(true)
    },
    ..TOGGLE
};
