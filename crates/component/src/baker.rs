//! Components that put objects into the Rhino model, as Grasshopper's users bake: what they put there is told from what they take.

use katydid_data::{Tree, Value, cast::Rules};
use uuid::Uuid;

/// A component that puts objects into the model.
#[derive(Debug, Clone, Copy)]
pub struct Baker {
    /// The type id of the component.
    pub component: Uuid,
    /// The objects that it puts into the model, of the trees that its inputs take; none while it is told not to.
    pub objects: fn(&[Tree], &Rules) -> Vec<Value>,
}

inventory::collect!(Baker);

/// What a component of a type id puts into the model; none for those that put nothing there.
pub fn baker(component: Uuid) -> Option<&'static Baker> {
    inventory::iter::<Baker>.into_iter().find(|baker| baker.component == component)
}
