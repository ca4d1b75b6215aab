//! The Transform tab.

mod affine;
mod array;
mod euclidean;
mod extent;
mod morph;
mod sanity;
mod util;

pub(crate) use extent::around;

use katydid_component::{Context, Message};
use katydid_data::{Geometry, Value};
use katydid_geometry::Xform;

/// What most transforms give: the image, and the map itself, which comes without geometry too.
type Transformed = Result<(Option<Geometry>, Option<Value>), Message>;

/// The results of a transform component. The map is only put out where somebody reads it.
fn transformed(context: &Context<'_>, geometry: Option<Geometry>, xform: Xform) -> Transformed {
    if !xform.is_finite() {
        return Err(Message::error("The transform holds a number that is not finite"));
    }
    let image = match geometry {
        Some(Geometry(value)) => Some(Geometry(value.transformed(&xform)?)),
        None => None,
    };
    Ok((image, context.is_wanted(1).then(|| Value::from(xform))))
}
