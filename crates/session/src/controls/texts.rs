//! Controls that hold a text: the file of an Image Sampler, a formula, and what a caller is asked.

use katydid_definition::document::{Special, ids};

use super::parts::number;
use super::{FACE, PLAIN, Row, finite, short};
use crate::protocol::Control;

pub(super) const IMAGE_SAMPLER: Row = Row {
    components: &[ids::IMAGE_SAMPLER],
    begin: |container| {
        container.set("FilePath", "");
        container.set("SaveInFile", false);
        container.set("Filter", "Colour");
        for (name, x) in [("Umin", 0.0), ("Umax", 1.0), ("Vmin", 0.0), ("Vmax", 1.0)] {
            container.set(name, x);
        }
    },
    view: |_, special| {
        let Special::ImageSampler(sampler) = special else { return None };
        let hash = sampler.image.as_deref().and_then(crate::view::picture::hash);
        Some(Control::Image { hash, file: sampler.file })
    },
    shape: |object, control| {
        let Control::Image { file, .. } = control else { return Ok(false) };
        object.container_mut().set("FilePath", short(file)?);
        Ok(true)
    },
    size: |_, _| Some([150.0, 150.0]),
    ..FACE
};

pub(super) const EXPRESSION: Row = Row {
    components: &[ids::EXPRESSION],
    begin: |container| container.set("Expression", "x + y"),
    view: |_, special| match special {
        Special::Expression(text) => Some(Control::Formula { text }),
        _ => None,
    },
    shape: |object, control| {
        let Control::Formula { text } = control else { return Ok(false) };
        object.container_mut().set("Expression", short(text)?);
        Ok(true)
    },
    ..PLAIN
};

/// Get Number and the like, of many component types: what a file holds tells them.
pub(super) static CONTEXTUAL: Row = Row {
    view: |_, special| {
        let Special::Contextual(input) = special else { return None };
        Some(Control::Contextual { prompt: input.prompt, minimum: input.minimum, maximum: input.maximum })
    },
    shape: |object, control| {
        let Control::Contextual { prompt, minimum, maximum } = control else { return Ok(false) };
        object.container_mut().set("Prompt", short(prompt)?);
        for (name, x) in [("Minimum", minimum), ("Maximum", maximum)] {
            match x {
                Some(x) => {
                    finite(&[*x])?;
                    number(object.container_mut(), name, *x);
                }
                None => {
                    object.container_mut().remove(name);
                }
            }
        }
        Ok(true)
    },
    ..PLAIN
};
