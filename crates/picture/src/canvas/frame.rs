//! Where an object and its ports are.

use katydid_definition::document::{Object, Side, Special};

/// An object's rectangle, x, y, width and height, and the grips of its ports.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame {
    pub(crate) rect: [f64; 4],
    pub(crate) inputs: Vec<[f64; 2]>,
    pub(crate) outputs: Vec<[f64; 2]>,
}

/// A file's coordinates beyond this are taken for broken.
const FARTHEST: f32 = 1e6;
/// Room above an object for the name of its type.
const ABOVE: f64 = 12.0;

impl Frame {
    /// The frame of an object; `None` for one without a place.
    pub(crate) fn new(object: &Object) -> Option<Self> {
        let bounds = object.bounds.or_else(|| object.pivot.map(|[x, y]| [x, y, 0.0, 0.0]))?;
        if !bounds.iter().all(|x| x.abs() <= FARTHEST) {
            return None;
        }
        let [x, y, w, h] = bounds.map(f64::from);
        let rect = [x, y, w.max(20.0), h.max(16.0)];
        let [x, y, w, h] = rect;
        let side = |side: Side| {
            let n = object.ports(side).len();
            let at = if side == Side::Input { x } else { x + w };
            (0..n).map(|k| [at, y + h * (k as f64 + 0.5) / n.max(1) as f64]).collect::<Vec<_>>()
        };
        let inputs = if has_inputs(object) { side(Side::Input) } else { Vec::new() };
        Some(Self { rect, inputs, outputs: side(Side::Output) })
    }

    /// The rectangle with what stands around it.
    pub(crate) fn outer(&self) -> [f64; 4] {
        let [x, y, w, h] = self.rect;
        [x - 4.0, y - ABOVE, w + 8.0, h + ABOVE + 2.0]
    }
}

/// Whether wires can be led to an object: not to one that its user sets.
fn has_inputs(object: &Object) -> bool {
    !matches!(
        object.special(),
        Some(
            Special::Slider(_)
                | Special::Toggle(_)
                | Special::Button(_)
                | Special::ValueList(_)
                | Special::MdSlider(_)
                | Special::Knob(_)
                | Special::DigitScroller(_)
                | Special::Calendar(_)
                | Special::Clock(_)
                | Special::GenePool(_)
        )
    )
}

/// The smallest rectangle around two.
pub(crate) fn union(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    let (x, y) = (a[0].min(b[0]), a[1].min(b[1]));
    let (right, bottom) = ((a[0] + a[2]).max(b[0] + b[2]), (a[1] + a[3]).max(b[1] + b[3]));
    [x, y, right - x, bottom - y]
}
