use std::fmt;
use std::sync::Arc;

use katydid_component::{Account, Cancel, Limits};
use katydid_solver::Listener;

/// What one request may use, and how it is followed and stopped.
#[derive(Clone, Default)]
pub struct Bounds {
    /// What each object may put out, and how long the whole solve may take.
    pub limits: Limits,
    /// What counts the memory of the request besides its own account: that of a server's requests together.
    pub memory: Option<Arc<Account>>,
    /// Stops the solve from outside.
    pub cancel: Cancel,
    /// Told after each object.
    pub progress: Option<Listener>,
    /// How many definitions called one another to come here; 0 for a request of a person.
    pub recursion: u32,
}

impl fmt::Debug for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Bounds")
            .field("limits", &self.limits)
            .field("cancel", &self.cancel)
            .field("recursion", &self.recursion)
            .finish_non_exhaustive()
    }
}
