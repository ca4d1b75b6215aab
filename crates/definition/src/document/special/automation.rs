use uuid::Uuid;

use crate::archive::Chunk;

/// A Trigger, which makes objects run again and again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trigger {
    /// Milliseconds from one run to the next.
    pub interval: i32,
    /// The objects.
    pub targets: Vec<Uuid>,
}

/// A Galapagos solver.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Galapagos {
    /// The sliders and gene pools that it moves.
    pub genes: Vec<Uuid>,
    /// The parameter whose number it drives up or down.
    pub fitness: Option<Uuid>,
}

impl Trigger {
    pub(super) fn read(c: &Chunk) -> Self {
        Self {
            interval: c.i32("TimerInterval").or_else(|| c.i32("Interval")).unwrap_or(0),
            targets: c.list("Target").into_iter().filter_map(|(_, id)| id.as_guid()).collect(),
        }
    }
}

impl Galapagos {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        let chunk = c.child("GalapagosData")?;
        Some(Self {
            genes: chunk.list("gene").into_iter().filter_map(|(_, id)| id.as_guid()).collect(),
            fitness: chunk.guid("fitness"),
        })
    }
}
