//! Geometry that inputs keep, moved, turned and scaled where it stands.

use katydid_component::stored;
use katydid_data::Kind;
use katydid_data::cast::Rules;
use katydid_definition::document::{Branch, Persistent, Stored};
use katydid_geometry::Xform;
use uuid::Uuid;

use super::{bounded, finite, geometry, given, keep};
use crate::Refusal;
use crate::editor::Draft;

/// Puts a map's image of what inputs keep in its place; `map` is the first three rows of its matrix.
pub(super) fn transform(draft: &mut Draft<'_>, ports: &[Uuid], map: &[[f64; 4]; 3]) -> Result<(), Refusal> {
    bounded(ports)?;
    finite(map.as_flattened())?;
    let mut xform = Xform::IDENTITY;
    for (row, given) in xform.rows.iter_mut().zip(map) {
        *row = *given;
    }
    if xform.inverse().is_none() {
        return Err(Refusal::Senseless("a map that flattens space leaves nothing of a shape".to_owned()));
    }
    ports.iter().try_for_each(|port| one(draft, *port, &xform))
}

fn one(draft: &mut Draft<'_>, port: Uuid, xform: &Xform) -> Result<(), Refusal> {
    let at = draft.input(port)?;
    let rules = draft.rules;
    let object = draft.at(at.object)?;
    let kind = keep::kind_of(object, at.port);
    let Some(values) = object.inputs.get(at.port).and_then(|port| object.persistent(port)) else {
        return Err(keep::unfit(object, "it keeps nothing"));
    };
    let branches = values.branches.iter().map(|branch| {
        let items = branch.items.iter().map(|item| image(item, kind, xform, &rules));
        Ok(Branch { path: branch.path.clone(), items: items.collect::<Result<_, _>>()? })
    });
    let branches = branches.collect::<Result<_, String>>().map_err(|reason| keep::unfit(object, reason))?;
    Ok(object.set_persistent(at.port, Some(&Persistent { branches }))?)
}

/// The image of a kept value, as an input of a type keeps it.
fn image(item: &Stored, kind: Kind, xform: &Xform, rules: &Rules) -> Result<Stored, String> {
    if let Stored::Geometry(geometry) = item
        && !geometry.ref_id.is_nil()
    {
        return Err("it refers to an object of the Rhino model, and has no geometry of its own".to_owned());
    }
    let Some(value) = stored::item(item)? else { return Ok(Stored::Null) };
    let image = value.transformed(xform).map_err(|error| error.to_string())?;
    let fitting = given::fit(&image, kind, rules);
    geometry::stored(&fitting.ok_or_else(|| format!("its image, a {}, is no {kind}", image.kind()))?)
}
