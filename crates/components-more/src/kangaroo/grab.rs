//! Main: a hand that drags a particle.

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::Point3;

use super::goal::finite;
use super::thresholds::GRAB_STRENGTH;
use super::{Goal, Pull, Rule};

/// What a hand holds: whoever shows the definition tells it to the object for as long as it lasts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hold {
    /// Where the hand took hold.
    pub(super) from: Point3,
    /// Where it is now.
    pub(super) to: Point3,
    /// How far from `from` the particle may be that it took, where the object does not say.
    reach: f64,
}

impl Hold {
    /// What stands in the settings of the object; none where nobody drags.
    fn of(context: &Context<'_>) -> Option<Self> {
        let settings = context.settings();
        let point =
            |name| settings.point3d(name).map(|[x, y, z]| Point3::new(x, y, z)).filter(|p| p.is_finite());
        let reach = settings.f64("GrabReach").filter(|reach| *reach >= 0.0)?;
        Some(Self { from: point("GrabFrom")?, to: point("GrabTo")?, reach })
    }
}

/// Pulls the particle that a hand holds to where the hand is.
#[derive(Debug)]
pub(super) struct Grab {
    strength: f64,
    /// How far from the hand the particle may be that it takes; none leaves it to the hand.
    range: Option<f64>,
    hold: Option<Hold>,
}

impl Grab {
    /// What is held.
    pub(super) fn hold(&self) -> Option<&Hold> {
        self.hold.as_ref()
    }

    /// The number of the particle that a hand takes: the nearest within reach, of equally near ones the first.
    pub(super) fn taken(&self, points: &[Point3]) -> Option<usize> {
        let hold = self.hold?;
        let reach = self.range.unwrap_or(hold.reach);
        let far = points.iter().map(|p| p.distance_to(hold.from)).enumerate();
        let near = far.filter(|(_, far)| *far <= reach).min_by(|(_, a), (_, b)| a.total_cmp(b));
        near.map(|(i, _)| i)
    }
}

impl Rule for Grab {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        if let (Some(hold), Some(p), Some(pull)) = (self.hold, points.first(), pulls.first_mut()) {
            *pull = Pull::new(hold.to - *p, self.strength);
        }
    }

    fn grab(&self) -> Option<&Self> {
        Some(self)
    }
}

macro_rules! grab {
    ($function:ident, $guid:literal $(, $old:ident)?) => {
        /// Lets a hand drag a particle of the solver. Dragging works in the studio: hold Alt and drag a point in the viewport.
        /// While it is held the particle nearest to where it was taken is pulled to the pointer, and the solver goes on from
        /// where its particles are, a few steps a frame; when it is let go they come to rest from there. Nothing of this is
        /// stored in the document. `katydid run` has no hand: there the goal asks for nothing. Stands for Kangaroo 2's Grab;
        /// what the inputs have when nothing is given, and that Range is in units of the model, is our reading.
        #[component($guid, name = "Grab", nick = "Grab", at = "Kangaroo2/Main" $(, $old)?)]
        #[output("Goal", "G", "The goal, for a solver: it asks for nothing unless somebody drags.")]
        #[output("Anchors", "A", "The places of points that were fixed by hand: none.")]
        fn $function(
            context: &Context<'_>,
            /// Whether particles can be dragged.
            #[port("On", "On", default = true)]
            on: bool,
            /// The strength with which the particle is pulled to the pointer.
            #[port("Strength", "Strength", default = GRAB_STRENGTH)]
            strength: f64,
            /// How far from where the hand takes hold a particle may be, in units; when empty, as far as the pointer reaches on
            /// the screen.
            #[port("Range", "Range", optional)]
            range: Option<f64>,
        ) -> Result<(Value, Vec<Point3>), Message> {
            let strength = finite(strength, "The strength")?;
            let range = range.map(|range| finite(range, "The range")).transpose()?;
            let hold = Hold::of(context).filter(|_| on);
            Ok((Goal::item("Kangaroo goal: Grab", Vec::new(), Grab { strength, range, hold })?, Vec::new()))
        }
    };
}

grab!(grab, "ea145d1d-7727-4d52-8db6-c9b7100ab7f9");
grab!(grab_with_control, "4c90aad1-0748-4800-99db-a27d690bb1e1", old);
grab!(grab_with_alt, "4c53ba00-f4bd-4ede-8d26-55106278268d", old);
grab!(grab_plain, "3d13a415-6ac5-4b59-9677-3975e4696a85", old);
