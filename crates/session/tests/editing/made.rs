//! The definition that several of these tests begin with.

use crate::common::Studio;
use katydid_session::protocol::Edit;
use uuid::Uuid;

/// Two sliders, an addition, a panel that shows it, and a group around the sliders.
pub(super) fn story() -> (Studio, [Uuid; 5]) {
    let mut studio = Studio::empty();
    let (a, b) = (studio.slider(2.0, 0.0, 10.0), studio.slider(3.0, 0.0, 10.0));
    let sum = studio.place("Addition", [300.0, 40.0]);
    studio.wire(a, sum, 0);
    studio.wire(b, sum, 1);
    let panel = studio.place("Panel", [500.0, 40.0]);
    studio.wire(sum, panel, 0);
    let group = studio.id();
    studio.make(Edit::Group { id: group, objects: vec![a, b] });
    (studio, [a, b, sum, panel, group])
}
