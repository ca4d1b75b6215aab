//! Faces that are taken out of a Brep: those that are left keep their numbers, which no member of the table does.

use std::sync::Arc;

use katydid_geometry::Brep;
use katydid_members::{Fault, Geometry, Shape, Value};

/// The members of this file, as declarations name them.
pub(super) const MEMBERS: [&str; 3] = ["Brep.__ExtractFace", "Brep.__FaceCount", "Brep.__HasFace"];

/// Breps that faces were taken out of.
pub(super) type Extracted = Vec<(Arc<Brep>, Numbers)>;

/// The numbers that the faces of a Brep had before any was taken out, and how many there were.
#[derive(Debug, Clone)]
pub(super) struct Numbers {
    places: Vec<usize>,
    count: usize,
}

/// How many Breps are remembered.
const MOST: usize = 64;

/// A result, and what the object becomes.
type Given = Result<(Value, Option<Geometry>), Fault>;

/// Calls a member of this file; none for the name of another.
pub(super) fn call(name: &str, arguments: &[Value], extracted: &mut Extracted) -> Option<Given> {
    let member = MEMBERS.contains(&name).then(|| name.rsplit_once("__")).flatten()?.1;
    Some(answer(member, arguments, extracted))
}

fn answer(member: &str, arguments: &[Value], extracted: &mut Extracted) -> Given {
    let brep = match arguments.first() {
        Some(Value::Geometry(geometry)) => geometry.shape.brep(),
        _ => None,
    };
    let brep = brep.ok_or_else(|| Fault::bad_request("is not a brep"))??;
    let index = match arguments.get(1) {
        Some(Value::Int(index)) => usize::try_from(*index).ok(),
        _ => None,
    };
    let value = match member {
        "FaceCount" => Value::Int(i64::try_from(numbers(&brep, extracted).count).unwrap_or(-1)),
        "HasFace" => {
            Value::Bool(index.is_some_and(|index| numbers(&brep, extracted).places.contains(&index)))
        }
        _ => return extract(&brep, index, extracted),
    };
    Ok((value, None))
}

fn numbers(brep: &Arc<Brep>, extracted: &Extracted) -> Numbers {
    let known = extracted.iter().find(|(own, _)| Arc::ptr_eq(own, brep));
    let count = brep.faces().len();
    known.map_or_else(|| Numbers { places: (0..count).collect(), count }, |(_, numbers)| numbers.clone())
}

/// Takes a face out. Those that are left keep their numbers, as in openNURBS until the Brep is made compact.
fn extract(brep: &Arc<Brep>, index: Option<usize>, extracted: &mut Extracted) -> Given {
    let mut numbers = numbers(brep, extracted);
    let at = index.and_then(|index| numbers.places.iter().position(|place| *place == index));
    let at = at.ok_or_else(|| Fault::bad_request("there is no such face"))?;
    let made = |faces: &[usize]| brep.sub_brep(faces).map(Arc::new).map_err(|e| Fault::failed(e.to_string()));
    let face = made(&[at])?;
    let rest: Vec<usize> = (0..numbers.places.len()).filter(|place| *place != at).collect();
    let rest = if rest.is_empty() { Arc::new(Brep::merged(&[])) } else { made(&rest)? };
    numbers.places.remove(at);
    extracted.retain(|(own, _)| !Arc::ptr_eq(own, brep));
    if extracted.len() >= MOST {
        extracted.remove(0);
    }
    extracted.push((rest.clone(), numbers));
    Ok((Shape::Brep(face).into(), Some(Shape::Brep(rest).into())))
}
