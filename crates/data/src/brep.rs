//! Breps as values: computed ones, and those that are kept as a program wrote them.

use std::sync::Arc as Shared;

use katydid_3dm::{Limits, Object};
use katydid_geometry::subd::SubD;
use katydid_geometry::{Brep, construct};

use crate::item::item;
use crate::{Column, Item, Items, Kind, Value};

impl From<Brep> for Value {
    /// A brep that is nothing but one surface, whole and not turned over, is that surface.
    fn from(brep: Brep) -> Self {
        let bare = brep.as_surface().and_then(|(surface, reversed)| (!reversed).then(|| surface.clone()));
        match bare {
            Some(surface) => Self::from(surface),
            None => Self::Brep(Shared::new(brep)),
        }
    }
}

impl Value {
    /// A brep that is shared, as [`Value::from`] a brep of its own.
    pub fn from_shared_brep(brep: Shared<Brep>) -> Self {
        match brep.as_surface() {
            Some((surface, false)) => Self::from(surface.clone()),
            _ => Self::Brep(brep),
        }
    }

    /// The subdivision surface that a value holds; `None` for other values.
    ///
    /// # Errors
    /// In words, when it cannot be read.
    pub fn subd(&self) -> Option<Result<SubD, String>> {
        let Self::Kept(raw) = self else { return None };
        if raw.class_name() != "SubD" {
            return None;
        }
        Some(match raw.parse_shape(&Limits::default()) {
            Ok(Object::SubD(object)) => object.to_subd().map_err(|error| error.to_string()),
            Ok(_) => Err(format!("A {} is no SubD", raw.class_name())),
            Err(error) => Err(format!("The SubD cannot be read: {error}")),
        })
    }

    /// The brep that a value is or stands for: a surface is one of one face, a box one of six, and what is kept as it
    /// was written is read. `None` for what has no faces.
    ///
    /// # Errors
    /// In words, when it cannot be read, or no brep can be made of it.
    pub fn brep(&self) -> Option<Result<Shared<Brep>, String>> {
        let made = match self {
            Self::Brep(brep) => return Some(Ok(brep.clone())),
            Self::Surface(surface) => Brep::from_surface((**surface).clone()),
            Self::Box(shape) => construct::box_brep(shape),
            Self::Kept(raw) => {
                return match raw.parse_shape(&Limits::default()) {
                    Ok(Object::Brep(object)) => Some(Ok(Shared::new(object.brep))),
                    Ok(Object::Extrusion(extrusion)) => Some(
                        (extrusion.to_brep().map(|object| Shared::new(object.brep)))
                            .ok_or_else(|| "The extrusion is no sound one".to_owned()),
                    ),
                    Ok(object) => object.surface().map(|surface| {
                        let made = Brep::from_surface(surface.into_owned());
                        made.map(Shared::new).map_err(|error| error.to_string())
                    }),
                    Err(error) => Some(Err(format!("A {} cannot be read: {error}", raw.class_name()))),
                };
            }
            _ => return None,
        };
        Some(made.map(Shared::new).map_err(|error| error.to_string()))
    }
}

// What stands for a brep counts as one.
item!(Shared<Brep>, Brep, Breps, Self::new(Brep::default()), |column: &Column, i: usize| {
    column.get(i)?.brep()?.ok()
});
