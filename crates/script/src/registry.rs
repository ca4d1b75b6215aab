//! A host of the member table with the components of the registry.

use katydid_data::cast::Rules;
use katydid_members::Host;

use crate::components::Components;

/// A host that answers calls of members and of components, with these units and tolerances.
pub fn host(rules: Rules) -> Host {
    Host::new().with_registry(Components { rules })
}
