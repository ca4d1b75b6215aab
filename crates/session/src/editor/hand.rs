//! What only a hand does, and lasts as long as it is there: nobody keeps it or takes it back.

use katydid_definition::archive::ItemValue;
use katydid_definition::document::{Difference, Object, Special, ids};
use uuid::Uuid;

use super::Editor;
use crate::Refusal;
use crate::controls::{finite, unfit};
use crate::protocol::HeldPoint;

impl Editor {
    /// Holds a Button down, or lets it go: the step that a solver takes for it. The document is as it was.
    ///
    /// # Errors
    /// When there is no such button.
    pub fn press(&self, button: Uuid, down: bool, within: &[Uuid]) -> Result<Difference, Refusal> {
        self.passing(button, within, |object| {
            let Some(Special::Button(held)) = object.special() else {
                return Err(unfit(object, "it is not a Button"));
            };
            if down {
                object.container_mut().set("ExpressionNormal", held.pressed);
            }
            Ok(())
        })
    }

    /// Drags a particle for a Grab, or lets it go: the step that a solver takes for it. The document is as it was. The object
    /// is to be solved anew even where the step is one that was taken before: while a particle is held each solve goes on
    /// from the one before.
    ///
    /// # Errors
    /// There is no such Grab, it is in a cluster, or a number is not finite.
    pub fn grab(&self, grab: Uuid, held: Option<HeldPoint>, within: &[Uuid]) -> Result<Difference, Refusal> {
        self.passing(grab, within, |object| {
            if !ids::GRABS.contains(&object.component) {
                return Err(unfit(object, "it is not a Grab"));
            }
            // What is in a cluster is made anew with each solve, and goes on from nowhere.
            if !within.is_empty() {
                return Err(unfit(object, "points cannot be dragged inside a cluster"));
            }
            let Some(HeldPoint { from, to, reach }) = held else { return Ok(()) };
            finite(&from)?;
            finite(&to)?;
            finite(&[reach])?;
            let container = object.container_mut();
            container.set("GrabFrom", ItemValue::Point3d(from));
            container.set("GrabTo", ItemValue::Point3d(to));
            container.set("GrabReach", reach);
            Ok(())
        })
    }

    /// The step to a state of one object that the document does not take.
    fn passing(
        &self,
        id: Uuid,
        within: &[Uuid],
        change: impl FnOnce(&mut Object) -> Result<(), Refusal>,
    ) -> Result<Difference, Refusal> {
        let outermost = within.first().copied().unwrap_or(id);
        let at = self.lookup().object(outermost).ok_or(Refusal::NoObject(outermost))?;
        let object = if within.is_empty() {
            let mut object = self.document().objects.get(at).cloned().ok_or(Refusal::NoObject(id))?;
            change(&mut object)?;
            object
        } else {
            let mut inner = self.open(within)?;
            let found = inner.objects.iter_mut().find(|object| object.id == id);
            change(found.ok_or(Refusal::NoObject(id))?)?;
            self.close(within, inner)?.objects.get(at).cloned().ok_or(Refusal::NoObject(outermost))?
        };
        Ok(Difference { removed: vec![at], put: vec![(at, object)], frame: None })
    }
}
