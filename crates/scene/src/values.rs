//! Values as things to be seen.

use std::collections::HashSet;
use std::sync::Arc as Shared;

use katydid_data::cast::{self, Rules};
use katydid_data::{Colour, Content, Kind, Material, ModelObject, Value};

use crate::colour::{channel, opaque};
use crate::{Facets, Form, Look, Scene, solids};

/// Turns values into things; on pictures each only once: a point that goes through five parameters is one cross.
#[derive(Debug)]
pub(crate) struct Values {
    /// What has been seen, with its colour. The values are kept, so that no address is used twice.
    seen: HashSet<(Key, Colour)>,
    kept: Vec<Value>,
    /// Whether a thing that was seen already is left out.
    once: bool,
    /// What could not be drawn, in words.
    pub(crate) left_out: Vec<String>,
}

/// What makes a value the same as another: its numbers, or the place where it is shared.
#[derive(Debug, PartialEq, Eq, Hash)]
enum Key {
    Numbers([u64; 3]),
    Place(usize),
}

impl Values {
    pub(crate) fn new(once: bool) -> Self {
        Self { seen: HashSet::new(), kept: Vec::new(), once, left_out: Vec::new() }
    }

    /// Adds what a value of the object `of` looks like. What has no look, such as a number or a vector, adds nothing.
    pub(crate) fn add(&mut self, scene: &mut Scene, value: &Value, look: Look, rules: &Rules, of: &str) {
        if let Some(key) = key(value).filter(|_| self.once) {
            if !self.seen.insert((key, look.fill)) {
                return;
            }
            self.kept.push(value.clone());
        }
        let form = match value {
            Value::Point(p) => Form::Point(*p),
            Value::Plane(plane) => Form::Plane(**plane),
            Value::Line(line) => Form::Lines(vec![line.from, line.to]),
            Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) | Value::Curve(_) => {
                match cast::value(value, Kind::Curve, rules) {
                    Some(Value::Curve(curve)) => Form::Curve(curve),
                    _ => return self.leave_out(of, "a curve without length"),
                }
            }
            Value::Box(_) | Value::TwistedBox(_) | Value::Mesh(_) => {
                match cast::value(value, Kind::Mesh, rules) {
                    Some(Value::Mesh(mesh)) => Form::Mesh(mesh),
                    _ => return self.leave_out(of, "a box without volume"),
                }
            }
            Value::Surface(surface) => match Facets::new(surface) {
                Some(facets) => Form::Surface(Shared::new(facets)),
                None => return self.leave_out(of, "a surface without a NURBS form"),
            },
            Value::Brep(brep) => match solids::of_brep(brep) {
                Ok(form) => form,
                Err(why) => return self.leave_out(of, &why),
            },
            Value::Group(group) => {
                for member in group.members.iter().flatten() {
                    self.add(scene, member, look, rules, of);
                }
                return;
            }
            Value::Content(content) => match &**content {
                Content::Object(ModelObject { geometry: Some(geometry), .. }) => {
                    return self.add(scene, geometry, look, rules, of);
                }
                Content::Instance(_) => return self.leave_out(of, "a block instance cannot be drawn yet"),
                _ => return,
            },
            Value::Kept(raw) => match solids::of(raw) {
                Ok(forms) => return forms.into_iter().for_each(|form| scene.add(form, look)),
                Err(why) => return self.leave_out(of, &why),
            },
            _ => return,
        };
        scene.add(form, look);
    }

    pub(crate) fn leave_out(&mut self, of: &str, why: &str) {
        let text = format!("{of}: {why}");
        if !self.left_out.contains(&text) {
            self.left_out.push(text);
        }
    }
}

fn key(value: &Value) -> Option<Key> {
    Some(match value {
        Value::Point(p) => Key::Numbers([p.x, p.y, p.z].map(f64::to_bits)),
        Value::Curve(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        Value::Surface(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        Value::Brep(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        Value::Mesh(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        Value::Box(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        Value::Plane(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        Value::Circle(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        Value::Line(shared) => Key::Place(Shared::as_ptr(shared) as usize),
        _ => return None,
    })
}

/// The colours that a material gives.
pub(crate) fn look(material: &Material, look: Look) -> Look {
    let diffuse = opaque(material.diffuse);
    let clear = material.transparency.clamp(0.0, 1.0);
    let alpha = if clear.is_nan() { 255 } else { channel(255.0 * (1.0 - clear)) };
    Look { line: diffuse, fill: Colour { a: alpha, ..diffuse }, ..look }
}
